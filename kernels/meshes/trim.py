"""A mesh cut where values at its vertices pass a level, and which parts of the two sides are too small to count.

Values are linear in a triangle, so the cut is a line there: between a corner above and one below the level lies a new
vertex, one for each edge whatever the triangles at it; corners on the level are corners of the line. Each triangle
becomes one to three, all on one side or the other, and both sides stay joined: nothing opens but where a side is
dropped. New vertices follow the old ones in the order of their edges' two numbers, triangles that of their first ones:
the same bits on every device. About 80 B of memory a triangle beside the sort of edges.

Source: SurfaceTrimmer of PoissonRecon (Kazhdan), whose islands and holes are these.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from ..algebra.transform import narrow, widen
from ..array_types import Doubles, Integers, Mask, Points, Triangles, Vectors
from ..arrays.pair_sort import argsort_pairs
from ..arrays.prefix_sum import exclusive_scan
from ..arrays.select import gather_rows, invert_mask, positions_of
from ..arrays.unique import UniqueKeys
from ..lang import array, atomic_max, float64, int32, int64, kernel, launch, length, struct, tid, uint8, vec3, vec3i
from ..memory import copy, download, empty, full, upload, zeros
from .mesh_components import Components
from .mesh_edges import higher_end, lower_end
from .mesh_edits import keep_triangles
from .mesh_measures import measure
from .mesh_topology import corner_vertex, list_edge_keys_kernel, next_corner


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
        edges: UniqueKeys of the edges, by the numbers of their two vertices.
        vertices: int32 [3 t], the new vertex of each half-edge, -1 where it is not cut.
        shares: float64 [c], where between its lower and its higher vertex each edge is cut.
    """

    vertices: array(dtype=int32)
    shares: array(dtype=float64)

    def __init__(self, triangles: Triangles, values: Doubles, sides: Integers, level: float) -> None:
        device, half_edges = triangles.device, 3 * triangles.size
        self.bits = max(1, values.size.bit_length())
        keys, mask = empty(half_edges, int64, device), empty(half_edges, uint8, device)
        launch(list_edge_keys_kernel, triangles.size, [triangles, self.bits, keys])
        launch(mark_cut_edges_kernel, half_edges, [triangles, sides, mask])
        rows = positions_of(mask)  # sync
        self.edges = UniqueKeys(gather_rows(keys, rows), 2 * self.bits)  # sync
        self.count = self.edges.count
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
    half = float64(0.5)
    a = values[lower_end(edges.keys[i], bits)] * half
    b = values[higher_end(edges.keys[i], bits)] * half
    shares[i] = (level * half - a) / (b - a)


@kernel
def interpolate_rows_kernel(
    edges: UniqueKeys, bits: int, shares: array(dtype=float64), unit: int, first: int, rows: array(dtype=vec3)
):
    """The rows of new vertices between those of their edges; of unit length where `unit` is 1 and there is a length."""
    i = tid()
    a = widen(rows[lower_end(edges.keys[i], bits)])
    b = widen(rows[higher_end(edges.keys[i], bits)])
    row = a * (1.0 - shares[i]) + b * shares[i]
    size = length(row)
    if unit == 1 and size > 0.0:
        row = row / size
    rows[first + i] = narrow(row)


@kernel
def count_pieces_kernel(cuts: CutEdges, counts: array(dtype=int32)):
    """The triangles that each triangle becomes: one more than its edges that are cut."""
    i = tid()
    count = 1
    for k in range(3):
        if cuts.vertices[3 * i + k] >= 0:
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


def cut_at_level(
    triangles: Triangles, per_vertex: Sequence[Vectors], unit: Sequence[bool], values: Doubles, level: float
) -> tuple[Triangles, list[Vectors], Mask]:
    """The mesh with its triangles cut along the level.

    Args:
        triangles: vec3i [t].
        per_vertex: vec3 [m] device arrays.
        unit: For each of them whether its rows have unit length.
        values: float64 device array [m], finite.
        level: A Python number.

    Returns:
        (pieces vec3i [p], arrays vec3 [m + c], uint8 [p]: 1 for pieces above the level).
    """
    device, count = triangles.device, values.size
    sides = empty(count, int32, device)
    launch(mark_sides_kernel, count, [values, level, sides])
    cuts = CutEdges(triangles, values, sides, level)
    arrays = []
    for rows, is_unit in zip(per_vertex, unit, strict=True):
        longer = empty(count + cuts.count, vec3, device)
        copy(longer, rows, count=count)
        launch(interpolate_rows_kernel, cuts.count, [cuts.edges, cuts.bits, cuts.shares, int(is_unit), count, longer])
        arrays.append(longer)
    counts = empty(triangles.size, int32, device)
    launch(count_pieces_kernel, triangles.size, [cuts, counts])
    offsets, total = exclusive_scan(counts)  # sync
    pieces, kept = empty(total, vec3i, device), empty(total, uint8, device)
    launch(write_pieces_kernel, triangles.size, [triangles, sides, cuts, offsets, pieces, kept])
    return pieces, arrays, kept


