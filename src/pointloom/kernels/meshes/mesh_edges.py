"""Unique edges of a mesh with their half-edges, and fans at vertices.

Edges are runs of equal keys among sorted half-edges (mesh_topology.py), ordered by their two vertices. A half-edge from
a vertex to itself is an edge, as in Open3D. 50 B per half-edge while sorting, 20 B after.
"""

from ..array_types import Array1, Indices, Integers, LongIntegers, Mask, Triangles
from ..arrays.pair_sort import argsort_pairs
from ..arrays.select import invert_mask
from ..arrays.sort import positions
from ..arrays.union_find import flatten_sets_kernel, unite
from ..arrays.unique import UniqueKeys
from ..lang import array, compute, func, int32, int64, kernel, launch, struct, tid, uint8, vec2i, vec3i
from ..memory import empty, rows_of
from .mesh_topology import CornersByVertex, corner_vertex, list_edge_keys_kernel, next_corner


@func
def lower_end(key: int64, bits: int) -> int:
    return int(key >> int64(bits))


@func
def higher_end(key: int64, bits: int) -> int:
    return int(key & ((1 << int64(bits)) - 1))


@func
def edge_key(a: int, b: int, bits: int) -> int64:
    return (int64(min(a, b)) << int64(bits)) | int64(max(a, b))


@func
def find_edge(key: int64, keys: array(dtype=int64)) -> int:
    """Index of an edge among ascending keys by bisection, or -1."""
    low = 0
    high = keys.shape[0]
    while low < high:
        middle = low + (high - low) // 2
        if keys[middle] < key:
            low = middle + 1
        else:
            high = middle
    index = -1
    if low < keys.shape[0]:
        if keys[low] == key:
            index = low
    return index


def key_bits(vertex_count: int) -> int:
    return max(1, vertex_count.bit_length())


SortedEdges = tuple[LongIntegers, Indices]


def sorted_edges(triangles: Triangles, vertex_count: int) -> SortedEdges:
    """(keys, half-edges) of the triangles, sorted by edge, ascending within an edge."""
    keys, bits = empty(3 * triangles.size, int64, triangles.device), key_bits(vertex_count)
    launch(list_edge_keys_kernel, triangles.size, [triangles, bits, keys])
    return argsort_pairs(keys, bits, vertex_count)


def find_edges(
    triangles: Triangles, vertex_count: int, padded: bool = False, in_order: SortedEdges | None = None
) -> UniqueKeys:
    """Edges as UniqueKeys of half-edges. One sync, none if padded. `in_order`: known result of `sorted_edges`."""
    keys, order = in_order or sorted_edges(triangles, vertex_count)
    return UniqueKeys(keys, 2 * key_bits(vertex_count), (keys, order), padded=padded)


@kernel
def split_edge_keys_kernel(keys: array(dtype=int64), bits: int, lows: array(dtype=int32), highs: array(dtype=int32)):
    i = tid()
    lows[i] = lower_end(keys[i], bits)
    highs[i] = higher_end(keys[i], bits)


@kernel
def split_padded_keys_kernel(edges: UniqueKeys, bits: int, lows: array(dtype=int32), highs: array(dtype=int32)):
    """Both vertices of each edge. Vertex 0 twice beyond the last one."""
    i = tid()
    a = 0
    b = 0
    if edges.starts[i + 1] > edges.starts[i]:
        a = lower_end(edges.keys[i], bits)
        b = higher_end(edges.keys[i], bits)
    lows[i] = a
    highs[i] = b


@struct
class MeshEdges:
    """Edges of a mesh by ascending vertices `lows`, `highs`. Half-edge 3 t + k runs from corner k of triangle t to the
    next. `starts` index the ascending `half_edges` of each edge. If padded (`summary` as in UniqueKeys), edges beyond
    the last have no half-edges and vertex 0 twice."""

    lows: array(dtype=int32)
    highs: array(dtype=int32)
    starts: array(dtype=int32)
    half_edges: array(dtype=int32)

    def __init__(
        self, triangles: Triangles, vertex_count: int, padded: bool = False, in_order: SortedEdges | None = None
    ) -> None:
        device, edges = triangles.device, find_edges(triangles, vertex_count, padded, in_order)
        self.count, self.starts, self.half_edges, self.summary = edges.count, edges.starts, edges.order, edges.summary
        self.lows, self.highs = empty(self.count, int32, device), empty(self.count, int32, device)
        bits = key_bits(vertex_count)
        if self.summary is None:
            launch(split_edge_keys_kernel, self.count, [edges.keys, bits, self.lows, self.highs])
        else:
            launch(split_padded_keys_kernel, self.count, [edges, bits, self.lows, self.highs])

    def cut(self, count: int) -> None:
        """Remove the padding beyond `count` edges."""
        self.count, self.summary, self.starts = count, None, rows_of(self.starts, 0, count + 1)
        self.lows, self.highs = rows_of(self.lows, 0, count), rows_of(self.highs, 0, count)


