"""Acceptance of the camera that fits the rotated frames of a path: `assess_camera`."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...core.reports import Assessed, quality
from ...kernels.rgbd.stream_views import StreamView, view_stream
from ..odometry.camera_fit import CameraFit, CameraView, ViewPairs, fit_camera, rotated_pairs
from .fixed_parts import cell_lens
from .frames import SensorFrame

MAX_VIEWS = 40  # compared frames, spread over the path
# Largest accepted log focal length, principal point (u, v, in focal lengths) and radial distortion, besides MAX_SIGMAS
# deviations of each. The kitchen, whose sensor is not calibrated, has up to 0.07 (deviation 0.03), 0.35 (0.06) and
# 0.15. Chosen on the kitchen and two synthetic rooms, verified on synthetic sites of seeds 40 and 41 (2026-11-29).
MAX_CORRECTIONS, MAX_SIGMAS = np.array([0.055, 0.28, 0.28, 0.2]), 1.5


@dataclasses.dataclass(frozen=True)
class FocalCheck(Assessed):
    """Camera that fits pairs of frames which are rotated against each other.

    Attributes:
        pairs: Number of aligned pairs.
        residual: Weighted root mean square residual with the given camera [m].
        factor: Best factor of the focal length. 1 if none is clearly better.
        residual_there: Residual of the best camera [m].
        center: Displacement of the principal point [px]. 0 if none is clearly better.
        distortion: Radial distortion of the rays (factor of squared distance from the center, in focal lengths). 0 if
            none is clearly better.

    Example:
        >>> import pointloom as loom
        >>> print(loom.rgbd.FocalCheck(pairs=8, residual=0.004, factor=1.0, residual_there=0.004))
        8 pairs of rotated frames have a residual of 4.0 mm, and no other focal length fits better
        >>> loom.rgbd.FocalCheck(pairs=8, residual=0.012, factor=1.25, residual_there=0.004).reliable
        False
    """

    pairs: int
    residual: float
    factor: float
    residual_there: float
    center: tuple[float, float] = (0.0, 0.0)
    distortion: float = 0.0

    def __str__(self) -> str:
        summary = f"{self.pairs} pairs of rotated frames have a residual of {self.residual * 1000:.1f} mm"
        return "; ".join(self.warnings) or f"{summary}, and no other focal length fits better"

    @property
    def warnings(self) -> tuple[str, ...]:
        better = []
        if self.factor != 1.0:
            better.append(f"a focal length about {self.factor:.3g} times as long")
        if any(self.center):
            better.append(f"a principal point moved by {self.center[0]:.0f}, {self.center[1]:.0f} px")
        if self.distortion:
            better.append(f"a radial distortion of {self.distortion:.2f}; undistort the images")
        if not better:
            return ()
        return (
            f"the camera may be wrong: rotated frames fit better with {', and '.join(better)} "
            f"({self.residual_there * 1000:.1f} mm apart, not {self.residual * 1000:.1f}); correct intrinsic",
        )

    def to_dict(self) -> dict[str, Any]:
        residuals = {"residual_m": self.residual, "factor": self.factor, "residual_there_m": self.residual_there}
        other = {"center_px": list(self.center), "distortion": self.distortion}
        return {"pairs": self.pairs, **residuals, **other, **quality(self)}


def view_of(frame: SensorFrame, view: StreamView | None = None) -> CameraView:
    """The cells of a frame."""
    cells = view or view_stream(frame.depth, frame.pixels, frame.intrinsic.width, frame.intrinsic.height)
    return CameraView(cells.host_nearness, cell_lens(frame, cells))


def spread(count: int) -> list[int]:
    """Indices of at most MAX_VIEWS of `count` frames."""
    return np.unique(np.linspace(0, count - 1, min(count, MAX_VIEWS)).round().astype(int)).tolist() if count else []


def assess_camera(
    views: Sequence[CameraView], poses: Sequence[NDArray[np.float64]], intrinsic: PinholeCameraIntrinsic
) -> FocalCheck | None:
    """Assess a camera by views with poses T_world_camera, at most MAX_VIEWS. None if they do not determine it."""
    chosen = spread(len(poses))
    their_poses = [poses[index] for index in chosen]
    pairs = ViewPairs([views[index] for index in chosen], their_poses, rotated_pairs(their_poses))
    return judged(fit_camera(pairs), intrinsic)


def judged(fit: CameraFit | None, intrinsic: PinholeCameraIntrinsic) -> FocalCheck | None:
    if fit is None or not np.isfinite(fit.deviations[0]):
        return None
    is_off = np.abs(fit.values) > MAX_CORRECTIONS + MAX_SIGMAS * fit.deviations
    log_focal, u, v, distortion = np.where(is_off, fit.values, 0.0).tolist()
    center = (u * intrinsic.fx, v * intrinsic.fy)
    there = fit.fitted_residual if is_off.any() else fit.residual
    return FocalCheck(len(fit.pairs), fit.residual, math.exp(log_focal), there, center, distortion)