# ------------------------------------------------------------------------------------------------ islands and holes


@kernel
def spread_mask_kernel(rows: array(dtype=int32), chosen: array(dtype=uint8), value: int, mask: array(dtype=uint8)):
    """Set the mask to a value at the chosen ones of some rows."""
    i = tid()
    if chosen[i] == 1:
        mask[rows[i]] = uint8(value)


@kernel
def spread_parts_kernel(rows: array(dtype=int32), labels: array(dtype=int64), parts: array(dtype=int32)):
    """The part of each of some rows."""
    i = tid()
    parts[rows[i]] = int(labels[i])


@kernel
def find_edges_of_parts_kernel(
    keys: array(dtype=int64),
    order: array(dtype=int32),
    parts: array(dtype=int32),
    is_open: array(dtype=int32),
    touches: array(dtype=int32),
):
    """Which parts end at the mesh's own border, and which touch what is in none; any thread may set it to 1."""
    i = tid()
    part = parts[order[i] // 3]
    if part >= 0:
        first = i
        while first > 0 and keys[max(first - 1, 0)] == keys[i]:
            first -= 1
        last = i + 1
        while last < keys.shape[0] and keys[min(last, keys.shape[0] - 1)] == keys[i]:
            last += 1
        if last - first == 1:
            atomic_max(is_open, part, 1)
        for j in range(first, last):
            if parts[order[j] // 3] < 0:
                atomic_max(touches, part, 1)


def drop_islands(vertices: Points, triangles: Triangles, mask: Mask, least: float) -> None:
    """Clear the mask (uint8 [t]) of parts of the chosen triangles whose area is below `least`."""
    rows = positions_of(mask)  # sync
    parts = Components(vertices, keep_triangles(triangles, mask))
    chosen = parts.mask(parts.areas < least)
    launch(spread_mask_kernel, rows.size, [rows, chosen, 0, mask])


def keep_holes(vertices: Points, triangles: Triangles, mask: Mask, least: float) -> None:
    """Set the mask of parts of the other triangles whose area is below `least` and that chosen ones enclose."""
    device = triangles.device
    others = invert_mask(mask)
    rows = positions_of(others)  # sync
    found = Components(vertices, keep_triangles(triangles, others))
    parts = full(triangles.size, -1, int32, device)
    launch(spread_parts_kernel, rows.size, [rows, found.labels, parts])
    bits = max(1, vertices.size.bit_length())
    keys = empty(3 * triangles.size, int64, device)
    launch(list_edge_keys_kernel, triangles.size, [triangles, bits, keys])
    keys, order = argsort_pairs(keys, bits, vertices.size)
    is_open, touches = (zeros(len(found.counts), int32, device) for _ in range(2))
    launch(find_edges_of_parts_kernel, keys.size, [keys, order, parts, is_open, touches])
    enclosed = (download(is_open) == 0) & (download(touches) == 1)  # sync
    chosen = found.mask(enclosed & (found.areas < least))
    launch(spread_mask_kernel, rows.size, [rows, chosen, 1, mask])


def trim(
    triangles: Triangles,
    per_vertex: Sequence[Vectors],
    unit: Sequence[bool],
    values: np.ndarray,
    level: float,
    island_ratio: float,
) -> tuple[Triangles, list[Any]]:
    """The part of a mesh above a level.

    Args:
        triangles: vec3i [t].
        per_vertex: vec3 [m] device arrays, the vertices first.
        unit: For each of them whether its rows have unit length.
        values: float64 NumPy array [m], finite.
        level: Where to cut.
        island_ratio: Parts of less than this share of the whole area change sides.

    Returns:
        (triangles, arrays of m and more rows, in which not all are used).
    """
    device = triangles.device
    area, _ = measure(per_vertex[0], triangles)
    field = upload(np.asarray(values, np.float64), float64, device)
    pieces, arrays, mask = cut_at_level(triangles, per_vertex, unit, field, level)
    if island_ratio > 0:
        drop_islands(arrays[0], pieces, mask, island_ratio * area)
        keep_holes(arrays[0], pieces, mask, island_ratio * area)
    return keep_triangles(pieces, mask), arrays
