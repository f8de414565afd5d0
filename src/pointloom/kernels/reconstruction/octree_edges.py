"""Vertices on edges of undivided octree cells where a function on the corners crosses zero.

One vertex per edge that no cell divides further. The function is linear along a coarse edge next to finer cells, so it
crosses one half of the edge. One thread per block. 12 B per block and 4 B per slot.
"""

from ..algebra.transform import narrow, widen
from ..array_types import Array1, Integers, Scalars
from ..lang import (
    array,
    bit_count,
    float32,
    float64,
    func,
    int32,
    kernel,
    launch,
    length,
    struct,
    tid,
    vec2d,
    vec3,
    vec3d,
    vec3i,
)
from ..memory import empty
from .octree_levels import BLOCK_SLOTS, OctreeLevel, is_cell, is_divided, neighbor_slot, slot_position
from .sample_cells import Cube

EDGE_HALVINGS = 24  # of an edge, to a float32's precision


@struct
class LevelSurface:
    """Part of the surface on one level, with relative `values`. Bits 3 * corner + axis of `crossings` mark edges."""

    level: OctreeLevel
    values: array(dtype=float32)
    crossings: array(dtype=int32)
    firsts: array(dtype=int32)

    def __init__(self, level: OctreeLevel, values: Scalars, iso: Array1[vec2d], counts: Integers) -> None:
        """Find the crossings and write the vertex count of each block to `counts`. `iso` is (sum, weight)."""
        self.level, self.values = level, empty(values.size, float32, level.device)
        self.crossings = empty(level.count, int32, level.device)
        launch(lower_to_surface_kernel, values.size, [values, iso, self.values])
        launch(mark_crossings_kernel, level.count, [level, self.values, self.crossings, counts])


@kernel
def lower_to_surface_kernel(values: array(dtype=float32), iso: array(dtype=vec2d), lowered: array(dtype=float32)):
    i = tid()
    lowered[i] = values[i] - float(iso[0][0] / iso[0][1])


@func
def along(axis: int) -> vec3i:
    step = vec3i(1, 0, 0)
    if axis == 1:
        step = vec3i(0, 1, 0)
    if axis == 2:
        step = vec3i(0, 0, 1)
    return step


@func
def slot_after(slot: int, step: vec3i, level: OctreeLevel) -> int:
    return neighbor_slot(slot, step[0], step[1], step[2], level)


@func
def differ(a: float, b: float) -> int:
    differing = 0
    if (a < 0.0 and b >= 0.0) or (a >= 0.0 and b < 0.0):
        differing = 1
    return differing


@func
def has_vertex(slot: int, axis: int, level: OctreeLevel, values: array(dtype=float32)) -> int:
    """1 for an edge of undivided cells whose ends have different signs."""
    crossing = 0
    end = slot_after(slot, along(axis), level)
    if end >= 0:
        crossing = differ(values[slot], values[end])
    if crossing == 1:
        u = along((axis + 1) % 3)
        v = along((axis + 2) % 3)
        cells = 0
        n = int(2)
        for i in range(n):
            for j in range(n):
                cell = slot_after(slot, u * (-i) + v * (-j), level)
                cells += is_cell(cell, level)
                if is_divided(cell, level) == 1:
                    crossing = 0
        if cells == 0:
            crossing = 0
    return crossing


@kernel
def mark_crossings_kernel(
    level: OctreeLevel, values: array(dtype=float32), crossings: array(dtype=int32), counts: array(dtype=int32)
):
    i = tid()
    bits = 0
    n = int(8)
    m = int(3)
    for corner in range(n):
        for axis in range(m):
            if has_vertex(BLOCK_SLOTS * i + corner, axis, level, values) == 1:
                bits = bits | (1 << (3 * corner + axis))
    crossings[i] = bits
    counts[i] = bit_count(bits)


@func
def own_vertex(slot: int, axis: int, surface: LevelSurface) -> int:
    """Vertex on an edge of this level, or -1."""
    block = slot // BLOCK_SLOTS
    bit = 3 * (slot - BLOCK_SLOTS * block) + axis
    bits = surface.crossings[block]
    vertex = -1
    if ((bits >> bit) & 1) == 1:
        vertex = surface.firsts[block] + bit_count(bits & ((1 << bit) - 1))
    return vertex


