"""The triangulation of least weight of each of many loops.

Of a loop of n vertices it is found from short chords to long ones (Barequet and Sharir, "Filling gaps in the boundary
of a polyhedron", CAGD 12, 1995): n^3 / 6 triangles are looked at, and n^2 chords kept at 44 B each. A weight is the
sharpest bend at any edge, to neighbours in the hole and around it, then the sum of the squared sides: after Liepa,
"Filling holes in meshes", SGP 2003, section 3, with sides in the place of areas, since in a plane all triangulations
have one area. Bends are compared in steps, so that rounding does not choose. A chord that is an edge of the mesh
already is not taken. The chords that span as many sides are one thread each; all in float64, the same bits everywhere.
"""

from typing import TYPE_CHECKING

import numpy as np

from ..algebra.transform import widen
from ..array_types import Indices, Points, Triangles
from ..arrays.select import gather_rows
from ..lang import (
    INFINITY,
    array,
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
    vec3,
    vec3d,
    vec3i,
)
from ..memory import download, empty, full, upload, zeros
from .mesh_edges import edge_key, find_edge, key_bits, spread_runs_kernel
from .mesh_measures import triangle_cross

if TYPE_CHECKING:
    from .holes import FoundLoops

STEPS = 256.0  # in which bends of 0..2 are compared: the first is 5 degrees, later ones are less


@kernel
def list_entries_kernel(
    starts: array(dtype=int32),
    owners: array(dtype=int32),
    sources: array(dtype=int32),
    source_starts: array(dtype=int32),
    rows: array(dtype=int32),
):
    """Where each vertex of the chosen loops stands along all loops."""
    i = tid()
    rows[i] = source_starts[sources[owners[i]]] + i - starts[owners[i]]


@struct
class Loops:
    """Loops to be closed.

    Attributes:
        vertices: int32 [k], along the loops, as the triangles at the border run; they run the hole the other way.
        half_edges: int32 [k], from each vertex to the next.
        starts: int32 [l + 1], where each loop begins.
        owners: int32 [k], the loop of each.
        cells: int32 [l], where the chords of each loop begin; chord (i, j) of n vertices is n i + j further.
        points: vec3d [k].
        bends, sizes: float64 weights of the best triangulation beyond each chord.
        normals: vec3d, of the triangle beyond each chord, of the mesh beyond sides; zero where it has no area.
        tips: int32, the vertex of the loop that makes a triangle with the chord; -1 where there is none.
    """

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

    def __init__(self, found: "FoundLoops", chosen: np.ndarray, counts: np.ndarray) -> None:
        """Some of the loops of FoundLoops, with their numbers of vertices (NumPy arrays)."""
        device, square = found.vertices.device, counts.astype(np.int64) ** 2
        starts, entries = np.concatenate([[0], np.cumsum(counts)]), int(counts.sum())
        self.starts, self.owners = upload(starts, int32, device), empty(entries, int32, device)
        launch(spread_runs_kernel, len(counts), [self.starts, self.owners])
        rows, sources = empty(entries, int32, device), upload(chosen, int32, device)
        launch(list_entries_kernel, entries, [self.starts, self.owners, sources, found.starts, rows])
        self.vertices, self.half_edges = gather_rows(found.vertices, rows), gather_rows(found.half_edges, rows)
        self.cells = upload(np.concatenate([[0], np.cumsum(square)])[:-1], int32, device)
        count = int(square.sum())
        self.bends, self.sizes = zeros(count, float64, device), zeros(count, float64, device)
        self.normals, self.points = zeros(count, vec3d, device), empty(entries, vec3d, device)
        self.tips = full(count, -1, int32, device)


@kernel
def begin_loops_kernel(vertices: array(dtype=vec3), triangles: array(dtype=vec3i), loops: Loops):
    """The point of each vertex, and beyond the side after it the normal of the mesh; the last side closes the loop."""
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
    """The direction of a vector, zero where it has none."""
    size = length(n)
    unit = vec3d(0.0, 0.0, 0.0)
    if size > 0.0:
        unit = n / size
    return unit


@func
def bend_to(n: vec3d, m: vec3d) -> float64:
    """1 - cos of the angle between two unit normals; 0 where the second is none."""
    bend = float64(0.0)
    if dot(m, m) > 0.5:
        bend = 1.0 - dot(n, m)
    return bend


