"""The Poisson equation on the levels of an octree: a function whose gradient follows the samples' normals.

Sought is the piecewise linear u that makes |grad u - V|^2 least, integrated over the cube, plus a weight times the
squares of u at the samples. V is the field of normals: each sample's, times the area that it stands for, spread by the
quadratic splines of its cell on the level where its tree ends (between two levels, on both).

Level by level the equation is tested with the functions at the level's corners (`constraints`): V from this level by
exact integrals over splines, from finer levels by restriction, from coarser ones by their values at the corners. All of
it is divided by the width h of a cell, so that no number depends on the level.

A field V is held as V h: on a cell's spline the sum of area h^-2 times normals. Source: Kazhdan and Hoppe, "Screened
Poisson surface reconstruction", ACM TOG 32(3), 2013; the corners' linear functions are those of its code since 2018.
"""

from ..lang import array, atomic_max, float32, func, int32, kernel, launch, pow, tid, vec3
from ..memory import download, empty, zeros
from .octree_levels import SLOTS, OctreeLevel, neighbor_slot
from .sample_cells import SampleCells
from .sample_density import ENDS, SampleReach
from .splines import corner_weight, shares_in_cell, spline_product, spline_vector


@func
def level_share(local: float, depth: int) -> float:
    """How much of a sample whose tree ends on a level is spread there; the rest is on the level above."""
    share = float(1.0)
    if depth > 1:
        share = min(max(1.0 - (float(depth) - local), 0.0), 1.0)
    return share


@func
def cell_area(local: float, depth: int, samples_per_cell: float) -> float:
    """The area that a sample stands for, in those of a cell's face."""
    return pow(4.0, float(depth) - local) / samples_per_cell


@kernel
def sum_flux_kernel(
    cells: SampleCells,
    reach: SampleReach,
    depth: int,
    has_below: int,
    below: SampleCells,
    below_reach: SampleReach,
    samples_per_cell: float,
    flux: array(dtype=vec3),
    found: array(dtype=int32),
):
    """Area times normal of each cell's samples that are spread on this level; any thread notes that there are some."""
    i = tid()
    total = vec3(0.0, 0.0, 0.0)
    if reach.states[i] == ENDS:
        local = reach.depths[i]
        total = cells.sums[i] * (level_share(local, depth) * cell_area(local, depth, samples_per_cell))
        atomic_max(found, depth, 1)
    if has_below == 1 and reach.slots[i] >= 0:
        for j in range(cells.starts[i], cells.starts[i + 1]):
            if below_reach.states[j] == ENDS:
                local = below_reach.depths[j]
                rest = 1.0 - level_share(local, depth + 1)
                if rest > 0.0:
                    total = total + below.sums[j] * (rest * cell_area(local, depth, samples_per_cell))
                    atomic_max(found, depth, 1)
    flux[i] = total


@kernel
def spread_flux_kernel(
    cells_at: array(dtype=int32),
    cells: SampleCells,
    flux: array(dtype=vec3),
    level: OctreeLevel,
    field: array(dtype=vec3),
):
    """V h of each cell's spline."""
    i = tid()
    total = vec3(0.0, 0.0, 0.0)
    n = int(3)
    for x in range(n):
        for y in range(n):
            for z in range(n):
                slot = neighbor_slot(i, x - 1, y - 1, z - 1, level)
                if slot >= 0:
                    cell = cells_at[slot]
                    if cell >= 0:
                        f = shares_in_cell(cells.means[cell], slot, level)
                        total = total + flux[cell] * spline_product(f, 1 - x, 1 - y, 1 - z)
    field[i] = total


@func
def spline_mass(k: int) -> float:
    """The integral of a corner's function times the spline of the k-th cell from it, -2..1."""
    mass = float(0.4583333333333333)  # 11 / 24
    if k == -2 or k == 1:
        mass = 0.041666666666666664  # 1 / 24
    return mass


@func
def spline_slope(k: int) -> float:
    """The integral of the derivative of a corner's function times the spline of the k-th cell from it, -2..1."""
    slope = float(0.5)
    if k == -2 or k == 1:
        slope = 0.16666666666666666
    if k >= 0:
        slope = -slope
    return slope


@func
def linear_mass(k: int) -> float:
    """The integral of the functions of two corners, k = -1, 0, 1 apart."""
    return 0.6666666666666666 if k == 0 else 0.16666666666666666


@kernel
def test_field_kernel(field: array(dtype=vec3), level: OctreeLevel, tested: array(dtype=float32)):
    """The integral of V from this level's splines against the gradient of each corner's function."""
    i = tid()
    total = float(0.0)
    n = int(4)
    for x in range(n):
        for y in range(n):
            for z in range(n):
                slot = neighbor_slot(i, x - 2, y - 2, z - 2, level)
                if slot >= 0:
                    v = field[slot]
                    mx = spline_mass(x - 2)
                    my = spline_mass(y - 2)
                    mz = spline_mass(z - 2)
                    total += v[0] * spline_slope(x - 2) * my * mz
                    total += v[1] * mx * spline_slope(y - 2) * mz
                    total += v[2] * mx * my * spline_slope(z - 2)
    tested[i] = total


