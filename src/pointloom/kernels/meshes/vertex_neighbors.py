"""Sorted unique neighbors of each vertex along edges. About 30 B per edge."""

from typing import Protocol

from ..array_types import Indices
from ..arrays.pair_sort import argsort_pairs
from ..lang import array, int32, int64, kernel, launch, struct, tid
from ..memory import empty, zeros
from .mesh_topology import find_starts_kernel


class Edges(Protocol):
    """MeshEdges or an object with the same attributes: ascending vertices `lows` and `highs`, int32 [e]."""

    count: int
    lows: Indices
    highs: Indices


@kernel
def list_ends_kernel(lows: array(dtype=int32), highs: array(dtype=int32), loop_key: int64, keys: array(dtype=int64)):
    """Ends of each edge, all higher ones before all lower ones; self-loops go last."""
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
    """Ascending neighbors of each vertex: starts int32 [m + 1], vertices and edges that lead there int32 [2 e]."""

    starts: array(dtype=int32)
    vertices: array(dtype=int32)
    edges: array(dtype=int32)

    def __init__(self, edges: Edges, vertex_count: int) -> None:
        device, count = edges.lows.device, 2 * edges.count
        keys = empty(count, int64, device)
        launch(list_ends_kernel, edges.count, [edges.lows, edges.highs, vertex_count, keys])
        keys, order = argsort_pairs(keys, 0, vertex_count + 1)
        self.starts = zeros(vertex_count + 1, int32, device)
        launch(find_starts_kernel, count, [keys, vertex_count, self.starts])
        self.vertices, self.edges = empty(count, int32, device), empty(count, int32, device)
        launch(list_neighbors_kernel, count, [edges.lows, edges.highs, order, self.vertices, self.edges])
