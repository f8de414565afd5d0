"""The surface of a volume of blocks by marching cubes, with vertices shared between cells and between blocks.

Each edge of the grid belongs to its lower voxel, and makes at most one vertex. Four passes over the rows of 8 voxels:
which cells the surface cuts (all 8 corners valid), which edges these cells use, then vertices and triangles at places
known from prefix sums. Nothing is hashed or merged afterwards, and the order is fixed: the same bits from run to run.
Scratch 28 B a row. Lorensen and Cline, SIGGRAPH 1987; cases from cube_table.py.
"""

from ..arrays.block_keys import key_block
from ..arrays.prefix_sum import exclusive_scan
from ..lang import (
    array,
    bit_count,
    float32,
    func,
    int32,
    int64,
    kernel,
    launch,
    sqrt,
    tid,
    uint16,
    vec3,
    vec3i,
)
from ..memory import empty
from .block_rows import (
    EIGHT,
    NINE,
    VALID,
    row_near,
    voxel_near,
    word_near,
)
from .cube_table import device_tables
from .integrate import COLOR_SCALE
from .tsdf_blocks import ROWS, SIDE

MAX_EDGES = 15  # entries of a case in the table of triangles


@func
def case_of(s00: int, s10: int, s01: int, s11: int, z: int) -> int:
    """The case of the cell at z between four rows: bit x + 2 y + 4 z of a corner is its sign."""
    low = ((s00 >> z) & 1) | (((s10 >> z) & 1) << 1) | (((s01 >> z) & 1) << 2) | (((s11 >> z) & 1) << 3)
    up = z + 1
    high = ((s00 >> up) & 1) | (((s10 >> up) & 1) << 1) | (((s01 >> up) & 1) << 2) | (((s11 >> up) & 1) << 3)
    return low | (high << 4)


@kernel
def find_cells_kernel(
    words: array(dtype=int32),
    neighbors: array(dtype=int32),
    triangle_count: array(dtype=int32),
    cells: array(dtype=int32),
    counts: array(dtype=int32),
):
    """The cells of each row that the surface cuts, one bit each, and their triangles."""
    i = tid()
    block = i // ROWS
    x = i // SIDE % SIDE
    y = i % SIDE
    cut = int(0)
    triangles = int(0)
    w00 = words[i]
    if (w00 >> VALID) != 0:
        w10 = word_near(words, neighbors, block, x + 1, y, 0)
        w01 = word_near(words, neighbors, block, x, y + 1, 0)
        w11 = word_near(words, neighbors, block, x + 1, y + 1, 0)
        every = w00 & w10 & w01 & w11
        some = w00 | w10 | w01 | w11
        valid = every >> VALID
        whole = valid & (valid >> 1) & EIGHT
        negative = every & NINE
        any_negative = some & NINE
        cut = whole & (any_negative | (any_negative >> 1)) & ~(negative & (negative >> 1)) & EIGHT
        if cut != 0:
            for z in range(SIDE):
                if ((cut >> z) & 1) == 1:
                    triangles += triangle_count[case_of(w00, w10, w01, w11, z)]
    cells[i] = cut
    counts[i] = triangles


@func
def cells_beside(cells: array(dtype=int32), neighbors: array(dtype=int32), block: int, x: int, y: int) -> int:
    """Bit z: the cell at z or the one below it is cut, in the row at (x, y)."""
    here = word_near(cells, neighbors, block, x, y, 0)
    below = word_near(cells, neighbors, block, x, y, -1)
    return (here | (here << 1) | (below >> (SIDE - 1))) & EIGHT


