"""Marching cubes over a dense field: packed signs, counts, a prefix sum, then vertices and triangles written in place.

The field is [rows, nz], a row for each (x, y) with y fastest; samples along z are packed into words of 32 signs. A cell
or edge is named by its lower corner. Each pass works on words, so that 32 cells away from the surface cost one test:

1. pack: signs (value < level) and finiteness of 32 samples a thread; reads the field once, 4 B a sample.
2. count: per row, crossing edges as XORs of sign words, cells that hold surface, triangles by table.
3. prefix sum over the rows, the one wait for the device: sizes are then known.
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
    loop,
    struct,
    tid,
    vec3,
    vec3i,
    vec4i,
)
from ..memory import download, empty, zeros
from .bit_rows import WORD, above, bit, bits_below, has_next, lowest_bit, with_below
from .cube_table import MAX_TRIANGLES, CubeTables, device_tables

EDGES = 3 * MAX_TRIANGLES  # entries of the triangle table a case


@struct
class SampledField:
    """A field on a grid of samples.

    Attributes:
        values: float32 [nx * ny, nz].
        nx, ny, nz: Samples along each axis.
        level: The value on the surface.
        origin, spacing: Place [m] of sample (0, 0, 0), and the distance [m] between neighbours along each axis.
    """

    values: array(dtype=float32, ndim=2)
    ny: int
    nz: int
    level: float
    origin: vec3
    spacing: vec3

    def __init__(self, values, shape, level, origin, spacing):
        self.values, (self.nx, self.ny, self.nz), self.level = values, shape, level
        self.origin, self.spacing = vec3(*origin), vec3(*spacing)


@struct
class SignGrid:
    """On which side of the level the samples of a field lie, a bit each.

    Attributes:
        width: Words a row.
        rows: Rows, one for each (x, y).
        ny, nz: Rows with one x, and samples a row.
        signs: int32 [rows * width], set below the level.
        finite: Likewise, set for finite samples.
        whole: Likewise, set for cells whose eight corners are finite; undefined where all samples are.
        has_gaps: int32 [1], 1 where a sample is not finite.
    """

    width: int
    rows: int
    ny: int
    nz: int
    signs: array(dtype=int32)
    finite: array(dtype=int32)
    whole: array(dtype=int32)
    has_gaps: array(dtype=int32)

    def __init__(self, field):
        device, self.ny, self.nz = field.values.device, field.ny, field.nz
        self.width, self.rows = -(-field.nz // WORD), field.nx * field.ny
        self.signs, self.finite, self.whole = (empty(self.rows * self.width, int32, device) for _ in range(3))
        self.has_gaps = zeros(1, int32, device)
        launch(pack_signs_kernel, self.rows * self.width, [field, self])
        launch(find_whole_cells_kernel, self.rows, [self])


@struct
class SurfaceEdges:
    """The edges that cross the level, and where the vertices and triangles of each row begin.

    Attributes:
        words: vec4i [rows * width]: vertices of the row before this word, then the crossing edges along x, y, z.
        offsets: int32 [2 * rows + 1], of the vertices of all rows, then of the triangles of all rows.
    """

    words: array(dtype=vec4i)
    offsets: array(dtype=int32)

    def __init__(self, grid, tables):
        device = grid.signs.device
        self.words, counts = empty(grid.rows * grid.width, vec4i, device), empty(2 * grid.rows, int32, device)
        launch(count_surface_kernel, grid.rows, [grid, tables, self, counts])
        self.offsets, self.total = exclusive_scan(counts)  # sync


@kernel
def pack_signs_kernel(field: SampledField, grid: SignGrid):
    """One thread a word; bits beyond the end of the row are zero."""
    i = tid()
    row = i // grid.width
    first = (i - row * grid.width) * WORD
    size = min(field.nz - first, WORD)
    below = int(0)
    known = int(0)
    for j in range(size):
        value = field.values[row, first + j]
        if value < field.level:
            below = below | (1 << j)
        if isfinite(value):
            known = known | (1 << j)
    grid.signs[i] = below
    grid.finite[i] = known
    if bit_count(known) < size:
        atomic_max(grid.has_gaps, 0, 1)  # set by any thread


@func
def finite_pairs(row: int, w: int, grid: SignGrid) -> int:
    """The samples of a word that are finite, as is the one above them."""
    return grid.finite[row * grid.width + w] & above(grid.finite, row, w, grid.width)


@kernel
def find_whole_cells_kernel(grid: SignGrid):
    """The cells whose eight corners are finite; one thread a row. Does nothing where the whole field is finite."""
    i = tid()
    if grid.has_gaps[0] == 0:
        return
    y = i % grid.ny
    for w in range(grid.width):
        cells = int(0)
        if y + 1 < grid.ny and i + grid.ny < grid.rows:
            cells = has_next(w, grid.nz) & finite_pairs(i, w, grid) & finite_pairs(i + 1, w, grid)
            cells = cells & finite_pairs(i + grid.ny, w, grid) & finite_pairs(i + grid.ny + 1, w, grid)
        grid.whole[i * grid.width + w] = cells


@func
def sign_word(row: int, w: int, grid: SignGrid) -> int:
    """The signs of a word's samples."""
    return grid.signs[row * grid.width + w]


