"""Mesh for isotropic remeshing, with creases that are preserved.

A crease is an edge without exactly two consistently oriented triangles, with a large dihedral angle, or that was one
before. A vertex is free, on a line (two creases), or a corner, also if its line bends. About 200 B per triangle. On
CUDA, removed triangles stay as three times the vertex count, so no sync is needed. Their common edge comes last.
"""

import math
from typing import Any

from ..algebra.transform import widen
from ..array_types import Bytes, Indices, Integers, Points, Triangles
from ..arrays.select import positions_of
from ..arrays.side_by_side import read_together
from ..arrays.sort import positions
from ..arrays.union_find import flatten_sets_kernel, unite
from ..lang import (
    array,
    atomic_add,
    atomic_max,
    compute,
    dot,
    float32,
    float64,
    func,
    int32,
    int64,
    kernel,
    launch,
    length,
    struct,
    tid,
    uint8,
    vec3,
    vec3d,
    vec3i,
)
from ..memory import empty, full, zeros
from ..meshes.mesh_edges import MeshEdges, key_bits
from ..meshes.mesh_measures import triangle_cross
from ..meshes.mesh_topology import CornersByVertex, corner_vertex, last_corner, next_corner

FREE_VERTEX, LINE_VERTEX, CORNER_VERTEX = 0, 1, 2  # kinds of vertices
NO_NUMBER = 0x7FFF_FFFF_FFFF_FFFF  # above all keys


@func
def mixed_key(number: int, i: int) -> int64:
    """Unique key of a number with a hash of i in the low bits, without spatial order."""
    x = (int64(i) * 0x9E3779B1) & 0xFFFFFFFF
    return (int64(number) << 32) | x


@struct
class CreasedMesh:
    """A mesh between two steps. Edges are padded until `count_edges`. `creases` flags half-edges, `fixed` vertices that
    are always corners, `rims` those on boundary edges. Removed triangles have three vertices m."""

    vertices: array(dtype=vec3)
    triangles: array(dtype=vec3i)
    creases: array(dtype=uint8)
    fixed: array(dtype=uint8)
    edges: MeshEdges
    edge_of: array(dtype=int32)
    around: CornersByVertex
    kinds: array(dtype=uint8)
    rims: array(dtype=uint8)

    def __init__(self, vertices: Points, triangles: Triangles, creases: Bytes, fixed: Bytes) -> None:
        self.vertices, self.triangles, self.creases, self.fixed = vertices, triangles, creases, fixed
        device, count = vertices.device, vertices.size
        self.edges, self.around = MeshEdges(triangles, count, padded=True), CornersByVertex(triangles, count)
        self.edge_of = empty(3 * triangles.size, int32, device)
        self.rims, ends = zeros(count, uint8, device), zeros(count, int32, device)
        self.kinds = empty(count, uint8, device)
        launch(join_creases_kernel, self.edges.count, [self, self.edge_of, self.creases, self.rims, ends])
        launch(sort_vertices_kernel, count, [ends, fixed, self.kinds])

    @property
    def removed_edge(self) -> int:
        return self.vertices.size << key_bits(self.vertices.size) | self.vertices.size

    def count_edges(self, *beside: Integers) -> list[Any]:
        """Remove the padding of edges, and copy `beside` to NumPy. One sync."""
        if self.edges.summary is None:
            return read_together(beside) if beside else []
        (count, low, high), *values = read_together([self.edges.summary, *beside])  # sync
        self.edges.cut(int(count) - int((int(high) << 32 | int(low) & 0xFFFF_FFFF) == self.removed_edge))
        return values


@func
def is_edge(edges: MeshEdges, e: int) -> int:
    """1 for edges of existing triangles."""
    return 1 if edges.lows[e] != edges.highs[e] else 0


@func
def is_paired(triangles: array(dtype=vec3i), edges: MeshEdges, e: int) -> int:
    first = edges.starts[e]
    paired = 0
    if edges.starts[e + 1] - first == 2:
        if corner_vertex(triangles, edges.half_edges[first]) != corner_vertex(triangles, edges.half_edges[first + 1]):
            paired = 1
    return paired


@kernel
def join_creases_kernel(
    mesh: CreasedMesh,
    edge_of: array(dtype=int32),
    creases: array(dtype=uint8),
    rims: array(dtype=uint8),
    ends: array(dtype=int32),
):
    """Make all half-edges of an edge creases if one is, and count them at vertices (integers)."""
    e = tid()
    if is_edge(mesh.edges, e) == 0:
        return
    first = mesh.edges.starts[e]
    last = mesh.edges.starts[e + 1]
    crease = 1 - is_paired(mesh.triangles, mesh.edges, e)
    for j in range(first, last):
        if creases[mesh.edges.half_edges[j]] != 0:
            crease = 1
    for j in range(first, last):
        creases[mesh.edges.half_edges[j]] = uint8(crease)
        edge_of[mesh.edges.half_edges[j]] = e
    if last - first == 1:
        rims[mesh.edges.lows[e]] = uint8(1)
        rims[mesh.edges.highs[e]] = uint8(1)
    if crease == 1:
        atomic_add(ends, mesh.edges.lows[e], 1)
        atomic_add(ends, mesh.edges.highs[e], 1)


