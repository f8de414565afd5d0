"""Midpoint and Loop subdivision: each triangle becomes four.

Loop, "Smooth subdivision surfaces based on triangles", master's thesis, University of Utah 1987, with Warren's weights.
Boundary edges after Hoppe et al., "Piecewise smooth surface reconstruction", SIGGRAPH 1994. Non-manifold edges and
vertex order (by first half-edge) as in Open3D. Values are float64 between rounds, with sums in fixed orders. About 150
B per triangle.
"""

from collections.abc import Sequence

from ..array_types import Array1, Integers, Positions, Triangles
from ..arrays.prefix_sum import offsets_of
from ..lang import array, compute, float64, int32, kernel, launch, struct, tid, vec2, vec3d, vec3i
from ..memory import empty, full, zeros
from ..meshes.mesh_edges import MeshEdges, SortedEdges, count_sharers, opposite_vertex
from ..meshes.mixed_rows import MixedRows, with_vertices_on_edges
from ..meshes.vertex_neighbors import VertexNeighbors

# half-edges that one CPU thread numbers faster than two: 60 us less of 290 for 13,812 (2026-11-28)
MAX_SERIAL_HALF_EDGES = 1 << 14

# half-edges that one CPU thread numbers faster than two: 60 us less of 290 for 13,812 (2026-11-28)
MAX_SERIAL_HALF_EDGES = 1 << 14


@kernel
def mark_first_half_edges_kernel(edges: MeshEdges, firsts: array(dtype=int32)):
    i = tid()
    firsts[edges.half_edges[edges.starts[i]]] = 1


@kernel
def number_edges_kernel(
    edges: MeshEdges, offsets: array(dtype=int32), base: int, numbers: array(dtype=int32), middles: array(dtype=int32)
):
    i = tid()
    number = base + offsets[edges.half_edges[edges.starts[i]]]
    numbers[i] = number
    for j in range(edges.starts[i], edges.starts[i + 1]):
        middles[edges.half_edges[j]] = number


@kernel(for_cpu=True)
def number_in_order_kernel(edges: MeshEdges, base: int, numbers: array(dtype=int32), middles: array(dtype=int32)):
    """Number all edges by one thread; `middles` begin as the edge whose first half-edge each is, or -1."""
    i = tid()
    number = i + base
    for h in range(middles.shape[0]):
        middles[h] = -1
    for e in range(edges.lows.shape[0]):
        middles[edges.half_edges[edges.starts[e]]] = e
    for h in range(middles.shape[0]):
        if middles[h] >= 0:
            numbers[middles[h]] = number
            number += 1
    for e in range(edges.lows.shape[0]):
        for j in range(edges.starts[e], edges.starts[e + 1]):
            middles[edges.half_edges[j]] = numbers[e]


@struct
class EdgeSplit:
    """Edges and new vertices: `numbers` by edge, `middles` by half-edge, `vertex_count` before and after."""

    edges: MeshEdges
    numbers: array(dtype=int32)
    middles: array(dtype=int32)

    def __init__(self, triangles: Triangles, vertex_count: int, in_order: SortedEdges | None = None) -> None:
        """Number the new vertices. `in_order`: known result of `sorted_edges`."""
        device, half_edge_count = triangles.device, 3 * triangles.size
        self.edges = MeshEdges(triangles, vertex_count, in_order=in_order)  # sync
        self.numbers, self.middles = empty(self.edges.count, int32, device), empty(half_edge_count, int32, device)
        if device.is_cuda or half_edge_count > MAX_SERIAL_HALF_EDGES:
            firsts = zeros(half_edge_count, int32, device)
            launch(mark_first_half_edges_kernel, self.edges.count, [self.edges, firsts])
            offsets = offsets_of(firsts)
            arguments = [self.edges, offsets, vertex_count, self.numbers, self.middles]
            launch(number_edges_kernel, self.edges.count, arguments)
        else:
            launch(number_in_order_kernel, 1, [self.edges, vertex_count, self.numbers, self.middles])
        self.vertex_count = (vertex_count, vertex_count + self.edges.count)


@kernel
def split_triangles_kernel(triangles: array(dtype=vec3i), middles: array(dtype=int32), quarters: array(dtype=vec3i)):
    """Three corner triangles, then the middle one."""
    i = tid()
    t = triangles[i]
    ab = middles[3 * i]
    bc = middles[3 * i + 1]
    ca = middles[3 * i + 2]
    quarters[4 * i] = vec3i(t[0], ab, ca)
    quarters[4 * i + 1] = vec3i(ab, t[1], bc)
    quarters[4 * i + 2] = vec3i(bc, t[2], ca)
    quarters[4 * i + 3] = vec3i(ab, bc, ca)


