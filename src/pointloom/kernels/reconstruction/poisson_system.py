"""The Poisson equation on the levels of an octree: a function whose gradient fits the sample normals.

Kazhdan and Hoppe, "Screened Poisson surface reconstruction", ACM TOG 32(3), 2013, and its code since 2018. The
piecewise linear u minimizes the integral of |grad u - V|^2 plus weighted squares of u at the samples. V spreads normals
times area by quadratic splines, and is stored as V h, mirrored at the sides. Constraints of a level come from its own V
by exact integrals, from finer levels by restriction, and from coarser ones by corner values.
"""

from typing import Any

import numpy as np

from ..array_types import Scalars
from ..lang import (
    array,
    atomic_max,
    callback,
    float32,
    func,
    int32,
    kernel,
    launch,
    pow,
    tid,
    vec2,
    vec3,
    vec3i,
    vector,
)
from ..memory import download, empty, zeros
from .octree_levels import BLOCK_SLOTS, OctreeLevel, neighbor_slot, slot_beside, slot_position
from .sample_cells import SampleCells
from .sample_density import TREE_ENDS, DensityPyramid, SampleNodes
from .splines import fractions_in_cell, is_beyond, mirrored_step, spline_weight

eight = vector(8, float32)


@func
def level_fraction(local: float, depth: int) -> float:
    """Fraction of a sample that is spread on the level where its tree ends. The rest goes to the level above."""
    fraction = 1.0
    if depth > 1:
        fraction = min(max(1.0 - (float(depth) - local), 0.0), 1.0)
    return fraction


@func
def cell_area(local: float, depth: int, samples_per_cell: float) -> float:
    return pow(4.0, float(depth) - local) / samples_per_cell


@kernel
def sum_flux_kernel(
    cells: SampleCells,
    nodes: SampleNodes,
    depth: int,
    has_below: int,
    below: SampleCells,
    below_nodes: SampleNodes,
    samples_per_cell: float,
    flux: array(dtype=vec3),
    flux_flags: array(dtype=int32),
):
    """Area times normal of each cell's samples on this level. All threads that write `flux_flags` write 1."""
    i = tid()
    total = vec3(0.0, 0.0, 0.0)
    if nodes.states[i] == TREE_ENDS:
        local = nodes.depths[i]
        total = cells.sums[i] * (level_fraction(local, depth) * cell_area(local, depth, samples_per_cell))
        atomic_max(flux_flags, depth, 1)
    if has_below == 1 and nodes.slots[i] >= 0:
        for j in range(cells.starts[i], cells.starts[i + 1]):
            if below_nodes.states[j] == TREE_ENDS:
                local = below_nodes.depths[j]
                rest = 1.0 - level_fraction(local, depth + 1)
                if rest > 0.0:
                    total = total + below.sums[j] * (rest * cell_area(local, depth, samples_per_cell))
                    atomic_max(flux_flags, depth, 1)
    flux[i] = total


@kernel
def spread_flux_kernel(
    cells_at: array(dtype=int32),
    cells: SampleCells,
    flux: array(dtype=vec3),
    level: OctreeLevel,
    field: array(dtype=vec3),
):
    """V h of the splines of a block's cells, from the samples of 64 cells, mirrored at the sides."""
    i = tid()
    xs = eight(0.0)
    ys = eight(0.0)
    zs = eight(0.0)
    width = 1 << level.depth
    base = level.positions[i] * 2
    n = 4
    if is_beyond(base, width - 1) == 1:
        n = 0
    for x in range(n):
        dx = mirrored_step(base[0], x - 1, width)
        for y in range(n):
            dy = mirrored_step(base[1], y - 1, width)
            for z in range(n):
                dz = mirrored_step(base[2], z - 1, width)
                slot = slot_beside(level.around, i, dx, dy, dz)
                cell = -1
                if slot >= 0:
                    cell = cells_at[slot]
                if cell >= 0:
                    f = fractions_in_cell(cells.means[cell], slot, level)
                    fx = f[0] if dx == x - 1 else 1.0 - f[0]
                    fy = f[1] if dy == y - 1 else 1.0 - f[1]
                    fz = f[2] if dz == z - 1 else 1.0 - f[2]
                    v = flux[cell]
                    wx = vec2(near_weight(fx, 1 - x), near_weight(fx, 2 - x))
                    wy = vec2(near_weight(fy, 1 - y), near_weight(fy, 2 - y))
                    wz = vec2(near_weight(fz, 1 - z), near_weight(fz, 2 - z))
                    for corner in range(BLOCK_SLOTS):
                        weight = wx[corner & 1] * wy[(corner >> 1) & 1] * wz[(corner >> 2) & 1]
                        xs[corner] = xs[corner] + weight * v[0]
                        ys[corner] = ys[corner] + weight * v[1]
                        zs[corner] = zs[corner] + weight * v[2]
    for corner in range(BLOCK_SLOTS):
        field[BLOCK_SLOTS * i + corner] = vec3(xs[corner], ys[corner], zs[corner])


