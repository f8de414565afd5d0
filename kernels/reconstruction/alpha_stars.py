"""The star of a point in the Delaunay triangulation, from the points within a radius of it alone.

A star is the tetrahedra at one point a, kept as the triangles opposite it. It begins as the eight between a and its six
guards, and takes in one point after the other: the triangles whose sphere holds the new one go, and the edges around
the gap are joined to it (Bowyer 1981, Watson 1981, on one star; the dual of clipping a Voronoi cell: Ray et al.,
"Meshless Voronoi on the GPU", 2018). The order of the points changes the work, not the result, since answers are exact.

A tetrahedron of radius R <= alpha has all its corners, and every point that could lie in its sphere, within 2 alpha of
a, and the guards lie farther. So it is in the star of a exactly where it is in the triangulation of all points, and
two points never disagree on a tetrahedron that they share.

Most points near a surface touch no sphere of the star. So the nearest come first, from a list, and a walk through the
tree of boxes takes the rest: it enters a box only where some sphere may reach into it.
"""

from ..arrays.packed_keys import pack_key
from ..lang import array, bit_count, float64, func, int32, int64, sqrt, struct, vec3, vec3d
from ..memory import empty
from ..search.bucket_walk import BYTE, byte_place
from ..search.point_tree import BUCKET, FAN, LEAF, SIDES, PointTree, measure_boxes, square_distance
from .alpha_predicates import Predicates, offset_of, side_of_sphere, sphere_through

GUARDS = 6
FIRST_TRIANGLES = 8
NUMBERS = 9  # of a triangle: N, D, the bounds of their errors, the centre
NO_ROOM = -1


@struct
class Stars:
    """Scratch memory: a star a thread.

    Args:
        device: Where.
        threads: How many.
        room: Triangles a star.

    Attributes:
        corners: int32 [threads, room, 3]: codes of points; seen from outside they turn counter-clockwise.
        spheres: float64 [threads, room, NUMBERS].
        edges: int32 [threads, 2 * room]: the edges around a gap; in the end the triangles' classes.
    """

    corners: array(dtype=int32)
    spheres: array(dtype=float64)
    edges: array(dtype=int32)
    room: int

    def __init__(self, device, threads, room):
        self.room = room
        self.corners = empty(3 * threads * room, int32, device)
        self.spheres = empty(NUMBERS * threads * room, float64, device)
        self.edges = empty(2 * threads * room, int32, device)


@func
def write_triangle(at: int, a: int, b: int, c: int, d: int, stars: Stars, given: Predicates):
    """Put a triangle and its sphere at a place."""
    stars.corners[3 * at] = b
    stars.corners[3 * at + 1] = c
    stars.corners[3 * at + 2] = d
    found = sphere_through(offset_of(b, a, given), offset_of(c, a, given), offset_of(d, a, given))
    base = at * NUMBERS
    for j in range(6):
        stars.spheres[base + j] = found[j]
    for j in range(3):
        stars.spheres[base + 6 + j] = found[j] / (found[3] + found[3])