@kernel
def find_edges_kernel(
    words: array(dtype=int32),
    cells: array(dtype=int32),
    neighbors: array(dtype=int32),
    need_cells: int,
    edges: array(dtype=int32),
    counts: array(dtype=int32),
):
    """The edges of each row that make a vertex: 8 bits for those along x, then y, then z; and their number.

    With `need_cells` only those of cells that make triangles; else all between two valid voxels.
    """
    i = tid()
    block = i // ROWS
    x = i // SIDE % SIDE
    y = i % SIDE
    word = words[i]
    found = int(0)
    if (word >> VALID) != 0:
        wx = word_near(words, neighbors, block, x + 1, y, 0)
        wy = word_near(words, neighbors, block, x, y + 1, 0)
        along_x = (word ^ wx) & ((word & wx) >> VALID) & EIGHT
        along_y = (word ^ wy) & ((word & wy) >> VALID) & EIGHT
        valid = word >> VALID
        along_z = (word ^ (word >> 1)) & valid & (valid >> 1) & EIGHT
        if need_cells == 1 and (along_x | along_y | along_z) != 0:
            here = cells_beside(cells, neighbors, block, x, y)
            along_x = along_x & (here | cells_beside(cells, neighbors, block, x, y - 1))
            along_y = along_y & (here | cells_beside(cells, neighbors, block, x - 1, y))
            around = cells[i] | word_near(cells, neighbors, block, x - 1, y, 0)
            around = around | word_near(cells, neighbors, block, x, y - 1, 0)
            along_z = along_z & (around | word_near(cells, neighbors, block, x - 1, y - 1, 0))
        found = along_x | (along_y << SIDE) | (along_z << (2 * SIDE))
    edges[i] = found
    counts[i] = bit_count(found)


@func
def gradient_along(
    distances: array(dtype=float32), weights: array(dtype=uint16), low: int, here: float, high: int
) -> float:
    """The slope between the voxels before and behind, one-sided where one was never seen, 0 where both."""
    a = here + 0.0
    b = here + 0.0
    span = float(0.0)
    if low >= 0:
        if weights[low] > uint16(0):
            a = distances[low]
            span += 1.0
    if high >= 0:
        if weights[high] > uint16(0):
            b = distances[high]
            span += 1.0
    slope = float(0.0)
    if span > 0.0:
        slope = (b - a) / span
    return slope


@func
def gradient_at(
    distances: array(dtype=float32),
    weights: array(dtype=uint16),
    neighbors: array(dtype=int32),
    block: int,
    x: int,
    y: int,
    z: int,
) -> vec3:
    """The gradient of the distance at a voxel, local coordinates in 0..8."""
    here = distances[voxel_near(neighbors, block, x, y, z)]
    gx = gradient_along(
        distances, weights, voxel_near(neighbors, block, x - 1, y, z), here, voxel_near(neighbors, block, x + 1, y, z)
    )
    gy = gradient_along(
        distances, weights, voxel_near(neighbors, block, x, y - 1, z), here, voxel_near(neighbors, block, x, y + 1, z)
    )
    gz = gradient_along(
        distances, weights, voxel_near(neighbors, block, x, y, z - 1), here, voxel_near(neighbors, block, x, y, z + 1)
    )
    return vec3(gx, gy, gz)


@kernel
def emit_vertices_kernel(
    block_keys: array(dtype=int64),
    distances: array(dtype=float32),
    weights: array(dtype=uint16),
    voxel_colors: array(dtype=uint16, ndim=2),
    neighbors: array(dtype=int32),
    edges: array(dtype=int32),
    offsets: array(dtype=int32),
    voxel_size: float,
    has_color: int,
    has_normals: int,
    vertices: array(dtype=vec3),
    colors: array(dtype=vec3),
    normals: array(dtype=vec3),
):
    """The vertices of each row's edges, where the distance between the two voxels is zero."""
    i = tid()
    marks = edges[i]
    if marks == 0:
        return
    block = i // ROWS
    x = i // SIDE % SIDE
    y = i % SIDE
    corner = key_block(block_keys[block])
    at = offsets[i]
    for e in range(3 * SIDE):
        if ((marks >> e) & 1) == 1:
            axis = e // SIDE
            z = e % SIDE
            ox = x + int(axis == 0)
            oy = y + int(axis == 1)
            oz = z + int(axis == 2)
            a = i * SIDE + z
            b = voxel_near(neighbors, block, ox, oy, oz)
            share = distances[a] / (distances[a] - distances[b])
            p = vec3(float(corner[0] * SIDE + x), float(corner[1] * SIDE + y), float(corner[2] * SIDE + z))
            p[axis] = p[axis] + share
            vertices[at] = p * voxel_size
            if has_color == 1:
                c = vec3(float(voxel_colors[a, 0]), float(voxel_colors[a, 1]), float(voxel_colors[a, 2]))
                d = vec3(float(voxel_colors[b, 0]), float(voxel_colors[b, 1]), float(voxel_colors[b, 2]))
                colors[at] = (c + (d - c) * share) / (255.0 * COLOR_SCALE)
            if has_normals == 1:
                g = gradient_at(distances, weights, neighbors, block, x, y, z)
                h = gradient_at(distances, weights, neighbors, block, ox, oy, oz)
                n = g + (h - g) * share
                size = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2])
                if size > 0.0:
                    n = n / size
                normals[at] = n
            at += 1


