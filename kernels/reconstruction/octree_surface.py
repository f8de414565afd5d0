"""The surface where a function on the corners of an adaptive octree passes a level, without cracks.

Vertices lie on the edges of undivided cells (`octree_edges`). Cells with undivided neighbours take their triangles from
the table of marching cubes (`volumes/cube_table.py`), those beside finer cells join contours (`octree_contours`). The
levels are done from coarse to fine, and all orders are those of the slots: the same bits from run to run.

Lorensen and Cline, "Marching cubes", SIGGRAPH 1987.
"""

from collections.abc import Iterable, Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from ..array_types import Array1, Scalars
from ..arrays.prefix_sum import scan_together
from ..lang import array, func, int32, kernel, launch, tid, vec2d, vec3, vec3i
from ..memory import empty
from ..volumes.cube_table import CubeTables, device_tables
from .octree_contours import Contours, draw_contours_kernel, write_loops_kernel
from .octree_edges import LevelSurface, along, edge_vertex, slot_after, write_vertices_kernel
from .octree_levels import SLOTS, OctreeLevel, is_cell, is_divided, neighbor_slot
from .sample_cells import Cube

EDGES = 15  # entries of a case in the table of triangles
MOST = 2**31 - 1  # triangles and vertices


@func
def leaf_case(slot: int, surface: LevelSurface) -> int:
    """The signs at the corners of an undivided cell, a bit each; 0 where there is no such cell."""
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
    """1 for a cell one of whose six neighbours is divided."""
    found = 0
    n = int(3)
    for axis in range(n):
        step = along(axis)
        found = max(found, is_divided(slot_after(slot, step, level), level))
        found = max(found, is_divided(slot_after(slot, -step, level), level))
    return found


@kernel
def count_triangles_kernel(
    surface: LevelSurface, tables: CubeTables, counts: array(dtype=int32), joined: array(dtype=int32)
):
    """Triangles of each cell that takes them from the table; 1 for cells that have to be joined to finer ones."""
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
    """The cells that have to be joined to finer ones."""
    i = tid()
    if ranks[i + 1] > ranks[i]:
        cells[ranks[i]] = i


@func
def cell_edge_vertex(slot: int, edge: int, surface: LevelSurface, below: LevelSurface, tables: CubeTables) -> int:
    """The vertex on an edge of the cell at a slot."""
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
    """The triangles of cells that take them from the table."""
    i = tid()
    count = offsets[i + 1] - offsets[i]
    if count > 0:
        case = leaf_case(i, surface)
        for t in range(count):
            entry = case * EDGES + 3 * t
            a = cell_edge_vertex(i, tables.triangle_edges[entry], surface, below, tables)
            b = cell_edge_vertex(i, tables.triangle_edges[entry + 1], surface, below, tables)
            c = cell_edge_vertex(i, tables.triangle_edges[entry + 2], surface, below, tables)
            triangles[first + offsets[i] + t] = vec3i(a, b, c)


def _part(values: Array1[Any], first: int, end: int) -> Array1[Any]:
    """The elements from one on to another, or none: a slice that is empty may not begin at the end."""
    return values[first:end] if end > first else empty(0, values.dtype, values.device)


