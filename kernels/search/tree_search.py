"""Neighbours of queries in a PointTree: the k nearest within a radius, or all within it.

A thread takes a run of queries that follow each other on the curve. Its scratch row then stays in the nearest cache,
and each query starts with the ball of the query before it. Output 8 B a neighbour and 4 B a query.
"""

import math

import numpy as np

from ..arrays.prefix_sum import exclusive_scan
from ..arrays.sort import argsort_keys
from ..lang import INFINITY, array, bits_float, float32, float_bits, int32, int64, isfinite, kernel, launch, tid, vec3
from ..memory import empty
from .group_search import (
    GUESS,
    GroupScratch,
    gather_candidates,
    grown_reach,
    search_member,
)
from .hilbert_order import encode_points, locate_on_curve
from .neighbor_keys import sort_keys
from .point_tree import (
    FAN,
    FAR,
    INDEX_MASK,
    LEAF,
    PointTree,
    find_bucket,
    points_in_reach,
    square_distance,
)

MAX_ROWS = 2**31 - 1  # arrays of one launch hold fewer elements than this


@kernel
def search_nearest_kernel(
    queries: array(dtype=vec3),
    query_order: array(dtype=int32),
    query_count: int,
    first: int,
    last: int,
    run: int,
    self_query: int,
    codes: array(dtype=int64),
    curve_low: vec3,
    curve_scale: float,
    curve_levels: int,
    tree: PointTree,
    order: array(dtype=int32),
    scratch: GroupScratch,
    reach: float,
    indices: array(dtype=int32),
    distances: array(dtype=float32),
    counts: array(dtype=int32),
):
    """Rows of neighbours by distance, ties by index; missing ones are -1 at distance 0."""
    i = tid()
    base = i * (scratch.room + scratch.k)
    listing = i * scratch.gather
    before = vec3(0.0, 0.0, 0.0)
    bound = float(INFINITY)
    widest = float(INFINITY)
    for group in range(first + i * run, min(first + (i + 1) * run, last)):
        head = group * LEAF
        tail = min((group + 1) * LEAF, query_count)
        a = queries[query_order[head]]
        b = a + vec3(0.0, 0.0, 0.0)
        for rank in range(head + 1, tail):
            q = queries[query_order[rank]]
            if isfinite(q):  # the others stand last and search nothing
                a = vec3(min(a[0], q[0]), min(a[1], q[1]), min(a[2], q[2]))
                b = vec3(max(b[0], q[0]), max(b[1], q[1]), max(b[2], q[2]))
        start = group // FAN
        gathered = scratch.gather + 1
        covered = min(reach, widest * GUESS)
        widest = float(0.0)
        if tree.count > 0 and isfinite(a):  # else no query of the group is finite
            if self_query == 0:
                start = find_bucket(codes, tree.count, locate_on_curve(a, curve_low, curve_scale, curve_levels))
            if scratch.gather > 0 and covered < FAR:
                gathered = gather_candidates(a, b, start, covered, tree, order, scratch, listing)
        for rank in range(head, tail):
            row = query_order[rank]
            p = queries[row]
            out = row * scratch.k
            size = int(0)
            if tree.count > 0 and isfinite(p):
                near = min(reach, grown_reach(bound, square_distance(before, p)))
                size = search_member(
                    p, start, gathered, covered, tree, order, scratch, listing, base, near, 1,
                )  # fmt: skip
                for j in range(size):
                    key = scratch.keys[base + j]
                    indices[out + j] = int(key & int64(INDEX_MASK))
                    distances[out + j] = bits_float(int(key >> int64(32)))
                before = p
                bound = float(INFINITY)
                if size == scratch.k:
                    bound = bits_float(int(scratch.keys[base + scratch.k - 1] >> int64(32)))
                widest = max(widest, bound)
            for j in range(size, scratch.k):
                indices[out + j] = -1
                distances[out + j] = 0.0
            counts[row] = size


@kernel
def count_within_kernel(
    queries: array(dtype=vec3),
    query_order: array(dtype=int32),
    codes: array(dtype=int64),
    curve_low: vec3,
    curve_scale: float,
    curve_levels: int,
    tree: PointTree,
    reach: float,
    counts: array(dtype=int32),
):
    """How many points lie within the squared radius of each query."""
    i = tid()
    q = query_order[i]
    p = queries[q]
    found = int(0)
    if tree.count > 0 and isfinite(p):
        for j in points_in_reach(
            find_bucket(codes, tree.count, locate_on_curve(p, curve_low, curve_scale, curve_levels)), p, reach, tree
        ):
            if square_distance(p, tree.points[j]) <= reach:
                found += 1
    counts[q] = found


