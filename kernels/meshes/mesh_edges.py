"""The edges of a mesh, each with the half-edges that run it, and the neighbours of each vertex along them.

An edge is two vertices, whichever way triangles run it and however many there are. Edges are sorted by their vertices
(one stable sort of 64-bit keys), neighbours of a vertex ascend: all orders are fixed. About 60 B a half-edge.
"""

from ..arrays.sort import argsort_keys
from ..arrays.unique import UniqueKeys
from ..lang import array, func, int32, int64, kernel, launch, struct, tid, vec3i
from ..memory import empty, zeros
from .mesh_topology import find_starts_kernel, list_edge_keys_kernel


@kernel
def split_edge_keys_kernel(keys: array(dtype=int64), bits: int, lows: array(dtype=int32), highs: array(dtype=int32)):
    """The two vertices of each edge."""
    i = tid()
    low = keys[i] >> int64(bits)
    lows[i] = int(low)
    highs[i] = int(keys[i] - (low << int64(bits)))


@struct
class MeshEdges:
    """The edges of a mesh, by ascending vertices. Half-edge 3 t + k runs from corner k of triangle t to the next.

    Attributes:
        count: Edges e.
        lows, highs: Their vertices, int32 [e]; the same one where a triangle has a vertex twice.
        starts: int32 [e + 1], where each edge's half-edges begin in `halves`.
        halves: int32 [3 t], those of an edge ascending.
    """

    lows: array(dtype=int32)
    highs: array(dtype=int32)
    starts: array(dtype=int32)
    halves: array(dtype=int32)

    def __init__(self, triangles, vertex_count):
        device, bits = triangles.device, max(1, vertex_count.bit_length())
        keys = empty(3 * triangles.size, int64, device)
        launch(list_edge_keys_kernel, triangles.size, [triangles, bits, keys])
        edges = UniqueKeys(keys, 2 * bits)  # sync
        self.count, self.starts, self.halves = edges.count, edges.starts, edges.order
        self.lows, self.highs = empty(self.count, int32, device), empty(self.count, int32, device)
        launch(split_edge_keys_kernel, self.count, [edges.keys, bits, self.lows, self.highs])


@kernel
def list_ends_kernel(lows: array(dtype=int32), highs: array(dtype=int32), loop_key: int64, keys: array(dtype=int64)):
    """Each edge's ends, all higher ones before all lower ones; an edge from a vertex to itself goes behind all."""
    i = tid()
    first = int64(highs[i])
    second = int64(lows[i])
    if lows[i] == highs[i]:
        first = loop_key + int64(0)
        second = loop_key + int64(0)
    keys[i] = first
    keys[lows.shape[0] + i] = second


@kernel
def list_neighbors_kernel(
    lows: array(dtype=int32),
    highs: array(dtype=int32),
    order: array(dtype=int32),
    vertices: array(dtype=int32),
    edges: array(dtype=int32),
):
    """The other end of an edge, seen from each of its ends."""
    i = tid()
    count = lows.shape[0]
    edge = order[i] % count
    other = highs[edge]
    if order[i] < count:
        other = lows[edge]
    vertices[i] = other
    edges[i] = edge


@struct
class VertexNeighbors:
    """The neighbours of each vertex along edges, ascending; no vertex is its own.

    Attributes:
        starts: int32 [m + 1], where each vertex' neighbours begin.
        vertices: int32 [2 e].
        edges: int32 [2 e], the edges that lead there.
    """

    starts: array(dtype=int32)
    vertices: array(dtype=int32)
    edges: array(dtype=int32)

    def __init__(self, edges, vertex_count):
        """The neighbours along edges with `lows` and `highs`, which ascend by both; lists nothing twice."""
        device, count = edges.lows.device, 2 * edges.count
        keys = empty(count, int64, device)
        launch(list_ends_kernel, edges.count, [edges.lows, edges.highs, vertex_count, keys])
        keys, order = argsort_keys(keys, max(1, vertex_count.bit_length()))
        self.starts = zeros(vertex_count + 1, int32, device)
        launch(find_starts_kernel, count, [keys, vertex_count, self.starts])
        self.vertices, self.edges = empty(count, int32, device), empty(count, int32, device)
        launch(list_neighbors_kernel, count, [edges.lows, edges.highs, order, self.vertices, self.edges])


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
    count = int(0)
    last = int(-1)
    for j in range(edges.starts[i], edges.starts[i + 1]):
        triangle = edges.halves[j] // 3
        if triangle != last:
            count += 1
        last = triangle
    counts[i] = count


def count_sharers(edges):
    """How many triangles each edge has, int32 [e]."""
    counts = empty(edges.count, int32, edges.lows.device)
    launch(count_sharers_kernel, edges.count, [edges, counts])
    return counts
