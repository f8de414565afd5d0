"""Cut a mesh where linear values at its vertices cross a level.

Each cut edge gets one vertex, and each triangle becomes one to three pieces that stay connected. New vertices are
sorted by edge, pieces by triangle: bitwise reproducible. About 80 B per triangle.
"""

from ..algebra.transform import narrow, widen
from ..array_types import Array1, Doubles, Integers, Triangles, Vectors
from ..arrays.prefix_sum import exclusive_scan
from ..arrays.select import gather_rows, positions_of
from ..arrays.unique import UniqueKeys
from ..lang import (
    array,
    compute,
    float64,
    int32,
    int64,
    kernel,
    launch,
    length,
    struct,
    tid,
    uint8,
    vec2,
    vec3,
    vec3d,
    vec3i,
)
from ..memory import copy, empty, full
from .mesh_edges import higher_end, lower_end, spread_runs_kernel
from .mesh_topology import corner_vertex, list_edge_keys_kernel, next_corner
from .mixed_rows import MixedRows, with_vertices_on_edges


@kernel
def mark_sides_kernel(values: array(dtype=float64), level: float64, sides: array(dtype=int32)):
    i = tid()
    side = 0
    if values[i] > level:
        side = 1
    if values[i] < level:
        side = -1
    sides[i] = side


@kernel
def mark_cut_edges_kernel(triangles: array(dtype=vec3i), sides: array(dtype=int32), mask: array(dtype=uint8)):
    i = tid()
    product = sides[corner_vertex(triangles, i)] * sides[corner_vertex(triangles, next_corner(i))]
    mask[i] = uint8(1 if product < 0 else 0)


@struct
class CutEdges:
    """Cut edges, sorted by their two vertices. `vertices` are the new vertices of half-edges (-1 if uncut), `fractions`
    the fraction from the lower to the higher vertex. On CUDA, `count` is the number of half-edges, padded by zeros."""

    vertices: array(dtype=int32)
    fractions: array(dtype=float64)

    def __init__(self, triangles: Triangles, values: Doubles, sides: Integers, level: float, crossings: int) -> None:
        """From triangles with a number of edges that cross the level. No sync."""
        device, half_edges = triangles.device, 3 * triangles.size
        self.bits = max(1, values.size.bit_length())
        keys, mask = empty(half_edges, int64, device), empty(half_edges, uint8, device)
        launch(list_edge_keys_kernel, triangles.size, [triangles, self.bits, keys])
        launch(mark_cut_edges_kernel, half_edges, [triangles, sides, mask])
        rows = positions_of(mask, crossings)
        self.edges = UniqueKeys(gather_rows(keys, rows), 2 * self.bits, padded=True)
        self.count = self.edges.count
        self.vertex_count = values.size
        self.vertices, self.fractions = full(half_edges, -1, int32, device), empty(self.count, float64, device)
        launch(number_cuts_kernel, self.count, [self.edges, rows, values.size, self.vertices])
        launch(locate_cuts_kernel, self.count, [self.edges, self.bits, values, level, self.fractions])


@kernel
def number_cuts_kernel(edges: UniqueKeys, rows: array(dtype=int32), first: int, vertices: array(dtype=int32)):
    i = tid()
    for j in range(edges.starts[i], edges.starts[i + 1]):
        vertices[rows[edges.order[j]]] = first + i


@kernel
def locate_cuts_kernel(
    edges: UniqueKeys, bits: int, values: array(dtype=float64), level: float64, fractions: array(dtype=float64)
):
    """Fraction at which each edge is cut; halved first to avoid overflow."""
    i = tid()
    fraction = float64(0.0)
    if edges.starts[i + 1] > edges.starts[i]:
        half = float64(0.5)
        a = values[lower_end(edges.keys[i], bits)] * half
        b = values[higher_end(edges.keys[i], bits)] * half
        fraction = (level * half - a) / (b - a)
    fractions[i] = fraction


@kernel
def interpolate_rows_kernel(
    edges: UniqueKeys, bits: int, fractions: array(dtype=float64), unit: int, first: int, rows: array(dtype=vec3)
):
    """Interpolate rows at the new vertices; normalized if `unit` is 1."""
    i = tid()
    row = vec3d(0.0, 0.0, 0.0)
    if edges.starts[i + 1] > edges.starts[i]:
        a = widen(rows[lower_end(edges.keys[i], bits)])
        b = widen(rows[higher_end(edges.keys[i], bits)])
        row = a * (1.0 - fractions[i]) + b * fractions[i]
        size = length(row)
        if unit == 1 and size > 0.0:
            row = row / size
    rows[first + i] = narrow(row)


@kernel
def count_pieces_kernel(triangles: array(dtype=vec3i), sides: array(dtype=int32), counts: array(dtype=int32)):
    i = tid()
    t = triangles[i]
    count = 1
    for k in range(3):
        if sides[t[k]] * sides[t[(k + 1) % 3]] < 0:
            count += 1
    counts[i] = count


