"""Data snooping: observations that contradict the rest are taken out one by one, the worst first (Baarda 1968)."""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass

import numpy as np
from scipy.special import chdtri

from ...kernels.linear_algebra import matmul, norm
from .adjustment import Adjusted, Array, Group, Observed, adjust
from .observations import TargetObservation

FALSE_ALARM = 0.01  # the chance that any right observation of a survey is called wrong
TESTED = ("pair", "target", "control")
FEWEST_PAIRS = 5  # that are checked, from which on their standard deviations are judged
MEDIAN = 0.5
RIVALS = 3  # suspects that are tried: gross errors bend what their tests say
TIED = 1e-6  # of a statistic: two that are as large contradict each other, and nothing says which is wrong
EXCHANGED = 0.1  # of the misfits of two targets: what is left of them where their names were exchanged


@dataclass(frozen=True, eq=False)
class Outlier:
    """An observation that contradicts the rest.

    Attributes:
        group: It, as it was tested.
        critical: What its statistic should have been below.
        rivals: Others that contradict it as much, of which one may be wrong in its place.
        exchanged: The other target of the same station that it was exchanged with; "" where it was not.
    """

    group: Group
    critical: float
    rivals: tuple[Group, ...] = ()
    exchanged: str = ""


def snoop(first: Array, observed: Observed, *, level: bool, reference: int) -> tuple[Adjusted, Observed, list[Outlier]]:
    """The adjustment of what is left without the outliers, what that is, and the outliers.

    Standard deviations of pairs are estimates: where those that are left show that they were too small, all is done
    again with larger ones.
    """
    found, left, outliers = _cleaned(first, observed, level, reference)
    factor = _pair_factor(found)
    if factor > 1:
        wider = dataclasses.replace(observed, pair_factor=observed.pair_factor * factor)
        found, left, outliers = _cleaned(first, wider, level, reference)
    return found, left, [_with_exchange(one, outliers, found) for one in outliers]


def _cleaned(first: Array, observed: Observed, level: bool, reference: int) -> tuple[Adjusted, Observed, list[Outlier]]:
    found, outliers = adjust(first, observed, level=level, reference=reference), []
    loose, most = found.loose.sum(), len(found.groups) // 2
    while len(outliers) < most:
        suspects = _suspects(found)
        tried = []
        for group in suspects[:RIVALS]:
            again = adjust(found.poses, observed.without(group), level=level, reference=reference)
            if again.loose.sum() == loose and again.datum == found.datum:
                tried.append((again.squares, len(tried), group, again))
        if not tried:
            break
        _, _, group, again = min(tried, key=lambda one: one[:2])
        ties = (g for g in suspects if g is not group and abs(g.statistic / group.statistic - 1) < TIED)
        outliers.append(Outlier(group, _critical(group.freedom, len(found.groups)), tuple(ties)))
        found, observed = again, observed.without(group)
    return found, observed, outliers


def _critical(freedom: int, count: int) -> float:
    return float(chdtri(freedom, FALSE_ALARM / max(count, 1)))


def _suspects(found: Adjusted) -> list[Group]:
    """Groups that contradict the rest, the worst first: by how much less the sum of squares is without them."""
    beyond = {}
    for k, group in enumerate(found.groups):
        if group.kind in TESTED and group.freedom == group.rows.stop - group.rows.start > 0:
            beyond[k] = group.statistic - _critical(group.freedom, len(found.groups))
    return [found.groups[k] for k in sorted(beyond, key=lambda k: -beyond[k]) if beyond[k] > 0]


def _pair_factor(found: Adjusted) -> float:
    """How much larger the standard deviations of pairs are than said, by the median of their tests; 1 at least."""
    tested = [g for g in found.groups if g.kind == "pair" and g.freedom]
    if len(tested) < FEWEST_PAIRS:
        return 1.0
    return max(1.0, float(np.sqrt(np.median([g.statistic / chdtri(g.freedom, MEDIAN) for g in tested]))))


def _with_exchange(outlier: Outlier, outliers: list[Outlier], found: Adjusted) -> Outlier:
    """The outlier, with the other target of its station whose place it fits, and that fits its place."""
    one = outlier.group.observation
    if not isinstance(one, TargetObservation):
        return outlier
    for other in (rival.group.observation for rival in outliers):
        if other is one or not isinstance(other, TargetObservation) or other.station != one.station:
            continue
        if one.name not in found.targets or other.name not in found.targets:
            continue
        apart = norm(np.asarray(one.position) - np.asarray(other.position))
        T = found.poses[one.station]
        crossed = [(one, other.name), (other, one.name)]
        misses = [
            norm(matmul(T[:3, :3], np.asarray(p.position)) + T[:3, 3] - found.targets[name]) for p, name in crossed
        ]
        if max(misses) < EXCHANGED * apart:
            return dataclasses.replace(outlier, exchanged=other.name)
    return outlier
