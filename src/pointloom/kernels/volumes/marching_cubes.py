"""Marching cubes on a dense field (Lorensen and Cline, SIGGRAPH 1987).

Row passes after Schroeder, Maynard and Geveci, "Flying edges", LDAV 2015: the field is [rows, nz], y fastest over rows.
Signs along z are packed into 32-bit words. 28 B per word, one sync, no atomics: bitwise reproducible. Cells with a
non-finite corner have no triangles. Samples at the level count as above it, which may give zero-area triangles.
"""

import numpy as np

from ..array_types import Array2, Points, Triangles
from ..arrays.prefix_sum import scan_two
from ..lang import (
    array,
    atomic_max,
    ballot,
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
    vector,
)
from ..memory import empty, host_view, zeros
from .bit_rows import LOW_31, WORD_BITS, above, bit, bits_below, has_next, lowest_bit, with_below
from .cube_table import MAX_TRIANGLES, CubeTables, device_tables


@struct
class SampledField:
    """Field on a grid of `nx`, `ny`, `nz` samples, with isovalue `level`, origin and spacing [m]."""

    values: array(dtype=float32, ndim=2)
    ny: int
    nz: int
    level: float
    origin: vec3
    spacing: vec3

    def __init__(
        self,
        values: Array2[float32],
        shape: tuple[int, int, int],
        level: float,
        origin: np.ndarray,
        spacing: np.ndarray,
    ) -> None:
        self.values, (self.nx, self.ny, self.nz), self.level = values, shape, level
        self.origin, self.spacing = vec3(*origin), vec3(*spacing)


