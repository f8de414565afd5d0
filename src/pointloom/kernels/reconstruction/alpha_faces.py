"""Alpha shapes: faces between Delaunay tetrahedra with a circumradius <= alpha and the others.

Each point builds its star of the Delaunay triangulation from its neighbors within 2 alpha (Bowyer 1981, Watson 1981;
dual of Ray et al., "Meshless Voronoi on the GPU", 2018). Exact predicates make all stars consistent and the result
unique. The point with the lowest row emits a face. The faces bound the union of the kept tetrahedra, as in CGAL's
regularized alpha shape and Open3D (Edelsbrunner and Muecke 1994). 8 kB of scratch memory per thread.
"""

from collections.abc import Sequence

from ..algebra.plain_min_max import larger, smaller
from ..array_types import Array1, Cells, Device, Element, Indices, Integers, Mask
from ..arrays.concatenation import concatenate_rows
from ..arrays.packed_keys import BYTE_MASK, pack_bits, pack_key
from ..arrays.prefix_sum import offsets_of, scan_together
from ..arrays.select import positions_of_each, rows_by_offsets
from ..lang import (
    Kernel,
    array,
    atomic_add,
    bit_count,
    compute,
    float32,
    float64,
    func,
    int32,
    int64,
    kernel,
    launch,
    sqrt,
    struct,
    tid,
    uint8,
    vec3,
    vec3i,
    vec4i,
    vector,
)
from ..memory import empty, zeros
from ..search.bucket_walk import byte_shift
from ..search.neighbor_lists import list_neighbors
from ..search.point_tree import BUCKET, FAN, LEAF, SIDES, PointTree, measure_boxes, square_distance
from .alpha_predicates import Predicates, ball, is_within_radius, offset_of, side_of_sphere, sphere_through

FIRST_TRIANGLES = 8
NUMBERS_PER_TRIANGLE = 6  # of a triangle: N, D, the bounds of their errors
SPHERE_LANES = 8  # spheres processed together in vector registers
LANE_BITS = 3
RELATIVE_MARGIN = 2e-6  # relative: 32 roundings of float32, where ten are made
MAX_FLOAT32_DISTANCE = 1e18  # [m] spheres farther away are not tested in float32: their products overflow
OPEN_MARGIN = 3e38  # margin of a sphere that may contain any point
eight_counts = vector(8, int32)
NO_ROOM = -1


@struct
class Stars:
    """Scratch memory, one star per thread: corners and spheres [threads, room], edges [threads, 3 * room]. `xs`, `ys`,
    `zs` are N / D, twice the center. `margins` bound the float32 error over the distance from the star's point. They
    are padded with zeros to a multiple of LANES. `edges` finally stores the classes and the emitted faces."""

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
        self.spheres = empty(NUMBERS_PER_TRIANGLE * threads * room, float64, device)
        self.xs, self.ys, self.zs, self.margins = (empty(threads * room, float32, device) for _ in range(4))
        self.edges = empty(3 * threads * room, int32, device)


@func
def write_triangle(at: int, a: int, b: int, c: int, d: int, stars: Stars, given: Predicates):
    stars.corners[3 * at] = b
    stars.corners[3 * at + 1] = c
    stars.corners[3 * at + 2] = d
    sphere = sphere_through(offset_of(b, a, given), offset_of(c, a, given), offset_of(d, a, given))
    for j in range(NUMBERS_PER_TRIANGLE):
        stars.spheres[at * NUMBERS_PER_TRIANGLE + j] = sphere[j]
    fraction = 1.0 / sphere[3]
    x = sphere[0] * fraction
    y = sphere[1] * fraction
    z = sphere[2] * fraction
    size = abs(x) + abs(y) + abs(z)
    error = (sphere[4] + given.guard * sphere[5]) * fraction  # no tested point is beyond the guards
    stars.xs[at] = 0.0
    stars.ys[at] = 0.0
    stars.zs[at] = 0.0
    stars.margins[at] = float(OPEN_MARGIN)
    if sphere[3] > 0.0 and size < float64(MAX_FLOAT32_DISTANCE) and error < float64(MAX_FLOAT32_DISTANCE):
        stars.xs[at] = float(x)
        stars.ys[at] = float(y)
        stars.zs[at] = float(z)
        stars.margins[at] = float(error + size * float64(RELATIVE_MARGIN))


