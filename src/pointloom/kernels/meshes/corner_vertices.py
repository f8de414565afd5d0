"""New vertices from sets of corners. Each takes the row of its lowest earlier vertex.

The first set at a vertex keeps its index. Further sets are appended by their lowest corners. About 20 B per corner.
"""

from ..array_types import Indices, Integers, Triangles
from ..arrays.prefix_sum import exclusive_scan, scan_together
from ..arrays.select import positions_of
from ..arrays.sort import positions
from ..arrays.union_find import flatten_sets_kernel
from ..arrays.unique import UniqueKeys
from ..lang import array, atomic_min, func, int32, kernel, launch, tid, uint8, vec3i
from ..memory import empty, full, zeros
from .mesh_edges import find_edges, key_bits, run_indices, unite_corners_kernel
from .mesh_edits import find_first_positions_kernel, mask_and_index
from .mesh_topology import CornersByVertex, corner_vertex

NO_CORNER = 2**31 - 1  # above all vertices and corners


@kernel
def find_lowest_vertices_kernel(triangles: array(dtype=vec3i), sets: array(dtype=int32), lowest: array(dtype=int32)):
    """Lowest vertex of each set, at its lowest corner. The minimum does not depend on the order."""
    i = tid()
    atomic_min(lowest, sets[i], corner_vertex(triangles, i))


@kernel
def find_first_sets_kernel(sets: array(dtype=int32), lowest: array(dtype=int32), firsts: array(dtype=int32)):
    """Lowest set at each vertex. The minimum does not depend on the order."""
    i = tid()
    if sets[i] == i:
        atomic_min(firsts, lowest[i], i)


@kernel
def mark_first_sets_kernel(firsts: array(dtype=int32), used: array(dtype=int32)):
    i = tid()
    used[i] = 1 if firsts[i] != NO_CORNER else 0


@kernel
def mark_further_sets_kernel(
    sets: array(dtype=int32), lowest: array(dtype=int32), firsts: array(dtype=int32), further: array(dtype=int32)
):
    i = tid()
    mark = 0
    if sets[i] == i:
        if firsts[lowest[i]] != i:
            mark = 1
    further[i] = mark


@kernel
def write_rows_kernel(
    sets: array(dtype=int32),
    lowest: array(dtype=int32),
    firsts: array(dtype=int32),
    indices: array(dtype=int32),
    kept_count: int,
    further: array(dtype=int32),
    numbers: array(dtype=int32),
    rows: array(dtype=int32),
):
    """New index of each set, at its lowest corner, and the earlier vertex that provides its row."""
    i = tid()
    if sets[i] == i:
        v = lowest[i]
        number = indices[v]
        if firsts[v] != i:
            number = kept_count + further[i]
        numbers[i] = number
        rows[number] = v


@kernel
def name_corners_kernel(sets: array(dtype=int32), numbers: array(dtype=int32), named: array(dtype=vec3i)):
    i = tid()
    named[i] = vec3i(numbers[sets[3 * i]], numbers[sets[3 * i + 1]], numbers[sets[3 * i + 2]])


class CornerVertices:
    """Vertices from sets of corners, by lowest corner. `rows`: earlier vertices. The first `kept_count` start sets."""

    def __init__(self, triangles: Triangles, vertex_count: int, sets: Indices) -> None:
        device, corners = triangles.device, sets.size
        lowest, firsts = full(corners, NO_CORNER, int32, device), full(vertex_count, NO_CORNER, int32, device)
        launch(find_lowest_vertices_kernel, corners, [triangles, sets, lowest])
        launch(find_first_sets_kernel, corners, [sets, lowest, firsts])
        used, further = empty(vertex_count, int32, device), empty(corners, int32, device)
        launch(mark_first_sets_kernel, vertex_count, [firsts, used])
        launch(mark_further_sets_kernel, corners, [sets, lowest, firsts, further])
        parts = [(used, [vertex_count]), (further, [corners])]
        (indices, (self.kept_count,)), (further_rows, (count,)) = scan_together(parts, largest=1)  # sync
        numbers, self.rows = zeros(corners, int32, device), empty(self.kept_count + count, int32, device)
        launch(
            write_rows_kernel,
            corners,
            [sets, lowest, firsts, indices, self.kept_count, further_rows, numbers, self.rows],
        )
        self.triangles = empty(triangles.size, vec3i, device)
        launch(name_corners_kernel, triangles.size, [sets, numbers, self.triangles])