@func
def begin_star(a: int, first: int, stars: Stars, given: Predicates):
    """The tetrahedra between a and its guards."""
    n = int(FIRST_TRIANGLES)
    for j in range(n):
        x = given.count + j % 2
        y = given.count + 2 + (j // 2) % 2
        z = given.count + 4 + j // 4
        turned = (j % 2 + (j // 2) % 2 + j // 4) % 2
        write_triangle(first + j, a, x, z if turned == 1 else y, y if turned == 1 else z, stars, given)


@func
def swap_triangles(a: int, b: int, stars: Stars):
    """Exchange two triangles."""
    for j in range(3):
        corner = stars.corners[3 * a + j]
        stars.corners[3 * a + j] = stars.corners[3 * b + j]
        stars.corners[3 * b + j] = corner
    for j in range(NUMBERS):
        number = stars.spheres[NUMBERS * a + j]
        stars.spheres[NUMBERS * a + j] = stars.spheres[NUMBERS * b + j]
        stars.spheres[NUMBERS * b + j] = number


@func
def part_touched(a: int, code: int, thread: int, first: int, size: int, stars: Stars, given: Predicates) -> int:
    """Move the triangles whose spheres hold a point behind the others; how many others there are."""
    p = offset_of(code, a, given)
    square = p[0] * p[0] + p[1] * p[1] + p[2] * p[2]
    far = sqrt(square)
    left = size + 0
    j = int(0)
    while j < left:
        at = (first + j) * NUMBERS
        value = p[0] * stars.spheres[at] + p[1] * stars.spheres[at + 1] + p[2] * stars.spheres[at + 2]
        value = value - square * stars.spheres[at + 3]
        bound = far * (stars.spheres[at + 4] + far * stars.spheres[at + 5])
        if given.sphere_primes == 0:
            bound = float64(0.0)
        inside = int(0)
        if value > bound:
            inside = 1
        elif not (value < -bound):  # open, or beyond the range of float64
            b = stars.corners[3 * (first + j)]
            c = stars.corners[3 * (first + j) + 1]
            d = stars.corners[3 * (first + j) + 2]
            if side_of_sphere(b, c, d, code, a, thread, given) == 1:
                inside = 1
        if inside == 1:
            left = left - 1
            if j < left:
                swap_triangles(first + j, first + left, stars)
        else:
            j += 1
    return left


@func
def has_edge(b: int, c: int, first: int, last: int, stars: Stars) -> int:
    """The triangle of first .. last - 1 with the edge from b to c, or -1."""
    found = int(-1)
    j = first + 0
    while j < last and found < 0:
        x = stars.corners[3 * j]
        y = stars.corners[3 * j + 1]
        z = stars.corners[3 * j + 2]
        if (x == b and y == c) or (y == b and z == c) or (z == b and x == c):
            found = j
        j += 1
    return found


@func
def list_gap_edges(first: int, last: int, edges_at: int, stars: Stars) -> int:
    """List the edges of triangles whose other side is not among them; how many. The most there is room for: one more."""
    count = int(0)
    for j in range(first, last):
        for side in range(3):
            b = stars.corners[3 * j + side]
            c = stars.corners[3 * j + (side + 1) % 3]
            if has_edge(c, b, first, last, stars) < 0:
                if count < stars.room:
                    stars.edges[edges_at + 2 * count] = b
                    stars.edges[edges_at + 2 * count + 1] = c
                count += 1
    return count


@func
def insert_point(a: int, code: int, thread: int, size: int, stars: Stars, given: Predicates) -> int:
    """Take a point into the star; the number of its triangles, or NO_ROOM."""
    first = thread * stars.room
    left = part_touched(a, code, thread, first, size, stars, given)
    after = size + 0
    if left < size:
        at = 2 * thread * stars.room
        count = list_gap_edges(first + left, first + size, at, stars)
        after = left + count
        if after > stars.room:
            after = NO_ROOM
        else:
            for j in range(count):
                b = stars.edges[at + 2 * j]
                c = stars.edges[at + 2 * j + 1]
                write_triangle(first + left + j, a, b, c, code, stars, given)
    return after


@func
def reaches_box(low: vec3d, high: vec3d, first: int, size: int, stars: Stars) -> int:
    """1 where the sphere of a triangle may hold a point of a box seen from the star's own; errors covered.

    p . N - |p|^2 D is largest where the box comes nearest to the centre.
    """
    x = max(-low[0], high[0])
    y = max(-low[1], high[1])
    z = max(-low[2], high[2])
    far = sqrt(x * x + y * y + z * z)
    found = int(0)
    j = first * NUMBERS
    last = (first + size) * NUMBERS
    while j < last and found == 0:
        x = max(low[0], min(high[0], stars.spheres[j + 6]))
        y = max(low[1], min(high[1], stars.spheres[j + 7]))
        z = max(low[2], min(high[2], stars.spheres[j + 8]))
        D = stars.spheres[j + 3]
        value = x * stars.spheres[j] + y * stars.spheres[j + 1] + z * stars.spheres[j + 2] - (x * x + y * y + z * z) * D
        bound = far * (stars.spheres[j + 4] + far * stars.spheres[j + 5])
        # where rounding took all of D nothing is known of the centre
        if not (value < -bound and D > float64(0.0)):
            found = 1
        j += NUMBERS
    return found


@func
def children_in_star(
    tree: PointTree, a: vec3, reach: float, first: int, size: int, stars: Stars, level: int, node: int
) -> int:
    """A byte: bit j is set where child j of a node may hold a point within reach that changes the star."""
    record = tree.levels[level] + node
    distances = measure_boxes(tree.boxes, record, a, a)
    found = int(0)
    for j in range(FAN):
        if distances[j] <= reach:
            at = record * SIDES + j
            low = vec3d(
                float64(tree.boxes[at]) - float64(a[0]),
                float64(tree.boxes[at + FAN]) - float64(a[1]),
                float64(tree.boxes[at + 2 * FAN]) - float64(a[2]),
            )
            high = vec3d(
                float64(tree.boxes[at + 3 * FAN]) - float64(a[0]),
                float64(tree.boxes[at + 4 * FAN]) - float64(a[1]),
                float64(tree.boxes[at + 5 * FAN]) - float64(a[2]),
            )
            if reaches_box(low, high, first, size, stars) == 1:
                found = found | (1 << j)
    return found


@func
def grow_star(
    a: int,
    thread: int,
    lists: array(dtype=int32),
    head: int,
    near: int,
    reach: float,
    tree: PointTree,
    stars: Stars,
    given: Predicates,
) -> int:
    """The star of the point at place a, from its `near` nearest points in lists[head:] and a walk; its triangles.

    NO_ROOM where it has more of them than a thread holds. The list and each leaf are one batch a turn, so that there is
    one place where a point is taken in: Taichi writes every call out.
    """
    p = tree.points[a]
    first = thread * stars.room
    begin_star(a, first, stars, given)
    size = int(FIRST_TRIANGLES)
    limit = int64(-1)
    low = int(-1)  # the first of a leaf, or -1 for the list
    count = near + 0
    level = tree.root + 0
    node = int(0)
    pending = int64(0)  # a byte a level above the buckets: the children left to visit
    leaves = int(0)  # of the bucket
    entering = int(1)
    while size > 0 and level <= tree.root:
        for j in range(count):
            q = low + j
            if low < 0:
                q = lists[head + j]
            if q >= 0 and size > 0:
                sqdist = square_distance(p, tree.points[q])
                key = pack_key(sqdist, q)
                # the listed ones are in the star already: they have been asked about
                if key > limit and sqdist <= reach:
                    if low < 0:
                        limit = key
                    if q != a:
                        size = insert_point(a, q, thread, size, stars, given)
        count = int(0)
        while count == 0 and level <= tree.root:
            if entering == 1:
                entering = int(0)
                inside = children_in_star(tree, p, reach, first, max(size, 0), stars, level, node)
                if level == 0:
                    leaves = inside
                else:
                    pending = pending | (int64(inside) << byte_place(level))
            left = leaves
            if level > 0:
                left = int(pending >> byte_place(level)) & BYTE
            lowest = left & (-left)
            if left == 0:
                level += 1
                node = node // FAN
            elif level == 0:
                leaves = leaves ^ lowest
                low = node * BUCKET + bit_count(lowest - 1) * LEAF
                count = min(LEAF, tree.count - low)
            else:
                pending = pending ^ (int64(lowest) << byte_place(level))
                node = node * FAN + bit_count(lowest - 1)
                level = level - 1
                entering = 1
    return size
