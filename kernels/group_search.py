"""Neighbours for a group of queries that lie close together: one walk through the tree, then plain vector loops.

The leaves that a group of LEAF queries can need are found once and their points copied side by side; each query then
measures all of them in a loop without branches, keeps those within its own reach, and picks. How far a group looks is
the radius, or less: a little farther than the k-th neighbours of the group before it. A query that finds fewer than k
there, one whose group has too many candidates, and every query on CUDA walks the tree alone: the result is the same.

A walk's reach comes from the query before: a ball grown by the way between the two holds as many points.
"""

from .lang import array, bits_float, float32, float_bits, func, int32, int64, sqrt, vec3, vector
from .memory import empty
from .neighbor_keys import keep_nearest, thin_keys
from .point_tree import (
    BUCKET,
    FAN,
    FAR,
    LEAF,
    SIDES,
    measure_boxes,
    next_bucket,
    search_tree,
    start_walk,
)

SLACK = 1.00001  # covers the rounding of two square roots, a sum and a product in float32
TINY = 1.0e-37  # [m^2] covers the rounding of products below the normal numbers, which is not relative
eight = vector(8, float32)
FEW = 8  # so many keys too many are dropped one by one rather than by sorting all
GUESS = 1.2  # times the largest k-th squared distance of the group before: then 3 % of queries find fewer than k
CPU_RUN = 32  # groups a thread on the CPU; the queries of the first have no group before and walk the tree
SCRATCH = 2**25  # scratch numbers of one kind a launch


@func
def grown_reach(bound: float, sqdist: float) -> float:
    """Squared radius of a ball that holds a ball of squared radius `bound` whose centre is sqrt(sqdist) away."""
    hint = sqrt(bound) + sqrt(sqdist)
    return hint * hint * SLACK + TINY


@func
def gather_candidates(
    a: vec3,
    b: vec3,
    start: int,
    reach: float,
    count: int,
    root: int,
    levels: array(dtype=int32),
    boxes: array(dtype=float32),
    points: array(dtype=vec3),
    labels: array(dtype=int32),
    xs: array(dtype=float32),
    ys: array(dtype=float32),
    zs: array(dtype=float32),
    ids: array(dtype=int32),
    base: int,
    room: int,
) -> int:
    """Copy the points of all leaves within the squared distance `reach` of a box; their number.

    More than `room` are not copied and reported as room + 1.
    """
    size = int(0)
    step = start_walk(start)
    while int(step[0]) <= root and size <= room:
        bucket = int(step[2])
        distances = measure_boxes(boxes, bucket, a, b)
        for leaf in range(FAN):
            if distances[leaf] <= reach and size <= room:
                first = bucket * BUCKET + leaf * LEAF
                if size + LEAF > room:
                    size = room + 1
                else:
                    for j in range(first, min(first + LEAF, count)):
                        p = points[j]
                        xs[base + size] = p[0]
                        ys[base + size] = p[1]
                        zs[base + size] = p[2]
                        ids[base + size] = labels[j]
                        size += 1
        step = next_bucket(step, a, b, reach, root, levels, boxes)
    return size


