"""Mesh topology: boundary, non-manifold and inconsistent edges, and fans at vertices.

Half-edge h = 3 t + k runs from corner k of triangle t to the next. Half-edges are sorted by their two vertices (stable
64-bit sort), so an edge is a run of equal keys. About 40 B per half-edge.
"""

from typing import NamedTuple

import numpy as np

from ..array_types import Integers, LongIntegers, Triangles
from ..arrays.pair_sort import argsort_pairs
from ..lang import array, atomic_max, func, int32, int64, kernel, launch, struct, tid, vec3i
from ..memory import empty, zeros

BOUNDARY_EDGES, CROWDED_EDGES, TWISTED_EDGES, SPLIT_VERTICES = 0, 1, 2, 3  # indices of the findings


@kernel
def list_corner_keys_kernel(triangles: array(dtype=vec3i), keys: array(dtype=int64)):
    i = tid()
    t = triangles[i]
    keys[3 * i] = int64(t[0])
    keys[3 * i + 1] = int64(t[1])
    keys[3 * i + 2] = int64(t[2])


@kernel
def find_starts_kernel(keys: array(dtype=int64), count: int, starts: array(dtype=int32)):
    """starts[v] is the first position of a key >= v. One thread per key."""
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
    """Corners of triangles by vertex: starts int32 [m + 1], corners int32 [3 t] (corner // 3 is the triangle)."""

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
    return h + 1 if h % 3 < 2 else h - 2


@func
def last_corner(h: int) -> int:
    return h - 1 if h % 3 > 0 else h + 2


@kernel
def pair_edges_kernel(
    triangles: array(dtype=vec3i),
    keys: array(dtype=int64),
    order: array(dtype=int32),
    twins: array(dtype=int32),
    findings: array(dtype=int32),
):
    """Opposite half-edge at edges with two triangles, else -1. All threads that set a finding write the same value."""
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
        atomic_max(findings, BOUNDARY_EDGES, 1)
    elif before + after == 2 or first == 0 or last == 0:
        atomic_max(findings, CROWDED_EDGES, 1)
    else:
        twin = order[i - before + after]
        if corner_vertex(triangles, twin) == corner_vertex(triangles, h):
            atomic_max(findings, TWISTED_EDGES, 1)
    twins[h] = twin


@func
def other_edge(triangles: array(dtype=vec3i), h: int, v: int) -> int:
    first = (h // 3) * 3
    k = h % 3
    step = 1
    if corner_vertex(triangles, h) == v:
        step = 2
    return first + (k + step) % 3


@kernel
def check_fans_kernel(
    triangles: array(dtype=vec3i), around: CornersByVertex, twins: array(dtype=int32), findings: array(dtype=int32)
):
    i = tid()
    count = around.starts[i + 1] - around.starts[i]
    if count == 0:
        return
    start = around.corners[around.starts[i]]
    visited = 1
    h = start
    closed = 0
    for way in range(2):
        if way == 1:
            h = other_edge(triangles, start, i)
        while visited <= count and closed == 0 and twins[h] >= 0:
            h = other_edge(triangles, twins[h], i)
            if h // 3 == start // 3:
                closed = 1
            else:
                visited += 1
    if visited != count:
        atomic_max(findings, SPLIT_VERTICES, 1)


def sorted_edges(triangles: Triangles, vertex_count: int) -> tuple[LongIntegers, Integers]:
    """Half-edges sorted by their vertices: (keys, order) as of `argsort_pairs`."""
    bits, keys = max(1, vertex_count.bit_length()), empty(3 * triangles.size, int64, triangles.device)
    launch(list_edge_keys_kernel, triangles.size, [triangles, bits, keys])
    return argsort_pairs(keys, bits, vertex_count)


class Topology(NamedTuple):
    """Topology flags: `has_boundary` (edges with one triangle), `has_crowded_edge` (more than two), `has_twisted_edge`
    (two in the same direction), `has_split_vertex` (triangles at a vertex that are not one fan)."""

    has_boundary: bool
    has_crowded_edge: bool
    has_twisted_edge: bool
    has_split_vertex: bool


def find_topology(
    triangles: Triangles, vertex_count: int, edges: tuple[LongIntegers, Integers] | None = None
) -> Integers:
    """Topology flags as int32 [4]; `edges` of `sorted_edges` if known. No sync."""
    device, count = triangles.device, 3 * triangles.size
    keys, order = edges or sorted_edges(triangles, vertex_count)
    twins, findings = empty(count, int32, device), zeros(4, int32, device)
    launch(pair_edges_kernel, count, [triangles, keys, order, twins, findings])
    around = CornersByVertex(triangles, vertex_count)
    launch(check_fans_kernel, vertex_count, [triangles, around, twins, findings])
    return findings


def topology_of(findings: np.ndarray) -> Topology:
    return Topology(*(bool(flag) for flag in findings))
