"""Posed RGB-D frames to a coloured mesh: `fuse_dataset` for any sequence, `fuse_folder` for one on disk."""

from __future__ import annotations

import contextlib
import dataclasses
import os
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..meshing.mesh import TriangleMesh
from ..meshing.mesh_files import write_triangle_mesh
from ..meshing.tsdf import BLOCK_VOXELS, TSDFVolume
from ..pcd.camera import read_pinhole_camera_intrinsic
from ..pcd.checks import check_count, check_positive, check_rigid
from ..pcd.coordinates import finite_box
from ..pcd.devices import resolve_device
from ..pcd.errors import DatasetError, FileError, PointloomError
from ..pcd.io.datasets import RGBDDataset, open_dataset, open_frames
from .console import (
    Clock,
    ReportProgress,
    format_bounds,
    format_bytes,
    format_seconds,
    format_share,
    peak_bytes,
    say_nothing,
)
from .frames import (
    DEPTH_MAX,
    READ_AHEAD,
    FilePath,
    FrameSource,
    camera_line,
    describe_camera,
    measured_shares,
    read_frames,
    why_doubted,
    why_out_of_reach,
)
from .pictures.picture_files import check_picture
from .pictures.scene_view import draw_scene
from .refine import PoseRefiner, refinement_line, why_refinement_poor
from .slam.model import Model
from .surface_weights import least_weight
from .tables import MESHES, check_output
from .trajectory_report import check_trajectory_output, trajectory_of, write_poses

Pose = NDArray[np.float64]

VOXEL_SIZE = 0.02  # [m] twice the noise of structured light at 2 m; a room then takes some 100 MB


@dataclasses.dataclass(frozen=True, eq=False)
class FusionResult:
    """A surface and how it came about.

    Args:
        mesh: The surface; empty where no voxel was seen often enough.
        volume: What it was extracted from.
        T_world_camera: Where the camera was, shape [n, 4, 4] [m].
        depth_share: Share of all pixels that have a depth.
        used_share: Share of all pixels that have a depth up to `depth_max`.
        weight_threshold: A voxel counts where it was seen more often than this.
        seconds: Time of each stage: waiting for frames ("read"), "integrate", "extract".
        refinement: What became of the poses given, where they were refined, in JSON's types.
    """

    mesh: TriangleMesh
    volume: TSDFVolume
    T_world_camera: NDArray[np.float64]
    depth_share: float
    used_share: float
    weight_threshold: float
    seconds: dict[str, float]
    refinement: dict[str, Any] | None = None

    @property
    def frame_count(self) -> int:
        """How many frames were integrated."""
        return len(self.T_world_camera)


def fuse_dataset(
    dataset: FrameSource,
    *,
    voxel_size: float = VOXEL_SIZE,
    truncation: float | None = None,
    depth_max: float = DEPTH_MAX,
    weight_threshold: float | None = None,
    refine: bool = False,
    device: Any = None,
    read_ahead: int = READ_AHEAD,
    progress: ReportProgress | None = None,
) -> FusionResult:
    """Fuse posed RGB-D frames into a mesh.

    Args:
        dataset: From `open_dataset`, `room_sequence`, or anything with `len`, `read(i)`, `intrinsic`, `depth_scale`.
        voxel_size: Edge of a voxel [m].
        truncation: Distance from the surface [m] up to which depth is trusted; None takes 4 voxels.
        depth_max: Farther depth is left out [m].
        weight_threshold: Voxels seen more often than this count; None takes 3 from 30 frames on, 1 from 10, else 0.
        refine: Align each frame with the model that those before it made, from its pose; a frame that does not fit
            keeps the pose given.
        device: Where to compute; None for the CPU.
        read_ahead: Frames that are read while others are integrated; 0 reads each when its turn comes.
        progress: Called with the stage, how many of its steps are done, and how many there are.

    Raises:
        ValueError: A length that is not positive, no frame, a frame without pose, or a pose that is no rigid motion.
        FileError: A frame that cannot be read.
        DeviceError: No such device.

    Notes:
        The same bits from run to run on one device: frames are integrated in their order, however they are read.
    """
    where, say = resolve_device(device), progress or say_nothing
    voxel_size, farthest = check_positive("voxel_size", voxel_size), check_positive("depth_max", depth_max)
    frame_count = len(dataset)
    if frame_count == 0:
        raise ValueError("dataset: expected at least one frame, got none")
    if weight_threshold is None:
        weight_threshold = least_weight(frame_count)
    sizes = {"voxel_size": voxel_size, "truncation": truncation, "device": where}
    fold = (_Refined if refine else _AsGiven)(dataset, farthest, sizes)
    clock = Clock()
    with contextlib.closing(read_frames(dataset, check_count("read_ahead", read_ahead, minimum=0))) as frames:
        poses, shares = _integrate_frames(frames, dataset, fold, farthest, say, clock)
    say("extract", 0, 0)
    mesh = fold.volume.extract_triangle_mesh(weight_threshold=weight_threshold)
    clock.stop("extract")
    refinement = fold.refiner.describe() if isinstance(fold, _Refined) else None
    return FusionResult(mesh, fold.volume, poses, *shares, weight_threshold, clock.seconds, refinement)


