"""Posed RGB-D frames to a coloured mesh: `fuse_dataset` for any sequence, `fuse_folder` for one on disk."""

from __future__ import annotations

import contextlib
import contextvars
import dataclasses
import os
from collections import deque
from collections.abc import Callable, Generator, Iterable
from concurrent.futures import Future, ThreadPoolExecutor
from functools import partial
from pathlib import Path
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from ..meshing.mesh import TriangleMesh
from ..meshing.mesh_files import write_triangle_mesh
from ..meshing.tsdf import BLOCK_VOXELS, TSDFVolume
from ..pcd.camera import PinholeCameraIntrinsic, read_pinhole_camera_intrinsic
from ..pcd.checks import check_count, check_positive, check_rigid
from ..pcd.coordinates import finite_box
from ..pcd.devices import resolve_device
from ..pcd.errors import FileError
from ..pcd.io.atomic import check_writable
from ..pcd.io.datasets import RGBDDataset, open_dataset
from .console import Clock, ReportProgress, format_bounds, format_bytes, format_seconds, format_share, peak_bytes
from .tables import MESHES, check_output

FilePath = str | os.PathLike[str]

VOXEL_SIZE = 0.02  # [m] twice the noise of structured light at 2 m; a room then takes some 100 MB
TRUNCATION_VOXELS = 4.0
DEPTH_MAX = 4.0  # [m] beyond it the noise of depth cameras passes 2 cm

# Frames decoded while earlier ones are integrated. Decoding takes about as long as integrating, on one core.
READ_AHEAD = 4

# A voxel counts as surface when it was seen more often than this; with few frames most are seen once or twice.
WEIGHTS = ((30, 3.0), (10, 1.0), (0, 0.0))  # (from so many frames on, the threshold)

BACKDROP = (0.88, 0.89, 0.91)  # of the picture: sunlit walls are as white as paper

# Below this share of pixels with a depth in reach the frames are likely read in the wrong unit, or to the wrong reach.
HARDLY_ANY = 0.02


