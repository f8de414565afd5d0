"""Marching cubes on a block volume, with vertices shared between cells and blocks.

Each grid edge belongs to its lower voxel. Passes over rows of 8 voxels find cut cells (8 valid corners), then their
edges, then write vertices and triangles at prefix sums: bitwise reproducible. 32 B of scratch memory per row. Lorensen
and Cline, SIGGRAPH 1987.
"""

from collections.abc import Iterable

from ..array_types import Integers, LongIntegers, Points, Triangles, Vectors
from ..arrays.block_keys import key_block
from ..arrays.prefix_sum import scan_two
from ..lang import array, bit_count, func, int32, int64, kernel, launch, sqrt, struct, tid, vec3, vec3i
from ..memory import empty
from .block_rows import EIGHT_BITS, NINE_BITS, VALID_SHIFT, SeenBlocks, pack_rows, row_near, voxel_near, word_near
from .cube_table import MAX_TRIANGLES, CubeTables, device_tables
from .tsdf_blocks import BLOCK_ROWS, BLOCK_SIDE
from .voxel_blocks import COLOR_SCALE, VoxelBlocks, voxel_color

EDGES_PER_BLOCK = 3 * BLOCK_SIDE * BLOCK_ROWS  # grid edges that belong to a block
MAX_EDGES = 15  # entries of a case in the triangle table


@func
def case_of(s00: int, s10: int, s01: int, s11: int, z: int) -> int:
    """Case of the cell at z between four rows: bit x + 2 y + 4 z of a corner is its sign."""
    low = ((s00 >> z) & 1) | (((s10 >> z) & 1) << 1) | (((s01 >> z) & 1) << 2) | (((s11 >> z) & 1) << 3)
    up = z + 1
    high = ((s00 >> up) & 1) | (((s10 >> up) & 1) << 1) | (((s01 >> up) & 1) << 2) | (((s11 >> up) & 1) << 3)
    return low | (high << 4)


@struct
class BlockSurface:
    """Cut cells and crossing edges of a volume. `cells` has a bit per cell of a row, `edges` 8 bits each for x, y and
    z. `offsets` int32 [2 * rows + 1] are the first vertices of rows, then their first triangles."""

    seen: SeenBlocks
    words: array(dtype=int32)
    cells: array(dtype=int32)
    edges: array(dtype=int32)
    rows: int
    offsets: array(dtype=int32)
    tables: CubeTables

    def __init__(
        self, seen: SeenBlocks, need_cells: bool, within: tuple[Iterable[int], Iterable[int]] | None = None
    ) -> None:
        """`need_cells`: only edges of cells with triangles get vertices. `within`: low and exclusive high block."""
        rows, device = seen.row_count, seen.neighbors.device
        self.rows = rows
        self.seen, self.device, self.tables, self.words = seen, device, device_tables(device), pack_rows(seen)
        self.cells, self.edges = (empty(rows, int32, device) for _ in range(2))
        counts = empty(2 * rows, int32, device)
        launch(find_cells_kernel, rows, [self, counts])
        if within is not None:
            low, high = (vec3i(*(int(c) for c in corner)) for corner in within)
            launch(drop_cells_kernel, rows, [self, low, high, counts])
        launch(find_edges_kernel, rows, [self, int(need_cells), counts])
        self.offsets, self.vertex_count, total = scan_two(
            counts, MAX_TRIANGLES * BLOCK_SIDE
        )  # more than 3 edges per voxel
        self.triangle_count = total - self.vertex_count

    def vertices(self, has_color: bool, has_normals: bool) -> tuple[Points, Vectors | None, Vectors | None]:
        """(vertices, colors or None, normals or None), vec3."""
        vertices = empty(self.vertex_count, vec3, self.device)
        colors = empty(self.vertex_count if has_color else 1, vec3, self.device)
        normals = empty(self.vertex_count if has_normals else 1, vec3, self.device)
        outputs = [int(has_color), int(has_normals), vertices, colors, normals]
        launch(emit_vertices_kernel, self.edges.size, [self, *outputs])
        return vertices, colors if has_color else None, normals if has_normals else None

    def vertex_edges(self) -> tuple[LongIntegers, Integers]:
        """Identify vertices across parts of a volume: int64 block key of the lower voxel, int32 edge in the block."""
        blocks, edges = empty(self.vertex_count, int64, self.device), empty(self.vertex_count, int32, self.device)
        launch(emit_edges_kernel, self.edges.size, [self, blocks, edges])
        return blocks, edges

    def triangles(self) -> Triangles:
        triangles = empty(self.triangle_count, vec3i, self.device)
        launch(emit_triangles_kernel, self.cells.size, [self, triangles])
        return triangles


