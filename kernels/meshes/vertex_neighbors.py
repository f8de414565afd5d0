"""The neighbours of each vertex of a mesh along its edges, each once and ascending. About 30 B an edge."""

from typing import Protocol

from ..array_types import Indices
from ..arrays.pair_sort import argsort_pairs
from ..lang import array, int32, int64, kernel, launch, struct, tid
from ..memory import empty, zeros
from .mesh_topology import find_starts_kernel


class Edges(Protocol):
    """MeshEdges, or others with these attributes.

    Attributes:
        count: How many e.
        lows, highs: Their vertices, int32 [e], ascending by both.
    """

    count: int
    lows: Indices
    highs: Indices


@kernel
def list_ends_kernel(lows: array(dtype=int32), highs: array(dtype=int32), loop_key: int64, keys: array(dtype=int64)):
    """Each edge's ends, all higher ones before all lower ones; an edge from a vertex to itself goes behind all."""
    i = tid()
    first = int64(highs[i])
    second = int64(lows[i])
    if lows[i] == highs[i]:
        first = loop_key
        second = loop_key
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

    def __init__(self, edges: Edges, vertex_count: int) -> None:
        """The neighbours along edges."""
        device, count = edges.lows.device, 2 * edges.count
        keys = empty(count, int64, device)
        launch(list_ends_kernel, edges.count, [edges.lows, edges.highs, vertex_count, keys])
        keys, order = argsort_pairs(keys, 0, vertex_count + 1)
        self.starts = zeros(vertex_count + 1, int32, device)
        launch(find_starts_kernel, count, [keys, vertex_count, self.starts])
        self.vertices, self.edges = empty(count, int32, device), empty(count, int32, device)
        launch(list_neighbors_kernel, count, [edges.lows, edges.highs, order, self.vertices, self.edges])
