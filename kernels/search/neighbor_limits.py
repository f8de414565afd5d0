"""How far the neighbours of each point reach, as one 64-bit limit a point: they are the keys up to it.

A key is a squared distance above a place on the curve, as in the search. An operation that needs the neighbours twice,
or in another kernel than the one that found them, keeps 8 B a point instead of a list of k: whoever has the limit
finds the neighbours again by comparing keys, with nothing left to sort or pick.
"""

import numpy as np

from ..arrays.sort import fill_positions_kernel
from ..lang import (
    INFINITY,
    array,
    atomic_max,
    bits_float,
    float_bits,
    func,
    int32,
    int64,
    kernel,
    launch,
    tid,
    vec3,
    vector,
)
from ..memory import empty, full, zeros
from .group_search import GroupScratch, gather_candidates, grown_reach, pick_within
from .point_tree import (
    BUCKET,
    LEAF,
    PointTree,
    points_in_reach,
    search_tree,
    square_distance,
)
from .tree_search import reach_of

eight_counts = vector(8, int32)
FINITE_REACH = 3.4e38  # [m^2] below infinity, so that empty boxes lie beyond every reach
GUESSES = 6  # before the search for a limit halves its interval: interpolation needs about four
LIST_SIZE = 256  # neighbours that scratch memory is laid out for where their number is not limited


@func
def limit_within(reach: float) -> int64:
    """The limit of all points with squared distance <= reach."""
    return ((int64(float_bits(reach)) + int64(1)) << int64(32)) - int64(1)


@func
def reach_within(limit: int64) -> float:
    """The squared distance [m^2] that a limit reaches to."""
    return bits_float(int(limit >> int64(32)))


@func
def key_of(sqdist: float, place: int) -> int64:
    """A point's key: its squared distance above its place."""
    return (int64(float_bits(sqdist)) << int64(32)) | int64(place)


@func
def count_up_to(keys: array(dtype=int64), base: int, held: int, limit: int64) -> int:
    """How many of the keys held lie up to a limit."""
    count = int64(0)  # as wide as the keys, so that both share vector registers
    for j in range(base, base + held):
        if keys[j] <= limit:
            count += int64(1)
    return int(count)


@func
def count_candidates(
    p: vec3,
    scratch: GroupScratch,
    first: int,
    size: int,
    reach: float,
) -> int:
    """How many of the candidates lie within the squared distance `reach`: no keys are made to find that out."""
    counts = eight_counts(0)
    full = size // LEAF
    for chunk in range(full):
        start = first + chunk * LEAF
        for j in range(LEAF):
            x = scratch.xs[start + j] - p[0]
            y = scratch.ys[start + j] - p[1]
            z = scratch.zs[start + j] - p[2]
            counts[j] = counts[j] + (1 if x * x + y * y + z * z <= reach else 0)
    total = int(0)
    for j in range(LEAF):
        total += counts[j]
    for j in range(first + full * LEAF, first + size):
        x = scratch.xs[j] - p[0]
        y = scratch.ys[j] - p[1]
        z = scratch.zs[j] - p[2]
        if x * x + y * y + z * z <= reach:
            total += 1
    return total


@func
def limit_nearest(keys: array(dtype=int64), base: int, held: int, k: int, reach: float) -> int64:
    """A limit that the k smallest of the keys lie up to and no other; the limit of `reach` where they are no more.

    Points within a squared radius grow in proportion to it on a surface, so interpolation finds one in a few passes.
    Where distances are tied or the guesses go wrong the interval is halved: keys differ, so at most 64 times.
    """
    low = int64(-1)
    high = limit_within(reach)
    below = int(0)
    above = held + 0
    turn = int(0)
    while above > k:
        guess = low + (high - low) // int64(2)
        if turn < GUESSES:
            near = reach_within(max(low, int64(0)))
            share = (float(k - below) + 0.5) / float(above - below)
            likely = limit_within(near + (reach_within(high) - near) * share)
            if likely > low and likely < high:
                guess = likely
        found = count_up_to(keys, base, held, guess)
        if found < k:
            low = guess
            below = found
        else:
            high = guess
            above = found
        turn += 1
    return high


@func
def gather_group(
    ranks: array(dtype=int32),
    head: int,
    tail: int,
    reach: float,
    tree: PointTree,
    places: array(dtype=int32),
    scratch: GroupScratch,
    listing: int,
) -> int:
    """Copy the points within reach of the box of a group of queries; their number, gather + 1 where they are more."""
    size = scratch.gather + 1
    if scratch.gather > 0:
        a = tree.points[ranks[head]]
        b = a + vec3(0.0, 0.0, 0.0)
        for j in range(head + 1, tail):
            q = tree.points[ranks[j]]
            a = vec3(min(a[0], q[0]), min(a[1], q[1]), min(a[2], q[2]))
            b = vec3(max(b[0], q[0]), max(b[1], q[1]), max(b[2], q[2]))
        size = gather_candidates(
            a, b, ranks[head] // BUCKET, reach, tree, places, scratch, listing,
        )  # fmt: skip
    return size


@func
def widest_reach(ranks: array(dtype=int32), head: int, tail: int, limits: array(dtype=int64)) -> float:
    """The largest squared distance that the limits of a group of queries reach to."""
    widest = limits[ranks[head]]
    for j in range(head + 1, tail):
        widest = max(widest, limits[ranks[j]])
    return reach_within(widest)