@kernel
def find_cells_kernel(surface: BlockSurface, counts: array(dtype=int32)):
    """Cut cells of each row. Their triangle counts go to the second half of `counts`."""
    i = tid()
    block = i // BLOCK_ROWS
    x = i // BLOCK_SIDE % BLOCK_SIDE
    y = i % BLOCK_SIDE
    cut = 0
    triangles = 0
    w00 = surface.words[i]
    if (w00 >> VALID_SHIFT) != 0:
        w10 = word_near(surface.words, block, x + 1, y, 0, surface.seen)
        w01 = word_near(surface.words, block, x, y + 1, 0, surface.seen)
        w11 = word_near(surface.words, block, x + 1, y + 1, 0, surface.seen)
        every = w00 & w10 & w01 & w11
        some = w00 | w10 | w01 | w11
        valid = every >> VALID_SHIFT
        complete = valid & (valid >> 1) & EIGHT_BITS
        negative = every & NINE_BITS
        any_negative = some & NINE_BITS
        cut = complete & (any_negative | (any_negative >> 1)) & ~(negative & (negative >> 1)) & EIGHT_BITS
        if cut != 0:
            for z in range(BLOCK_SIDE):
                if ((cut >> z) & 1) == 1:
                    triangles += surface.tables.triangle_count[case_of(w00, w10, w01, w11, z)]
    surface.cells[i] = cut
    counts[surface.rows + i] = triangles


@kernel
def drop_cells_kernel(surface: BlockSurface, low: vec3i, high: vec3i, counts: array(dtype=int32)):
    i = tid()
    block = key_block(surface.seen.blocks.keys[i // BLOCK_ROWS])
    inside = block[0] >= low[0] and block[1] >= low[1] and block[2] >= low[2]
    if not (inside and block[0] < high[0] and block[1] < high[1] and block[2] < high[2]):
        surface.cells[i] = 0
        counts[surface.rows + i] = 0


@func
def cells_near(block: int, x: int, y: int, surface: BlockSurface) -> int:
    return word_near(surface.cells, block, x, y, 0, surface.seen)


@func
def cells_beside(block: int, x: int, y: int, surface: BlockSurface) -> int:
    """Bit z: the cell at z or below it is cut in the row at (x, y)."""
    here = cells_near(block, x, y, surface)
    below = word_near(surface.cells, block, x, y, -1, surface.seen)
    return (here | (here << 1) | (below >> (BLOCK_SIDE - 1))) & EIGHT_BITS


@kernel
def find_edges_kernel(surface: BlockSurface, need_cells: int, counts: array(dtype=int32)):
    """Edges of each row with a vertex (`need_cells`: of cells with triangles). Counts go to the first half."""
    i = tid()
    block = i // BLOCK_ROWS
    x = i // BLOCK_SIDE % BLOCK_SIDE
    y = i % BLOCK_SIDE
    word = surface.words[i]
    edges = 0
    if (word >> VALID_SHIFT) != 0:
        wx = word_near(surface.words, block, x + 1, y, 0, surface.seen)
        wy = word_near(surface.words, block, x, y + 1, 0, surface.seen)
        along_x = (word ^ wx) & ((word & wx) >> VALID_SHIFT) & EIGHT_BITS
        along_y = (word ^ wy) & ((word & wy) >> VALID_SHIFT) & EIGHT_BITS
        valid = word >> VALID_SHIFT
        along_z = (word ^ (word >> 1)) & valid & (valid >> 1) & EIGHT_BITS
        if need_cells == 1 and (along_x | along_y | along_z) != 0:
            here = cells_beside(block, x, y, surface)
            along_x = along_x & (here | cells_beside(block, x, y - 1, surface))
            along_y = along_y & (here | cells_beside(block, x - 1, y, surface))
            around = surface.cells[i] | cells_near(block, x - 1, y, surface)
            around = around | cells_near(block, x, y - 1, surface)
            along_z = along_z & (around | cells_near(block, x - 1, y - 1, surface))
        edges = along_x | (along_y << BLOCK_SIDE) | (along_z << (2 * BLOCK_SIDE))
    surface.edges[i] = edges
    counts[i] = bit_count(edges)


@func
def gradient_along(low: int, here: float, high: int, blocks: VoxelBlocks) -> float:
    """Central difference, one-sided next to an unobserved voxel, 0 between two."""
    a = here
    b = here
    span = 0.0
    if low >= 0:
        if blocks.weights[low] > 0:
            a = blocks.distances[low]
            span += 1.0
    if high >= 0:
        if blocks.weights[high] > 0:
            b = blocks.distances[high]
            span += 1.0
    slope = 0.0
    if span > 0.0:
        slope = (b - a) / span
    return slope


@func
def gradient_at(block: int, x: int, y: int, z: int, seen: SeenBlocks) -> vec3:
    here = seen.blocks.distances[voxel_near(block, x, y, z, seen)]
    low = voxel_near(block, x - 1, y, z, seen)
    gx = gradient_along(low, here, voxel_near(block, x + 1, y, z, seen), seen.blocks)
    low = voxel_near(block, x, y - 1, z, seen)
    gy = gradient_along(low, here, voxel_near(block, x, y + 1, z, seen), seen.blocks)
    low = voxel_near(block, x, y, z - 1, seen)
    gz = gradient_along(low, here, voxel_near(block, x, y, z + 1, seen), seen.blocks)
    return vec3(gx, gy, gz)


@kernel
def emit_vertices_kernel(
    surface: BlockSurface,
    has_color: int,
    has_normals: int,
    vertices: array(dtype=vec3),
    colors: array(dtype=vec3),
    normals: array(dtype=vec3),
):
    i = tid()
    marks = surface.edges[i]
    if marks == 0:
        return
    block = i // BLOCK_ROWS
    x = i // BLOCK_SIDE % BLOCK_SIDE
    y = i % BLOCK_SIDE
    corner = key_block(surface.seen.blocks.keys[block])
    at = surface.offsets[i]
    for e in range(3 * BLOCK_SIDE):
        if ((marks >> e) & 1) == 1:
            axis = e // BLOCK_SIDE
            z = e % BLOCK_SIDE
            ox = x + int(axis == 0)
            oy = y + int(axis == 1)
            oz = z + int(axis == 2)
            a = i * BLOCK_SIDE + z
            b = voxel_near(block, ox, oy, oz, surface.seen)
            before = surface.seen.blocks.distances[a]
            fraction = before / (before - surface.seen.blocks.distances[b])
            p = vec3(
                float(corner[0] * BLOCK_SIDE + x), float(corner[1] * BLOCK_SIDE + y), float(corner[2] * BLOCK_SIDE + z)
            )
            if axis == 0:
                p = vec3(p[0] + fraction, p[1], p[2])
            if axis == 1:
                p = vec3(p[0], p[1] + fraction, p[2])
            if axis == 2:
                p = vec3(p[0], p[1], p[2] + fraction)
            vertices[at] = p * float(surface.seen.blocks.voxel_size)
            if has_color == 1:
                c = voxel_color(a, surface.seen.blocks)
                d = voxel_color(b, surface.seen.blocks)
                colors[at] = (c + (d - c) * fraction) / (255.0 * COLOR_SCALE)
            if has_normals == 1:
                g = gradient_at(block, x, y, z, surface.seen)
                h = gradient_at(block, ox, oy, oz, surface.seen)
                n = g + (h - g) * fraction
                size = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2])
                if size > 0.0:
                    n = n / size
                normals[at] = n
            at += 1


