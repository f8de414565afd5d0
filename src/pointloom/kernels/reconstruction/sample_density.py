"""Sample density and the resulting local depth of the octree.

W is the number of points per cell, in units of `samples_per_cell`, smoothed by quadratic B-splines. The local depth is
where W = 1: interpolated up to `kernel_depth`; beyond it, W grows by 4 per level. After `getSampleDepthAndWeight` of
PoissonRecon (Kazhdan and Hoppe, ACM TOG 32(3), 2013, section 4.4).
"""

from collections.abc import Iterator, Sequence
from typing import Any

from ..array_types import Device, Integers, Points, Scalars
from ..lang import array, compute, float32, func, int32, kernel, launch, log, struct, tid, vec3
from ..memory import empty, full
from .octree_levels import BLOCK_SLOTS, OctreeLevel, neighbor_slot, slot_position
from .sample_cells import SampleCells
from .splines import fractions_in_cell, is_beyond, spline_product, spline_value

# The tree continues below a cell of samples, ends with it, or has ended above it.
TREE_CONTINUES, TREE_ENDS, TREE_ENDED_ABOVE = 0, 1, 2
SPLINE_SQUARES = 0.59375  # of the splines at the center of a cell, along one axis: 1 / 64 + 9 / 16 + 1 / 64
LOG_4 = 1.3862943611198906  # on a surface a cell's children contain a quarter of its points


@struct
class SampleNodes:
    """Nodes of the tree for cells of samples of one level. `slots` are -1 below the tree, `anchors` the slots on the
    level of the density, `states` ON, ENDS or BELOW, `densities` W, `depths` the local depth of cells that end."""

    slots: array(dtype=int32)
    anchors: array(dtype=int32)
    states: array(dtype=int32)
    densities: array(dtype=float32)
    depths: array(dtype=float32)

    def __init__(self, count: int, device: Device) -> None:
        self.slots, self.anchors, self.states = (empty(count, int32, device) for _ in range(3))
        self.densities, self.depths = empty(count, float32, device), empty(count, float32, device)


@kernel
def find_slots_kernel(
    cells: SampleCells, above: SampleNodes, level_above: OctreeLevel, has_density: int, nodes: SampleNodes
):
    """Slot of each cell of samples, and the slot that provides its density."""
    i = tid()
    parent = cells.parents[i]
    slot = -1
    if above.slots[parent] >= 0:
        block = level_above.children[above.slots[parent]]
        if block >= 0:
            slot = BLOCK_SLOTS * block + int(cells.codes[i] & 7)
    nodes.slots[i] = slot
    nodes.anchors[i] = slot if has_density == 1 else above.anchors[parent]


@kernel
def fill_cells_kernel(slots: array(dtype=int32), cells_at: array(dtype=int32)):
    i = tid()
    if slots[i] >= 0:
        cells_at[slots[i]] = i


@kernel
def gather_density_kernel(
    cells_at: array(dtype=int32), cells: SampleCells, unit: float, level: OctreeLevel, density: array(dtype=float32)
):
    """Spline coefficients of the cells. None beyond the cube, where only its upper sides have slots."""
    i = tid()
    if is_beyond(slot_position(i, level), (1 << level.depth) - 1) == 1:
        density[i] = 0.0
        return
    total = 0.0
    n = int(3)
    for x in range(n):
        for y in range(n):
            for z in range(n):
                slot = neighbor_slot(i, x - 1, y - 1, z - 1, level)
                if slot >= 0:
                    cell = cells_at[slot]
                    if cell >= 0:
                        f = fractions_in_cell(cells.means[cell], slot, level)
                        total += cells.counts[cell] * spline_product(f, 1 - x, 1 - y, 1 - z)
    density[i] = total * unit


@func
def depth_beyond(w: float, depth: int) -> float:
    return float(depth) + log(max(w, 1.0)) / LOG_4


@func
def depth_between(above: float, w: float, depth: int) -> float:
    """Local depth where W falls from `above` (>= 1) below 1 on level `depth`."""
    fall = log(max(above, 1.0) / max(w, 1.0e-30))
    return float(depth - 1) + log(max(above, 1.0)) / fall


@kernel
def measure_depths_kernel(
    cells: SampleCells,
    above: SampleNodes,
    depth: int,
    kernel_depth: int,
    deepest: int,
    density_level: OctreeLevel,
    density: array(dtype=float32),
    nodes: SampleNodes,
):
    """W at each cell of samples with a growing parent, and whether the cell itself grows."""
    i = tid()
    parent = cells.parents[i]
    state = int(TREE_ENDED_ABOVE)
    w = 0.0
    local = above.depths[parent]
    if nodes.slots[i] >= 0 and above.states[parent] == TREE_CONTINUES:
        w = spline_value(
            density, nodes.anchors[i], fractions_in_cell(cells.means[i], nodes.anchors[i], density_level), density_level
        )
        state = TREE_ENDS
        if depth > density_level.depth:
            local = depth_beyond(w, density_level.depth)
        elif w < 1.0:
            local = depth_between(above.densities[parent], w, depth)
        elif depth == kernel_depth:
            local = depth_beyond(w, depth)
        else:
            local = float(depth + 1)
        if local > float(depth) and depth < deepest:
            state = TREE_CONTINUES
    nodes.states[i] = state
    nodes.densities[i] = w
    nodes.depths[i] = local


