"""Crack-free isosurface of a function on the corners of an adaptive octree. Bitwise reproducible.

Cells with undivided neighbors use marching cubes (Lorensen and Cline, SIGGRAPH 1987). A cell next to finer cells joins
the contours of the finer faces to loops, triangulated as fans around a middle vertex (Kazhdan, Klein, Dalal and Hoppe,
"Unconstrained isosurface extraction on arbitrary octrees", SGP 2007).
"""

from collections.abc import Iterable, Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from ..algebra.transform import narrow, widen
from ..array_types import Array1, Indices, Scalars
from ..arrays.prefix_sum import scan_together
from ..lang import array, float64, func, int32, kernel, launch, length, struct, tid, vec2d, vec3, vec3d, vec3i
from ..memory import empty
from ..volumes.cube_table import MAX_TRIANGLES, CubeTables, device_tables
from .octree_edges import LevelSurface, along, edge_vertex, own_vertex, slot_after, write_vertices_kernel
from .octree_levels import BLOCK_SLOTS, OctreeLevel, is_cell, is_divided, neighbor_slot
from .sample_cells import Cube

MAX_SEGMENTS = 48  # of the contours on a cell's faces: two on each of four parts of six faces


@func
def face_step(k: int, side: int, is_second: int) -> int:
    """Offset (0 or 1) of the k-th corner of a face along one of its axes, counter-clockwise from outside."""
    corner = k
    if side == 0:
        corner = (4 - k) % 4
    step = 0
    if is_second == 0 and (corner == 1 or corner == 2):
        step = 1
    if is_second == 1 and corner >= 2:
        step = 1
    return step


@struct
class Contours:
    """Contours of cells next to finer ones: int32 [48 n] ends of segments by loop. `base`: first slot of the level."""

    cells: array(dtype=int32)
    base: int
    sizes: array(dtype=int32)
    froms: array(dtype=int32)
    tos: array(dtype=int32)

    def __init__(self, cells: Indices, base: int) -> None:
        device, self.cells, self.count, self.base = cells.device, cells, cells.size, base
        self.sizes = empty(cells.size, int32, device)
        self.froms, self.tos = (empty(MAX_SEGMENTS * cells.size, int32, device) for _ in range(2))


@func
def face_corner(slot: int, axis: int, side: int, u: int, v: int, is_fine: int, level: OctreeLevel) -> int:
    step = along(axis) * side + along((axis + 1) % 3) * (u >> is_fine) + along((axis + 2) % 3) * (v >> is_fine)
    corner = slot_after(slot, step, level)
    if is_fine == 1:
        child = ((u & 1) << ((axis + 1) % 3)) + ((v & 1) << ((axis + 2) % 3))
        corner = BLOCK_SLOTS * level.children[corner] + child
    return corner


@func
def contour_vertex(
    slot: int, axis: int, side: int, k: int, u: int, v: int, is_fine: int, surface: LevelSurface, below: LevelSurface
) -> int:
    """Vertex on the edge after the k-th corner of the face part that begins at (u, v)."""
    k0 = k % 4
    k1 = (k + 1) % 4
    u0 = face_step(k0, side, 0)
    v0 = face_step(k0, side, 1)
    u1 = face_step(k1, side, 0)
    edge_axis = (axis + 1) % 3
    if u0 == u1:
        edge_axis = (axis + 2) % 3
    start = face_corner(
        slot, axis, side, u + min(u0, u1), v + min(v0, face_step(k1, side, 1)), is_fine, surface.level
    )  # fmt: skip
    vertex = -1
    if is_fine == 1:
        vertex = own_vertex(start, edge_axis, below)
    else:
        vertex = edge_vertex(start, edge_axis, surface, below)
    return vertex


