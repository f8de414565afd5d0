"""The surface where a function on the corners of an adaptive octree passes a level, without cracks.

Vertices lie on the edges of undivided cells that cross the level, one for each edge that no cell divides further. The
function is linear along a coarse edge beside finer cells, so it crosses one of the edge's halves where it crosses the
edge. Cells with undivided neighbours take their triangles from the table of marching cubes (`volumes/cube_table.py`).
A cell beside a finer one takes the contour on the shared face from the four finer faces, by the same rule for signs;
its contours close to loops, and a loop of more than three vertices is a fan about a vertex in its middle: no edge of it
lies in a face, so none is shared by more than two triangles.

One thread a slot or block; 1 B a slot, 8 B a block and 400 B a cell beside finer ones. The levels are done from coarse
to fine, and all orders are those of the slots: the same bits from run to run.

Sources: Lorensen and Cline, "Marching cubes", SIGGRAPH 1987; faces of finer cells handed to coarser ones as in Kazhdan,
Klein, Dalal and Hoppe, "Unconstrained isosurface extraction on arbitrary octrees", SGP 2007.
"""

from ..algebra.transform import narrow, widen
from ..arrays.prefix_sum import exclusive_scan
from ..arrays.select import positions_of
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
    uint8,
    vec3,
    vec3d,
    vec3i,
)
from ..memory import empty
from ..volumes.cube_table import CubeTables, device_tables
from .octree_levels import SLOTS, OctreeLevel, is_cell, is_divided, neighbor_slot, slot_place
from .sample_cells import Cube

EDGES = 15  # entries of a case in the table of triangles
SEGMENTS = 48  # of the contours on a cell's faces: two on each of four parts of six faces
HALVINGS = 24  # of an edge, to a float32's precision


@struct
class LevelSurface:
    """A level's part of the surface.

    Attributes:
        level: The OctreeLevel.
        values: float32 [slots], the function at the corners, less the value on the surface.
        crossings: int32 [blocks], bit 3 * corner + axis for the edges that hold a vertex.
        firsts: int32 [blocks + 1], the first vertex of each block.
    """

    level: OctreeLevel
    values: array(dtype=float32)
    crossings: array(dtype=int32)
    firsts: array(dtype=int32)

    def __init__(self, level, values, first, iso):
        device, count = level.device, level.count
        self.level, self.values = level, empty(values.size, float32, device)
        self.crossings = empty(count, int32, device)
        launch(lower_to_surface_kernel, values.size, [values, iso, self.values])
        counts = empty(count, int32, device)
        launch(mark_crossings_kernel, count, [level, self.values, self.crossings, counts])
        self.firsts, self.vertex_count = exclusive_scan(counts)  # sync
        launch(add_first_kernel, count + 1, [self.firsts, first])


@kernel
def lower_to_surface_kernel(values: array(dtype=float32), iso: float, lowered: array(dtype=float32)):
    """The function less its value on the surface."""
    i = tid()
    lowered[i] = values[i] - iso


@kernel
def add_first_kernel(firsts: array(dtype=int32), first: int):
    """Number the vertices behind those of the levels above."""
    i = tid()
    firsts[i] = firsts[i] + first


@func
def along(axis: int) -> vec3i:
    """One step along an axis."""
    step = vec3i(1, 0, 0)
    if axis == 1:
        step = vec3i(0, 1, 0)
    if axis == 2:
        step = vec3i(0, 0, 1)
    return step


@func
def slot_after(slot: int, step: vec3i, level: OctreeLevel) -> int:
    """The slot some steps away."""
    return neighbor_slot(slot, step[0], step[1], step[2], level)


@func
def differ(a: float, b: float) -> int:
    """1 where one of two values is below zero and the other is not."""
    found = int(0)
    if (a < 0.0 and b >= 0.0) or (a >= 0.0 and b < 0.0):
        found = 1
    return found


@func
def holds_vertex(slot: int, axis: int, level: OctreeLevel, values: array(dtype=float32)) -> int:
    """1 for an edge of cells none of which is divided, whose ends lie on different sides."""
    found = int(0)
    end = slot_after(slot, along(axis), level)
    if end >= 0:
        found = differ(values[slot], values[end])
    if found == 1:
        u = along((axis + 1) % 3)
        v = along((axis + 2) % 3)
        cells = int(0)
        n = int(2)
        for i in range(n):
            for j in range(n):
                cell = slot_after(slot, u * (-i) + v * (-j), level)
                cells += is_cell(cell, level)
                if is_divided(cell, level) == 1:
                    found = 0
        if cells == 0:
            found = 0
    return found


@kernel
def mark_crossings_kernel(
    level: OctreeLevel, values: array(dtype=float32), crossings: array(dtype=int32), counts: array(dtype=int32)
):
    """The edges of each block that hold a vertex."""
    i = tid()
    bits = int(0)
    n = int(8)
    m = int(3)
    for corner in range(n):
        for axis in range(m):
            if holds_vertex(SLOTS * i + corner, axis, level, values) == 1:
                bits = bits | (1 << (3 * corner + axis))
    crossings[i] = bits
    counts[i] = bit_count(bits)


