"""The edges of a mesh: each once, with its half-edges; the fans at a vertex.

Edges are runs of equal keys among the sorted half-edges (mesh_topology.py), the lower vertex above the higher one, so
they come in the order of their two numbers. A half-edge from a vertex to itself, which a triangle has that names it
twice, is an edge of its own here, as Open3D counts it. About 50 B a half-edge while they are sorted, 20 B after.
"""

from ..array_types import Array1, Indices, Integers, LongIntegers, Mask, Triangles
from ..arrays.pair_sort import argsort_pairs
from ..arrays.select import invert_mask
from ..arrays.sort import positions
from ..arrays.union_find import flatten_sets_kernel, unite
from ..arrays.unique import UniqueKeys
from ..lang import array, func, int32, int64, kernel, launch, struct, tid, uint8, vec2i, vec3i
from ..memory import empty, rows_of
from .mesh_topology import CornersByVertex, corner_vertex, list_edge_keys_kernel, next_corner


@func
def lower_end(key: int64, bits: int) -> int:
    """The vertex of an edge with the lower number."""
    return int(key >> int64(bits))


@func
def higher_end(key: int64, bits: int) -> int:
    """The other one."""
    return int(key & ((1 << int64(bits)) - 1))


@func
def edge_key(a: int, b: int, bits: int) -> int64:
    """The key of the edge between two vertices."""
    return (int64(min(a, b)) << int64(bits)) | int64(max(a, b))


@func
def find_edge(key: int64, keys: array(dtype=int64)) -> int:
    """The place of an edge among ascending keys, -1 where there is none; by bisection."""
    low = 0
    high = keys.shape[0]
    while low < high:
        middle = low + (high - low) // 2
        if keys[middle] < key:
            low = middle + 1
        else:
            high = middle
    found = -1
    if low < keys.shape[0]:
        if keys[low] == key:
            found = low
    return found


def key_bits(vertex_count: int) -> int:
    """Bits of a vertex' number in the key of an edge."""
    return max(1, vertex_count.bit_length())


def sorted_edges(triangles: Triangles, vertex_count: int) -> tuple[LongIntegers, Indices]:
    """(keys, half-edges) of vec3i [t] triangles, sorted by the keys of their edges; of one edge ascending."""
    keys, bits = empty(3 * triangles.size, int64, triangles.device), key_bits(vertex_count)
    launch(list_edge_keys_kernel, triangles.size, [triangles, bits, keys])
    return argsort_pairs(keys, bits, vertex_count)


def find_edges(triangles: Triangles, vertex_count: int, padded: bool = False) -> UniqueKeys:
    """The edges of vec3i [t] triangles as UniqueKeys of half-edges; one sync, none where they may be padded."""
    keys, order = sorted_edges(triangles, vertex_count)
    return UniqueKeys(keys, 2 * key_bits(vertex_count), (keys, order), padded=padded)


@kernel
def split_edge_keys_kernel(keys: array(dtype=int64), bits: int, lows: array(dtype=int32), highs: array(dtype=int32)):
    """The two vertices of each edge."""
    i = tid()
    lows[i] = lower_end(keys[i], bits)
    highs[i] = higher_end(keys[i], bits)


@kernel
def split_padded_keys_kernel(edges: UniqueKeys, bits: int, lows: array(dtype=int32), highs: array(dtype=int32)):
    """The two vertices of each edge, vertex 0 twice for those behind the last one."""
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
    """The edges of a mesh, by ascending vertices. Half-edge 3 t + k runs from corner k of triangle t to the next.

    Attributes:
        count: Edges e.
        lows, highs: Their vertices, int32 [e]; the same one where a triangle has a vertex twice.
        starts: int32 [e + 1], where each edge's half-edges begin in `halves`.
        halves: int32 [3 t], those of an edge ascending.
        told: Where they are padded, as of UniqueKeys; behind the edges stand some of no half-edges, at vertex 0 twice.
    """

    lows: array(dtype=int32)
    highs: array(dtype=int32)
    starts: array(dtype=int32)
    halves: array(dtype=int32)

    def __init__(self, triangles: Triangles, vertex_count: int, padded: bool = False) -> None:
        """One sync, none where they may be padded."""
        device, edges = triangles.device, find_edges(triangles, vertex_count, padded)
        self.count, self.starts, self.halves, self.told = edges.count, edges.starts, edges.order, edges.told
        self.lows, self.highs = empty(self.count, int32, device), empty(self.count, int32, device)
        bits = key_bits(vertex_count)
        if self.told is None:
            launch(split_edge_keys_kernel, self.count, [edges.keys, bits, self.lows, self.highs])
        else:
            launch(split_padded_keys_kernel, self.count, [edges, bits, self.lows, self.highs])

    def cut(self, count: int) -> None:
        """No longer padded: so many stay, with their half-edges."""
        self.count, self.told, self.starts = count, None, rows_of(self.starts, 0, count + 1)
        self.lows, self.highs = rows_of(self.lows, 0, count), rows_of(self.highs, 0, count)


