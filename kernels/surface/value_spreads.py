"""The mean and the spread of a number over the neighbours of each point.

Sums are of differences to the point's own number, in float64 in the order in which the walk meets neighbours, which is
that of the tree: the same bits from run to run. 20 B read a neighbour.
"""

from ..array_types import Device, Doubles
from ..lang import NAN, array, float64, int32, isfinite, kernel, launch, sqrt, struct, tid, vector
from ..memory import full, zeros
from ..search.bucket_walk import points_in_reach
from ..search.point_tree import BUCKET, PointTree
from ..search.tree_search import reach_of

value_sums = vector(3, float64)  # of differences: how many, their sum, that of their squares


@struct
class Spreads:
    """Of the neighbours that have a number, themselves among them.

    Attributes:
        means: float64 [n]; NaN where the point itself has none.
        deviations: Standard deviations with n - 1, float64 [n]; NaN of fewer than two.
        counts: int32 [n].
    """

    means: array(dtype=float64)
    deviations: array(dtype=float64)
    counts: array(dtype=int32)

    def __init__(self, count: int, device: Device) -> None:
        self.means, self.deviations = full(count, NAN, float64, device), full(count, NAN, float64, device)
        self.counts = zeros(count, int32, device)


@kernel
def spread_values_kernel(tree: PointTree, values: array(dtype=float64), reach: float, spreads: Spreads):
    """Mean, deviation and count of the numbers of each point's neighbours."""
    i = tid()
    at = tree.order[i]
    p = tree.points[i]
    own = values[at]
    total = value_sums(0.0)
    if isfinite(own):
        for j, sqdist in points_in_reach(i // BUCKET, p, reach, tree):
            off = values[tree.order[j]] - own
            if isfinite(off):
                total = total + value_sums(1.0, off, off * off)
        count = total[0]
        spreads.means[at] = own + total[1] / count
        spreads.counts[at] = int(count)
        if count > 1.0:
            spreads.deviations[at] = sqrt(max((total[2] - total[1] * total[1] / count) / (count - 1.0), 0.0))


def spread_values(tree: PointTree, values: Doubles, radius: float) -> Spreads:
    """Mean and spread of numbers, float64 [n], over the neighbours within a radius [m], excluded, of each point."""
    spreads = Spreads(values.size, values.device)
    launch(spread_values_kernel, tree.count, [tree, values, reach_of(radius), spreads])
    return spreads
