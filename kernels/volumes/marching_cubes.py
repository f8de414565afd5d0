"""Marching cubes over a dense field: packed signs, counts, one scan, then vertices and triangles written in place.

The field is [rows, nz], a row for each (x, y) with y fastest; samples along z are packed into words of 32 signs. A cell
or edge is named by its lower corner. Each pass works on words, so that 32 cells away from the surface cost one test:

1. pack: signs (value < level) and finiteness of 32 samples a thread; reads the field once, 4 B a sample.
2. count: per row, crossing edges as XORs of sign words, cells that hold surface, triangles by table.
3. scan over the rows, the one wait for the device: sizes are then known.
4. vertices: per row, one for each crossing edge; 5. triangles: per row, corners found again by counting bits.

The number of the vertex on an edge: that of its row, plus that of its word in the row, plus the crossing edges below it
in the word, so no map of the grid is kept: 28 B a word, 0.9 B a sample. No atomics order anything: the same bits from
run to run. Rows without surface are skipped.

A cell with a corner that is not finite makes no triangles, and an edge without a finite cell no vertex. A sample
exactly at the level counts as above it: its vertices coincide there, and triangles may have no area.

Sources: Lorensen and Cline, "Marching cubes", SIGGRAPH 1987; the passes by rows are those of Schroeder, Maynard and
Geveci, "Flying edges", LDAV 2015.
"""

from ..arrays.prefix_sum import exclusive_scan
from ..lang import (
    array,
    atomic_max,
    bit_count,
    float32,
    float64,
    func,
    int32,
    isfinite,
    kernel,
    launch,
    tid,
    vec3,
    vec3i,
    vec4i,
)
from ..memory import empty, zeros
from .cube_table import MAX_TRIANGLES, device_tables
from .sign_words import WORD, above, bit, bits_below, has_next, lowest_bit, with_below

EDGES = 3 * MAX_TRIANGLES  # entries of the triangle table a case


@kernel
def pack_signs_kernel(
    field: array(dtype=float32, ndim=2),
    level: float,
    width: int,
    signs: array(dtype=int32),
    finite: array(dtype=int32),
    has_gaps: array(dtype=int32),
):
    """One thread a word; bits beyond the end of the row are zero."""
    i = tid()
    row = i // width
    first = (i - row * width) * WORD
    size = min(field.shape[1] - first, WORD)
    below = int(0)
    known = int(0)
    for j in range(size):
        value = field[row, first + j]
        if value < level:
            below = below | (1 << j)
        if isfinite(value):
            known = known | (1 << j)
    signs[i] = below
    finite[i] = known
    if bit_count(known) < size:
        atomic_max(has_gaps, 0, 1)  # set by any thread


@kernel
def find_whole_cells_kernel(
    ny: int, nz: int, width: int, finite: array(dtype=int32), has_gaps: array(dtype=int32), whole: array(dtype=int32)
):
    """The cells whose eight corners are finite; one thread a row. Does nothing where the whole field is finite."""
    i = tid()
    if has_gaps[0] == 0:
        return
    y = i % ny
    rows = whole.shape[0] // width
    for w in range(width):
        cells = int(0)
        if y + 1 < ny and i + ny < rows:
            cells = has_next(w, nz)
            cells = cells & finite[i * width + w] & above(finite, i, w, width)
            cells = cells & finite[(i + 1) * width + w] & above(finite, i + 1, w, width)
            cells = cells & finite[(i + ny) * width + w] & above(finite, i + ny, w, width)
            cells = cells & finite[(i + ny + 1) * width + w] & above(finite, i + ny + 1, w, width)
        whole[i * width + w] = cells


@func
def surface_cells(
    signs: array(dtype=int32),
    has_gaps: array(dtype=int32),
    whole: array(dtype=int32),
    row: int,
    w: int,
    ny: int,
    nz: int,
    width: int,
) -> int:
    """The cells of a word with corners on both sides of the level."""
    a = signs[row * width + w]
    b = signs[(row + 1) * width + w]
    c = signs[(row + ny) * width + w]
    d = signs[(row + ny + 1) * width + w]
    mixed = (a ^ b) | (a ^ c) | (a ^ d)
    mixed = mixed | (a ^ above(signs, row, w, width)) | (a ^ above(signs, row + 1, w, width))
    mixed = mixed | (a ^ above(signs, row + ny, w, width)) | (a ^ above(signs, row + ny + 1, w, width))
    mixed = mixed & has_next(w, nz)
    if has_gaps[0] != 0:
        mixed = mixed & whole[row * width + w]
    return mixed


