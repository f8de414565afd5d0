"""Alignment of network depth by RANSAC: 1 / z = scale * d + shift.

Fitted in inverse depth as in the training of relative networks (Ranftl et al. 2020, section 5), with relative residuals
|scale d + shift - y| / y, y = 1 / z, truncated at `MAX_RELATIVE_RESIDUAL` (MSAC, Torr and Zisserman 2000), then
refitted to the inliers with weights 1 / y^2. On the host. Hypotheses are scored on a subset of the references.
"""

from __future__ import annotations

import dataclasses

import numpy as np
from numpy.typing import NDArray

from ...core.errors import PointloomError

Numbers = NDArray[np.float64]

MAX_RELATIVE_RESIDUAL = 0.1  # relative: above a good network's error, far below that of wrong matches
HYPOTHESIS_COUNT = 512  # with 60% outliers, one pair in six is correct: failure probability 1e-40
MAX_SCORED_REFERENCES = 4096  # references used for scoring: inlier fraction to 0.8%
MIN_INLIERS = 20
REFIT_COUNT = 10
MAX_DISTANCES = 50  # all 1225 pairs are tried; above this, random ones
MIN_RELATIVE_DIFFERENCE = 1e-6  # minimum difference in d, relative to the range of d


class AlignmentError(PointloomError, ValueError):
    """No scale and shift agrees with the references."""


@dataclasses.dataclass(frozen=True)
class Alignment:
    """1 / z = scale * d + shift, with the inlier fraction (None if unchecked) and the depth of the farthest inlier."""

    scale: float
    shift: float
    inlier_fraction: float | None
    references: int
    farthest: float


def align_inverse_depth(d: Numbers, y: Numbers, *, seed: int = 0, with_shift: bool = True) -> Alignment:
    """Scale and shift from many references y = 1 / z [n] with outliers. AlignmentError if fewer than 20 agree."""
    if len(d) < MIN_INLIERS:
        raise AlignmentError(f"align: expected at least {MIN_INLIERS} references inside the image, got {len(d)}")
    rng = np.random.default_rng(seed)
    rows = (
        np.arange(len(d))
        if len(d) <= MAX_SCORED_REFERENCES
        else rng.choice(len(d), MAX_SCORED_REFERENCES, replace=False)
    )
    hypotheses = _draw(d[rows], y[rows], rng, with_shift)
    scale, shift = _best(hypotheses, d[rows], y[rows])
    scale, shift, inliers = _refit(scale, shift, d, y, with_shift)
    if scale <= 0 and inliers.sum() >= MIN_INLIERS:
        raise AlignmentError(
            f"align: the references only agree with an inverted map, where nearer is farther; {REMEDY}"
        )
    if inliers.sum() < MIN_INLIERS:
        raise AlignmentError(
            f"align: expected at least {MIN_INLIERS} references that agree with one scale and shift, got "
            f"{int(inliers.sum())} of {len(d)}; {REMEDY}"
        )
    return Alignment(scale, shift, float(inliers.mean()), len(d), float(1 / y[inliers].min()))


REMEDY = "check that they belong to this image, and that the preset matches the model"


def align_to_distances(d: Numbers, y: Numbers, *, with_shift: bool = True) -> Alignment:
    """Scale and shift from a few distances, by all pairs; above the minimum number more than half must agree."""
    unknowns = 2 if with_shift else 1
    if len(d) < unknowns:
        why = "scale and shift are unknown" if with_shift else "the scale is unknown"
        raise AlignmentError(f"align: expected at least {unknowns} distances since {why}, got {len(d)}")
    first, second = np.triu_indices(len(d), 1)
    hypotheses = _lines(d, y, first, second) if with_shift else _scales(d, y)
    scale, shift = _best(hypotheses, d, y)
    if len(d) == unknowns:
        return Alignment(scale, shift, None, len(d), float(1 / y.min()))
    scale, shift, inliers = _refit(scale, shift, d, y, with_shift)
    agreeing = int(inliers.sum())
    if scale <= 0 or agreeing <= unknowns or 2 * agreeing <= len(d):
        raise AlignmentError(
            f"align: expected more than half of the {len(d)} distances, and at least {unknowns + 1}, to agree with one "
            f"scale and shift, got {agreeing}; measure again, or {REMEDY}"
        )
    return Alignment(scale, shift, float(inliers.mean()), len(d), float(1 / y[inliers].min()))


def _draw(d: Numbers, y: Numbers, rng: np.random.Generator, with_shift: bool) -> Numbers:
    first = rng.integers(0, len(d), HYPOTHESIS_COUNT)
    if not with_shift:
        return _scales(d[first], y[first])
    second = (first + rng.integers(1, len(d), HYPOTHESIS_COUNT)) % len(d)
    return _lines(d, y, first, second)


def _lines(d: Numbers, y: Numbers, first: NDArray[np.int64], second: NDArray[np.int64]) -> Numbers:
    """Scale and shift of each pair with different d, shape [k, 2]."""
    apart = np.abs(d[first] - d[second]) > MIN_RELATIVE_DIFFERENCE * max(float(np.ptp(d)), 1e-300)
    first, second = first[apart], second[apart]
    scales = (y[first] - y[second]) / (d[first] - d[second])
    return np.stack([scales, y[first] - scales * d[first]], 1)


def _scales(d: Numbers, y: Numbers) -> Numbers:
    return np.stack([y / d, np.zeros_like(y)], 1)


def _best(hypotheses: Numbers, d: Numbers, y: Numbers) -> tuple[float, float]:
    hypotheses = hypotheses[np.isfinite(hypotheses).all(1) & (hypotheses[:, 0] > 0)]
    if not len(hypotheses):
        raise AlignmentError(
            f"align: where the references are nearer, the depth of the network is equal or larger; {REMEDY}"
        )
    costs = [np.minimum(_residuals(scale, shift, d, y), MAX_RELATIVE_RESIDUAL).sum() for scale, shift in hypotheses]
    scale, shift = hypotheses[int(np.argmin(costs))]
    return float(scale), float(shift)


def _residuals(scale: float, shift: float, d: Numbers, y: Numbers) -> Numbers:
    return np.abs(scale * d + shift - y) / y


def _refit(
    scale: float, shift: float, d: Numbers, y: Numbers, with_shift: bool
) -> tuple[float, float, NDArray[np.bool_]]:
    """Relative least squares over the inliers, until they no longer change."""
    inliers = _residuals(scale, shift, d, y) < MAX_RELATIVE_RESIDUAL
    for _ in range(REFIT_COUNT):
        if inliers.sum() < (2 if with_shift else 1):
            break
        scale, shift = _solve(d[inliers], y[inliers], with_shift, (scale, shift))
        again = _residuals(scale, shift, d, y) < MAX_RELATIVE_RESIDUAL
        if np.array_equal(again, inliers):
            break
        inliers = again
    return scale, shift, inliers


def _solve(d: Numbers, y: Numbers, with_shift: bool, before: tuple[float, float]) -> tuple[float, float]:
    """Minimize the sum of ((scale d + shift) / y - 1)^2. The previous line if all d are equal."""
    a, b = d / y, 1 / y
    if not with_shift:
        return float(a.sum() / (a * a).sum()), 0.0
    across = a - (a * b).sum() / (b * b).sum() * b  # the part of a that no shift explains, without cancellation
    spread = float((across * across).sum())
    if spread <= 1e-12 * float((a * a).sum()):
        return before
    scale = float(across.sum() / spread)
    return scale, float((b * (1 - scale * a)).sum() / (b * b).sum())
