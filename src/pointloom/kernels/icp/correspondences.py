"""Nearest target points of all source points across ICP iterations.

A lower bound of the distance to every other target point is kept per match, so a point is searched again only when the
cloud has moved by more than the gap (triangle inequality; Greenspan and Godin 2001). Results equal full searches.
Searches look `margin` beyond the nearest point for a useful bound. Ties go to the first in traversal order. Eight
points (CPU) or a warp's 32 (CUDA) share a traversal.
"""

from ..algebra.plain_min_max import larger, smaller
from ..algebra.rigid_solve import move
from ..algebra.transform import narrow, widen
from ..arrays.lanes import max_of_eight
from ..lang import (
    INFINITY,
    array,
    ballot,
    bits_float,
    cuda_func,
    float32,
    float_bits,
    func,
    int32,
    isfinite,
    kernel,
    load_eight,
    loop,
    mat44d,
    partial,
    shuffle,
    sqrt,
    tid,
    vec3,
    vector,
)
from ..search.bucket_walk import children_within, next_step, start_traversal, traversal
from ..search.lane_boxes import boxes_of_eight, nearby_children, nearby_nodes, two_boxes
from ..search.lane_search import sqdist_of
from ..search.nearest_point import closest_leaf, lane_numbers
from ..search.point_forest import HEIGHTS, PointForest, find_bucket_of, next_bucket_of
from ..search.point_tree import BUCKET, FAN, LEAF, measure_box, square_distance
from ..search.tree_walk import bits_of, lowest_bit
from .jobs import source_position
from .matches import Matches

lane_integers = vector(8, int32)
motion = vector(12, float32)
LARGEST_BITS = 0x7F7F_FFFF  # of the largest float32
NO_LEAF = 0x7FFF_FFFF  # beyond all leaves
COORDINATE_SLACK = 1.0e-6  # of a coordinate: exceeds the rounding of a moved point and its distance


@func
def measure_lanes(
    first: int,
    points: array(dtype=vec3),
    xs: lane_numbers,
    ys: lane_numbers,
    zs: lane_numbers,
    best: lane_integers,
    places: lane_integers,
    second: lane_integers,
) -> tuple[lane_integers, lane_integers, lane_integers]:
    """Update the nearest and second nearest squared distances (bits) and the nearest positions with a leaf's points.
    Padding is at infinity.
    """
    nearest = best
    positions = places
    others = second
    for i in range(first, first + LEAF):
        p = points[i]
        for j in range(LEAF):
            x = p[0] - xs[j]
            y = p[1] - ys[j]
            z = p[2] - zs[j]
            bits = min(float_bits(x * x + y * y + z * z), LARGEST_BITS)
            before = nearest[j]
            position = positions[j]
            closer = 1 if bits < before else 0
            passed = before if position >= 0 else LARGEST_BITS  # the initial bound is not a second nearest
            behind = passed if closer == 1 else bits
            nearest[j] = bits if closer == 1 else before
            positions[j] = i if closer == 1 else position
            others[j] = min(others[j], behind)
    return nearest, positions, others


@func
def lane_limits(best: lane_integers, second: lane_integers, wanted: lane_integers, margin: float) -> lane_numbers:
    """Squared search limit of each lane: a margin beyond its nearest point, not beyond the second."""
    limits = lane_numbers(-1.0)
    for j in range(LEAF):
        nearest = bits_float(best[j])
        radius = sqrt(nearest) + margin
        limit = smaller(larger(radius * radius, nearest), bits_float(second[j]))  # a root rounds down too
        limits[j] = limit if wanted[j] == 1 else -1.0
    return limits


@func
def limit_beside(best: int, second: int, margin: float) -> float:
    nearest = bits_float(best)
    look = sqrt(nearest) + margin
    return smaller(larger(look * look, nearest), bits_float(second))