@func
def draw_contour(
    i: int,
    size: int,
    axis: int,
    side: int,
    u: int,
    v: int,
    is_fine: int,
    surface: LevelSurface,
    below: LevelSurface,
    contours: Contours,
) -> int:
    """Add the segments of a face part and return the new number: one per run of inside corners."""
    slot = contours.cells[i] - contours.base
    inside = 0
    n = int(4)
    for k in range(n):
        corner = face_corner(
            slot, axis, side, u + face_step(k, side, 0), v + face_step(k, side, 1), is_fine, surface.level
        )  # fmt: skip
        value = 0.0
        if is_fine == 1:
            value = below.values[corner]
        else:
            value = surface.values[corner]
        if value < 0.0:
            inside = inside | (1 << k)
    total = size
    for k in range(n):
        if ((inside >> k) & 1) == 1 and ((inside >> ((k + 3) % 4)) & 1) == 0:
            last = k
            while ((inside >> ((last + 1) % 4)) & 1) == 1:
                last += 1
            at = MAX_SEGMENTS * i + total
            contours.froms[at] = contour_vertex(slot, axis, side, k + 3, u, v, is_fine, surface, below)
            contours.tos[at] = contour_vertex(slot, axis, side, last, u, v, is_fine, surface, below)
            total += 1
    return total


@func
def join_segments(i: int, size: int, contours: Contours) -> vec3i:
    """Order the segments of a cell by loop. Return (triangles, middle vertices, 0)."""
    base = MAX_SEGMENTS * i
    triangles = 0
    middles = 0
    start = 0
    for at in range(size):
        if contours.tos[base + at] == contours.froms[base + start]:
            sides = at + 1 - start
            if sides == 3:
                triangles += 1
            else:
                triangles += sides
                middles += 1
            start = at + 1
        else:
            wanted = contours.tos[base + at]
            for other in range(at + 1, size):
                if contours.froms[base + other] == wanted and contours.froms[base + at + 1] != wanted:
                    head = contours.froms[base + at + 1]
                    tail = contours.tos[base + at + 1]
                    contours.froms[base + at + 1] = contours.froms[base + other]
                    contours.tos[base + at + 1] = contours.tos[base + other]
                    contours.froms[base + other] = head
                    contours.tos[base + other] = tail
    return vec3i(triangles, middles, 0)


@kernel
def draw_contours_kernel(
    surface: LevelSurface,
    below: LevelSurface,
    contours: Contours,
    triangle_counts: array(dtype=int32),
    middle_counts: array(dtype=int32),
):
    i = tid()
    size = 0
    axes = int(3)
    two = int(2)
    for axis in range(axes):
        for side in range(two):
            beside = slot_after(contours.cells[i] - contours.base, along(axis) * (2 * side - 1), surface.level)
            if is_divided(beside, surface.level) == 1:
                for u in range(two):
                    for v in range(two):
                        size = draw_contour(i, size, axis, side, u, v, 1, surface, below, contours)
            else:
                size = draw_contour(i, size, axis, side, 0, 0, 0, surface, below, contours)
    contours.sizes[i] = size
    counts = join_segments(i, size, contours)
    triangle_counts[i] = counts[0]
    middle_counts[i] = counts[1]


@kernel
def write_loops_kernel(
    contours: Contours,
    offsets: array(dtype=int32),
    middles: array(dtype=int32),
    first: int,
    first_middle: int,
    slots: array(dtype=int32),
    vertices: array(dtype=vec3),
    normals: array(dtype=vec3),
    cube_positions: array(dtype=vec3),
    triangles: array(dtype=vec3i),
):
    """Write the triangles of each loop and the middle vertices of loops with more than three sides."""
    i = tid()
    base = MAX_SEGMENTS * i
    triangle = first + offsets[i]
    middle = first_middle + middles[i]
    start = 0
    for at in range(contours.sizes[i]):
        if contours.tos[base + at] == contours.froms[base + start]:
            sides = at + 1 - start
            if sides == 3:
                a = contours.froms[base + start]
                b = contours.froms[base + start + 1]
                triangles[triangle] = vec3i(a, b, contours.froms[base + at])
                triangle += 1
            else:
                p = vec3d(0.0, 0.0, 0.0)
                normal = vec3d(0.0, 0.0, 0.0)
                cube_position = vec3d(0.0, 0.0, 0.0)
                for j in range(start, at + 1):
                    vertex = contours.froms[base + j]
                    p = p + widen(vertices[vertex])
                    normal = normal + widen(normals[vertex])
                    cube_position = cube_position + widen(cube_positions[vertex])
                    triangles[triangle] = vec3i(vertex, contours.tos[base + j], middle)
                    triangle += 1
                fraction = 1.0 / float64(sides)
                size = length(normal)
                if size > 0.0:
                    normal = normal / size
                vertices[middle] = narrow(p * fraction)
                normals[middle] = narrow(normal)
                cube_positions[middle] = narrow(cube_position * fraction)
                slots[middle] = contours.cells[i] - contours.base
                middle += 1
            start = at + 1


