"""The surface in cells of an octree that lie beside finer ones: contours on their faces, joined to loops.

On a face that it shares with four finer faces a cell takes their contours, by the same rule for signs, so there is no
crack. A loop of more than three vertices is a fan about a vertex in its middle: no edge of it lies in a face, so none
is shared by more than two triangles. A thread a cell, 400 B of scratch for each.

Faces of finer cells handed to coarser ones: Kazhdan, Klein, Dalal and Hoppe, "Unconstrained isosurface extraction on
arbitrary octrees", SGP 2007.
"""

from ..algebra.transform import narrow, widen
from ..array_types import Indices
from ..lang import array, float64, func, int32, kernel, length, struct, tid, vec3, vec3d, vec3i
from ..memory import empty
from .octree_edges import LevelSurface, along, edge_vertex, own_vertex, slot_after
from .octree_levels import SLOTS, OctreeLevel, is_divided

SEGMENTS = 48  # of the contours on a cell's faces: two on each of four parts of six faces


@func
def face_step(k: int, side: int, is_second: int) -> int:
    """0 or 1: where the k-th corner of a face lies along its first or second axis, counter-clockwise from outside."""
    turned = k
    if side == 0:
        turned = (4 - k) % 4
    step = 0
    if is_second == 0 and (turned == 1 or turned == 2):
        step = 1
    if is_second == 1 and turned >= 2:
        step = 1
    return step


@struct
class Contours:
    """The contours on the faces of cells beside finer ones.

    Attributes:
        cells: int32 [n], their slots, counted through all levels.
        base: The first slot of their level.
        sizes: int32 [n], segments of each.
        froms, tos: int32 [48 n], the vertices that each segment leads from and to; ordered, segments of a loop follow
            each other.
    """

    cells: array(dtype=int32)
    base: int
    sizes: array(dtype=int32)
    froms: array(dtype=int32)
    tos: array(dtype=int32)

    def __init__(self, cells: Indices, base: int) -> None:
        device, self.cells, self.count, self.base = cells.device, cells, cells.size, base
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
    slot: int, axis: int, side: int, k: int, u: int, v: int, is_fine: int, surface: LevelSurface, below: LevelSurface
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
    """Add the segments on a face, or the part of it that begins at (u, v); the number of segments then.

    Around the face a run of inside corners is entered through one edge and left through another: that is its segment.
    """
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
            at = SEGMENTS * i + total
            contours.froms[at] = contour_vertex(slot, axis, side, k + 3, u, v, is_fine, surface, below)
            contours.tos[at] = contour_vertex(slot, axis, side, last, u, v, is_fine, surface, below)
            total += 1
    return total


@func
def join_segments(i: int, size: int, contours: Contours) -> vec3i:
    """Order a cell's segments so that each loop's follow each other: (triangles, middles of loops, 0)."""
    base = SEGMENTS * i
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
    """The contours on the faces of each cell, in loops."""
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
    places: array(dtype=vec3),
    triangles: array(dtype=vec3i),
):
    """The triangles of each loop, and the vertices in the middle of those of more than three sides."""
    i = tid()
    base = SEGMENTS * i
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
                place = vec3d(0.0, 0.0, 0.0)
                for j in range(start, at + 1):
                    vertex = contours.froms[base + j]
                    p = p + widen(vertices[vertex])
                    normal = normal + widen(normals[vertex])
                    place = place + widen(places[vertex])
                    triangles[triangle] = vec3i(vertex, contours.tos[base + j], middle)
                    triangle += 1
                share = 1.0 / float64(sides)
                size = length(normal)
                if size > 0.0:
                    normal = normal / size
                vertices[middle] = narrow(p * share)
                normals[middle] = narrow(normal)
                places[middle] = narrow(place * share)
                slots[middle] = contours.cells[i] - contours.base
                middle += 1
            start = at + 1
