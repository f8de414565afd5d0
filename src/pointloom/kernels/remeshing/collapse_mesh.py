"""Mesh for edge collapse: arrays, triangles around vertices, and feature edges.

An edge is a feature without exactly two triangles, or with different texture coordinates or materials across it. A
vertex is free, on a line (two features), or a corner (Dey, Edelsbrunner, Guha and Nekhayev, "Topology preserving edge
contraction", 1999). Removed elements are compacted at a quarter of all (compacted_mesh.py). Sizes are in a device
record: CUDA launches cover the maximum. About 300 B per triangle.
"""

import copy
from collections.abc import Sequence
from typing import Any

import numpy as np

from ..array_types import Array1, Integers, Positions, Triangles, Vectors
from ..arrays.packed_keys import NO_KEY
from ..arrays.tile_scan import TileScan
from ..lang import array, func, int32, int64, kernel, launch, struct, tid, uint8, vec2, vec2i, vec3d, vec3i
from ..memory import clone, empty, fill, full, host_view, rows_of, upload, zeros
from ..meshes.mesh_topology import CornersByVertex, corner_vertex, last_corner, next_corner
from .quadrics import quadric

OWNER_BIT, FEATURE_BIT = 1, 2  # bits of a half-edge: owner of its edge. Feature edge
FREE_VERTEX, LINE_VERTEX, CORNER_VERTEX = 0, 1, 2  # kinds of vertices
REJECTED_KEY = NO_KEY - 1  # of an edge that may not collapse in its current neighborhood
STALE_KEY = NO_KEY - 2  # of an edge whose cost must be computed
MAX_NEAR = 16  # corners of a vertex that are always read: longer lists only if the neighbor's is not shorter

# Record: remaining triangles. Triangles and vertices including removed ones. Edges considered, able to collapse at
# once, and collapsing. The highest cost bin considered (-1 for none).
TRIANGLE_COUNT, SLOT_COUNT, VERTEX_COUNT, EDGE_COUNT, PICKED_COUNT, CHOSEN_COUNT, HIGHEST_BIN = 0, 1, 2, 3, 4, 5, 6
# Flags: triangles may flip, seams are features, compaction is due, all features must be found.
MAY_FLIP, SEAMS_ARE_FEATURES, NEEDS_COMPACTION, FINDS_ALL_FEATURES = 7, 8, 9, 10
RECORD_SIZE = 11

LISTS = ("starts", "corners", "spokes")  # arrays recomputed by a round
OTHERS = ("positions", "quadrics", "triangles", "uvs", "materials", "flags", "kinds", "touched", "keys")


@struct
class CollapseMesh:
    """A mesh between two rounds, scaled to a unit box. `starts` and `corners` are half-edges by vertex, `spokes` the
    next and last vertex of their triangles. `triangles` are -1 if removed; `uvs` and `materials` have one row if
    absent. `touched` marks vertices near the last collapses; `keys` are edge costs at their owners, or NO_KEY;
    `numbers` is the device record."""

    positions: array(dtype=vec3d)
    quadrics: array(dtype=quadric)
    triangles: array(dtype=vec3i)
    uvs: array(dtype=vec2)
    materials: array(dtype=int32)
    starts: array(dtype=int32)
    corners: array(dtype=int32)
    spokes: array(dtype=vec2i)
    flags: array(dtype=uint8)
    kinds: array(dtype=uint8)
    touched: array(dtype=uint8)
    keys: array(dtype=int64)
    numbers: array(dtype=int32)
    has_uvs: int
    has_materials: int

    def __init__(
        self,
        positions: Positions,
        triangles: Triangles,
        uvs: Array1[vec2] | None,
        materials: Integers | None,
        rows: Sequence[Vectors],
    ) -> None:
        device = triangles.device
        self.positions, self.triangles = positions, clone(triangles)
        self.rows = [clone(values) for values in rows]
        numbers = np.zeros(RECORD_SIZE, np.int32)
        numbers[[TRIANGLE_COUNT, SLOT_COUNT, VERTEX_COUNT, SEAMS_ARE_FEATURES, FINDS_ALL_FEATURES]] = (
            triangles.size,
            triangles.size,
            positions.size,
            1,
            1,
        )
        self.numbers = upload(numbers, int32, device)
        self.record = None if device.is_cuda else host_view(self.numbers)
        self.has_uvs, self.has_materials = int(uvs is not None), int(materials is not None)
        self.uvs = empty(1, vec2, device) if uvs is None else clone(uvs)
        self.materials = empty(1, int32, device) if materials is None else clone(materials)
        around = CornersByVertex(triangles, positions.size)
        self.starts, self.corners = around.starts, around.corners
        self.spokes = empty(3 * triangles.size, vec2i, device)
        launch(fill_spokes_kernel, self.spokes.size, [triangles, self.corners, self.spokes])
        self.flags, self.kinds = zeros(3 * triangles.size, uint8, device), zeros(positions.size, uint8, device)
        self.touched = zeros(positions.size, uint8, device)
        self.keys = full(3 * triangles.size, NO_KEY, int64, device)

    def live(self, number: int, capacity: int) -> int:
        """Number of threads for a count in the record: exact on the CPU, `capacity` on CUDA."""
        return capacity if self.record is None else int(self.record[number])

    def twin(self) -> "CollapseMesh":
        """A copy with room for all arrays that change, sharing the record."""
        other = copy.copy(self)
        for name in (*LISTS, *OTHERS):
            values = getattr(self, name)
            setattr(other, name, empty(values.shape, values.dtype, values.device))
        other.rows = [empty(values.shape, values.dtype, values.device) for values in self.rows]
        fill(other.starts, 0)
        return other

    def exchange(self, other: "CollapseMesh", names: Sequence[str]) -> None:
        for name in names:
            mine = getattr(self, name)
            setattr(self, name, getattr(other, name))
            setattr(other, name, mine)

    def find_all_features(self) -> None:
        """Flag all half-edges and classify all vertices if the record requests it. All edges then need a cost."""
        every, count = empty(0, int32, self.numbers.device), self.live(VERTEX_COUNT, self.positions.size)
        self._find_features(every, count)

    def find_features(self, moved: Integers, capacity: int) -> None:
        """`find_all_features` around moved vertices (int32), none adjacent to another."""
        self._find_features(moved, self.live(CHOSEN_COUNT, capacity))

    def _find_features(self, rows: Integers, count: int) -> None:
        launch(find_features_kernel, count, [self, rows, self.flags, self.keys, self.kinds])

    def join_corners(self, partners: Integers, other: "CollapseMesh", scan: TileScan) -> None:
        """Update corner lists. `partners`: vertex whose corners each takes over; -2 - v if v keeps its own, else -1."""
        count = self.live(VERTEX_COUNT, self.positions.size)
        counts = rows_of(other.starts, 1, other.starts.size)
        launch(count_corners_kernel, count, [self, partners, counts])
        scan.run(counts, counts, count)
        launch(join_corners_kernel, count, [self, partners, other.starts, other.corners, other.spokes])
        if self.numbers.device.is_cuda:
            launch(
                keep_lists_kernel, max(self.corners.size, count + 1), [other, self.starts, self.corners, self.spokes]
            )
        else:
            self.exchange(other, LISTS)


