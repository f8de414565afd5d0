"""Whether the focal length is right, from the frames alone: `check_focal`.

A wrong focal length stretches what a frame shows across its line of sight. Frames that look the same way are stretched
alike and fit each other as well as before; frames that are turned against each other do not. So pairs of frames that
are turned by some degrees are aligned with several focal lengths, and the one given should fit best.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from ..pcd.camera import PinholeCameraIntrinsic
from ..pcd.errors import FileError
from ..pcd.io.trajectory import Trajectory
from ..registration.odometry.alignment import align_frames
from ..registration.odometry.frames import OdometryFrame
from ..registration.odometry.results import OdometryResult
from .frames import FrameSource

TURN = 12.0  # [degrees] between the frames of a pair: enough to tell 10 % of the focal length, and they still overlap
PAIRS = 8
FEWEST_PAIRS = 3  # below it nothing is said
FACTORS = (0.8, 0.9, 1.1, 1.25)  # of the focal length, that are tried beside the one given
BETTER = 0.95  # of the residual, below which another focal length fits better: noise alone stays above 0.99
LEAST_OVERLAP = 0.2
MISS = 0.05  # [m] what a pixel counts that is off the other frame's surface


def check_focal(
    dataset: FrameSource, path: Trajectory, *, depth_max: float, uncertain: Sequence[int] = (), device: Any = None
) -> dict[str, Any] | None:
    """Residuals of turned pairs of frames with the focal length given and with others.

    Args:
        dataset: The frames.
        path: Poses of some of them; ids hold their numbers.
        depth_max: Farther depth is left out [m].
        uncertain: Numbers of frames whose poses say nothing.
        device: Where to compute.

    Returns:
        "pairs", how many were aligned; "residual_m" of the focal length given, the median; "factor", by which it fits
        best, 1 where none is clearly better, and "residual_there_m". None where the camera turned too little to tell.
    """
    found, path = [], _without(path, uncertain)
    for first, second in turned_pairs(path):
        residuals = _residuals(dataset, path, first, second, depth_max, device)
        if residuals is not None:
            found.append(residuals)
    if len(found) < FEWEST_PAIRS:
        return None
    table = np.array(found)
    ratios = np.median(table[:, 1:] / table[:, :1], axis=0)
    best = int(np.argmin(ratios))
    given = float(np.median(table[:, 0]))
    factor, ratio = (FACTORS[best], float(ratios[best])) if ratios[best] < BETTER else (1.0, 1.0)
    return {"pairs": len(found), "residual_m": given, "factor": factor, "residual_there_m": given * ratio}


def why_focal_doubted(check: dict[str, Any] | None) -> str | None:
    """Whether another focal length fits the frames better, in the words of the command line."""
    if check is None or check["factor"] == 1.0:
        return None
    return (
        f"the camera may be wrong: frames that are turned against each other fit better with a focal length "
        f"about {check['factor']:g} times as long ({check['residual_there_m'] * 1000:.1f} mm off each other instead of "
        f"{check['residual_m'] * 1000:.1f}); give the right one with --intrinsic"
    )


def turned_pairs(path: Trajectory) -> list[tuple[int, int]]:
    """Places in a path of poses that are turned against each other, spread over it."""
    axes = path.poses[:, :3, 2]
    pairs = []
    for first in range(0, len(path), max(1, len(path) // PAIRS)):
        turned = np.flatnonzero(axes[first + 1 :] @ axes[first] < math.cos(math.radians(TURN)))
        if len(turned) and first + 1 + int(turned[0]) not in (second for _, second in pairs):
            pairs.append((first, first + 1 + int(turned[0])))
    return pairs


def _without(path: Trajectory, uncertain: Sequence[int]) -> Trajectory:
    assert path.ids is not None
    sure = ~np.isin(path.ids[:, 0], np.array(uncertain, np.int64))
    return Trajectory(path.poses[sure], ids=path.ids[sure])


def _residuals(
    dataset: FrameSource, path: Trajectory, first: int, second: int, depth_max: float, device: Any
) -> list[float] | None:
    """The residual of a pair with each focal length, the one given first; None where it says nothing."""
    assert path.ids is not None
    try:
        frames = [dataset.read(int(path.ids[place, 0])) for place in (first, second)]
    except FileError:
        return None
    start = np.linalg.inv(path.poses[first]) @ path.poses[second]
    options = {"depth_scale": dataset.depth_scale, "depth_max": depth_max, "device": device}
    results = []
    for factor in (1.0, *FACTORS):
        camera = _stretched(dataset.intrinsic, factor)
        target, source = (OdometryFrame(frame.depth, camera, frame.color, **options) for frame in frames)
        results.append(align_frames(source, target, start))
    if not any(result.success for result in results) or min(result.overlap for result in results) < LEAST_OVERLAP:
        return None
    return [_residual(result) for result in results]


def _residual(result: OdometryResult) -> float:
    """Root of the mean square distance [m] over the pixels that meet depth."""
    share = result.fitness / result.overlap
    return math.sqrt(share * result.inlier_rmse**2 + (1 - share) * MISS**2)


def _stretched(camera: PinholeCameraIntrinsic, factor: float) -> PinholeCameraIntrinsic:
    fx, fy = factor * camera.fx, factor * camera.fy
    return PinholeCameraIntrinsic(camera.width, camera.height, fx, fy, camera.cx, camera.cy)
