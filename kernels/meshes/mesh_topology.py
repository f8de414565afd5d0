"""How the triangles of a mesh hang together: edges with one, two or more triangles, their directions, fans at vertices.

Half-edge h = 3 t + k runs from corner k of triangle t to the next corner. Half-edges are sorted by their two vertices
(one stable sort of 64-bit keys), so an edge is a run of equal keys; then one thread a vertex walks around it from
triangle to triangle. About 40 B a half-edge.
"""

from typing import NamedTuple

import numpy as np

from ..array_types import Integers, LongIntegers, Triangles
from ..arrays.pair_sort import argsort_pairs
from ..lang import array, atomic_max, func, int32, int64, kernel, launch, struct, tid, vec3i
from ..memory import download, empty, zeros

BOUNDARY, CROWDED, TWISTED, SPLIT = 0, 1, 2, 3  # places of the findings


@kernel
def list_corner_keys_kernel(triangles: array(dtype=vec3i), keys: array(dtype=int64)):
    """The vertex of each corner, three corners a triangle."""
    i = tid()
    t = triangles[i]
    keys[3 * i] = int64(t[0])
    keys[3 * i + 1] = int64(t[1])
    keys[3 * i + 2] = int64(t[2])


@kernel
def find_starts_kernel(keys: array(dtype=int64), count: int, starts: array(dtype=int32)):
    """starts[v] is the first place of v or more in the sorted keys; one thread a key writes all up to its own."""
    i = tid()
    first = 0
    if i > 0:
        first = int(keys[i - 1]) + 1
    for v in range(first, int(keys[i]) + 1):
        starts[v] = i
    if i + 1 == keys.shape[0]:
        for v in range(int(keys[i]) + 1, count + 1):
            starts[v] = i + 1


@struct
class CornersByVertex:
    """The corners of triangles by vertex.

    Attributes:
        starts: int32 [m + 1], where each vertex' corners begin in `corners`.
        corners: int32 [3 t]; corner // 3 is the triangle.
    """

    starts: array(dtype=int32)
    corners: array(dtype=int32)

    def __init__(self, triangles: Triangles, vertex_count: int) -> None:
        device = triangles.device
        keys = empty(3 * triangles.size, int64, device)
        launch(list_corner_keys_kernel, triangles.size, [triangles, keys])
        keys, self.corners = argsort_pairs(keys, 0, vertex_count)
        self.starts = zeros(vertex_count + 1, int32, device)
        launch(find_starts_kernel, keys.size, [keys, vertex_count, self.starts])


@kernel
def list_edge_keys_kernel(triangles: array(dtype=vec3i), bits: int, keys: array(dtype=int64)):
    """The two vertices of each half-edge, the lower number above the higher one."""
    i = tid()
    t = triangles[i]
    for k in range(3):
        a = t[0]
        b = t[1]
        if k == 1:
            a = t[1]
            b = t[2]
        if k == 2:
            a = t[2]
            b = t[0]
        keys[3 * i + k] = (int64(min(a, b)) << int64(bits)) | int64(max(a, b))