@kernel
def split_corners_kernel(corners: array(dtype=vec2), quarters: array(dtype=vec2)):
    i = tid()
    a = corners[3 * i]
    b = corners[3 * i + 1]
    c = corners[3 * i + 2]
    ab = 0.5 * (a + b)
    bc = 0.5 * (b + c)
    ca = 0.5 * (c + a)
    quarters[12 * i] = a
    quarters[12 * i + 1] = ab
    quarters[12 * i + 2] = ca
    quarters[12 * i + 3] = ab
    quarters[12 * i + 4] = b
    quarters[12 * i + 5] = bc
    quarters[12 * i + 6] = bc
    quarters[12 * i + 7] = c
    quarters[12 * i + 8] = ca
    quarters[12 * i + 9] = ab
    quarters[12 * i + 10] = bc
    quarters[12 * i + 11] = ca


@kernel
def repeat_four_times_kernel(values: array(dtype=int32), repeated: array(dtype=int32)):
    i = tid()
    repeated[i] = values[i // 4]


@kernel
def halve_edges_kernel(split: EdgeSplit, values: array(dtype=vec3d), out: array(dtype=vec3d)):
    """Copy the old values, and add the mean of both ends of each edge."""
    i = tid()
    old = values.shape[0]
    if i < old:
        out[i] = values[i]
    else:
        e = i - old
        out[split.numbers[e]] = 0.5 * (values[split.edges.lows[e]] + values[split.edges.highs[e]])


@kernel
def mask_edges_kernel(
    triangles: array(dtype=vec3i),
    split: EdgeSplit,
    sharers: array(dtype=int32),
    values: array(dtype=vec3d),
    out: array(dtype=vec3d),
):
    """3/8 of each end plus 1/8 of each opposite vertex. The mean on boundary edges."""
    i = tid()
    a = split.edges.lows[i]
    b = split.edges.highs[i]
    value = values[a] + values[b]
    if sharers[i] < 2:
        value = 0.5 * value
    else:
        value = 0.375 * value
        fraction = 0.25 / float64(sharers[i])
        last = -1
        for j in range(split.edges.starts[i], split.edges.starts[i + 1]):
            triangle = split.edges.half_edges[j] // 3
            if triangle != last:
                value = value + fraction * values[opposite_vertex(triangles[triangle], a, b)]
            last = triangle
    out[split.numbers[i]] = value


@kernel
def mask_vertices_kernel(
    around: VertexNeighbors, sharers: array(dtype=int32), values: array(dtype=vec3d), out: array(dtype=vec3d)
):
    """Old vertex moved by its neighbors. Only by those along boundary edges if there are at least two."""
    i = tid()
    everyone = vec3d(0.0, 0.0, 0.0)
    rim = vec3d(0.0, 0.0, 0.0)
    count = float64(around.starts[i + 1] - around.starts[i])
    rim_count = float64(0.0)
    for j in range(around.starts[i], around.starts[i + 1]):
        value = values[around.vertices[j]]
        everyone = everyone + value
        if sharers[around.edges[j]] < 2:
            rim = rim + value
            rim_count += 1.0
    value = values[i]
    if rim_count >= 2.0:
        value = (1.0 - 0.125 * rim_count) * value + 0.125 * rim
    elif count == 3.0:
        value = 0.4375 * value + 0.1875 * everyone
    elif count > 0.0:
        value = 0.625 * value + (0.375 / count) * everyone
    out[i] = value


def split_triangles(triangles: Triangles, split: EdgeSplit) -> Triangles:
    quarters = empty(4 * triangles.size, vec3i, triangles.device)
    launch(split_triangles_kernel, triangles.size, [triangles, split.middles, quarters])
    return quarters


def split_corners(corners: Array1[vec2]) -> Array1[vec2]:
    quarters = empty(4 * corners.size, vec2, corners.device)
    launch(split_corners_kernel, corners.size // 3, [corners, quarters])
    return quarters


def repeat_four_times(values: Integers) -> Integers:
    return compute(repeat_four_times_kernel, 4 * values.size, [values], int32, values.device)


def mixed_ends(split: EdgeSplit) -> MixedRows:
    """Sources of the vertices if new ones are midpoints."""
    edges = split.edges
    weights = full(edges.count, 0.5, float64, edges.lows.device)
    return with_vertices_on_edges(split.vertex_count[0], split.numbers, edges.lows, edges.highs, weights)


def halve(triangles: Triangles, split: EdgeSplit, values: Sequence[Positions]) -> list[Positions]:
    results = []
    for rows in values:
        out = compute(halve_edges_kernel, split.vertex_count[1], [split, rows], vec3d, rows.device)
        results.append(out)
    return results


def mask(triangles: Triangles, split: EdgeSplit, values: Sequence[Positions]) -> list[Positions]:
    """Apply Loop's masks to vec3d arrays: old rows move, and one row is added per edge."""
    sharers, around = count_sharers(split.edges), VertexNeighbors(split.edges, split.vertex_count[0])
    results = []
    for rows in values:
        out = empty(split.vertex_count[1], vec3d, rows.device)
        launch(mask_vertices_kernel, rows.size, [around, sharers, rows, out])
        launch(mask_edges_kernel, split.edges.count, [triangles, split, sharers, rows, out])
        results.append(out)
    return results
