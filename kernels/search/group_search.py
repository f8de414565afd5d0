"""Neighbours for a group of queries that lie close together: one walk through the tree, then plain vector loops.

The leaves that a group of LEAF queries can need are found once and their points copied side by side; each query then
measures all of them in a loop without branches, keeps those within its own reach, and picks. How far a group looks is
the radius, or less: a little farther than the k-th neighbours of the group before it. A query that finds fewer than k
there, one whose group has too many candidates, and every query on CUDA walks the tree alone: the result is the same.

A walk's reach comes from the query before: a ball grown by the way between the two holds as many points.
"""

from ..arrays.packed_keys import key_number, pack_key
from ..arrays.sort import positions
from ..lang import INFINITY, array, float32, func, int32, int64, launch, loop, sqrt, struct, vec3, vector
from ..memory import empty
from .bucket_walk import next_bucket, start_walk
from .k_nearest import search_k_nearest
from .neighbor_keys import BOUNDLESS, keep_nearest, thin_keys
from .point_tree import BUCKET, FAN, LEAF, SIDES, PointTree, measure_boxes, square_distance

SLACK = 1.00001  # covers the rounding of two square roots, a sum and a product in float32
TINY = 1.0e-37  # [m^2] covers the rounding of products below the normal numbers, which is not relative
eight = vector(8, float32)
FEW = 8  # so many keys too many are dropped one by one rather than by sorting all
GUESS = 1.2  # times the largest k-th squared distance of the group before: then 3 % of queries find fewer than k
CPU_RUN = 32  # groups a thread on the CPU; the queries of the first have no group before and walk the tree
SCRATCH = 2**25  # scratch numbers of one kind a launch


@struct
class LaunchPart:
    """The groups of one launch.

    Attributes:
        first, last: The groups from `first` to `last` - 1.
        run: Groups a thread.
        threads: Threads.
    """

    first: int
    last: int
    run: int

    def __init__(self, first, last, run, threads):
        self.first, self.last, self.run, self.threads = first, last, run, threads