@kernel
def sort_vertices_kernel(ends: array(dtype=int32), fixed: array(dtype=uint8), kinds: array(dtype=uint8)):
    i = tid()
    kind = int(CORNER_VERTEX)
    if ends[i] == 0:
        kind = FREE_VERTEX
    if ends[i] == 2:
        kind = LINE_VERTEX
    if fixed[i] != 0:
        kind = CORNER_VERTEX
    kinds[i] = uint8(kind)


@kernel
def find_creases_kernel(
    vertices: array(dtype=vec3),
    triangles: array(dtype=vec3i),
    edges: MeshEdges,
    cosine: float64,
    creases: array(dtype=uint8),
):
    """1 for both half-edges of an edge with a dihedral angle above the limit."""
    e = tid()
    if is_paired(triangles, edges, e) == 1:
        g = edges.half_edges[edges.starts[e]]
        h = edges.half_edges[edges.starts[e] + 1]
        n = triangle_cross(vertices, triangles[g // 3])
        m = triangle_cross(vertices, triangles[h // 3])
        size = length(n) * length(m)
        if size > 0.0 and dot(n, m) < cosine * size:
            creases[g] = uint8(1)
            creases[h] = uint8(1)


@func
def line_neighbor(mesh: CreasedMesh, v: int, other: int) -> int:
    """A vertex other than `other` across a crease at v, the first by corners, or -1."""
    neighbor = -1
    for j in range(mesh.around.starts[v], mesh.around.starts[v + 1]):
        c = mesh.around.corners[j]
        d = last_corner(c)
        if mesh.creases[c] != 0 and neighbor < 0:
            u = corner_vertex(mesh.triangles, next_corner(c))
            if u != other:
                neighbor = u
        if mesh.creases[d] != 0 and neighbor < 0:
            u = corner_vertex(mesh.triangles, d)
            if u != other:
                neighbor = u
    return neighbor


@kernel
def fix_bends_kernel(mesh: CreasedMesh, cosine: float64, fixed: array(dtype=uint8)):
    """1 for corners, and where a line bends by more than the angle."""
    i = tid()
    kind = int(mesh.kinds[i])
    value = 0
    if kind == CORNER_VERTEX:
        value = 1
    if kind == LINE_VERTEX:
        u = line_neighbor(mesh, i, -1)
        w = line_neighbor(mesh, i, u)
        if u >= 0 and w >= 0:
            p = widen(mesh.vertices[i])
            a = p - widen(mesh.vertices[u])
            b = widen(mesh.vertices[w]) - p
            size = length(a) * length(b)
            if size > 0.0 and dot(a, b) < cosine * size:
                value = 1
    fixed[i] = uint8(value)


@kernel
def drop_creases_kernel(
    mesh: CreasedMesh, sets: array(dtype=int32), chosen: array(dtype=uint8), creases: array(dtype=uint8)
):
    h = tid()
    if chosen[sets[corner_vertex(mesh.triangles, h)]] == 0:
        creases[h] = uint8(0)


@func
def is_crease(mesh: CreasedMesh, e: int) -> int:
    flag = 0
    if is_edge(mesh.edges, e) == 1:
        flag = int(mesh.creases[mesh.edges.half_edges[mesh.edges.starts[e]]])
    return flag


@kernel
def unite_creases_kernel(mesh: CreasedMesh, sets: array(dtype=int32)):
    e = tid()
    if is_crease(mesh, e) == 1:
        unite(sets, mesh.edges.lows[e], mesh.edges.highs[e])


@kernel
def stretch_sets_kernel(mesh: CreasedMesh, sets: array(dtype=int32), extents: array(dtype=float32, ndim=2)):
    """Bounding box of each set. Maxima do not depend on the order."""
    e = tid()
    if is_crease(mesh, e) == 0:
        return
    a = mesh.edges.lows[e]
    b = mesh.edges.highs[e]
    root = sets[a]
    for c in range(3):
        p = mesh.vertices[a]
        q = mesh.vertices[b]
        atomic_max(extents, root, c, max(p[c], q[c]))
        atomic_max(extents, root, c + 3, max(-p[c], -q[c]))


@kernel
def choose_large_kernel(extents: array(dtype=float32, ndim=2), min_size: float64, chosen: array(dtype=uint8)):
    i = tid()
    x = float64(extents[i, 0]) + float64(extents[i, 3])
    y = float64(extents[i, 1]) + float64(extents[i, 4])
    z = float64(extents[i, 2]) + float64(extents[i, 5])
    d = vec3d(x, y, z)
    chosen[i] = uint8(1 if dot(d, d) >= min_size * min_size else 0)


def drop_short_creases(mesh: CreasedMesh, min_size: float) -> Bytes:
    """Creases without connected sets smaller than `min_size`. Boundaries are found again."""
    device, count = mesh.vertices.device, mesh.vertices.size
    sets = positions(count, device)
    launch(unite_creases_kernel, mesh.edges.count, [mesh, sets])
    launch(flatten_sets_kernel, count, [sets])
    extents, chosen = full((count, 6), -math.inf, float32, device), empty(count, uint8, device)
    launch(stretch_sets_kernel, mesh.edges.count, [mesh, sets, extents])
    launch(choose_large_kernel, count, [extents, min_size, chosen])
    launch(drop_creases_kernel, mesh.creases.size, [mesh, sets, chosen, mesh.creases])
    return mesh.creases


def find_features(vertices: Points, triangles: Triangles, angle: float, min_size: float) -> tuple[Bytes, Bytes]:
    """(creases, fixed): `angle` limits dihedral and line angles [rad], `min_size` the size of connected creases."""
    device = vertices.device
    creases, cosine = zeros(3 * triangles.size, uint8, device), math.cos(angle)
    edges = MeshEdges(triangles, vertices.size, padded=True)
    launch(find_creases_kernel, edges.count, [vertices, triangles, edges, cosine, creases])
    free = zeros(vertices.size, uint8, device)
    creases = drop_short_creases(CreasedMesh(vertices, triangles, creases, free), min_size)
    mesh = CreasedMesh(vertices, triangles, creases, free)
    fixed = compute(fix_bends_kernel, vertices.size, [mesh, cosine], uint8, device)
    return mesh.creases, fixed


@kernel
def mark_creased_kernel(mesh: CreasedMesh, mask: array(dtype=uint8)):
    e = tid()
    mask[e] = uint8(is_crease(mesh, e))


@kernel
def list_segments_kernel(mesh: CreasedMesh, rows: array(dtype=int32), segments: array(dtype=vec3i)):
    i = tid()
    a = mesh.edges.lows[rows[i]]
    b = mesh.edges.highs[rows[i]]
    segments[i] = vec3i(a, b, b)


def crease_rows(mesh: CreasedMesh) -> Indices:
    """Crease edges, int32. One sync."""
    mask = compute(mark_creased_kernel, mesh.edges.count, [mesh], uint8, mesh.vertices.device)
    return positions_of(mask)


def crease_segments(mesh: CreasedMesh) -> Triangles:
    """Creases as degenerate triangles, vec3i, for nearest points by a TriangleTree."""
    rows = crease_rows(mesh)  # sync
    return compute(list_segments_kernel, rows.size, [mesh, rows], vec3i, mesh.vertices.device)


@kernel
def end_rounds_kernel(
    summary: array(dtype=int32),
    removed_edge: int64,
    few: float64,
    changed: array(dtype=int32),
    rounds: array(dtype=int32),
):
    """Count a round, and end if it changed few edges. One thread. `rounds` is (1 if ended, count)."""
    i = tid()
    if rounds[i] == 0:
        edges = summary[0]
        if (int64(summary[2]) << 32) | (int64(summary[1]) & 0xFFFFFFFF) == removed_edge:
            edges -= 1
        rounds[i + 1] = rounds[i + 1] + 1
        if float64(changed[0]) <= few * float64(edges):
            rounds[i] = 1


def end_rounds(made: CreasedMesh, changed: Integers, few: float, rounds: Integers) -> None:
    """End the rounds on CUDA if at most the fraction `few` of edges changed. `rounds`: int32 (1 if ended, count)."""
    launch(end_rounds_kernel, 1, [made.edges.summary, made.removed_edge, few, changed, rounds])


def after_round(
    mesh: CreasedMesh, made: CreasedMesh, count: Integers, few: float, rounds: Integers | None
) -> tuple[CreasedMesh, int | None]:
    """(New mesh, or the old one if unchanged; number of changed edges, None with `rounds`, which avoids a sync)."""
    if rounds is not None:
        end_rounds(made, count, few, rounds)
        return made, None
    changed = int(made.count_edges(count)[0][0])  # sync
    return (made, changed) if changed else (mesh, 0)