@func
def fill_lanes(first: int, size: int, stars: Stars):
    """Pad the float32 spheres with empty ones to a multiple of LANES."""
    for j in range(first + size, first + (size + SPHERE_LANES - 1) // SPHERE_LANES * SPHERE_LANES):
        stars.xs[j] = 0.0
        stars.ys[j] = 0.0
        stars.zs[j] = 0.0
        stars.margins[j] = 0.0


@func
def begin_star(a: int, first: int, stars: Stars, given: Predicates):
    n = int(FIRST_TRIANGLES)
    for j in range(n):
        x = given.count + j % 2
        y = given.count + 2 + (j // 2) % 2
        z = given.count + 4 + j // 4
        flipped = (j % 2 + (j // 2) % 2 + j // 4) % 2
        write_triangle(first + j, a, x, z if flipped == 1 else y, y if flipped == 1 else z, stars, given)


@func
def exchange_triangles(a: int, b: int, stars: Stars):
    """Swap the corners of two triangles. The sphere of a is overwritten by that of b."""
    for j in range(3):
        corner = stars.corners[3 * a + j]
        stars.corners[3 * a + j] = stars.corners[3 * b + j]
        stars.corners[3 * b + j] = corner
    for j in range(NUMBERS_PER_TRIANGLE):
        stars.spheres[NUMBERS_PER_TRIANGLE * a + j] = stars.spheres[NUMBERS_PER_TRIANGLE * b + j]
    stars.xs[a] = stars.xs[b]
    stars.ys[a] = stars.ys[b]
    stars.zs[a] = stars.zs[b]
    stars.margins[a] = stars.margins[b]


@func
def may_touch(p: vec3, first: int, size: int, stars: Stars) -> int:
    """Number of spheres that may contain a point relative to the star's own. 0 is certain."""
    square = p[0] * p[0] + p[1] * p[1] + p[2] * p[2]
    far = sqrt(square)
    threshold = square - square * RELATIVE_MARGIN
    counts = eight_counts(0)
    for chunk in range((size + SPHERE_LANES - 1) // SPHERE_LANES):
        start = ((first >> LANE_BITS) + chunk) * SPHERE_LANES  # in this form, a compiler can exclude wrapping of lanes
        for j in range(SPHERE_LANES):
            value = p[0] * stars.xs[start + j] + p[1] * stars.ys[start + j] + p[2] * stars.zs[start + j]
            counts[j] = counts[j] + (1 if value + far * stars.margins[start + j] >= threshold else 0)
    total = 0
    for j in range(SPHERE_LANES):
        total += counts[j]
    return total


@func
def part_touched(a: int, code: int, thread: int, first: int, size: int, stars: Stars, given: Predicates) -> int:
    """Move triangles whose spheres contain a point behind the others. Return the number of the others."""
    p = offset_of(code, a, given)
    square = p[0] * p[0] + p[1] * p[1] + p[2] * p[2]
    far = sqrt(square)
    left = size
    j = 0
    while j < left:
        at = (first + j) * NUMBERS_PER_TRIANGLE
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
def find_star_edge(b: int, c: int, first: int, last: int, stars: Stars) -> int:
    index = -1
    j = first
    while j < last and index < 0:
        x = stars.corners[3 * j]
        y = stars.corners[3 * j + 1]
        z = stars.corners[3 * j + 2]
        if (x == b and y == c) or (y == b and z == c) or (z == b and x == c):
            index = j
        j += 1
    return index


@func
def list_gap_edges(first: int, last: int, edges_at: int, stars: Stars) -> int:
    """List the boundary edges of triangles first .. last - 1, up to the room. Return their number."""
    count = 0
    for j in range(first, last):
        for side in range(3):
            b = stars.corners[3 * j + side]
            c = stars.corners[3 * j + (side + 1) % 3]
            if find_star_edge(c, b, first, last, stars) < 0:
                if count < stars.room:
                    stars.edges[edges_at + 2 * count] = b
                    stars.edges[edges_at + 2 * count + 1] = c
                count += 1
    return count


@func
def insert_point(a: int, code: int, thread: int, size: int, stars: Stars, given: Predicates) -> int:
    """Insert a point into the star. Return its number of triangles, or NO_ROOM."""
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
def may_touch_box(low: vec3, high: vec3, first: int, size: int, stars: Stars) -> int:
    """Number of spheres that may contain a point of a box. 0 is certain."""
    x = larger(-low[0], high[0])
    y = larger(-low[1], high[1])
    z = larger(-low[2], high[2])
    far = sqrt(x * x + y * y + z * z)
    counts = eight_counts(0)
    for chunk in range((size + SPHERE_LANES - 1) // SPHERE_LANES):
        start = ((first >> LANE_BITS) + chunk) * SPHERE_LANES  # in this form, a compiler can exclude wrapping of lanes
        for j in range(SPHERE_LANES):
            N = vec3(stars.xs[start + j], stars.ys[start + j], stars.zs[start + j])
            x = larger(low[0], smaller(high[0], N[0] * 0.5))
            y = larger(low[1], smaller(high[1], N[1] * 0.5))
            z = larger(low[2], smaller(high[2], N[2] * 0.5))
            square = x * x + y * y + z * z
            value = x * N[0] + y * N[1] + z * N[2] + far * stars.margins[start + j]
            counts[j] = counts[j] + (1 if value >= square - square * RELATIVE_MARGIN else 0)
    total = 0
    for j in range(SPHERE_LANES):
        total += counts[j]
    return total


@func
def children_in_star(
    tree: PointTree, a: vec3, max_sqdist: float, first: int, size: int, stars: Stars, level: int, node: int, is_new: int
) -> int:
    """Bit mask of the children of a new node that may contain a point within range that changes the star."""
    mask = 0
    if is_new == 1:
        record = tree.levels[level] + node
        distances = measure_boxes(tree.boxes, record, a, a)
        children = int(FAN)
        for j in range(children):
            if distances[j] <= max_sqdist:
                at = record * SIDES + j
                low = vec3(tree.boxes[at] - a[0], tree.boxes[at + FAN] - a[1], tree.boxes[at + 2 * FAN] - a[2])
                high = vec3(
                    tree.boxes[at + 3 * FAN] - a[0], tree.boxes[at + 4 * FAN] - a[1], tree.boxes[at + 5 * FAN] - a[2]
                )
                if may_touch_box(low, high, first, size, stars) > 0:
                    mask = mask | (1 << j)
    return mask


@func
def offer_point(
    a: int, code: int, offset: vec3, is_new: int, thread: int, size: int, stars: Stars, given: Predicates
) -> int:
    """Insert a new point into the star if it may change it. Return the star's number of triangles, or NO_ROOM."""
    after = size + 0
    if is_new == 1 and code != a and size > 0:
        if may_touch(offset, thread * stars.room, size, stars) > 0:
            after = insert_point(a, code, thread, size, stars, given)
    return after


@func
def grow_star(
    a: int,
    thread: int,
    lists: array(dtype=int32),
    head: int,
    near: int,
    max_sqdist: float,
    tree: PointTree,
    stars: Stars,
    given: Predicates,
) -> int:
    """Build the star of a from its `near` nearest points and a tree traversal. Insertion is inlined once only."""
    p = tree.points[a]
    first = thread * stars.room
    begin_star(a, first, stars, given)
    size = int(FIRST_TRIANGLES)
    limit = int64(-1)
    low = -1  # first of a leaf, or -1 for the list
    count = near
    level = tree.root
    node = 0
    pending = int64(0)  # a byte per level above the buckets: the children left to visit
    leaves = 0  # of the bucket
    entering = 1
    while size > 0 and level <= tree.root:
        for j in range(count):
            q = lists[head + j] if low < 0 else low + j
            point = tree.points[max(q, 0)]
            sqdist = square_distance(p, point)
            key = pack_key(sqdist, q)
            # points of the list have already been inserted
            is_new = 1 if q >= 0 and key > limit and sqdist <= max_sqdist else 0
            limit = key if is_new == 1 and low < 0 else limit
            size = offer_point(a, q, point - p, is_new, thread, size, stars, given)
        count = 0
        while count == 0 and level <= tree.root:
            # one assignment to each variable, outside of branches: each in a branch would occupy a register on CUDA
            inside = children_in_star(tree, p, max_sqdist, first, max(size, 0), stars, level, node, entering)
            above = min(level, 1)
            leaves = leaves | (inside * (1 - above))
            pending = pending | (int64(inside * above) << byte_shift(level))
            left = leaves if above == 0 else int(pending >> byte_shift(level)) & BYTE_MASK
            lowest = left & (-left)
            child = bit_count(lowest - 1)
            found = min(left, 1)
            leaves = leaves ^ (lowest * (1 - above))
            pending = pending ^ (int64(lowest * above) << byte_shift(level))
            low = node * BUCKET + child * LEAF if found > above else low
            count = min(LEAF, tree.count - low) if found > above else 0
            entering = found * above
            node = node * FAN + child if entering == 1 else node // FAN if found == 0 else node
            level += 1 - found - entering
    return size


RESULT_COLUMNS = 5  # of a result: a face's corners and two classes, or a tetrahedron's corners and class


@struct
class EmittedRows:
    """Emitted rows in any order; `starts` and `counts` by owner. `total` includes rows that did not fit."""

    table: array(dtype=int32)
    starts: array(dtype=int32)
    counts: array(dtype=int32)
    total: array(dtype=int32)
    capacity: int

    def __init__(self, device: Device, owners: int, capacity: int, total: Integers) -> None:
        self.device, self.capacity, self.total = device, capacity, total
        self.table = empty(capacity * RESULT_COLUMNS, int32, device)
        self.starts, self.counts = zeros(owners, int32, device), zeros(owners, int32, device)

    def sorted_table(self, total: int) -> Integers:
        table = empty(total * RESULT_COLUMNS, int32, self.device)
        launch(sort_emitted_kernel, self.counts.size, [self, offsets_of(self.counts), table])
        return table


@kernel
def sort_emitted_kernel(emitted: EmittedRows, offsets: array(dtype=int32), table: array(dtype=int32)):
    """Sort the rows of an owner by their second and third number, which are unique."""
    i = tid()
    first = emitted.starts[i]
    last = first + emitted.counts[i]
    for j in range(first, last):
        key = pack_bits(emitted.table[j * RESULT_COLUMNS + 1], emitted.table[j * RESULT_COLUMNS + 2])
        slot = offsets[i]
        for k in range(first, last):
            if pack_bits(emitted.table[k * RESULT_COLUMNS + 1], emitted.table[k * RESULT_COLUMNS + 2]) < key:
                slot += 1
        for column in range(RESULT_COLUMNS):
            table[slot * RESULT_COLUMNS + column] = emitted.table[j * RESULT_COLUMNS + column]


@kernel
def mark_faces_kernel(table: array(dtype=int32), kind: int, mask: array(dtype=uint8)):
    i = tid()
    inside = 0
    if table[i * RESULT_COLUMNS + 3] <= kind and kind < table[i * RESULT_COLUMNS + 4]:
        inside = 1
    mask[i] = uint8(inside)


@kernel
def mark_tetrahedra_kernel(table: array(dtype=int32), kind: int, mask: array(dtype=uint8)):
    i = tid()
    inside = 0
    if table[i * RESULT_COLUMNS + 4] <= kind:
        inside = 1
    mask[i] = uint8(inside)


@kernel
def read_faces_kernel(table: array(dtype=int32), rows: array(dtype=int32), triangles: array(dtype=vec3i)):
    i = tid()
    at = rows[i] * RESULT_COLUMNS
    triangles[i] = vec3i(table[at], table[at + 1], table[at + 2])


@kernel
def read_tetrahedra_kernel(table: array(dtype=int32), rows: array(dtype=int32), corners: array(dtype=vec4i)):
    i = tid()
    at = rows[i] * RESULT_COLUMNS
    corners[i] = vec4i(table[at], table[at + 1], table[at + 2], table[at + 3])


def mark_rows(mark: Kernel, table: Integers, kind: int) -> Mask:
    count = table.size // RESULT_COLUMNS
    return compute(mark, count, [table, kind], uint8, table.device)


def read_rows(read: Kernel, kind_of_row: type[Element], table: Integers, rows: Indices) -> Array1[Element]:
    return compute(read, rows.size, [table, rows], kind_of_row, table.device)


FIRST_NEIGHBORS = 16  # points inserted into a star before the traversal
CPU_POINTS_PER_THREAD = 64  # points per thread on the CPU, which share its scratch memory
STAR_TRIANGLES = 96  # initial triangles per star
SCRATCH_NUMBERS = 2**25  # scratch numbers per launch
FACES_A_POINT = 6  # initial room: a surface has 4 per point, both sides counted
TETRAHEDRA_A_POINT = 8  # a Delaunay triangulation of random points has 6.8
ALPHAS_PER_SYNC = 16  # alphas whose faces are counted in one sync. Each takes a byte per face


@func
def class_of(b: int, c: int, d: int, a: int, at: int, thread: int, stars: Stars, given: Predicates) -> int:
    """Index of the first radius >= the circumradius of a tetrahedron, or the number of radii."""
    sphere = ball(0.0)
    for j in range(6):
        sphere[j] = stars.spheres[NUMBERS_PER_TRIANGLE * at + j]
    kind = 0
    searching = 1
    while searching == 1 and kind < given.radii.shape[0]:
        searching = 1 - is_within_radius(b, c, d, sphere, a, kind, thread, given)
        kind += searching
    return kind


@func
def classify_star(a: int, thread: int, size: int, stars: Stars, given: Predicates):
    for j in range(size):
        at = thread * stars.room + j
        b = stars.corners[3 * at]
        c = stars.corners[3 * at + 1]
        d = stars.corners[3 * at + 2]
        kind = given.radii.shape[0]
        if max(b, max(c, d)) < given.count:
            kind = class_of(b, c, d, a, at, thread, stars, given)
        stars.edges[3 * thread * stars.room + j] = kind


@func
def list_faces(a: int, thread: int, size: int, stars: Stars, given: Predicates) -> int:
    """List the faces that a emits, as triangle and side, behind the classes. Return their number (< 1.5 a triangle)."""
    first = thread * stars.room
    row = given.rows[a]
    count = 0
    for j in range(size):
        kind = stars.edges[3 * first + j]
        if kind < given.radii.shape[0]:
            for side in range(3):
                b = stars.corners[3 * (first + j) + side]
                c = stars.corners[3 * (first + j) + (side + 1) % 3]
                if given.rows[b] > row and given.rows[c] > row:
                    other = find_star_edge(c, b, first, first + size, stars) - first
                    if kind < stars.edges[3 * first + other]:
                        stars.edges[3 * first + stars.room + count] = 3 * j + side
                        count += 1
    return count


@func
def write_faces(
    a: int, thread: int, size: int, count: int, start: int, stars: Stars, given: Predicates, faces: EmittedRows
):
    first = thread * stars.room
    for index in range(min(count, faces.capacity - start)):
        listed = stars.edges[3 * first + stars.room + index]
        j = listed // 3
        b = stars.corners[3 * first + listed]
        c = stars.corners[3 * (first + j) + (listed + 1) % 3]
        at = (start + index) * RESULT_COLUMNS
        faces.table[at] = given.rows[a]
        faces.table[at + 1] = given.rows[c]
        faces.table[at + 2] = given.rows[b]
        faces.table[at + 3] = stars.edges[3 * first + j]
        faces.table[at + 4] = stars.edges[3 * first + find_star_edge(c, b, first, first + size, stars) - first]


@func
def write_tetrahedra(
    a: int, thread: int, size: int, start: int, room: int, stars: Stars, given: Predicates, tetrahedra: EmittedRows
) -> int:
    """Write the tetrahedra that a emits, lowest other row next, up to the room. Return their number."""
    first = thread * stars.room
    row = given.rows[a]
    count = 0
    for j in range(first, first + size):
        kind = stars.edges[3 * first + j - first]
        if kind < given.radii.shape[0]:
            b = given.rows[stars.corners[3 * j]]
            c = given.rows[stars.corners[3 * j + 1]]
            d = given.rows[stars.corners[3 * j + 2]]
            lowest = min(b, min(c, d))
            if lowest > row:
                if count < room:
                    at = (start + count) * RESULT_COLUMNS
                    tetrahedra.table[at] = row
                    tetrahedra.table[at + 1] = lowest
                    tetrahedra.table[at + 2] = c if lowest == b else d if lowest == c else b
                    tetrahedra.table[at + 3] = d if lowest == b else b if lowest == c else c
                    tetrahedra.table[at + 4] = kind
                count += 1
    return count


@kernel(max_registers=128)  # for two blocks per SM
def find_faces_kernel(
    ranks: array(dtype=int32),
    run: int,
    begin: int,
    lists: array(dtype=int32),
    near: int,
    max_sqdist: float,
    tree: PointTree,
    stars: Stars,
    given: Predicates,
    with_tetrahedra: int,
    faces: EmittedRows,
    tetrahedra: EmittedRows,
    crowded: array(dtype=int32),
):
    """Emit faces and optionally tetrahedra of a run of points. The order of rows is a race that sorting removes."""
    i = tid()
    for index in range(i * run, min((i + 1) * run, ranks.shape[0])):
        a = ranks[index]
        size = grow_star(a, i, lists, (a - begin) * near, near, max_sqdist, tree, stars, given)
        if size < 0:
            crowded[index] = 1
        else:
            crowded[index] = 0
            classify_star(a, i, size, stars, given)
            row = given.rows[a]
            count = list_faces(a, i, size, stars, given)
            start = atomic_add(faces.total, 0, count)
            write_faces(a, i, size, count, start, stars, given, faces)
            faces.starts[row] = start
            faces.counts[row] = count
            if with_tetrahedra == 1:
                steps = int(2)
                for step in range(steps):  # count them, take room, write them
                    room = (tetrahedra.capacity - start) * step
                    count = write_tetrahedra(a, i, size, start, room, stars, given, tetrahedra)
                    if step == 0:
                        start = atomic_add(tetrahedra.total, 0, count)
                tetrahedra.starts[row] = start
                tetrahedra.counts[row] = count


def find_alpha_shapes(
    tree: PointTree, rows: Indices, owners: int, alphas: Sequence[float], with_tetrahedra: bool = False
) -> list[tuple[Cells, Array1[vec4i] | None]]:
    """Boundary of each alpha shape (ascending `alphas`, inf allowed) of the distinct points of a tree: (triangles,
    tetrahedra) as rows of the cloud, counter-clockwise from outside, and with a positive determinant, or None."""
    given = Predicates(tree, rows, alphas)  # sync
    room = [FACES_A_POINT * tree.count, TETRAHEDRA_A_POINT * tree.count if with_tetrahedra else 0]
    while True:
        totals, needed = zeros(2, int32, tree.device), [0, 0]
        faces, tetrahedra = (EmittedRows(tree.device, owners, size, totals[k : k + 1]) for k, size in enumerate(room))
        for begin, lists in list_neighbors(tree, FIRST_NEIGHBORS, given.radius):
            needed = search_stars(tree, begin, lists, given, with_tetrahedra, faces, tetrahedra, totals)
        if all(size <= there for size, there in zip(needed, room, strict=True)):
            break
        room = [max(sizes) for sizes in zip(needed, room, strict=True)]
    face_table = faces.sorted_table(needed[0])
    table = tetrahedra.sorted_table(needed[1]) if with_tetrahedra else None
    shapes: list[tuple[Cells, Array1[vec4i] | None]] = []
    for first in range(0, len(alphas), ALPHAS_PER_SYNC):
        kinds = range(first, min(first + ALPHAS_PER_SYNC, len(alphas)))
        marks = [mark_rows(mark_faces_kernel, face_table, kind) for kind in kinds]
        marks += [mark_rows(mark_tetrahedra_kernel, table, kind) for kind in kinds if table is not None]
        listed = positions_of_each(*marks)  # sync
        for k in range(len(kinds)):
            corners = None if table is None else read_rows(read_tetrahedra_kernel, vec4i, table, listed[len(kinds) + k])
            shapes.append((read_rows(read_faces_kernel, vec3i, face_table, listed[k]), corners))
    return shapes


def search_stars(
    tree: PointTree,
    begin: int,
    lists: Integers,
    given: Predicates,
    with_tetrahedra: bool,
    faces: EmittedRows,
    tetrahedra: EmittedRows,
    totals: Integers,
) -> list[int]:
    """Launch the search, and repeat it with more room for stars that overflowed. One sync per launch."""
    device, room, needed = tree.device, STAR_TRIANGLES, [0, 0]
    run = 1 if device.is_cuda else CPU_POINTS_PER_THREAD
    todo = compute(list_ranks_kernel, lists.size // FIRST_NEIGHBORS, [begin], int32, device)
    while todo.size:
        step = max(1, SCRATCH_NUMBERS // (room * NUMBERS_PER_TRIANGLE)) * run
        left = []
        for first in range(0, todo.size, step):
            ranks = todo[first : min(first + step, todo.size)]
            threads = -(-ranks.size // run)
            given.reserve(threads)
            crowded = empty(ranks.size, int32, device)
            stars, reach = Stars(device, threads, room), given.max_sqdist
            search = [ranks, run, begin, lists, FIRST_NEIGHBORS, reach, tree, stars, given]
            launch(find_faces_kernel, threads, [*search, int(with_tetrahedra), faces, tetrahedra, crowded])
            (offsets, (count,)), (_, needed) = scan_together([(crowded, [ranks.size])], totals, largest=1)  # sync
            left.append(rows_by_offsets(ranks, offsets, count))
        todo = concatenate_rows(left)
        room, run = 4 * room, 1
    return needed


@kernel
def list_ranks_kernel(begin: int, ranks: array(dtype=int32)):
    i = tid()
    ranks[i] = begin + i