@func
def vertex_of(edges: array(dtype=int32), offsets: array(dtype=int32), row: int, axis: int, z: int) -> int:
    """The vertex of the edge along an axis from voxel z of a row."""
    place = axis * SIDE + z
    return offsets[row] + bit_count(edges[row] & ((1 << place) - 1))


@kernel
def emit_triangles_kernel(
    words: array(dtype=int32),
    cells: array(dtype=int32),
    neighbors: array(dtype=int32),
    edges: array(dtype=int32),
    vertex_offsets: array(dtype=int32),
    triangle_offsets: array(dtype=int32),
    triangle_count: array(dtype=int32),
    triangle_edges: array(dtype=int32),
    edge_corner: array(dtype=int32),
    edge_axis: array(dtype=int32),
    triangles: array(dtype=vec3i),
):
    """The triangles of each row's cells."""
    i = tid()
    cut = cells[i]
    if cut == 0:
        return
    block = i // ROWS
    x = i // SIDE % SIDE
    y = i % SIDE
    w10 = word_near(words, neighbors, block, x + 1, y, 0)
    w01 = word_near(words, neighbors, block, x, y + 1, 0)
    w11 = word_near(words, neighbors, block, x + 1, y + 1, 0)
    at = triangle_offsets[i]
    for z in range(SIDE):
        if ((cut >> z) & 1) == 1:
            case = case_of(words[i], w10, w01, w11, z)
            for t in range(triangle_count[case]):
                triangle = vec3i(0, 0, 0)
                for k in range(3):
                    e = triangle_edges[case * MAX_EDGES + 3 * t + k]
                    c = edge_corner[e]
                    up = z + ((c >> 2) & 1)
                    dz = up // SIDE
                    row = row_near(neighbors, block, x + (c & 1), y + ((c >> 1) & 1), dz)
                    triangle[k] = vertex_of(edges, vertex_offsets, row, edge_axis[e], up - dz * SIDE)
                triangles[at] = triangle
                at += 1


class BlockSurface:
    """The cut cells and edges of a volume, ready to be emitted.

    Args:
        words, neighbors: From block_rows.pack_rows and find_neighbors.
        need_cells: Whether only edges of cells with triangles make vertices.
    """

    def __init__(self, words, neighbors, need_cells):
        self.words, self.neighbors, self.device = words, neighbors, words.device
        rows = words.size
        self.tables = device_tables(self.device)
        self.cells, counts = empty(rows, int32, self.device), empty(rows, int32, self.device)
        launch(find_cells_kernel, rows, [words, neighbors, self.tables.triangle_count, self.cells, counts])
        self.triangle_offsets, self.triangle_count = exclusive_scan(counts)
        self.edges = empty(rows, int32, self.device)
        launch(find_edges_kernel, rows, [words, self.cells, neighbors, int(need_cells), self.edges, counts])
        self.vertex_offsets, self.vertex_count = exclusive_scan(counts)

    def vertices(self, block_keys, voxels, voxel_size, has_color, has_normals):
        """(vertices, colors or None, normals or None), vec3 device arrays."""
        distances, weights, voxel_colors = voxels
        vertices = empty(self.vertex_count, vec3, self.device)
        colors = empty(self.vertex_count if has_color else 1, vec3, self.device)
        normals = empty(self.vertex_count if has_normals else 1, vec3, self.device)
        volume = [block_keys, distances, weights, voxel_colors, self.neighbors, self.edges, self.vertex_offsets]
        outputs = [float(voxel_size), int(has_color), int(has_normals), vertices, colors, normals]
        launch(emit_vertices_kernel, self.edges.size, [*volume, *outputs])
        return vertices, colors if has_color else None, normals if has_normals else None

    def triangles(self):
        """The triangles, vec3i [t]."""
        triangles = empty(self.triangle_count, vec3i, self.device)
        rows = [self.words, self.cells, self.neighbors, self.edges, self.vertex_offsets, self.triangle_offsets]
        tables = self.tables
        cases = [tables.triangle_count, tables.triangle_edges, tables.edge_corner, tables.edge_axis]
        launch(emit_triangles_kernel, self.cells.size, [*rows, *cases, triangles])
        return triangles
