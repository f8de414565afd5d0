"""Neighbors of a group of adjacent queries: one traversal, then vector loops.

The points of all leaves near a group are copied once, and each query measures them without branches. The
group's radius is estimated from the previous group. Queries that find fewer than k, or have too many candidates, search
the tree alone, with the same result. On CUDA a group is a warp (lane_search.py).
"""

from collections.abc import Sequence
from typing import Any

from ..arrays.lanes import max_of_lanes
from ..arrays.packed_keys import key_limit, key_number, pack_key
from ..lang import INFINITY, WARP, Kernel, array, bits_float, func, int32, int64, lane, launch, loop, sqrt, vec3
from .bucket_walk import leaves_within
from .group_scratch import GroupScratch, LaunchPart, stored_key
from .k_nearest import search_k_nearest
from .lane_search import search_lanes
from .neighbor_keys import UNLIMITED_SQRADIUS, keep_nearest, sort_keys, thin_keys
from .point_tree import BUCKET, FAN, LEAF, SIDES, PointTree, positions_in, square_distance

ROUNDING_FACTOR = 1.00001  # covers the float32 rounding of two square roots, a sum and a product
SUBNORMAL_MARGIN = 1.0e-37  # [m^2] covers the rounding of subnormal products, which is not relative
MAX_DROPPED_KEYS = 8  # up to this many excess keys are dropped one by one, without a sort
SQDIST_GROWTH = 1.2  # times the previous group's largest k-th squared distance: 3 % of queries then find fewer than k


@func
def grown_sqradius(bound: float, sqdist: float) -> float:
    """Squared radius of a ball that contains the ball of squared radius `bound` with its center sqrt(sqdist) away."""
    hint = sqrt(bound) + sqrt(sqdist)
    return hint * hint * ROUNDING_FACTOR + SUBNORMAL_MARGIN


@func
def is_repeated(p: vec3, before: vec3, bound: float) -> int:
    """1 if a query has the keys of the one before, whose k-th squared distance is `bound`, infinite for fewer than k.

    The scans of some LiDARs contain thousands of missing returns at zero.
    """
    return 1 if p[0] == before[0] and p[1] == before[1] and p[2] == before[2] and bound < UNLIMITED_SQRADIUS else 0


