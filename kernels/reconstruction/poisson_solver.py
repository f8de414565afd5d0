"""The Poisson system of each level, coarse to fine: eight-coloured Gauss-Seidel from the coarser level's solution.

The corners of a level that all eight cells around exist for are its unknowns; the others hold what the level above has
there, so the solution is continuous where levels meet. Corners of one colour (equal parity of x, y and z) do not meet
in an equation, so all of them are renewed at once, and the result does not depend on the order of the threads.

Divided by the width of a cell the Laplacian is 8/3 at the corner, 0 at the 6 next to it, -1/6 at the 12 across a face
and -1/12 at the 8 across a cell. Samples pull u to 0 with a weight a point that does not depend on the level; those of
a cell count as one, at their mean, and what u is there is kept and corrected as its corners change. At the sides of
the cube no gradient is asked for (Neumann): corners there see themselves mirrored.

A renewal reads 21 corners, through a table of where they lie from each kind of corner; each level is solved by a fixed
number of sweeps, never until a tolerance.
"""

from collections.abc import Callable, Sequence
from itertools import product
from typing import TYPE_CHECKING, Any

import numpy as np

from ..array_types import Array1, Device, Scalars
from ..lang import (
    array,
    float32,
    float64,
    func,
    int32,
    kernel,
    launch,
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
from ..memory import empty, upload, zeros
from .envelope import Envelope, hold_outside
from .octree_levels import AROUND, SLOTS, OctreeLevel, is_cell, is_divided, slot_place
from .poisson_system import shares_in_parent
from .poisson_unknowns import list_unknowns, mark_unknowns_kernel
from .sample_cells import Cube, SampleCells
from .splines import corner_value, corner_weight, shares_in_cell

if TYPE_CHECKING:
    from .sample_density import DensityPyramid

COARSE = 4  # levels up to this one are small and get more sweeps
COARSE_SWEEPS = 10
FULL_SWEEPS = 8  # of the last level that fills the cube; four leave its surface 10 % less exact
SWEEPS = 4  # from the level above its solution; eight change no error by 1 %
eight = vector(8, int32)


@kernel
def lower_values_kernel(
    above: OctreeLevel, coarse: array(dtype=float32), level: OctreeLevel, fine: array(dtype=float32)
):
    """The values at a level's corners from those of the level above."""
    i = tid()
    fine[i] = corner_value(coarse, level.parents[i // SLOTS], shares_in_parent(i), above)


@struct
class SamplePulls:
    """How the samples pull on a level's solution.

    Attributes:
        cells_at: int32 [slots], the cell of samples at each slot, or -1.
        shares: vec3 [cells], where each cell's samples lie in it.
        weights: float32 [cells].
        values: float32 [cells], the solution there.
    """

    cells_at: array(dtype=int32)
    shares: array(dtype=vec3)
    weights: array(dtype=float32)
    values: array(dtype=float32)

    def __init__(
        self, pyramid: "DensityPyramid", depth: int, values: Scalars, weight: float, areas: Array1[vec2d]
    ) -> None:
        cells, level, slots = pyramid.cells[depth], pyramid.levels[depth], pyramid.reaches[depth].slots
        device = level.device
        self.cells_at = pyramid.cells_at[depth]
        self.shares = empty(cells.count, vec3, device)
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
    """Place and weight of each cell's samples, and what the solution is there; `areas` is (area, weight) of all."""
    i = tid()
    pull = float(weight * areas[0][0] / areas[0][1])
    f = vec3(0.0, 0.0, 0.0)
    value = 0.0
    if slots[i] >= 0:
        f = shares_in_cell(cells.means[i], slots[i], level)
        value = corner_value(values, slots[i], f, level)
    pulls.shares[i] = f
    pulls.weights[i] = pull * cells.weights[i]
    pulls.values[i] = value


FACES, CELLS = 12, 8  # corners across the faces around a corner, and across the cells
ENTRIES = FACES + 2 * CELLS  # of a kind of corner in the table, the cells around it last
EVEN, ODD, FIRST, LAST = range(4)  # where a corner lies along an axis: in its block, or at a side of the cube


def _step(kind: int, step: int) -> tuple[int, int]:
    """Along one axis: the block (-1, 0, 1) and the place in it of the corner a step away; at a side as in a mirror."""
    if (kind == FIRST and step < 0) or (kind == LAST and step > 0):
        step = -step
    at = (1 if kind == ODD else 0) + step
    return at >> 1, at & 1


def _entry(kinds: Sequence[int], steps: Sequence[int] | tuple[int, int, int]) -> int:
    blocks, places = zip(*(_step(kind, step) for kind, step in zip(kinds, steps, strict=True)), strict=True)
    around = sum(factor * (block + 1) for factor, block in zip((9, 3, 1), blocks, strict=True))
    return SLOTS * around + sum(place << axis for axis, place in enumerate(places))


def _cell_entry(kinds: Sequence[int], corner: int) -> int:
    """Of the cell that a corner is the given corner of: not mirrored, so outside the cube there is no block."""
    plain = [ODD if kind == ODD else EVEN for kind in kinds]
    return _entry(plain, [-(corner >> axis & 1) for axis in range(3)])


def _build_table() -> np.ndarray:
    steps = sorted(product((-1, 0, 1), repeat=3), key=lambda step: (sum(map(abs, step)), step))
    far = [step for step in steps if sum(map(abs, step)) > 1]
    rows = []
    for number in range(64):
        kinds = [number >> 2 * axis & 3 for axis in range(3)]
        rows.append([_entry(kinds, step) for step in far] + [_cell_entry(kinds, c) for c in range(CELLS)])
    return np.array(rows, np.int32).ravel()


CORNER_TABLE = _build_table()  # [64 * ENTRIES], SLOTS * (which block around) + place in it


@func
def axis_kind(at: int, cells: int) -> int:
    """EVEN, ODD, FIRST or LAST."""
    kind = at & 1
    if at == 0:
        kind = FIRST
    if at == cells:
        kind = LAST
    return kind


@func
def sides_met(place: vec3i, cells: int) -> float:
    """2 to the number of sides of the cube that a corner lies on."""
    factor = 1.0
    for axis in range(3):
        if place[axis] == 0 or place[axis] == cells:
            factor = factor * 2.0
    return factor


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
    """One Gauss-Seidel step at the corners of a colour; a cell of samples has one corner of it, so none is shared."""
    i = tid()
    first = firsts[color]
    if first + i >= firsts[color + 1]:
        return
    slot = corners[first + i]
    around = AROUND * (slot // SLOTS)
    place = slot_place(slot, level)
    side = 1 << level.depth
    kind = axis_kind(place[0], side) + 4 * axis_kind(place[1], side) + 16 * axis_kind(place[2], side)
    row = ENTRIES * kind
    across_faces = 0.0
    for j in range(FACES):
        entry = table[row + j]
        across_faces += values[SLOTS * level.around[around + (entry >> 3)] + (entry & 7)]
    across_cells = 0.0
    for j in range(CELLS):
        entry = table[row + FACES + j]
        across_cells += values[SLOTS * level.around[around + (entry >> 3)] + (entry & 7)]
    pull = 0.0
    stiffness = 0.0
    cells = eight(-1)
    for corner in range(CELLS):
        entry = table[row + FACES + CELLS + corner]
        block = level.around[around + (entry >> 3)]
        if block >= 0:
            cell = pulls.cells_at[SLOTS * block + (entry & 7)]
            if cell >= 0:
                cells[corner] = cell
                share = corner_weight(pulls.shares[cell], corner)
                pull += pulls.weights[cell] * share * pulls.values[cell]
                stiffness += pulls.weights[cell] * share * share
    mirrored = sides_met(place, side)
    own = values[slot]
    rest = mirrored * (tested[slot] - pull) - (8.0 / 3.0) * own + across_faces / 6.0 + across_cells / 12.0
    change = rest / (8.0 / 3.0 + mirrored * stiffness)
    values[slot] = own + change
    if stiffness > 0.0:
        for corner in range(CELLS):
            cell = cells[corner]
            if cell >= 0:
                pulls.values[cell] = pulls.values[cell] + corner_weight(pulls.shares[cell], corner) * change


@reduction
def weigh_values(
    cells: SampleCells, slots: array(dtype=int32), level: OctreeLevel, values: array(dtype=float32)
) -> vec2d:
    """(weight times value, weight) of the solution at the samples of undivided cells; the halo's slots lack corners."""
    i = tid()
    weight = float64(0.0)
    value = 0.0
    if is_cell(slots[i], level) > is_divided(slots[i], level):
        weight = float64(cells.weights[i])
        value = corner_value(values, slots[i], shares_in_cell(cells.means[i], slots[i], level), level)
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
    """The solution at the corners of all levels, a list by depth (None for 0) of float32 device arrays.

    Args:
        pyramid: A DensityPyramid whose levels are complete.
        tests: From `constraints`.
        weight: How much a sample pulls where samples stand for a face of a cell on level 0; 4^depth times that on a
            level.
        areas: vec2d [1], the area that all samples stand for, in those faces, and their weight.
        cube, envelope: A Cube, and an Envelope in it beyond which the function is held; None for none.
        progress: Called with "levels", levels solved and levels in all, before each.
    """
    levels = pyramid.levels
    solutions: list[Any] = [None]
    table = upload(CORNER_TABLE, int32, levels[1].device)
    for depth in range(1, len(levels)):
        if progress is not None:
            progress("levels", depth - 1, len(levels) - 1)
        level, device = levels[depth], levels[depth].device
        values = zeros(SLOTS * level.count, float32, device)
        if depth > 1:
            launch(lower_values_kernel, values.size, [levels[depth - 1], solutions[-1], level, values])
        mask = empty(values.size, uint8, device)
        launch(mark_unknowns_kernel, values.size, [level, level.count, mask])
        if envelope is not None:
            assert cube is not None
            hold_outside(level, cube, envelope, mask, values)
        corners, firsts, counts = list_unknowns(mask, level.count)
        pulls = SamplePulls(pyramid, depth, values, weight, areas)
        arguments = [level, tests[depth], pulls, values]

        def sweep(corners=corners, firsts=firsts, counts=counts, arguments=arguments) -> None:
            for color, count in enumerate(counts):
                launch(renew_corners_kernel, count, [corners, firsts, color, table, *arguments])

        _repeat(sweep, COARSE_SWEEPS if depth <= COARSE else FULL_SWEEPS if depth == COARSE + 1 else SWEEPS, device)
        solutions.append(values)
    return solutions


def _repeat(body: Callable[[], None], count: int, device: Device) -> None:
    """The same launches so many times; on CUDA a graph of one turn, launched again and again."""
    if device.is_cuda:
        turn = record(device, body)
        for _ in range(count):
            replay(turn)
    else:
        for _ in range(count):
            body()


@kernel
def add_pair_kernel(pair: array(dtype=vec2d), total: array(dtype=vec2d)):
    """Add a sum to those before it."""
    i = tid()
    total[i] = total[i] + pair[i]


def sum_levels(sums: Sequence[Array1[vec2d]]) -> Array1[vec2d]:
    """The sum of vec2d [1] arrays in their order, on their device."""
    total = zeros(1, vec2d, sums[0].device)
    for part in sums:
        launch(add_pair_kernel, 1, [part, total])
    return total


def mean_at_samples(pyramid: "DensityPyramid", solutions: Sequence[Scalars | None]) -> Array1[vec2d]:
    """The solution's mean at the samples, weighted as they are, the value on the surface: (sum, weight), vec2d [1]."""
    sums = []
    for depth in range(1, len(solutions)):
        cells, slots = pyramid.cells[depth], pyramid.reaches[depth].slots
        sums.append(reduce(weigh_values, cells.count, [cells, slots, pyramid.levels[depth], solutions[depth]]))
    return sum_levels(sums)