@func
def opposite_vertex(t: vec3i, a: int, b: int) -> int:
    """Vertex of a triangle other than a and b, else its last one."""
    v = t[2]
    if t[1] != a and t[1] != b:
        v = t[1]
    if t[0] != a and t[0] != b:
        v = t[0]
    return v


@kernel
def count_sharers_kernel(edges: MeshEdges, counts: array(dtype=int32)):
    i = tid()
    count = 0
    last = -1
    for j in range(edges.starts[i], edges.starts[i + 1]):
        triangle = edges.half_edges[j] // 3
        if triangle != last:
            count += 1
        last = triangle
    counts[i] = count


def count_sharers(edges: MeshEdges) -> Integers:
    return compute(count_sharers_kernel, edges.count, [edges], int32, edges.lows.device)


@kernel
def list_ends_kernel(keys: array(dtype=int64), rows: array(dtype=int32), bits: int, ends: array(dtype=vec2i)):
    i = tid()
    key = keys[rows[i]]
    ends[i] = vec2i(lower_end(key, bits), higher_end(key, bits))


@kernel
def mask_counts_kernel(starts: array(dtype=int32), min_count: int, max_count: int, mask: array(dtype=uint8)):
    i = tid()
    count = starts[i + 1] - starts[i]
    mask[i] = uint8(1 if count >= min_count and count <= max_count else 0)


def mask_counts(edges: UniqueKeys | MeshEdges, min_count: int, max_count: int) -> Mask:
    return compute(mask_counts_kernel, edges.count, [edges.starts, min_count, max_count], uint8, edges.starts.device)


def mask_other_counts(edges: UniqueKeys | MeshEdges, count: int) -> Mask:
    return invert_mask(mask_counts(edges, count, count))


def edge_ends(edges: UniqueKeys, rows: Indices, vertex_count: int) -> Array1[vec2i]:
    """Vertices of the edges at some rows, vec2i, the lower first."""
    return compute(list_ends_kernel, rows.size, [edges.keys, rows, key_bits(vertex_count)], vec2i, rows.device)


@func
def corner_at(triangles: array(dtype=vec3i), h: int, v: int) -> int:
    corner = next_corner(h)
    if corner_vertex(triangles, h) == v:
        corner = h
    return corner


@kernel
def unite_corners_kernel(
    triangles: array(dtype=vec3i),
    edges: UniqueKeys,
    bits: int,
    edge_of: array(dtype=int32),
    parents: array(dtype=int32),
):
    """Unite corners at both ends of an edge with those of the previous half-edge there."""
    i = tid()
    if i > 0:
        if edge_of[i] == edge_of[i - 1]:
            key = edges.keys[edge_of[i]]
            a = lower_end(key, bits)
            b = higher_end(key, bits)
            h = edges.order[i]
            g = edges.order[i - 1]
            if a != b:
                unite(parents, corner_at(triangles, h, a), corner_at(triangles, g, a))
                unite(parents, corner_at(triangles, h, b), corner_at(triangles, g, b))


@kernel
def spread_runs_kernel(starts: array(dtype=int32), indices: array(dtype=int32)):
    i = tid()
    for j in range(starts[i], starts[i + 1]):
        indices[j] = i


@kernel
def mark_split_vertices_kernel(
    triangles: array(dtype=vec3i), around: CornersByVertex, parents: array(dtype=int32), mask: array(dtype=uint8)
):
    """1 if the triangles at a vertex form several fans; those that use the vertex twice are ignored."""
    i = tid()
    fan = -1
    split = 0
    for j in range(around.starts[i], around.starts[i + 1]):
        t = triangles[around.corners[j] // 3]
        times = 0
        for k in range(3):
            if t[k] == i:
                times += 1
        if times == 1:
            root = parents[around.corners[j]]
            if fan < 0:
                fan = root
            elif fan != root:
                split = 1
    mask[i] = uint8(split)


def run_indices(groups: UniqueKeys, count: int) -> Indices:
    """Run of each of `count` positions of UniqueKeys, int32."""
    indices = empty(count, int32, groups.starts.device)
    launch(spread_runs_kernel, groups.count, [groups.starts, indices])
    return indices


def find_split_vertices(triangles: Triangles, vertex_count: int) -> Mask:
    """uint8 [m]: 1 if the triangles at a vertex are not all connected by edges at it."""
    device, half_edges = triangles.device, 3 * triangles.size
    edges, parents = find_edges(triangles, vertex_count, padded=True), positions(half_edges, device)
    edge_of = run_indices(edges, half_edges)
    launch(unite_corners_kernel, half_edges, [triangles, edges, key_bits(vertex_count), edge_of, parents])
    launch(flatten_sets_kernel, half_edges, [parents])
    mask = empty(vertex_count, uint8, device)
    around = CornersByVertex(triangles, vertex_count)
    launch(mark_split_vertices_kernel, vertex_count, [triangles, around, parents, mask])
    return mask