def fill_first(values: Any, count: int, value: int) -> None:
    """Fill the first elements of an array, on CUDA all, by counts of `live`."""
    if values.device.is_cuda:
        fill(values, value)
    else:
        host_view(values)[:count] = value


@kernel
def fill_spokes_kernel(triangles: array(dtype=vec3i), corners: array(dtype=int32), spokes: array(dtype=vec2i)):
    i = tid()
    h = corners[i]
    spokes[i] = vec2i(corner_vertex(triangles, next_corner(h)), corner_vertex(triangles, last_corner(h)))


@func
def joined_spoke(mesh: CollapseMesh, j: int, partners: array(dtype=int32)) -> vec2i:
    s = mesh.spokes[j]
    p = partners[s[0]]
    q = partners[s[1]]
    return vec2i(s[0] if p > -2 else -2 - p, s[1] if q > -2 else -2 - q)


@kernel
def count_corners_kernel(mesh: CollapseMesh, partners: array(dtype=int32), counts: array(dtype=int32)):
    i = tid()
    if i >= mesh.numbers[VERTEX_COUNT]:
        counts[i] = 0
        return
    count = 0
    v = i if partners[i] > -2 else -1
    while v >= 0:
        for j in range(mesh.starts[v], mesh.starts[v + 1]):
            s = joined_spoke(mesh, j, partners)
            if s[0] != s[1] and s[0] != i and s[1] != i:
                count += 1
        v = partners[i] if v == i else -1
    counts[i] = count


@kernel
def join_corners_kernel(
    mesh: CollapseMesh,
    partners: array(dtype=int32),
    starts: array(dtype=int32),
    corners: array(dtype=int32),
    spokes: array(dtype=vec2i),
):
    """Corners of each vertex, followed by those that it takes over."""
    i = tid()
    if i >= mesh.numbers[VERTEX_COUNT]:
        return
    slot = starts[i]
    v = i if partners[i] > -2 else -1
    while v >= 0:
        for j in range(mesh.starts[v], mesh.starts[v + 1]):
            s = joined_spoke(mesh, j, partners)
            if s[0] != s[1] and s[0] != i and s[1] != i:
                corners[slot] = mesh.corners[j]
                spokes[slot] = s
                slot += 1
        v = partners[i] if v == i else -1


@kernel
def keep_lists_kernel(
    other: CollapseMesh, starts: array(dtype=int32), corners: array(dtype=int32), spokes: array(dtype=vec2i)
):
    i = tid()
    count = other.numbers[VERTEX_COUNT]
    if i <= count:
        starts[i] = other.starts[i]
    if i < other.starts[count]:
        corners[i] = other.corners[i]
        spokes[i] = other.spokes[i]


