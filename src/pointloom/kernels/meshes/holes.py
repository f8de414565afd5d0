"""Hole filling by minimum-weight triangulations of boundary loops.

Dynamic programming over chords (Barequet and Sharir, "Filling gaps in the boundary of a polyhedron", CAGD 12, 1995):
n^3 / 6 triangles and n^2 chords of 44 B. The weight is the largest dihedral angle, quantized so that rounding does not
decide, then the sum of squared sides (after Liepa, "Filling holes in meshes", SGP 2003, section 3). If two holes choose
the same chord, the later one waits for the next pass. Float64, bitwise reproducible.
"""

from typing import TYPE_CHECKING

import numpy as np

from ..algebra.transform import widen
from ..array_types import Array1, Indices, Integers, Points, Triangles
from ..arrays.concatenation import concatenate_rows, joined_rows
from ..arrays.select import gather_rows, positions_of
from ..arrays.unique import UniqueKeys
from ..lang import (
    INFINITY,
    array,
    atomic_max,
    compute,
    cross,
    dot,
    float64,
    floor,
    func,
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
from ..memory import copy, download, empty, full, upload, zeros
from .boundary_loops import Border, find_loops
from .mesh_edges import edge_key, find_edge, find_edges, key_bits, spread_runs_kernel
from .mesh_measures import triangle_cross

if TYPE_CHECKING:
    from .holes import BoundaryLoops


# vertices of a loop: a thread weighs its triangles in about the time of 30 launches (an estimate)
SHORT_LOOP_VERTICES = 32
BEND_STEPS = 256.0  # quantization of bends in 0..2: the first step is 5 degrees, later ones are smaller


@kernel
def list_entries_kernel(
    starts: array(dtype=int32),
    owners: array(dtype=int32),
    sources: array(dtype=int32),
    source_starts: array(dtype=int32),
    rows: array(dtype=int32),
):
    i = tid()
    rows[i] = source_starts[sources[owners[i]]] + i - starts[owners[i]]


@struct
class Loops:
    """Loops to fill: vertices and half-edges in boundary order, which is opposite to that of the hole. Chord (i, j) of
    a loop is at n i + j after its entry of `cells`. For each chord: weights `bends` and `sizes`, the normal of the
    triangle (zero without area), and its tip (-1 if none)."""

    vertices: array(dtype=int32)
    half_edges: array(dtype=int32)
    starts: array(dtype=int32)
    owners: array(dtype=int32)
    cells: array(dtype=int32)
    points: array(dtype=vec3d)
    bends: array(dtype=float64)
    normals: array(dtype=vec3d)
    sizes: array(dtype=float64)
    tips: array(dtype=int32)

    def __init__(self, all_loops: "BoundaryLoops", chosen: np.ndarray, counts: np.ndarray) -> None:
        """Selected loops and their numbers of vertices (NumPy)."""
        device, square = all_loops.vertices.device, counts.astype(np.int64) ** 2
        starts, entries = np.concatenate([[0], np.cumsum(counts)]), int(counts.sum())
        self.starts, self.owners = upload(starts, int32, device), empty(entries, int32, device)
        launch(spread_runs_kernel, len(counts), [self.starts, self.owners])
        rows, sources = empty(entries, int32, device), upload(chosen, int32, device)
        launch(list_entries_kernel, entries, [self.starts, self.owners, sources, all_loops.starts, rows])
        self.vertices, self.half_edges = gather_rows(all_loops.vertices, rows), gather_rows(all_loops.half_edges, rows)
        self.cells = upload(np.concatenate([[0], np.cumsum(square)])[:-1], int32, device)
        count = int(square.sum())
        self.bends, self.sizes = zeros(count, float64, device), zeros(count, float64, device)
        self.normals, self.points = zeros(count, vec3d, device), empty(entries, vec3d, device)
        self.tips = full(count, -1, int32, device)


@kernel
def begin_loops_kernel(vertices: array(dtype=vec3), triangles: array(dtype=vec3i), loops: Loops):
    """Position of each vertex, and the mesh normal beyond the side after it. The last side closes the loop."""
    p = tid()
    first = loops.starts[loops.owners[p]]
    count = loops.starts[loops.owners[p] + 1] - first
    i = p - first
    j = (i + 1) % count
    loops.points[p] = widen(vertices[loops.vertices[p]])
    loops.normals[loops.cells[loops.owners[p]] + i * count + j] = unit_or_none(
        triangle_cross(vertices, triangles[loops.half_edges[p] // 3])
    )


@func
def unit_or_none(n: vec3d) -> vec3d:
    size = length(n)
    unit = vec3d(0.0, 0.0, 0.0)
    if size > 0.0:
        unit = n / size
    return unit


@func
def bend_to(n: vec3d, m: vec3d) -> float64:
    """1 - cos of the angle between two unit normals. 0 if the second is zero."""
    bend = float64(0.0)
    if dot(m, m) > 0.5:
        bend = 1.0 - dot(n, m)
    return bend


@func
def square_side(a: vec3d, b: vec3d) -> float64:
    d = a - b
    return dot(d, d)


@func
def weigh_chord(edge_keys: array(dtype=int64), bits: int, loops: Loops, loop: int, i: int, j: int):
    """Best triangle at the chord between vertices i and j of a loop. Shorter chords are complete."""
    first = loops.starts[loop]
    count = loops.starts[loop + 1] - first
    base = loops.cells[loop]
    at = base + i * count + j
    a = loops.points[first + i]
    c = loops.points[first + j]
    is_closing = 0
    if i == 0 and j + 1 == count:
        is_closing = 1
    across = loops.normals[base + (count - 1) * count]
    side = square_side(a, c)
    best_bend = float64(INFINITY)
    best_size = float64(INFINITY)
    best_normal = vec3d(0.0, 0.0, 0.0)
    best = -1
    last = j
    existing = find_edge(edge_key(loops.vertices[first + i], loops.vertices[first + j], bits), edge_keys)
    if existing >= 0 and is_closing == 0:
        last = i + 1
    for k in range(i + 1, last):
        left = base + i * count + k
        right = base + k * count + j
        bend = max(loops.bends[left], loops.bends[right])  # infinite if a chord is not allowed
        if bend <= best_bend and bend < float64(INFINITY):
            b = loops.points[first + k]
            n = cross(b - c, a - c)
            unit = unit_or_none(n)
            sharpest = float64(2.0)
            if dot(unit, unit) > 0.5:
                sharpest = max(bend_to(unit, loops.normals[left]), bend_to(unit, loops.normals[right]))
                if is_closing == 1:
                    sharpest = max(sharpest, bend_to(unit, across))
            bend = max(floor(sharpest * float64(BEND_STEPS)), bend)
            size = side + square_side(a, b) + square_side(b, c) + loops.sizes[left] + loops.sizes[right]
            if bend < best_bend or (bend == best_bend and size < best_size):
                best_bend = bend
                best_size = size
                best_normal = unit
                best = k
    loops.bends[at] = best_bend
    loops.sizes[at] = best_size
    loops.normals[at] = best_normal
    loops.tips[at] = best


@kernel
def weigh_chords_kernel(edge_keys: array(dtype=int64), bits: int, loops: Loops, span: int):
    """Weigh the chords that span `span` sides."""
    p = tid()
    loop = loops.owners[p]
    i = p - loops.starts[loop]
    if i + span < loops.starts[loop + 1] - loops.starts[loop]:
        weigh_chord(edge_keys, bits, loops, loop, i, i + span)


@kernel(for_cpu=True)
def weigh_loops_kernel(edge_keys: array(dtype=int64), bits: int, loops: Loops):
    """Weigh all chords of a loop, shorter ones first. One thread per loop."""
    loop = tid()
    count = loops.starts[loop + 1] - loops.starts[loop]
    for span in range(2, count):
        for i in range(count - span):
            weigh_chord(edge_keys, bits, loops, loop, i, i + span)


@kernel
def mark_closed_kernel(loops: Loops, closed: array(dtype=uint8)):
    i = tid()
    count = loops.starts[i + 1] - loops.starts[i]
    closed[i] = uint8(1 if loops.tips[loops.cells[i] + count - 1] >= 0 else 0)


@kernel
def write_triangles_kernel(
    loops: Loops,
    chosen: array(dtype=int32),
    offsets: array(dtype=int32),
    stack: array(dtype=int32),
    pieces: array(dtype=vec3i),
):
    i = tid()
    loop = chosen[i]
    first = loops.starts[loop]
    count = loops.starts[loop + 1] - first
    base = loops.cells[loop]
    written = offsets[i]
    stack[first] = count - 1  # chords in the order of their cells
    depth = 1
    while depth > 0:
        depth -= 1
        chord = stack[first + depth]
        a = chord // count
        c = chord - a * count
        b = loops.tips[base + chord]
        pieces[written] = vec3i(first + c, first + b, first + a)
        written += 1
        if b > a + 1:
            stack[first + depth] = a * count + b
            depth += 1
        if c > b + 1:
            stack[first + depth] = b * count + c
            depth += 1


@kernel
def name_pieces_kernel(
    loops: Loops,
    numbers: array(dtype=int32),
    pieces: array(dtype=vec3i),
    corners: array(dtype=int32),
    of_loop: array(dtype=int32),
):
    """Replace positions by vertices. Also the half-edges that start there and the loop of each triangle."""
    i = tid()
    p = pieces[i]
    for k in range(3):
        corners[3 * i + k] = loops.half_edges[p[k]]
    pieces[i] = vec3i(loops.vertices[p[0]], loops.vertices[p[1]], loops.vertices[p[2]])
    of_loop[i] = numbers[loops.owners[p[0]]]


def close_loops(
    vertices: Points, triangles: Triangles, all_loops: "BoundaryLoops", batch: np.ndarray
) -> tuple[Triangles, Indices, Indices, int]:
    """Triangulate a batch. One sync. Returns (pieces vec3i [p], corners int32 [3 p], loop of each, loops filled)."""
    device, counts = triangles.device, all_loops.counts[batch]
    loops, bits = Loops(all_loops, batch, counts), key_bits(vertices.size)
    launch(begin_loops_kernel, loops.owners.size, [vertices, triangles, loops])
    longest = int(counts.max())
    if longest <= SHORT_LOOP_VERTICES and not device.is_cuda:
        launch(weigh_loops_kernel, len(counts), [all_loops.edge_keys, bits, loops])
    for span in range(2, longest if longest > SHORT_LOOP_VERTICES or device.is_cuda else 0):
        launch(weigh_chords_kernel, loops.owners.size, [all_loops.edge_keys, bits, loops, span])
    mask = compute(mark_closed_kernel, len(batch), [loops], uint8, device)
    rows = np.flatnonzero(download(mask).view(np.bool_))  # sync
    closed, sizes = upload(rows, int32, device), counts[rows] - 2
    offsets = upload(np.concatenate([[0], np.cumsum(sizes)]), int32, device)
    count, stack = int(sizes.sum()), empty(loops.owners.size, int32, device)
    pieces, corners, of_loop = empty(count, vec3i, device), empty(3 * count, int32, device), empty(count, int32, device)
    launch(write_triangles_kernel, closed.size, [loops, closed, offsets, stack, pieces])
    launch(name_pieces_kernel, count, [loops, upload(batch, int32, device), pieces, corners, of_loop])
    return pieces, corners, of_loop, len(rows)


MAX_VERTICES = 1000  # of a loop: 1.7e8 triangles, a second or two on two cores
MAX_CELLS = 2**24  # pairs of vertices at once: 740 MB
MAX_CHORD_PASSES = 8  # over holes that use a chord of another


@kernel
def measure_loops_kernel(
    vertices: array(dtype=vec3),
    of_loop: array(dtype=int32),
    half_edges: array(dtype=int32),
    starts: array(dtype=int32),
    radii: array(dtype=float64),
):
    """Largest distance [m] of a loop's vertices from their box center. NaN if not finite, inf for a single triangle."""
    i = tid()
    first = starts[i]
    last = starts[i + 1]
    low = widen(vertices[of_loop[first]])
    high = low + vec3d(0.0, 0.0, 0.0)
    gap = float64(0.0)  # becomes NaN with any vertex that is not finite
    alone = 1
    for j in range(first, last):
        p = widen(vertices[of_loop[j]])
        gap += (p[0] - p[0]) + (p[1] - p[1]) + (p[2] - p[2])
        low = vec3d(min(low[0], p[0]), min(low[1], p[1]), min(low[2], p[2]))
        high = vec3d(max(high[0], p[0]), max(high[1], p[1]), max(high[2], p[2]))
        if half_edges[j] // 3 != half_edges[first] // 3:
            alone = 0
    middle = (low + high) * 0.5
    farthest = float64(0.0)
    for j in range(first, last):
        farthest = max(farthest, length(widen(vertices[of_loop[j]]) - middle))
    if alone == 1:
        farthest = float64(INFINITY)
    radii[i] = farthest + gap


@kernel
def find_conflicts_kernel(edges: UniqueKeys, of_loop: array(dtype=int32), waits: array(dtype=int32)):
    """1 for loops that use a chord of an earlier one. All threads write the same value."""
    i = tid()
    first = edges.starts[i]
    last = edges.starts[i + 1]
    if last - first > 2:
        first_loop = of_loop[edges.order[first] // 3]
        for j in range(first, last):
            first_loop = min(first_loop, of_loop[edges.order[j] // 3])
        for j in range(first, last):
            loop = of_loop[edges.order[j] // 3]
            if loop != first_loop:
                atomic_max(waits, loop, 1)


@kernel
def mask_accepted_kernel(of_loop: array(dtype=int32), waits: array(dtype=int32), mask: array(dtype=uint8)):
    i = tid()
    mask[i] = uint8(1 - waits[of_loop[i]])


@kernel
def gather_three_kernel(values: array(dtype=int32), rows: array(dtype=int32), gathered: array(dtype=int32)):
    i = tid()
    for k in range(3):
        gathered[3 * i + k] = values[3 * rows[i] + k]


class BoundaryLoops:
    """All loops of a mesh: vertices and half-edges (device), starts and radii (NumPy)."""

    def __init__(self, vertices: Points, triangles: Triangles) -> None:
        border = Border(triangles, vertices.size)
        rows, loops, starts = find_loops(border)  # sync
        self.vertices, self.half_edges = gather_rows(border.vertices, rows), gather_rows(border.half_edges, rows)
        self.starts, self.edge_keys, self.border_count = loops.starts, border.edges.keys, border.half_edges.size
        self.counts = np.diff(starts)
        radii = empty(loops.count, float64, vertices.device)
        launch(measure_loops_kernel, loops.count, [vertices, self.vertices, self.half_edges, self.starts, radii])
        self.radii = download(radii).copy()  # sync


def plan_batches(chosen: np.ndarray, counts: np.ndarray) -> list[np.ndarray]:
    """Batches of loops of similar size with at most MAX_CELLS chords, largest first."""
    order, batches, cells = chosen[np.argsort(-counts[chosen], kind="stable")], [], 0
    for loop, count in zip(order.tolist(), counts[order].tolist(), strict=True):
        cells += count * count
        if not batches or cells > MAX_CELLS or 2 * count < counts[batches[-1][0]]:
            batches.append([])
            cells = count * count
        batches[-1].append(loop)
    return [np.array(batch) for batch in batches]


def drop_conflicts(
    pieces: Triangles, corners: Indices, of_loop: Integers, loop_count: int, vertex_count: int
) -> tuple[Triangles, Indices, int]:
    """Remove loops that share a chord with an earlier one. Return pieces, corners, and the number of waiting loops."""
    device = pieces.device
    edges, waits = find_edges(pieces, vertex_count, padded=True), zeros(loop_count, int32, device)
    launch(find_conflicts_kernel, edges.count, [edges, of_loop, waits])
    waiting = int(download(waits).sum())  # sync
    if not waiting:
        return pieces, corners, 0
    mask = compute(mask_accepted_kernel, pieces.size, [of_loop, waits], uint8, device)
    rows = positions_of(mask)  # sync
    kept_corners = empty(3 * rows.size, int32, device)
    launch(gather_three_kernel, rows.size, [corners, rows, kept_corners])
    return gather_rows(pieces, rows), kept_corners, waiting


class Filling:
    """Triangles that fill holes with a radius up to `hole_size` [m]. `triangles` begins with those of the mesh;
    `corners` are the half-edges whose start vertices the new corners use; `filled` and `left` count holes."""

    def __init__(self, vertices: Points, triangles: Triangles, hole_size: float) -> None:
        self.triangles, self.filled, waiting = triangles, 0, 1
        self.corners = empty(0, int32, triangles.device)
        for _ in range(MAX_CHORD_PASSES):
            if waiting:
                waiting = self._fill(vertices, hole_size)

    def _fill(self, vertices: Points, hole_size: float) -> int:
        all_loops = BoundaryLoops(vertices, self.triangles)
        within = all_loops.radii <= hole_size
        chosen = np.flatnonzero(within & (all_loops.counts <= MAX_VERTICES))
        self.left = int(within.sum())
        parts = [
            close_loops(vertices, self.triangles, all_loops, batch) for batch in plan_batches(chosen, all_loops.counts)
        ]
        if not parts:
            return 0
        pieces, corners, of_loop = (joined_rows(rows) for rows in list(zip(*parts, strict=True))[:3])
        closed = sum(count for *_, count in parts)
        pieces, corners, waiting = drop_conflicts(pieces, corners, of_loop, len(all_loops.counts), vertices.size)
        self.filled += closed - waiting
        self.left -= closed - waiting
        self.triangles = concatenate_rows([self.triangles, pieces])
        self.corners = concatenate_rows([self.corners, corners]) if self.corners.size else corners
        return waiting


@kernel
def spread_corners_kernel(values: array(dtype=vec2), corners: array(dtype=int32), first: int, out: array(dtype=vec2)):
    i = tid()
    out[first + i] = values[corners[i]]


@kernel
def spread_ids_kernel(ids: array(dtype=int32), corners: array(dtype=int32), first: int, out: array(dtype=int32)):
    """Append the material of the triangle at the first corner of each new one."""
    i = tid()
    out[first + i] = ids[corners[3 * i] // 3]


def spread_corners(values: Array1[vec2], corners: Indices) -> Array1[vec2]:
    out = empty(values.size + corners.size, vec2, values.device)
    copy(out, values, count=values.size)
    launch(spread_corners_kernel, corners.size, [values, corners, values.size, out])
    return out


def spread_ids(ids: Indices, corners: Indices) -> Integers:
    out = empty(ids.size + corners.size // 3, int32, ids.device)
    copy(out, ids, count=ids.size)
    launch(spread_ids_kernel, corners.size // 3, [ids, corners, ids.size, out])
    return out
