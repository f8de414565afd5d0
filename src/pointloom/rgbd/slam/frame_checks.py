"""Acceptance of frame poses against the model.

Tracking starts nearby, so wrong poses slid or left the model: the checks are the agreement of the common surface, the
determination of the motion, and the jump. Moving people hide the model, but the remaining pixels agree at a correct
pose. Recognitions from keyframes need the stricter checks of odometry (src/pointloom/rgbd/odometry/motion_checks.py).
"""

from __future__ import annotations

import dataclasses
import math

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import norm
from ...registration.rigid import rotation_vector
from ..odometry.frames import OdometryFrame
from ..odometry.motion_checks import UNDETERMINED
from ..odometry.results import OdometryResult
from .results import Status, TrackingResult

MIN_DEPTH = 0.02  # minimum depth fraction of a frame
BLANK = "the image is blank"  # with less
MIN_OVERLAP, FIRM_OVERLAP = 0.15, 0.25  # fraction of the frame's depth where the model has depth
MIN_AGREEMENT, FIRM_AGREEMENT = 0.45, 0.6  # fraction of that on its surface
MIN_EIGENVALUE = 0.005  # as of OdometryResult: small images of rooms 0.007 and more | flat walls up to 0.004
MAX_SHIFT, MAX_ROTATION = 0.35, np.deg2rad(30.0)  # [m], [rad] jump from the expected pose
MAX_DEVIATION = 0.035  # [m] position deviation: 0.04 and more in a white office 10 cm off | textured rooms up to 0.011
MAX_OF_TRUNCATION = 0.44  # larger limit for coarser models
SURE_OVERLAP, SURE_AGREEMENT = 0.5, 0.75  # from a keyframe
RIM_OVERLAP = 0.3  # at the extrapolated pose: a camera that was covered sees the model border
SHAPE_OVERLAP = 0.08  # if registration accepts the pose, and two frames agree
# Doors that differ by 9% white: 15 times the typical residual; correct poses up to 1.9 times, at untextured model
# borders, by a gray value.
MAX_SHADES, MIN_SHADES = 2.0, 0.01  # factor of the typical brightness residual, and minimum difference
MAX_GAP, MIN_GAP = 2.5, 0.005  # factor of the typical surface distance, and minimum difference [m]
FOLLOWED_GAP = 0.015  # [m] likewise for a tracked frame: the view may move from near to far objects
MAX_OUTLIER_RATIO, MIN_OUTLIER_EXCESS = 2.0, 0.05  # factor of the fraction off the surface, and minimum difference


@dataclasses.dataclass(frozen=True, eq=False)
class Attempt:
    """An alignment: `pose` T_world_camera, OdometryResult, status with warnings, covariances as of `TrackingResult`."""

    pose: NDArray[np.float64]
    result: OdometryResult
    status: Status
    warnings: tuple[str, ...] = ()
    covariance: NDArray[np.float64] = dataclasses.field(default_factory=lambda: np.zeros((6, 6)))
    error_covariance: NDArray[np.float64] = dataclasses.field(default_factory=lambda: np.zeros((6, 6)))

    @property
    def score(self) -> float:
        """Rank of attempts: the fraction of the frame on the model, lost ones last."""
        rank = {"tracked": 2.0, "uncertain": 1.0, "lost": 0.0}[self.status]
        return rank + self.result.fitness

    @property
    def measures(self) -> dict[str, float]:
        names = ("fitness", "overlap", "inlier_rmse", "intensity_rmse", "smallest_eigenvalue", "iterations")
        return {name: getattr(self.result, name) for name in names}

    def with_warning(self, warning: str) -> Attempt:
        """The attempt with a warning: uncertain at best."""
        if not warning:
            return self
        status: Status = "lost" if self.status == "lost" else "uncertain"
        return dataclasses.replace(self, status=status, warnings=(warning, *self.warnings))


def agreement_of(result: OdometryResult) -> float:
    """Fraction of the common visible area that matches the model surface."""
    return result.fitness / result.overlap if result.overlap > 0 else 0.0


def is_determined(result: OdometryResult) -> bool:
    """True if the frame determines its motion. A frame that may slide gives no velocity."""
    return result.smallest_eigenvalue >= MIN_EIGENVALUE