ENTRIES_PER_CASE = 15  # entries of a case in the triangle table
MAX_COUNT = 2**31 - 1  # triangles and vertices


@func
def leaf_case(slot: int, surface: LevelSurface) -> int:
    """Signs at the corners of an undivided cell as bits, else 0."""
    case = 0
    if is_cell(slot, surface.level) > is_divided(slot, surface.level):
        n = int(8)
        for corner in range(n):
            at = neighbor_slot(slot, corner & 1, (corner >> 1) & 1, (corner >> 2) & 1, surface.level)
            if surface.values[at] < 0.0:
                case = case | (1 << corner)
    return case


@func
def is_beside_divided(slot: int, level: OctreeLevel) -> int:
    flag = 0
    n = int(3)
    for axis in range(n):
        step = along(axis)
        flag = max(flag, is_divided(slot_after(slot, step, level), level))
        flag = max(flag, is_divided(slot_after(slot, -step, level), level))
    return flag


@kernel
def count_triangles_kernel(
    surface: LevelSurface, tables: CubeTables, counts: array(dtype=int32), joined: array(dtype=int32)
):
    """Count the marching cubes triangles and mark cells that join finer ones."""
    i = tid()
    case = leaf_case(i, surface)
    count = 0
    beside = 0
    if case != 0 and case != 255:
        beside = is_beside_divided(i, surface.level)
        if beside == 0:
            count = tables.triangle_count[case]
    counts[i] = count
    joined[i] = beside


@kernel
def list_joined_kernel(ranks: array(dtype=int32), cells: array(dtype=int32)):
    i = tid()
    if ranks[i + 1] > ranks[i]:
        cells[ranks[i]] = i