@func
def opposite_vertex(t: vec3i, a: int, b: int) -> int:
    """The vertex of a triangle that is neither a nor b; its last one where there is none."""
    v = t[2]
    if t[1] != a and t[1] != b:
        v = t[1]
    if t[0] != a and t[0] != b:
        v = t[0]
    return v


@kernel
def count_sharers_kernel(edges: MeshEdges, counts: array(dtype=int32)):
    """How many triangles each edge has; one that runs it twice counts once."""
    i = tid()
    count = 0
    last = -1
    for j in range(edges.starts[i], edges.starts[i + 1]):
        triangle = edges.halves[j] // 3
        if triangle != last:
            count += 1
        last = triangle
    counts[i] = count


def count_sharers(edges: MeshEdges) -> Integers:
    """How many triangles each edge has, int32 [e]."""
    counts = empty(edges.count, int32, edges.lows.device)
    launch(count_sharers_kernel, edges.count, [edges, counts])
    return counts


@kernel
def list_ends_kernel(keys: array(dtype=int64), rows: array(dtype=int32), bits: int, ends: array(dtype=vec2i)):
    """The two vertices of some edges."""
    i = tid()
    key = keys[rows[i]]
    ends[i] = vec2i(lower_end(key, bits), higher_end(key, bits))


@kernel
def mask_counts_kernel(starts: array(dtype=int32), least: int, most: int, mask: array(dtype=uint8)):
    """1 for the edges of at least and at most so many half-edges."""
    i = tid()
    count = starts[i + 1] - starts[i]
    mask[i] = uint8(1 if count >= least and count <= most else 0)


def mask_counts(edges: UniqueKeys | MeshEdges, least: int, most: int) -> Mask:
    """uint8 [e]: 1 for the edges of `least` to `most` half-edges."""
    mask = empty(edges.count, uint8, edges.starts.device)
    launch(mask_counts_kernel, edges.count, [edges.starts, least, most, mask])
    return mask


def mask_other_counts(edges: UniqueKeys | MeshEdges, count: int) -> Mask:
    """uint8 [e]: 1 for the edges of more or fewer half-edges."""
    return invert_mask(mask_counts(edges, count, count))


def edge_ends(edges: UniqueKeys, rows: Indices, vertex_count: int) -> Array1[vec2i]:
    """The vertices of the edges at some rows, vec2i, the lower number first."""
    ends = empty(rows.size, vec2i, rows.device)
    launch(list_ends_kernel, rows.size, [edges.keys, rows, key_bits(vertex_count), ends])
    return ends


# ------------------------------------------------------------------------------------------------ fans at vertices


@func
def corner_at(triangles: array(dtype=vec3i), h: int, v: int) -> int:
    """The corner of a half-edge's triangle at the end v of the half-edge."""
    corner = next_corner(h)
    if corner_vertex(triangles, h) == v:
        corner = h
    return corner


@kernel
def unite_corners_kernel(
    triangles: array(dtype=vec3i), edges: UniqueKeys, bits: int, places: array(dtype=int32), parents: array(dtype=int32)
):
    """Make one set of the corners at either end of an edge; one thread a half-edge, with the one before it."""
    i = tid()
    if i > 0:
        if places[i] == places[i - 1]:
            key = edges.keys[places[i]]
            a = lower_end(key, bits)
            b = higher_end(key, bits)
            h = edges.order[i]
            g = edges.order[i - 1]
            if a != b:
                unite(parents, corner_at(triangles, h, a), corner_at(triangles, g, a))
                unite(parents, corner_at(triangles, h, b), corner_at(triangles, g, b))


@kernel
def spread_runs_kernel(starts: array(dtype=int32), places: array(dtype=int32)):
    """The run of each place; one thread a run."""
    i = tid()
    for j in range(starts[i], starts[i + 1]):
        places[j] = i


@kernel
def mark_split_vertices_kernel(
    triangles: array(dtype=vec3i), around: CornersByVertex, parents: array(dtype=int32), mask: array(dtype=uint8)
):
    """1 where the triangles at a vertex are more than one fan; those that name the vertex twice count for none."""
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


def run_places(groups: UniqueKeys, count: int) -> Indices:
    """The run of each of `count` places of UniqueKeys, int32."""
    places = empty(count, int32, groups.starts.device)
    launch(spread_runs_kernel, groups.count, [groups.starts, places])
    return places


def find_split_vertices(triangles: Triangles, vertex_count: int) -> Mask:
    """uint8 [m]: 1 where the triangles at a vertex hang together by it alone, and not by edges at it."""
    device, half_edges = triangles.device, 3 * triangles.size
    edges, parents = find_edges(triangles, vertex_count, padded=True), positions(half_edges, device)
    places = run_places(edges, half_edges)
    launch(unite_corners_kernel, half_edges, [triangles, edges, key_bits(vertex_count), places, parents])
    launch(flatten_sets_kernel, half_edges, [parents])
    mask = empty(vertex_count, uint8, device)
    around = CornersByVertex(triangles, vertex_count)
    launch(mark_split_vertices_kernel, vertex_count, [triangles, around, parents, mask])
    return mask
