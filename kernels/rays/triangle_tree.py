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

from collections.abc import Sequence
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ..algebra.transform import narrow, widen
from ..array_types import AnyArray, Points, Triangles
from ..arrays.bounds import NOTHING, WIDTH, box_of, settle_box
from ..arrays.runs import Runs, elements_of
from ..arrays.select import positions_of
from ..arrays.side_by_side import read_together
from ..lang import INFINITY, NAN, array, float32, func, int32, isfinite, kernel, launch, struct, tid, uint8, vec3, vec3i
from ..memory import download, empty, full, upload
from ..search.point_tree import FAN, SIDES, bound_levels, level_sizes
from .split_order import order_by_splits

LEAF = 8  # triangles a leaf
RUN = 1024  # triangles that a thread of the CPU bounds: one atomic each
LEAF_NUMBERS = 9 * LEAF  # numbers of a leaf's corners


class Extent:
    """How far triangles reach: what a TriangleTree over them begins with, where they are.

    Attributes:
        middles: vec3 [t], the middle of each triangle; NaN where a corner is not finite.
        mask: uint8 [t], 1 for triangles whose corners are finite.
        extremes: int32, the box of those and how many they are: `box_of` makes it of what the host reads.
    """

    def __init__(self, vertices: Points, triangles: Triangles) -> None:
        device, runs = vertices.device, Runs(triangles.size, vertices.device, RUN)
        self.middles, self.mask = empty(triangles.size, vec3, device), empty(triangles.size, uint8, device)
        self.extremes = full(runs.rows * WIDTH, NOTHING, int32, device)
        results = [self.middles, self.mask, self.extremes]
        launch(bound_triangles_kernel, runs.threads, [vertices, triangles, runs, *results])


def trees_over(
    meshes: Sequence[tuple[Points, Triangles]], beside: Sequence[AnyArray] = ()
) -> tuple[list["TriangleTree"], list[np.ndarray]]:
    """The trees over the vertices and triangles of some meshes on a device, and other arrays as NumPy; one sync."""
    extents = [Extent(vertices, triangles) for vertices, triangles in meshes]
    found = read_together([*(extent.extremes for extent in extents), *beside])  # sync
    known = zip(extents, found, strict=False)
    return [TriangleTree(*mesh, of) for mesh, of in zip(meshes, known, strict=True)], found[len(meshes) :]


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
        self,
        vertices: Points,
        triangles: Triangles,
        known: tuple[Extent, np.ndarray] | None = None,
        *,
        all_finite: bool = False,
    ) -> None:
        """Build it; one sync, none where it is known that all corners are finite, or how far the triangles reach, and
        what the host has read of it."""
        self.vertices, self.triangles, self.device = vertices, triangles, vertices.device
        extent = known[0] if known else Extent(vertices, triangles)
        self._extremes, self._known, self.count = extent.extremes, known[1] if known else None, triangles.size
        if not all_finite:
            self.count = self._box[2]  # sync, if it is not known
        placed = order_by_splits(extent.middles, positions_of(extent.mask, self.count), LEAF)
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
    def _box(self) -> tuple[NDArray[np.float32], NDArray[np.float32], int]:
        return box_of(download(self._extremes) if self._known is None else self._known)  # sync

    @property
    def low(self) -> NDArray[np.float32]:
        """The lowest coordinates."""
        return self._box[0]

    @property
    def high(self) -> NDArray[np.float32]:
        """The highest coordinates."""
        return self._box[1]


@func
def leaf_corner(corners: array(dtype=float32), leaf: int, lane: int, corner: int) -> vec3:
    """The corner (0, 1 or 2) of one of a leaf's triangles."""
    at = leaf * LEAF_NUMBERS + 3 * corner * LEAF + lane
    return vec3(corners[at], corners[at + LEAF], corners[at + 2 * LEAF])


@func
def middle_of(a: vec3, b: vec3, c: vec3) -> vec3:
    """The middle of a triangle."""
    return narrow((widen(a) + widen(b) + widen(c)) / 3.0)


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
        middle = middle_of(a, b, c)
    middles[i] = middle


@kernel
def bound_triangles_kernel(
    vertices: array(dtype=vec3),
    triangles: array(dtype=vec3i),
    runs: Runs,
    middles: array(dtype=vec3),
    mask: array(dtype=uint8),
    extremes: array(dtype=int32),
):
    """The middles of a thread's triangles and whether they are finite; a row's box is widened to those that are."""
    i = tid()
    low = vec3(INFINITY, INFINITY, INFINITY)
    high = vec3(-INFINITY, -INFINITY, -INFINITY)
    count = 0
    for j in elements_of(i, runs):
        t = triangles[j]
        a = vertices[t[0]]
        b = vertices[t[1]]
        c = vertices[t[2]]
        middle = vec3(NAN, NAN, NAN)
        is_finite = 0
        if isfinite(a) and isfinite(b) and isfinite(c):
            middle = middle_of(a, b, c)
            is_finite = 1
            for axis in range(3):
                low[axis] = min(low[axis], min(a[axis], min(b[axis], c[axis])))
                high[axis] = max(high[axis], max(a[axis], max(b[axis], c[axis])))
        middles[j] = middle
        mask[j] = uint8(is_finite)
        count += is_finite
    settle_box(i, low, high, count, runs, extremes)


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
