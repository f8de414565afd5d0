"""Search trees over many clouds in shared arrays, so that one launch searches all of them.

Each tree is that of point_tree.py: leaves of LEAF points in Hilbert order, buckets of FAN leaves, nodes of FAN
children. Nodes are numbered within their tree; a node of tree t on a level has its children's boxes in the record
levels[t * HEIGHTS + level] + node. Padding is at infinity and inside no box.
"""

import numpy as np

from ..lang import INFINITY, array, float32, int32, isfinite, kernel, launch, tid, vec3
from ..memory import upload
from .many_clouds import CurveSegments
from .point_tree import FAN, LEAF, SIDES, highest_corner, lowest_corner

HEIGHTS = 12  # more levels than 2^31 points have


@kernel
def bound_forest_leaves_kernel(points: array(dtype=vec3), boxes: array(dtype=float32)):
    """The boxes of the leaves; empty, which no query reaches, where a leaf has no point."""
    i = tid()
    a = vec3(INFINITY, INFINITY, INFINITY)
    b = vec3(-INFINITY, -INFINITY, -INFINITY)
    for j in range(i * LEAF, (i + 1) * LEAF):
        p = points[j]
        if isfinite(p):
            a = vec3(min(a[0], p[0]), min(a[1], p[1]), min(a[2], p[2]))
            b = vec3(max(b[0], p[0]), max(b[1], p[1]), max(b[2], p[2]))
    at = (i // FAN) * SIDES + i % FAN
    for axis in range(3):
        boxes[at + axis * FAN] = a[axis]
        boxes[at + (axis + 3) * FAN] = b[axis]


@kernel
def bound_forest_nodes_kernel(
    starts: array(dtype=int32),
    trees: int,
    below: int,
    level: int,
    roots: array(dtype=int32),
    levels: array(dtype=int32),
    boxes: array(dtype=float32),
):
    """Put the box of each node of the level below beside its siblings', where its parent holds them."""
    i = tid()
    a = int(0)
    b = trees + 0
    while b - a > 1:
        middle = (a + b) // 2
        if starts[middle] <= i:
            a = middle
        else:
            b = middle
    if roots[a] >= level:
        child = i - starts[a]
        at = (levels[a * HEIGHTS + level] + child // FAN) * SIDES + child % FAN
        low = lowest_corner(below + i, boxes)
        high = highest_corner(below + i, boxes)
        for axis in range(3):
            boxes[at + axis * FAN] = low[axis]
            boxes[at + (axis + 3) * FAN] = high[axis]


class PointForest:
    """The search trees of several clouds.

    Attributes:
        curve: The points in their order, a CurveSegments.
        search_arguments: What kernels take: the buckets of each tree; codes, low, scale and levels of the curve;
            levels, roots, boxes, points.
    """

    def __init__(self, clouds):
        curve = self.curve = CurveSegments(clouds)
        device, trees = curve.device, len(clouds)
        sizes = [curve.buckets]
        while sizes[-1].max() > 1:
            sizes.append(-(-sizes[-1] // FAN))
        table, first = np.zeros((trees, HEIGHTS), np.int64), 0
        starts = []
        for level, count in enumerate(sizes):
            starts.append(np.concatenate([[0], np.cumsum(count)]))
            table[:, level] = first + starts[-1][:-1]
            first += int(starts[-1][-1])
        roots = np.zeros(trees, np.int64)
        for level in range(1, len(sizes)):
            roots[sizes[level - 1] > 1] = level
        levels, self.roots = upload(table.ravel(), int32, device), upload(roots, int32, device)
        sides = np.repeat(np.array([np.inf, -np.inf], np.float32), 3 * FAN)
        boxes = upload(np.tile(sides, first), float32, device)
        launch(bound_forest_leaves_kernel, curve.points.size // LEAF, [curve.points, boxes])
        below = 0
        for level in range(1, len(sizes)):
            children = int(starts[level - 1][-1])
            firsts = upload(starts[level - 1], int32, device)
            launch(bound_forest_nodes_kernel, children, [firsts, trees, below, level, self.roots, levels, boxes])
            below += children
        self.search_arguments = [
            upload(curve.buckets, int32, device),
            curve.codes,
            curve.low,
            curve.scale,
            curve.levels,
            levels,
            self.roots,
            boxes,
            curve.points,
        ]
