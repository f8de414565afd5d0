"""Mean and standard deviation of a value over the neighbors of each point, in float64 and tree order."""

from ..array_types import Device, Doubles
from ..lang import NAN, array, float64, int32, isfinite, kernel, launch, sqrt, struct, tid, vector
from ..memory import full, zeros
from ..search.bucket_walk import points_within
from ..search.point_tree import BUCKET, PointTree
from ..search.tree_search import squared_radius

value_sums = vector(3, float64)  # of differences: count, sum, sum of squares


@struct
class Spreads:
    """Results: `means` (NaN if the point has no value), sample `deviations` (NaN for fewer than two), `counts`."""

    means: array(dtype=float64)
    deviations: array(dtype=float64)
    counts: array(dtype=int32)

    def __init__(self, count: int, device: Device) -> None:
        self.means, self.deviations = full(count, NAN, float64, device), full(count, NAN, float64, device)
        self.counts = zeros(count, int32, device)


@kernel
def spread_values_kernel(tree: PointTree, values: array(dtype=float64), max_sqdist: float, spreads: Spreads):
    i = tid()
    at = tree.order[i]
    p = tree.points[i]
    own = values[at]
    total = value_sums(0.0)
    if isfinite(own):
        for j, sqdist in points_within(i // BUCKET, p, max_sqdist, tree):
            off = values[tree.order[j]] - own
            if isfinite(off):
                total = total + value_sums(1.0, off, off * off)
        count = total[0]
        spreads.means[at] = own + total[1] / count
        spreads.counts[at] = int(count)
        if count > 1.0:
            spreads.deviations[at] = sqrt(max((total[2] - total[1] * total[1] / count) / (count - 1.0), 0.0))


def spread_values(tree: PointTree, values: Doubles, radius: float) -> Spreads:
    """Mean and deviation of float64 values over the neighbors within a radius [m] (exclusive) of each point."""
    spreads = Spreads(values.size, values.device)
    launch(spread_values_kernel, tree.count, [tree, values, squared_radius(radius), spreads])
    return spreads