@func
def signs_above(row: int, w: int, grid: SignGrid) -> int:
    """The signs of the samples above those of a word."""
    return above(grid.signs, row, w, grid.width)


@func
def surface_cells(row: int, w: int, grid: SignGrid) -> int:
    """The cells of a word with corners on both sides of the level."""
    a = sign_word(row, w, grid)
    b = sign_word(row + 1, w, grid)
    c = sign_word(row + grid.ny, w, grid)
    d = sign_word(row + grid.ny + 1, w, grid)
    mixed = (a ^ b) | (a ^ c) | (a ^ d)
    mixed = mixed | (a ^ signs_above(row, w, grid)) | (a ^ signs_above(row + 1, w, grid))
    mixed = mixed | (a ^ signs_above(row + grid.ny, w, grid)) | (a ^ signs_above(row + grid.ny + 1, w, grid))
    mixed = mixed & has_next(w, grid.nz)
    if grid.has_gaps[0] != 0:
        mixed = mixed & grid.whole[row * grid.width + w]
    return mixed


@func
def cell_case(row: int, w: int, j: int, grid: SignGrid) -> int:
    """The case of cell j of a word: bit c is corner c."""
    low = bit(sign_word(row, w, grid), j) | (bit(sign_word(row + grid.ny, w, grid), j) << 1)
    low = low | (bit(sign_word(row + 1, w, grid), j) << 2) | (bit(sign_word(row + grid.ny + 1, w, grid), j) << 3)
    high = bit(signs_above(row, w, grid), j) | (bit(signs_above(row + grid.ny, w, grid), j) << 1)
    high = high | (bit(signs_above(row + 1, w, grid), j) << 2)
    high = high | (bit(signs_above(row + grid.ny + 1, w, grid), j) << 3)
    return low | (high << 4)


@loop
def surface_cases(row: int, w: int, cells: int, grid: SignGrid) -> tuple[int, int]:
    """The sample and the case of each of the cells of a word, ascending."""
    left = cells + 0
    while left != 0:
        j = lowest_bit(left)
        left = left ^ (1 << j)
        case = cell_case(row, w, j, grid)
        yield j, case


@func
def crossing_edges(row: int, w: int, grid: SignGrid) -> vec4i:
    """(0, x, y, z): the edges of the samples of a word that cross the level, by axis."""
    y = row % grid.ny
    a = sign_word(row, w, grid)
    ex = int(0)
    ey = int(0)
    ez = (a ^ signs_above(row, w, grid)) & has_next(w, grid.nz)
    if row + grid.ny < grid.rows:
        ex = a ^ sign_word(row + grid.ny, w, grid)
    if y + 1 < grid.ny:
        ey = a ^ sign_word(row + 1, w, grid)
    if grid.has_gaps[0] != 0:  # an edge needs one whole cell of the four around it
        along_x = with_below(grid.whole, row, w, grid.width)
        along_y = along_x + 0
        along_z = grid.whole[row * grid.width + w]
        if y > 0:
            along_x = along_x | with_below(grid.whole, row - 1, w, grid.width)
            along_z = along_z | grid.whole[(row - 1) * grid.width + w]
        if row >= grid.ny:
            along_y = along_y | with_below(grid.whole, row - grid.ny, w, grid.width)
            along_z = along_z | grid.whole[(row - grid.ny) * grid.width + w]
        if y > 0 and row >= grid.ny:
            along_z = along_z | grid.whole[(row - grid.ny - 1) * grid.width + w]
        ex = ex & along_x
        ey = ey & along_y
        ez = ez & along_z
    return vec4i(0, ex, ey, ez)


