"""Search trees over many clouds in shared arrays, so that one launch searches all of them.

Each tree is that of point_tree.py: leaves of LEAF points in Hilbert order, buckets of FAN leaves, nodes of FAN
children. Nodes are numbered within their tree; a node of tree t on a level has its children's boxes in the record
levels[t * HEIGHTS + level] + node. Padding is at infinity and inside no box.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from ..array_types import Vectors
from ..lang import INFINITY, array, float32, func, int32, kernel, launch, partial, struct, tid, vec3
from ..memory import empty, upload_together
from .bucket_walk import children_in_reach, next_step, walk
from .hilbert_order import locate_on_curve
from .many_clouds import ManyClouds
from .point_tree import FAN, LEAF, SIDES, bound_leaf, find_run, highest_corner, lowest_corner

if TYPE_CHECKING:
    from .point_tree import PointTree

HEIGHTS = 12  # more levels than 2^31 points have


@struct
class PointForest:
    """The search trees of several clouds.

    Args:
        clouds: Device arrays of vec3; at least one, all on one device.
        tree: The PointTree of the one cloud that there is, where it is known.

    Attributes:
        clouds: The points in their order: a ManyClouds.
        bucket_counts: Buckets of each tree.
        levels: HEIGHTS numbers a tree: where the nodes of each level begin; buckets are level 0, named as in `codes`.
        roots: The level of each tree's highest node.
        boxes: SIDES numbers a node.
    """

    clouds: ManyClouds
    bucket_counts: array(dtype=int32)
    levels: array(dtype=int32)
    roots: array(dtype=int32)
    boxes: array(dtype=float32)

    def __init__(self, clouds: Sequence[Vectors], tree: "PointTree | None" = None) -> None:
        placed = self.clouds = ManyClouds(clouds, tree)
        device, trees = placed.device, len(clouds)
        sizes = [placed.buckets]
        while sizes[-1].max() > 1:
            sizes.append(-(-sizes[-1] // FAN))
        table, first = np.zeros((trees, HEIGHTS), np.int64), 0
        for level, count in enumerate(sizes):
            table[:, level] = first + np.cumsum(count) - count
            first += int(count.sum())
        roots = np.zeros(trees, np.int64)
        for level in range(1, len(sizes)):
            roots[sizes[level - 1] > 1] = level
        tables = [table.ravel(), roots, placed.buckets]
        self.levels, self.roots, self.bucket_counts = upload_together(tables, int32, device)
        if tree is not None:
            self.boxes = tree.boxes
            return
        self.boxes = empty(first * SIDES, float32, device)
        launch(bound_forest_leaves_kernel, placed.points.size // LEAF, [placed.points, self.boxes])
        for level in range(1, len(sizes)):
            launch(bound_forest_nodes_kernel, int(sizes[level].sum()) * FAN, [trees, level, self])


@kernel
def bound_forest_leaves_kernel(points: array(dtype=vec3), boxes: array(dtype=float32)):
    """The boxes of the leaves; empty, which no query reaches, where a leaf has no point."""
    i = tid()
    bound_leaf(i, points, points.shape[0], boxes)


@kernel
def bound_forest_nodes_kernel(trees: int, level: int, forest: PointForest):
    """Put the box of each node of the level below beside its siblings', where its parent on this one holds them.

    Nodes there are not are empty boxes. Every tree has a record on every level, looked at or not.
    """
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
    """The bucket of one of the trees, counted from its first, whose run on the curve holds a place."""
    code = locate_on_curve(p, forest.clouds.curve)
    return find_run(forest.clouds.codes, forest.levels[tree * HEIGHTS], forest.bucket_counts[tree], code)


@func
def next_bucket_of(step: walk, a: vec3, b: vec3, bound: float, tree: int, forest: PointForest) -> walk:
    """As point_tree's `next_bucket`, in one of the trees."""
    first = tree * HEIGHTS
    return next_step(
        step, forest.roots[tree], partial(children_in_reach, forest.levels, first, forest.boxes, a, b, bound)
    )