@func
def near_weight(f: float, k: int) -> float:
    """`spline_weight`, and 0 for cells that are not adjacent."""
    weight = 0.0
    if k >= -1 and k <= 1:
        weight = spline_weight(f, k)
    return weight


@func
def is_outside(k: int, at: int, width: int) -> int:
    """1 if the k-th cell from a corner is beyond the corner's side of the cube, or too far."""
    return 1 if k < -2 or k > 1 or (at == 0 and k < 0) or (at == width and k >= 0) else 0


@func
def spline_mass(k: int, at: int, width: int) -> float:
    """Integral of a corner function times the spline of the k-th cell, including mirror images."""
    mass = 0.4583333333333333  # 11 / 24
    if k == -2 or k == 1:
        mass = 0.041666666666666664  # 1 / 24
    if is_outside(k, at, width) == 1:
        mass = 0.0
    return mass


@func
def spline_slope(k: int, at: int, width: int) -> float:
    """Integral of the derivative of a corner function times the spline of the k-th cell."""
    slope = 0.5
    if at == 0 or at == width:
        slope = 0.8333333333333334  # 2 / 3 and its mirror image's 1 / 6
    if k == -2 or k == 1:
        slope = 0.16666666666666666
    if k >= 0:
        slope = -slope
    if is_outside(k, at, width) == 1:
        slope = 0.0
    return slope


@func
def linear_mass(k: int, at: int, width: int) -> float:
    """Integral within the cube of the functions of two corners k apart. The first is at `at`."""
    mass = 0.16666666666666666
    if k == 0:
        mass = 0.6666666666666666
        if at == 0 or at == width:
            mass = 0.3333333333333333
    if k < -1 or k > 1 or (k < 0 and at == 0) or (k > 0 and at == width):
        mass = 0.0
    return mass


@func
def linear_slope(k: int, at: int, width: int) -> float:
    """Integral of the derivative of the first times the function of the second corner."""
    slope = -0.5 * float(k)
    if at == 0:
        slope = -0.5 if k >= 0 else 0.0
    if at == width:
        slope = 0.5 if k <= 0 else 0.0
    if k < -1 or k > 1:
        slope = 0.0
    return slope


@func
def tested_along_z(v: vec3, step: int, z: int, width: int, mass: callback, slope: callback) -> vec3:
    """Integrals along z of a vector's components against the function at z and, for the last, its slope."""
    m = mass(step, z, width)
    return vec3(v[0] * m, v[1] * m, v[2] * slope(step, z, width))


@func
def tested_across(
    total: eight, low: vec3, high: vec3, dx: int, dy: int, base: vec3i, width: int, mass: callback, slope: callback
) -> eight:
    """Add one column to the sums of a block's corners: `low` for the lower four, `high` for the upper."""
    mx = vec2(mass(dx, base[0], width), mass(dx - 1, base[0] + 1, width))
    my = vec2(mass(dy, base[1], width), mass(dy - 1, base[1] + 1, width))
    sx = vec2(slope(dx, base[0], width), slope(dx - 1, base[0] + 1, width))
    sy = vec2(slope(dy, base[1], width), slope(dy - 1, base[1] + 1, width))
    sums = total
    for upper in range(2):
        v = low
        if upper == 1:
            v = high
        for b in range(2):
            for a in range(2):
                part = v[0] * sx[a] * my[b]
                part += v[1] * mx[a] * sy[b] + v[2] * mx[a] * my[b]
                corner = 4 * upper + 2 * b + a
                sums[corner] = sums[corner] + part
    return sums


