"""Acceptance of the camera that fits the rotated frames of a path: `assess_camera`."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...core.reports import Assessed, failed, quality
from ...kernels.linear_algebra import matmul
from ...kernels.rgbd.stream_views import StreamView, view_stream
from ..odometry.camera_fit import MIN_DEPTH_FACTOR, CameraFit, CameraView, ViewPairs, fit_camera, rotated_pairs
from ..odometry.posed_camera import POSED_SIGMAS, PosedCameraFit
from .fixed_parts import cell_lens
from .frames import SensorFrame

# Largest accepted log focal length, principal point (u, v, in focal lengths) and radial distortion, besides MAX_SIGMAS
# deviations of each. Windows of the kitchen, whose sensor is not calibrated, have up to 0.04 (deviation 0.02), 0.11
# (0.03) and 0.11. Chosen on the kitchen and two synthetic rooms, verified on synthetic sites of seeds 40 and 41
# (2026-11-29), and with other deviations on sites of seed 502: 0 of 21 windows with the right camera are reported
# (2026-11-30).
MAX_CORRECTIONS, MAX_SIGMAS = np.array([0.055, 0.28, 0.28, 0.2]), 1.5
# Corrections with given poses are reported beyond their limits (posed_camera.py), if they reduce the residual by
# MIN_FALL, which errors of the poses hardly do. Radial distortion is also larger than that of usual lenses.
# Deviations above MAX_POSED_DEVIATION determine nothing, unless the residual falls by MIN_RESIDUAL_RATIO: windows of
# less than a second of the kitchen have deviations of 0.05 and more, and ratios up to 1.9. Chosen on all its frames:
# of 380 random windows at the right camera, 1 of 300 of 4 to 20 frames and 2 of 80 of 30 to 139 frames are reported.
# Held out: of walks on sites of seeds 302 and 303, none of the correct ones is reported (2026-11-30).
MIN_FALL = 1.1
MAX_POSED_DEVIATION, MIN_RESIDUAL_RATIO = 0.05, 2.5
MIN_POSED_CORRECTIONS = np.array([0.0, 0.0, 0.0, 0.0, 0.2, 0.0])
# Displacement of the surface [m], the root mean square, by an error that is not reported: a value with larger ones is
# not determined. A surface is wrong beyond 3 cm in the measurements of docs/trust.md.
MAX_UNDETECTED = 0.03


@dataclasses.dataclass(frozen=True)
class FocalCheck(Assessed):
    """Camera that fits pairs of frames: rotated against each other, or with given poses.

    Attributes:
        pairs: Number of aligned pairs.
        residual: Weighted root mean square residual with the given camera [m].
        factor: Best factor of the focal length. 1 if none is clearly better.
        residual_there: Residual of the best camera [m].
        center: Displacement of the principal point [px]. 0 if none is clearly better.
        distortion: Radial distortion of the rays (factor of squared distance from the center, in focal lengths). 0 if
            none is clearly better.
        aspect: Best factor of fx / fy. 1 if none is clearly better, or without given poses.
        factor_deviation: Standard deviation of `factor`.
        center_deviation: Standard deviations of `center` [px]. 0 if unknown.

    Example:
        >>> import pointloom as loom
        >>> print(loom.rgbd.FocalCheck(pairs=8, residual=0.004, factor=1.0, residual_there=0.004))
        8 pairs of frames have a residual of 4.0 mm, and no other focal length fits better
        >>> loom.rgbd.FocalCheck(pairs=8, residual=0.012, factor=1.25, residual_there=0.004).reliable
        False
    """

    pairs: int
    residual: float
    factor: float
    residual_there: float
    center: tuple[float, float] = (0.0, 0.0)
    distortion: float = 0.0
    aspect: float = 1.0
    factor_deviation: float = 0.0
    center_deviation: tuple[float, float] = (0.0, 0.0)

    def __str__(self) -> str:
        summary = f"{self.pairs} pairs of frames have a residual of {self.residual * 1000:.1f} mm"
        return "; ".join(self.warnings) or f"{summary}, and no other focal length fits better"

    @property
    def warnings(self) -> tuple[str, ...]:
        better = []
        sigma = f" (sigma {self.factor_deviation:.2g})" if self.factor_deviation else ""
        if self.aspect != 1.0:
            fx, fy = self.factor * math.sqrt(self.aspect), self.factor / math.sqrt(self.aspect)
            better.append(f"fx about {fx:.3g} times and fy about {fy:.3g} times as long{sigma}")
        elif self.factor != 1.0:
            better.append(f"a focal length about {self.factor:.3g} times as long{sigma}")
        if any(self.center):
            sigma = " (sigma {:.0f}, {:.0f})".format(*self.center_deviation) if any(self.center_deviation) else ""
            better.append(f"a principal point moved by {self.center[0]:.0f}, {self.center[1]:.0f} px{sigma}")
        if self.distortion:
            better.append(f"a radial distortion of {self.distortion:.2f}; undistort the images")
        if not better:
            return ()
        return (
            f"the camera may be wrong: the frames fit better with {', and '.join(better)} "
            f"({self.residual_there * 1000:.1f} mm apart, not {self.residual * 1000:.1f}); correct intrinsic",
        )

    def to_dict(self) -> dict[str, Any]:
        residuals = {"residual_m": self.residual, "factor": self.factor, "residual_there_m": self.residual_there}
        other = {"center_px": list(self.center), "distortion": self.distortion, "aspect": self.aspect}
        other |= {"factor_deviation": self.factor_deviation, "center_deviation_px": list(self.center_deviation)}
        return {"pairs": self.pairs, **residuals, **other, **quality(self)}


def view_of(frame: SensorFrame, view: StreamView | None = None) -> CameraView:
    """The cells of a frame."""
    cells = view or view_stream(frame.depth, frame.pixels, frame.intrinsic.width, frame.intrinsic.height)
    return CameraView(cells.host_nearness, cell_lens(frame, cells))


def assess_camera(
    views: Sequence[CameraView], poses: Sequence[NDArray[np.float64]], intrinsic: PinholeCameraIntrinsic
) -> FocalCheck | None:
    """Assess a camera by views with poses T_world_camera. None if they do not determine it."""
    return judged(fit_camera(ViewPairs(views, poses, rotated_pairs(poses))), intrinsic)


def judged(fit: CameraFit | None, intrinsic: PinholeCameraIntrinsic) -> FocalCheck | None:
    if fit is None or not np.isfinite(fit.deviations[0]):
        return None
    is_off = np.abs(fit.values[:4]) > MAX_CORRECTIONS + MAX_SIGMAS * fit.deviations[:4]
    log_focal, u, v, distortion = np.where(is_off, fit.values[:4], 0.0).tolist()
    sizes = intrinsic.fx, intrinsic.fy
    deviations = np.where(np.isfinite(fit.deviations), fit.deviations, 0.0).tolist()
    return FocalCheck(
        len(fit.pairs),
        fit.residual,
        math.exp(log_focal),
        fit.fitted_residual if is_off.any() else fit.residual,
        (u * sizes[0], v * sizes[1]),
        distortion,
        factor_deviation=math.exp(log_focal) * deviations[0],
        center_deviation=(deviations[1] * sizes[0], deviations[2] * sizes[1]),
    )


def judge_posed_camera(
    fits: Sequence[PosedCameraFit], intrinsic: PinholeCameraIntrinsic, factor: float = 1.0
) -> tuple[FocalCheck | None, float, float]:
    """The camera, the factor of the depth (1 without a better one) and its deviation.

    The first of the fits is that of all values, the others are those of single errors. The camera is None if the frames
    do not determine its focal lengths. `factor` is that of `depth_factor`, by which the depth of the views was scaled.
    """
    if not fits:
        return None, factor, 0.0
    complete = _judged_fit(fits[0], intrinsic, factor)
    if factor != 1.0:
        return complete
    verdicts = [(fit.fitted_residual, _judged_fit(fit, intrinsic)) for fit in fits[1:]]
    reported = [each for each in verdicts if _is_reported(each[1])]
    if not reported:
        return complete
    residual, single = min(reported, key=lambda each: each[0])
    is_enough = not _is_reported(complete) or residual < MIN_FALL * fits[0].fitted_residual
    return single if is_enough else complete


def undetermined_values(fits: Sequence[PosedCameraFit], intrinsic: PinholeCameraIntrinsic) -> str | None:
    """Values that the frames do not determine, as a remark: errors of them may not be reported. None if there are none.

    The first of the fits is that of all values, the others are those of single errors.
    """
    if not fits:
        return "the camera and the depth unit are not checked: too few sampled frames overlap at the given poses"
    limits = np.ones(6)  # 100 % and more: nothing is known
    for fit in fits[1:]:
        limits = np.where(fit.deviations > 0, np.minimum(limits, POSED_SIGMAS * fit.deviations), limits)
    focal, _, u, v, _, depth = (limits * (limits * fits[0].displacements > MAX_UNDETECTED)).tolist()
    values = [
        f"the focal length up to {100 * focal:.1f}%" if focal else None,
        f"the principal point up to {max(u * intrinsic.fx, v * intrinsic.fy):.0f} px" if u or v else None,
        f"the depth unit up to {100 * depth:.1f}%" if depth else None,
    ]
    known = ", ".join(failed(*values))
    return f"not determined by the frames and poses, so errors may not be reported: {known}" if known else None


def _is_reported(found: tuple[FocalCheck | None, float, float]) -> bool:
    camera, factor, _ = found
    return factor != 1.0 or (camera is not None and not camera.reliable)


def _judged_fit(
    fit: PosedCameraFit, intrinsic: PinholeCameraIntrinsic, factor: float = 1.0
) -> tuple[FocalCheck | None, float, float]:
    values, deviations = fit.values.copy(), fit.deviations
    values[5] += math.log(factor)
    is_off = np.abs(values) > np.maximum(fit.limits(), MIN_POSED_CORRECTIONS + POSED_SIGMAS * deviations)
    is_known = (deviations < MAX_POSED_DEVIATION) | (fit.residual > MIN_RESIDUAL_RATIO * fit.fitted_residual)
    is_off &= is_known & (fit.residual > MIN_FALL * fit.fitted_residual)
    is_off[5] |= factor != 1.0 and abs(values[5]) > math.log(MIN_DEPTH_FACTOR)
    mean, difference = (np.array([a, b, 0.0, 0.0, 0.0, 0.0]) for a, b in ((0.5, 0.5), (1.0, -1.0)))
    mean_deviation, difference_deviation = (
        math.sqrt(float(matmul(row, fit.covariance, row))) for row in (mean, difference)
    )
    log_focal, log_aspect = float(matmul(mean, values)), float(matmul(difference, values))
    is_focal = bool(is_off[:2].any())
    is_aspect = is_focal and abs(log_aspect) > POSED_SIGMAS * difference_deviation
    u, v, distortion, depth = np.where(is_off, values, 0.0)[2:].tolist()
    camera = FocalCheck(
        fit.pair_count,
        fit.residual,
        math.exp(log_focal) if is_focal else 1.0,
        fit.fitted_residual if is_off.any() else fit.residual,
        (u * intrinsic.fx, v * intrinsic.fy),
        distortion,
        math.exp(log_aspect) if is_aspect else 1.0,
        math.exp(log_focal) * mean_deviation,
        (float(deviations[2]) * intrinsic.fx, float(deviations[3]) * intrinsic.fy),
    )
    return (
        camera if is_known[:2].any() or not camera.reliable else None,
        math.exp(depth),
        math.exp(depth) * float(deviations[5]),
    )