class OctreeSurface:
    """The surface on all levels of a tree.

    Args:
        levels: OctreeLevels by depth (None for 0).
        solutions: float32 device arrays by depth, the function at the corners.
        iso: Its value on the surface as (sum, weight).
        cube: The Cube.
        is_linear: Take the function as linear along an edge, else as the cubic with its slopes at the ends.

    Attributes:
        vertices: vec3 [m] [m], relative to the cloud's origin.
        normals: vec3 [m], unit gradients.
        triangles: vec3i [t], counter-clockwise seen from where the function is above its value on the surface.
        places: vec3 [m], the vertices in the cube, 0..1.
        slots: int32 [m], the cell or corner of each vertex on its level.
        ranges: (depth, first, last) of runs of vertices of one level.
    """

    def __init__(
        self, levels: Sequence[Any], solutions: Sequence[Any], iso: Array1[vec2d], cube: Cube, is_linear: bool
    ) -> None:
        self._device, self._tables = levels[1].device, device_tables(levels[1].device)
        self._blocks = np.cumsum([0, *(level.count for level in levels[1:])]).tolist()
        self._find_vertices(levels[1:], solutions[1:], iso)
        self._draw_contours()
        self._write(cube, is_linear)

    def _find_vertices(self, levels: Sequence[OctreeLevel], solutions: Sequence[Scalars], iso: Array1[vec2d]) -> None:
        """The vertices on edges and the triangles from the table, counted; the cells that have to be joined."""
        blocks = self._blocks
        slots = [SLOTS * block for block in blocks]
        vertices, triangles, joined = (empty(n, int32, self._device) for n in (blocks[-1], slots[-1], slots[-1]))
        self._surfaces = []
        for k, (level, values) in enumerate(zip(levels, solutions, strict=True)):
            surface = LevelSurface(level, values, iso, vertices[blocks[k] : blocks[k + 1]])
            self._surfaces.append(surface)
            part = slice(slots[k], slots[k + 1])
            arguments = [surface, self._tables, triangles[part], joined[part]]
            launch(count_triangles_kernel, slots[k + 1] - slots[k], arguments)
        scans = scan_together([(vertices, blocks), (triangles, slots), (joined, slots)])  # sync
        (firsts, self._vertex_ends), (self._triangles, self._triangle_ends), (ranks, self._joined_ends) = scans
        for k, surface in enumerate(self._surfaces):
            surface.firsts = firsts[blocks[k] : blocks[k + 1] + 1]
        self._joined = empty(self._joined_ends[-1], int32, self._device)
        launch(list_joined_kernel, joined.size if self._joined.size else 0, [ranks, self._joined])

    def _draw_contours(self) -> None:
        """The contours of cells beside finer ones, whose triangles and middles are counted."""
        loops, middles = (empty(self._joined.size, int32, self._device) for _ in range(2))
        self._contours = []
        for k, (surface, below) in enumerate(self._pairs()):
            ends = (self._joined_ends[k], self._joined_ends[k + 1])
            contours = Contours(_part(self._joined, *ends), SLOTS * self._blocks[k])
            self._contours.append(contours)
            launch(
                draw_contours_kernel,
                contours.count,
                [surface, below, contours, _part(loops, *ends), _part(middles, *ends)],
            )
        scans = scan_together([(loops, self._joined_ends), (middles, self._joined_ends)])  # sync
        (self._loops, self._loop_ends), (self._middles, self._middle_ends) = scans

    def _pairs(self) -> Iterable[tuple[LevelSurface, LevelSurface]]:
        """Each level's surface and that of the level below it."""
        return zip(self._surfaces, [*self._surfaces[1:], self._surfaces[-1]], strict=True)

    def _write(self, cube: Cube, is_linear: bool) -> None:
        edges, vertex_count = self._vertex_ends[-1], self._vertex_ends[-1] + self._middle_ends[-1]
        triangle_count = self._triangle_ends[-1] + self._loop_ends[-1]
        if triangle_count > MOST:
            raise ValueError(f"{triangle_count} triangles are more than 2^31 - 1; take a smaller depth")
        self.vertices, self.normals, self.places = (empty(vertex_count, vec3, self._device) for _ in range(3))
        self.slots, self.triangles = (
            empty(vertex_count, int32, self._device),
            empty(triangle_count, vec3i, self._device),
        )
        self.ranges = []
        for surface, (first, last) in zip(self._surfaces, pairwise(self._vertex_ends), strict=True):
            self.ranges.append((surface.level.depth, first, last))
            arguments = [surface, cube, int(is_linear), self.vertices, self.normals, self.slots, self.places]
            launch(write_vertices_kernel, surface.level.count, arguments)
        for k, (surface, below) in enumerate(self._pairs()):
            slots, contours = SLOTS * surface.level.count, self._contours[k]
            offsets = self._triangles[SLOTS * self._blocks[k] :][: slots + 1]
            arguments = [surface, below, self._tables, offsets, self._loop_ends[k], self.triangles]
            launch(write_triangles_kernel, slots, arguments)
            ends = (self._joined_ends[k], self._joined_ends[k + 1])
            first = self._triangle_ends[k + 1]
            vertices = [self.slots, self.vertices, self.normals, self.places]
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
