"""Points with many neighbors: the counting step of DBSCAN.

One thread per leaf of eight lanes, on CUDA per point. Counting stops once each lane has enough.
"""

from ..array_types import Mask
from ..lang import INFINITY, array, kernel, launch, tid, uint8
from ..memory import zeros
from ..search.point_tree import BUCKET, LEAF, PointTree
from ..search.tree_search import squared_radius
from ..search.tree_walk import lanes, leaf_threads, numbers, points_of
from .dbscan import count_group, count_lacking


@kernel
def mask_crowded_kernel(tree: PointTree, max_sqdist: float, needed: int, mask: array(dtype=uint8)):
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
    counts = count_group(counts, xs, ys, zs, leaf, tree, max_sqdist)
    for j in range(LEAF):
        rank = leaf * LEAF + j
        if rank < tree.count:
            is_crowded = 0
            if counts[j] >= 0:
                is_crowded = 1
            mask[tree.order[rank]] = uint8(is_crowded)


@mask_crowded_kernel.on_cuda
def mask_crowded_lanes_kernel(tree: PointTree, max_sqdist: float, needed: int, mask: array(dtype=uint8)):
    """CUDA variant: a point per lane."""
    i = tid()
    p = tree.points[min(i, tree.count - 1)]
    counted = count_lacking(p, needed, i // BUCKET, tree, max_sqdist)
    if i < tree.count:
        mask[tree.order[i]] = uint8(1 if counted[0] <= 0 else 0)


def mask_crowded(tree: PointTree, radius: float, needed: int) -> Mask:
    """uint8 [n]: 1 for finite points with at least `needed` points within a radius [m], including themselves."""
    mask = zeros(tree.source.size, uint8, tree.device)
    if tree.count:
        arguments = [tree, squared_radius(radius), min(needed, tree.count + 1), mask]
        launch(mask_crowded_kernel, leaf_threads(tree), arguments)
    return mask
