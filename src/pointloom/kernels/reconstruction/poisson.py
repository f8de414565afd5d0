"""Screened Poisson surface reconstruction (Kazhdan and Hoppe, ACM TOG 32(3), 2013).

Levels are solved from coarse to fine by a fixed number of eight-colored Gauss-Seidel sweeps, independent of the thread
order. Those of a small level are one launch. Unknowns are corners inside eight existing cells. The others keep the
coarser solution. Divided by the cell width, the Laplacian is 8/3 at the corner, -1/6 at the 12 corners across a face
and -1/12 at the 8 across a cell. Samples of a cell pull u to 0 at their mean. The sides of the cube have Neumann
boundary conditions.
"""

from collections.abc import Callable, Sequence
from itertools import product
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ..algebra.transform import widen
from ..array_types import Array1, Device, Indices, Integers, Mask, Points, Scalars, Triangles, Vectors
from ..arrays.blocks import block_threads, wait_for_block
from ..arrays.prefix_sum import inclusive_scan
from ..arrays.select import positions_of
from ..lang import (
    array,
    compute,
    float32,
    float64,
    func,
    int32,
    kernel,
    launch,
    length,
    pow,
    record,
    reduce,
    reduction,
    replay,
    struct,
    tid,
    uint8,
    vec2d,
    vec3,
    vec3i,
    vector,
)
from ..memory import check_room, download, empty, fill, upload, zeros
from .envelope import Envelope, fix_outside
from .octree_levels import (
    BLOCK_SLOTS,
    BLOCKS_AROUND,
    OctreeLevel,
    divide,
    first_levels,
    is_cell,
    is_divided,
    neighbor_slot,
    next_level,
    slot_position,
)
from .octree_surface import OctreeSurface
from .poisson_system import constraints, fractions_in_parent
from .sample_cells import Cube, SampleCells, gather_samples
from .sample_density import TREE_ENDS, DensityPyramid, SampleNodes, local_depths
from .splines import corner_value, corner_weight, fractions_in_cell

if TYPE_CHECKING:
    from .sample_density import DensityPyramid


@reduction
def sum_lengths(normals: array(dtype=vec3), rows: array(dtype=int32)) -> vec2d:
    i = tid()
    return vec2d(length(widen(normals[rows[i]])), 1.0)


def mean_length(normals: Vectors, rows: Indices) -> float:
    """Mean length of the selected normals, or 1 if none: the scale of weights."""
    total, count = download(reduce(sum_lengths, rows.size, [normals, rows]))[0]  # sync
    return float(total) / float(count) if count else 1.0


@kernel
def mark_unknowns_kernel(level: OctreeLevel, blocks: int, mask: array(dtype=uint8)):
    """Mark corners in the cube whose cells all exist, by color and block."""
    i = tid()
    color = i // blocks
    slot = BLOCK_SLOTS * (i - color * blocks) + color
    position = slot_position(slot, level)
    cells = 1 << level.depth
    unknown = 1
    if position[0] > cells or position[1] > cells or position[2] > cells:
        unknown = 0
    n = int(8)
    for corner in range(n):
        x = corner & 1
        y = (corner >> 1) & 1
        z = (corner >> 2) & 1
        outside = 0
        if position[0] - x < 0 or position[1] - y < 0 or position[2] - z < 0:
            outside = 1
        if position[0] - x >= cells or position[1] - y >= cells or position[2] - z >= cells:
            outside = 1
        if outside == 0:
            if is_cell(neighbor_slot(slot, -x, -y, -z, level), level) == 0:
                unknown = 0
    mask[i] = uint8(unknown)


@kernel(for_cpu=True)
def name_corners_kernel(indices: array(dtype=int32), blocks: int, corners: array(dtype=int32)):
    i = tid()
    color = indices[i] // blocks
    corners[i] = BLOCK_SLOTS * (indices[i] - color * blocks) + color


@kernel
def count_unknowns_kernel(mask: array(dtype=uint8), counts: array(dtype=int32)):
    i = tid()
    counts[i] = int(mask[i])


@kernel
def list_unknowns_kernel(
    mask: array(dtype=uint8),
    ranks: array(dtype=int32),
    blocks: int,
    corners: array(dtype=int32),
    firsts: array(dtype=int32),
):
    """Slots of unknowns by color and block, and the start of each color. Ranks count from one."""
    i = tid()
    color = i // blocks
    if mask[i] != 0:
        corners[ranks[i] - 1] = BLOCK_SLOTS * (i - color * blocks) + color
    if i == 0:
        firsts[0] = 0
    if i + 1 == (color + 1) * blocks:
        firsts[color + 1] = ranks[i]