@kernel
def count_surface_kernel(grid: SignGrid, tables: CubeTables, edges: SurfaceEdges, counts: array(dtype=int32)):
    """Per row: the edge words, and in `counts` the vertices of all rows followed by the triangles of all rows."""
    i = tid()
    vertices = int(0)
    triangles = int(0)
    has_cells = int(0)
    if i % grid.ny + 1 < grid.ny and i + grid.ny < grid.rows:
        has_cells = 1
    for w in range(grid.width):
        crossing = crossing_edges(i, w, grid)
        edges.words[i * grid.width + w] = vec4i(vertices, crossing[1], crossing[2], crossing[3])
        vertices += bit_count(crossing[1]) + bit_count(crossing[2]) + bit_count(crossing[3])
        cells = int(0)
        if has_cells == 1:
            cells = surface_cells(i, w, grid)
        for j, case in surface_cases(i, w, cells, grid):
            triangles += tables.triangle_count[case]
    counts[i] = vertices
    counts[grid.rows + i] = triangles


@func
def crossing_place(a: float, b: float, level: float) -> float:
    """Where between a and b the level lies, 0..1; in double precision, since b - a may pass the range of a float."""
    return float((float64(level) - float64(a)) / (float64(b) - float64(a)))


@kernel
def write_vertices_kernel(field: SampledField, grid: SignGrid, edges: SurfaceEdges, vertices: array(dtype=vec3)):
    """The vertices of a row, by z, then axis."""
    i = tid()
    n = edges.offsets[i]
    if edges.offsets[i + 1] == n:
        return
    x = field.origin[0] + field.spacing[0] * float(i // field.ny)
    y = field.origin[1] + field.spacing[1] * float(i % field.ny)
    for w in range(grid.width):
        crossing = edges.words[i * grid.width + w]
        left = crossing[1] | crossing[2] | crossing[3]
        while left != 0:
            j = lowest_bit(left)
            left = left ^ (1 << j)
            k = w * WORD + j
            z = field.origin[2] + field.spacing[2] * float(k)
            a = field.values[i, k]
            if bit(crossing[1], j) == 1:
                share = crossing_place(a, field.values[i + field.ny, k], field.level)
                vertices[n] = vec3(x + field.spacing[0] * share, y, z)
                n += 1
            if bit(crossing[2], j) == 1:
                share = crossing_place(a, field.values[i + 1, k], field.level)
                vertices[n] = vec3(x, y + field.spacing[1] * share, z)
                n += 1
            if bit(crossing[3], j) == 1:
                share = crossing_place(a, field.values[i, k + 1], field.level)
                vertices[n] = vec3(x, y, z + field.spacing[2] * share)
                n += 1


@func
def vertex_number(edge: int, row: int, k: int, grid: SignGrid, edges: SurfaceEdges, tables: CubeTables) -> int:
    """The vertex on an edge of the cell at sample k of a row."""
    corner = tables.edge_corner[edge]
    owner = row + (corner & 1) * grid.ny + ((corner >> 1) & 1)
    z = k + (corner >> 2)
    j = z & (WORD - 1)
    crossing = edges.words[owner * grid.width + z // WORD]
    below = bits_below(j)
    n = edges.offsets[owner] + crossing[0] + bit_count(crossing[1] & below) + bit_count(crossing[2] & below)
    n += bit_count(crossing[3] & below)
    if edge >= 4:
        n += bit(crossing[1], j)
    if edge >= 8:
        n += bit(crossing[2], j)
    return n


@kernel
def write_triangles_kernel(grid: SignGrid, edges: SurfaceEdges, tables: CubeTables, triangles: array(dtype=vec3i)):
    """The triangles of a row of cells, by z, then in the order of the table."""
    i = tid()
    first = edges.offsets[grid.rows + i]
    n = first - edges.offsets[grid.rows]
    if edges.offsets[grid.rows + i + 1] == first:
        return
    for w in range(grid.width):
        cells = surface_cells(i, w, grid)
        for j, case in surface_cases(i, w, cells, grid):
            k = w * WORD + j
            for t in range(tables.triangle_count[case]):
                entry = case * EDGES + 3 * t
                a = vertex_number(tables.triangle_edges[entry], i, k, grid, edges, tables)
                b = vertex_number(tables.triangle_edges[entry + 1], i, k, grid, edges, tables)
                c = vertex_number(tables.triangle_edges[entry + 2], i, k, grid, edges, tables)
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
    samples, device = SampledField(field, shape, level, origin, spacing), field.device
    grid, tables = SignGrid(samples), device_tables(device)
    edges = SurfaceEdges(grid, tables)
    vertex_count = int(download(edges.offsets[grid.rows : grid.rows + 1])[0])  # sync; nothing is left to wait for
    vertices, triangles = empty(vertex_count, vec3, device), empty(edges.total - vertex_count, vec3i, device)
    if edges.total:
        launch(write_vertices_kernel, grid.rows, [samples, grid, edges, vertices])
        launch(write_triangles_kernel, grid.rows, [grid, edges, tables, triangles])
    return vertices, triangles