@kernel
def emit_edges_kernel(surface: BlockSurface, blocks: array(dtype=int64), edges: array(dtype=int32)):
    i = tid()
    marks = surface.edges[i]
    at = surface.offsets[i]
    for e in range(3 * BLOCK_SIDE):
        if ((marks >> e) & 1) == 1:
            blocks[at] = surface.seen.blocks.keys[i // BLOCK_ROWS]
            edges[at] = i % BLOCK_ROWS * (3 * BLOCK_SIDE) + e
            at += 1


@func
def vertex_of(row: int, axis: int, z: int, surface: BlockSurface) -> int:
    bit = axis * BLOCK_SIDE + z
    return surface.offsets[row] + bit_count(surface.edges[row] & ((1 << bit) - 1))


@kernel
def emit_triangles_kernel(surface: BlockSurface, triangles: array(dtype=vec3i)):
    i = tid()
    cut = surface.cells[i]
    if cut == 0:
        return
    block = i // BLOCK_ROWS
    x = i // BLOCK_SIDE % BLOCK_SIDE
    y = i % BLOCK_SIDE
    w10 = word_near(surface.words, block, x + 1, y, 0, surface.seen)
    w01 = word_near(surface.words, block, x, y + 1, 0, surface.seen)
    w11 = word_near(surface.words, block, x + 1, y + 1, 0, surface.seen)
    at = surface.offsets[surface.rows + i] - surface.offsets[surface.rows]
    for z in range(BLOCK_SIDE):
        if ((cut >> z) & 1) == 1:
            case = case_of(surface.words[i], w10, w01, w11, z)
            for t in range(surface.tables.triangle_count[case]):
                triangle = vec3i(0, 0, 0)
                for k in range(3):
                    e = surface.tables.triangle_edges[case * MAX_EDGES + 3 * t + k]
                    c = surface.tables.edge_corner[e]
                    up = z + ((c >> 2) & 1)
                    dz = up // BLOCK_SIDE
                    row = row_near(block, x + (c & 1), y + ((c >> 1) & 1), dz, surface.seen)
                    triangle[k] = vertex_of(row, surface.tables.edge_axis[e], up - dz * BLOCK_SIDE, surface)
                triangles[at] = triangle
                at += 1