@func
def largest_lane(values: lane_numbers) -> float:
    """Largest of eight numbers, in pairs: the comparisons of a level are one instruction."""
    a = larger(values[0], values[4])
    b = larger(values[1], values[5])
    c = larger(values[2], values[6])
    d = larger(values[3], values[7])
    return larger(larger(a, c), larger(b, d))


@func
def difference_of(pose: mat44d, before: mat44d) -> motion:
    """Difference of two poses: nine numbers of the matrix, then three of the translation."""
    d = motion(0.0)
    for row in range(3):
        for column in range(3):
            d[3 * row + column] = float(pose[row, column] - before[row, column])
        d[9 + row] = float(pose[row, 3] - before[row, 3])
    return d


@func
def remaining_bound(p: vec3, q: vec3, d: motion, lower: float) -> float:
    """Lower bound of distances from q after the motion d, including rounding."""
    x = d[0] * p[0] + d[1] * p[1] + d[2] * p[2] + d[9]
    y = d[3] * p[0] + d[4] * p[1] + d[5] * p[2] + d[10]
    z = d[6] * p[0] + d[7] * p[1] + d[8] * p[2] + d[11]
    size = larger(larger(abs(q[0]), abs(q[1])), abs(q[2]))
    extent = larger(larger(abs(p[0]), abs(p[1])), abs(p[2]))
    return lower - sqrt(x * x + y * y + z * z) * (1.0 + COORDINATE_SLACK) - COORDINATE_SLACK * (size + extent)


@loop
def leaves_nearer(
    bucket: int, a: vec3, b: vec3, limit: float, target: int, forest: PointForest, seed: int
) -> tuple[int, int]:
    """Leaves (bucket record, leaf) but `seed` within the squared `limit` of the box (a, b). It may shrink."""
    root = forest.roots[target]
    first_bucket = forest.levels[target * HEIGHTS]
    step = start_traversal(bucket)
    while int(step[0]) <= root:
        record = first_bucket + int(step[2])
        near = children_within(forest.boxes, record, a, b, limit)
        if record == seed // FAN:
            near = near & ~(1 << (seed % FAN))
        for leaf in bits_of(near):
            yield record, leaf
        step = next_bucket_of(step, a, b, limit, target, forest)


@func
def search_lanes(
    known: int,
    target: int,
    a: vec3,
    b: vec3,
    xs: lane_numbers,
    ys: lane_numbers,
    zs: lane_numbers,
    wanted: lane_integers,
    margin: float,
    initial: lane_integers,
    forest: PointForest,
) -> tuple[lane_integers, lane_numbers]:
    """Nearest positions and limits of lanes in the box (a, b) after one traversal of their target's tree, from position
    `known` if >= 0.
    """
    first = forest.levels[target * HEIGHTS]  # first bucket of the tree
    bucket = known // BUCKET - first
    if known < 0:
        bucket = find_bucket_of(a, target, forest)
    seed = known // LEAF
    if known < 0:
        seed = closest_leaf(first + bucket, a, b, forest.boxes)  # its points bound the search from the start
    best, places, second = measure_lanes(
        seed * LEAF, forest.clouds.points, xs, ys, zs, initial, lane_integers(-1), lane_integers(LARGEST_BITS)
    )
    limits = lane_limits(best, second, wanted, margin)
    bound_all = largest_lane(limits)
    for record, leaf in leaves_nearer(bucket, a, b, bound_all, target, forest, seed):
        start = record * BUCKET + leaf * LEAF
        best, places, second = measure_lanes(start, forest.clouds.points, xs, ys, zs, best, places, second)
        limits = lane_limits(best, second, wanted, margin)
        bound_all = largest_lane(limits)
    return places, limits


