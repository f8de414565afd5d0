"""Posed RGB-D frames to a colored mesh: `fuse`."""

from __future__ import annotations

import contextlib
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.depth_range import DEPTH_MAX
from ...core.checks import check_count, check_positive, check_progress, check_rigid
from ...core.devices import DeviceLike, resolve_device
from ...core.escaped_text import escaped
from ...core.progress import ReportProgress
from ...core.timing import Clock, check_clock
from ...io.frames.frames import (
    READ_AHEAD,
    FrameSource,
    check_frames,
    count_of,
    depth_unit,
    measured_fractions,
    read_frames,
    source_warnings,
)
from ...io.frames.rgbd_sources import RGBDSource
from ...kernels.linear_algebra import inv
from ...meshing.volume.surface_weights import min_weight
from ...meshing.volume.tsdf import TSDFVolume
from ...registration.trajectories.up_direction import up_of_poses
from ..slam.model import SlamModel
from ..slam.volume_sizes import check_sizes
from .pose_check import MAX_OFF_SURFACE, PoseCheck
from .refine import PoseRefinement, PoseRefiner
from .results import FusionResult

Pose = NDArray[np.float64]

VOXEL_SIZE = 0.02  # [m] twice the noise of structured light at 2 m. A room takes about 100 MB

NO_FRAME = "frames: expected at least one frame, got none"


def fuse(
    frames: FrameSource | RGBDSource,
    *,
    voxel_size: float = VOXEL_SIZE,
    truncation: float | None = None,
    depth_max: float = DEPTH_MAX,
    weight_threshold: float | None = None,
    refine: bool = False,
    device: DeviceLike = None,
    read_ahead: int = READ_AHEAD,
    progress: ReportProgress | None = None,
    clock: Clock | None = None,
) -> FusionResult:
    """Fuse posed RGB-D frames into a mesh, as `pointloom fuse` does.

    Args:
        frames: From `open_dataset`, `open_frames`, `frames_from`, a camera, or any source with `intrinsic`,
            `depth_scale` and either `len` and `read(i)` or an iterator. Each frame has its `T_world_camera`.
        voxel_size: Voxel edge [m].
        truncation: Truncation distance [m]; None: 4 voxels.
        depth_max: Maximum depth [m].
        weight_threshold: Minimum weight (exclusive) of surface voxels; None: 3 from 30 frames on, 1 from 10, else 0.
        refine: Align each frame with the model first. A frame that does not fit keeps its pose.
        device: Compute device; None: the CPU.
        read_ahead: Number of frames read ahead; 0: none.
        progress: Called with (stage, steps done, steps in all or 0 if unknown).
        clock: Measures the stages "read" (waiting for frames), "integrate", "extract".

    Returns:
        The mesh, its volume, and the figures.

    Raises:
        TypeError, ValueError: Not frames of one camera, a length that is not positive, no frame, or an invalid pose.
        FileError: A frame cannot be read.
        DeviceError: No such device.

    Notes:
        Bitwise reproducible on one device. Memory: the volume and `read_ahead` frames. Curless and Levoy, "A volumetric
        method for building complex models from range images", SIGGRAPH 1996.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from types import SimpleNamespace
        >>> camera = loom.PinholeCameraIntrinsic(32, 24, 30.0, 30.0, 15.5, 11.5)
        >>> wall = SimpleNamespace(depth=np.full((24, 32), 1000, np.uint16), color=None, T_world_camera=np.eye(4))
        >>> result = loom.rgbd.fuse(loom.frames_from([wall, wall], camera), voxel_size=0.05)
        >>> result.frame_count, bool(np.allclose(result.mesh.vertices[:, 2], 1.0, atol=1e-4))
        (2, True)
    """
    count, target_device = count_of(check_frames("frames", frames)), resolve_device(device)
    report_progress, clock = check_progress(progress), check_clock(clock)
    max_depth, ahead = check_positive("depth_max", depth_max), check_count("read_ahead", read_ahead, minimum=0)
    if weight_threshold is not None:
        weight_threshold = check_positive("weight_threshold", weight_threshold, allow_zero=True)
    if hasattr(frames, "__len__") and not count:
        raise ValueError(NO_FRAME)
    edge, cut = check_sizes(voxel_size, truncation)
    sizes = {"voxel_size": edge, "truncation": cut, "device": target_device}
    fold = (_Refined if refine else _AsGiven)(frames, max_depth, sizes)
    check = PoseCheck(frames.intrinsic, frames.depth_scale, max_depth, count)
    poses, fractions = _integrate_frames(frames, fold, check, ahead, report_progress, clock)
    threshold = min_weight(len(poses)) if weight_threshold is None else weight_threshold
    report_progress("extract", 0, 0)
    mesh = fold.volume.extract_triangle_mesh(weight_threshold=threshold)
    mesh.up = up_of_poses(np.asarray(poses))
    clock.stop("extract")
    fractions_off = check.fractions_off(fold.volume)
    is_off = bool(fractions_off) and float(np.median(fractions_off)) > MAX_OFF_SURFACE
    camera, depth_factor, depth_deviation = check.camera_and_factor(is_off)
    checks: dict[str, Any] = {
        "fractions_off": fractions_off, "seen_extent": check.seen_extent(),
        "fraction_displaced": check.fraction_displaced(edge),
        "camera": camera, "depth_factor": depth_factor, "depth_deviation": depth_deviation,
        "source_warnings": (*source_warnings(frames), *check.images.warnings), "notes": check.notes,
    }  # fmt: skip
    clock.stop("check")
    return FusionResult(mesh, fold.volume, poses, max_depth, *fractions, threshold, fold.refinement, **checks)