class _AsGiven:
    """A volume that takes each frame at the pose given; with colour if the first frame has it."""

    volume: TSDFVolume

    def __init__(self, dataset: FrameSource, depth_max: float, sizes: dict[str, Any]):
        self._camera = dataset.intrinsic, {"depth_scale": dataset.depth_scale, "depth_max": depth_max}
        self._sizes = sizes

    def __call__(self, frame: Any, T_world_camera: Pose) -> Pose:
        """Fold a frame in; gives the pose at which it was."""
        if not hasattr(self, "volume"):
            self.volume = TSDFVolume(color=frame.color is not None, **self._sizes)
        camera, limits = self._camera
        self.volume.integrate(frame.depth, camera, np.linalg.inv(T_world_camera), color=frame.color, **limits)
        return T_world_camera


class _Refined:
    """... and at the pose that the model says."""

    def __init__(self, dataset: FrameSource, depth_max: float, sizes: dict[str, Any]):
        limits = {"depth_scale": dataset.depth_scale, "depth_max": depth_max}
        model = Model(dataset.intrinsic, **limits, **sizes)
        self.volume, self.refiner = model.volume, PoseRefiner(model)

    def __call__(self, frame: Any, T_world_camera: Pose) -> Pose:
        """Fold a frame in; gives the pose at which it was."""
        return self.refiner.integrate(frame, T_world_camera)


def _integrate_frames(
    frames: Iterable[Any],
    dataset: FrameSource,
    fold: Callable[[Any, Pose], Pose],
    depth_max: float,
    say: ReportProgress,
    clock: Clock,
) -> tuple[Pose, tuple[float, float]]:
    """Fold all frames in; gives the poses at which they were, and the shares of pixels measured and used."""
    poses, shares, frame_count = [], [], len(dataset)
    say("frames", 0, frame_count)
    for frame in frames:
        clock.stop("read")
        scale = dataset.depth_scale if frame.depth.dtype.kind in "iu" else 1.0
        shares.append(measured_shares(frame.depth, depth_max * scale))
        try:
            if frame.T_world_camera is None:
                raise ValueError(
                    "has no pose, and fusing needs where each frame was taken; pointloom reconstruct finds out"
                )
            poses.append(fold(frame, check_rigid("T_world_camera", frame.T_world_camera)))
        except ValueError as error:
            raise ValueError(f"frame {frame.name}: {error}") from error
        clock.stop("integrate")
        say("frames", len(poses), frame_count)
    depth_share, used_share = np.mean(shares, axis=0).tolist()
    return np.array(poses), (depth_share, used_share)


# ------------------------------------------------------------------------------------------------ folders


def fuse_folder(
    folder: FilePath,
    output: FilePath,
    *,
    layout: str = "auto",
    intrinsic: FilePath | None = None,
    voxel_size: float = VOXEL_SIZE,
    truncation: float | None = None,
    depth_max: float = DEPTH_MAX,
    every: int = 1,
    refine: bool = False,
    trajectory: FilePath | None = None,
    device: Any = "auto",
    picture: FilePath | None = None,
    overwrite: bool = False,
    progress: ReportProgress | None = None,
) -> dict[str, Any]:
    """Fuse a folder of frames into a mesh file, and a picture of it; outputs are checked before the work.

    Args:
        folder: As `open_dataset` takes it, with `layout` and `every`.
        output: A .ply, .obj, .stl, .off or .glb file; STL holds no colours, which are then left out.
        layout, every: As `open_dataset`.
        intrinsic: A camera as Open3D's JSON, if it is another than the folder says.
        voxel_size, truncation, depth_max, refine, device, progress: As `fuse_dataset`.
        trajectory: A file for the poses that were used: .txt or .tum (TUM's format), .log.
        picture: A .png file for a picture of the mesh.
        overwrite: Replace outputs that exist.

    Returns:
        What was done, in JSON's types; "poor" says why the result is poor, or is None. An empty mesh is not written.

    Raises:
        FileError: A file that cannot be read, or an output that cannot be written.
        ValueError, DeviceError: As `fuse_dataset`.
    """
    check_output(output, MESHES, what="meshes", overwrite=overwrite)
    if picture is not None:
        check_picture(picture, overwrite=overwrite)
    if trajectory is not None:
        check_trajectory_output(trajectory, overwrite=overwrite)
    where, opening = resolve_device(device), Clock()
    camera = None if intrinsic is None else read_pinhole_camera_intrinsic(intrinsic)
    dataset = _open_posed(folder, {"layout": layout, "intrinsic": camera, "every": every})
    opening.stop("open")
    sizes = {"voxel_size": voxel_size, "truncation": truncation, "depth_max": depth_max}
    result = fuse_dataset(dataset, **sizes, refine=refine, device=where, progress=progress)
    writing, files = Clock(), []
    if len(result.mesh):
        files = write_model(result.mesh, result.T_world_camera, output, picture, overwrite=overwrite)
        if trajectory is not None:
            times = [frame.timestamp for frame in dataset.frames]
            write_poses(trajectory, trajectory_of(result.T_world_camera, range(len(times)), times), overwrite=overwrite)
            files.append(os.fspath(trajectory))
        writing.stop("write")
    report = {"command": "fuse", "dataset": os.fspath(folder), "layout": dataset.layout, "left_out": dataset.left_out}
    report |= {"camera": describe_camera(dataset, intrinsic)}
    report |= describe_fusion(result, voxel_size=voxel_size, depth_max=depth_max)
    report |= {"seconds": opening.seconds | result.seconds | writing.seconds, "peak_bytes": peak_bytes()}
    report |= {"refinement": result.refinement}
    reasons = [_why_poor(result, depth_max), why_doubted(dataset, report["camera"]["source"])]
    if result.refinement is not None:
        reasons.append(why_refinement_poor(result.refinement, result.frame_count))
    return report | {"files": files, "poor": "; ".join(reason for reason in reasons if reason) or None}


