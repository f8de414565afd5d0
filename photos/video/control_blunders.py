"""Which points of ground control contradict the others.

Least trimmed squares: the similarity for which most of the points are least off, from three points each, then again
and again by those that agree best. Points far beyond what that leaves, and beyond how sure the similarity is where they
lie, are wrong. Three points contradict nothing but their own triangle, four do not tell which of them is wrong.

Source: Rousseeuw and Van Driessen 2006 (FAST-LTS); Rousseeuw and Leroy 1987 (the medians of few points are too small).
"""

from __future__ import annotations

import itertools
import math

import numpy as np
from numpy.typing import NDArray

from ...registration.rigid import fit_pose
from ...registration.trajectories.weighted_similarity import Rows, UndeterminedError, WeightedFit, fit_rows
from .ground_control import FEWEST, is_straight

Array = NDArray[np.float64]

TRIPLES = 300  # that are tried, where there are more
TURNS = 10
AS_TOLD = 1.25  # times the told standard deviations that the best of the points leave
ROUGH = 5.0  # standard deviations beyond which a point is wrong
FEWEST_TO_TELL = 5  # points that tell which of them is wrong


def agreeing(source: Array, target: Array, sigma: Array, *, seed: int = 0) -> NDArray[np.bool_]:
    """Which points agree with most of the others, shape [n].

    Args:
        source: In the model, shape [n, 3].
        target: In the world, shape [n, 3] [m].
        sigma: Standard deviation of each coordinate, shape [n, 3] [m].
        seed: Of the triples that are tried.
    """
    count = len(source)
    kept = np.ones(count, bool)
    if count < FEWEST_TO_TELL:
        return kept
    most = count - (count - FEWEST) // 2
    best, left = math.inf, None
    for rows in _triples(count, seed):
        found = _concentrated(source, target, sigma, rows, most)
        if found is not None and found[0] < best:
            best, left = found
    if left is None:
        return kept
    try:
        fit = fit_rows(
            Rows(source[left], target[left], sigma[left]), fit_pose(source[left], target[left], with_scaling=True)
        )
    except UndeterminedError:
        return kept
    spread = math.sqrt(best / max(3 * most - 7, 1))
    if spread > AS_TOLD:  # the model is bent, or points are worse than they are told to be
        spread *= 1 + FEWEST_TO_TELL / (count - FEWEST)
    kept = deviations(fit, source, target, sigma) <= ROUGH * max(1.0, spread)
    return kept if kept.sum() > FEWEST and not is_straight(target[kept]) else np.ones(count, bool)


def deviations(fit: WeightedFit, source: Array, target: Array, sigma: Array) -> Array:
    """How far each point is from where a fit brings it, in standard deviations of both, shape [n]."""
    gaps = fit.of(source) - target
    spread = fit.covariance_of(source) + sigma[:, :, None] ** 2 * np.eye(3)
    return np.sqrt(np.einsum("ni,ni->n", gaps, np.linalg.solve(spread, gaps[:, :, None])[:, :, 0]))


def misfit(fit: WeightedFit, source: Array, target: Array, sigma: Array) -> float:
    """How many times farther off points are than they are told to be sure: 1 is expected."""
    freedom = max(3 * len(source) - 7, 1)
    return math.sqrt(float((((fit.of(source) - target) / sigma) ** 2).sum()) / freedom)


def _triples(count: int, seed: int) -> list[NDArray[np.int64]]:
    if math.comb(count, 3) <= TRIPLES:
        return [np.array(each) for each in itertools.combinations(range(count), 3)]
    rng = np.random.Generator(np.random.PCG64(seed))
    return [np.sort(rng.choice(count, 3, replace=False)) for _ in range(TRIPLES)]


def _concentrated(
    source: Array, target: Array, sigma: Array, rows: NDArray[np.int64], most: int
) -> tuple[float, NDArray[np.int64]] | None:
    """What the best of the points leave, and which they are, from three of them; None where those lie on a line."""
    off = np.zeros(len(source))
    for _ in range(TURNS):
        if is_straight(target[rows]) or is_straight(source[rows]):
            return None
        weights = 1 / (sigma[rows] ** 2).sum(axis=1)
        T = fit_pose(source[rows], target[rows], weights=weights, with_scaling=True)
        off = ((source @ T[:3, :3].T + T[:3, 3] - target) ** 2 / sigma**2).sum(axis=1)
        nearest = np.sort(np.argsort(off, kind="stable")[:most])
        if len(nearest) == len(rows) and (nearest == rows).all():
            break
        rows = nearest
    return float(off[rows].sum()), rows
