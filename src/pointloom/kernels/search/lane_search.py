"""Neighbors of the 32 queries of a CUDA warp: one traversal lists leaves, then each lane measures their points.

Lanes read the same eight points together and keep keys within a radius. The k smallest keys are found by counting
against interpolated limits (neighbor_keys.limit_nearest), without a quadratic pass. The radius is widened or narrowed
as needed. A lane that does not converge searches alone. Scratch memory is reused so that it stays in the L2 cache.
"""

from ..algebra.plain_min_max import larger
from ..arrays.lanes import high_of_lanes, low_of_lanes, max_of_eight, min_of_lanes
from ..arrays.packed_keys import key_bits, key_index, key_number, pack_bits, pack_key
from ..lang import (
    INFINITY,
    WARP,
    array,
    bit_count,
    cuda_func,
    float32,
    float_bits,
    int32,
    int64,
    lane,
    load_eight,
    partial,
    sqrt,
    sync_lanes,
    vec2,
    vec2i,
    vec3,
    vector,
)
from .bucket_walk import next_step, start_traversal, traversal
from .group_scratch import GroupScratch
from .k_nearest import search_k_nearest
from .lane_boxes import boxes_of_eight, nearby_children, nearby_nodes, two_boxes
from .neighbor_keys import MAX_INTERPOLATIONS, keep_up_to, limit_nearest
from .point_tree import BUCKET, FAN, LEAF, SIDES, PointTree, square_distance

eight_points = vector(24, float32)
PLANE_FRACTION = (
    0.0025  # [1] a bucket's squared diagonal times k times this is the squared radius of k points on a plane
)
SQRADIUS_MARGIN = 1.5  # safety factor of the expected squared radius
MAX_GROWTH = 8.0  # maximum growth of a squared radius per step
SQRADIUS_SHRINKAGE = 0.25  # shrink factor of a squared radius with too many leaves
MIN_SQRADIUS = 1.0e-37  # [m^2] minimum of a growing squared radius
MAX_ATTEMPTS = 12  # attempts before each lane traverses the tree


@cuda_func
def next_bucket_of_lanes(step: traversal, around: two_boxes, bound: float, tree: PointTree) -> traversal:
    return next_step(step, tree.root, partial(nearby_nodes, tree.levels, 0, tree.boxes, around, bound))


@cuda_func
def list_leaves(p: vec3, max_sqdist: float, start: int, tree: PointTree, scratch: GroupScratch, listing: int) -> int:
    """List the leaves near the lanes' points by boxes of eight lanes. Return the count, partial beyond `gather`."""
    around = boxes_of_eight(p, 1)
    widest = max_of_eight(max_sqdist)
    own = lane()
    sync_lanes()  # after lanes have read the previous list
    size = 0
    step = start_traversal(start)
    while int(step[0]) <= tree.root and size <= scratch.gather:
        bucket = int(step[2])
        near = nearby_children(tree.boxes, bucket, around, widest)
        slot = size + bit_count(near & ((1 << own) - 1))
        if own < FAN and ((near >> own) & 1) == 1 and slot < scratch.gather:
            scratch.ids[listing + slot] = bucket * BUCKET + own * LEAF
        size += bit_count(near)
        step = next_bucket_of_lanes(step, around, widest, tree)
    sync_lanes()
    return size


@cuda_func
def sqdist_of(leaf: eight_points, j: int, p: vec3) -> float:
    return square_distance(p, vec3(leaf[3 * j], leaf[3 * j + 1], leaf[3 * j + 2]))


@cuda_func
def keep_near(
    p: vec3, max_sqdist: float, tree: PointTree, scratch: GroupScratch, listing: int, size: int, base: int
) -> int:
    """Store the keys within `max_sqdist`, above positions. Return the count, partial above room - LEAF."""
    at = base
    last = base + (scratch.room - LEAF) * scratch.stride
    lacking = 0
    following = scratch.ids[listing]
    for entry in range(size):
        first = following + 0
        leaf = load_eight(tree.points, first)
        following = scratch.ids[listing + min(entry + 1, size - 1)]  # after the stores it would wait for them
        has_room = 1 if at <= last else 0
        for j in range(LEAF):
            sqdist = sqdist_of(leaf, j, p)
            near = 1 if sqdist <= max_sqdist else 0
            if near == 1 and has_room == 1:
                scratch.keys[at] = pack_key(sqdist, first + j)
            # outside of the branch: each assignment inside would occupy a register during the whole loop
            at += scratch.stride * (near * has_room)
            lacking += near * (1 - has_room)
    return (at - base) // scratch.stride + lacking


@cuda_func
def keep_up_to_limit(
    p: vec3, limit: int64, tree: PointTree, scratch: GroupScratch, listing: int, size: int, base: int
) -> int:
    """Store the keys up to a limit and return the count, -1 if there is no room."""
    near_count = keep_near(p, key_number(limit), tree, scratch, listing, size, base)
    count = -1
    if near_count <= scratch.room - LEAF:
        count = keep_up_to(scratch.keys, base, scratch.stride, near_count, limit)
    return count


