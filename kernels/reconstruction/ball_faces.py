"""All triangles of some points on which a ball of one radius rests and is empty, on the side of their normals.

A triangle is found once, at the corner that comes first on the tree's curve: its neighbours within twice the radius are
gathered and sorted by distance, the circles of the pairs are cut by the others (ball_arcs.py), nearest first, and what
touches an end of an arc that is left is tried exactly (ball_geometry.py). For k neighbours that is some k^2 / 2 steps
at worst, and far fewer where the points are dense for the ball; the naive search of triples takes k^4.

Nothing is found about points that are not asked for, but all of a tree's points are in the way of balls.

A point takes 56 B of scratch memory a neighbour while its thread works on it, and 100 B of room for results; points are
taken in parts, and those that need more room than others are done again with what they need.
"""

import numpy as np

from ..algebra.transform import widen
from ..array_types import Bytes, Device, Integers, Scalars, Triangles, Vectors
from ..arrays.concatenation import concatenate_rows
from ..arrays.packed_keys import key_index, pack_key
from ..arrays.prefix_sum import scan_together
from ..lang import (
    array,
    atomic_max,
    cross,
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
    tid,
    uint8,
    vec3,
    vec3d,
    vec3i,
)
from ..memory import empty, fill
from ..search.bucket_walk import points_in_reach
from ..search.neighbor_keys import keep_nearest
from ..search.point_tree import BUCKET, PointTree
from .ball_arcs import ARCS, FULL_TURN, NEAR, across, arc_sag, forbid_arc, passes_arc, point_at
from .ball_geometry import ball_center, holds_point, root_of_ball, side_of_normals, width_of_circle

FIRST_ROOM = 96  # neighbours that scratch memory is laid out for at first
FIRST_SLOTS = 8  # triangles a point, which has some two as the first of their corners
SCRATCH = 2**24  # neighbours that all threads of a launch may hold
NEAREST = 5  # points that cut a circle before it is looked which others reach what is left
PART = 2**18  # points a launch
CPU_THREADS = 512  # a launch: few, so that their scratch memory stays in the caches; more than there are chunks of them
REACH = 1.00001  # times the squared reach: float32 distances must not lose a neighbour


