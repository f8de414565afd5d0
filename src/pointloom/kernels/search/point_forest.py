"""Search trees over many clouds in shared arrays for batched launches.

As in point_tree.py. Node `node` of tree t has its children's boxes in record levels[t * HEIGHTS + level] + node.
Padding is at infinity and inside no box.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from ..array_types import Vectors
from ..lang import INFINITY, array, float32, func, int32, kernel, launch, partial, struct, tid, vec3
from ..memory import empty, upload_together
from .bucket_walk import level_children_within, next_step, traversal
from .hilbert_order import locate_on_curve
from .many_clouds import ManyClouds
from .point_tree import FAN, LEAF, SIDES, bound_leaf, find_run, highest_corner, lowest_corner

if TYPE_CHECKING:
    from .point_tree import PointTree

HEIGHTS = 12  # sufficient for 2^31 points


@struct
class PointForest:
    """Search trees of several clouds: `levels`: HEIGHTS numbers per tree, start of each level (buckets are level 0,
    indexed as in `codes`); `roots`: top level per tree; `boxes`: SIDES numbers per node.
    """

    clouds: ManyClouds
    bucket_counts: array(dtype=int32)
    levels: array(dtype=int32)
    roots: array(dtype=int32)
    boxes: array(dtype=float32)

    def __init__(
        self,
        clouds: Sequence[Vectors],
        tree: "PointTree | None" = None,
        joined: Vectors | None = None,
        order: ManyClouds | None = None,
    ) -> None:
        """`tree`, `order`: of the only cloud, if they exist. `joined`: the clouds in one array, if there is one."""
        sorted_clouds = self.clouds = ManyClouds(clouds, tree, joined) if order is None else order
        device, trees = sorted_clouds.device, len(clouds)
        sizes = [sorted_clouds.buckets]
        while sizes[-1].max() > 1:
            sizes.append(-(-sizes[-1] // FAN))
        table, first = np.zeros((trees, HEIGHTS), np.int64), 0
        for level, count in enumerate(sizes):
            table[:, level] = first + np.cumsum(count) - count
            first += int(count.sum())
        roots = np.zeros(trees, np.int64)
        for level in range(1, len(sizes)):
            roots[sizes[level - 1] > 1] = level
        tables = [table.ravel(), roots, sorted_clouds.buckets]
        self.levels, self.roots, self.bucket_counts = upload_together(tables, int32, device)
        if tree is not None:
            self.boxes = tree.boxes
            return
        self.boxes = empty(first * SIDES, float32, device)
        launch(bound_forest_leaves_kernel, sorted_clouds.points.size // LEAF, [sorted_clouds.points, self.boxes])
        for level in range(1, len(sizes)):
            launch(bound_forest_nodes_kernel, int(sizes[level].sum()) * FAN, [trees, level, self])


@kernel
def bound_forest_leaves_kernel(points: array(dtype=vec3), boxes: array(dtype=float32)):
    """Leaf boxes. Empty, which no query reaches, for leaves without points."""
    i = tid()
    bound_leaf(i, points, points.shape[0], boxes)


@kernel
def bound_forest_nodes_kernel(trees: int, level: int, forest: PointForest):
    """Copy the node boxes of the level below into their parents. Missing nodes get empty boxes."""
    i = tid()
    record = forest.levels[level] + i // FAN
    a = 0
    b = trees
    while b - a > 1:
        middle = (a + b) // 2
        if forest.levels[middle * HEIGHTS + level] <= record:
            a = middle
        else:
            b = middle
    end = forest.levels[level]
    if a + 1 < trees:
        end = forest.levels[(a + 1) * HEIGHTS + level - 1]
    first = forest.levels[a * HEIGHTS + level - 1]
    child = first + (record - forest.levels[a * HEIGHTS + level]) * FAN + i % FAN
    low = vec3(INFINITY, INFINITY, INFINITY)
    high = vec3(-INFINITY, -INFINITY, -INFINITY)
    if child < end:
        low = lowest_corner(child, forest.boxes)
        high = highest_corner(child, forest.boxes)
    at = record * SIDES + i % FAN
    for axis in range(3):
        forest.boxes[at + axis * FAN] = low[axis]
        forest.boxes[at + (axis + 3) * FAN] = high[axis]


@func
def find_bucket_of(p: vec3, tree: int, forest: PointForest) -> int:
    """Bucket, within one tree, whose curve interval contains a point."""
    code = locate_on_curve(p, forest.clouds.curve)
    return find_run(forest.clouds.codes, forest.levels[tree * HEIGHTS], forest.bucket_counts[tree], code)


@func
def next_bucket_of(step: traversal, a: vec3, b: vec3, bound: float, tree: int, forest: PointForest) -> traversal:
    """As point_tree's `next_bucket`, in one of the trees."""
    first = tree * HEIGHTS
    return next_step(
        step, forest.roots[tree], partial(level_children_within, forest.levels, first, forest.boxes, a, b, bound)
    )