@func
def square_side(a: vec3d, b: vec3d) -> float64:
    """The squared distance of two points."""
    d = a - b
    return dot(d, d)


@kernel
def weigh_chords_kernel(edge_keys: array(dtype=int64), bits: int, loops: Loops, span: int):
    """The best triangle at each chord that spans so many sides of its loop; chords of fewer sides are weighed."""
    p = tid()
    first = loops.starts[loops.owners[p]]
    count = loops.starts[loops.owners[p] + 1] - first
    i = p - first
    j = i + span
    if j >= count:
        return
    base = loops.cells[loops.owners[p]]
    at = base + i * count + j
    a = loops.points[first + i]
    c = loops.points[first + j]
    whole = 0
    if i == 0 and j + 1 == count:
        whole = 1
    across = loops.normals[base + (count - 1) * count]
    side = square_side(a, c)
    best_bend = float64(INFINITY)
    best_size = float64(INFINITY)
    best_normal = vec3d(0.0, 0.0, 0.0)
    best = -1
    last = j
    taken = find_edge(edge_key(loops.vertices[first + i], loops.vertices[first + j], bits), edge_keys)
    if taken >= 0 and whole == 0:
        last = i + 1
    for k in range(i + 1, last):
        left = base + i * count + k
        right = base + k * count + j
        bend = max(loops.bends[left], loops.bends[right])  # infinite where a chord cannot be taken
        if bend <= best_bend and bend < float64(INFINITY):
            b = loops.points[first + k]
            n = cross(b - c, a - c)
            unit = unit_or_none(n)
            sharpest = float64(2.0)
            if dot(unit, unit) > 0.5:
                sharpest = max(bend_to(unit, loops.normals[left]), bend_to(unit, loops.normals[right]))
                if whole == 1:
                    sharpest = max(sharpest, bend_to(unit, across))
            bend = max(floor(sharpest * float64(STEPS)), bend)
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
def mark_closed_kernel(loops: Loops, closed: array(dtype=uint8)):
    """1 for loops that have a triangulation."""
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
    """The triangles of a loop, as places along all loops; one thread a loop, two less than it has vertices."""
    i = tid()
    loop = chosen[i]
    first = loops.starts[loop]
    count = loops.starts[loop + 1] - first
    base = loops.cells[loop]
    written = offsets[i]
    stack[first] = count - 1  # chords as they lie in a row of cells
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
    """Pieces by vertices in the place of places; the half-edges that start there; the number of each one's loop."""
    i = tid()
    p = pieces[i]
    for k in range(3):
        corners[3 * i + k] = loops.half_edges[p[k]]
    pieces[i] = vec3i(loops.vertices[p[0]], loops.vertices[p[1]], loops.vertices[p[2]])
    of_loop[i] = numbers[loops.owners[p[0]]]


def close_loops(
    vertices: Points, triangles: Triangles, found: "FoundLoops", batch: np.ndarray
) -> tuple[Triangles, Indices, Indices, int]:
    """The pieces of the loops of a batch that can be closed; one sync.

    Returns:
        (pieces, corners, of_loop, closed): vec3i [p], int32 [3 p], the loop of each, int32 [p]; how many were closed.
    """
    device, counts = triangles.device, found.counts[batch]
    loops, bits = Loops(found, batch, counts), key_bits(vertices.size)
    launch(begin_loops_kernel, loops.owners.size, [vertices, triangles, loops])
    for span in range(2, int(counts.max())):
        launch(weigh_chords_kernel, loops.owners.size, [found.edge_keys, bits, loops, span])
    mask = empty(len(batch), uint8, device)
    launch(mark_closed_kernel, len(batch), [loops, mask])
    rows = np.flatnonzero(download(mask))  # sync
    closed, sizes = upload(rows, int32, device), counts[rows] - 2
    offsets = upload(np.concatenate([[0], np.cumsum(sizes)]), int32, device)
    count, stack = int(sizes.sum()), empty(loops.owners.size, int32, device)
    pieces, corners, of_loop = empty(count, vec3i, device), empty(3 * count, int32, device), empty(count, int32, device)
    launch(write_triangles_kernel, closed.size, [loops, closed, offsets, stack, pieces])
    launch(name_pieces_kernel, count, [loops, upload(batch, int32, device), pieces, corners, of_loop])
    return pieces, corners, of_loop, len(rows)