@func
def cell_edge_vertex(slot: int, edge: int, surface: LevelSurface, below: LevelSurface, tables: CubeTables) -> int:
    corner = tables.edge_corner[edge]
    start = neighbor_slot(slot, corner & 1, (corner >> 1) & 1, (corner >> 2) & 1, surface.level)
    return edge_vertex(start, edge // 4, surface, below)


@kernel
def write_triangles_kernel(
    surface: LevelSurface,
    below: LevelSurface,
    tables: CubeTables,
    offsets: array(dtype=int32),
    first: int,
    triangles: array(dtype=vec3i),
):
    i = tid()
    count = offsets[i + 1] - offsets[i]
    if count > 0:
        case = leaf_case(i, surface)
        for t in range(count):
            entry = case * ENTRIES_PER_CASE + 3 * t
            a = cell_edge_vertex(i, tables.triangle_edges[entry], surface, below, tables)
            b = cell_edge_vertex(i, tables.triangle_edges[entry + 1], surface, below, tables)
            c = cell_edge_vertex(i, tables.triangle_edges[entry + 2], surface, below, tables)
            triangles[first + offsets[i] + t] = vec3i(a, b, c)


def _part(values: Array1[Any], first: int, end: int) -> Array1[Any]:
    """A slice that may be empty: Warp slices may not begin at the end."""
    return values[first:end] if end > first else empty(0, values.dtype, values.device)


class OctreeSurface:
    """Surface on all levels. `iso` is the value on the surface as (sum, weight). Vertices are relative to the cloud's
    origin, triangles counter-clockwise seen from higher values. `cube_positions` are in 0..1, `slots` the
    cell or corner of each vertex, `ranges` runs (depth, first, last). Edges are linear if `is_linear`, else cubic."""

    def __init__(
        self, levels: Sequence[Any], solutions: Sequence[Any], iso: Array1[vec2d], cube: Cube, is_linear: bool
    ) -> None:
        self._device, self._tables = levels[1].device, device_tables(levels[1].device)
        self._blocks = np.cumsum([0, *(level.count for level in levels[1:])]).tolist()
        self._find_vertices(levels[1:], solutions[1:], iso)
        self._draw_contours()
        self._write(cube, is_linear)

    def _find_vertices(self, levels: Sequence[OctreeLevel], solutions: Sequence[Scalars], iso: Array1[vec2d]) -> None:
        """Find edge vertices, count the table's triangles, and list the cells next to finer ones."""
        blocks = self._blocks
        slots = [BLOCK_SLOTS * block for block in blocks]
        vertices, triangles, joined = (empty(n, int32, self._device) for n in (blocks[-1], slots[-1], slots[-1]))
        self._surfaces = []
        for k, (level, values) in enumerate(zip(levels, solutions, strict=True)):
            surface = LevelSurface(level, values, iso, vertices[blocks[k] : blocks[k + 1]])
            self._surfaces.append(surface)
            part = slice(slots[k], slots[k + 1])
            arguments = [surface, self._tables, triangles[part], joined[part]]
            launch(count_triangles_kernel, slots[k + 1] - slots[k], arguments)
        largest = max(3 * BLOCK_SLOTS, MAX_TRIANGLES)  # edges of a block, triangles of a cell
        scans = scan_together([(vertices, blocks), (triangles, slots), (joined, slots)], largest=largest)  # sync
        (firsts, self._vertex_ends), (self._triangles, self._triangle_ends), (ranks, self._joined_ends) = scans
        for k, surface in enumerate(self._surfaces):
            surface.firsts = firsts[blocks[k] : blocks[k + 1] + 1]
        self._joined = empty(self._joined_ends[-1], int32, self._device)
        launch(list_joined_kernel, joined.size if self._joined.size else 0, [ranks, self._joined])

    def _draw_contours(self) -> None:
        loops, middles = (empty(self._joined.size, int32, self._device) for _ in range(2))
        self._contours = []
        for k, (surface, below) in enumerate(self._pairs()):
            ends = (self._joined_ends[k], self._joined_ends[k + 1])
            contours = Contours(_part(self._joined, *ends), BLOCK_SLOTS * self._blocks[k])
            self._contours.append(contours)
            launch(
                draw_contours_kernel,
                contours.count,
                [surface, below, contours, _part(loops, *ends), _part(middles, *ends)],
            )
        scans = scan_together(
            [(loops, self._joined_ends), (middles, self._joined_ends)], largest=MAX_SEGMENTS
        )  # sync, sides
        (self._loops, self._loop_ends), (self._middles, self._middle_ends) = scans

    def _pairs(self) -> Iterable[tuple[LevelSurface, LevelSurface]]:
        return zip(self._surfaces, [*self._surfaces[1:], self._surfaces[-1]], strict=True)

    def _write(self, cube: Cube, is_linear: bool) -> None:
        edges, vertex_count = self._vertex_ends[-1], self._vertex_ends[-1] + self._middle_ends[-1]
        triangle_count = self._triangle_ends[-1] + self._loop_ends[-1]
        if triangle_count > MAX_COUNT:
            raise ValueError(f"{triangle_count} triangles are more than 2^31 - 1; take a smaller depth")
        self.vertices, self.normals, self.cube_positions = (empty(vertex_count, vec3, self._device) for _ in range(3))
        self.slots, self.triangles = (
            empty(vertex_count, int32, self._device),
            empty(triangle_count, vec3i, self._device),
        )
        self.ranges = []
        for surface, (first, last) in zip(self._surfaces, pairwise(self._vertex_ends), strict=True):
            self.ranges.append((surface.level.depth, first, last))
            arguments = [surface, cube, int(is_linear), self.vertices, self.normals, self.slots, self.cube_positions]
            launch(write_vertices_kernel, surface.level.count, arguments)
        for k, (surface, below) in enumerate(self._pairs()):
            slots, contours = BLOCK_SLOTS * surface.level.count, self._contours[k]
            offsets = self._triangles[BLOCK_SLOTS * self._blocks[k] :][: slots + 1]
            arguments = [surface, below, self._tables, offsets, self._loop_ends[k], self.triangles]
            launch(write_triangles_kernel, slots, arguments)
            ends = (self._joined_ends[k], self._joined_ends[k + 1])
            first = self._triangle_ends[k + 1]
            vertices = [self.slots, self.vertices, self.normals, self.cube_positions]
            arguments = [
                contours,
                _part(self._loops, *ends),
                _part(self._middles, *ends),
                first,
                edges,
                *vertices,
                self.triangles,
            ]
            launch(write_loops_kernel, contours.count, arguments)
            middles = (edges + self._middle_ends[k], edges + self._middle_ends[k + 1])
            self.ranges.append((surface.level.depth, *middles))
