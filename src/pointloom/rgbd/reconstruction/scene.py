"""Fusion of all placed frames into one model, and the camera trajectory."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.trajectory import Trajectory, write_trajectory
from ...core.checks import check_progress
from ...core.devices import DeviceLike, resolve_device
from ...core.errors import FilePath
from ...core.json_fields import (
    Checks,
    has_fields,
    is_ascending,
    is_count,
    is_flag,
    is_number,
    is_pose,
    list_of,
    numbers,
    optional,
)
from ...core.paths import job_file
from ...core.progress import ReportProgress
from ...core.records import digest_of, files_below, read_record, write_record
from ...io.frames.frames import FrameSource
from ...io.points.point_cloud import write_point_cloud
from ...kernels.linear_algebra import matmul
from ...meshing.mesh.mesh import TriangleMesh
from ...meshing.mesh.mesh_files import write_triangle_mesh
from ...meshing.mesh.mesh_summary import describe_mesh
from ...meshing.volume.surface_weights import min_weights
from ...meshing.volume.tsdf import TSDFVolume
from ...registration.trajectories.trajectory_error import evaluate_trajectory
from .config import ReconstructionConfig
from .fragments import Fragment, fragments_in, is_lost
from .frames import Frames, LostFrame, ReadFrame
from .job_files import JobFiles
from .nonrigid import placement_with_slac
from .placement import Placement
from .refinement import latest_placement
from .volumes import Straightener, fuse_frames

Matrix = NDArray[np.float64]

STAGE = "integrate"


@dataclass(frozen=True, eq=False)
class Scene:
    """The fused model.

    Attributes:
        mesh_path: Mesh file. None if the mesh is empty.
        trajectory_path: Trajectory file.
        cloud_path: Point cloud file. Only with SLAC and `save_output_as` "pointcloud".
        indices: Source indices of its frames, int64 [n].
        T_world_camera: Camera poses, float64 [n, 4, 4], in the frame of the first placed fragment.
        lost: Placed frames that could not be read again.
        figures: Vertices, triangles, bounds, voxels. With known poses also "trajectory_error" (rmse, median, max [m]).
    """

    mesh_path: Path | None
    trajectory_path: Path
    indices: NDArray[np.int64]
    T_world_camera: Matrix
    lost: list[LostFrame]
    figures: dict[str, Any]
    cloud_path: Path | None = None


def integrate_scene(
    source: FrameSource,
    config: ReconstructionConfig,
    folder: FilePath,
    *,
    slac: bool = False,
    resume: bool = False,
    device: DeviceLike = None,
    progress: ReportProgress | None = None,
) -> Scene:
    """Fuse all frames of the placed fragments, and write the mesh and the trajectory.

    Args:
        source: The frames that the fragments were made of.
        config, folder, device: As of `make_fragments`.
        slac: Undistort the frames, at the poses of `refine_with_slac`. Also writes points and grid if
            `config.save_output_as` is "pointcloud".
        resume: Keep a valid earlier result.
        progress: Called with ("integrate", done, all), and ("extract", 0, 0).

    Returns:
        The scene, without `slac` at the poses of `refine_registration` if it was run, else of `register_fragments`.

    Raises:
        TypeError, ValueError: Wrong source or configuration, or another number of frames than in the fragments.
        FileError: No placed fragments or `refine_with_slac` result, or a file that cannot be read or written.
        DeviceError: No such device.

    Notes:
        Frames are read ahead, one is in use at a time. Bitwise reproducible.
    """
    job, where = JobFiles.make(folder, config), resolve_device(device)
    frames, report_progress = Frames(source, config), check_progress(progress)
    fragments = fragments_in(job)
    bent = placement_with_slac(job, fragments, where) if slac else None
    placement = latest_placement(job, fragments) if bent is None else bent.placement
    indices, poses = poses_of(fragments, placement)
    if len(indices) and indices[-1] >= frames.count:
        raise ValueError(
            f"source: expected frames up to {indices[-1]}, as the fragments contain, got {frames.count} frames"
        )
    sizes = {"voxel_size": config.volume_voxel_size, "truncation": config.truncation}
    is_cloud_wanted = slac and config.save_output_as == "pointcloud"
    made_from = digest_of([placement.made_from, sizes, config.surface_weight_threshold, is_cloud_wanted])
    if resume and (done := _read_scene(job, made_from)) is not None:
        return done
    colored = all(fragments[i].colored for i in placement.members)
    volume = TSDFVolume(voxel_size=config.volume_voxel_size, truncation=config.truncation, color=colored, device=where)
    truths: list[Any] = []

    def see(frame: ReadFrame) -> None:
        truths.append(frame.T_world_camera)
        report_progress("integrate", len(truths), len(indices))

    report_progress("integrate", 0, len(indices))
    straight = None
    if bent is not None and len(bent.grid):
        straight = Straightener(bent.grid, np.concatenate([fragments[i].poses for i in placement.members]))
    lost = fuse_frames(frames, indices.tolist(), poses, volume, straight=straight, seen=see)
    report_progress("extract", 0, 0)
    mesh, threshold = extract_mesh(volume, config.surface_weight_threshold)
    figures = sizes | {"weight_threshold": threshold, "volume_bytes": volume.memory_bytes}
    figures |= describe_mesh(mesh).to_dict() | {"trajectory_error": _error_of(poses, truths)}
    ids = np.stack([indices, indices, np.full(len(indices), frames.count)], axis=1)
    write_trajectory(job.trajectory, Trajectory(poses, ids=ids))
    mesh_path = job.scene_mesh if len(mesh) else None
    cloud_path = job_file(job.slac_cloud, job.root) if len(mesh) and is_cloud_wanted else None
    if cloud_path is not None:
        write_point_cloud(cloud_path, volume.extract_point_cloud(threshold))
    scene = Scene(mesh_path, job.trajectory, indices, poses, lost, figures, cloud_path)
    _write_scene(job, scene, made_from, mesh)
    return scene


def poses_of(fragments: list[Fragment], placement: Placement) -> tuple[NDArray[np.int64], Matrix]:
    members = placement.members
    indices = np.concatenate([fragments[i].indices for i in members])
    return indices, np.concatenate([matmul(placement.poses[i], fragments[i].poses) for i in members])


def extract_mesh(volume: TSDFVolume, threshold: float | None) -> tuple[TriangleMesh, float]:
    """The surface of a volume and its threshold: by default the first that gives any surface."""
    mesh, used = TriangleMesh(), 0.0
    for used in min_weights(volume.frame_count) if threshold is None else [threshold]:
        mesh = volume.extract_triangle_mesh(used)
        if len(mesh):
            break
    return mesh, used


def _error_of(poses: Matrix, truths: list[Any]) -> dict[str, float] | None:
    if len(truths) != len(poses) or len(poses) < 3 or any(T is None for T in truths):
        return None
    error = evaluate_trajectory(Trajectory(poses), Trajectory(np.array(truths))).absolute_translation
    return {"rmse": error.rmse, "median": error.median, "max": error.max}


def _write_scene(job: JobFiles, scene: Scene, made_from: str, mesh: TriangleMesh) -> None:
    if scene.mesh_path is not None:
        write_triangle_mesh(scene.mesh_path, mesh)
    files = [path for path in (scene.trajectory_path, scene.mesh_path, scene.cloud_path) if path is not None]
    result = {
        "has_mesh": scene.mesh_path is not None,
        "has_cloud": scene.cloud_path is not None,
        "indices": scene.indices.tolist(),
        "poses": scene.T_world_camera.tolist(),
        "lost": [[frame.index, frame.name, frame.reason] for frame in scene.lost],
        "figures": scene.figures,
    }
    write_record(job.record(STAGE), STAGE, made_from, files_below(job.root, files), result)


def _read_scene(job: JobFiles, made_from: str) -> Scene | None:
    result = read_record(job.record(STAGE), STAGE, job.root, _is_scene, made_from)
    if result is None:
        return None
    return Scene(
        job.scene_mesh if result["has_mesh"] else None,
        job.trajectory,
        np.array(result["indices"], np.int64),
        np.array(result["poses"]),
        [LostFrame(*entry) for entry in result["lost"]],
        result["figures"],
        job.slac_cloud if result["has_cloud"] else None,
    )


def _is_scene(value: Any) -> bool:
    """True for the result that `_write_scene` writes."""
    corners = optional(has_fields({"min": numbers(3), "max": numbers(3)}))
    errors = optional(has_fields(dict.fromkeys(("rmse", "median", "max"), is_number)))
    counts = dict.fromkeys(("volume_bytes", "vertices", "triangles"), is_count)
    sizes = dict.fromkeys(("voxel_size", "truncation", "weight_threshold"), is_number)
    figures = has_fields({**counts, **sizes, "bounds": corners, "trajectory_error": errors})
    flags, lists = (
        dict.fromkeys(("has_mesh", "has_cloud"), is_flag),
        {"indices": is_ascending, "poses": list_of(is_pose)},
    )
    checks: Checks = {**flags, **lists, "lost": list_of(is_lost), "figures": figures}
    return has_fields(checks)(value) and len(value["indices"]) == len(value["poses"])