@kernel
def find_limits_kernel(
    ranks: array(dtype=int32),
    query_count: int,
    first: int,
    last: int,
    run: int,
    tree: PointTree,
    places: array(dtype=int32),
    scratch: GroupScratch,
    reach: float,
    limits: array(dtype=int64),
):
    """The limit of the k nearest points within reach, of each query."""
    i = tid()
    base = i * (scratch.room + scratch.k)
    listing = i * scratch.gather
    before = vec3(0.0, 0.0, 0.0)
    bound = float(INFINITY)
    for group in range(first + i * run, min(first + (i + 1) * run, last)):
        head = group * LEAF
        tail = min((group + 1) * LEAF, query_count)
        gathered = gather_group(ranks, head, tail, reach, tree, places, scratch, listing)
        for j in range(head, tail):
            rank = ranks[j]
            p = tree.points[rank]
            limit = limit_within(reach)
            if gathered <= scratch.gather:
                if count_candidates(p, scratch, listing, gathered, reach) > scratch.k:
                    held = pick_within(p, scratch, listing, gathered, base, reach)
                    limit = limit_nearest(scratch.keys, base, held, scratch.k, reach)
            else:
                near = min(reach, grown_reach(bound, square_distance(before, p)))
                size = search_tree(p, rank // BUCKET, tree, places, scratch.keys, base, scratch.k, scratch.room, near)
                before = p
                bound = float(INFINITY)
                if size == scratch.k:
                    limit = scratch.keys[base + scratch.k - 1]
                    bound = reach_within(limit)
            limits[rank] = limit


@kernel
def mark_neighbors_kernel(
    ranks: array(dtype=int32),
    tree: PointTree,
    limits: array(dtype=int64),
    marks: array(dtype=int32),
):
    """Set the marks of some points and of their neighbours; the atomic settles who sets one, all of them to 1."""
    i = tid()
    rank = ranks[i]
    p = tree.points[rank]
    atomic_max(marks, rank, 1)
    limit = limits[rank]
    reach = reach_within(limit)
    for j in points_in_reach(rank // BUCKET, p, reach, tree):
        if key_of(square_distance(p, tree.points[j]), j) <= limit:
            atomic_max(marks, j, 1)


class Neighborhood:
    """The neighbours that a radius, a count or both give each point of a tree, without a list of them.

    Distances are compared as the search compares them; where several points tie for the last place, those that come
    first on the curve are taken.

    Args:
        tree: A PointTree.
        radius: Upper limit of the distance [m], excluded; infinity for none.
        max_nn: Neighbours of a point, itself included; None for all within the radius.
        ranks: int32 device array of the places on the curve whose limits are needed first; None for all.

    Attributes:
        limits: int64 [tree.count] by place.
        places: int32, 0 .. tree.count - 1.
        reach: Squared distance [m^2] that no neighbour lies beyond.
        in_groups: Whether candidates are gathered for groups of points, or each point walks the tree.
    """

    def __init__(self, tree, radius, max_nn, ranks=None):
        device, self.tree = tree.device, tree
        self.reach = min(reach_of(radius), FINITE_REACH)
        self.places = empty(tree.count, int32, device)
        launch(fill_positions_kernel, tree.count, [self.places])
        self.in_groups = not device.is_cuda
        self.is_complete = max_nn is None or max_nn >= tree.count
        self.list_size = LIST_SIZE if self.is_complete else max_nn
        if self.is_complete:
            bits = int(np.float32(self.reach).view(np.int32))
            self.limits = full(tree.count, ((bits + 1) << 32) - 1, int64, device)  # limit_within(reach)
        else:
            self.limits = empty(tree.count, int64, device)
            self.find(self.places if ranks is None else ranks)

    def find(self, ranks):
        """Find the limits of points at these places."""
        if self.is_complete:
            return
        scratch = GroupScratch(self.tree.device, ranks.size, self.list_size, self.reach)
        common = [self.tree, self.places, scratch, self.reach, self.limits]
        for first, last, threads, run in scratch.parts():
            launch(find_limits_kernel, threads, [ranks, ranks.size, first, last, run, *common])

    def visit(self, grouped_kernel, walking_kernel, ranks, arguments):
        """Launch a kernel over the neighbours of the points at these places.

        On the CPU the candidates of a group of points are gathered side by side, as the search does; on CUDA, where a
        thread has no cache of its own for them, each point walks the tree.

        Args:
            grouped_kernel: Takes ranks, their count, first and last group, groups a thread, the tree, places, scratch
                memory, limits and `arguments`.
            walking_kernel: Takes ranks, the tree, limits and `arguments`.
            ranks: int32 device array; their limits are known.
            arguments: What the kernel takes besides.
        """
        if not self.in_groups:
            launch(walking_kernel, ranks.size, [ranks, self.tree, self.limits, *arguments])
            return
        scratch = GroupScratch(self.tree.device, ranks.size, self.list_size, 0.0)  # each group has a reach of its own
        common = [self.tree, self.places, scratch, self.limits, *arguments]
        for first, last, threads, run in scratch.parts():
            launch(grouped_kernel, threads, [ranks, ranks.size, first, last, run, *common])

    def mark(self, ranks):
        """int32 [tree.count]: 1 at the points at these places and at their neighbours, else 0."""
        marks = zeros(self.tree.count, int32, self.tree.device)
        launch(mark_neighbors_kernel, ranks.size, [ranks, self.tree, self.limits, marks])
        return marks