@func
def cell_case(signs: array(dtype=int32), row: int, w: int, j: int, ny: int, width: int) -> int:
    """The case of cell j of a word: bit c is corner c."""
    low = bit(signs[row * width + w], j) | (bit(signs[(row + ny) * width + w], j) << 1)
    low = low | (bit(signs[(row + 1) * width + w], j) << 2) | (bit(signs[(row + ny + 1) * width + w], j) << 3)
    high = bit(above(signs, row, w, width), j) | (bit(above(signs, row + ny, w, width), j) << 1)
    high = high | (bit(above(signs, row + 1, w, width), j) << 2)
    high = high | (bit(above(signs, row + ny + 1, w, width), j) << 3)
    return low | (high << 4)


@func
def crossing_edges(
    signs: array(dtype=int32),
    has_gaps: array(dtype=int32),
    whole: array(dtype=int32),
    row: int,
    w: int,
    ny: int,
    nz: int,
    width: int,
) -> vec4i:
    """(0, x, y, z): the edges of the samples of a word that cross the level, by axis."""
    rows = whole.shape[0] // width
    y = row % ny
    a = signs[row * width + w]
    ex = int(0)
    ey = int(0)
    ez = (a ^ above(signs, row, w, width)) & has_next(w, nz)
    if row + ny < rows:
        ex = a ^ signs[(row + ny) * width + w]
    if y + 1 < ny:
        ey = a ^ signs[(row + 1) * width + w]
    if has_gaps[0] != 0:  # an edge needs one whole cell of the four around it
        along_x = with_below(whole, row, w, width)
        along_y = along_x + 0
        along_z = whole[row * width + w]
        if y > 0:
            along_x = along_x | with_below(whole, row - 1, w, width)
            along_z = along_z | whole[(row - 1) * width + w]
        if row >= ny:
            along_y = along_y | with_below(whole, row - ny, w, width)
            along_z = along_z | whole[(row - ny) * width + w]
        if y > 0 and row >= ny:
            along_z = along_z | whole[(row - ny - 1) * width + w]
        ex = ex & along_x
        ey = ey & along_y
        ez = ez & along_z
    return vec4i(0, ex, ey, ez)


@kernel
def count_surface_kernel(
    ny: int,
    nz: int,
    width: int,
    signs: array(dtype=int32),
    has_gaps: array(dtype=int32),
    whole: array(dtype=int32),
    triangle_count: array(dtype=int32),
    edges: array(dtype=vec4i),
    counts: array(dtype=int32),
):
    """Per row: the edge words, and in `counts` the vertices of all rows followed by the triangles of all rows."""
    i = tid()
    rows = whole.shape[0] // width
    vertices = int(0)
    triangles = int(0)
    has_cells = int(0)
    if i % ny + 1 < ny and i + ny < rows:
        has_cells = 1
    for w in range(width):
        crossing = crossing_edges(signs, has_gaps, whole, i, w, ny, nz, width)
        edges[i * width + w] = vec4i(vertices, crossing[1], crossing[2], crossing[3])
        vertices += bit_count(crossing[1]) + bit_count(crossing[2]) + bit_count(crossing[3])
        cells = int(0)
        if has_cells == 1:
            cells = surface_cells(signs, has_gaps, whole, i, w, ny, nz, width)
        while cells != 0:
            j = lowest_bit(cells)
            cells = cells ^ (1 << j)
            triangles += triangle_count[cell_case(signs, i, w, j, ny, width)]
    counts[i] = vertices
    counts[rows + i] = triangles


@func
def crossing_place(a: float, b: float, level: float) -> float:
    """Where between a and b the level lies, 0..1; in double precision, since b - a may pass the range of a float."""
    return float((float64(level) - float64(a)) / (float64(b) - float64(a)))