@func
def own_vertex(slot: int, axis: int, surface: LevelSurface) -> int:
    """The vertex on an edge of this level, -1 where it holds none."""
    block = slot // SLOTS
    bit = 3 * (slot - SLOTS * block) + axis
    bits = surface.crossings[block]
    vertex = int(-1)
    if ((bits >> bit) & 1) == 1:
        vertex = surface.firsts[block] + bit_count(bits & ((1 << bit) - 1))
    return vertex


@func
def edge_vertex(slot: int, axis: int, surface: LevelSurface, below: LevelSurface) -> int:
    """The vertex on an edge of this level that crosses the surface: its own, or that of one of its halves."""
    vertex = own_vertex(slot, axis, surface)
    if vertex < 0:
        first = SLOTS * surface.level.children[slot]
        vertex = own_vertex(first, axis, below)
        if vertex < 0:
            vertex = own_vertex(first + (1 << axis), axis, below)
    return vertex


@func
def difference_along(slot: int, step: vec3i, level: OctreeLevel, values: array(dtype=float32)) -> float:
    """The derivative at a corner, a cell's width being 1: from both sides where there are both."""
    ahead = slot_after(slot, step, level)
    behind = slot_after(slot, -step, level)
    slope = float(0.0)
    if ahead >= 0 and behind >= 0:
        slope = 0.5 * (values[ahead] - values[behind])
    elif ahead >= 0:
        slope = values[ahead] - values[slot]
    elif behind >= 0:
        slope = values[slot] - values[behind]
    return slope


@func
def gradient_at(slot: int, level: OctreeLevel, values: array(dtype=float32)) -> vec3:
    """The derivatives at a corner along the three axes."""
    x = difference_along(slot, vec3i(1, 0, 0), level, values)
    y = difference_along(slot, vec3i(0, 1, 0), level, values)
    z = difference_along(slot, vec3i(0, 0, 1), level, values)
    return vec3(x, y, z)


@func
def crossing_share(a: float, b: float, slope_a: float, slope_b: float, is_linear: int) -> float:
    """Where between 0 and 1 a function is zero that is a and b there: a line, or a parabola.

    Of the slopes only their ratio counts: scaled, so that their mean is b - a, they make the Hermite cubic a parabola.
    """
    share = a / (a - b)
    if is_linear == 0:
        rise = b - a
        mean = 0.5 * (slope_a + slope_b)
        if mean * rise > 0.0:
            slope = slope_a * (rise / mean)
            low = float(0.0)
            high = float(1.0)
            n = int(HALVINGS)
            for _ in range(n):
                t = 0.5 * (low + high)
                if differ(a + t * (slope + t * (rise - slope)), a) == 1:
                    high = t
                else:
                    low = t
            share = 0.5 * (low + high)
    return share


@kernel
def write_vertices_kernel(
    surface: LevelSurface,
    cube: Cube,
    is_linear: int,
    vertices: array(dtype=vec3),
    normals: array(dtype=vec3),
    slots: array(dtype=int32),
    places: array(dtype=vec3),
):
    """Position, unit normal, slot and place in the cube of the vertices of a block."""
    i = tid()
    bits = surface.crossings[i]
    vertex = surface.firsts[i]
    width = 1.0 / float(1 << surface.level.depth)
    left = bits + 0
    while left != 0:
        bit = bit_count((left & (-left)) - 1)
        left = left & (left - 1)
        slot = SLOTS * i + bit // 3
        step = along(bit % 3)
        end = slot_after(slot, step, surface.level)
        a = surface.values[slot]
        b = surface.values[end]
        start_gradient = gradient_at(slot, surface.level, surface.values)
        end_gradient = gradient_at(end, surface.level, surface.values)
        axis = bit % 3
        t = crossing_share(a, b, start_gradient[axis], end_gradient[axis], is_linear)
        place = slot_place(slot, surface.level)
        x = vec3d(
            float64(place[0]) + float64(t * float(step[0])),
            float64(place[1]) + float64(t * float(step[1])),
            float64(place[2]) + float64(t * float(step[2])),
        )
        x = x * float64(width)
        vertices[vertex] = narrow(cube.corner + x * cube.side)
        gradient = widen(start_gradient * (1.0 - t) + end_gradient * t)
        size = length(gradient)
        if size > float64(0.0):
            gradient = gradient / size
        normals[vertex] = narrow(gradient)
        slots[vertex] = slot
        places[vertex] = narrow(x)
        vertex += 1


@func
def leaf_case(slot: int, surface: LevelSurface) -> int:
    """The signs at the corners of an undivided cell, a bit each; 0 where there is no such cell."""
    case = int(0)
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
    found = int(0)
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
    count = int(0)
    beside = int(0)
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


# ------------------------------------------------------------------------------------------------ beside finer cells


@func
def face_step(k: int, side: int, is_second: int) -> int:
    """0 or 1: where the k-th corner of a face lies along its first or second axis, counter-clockwise from outside."""
    turned = k + 0
    if side == 0:
        turned = (4 - k) % 4
    step = int(0)
    if is_second == 0 and (turned == 1 or turned == 2):
        step = 1
    if is_second == 1 and turned >= 2:
        step = 1
    return step