@kernel
def restrict_tests_kernel(level: OctreeLevel, below: array(dtype=float32), tested: array(dtype=float32)):
    """Add what the next level's functions were tested with: a function is theirs, halved with each step away."""
    i = tid()
    total = float(0.0)
    n = int(3)
    for x in range(n):
        for y in range(n):
            for z in range(n):
                slot = neighbor_slot(i, min(x - 1, 0), min(y - 1, 0), min(z - 1, 0), level)
                if slot >= 0:
                    block = level.children[slot]
                    if block >= 0:
                        child = SLOTS * block + ((x + 1) & 1) + 2 * ((y + 1) & 1) + 4 * ((z + 1) & 1)
                        weight = float(1.0)
                        if x != 1:
                            weight = weight * 0.5
                        if y != 1:
                            weight = weight * 0.5
                        if z != 1:
                            weight = weight * 0.5
                        total += weight * below[child]
    tested[i] = tested[i] + 0.5 * total


@func
def shares_in_parent(slot: int) -> vec3:
    """Where a corner lies in the cell of its block's parent: at its lowest corner or half way along an axis."""
    return vec3(0.5 * float(slot & 1), 0.5 * float((slot >> 1) & 1), 0.5 * float((slot >> 2) & 1))


@kernel
def lower_field_kernel(
    above: OctreeLevel,
    coarse: array(dtype=vec3),
    splines: array(dtype=vec3),
    level: OctreeLevel,
    fine: array(dtype=vec3),
):
    """V h at a level's corners from all levels above it; `coarse` is that of the level above, `splines` its own V h."""
    i = tid()
    parent = level.parents[i // SLOTS]
    f = shares_in_parent(i)
    total = spline_vector(splines, parent, f, above)
    n = int(8)
    for corner in range(n):
        weight = corner_weight(f, corner)
        if weight > 0.0:
            slot = neighbor_slot(parent, corner & 1, (corner >> 1) & 1, (corner >> 2) & 1, above)
            if slot >= 0:
                total = total + coarse[slot] * weight
    fine[i] = total * 0.5


@kernel
def test_lowered_kernel(field: array(dtype=vec3), level: OctreeLevel, tested: array(dtype=float32)):
    """Add the integral of V from coarser levels, linear between corners, against each function's gradient."""
    i = tid()
    total = float(0.0)
    n = int(3)
    for x in range(n):
        for y in range(n):
            for z in range(n):
                slot = neighbor_slot(i, x - 1, y - 1, z - 1, level)
                if slot >= 0:
                    v = field[slot]
                    mx = linear_mass(x - 1)
                    my = linear_mass(y - 1)
                    mz = linear_mass(z - 1)
                    total -= 0.5 * float(x - 1) * v[0] * my * mz
                    total -= 0.5 * float(y - 1) * v[1] * mx * mz
                    total -= 0.5 * float(z - 1) * v[2] * mx * my
    tested[i] = tested[i] + total


def constraints(pyramid):
    """The right-hand sides of all levels, a list by depth (None for 0): float32 device arrays, a number a slot.

    Args:
        pyramid: A DensityPyramid whose levels are complete.
    """
    levels, reaches, cells = pyramid.levels, pyramid.reaches, pyramid.cells
    device, last = levels[1].device, len(levels) - 1
    found = zeros(last + 1, int32, device)
    fields, tests = [None] * (last + 1), [None] * (last + 1)
    for depth in range(last, 0, -1):
        flux = empty(cells[depth].count, vec3, device)
        has_below = int(depth < last)
        beside = [cells[depth + has_below], reaches[depth + has_below]]
        arguments = [cells[depth], reaches[depth], depth, has_below, *beside, pyramid.samples_per_cell, flux, found]
        launch(sum_flux_kernel, flux.size, arguments)
        fields[depth] = flux
    is_found = download(found)  # sync
    for depth in range(last, 0, -1):
        level, slots = levels[depth], SLOTS * levels[depth].count
        tests[depth] = zeros(slots, float32, device)
        flux, fields[depth] = fields[depth], zeros(slots, vec3, device)
        if is_found[depth]:
            arguments = [pyramid.cells_at[depth], cells[depth], flux, level, fields[depth]]
            launch(spread_flux_kernel, slots, arguments)
            launch(test_field_kernel, slots, [fields[depth], level, tests[depth]])
        if depth < last:
            launch(restrict_tests_kernel, slots, [level, tests[depth + 1], tests[depth]])
    coarse = zeros(SLOTS * levels[1].count, vec3, device)
    for depth in range(2, last + 1):
        if not is_found[:depth].any():
            coarse = zeros(SLOTS * levels[depth].count, vec3, device)
            continue
        fine = empty(SLOTS * levels[depth].count, vec3, device)
        launch(lower_field_kernel, fine.size, [levels[depth - 1], coarse, fields[depth - 1], levels[depth], fine])
        launch(test_lowered_kernel, fine.size, [fine, levels[depth], tests[depth]])
        coarse = fine
    return tests