@kernel(for_cpu=True)
def match_groups_kernel(matches: Matches, forest: PointForest):
    """Nearest target point of LEAF source points whose previous match is not certain."""
    i = tid()
    job = matches.jobs.group_jobs[i]
    if matches.live[job] != 0:
        head = i * LEAF
        start = source_position(head, matches.jobs)
        pose = matches.poses[job]
        change = difference_of(pose, matches.earlier[job])
        xs = lane_numbers(0.0)
        ys = lane_numbers(0.0)
        zs = lane_numbers(0.0)
        wanted = lane_integers(0)
        best = lane_integers(LARGEST_BITS)
        none = float_bits(matches.max_sqdist) + 1
        count = 0
        known = -1
        a = vec3(INFINITY, INFINITY, INFINITY)
        b = vec3(-INFINITY, -INFINITY, -INFINITY)
        for j in range(LEAF):
            p = matches.jobs.sources.points[start + j]
            pair = -1
            if isfinite(p):
                q = narrow(move(pose, widen(p)))
                lower = remaining_bound(p, q, change, matches.lowers[head + j])
                matches.lowers[head + j] = lower
                position = matches.nearest[head + j]
                bound = none
                distance = sqrt(matches.max_sqdist)
                if position >= 0:
                    known = position
                    square = square_distance(q, forest.clouds.points[position])
                    distance = sqrt(square)
                    bound = min(none, float_bits(square) + 1)
                    if square <= matches.max_sqdist:
                        pair = position
                if distance * (1.0 + COORDINATE_SLACK) >= lower and isfinite(q):
                    wanted[j] = 1
                    xs[j] = q[0]
                    ys[j] = q[1]
                    zs[j] = q[2]
                    best[j] = bound
                    a = vec3(min(a[0], q[0]), min(a[1], q[1]), min(a[2], q[2]))
                    b = vec3(max(b[0], q[0]), max(b[1], q[1]), max(b[2], q[2]))
                    count += 1
            matches.pairs[head + j] = pair
        if count > 0:
            target = matches.jobs.job_targets[job]
            margin = matches.margins[job]
            places, limits = search_lanes(known, target, a, b, xs, ys, zs, wanted, margin, best, forest)
            for j in range(LEAF):
                if wanted[j] == 1:
                    matches.nearest[head + j] = places[j]
                    matches.pairs[head + j] = places[j]
                    matches.lowers[head + j] = sqrt(limits[j])