@kernel
def list_within_kernel(
    queries: array(dtype=vec3),
    query_order: array(dtype=int32),
    codes: array(dtype=int64),
    curve_low: vec3,
    curve_scale: float,
    curve_levels: int,
    tree: PointTree,
    order: array(dtype=int32),
    reach: float,
    offsets: array(dtype=int32),
    keys: array(dtype=int64),
    indices: array(dtype=int32),
    sqdists: array(dtype=float32),
):
    """The points within the squared radius of each query, sorted."""
    i = tid()
    q = query_order[i]
    p = queries[q]
    base = offsets[q]
    size = int(0)
    if tree.count > 0 and isfinite(p):
        for j in points_in_reach(
            find_bucket(codes, tree.count, locate_on_curve(p, curve_low, curve_scale, curve_levels)), p, reach, tree
        ):
            d = square_distance(p, tree.points[j])
            if d <= reach:
                keys[base + size] = (int64(float_bits(d)) << int64(32)) | int64(order[j])
                size += 1
    size = sort_keys(keys, base, size)
    for j in range(base, base + size):
        indices[j] = int(keys[j] & int64(INDEX_MASK))
        sqdists[j] = bits_float(int(keys[j] >> int64(32)))


def reach_of(radius):
    """The largest float32 below radius^2: Open3D counts a neighbour when d^2 < r^2."""
    if math.isinf(radius):
        return INFINITY
    exact = float(radius) * float(radius)
    square = np.float32(min(exact, 3.4e38))
    return float(square) if float(square) < exact else float(np.nextafter(square, np.float32(0)))


def order_along_curve(tree, queries):
    """The queries' order along the tree's curve, int32 [n]."""
    _, low, scale, levels = tree.curve_arguments
    return argsort_keys(encode_points(queries, low, scale, levels), 3 * levels + 1)[1]


def search_nearest(tree, queries, k, radius=INFINITY):
    """The k nearest neighbours of each query closer than a radius.

    Args:
        tree: A PointTree.
        queries: Device array of vec3, shape [m]; the tree's own points are known by their address.
        k: Neighbours a query.
        radius: Upper limit of the distance [m], excluded.

    Returns:
        (indices, sqdists, counts): int32 [m, k], float32 [m, k], int32 [m]; -1 and 0 where there are fewer than k.
    """
    device, total = queries.device, queries.size
    indices, sqdists = empty((total, k), int32, device), empty((total, k), float32, device)
    counts = empty(total, int32, device)
    step = max(1, MAX_ROWS // k)
    is_self = tree.source.ptr == queries.ptr and tree.source.size == total and total <= step
    for begin in range(0, total, step):
        end = min(total, begin + step)
        part = queries[begin:end]
        order = tree.order if is_self else order_along_curve(tree, part)
        outputs = [indices[begin:end].flatten(), sqdists[begin:end].flatten(), counts[begin:end]]
        scratch = GroupScratch(device, end - begin, k, reach_of(radius))
        common = [int(is_self), *tree.curve_arguments, tree, tree.order, scratch]
        for first, last, threads, run in scratch.parts():
            search = [part, order, end - begin, first, last, run, *common, reach_of(radius), *outputs]
            launch(search_nearest_kernel, threads, search)
    return indices, sqdists, counts


def search_within(tree, queries, radius):
    """All neighbours of each query closer than a radius, by distance.

    Returns:
        (indices, sqdists, offsets): int32 [total], float32 [total], int32 [m + 1]; row q is offsets[q]:offsets[q + 1].

    Raises:
        ValueError: 2^31 neighbours or more.
    """
    device, total, reach = queries.device, queries.size, reach_of(radius)
    order = order_along_curve(tree, queries)
    counts = empty(total, int32, device)
    common = [queries, order, *tree.curve_arguments, tree]
    launch(count_within_kernel, total, [*common, reach, counts])
    offsets, found = exclusive_scan(counts)
    keys, indices, sqdists = empty(found, int64, device), empty(found, int32, device), empty(found, float32, device)
    launch(list_within_kernel, total, [*common, tree.order, reach, offsets, keys, indices, sqdists])
    return indices, sqdists, offsets