def list_unknowns(mask: Mask, blocks: int) -> tuple[Indices, Integers, list[int]]:
    """Unknowns by color, from uint8 [8 * blocks]: (slots, color starts int32 [9], upper bound per color)."""
    device = mask.device
    if device.is_cuda:
        ranks, corners, firsts = (empty(size, int32, device) for size in (mask.size, mask.size, BLOCK_SLOTS + 1))
        launch(count_unknowns_kernel, mask.size, [mask, ranks])
        inclusive_scan(ranks, ranks)
        launch(list_unknowns_kernel, mask.size, [mask, ranks, blocks, corners, firsts])
        return corners, firsts, [blocks] * BLOCK_SLOTS
    indices = positions_of(mask)
    begins = np.searchsorted(download(indices), np.arange(BLOCK_SLOTS + 1) * blocks)
    corners = compute(name_corners_kernel, indices.size, [indices, blocks], int32, device)
    return corners, upload(begins, int32, device), np.diff(begins).tolist()


COARSE_LEVELS = 4  # levels up to this one are small and get more sweeps
COARSE_SWEEPS = 10
FULL_SWEEPS = 8  # of the last level that fills the cube; four leave its surface 10% less accurate
SWEEPS_PER_LEVEL = 4  # from the level above its solution. Eight change no error by 1%
MAX_ALONE = 1024  # blocks of a level that one block of threads solves: 4 corners of a color per thread
MAX_ALONE_ON_CPU = 128  # the same for one thread: a color takes 10 us, which would not be divided among threads
eight = vector(8, int32)