@func
def gather_candidates(
    a: vec3,
    b: vec3,
    start: int,
    max_sqdist: float,
    tree: PointTree,
    labels: array(dtype=int32),
    scratch: GroupScratch,
    base: int,
) -> int:
    """Copy the points of leaves near a box, padded with infinity. Return the count, at most `gather` + 1."""
    size = 0
    near = max_sqdist
    for first in leaves_within(start, a, b, near, tree):
        if size + LEAF > scratch.gather:
            size = scratch.gather + 1
            near = -1.0
        else:
            for j in range(first, min(first + LEAF, tree.count)):
                p = tree.points[j]
                scratch.xs[base + size] = p[0]
                scratch.ys[base + size] = p[1]
                scratch.zs[base + size] = p[2]
                scratch.ids[base + size] = labels[j]
                size += 1
    if size <= scratch.gather:
        for j in range(base + size, base + (size + LEAF - 1) // LEAF * LEAF):
            scratch.xs[j] = INFINITY
            scratch.ys[j] = INFINITY
            scratch.zs[j] = INFINITY
    return size


@func
def gather_around_leaf(
    leaf: int, max_sqdist: float, tree: PointTree, labels: array(dtype=int32), scratch: GroupScratch, base: int
) -> int:
    """gather_candidates for a leaf. None if there is no room or the radius is infinite."""
    gathered = scratch.gather + 1
    if scratch.gather > 0 and max_sqdist < UNLIMITED_SQRADIUS:
        at = (leaf // FAN) * SIDES + leaf % FAN
        a = vec3(tree.boxes[at], tree.boxes[at + FAN], tree.boxes[at + 2 * FAN])
        b = vec3(tree.boxes[at + 3 * FAN], tree.boxes[at + 4 * FAN], tree.boxes[at + 5 * FAN])
        gathered = gather_candidates(a, b, leaf // FAN, max_sqdist, tree, labels, scratch, base)
    return gathered


@func
def pick_within(p: vec3, scratch: GroupScratch, first: int, size: int, base: int, max_sqdist: float) -> int:
    """Write the keys of candidates within squared distance `max_sqdist` to keys[base:]. Return the count.

    All keys are written by a loop that is vectorized, then selected without branches.
    """
    for j in range(size):
        x = scratch.xs[first + j] - p[0]
        y = scratch.ys[first + j] - p[1]
        z = scratch.zs[first + j] - p[2]
        scratch.keys[base + j] = pack_key(x * x + y * y + z * z, scratch.ids[first + j])
    key_count = 0
    limit = key_limit(max_sqdist)
    for j in range(size):
        key = scratch.keys[base + j]
        scratch.keys[base + key_count] = key
        if key <= limit:
            key_count += 1
    return key_count


@func
def drop_farthest(keys: array(dtype=int64), base: int, key_count: int, k: int) -> int:
    """Remove the largest keys until k are left, unsorted. Return the count."""
    remaining = key_count
    while remaining > k:
        largest = keys[base]
        at = base
        for j in range(base + 1, base + remaining):
            key = keys[j]
            if key > largest:
                largest = key
                at = j
        keys[at] = keys[base + remaining - 1]
        remaining = remaining - 1
    return remaining


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
    max_sqdist: float,
    sort: int,
) -> int:
    """Write the keys of the k nearest points within `max_sqdist` to keys[base:]. Return the count.

    `gathered` candidates cover the squared distance `covered`, unless there are more than `gather`.
    """
    size = -1
    if gathered <= scratch.gather:
        near = min(max_sqdist, covered)
        size = pick_within(p, scratch, first, gathered, base, near)
        if size < scratch.k and near < max_sqdist:
            size = -1  # its k nearest may be farther than the gathered leaves
        else:
            size = thin_keys(scratch.keys, base, 1, size, scratch.k, near)
            if sort == 0 and size <= scratch.k + MAX_DROPPED_KEYS:
                size = drop_farthest(scratch.keys, base, size, scratch.k)
            else:
                size = keep_nearest(scratch.keys, base, 1, size, scratch.k, scratch.room)
    if size < 0:
        size = search_k_nearest(p, start, tree, labels, scratch.keys, base, 1, scratch.k, scratch.room, max_sqdist)
    return size


@func
def farthest_key(scratch: GroupScratch, base: int, size: int) -> float:
    """Largest squared distance among a thread's keys. 0 if there are none."""
    largest = int64(0)
    for j in range(size):
        largest = max(largest, stored_key(scratch, base, j))
    return key_number(largest)


@loop
def nearest_of_leaves(
    thread: int,
    part: LaunchPart,
    tree: PointTree,
    labels: array(dtype=int32),
    scratch: GroupScratch,
    max_sqdist: float,
    sort: int,
) -> tuple[int, int, int]:
    """Each position of a thread's leaves, and base and count of its keys (read with `stored_key`)."""
    base = thread * (scratch.room + scratch.k)
    listing = thread * scratch.gather
    before = vec3(0.0, 0.0, 0.0)
    bound = float(INFINITY)
    widest = float(INFINITY)
    size = 0
    for leaf in range(part.first + thread * part.run, min(part.first + (thread + 1) * part.run, part.last)):
        covered = min(max_sqdist, widest * SQDIST_GROWTH)
        gathered = gather_around_leaf(leaf, covered, tree, labels, scratch, listing)
        widest = 0.0
        for rank in range(leaf * LEAF, min((leaf + 1) * LEAF, tree.count)):
            p = tree.points[rank]
            if is_repeated(p, before, bound) == 0:
                near = min(max_sqdist, grown_sqradius(bound, square_distance(before, p)))
                size = search_member(
                    p, leaf // FAN, gathered, covered, tree, labels, scratch, listing, base, near, sort
                )
                before = p
                bound = float(INFINITY)
                if size == scratch.k:
                    bound = farthest_key(scratch, base, size)
            widest = max(widest, bound)
            yield rank, base, size


@nearest_of_leaves.on_cuda
def nearest_of_lanes(
    thread: int,
    part: LaunchPart,
    tree: PointTree,
    labels: array(dtype=int32),
    scratch: GroupScratch,
    max_sqdist: float,
    sort: int,
) -> tuple[int, int, int]:
    """CUDA variant, one position per lane. The label is the position. The radius follows the warp's previous group."""
    guess = -1.0
    first = part.first + (thread // WARP) * part.run
    for group in range(first, min(first + part.run, part.last)):
        rank = min(group * WARP + lane(), tree.count - 1)
        is_query = 1 if group * WARP + lane() < tree.count else 0
        p = tree.points[rank]
        start = (group * WARP) // BUCKET
        result = search_lanes(p, is_query, start, guess, tree, labels, scratch, thread, max_sqdist, 1)
        guess = max_of_lanes(bits_float(result[1])) * SQDIST_GROWTH
        size = result[0]
        if sort == 1:
            sort_keys(scratch.keys, thread, scratch.stride, size)
        if is_query == 1:
            base = thread
            yield rank, base, size


def launch_over_leaves(kernel: Kernel, tree: PointTree, k: int, arguments: Sequence[Any]) -> None:
    """Launch a kernel (LaunchPart, tree, labels, GroupScratch, `arguments`) that loops over `nearest_of_leaves`."""
    labels = positions_in(tree)
    scratch = GroupScratch(tree.device, tree.count, min(k, max(1, tree.count)))
    for part in scratch.parts():
        launch(kernel, part.threads, [part, tree, labels, scratch, *arguments])