@kernel
def keep_corners_kernel(
    corners: array(dtype=int32), rows: array(dtype=int32), indices: array(dtype=int32), renumbered: array(dtype=int32)
):
    i = tid()
    corner = corners[3 * rows[i // 3] + i % 3]
    new = -1
    if corner >= 0:
        new = 3 * indices[corner // 3] + corner % 3
    renumbered[i] = new


def keep_corners(corners: Indices, rows: Indices) -> Integers:
    """Renumber corner references of the triangles at ascending rows: corners of these triangles, or -1."""
    renumbered = empty(3 * rows.size, int32, corners.device)
    _, indices = mask_and_index(rows, corners.size // 3)
    launch(keep_corners_kernel, renumbered.size, [corners, rows, indices, renumbered])
    return renumbered


@kernel
def mark_doubled_kernel(edges: UniqueKeys, twins: array(dtype=int32), mask: array(dtype=uint8)):
    """1 for half-edges that are neither the first of their two vertices nor its opposite."""
    i = tid()
    first = -1
    for j in range(edges.starts[i], edges.starts[i + 1]):
        h = edges.order[j]
        if first < 0:
            first = h
        mask[h] = uint8(1 if h != first and twins[first] != h else 0)


def find_doubled_edges(triangles: Triangles, vertex_count: int, twins: Indices) -> Indices:
    """Ascending half-edges that share both vertices with an earlier one that is not their opposite."""
    mask, edges = empty(twins.size, uint8, twins.device), find_edges(triangles, vertex_count, padded=True)
    launch(mark_doubled_kernel, edges.count, [edges, twins, mask])
    return positions_of(mask)  # sync


@func
def times_named(t: vec3i, v: int) -> int:
    times = 0
    for k in range(3):
        if t[k] == v:
            times += 1
    return times


@kernel
def drop_folded_corners_kernel(triangles: array(dtype=vec3i), around: CornersByVertex, fans: array(dtype=int32)):
    """Merge corners of triangles that use their vertex twice with the first fan there."""
    i = tid()
    first = NO_CORNER
    for j in range(around.starts[i], around.starts[i + 1]):
        corner = around.corners[j]
        if times_named(triangles[corner // 3], i) == 1:
            first = min(first, fans[corner])
    for j in range(around.starts[i], around.starts[i + 1]):
        corner = around.corners[j]
        if times_named(triangles[corner // 3], i) > 1:
            if first == NO_CORNER:
                first = corner
            fans[corner] = first


@kernel
def name_fans_kernel(lowest: array(dtype=int32), fans: array(dtype=int32)):
    i = tid()
    fans[i] = lowest[fans[i]]


@kernel
def take_fans_kernel(
    triangles: array(dtype=vec3i),
    fans: array(dtype=int32),
    firsts: array(dtype=int32),
    numbers: array(dtype=int32),
    vertex_count: int,
    split: array(dtype=vec3i),
):
    i = tid()
    t = triangles[i]
    for k in range(3):
        fan = fans[3 * i + k]
        if firsts[t[k]] != fan:
            t[k] = vertex_count + numbers[fan]
    split[i] = t


@kernel
def find_first_fans_kernel(triangles: array(dtype=vec3i), fans: array(dtype=int32), firsts: array(dtype=int32)):
    """Fan with the lowest corner at each vertex. The minimum does not depend on the order."""
    i = tid()
    atomic_min(firsts, corner_vertex(triangles, i), fans[i])


@kernel
def mark_further_fans_kernel(
    triangles: array(dtype=vec3i), fans: array(dtype=int32), firsts: array(dtype=int32), further: array(dtype=int32)
):
    i = tid()
    v = corner_vertex(triangles, i)
    further[i] = 1 if fans[i] == i and firsts[v] != i else 0


@kernel
def list_fan_rows_kernel(
    triangles: array(dtype=vec3i),
    further: array(dtype=int32),
    numbers: array(dtype=int32),
    vertex_count: int,
    rows: array(dtype=int32),
):
    i = tid()
    if i < vertex_count:
        rows[i] = i
    else:
        corner = i - vertex_count
        if further[corner] == 1:
            rows[vertex_count + numbers[corner]] = corner_vertex(triangles, corner)


def split_fans(triangles: Triangles, vertex_count: int) -> tuple[Triangles, Indices]:
    """Give each fan of edge-connected triangles its own vertex. Returns (triangles, earlier vertex of each)."""
    device, corners = triangles.device, 3 * triangles.size
    edges, fans = find_edges(triangles, vertex_count, padded=True), positions(corners, device)
    edge_of = run_indices(edges, corners)
    launch(unite_corners_kernel, corners, [triangles, edges, key_bits(vertex_count), edge_of, fans])
    launch(flatten_sets_kernel, corners, [fans])
    launch(drop_folded_corners_kernel, vertex_count, [triangles, CornersByVertex(triangles, vertex_count), fans])
    lowest = full(corners, NO_CORNER, int32, device)
    launch(find_first_positions_kernel, corners, [fans, lowest])
    launch(name_fans_kernel, corners, [lowest, fans])
    firsts, further = full(vertex_count, NO_CORNER, int32, device), empty(corners, int32, device)
    launch(find_first_fans_kernel, corners, [triangles, fans, firsts])
    launch(mark_further_fans_kernel, corners, [triangles, fans, firsts, further])
    numbers, count = exclusive_scan(further, largest=1)  # sync
    rows, split = empty(vertex_count + count, int32, device), empty(triangles.size, vec3i, device)
    launch(list_fan_rows_kernel, vertex_count + corners, [triangles, further, numbers, vertex_count, rows])
    launch(take_fans_kernel, triangles.size, [triangles, fans, firsts, numbers, vertex_count, split])
    return split, rows