@kernel
def lower_values_kernel(
    above: OctreeLevel, coarse: array(dtype=float32), level: OctreeLevel, fine: array(dtype=float32)
):
    i = tid()
    fine[i] = corner_value(coarse, level.parents[i // BLOCK_SLOTS], fractions_in_parent(i), above)


@struct
class SamplePulls:
    """Pull of the samples: cell of samples by slot (or -1), mean position in the cell, weight, and solution there."""

    cells_at: array(dtype=int32)
    fractions: array(dtype=vec3)
    weights: array(dtype=float32)
    values: array(dtype=float32)

    def __init__(
        self, pyramid: "DensityPyramid", depth: int, values: Scalars, weight: float, areas: Array1[vec2d]
    ) -> None:
        cells, level, slots = pyramid.cells[depth], pyramid.levels[depth], pyramid.nodes[depth].slots
        device = level.device
        self.cells_at = pyramid.cells_at[depth]
        self.fractions = empty(cells.count, vec3, device)
        self.weights, self.values = empty(cells.count, float32, device), empty(cells.count, float32, device)
        launch(begin_pulls_kernel, cells.count, [cells, slots, level, values, weight * 4.0**depth, areas, self])


@kernel
def begin_pulls_kernel(
    cells: SampleCells,
    slots: array(dtype=int32),
    level: OctreeLevel,
    values: array(dtype=float32),
    weight: float64,
    areas: array(dtype=vec2d),
    pulls: SamplePulls,
):
    """Position, weight, and current solution of each cell's samples; `areas` is (area, weight) of all."""
    i = tid()
    pull = float(weight * areas[0][0] / areas[0][1])
    f = vec3(0.0, 0.0, 0.0)
    value = 0.0
    if slots[i] >= 0:
        f = fractions_in_cell(cells.means[i], slots[i], level)
        value = corner_value(values, slots[i], f, level)
    pulls.fractions[i] = f
    pulls.weights[i] = pull * cells.weights[i]
    pulls.values[i] = value


FACE_CORNERS, CELL_CORNERS = 12, 8  # corners across the faces and across the cells around a corner
CORNER_ENTRIES = FACE_CORNERS + 2 * CELL_CORNERS  # of a kind of corner in the table, the cells around it last
# position of a corner along an axis: in its block, or at a side of the cube
EVEN_CORNER, ODD_CORNER, FIRST_CORNER, LAST_CORNER = range(4)


def _step(kind: int, step: int) -> tuple[int, int]:
    """Along one axis: block offset and slot of the adjacent corner, mirrored at a side."""
    if (kind == FIRST_CORNER and step < 0) or (kind == LAST_CORNER and step > 0):
        step = -step
    at = (1 if kind == ODD_CORNER else 0) + step
    return at >> 1, at & 1


def _entry(kinds: Sequence[int], steps: Sequence[int] | tuple[int, int, int]) -> int:
    blocks, indices = zip(*(_step(kind, step) for kind, step in zip(kinds, steps, strict=True)), strict=True)
    around = sum(factor * (block + 1) for factor, block in zip((9, 3, 1), blocks, strict=True))
    return BLOCK_SLOTS * around + sum(index << axis for axis, index in enumerate(indices))


def _cell_entry(kinds: Sequence[int], corner: int) -> int:
    """Table entry of the cell with the given corner. No block outside the cube."""
    plain = [ODD_CORNER if kind == ODD_CORNER else EVEN_CORNER for kind in kinds]
    return _entry(plain, [-(corner >> axis & 1) for axis in range(3)])


def _build_table() -> np.ndarray:
    steps = sorted(product((-1, 0, 1), repeat=3), key=lambda step: (sum(map(abs, step)), step))
    far = [step for step in steps if sum(map(abs, step)) > 1]
    rows = []
    for number in range(64):
        kinds = [number >> 2 * axis & 3 for axis in range(3)]
        rows.append([_entry(kinds, step) for step in far] + [_cell_entry(kinds, c) for c in range(CELL_CORNERS)])
    return np.array(rows, np.int32).ravel()


CORNER_TABLE = _build_table()  # [64 * CORNER_ENTRIES], BLOCK_SLOTS * (neighbor block) + index in it


@func
def axis_kind(at: int, cells: int) -> int:
    kind = at & 1
    if at == 0:
        kind = FIRST_CORNER
    if at == cells:
        kind = LAST_CORNER
    return kind


@func
def sides_met(position: vec3i, cells: int) -> float:
    """2 to the power of the number of cube sides that a corner is on."""
    factor = 1.0
    for axis in range(3):
        if position[axis] == 0 or position[axis] == cells:
            factor = factor * 2.0
    return factor


@func
def renew_corner(
    slot: int,
    table: array(dtype=int32),
    level: OctreeLevel,
    tested: array(dtype=float32),
    pulls: SamplePulls,
    values: array(dtype=float32),
):
    """One Gauss-Seidel step at a corner. A cell of samples has one corner of a color, so none is shared."""
    around = BLOCKS_AROUND * (slot // BLOCK_SLOTS)
    position = slot_position(slot, level)
    side = 1 << level.depth
    kind = axis_kind(position[0], side) + 4 * axis_kind(position[1], side) + 16 * axis_kind(position[2], side)
    row = CORNER_ENTRIES * kind
    across_faces = 0.0
    for j in range(FACE_CORNERS):
        entry = table[row + j]
        across_faces += values[BLOCK_SLOTS * level.around[around + (entry >> 3)] + (entry & 7)]
    across_cells = 0.0
    for j in range(CELL_CORNERS):
        entry = table[row + FACE_CORNERS + j]
        across_cells += values[BLOCK_SLOTS * level.around[around + (entry >> 3)] + (entry & 7)]
    pull = 0.0
    stiffness = 0.0
    cells = eight(-1)
    for corner in range(CELL_CORNERS):
        entry = table[row + FACE_CORNERS + CELL_CORNERS + corner]
        block = level.around[around + (entry >> 3)]
        if block >= 0:
            cell = pulls.cells_at[BLOCK_SLOTS * block + (entry & 7)]
            if cell >= 0:
                cells[corner] = cell
                fraction = corner_weight(pulls.fractions[cell], corner)
                pull += pulls.weights[cell] * fraction * pulls.values[cell]
                stiffness += pulls.weights[cell] * fraction * fraction
    mirrored = sides_met(position, side)
    value = values[slot]
    rest = mirrored * (tested[slot] - pull) - (8.0 / 3.0) * value + across_faces / 6.0 + across_cells / 12.0
    change = rest / (8.0 / 3.0 + mirrored * stiffness)
    values[slot] = value + change
    if stiffness > 0.0:
        for corner in range(CELL_CORNERS):
            cell = cells[corner]
            if cell >= 0:
                pulls.values[cell] = pulls.values[cell] + corner_weight(pulls.fractions[cell], corner) * change


@kernel
def renew_corners_kernel(
    corners: array(dtype=int32),
    firsts: array(dtype=int32),
    color: int,
    table: array(dtype=int32),
    level: OctreeLevel,
    tested: array(dtype=float32),
    pulls: SamplePulls,
    values: array(dtype=float32),
):
    """The corners of a color."""
    i = tid()
    first = firsts[color]
    if first + i >= firsts[color + 1]:
        return
    renew_corner(corners[first + i], table, level, tested, pulls, values)


@kernel
def renew_level_kernel(
    threads: int,
    sweeps: int,
    corners: array(dtype=int32),
    firsts: array(dtype=int32),
    table: array(dtype=int32),
    level: OctreeLevel,
    tested: array(dtype=float32),
    pulls: SamplePulls,
    values: array(dtype=float32),
):
    """All sweeps over all colors of a small level: one block on CUDA, one thread on the CPU."""
    i = tid()
    colors = int(BLOCK_SLOTS)
    for _ in range(sweeps):
        for color in range(colors):
            at = firsts[color] + i
            while at < firsts[color + 1]:
                renew_corner(corners[at], table, level, tested, pulls, values)
                at += threads
            wait_for_block()


@reduction
def weigh_values(
    cells: SampleCells, slots: array(dtype=int32), level: OctreeLevel, values: array(dtype=float32)
) -> vec2d:
    """(weight * value, weight) at the samples of undivided cells. Halo slots lack corners."""
    i = tid()
    weight = float64(0.0)
    value = 0.0
    if is_cell(slots[i], level) > is_divided(slots[i], level):
        weight = float64(cells.weights[i])
        value = corner_value(values, slots[i], fractions_in_cell(cells.means[i], slots[i], level), level)
    return vec2d(weight * float64(value), weight)


def solve(
    pyramid: "DensityPyramid",
    tests: Sequence[Scalars | None],
    weight: float,
    areas: Array1[vec2d],
    cube: Cube | None = None,
    envelope: Envelope | None = None,
    progress: Callable[[str, int, int], None] | None = None,
) -> list[Any]:
    """Solution at the corners of all levels by depth (None for 0). `weight` is the pull on level 0, times 4^depth.
    `areas` vec2d [1]: area of all samples in faces of level 0, and weight. `progress`: ("levels", solved, total)."""
    levels = pyramid.levels
    solutions: list[Any] = [None]
    table = upload(CORNER_TABLE, int32, levels[1].device)
    for depth in range(1, len(levels)):
        if progress is not None:
            progress("levels", depth - 1, len(levels) - 1)
        level, device = levels[depth], levels[depth].device
        values = zeros(BLOCK_SLOTS * level.count, float32, device)
        if depth > 1:
            launch(lower_values_kernel, values.size, [levels[depth - 1], solutions[-1], level, values])
        mask = compute(mark_unknowns_kernel, values.size, [level, level.count], uint8, device)
        if envelope is not None:
            assert cube is not None
            fix_outside(level, cube, envelope, mask, values)
        corners, firsts, counts = list_unknowns(mask, level.count)
        pulls = SamplePulls(pyramid, depth, values, weight, areas)
        arguments = [level, tests[depth], pulls, values]

        def sweep(corners=corners, firsts=firsts, counts=counts, arguments=arguments) -> None:
            for color, count in enumerate(counts):
                launch(renew_corners_kernel, count, [corners, firsts, color, table, *arguments])

        sweeps = (
            COARSE_SWEEPS if depth <= COARSE_LEVELS else FULL_SWEEPS if depth == COARSE_LEVELS + 1 else SWEEPS_PER_LEVEL
        )
        if level.count <= (MAX_ALONE if device.is_cuda else MAX_ALONE_ON_CPU):
            threads = block_threads(device)
            launch(renew_level_kernel, threads, [threads, sweeps, corners, firsts, table, *arguments])
        else:
            _repeat(sweep, sweeps, device)
        solutions.append(values)
    return solutions


def _repeat(body: Callable[[], None], count: int, device: Device) -> None:
    if device.is_cuda:
        graph = record(device, body)
        for _ in range(count):
            replay(graph)
    else:
        for _ in range(count):
            body()


@kernel
def add_pair_kernel(pair: array(dtype=vec2d), total: array(dtype=vec2d)):
    i = tid()
    total[i] = total[i] + pair[i]


def sum_levels(sums: Sequence[Array1[vec2d]]) -> Array1[vec2d]:
    total = zeros(1, vec2d, sums[0].device)
    for part in sums:
        launch(add_pair_kernel, 1, [part, total])
    return total


def mean_at_samples(pyramid: "DensityPyramid", solutions: Sequence[Scalars | None]) -> Array1[vec2d]:
    """Weighted mean of the solution at the samples, the value on the surface: (sum, weight), vec2d [1]."""
    sums = []
    for depth in range(1, len(solutions)):
        cells, slots = pyramid.cells[depth], pyramid.nodes[depth].slots
        sums.append(reduce(weigh_values, cells.count, [cells, slots, pyramid.levels[depth], solutions[depth]]))
    return sum_levels(sums)


FULL_DEPTH = 5  # up to this level all cells are divided: the function is solved in the complete cube
BLOCK_BYTES = 800  # of a block of eight slots, in all simultaneous arrays, including the surface
SAMPLE_BYTES = 90  # of a sample on the finest level, with its cells of the levels above


@reduction
def sum_areas(cells: SampleCells, nodes: SampleNodes) -> vec2d:
    """(area, weight) of the samples of cells that end on a level; areas in faces of the cube."""
    i = tid()
    area = float64(0.0)
    weight = float64(0.0)
    if nodes.states[i] == TREE_ENDS:
        area = float64(cells.weights[i]) * float64(pow(4.0, -nodes.depths[i]))
        weight = float64(cells.weights[i])
    return vec2d(area, weight)


class PoissonSurface(NamedTuple):
    """Surface, local depths of its vertices, and the finest level of the tree."""

    vertices: Points
    normals: Vectors
    triangles: Triangles
    densities: Scalars
    depth: int


def grow_tree(
    cells: Sequence[SampleCells], sample_count: int, deepest: int, kernel_depth: int, samples_per_cell: float
) -> DensityPyramid:
    """Grow the octree over samples. Raises MemoryError if the next level does not fit on the device."""
    device = cells[0].codes.device
    pyramid = DensityPyramid(cells, sample_count, deepest, kernel_depth, samples_per_cell)
    above, level = first_levels(device)
    while level is not None:
        growing = pyramid.enter(level, above)
        if level.depth == deepest:
            break
        is_full = level.depth < FULL_DEPTH
        divide(level, None if is_full else growing)
        above, level = level, next_level(level, BLOCK_BYTES, is_full)  # sync beyond the full levels
    return pyramid


class PoissonSettings(NamedTuple):
    """Settings of a reconstruction: the finest level `depth` >= 2, linear interpolation of vertices (`is_linear`), the
    weight of points, samples per cell, and weights by the lengths of the normals (`by_length`)."""

    depth: int
    is_linear: bool
    point_weight: float
    samples_per_cell: float
    by_length: bool


def reconstruct_poisson(
    points: Points,
    normals: Vectors,
    rows: Indices,
    cube: Cube,
    settings: PoissonSettings,
    envelope: Envelope | None = None,
    progress: Callable[[str, int, int], None] | None = None,
) -> PoissonSurface:
    """Reconstruct a surface from oriented points. `rows` (int32) are points with a valid normal, `cube` contains them.
    `progress` gets (stage, steps done, total). Raises MemoryError if the tree does not fit, and ValueError for more
    triangles than int32 counts."""
    depth = settings.depth
    check_room(points.device, rows.size * SAMPLE_BYTES, f"the cells of {rows.size:,} points")
    cells = gather_samples(points, normals, rows, cube, depth, settings.by_length)
    pyramid = grow_tree(cells, rows.size, depth, max(1, depth - 2), settings.samples_per_cell)
    areas = sum_levels([reduce(sum_areas, c.count, [c, r]) for c, r in pyramid.pairs()])
    tests = constraints(pyramid)
    solutions = solve(pyramid, tests, settings.point_weight, areas, cube, envelope, progress)
    del tests
    if progress is not None:
        progress("surface", 0, 0)
    iso = mean_at_samples(pyramid, solutions)
    surface = OctreeSurface(pyramid.levels, solutions, iso, cube, settings.is_linear)
    depths = empty(surface.slots.size, int32, points.device)
    for level, first, last in surface.ranges:
        if last > first:
            fill(depths[first:last], level)
    densities = local_depths(pyramid, surface.cube_positions, surface.slots, depths)
    return PoissonSurface(surface.vertices, surface.normals, surface.triangles, densities, len(pyramid.levels) - 1)
