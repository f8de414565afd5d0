"""Outlier detection in ground control by least trimmed squares.

FAST-LTS over triples (Rousseeuw and Van Driessen 2006), with the small sample correction of Rousseeuw and Leroy 1987.
Three points only check their own triangle. Four do not identify a wrong one.
"""

from __future__ import annotations

import itertools
import math

import numpy as np
from numpy.typing import NDArray

from ...registration.rigid import fit_pose
from ...registration.trajectories.weighted_similarity import Rows, UndeterminedError, WeightedFit, fit_rows
from .ground_control import MIN_POINTS, is_straight

Array = NDArray[np.float64]

MAX_TRIPLES = 300  # random triples if there are more
MAX_ITERATIONS = 10
CONSISTENT_RATIO = 1.25  # ratio of actual to stated errors of the inliers
OUTLIER_DEVIATIONS = 5.0  # standard deviations of an outlier
MIN_TO_IDENTIFY = 5  # minimum points to identify a wrong one


def agreeing(source: Array, target: Array, sigma: Array, *, seed: int = 0) -> NDArray[np.bool_]:
    """Mask [n] of the inliers among model and world positions [n, 3] [m] with standard deviations `sigma` [m]."""
    count = len(source)
    inliers = np.ones(count, bool)
    if count < MIN_TO_IDENTIFY:
        return inliers
    inlier_count = count - (count - MIN_POINTS) // 2
    best, left = math.inf, None
    for rows in _triples(count, seed):
        candidate = _concentrated(source, target, sigma, rows, inlier_count)
        if candidate is not None and candidate[0] < best:
            best, left = candidate
    if left is None:
        return inliers
    try:
        fit = fit_rows(
            Rows(source[left], target[left], sigma[left]), fit_pose(source[left], target[left], with_scaling=True)
        )
    except UndeterminedError:
        return inliers
    spread = math.sqrt(best / max(3 * inlier_count - 7, 1))
    if spread > CONSISTENT_RATIO:  # the model is deformed, or the stated sigmas are too small
        spread *= 1 + MIN_TO_IDENTIFY / (count - MIN_POINTS)
    inliers = deviations(fit, source, target, sigma) <= OUTLIER_DEVIATIONS * max(1.0, spread)
    return inliers if inliers.sum() > MIN_POINTS and not is_straight(target[inliers]) else np.ones(count, bool)


def deviations(fit: WeightedFit, source: Array, target: Array, sigma: Array) -> Array:
    """Residuals in standard deviations of point and fit, [n]."""
    gaps = fit.of(source) - target
    spread = fit.covariance_of(source) + sigma[:, :, None] ** 2 * np.eye(3)
    return np.sqrt(np.einsum("ni,ni->n", gaps, np.linalg.solve(spread, gaps[:, :, None])[:, :, 0]))


def residual_ratio(fit: WeightedFit, source: Array, target: Array, sigma: Array) -> float:
    """Ratio of actual to stated errors: 1 is expected."""
    freedom = max(3 * len(source) - 7, 1)
    return math.sqrt(float((((fit.of(source) - target) / sigma) ** 2).sum()) / freedom)


def _triples(count: int, seed: int) -> list[NDArray[np.int64]]:
    if math.comb(count, 3) <= MAX_TRIPLES:
        return [np.array(each) for each in itertools.combinations(range(count), 3)]
    rng = np.random.Generator(np.random.PCG64(seed))
    return [np.sort(rng.choice(count, 3, replace=False)) for _ in range(MAX_TRIPLES)]


def _concentrated(
    source: Array, target: Array, sigma: Array, rows: NDArray[np.int64], count: int
) -> tuple[float, NDArray[np.int64]] | None:
    """Cost and indices of the best points from a triple. None if collinear."""
    off = np.zeros(len(source))
    for _ in range(MAX_ITERATIONS):
        if is_straight(target[rows]) or is_straight(source[rows]):
            return None
        weights = 1 / (sigma[rows] ** 2).sum(axis=1)
        T = fit_pose(source[rows], target[rows], weights=weights, with_scaling=True)
        off = ((source @ T[:3, :3].T + T[:3, 3] - target) ** 2 / sigma**2).sum(axis=1)
        nearest = np.sort(np.argsort(off, kind="stable")[:count])
        if len(nearest) == len(rows) and (nearest == rows).all():
            break
        rows = nearest
    return float(off[rows].sum()), rows