@func
def gather_around_leaf(
    leaf: int,
    reach: float,
    count: int,
    root: int,
    levels: array(dtype=int32),
    boxes: array(dtype=float32),
    points: array(dtype=vec3),
    labels: array(dtype=int32),
    xs: array(dtype=float32),
    ys: array(dtype=float32),
    zs: array(dtype=float32),
    ids: array(dtype=int32),
    base: int,
    room: int,
) -> int:
    """gather_candidates for the points of a leaf; none where there is no room or the reach is without bound."""
    gathered = room + 1
    if room > 0 and reach < FAR:
        at = (leaf // FAN) * SIDES + leaf % FAN
        a = vec3(boxes[at], boxes[at + FAN], boxes[at + 2 * FAN])
        b = vec3(boxes[at + 3 * FAN], boxes[at + 4 * FAN], boxes[at + 5 * FAN])
        gathered = gather_candidates(
            a, b, leaf // FAN, reach, count, root, levels, boxes, points, labels, xs, ys, zs, ids, base, room
        )
    return gathered


@func
def pick_within(
    p: vec3,
    xs: array(dtype=float32),
    ys: array(dtype=float32),
    zs: array(dtype=float32),
    ids: array(dtype=int32),
    first: int,
    size: int,
    keys: array(dtype=int64),
    base: int,
    reach: float,
) -> int:
    """The keys of the candidates with squared distance <= reach, in keys[base:]; how many.

    Eight at a time: their distances stay in registers, so that no store stands between the loads.
    """
    held = int(0)
    sqdists = eight(0.0)
    for chunk in range((size + LEAF - 1) // LEAF):
        start = first + chunk * LEAF
        for j in range(LEAF):
            x = xs[start + j] - p[0]
            y = ys[start + j] - p[1]
            z = zs[start + j] - p[2]
            sqdists[j] = x * x + y * y + z * z
        for j in range(min(LEAF, size - chunk * LEAF)):
            keys[base + held] = (int64(float_bits(sqdists[j])) << int64(32)) | int64(ids[start + j])
            if sqdists[j] <= reach:
                held += 1
    return held


@func
def drop_farthest(keys: array(dtype=int64), base: int, held: int, k: int) -> int:
    """Remove the largest keys until k are left, unsorted; how many are left."""
    left = held + 0
    while left > k:
        largest = keys[base]
        at = base + 0
        for j in range(base + 1, base + left):
            key = keys[j]
            if key > largest:
                largest = key
                at = j
        keys[at] = keys[base + left - 1]
        left = left - 1
    return left


@func
def search_member(
    p: vec3,
    start: int,
    gathered: int,
    covered: float,
    count: int,
    root: int,
    levels: array(dtype=int32),
    boxes: array(dtype=float32),
    points: array(dtype=vec3),
    labels: array(dtype=int32),
    xs: array(dtype=float32),
    ys: array(dtype=float32),
    zs: array(dtype=float32),
    ids: array(dtype=int32),
    first: int,
    gather: int,
    keys: array(dtype=int64),
    base: int,
    k: int,
    room: int,
    reach: float,
    sort: int,
) -> int:
    """The k nearest points within reach of one query of a group, as keys in keys[base:]; how many.

    `gathered` candidates hold every point within the squared distance `covered` of the query, unless they are more
    than `gather`. Sorted where asked, else in any order unless they had to be sorted to pick them.
    """
    size = int(-1)
    if gathered <= gather:
        near = min(reach, covered)
        size = pick_within(p, xs, ys, zs, ids, first, gathered, keys, base, near)
        if size < k and near < reach:
            size = -1  # its k nearest may lie farther than the leaves that were gathered
        else:
            size = thin_keys(keys, base, size, k, near)
            if sort == 0 and size <= k + FEW:
                size = drop_farthest(keys, base, size, k)
            else:
                size = keep_nearest(keys, base, size, k, room)
    if size < 0:
        size = search_tree(p, start, count, root, levels, boxes, points, labels, keys, base, k, room, reach)
    return size


@func
def farthest_key(keys: array(dtype=int64), base: int, size: int) -> float:
    """The largest squared distance among keys."""
    largest = keys[base]
    for j in range(base + 1, base + size):
        largest = max(largest, keys[j])
    return bits_float(int(largest >> int64(32)))


def candidate_room(device, k):
    """How many candidates a group may gather; 0 for none, on CUDA, where a thread has no cache of its own for them."""
    return 0 if device.is_cuda else LEAF * max(64, 2 * k + 24)


class GroupScratch:
    """Scratch memory of searches in groups, and the parts in which they are launched.

    Attributes:
        arguments: xs, ys, zs, ids, keys, k, room, gather: what the kernels take.
    """

    def __init__(self, device, query_count, k, reach):
        self.run = 1 if device.is_cuda else CPU_RUN
        self.groups = -(-query_count // LEAF)
        gather = candidate_room(device, k)
        room = max(gather, 3 * k + 2 * BUCKET)  # a ball from the query before holds about 2 k points
        row = room + k
        self.most = max(1, SCRATCH // row)
        threads = min(-(-self.groups // self.run), self.most)
        candidates = max(1, threads * gather)
        floats = [empty(candidates, float32, device) for _ in range(3)]
        xs, ys, zs = floats
        ids, keys = empty(candidates, int32, device), empty(threads * row, int64, device)
        self.arguments = [xs, ys, zs, ids, keys, k, room, gather]

    def parts(self):
        """(first group, last group, threads, groups a thread) of each launch."""
        threads = -(-self.groups // self.run)
        for begin in range(0, threads, self.most):
            here = min(self.most, threads - begin)
            yield begin * self.run, min(self.groups, (begin + here) * self.run), here, self.run
