"""A mesh cut where values at its vertices pass a level.

Values are linear in a triangle, so the cut is a line there: between a corner above and one below the level lies a new
vertex, one for each edge whatever the triangles at it; corners on the level are corners of the line. Each triangle
becomes one to three, all on one side or the other, and both sides stay joined: nothing opens but where a side is
dropped. New vertices follow the old ones in the order of their edges' two numbers, triangles that of their first ones:
the same bits on every device. About 80 B of memory a triangle beside the sort of edges.
"""

from ..algebra.transform import narrow, widen
from ..array_types import Array1, Doubles, Integers, Triangles, Vectors
from ..arrays.prefix_sum import exclusive_scan
from ..arrays.select import gather_rows, positions_of
from ..arrays.unique import UniqueKeys
from ..lang import array, float64, int32, int64, kernel, launch, length, struct, tid, uint8, vec2, vec3, vec3d, vec3i
from ..memory import copy, empty, full
from .mesh_edges import higher_end, lower_end, spread_runs_kernel
from .mesh_topology import corner_vertex, list_edge_keys_kernel, next_corner
from .mixed_rows import MixedRows, with_vertices_on_edges


@kernel
def mark_sides_kernel(values: array(dtype=float64), level: float64, sides: array(dtype=int32)):
    """1 where a value is above the level, -1 where it is below, 0 on it."""
    i = tid()
    side = 0
    if values[i] > level:
        side = 1
    if values[i] < level:
        side = -1
    sides[i] = side


@kernel
def mark_cut_edges_kernel(triangles: array(dtype=vec3i), sides: array(dtype=int32), mask: array(dtype=uint8)):
    """1 for half-edges that lead from above the level to below it or back."""
    i = tid()
    product = sides[corner_vertex(triangles, i)] * sides[corner_vertex(triangles, next_corner(i))]
    mask[i] = uint8(1 if product < 0 else 0)


@struct
class CutEdges:
    """The edges that the level cuts.

    Attributes:
        vertex_count: Vertices m before the cut.
        bits: Of a vertex' number in a key.
        edges: UniqueKeys of the edges, by the numbers of their two vertices.
        vertices: int32 [3 t], the new vertex of each half-edge, -1 where it is not cut.
        shares: float64 [c], where between its lower and its higher vertex each edge is cut.
        count: Edges c; on CUDA as many as half-edges, of which those behind the last edge are none: what stands for
            them has shares and rows of zeros.
    """

    vertices: array(dtype=int32)
    shares: array(dtype=float64)

    def __init__(self, triangles: Triangles, values: Doubles, sides: Integers, level: float, crossings: int) -> None:
        """Of triangles whose edges pass the level as often as `crossings` says; no sync."""
        device, half_edges = triangles.device, 3 * triangles.size
        self.bits = max(1, values.size.bit_length())
        keys, mask = empty(half_edges, int64, device), empty(half_edges, uint8, device)
        launch(list_edge_keys_kernel, triangles.size, [triangles, self.bits, keys])
        launch(mark_cut_edges_kernel, half_edges, [triangles, sides, mask])
        rows = positions_of(mask, crossings)
        self.edges = UniqueKeys(gather_rows(keys, rows), 2 * self.bits, padded=True)
        self.count = self.edges.count
        self.vertex_count = values.size
        self.vertices, self.shares = full(half_edges, -1, int32, device), empty(self.count, float64, device)
        launch(number_cuts_kernel, self.count, [self.edges, rows, values.size, self.vertices])
        launch(place_cuts_kernel, self.count, [self.edges, self.bits, values, level, self.shares])


@kernel
def number_cuts_kernel(edges: UniqueKeys, rows: array(dtype=int32), first: int, vertices: array(dtype=int32)):
    """The new vertex of each half-edge of an edge."""
    i = tid()
    for j in range(edges.starts[i], edges.starts[i + 1]):
        vertices[rows[edges.order[j]]] = first + i


@kernel
def place_cuts_kernel(
    edges: UniqueKeys, bits: int, values: array(dtype=float64), level: float64, shares: array(dtype=float64)
):
    """Where each edge is cut; halved first, so that no difference overflows."""
    i = tid()
    share = float64(0.0)
    if edges.starts[i + 1] > edges.starts[i]:
        half = float64(0.5)
        a = values[lower_end(edges.keys[i], bits)] * half
        b = values[higher_end(edges.keys[i], bits)] * half
        share = (level * half - a) / (b - a)
    shares[i] = share


@kernel
def interpolate_rows_kernel(
    edges: UniqueKeys, bits: int, shares: array(dtype=float64), unit: int, first: int, rows: array(dtype=vec3)
):
    """The rows of new vertices between those of their edges; of unit length where `unit` is 1 and there is a length."""
    i = tid()
    row = vec3d(0.0, 0.0, 0.0)
    if edges.starts[i + 1] > edges.starts[i]:
        a = widen(rows[lower_end(edges.keys[i], bits)])
        b = widen(rows[higher_end(edges.keys[i], bits)])
        row = a * (1.0 - shares[i]) + b * shares[i]
        size = length(row)
        if unit == 1 and size > 0.0:
            row = row / size
    rows[first + i] = narrow(row)