@kernel
def test_field_kernel(field: array(dtype=vec3), level: OctreeLevel, tested: array(dtype=float32)):
    """Integral of this level's V against the gradients of a block's corner functions, along z, y, then x."""
    i = tid()
    total = eight(0.0)
    width = 1 << level.depth
    base = level.positions[i] * 2
    n = int(5)
    for x in range(n):
        dx = max(mirrored_step(base[0], x - 2, width), -2)  # farther only for corners beyond the cube
        for y in range(n):
            dy = max(mirrored_step(base[1], y - 2, width), -2)
            low = vec3(0.0, 0.0, 0.0)
            high = vec3(0.0, 0.0, 0.0)
            for z in range(n):
                slot = slot_beside(level.around, i, dx, dy, max(mirrored_step(base[2], z - 2, width), -2))
                if slot >= 0:
                    v = field[slot]
                    low = low + tested_along_z(v, z - 2, base[2], width, spline_mass, spline_slope)
                    high = high + tested_along_z(v, z - 3, base[2] + 1, width, spline_mass, spline_slope)
            total = tested_across(total, low, high, x - 2, y - 2, base, width, spline_mass, spline_slope)
    for corner in range(BLOCK_SLOTS):
        if is_beyond(slot_position(BLOCK_SLOTS * i + corner, level), width) == 1:
            total[corner] = 0.0
        tested[BLOCK_SLOTS * i + corner] = total[corner]


@kernel
def restrict_tests_kernel(level: OctreeLevel, below: array(dtype=float32), tested: array(dtype=float32)):
    """Restrict the constraints of the next level: weights halve with each step."""
    i = tid()
    total = 0.0
    n = int(3)
    for x in range(n):
        for y in range(n):
            for z in range(n):
                slot = neighbor_slot(i, min(x - 1, 0), min(y - 1, 0), min(z - 1, 0), level)
                if slot >= 0:
                    block = level.children[slot]
                    if block >= 0:
                        child = BLOCK_SLOTS * block + ((x + 1) & 1) + 2 * ((y + 1) & 1) + 4 * ((z + 1) & 1)
                        weight = 1.0
                        if x != 1:
                            weight = weight * 0.5
                        if y != 1:
                            weight = weight * 0.5
                        if z != 1:
                            weight = weight * 0.5
                        total += weight * below[child]
    tested[i] = tested[i] + 0.5 * total


@func
def fractions_in_parent(slot: int) -> vec3:
    return vec3(0.5 * float(slot & 1), 0.5 * float((slot >> 1) & 1), 0.5 * float((slot >> 2) & 1))


@func
def half_spline_weight(half: int, k: int) -> float:
    """`spline_weight` at the lowest corner of a cell (0) and in its middle (1)."""
    return spline_weight(0.5 * float(half), k)


@func
def half_corner_weight(half: int, k: int) -> float:
    """Weight of the lower (0) or upper (1) cell corner at the lowest corner (0) and in the middle (1)."""
    return 0.5 * float(half) if k == 1 else 1.0 - 0.5 * float(half)


@kernel
def lower_field_kernel(
    above: OctreeLevel,
    coarse: array(dtype=vec3),
    splines: array(dtype=vec3),
    level: OctreeLevel,
    fine: array(dtype=vec3),
):
    """V h at the corners of a block from all coarser levels; `coarse` is that of the level above."""
    i = tid()
    parent = level.parents[i]
    position = slot_position(parent, above)
    width = 1 << above.depth
    xs = eight(0.0)
    ys = eight(0.0)
    zs = eight(0.0)
    n = int(3)
    for x in range(n):
        dx = mirrored_step(position[0], x - 1, width)
        for y in range(n):
            dy = mirrored_step(position[1], y - 1, width)
            for z in range(n):
                v = vec3(0.0, 0.0, 0.0)
                slot = neighbor_slot(parent, dx, dy, mirrored_step(position[2], z - 1, width), above)
                if slot >= 0:
                    v = splines[slot] * 0.5
                u = vec3(0.0, 0.0, 0.0)
                if x > 0 and y > 0 and z > 0:
                    slot = neighbor_slot(parent, x - 1, y - 1, z - 1, above)
                    if slot >= 0:
                        u = coarse[slot] * 0.5
                for corner in range(BLOCK_SLOTS):
                    a = corner & 1
                    b = (corner >> 1) & 1
                    c = (corner >> 2) & 1
                    weight = half_spline_weight(a, x - 1) * half_spline_weight(b, y - 1)
                    weight = weight * half_spline_weight(c, z - 1)
                    fraction = half_corner_weight(a, x - 1) * half_corner_weight(b, y - 1)
                    fraction = fraction * half_corner_weight(c, z - 1)
                    xs[corner] = xs[corner] + weight * v[0] + fraction * u[0]
                    ys[corner] = ys[corner] + weight * v[1] + fraction * u[1]
                    zs[corner] = zs[corner] + weight * v[2] + fraction * u[2]
    for corner in range(BLOCK_SLOTS):
        lowered = vec3(xs[corner], ys[corner], zs[corner])
        if is_beyond(slot_position(BLOCK_SLOTS * i + corner, level), 2 * width) == 1:
            lowered = vec3(0.0, 0.0, 0.0)
        fine[BLOCK_SLOTS * i + corner] = lowered


