"""Stackless PointTree traversal from bucket to bucket, with one byte of pending children per level."""

from ..arrays.packed_keys import BYTE_MASK, pack_key
from ..lang import array, bit_count, callback, cuda_func, float32, func, int32, int64, loop, partial, vec3, vector
from .point_tree import BUCKET, FAN, LEAF, PointTree, is_one_point, measure_box, measure_boxes, square_distance

traversal = vector(4, int64)  # height, level, node, and pending children, one byte per level


@func
def children_within(boxes: array(dtype=float32), node: int, a: vec3, b: vec3, bound: float) -> int:
    """Bit mask of the child boxes within the squared distance `bound` of the box (a, b)."""
    distances = measure_boxes(boxes, node, a, b)
    bits = 0
    for j in range(FAN):
        if distances[j] <= bound:
            bits = bits | (1 << j)
    return bits


@cuda_func
def children_one_by_one(
    levels: array(dtype=int32), boxes: array(dtype=float32), p: vec3, bound: float, level: int, node: int
) -> int:
    """`level_children_within` of a point, one box at a time: fewer registers, for rare traversals."""
    bits = 0
    children = int(FAN)
    for j in range(children):
        if measure_box(boxes, levels[level] + node, j, p, p) <= bound:
            bits = bits | (1 << j)
    return bits


@func
def byte_shift(level: int) -> int64:
    """Shift of a level's byte in the pending mask; buckets (level 0) need none."""
    return int64(FAN * max(level - 1, 0))


@func
def start_traversal(bucket: int) -> traversal:
    return traversal(0, 0, int64(bucket), 0)


@func
def next_step(step: traversal, root: int, children: callback) -> traversal:
    """Advance to the next bucket step[2], or to a height above `root`; `children(level, node)` may shrink."""
    height = int(step[0])
    level = int(step[1])
    node = int(step[2])
    pending = step[3]
    if level == 0 and height > 0:
        level = 1
        node = node // FAN
    searching = 1
    while searching == 1:
        left = int(pending >> byte_shift(level)) & BYTE_MASK
        if left != 0:
            lowest = left & (-left)
            pending = pending ^ (int64(lowest) << byte_shift(level))
            node = node * FAN + bit_count(lowest - 1)
            level = level - 1
            if level == 0:
                searching = 0
            else:
                inside = children(level, node)
                pending = pending | (int64(inside) << byte_shift(level))
        else:
            if level == height:
                height = height + 1
                if height > root:
                    searching = 0
                else:
                    own = 1 << (node % FAN)
                    node = node // FAN
                    level = level + 1
                    others = children(level, node) & (BYTE_MASK - own)
                    pending = pending | (int64(others) << byte_shift(level))
            else:
                node = node // FAN
                level = level + 1
    return traversal(int64(height), int64(level), int64(node), pending)


@func
def level_children_within(
    levels: array(dtype=int32),
    first: int,
    boxes: array(dtype=float32),
    a: vec3,
    b: vec3,
    bound: float,
    level: int,
    node: int,
) -> int:
    """`children_within` for a node given by its level. The levels of its tree start at `first`."""
    return children_within(boxes, levels[first + level] + node, a, b, bound)


@func
def next_bucket(step: traversal, a: vec3, b: vec3, bound: float, tree: PointTree) -> traversal:
    """Advance to the next bucket within the squared distance `bound` of the box (a, b)."""
    return next_step(step, tree.root, partial(level_children_within, tree.levels, 0, tree.boxes, a, b, bound))


@func
def next_bucket_of_point(step: traversal, p: vec3, bound: float, tree: PointTree) -> traversal:
    return next_bucket(step, p, p, bound, tree)


@next_bucket_of_point.on_cuda
def next_bucket_one_by_one(step: traversal, p: vec3, bound: float, tree: PointTree) -> traversal:
    return next_step(step, tree.root, partial(children_one_by_one, tree.levels, tree.boxes, p, bound))


@loop
def leaves_within(start: int, a: vec3, b: vec3, max_sqdist: float, tree: PointTree) -> int:
    """First positions of the leaves within the squared distance `max_sqdist` of a box, starting at a bucket."""
    step = start_traversal(start)
    while int(step[0]) <= tree.root:
        bucket = int(step[2])
        distances = measure_boxes(tree.boxes, bucket, a, b)
        for leaf in range(FAN):
            if distances[leaf] <= max_sqdist:
                first = bucket * BUCKET + leaf * LEAF
                yield first
        step = next_bucket(step, a, b, max_sqdist, tree)


@loop
def points_within(start: int, p: vec3, max_sqdist: float, tree: PointTree) -> tuple[int, float]:
    """Positions and squared distances [m^2] of the points within `max_sqdist` [m^2], starting at a bucket."""
    for first in leaves_within(start, p, p, max_sqdist, tree):
        for j in range(first, min(first + LEAF, tree.count)):
            sqdist = square_distance(p, tree.points[j])
            if sqdist <= max_sqdist:
                yield j, sqdist


@func
def pass_over_equal(
    step: traversal, a: vec3, b: vec3, limit: int64, tree: PointTree, labels: array(dtype=int32)
) -> traversal:
    """Skip nodes whose points all coincide and have keys beyond the limit; avoids O(n^2) for n duplicates."""
    pending = step[3]
    node = int(step[2])
    buckets = 1  # buckets per child
    for above in range(int(step[0])):
        node = node // FAN
        left = int(pending >> byte_shift(above + 1)) & BYTE_MASK
        if left != 0:
            record = tree.levels[above + 1] + node
            distances = measure_boxes(tree.boxes, record, a, b)
            for j in range(FAN):
                if ((left >> j) & 1) == 1:
                    first = (node * FAN + j) * buckets * BUCKET
                    if is_one_point(tree.boxes, record, j) == 1 and first < labels.shape[0]:
                        # equal points are ordered by index, so the first has the smallest key
                        if pack_key(distances[j], labels[first]) > limit:
                            pending = pending ^ (int64(1 << j) << byte_shift(above + 1))
        buckets = buckets * FAN
    return traversal(step[0], step[1], step[2], pending)


@pass_over_equal.on_cuda
def pass_over_equal_one_by_one(
    step: traversal, a: vec3, b: vec3, limit: int64, tree: PointTree, labels: array(dtype=int32)
) -> traversal:
    pending = step[3]
    node = int(step[2])
    buckets = 1
    children = int(FAN)
    for above in range(int(step[0])):
        node = node // FAN
        left = int(pending >> byte_shift(above + 1)) & BYTE_MASK
        record = tree.levels[above + 1] + node
        for j in range(children):
            if ((left >> j) & 1) == 1:
                first = (node * FAN + j) * buckets * BUCKET
                if is_one_point(tree.boxes, record, j) == 1 and first < labels.shape[0]:
                    if pack_key(measure_box(tree.boxes, record, j, a, b), labels[first]) > limit:
                        pending = pending ^ (int64(1 << j) << byte_shift(above + 1))
        buckets = buckets * FAN
    return traversal(step[0], step[1], step[2], pending)