@struct
class Contours:
    """The contours on the faces of cells beside finer ones.

    Attributes:
        cells: int32 [n], their slots.
        sizes: int32 [n], segments of each.
        froms, tos: int32 [48 n], the vertices that each segment leads from and to; ordered, segments of a loop follow
            each other.
    """

    cells: array(dtype=int32)
    sizes: array(dtype=int32)
    froms: array(dtype=int32)
    tos: array(dtype=int32)

    def __init__(self, cells):
        device, self.cells, self.count = cells.device, cells, cells.size
        self.sizes = empty(cells.size, int32, device)
        self.froms, self.tos = (empty(SEGMENTS * cells.size, int32, device) for _ in range(2))


@func
def face_corner(slot: int, axis: int, side: int, u: int, v: int, is_fine: int, level: OctreeLevel) -> int:
    """The slot of a corner of a cell's face, u and v steps along the face's axes; of the next level where `is_fine`."""
    step = along(axis) * side + along((axis + 1) % 3) * (u >> is_fine) + along((axis + 2) % 3) * (v >> is_fine)
    corner = slot_after(slot, step, level)
    if is_fine == 1:
        halves = ((u & 1) << ((axis + 1) % 3)) + ((v & 1) << ((axis + 2) % 3))
        corner = SLOTS * level.children[corner] + halves
    return corner


@func
def contour_vertex(
    slot: int,
    axis: int,
    side: int,
    k: int,
    u: int,
    v: int,
    is_fine: int,
    surface: LevelSurface,
    below: LevelSurface,
) -> int:
    """The vertex on the edge from the k-th corner to the next of the part of a face that begins at (u, v)."""
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
    vertex = int(-1)
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
    """Add the segments on a face, or the part of it that begins at (u, v); the number of segments then.

    Around the face a run of inside corners is entered through one edge and left through another: that is its segment.
    """
    slot = contours.cells[i]
    inside = int(0)
    n = int(4)
    for k in range(n):
        corner = face_corner(
            slot, axis, side, u + face_step(k, side, 0), v + face_step(k, side, 1), is_fine, surface.level
        )  # fmt: skip
        value = float(0.0)
        if is_fine == 1:
            value = below.values[corner]
        else:
            value = surface.values[corner]
        if value < 0.0:
            inside = inside | (1 << k)
    total = size + 0
    for k in range(n):
        if ((inside >> k) & 1) == 1 and ((inside >> ((k + 3) % 4)) & 1) == 0:
            last = k + 0
            while ((inside >> ((last + 1) % 4)) & 1) == 1:
                last += 1
            at = SEGMENTS * i + total
            contours.froms[at] = contour_vertex(slot, axis, side, k + 3, u, v, is_fine, surface, below)
            contours.tos[at] = contour_vertex(slot, axis, side, last, u, v, is_fine, surface, below)
            total += 1
    return total


@func
def join_segments(i: int, size: int, contours: Contours) -> vec3i:
    """Order a cell's segments so that each loop's follow each other: (triangles, middles of loops, 0)."""
    base = SEGMENTS * i
    triangles = int(0)
    middles = int(0)
    start = int(0)
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
    """The contours on the faces of each cell, in loops."""
    i = tid()
    size = int(0)
    axes = int(3)
    two = int(2)
    for axis in range(axes):
        for side in range(two):
            beside = slot_after(contours.cells[i], along(axis) * (2 * side - 1), surface.level)
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
    places: array(dtype=vec3),
    triangles: array(dtype=vec3i),
):
    """The triangles of each loop, and the vertices in the middle of those of more than three sides."""
    i = tid()
    base = SEGMENTS * i
    triangle = first + offsets[i]
    middle = first_middle + middles[i]
    start = int(0)
    for at in range(contours.sizes[i]):
        if contours.tos[base + at] == contours.froms[base + start]:
            sides = at + 1 - start
            if sides == 3:
                a = contours.froms[base + start]
                b = contours.froms[base + start + 1]
                triangles[triangle] = vec3i(a, b, contours.froms[base + at])
                triangle += 1
            else:
                p = vec3d(float64(0.0), float64(0.0), float64(0.0))
                normal = vec3d(float64(0.0), float64(0.0), float64(0.0))
                place = vec3d(float64(0.0), float64(0.0), float64(0.0))
                for j in range(start, at + 1):
                    vertex = contours.froms[base + j]
                    p = p + widen(vertices[vertex])
                    normal = normal + widen(normals[vertex])
                    place = place + widen(places[vertex])
                    triangles[triangle] = vec3i(vertex, contours.tos[base + j], middle)
                    triangle += 1
                share = float64(1.0) / float64(sides)
                size = length(normal)
                if size > float64(0.0):
                    normal = normal / size
                vertices[middle] = narrow(p * share)
                normals[middle] = narrow(normal)
                places[middle] = narrow(place * share)
                slots[middle] = contours.cells[i]
                middle += 1
            start = at + 1


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

    def __init__(self, levels, solutions, iso, cube, is_linear):
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
