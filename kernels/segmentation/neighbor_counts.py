"""Which points have many neighbours: the counting half of DBSCAN, alone.

One thread a leaf: its points are eight lanes, a candidate is loaded once and measured against all of them, and counting
stops once each lane has enough. 12 B read and 1 B written a point beside the walk; O(1) memory a thread.
"""

from ..array_types import Mask
from ..lang import INFINITY, array, kernel, launch, tid, uint8
from ..memory import zeros
from ..search.point_tree import LEAF, PointTree
from ..search.tree_search import reach_of
from ..search.tree_walk import lanes, numbers, points_of
from .dbscan import count_group


@kernel
def mask_crowded_kernel(tree: PointTree, reach: float, needed: int, mask: array(dtype=uint8)):
    """1 for the points of a leaf that have `needed` points within reach, themselves included."""
    leaf = tid()
    xs = lanes(INFINITY)
    ys = lanes(0.0)
    zs = lanes(0.0)
    counts = numbers(0)
    for j, p in points_of(leaf, tree):
        xs[j] = p[0]
        ys[j] = p[1]
        zs[j] = p[2]
        counts[j] = -needed
    counts = count_group(counts, xs, ys, zs, leaf, tree, reach)
    for j in range(LEAF):
        rank = leaf * LEAF + j
        if rank < tree.count:
            kept = 0
            if counts[j] >= 0:
                kept = 1
            mask[tree.order[rank]] = uint8(kept)


def mask_crowded(tree: PointTree, radius: float, needed: int) -> Mask:
    """The points with at least `needed` points closer than a radius [m], themselves included.

    Returns:
        uint8 device array in the cloud's order, shape [n]; 0 for points that are not finite.
    """
    mask = zeros(tree.source.size, uint8, tree.device)
    if tree.count:
        arguments = [tree, reach_of(radius), min(needed, tree.count + 1), mask]
        launch(mask_crowded_kernel, -(-tree.count // LEAF), arguments)
    return mask
