"""Whether a frame lies on the model where its alignment ended.

In tracking the start is near, so that a wrong pose is one that slid or that left the model: what counts is how much of
what both see agrees, whether the frame fixes its motion, and how far it jumped. People who walk about stand in front of
the model and take part of the picture; the pixels that do lie on its surface agree in normals, distances and brightness
at a right pose, whoever hides the others, and contradict a wrong one. From a keyframe the start says little, and the
pair has to pass the checks of odometry (rgbd/odometry/verdicts.py), with stricter limits.
"""

from __future__ import annotations

import dataclasses
import math

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import norm
from ...registration.rigid import rotation_vector
from ..odometry.frames import OdometryFrame
from ..odometry.results import OdometryResult
from ..odometry.verdicts import UNDETERMINED
from .results import TrackingResult, Verdict

LEAST_DEPTH = 0.02  # share of the pixels with depth below which a picture is blank
LEAST_OVERLAP, FIRM_OVERLAP = 0.15, 0.25  # share of the frame's depth that meets the model's
LEAST_AGREEMENT, FIRM_AGREEMENT = 0.45, 0.6  # share of that which lies on its surface
LEAST_EIGENVALUE = 0.005  # as of OdometryResult: rooms in tiny pictures 0.007 and more | flat walls up to 0.004
MOST_SHIFT, MOST_TURN = 0.35, np.deg2rad(30.0)  # [m], from where the camera was expected: a jump
MOST_DEVIATION = 0.035  # [m] of a position: 0.04 and more in a white office once 10 cm off | textured rooms up to 0.011
MOST_OF_TRUNCATION = 0.44  # where that is more: coarser models hold less
SURE_OVERLAP, SURE_AGREEMENT = 0.5, 0.75  # from a keyframe: enough to be accepted
RIM_OVERLAP = 0.3  # where motion led: a camera that went on while it was covered sees the model's rim
SHAPE_OVERLAP = 0.08  # where registration accepts the place already, and two frames agree on it
# Doors that look alike but for 9 % of white: 15 times the usual | right poses up to 1.9 times, at the rim of a model
# without texture, by a grey value.
MOST_SHADES, LEAST_SHADES = 2.0, 0.01  # times the brightness is off beside the usual, and by how much at least
MOST_GAP, LEAST_GAP = 2.5, 0.005  # times the surface is off beside the usual, and by how much at least [m]
FOLLOWED_GAP = 0.015  # [m] by how much a frame that is followed: the view may turn from near things to far ones
MOST_MISFIT, LEAST_MISFIT = 2.0, 0.05  # times what does not lie on the surface, and how much more at least


@dataclasses.dataclass(frozen=True, eq=False)
class Attempt:
    """A frame aligned with something, and what comes of it.

    Attributes:
        pose: T_world_camera.
        result: The OdometryResult.
        verdict, reason: Of the frame there.
        covariance: Of the pose, with all that was open on the way to it; see `TrackingResult`.
    """

    pose: NDArray[np.float64]
    result: OdometryResult
    verdict: Verdict
    reason: str = ""
    covariance: NDArray[np.float64] = dataclasses.field(default_factory=lambda: np.zeros((6, 6)))

    @property
    def score(self) -> float:
        """What tells the better of two attempts: the share of the frame that lies on the model, lost ones last."""
        rank = {"tracked": 2.0, "uncertain": 1.0, "lost": 0.0}[self.verdict]
        return rank + self.result.fitness

    @property
    def measures(self) -> dict[str, float]:
        """The numbers of the alignment, as a TrackingResult names them."""
        names = ("fitness", "overlap", "inlier_rmse", "intensity_rmse", "smallest_eigenvalue", "iterations")
        return {name: getattr(self.result, name) for name in names}

    def doubted(self, reason: str) -> Attempt:
        """The same where something speaks against it, whatever fits: no more than uncertain."""
        if not reason:
            return self
        verdict: Verdict = "lost" if self.verdict == "lost" else "uncertain"
        return dataclasses.replace(self, verdict=verdict, reason="; ".join(filter(None, (reason, self.reason))))


def agreement_of(result: OdometryResult) -> float:
    """The share of what both see that lies on the model's surface."""
    return result.fitness / result.overlap if result.overlap > 0 else 0.0


def is_determined(result: OdometryResult) -> bool:
    """Whether what a frame shows fixes its motion; else it may slide, and where it slid tells no velocity."""
    return result.smallest_eigenvalue >= LEAST_EIGENVALUE


