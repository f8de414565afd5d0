"""The surface where a function on the corners of an adaptive octree passes a level, without cracks.

Vertices lie on the edges of undivided cells (`octree_edges`). Cells with undivided neighbours take their triangles from
the table of marching cubes (`volumes/cube_table.py`), those beside finer cells join contours (`octree_contours`). The
levels are done from coarse to fine, and all orders are those of the slots: the same bits from run to run.

Lorensen and Cline, "Marching cubes", SIGGRAPH 1987.
"""

from collections.abc import Sequence
from typing import Any

from ..arrays.prefix_sum import exclusive_scan
from ..arrays.select import positions_of
from ..lang import array, func, int32, kernel, launch, tid, uint8, vec3, vec3i
from ..memory import empty
from ..volumes.cube_table import CubeTables, device_tables
from .octree_contours import Contours, draw_contours_kernel, write_loops_kernel
from .octree_edges import LevelSurface, along, edge_vertex, slot_after, write_vertices_kernel
from .octree_levels import SLOTS, OctreeLevel, is_cell, is_divided, neighbor_slot
from .sample_cells import Cube

EDGES = 15  # entries of a case in the table of triangles


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
    surface: LevelSurface, tables: CubeTables, counts: array(dtype=int32), joined: array(dtype=uint8)
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
    joined[i] = uint8(beside)


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


class OctreeSurface:
    """The surface on all levels of a tree.

    Args:
        levels: OctreeLevels by depth (None for 0).
        solutions: float32 device arrays by depth, the function at the corners.
        iso: Its value on the surface.
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
        self, levels: Sequence[Any], solutions: Sequence[Any], iso: float, cube: Cube, is_linear: bool
    ) -> None:
        device, last = levels[1].device, len(levels) - 1
        tables = device_tables(device)
        surfaces, vertex_count, self.ranges = [], 0, []
        for depth in range(1, last + 1):
            surface = LevelSurface(levels[depth], solutions[depth], vertex_count, iso)
            surfaces.append(surface)
            self.ranges.append((depth, vertex_count, vertex_count + surface.vertex_count))
            vertex_count += surface.vertex_count
        parts, triangle_count = [], 0
        for surface, below in zip(surfaces, [*surfaces[1:], surfaces[-1]], strict=True):
            slots = SLOTS * surface.level.count
            counts, joined = empty(slots, int32, device), empty(slots, uint8, device)
            launch(count_triangles_kernel, slots, [surface, tables, counts, joined])
            offsets, total = exclusive_scan(counts)  # sync
            contours = Contours(positions_of(joined))  # sync
            loop_counts, middle_counts = (empty(contours.count, int32, device) for _ in range(2))
            launch(draw_contours_kernel, contours.count, [surface, below, contours, loop_counts, middle_counts])
            loops, loop_total = exclusive_scan(loop_counts)  # sync
            middles, middle_total = exclusive_scan(middle_counts)  # sync
            parts.append((offsets, triangle_count, contours, loops, middles, triangle_count + total, vertex_count))
            triangle_count += total + loop_total
            self.ranges.append((surface.level.depth, vertex_count, vertex_count + middle_total))
            vertex_count += middle_total
        self.vertices, self.normals, self.places = (empty(vertex_count, vec3, device) for _ in range(3))
        self.slots, self.triangles = empty(vertex_count, int32, device), empty(triangle_count, vec3i, device)
        for surface in surfaces:
            arguments = [surface, cube, int(is_linear), self.vertices, self.normals, self.slots, self.places]
            launch(write_vertices_kernel, surface.level.count, arguments)
        for k, (offsets, first, contours, loops, middles, first_loop, first_middle) in enumerate(parts):
            surface, below = surfaces[k], surfaces[min(k + 1, last - 1)]
            slots = SLOTS * surface.level.count
            launch(write_triangles_kernel, slots, [surface, below, tables, offsets, first, self.triangles])
            vertices = [self.slots, self.vertices, self.normals, self.places]
            arguments = [contours, loops, middles, first_loop, first_middle, *vertices, self.triangles]
            launch(write_loops_kernel, contours.count, arguments)
