"""The triangulation of least weight of each of many loops.

Of a loop of n vertices it is found from short chords to long ones (Barequet and Sharir, "Filling gaps in the boundary
of a polyhedron", CAGD 12, 1995): n^3 / 6 triangles are looked at, and n^2 chords kept at 20 B each. A weight is the
sharpest bend at any edge, to neighbours in the hole and around it, then the sum of the squared sides: after Liepa,
"Filling holes in meshes", SGP 2003, section 3, with sides in the place of areas, since in a plane all triangulations
have one area. Bends are compared in steps, so that rounding does not choose. A chord that is an edge of the mesh
already is not taken. The chords that span as many sides are one thread each; all in float64, the same bits everywhere.
"""

import numpy as np

from ..algebra.transform import widen
from ..arrays.select import gather_rows, positions_of
from ..lang import (
    INFINITY,
    array,
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
        bends, sizes: float64 weights of the best triangulation beyond each chord.
        tips: int32, the vertex of the loop that makes a triangle with the chord; -1 where there is none.
    """

    vertices: array(dtype=int32)
    half_edges: array(dtype=int32)
    starts: array(dtype=int32)
    owners: array(dtype=int32)
    cells: array(dtype=int32)
    bends: array(dtype=float64)
    sizes: array(dtype=float64)
    tips: array(dtype=int32)

    def __init__(self, found, chosen, counts):
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
        self.tips = full(count, -1, int32, device)


@func
def bend_between(n: vec3d, m: vec3d, one_sided: int) -> float64:
    """1 - cos of the angle between two normals; 2 where the first, or without `one_sided` either, has no length."""
    size = length(n) * length(m)
    bend = float64(2.0)
    if size > float64(0.0):
        bend = float64(1.0) - dot(n, m) / size
    elif one_sided == 1 and length(n) > float64(0.0):
        bend = float64(0.0)
    return bend


@func
def normal_beyond(
    vertices: array(dtype=vec3), triangles: array(dtype=vec3i), loops: Loops, first: int, cell: int, i: int, j: int
) -> vec3d:
    """The normal of the triangle beyond the chord from i to j: of the mesh for neighbours, else of the hole."""
    n = vec3d(float64(0.0), float64(0.0), float64(0.0))
    if j == i + 1:
        n = triangle_cross(vertices, triangles[loops.half_edges[first + i] // 3])
    else:
        k = loops.tips[cell]
        if k >= 0:
            n = triangle_cross(
                vertices, vec3i(loops.vertices[first + j], loops.vertices[first + k], loops.vertices[first + i])
            )
    return n


@func
def square_side(vertices: array(dtype=vec3), a: int, b: int) -> float64:
    """The squared distance of two vertices."""
    d = widen(vertices[a]) - widen(vertices[b])
    return dot(d, d)


@kernel
def weigh_chords_kernel(
    vertices: array(dtype=vec3),
    triangles: array(dtype=vec3i),
    edge_keys: array(dtype=int64),
    bits: int,
    loops: Loops,
    span: int,
):
    """The best triangle at each chord that spans so many sides of its loop; chords of fewer sides are weighed."""
    p = tid()
    first = loops.starts[loops.owners[p]]
    count = loops.starts[loops.owners[p] + 1] - first
    i = p - first
    j = i + span
    if j >= count:
        return
    base = loops.cells[loops.owners[p]]
    a = loops.vertices[first + i]
    c = loops.vertices[first + j]
    whole = int(0)
    if i == 0 and j + 1 == count:
        whole = 1
    best_bend = float64(INFINITY)
    best_size = float64(INFINITY)
    best = int(-1)
    taken = find_edge(edge_key(a, c, bits), edge_keys)
    last = j + 0
    if taken >= 0 and whole == 0:
        last = i + 1
    across = vec3d(float64(0.0), float64(0.0), float64(0.0))
    if whole == 1:
        across = triangle_cross(vertices, triangles[loops.half_edges[first + j] // 3])
    for k in range(i + 1, last):
        left = base + i * count + k
        right = base + k * count + j
        open_left = k > i + 1 and loops.tips[left] < 0
        open_right = j > k + 1 and loops.tips[right] < 0
        if not open_left and not open_right:
            b = loops.vertices[first + k]
            n = triangle_cross(vertices, vec3i(c, b, a))
            on_left = normal_beyond(vertices, triangles, loops, first, left, i, k)
            on_right = normal_beyond(vertices, triangles, loops, first, right, k, j)
            bend = max(
                bend_between(n, on_left, 1 if k == i + 1 else 0), bend_between(n, on_right, 1 if j == k + 1 else 0)
            )
            if whole == 1:
                bend = max(bend, bend_between(n, across, 1))
            bend = max(floor(bend * float64(STEPS)), max(loops.bends[left], loops.bends[right]))
            size = square_side(vertices, a, b) + square_side(vertices, b, c) + square_side(vertices, c, a)
            size = size + loops.sizes[left] + loops.sizes[right]
            if bend < best_bend or (bend == best_bend and size < best_size):
                best_bend = bend
                best_size = size
                best = k + 0
    at = base + i * count + j
    loops.bends[at] = best_bend
    loops.sizes[at] = best_size
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
    depth = int(1)
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


def close_loops(vertices, triangles, found, batch):
    """(pieces vec3i [p], corners int32 [3 p], loop of each int32 [p]) of the loops of a batch that can be closed."""
    device, counts = triangles.device, found.counts[batch]
    loops, bits = Loops(found, batch, counts), key_bits(vertices.size)
    for span in range(2, int(counts.max())):
        launch(weigh_chords_kernel, loops.owners.size, [vertices, triangles, found.edge_keys, bits, loops, span])
    mask = empty(len(batch), uint8, device)
    launch(mark_closed_kernel, len(batch), [loops, mask])
    closed = positions_of(mask)  # sync
    sizes = counts[download(closed)] - 2
    offsets = upload(np.concatenate([[0], np.cumsum(sizes)]), int32, device)
    count, stack = int(sizes.sum()), empty(loops.owners.size, int32, device)
    pieces, corners, of_loop = empty(count, vec3i, device), empty(3 * count, int32, device), empty(count, int32, device)
    launch(write_triangles_kernel, closed.size, [loops, closed, offsets, stack, pieces])
    launch(name_pieces_kernel, count, [loops, upload(batch, int32, device), pieces, corners, of_loop])
    return pieces, corners, of_loop