@kernel
def count_pieces_kernel(triangles: array(dtype=vec3i), sides: array(dtype=int32), counts: array(dtype=int32)):
    """The triangles that each triangle becomes: one more than its edges that are cut."""
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
    kept: array(dtype=uint8),
):
    """The pieces of each triangle, wound as it is, and 1 for those above the level; all of it on the level is above."""
    i = tid()
    first = offsets[i]
    count = offsets[i + 1] - first
    t = triangles[i]
    if count == 1:
        pieces[first] = t
        kept[first] = uint8(1 if min(sides[t[0]], min(sides[t[1]], sides[t[2]])) >= 0 else 0)
    # The corner to begin from: of two cut edges the one between them, of one the one across.
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
        kept[first] = uint8(1 if sides[b] > 0 else 0)
        pieces[first + 1] = vec3i(a, p, c)
        kept[first + 1] = uint8(1 if sides[c] > 0 else 0)
    if count == 3:
        p = cuts.vertices[h]
        q = cuts.vertices[h2]
        pieces[first] = vec3i(a, p, q)
        kept[first] = uint8(1 if sides[a] > 0 else 0)
        pieces[first + 1] = vec3i(p, b, c)
        pieces[first + 2] = vec3i(p, c, q)
        kept[first + 1] = uint8(1 if sides[b] > 0 else 0)
        kept[first + 2] = uint8(1 if sides[b] > 0 else 0)


@kernel
def split_cut_keys_kernel(
    edges: UniqueKeys,
    bits: int,
    first: int,
    numbers: array(dtype=int32),
    lows: array(dtype=int32),
    highs: array(dtype=int32),
):
    """The new vertex and the two ends of each edge."""
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
    """Values of corners at those of the pieces; on cut edges between those of their triangle's own corners."""
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
                share = float(cuts.shares[v - first_new])
                if corner_vertex(triangles, h) > corner_vertex(triangles, next_corner(h)):
                    share = 1.0 - share
                value = (1.0 - share) * values[h] + share * values[next_corner(h)]
        mixed[3 * i + c] = value


class LevelCut:
    """The mesh with its triangles cut along a level; nothing is dropped.

    Attributes:
        sides: int32 [m]: 1 for vertices above the level, -1 below, 0 on it.
        pieces: vec3i [p], wound as their triangles are.
        above: uint8 [p]: 1 for pieces above the level, and those that lie on it.
        sources: int32 [p], the triangle that each piece is of.
        cuts: The edges that are cut; the vertex on edge i has the number m + i. Beyond the last one are vertices that
            no piece uses.
    """

    def __init__(self, triangles: Triangles, values: Doubles, level: float) -> None:
        """Cut; one sync.

        Args:
            triangles: vec3i [t].
            values: float64 device array [m], finite.
            level: A Python number.
        """
        device, self.triangles = triangles.device, triangles
        self.sides = empty(values.size, int32, device)
        launch(mark_sides_kernel, values.size, [values, level, self.sides])
        counts = empty(triangles.size, int32, device)
        launch(count_pieces_kernel, triangles.size, [triangles, self.sides, counts])
        offsets, total = exclusive_scan(counts)  # sync
        self.cuts = CutEdges(triangles, values, self.sides, level, total - triangles.size)
        self.pieces, self.above = empty(total, vec3i, device), empty(total, uint8, device)
        self.sources = empty(total, int32, device)
        launch(spread_runs_kernel, triangles.size, [offsets, self.sources])
        arguments = [triangles, self.sides, self.cuts, offsets, self.pieces, self.above]
        launch(write_pieces_kernel, triangles.size, arguments)

    def rows_of(self, rows: Vectors, unit: bool) -> Vectors:
        """vec3 [m] rows at vertices and behind them those on the cut; of unit length where they have one."""
        cuts, count = self.cuts, rows.size
        longer = empty(count + cuts.count, vec3, rows.device)
        copy(longer, rows, count=count)
        arguments = [cuts.edges, cuts.bits, cuts.shares, int(unit), count, longer]
        launch(interpolate_rows_kernel, cuts.count, arguments)
        return longer

    def mixed(self) -> MixedRows:
        """What all vertices are made of, for values of other kinds."""
        cuts, device = self.cuts, self.sides.device
        numbers, lows, highs = (empty(cuts.count, int32, device) for _ in range(3))
        launch(split_cut_keys_kernel, cuts.count, [cuts.edges, cuts.bits, cuts.vertex_count, numbers, lows, highs])
        return with_vertices_on_edges(cuts.vertex_count, numbers, lows, highs, cuts.shares)

    def corners_of(self, values: Array1[vec2]) -> Array1[vec2]:
        """vec2 [3 t] values of corners at those of the pieces, vec2 [3 p]."""
        mixed = empty(3 * self.pieces.size, vec2, values.device)
        arguments = [self.triangles, self.cuts, self.cuts.vertex_count, self.pieces, self.sources, values, mixed]
        launch(mix_piece_corners_kernel, self.pieces.size, arguments)
        return mixed
