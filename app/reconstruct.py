"""RGB-D frames without poses to a coloured mesh: `reconstruct_folder`."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..meshing.mesh import TriangleMesh
from ..pcd.coordinates import finite_box
from ..pcd.devices import resolve_device
from ..pcd.io.datasets import RGBDDataset
from ..pcd.io.trajectory import Trajectory
from .camera_check import check_focal, why_focal_doubted
from .console import Clock, ReportProgress, format_bounds, format_bytes, format_seconds, peak_bytes, say_nothing
from .frames import DEPTH_MAX, FilePath, describe_folder, open_folder, why_doubted, why_incomplete
from .fuse import write_model
from .pictures.picture_files import check_picture
from .reconstruct_fragments import (
    default_work_folder,
    fragment_fields,
    make_settings,
    run_fragments,
)
from .reconstruct_slam import Reconstruction, loop_fields, run_slam
from .reconstruction.job import CONFIG_FILE
from .tables import MESHES, check_output
from .track import (
    VOXEL_SIZE,
    error_part,
    tracking_fields,
)
from .trajectory_report import check_trajectory_output, errors_against_truth, write_poses
from .work_folder import check_work_folder

METHODS = ("slam", "fragments")
EMPTY = "the mesh is empty, and was not written: no voxel was seen often enough; take more frames (a smaller --every)"


def reconstruct_folder(
    folder: FilePath,
    output: FilePath,
    *,
    method: str = "slam",
    layout: str = "auto",
    intrinsic: FilePath | None = None,
    every: int = 1,
    depth_scale: float | None = None,
    voxel_size: float | None = None,
    depth_max: float | None = None,
    trajectory: FilePath | None = None,
    picture: FilePath | None = None,
    work: FilePath | None = None,
    resume: bool = False,
    config: FilePath | None = None,
    slac: bool = False,
    device: Any = "auto",
    overwrite: bool = False,
    progress: ReportProgress | None = None,
) -> dict[str, Any]:
    """Make a mesh of a folder of frames whose poses nobody knows; outputs are checked before the work.

    Args:
        folder: As `open_frames` takes it; poses that lie there are taken as the truth, and not used.
        output: A .ply, .obj, .stl, .off or .glb file; STL holds no colours, which are then left out.
        method: "slam" tracks each frame against the model and closes loops, "fragments" joins runs of frames.
        layout, every, depth_scale: As `open_frames`.
        intrinsic: A camera as Open3D's JSON, if it is another than the folder says.
        voxel_size: Edge of a voxel of the mesh [m]; None takes the method's.
        depth_max: Farther depth is left out [m]; None takes 4, or what the configuration says.
        trajectory: A file for the poses: .txt or .tum (TUM's format), .log.
        picture: A .png file for a picture of the mesh.
        work: Folder of the stages' files, with "fragments"; None for one beside the output.
        resume: Keep what an earlier run left there.
        config: Settings with the names of Open3D's system, with "fragments".
        slac: Find the camera's distortion too, and take it out of the frames, with "fragments".
        device: Where to compute.
        overwrite: Replace outputs that exist.
        progress: Called with the stage, how many of its steps are done, and how many there are.

    Returns:
        What was done, in JSON's types; "poor" says why the result is poor, or is None; "errors" holds ATE and RPE
        where true poses lie beside the frames. An empty mesh is not written.

    Raises:
        FileError: A file that cannot be read, or an output that cannot be written.
        ValueError: An unknown method, or a length out of range.
        DeviceError: No such device.
    """
    if method not in METHODS:
        raise ValueError(f"method: expected one of {', '.join(METHODS)}, got {method!r}")
    check_output(output, MESHES, what="meshes", overwrite=overwrite)
    if trajectory is not None:
        check_trajectory_output(trajectory, overwrite=overwrite)
    if picture is not None:
        check_picture(picture, overwrite=overwrite)
    where, clock, say = resolve_device(device), Clock(), progress or say_nothing
    settings = None
    if method == "fragments":
        settings = make_settings(config, voxel_size, depth_max)
        folder_of_stages = work or default_work_folder(output)
        work = check_work_folder(folder_of_stages, marker=CONFIG_FILE, resume=resume, overwrite=overwrite)
    dataset = open_folder(folder, layout=layout, intrinsic=intrinsic, every=every, depth_scale=depth_scale)
    clock.stop("open")
    if settings is not None and work is not None:
        options: dict[str, Any] = {"slac": slac, "resume": resume, "device": where, "progress": say, "clock": clock}
        mesh, path, told, poor = run_fragments(dataset, settings, Path(work), **options)
        made = Reconstruction(mesh, path, told, [poor])
    else:
        sizes: dict[str, Any] = {"voxel_size": voxel_size or VOXEL_SIZE, "depth_max": depth_max or DEPTH_MAX}
        made = run_slam(dataset, **sizes, device=where, progress=say, clock=clock)
    report = {"command": "reconstruct", "method": method, **describe_folder(folder, dataset, intrinsic)}
    report |= {"device": str(where), **made.report, **describe_mesh(made.mesh)}
    poses = list(made.trajectory.poses)
    report["errors"] = errors_against_truth(poses, _true_poses(dataset, made.trajectory))
    clock.restart()
    sure: dict[str, Any] = {"uncertain": report.get("uncertain", ()), "depth_max": report["depth_max"]}
    report["focal"] = check_focal(dataset, made.trajectory, **sure, device=where)
    clock.stop("camera")
    files = []
    if len(made.mesh):
        files = write_model(made.mesh, made.trajectory.poses, output, picture, overwrite=overwrite)
    if trajectory is not None and poses:
        write_poses(trajectory, made.trajectory, overwrite=overwrite)
        files.append(os.fspath(trajectory))
    clock.stop("write")
    report |= {"seconds": clock.seconds, "peak_bytes": peak_bytes(), "files": files}
    empty = None if files or made.poor else EMPTY
    doubts = [empty, why_incomplete(dataset), why_doubted(dataset, report["camera"]["source"])]
    reasons = [*made.poor, *doubts, why_focal_doubted(report["focal"])]
    return report | {"poor": "; ".join(reason for reason in reasons if reason) or None}


def reconstruct_fields(report: dict[str, Any]) -> list[tuple[str, str]]:
    """What was done as labels and values for the terminal."""
    by_slam = report["method"] == "slam"
    return [
        *([*tracking_fields(report), *loop_fields(report)] if by_slam else fragment_fields(report)),
        ("mesh", f"{report['vertices']:,} vertices, {report['triangles']:,} triangles, voxels of {_size(report)}"),
        ("bounds", format_bounds(report["bounds"])),
        *error_part(report),
        ("seconds", format_seconds(report["seconds"])),
        ("memory", f"{format_bytes(report['peak_bytes'])} at most"),
        ("files", ", ".join(report["files"]) or "none"),
    ]


def _size(report: dict[str, Any]) -> str:
    return f"{report['voxel_size'] * 1000:.4g} mm"


def _true_poses(dataset: RGBDDataset, trajectory: Trajectory) -> list[NDArray[np.float64] | None]:
    """The true pose, or None, of each frame of a trajectory."""
    assert trajectory.ids is not None
    return [dataset.frames[number].T_world_camera for number in trajectory.ids[:, 0]]


def describe_mesh(mesh: TriangleMesh) -> dict[str, Any]:
    """The size of a mesh, in JSON's types."""
    vertices = mesh.vertices
    low, high = finite_box(vertices)
    bounds = {"min": low.tolist(), "max": high.tolist()} if len(vertices) else None
    return {"vertices": len(vertices), "triangles": len(mesh), "bounds": bounds}