@func
def edge_vertex(slot: int, axis: int, surface: LevelSurface, below: LevelSurface) -> int:
    """Vertex on an edge that crosses the surface: its own, or that of one of its halves."""
    vertex = own_vertex(slot, axis, surface)
    if vertex < 0:
        first = BLOCK_SLOTS * surface.level.children[slot]
        vertex = own_vertex(first, axis, below)
        if vertex < 0:
            vertex = own_vertex(first + (1 << axis), axis, below)
    return vertex


@func
def difference_along(slot: int, step: vec3i, level: OctreeLevel, values: array(dtype=float32)) -> float:
    ahead = slot_after(slot, step, level)
    behind = slot_after(slot, -step, level)
    slope = 0.0
    if ahead >= 0 and behind >= 0:
        slope = 0.5 * (values[ahead] - values[behind])
    elif ahead >= 0:
        slope = values[ahead] - values[slot]
    elif behind >= 0:
        slope = values[slot] - values[behind]
    return slope


@func
def gradient_at(slot: int, level: OctreeLevel, values: array(dtype=float32)) -> vec3:
    x = difference_along(slot, vec3i(1, 0, 0), level, values)
    y = difference_along(slot, vec3i(0, 1, 0), level, values)
    z = difference_along(slot, vec3i(0, 0, 1), level, values)
    return vec3(x, y, z)


@func
def crossing_fraction(a: float, b: float, slope_a: float, slope_b: float, is_linear: int) -> float:
    """Zero in 0..1 of a line, or of a parabola: the Hermite cubic with slopes scaled to a mean of b - a."""
    fraction = a / (a - b)
    if is_linear == 0:
        rise = b - a
        mean = 0.5 * (slope_a + slope_b)
        if mean * rise > 0.0:
            slope = slope_a * (rise / mean)
            low = 0.0
            high = 1.0
            n = int(EDGE_HALVINGS)
            for _ in range(n):
                t = 0.5 * (low + high)
                if differ(a + t * (slope + t * (rise - slope)), a) == 1:
                    high = t
                else:
                    low = t
            fraction = 0.5 * (low + high)
    return fraction


@kernel
def write_vertices_kernel(
    surface: LevelSurface,
    cube: Cube,
    is_linear: int,
    vertices: array(dtype=vec3),
    normals: array(dtype=vec3),
    slots: array(dtype=int32),
    cube_positions: array(dtype=vec3),
):
    """Position, unit normal, slot, and cube coordinates of the vertices of a block."""
    i = tid()
    bits = surface.crossings[i]
    vertex = surface.firsts[i]
    width = 1.0 / float(1 << surface.level.depth)
    left = bits
    while left != 0:
        bit = bit_count((left & (-left)) - 1)
        left = left & (left - 1)
        slot = BLOCK_SLOTS * i + bit // 3
        step = along(bit % 3)
        end = slot_after(slot, step, surface.level)
        a = surface.values[slot]
        b = surface.values[end]
        start_gradient = gradient_at(slot, surface.level, surface.values)
        end_gradient = gradient_at(end, surface.level, surface.values)
        axis = bit % 3
        t = crossing_fraction(a, b, start_gradient[axis], end_gradient[axis], is_linear)
        position = slot_position(slot, surface.level)
        x = vec3d(
            float64(position[0]) + float64(t * float(step[0])),
            float64(position[1]) + float64(t * float(step[1])),
            float64(position[2]) + float64(t * float(step[2])),
        )
        x = x * float64(width)
        vertices[vertex] = narrow(cube.corner + x * cube.side)
        gradient = widen(start_gradient * (1.0 - t) + end_gradient * t)
        size = length(gradient)
        if size > 0.0:
            gradient = gradient / size
        normals[vertex] = narrow(gradient)
        slots[vertex] = slot
        cube_positions[vertex] = narrow(x)
        vertex += 1
