"""Data snooping: outlier observations are removed one by one, the worst first (Baarda 1968)."""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass

import numpy as np
from scipy.special import chdtri

from ...kernels.linear_algebra import matmul, norm
from .adjustment import Adjusted, Array, Group, Observed, adjust
from .observations import TargetObservation

FALSE_ALARM = 0.01  # probability of any false outlier in a survey
TESTED = ("pair", "target", "control")
MIN_PAIRS = 5  # minimum number of tested pairs to judge their sigmas
MEDIAN_PROBABILITY = 0.5
MAX_DIVERGED = 2  # removed outliers without convergence: then units or poses are wrong, and tests have no meaning
TRIED_SUSPECTS = 3  # suspects tried: gross errors distort the tests
MAX_TIED_DIFFERENCE = 1e-6  # relative difference of statistics that cannot be separated
MAX_EXCHANGED_RATIO = 0.1  # residual ratio of two targets with exchanged names


@dataclass(frozen=True, eq=False)
class Outlier:
    """A removed observation with its `critical` value; `rivals` may be wrong instead, `exchanged`: swapped target."""

    group: Group
    critical: float
    rivals: tuple[Group, ...] = ()
    exchanged: str = ""


def snoop(first: Array, observed: Observed, *, level: bool, reference: int) -> tuple[Adjusted, Observed, list[Outlier]]:
    """Adjust without outliers; repeated with larger standard deviations if those of the pairs prove too small."""
    adjusted, remaining, outliers = _cleaned(first, observed, level, reference)
    factor = _pair_factor(adjusted)
    if factor > 1 and adjusted.converged:
        wider = dataclasses.replace(observed, pair_factor=observed.pair_factor * factor)
        adjusted, remaining, outliers = _cleaned(first, wider, level, reference)
    return adjusted, remaining, [_with_exchange(one, outliers, adjusted) for one in outliers]


def _cleaned(first: Array, observed: Observed, level: bool, reference: int) -> tuple[Adjusted, Observed, list[Outlier]]:
    adjusted, outliers = adjust(first, observed, level=level, reference=reference), []
    loose, max_outliers = adjusted.loose.sum(), len(adjusted.groups) // 2
    while len(outliers) < (max_outliers if adjusted.converged else min(max_outliers, MAX_DIVERGED)):
        suspects = _suspects(adjusted)
        tried = []
        for group in suspects[:TRIED_SUSPECTS]:
            again = adjust(adjusted.poses, observed.without(group), level=level, reference=reference)
            if again.loose.sum() == loose and again.datum == adjusted.datum:
                tried.append((again.squares, len(tried), group, again))
        if not tried:
            break
        _, _, group, again = min(tried, key=lambda one: one[:2])
        ties = (g for g in suspects if g is not group and abs(g.statistic / group.statistic - 1) < MAX_TIED_DIFFERENCE)
        outliers.append(Outlier(group, _critical(group.freedom, len(adjusted.groups)), tuple(ties)))
        adjusted, observed = again, observed.without(group)
    return adjusted, observed, outliers


def _critical(freedom: int, count: int) -> float:
    return float(chdtri(freedom, FALSE_ALARM / max(count, 1)))


def _suspects(adjusted: Adjusted) -> list[Group]:
    """Outlier groups by the decrease of the sum of squares without them."""
    beyond = {}
    for k, group in enumerate(adjusted.groups):
        if group.kind in TESTED and group.freedom == group.rows.stop - group.rows.start > 0:
            beyond[k] = group.statistic - _critical(group.freedom, len(adjusted.groups))
    return [adjusted.groups[k] for k in sorted(beyond, key=lambda k: -beyond[k]) if beyond[k] > 0]


def _pair_factor(adjusted: Adjusted) -> float:
    """Factor of the pairs' standard deviations by the median of their tests, at least 1."""
    tested = [g for g in adjusted.groups if g.kind == "pair" and g.freedom]
    if len(tested) < MIN_PAIRS:
        return 1.0
    return max(1.0, float(np.sqrt(np.median([g.statistic / chdtri(g.freedom, MEDIAN_PROBABILITY) for g in tested]))))


def _with_exchange(outlier: Outlier, outliers: list[Outlier], adjusted: Adjusted) -> Outlier:
    """Detect a swap with another target of the same station."""
    one = outlier.group.observation
    if not isinstance(one, TargetObservation):
        return outlier
    for other in (rival.group.observation for rival in outliers):
        if other is one or not isinstance(other, TargetObservation) or other.station != one.station:
            continue
        if one.name not in adjusted.targets or other.name not in adjusted.targets:
            continue
        apart = norm(np.asarray(one.position) - np.asarray(other.position))
        T = adjusted.poses[one.station]
        crossed = [(one, other.name), (other, one.name)]
        misses = [
            norm(matmul(T[:3, :3], np.asarray(p.position)) + T[:3, 3] - adjusted.targets[name]) for p, name in crossed
        ]
        if max(misses) < MAX_EXCHANGED_RATIO * apart:
            return dataclasses.replace(outlier, exchanged=other.name)
    return outlier