@kernel
def write_pieces_kernel(
    triangles: array(dtype=vec3i),
    sides: array(dtype=int32),
    cuts: CutEdges,
    offsets: array(dtype=int32),
    pieces: array(dtype=vec3i),
    above: array(dtype=uint8),
):
    """Pieces of each triangle in its orientation, and 1 for those above or on the level."""
    i = tid()
    first = offsets[i]
    count = offsets[i + 1] - first
    t = triangles[i]
    if count == 1:
        pieces[first] = t
        above[first] = uint8(1 if min(sides[t[0]], min(sides[t[1]], sides[t[2]])) >= 0 else 0)
    # First corner: between two cut edges, or opposite to a single one.
    h = 3 * i
    for k in range(3):
        before = cuts.vertices[3 * i + (k + 2) % 3]
        after = cuts.vertices[3 * i + k]
        if (count == 3 and before >= 0 and after >= 0) or (count == 2 and before < 0 and after < 0):
            h = 3 * i + k
    a = corner_vertex(triangles, h)
    h1 = next_corner(h)
    h2 = next_corner(h1)
    b = corner_vertex(triangles, h1)
    c = corner_vertex(triangles, h2)
    if count == 2:
        p = cuts.vertices[h1]
        pieces[first] = vec3i(a, b, p)
        above[first] = uint8(1 if sides[b] > 0 else 0)
        pieces[first + 1] = vec3i(a, p, c)
        above[first + 1] = uint8(1 if sides[c] > 0 else 0)
    if count == 3:
        p = cuts.vertices[h]
        q = cuts.vertices[h2]
        pieces[first] = vec3i(a, p, q)
        above[first] = uint8(1 if sides[a] > 0 else 0)
        pieces[first + 1] = vec3i(p, b, c)
        pieces[first + 2] = vec3i(p, c, q)
        above[first + 1] = uint8(1 if sides[b] > 0 else 0)
        above[first + 2] = uint8(1 if sides[b] > 0 else 0)


@kernel
def split_cut_keys_kernel(
    edges: UniqueKeys,
    bits: int,
    first: int,
    numbers: array(dtype=int32),
    lows: array(dtype=int32),
    highs: array(dtype=int32),
):
    i = tid()
    numbers[i] = first + i
    lows[i] = 0
    highs[i] = 0
    if edges.starts[i + 1] > edges.starts[i]:
        lows[i] = lower_end(edges.keys[i], bits)
        highs[i] = higher_end(edges.keys[i], bits)


@kernel
def mix_piece_corners_kernel(
    triangles: array(dtype=vec3i),
    cuts: CutEdges,
    first_new: int,
    pieces: array(dtype=vec3i),
    sources: array(dtype=int32),
    values: array(dtype=vec2),
    mixed: array(dtype=vec2),
):
    """Values of corners for the pieces, interpolated on cut edges within their triangle."""
    i = tid()
    piece = pieces[i]
    t = sources[i]
    for c in range(3):
        v = piece[c]
        value = values[3 * t]
        for k in range(3):
            h = 3 * t + k
            if v < first_new and triangles[t][k] == v:
                value = values[h]
            if v >= first_new and cuts.vertices[h] == v:
                fraction = float(cuts.fractions[v - first_new])
                if corner_vertex(triangles, h) > corner_vertex(triangles, next_corner(h)):
                    fraction = 1.0 - fraction
                value = (1.0 - fraction) * values[h] + fraction * values[next_corner(h)]
        mixed[3 * i + c] = value


class LevelCut:
    """Mesh cut along a level. `sides` are signs of vertices, `above` marks pieces above or on the level, `sources` are
    their triangles. The vertex on cut edge i has index m + i. Trailing vertices may be unused."""

    def __init__(self, triangles: Triangles, values: Doubles, level: float) -> None:
        """Cut by finite float64 values [m]. One sync."""
        device, self.triangles = triangles.device, triangles
        self.sides = empty(values.size, int32, device)
        launch(mark_sides_kernel, values.size, [values, level, self.sides])
        counts = compute(count_pieces_kernel, triangles.size, [triangles, self.sides], int32, device)
        offsets, total = exclusive_scan(counts, largest=3)  # sync, since a level cuts at most two edges
        self.cuts = CutEdges(triangles, values, self.sides, level, total - triangles.size)
        self.pieces, self.above = empty(total, vec3i, device), empty(total, uint8, device)
        self.sources = empty(total, int32, device)
        launch(spread_runs_kernel, triangles.size, [offsets, self.sources])
        arguments = [triangles, self.sides, self.cuts, offsets, self.pieces, self.above]
        launch(write_pieces_kernel, triangles.size, arguments)

    def rows_of(self, rows: Vectors, unit: bool) -> Vectors:
        """Rows vec3 [m] of the vertices, followed by those on the cut; normalized with `unit`."""
        cuts, count = self.cuts, rows.size
        longer = empty(count + cuts.count, vec3, rows.device)
        copy(longer, rows, count=count)
        arguments = [cuts.edges, cuts.bits, cuts.fractions, int(unit), count, longer]
        launch(interpolate_rows_kernel, cuts.count, arguments)
        return longer

    def mixed(self) -> MixedRows:
        """Sources of all vertices, for values of other types."""
        cuts, device = self.cuts, self.sides.device
        numbers, lows, highs = (empty(cuts.count, int32, device) for _ in range(3))
        launch(split_cut_keys_kernel, cuts.count, [cuts.edges, cuts.bits, cuts.vertex_count, numbers, lows, highs])
        return with_vertices_on_edges(cuts.vertex_count, numbers, lows, highs, cuts.fractions)

    def corners_of(self, values: Array1[vec2]) -> Array1[vec2]:
        mixed = empty(3 * self.pieces.size, vec2, values.device)
        arguments = [self.triangles, self.cuts, self.cuts.vertex_count, self.pieces, self.sources, values, mixed]
        launch(mix_piece_corners_kernel, self.pieces.size, arguments)
        return mixed