@func
def corner_vertex(triangles: array(dtype=vec3i), h: int) -> int:
    """The vertex that a half-edge starts from."""
    t = triangles[h // 3]
    k = h % 3
    v = t[0]
    if k == 1:
        v = t[1]
    if k == 2:
        v = t[2]
    return v


@func
def next_corner(h: int) -> int:
    """The half-edge after another in its triangle."""
    return h + 1 if h % 3 < 2 else h - 2


@kernel
def pair_edges_kernel(
    triangles: array(dtype=vec3i),
    keys: array(dtype=int64),
    order: array(dtype=int32),
    twins: array(dtype=int32),
    findings: array(dtype=int32),
):
    """The other half-edge of each edge with two triangles, else -1; any thread may set a finding."""
    i = tid()
    count = keys.shape[0]
    key = keys[i]
    h = order[i]
    before = 0
    after = 0
    first = 1
    if i > 0:
        if keys[i - 1] == key:
            before = 1
            if i > 1:
                if keys[i - 2] == key:
                    first = 0
    last = 1
    if i + 1 < count:
        if keys[i + 1] == key:
            after = 1
            if i + 2 < count:
                if keys[i + 2] == key:
                    last = 0
    twin = -1
    if before + after == 0:
        atomic_max(findings, BOUNDARY, 1)
    elif before + after == 2 or first == 0 or last == 0:
        atomic_max(findings, CROWDED, 1)
    else:
        twin = order[i - before + after]
        if corner_vertex(triangles, twin) == corner_vertex(triangles, h):
            atomic_max(findings, TWISTED, 1)
    twins[h] = twin


@func
def other_edge(triangles: array(dtype=vec3i), h: int, v: int) -> int:
    """The other half-edge of the triangle of h that touches v."""
    first = (h // 3) * 3
    k = h % 3
    step = 1
    if corner_vertex(triangles, h) == v:
        step = 2
    return first + (k + step) % 3


@kernel
def walk_fans_kernel(
    triangles: array(dtype=vec3i), around: CornersByVertex, twins: array(dtype=int32), findings: array(dtype=int32)
):
    """Whether the triangles around each vertex are one fan, walked both ways from the first; any thread may set it."""
    i = tid()
    count = around.starts[i + 1] - around.starts[i]
    if count == 0:
        return
    start = around.corners[around.starts[i]]
    seen = 1
    h = start
    closed = 0
    for way in range(2):
        if way == 1:
            h = other_edge(triangles, start, i)
        while seen <= count and closed == 0 and twins[h] >= 0:
            h = other_edge(triangles, twins[h], i)
            if h // 3 == start // 3:
                closed = 1
            else:
                seen += 1
    if seen != count:
        atomic_max(findings, SPLIT, 1)


def sorted_edges(triangles: Triangles, vertex_count: int) -> tuple[LongIntegers, Integers]:
    """The half-edges of triangles by their two vertices: (keys, order), as of `argsort_pairs`."""
    bits, keys = max(1, vertex_count.bit_length()), empty(3 * triangles.size, int64, triangles.device)
    launch(list_edge_keys_kernel, triangles.size, [triangles, bits, keys])
    return argsort_pairs(keys, bits, vertex_count)


class Topology(NamedTuple):
    """What a mesh is made of.

    Attributes:
        has_boundary: Some edge belongs to one triangle.
        has_crowded_edge: Some edge belongs to three triangles or more.
        has_twisted_edge: The two triangles of some edge run it in the same direction.
        has_split_vertex: The triangles at some vertex are not one fan.
    """

    has_boundary: bool
    has_crowded_edge: bool
    has_twisted_edge: bool
    has_split_vertex: bool


def find_topology(
    triangles: Triangles, vertex_count: int, edges: tuple[LongIntegers, Integers] | None = None
) -> Integers:
    """What a Topology is made of, int32 [4] device array; `edges` of `sorted_edges`, where they are known; no sync."""
    device, count = triangles.device, 3 * triangles.size
    keys, order = edges or sorted_edges(triangles, vertex_count)
    twins, findings = empty(count, int32, device), zeros(4, int32, device)
    launch(pair_edges_kernel, count, [triangles, keys, order, twins, findings])
    around = CornersByVertex(triangles, vertex_count)
    launch(walk_fans_kernel, vertex_count, [triangles, around, twins, findings])
    return findings


def examine(triangles: Triangles, vertex_count: int) -> Topology:
    """The topology of vec3i [t] triangles; one sync. Vertices without triangles do not count."""
    return topology_of(download(find_topology(triangles, vertex_count)))  # sync


def topology_of(findings: np.ndarray) -> Topology:
    """The topology, of what the host has read of `find_topology`."""
    return Topology(*(bool(found) for found in findings))