class _AsGiven:
    volume: TSDFVolume
    refinement: PoseRefinement | None = None

    def __init__(self, frames: FrameSource | RGBDSource, depth_max: float, sizes: dict[str, Any]):
        self._frames, self._depth_max, self._sizes = frames, depth_max, sizes

    def __call__(self, frame: Any, T_world_camera: Pose) -> Pose:
        if not hasattr(self, "volume"):
            self.volume = TSDFVolume(color=frame.color is not None, **self._sizes)
        limits = {"depth_scale": depth_unit(self._frames, frame), "depth_max": self._depth_max}
        T = inv(T_world_camera)
        self.volume.integrate(frame.depth, self._frames.intrinsic, T, color=frame.color, **limits)
        return T_world_camera


class _Refined:
    def __init__(self, frames: FrameSource | RGBDSource, depth_max: float, sizes: dict[str, Any]):
        limits = {"depth_scale": frames.depth_scale, "depth_max": depth_max}
        model = SlamModel(frames.intrinsic, **limits, **sizes)
        self.volume, self._refiner = model.volume, PoseRefiner(model)

    def __call__(self, frame: Any, T_world_camera: Pose) -> Pose:
        return self._refiner.integrate(frame, T_world_camera)

    @property
    def refinement(self) -> PoseRefinement | None:
        return self._refiner.refinement


def _integrate_frames(
    frames: FrameSource | RGBDSource,
    fold: Callable[[Any, Pose], Pose],
    check: PoseCheck,
    read_ahead: int,
    report_progress: ReportProgress,
    clock: Clock,
) -> tuple[Pose, tuple[float, float]]:
    """Integrate all frames. Returns their poses, and the fractions of pixels measured and used."""
    poses, fractions, count = [], [], count_of(frames)
    report_progress("frames", 0, count)
    with contextlib.closing(read_frames(frames, read_ahead)) as taken:
        for frame in taken:
            clock.stop("read")
            fractions.append(measured_fractions(frame.depth, check.depth_max * depth_unit(frames, frame)))
            try:
                given = _pose_of(frame)
                poses.append(fold(frame, given))
                check.add(frame.depth, frame.color, poses[-1], given)
            except ValueError as error:
                raise ValueError(f"frame {escaped(frame.name)}: {error}") from error
            clock.stop("integrate")
            report_progress("frames", len(poses), count)
    if not poses:
        raise ValueError(NO_FRAME)
    depth_fraction, used_fraction = np.mean(fractions, axis=0).tolist()
    return np.array(poses), (depth_fraction, used_fraction)


def _pose_of(frame: Any) -> Pose:
    if frame.T_world_camera is None:
        raise ValueError("expected a camera pose (T_world_camera), got None; pointloom reconstruct estimates poses")
    return check_rigid("T_world_camera", frame.T_world_camera)