@struct
class SignGrid:
    """Packed signs of a field: `signs` (below the level), `finite` samples, and `complete` cells (8 finite corners;
    undefined if all samples are finite). `has_gaps` int32 [1] is 1 if a sample is not finite."""

    width: int
    rows: int
    ny: int
    nz: int
    signs: array(dtype=int32)
    finite: array(dtype=int32)
    complete: array(dtype=int32)
    has_gaps: array(dtype=int32)

    def __init__(self, field: SampledField) -> None:
        device, self.ny, self.nz = field.values.device, field.ny, field.nz
        self.width, self.rows = -(-field.nz // WORD_BITS), field.nx * field.ny
        self.signs, self.finite, self.complete = (empty(self.rows * self.width, int32, device) for _ in range(3))
        self.has_gaps = zeros(1, int32, device)
        words = self.rows * self.width
        launch(
            pack_signs_kernel, -(-words // WORD_BITS) * WORD_BITS if device.is_cuda else words, [field, self]
        )  # full warps
        if device.is_cuda or host_view(self.has_gaps)[0]:
            launch(find_complete_cells_kernel, self.rows, [self])


@kernel
def pack_signs_kernel(field: SampledField, grid: SignGrid):
    """One thread per word. Bits beyond the row are zero."""
    i = tid()
    row = i // grid.width
    first = (i - row * grid.width) * WORD_BITS
    size = min(field.nz - first, WORD_BITS)
    below = 0
    known = 0
    if size == WORD_BITS:  # a constant count: vector code
        for j in range(WORD_BITS):
            value = field.values[row, first + j]
            below = below | (int(value < field.level) << j)
            known = known | (int(isfinite(value)) << j)
    else:
        for j in range(size):
            value = field.values[row, first + j]
            below = below | (int(value < field.level) << j)
            known = known | (int(isfinite(value)) << j)
    grid.signs[i] = below
    grid.finite[i] = known
    if bit_count(known) < size:
        atomic_max(grid.has_gaps, 0, 1)  # set by any thread


@pack_signs_kernel.on_cuda
def pack_lanes_kernel(field: SampledField, grid: SignGrid):
    """A warp packs the words of its threads together, one sample per lane: coalesced reads."""
    i = tid()
    lane = i % WORD_BITS
    below = 0
    known = 0
    n = int(WORD_BITS)
    for source_lane in range(n):
        word = i - lane + source_lane
        row = word // grid.width
        k = (word - row * grid.width) * WORD_BITS + lane
        is_below = 0
        is_known = 0
        if row < grid.rows and k < field.nz:
            value = field.values[row, k]
            is_below = int(value < field.level)
            is_known = int(isfinite(value))
        signs = ballot(is_below)
        finite = ballot(is_known)
        if lane == source_lane:
            below = signs
            known = finite
    if i < grid.rows * grid.width:
        grid.signs[i] = below
        grid.finite[i] = known
        if bit_count(known) < min(field.nz - i % grid.width * WORD_BITS, WORD_BITS):
            atomic_max(grid.has_gaps, 0, 1)  # set by any thread


@func
def finite_pairs(row: int, w: int, grid: SignGrid) -> int:
    """Finite samples of a word whose upper neighbor is finite too."""
    return grid.finite[row * grid.width + w] & above(grid.finite, row, w, grid.width)


@kernel
def find_complete_cells_kernel(grid: SignGrid):
    """Cells with eight finite corners. One thread per row. No effect if the field is finite."""
    i = tid()
    if grid.has_gaps[0] == 0:
        return
    y = i % grid.ny
    for w in range(grid.width):
        cells = 0
        if y + 1 < grid.ny and i + grid.ny < grid.rows:
            cells = has_next(w, grid.nz) & finite_pairs(i, w, grid) & finite_pairs(i + 1, w, grid)
            cells = cells & finite_pairs(i + grid.ny, w, grid) & finite_pairs(i + grid.ny + 1, w, grid)
        grid.complete[i * grid.width + w] = cells


ENTRIES_PER_CASE = 3 * MAX_TRIANGLES  # entries of a case in the triangle table
cell_edges = vector(12, int32)


@struct
class SurfaceEdges:
    """Crossing edges: `words` vec4i (vertices of the row before, bits x, y, z); `offsets` of vertices, triangles."""

    words: array(dtype=vec4i)
    offsets: array(dtype=int32)

    def __init__(self, grid: SignGrid, tables: CubeTables) -> None:
        device = grid.signs.device
        self.words, counts = empty(grid.rows * grid.width, vec4i, device), empty(2 * grid.rows, int32, device)
        launch(count_surface_kernel, grid.rows, [grid, tables, self, counts])
        largest = MAX_TRIANGLES * WORD_BITS * grid.width  # of a row, which has 3 edges per sample
        self.offsets, self.vertex_count, self.total = scan_two(counts, largest)  # sync


@func
def sign_word(row: int, w: int, grid: SignGrid) -> int:
    return grid.signs[row * grid.width + w]


@func
def signs_above(row: int, w: int, grid: SignGrid) -> int:
    return above(grid.signs, row, w, grid.width)


@func
def surface_cells(row: int, w: int, grid: SignGrid) -> int:
    a = sign_word(row, w, grid)
    b = sign_word(row + 1, w, grid)
    c = sign_word(row + grid.ny, w, grid)
    d = sign_word(row + grid.ny + 1, w, grid)
    mixed = (a ^ b) | (a ^ c) | (a ^ d)
    mixed = mixed | (a ^ signs_above(row, w, grid)) | (a ^ signs_above(row + 1, w, grid))
    mixed = mixed | (a ^ signs_above(row + grid.ny, w, grid)) | (a ^ signs_above(row + grid.ny + 1, w, grid))
    mixed = mixed & has_next(w, grid.nz)
    if grid.has_gaps[0] != 0:
        mixed = mixed & grid.complete[row * grid.width + w]
    return mixed


@loop
def surface_cases(row: int, w: int, cells: int, grid: SignGrid) -> tuple[int, int]:
    """Sample and case of each surface cell of a word. Sign words are read once, as the loop body might alias them."""
    left = cells
    a = 0
    b = 0
    c = 0
    d = 0
    e = 0
    f = 0
    g = 0
    h = 0
    if left != 0:
        a = sign_word(row, w, grid)
        b = sign_word(row + grid.ny, w, grid)
        c = sign_word(row + 1, w, grid)
        d = sign_word(row + grid.ny + 1, w, grid)
        e = signs_above(row, w, grid)
        f = signs_above(row + grid.ny, w, grid)
        g = signs_above(row + 1, w, grid)
        h = signs_above(row + grid.ny + 1, w, grid)
    while left != 0:
        j = lowest_bit(left)
        left = left ^ (1 << j)
        low = bit(a, j) | (bit(b, j) << 1) | (bit(c, j) << 2) | (bit(d, j) << 3)
        high = bit(e, j) | (bit(f, j) << 1) | (bit(g, j) << 2) | (bit(h, j) << 3)
        case = low | (high << 4)
        yield j, case


@func
def crossing_edges(row: int, w: int, grid: SignGrid) -> vec4i:
    """(0, x, y, z): crossing edges of a word by axis."""
    y = row % grid.ny
    a = sign_word(row, w, grid)
    ex = 0
    ey = 0
    ez = (a ^ signs_above(row, w, grid)) & has_next(w, grid.nz)
    if row + grid.ny < grid.rows:
        ex = a ^ sign_word(row + grid.ny, w, grid)
    if y + 1 < grid.ny:
        ey = a ^ sign_word(row + 1, w, grid)
    if grid.has_gaps[0] != 0:  # an edge needs one complete cell of the four around it
        along_x = with_below(grid.complete, row, w, grid.width)
        along_y = along_x
        along_z = grid.complete[row * grid.width + w]
        if y > 0:
            along_x = along_x | with_below(grid.complete, row - 1, w, grid.width)
            along_z = along_z | grid.complete[(row - 1) * grid.width + w]
        if row >= grid.ny:
            along_y = along_y | with_below(grid.complete, row - grid.ny, w, grid.width)
            along_z = along_z | grid.complete[(row - grid.ny) * grid.width + w]
        if y > 0 and row >= grid.ny:
            along_z = along_z | grid.complete[(row - grid.ny - 1) * grid.width + w]
        ex = ex & along_x
        ey = ey & along_y
        ez = ez & along_z
    return vec4i(0, ex, ey, ez)


@kernel
def count_surface_kernel(grid: SignGrid, tables: CubeTables, edges: SurfaceEdges, counts: array(dtype=int32)):
    """Edge words per row; `counts` are the vertices of all rows, then their triangles."""
    i = tid()
    vertices = 0
    triangles = 0
    has_cells = 0
    if i % grid.ny + 1 < grid.ny and i + grid.ny < grid.rows:
        has_cells = 1
    for w in range(grid.width):
        crossing = crossing_edges(i, w, grid)
        cells = 0
        if has_cells == 1:
            cells = surface_cells(i, w, grid)
        edges.words[i * grid.width + w] = vec4i(vertices, crossing[1], crossing[2], crossing[3])
        vertices += bit_count(crossing[1]) + bit_count(crossing[2]) + bit_count(crossing[3])
        for j, case in surface_cases(i, w, cells, grid):
            triangles += tables.triangle_count[case]
    counts[i] = vertices
    counts[grid.rows + i] = triangles


@func
def crossing_fraction(a: float, b: float, level: float) -> float:
    """Fraction between a and b of the level. In float64, since b - a may overflow float32."""
    return float((float64(level) - float64(a)) / (float64(b) - float64(a)))


@kernel
def write_vertices_kernel(field: SampledField, grid: SignGrid, edges: SurfaceEdges, vertices: array(dtype=vec3)):
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
            k = w * WORD_BITS + j
            z = field.origin[2] + field.spacing[2] * float(k)
            a = field.values[i, k]
            if bit(crossing[1], j) == 1:
                fraction = crossing_fraction(a, field.values[i + field.ny, k], field.level)
                vertices[n] = vec3(x + field.spacing[0] * fraction, y, z)
                n += 1
            if bit(crossing[2], j) == 1:
                fraction = crossing_fraction(a, field.values[i + 1, k], field.level)
                vertices[n] = vec3(x, y + field.spacing[1] * fraction, z)
                n += 1
            if bit(crossing[3], j) == 1:
                fraction = crossing_fraction(a, field.values[i, k + 1], field.level)
                vertices[n] = vec3(x, y, z + field.spacing[2] * fraction)
                n += 1


@func
def word_of(row: int, w: int, grid: SignGrid, edges: SurfaceEdges) -> vec4i:
    word = edges.words[row * grid.width + w]
    return vec4i(edges.offsets[row] + word[0], word[1], word[2], word[3])


@func
def x_edges_above(word: vec4i, row: int, w: int, grid: SignGrid, edges: SurfaceEdges) -> int:
    """Crossing x edges of the samples above those of a word."""
    carry = 0
    if w + 1 < grid.width:
        carry = edges.words[row * grid.width + w + 1][1] << 31
    return ((word[1] >> 1) & LOW_31) | carry


@func
def vertices_before(word: vec4i, j: int) -> vec3i:
    """First vertex of sample j, its vertex along z, and the first one of the sample above."""
    below = bits_below(j)
    first = word[0] + bit_count(word[1] & below) + bit_count(word[2] & below) + bit_count(word[3] & below)
    along_z = first + bit(word[1], j) + bit(word[2], j)
    return vec3i(first, along_z, along_z + bit(word[3], j))


@kernel
def write_triangles_kernel(grid: SignGrid, edges: SurfaceEdges, tables: CubeTables, triangles: array(dtype=vec3i)):
    """Triangles of a row of cells, by z, then table order. A cell's vertices are numbered at once from four rows."""
    i = tid()
    first = edges.offsets[grid.rows + i]
    n = first - edges.offsets[grid.rows]
    if edges.offsets[grid.rows + i + 1] == first:
        return
    for w in range(grid.width):
        cells = surface_cells(i, w, grid)
        low = vec4i(0, 0, 0, 0)  # of the four rows: this one, the next along x, and the next along y of both
        low_x = vec4i(0, 0, 0, 0)
        high = vec4i(0, 0, 0, 0)
        high_x = vec4i(0, 0, 0, 0)
        low_above = 0
        low_x_above = 0
        if cells != 0:
            low = word_of(i, w, grid, edges)
            low_x = word_of(i + grid.ny, w, grid, edges)
            high = word_of(i + 1, w, grid, edges)
            high_x = word_of(i + grid.ny + 1, w, grid, edges)
            low_above = x_edges_above(low, i, w, grid, edges)
            low_x_above = x_edges_above(low_x, i + grid.ny, w, grid, edges)
        for j, case in surface_cases(i, w, cells, grid):
            p = vertices_before(low, j)
            q = vertices_before(low_x, j)
            r = vertices_before(high, j)
            s = vertices_before(high_x, j)
            y0 = p[0] + bit(low[1], j)
            y1 = q[0] + bit(low_x[1], j)
            y2 = p[2] + bit(low_above, j)
            y3 = q[2] + bit(low_x_above, j)
            numbers = cell_edges(p[0], r[0], p[2], r[2], y0, y1, y2, y3, p[1], q[1], r[1], s[1])
            for t in range(tables.triangle_count[case]):
                entry = case * ENTRIES_PER_CASE + 3 * t
                a = numbers[tables.triangle_edges[entry]]
                b = numbers[tables.triangle_edges[entry + 1]]
                c = numbers[tables.triangle_edges[entry + 2]]
                triangles[n] = vec3i(a, b, c)
                n += 1


def extract_surface(
    field: Array2[float32], shape: tuple[int, int, int], level: float, origin: np.ndarray, spacing: np.ndarray
) -> tuple[Points, Triangles]:
    """Isosurface of a field [nx * ny, nz], each size >= 2. Returns (vertices vec3, triangles vec3i) without unused
    vertices. Raises ValueError for more vertices or triangles than int32 can index."""
    samples, device = SampledField(field, shape, level, origin, spacing), field.device
    grid, tables = SignGrid(samples), device_tables(device)
    edges = SurfaceEdges(grid, tables)
    vertex_count = edges.vertex_count
    vertices, triangles = empty(vertex_count, vec3, device), empty(edges.total - vertex_count, vec3i, device)
    if edges.total:
        launch(write_vertices_kernel, grid.rows, [samples, grid, edges, vertices])
        launch(write_triangles_kernel, grid.rows, [grid, edges, tables, triangles])
    return vertices, triangles