def _open_posed(folder: FilePath, options: dict[str, Any]) -> RGBDDataset:
    """The folder, or an error that says where frames without any pose can go."""
    try:
        return open_dataset(folder, **options)
    except DatasetError as error:
        if not _has_no_poses(folder, options):
            raise
        remedy = "pointloom reconstruct takes frames without, pointloom track finds them"
        raise FileError(folder, "holds no poses", remedy=remedy) from error


def _has_no_poses(folder: FilePath, options: dict[str, Any]) -> bool:
    try:
        return all(frame.T_world_camera is None for frame in open_frames(folder, **options).frames)
    except PointloomError:
        return False


def describe_fusion(result: FusionResult, *, voxel_size: float, depth_max: float) -> dict[str, Any]:
    """The figures of a fusion, in JSON's types."""
    mesh, volume = result.mesh, result.volume
    vertices = mesh.vertices
    low, high = finite_box(vertices)
    return {
        "device": str(volume.device),
        "frames": result.frame_count,
        "voxel_size": voxel_size,
        "truncation": volume.truncation,
        "depth_max": depth_max,
        "weight_threshold": result.weight_threshold,
        "depth_share": result.depth_share,
        "used_share": result.used_share,
        "blocks": volume.block_count,
        "voxels": volume.block_count * BLOCK_VOXELS,
        "volume_bytes": volume.memory_bytes,
        "vertices": len(vertices),
        "triangles": len(mesh),
        "bounds": {"min": low.tolist(), "max": high.tolist()} if len(vertices) else None,
    }


def fusion_fields(report: dict[str, Any]) -> list[tuple[str, str]]:
    """The figures of a fusion as labels and values for the terminal."""
    seen = f"{format_share(report['used_share'])} of the pixels within {report['depth_max']:g} m"
    size = f"{report['voxel_size'] * 1000:g} mm, truncation {report['truncation'] * 1000:g} mm"
    frames = f"{report['frames']} on {report['device']}; {seen}"
    if lost := report.get("left_out"):
        frames += f"\n{len(lost)} left out, the first {lost[0]}"
    refinement = report.get("refinement")
    return [
        ("frames", frames),
        *([("poses", refinement_line(refinement))] if refinement else []),
        *([("camera", camera_line(report["camera"]))] if "camera" in report else []),
        ("voxels", f"{report['voxels']:,} of {size}, in {report['blocks']:,} blocks"),
        ("mesh", f"{report['vertices']:,} vertices, {report['triangles']:,} triangles"),
        ("bounds", format_bounds(report["bounds"])),
        ("seconds", format_seconds(report["seconds"])),
        ("memory", f"{format_bytes(report['volume_bytes'])} of volume, {format_bytes(report['peak_bytes'])} at most"),
        ("files", ", ".join(report["files"]) or "none"),
    ]


def write_model(
    mesh: TriangleMesh, T_world_camera: Pose, output: FilePath, picture: FilePath | None, *, overwrite: bool
) -> list[str]:
    """Write a mesh, without the colours where STL cannot hold them, and a picture of it; gives the files' names."""
    held = mesh
    if Path(output).suffix.lower() == ".stl":
        held = TriangleMesh._from_arrays(mesh.array("vertices"), mesh.array("triangles"), origin=mesh.origin)
    write_triangle_mesh(output, held, overwrite=overwrite)
    if picture is None:
        return [os.fspath(output)]
    draw_scene(picture, mesh, T_world_camera, overwrite=overwrite)
    return [os.fspath(output), os.fspath(picture)]


def _why_poor(result: FusionResult, depth_max: float) -> str | None:
    if reason := why_out_of_reach(result.depth_share, result.used_share, depth_max):
        return reason
    if not len(result.mesh):
        return (
            f"the mesh is empty, and nothing was written: no voxel was seen more than {result.weight_threshold:g} "
            "times; take more frames (a smaller --every), or check poses and camera"
        )
    return None
