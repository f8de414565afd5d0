"""Seams of a mesh: coincident boundaries, as files split vertices for texture coordinates.

Boundary half-edges with equal end positions unite their vertices, as do the ends of zero-length ones. Interior edges
are ignored. About 50 B per half-edge.
"""

from ..array_types import Indices, Points, Triangles
from ..arrays.duplicates import find_equal_points
from ..arrays.select import positions_of
from ..arrays.sort import positions
from ..arrays.union_find import flatten_sets_kernel, unite
from ..arrays.unique import UniqueKeys
from ..lang import array, int32, int64, kernel, launch, tid, uint8, vec3i
from ..memory import empty
from .mesh_edges import SortedEdges, edge_key, key_bits, sorted_edges
from .mesh_topology import corner_vertex, next_corner


@kernel
def mark_border_kernel(keys: array(dtype=int64), order: array(dtype=int32), mask: array(dtype=uint8)):
    i = tid()
    alone = 1
    if i > 0:
        if keys[i - 1] == keys[i]:
            alone = 0
    if i + 1 < keys.shape[0]:
        if keys[i + 1] == keys[i]:
            alone = 0
    mask[order[i]] = uint8(alone)


@kernel
def list_position_keys_kernel(
    triangles: array(dtype=vec3i),
    owners: array(dtype=int32),
    rows: array(dtype=int32),
    bits: int,
    keys: array(dtype=int64),
):
    i = tid()
    a = owners[corner_vertex(triangles, rows[i])]
    b = owners[corner_vertex(triangles, next_corner(rows[i]))]
    keys[i] = edge_key(a, b, bits)


@kernel
def unite_ends_kernel(
    triangles: array(dtype=vec3i),
    owners: array(dtype=int32),
    rows: array(dtype=int32),
    groups: UniqueKeys,
    parents: array(dtype=int32),
):
    """Unite the vertices at each end of half-edges with the same end positions."""
    i = tid()
    first = groups.starts[i]
    if first == groups.starts[i + 1]:
        return
    h = rows[groups.order[first]]
    a = corner_vertex(triangles, h)
    b = corner_vertex(triangles, next_corner(h))
    if owners[a] == owners[b]:
        unite(parents, a, b)
    for j in range(first + 1, groups.starts[i + 1]):
        g = rows[groups.order[j]]
        c = corner_vertex(triangles, g)
        d = corner_vertex(triangles, next_corner(g))
        if owners[a] == owners[c]:
            unite(parents, a, c)
            unite(parents, b, d)
        else:
            unite(parents, a, d)
            unite(parents, b, c)


def find_seams(vertices: Points, triangles: Triangles, in_order: SortedEdges | None = None) -> Indices | None:
    """Lowest vertex at each surface position, int32 [m]. None without a boundary. `in_order`: known `sorted_edges`."""
    device, count = triangles.device, vertices.size
    border = empty(3 * triangles.size, uint8, device)
    launch(mark_border_kernel, border.size, [*(in_order or sorted_edges(triangles, count)), border])
    rows, bits = positions_of(border), key_bits(count)  # sync
    if not rows.size:
        return None
    owners, keys, parents = find_equal_points(vertices), empty(rows.size, int64, device), positions(count, device)
    launch(list_position_keys_kernel, rows.size, [triangles, owners, rows, bits, keys])
    groups = UniqueKeys(keys, 2 * bits, padded=True)
    launch(unite_ends_kernel, groups.count, [triangles, owners, rows, groups, parents])
    launch(flatten_sets_kernel, count, [parents])
    return parents