class FrameSource(Protocol):
    """What can be fused: frames with depth, color, T_world_camera and name, all of one camera."""

    @property
    def intrinsic(self) -> PinholeCameraIntrinsic:
        """The camera of all frames."""
        ...

    @property
    def depth_scale(self) -> float:
        """Stored depth of one metre, where depth is stored in whole numbers."""
        ...

    def __len__(self) -> int: ...

    def read(self, index: int, /) -> Any:
        """A frame by its place."""
        ...


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
    """

    mesh: TriangleMesh
    volume: TSDFVolume
    T_world_camera: NDArray[np.float64]
    depth_share: float
    used_share: float
    weight_threshold: float
    seconds: dict[str, float]

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
    where, say = resolve_device(device), progress or _say_nothing
    voxel_size, farthest = check_positive("voxel_size", voxel_size), check_positive("depth_max", depth_max)
    frame_count = len(dataset)
    if frame_count == 0:
        raise ValueError("dataset: expected at least one frame, got none")
    if weight_threshold is None:
        weight_threshold = next(threshold for frames, threshold in WEIGHTS if frame_count >= frames)
    make_volume = partial(TSDFVolume, voxel_size=voxel_size, truncation=truncation, device=where)
    clock = Clock()
    with contextlib.closing(_read_frames(dataset, check_count("read_ahead", read_ahead, minimum=0))) as frames:
        volume, poses, shares = _integrate_frames(frames, dataset, make_volume, farthest, say, clock)
    say("extract", 0, 0)
    mesh = volume.extract_triangle_mesh(weight_threshold=weight_threshold)
    clock.stop("extract")
    return FusionResult(mesh, volume, poses, *shares, weight_threshold, clock.seconds)


def _integrate_frames(
    frames: Iterable[Any],
    dataset: FrameSource,
    make_volume: Callable[..., TSDFVolume],
    depth_max: float,
    say: ReportProgress,
    clock: Clock,
) -> tuple[TSDFVolume, NDArray[np.float64], tuple[float, float]]:
    """A volume of all frames, with colour if the first has it; the poses; the shares of pixels measured and used."""
    volume, poses, shares, frame_count = None, [], [], len(dataset)
    say("frames", 0, frame_count)
    for frame in frames:
        clock.stop("read")
        if volume is None:
            volume = make_volume(color=frame.color is not None)
        scale = dataset.depth_scale if frame.depth.dtype.kind in "iu" else 1.0
        shares.append(_measured_shares(frame.depth, depth_max * scale))
        _integrate(volume, frame, dataset.intrinsic, dataset.depth_scale, depth_max)
        poses.append(frame.T_world_camera)
        clock.stop("integrate")
        say("frames", len(poses), frame_count)
    assert volume is not None  # there is a frame
    depth_share, used_share = np.mean(shares, axis=0).tolist()
    return volume, np.array(poses), (depth_share, used_share)


def _say_nothing(stage: str, done: int, total: int) -> None:
    pass


def _read_frames(dataset: FrameSource, ahead: int) -> Generator[Any, None, None]:
    """The frames in order, some of them read in threads before they are asked for (Pillow decodes without the GIL)."""
    count = len(dataset)
    if not ahead:
        for i in range(count):
            yield dataset.read(i)
        return
    pending: deque[Future[Any]] = deque()
    with ThreadPoolExecutor(2, thread_name_prefix="pointloom-read") as pool:
        try:
            for i in range(count):
                # a context of its own: which compiler the caller chose holds in the thread too
                pending.append(pool.submit(contextvars.copy_context().run, dataset.read, i))
                if len(pending) > ahead:
                    yield pending.popleft().result()
            while pending:
                yield pending.popleft().result()
        finally:
            for future in pending:
                future.cancel()


def _integrate(
    volume: TSDFVolume, frame: Any, intrinsic: PinholeCameraIntrinsic, depth_scale: float, depth_max: float
) -> None:
    try:
        if frame.T_world_camera is None:
            raise ValueError("has no pose, and fusing needs where each frame was taken; find them by tracking first")
        T_camera_world = np.linalg.inv(check_rigid("T_world_camera", frame.T_world_camera))
        volume.integrate(
            frame.depth, intrinsic, T_camera_world, color=frame.color, depth_scale=depth_scale, depth_max=depth_max
        )
    except ValueError as error:
        raise ValueError(f"frame {frame.name}: {error}") from error


def _measured_shares(depth: NDArray[Any], farthest: float) -> tuple[float, float]:
    """Share of pixels with a depth at all, and with one up to `farthest`, in the picture's unit."""
    measured = depth > 0
    return float(np.mean(measured)), float(np.mean(measured & (depth <= farthest)))


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
        voxel_size, truncation, depth_max, device, progress: As `fuse_dataset`.
        picture: A .png file for a picture of the mesh.
        overwrite: Replace outputs that exist.

    Returns:
        What was done, in JSON's types; "poor" says why the result is poor, or is None. An empty mesh is not written.

    Raises:
        FileError: A file that cannot be read, or an output that cannot be written.
        ValueError, DeviceError: As `fuse_dataset`.
    """
    _check_outputs(output, picture, overwrite)
    where, opening = resolve_device(device), Clock()
    camera = None if intrinsic is None else read_pinhole_camera_intrinsic(intrinsic)
    dataset = open_dataset(folder, layout=layout, intrinsic=camera, every=every)
    opening.stop("open")
    sizes = {"voxel_size": voxel_size, "truncation": truncation, "depth_max": depth_max}
    result = fuse_dataset(dataset, **sizes, device=where, progress=progress)
    writing, files = Clock(), []
    if len(result.mesh):
        files = _write_results(result, output, picture, overwrite)
        writing.stop("write")
    report = {"command": "fuse", "dataset": os.fspath(folder), "layout": dataset.layout, "left_out": dataset.left_out}
    report |= {"camera": _describe_camera(dataset, intrinsic)}
    report |= describe_fusion(result, voxel_size=voxel_size, depth_max=depth_max)
    report |= {"seconds": opening.seconds | result.seconds | writing.seconds, "peak_bytes": peak_bytes()}
    reasons = [_why_poor(result, depth_max), _why_doubted(dataset, report["camera"]["source"])]
    return report | {"files": files, "poor": "; ".join(reason for reason in reasons if reason) or None}


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
    return [
        ("frames", frames),
        *([("camera", _camera_line(report["camera"]))] if "camera" in report else []),
        ("voxels", f"{report['voxels']:,} of {size}, in {report['blocks']:,} blocks"),
        ("mesh", f"{report['vertices']:,} vertices, {report['triangles']:,} triangles"),
        ("bounds", format_bounds(report["bounds"])),
        ("seconds", format_seconds(report["seconds"])),
        ("memory", f"{format_bytes(report['volume_bytes'])} of volume, {format_bytes(report['peak_bytes'])} at most"),
        ("files", ", ".join(report["files"]) or "none"),
    ]


def _describe_camera(dataset: RGBDDataset, given: FilePath | None) -> dict[str, Any]:
    """The camera that was used, and where it comes from."""
    camera = dataset.intrinsic
    source = dataset.intrinsic_source if given is None else os.fspath(given)
    size = {"width": camera.width, "height": camera.height}
    return size | {"fx": camera.fx, "fy": camera.fy, "cx": camera.cx, "cy": camera.cy, "source": source}


def _camera_line(camera: dict[str, Any]) -> str:
    numbers = f"f {camera['fx']:g} {camera['fy']:g}, c {camera['cx']:g} {camera['cy']:g}"
    return f"{camera['width']} x {camera['height']}, {numbers}, from {camera['source']}"


def _why_doubted(dataset: RGBDDataset, source: str) -> str | None:
    doubt = dataset.intrinsic_doubt.replace("with intrinsic=", "with --intrinsic, as Open3D's JSON")
    return f"the camera may be wrong ({source}): {doubt}" if doubt else None


def _check_outputs(output: Any, picture: Any, overwrite: bool) -> None:
    check_output(output, MESHES, what="meshes", overwrite=overwrite)
    if picture is None:
        return
    if Path(picture).suffix.lower() != ".png":
        raise FileError(picture, "pictures are written as .png", remedy="Give a name that ends in .png")
    check_writable(picture, overwrite=overwrite)


def _write_results(result: FusionResult, output: Any, picture: Any, overwrite: bool) -> list[str]:
    mesh = result.mesh
    if Path(output).suffix.lower() == ".stl":
        mesh = TriangleMesh._from_arrays(mesh.array("vertices"), mesh.array("triangles"), origin=mesh.origin)
    write_triangle_mesh(output, mesh, overwrite=overwrite)
    if picture is None:
        return [os.fspath(output)]
    from .picture import render_mesh, save_picture
    from .scene_view import view_scene

    view = view_scene(result.mesh, result.T_world_camera)
    image = render_mesh(result.mesh, view=view, background=BACKDROP, device=result.volume.device)
    save_picture(picture, image, overwrite=overwrite)
    return [os.fspath(output), os.fspath(picture)]


def _why_poor(result: FusionResult, depth_max: float) -> str | None:
    used, measured = format_share(result.used_share), format_share(result.depth_share)
    if result.used_share < HARDLY_ANY and result.depth_share >= HARDLY_ANY:
        return (
            f"only {used} of the pixels have a depth within {depth_max:g} m, though {measured} have one; "
            "raise --depth-max, or check the layout (its depth unit)"
        )
    if result.used_share < HARDLY_ANY:
        return f"only {used} of the pixels have a depth; check the depth maps with pointloom info"
    if not len(result.mesh):
        return (
            f"the mesh is empty, and nothing was written: no voxel was seen more than {result.weight_threshold:g} "
            "times; take more frames (a smaller --every), or check poses and camera"
        )
    return None
