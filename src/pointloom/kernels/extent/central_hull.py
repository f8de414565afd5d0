"""Convex hull of a center and the points around it, by insertion of one point after another.

It starts as a tiny tetrahedron about the center. A walk finds the facet that the ray of a point crosses. If the point
is beyond it, triangles at the point replace all facets that it is beyond. The signs of all volumes are certain, or
there is no result. One thread on the host, 0.5 microseconds and 100 B per point if neighbors follow each other. De Berg
et al., "Computational Geometry", 2008, chapter 11. Devillers, Pion and Teillaud, "Walking in a triangulation", IJFCS
2002.
"""

import numpy as np

from ..lang import array, cross, dot, float64, func, int32, kernel, launch, struct, tid, vec3d, vec3i
from ..memory import download, empty, host_view, upload

RELATIVE_ERROR = 1e-14  # of three lengths: the rounding of their volume is less (Shewchuk 1997: 5e-15)
RELATIVE_CORE_SIZE = 1e-10  # size of the tetrahedron, of the distance of the first point
CORE_CORNERS = 4  # of the tetrahedron, which are the first vertices
MAX_STEPS = 10_000  # of a walk
REPLACED_CORNER = -1  # corner of a triangle that was replaced
NOT_DECIDED = -1
NO_TRIANGLE = -1


@struct
class Hull:
    """Triangles, counterclockwise from outside, and their neighbors across the edges from each corner.

    `marks`: an even number for the last point that a triangle was tested with, plus one if the point is not beyond it.
    `spokes`: the new triangle at each vertex of the border of the facets that are replaced. `waiting`: points with an
    uncertain sign. The other arrays are scratch and lists.
    """

    points: array(dtype=vec3d)
    corners: array(dtype=vec3i)
    neighbors: array(dtype=vec3i)
    marks: array(dtype=int32)
    cavity: array(dtype=int32)
    border: array(dtype=vec3i)
    free: array(dtype=int32)
    spokes: array(dtype=int32)
    waiting: array(dtype=int32)
    core: float64

    def __init__(self, points: np.ndarray) -> None:
        slots = 2 * (len(points) + CORE_CORNERS)
        self.points = upload(points, vec3d, "cpu")
        self.corners, self.neighbors, self.border = (empty(slots, vec3i, "cpu") for _ in range(3))
        self.marks, self.cavity, self.free = (empty(slots, int32, "cpu") for _ in range(3))
        self.spokes, self.waiting = (empty(len(points) + CORE_CORNERS, int32, "cpu") for _ in range(2))
        self.core = RELATIVE_CORE_SIZE * float(np.abs(points[0]).max())


@func
def largest_of(v: vec3d) -> float64:
    return max(max(abs(v[0]), abs(v[1])), abs(v[2]))


@func
def vertex_at(v: int, hull: Hull) -> vec3d:
    size = hull.core
    p = vec3d(size, size, size)
    if v >= CORE_CORNERS:
        p = hull.points[v - CORE_CORNERS]
    elif v == 1:
        p = vec3d(size, -size, -size)
    elif v == 2:
        p = vec3d(-size, size, -size)
    elif v == 3:
        p = vec3d(-size, -size, size)
    return p


@func
def is_core(v: int) -> int:
    core = 0
    if v < CORE_CORNERS:
        core = 1
    return core


@func
def facet_side(t: int, q: vec3d, hull: Hull) -> int:
    """1 if a point is beyond a facet, 0 if not, or NOT_DECIDED."""
    c = hull.corners[t]
    # arms from a corner with another one near, so that the bound of the error is small
    first = 0
    if is_core(c[0]) != is_core(c[1]) and is_core(c[1]) == is_core(c[2]):
        first = 1
    p = vertex_at(c[first], hull)
    a = vertex_at(c[(first + 1) % 3], hull) - p
    b = vertex_at(c[(first + 2) % 3], hull) - p
    d = q - p
    height = dot(cross(a, b), d)
    error = float64(RELATIVE_ERROR) * largest_of(a) * largest_of(b) * largest_of(d)
    side = 0
    if height > error:
        side = 1
    elif not height < -error:
        side = NOT_DECIDED
    return side


@func
def walk_to(q: vec3d, start: int, hull: Hull) -> int:
    """The triangle that the ray of a point crosses, or NO_TRIANGLE."""
    t = start
    steps = int(0)
    before = int(NO_TRIANGLE)
    going = int(1)
    while going == 1:
        c = hull.corners[t]
        n = hull.neighbors[t]
        a = vertex_at(c[0], hull)
        b = vertex_at(c[1], hull)
        d = vertex_at(c[2], hull)
        after = int(NO_TRIANGLE)
        if n[0] != before and dot(cross(a, b), q) < 0.0:
            after = n[0]
        elif n[1] != before and dot(cross(b, d), q) < 0.0:
            after = n[1]
        elif n[2] != before and dot(cross(d, a), q) < 0.0:
            after = n[2]
        if after == NO_TRIANGLE:
            going = 0
        else:
            before = t
            t = after
            steps += 1
            if steps > MAX_STEPS:
                t = NO_TRIANGLE
                going = 0
    return t


@func
def side_under(t: int, q: vec3d, hull: Hull) -> int:
    """`facet_side` of a point over a facet, 0 if it is equal to a corner. Below a facet of the core is NOT_DECIDED."""
    side = facet_side(t, q, hull)
    if side != 1:
        c = hull.corners[t]
        for k in range(3):
            if c[k] < CORE_CORNERS:
                side = NOT_DECIDED
        for k in range(3):
            if c[k] >= CORE_CORNERS:
                if largest_of(hull.points[c[k] - CORE_CORNERS] - q) == 0.0:
                    side = 0
    return side