@kernel
def write_vertices_kernel(
    field: array(dtype=float32, ndim=2),
    level: float,
    origin: vec3,
    spacing: vec3,
    ny: int,
    width: int,
    edges: array(dtype=vec4i),
    offsets: array(dtype=int32),
    vertices: array(dtype=vec3),
):
    """The vertices of a row, by z, then axis."""
    i = tid()
    n = offsets[i]
    if offsets[i + 1] == n:
        return
    x = origin[0] + spacing[0] * float(i // ny)
    y = origin[1] + spacing[1] * float(i % ny)
    for w in range(width):
        crossing = edges[i * width + w]
        left = crossing[1] | crossing[2] | crossing[3]
        while left != 0:
            j = lowest_bit(left)
            left = left ^ (1 << j)
            k = w * WORD + j
            z = origin[2] + spacing[2] * float(k)
            a = field[i, k]
            if bit(crossing[1], j) == 1:
                vertices[n] = vec3(x + spacing[0] * crossing_place(a, field[i + ny, k], level), y, z)
                n += 1
            if bit(crossing[2], j) == 1:
                vertices[n] = vec3(x, y + spacing[1] * crossing_place(a, field[i + 1, k], level), z)
                n += 1
            if bit(crossing[3], j) == 1:
                vertices[n] = vec3(x, y, z + spacing[2] * crossing_place(a, field[i, k + 1], level))
                n += 1


@func
def vertex_number(
    edges: array(dtype=vec4i),
    offsets: array(dtype=int32),
    edge: int,
    row: int,
    k: int,
    edge_corner: array(dtype=int32),
    ny: int,
    width: int,
) -> int:
    """The vertex on an edge of the cell at sample k of a row."""
    corner = edge_corner[edge]
    owner = row + (corner & 1) * ny + ((corner >> 1) & 1)
    z = k + (corner >> 2)
    j = z & (WORD - 1)
    crossing = edges[owner * width + z // WORD]
    below = bits_below(j)
    n = offsets[owner] + crossing[0] + bit_count(crossing[1] & below) + bit_count(crossing[2] & below)
    n += bit_count(crossing[3] & below)
    if edge >= 4:
        n += bit(crossing[1], j)
    if edge >= 8:
        n += bit(crossing[2], j)
    return n


@kernel
def write_triangles_kernel(
    ny: int,
    nz: int,
    width: int,
    signs: array(dtype=int32),
    has_gaps: array(dtype=int32),
    whole: array(dtype=int32),
    edges: array(dtype=vec4i),
    offsets: array(dtype=int32),
    triangle_count: array(dtype=int32),
    triangle_edges: array(dtype=int32),
    edge_corner: array(dtype=int32),
    triangles: array(dtype=vec3i),
):
    """The triangles of a row of cells, by z, then in the order of the table."""
    i = tid()
    rows = whole.shape[0] // width
    n = offsets[rows + i] - offsets[rows]
    if offsets[rows + i + 1] == offsets[rows + i]:
        return
    for w in range(width):
        cells = surface_cells(signs, has_gaps, whole, i, w, ny, nz, width)
        while cells != 0:
            j = lowest_bit(cells)
            cells = cells ^ (1 << j)
            case = cell_case(signs, i, w, j, ny, width)
            first = case * EDGES
            k = w * WORD + j
            for t in range(triangle_count[case]):
                a = vertex_number(edges, offsets, triangle_edges[first + 3 * t], i, k, edge_corner, ny, width)
                b = vertex_number(edges, offsets, triangle_edges[first + 3 * t + 1], i, k, edge_corner, ny, width)
                c = vertex_number(edges, offsets, triangle_edges[first + 3 * t + 2], i, k, edge_corner, ny, width)
                triangles[n] = vec3i(a, b, c)
                n += 1


def extract_surface(field, shape, level, origin, spacing):
    """The surface where a field passes a level.

    Args:
        field: float32 device array of shape [nx * ny, nz].
        shape: (nx, ny, nz), each at least 2.
        level: The value on the surface.
        origin: Position of sample (0, 0, 0), three numbers.
        spacing: Distance of neighbouring samples along each axis.

    Returns:
        (vertices, triangles): vec3 [m] and vec3i [t] device arrays; every vertex belongs to a triangle.

    Raises:
        ValueError: More vertices or triangles than 32 bits can index.
    """
    nx, ny, nz = shape
    device, rows, width = field.device, nx * ny, -(-nz // WORD)
    tables = device_tables(device)
    signs, finite, whole = (empty(rows * width, int32, device) for _ in range(3))
    has_gaps = zeros(1, int32, device)
    launch(pack_signs_kernel, rows * width, [field, level, width, signs, finite, has_gaps])
    launch(find_whole_cells_kernel, rows, [ny, nz, width, finite, has_gaps, whole])
    edges, counts = empty(rows * width, vec4i, device), empty(2 * rows, int32, device)
    inputs = [ny, nz, width, signs, has_gaps, whole]
    launch(count_surface_kernel, rows, [*inputs, tables.triangle_count, edges, counts])
    offsets, total = exclusive_scan(counts)  # sync
    vertex_count = int(offsets[rows : rows + 1].numpy()[0])  # sync, though nothing is left to wait for
    vertices, triangles = empty(vertex_count, vec3, device), empty(total - vertex_count, vec3i, device)
    if total:
        places = [vec3(*origin), vec3(*spacing)]
        launch(write_vertices_kernel, rows, [field, level, *places, ny, width, edges, offsets, vertices])
        table = [tables.triangle_count, tables.triangle_edges, tables.edge_corner]
        launch(write_triangles_kernel, rows, [*inputs, edges, offsets, *table, triangles])
    return vertices, triangles