@kernel
def list_growing_kernel(nodes: SampleNodes, growing: array(dtype=int32)):
    """Slots of cells of samples that the tree subdivides, -1 for others."""
    i = tid()
    slot = -1
    if nodes.states[i] == TREE_CONTINUES:
        slot = nodes.slots[i]
    growing[i] = slot


class DensityPyramid:
    """Sample density by level from 1 on: `deepest`, `kernel_depth` with a density, W = 1 for `samples_per_cell`."""

    def __init__(
        self, cells: Sequence[SampleCells], sample_count: int, deepest: int, kernel_depth: int, samples_per_cell: float
    ) -> None:
        self.cells, self.samples_per_cell = cells, samples_per_cell
        self.deepest, self.kernel_depth = deepest, kernel_depth
        self.unit = 1.0 / (samples_per_cell * SPLINE_SQUARES)
        device = cells[0].codes.device
        top = SampleNodes(1, device)
        top.slots, top.anchors = full(1, 0, int32, device), full(1, 0, int32, device)
        top.states, top.depths = full(1, TREE_CONTINUES, int32, device), full(1, 0.0, float32, device)
        top.densities = full(1, max(1.0, sample_count / samples_per_cell), float32, device)
        self.nodes: list[SampleNodes] = [top]
        self.cells_at: list[Any] = [None]  # by depth. None at 0
        self.densities: list[Any] = [None]
        self.levels: list[Any] = [None]

    def enter(self, level: OctreeLevel, level_above: OctreeLevel) -> Integers:
        """Find the samples and densities of a new level. Return the slots to subdivide, or -1 (int32)."""
        depth, device = level.depth, level.device
        cells, above = self.cells[depth], self.nodes[-1]
        nodes = SampleNodes(cells.count, device)
        has_density = int(depth <= self.kernel_depth)
        launch(find_slots_kernel, cells.count, [cells, above, level_above, has_density, nodes])
        cells_at = full(BLOCK_SLOTS * level.count, -1, int32, device)
        launch(fill_cells_kernel, cells.count, [nodes.slots, cells_at])
        if has_density:
            density = empty(BLOCK_SLOTS * level.count, float32, device)
            launch(gather_density_kernel, density.size, [cells_at, cells, self.unit, level, density])
            self.densities.append(density)
            self.density_level = level
        arguments = [
            cells,
            above,
            depth,
            self.kernel_depth,
            self.deepest,
            self.density_level,
            self.densities[-1],
            nodes,
        ]
        launch(measure_depths_kernel, cells.count, arguments)
        self.nodes.append(nodes)
        self.cells_at.append(cells_at)
        self.levels.append(level)
        return compute(list_growing_kernel, cells.count, [nodes], int32, device)

    def pairs(self) -> Iterator[tuple[SampleCells, SampleNodes]]:
        """Cells of samples and their SampleNodes by level, from level 1 on."""
        return zip(self.cells[1 : len(self.nodes)], self.nodes[1:], strict=True)


@kernel
def rise_to_density_kernel(
    level: OctreeLevel,
    has_density: int,
    density: array(dtype=float32),
    positions: array(dtype=vec3),
    slots: array(dtype=int32),
    depths: array(dtype=int32),
    below: array(dtype=float32),
    result: array(dtype=float32),
):
    """Local depth at positions of this level; those with W < 1 continue on the level above."""
    i = tid()
    if depths[i] == level.depth:
        slot = slots[i]
        w = 0.0
        if has_density == 1:
            w = spline_value(density, slot, fractions_in_cell(positions[i], slot, level), level)
        if w >= 1.0:
            depths[i] = -1
            if below[i] < 0.0:
                result[i] = depth_beyond(w, level.depth)
            else:
                result[i] = depth_between(w, below[i], level.depth + 1)
        else:
            if has_density == 1:
                below[i] = w
            depths[i] = level.depth - 1
            slots[i] = level.parents[slot // BLOCK_SLOTS]


def local_depths(pyramid: DensityPyramid, positions: Points, slots: Integers, depths: Integers) -> Scalars:
    """Local depth (float32 [m]) at positions (0..1); `slots` and `depths` of a slot at or next to each are modified."""
    device = positions.device
    below, result = full(positions.size, -1.0, float32, device), full(positions.size, 0.0, float32, device)
    for level in reversed(pyramid.levels[1:]):
        has_density = int(level.depth < len(pyramid.densities))
        density = pyramid.densities[level.depth] if has_density else pyramid.densities[-1]
        arguments = [level, has_density, density, positions, slots, depths, below, result]
        launch(rise_to_density_kernel, positions.size, arguments)
    return result
