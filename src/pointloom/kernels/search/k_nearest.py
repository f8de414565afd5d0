"""The k nearest points of one query by one thread, as packed keys: by distance, ties by index."""

from ..arrays.packed_keys import key_limit, key_number, pack_key
from ..lang import array, func, int32, int64, vec3
from .bucket_walk import next_bucket_of_point, pass_over_equal, start_traversal
from .neighbor_keys import UNLIMITED_SQRADIUS, keep_nearest, thin_keys
from .point_tree import BUCKET, FAN, LEAF, PointTree, is_one_point, measure_box, measure_boxes, square_distance


@func
def offer_bucket(
    bucket: int,
    p: vec3,
    tree: PointTree,
    labels: array(dtype=int32),
    keys: array(dtype=int64),
    base: int,
    stride: int,
    key_count: int,
    max_sqdist: float,
    limit: int64,
) -> int:
    """Append the keys of a bucket's points up to `limit` and `max_sqdist`, branch-free. Return the count of keys."""
    size = key_count
    distances = measure_boxes(tree.boxes, bucket, p, p)
    for leaf in range(FAN):
        first = bucket * BUCKET + leaf * LEAF
        wanted = 0
        if first < tree.count and distances[leaf] <= max_sqdist:
            wanted = 1
            nearest = pack_key(distances[leaf], labels[first])
            if nearest > limit:
                # Up to the last key: duplicates are ordered by label.
                wanted = 1 - is_one_point(tree.boxes, bucket, leaf)
        if wanted == 1:
            for j in range(first, min(first + LEAF, tree.count)):
                key = pack_key(square_distance(p, tree.points[j]), labels[j])
                keys[base + size * stride] = key
                if key <= limit:
                    size += 1
    return size


@offer_bucket.on_cuda
def offer_leaves_one_by_one(
    bucket: int,
    p: vec3,
    tree: PointTree,
    labels: array(dtype=int32),
    keys: array(dtype=int64),
    base: int,
    stride: int,
    key_count: int,
    max_sqdist: float,
    limit: int64,
) -> int:
    """CUDA variant, one leaf at a time to save registers."""
    size = key_count
    leaves = int(FAN)
    for leaf in range(leaves):
        first = bucket * BUCKET + leaf * LEAF
        wanted = 0
        if first < tree.count:
            sqdist = measure_box(tree.boxes, bucket, leaf, p, p)
            if sqdist <= max_sqdist:
                wanted = 1
                if pack_key(sqdist, labels[first]) > limit:
                    wanted = 1 - is_one_point(tree.boxes, bucket, leaf)
        if wanted == 1:
            for j in range(first, min(first + LEAF, tree.count)):
                key = pack_key(square_distance(p, tree.points[j]), labels[j])
                if key <= limit:
                    keys[base + size * stride] = key
                    size += 1
    return size


@func
def search_k_nearest(
    p: vec3,
    start: int,
    tree: PointTree,
    labels: array(dtype=int32),
    keys: array(dtype=int64),
    base: int,
    stride: int,
    k: int,
    room: int,
    max_sqdist: float,
) -> int:
    """Write the k nearest points within `max_sqdist` as sorted keys from `base` on. Return the count."""
    bound = max_sqdist
    # The last key that may still be a result: of many points at one distance only those of low index.
    limit = key_limit(max_sqdist)
    crowd = min(room - BUCKET, 3 * k + BUCKET)  # selection is quadratic in the number of keys
    size = 0
    step = start_traversal(start)
    while int(step[0]) <= tree.root:
        bucket = int(step[2])
        previous_size = size
        size = offer_bucket(bucket, p, tree, labels, keys, base, stride, size, bound, limit)
        if size == previous_size:
            if is_one_point(tree.boxes, bucket, 0) == 1:
                step = pass_over_equal(step, p, p, limit, tree, labels)
        if size > crowd or (size >= k and bound >= UNLIMITED_SQRADIUS):
            size = keep_nearest(keys, base, stride, size, k, room)
            if size == k:
                limit = min(limit, keys[base + (k - 1) * stride])
                bound = key_number(limit)
        step = next_bucket_of_point(step, p, bound, tree)
    return keep_nearest(keys, base, stride, thin_keys(keys, base, stride, size, k, bound), k, room)


@search_k_nearest.on_cuda
def search_with_one_pick(
    p: vec3,
    start: int,
    tree: PointTree,
    labels: array(dtype=int32),
    keys: array(dtype=int64),
    base: int,
    stride: int,
    k: int,
    room: int,
    max_sqdist: float,
) -> int:
    """CUDA variant with one inlined selection, which takes about 20 KB of instructions."""
    bound = max_sqdist
    limit = key_limit(max_sqdist)
    crowd = min(room - BUCKET, 3 * k + BUCKET)
    size = 0
    is_active = 1
    step = start_traversal(start)
    while is_active == 1:
        if int(step[0]) <= tree.root:
            bucket = int(step[2])
            previous_size = size
            size = offer_bucket(bucket, p, tree, labels, keys, base, stride, size, bound, limit)
            if size == previous_size:
                if is_one_point(tree.boxes, bucket, 0) == 1:
                    step = pass_over_equal(step, p, p, limit, tree, labels)
        else:
            is_active = 0
        if is_active == 0 or size > crowd or (size >= k and bound >= UNLIMITED_SQRADIUS):
            size = keep_nearest(keys, base, stride, size, k, room)
            if size == k:
                limit = min(limit, keys[base + (k - 1) * stride])
                bound = key_number(limit)
        if is_active == 1:
            step = next_bucket_of_point(step, p, bound, tree)
    return size