@kernel(max_registers=128)  # for two blocks per SM
def match_points_kernel(matches: Matches, forest: PointForest):
    """Nearest target point of one source point whose previous match is not certain."""
    i = tid()
    job = matches.jobs.group_jobs[i // LEAF]
    if matches.live[job] != 0:
        p = matches.jobs.sources.points[source_position(i, matches.jobs)]
        pair = -1
        q = narrow(move(matches.poses[job], widen(p)))
        if isfinite(p) and isfinite(q):
            lower = remaining_bound(p, q, difference_of(matches.poses[job], matches.earlier[job]), matches.lowers[i])
            position = matches.nearest[i]
            distance = sqrt(matches.max_sqdist)
            best = float_bits(matches.max_sqdist) + 1
            if position >= 0:
                square = square_distance(q, forest.clouds.points[position])
                distance = sqrt(square)
                best = min(best, float_bits(square) + 1)
                if square <= matches.max_sqdist:
                    pair = position
            if distance * (1.0 + COORDINATE_SLACK) >= lower:
                target = matches.jobs.job_targets[job]
                bucket = position // BUCKET - forest.levels[target * HEIGHTS]
                if position < 0:
                    bucket = find_bucket_of(q, target, forest)
                pair = -1
                second = int(LARGEST_BITS)
                margin = matches.margins[job]
                limit = limit_beside(best, second, margin)
                for record, leaf in leaves_nearer(bucket, q, q, limit, target, forest, NO_LEAF):
                    for j in range(record * BUCKET + leaf * LEAF, record * BUCKET + (leaf + 1) * LEAF):
                        bits = min(float_bits(square_distance(q, forest.clouds.points[j])), LARGEST_BITS)
                        if bits < best:
                            if pair >= 0:
                                second = min(second, best)
                            best = bits
                            pair = j
                        else:
                            second = min(second, bits)
                    limit = limit_beside(best, second, margin)
                matches.nearest[i] = pair
                lower = sqrt(limit)
            matches.lowers[i] = lower
        matches.pairs[i] = pair


@cuda_func
def next_bucket_of_lanes(
    step: traversal, around: two_boxes, bound: float, target: int, forest: PointForest
) -> traversal:
    nodes = target * HEIGHTS
    return next_step(
        step, forest.roots[target], partial(nearby_nodes, forest.levels, nodes, forest.boxes, around, bound)
    )


@match_points_kernel.on_cuda
def match_lanes_kernel(matches: Matches, forest: PointForest):
    """CUDA variant: points of a warp with the same target share a traversal."""
    i = tid()
    row = min(i, matches.pairs.shape[0] - 1)
    job = matches.jobs.group_jobs[row // LEAF]
    is_live = 1 if i == row and matches.live[job] != 0 else 0
    target = matches.jobs.job_targets[job]
    margin = matches.margins[job]
    p = matches.jobs.sources.points[source_position(row, matches.jobs)]
    q = narrow(move(matches.poses[job], widen(p)))
    is_point = 1 if is_live == 1 and isfinite(p) and isfinite(q) else 0
    lower = 0.0
    position = -1
    pair = -1
    best = float_bits(matches.max_sqdist) + 1
    second = int(LARGEST_BITS)
    is_searching = 0
    bucket = 0
    if is_point == 1:
        position = matches.nearest[row]
        lower = remaining_bound(p, q, difference_of(matches.poses[job], matches.earlier[job]), matches.lowers[row])
        distance = sqrt(matches.max_sqdist)
        if position >= 0:
            square = square_distance(q, forest.clouds.points[position])
            distance = sqrt(square)
            best = min(best, float_bits(square) + 1)
            if square <= matches.max_sqdist:
                pair = position
        if distance * (1.0 + COORDINATE_SLACK) >= lower:
            is_searching = 1
            pair = -1
            bucket = position // BUCKET - forest.levels[target * HEIGHTS]
            if position < 0:
                bucket = find_bucket_of(q, target, forest)
    searching = ballot(is_searching)
    while searching != 0:
        leader = lowest_bit(searching)
        shared = shuffle(target, leader)
        limit = -1.0
        is_shared = 1 if is_searching == 1 and target == shared else 0
        if is_shared == 1:
            limit = limit_beside(best, second, margin)
        searching = searching ^ ballot(is_shared)
        around = boxes_of_eight(q, is_shared)
        widest = max_of_eight(limit)
        first_bucket = forest.levels[shared * HEIGHTS]
        step = start_traversal(shuffle(bucket, leader))
        while int(step[0]) <= forest.roots[shared]:
            record = first_bucket + int(step[2])
            near = nearby_children(forest.boxes, record, around, widest)
            for child in bits_of(near):
                if ballot(1 if measure_box(forest.boxes, record, child, q, q) < limit else 0) != 0:
                    first = record * BUCKET + child * LEAF
                    leaf = load_eight(forest.clouds.points, first)
                    if is_shared == 1:
                        for j in range(LEAF):
                            bits = min(float_bits(sqdist_of(leaf, j, q)), LARGEST_BITS)
                            if bits < best:
                                if pair >= 0:
                                    second = min(second, best)
                                best = bits
                                pair = first + j
                            else:
                                second = min(second, bits)
                        limit = limit_beside(best, second, margin)
            widest = max_of_eight(limit)
            step = next_bucket_of_lanes(step, around, widest, shared, forest)
        if is_shared == 1:
            matches.nearest[row] = pair
            lower = sqrt(limit)
    if is_live == 1:
        if is_point == 1:
            matches.lowers[row] = lower
        matches.pairs[row] = pair