def judge_tracking(
    result: OdometryResult, moved: NDArray[np.float64], usual_gap: float = math.nan
) -> tuple[Status, str]:
    """Status of a tracked frame by its deviation `moved` and the run's typical surface distance [m]."""
    agreement = agreement_of(result)
    shift = float(norm(moved[:3, 3]))
    angle = float(norm(rotation_vector(moved[:3, :3])))
    if not np.isfinite(moved).all() or shift > MAX_SHIFT or angle > MAX_ROTATION:
        return "lost", f"its pose jumps by {shift:.2f} m, {np.rad2deg(angle):.0f} degrees"
    if result.overlap < MIN_OVERLAP:
        return "lost", f"{result.overlap:.0%} of its depth overlaps with the model"
    if agreement < MIN_AGREEMENT:
        return "lost", f"{agreement:.0%} of the overlapping depth agrees with the model"
    if result.contradiction:
        return "lost", result.contradiction
    if result.inlier_rmse > MAX_GAP * usual_gap and result.inlier_rmse - usual_gap > FOLLOWED_GAP:
        return (
            "lost",
            f"its distance from the model is {result.inlier_rmse / max(usual_gap, 1e-6):.1f} times the usual one",
        )
    if not is_determined(result):
        return "uncertain", "the visible surfaces do not determine its pose"
    if result.overlap < FIRM_OVERLAP:
        return "uncertain", f"{result.overlap:.0%} of its depth overlaps with the model"
    if agreement < FIRM_AGREEMENT:
        return "uncertain", f"{agreement:.0%} of the overlapping depth agrees with the model"
    return "tracked", ""


def judge_recognition(
    result: OdometryResult, min_overlap: float, usual: float = math.nan, usual_gap: float = math.nan
) -> tuple[Status, str]:
    """Found or lost, compared with the run's typical brightness (`usual`) and distance [m] residuals."""
    if not result.reliable and UNDETERMINED not in result.warnings:  # whose limit is for full-size frames
        return "lost", result.warnings[0]
    if not is_determined(result):
        return "lost", UNDETERMINED
    if agreement_of(result) < SURE_AGREEMENT or result.overlap < min_overlap:
        return "lost", f"{result.fitness:.0%} of its depth agrees with the model"
    if is_off_shade(result.intensity_rmse, usual):
        return "lost", f"its brightness residual is {result.intensity_rmse / max(usual, 1e-4):.1f} times the usual one"
    if result.inlier_rmse > MAX_GAP * usual_gap and result.inlier_rmse - usual_gap > MIN_GAP:
        return (
            "lost",
            f"its distance from the model is {result.inlier_rmse / max(usual_gap, 1e-6):.1f} times the usual one",
        )
    return "tracked", ""


def is_off_shade(shades: float, usual: float) -> bool:
    """True if a brightness residual clearly exceeds the typical one. False without color (NaN)."""
    return shades > MAX_SHADES * usual and shades - usual > MIN_SHADES


def fits_worse(result: OdometryResult, other: OdometryResult) -> bool:
    """True if a pose explains a frame clearly worse than another one, regardless of the overlap."""
    if not result.reliable and result.overlap >= RIM_OVERLAP and UNDETERMINED not in result.warnings:
        return True
    outlier_fraction, other_outlier_fraction = 1.0 - agreement_of(result), 1.0 - agreement_of(other)
    if outlier_fraction > MAX_OUTLIER_RATIO * other_outlier_fraction + MIN_OUTLIER_EXCESS:
        return True
    return is_off_shade(result.intensity_rmse, other.intensity_rmse)


def judge_drift(result: TrackingResult, truncation: float) -> TrackingResult:
    """The result, uncertain if its accumulated deviation is too large for the truncation [m]."""
    off = result.position_deviation
    if not result.is_tracked or off <= max(MAX_DEVIATION, MAX_OF_TRUNCATION * truncation):
        return result
    warning = f"the uncertainty accumulated along the path is {off:.2f} m"
    return dataclasses.replace(result, status="uncertain", warnings=(warning,), has_drifted=True)


def fits_model(result: OdometryResult) -> bool:
    return result.overlap >= SHAPE_OVERLAP and agreement_of(result) >= SURE_AGREEMENT


def depth_fraction(frame: OdometryFrame) -> float:
    """Fraction of pixels with depth, in the coarsest level (sync)."""
    return float((frame.coarsest()[0] > 0).mean())
