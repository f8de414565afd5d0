"""Bounding-box tree over triangles, for rays, distances and intersections.

Leaves are runs of LEAF_SIZE triangles. Level 0 nodes have FAN leaves, node k of level l has nodes FAN k .. FAN k + 7 of
level l - 1. The record of a node is `levels[l] + k`. At `boxes[record * SIDES]` are its child boxes as in a PointTree
(low x of all eight, low y, ...). Missing children are empty boxes. A leaf's corners are interleaved (`leaf_corner`),
and the last leaf is padded with its last triangle. Triangles with non-finite corners are skipped, degenerate ones stay.
Boxes are exact float32 extremes.
"""

from collections.abc import Sequence
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ..algebra.transform import narrow, widen
from ..array_types import AnyArray, Points, Triangles
from ..arrays.bounds import COLUMN_COUNT, EMPTY_EXTREME, box_of, merge_box
from ..arrays.runs import Runs, elements_of
from ..arrays.select import positions_of
from ..arrays.side_by_side import read_together
from ..lang import (
    INFINITY,
    NAN,
    array,
    float32,
    func,
    int32,
    isfinite,
    kernel,
    launch,
    struct,
    tid,
    uint8,
    vec3,
    vec3i,
    vector,
)
from ..memory import download, empty, full, upload
from ..search.point_tree import FAN, SIDES, bound_levels, level_sizes
from .split_order import order_by_splits

LEAF_SIZE = 8  # triangles
TRIANGLES_PER_THREAD = 1024  # on the CPU: one atomic each
LEAF_NUMBERS = 9 * LEAF_SIZE  # numbers of a leaf's corners
MAX_LEVEL = 15  # 2^k - 1, above the root of 2^31 triangles
level_keys = vector(128, int32)  # FAN per level


class Extent:
    """Extent of triangles: `middles`, NaN for non-finite corners; `mask`, 1 if finite; `extremes` for `box_of`."""

    def __init__(self, vertices: Points, triangles: Triangles) -> None:
        device, runs = vertices.device, Runs(triangles.size, vertices.device, TRIANGLES_PER_THREAD)
        self.middles, self.mask = empty(triangles.size, vec3, device), empty(triangles.size, uint8, device)
        self.extremes = full(runs.rows * COLUMN_COUNT, EMPTY_EXTREME, int32, device)
        results = [self.middles, self.mask, self.extremes]
        launch(bound_triangles_kernel, runs.threads, [vertices, triangles, runs, *results])


def trees_over(
    meshes: Sequence[tuple[Points, Triangles]], beside: Sequence[AnyArray] = ()
) -> tuple[list["TriangleTree"], list[np.ndarray]]:
    """Trees of several meshes on one device, and other arrays as NumPy. One sync."""
    extents = [Extent(vertices, triangles) for vertices, triangles in meshes]
    host_arrays = read_together([*(extent.extremes for extent in extents), *beside])  # sync
    known = zip(extents, host_arrays, strict=False)
    return [TriangleTree(*mesh, of) for mesh, of in zip(meshes, known, strict=True)], host_arrays[len(meshes) :]


@struct
class TriangleTree:
    """Search structure over the finite triangles of a mesh. `boxes`: SIDES numbers per record; `corners`: LEAF_NUMBERS
    per leaf: x, y, z of first, second, third corners; `order` by position, padded; host box (one sync at first access).
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
        """Build. One sync, none if all corners are known to be finite or the extent and its host values are given."""
        self.vertices, self.triangles, self.device = vertices, triangles, vertices.device
        extent = known[0] if known else Extent(vertices, triangles)
        self._extremes, self._known, self.count = extent.extremes, known[1] if known else None, triangles.size
        if not all_finite:
            self.count = self._box[2]  # sync, if it is not known
        order = order_by_splits(extent.middles, positions_of(extent.mask, self.count), LEAF_SIZE)
        self.leaf_count = -(-self.count // LEAF_SIZE)
        padded_count = self.leaf_count * LEAF_SIZE
        self.order = empty(padded_count, int32, self.device)
        self.corners = empty(9 * padded_count, float32, self.device)
        launch(order_triangles_kernel, padded_count, [vertices, triangles, order, self])
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
        return self._box[0]

    @property
    def high(self) -> NDArray[np.float32]:
        return self._box[1]


@func
def leaf_corner(corners: array(dtype=float32), leaf: int, lane: int, corner: int) -> vec3:
    at = leaf * LEAF_NUMBERS + 3 * corner * LEAF_SIZE + lane
    return vec3(corners[at], corners[at + LEAF_SIZE], corners[at + 2 * LEAF_SIZE])


@func
def middle_of(a: vec3, b: vec3, c: vec3) -> vec3:
    return narrow((widen(a) + widen(b) + widen(c)) / 3.0)


@kernel
def find_middles_kernel(vertices: array(dtype=vec3), triangles: array(dtype=vec3i), middles: array(dtype=vec3)):
    """Center of each triangle. NaN for non-finite corners."""
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
    """Centers and finiteness of a thread's triangles; widens a row's box."""
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
    merge_box(i, low, high, count, runs, extremes)


@kernel
def order_triangles_kernel(
    vertices: array(dtype=vec3), triangles: array(dtype=vec3i), sorted_rows: array(dtype=int32), tree: TriangleTree
):
    i = tid()
    row = sorted_rows[min(i, tree.count - 1)]
    tree.order[i] = row
    t = triangles[row]
    for corner in range(3):
        p = vertices[t[corner]]
        at = (i // LEAF_SIZE) * LEAF_NUMBERS + 3 * corner * LEAF_SIZE + i % LEAF_SIZE
        tree.corners[at] = p[0]
        tree.corners[at + LEAF_SIZE] = p[1]
        tree.corners[at + 2 * LEAF_SIZE] = p[2]


@kernel
def bound_leaves_kernel(corners: array(dtype=float32), boxes: array(dtype=float32)):
    i = tid()
    at = (i // FAN) * SIDES + i % FAN
    for axis in range(3):
        low = float(INFINITY)
        high = -float(INFINITY)
        if i < corners.shape[0] // LEAF_NUMBERS:
            for corner in range(3):
                first = i * LEAF_NUMBERS + (3 * corner + axis) * LEAF_SIZE
                for lane in range(LEAF_SIZE):
                    low = min(low, corners[first + lane])
                    high = max(high, corners[first + lane])
        boxes[at + axis * FAN] = low
        boxes[at + (axis + 3) * FAN] = high