@func
def find_cavity(q: vec3d, mark: int, start: int, hull: Hull) -> int:
    """Number of facets that a point is beyond, connected to one of these, or 0 if a sign is uncertain."""
    count = int(1)
    hull.cavity[0] = start
    hull.marks[start] = mark
    k = int(0)
    while k < count:
        n = hull.neighbors[hull.cavity[k]]
        for e in range(3):
            t = n[e]
            if count > 0 and hull.marks[t] // 2 != mark // 2:
                side = facet_side(t, q, hull)
                hull.marks[t] = mark + 1
                if side == 1:
                    hull.marks[t] = mark
                    hull.cavity[count] = t
                    count += 1
                if side == NOT_DECIDED:
                    count = 0
        k += 1
    return count


@func
def edge_towards(n: vec3i, t: int) -> int:
    """The edge across which neighbor t is."""
    edge = 0
    if n[1] == t:
        edge = 1
    if n[2] == t:
        edge = 2
    return edge


@func
def with_neighbor(n: vec3i, edge: int, t: int) -> vec3i:
    changed = vec3i(t, n[1], n[2])
    if edge == 1:
        changed = vec3i(n[0], t, n[2])
    if edge == 2:
        changed = vec3i(n[0], n[1], t)
    return changed


@func
def fill_cavity(v: int, mark: int, count: int, used: vec3i, hull: Hull) -> vec3i:
    """Replace `count` facets by triangles at vertex v. `used`: (slots, free ones of them, the last triangle)."""
    edges = int(0)
    total = used[0]
    free = used[1]
    for k in range(count):
        t = hull.cavity[k]
        c = hull.corners[t]
        n = hull.neighbors[t]
        for e in range(3):
            if hull.marks[n[e]] != mark:
                hull.border[edges] = vec3i(c[e], c[(e + 1) % 3], 3 * n[e] + edge_towards(hull.neighbors[n[e]], t))
                edges += 1
        hull.corners[t] = vec3i(REPLACED_CORNER, REPLACED_CORNER, REPLACED_CORNER)
        hull.free[free] = t
        free += 1
    for k in range(edges):
        t = total
        if free > 0:
            free -= 1
            t = hull.free[free]
        else:
            total += 1
        edge = hull.border[k]
        outer = edge[2] // 3
        hull.spokes[edge[0]] = t
        hull.corners[t] = vec3i(edge[0], edge[1], v)
        hull.neighbors[t] = vec3i(outer, NO_TRIANGLE, NO_TRIANGLE)
        hull.marks[t] = 0
        hull.neighbors[outer] = with_neighbor(hull.neighbors[outer], edge[2] % 3, t)
    for k in range(edges):
        edge = hull.border[k]
        t = hull.spokes[edge[0]]
        after = hull.spokes[edge[1]]
        hull.neighbors[t] = with_neighbor(hull.neighbors[t], 1, after)
        hull.neighbors[after] = with_neighbor(hull.neighbors[after], 2, t)
    return vec3i(total, free, hull.spokes[hull.border[0][0]])


@func
def insert_point(k: int, mark: int, used: vec3i, hull: Hull) -> vec3i:
    """`used` after insertion of a point, or with NOT_DECIDED slots."""
    q = hull.points[k]
    t = walk_to(q, used[2], hull)
    side = int(NOT_DECIDED)
    if t != NO_TRIANGLE:
        side = side_under(t, q, hull)
    result = used
    if side == 1:
        count = find_cavity(q, mark, t, hull)
        if count > 0:
            result = fill_cavity(k + CORE_CORNERS, mark, count, used, hull)
        else:
            side = NOT_DECIDED
    if side == NOT_DECIDED:
        result = vec3i(NOT_DECIDED, 0, 0)
    return result


@kernel
def build_hull_kernel(hull: Hull, counts: array(dtype=int32)):
    """`counts`: slots of triangles in use, points with uncertain signs also if inserted after all others."""
    i = tid()
    hull.corners[i] = vec3i(0, 1, 2)
    hull.corners[1] = vec3i(0, 2, 3)
    hull.corners[2] = vec3i(0, 3, 1)
    hull.corners[3] = vec3i(1, 3, 2)
    hull.neighbors[0] = vec3i(2, 3, 1)
    hull.neighbors[1] = vec3i(0, 3, 2)
    hull.neighbors[2] = vec3i(1, 3, 0)
    hull.neighbors[3] = vec3i(2, 1, 0)
    for k in range(CORE_CORNERS):
        hull.marks[k] = 0
    used = vec3i(4, 0, 0)
    waiting = int(0)
    count = hull.points.shape[0]
    for k in range(count):
        state = insert_point(k, 2 * k + 2, used, hull)
        if state[0] == NOT_DECIDED:
            hull.waiting[waiting] = k
            waiting += 1
        else:
            used = state
    left = int(0)
    for k in range(waiting):
        state = insert_point(hull.waiting[k], 2 * (count + k) + 2, used, hull)
        if state[0] == NOT_DECIDED:
            left += 1
        else:
            used = state
    counts[0] = used[0]
    counts[1] = left


def find_central_hull(points: np.ndarray) -> np.ndarray | None:
    """Triangles int32 (t, 3) of the hull of the origin and points other than it (n, 3), counterclockwise from outside.
    Negative corners are the origin. None if a sign is uncertain."""
    if not len(points):
        return None
    hull = Hull(points)
    counts = empty(2, int32, hull.points.device)
    launch(build_hull_kernel, 1, [hull, counts])
    used, uncertain = download(counts).tolist()
    if uncertain:
        return None
    triangles = host_view(hull.corners)[:used] - CORE_CORNERS
    return triangles[triangles[:, 0] != REPLACED_CORNER - CORE_CORNERS]
