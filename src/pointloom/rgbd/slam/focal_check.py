"""Check of the focal length from the frames: `check_focal`.

A wrong focal length stretches frames laterally, so frames rotated against each other no longer fit. Rotated pairs are
aligned with several focal lengths. The given one should fit best.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable, Iterable, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.depth_range import DEPTH_MAX
from ...cameras.trajectory import Trajectory
from ...core.checks import check_count, check_list, check_positive, check_rigid
from ...core.devices import DeviceLike, resolve_device
from ...core.errors import FileError
from ...core.reports import Assessed, quality
from ...io.frames.frames import FrameSource, can_read, check_frames, depth_unit
from ...io.frames.rgbd_sources import RGBDSource
from ...kernels.linear_algebra import inv, matmul
from ..odometry.alignment import align_frames
from ..odometry.frames import OdometryFrame
from ..odometry.results import OdometryResult
from .tracking import track

MIN_ROTATION = 12.0  # [degrees] rotation of a pair: resolves 10% of the focal length, with enough overlap
FRAME_PAIRS = 8
MIN_PAIRS = 3  # minimum for a result
FOCAL_FACTORS = (0.8, 0.9, 1.1, 1.25)  # tested focal length factors
MAX_RESIDUAL_RATIO = 0.95  # residual ratio of a better focal length: noise stays above 0.99
MIN_OVERLAP = 0.2
MISS_COST = 0.05  # [m] cost of a pixel off the surface


@dataclasses.dataclass(frozen=True)
class FocalCheck(Assessed):
    """Residuals of rotated frame pairs by focal length.

    Attributes:
        pairs: Number of aligned pairs.
        residual: Median with the given focal length [m].
        factor: Best factor of the focal length. 1 if none is clearly better.
        residual_there: Median at that factor [m].

    Example:
        >>> from pointloom.rgbd.slam.focal_check import FocalCheck
        >>> print(FocalCheck(pairs=8, residual=0.004, factor=1.0, residual_there=0.004))
        8 pairs of rotated frames have a residual of 4.0 mm, and no other focal length fits better
        >>> FocalCheck(pairs=8, residual=0.012, factor=1.25, residual_there=0.004).reliable
        False
    """

    pairs: int
    residual: float
    factor: float
    residual_there: float

    def __str__(self) -> str:
        summary = f"{self.pairs} pairs of rotated frames have a residual of {self.residual * 1000:.1f} mm"
        return "; ".join(self.warnings) or f"{summary}, and no other focal length fits better"

    @property
    def warnings(self) -> tuple[str, ...]:
        if self.factor == 1.0:
            return ()
        return (
            f"the camera may be wrong: rotated frames fit better with a focal length about {self.factor:g} times as "
            f"long ({self.residual_there * 1000:.1f} mm apart, not {self.residual * 1000:.1f}); correct intrinsic",
        )

    def to_dict(self) -> dict[str, Any]:
        residuals = {"residual_m": self.residual, "factor": self.factor, "residual_there_m": self.residual_there}
        return {"pairs": self.pairs, **residuals, **quality(self)}


def check_focal(
    frames: FrameSource | RGBDSource,
    trajectory: Trajectory | None = None,
    *,
    uncertain: Iterable[int] = (),
    depth_max: float = DEPTH_MAX,
    device: DeviceLike = None,
) -> FocalCheck | None:
    """Check whether frames that are rotated against each other fit better with another focal length.

    Args:
        frames: From `open_frames`, `frames_from`, or any source with `intrinsic`, `depth_scale` and either `len` and
            `read(i)` or a repeatable iterator.
        trajectory: Poses of some frames, by ids or the first ones. None: estimated by `loom.rgbd.track`.
        uncertain: Frame numbers to ignore.
        depth_max: Maximum depth [m].
        device: Compute device; None: the CPU.

    Returns:
        None if the camera rotated too little, or too few frames overlap.

    Raises:
        TypeError, ValueError: Not frames of one camera, not a trajectory, or an invalid length or frame number.
        DeviceError: No such device.

    Notes:
        At most eight pairs with five focal lengths each. Bitwise reproducible.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> frames = loom.frames_from([(None, np.ones((48, 64), np.float32))] * 3, camera)
        >>> still = loom.Trajectory(np.tile(np.eye(4), (3, 1, 1)))
        >>> print(loom.rgbd.check_focal(frames, still))  # a camera that did not turn tells nothing
        None
    """
    check_frames("frames", frames)
    where, farthest = resolve_device(device), check_positive("depth_max", depth_max)
    uncertain_frames = [
        check_count("uncertain", number, minimum=0) for number in check_list("uncertain", uncertain, "numbers")
    ]
    if trajectory is None:
        tracked = track(frames, depth_max=farthest, device=where)
        path, uncertain_frames = tracked.trajectory, [*uncertain_frames, *tracked.uncertain]
    elif isinstance(trajectory, Trajectory):
        path = trajectory
    else:
        raise TypeError(f"trajectory: expected a Trajectory or None, got {type(trajectory).__name__}")
    poses, numbers = _sure(path, uncertain_frames)
    pairs = rotated_pairs(Trajectory(poses))
    read = _reader(frames, {int(numbers[index]) for pair in pairs for index in pair})
    options = {"depth_max": farthest, "device": where}
    pair_residuals = []
    for first, second in pairs:
        ends = [
            check_rigid(f"trajectory: the pose of frame {numbers[index]}", poses[index]) for index in (first, second)
        ]
        start = matmul(inv(ends[0]), ends[1])
        residuals = _residuals(read, frames, (int(numbers[first]), int(numbers[second])), start, options)
        if residuals is not None:
            pair_residuals.append(residuals)
    return _judged(pair_residuals)


def _judged(residuals: Sequence[Sequence[float]]) -> FocalCheck | None:
    if len(residuals) < MIN_PAIRS:
        return None
    table = np.array(residuals)
    ratios = np.median(table[:, 1:] / table[:, :1], axis=0)
    best = int(np.argmin(ratios))
    given = float(np.median(table[:, 0]))
    factor, ratio = (FOCAL_FACTORS[best], float(ratios[best])) if ratios[best] < MAX_RESIDUAL_RATIO else (1.0, 1.0)
    return FocalCheck(len(residuals), given, factor, given * ratio)


def rotated_pairs(path: Trajectory) -> list[tuple[int, int]]:
    """Index pairs of poses that are rotated against each other, spread over the path."""
    axes = path.poses[:, :3, 2]
    pairs = []
    for first in range(0, len(path), max(1, len(path) // FRAME_PAIRS)):
        rotated = np.flatnonzero(matmul(axes[first + 1 :], axes[first]) < math.cos(math.radians(MIN_ROTATION)))
        if len(rotated) and first + 1 + int(rotated[0]) not in (second for _, second in pairs):
            pairs.append((first, first + 1 + int(rotated[0])))
    return pairs


def _sure(path: Trajectory, uncertain: Sequence[int]) -> tuple[Any, Any]:
    numbers = np.arange(len(path)) if path.ids is None else path.ids[:, 0]
    sure = ~np.isin(numbers, np.array(uncertain, np.int64))
    return path.poses[sure], numbers[sure]


def _reader(frames: FrameSource | RGBDSource, numbers: set[int]) -> Callable[[int], Any]:
    if can_read(frames):
        read: Callable[[int], Any] = frames.read
        known = numbers.intersection(range(len(frames)))
    else:
        cached = {i: frame for i, frame in enumerate(frames if numbers else ()) if i in numbers}  # type: ignore[arg-type]
        read, known = cached.__getitem__, set(cached)
    if unknown := numbers - known:
        raise ValueError(f"trajectory: frame {min(unknown)} is not in frames")
    return read


def _residuals(
    read: Callable[[int], Any],
    source: FrameSource | RGBDSource,
    pair: tuple[int, int],
    start: ArrayLike | None,
    options: dict[str, Any],
) -> list[float] | None:
    try:
        frames = [read(number) for number in pair]
    except FileError:
        return None
    results = []
    for factor in (1.0, *FOCAL_FACTORS):
        camera = _stretched(source.intrinsic, factor)
        first, second = (
            OdometryFrame(frame.depth, camera, frame.color, depth_scale=depth_unit(source, frame), **options)
            for frame in frames
        )
        results.append(align_frames(second, first, start))
    if not any(result.reliable for result in results) or min(result.overlap for result in results) < MIN_OVERLAP:
        return None
    return [_residual(result) for result in results]


def _residual(result: OdometryResult) -> float:
    fraction = result.fitness / result.overlap
    return math.sqrt(fraction * result.inlier_rmse**2 + (1 - fraction) * MISS_COST**2)


def _stretched(camera: PinholeCameraIntrinsic, factor: float) -> PinholeCameraIntrinsic:
    fx, fy = factor * camera.fx, factor * camera.fy
    return PinholeCameraIntrinsic(camera.width, camera.height, fx, fy, camera.cx, camera.cy)