def judge_tracking(
    result: OdometryResult, moved: NDArray[np.float64], usual_gap: float = math.nan
) -> tuple[Verdict, str]:
    """Status of a frame that was aligned from where it was expected; `moved` is how far off that was, `usual_gap`
    how far the run's frames are off the model's surface [m]."""
    agreement = agreement_of(result)
    shift = float(norm(moved[:3, 3]))
    turn = float(norm(rotation_vector(moved[:3, :3])))
    if not np.isfinite(moved).all() or shift > MOST_SHIFT or turn > MOST_TURN:
        return "lost", f"it jumps by {shift:.2f} m, {np.rad2deg(turn):.0f} degrees"
    if result.overlap < LEAST_OVERLAP:
        return "lost", f"{result.overlap:.0%} of its depth meet the model"
    if agreement < LEAST_AGREEMENT:
        return "lost", f"{agreement:.0%} of what meets the model lie on its surface"
    if result.contradiction:
        return "lost", result.contradiction
    if result.inlier_rmse > MOST_GAP * usual_gap and result.inlier_rmse - usual_gap > FOLLOWED_GAP:
        return "lost", f"it lies {result.inlier_rmse / max(usual_gap, 1e-6):.1f} times as far off the model as usual"
    if not is_determined(result):
        return "uncertain", "what it shows does not fix where it was taken"
    if result.overlap < FIRM_OVERLAP:
        return "uncertain", f"{result.overlap:.0%} of its depth meet the model"
    if agreement < FIRM_AGREEMENT:
        return "uncertain", f"{agreement:.0%} of what meets the model lie on its surface"
    return "tracked", ""


def judge_recognition(
    result: OdometryResult, least_overlap: float, usual: float = math.nan, usual_gap: float = math.nan
) -> tuple[Verdict, str]:
    """Status of a frame that was aligned from a place it may be at: it is found, or it stays lost; `usual` and
    `usual_gap` [m] are how far the run's frames are off the model in brightness and in distance."""
    if not result.reliable and UNDETERMINED not in result.warnings:  # whose limit is for frames of full size
        return "lost", result.warnings[0]
    if not is_determined(result):
        return "lost", UNDETERMINED
    if agreement_of(result) < SURE_AGREEMENT or result.overlap < least_overlap:
        return "lost", f"{result.fitness:.0%} of its depth lie on the model"
    if is_off_shade(result.intensity_rmse, usual):
        return "lost", f"its brightness is {result.intensity_rmse / max(usual, 1e-4):.1f} times as far off as usual"
    if result.inlier_rmse > MOST_GAP * usual_gap and result.inlier_rmse - usual_gap > LEAST_GAP:
        return "lost", f"it lies {result.inlier_rmse / max(usual_gap, 1e-6):.1f} times as far off the model as usual"
    return "tracked", ""


def is_off_shade(shades: float, usual: float) -> bool:
    """Whether a difference in brightness is more than another one explains; never where there is no colour."""
    return shades > MOST_SHADES * usual and shades - usual > LEAST_SHADES


def speaks_against(result: OdometryResult, other: OdometryResult) -> bool:
    """Whether a pose explains a frame plainly worse than another one does, by what each meets, however much that is."""
    if not result.reliable and result.overlap >= RIM_OVERLAP and UNDETERMINED not in result.warnings:
        return True
    misfit, other_misfit = 1.0 - agreement_of(result), 1.0 - agreement_of(other)
    if misfit > MOST_MISFIT * other_misfit + LEAST_MISFIT:
        return True
    return is_off_shade(result.intensity_rmse, other.intensity_rmse)


def judge_drift(result: TrackingResult, truncation: float) -> TrackingResult:
    """The result, uncertain where it would be tracked and its position is too open by what adds up on the way, beside
    the truncation [m] of the model."""
    off = result.position_deviation
    if not result.is_tracked or off <= max(MOST_DEVIATION, MOST_OF_TRUNCATION * truncation):
        return result
    reason = f"what was open on the way adds up to {off:.2f} m"
    return dataclasses.replace(result, verdict="uncertain", reason=reason, has_drifted=True)


def lies_on_model(result: OdometryResult) -> bool:
    """Whether a frame whose place is proposed lies on what little of the model it sees."""
    return result.overlap >= SHAPE_OVERLAP and agreement_of(result) >= SURE_AGREEMENT


def depth_share(frame: OdometryFrame) -> float:
    """The share of a frame's pixels that have depth, in its coarsest level (sync)."""
    return float((frame.coarsest()[0] > 0).mean())