@struct
class GroupScratch:
    """Scratch memory of searches in groups, and the parts in which they are launched.

    Attributes:
        xs, ys, zs, ids: Candidates: coordinates and labels; a thread's begin at its number times `gather`.
        keys: A thread's begin at its number times `room` + `k`: first `room` that are held, then k that are kept.
        k: Neighbours a query.
        gather: Candidates that a group may have, a multiple of LEAF; 0 where each query walks the tree.
        width: Queries a group where it is no leaf; 1 where each query walks the tree.
    """

    xs: array(dtype=float32)
    ys: array(dtype=float32)
    zs: array(dtype=float32)
    ids: array(dtype=int32)
    keys: array(dtype=int64)
    k: int
    room: int
    gather: int
    width: int

    def __init__(self, device, query_count, k, *, walks=False):
        """Memory for searches of the k nearest; with `walks` for queries that walk the tree and hold no keys."""
        self.run, self.width = 1 if device.is_cuda else CPU_RUN, 1 if walks else LEAF
        self.groups = -(-query_count // self.width)
        self.k, self.gather = (0, 0) if walks else (k, candidate_room(device, k))
        self.room = 0 if walks else max(self.gather, 3 * k + 2 * BUCKET)  # a ball from the query before holds some 2 k
        row = self.room + self.k
        self.most = max(1, SCRATCH // max(1, row))
        threads = min(-(-self.groups // self.run), self.most)
        candidates = max(1, threads * self.gather)
        self.xs, self.ys, self.zs = (empty(candidates, float32, device) for _ in range(3))
        self.ids, self.keys = empty(candidates, int32, device), empty(max(1, threads * row), int64, device)

    def parts(self, shift=0):
        """The LaunchPart of each launch; `shift` is the number of the first group."""
        threads = -(-self.groups // self.run)
        for begin in range(0, threads, self.most):
            here = min(self.most, threads - begin)
            last = min(self.groups, (begin + here) * self.run)
            yield LaunchPart(shift + begin * self.run, shift + last, self.run, here)


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
    tree: PointTree,
    labels: array(dtype=int32),
    scratch: GroupScratch,
    base: int,
) -> int:
    """Copy the points of all leaves within the squared distance `reach` of a box; their number.

    More than `gather` are not copied and reported as `gather` + 1. Up to a multiple of LEAF points at infinity follow.
    """
    size = int(0)
    step = start_walk(start)
    while int(step[0]) <= tree.root and size <= scratch.gather:
        bucket = int(step[2])
        distances = measure_boxes(tree.boxes, bucket, a, b)
        for leaf in range(FAN):
            if distances[leaf] <= reach and size <= scratch.gather:
                first = bucket * BUCKET + leaf * LEAF
                if size + LEAF > scratch.gather:
                    size = scratch.gather + 1
                else:
                    for j in range(first, min(first + LEAF, tree.count)):
                        p = tree.points[j]
                        scratch.xs[base + size] = p[0]
                        scratch.ys[base + size] = p[1]
                        scratch.zs[base + size] = p[2]
                        scratch.ids[base + size] = labels[j]
                        size += 1
        step = next_bucket(step, a, b, reach, tree)
    if size <= scratch.gather:
        for j in range(base + size, base + (size + LEAF - 1) // LEAF * LEAF):
            scratch.xs[j] = INFINITY
            scratch.ys[j] = INFINITY
            scratch.zs[j] = INFINITY
    return size


@func
def gather_around_leaf(
    leaf: int,
    reach: float,
    tree: PointTree,
    labels: array(dtype=int32),
    scratch: GroupScratch,
    base: int,
) -> int:
    """gather_candidates for the points of a leaf; none where there is no room or the reach is without bound."""
    gathered = scratch.gather + 1
    if scratch.gather > 0 and reach < BOUNDLESS:
        at = (leaf // FAN) * SIDES + leaf % FAN
        a = vec3(tree.boxes[at], tree.boxes[at + FAN], tree.boxes[at + 2 * FAN])
        b = vec3(tree.boxes[at + 3 * FAN], tree.boxes[at + 4 * FAN], tree.boxes[at + 5 * FAN])
        gathered = gather_candidates(a, b, leaf // FAN, reach, tree, labels, scratch, base)
    return gathered


@func
def pick_within(p: vec3, scratch: GroupScratch, first: int, size: int, base: int, reach: float) -> int:
    """The keys of the candidates with squared distance <= reach, in keys[base:]; how many.

    Eight at a time: their distances stay in registers, so that no store stands between the loads. What is measured
    beyond the last candidate lies at infinity and is not kept.
    """
    held = int(0)
    sqdists = eight(0.0)
    for chunk in range((size + LEAF - 1) // LEAF):
        start = first + chunk * LEAF
        for j in range(LEAF):
            x = scratch.xs[start + j] - p[0]
            y = scratch.ys[start + j] - p[1]
            z = scratch.zs[start + j] - p[2]
            sqdists[j] = x * x + y * y + z * z
        for j in range(min(LEAF, size - chunk * LEAF)):
            scratch.keys[base + held] = pack_key(sqdists[j], scratch.ids[start + j])
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
    tree: PointTree,
    labels: array(dtype=int32),
    scratch: GroupScratch,
    first: int,
    base: int,
    reach: float,
    sort: int,
) -> int:
    """The k nearest points within reach of one query of a group, as keys in keys[base:]; how many.

    `gathered` candidates hold every point within the squared distance `covered` of the query, unless they are more
    than `gather`. Sorted where asked, else in any order unless they had to be sorted to pick them.
    """
    size = int(-1)
    if gathered <= scratch.gather:
        near = min(reach, covered)
        size = pick_within(p, scratch, first, gathered, base, near)
        if size < scratch.k and near < reach:
            size = -1  # its k nearest may lie farther than the leaves that were gathered
        else:
            size = thin_keys(scratch.keys, base, size, scratch.k, near)
            if sort == 0 and size <= scratch.k + FEW:
                size = drop_farthest(scratch.keys, base, size, scratch.k)
            else:
                size = keep_nearest(scratch.keys, base, size, scratch.k, scratch.room)
    if size < 0:
        size = search_k_nearest(p, start, tree, labels, scratch.keys, base, scratch.k, scratch.room, reach)
    return size


@func
def farthest_key(keys: array(dtype=int64), base: int, size: int) -> float:
    """The largest squared distance among keys."""
    largest = keys[base]
    for j in range(base + 1, base + size):
        largest = max(largest, keys[j])
    return key_number(largest)


@loop
def nearest_of_leaves(
    thread: int,
    part: LaunchPart,
    tree: PointTree,
    labels: array(dtype=int32),
    scratch: GroupScratch,
    reach: float,
    sort: int,
) -> tuple[int, int, int]:
    """Each place of a thread's leaves, where its keys begin in scratch memory, and how many they are.

    The keys are those of the k nearest points within the squared distance `reach`, above their labels.
    """
    base = thread * (scratch.room + scratch.k)
    listing = thread * scratch.gather
    before = vec3(0.0, 0.0, 0.0)
    bound = float(INFINITY)
    widest = float(INFINITY)
    for leaf in range(part.first + thread * part.run, min(part.first + (thread + 1) * part.run, part.last)):
        covered = min(reach, widest * GUESS)
        gathered = gather_around_leaf(leaf, covered, tree, labels, scratch, listing)
        widest = float(0.0)
        for rank in range(leaf * LEAF, min((leaf + 1) * LEAF, tree.count)):
            p = tree.points[rank]
            near = min(reach, grown_reach(bound, square_distance(before, p)))
            size = search_member(p, leaf // FAN, gathered, covered, tree, labels, scratch, listing, base, near, sort)
            yield rank, base, size
            before = p
            bound = float(INFINITY)
            if size == scratch.k:
                bound = farthest_key(scratch.keys, base, size)
            widest = max(widest, bound)


def candidate_room(device, k):
    """How many candidates a group may gather; 0 for none, on CUDA, where a thread has no cache of its own for them."""
    return 0 if device.is_cuda else LEAF * max(64, 2 * k + 24)


def launch_over_leaves(kernel, tree, k, arguments):
    """Launch a kernel that loops over `nearest_of_leaves`, for the k nearest of all points of a tree.

    Args:
        kernel: Takes a LaunchPart, the tree, the places of its points as labels, a GroupScratch and `arguments`.
        tree: The PointTree.
        k: Neighbours, the point itself included; all where there are no more points.
        arguments: What the kernel takes besides.
    """
    places = positions(tree.count, tree.device)
    scratch = GroupScratch(tree.device, tree.count, min(k, max(1, tree.count)))
    for part in scratch.parts():
        launch(kernel, part.threads, [part, tree, places, scratch, *arguments])
