"""Reliability of a motion between two frames."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import eigh, eigvalsh, matmul
from ...kernels.rgbd import check_rows as at
from ...kernels.rgbd.alignment import Alignment
from ...registration.rigid import symmetric_matrices
from .frames import OdometryFrame
from .results import OdometryResult, spread_information

MOMENT_COLUMNS = slice(at.POINT_MOMENTS, at.POINT_MOMENTS + 9)

UNDETERMINED = "the frames do not determine the motion"  # does not contradict the pose

# Measured over 400 pairs of a kitchen and 1,000 of different scenes (benchmarks/rgbd_odometry_accuracy.py): right |
# wrong.
MIN_OVERLAP = 0.25  # overlap: less is inconclusive
MIN_INLIERS = 0.6  # fraction on the surface: 0.69 and more | half of them below 0.35
MAX_IN_FRONT = 0.1  # fraction in front of the surface: up to 0.04 | half of them above 0.28
MIN_AGREEMENT = 0.87  # normal agreement: 0.93 and more | half below 0.3, one otherwise accepted has 0.79
MAX_EXCESS = 5.5  # squared distance in noise variances, at most 16 per pixel: up to 4.8 | all but 2% above
MIN_CORRELATION = 0.3  # brightness correlation: 0.65 and more | nearly all below 0.57
MIN_EIGENVALUE = 0.015  # 0.07 and more | untextured walls 0.004 and less
MIN_INLIER_COUNT = 12  # inliers
UNTEXTURED_EIGENVALUE = 0.004  # eigenvalue of untextured walls due to noise and rounded edges
MIN_INFORMATION = 1e-4  # of it, for a finite covariance: a meter and more
MIN_EXCESS = 0.1  # of the measured noise: means of many pixels are less exact than their number suggests
MAX_OPEN = 0.06  # [m] deviation along undetermined motions
WINDOW_PIXELS = 25.0  # pixels per plane window, with common errors
# Number of pixels of two frames with a common error: FRAME_NOISE for noise, more with larger residuals, which are due
# to errors of parts of the image. Chosen on synthetic frames with squared residuals of 0.03 variances, and on poses of
# halves of real frames (0.35), which differ more with brightness (benchmarks/trust/calibration.py --fitted).
FRAME_NOISE, SURFACE_ERROR, BRIGHTNESS_ERROR = 4.0, 130.0, 270.0
LEAST_EXCESS = 1e-6  # of identical frames
MIN_SHADED_FRACTION = 0.3  # minimum fraction of inliers with brightness
COST_DISPLACEMENT = 0.01  # [m] displacement whose cost the eigenvalue measures, in noise variances


def judge(alignment: Alignment, source: OdometryFrame, blur: float = 0.0) -> OdometryResult:
    """The result of an alignment, without its covariances."""
    v = alignment.consistency
    pixels, seen, inliers = v[at.PIXEL_COUNT], v[at.SEEN_COUNT], v[at.INLIER_COUNT]
    reason = _first_fault(alignment, pixels, seen, inliers, blur)
    smallest = smallest_eigenvalue(alignment.certainty, v)
    if not reason and smallest < MIN_EIGENVALUE:
        reason = UNDETERMINED
    scale = source.width * source.height / float(source.levels.counts[alignment.level])
    shades = v[at.SHADE_COUNT]
    return OdometryResult(
        transformation=alignment.pose,
        information=np.zeros((6, 6)) if reason else spread_information(inliers, v[MOMENT_COLUMNS]) * scale,
        warnings=(reason,) if reason else (),
        inliers=int(inliers),
        fitness=float(inliers / pixels) if pixels else 0.0,
        overlap=float(seen / pixels) if pixels else 0.0,
        inlier_rmse=float(np.sqrt(v[at.DISTANCE_SQUARES] / v[at.PLANE_COUNT])) if v[at.PLANE_COUNT] else 0.0,
        intensity_rmse=float(np.sqrt(v[at.SHADE_SQUARES] / shades)) if shades else float("nan"),
        smallest_eigenvalue=smallest,
        iterations=alignment.steps,
        contradiction=_contradiction(v, blur),
    )


def with_covariances(result: OdometryResult, alignment: Alignment, uses_brightness: bool) -> OdometryResult:
    v = alignment.consistency
    covariance, check_covariance = covariances_of(alignment.firm, v, (frame_noise(v, uses_brightness), model_noise(v)))
    unit, bias = unit_covariance(v), bias_of(v)
    return dataclasses.replace(
        result, covariance=covariance, check_covariance=check_covariance, unit_covariance=unit, bias=bias
    )


def _first_fault(alignment: Alignment, pixels: float, seen: float, inliers: float, blur: float = 0.0) -> str:
    v = alignment.consistency
    if not np.isfinite(alignment.pose).all():
        return "the alignment diverged: its pose is not finite"
    if pixels == 0:
        return "the source has no depth"
    if seen / pixels < MIN_OVERLAP:
        return f"only {100 * seen / pixels:.0f}% of the source pixels overlap with depth of the target"
    if inliers / seen < MIN_INLIERS:
        return f"only {100 * inliers / seen:.0f}% of the overlapping pixels agree with the target's surface"
    if (in_front := v[at.IN_FRONT_COUNT] / seen) > MAX_IN_FRONT:
        return f"{100 * in_front:.0f}% of the source pixels are in space that the target observed as free"
    return _contradiction(v, blur)


def _contradiction(v: NDArray[np.float64], blur: float) -> str:
    """Contradiction of the inlier pixels with the pose, independent of occlusion."""
    inliers = v[at.INLIER_COUNT]
    if v[at.NORMAL_COUNT] and v[at.AGREEING_COUNT] / v[at.NORMAL_COUNT] < MIN_AGREEMENT:
        return f"only {100 * v[at.AGREEING_COUNT] / v[at.NORMAL_COUNT]:.0f}% of the normals agree"
    if (excess := _excess(v, blur)) > MAX_EXCESS:
        return f"the surface residual is {np.sqrt(excess):.1f} times the depth noise"
    if v[at.SHADE_COUNT] > MIN_SHADED_FRACTION * inliers and correlation(v) < MIN_CORRELATION:
        return f"the brightness does not agree (correlation {correlation(v):.2f})"
    return ""


def _excess(v: NDArray[np.float64], blur: float) -> float:
    """Mean squared surface distance in variances of noise and blur [m]."""
    if not v[at.PLANE_COUNT]:
        return 0.0
    excess = float(v[at.EXCESS_SUM] / v[at.PLANE_COUNT])
    if not blur or not v[at.DISTANCE_SQUARES]:
        return excess
    noise = v[at.DISTANCE_SQUARES] / v[at.EXCESS_SUM]  # [m^2] unit of the normalized squares
    return excess / (1.0 + blur * blur / float(noise))


def bias_of(v: NDArray[np.float64]) -> float:
    """Root mean square surface distance [m] beyond the largest residuals that noise alone explains."""
    excess = _excess(v, 0.0)
    if excess <= MIN_EXCESS:
        return 0.0
    return float(np.sqrt(v[at.DISTANCE_SQUARES] / v[at.PLANE_COUNT] * (1.0 - MIN_EXCESS / excess)))


def correlation(v: NDArray[np.float64]) -> float:
    """Brightness correlation of matched pixels. 1 without contrast."""
    n, s, t, ss, tt, st = v[at.SHADE_COUNT : at.SHADE_COUNT + 6]
    variances = (ss / n - (s / n) ** 2) * (tt / n - (t / n) ** 2)
    return float((st / n - s * t / n / n) / np.sqrt(variances)) if variances > 1e-8 else 1.0


def smallest_eigenvalue(sums: NDArray[np.float64], v: NDArray[np.float64]) -> float:
    """Relative smallest eigenvalue of the normal equations about the center, rotations in units of the spread."""
    if v[at.INLIER_COUNT] < MIN_INLIER_COUNT:
        return 0.0
    b = _about_middle(v)
    values = eigvalsh(matmul(b.T, symmetric_matrices(sums[None, :21])[0], b)) / v[at.INLIER_COUNT]
    return float(values[0] * COST_DISPLACEMENT * COST_DISPLACEMENT)


def frame_noise(v: NDArray[np.float64], uses_brightness: bool) -> float:
    """Variance of the residuals of two frames, in noise variances, times the number of pixels with a common error."""
    excess = max(float(v[at.EXCESS_SUM] / v[at.PLANE_COUNT]), LEAST_EXCESS) if v[at.PLANE_COUNT] else 0.0
    return excess * (FRAME_NOISE + (BRIGHTNESS_ERROR if uses_brightness else SURFACE_ERROR) * excess)


def model_noise(v: NDArray[np.float64]) -> float:
    """As `frame_noise`, of a frame and a model. A model has errors that the residuals do not contain."""
    return WINDOW_PIXELS * max(v[at.EXCESS_SUM] / v[at.PLANE_COUNT], MIN_EXCESS) if v[at.PLANE_COUNT] else 0.0


def covariance_of(firm: NDArray[np.float64], v: NDArray[np.float64], noise: float) -> NDArray[np.float64]:
    """Covariance of the motion about the target's camera, rotation first; infinite with too few pixels."""
    return covariances_of(firm, v, (noise,))[0]


