"""The star of a point in the Delaunay triangulation, from the points within a radius of it alone.

A star is the tetrahedra at one point a, kept as the triangles opposite it. It begins as the eight between a and its six
guards, and takes in one point after the other: the triangles whose sphere holds the new one go, and the edges around
the gap are joined to it (Bowyer 1981, Watson 1981, on one star; the dual of clipping a Voronoi cell: Ray et al.,
"Meshless Voronoi on the GPU", 2018). The order of the points changes the work, not the result, since answers are exact.

A tetrahedron of radius R <= alpha has all its corners, and every point that could lie in its sphere, within 2 alpha of
a, and the guards lie farther. So it is in the star of a exactly where it is in the triangulation of all points, and
two points never disagree on a tetrahedron that they share.

Most points near a surface touch no sphere of the star. So the nearest come first, from a list, and a walk through the
tree of boxes takes the rest: it enters a box only where some sphere may reach into it. Boxes and points are held
against eight spheres at once, in float32 with a margin; what they may touch is looked at again in float64.
"""

from ..algebra.plain_min_max import larger, smaller
from ..array_types import Device
from ..arrays.packed_keys import pack_key
from ..lang import array, bit_count, float32, float64, func, int32, int64, sqrt, struct, vec3, vector
from ..memory import empty
from ..search.bucket_walk import BYTE, byte_place
from ..search.point_tree import BUCKET, FAN, LEAF, SIDES, PointTree, measure_boxes, square_distance
from .alpha_predicates import Predicates, offset_of, side_of_sphere, sphere_through