@kernel
def test_lowered_kernel(field: array(dtype=vec3), level: OctreeLevel, tested: array(dtype=float32)):
    """Add the integral of V from coarser levels, linear between corners, against the corner gradients."""
    i = tid()
    total = eight(0.0)
    width = 1 << level.depth
    base = level.positions[i] * 2
    n = int(4)
    for x in range(n):
        for y in range(n):
            low = vec3(0.0, 0.0, 0.0)
            high = vec3(0.0, 0.0, 0.0)
            for z in range(n):
                slot = slot_beside(level.around, i, x - 1, y - 1, z - 1)
                if slot >= 0:
                    v = field[slot]
                    low = low + tested_along_z(v, z - 1, base[2], width, linear_mass, linear_slope)
                    high = high + tested_along_z(v, z - 2, base[2] + 1, width, linear_mass, linear_slope)
            total = tested_across(total, low, high, x - 1, y - 1, base, width, linear_mass, linear_slope)
    for corner in range(BLOCK_SLOTS):
        if is_beyond(slot_position(BLOCK_SLOTS * i + corner, level), width) == 0:
            tested[BLOCK_SLOTS * i + corner] = tested[BLOCK_SLOTS * i + corner] + total[corner]


def constraints(pyramid: DensityPyramid) -> list[Scalars | None]:
    """Right-hand sides of all levels of a complete pyramid by depth (None for 0), float32 per slot."""
    levels, nodes, cells = pyramid.levels, pyramid.nodes, pyramid.cells
    device, last = levels[1].device, len(levels) - 1
    flux_flags = zeros(last + 1, int32, device)
    fields: list[Any] = [None] * (last + 1)
    tests: list[Any] = [None] * (last + 1)
    for depth in range(last, 0, -1):
        flux = empty(cells[depth].count, vec3, device)
        has_below = int(depth < last)
        beside = [cells[depth + has_below], nodes[depth + has_below]]
        arguments = [cells[depth], nodes[depth], depth, has_below, *beside, pyramid.samples_per_cell, flux, flux_flags]
        launch(sum_flux_kernel, flux.size, arguments)
        fields[depth] = flux
    # on CUDA a field of zeros is faster than a test for zero
    has_flux = np.ones(last + 1, bool) if device.is_cuda else download(flux_flags) != 0
    for depth in range(last, 0, -1):
        level, slots = levels[depth], BLOCK_SLOTS * levels[depth].count
        tests[depth] = zeros(slots, float32, device)
        flux, fields[depth] = fields[depth], zeros(slots, vec3, device)
        if has_flux[depth]:
            arguments = [pyramid.cells_at[depth], cells[depth], flux, level, fields[depth]]
            launch(spread_flux_kernel, level.count, arguments)
            launch(test_field_kernel, level.count, [fields[depth], level, tests[depth]])
        if depth < last:
            launch(restrict_tests_kernel, slots, [level, tests[depth + 1], tests[depth]])
    coarse = zeros(BLOCK_SLOTS * levels[1].count, vec3, device)
    for depth in range(2, last + 1):
        if not has_flux[:depth].any():
            coarse = zeros(BLOCK_SLOTS * levels[depth].count, vec3, device)
            continue
        fine = empty(BLOCK_SLOTS * levels[depth].count, vec3, device)
        launch(
            lower_field_kernel, levels[depth].count, [levels[depth - 1], coarse, fields[depth - 1], levels[depth], fine]
        )
        launch(test_lowered_kernel, levels[depth].count, [fine, levels[depth], tests[depth]])
        coarse = fine
    return tests