def covariances_of(
    firm: NDArray[np.float64], v: NDArray[np.float64], noises: Sequence[float]
) -> list[NDArray[np.float64]]:
    """As `covariance_of` for several noises."""
    n = v[at.INLIER_COUNT]
    if n < MIN_INLIER_COUNT or not v[at.PLANE_COUNT]:
        return [np.full((6, 6), np.inf) for _ in noises]
    b = _about_middle(v)
    values, vectors = eigh(matmul(b.T, symmetric_matrices(firm[None, :21])[0], b))
    unit = n / COST_DISPLACEMENT**2
    information = np.maximum(values - UNTEXTURED_EIGENVALUE * unit, MIN_INFORMATION * unit)
    spread = matmul(b, vectors)
    return [matmul(spread * np.minimum(noise / information, MAX_OPEN**2), spread.T) for noise in noises]


def unit_covariance(v: NDArray[np.float64]) -> NDArray[np.float64]:
    """Covariance of the motion by an error of 1 m along each motion about the inlier center."""
    if v[at.INLIER_COUNT] < MIN_INLIER_COUNT:
        return np.full((6, 6), np.inf)
    b = _about_middle(v)
    return matmul(b, b.T)


def _about_middle(v: NDArray[np.float64]) -> NDArray[np.float64]:
    """Transform from motions about the inlier center (rotations in units of their spread) to the camera."""
    n = v[at.INLIER_COUNT]
    m = v[MOMENT_COLUMNS]
    c = m[:3] / n
    spread = np.sqrt(max((m[3] + m[6] + m[8]) / n - matmul(c, c), 1e-12))
    b = np.eye(6)
    b[3:, :3] = [[0, -c[2], c[1]], [c[2], 0, -c[0]], [-c[1], c[0], 0]]
    b[:, :3] /= spread
    return b
