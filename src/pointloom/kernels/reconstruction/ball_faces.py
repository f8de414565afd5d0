"""All triangles on which an empty ball of one radius rests, on the side of their normals.

Bernardini et al., "The ball-pivoting algorithm for surface reconstruction", IEEE TVCG 1999. A triangle is found once,
at its first corner in tree order. Directions in which a ball may be (ball_directions.py) select the neighbors that may
be its other corners. Of up to FEW_CORNERS, all pairs are tested. Of more, for each neighbor b, the centers of balls on
both points form a circle. Every other one removes an arc of it, and those that touch an end of a remaining arc are
tested exactly. Arcs are kept too long rather than too short. At most about k^2 / 2 steps for k neighbors. 56 B of
scratch memory per neighbor and 640 B per point, on CUDA 84 B and 5 KB.

The exact test uses float64 relative to the first corner. With edges B and C, N = B x C and a fourth point D, the center
is

    x = (K + s N sqrt(R)) / (2 |N|^2),  K = |C|^2 (N x B) + |B|^2 (C x N),  R = 4 r^2 |N|^2 - |B|^2 |C|^2 |B - C|^2,

and D is inside if |D|^2 |N|^2 - D.K - s (D.N) sqrt(R) < 0. Values within rounding are ties: points with lower indices
count as larger balls (Edelsbrunner and Muecke, "Simulation of simplicity", ACM TOG 1990).
"""

import numpy as np

from ..algebra.transform import widen
from ..array_types import Bytes, Device, Integers, Scalars, Triangles, Vectors
from ..arrays.concatenation import concatenate_rows
from ..arrays.packed_keys import key_index, key_number, pack_key
from ..arrays.prefix_sum import scan_together
from ..arrays.select import rows_by_offsets
from ..lang import (
    WARP,
    array,
    atomic_add,
    atomic_max,
    cross,
    cuda_func,
    dot,
    float32,
    float64,
    func,
    int32,
    int64,
    kernel,
    launch,
    sqrt,
    struct,
    sync_lanes,
    tid,
    uint8,
    vec2i,
    vec3,
    vec3d,
    vec3i,
)
from ..memory import empty, fill
from ..search.bucket_walk import points_within
from ..search.neighbor_keys import keep_nearest
from ..search.point_tree import BUCKET, PointTree
from .ball_arcs import FULL_CIRCLE, MAX_ARCS, across, arc_sag, forbid_arc, passes_arc, point_at
from .ball_directions import (
    ALL_CELLS,
    CONE_COSINE,
    CONE_SINE,
    MIN_SQUARE,
    NEAR_FRACTION,
    any_cell,
    cap_limit,
    cover_cells,
    eight_cells,
    touches_cells,
)
from .ball_predicates import ball_center, contains_point, root_of_ball, side_of_normals, width_of_circle

# of the lengths: five times the effect of ARC_ROUNDING, so that points touching an arc's end are found
TOUCHING_DISTANCE = 2.0e-8
FIRST_ROOM, CPU_ROOM = 96, 384  # initial neighbors per thread in scratch memory
FIRST_SLOTS = 8  # triangles per point, which is the first corner of about two
SCRATCH_NEIGHBORS, CUDA_SCRATCH = 2**24, 2**23  # neighbors of all points of a launch
CUDA_LANES = 8  # of a point on CUDA
POINTS_PER_LAUNCH = 2**18  # points a launch
CPU_THREADS = 512  # per launch: few, so that scratch memory stays in the caches, but more than the chunks
CUTTING_POINTS = 5  # points that cut a circle before testing which others reach the rest
FEW_CORNERS = 40  # possible corners up to which all pairs are tested
SQDIST_MARGIN = 1.00001  # times the squared search radius: float32 distances must not lose a neighbor


