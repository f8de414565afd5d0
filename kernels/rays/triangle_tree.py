"""A tree of boxes over triangles: one exact search structure for rays, distances and triangles that cut each other.

Leaves are runs of LEAF triangles of an order in which neighbours in space stand together, the nodes of level 0 have
FAN leaves, and each node above FAN nodes of the level below: node k of level l has the nodes FAN k .. FAN k + 7 of
level l - 1, and node k of level 0 the leaves FAN k .. FAN k + 7. A node's record is `levels[l] + k`; at `boxes[record *
SIDES]` stand the boxes of its children as those of a PointTree do (low x of all eight, low y, low z, high x, ...), so
that they are measured together in vector registers: search/point_tree.py `measure_boxes` and search/bucket_walk.py
`next_step` work on them. Children that are not there are empty boxes, infinitely far and met by no ray.

The corners of a leaf's triangles lie side by side as well: `leaf_corner`. The last leaf is filled up with its last
triangle again, so that all of its lanes may be measured; where triangles are counted, places from `count` on are not.

Triangles with a corner that is not finite are left out. Triangles without area stay: they are as near as their edges.
Boxes are the lowest and highest of the float32 coordinates, without any rounding.
"""

from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ..algebra.transform import narrow, widen
from ..array_types import Points, Triangles
from ..lang import INFINITY, NAN, array, float32, func, int32, isfinite, kernel, launch, struct, tid, vec3, vec3i
from ..memory import download, empty, upload
from ..search.point_tree import FAN, SIDES, bound_levels, level_sizes
from .split_order import order_by_splits

Box = tuple[NDArray[np.float32], NDArray[np.float32]]

LEAF = 8  # triangles a leaf
LEAF_NUMBERS = 9 * LEAF  # numbers of a leaf's corners


@struct
class TriangleTree:
    """The search structure over the triangles of a mesh.

    Args:
        vertices: Device array of vec3.
        triangles: Device array of vec3i, each entry the number of a vertex.

    Attributes:
        count: Triangles whose corners are finite.
        root: The level of the highest node; leaves' parents are level 0.
        levels: int32, where the records of each level begin, and end; `level_firsts` on the host.
        boxes: float32, SIDES numbers a record: the boxes of its children.
        corners: float32, LEAF_NUMBERS a leaf: x of the first corners of its LEAF triangles, then y, then z, then those
            of the second corners and of the third ones.
        order: int32, the triangle's number by place (leaf * LEAF + lane); full leaves, so it may pass `count`.
        leaf_count: Leaves.
        vertices, triangles: What it was built over.
        low, high: The box of the triangles, float32 [3] on the host; from infinity to minus infinity without any. The
            first look takes one sync.
    """

    count: int
    root: int
    levels: array(dtype=int32)
    boxes: array(dtype=float32)
    corners: array(dtype=float32)
    order: array(dtype=int32)

    def __init__(
        self, vertices: Points, triangles: Triangles, *, all_finite: bool = False, box: Box | None = None
    ) -> None:
        """One sync, none where it is known that all corners are finite; and the box (low, high), where it is known."""
        self._known_box = box
        self.vertices, self.triangles, self.device = vertices, triangles, vertices.device
        middles = empty(triangles.size, vec3, self.device)
        launch(find_middles_kernel, triangles.size, [vertices, triangles, middles])
        placed = order_by_splits(middles, LEAF, all_finite=all_finite)  # sync
        self.count = placed.size
        self.leaf_count = -(-self.count // LEAF)
        places = self.leaf_count * LEAF
        self.order = empty(places, int32, self.device)
        self.corners = empty(9 * places, float32, self.device)
        launch(place_triangles_kernel, places, [vertices, triangles, placed, self])
        sizes, self.level_firsts = level_sizes(-(-self.leaf_count // FAN))
        self.root = len(sizes) - 1
        self.levels = upload(self.level_firsts, int32, self.device)
        self.boxes = empty(int(self.level_firsts[-1]) * SIDES, float32, self.device)
        launch(bound_leaves_kernel, sizes[0] * FAN, [self.corners, self.boxes])
        bound_levels(self.levels, sizes, self.boxes, known=0)

    @cached_property
    def box(self) -> Box:
        """(low, high)."""
        if self._known_box is not None:
            return self._known_box
        sides = download(self.boxes[-SIDES:]).reshape(2, 3, FAN)  # sync
        return sides[0].min(axis=1), sides[1].max(axis=1)

    @property
    def low(self) -> NDArray[np.float32]:
        """The lowest coordinates."""
        return self.box[0]

    @property
    def high(self) -> NDArray[np.float32]:
        """The highest coordinates."""
        return self.box[1]


@func
def leaf_corner(corners: array(dtype=float32), leaf: int, lane: int, corner: int) -> vec3:
    """The corner (0, 1 or 2) of one of a leaf's triangles."""
    at = leaf * LEAF_NUMBERS + 3 * corner * LEAF + lane
    return vec3(corners[at], corners[at + LEAF], corners[at + 2 * LEAF])


@kernel
def find_middles_kernel(vertices: array(dtype=vec3), triangles: array(dtype=vec3i), middles: array(dtype=vec3)):
    """The middle of each triangle; NaN where a corner is not finite."""
    i = tid()
    t = triangles[i]
    a = vertices[t[0]]
    b = vertices[t[1]]
    c = vertices[t[2]]
    middle = vec3(NAN, NAN, NAN)
    if isfinite(a) and isfinite(b) and isfinite(c):
        middle = narrow((widen(a) + widen(b) + widen(c)) / 3.0)
    middles[i] = middle


@kernel
def place_triangles_kernel(
    vertices: array(dtype=vec3), triangles: array(dtype=vec3i), sorted_rows: array(dtype=int32), tree: TriangleTree
):
    """Write the triangle of each place, the last one again beyond the last."""
    i = tid()
    row = sorted_rows[min(i, tree.count - 1)]
    tree.order[i] = row
    t = triangles[row]
    for corner in range(3):
        p = vertices[t[corner]]
        at = (i // LEAF) * LEAF_NUMBERS + 3 * corner * LEAF + i % LEAF
        tree.corners[at] = p[0]
        tree.corners[at + LEAF] = p[1]
        tree.corners[at + 2 * LEAF] = p[2]


@kernel
def bound_leaves_kernel(corners: array(dtype=float32), boxes: array(dtype=float32)):
    """The box of each leaf, beside its siblings'; an empty one where there is none."""
    i = tid()
    at = (i // FAN) * SIDES + i % FAN
    for axis in range(3):
        low = float(INFINITY)
        high = -float(INFINITY)
        if i < corners.shape[0] // LEAF_NUMBERS:
            for corner in range(3):
                first = i * LEAF_NUMBERS + (3 * corner + axis) * LEAF
                for lane in range(LEAF):
                    low = min(low, corners[first + lane])
                    high = max(high, corners[first + lane])
        boxes[at + axis * FAN] = low
        boxes[at + (axis + 3) * FAN] = high