@struct
class BallScratch:
    """Scratch memory of the threads: neighbours by distance, and the arcs of the circle that is cut.

    Attributes:
        room: Neighbours a thread.
        run: Points a thread.
        keys: Two for each neighbour.
        places: Where a neighbour stands in the tree.
        xs, ys, zs, sizes: Coordinates about the point, and distances.
        cutters, cuts: The neighbours that came near what was left of the circle, and how many they are: no other can
            touch an end of it.
        arcs: Two numbers an arc.
        ends: Their first and last centres.
        sags: What `arc_sag` says of them.
    """

    room: int
    run: int
    keys: array(dtype=int64)
    places: array(dtype=int32)
    xs: array(dtype=float64)
    ys: array(dtype=float64)
    zs: array(dtype=float64)
    sizes: array(dtype=float64)
    cutters: array(dtype=int32)
    cuts: array(dtype=int32)
    arcs: array(dtype=float64)
    ends: array(dtype=vec3d)
    sags: array(dtype=float64)

    def __init__(self, count: int, room: int, device: Device) -> None:
        most = max(1, SCRATCH // room) if device.is_cuda else min(CPU_THREADS, max(1, SCRATCH // room))
        self.threads, self.room = min(count, most), room
        self.run = -(-count // self.threads)
        self.threads = -(-count // self.run)
        total = self.threads * room
        self.keys, self.places = empty(2 * total, int64, device), empty(total, int32, device)
        self.xs, self.ys, self.zs, self.sizes = (empty(total, float64, device) for _ in range(4))
        self.cutters, self.cuts = empty(total, int32, device), empty(self.threads, int32, device)
        self.arcs = empty(self.threads * 2 * ARCS, float64, device)
        self.ends = empty(self.threads * 2 * ARCS, vec3d, device)
        self.sags = empty(self.threads * 2 * ARCS, float64, device)


@struct
class BallPoints:
    """The points that balls roll over.

    Attributes:
        tree: A PointTree.
        normals: By place in the tree, of any length, none zero.
        asked: 1 at the places whose triangles are wanted.
        radius: Of the ball [m].
        reach: Squared distance [m^2] of neighbours.
    """

    tree: PointTree
    normals: array(dtype=vec3)
    asked: array(dtype=uint8)
    radius: float64
    reach: float

    def __init__(self, tree: PointTree, normals: Vectors, asked: Bytes, radius: float) -> None:
        self.tree, self.normals, self.asked, self.radius = tree, normals, asked, float(radius)
        self.reach = float(min(np.float64(REACH) * (2 * self.radius) ** 2, np.finfo(np.float32).max))


@struct
class BallFaces:
    """Room for the triangles of some points.

    Attributes:
        places: int32, the points' places in the tree.
        slots: Triangles a point.
        held: Neighbours of each point; nothing was searched where they are more than the scratch memory's room.
        counts: Triangles of each point; only `slots` are stored.
        corners: The three places of each triangle.
        widths: The squared radius of its circle as a share of the ball's.
    """

    places: array(dtype=int32)
    slots: int
    held: array(dtype=int32)
    counts: array(dtype=int32)
    corners: array(dtype=vec3i)
    widths: array(dtype=float32)

    def __init__(self, places: Integers, slots: int) -> None:
        device, count = places.device, places.size
        self.places, self.slots = places, slots
        self.held, self.counts = empty(count, int32, device), empty(count, int32, device)
        self.corners, self.widths = empty(count * slots, vec3i, device), empty(count * slots, float32, device)


@func
def neighbor_at(scratch: BallScratch, j: int) -> vec3d:
    """A neighbour's place about the point."""
    return vec3d(scratch.xs[j], scratch.ys[j], scratch.zs[j])


@func
def gather_neighbors(place: int, points: BallPoints, scratch: BallScratch, base: int) -> int:
    """List the neighbours of a point by distance; how many, of which only `room` are listed."""
    p = points.tree.points[place]
    held = 0
    for j, sqdist in points_in_reach(place // BUCKET, p, points.reach, points.tree):
        if j != place:
            if held < scratch.room:
                scratch.keys[2 * base + held] = pack_key(sqdist, j)
            held += 1
    if held <= scratch.room:
        size = keep_nearest(scratch.keys, 2 * base, 1, held, held, scratch.room)
        middle = widen(p)
        for j in range(size):
            other = key_index(scratch.keys[2 * base + j])
            d = widen(points.tree.points[other]) - middle
            scratch.places[base + j] = other
            scratch.xs[base + j] = d[0]
            scratch.ys[base + j] = d[1]
            scratch.zs[base + j] = d[2]
            scratch.sizes[base + j] = sqrt(dot(d, d))
    return held


@func
def is_empty_ball(
    place: int,
    jb: int,
    jc: int,
    root: float64,
    side: int,
    points: BallPoints,
    scratch: BallScratch,
    base: int,
    held: int,
) -> int:
    """1 where no neighbour lies in the ball on a point and two of its neighbours, on one side of them."""
    b = neighbor_at(scratch, jb)
    c = neighbor_at(scratch, jc)
    x = ball_center(b, c, root, side)
    empty = 1
    j = base
    while j < base + held and empty == 1:
        q = neighbor_at(scratch, j)
        size = scratch.sizes[j]
        clearance = size * size - 2.0 * dot(x, q)
        slack = float64(NEAR) * points.radius * size
        if clearance <= slack and j != jb and j != jc:
            if clearance < -slack:
                empty = 0
            else:
                ia = points.tree.order[place]
                ib = points.tree.order[scratch.places[jb]]
                ic = points.tree.order[scratch.places[jc]]
                at = points.tree.order[scratch.places[j]]
                if holds_point(b, c, q, root, side, points.radius, ia, ib, ic, at) == 1:
                    empty = 0
        j += 1
    return empty


@func
def write_ends(b: vec3d, u: vec3d, v: vec3d, height: float64, count: int, scratch: BallScratch, at: int):
    """The centres at the ends of the arcs, and how far the others sag between them."""
    middle = b * 0.5
    slack = float64(NEAR) * (height + sqrt(dot(b, b)))  # more than NEAR of the radius
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
    """1 where a point may lie in a ball of the arcs whose ends are known."""
    touches = 0
    for k in range(count):
        if passes_arc(q, size, scratch.ends[at + 2 * k], scratch.ends[at + 2 * k + 1], scratch.sags[at + k]) == 0:
            touches = 1
    return touches


@func
def free_arcs(jb: int, u: vec3d, v: vec3d, height: float64, scratch: BallScratch, base: int, held: int, at: int) -> int:
    """The arcs of the circle of centres over a point and a neighbour where no other neighbour lies inside; how many.

    First those cut that lie between the two, in the ball about both: more than half the circle each, so that two end
    most searches. After some more the others mostly do not reach what is left, which is seen from the centres at its
    ends sooner than it is cut.
    """
    b = neighbor_at(scratch, jb)
    length = scratch.sizes[jb]
    count = 1
    cuts = 0
    scratch.arcs[at] = 0.0
    scratch.arcs[at + 1] = float64(FULL_TURN)
    j = base
    while j < jb and count > 0:
        q = neighbor_at(scratch, j)
        if dot(q, q - b) < 0.0:
            count = forbid_arc(scratch.arcs, at, count, q, scratch.sizes[j], b, length, u, v, height)
            scratch.cutters[base + cuts] = j
            cuts += 1
        j += 1
    early = cuts + NEAREST
    j = base
    known = 0
    while j < base + held and count > 0:
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
            scratch.cutters[base + cuts] = j
            cuts += 1
        j += 1
    write_ends(b, u, v, height, count, scratch, at)
    scratch.cuts[base // scratch.room] = cuts
    return count


@func
def store_face(place: int, b: int, c: int, width: float, row: int, found: int, faces: BallFaces):
    """Keep a triangle where there is room."""
    if found < faces.slots:
        faces.corners[row * faces.slots + found] = vec3i(place, b, c)
        faces.widths[row * faces.slots + found] = width


@func
def try_faces(
    place: int,
    row: int,
    jb: int,
    count: int,
    points: BallPoints,
    scratch: BallScratch,
    base: int,
    held: int,
    at: int,
    found: int,
    faces: BallFaces,
) -> int:
    """Store the triangles of a point, a neighbour and what touches the ends of the arcs left; how many there are."""
    total = found
    b = neighbor_at(scratch, jb)
    other = scratch.places[jb]
    for i in range(scratch.cuts[base // scratch.room]):
        j = scratch.cutters[base + i]
        third = scratch.places[j]
        if third > other and points.asked[third] != 0:
            q = neighbor_at(scratch, j)
            size = scratch.sizes[j]
            slack = float64(NEAR) * points.radius * size
            begins = 0
            ends = 0
            for k in range(count):
                if abs(size * size - 2.0 * dot(q, scratch.ends[at + 2 * k])) <= slack:
                    begins = 1
                if abs(size * size - 2.0 * dot(q, scratch.ends[at + 2 * k + 1])) <= slack:
                    ends = 1
            if begins + ends > 0:
                root = root_of_ball(b, q, points.radius)
                side = 0
                if root >= 0.0:
                    n = cross(b, q)
                    side = side_of_normals(n, points.normals[place], points.normals[other], points.normals[third])
                if (side == 1 and begins == 1) or (side == -1 and ends == 1):
                    if is_empty_ball(place, jb, j, root, side, points, scratch, base, held) == 1:
                        width = width_of_circle(b, q, points.radius)
                        if side == 1:
                            store_face(place, other, third, width, row, total, faces)
                        else:
                            store_face(place, third, other, width, row, total, faces)
                        total += 1
    return total


@func
def find_faces(
    place: int, row: int, thread: int, points: BallPoints, scratch: BallScratch, held: int, faces: BallFaces
) -> int:
    """The triangles of a point whose other corners lie behind it on the curve; how many."""
    base = thread * scratch.room
    at = thread * 2 * ARCS
    found = 0
    for jb in range(base, base + held):
        other = scratch.places[jb]
        half = scratch.sizes[jb] * 0.5
        rise = points.radius * points.radius - half * half
        if other > place and rise > 0.0 and points.asked[other] != 0:
            b = neighbor_at(scratch, jb)
            u = across(b)
            v = cross(b / scratch.sizes[jb], u)
            height = sqrt(rise)
            count = free_arcs(jb, u, v, height, scratch, base, held, at)
            if count > 0:
                found = try_faces(place, row, jb, count, points, scratch, base, held, at, found, faces)
    return found


@kernel
def find_faces_kernel(points: BallPoints, scratch: BallScratch, faces: BallFaces):
    """The triangles of the points of a run, one after the other."""
    i = tid()
    for row in range(i * scratch.run, min((i + 1) * scratch.run, faces.places.shape[0])):
        place = faces.places[row]
        held = gather_neighbors(place, points, scratch, i * scratch.room)
        found = 0
        if held <= scratch.room:
            found = find_faces(place, row, i, points, scratch, held, faces)
        faces.held[row] = held
        faces.counts[row] = found


@kernel
def pack_faces_kernel(
    faces: BallFaces, offsets: array(dtype=int32), corners: array(dtype=vec3i), widths: array(dtype=float32)
):
    """The triangles of points that had enough room, one after the other."""
    i = tid()
    for j in range(offsets[i + 1] - offsets[i]):
        corners[offsets[i] + j] = faces.corners[i * faces.slots + j]
        widths[offsets[i] + j] = faces.widths[i * faces.slots + j]


@kernel
def part_crowd_kernel(
    faces: BallFaces, room: int, usable: array(dtype=int32), again: array(dtype=int32), most: array(dtype=int32)
):
    """The triangles of points that had enough room, 1 at those that had not, and the most that any asked for.

    The maxima of whole numbers are the same in any order; a plain read spares the atomic where nothing would change.
    """
    i = tid()
    held = faces.held[i]
    count = faces.counts[i]
    crowded = 0
    if held > room or count > faces.slots:
        crowded = 1
        count = 0
    usable[i] = count
    again[i] = crowded
    if held > most[0]:
        atomic_max(most, 0, held)
    if faces.counts[i] > most[1]:
        atomic_max(most, 1, faces.counts[i])


@kernel
def list_crowd_kernel(places: array(dtype=int32), ranks: array(dtype=int32), crowd: array(dtype=int32)):
    """The places of points that had not enough room."""
    i = tid()
    if ranks[i + 1] > ranks[i]:
        crowd[ranks[i]] = places[i]


def list_faces(points: BallPoints, places: Integers) -> tuple[Triangles, Scalars]:
    """The triangles whose first corner on the curve is one of the points at these places.

    Args:
        points: BallPoints.
        places: int32 device array.

    Returns:
        (corners, widths): vec3i [t], places in the tree, counter-clockwise seen from the ball; float32 [t], the squared
            radius of each one's circle as a share of the ball's. One wait for the device a part, and one more where
            points need more room than others.
    """
    device, found = places.device, []
    for begin in range(0, places.size, PART):
        left, room, slots = places[begin : min(begin + PART, places.size)], FIRST_ROOM, FIRST_SLOTS
        while left.size:
            faces = BallFaces(left, slots)
            scratch = BallScratch(left.size, room, device)
            launch(find_faces_kernel, scratch.threads, [points, scratch, faces])
            usable, again, most = (empty(size, int32, device) for size in (left.size, left.size, 2))
            fill(most, 0)
            launch(part_crowd_kernel, left.size, [faces, room, usable, again, most])
            ends = [left.size]
            scans = scan_together([(usable, ends), (again, ends)], most)  # sync
            (offsets, (total,)), (ranks, (rest,)), (_, (held, count)) = scans
            corners, widths = empty(total, vec3i, device), empty(total, float32, device)
            launch(pack_faces_kernel, left.size, [faces, offsets, corners, widths])
            found.append((corners, widths))
            crowd = empty(rest, int32, device)
            launch(list_crowd_kernel, left.size if rest else 0, [left, ranks, crowd])
            left = crowd
            room = min(4 * room, held) if held > room else room  # most of the crowd need less than the worst
            slots = max(slots, count)
    none = [(empty(0, vec3i, device), empty(0, float32, device))]
    corners, widths = zip(*(found or none), strict=True)
    return concatenate_rows(corners), concatenate_rows(widths)