@cuda_func
def keep_nearer(
    p: vec3,
    max_sqdist: float,
    near_count: int,
    tree: PointTree,
    scratch: GroupScratch,
    listing: int,
    size: int,
    base: int,
) -> vec2:
    """Store at least k keys if `near_count` are too many: (squared distance or -1, count)."""
    low = 0.0
    high = max_sqdist
    above = int(near_count)
    capacity = scratch.room - LEAF
    middle = (scratch.k + capacity) // 2
    iteration = 0
    while above > capacity and iteration < 2 * MAX_INTERPOLATIONS:
        guess = low + (high - low) * (float(middle) / float(above))
        if iteration >= MAX_INTERPOLATIONS:
            guess = low + (high - low) * 0.5
        count = keep_near(p, guess, tree, scratch, listing, size, base)
        if count < scratch.k:
            low = guess
        else:
            high = guess
            above = count
        iteration += 1
    return vec2(high if above <= capacity else -1.0, float(above))


@cuda_func
def guess_sqradius(p: vec3, bucket: int, k: int, tree: PointTree) -> float:
    """Squared distance within which k points are expected around each lane's, from a nearby bucket."""
    a = low_of_lanes(p)
    b = high_of_lanes(p)
    at = bucket * SIDES + (lane() & (FAN - 1))
    low = low_of_lanes(vec3(tree.boxes[at], tree.boxes[at + FAN], tree.boxes[at + 2 * FAN]))
    high = high_of_lanes(vec3(tree.boxes[at + 3 * FAN], tree.boxes[at + 4 * FAN], tree.boxes[at + 5 * FAN]))
    x = larger(larger(low[0] - b[0], a[0] - high[0]), 0.0)
    y = larger(larger(low[1] - b[1], a[1] - high[1]), 0.0)
    z = larger(larger(low[2] - b[2], a[2] - high[2]), 0.0)
    near = sqrt(square_distance(low, high) * (PLANE_FRACTION * float(k))) + sqrt(x * x + y * y + z * z)
    return near * near


@cuda_func
def keep_for_lanes(
    p: vec3,
    start: int,
    guess: float,
    tree: PointTree,
    scratch: GroupScratch,
    listing: int,
    base: int,
    max_sqdist: float,
) -> vec3:
    """Store each lane's points within a distance at which all have k, or `max_sqdist`: (distance, leaves, points)."""
    covered = guess
    if guess < 0.0:
        covered = guess_sqradius(p, start, scratch.k, tree)
    covered = min(covered, max_sqdist)
    beyond = float(INFINITY)  # the leaves exceed the room
    listed = 0
    count = 0
    attempt = 0
    while attempt < MAX_ATTEMPTS:
        listed = list_leaves(p, covered, start, tree, scratch, listing)
        attempt += 1
        if listed > scratch.gather:
            beyond = covered
            covered = covered * SQRADIUS_SHRINKAGE
        else:
            count = keep_near(p, covered, tree, scratch, listing, listed, base)
            min_count = min_of_lanes(float(count))
            if min_count >= float(scratch.k) or covered >= max_sqdist or attempt >= MAX_ATTEMPTS:
                attempt = MAX_ATTEMPTS + 1
            else:
                grown = covered * min(SQRADIUS_MARGIN * float(scratch.k) / max(min_count, 1.0), MAX_GROWTH)
                if listed * LEAF >= tree.count:
                    grown = max_sqdist
                covered = min(min(max_sqdist, 0.5 * (covered + beyond)), max(grown, MIN_SQRADIUS))
    return vec3(covered, float(listed), float(count))


@cuda_func
def name_keys(labels: array(dtype=int32), scratch: GroupScratch, base: int, key_count: int):
    for j in range(key_count):
        key = scratch.keys[base + j * scratch.stride]
        scratch.keys[base + j * scratch.stride] = pack_bits(key_bits(key), labels[key_index(key)])


@cuda_func
def search_lanes(
    p: vec3,
    is_query: int,
    start: int,
    guess: float,
    tree: PointTree,
    labels: array(dtype=int32),
    scratch: GroupScratch,
    thread: int,
    max_sqdist: float,
    by_position: int,
) -> vec2i:
    """Store keys of the k nearest points within the squared distance `max_sqdist` of each lane's query, unordered. The
    nearby bucket `start` and first squared distance `guess` are uniform. Returns count and bits of a bounding distance.
    """
    listing = (thread // WARP) * scratch.gather
    result = keep_for_lanes(p, start, guess, tree, scratch, listing, thread, max_sqdist)
    near = result[0]
    listed = int(result[1])
    size = int(result[2])
    if listed > scratch.gather or (size < scratch.k and near < max_sqdist):
        near = -1.0
    if near >= 0.0 and size > scratch.room - LEAF:
        nearer = keep_nearer(p, near, size, tree, scratch, listing, listed, thread)
        near = nearer[0]
        size = int(nearer[1])
    if near < 0.0:
        size = 0
        if is_query == 1:
            size = search_k_nearest(
                p, start, tree, labels, scratch.keys, thread, scratch.stride, scratch.k, scratch.room, max_sqdist
            )
            near = max_sqdist
            if size == scratch.k:
                near = key_number(scratch.keys[thread + (size - 1) * scratch.stride])
    elif by_position == 0:
        name_keys(labels, scratch, thread, size)
    if size > scratch.k:
        limit = limit_nearest(scratch.keys, thread, scratch.stride, size, scratch.k, near)
        size = keep_up_to(scratch.keys, thread, scratch.stride, size, limit)
        near = key_number(limit)
    return vec2i(size, float_bits(near))
