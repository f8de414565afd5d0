"""Generalized winding numbers of closed or open meshes in float64.

Solid angles of near triangles (Van Oosterom and Strackee 1983, eq. 8), dipoles of far nodes (Barill et al., "Fast
winding numbers for soups and clouds", SIGGRAPH 2018, first term of eq. 12). Far is beyond MIN_FAR_RADII node radii.
Error of some thousandths on closed meshes.
"""

from ..algebra.angles import arctangent
from ..algebra.transform import widen
from ..array_types import Doubles, Indices, Points
from ..lang import array, cross, dot, float64, func, int32, isfinite, kernel, launch, length, struct, tid, vec3, vec3d
from ..memory import zeros
from ..search.point_tree import FAN, SIDES
from .triangle_tree import LEAF_SIZE, TriangleTree, leaf_corner

MIN_FAR_RADII = 2.0
FULL_SOLID_ANGLE = 12.566370614359172  # 4 pi
NUMBERS_PER_CHILD = 8  # area vector, area center, weight, radius
NO_RADIUS = -1.0  # of a missing child


@func
def solid_angle(p: vec3d, a: vec3d, b: vec3d, c: vec3d) -> float64:
    """Solid angle of a triangle, positive seen from behind. 0 in its plane."""
    u = a - p
    v = b - p
    w = c - p
    x = length(u)
    y = length(v)
    z = length(w)
    volume = dot(u, cross(v, w))
    rest = x * y * z + dot(u, v) * z + dot(v, w) * x + dot(w, u) * y
    angle = float64(0.0)
    if volume != 0.0:
        angle = 2.0 * arctangent(volume, rest)
    return angle


@kernel
def sum_leaf_moments_kernel(tree: TriangleTree, moments: array(dtype=float64)):
    """Area vector, area-weighted center and area of each leaf's triangles."""
    i = tid()
    vector = vec3d(0.0, 0.0, 0.0)
    middle = vec3d(0.0, 0.0, 0.0)
    area = float64(0.0)
    lanes = int(LEAF_SIZE)
    for lane in range(lanes):
        if i * LEAF_SIZE + lane < tree.count:
            a = widen(leaf_corner(tree.corners, i, lane, 0))
            b = widen(leaf_corner(tree.corners, i, lane, 1))
            c = widen(leaf_corner(tree.corners, i, lane, 2))
            n = cross(b - a, c - a) * 0.5
            size = length(n)
            vector = vector + n
            middle = middle + (a + b + c) * (size / 3.0)
            area += size
    for axis in range(3):
        moments[i * NUMBERS_PER_CHILD + axis] = vector[axis]
        moments[i * NUMBERS_PER_CHILD + 3 + axis] = middle[axis]
    moments[i * NUMBERS_PER_CHILD + 6] = area


@kernel
def sum_node_moments_kernel(below: int, first: int, moments: array(dtype=float64)):
    i = tid()
    for k in range(7):
        total = float64(0.0)
        for j in range(FAN):
            total += moments[((below + i) * FAN + j) * NUMBERS_PER_CHILD + k]
        moments[(first * FAN + i) * NUMBERS_PER_CHILD + k] = total


@kernel
def finish_moments_kernel(tree: TriangleTree, moments: array(dtype=float64)):
    """Area center of a child and the radius of its box about it. NO_RADIUS if missing."""
    i = tid()
    at = (i // FAN) * SIDES + i % FAN
    square_radius = float64(NO_RADIUS)
    middle = vec3d(0.0, 0.0, 0.0)
    if tree.boxes[at] <= tree.boxes[at + 3 * FAN]:
        square = float64(0.0)
        for axis in range(3):
            low = float64(tree.boxes[at + axis * FAN])
            high = float64(tree.boxes[at + (axis + 3) * FAN])
            middle[axis] = (low + high) * 0.5
            if moments[i * NUMBERS_PER_CHILD + 6] > 0.0:
                middle[axis] = moments[i * NUMBERS_PER_CHILD + 3 + axis] / moments[i * NUMBERS_PER_CHILD + 6]
            extent = max(high - middle[axis], middle[axis] - low)
            square += extent * extent
        square_radius = square
    for axis in range(3):
        moments[i * NUMBERS_PER_CHILD + 3 + axis] = middle[axis]
    moments[i * NUMBERS_PER_CHILD + 7] = square_radius


@func
def leaf_winding(p: vec3d, leaf: int, tree: TriangleTree) -> float64:
    total = float64(0.0)
    lanes = int(LEAF_SIZE)
    for lane in range(lanes):
        if leaf * LEAF_SIZE + lane < tree.count:
            a = widen(leaf_corner(tree.corners, leaf, lane, 0))
            b = widen(leaf_corner(tree.corners, leaf, lane, 1))
            c = widen(leaf_corner(tree.corners, leaf, lane, 2))
            total += solid_angle(p, a, b, c)
    return total


@struct
class Dipoles:
    """A TriangleTree with `moments` of its children, float64, NUMBERS_PER_CHILD per child."""

    tree: TriangleTree
    moments: array(dtype=float64)

    def __init__(self, tree: TriangleTree) -> None:
        levels = tree.level_firsts
        records = int(levels[-1])
        self.tree, self.moments = tree, zeros(records * FAN * NUMBERS_PER_CHILD, float64, tree.device)
        launch(sum_leaf_moments_kernel, tree.leaf_count, [tree, self.moments])
        for level in range(1, tree.root + 1):
            below, first = int(levels[level - 1]), int(levels[level])
            launch(sum_node_moments_kernel, first - below, [below, first, self.moments])
        launch(finish_moments_kernel, records * FAN, [tree, self.moments])


@kernel
def add_winding_numbers_kernel(
    queries: array(dtype=vec3), query_order: array(dtype=int32), dipoles: Dipoles, numbers: array(dtype=float64)
):
    i = tid()
    row = query_order[i]
    q = queries[row]
    if not isfinite(q) or dipoles.tree.count == 0:
        return
    p = widen(q)
    total = float64(0.0)
    level = dipoles.tree.root
    child = 0  # index among its siblings
    while child >= 0:
        at = (dipoles.tree.levels[level] * FAN + child) * NUMBERS_PER_CHILD
        square_radius = dipoles.moments[at + 7]
        down = 0
        if square_radius >= 0.0:
            x = dipoles.moments[at + 3] - p[0]
            y = dipoles.moments[at + 4] - p[1]
            z = dipoles.moments[at + 5] - p[2]
            square = x * x + y * y + z * z
            if square > square_radius * float64(MIN_FAR_RADII * MIN_FAR_RADII):
                flux = dipoles.moments[at] * x + dipoles.moments[at + 1] * y + dipoles.moments[at + 2] * z
                total += flux / (square * length(vec3d(x, y, z)))
            elif level == 0:
                total += leaf_winding(p, child, dipoles.tree)
            else:
                down = 1
        if down == 1:
            child = child * FAN
            level -= 1
        else:
            child += 1
            while child % FAN == 0 and level < dipoles.tree.root:
                child = child // FAN
                level += 1
            if level == dipoles.tree.root and child == FAN:
                child = -1
    numbers[row] = numbers[row] + total / float64(FULL_SOLID_ANGLE)


def add_winding_numbers(dipoles: Dipoles, queries: Points, order: Indices, numbers: Doubles) -> None:
    """Add a mesh's winding numbers, float64 (n), at queries vec3 (n) about the mesh's origin."""
    launch(add_winding_numbers_kernel, queries.size, [queries, order, dipoles, numbers])