@func
def mix_number(h: int) -> int64:
    """Bijective 32-bit hash to break ties without spatial order, so that not only the ends of chains collapse."""
    x = (int64(h) * 0x9E3779B1) & 0xFFFFFFFF
    x = x ^ (x >> 15)
    return (x * 0x85EBCA6B) & 0xFFFFFFFF


@func
def valence(mesh: CollapseMesh, v: int) -> int:
    return mesh.starts[v + 1] - mesh.starts[v]


@func
def uv_at(mesh: CollapseMesh, h: int, v: int) -> vec2:
    corner = h
    if corner_vertex(mesh.triangles, h) != v:
        corner = next_corner(h)
    return mesh.uvs[corner]


@func
def differ_across(mesh: CollapseMesh, g: int, h: int, a: int, b: int) -> int:
    """1 if two half-edges of edge a, b have different texture coordinates or materials."""
    differs = 0
    if mesh.has_uvs == 1:
        p = uv_at(mesh, g, a) - uv_at(mesh, h, a)
        q = uv_at(mesh, g, b) - uv_at(mesh, h, b)
        if p[0] != 0.0 or p[1] != 0.0 or q[0] != 0.0 or q[1] != 0.0:
            differs = 1
    if mesh.has_materials == 1:
        if mesh.materials[g // 3] != mesh.materials[h // 3]:
            differs = 1
    return differs


@func
def edge_at(mesh: CollapseMesh, j: int, u: int) -> int:
    """Half-edge between the vertex of the j-th corner and u in its triangle, or -1."""
    s = mesh.spokes[j]
    h = -1
    if s[0] == u:
        h = mesh.corners[j]
    elif s[1] == u:
        h = last_corner(mesh.corners[j])
    return h


@func
def edge_valence(mesh: CollapseMesh, a: int, b: int) -> int:
    count = 0
    for j in range(mesh.starts[a], mesh.starts[a + 1]):
        if edge_at(mesh, j, b) >= 0:
            count += 1
    return count


@func
def reads_other(mesh: CollapseMesh, v: int, u: int) -> int:
    """1 if a search for the edge v, u should read the list of u. That of v is in the cache, if it is not long."""
    count = valence(mesh, v)
    other = 0
    if count > MAX_NEAR:
        if valence(mesh, u) < count:
            other = 1
    return other


@func
def edge_flags(mesh: CollapseMesh, h: int, a: int, b: int, seams: int) -> int:
    """Flags of a half-edge between a and b. The first half-edge of an edge owns it."""
    v = a
    u = b
    if reads_other(mesh, a, b) == 1:
        v = b
        u = a
    first = h
    other = -1
    count = 0
    for j in range(mesh.starts[v], mesh.starts[v + 1]):
        g = edge_at(mesh, j, u)
        if g >= 0:
            count += 1
            first = min(first, g)
            if g != h:
                other = g
    value = 0
    if count != 2:
        value = FEATURE_BIT
    elif seams == 1 and other >= 0:
        value = FEATURE_BIT * differ_across(mesh, h, other, a, b)
    if first == h:
        value += OWNER_BIT
    return value


@func
def row_at(mesh: CollapseMesh, i: int, rows: array(dtype=int32)) -> int:
    """The i-th moved vertex, or vertex i if there are no rows and the record requests all, or -1 for none."""
    v = -1
    if rows.shape[0] > 0:
        if i < mesh.numbers[CHOSEN_COUNT]:
            v = rows[i]
    elif mesh.numbers[FINDS_ALL_FEATURES] == 1 and i < mesh.numbers[VERTEX_COUNT]:
        v = i
    return v


@func
def key_of_flags(value: int) -> int64:
    return int64(STALE_KEY) if (value & OWNER_BIT) != 0 else int64(NO_KEY)


@kernel
def find_features_kernel(
    mesh: CollapseMesh,
    rows: array(dtype=int32),
    flags: array(dtype=uint8),
    keys: array(dtype=int64),
    kinds: array(dtype=uint8),
):
    """Flags of the half-edges from and to some vertices, of all without rows. Classify these vertices by their number
    of feature edges (0, 2, other). Each edge is counted at its owner."""
    i = tid()
    v = row_at(mesh, i, rows)
    if v < 0:
        return
    seams = mesh.numbers[SEAMS_ARE_FEATURES]
    both_ways = min(rows.shape[0], 1)
    both = OWNER_BIT + FEATURE_BIT
    count = 0
    for j in range(mesh.starts[v], mesh.starts[v + 1]):
        c = mesh.corners[j]
        s = mesh.spokes[j]
        value = edge_flags(mesh, c, v, s[0], seams)
        if value == both:
            count += 1
        flags[c] = uint8(value)
        keys[c] = key_of_flags(value)
        d = last_corner(c)
        value = edge_flags(mesh, d, v, s[1], seams)
        if value == both:
            count += 1
        if both_ways == 1:
            flags[d] = uint8(value)
            keys[d] = key_of_flags(value)
    kind = int(CORNER_VERTEX)
    if count == 0:
        kind = FREE_VERTEX
    if count == 2:
        kind = LINE_VERTEX
    kinds[v] = uint8(kind)