@struct
class BallScratch:
    """Scratch memory: `room` neighbors, first possible corners by distance with coordinates. Arcs of the current
    circle, whose ends only `cutters` can touch. On CUDA also open `cells`, and `tallies` of possible corners and others
    for each point, from the point `first` on."""

    room: int
    run: int
    first: int
    keys: array(dtype=int64)
    indices: array(dtype=int32)
    xs: array(dtype=float64)
    ys: array(dtype=float64)
    zs: array(dtype=float64)
    sizes: array(dtype=float64)
    cells: array(dtype=eight_cells)
    tallies: array(dtype=int32)
    cutters: array(dtype=int32)
    cuts: array(dtype=int32)
    arcs: array(dtype=float64)
    ends: array(dtype=vec3d)
    sags: array(dtype=float64)

    def __init__(self, count: int, room: int, device: Device) -> None:
        max_threads = (
            max(1, CUDA_SCRATCH // room) if device.is_cuda else min(CPU_THREADS, max(1, SCRATCH_NEIGHBORS // room))
        )
        self.threads, self.room, self.first = min(count, max_threads), room, 0
        self.run = -(-count // self.threads)
        self.threads = -(-count // self.run)
        total, circles = self.threads * room, self.threads * (CUDA_LANES if device.is_cuda else 1)
        self.keys, self.indices = empty(2 * total, int64, device), empty(total, int32, device)
        self.xs, self.ys, self.zs, self.sizes = (empty(total, float64, device) for _ in range(4))
        points = self.threads if device.is_cuda else 0
        self.cells, self.tallies = empty(points, eight_cells, device), empty(2 * points, int32, device)
        self.cutters, self.cuts = empty(circles * room, int32, device), empty(circles, int32, device)
        self.arcs = empty(circles * 2 * MAX_ARCS, float64, device)
        self.ends = empty(circles * 2 * MAX_ARCS, vec3d, device)
        self.sags = empty(circles * 2 * MAX_ARCS, float64, device)


@struct
class BallPoints:
    """Points that balls roll over. `searched` marks points to search within the squared radius `max_sqdist` [m^2]."""

    tree: PointTree
    normals: array(dtype=vec3)
    searched: array(dtype=uint8)
    radius: float64
    max_sqdist: float

    def __init__(self, tree: PointTree, normals: Vectors, searched: Bytes, radius: float) -> None:
        self.tree, self.normals, self.searched, self.radius = tree, normals, searched, float(radius)
        self.max_sqdist = float(min(np.float64(SQDIST_MARGIN) * (2 * self.radius) ** 2, np.finfo(np.float32).max))


@struct
class BallFaces:
    """Triangles of the points `indices`, up to `slots` each. A point with a larger number in `neighbor_counts` than the
    scratch memory's room was not searched. `widths` are the squared radii of the circles as fractions of the ball's.
    `owners`: on CUDA the second corner's number."""

    indices: array(dtype=int32)
    slots: int
    neighbor_counts: array(dtype=int32)
    counts: array(dtype=int32)
    corners: array(dtype=vec3i)
    widths: array(dtype=float32)
    owners: array(dtype=int32)

    def __init__(self, indices: Integers, slots: int) -> None:
        device, count = indices.device, indices.size
        self.owners = empty(count * slots if device.is_cuda else 0, int32, device)
        self.indices, self.slots = indices, slots
        self.neighbor_counts, self.counts = empty(count, int32, device), empty(count, int32, device)
        self.corners, self.widths = empty(count * slots, vec3i, device), empty(count * slots, float32, device)


@func
def neighbor_at(scratch: BallScratch, j: int) -> vec3d:
    return vec3d(scratch.xs[j], scratch.ys[j], scratch.zs[j])


@func
def list_neighbors(index: int, points: BallPoints, scratch: BallScratch, base: int) -> tuple[int, eight_cells]:
    """List up to `room` neighbors of a point. Return their number, or 0 if no ball is empty, and the open cells."""
    p = points.tree.points[index]
    diameter = float(points.radius * 2.0)
    near = points.max_sqdist * NEAR_FRACTION
    cells = eight_cells(ALL_CELLS)
    halves = ALL_CELLS + 0
    neighbor_count = 0
    max_sqdist = points.max_sqdist + 0.0
    for j, sqdist in points_within(index // BUCKET, p, max_sqdist, points.tree):
        if j != index:
            if neighbor_count < scratch.room:
                scratch.keys[2 * base + neighbor_count] = pack_key(sqdist, j)
            neighbor_count += 1
            if sqdist <= near and sqdist > MIN_SQUARE:
                limit = cap_limit(sqdist, diameter, CONE_COSINE, CONE_SINE)
                cells = cover_cells(cells, halves, points.tree.points[j] - p, limit)
                halves = any_cell(cells)
                if halves == 0:
                    max_sqdist = -1.0
    if halves == 0:
        neighbor_count = 0
    return neighbor_count, cells


@func
def may_be_corner(key: int64, p: vec3, cells: eight_cells, halves: int, points: BallPoints) -> int:
    """0 if a neighbor is certainly no corner of a triangle of p. `halves`: the result of `any_cell`."""
    sqdist = key_number(key)
    limit = cap_limit(sqdist, float(points.radius * 2.0), CONE_COSINE, -CONE_SINE)
    touched = touches_cells(cells, halves, points.tree.points[key_index(key)] - p, limit)
    return 1 if sqdist <= MIN_SQUARE or touched != 0 else 0


@func
def store_corner(key: int64, at: int, p: vec3, points: BallPoints, scratch: BallScratch):
    other = key_index(key)
    d = widen(points.tree.points[other]) - widen(p)
    scratch.indices[at] = other
    scratch.xs[at] = d[0]
    scratch.ys[at] = d[1]
    scratch.zs[at] = d[2]
    scratch.sizes[at] = sqrt(dot(d, d))


@func
def gather_neighbors(index: int, points: BallPoints, scratch: BallScratch, base: int) -> vec2i:
    """List up to `room` neighbors of a point, first those that may be corners of its triangles, by distance. Return
    their numbers: of all, or 0 if no ball is empty, and of the first."""
    p = points.tree.points[index]
    neighbor_count, cells = list_neighbors(index, points, scratch, base)
    halves = any_cell(cells)
    corner_count = 0
    if neighbor_count <= scratch.room:
        for j in range(neighbor_count):
            key = scratch.keys[2 * base + j]
            if may_be_corner(key, p, cells, halves, points) == 1:
                scratch.keys[2 * base + j] = scratch.keys[2 * base + corner_count]
                scratch.keys[2 * base + corner_count] = key
                corner_count += 1
        corner_count = keep_nearest(scratch.keys, 2 * base, 1, corner_count, corner_count, scratch.room)
        for j in range(corner_count):
            store_corner(scratch.keys[2 * base + j], base + j, p, points, scratch)
    return vec2i(neighbor_count, corner_count)


@func
def first_other(base: int, counts: vec2i, scratch: BallScratch) -> int:
    """Position of the first key of a neighbor that is no possible corner."""
    return 2 * base + counts[1]


@first_other.on_cuda
def first_other_of_lanes(base: int, counts: vec2i, scratch: BallScratch) -> int:
    return 2 * (base + scratch.room) - (counts[0] - counts[1])


@func
def is_outside(
    index: int,
    jb: int,
    jc: int,
    other: int,
    q: vec3d,
    size: float64,
    x: vec3d,
    root: float64,
    side: int,
    points: BallPoints,
    scratch: BallScratch,
) -> int:
    """1 if a neighbor is not in the ball on a point and two of its neighbors, with the given center."""
    outside = 1
    clearance = size * size - 2.0 * dot(x, q)
    slack = float64(TOUCHING_DISTANCE) * points.radius * size
    if clearance < -slack:
        outside = 0
    elif clearance <= slack:
        b = neighbor_at(scratch, jb)
        c = neighbor_at(scratch, jc)
        ia = points.tree.order[index]
        ib = points.tree.order[scratch.indices[jb]]
        ic = points.tree.order[scratch.indices[jc]]
        at = points.tree.order[other]
        if contains_point(b, c, q, root, side, points.radius, ia, ib, ic, at) == 1:
            outside = 0
    return outside


@func
def is_empty_ball(
    index: int,
    jb: int,
    jc: int,
    root: float64,
    side: int,
    points: BallPoints,
    scratch: BallScratch,
    base: int,
    counts: vec2i,
) -> int:
    """1 if no neighbor is in the ball on a point and two of its neighbors."""
    x = ball_center(neighbor_at(scratch, jb), neighbor_at(scratch, jc), root, side)
    empty = 1
    j = base
    while j < base + counts[1] and empty == 1:
        if j != jb and j != jc:
            q = neighbor_at(scratch, j)
            empty = is_outside(index, jb, jc, scratch.indices[j], q, scratch.sizes[j], x, root, side, points, scratch)
        j += 1
    p = widen(points.tree.points[index])
    j = first_other(base, counts, scratch)
    last = j + counts[0] - counts[1]
    while j < last and empty == 1:
        other = key_index(scratch.keys[j])
        q = widen(points.tree.points[other]) - p
        empty = is_outside(index, jb, jc, other, q, sqrt(dot(q, q)), x, root, side, points, scratch)
        j += 1
    return empty


@func
def write_ends(b: vec3d, u: vec3d, v: vec3d, height: float64, count: int, scratch: BallScratch, at: int):
    middle = b * 0.5
    slack = float64(TOUCHING_DISTANCE) * (height + sqrt(dot(b, b)))  # more than TOUCHING_DISTANCE of the radius
    for k in range(count):
        low = scratch.arcs[at + 2 * k]
        high = scratch.arcs[at + 2 * k + 1]
        first = middle + point_at(low, u, v) * height
        last = middle + point_at(high, u, v) * height
        scratch.ends[at + 2 * k] = first
        scratch.ends[at + 2 * k + 1] = last
        scratch.sags[at + k] = arc_sag(first, last, low, high, height, slack)


@func
def touches_arcs(q: vec3d, size: float64, count: int, scratch: BallScratch, at: int) -> int:
    touches = 0
    for k in range(count):
        if passes_arc(q, size, scratch.ends[at + 2 * k], scratch.ends[at + 2 * k + 1], scratch.sags[at + k]) == 0:
            touches = 1
    return touches


@func
def free_arcs(
    jb: int, u: vec3d, v: vec3d, height: float64, scratch: BallScratch, base: int, corner_count: int, circle: int
) -> int:
    """Number of remaining arcs of the circle of centers over two points. Neighbors between both go first."""
    at = circle * 2 * MAX_ARCS
    cutters = circle * scratch.room
    b = neighbor_at(scratch, jb)
    length = scratch.sizes[jb]
    count = 1
    cuts = 0
    scratch.arcs[at] = 0.0
    scratch.arcs[at + 1] = float64(FULL_CIRCLE)
    j = base
    while j < jb and count > 0:
        q = neighbor_at(scratch, j)
        if dot(q, q - b) < 0.0:
            count = forbid_arc(scratch.arcs, at, count, q, scratch.sizes[j], b, length, u, v, height)
            scratch.cutters[cutters + cuts] = j
            cuts += 1
        j += 1
    early = cuts + CUTTING_POINTS
    j = base
    known = 0
    while j < base + corner_count and count > 0:
        q = neighbor_at(scratch, j)
        cut = 0
        if j > jb or (j < jb and dot(q, q - b) >= 0.0):
            cut = 1
            if cuts >= early:
                if known == 0:
                    write_ends(b, u, v, height, count, scratch, at)
                    known = count
                cut = touches_arcs(q, scratch.sizes[j], known, scratch, at)
        if cut == 1:
            count = forbid_arc(scratch.arcs, at, count, q, scratch.sizes[j], b, length, u, v, height)
            scratch.cutters[cutters + cuts] = j
            cuts += 1
        j += 1
    write_ends(b, u, v, height, count, scratch, at)
    scratch.cuts[circle] = cuts
    return count


@func
def store_face(index: int, b: int, c: int, width: float, row: int, face_index: int, owner: int, faces: BallFaces):
    if face_index < faces.slots:
        faces.corners[row * faces.slots + face_index] = vec3i(index, b, c)
        faces.widths[row * faces.slots + face_index] = width


@store_face.on_cuda
def store_face_of_lane(
    index: int, b: int, c: int, width: float, row: int, face_index: int, owner: int, faces: BallFaces
):
    """CUDA variant: in any order. `sort_faces` follows."""
    slot = atomic_add(faces.counts, row, 1)
    if slot < faces.slots:
        faces.corners[row * faces.slots + slot] = vec3i(index, b, c)
        faces.widths[row * faces.slots + slot] = width
        faces.owners[row * faces.slots + slot] = owner


@func
def ends_at(j: int, count: int, points: BallPoints, scratch: BallScratch, at: int) -> vec2i:
    """1 if a neighbor touches the start of an arc, 1 if it touches the end of one."""
    q = neighbor_at(scratch, j)
    size = scratch.sizes[j]
    slack = float64(TOUCHING_DISTANCE) * points.radius * size
    begins = 0
    ends = 0
    for k in range(count):
        if abs(size * size - 2.0 * dot(q, scratch.ends[at + 2 * k])) <= slack:
            begins = 1
        if abs(size * size - 2.0 * dot(q, scratch.ends[at + 2 * k + 1])) <= slack:
            ends = 1
    return vec2i(begins, ends)


@func
def try_face(
    index: int,
    row: int,
    jb: int,
    jc: int,
    sides: vec2i,
    points: BallPoints,
    scratch: BallScratch,
    base: int,
    counts: vec2i,
    face_count: int,
    faces: BallFaces,
) -> int:
    """Store the triangle of a point and two neighbors if it agrees with the normals, `sides` is 1 for its front or
    back, and its ball is empty. Return the number of triangles."""
    total = face_count
    b = neighbor_at(scratch, jb)
    c = neighbor_at(scratch, jc)
    other = scratch.indices[jb]
    third = scratch.indices[jc]
    root = root_of_ball(b, c, points.radius)
    side = 0
    if root >= 0.0:
        n = cross(b, c)
        side = side_of_normals(n, points.normals[index], points.normals[other], points.normals[third])
    if (side == 1 and sides[0] == 1) or (side == -1 and sides[1] == 1):
        if is_empty_ball(index, jb, jc, root, side, points, scratch, base, counts) == 1:
            width = width_of_circle(b, c, points.radius)
            if side == 1:
                store_face(index, other, third, width, row, total, jb, faces)
            else:
                store_face(index, third, other, width, row, total, jb, faces)
            total += 1
    return total


@func
def find_faces_over(
    index: int,
    row: int,
    jb: int,
    base: int,
    circle: int,
    points: BallPoints,
    scratch: BallScratch,
    counts: vec2i,
    face_count: int,
    faces: BallFaces,
) -> int:
    """Find triangles of a point and its neighbor jb whose third corner follows both. Return the number so far."""
    total = face_count
    other = scratch.indices[jb]
    half = scratch.sizes[jb] * 0.5
    rise = points.radius * points.radius - half * half
    if other > index and rise > 0.0 and points.searched[other] != 0:
        arcs = 0
        size = counts[1]
        first = base + 0
        if counts[1] > FEW_CORNERS:
            b = neighbor_at(scratch, jb)
            u = across(b)
            v = cross(b / scratch.sizes[jb], u)
            arcs = free_arcs(jb, u, v, sqrt(rise), scratch, base, counts[1], circle)
            size = scratch.cuts[circle] if arcs > 0 else 0
            first = circle * scratch.room
        for i in range(first, first + size):
            jc = scratch.cutters[i] if arcs > 0 else i
            third = scratch.indices[jc]
            if third > other and points.searched[third] != 0:
                sides = vec2i(1, 1)
                if arcs > 0:
                    sides = ends_at(jc, arcs, points, scratch, circle * 2 * MAX_ARCS)
                if sides[0] + sides[1] > 0:
                    total = try_face(index, row, jb, jc, sides, points, scratch, base, counts, total, faces)
    return total


@kernel
def find_faces_kernel(points: BallPoints, scratch: BallScratch, faces: BallFaces):
    """Find triangles of points whose other corners follow in tree order."""
    i = tid()
    base = i * scratch.room
    for row in range(i * scratch.run, min((i + 1) * scratch.run, faces.indices.shape[0])):
        index = faces.indices[row]
        counts = gather_neighbors(index, points, scratch, base)
        face_count = 0
        if counts[0] <= scratch.room:
            for jb in range(base, base + counts[1]):
                face_count = find_faces_over(index, row, jb, base, i, points, scratch, counts, face_count, faces)
        faces.neighbor_counts[row] = counts[0]
        faces.counts[row] = face_count


@kernel
def list_neighbors_kernel(points: BallPoints, scratch: BallScratch, faces: BallFaces):
    """List the neighbors of points for the CUDA variant of `find_faces_kernel`."""
    i = tid()
    row = scratch.first + i
    neighbor_count, cells = list_neighbors(faces.indices[row], points, scratch, i * scratch.room)
    scratch.cells[i] = cells
    scratch.tallies[2 * i] = 0
    scratch.tallies[2 * i + 1] = 0
    faces.neighbor_counts[row] = neighbor_count
    faces.counts[row] = 0


@cuda_func
def part_neighbors(
    index: int, point: int, k: int, neighbor_count: int, points: BallPoints, scratch: BallScratch, base: int
):
    """Copy each eighth neighbor: possible corners behind the list, others to the end. In any order, since corners are
    sorted next and the order of others has no effect."""
    p = points.tree.points[index]
    cells = scratch.cells[point]
    halves = any_cell(cells)
    j = 2 * base + k
    while j < 2 * base + neighbor_count:
        key = scratch.keys[j]
        if may_be_corner(key, p, cells, halves, points) == 1:
            scratch.keys[2 * base + scratch.room + atomic_add(scratch.tallies, 2 * point, 1)] = key
        else:
            scratch.keys[2 * (base + scratch.room) - 1 - atomic_add(scratch.tallies, 2 * point + 1, 1)] = key
        j += CUDA_LANES


@cuda_func
def sort_corners(index: int, k: int, corner_count: int, points: BallPoints, scratch: BallScratch, base: int):
    """Store each eighth possible corner at its rank by distance."""
    p = points.tree.points[index]
    first = 2 * base + scratch.room
    j = first + k
    while j < first + corner_count:
        key = scratch.keys[j]
        rank = 0
        for other in range(first, first + corner_count):
            rank += 1 if scratch.keys[other] < key else 0
        store_corner(key, base + rank, p, points, scratch)
        j += CUDA_LANES


@cuda_func
def sort_faces(row: int, count: int, faces: BallFaces):
    """Order the triangles of a point as the CPU finds them: those of a neighbor are in order already."""
    first = row * faces.slots
    for j in range(first + 1, first + count):
        corners = faces.corners[j]
        width = faces.widths[j]
        owner = faces.owners[j]
        slot = j + 0
        while slot > first and faces.owners[slot - 1] > owner:
            faces.corners[slot] = faces.corners[slot - 1]
            faces.widths[slot] = faces.widths[slot - 1]
            faces.owners[slot] = faces.owners[slot - 1]
            slot -= 1
        faces.corners[slot] = corners
        faces.widths[slot] = width
        faces.owners[slot] = owner


@find_faces_kernel.on_cuda
def find_faces_of_lanes_kernel(points: BallPoints, scratch: BallScratch, faces: BallFaces):
    """CUDA variant, eight lanes per point, after `list_neighbors_kernel`. A lane has every eighth neighbor."""
    i = tid()
    k = i % CUDA_LANES
    point = i // CUDA_LANES
    row = scratch.first + point
    base = point * scratch.room
    index = 0
    counts = vec2i(0, 0)
    is_searched = 0
    if row < min(scratch.first + scratch.cells.shape[0], faces.indices.shape[0]):
        index = faces.indices[row]
        counts = vec2i(faces.neighbor_counts[row], 0)
        if counts[0] > 0 and counts[0] <= scratch.room:
            is_searched = 1
            part_neighbors(index, point, k, counts[0], points, scratch, base)
    sync_lanes()
    if is_searched == 1:  # an atomic, since a load may find an old number in the L1 cache
        counts = vec2i(counts[0], atomic_add(scratch.tallies, 2 * point, 0))
        sort_corners(index, k, counts[1], points, scratch, base)
    sync_lanes()
    jb = base + k
    while jb < base + counts[1]:
        find_faces_over(index, row, jb, base, i, points, scratch, counts, 0, faces)
        jb += CUDA_LANES
    sync_lanes()  # all lanes have stored their triangles
    if is_searched == 1 and k == 0:
        count = atomic_add(faces.counts, row, 0)
        if count <= faces.slots:
            sort_faces(row, count, faces)


def find_faces(points: BallPoints, scratch: BallScratch, faces: BallFaces) -> None:
    """Find triangles of points whose other corners follow in tree order."""
    arguments = [points, scratch, faces]
    if not faces.indices.device.is_cuda:
        launch(find_faces_kernel, scratch.threads, arguments)
        return
    for first in range(0, faces.indices.size, scratch.threads):
        scratch.first, count = first, min(scratch.threads, faces.indices.size - first)
        launch(list_neighbors_kernel, count, arguments)
        launch(find_faces_kernel, -(-count * CUDA_LANES // WARP) * WARP, arguments)  # whole warps


@kernel
def pack_faces_kernel(
    faces: BallFaces, offsets: array(dtype=int32), corners: array(dtype=vec3i), widths: array(dtype=float32)
):
    i = tid()
    for j in range(offsets[i + 1] - offsets[i]):
        corners[offsets[i] + j] = faces.corners[i * faces.slots + j]
        widths[offsets[i] + j] = faces.widths[i * faces.slots + j]


@kernel
def part_crowd_kernel(
    faces: BallFaces, room: int, usable: array(dtype=int32), again: array(dtype=int32), maxima: array(dtype=int32)
):
    """Count triangles, mark points without enough room, compute the maximum (atomic if the plain value is lower)."""
    i = tid()
    neighbor_count = faces.neighbor_counts[i]
    count = faces.counts[i]
    crowded = 0
    if neighbor_count > room or count > faces.slots:
        crowded = 1
        count = 0
    usable[i] = count
    again[i] = crowded
    if neighbor_count > maxima[0]:
        atomic_max(maxima, 0, neighbor_count)
    if faces.counts[i] > maxima[1]:
        atomic_max(maxima, 1, faces.counts[i])


def list_faces(points: BallPoints, indices: Integers, expected: int = 0) -> tuple[Triangles, Scalars, int]:
    """Triangles with a first corner in `indices`: (corners vec3i [t], counter-clockwise seen from the ball; widths
    float32 [t]; the largest number of neighbors). One sync per batch, and one more if points need more room.
    `expected` neighbors have room from the start on the CPU, so that few points are searched twice."""
    device, batches, largest = indices.device, [], 0
    cpu_room = max(CPU_ROOM, min(expected, SCRATCH_NEIGHBORS // CPU_THREADS))
    for begin in range(0, indices.size, POINTS_PER_LAUNCH):
        left, slots = indices[begin : min(begin + POINTS_PER_LAUNCH, indices.size)], FIRST_SLOTS
        room = FIRST_ROOM if device.is_cuda else cpu_room
        while left.size:
            faces = BallFaces(left, slots)
            scratch = BallScratch(left.size, room, device)
            find_faces(points, scratch, faces)
            usable, again, maxima = (empty(size, int32, device) for size in (left.size, left.size, 2))
            fill(maxima, 0)
            launch(part_crowd_kernel, left.size, [faces, room, usable, again, maxima])
            ends = [left.size]
            scans = scan_together([(usable, ends), (again, ends)], maxima, largest=slots)  # sync
            (offsets, (total,)), (ranks, (rest,)), (_, (neighbor_count, count)) = scans
            corners, widths = empty(total, vec3i, device), empty(total, float32, device)
            launch(pack_faces_kernel, left.size, [faces, offsets, corners, widths])
            batches.append((corners, widths))
            left = rows_by_offsets(left, ranks, rest)
            # most of these need less than the maximum
            room = min(4 * room, neighbor_count) if neighbor_count > room else room
            slots, largest = max(slots, count), max(largest, neighbor_count)
    none = [(empty(0, vec3i, device), empty(0, float32, device))]
    corners, widths = zip(*(batches or none), strict=True)
    return concatenate_rows(corners), concatenate_rows(widths), largest