FIRST_TRIANGLES = 8
NUMBERS = 6  # of a triangle: N, D, the bounds of their errors
LANES = 8  # spheres side by side in vector registers
LANE_BITS = 3
MARGIN = 2e-6  # relative: 32 roundings of float32, where ten are made
LARGEST = 1e18  # [m] a sphere beyond is not held against anything in float32: its products are no numbers there
OPEN = 3e38  # the margin of a sphere that may hold any point
eight_counts = vector(8, int32)
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
        xs, ys, zs, margins: float32 [threads, room]: N / D, twice the centre, and how far from the sphere nothing is
            certain, over the distance from a. Zeros behind the last triangle, up to a multiple of LANES.
        edges: int32 [threads, 3 * room]: the edges around a gap; in the end the triangles' classes, and the faces that
            the point hands out.
    """

    corners: array(dtype=int32)
    spheres: array(dtype=float64)
    xs: array(dtype=float32)
    ys: array(dtype=float32)
    zs: array(dtype=float32)
    margins: array(dtype=float32)
    edges: array(dtype=int32)
    room: int

    def __init__(self, device: Device, threads: int, room: int) -> None:
        self.room = room
        self.corners = empty(3 * threads * room, int32, device)
        self.spheres = empty(NUMBERS * threads * room, float64, device)
        self.xs, self.ys, self.zs, self.margins = (empty(threads * room, float32, device) for _ in range(4))
        self.edges = empty(3 * threads * room, int32, device)


@func
def write_triangle(at: int, a: int, b: int, c: int, d: int, stars: Stars, given: Predicates):
    """Put a triangle and its sphere at a place."""
    stars.corners[3 * at] = b
    stars.corners[3 * at + 1] = c
    stars.corners[3 * at + 2] = d
    found = sphere_through(offset_of(b, a, given), offset_of(c, a, given), offset_of(d, a, given))
    for j in range(NUMBERS):
        stars.spheres[at * NUMBERS + j] = found[j]
    share = 1.0 / found[3]
    x = found[0] * share
    y = found[1] * share
    z = found[2] * share
    size = abs(x) + abs(y) + abs(z)
    error = (found[4] + given.guard * found[5]) * share  # no point that is asked about lies beyond the guards
    stars.xs[at] = 0.0
    stars.ys[at] = 0.0
    stars.zs[at] = 0.0
    stars.margins[at] = float(OPEN)
    if found[3] > 0.0 and size < float64(LARGEST) and error < float64(LARGEST):
        stars.xs[at] = float(x)
        stars.ys[at] = float(y)
        stars.zs[at] = float(z)
        stars.margins[at] = float(error + size * float64(MARGIN))


@func
def fill_lanes(first: int, size: int, stars: Stars):
    """Spheres that hold nothing, behind the last up to a multiple of LANES."""
    for j in range(first + size, first + (size + LANES - 1) // LANES * LANES):
        stars.xs[j] = 0.0
        stars.ys[j] = 0.0
        stars.zs[j] = 0.0
        stars.margins[j] = 0.0


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
def exchange_triangles(a: int, b: int, stars: Stars):
    """Exchange the corners of two triangles; the second's sphere takes the place of the first's, which is lost."""
    for j in range(3):
        corner = stars.corners[3 * a + j]
        stars.corners[3 * a + j] = stars.corners[3 * b + j]
        stars.corners[3 * b + j] = corner
    for j in range(NUMBERS):
        stars.spheres[NUMBERS * a + j] = stars.spheres[NUMBERS * b + j]
    stars.xs[a] = stars.xs[b]
    stars.ys[a] = stars.ys[b]
    stars.zs[a] = stars.zs[b]
    stars.margins[a] = stars.margins[b]


@func
def may_touch(p: vec3, first: int, size: int, stars: Stars) -> int:
    """How many spheres may hold a point seen from the star's own; 0 is certain."""
    square = p[0] * p[0] + p[1] * p[1] + p[2] * p[2]
    far = sqrt(square)
    least = square - square * MARGIN
    counts = eight_counts(0)
    for chunk in range((size + LANES - 1) // LANES):
        start = ((first >> LANE_BITS) + chunk) * LANES  # so written, a compiler knows that no lane wraps around
        for j in range(LANES):
            value = p[0] * stars.xs[start + j] + p[1] * stars.ys[start + j] + p[2] * stars.zs[start + j]
            counts[j] = counts[j] + (1 if value + far * stars.margins[start + j] >= least else 0)
    total = 0
    for j in range(LANES):
        total += counts[j]
    return total


@func
def part_touched(a: int, code: int, thread: int, first: int, size: int, stars: Stars, given: Predicates) -> int:
    """Move the triangles whose spheres hold a point behind the others; how many others there are."""
    p = offset_of(code, a, given)
    square = p[0] * p[0] + p[1] * p[1] + p[2] * p[2]
    far = sqrt(square)
    left = size
    j = 0
    while j < left:
        at = (first + j) * NUMBERS
        value = p[0] * stars.spheres[at] + p[1] * stars.spheres[at + 1] + p[2] * stars.spheres[at + 2]
        value = value - square * stars.spheres[at + 3]
        bound = far * (stars.spheres[at + 4] + far * stars.spheres[at + 5])
        if given.sphere_primes == 0:
            bound = 0.0
        inside = 0
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
                exchange_triangles(first + j, first + left, stars)
        else:
            j += 1
    return left


@func
def has_edge(b: int, c: int, first: int, last: int, stars: Stars) -> int:
    """The triangle of first .. last - 1 with the edge from b to c, or -1."""
    found = -1
    j = first
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
    """List the edges of triangles whose other side is not among them, as long as there is room; how many there are."""
    count = 0
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
    after = size
    if left < size:
        at = 3 * thread * stars.room
        count = list_gap_edges(first + left, first + size, at, stars)
        after = left + count
        if after > stars.room:
            after = NO_ROOM
        else:
            for j in range(count):
                b = stars.edges[at + 2 * j]
                c = stars.edges[at + 2 * j + 1]
                write_triangle(first + left + j, a, b, c, code, stars, given)
            fill_lanes(first, after, stars)
    return after


@func
def reaches_box(low: vec3, high: vec3, first: int, size: int, stars: Stars) -> int:
    """How many spheres may hold a point of a box seen from the star's own; 0 is certain.

    What `may_touch` compares is largest where the box comes nearest to the centre.
    """
    x = larger(-low[0], high[0])
    y = larger(-low[1], high[1])
    z = larger(-low[2], high[2])
    far = sqrt(x * x + y * y + z * z)
    counts = eight_counts(0)
    for chunk in range((size + LANES - 1) // LANES):
        start = ((first >> LANE_BITS) + chunk) * LANES  # so written, a compiler knows that no lane wraps around
        for j in range(LANES):
            N = vec3(stars.xs[start + j], stars.ys[start + j], stars.zs[start + j])
            x = larger(low[0], smaller(high[0], N[0] * 0.5))
            y = larger(low[1], smaller(high[1], N[1] * 0.5))
            z = larger(low[2], smaller(high[2], N[2] * 0.5))
            square = x * x + y * y + z * z
            value = x * N[0] + y * N[1] + z * N[2] + far * stars.margins[start + j]
            counts[j] = counts[j] + (1 if value >= square - square * MARGIN else 0)
    total = 0
    for j in range(LANES):
        total += counts[j]
    return total


@func
def children_in_star(
    tree: PointTree, a: vec3, reach: float, first: int, size: int, stars: Stars, level: int, node: int
) -> int:
    """A byte: bit j is set where child j of a node may hold a point within reach that changes the star."""
    record = tree.levels[level] + node
    distances = measure_boxes(tree.boxes, record, a, a)
    found = 0
    children = int(FAN)
    for j in range(children):
        if distances[j] <= reach:
            at = record * SIDES + j
            low = vec3(tree.boxes[at] - a[0], tree.boxes[at + FAN] - a[1], tree.boxes[at + 2 * FAN] - a[2])
            high = vec3(
                tree.boxes[at + 3 * FAN] - a[0], tree.boxes[at + 4 * FAN] - a[1], tree.boxes[at + 5 * FAN] - a[2]
            )
            if reaches_box(low, high, first, size, stars) > 0:
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
    one place where a point is taken in: a compiler that inlines calls would write each out.
    """
    p = tree.points[a]
    first = thread * stars.room
    begin_star(a, first, stars, given)
    size = int(FIRST_TRIANGLES)
    limit = int64(-1)
    low = -1  # the first of a leaf, or -1 for the list
    count = near
    level = tree.root
    node = 0
    pending = int64(0)  # a byte a level above the buckets: the children left to visit
    leaves = 0  # of the bucket
    entering = 1
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
                        if may_touch(tree.points[q] - p, first, size, stars) > 0:
                            size = insert_point(a, q, thread, size, stars, given)
        count = 0
        while count == 0 and level <= tree.root:
            if entering == 1:
                entering = 0
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
