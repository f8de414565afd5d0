"""Quadratic B-splines at cells (27 overlap a point) and piecewise linear functions at corners (8 overlap a point).

Both are products over the axes, and both are partitions of unity.
"""

from ..lang import array, float32, func, vec3, vec3i
from .octree_levels import OctreeLevel, neighbor_slot, slot_position


@func
def spline_weight(f: float, k: int) -> float:
    """Spline weight of the adjacent cell k (-1, 0, 1) at a fraction f of a cell."""
    weight = 0.75 - (f - 0.5) * (f - 0.5)
    if k < 0:
        weight = 0.5 * (1.0 - f) * (1.0 - f)
    if k > 0:
        weight = 0.5 * f * f
    return weight


@func
def spline_product(f: vec3, x: int, y: int, z: int) -> float:
    return spline_weight(f[0], x) * spline_weight(f[1], y) * spline_weight(f[2], z)


@func
def corner_weight(f: vec3, corner: int) -> float:
    """Weight of a cell corner (x + 2 y + 4 z) at fractions f."""
    x = f[0] if (corner & 1) == 1 else 1.0 - f[0]
    y = f[1] if (corner & 2) == 2 else 1.0 - f[1]
    z = f[2] if (corner & 4) == 4 else 1.0 - f[2]
    return x * y * z


@func
def fractions_in_cell(x: vec3, slot: int, level: OctreeLevel) -> vec3:
    position = slot_position(slot, level)
    cells = float(1 << level.depth)
    fx = min(max(x[0] * cells - float(position[0]), 0.0), 1.0)
    fy = min(max(x[1] * cells - float(position[1]), 0.0), 1.0)
    fz = min(max(x[2] * cells - float(position[2]), 0.0), 1.0)
    return vec3(fx, fy, fz)


@func
def spline_value(values: array(dtype=float32), slot: int, f: vec3, level: OctreeLevel) -> float:
    """Sum of the splines times their values at fractions f of a cell."""
    total = 0.0
    n = int(3)
    for x in range(n):
        for y in range(n):
            for z in range(n):
                other = neighbor_slot(slot, x - 1, y - 1, z - 1, level)
                if other >= 0:
                    total += spline_product(f, x - 1, y - 1, z - 1) * values[other]
    return total


@func
def mirrored_step(at: int, step: int, width: int) -> int:
    """Step to a cell, or to its mirror image beyond the sides of the cube."""
    other = at + step
    taken = step
    if other < 0:
        taken = -1 - other - at
    if other >= width:
        taken = 2 * width - 1 - other - at
    return taken


@func
def is_beyond(position: vec3i, width: int) -> int:
    return 1 if position[0] > width or position[1] > width or position[2] > width else 0


@func
def corner_value(values: array(dtype=float32), slot: int, f: vec3, level: OctreeLevel) -> float:
    """Trilinear interpolation of the corner values at fractions f of a cell."""
    total = 0.0
    n = int(8)
    for corner in range(n):
        other = neighbor_slot(slot, corner & 1, (corner >> 1) & 1, (corner >> 2) & 1, level)
        if other >= 0:
            total += corner_weight(f, corner) * values[other]
    return total
