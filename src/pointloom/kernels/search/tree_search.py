"""Neighbors of queries in a PointTree: the k nearest within a radius, or all. A thread takes consecutive queries on the
curve, so scratch stays cached and each starts with the previous radius.
"""

import numpy as np

from ..array_types import Array2, Indices, Integers, Points, Scalars
from ..arrays.lanes import max_of_lanes
from ..arrays.packed_keys import key_index, key_number, pack_key
from ..arrays.prefix_sum import exclusive_scan
from ..arrays.sort import positions
from ..lang import (
    INFINITY,
    WARP,
    array,
    ballot,
    bits_float,
    float32,
    func,
    int32,
    int64,
    isfinite,
    kernel,
    lane,
    launch,
    tid,
    vec3,
)
from ..memory import download, empty, flat, rows_of
from .bucket_walk import points_within
from .group_scratch import GroupScratch, LaunchPart
from .group_search import SQDIST_GROWTH, gather_candidates, grown_sqradius, is_repeated, search_member
from .hilbert_order import is_few, order_queries
from .lane_boxes import point_of_lane
from .lane_search import search_lanes
from .neighbor_keys import UNLIMITED_SQRADIUS, sort_keys
from .point_tree import BUCKET, FAN, LARGEST_SQDIST, LEAF, PointTree, find_bucket, square_distance
from .tree_walk import lowest_bit

COUNTED_NEIGHBORS = 64  # neighbors of each of few queries that the count keeps, so that there is one traversal
SAMPLE_POINTS = 64  # points used to estimate the number of neighbors
MAX_ROWS = 2**31 - 1  # element limit of arrays in a launch


@func
def write_row(
    row: int,
    size: int,
    base: int,
    stride: int,
    scratch: GroupScratch,
    indices: array(dtype=int32),
    distances: array(dtype=float32),
    counts: array(dtype=int32),
):
    """Write a query's sorted keys as its row. Missing neighbors are -1 at infinite distance."""
    first = row * scratch.k
    for j in range(size):
        key = scratch.keys[base + j * stride]
        indices[first + j] = key_index(key)
        distances[first + j] = key_number(key)
    for j in range(size, scratch.k):
        indices[first + j] = -1
        distances[first + j] = INFINITY
    counts[row] = size


@kernel(max_registers=80)
def search_nearest_kernel(
    queries: array(dtype=vec3),
    query_order: array(dtype=int32),
    query_count: int,
    part: LaunchPart,
    self_query: int,
    tree: PointTree,
    scratch: GroupScratch,
    max_sqdist: float,
    indices: array(dtype=int32),
    distances: array(dtype=float32),
    counts: array(dtype=int32),
):
    i = tid()
    base = i * (scratch.room + scratch.k)
    listing = i * scratch.gather
    before = vec3(0.0, 0.0, 0.0)
    bound = float(INFINITY)
    widest = float(INFINITY)
    for group in range(part.first + i * part.run, min(part.first + (i + 1) * part.run, part.last)):
        head = group * LEAF
        tail = min((group + 1) * LEAF, query_count)
        a = queries[query_order[head]]
        b = a + vec3(0.0, 0.0, 0.0)
        for rank in range(head + 1, tail):
            q = queries[query_order[rank]]
            if isfinite(q):  # non-finite queries are last and search nothing
                a = vec3(min(a[0], q[0]), min(a[1], q[1]), min(a[2], q[2]))
                b = vec3(max(b[0], q[0]), max(b[1], q[1]), max(b[2], q[2]))
        start = group // FAN
        gathered = scratch.gather + 1
        covered = min(max_sqdist, widest * SQDIST_GROWTH)
        widest = 0.0
        if tree.count > 0 and isfinite(a):  # otherwise no query of the group is finite
            if self_query == 0:
                start = find_bucket(a, tree)
            if scratch.gather > 0 and covered < UNLIMITED_SQRADIUS:
                gathered = gather_candidates(a, b, start, covered, tree, tree.order, scratch, listing)
        for rank in range(head, tail):
            row = query_order[rank]
            p = queries[row]
            size = 0
            if tree.count > 0 and isfinite(p):
                if is_repeated(p, before, bound) == 1:
                    size = scratch.k
                else:
                    near = min(max_sqdist, grown_sqradius(bound, square_distance(before, p)))
                    size = search_member(p, start, gathered, covered, tree, tree.order, scratch, listing, base, near, 1)
                    before = p
                    bound = float(INFINITY)
                    if size == scratch.k:
                        bound = key_number(scratch.keys[base + scratch.k - 1])
                widest = max(widest, bound)
            write_row(row, size, base, 1, scratch, indices, distances, counts)


@search_nearest_kernel.on_cuda
def search_nearest_of_lanes_kernel(
    queries: array(dtype=vec3),
    query_order: array(dtype=int32),
    query_count: int,
    part: LaunchPart,
    self_query: int,
    tree: PointTree,
    scratch: GroupScratch,
    max_sqdist: float,
    indices: array(dtype=int32),
    distances: array(dtype=float32),
    counts: array(dtype=int32),
):
    i = tid()
    guess = -1.0
    first = part.first + (i // WARP) * part.run
    for group in range(first, min(first + part.run, part.last)):
        row = query_order[min(group * WARP + lane(), query_count - 1)]
        p = queries[row]
        is_row = 1 if group * WARP + lane() < query_count else 0
        is_query = 1 if isfinite(p) and is_row == 1 else 0
        query_lanes = ballot(is_query)
        size = 0
        if query_lanes != 0 and tree.count > 0:
            leader = point_of_lane(p, lowest_bit(query_lanes))
            if is_query == 0:
                p = leader
            start = group * WARP // BUCKET
            if self_query == 0:
                start = find_bucket(leader, tree)
            result = search_lanes(p, is_query, start, guess, tree, tree.order, scratch, i, max_sqdist, 0)
            guess = max_of_lanes(bits_float(result[1])) * SQDIST_GROWTH
            size = result[0] * is_query
            sort_keys(scratch.keys, i, scratch.stride, size)
        if is_row == 1:
            write_row(row, size, i, scratch.stride, scratch, indices, distances, counts)


@kernel
def count_within_kernel(
    queries: array(dtype=vec3),
    query_order: array(dtype=int32),
    tree: PointTree,
    max_sqdist: float,
    counts: array(dtype=int32),
):
    i = tid()
    q = query_order[i]
    p = queries[q]
    count = 0
    if tree.count > 0 and isfinite(p):
        for j, sqdist in points_within(find_bucket(p, tree), p, max_sqdist, tree):
            count += 1
    counts[q] = count


@kernel
def list_within_kernel(
    queries: array(dtype=vec3),
    query_order: array(dtype=int32),
    tree: PointTree,
    max_sqdist: float,
    offsets: array(dtype=int32),
    keys: array(dtype=int64),
    indices: array(dtype=int32),
    sqdists: array(dtype=float32),
):
    i = tid()
    q = query_order[i]
    p = queries[q]
    base = offsets[q]
    size = 0
    if tree.count > 0 and isfinite(p):
        for j, sqdist in points_within(find_bucket(p, tree), p, max_sqdist, tree):
            keys[base + size] = pack_key(sqdist, tree.order[j])
            size += 1
    sort_keys(keys, base, 1, size)
    for j in range(base, base + size):
        indices[j] = key_index(keys[j])
        sqdists[j] = key_number(keys[j])


@kernel(for_cpu=True)
def keep_within_kernel(
    queries: array(dtype=vec3),
    query_order: array(dtype=int32),
    tree: PointTree,
    max_sqdist: float,
    counts: array(dtype=int32),
    kept: array(dtype=int64),
):
    """Count as `count_within_kernel`, and keep the keys of up to COUNTED_NEIGHBORS neighbors of each query."""
    i = tid()
    q = query_order[i]
    p = queries[q]
    count = 0
    if tree.count > 0 and isfinite(p):
        for j, sqdist in points_within(find_bucket(p, tree), p, max_sqdist, tree):
            kept[q * COUNTED_NEIGHBORS + min(count, COUNTED_NEIGHBORS - 1)] = pack_key(sqdist, tree.order[j])
            count += 1
    counts[q] = count


@kernel(for_cpu=True)
def list_kept_kernel(
    offsets: array(dtype=int32),
    counts: array(dtype=int32),
    kept: array(dtype=int64),
    indices: array(dtype=int32),
    sqdists: array(dtype=float32),
):
    i = tid()
    sort_keys(kept, i * COUNTED_NEIGHBORS, 1, counts[i])
    for j in range(counts[i]):
        indices[offsets[i] + j] = key_index(kept[i * COUNTED_NEIGHBORS + j])
        sqdists[offsets[i] + j] = key_number(kept[i * COUNTED_NEIGHBORS + j])


def squared_radius(radius: float) -> float:
    """Largest float32 below radius^2, finite, since Open3D counts neighbors with d^2 < r^2."""
    exact = float(radius) * float(radius)
    square = np.float32(min(exact, LARGEST_SQDIST))
    return float(square) if float(square) < exact else float(np.nextafter(square, np.float32(0)))


def order_along_curve(tree: PointTree, queries: Points) -> Indices:
    return order_queries(queries, tree.curve)


def search_nearest(
    tree: PointTree, queries: Points, k: int, radius: float = INFINITY
) -> tuple[Array2[int32], Array2[float32], Integers]:
    """(indices, sqdists, counts) of the k nearest neighbors closer than a radius [m], padded with -1 and infinity. The
    tree's own points as queries are recognized by address.
    """
    device, total = queries.device, queries.size
    indices, sqdists = empty((total, k), int32, device), empty((total, k), float32, device)
    counts = empty(total, int32, device)
    step = max(1, MAX_ROWS // k)
    is_self = tree.source.ptr == queries.ptr and tree.source.size == total and total <= step
    for begin in range(0, total, step):
        end = min(total, begin + step)
        arrays = [queries, indices, sqdists, counts]
        rows, *outputs = arrays if end - begin == total else [rows_of(a, begin, end) for a in arrays]
        order = tree.order if is_self else order_along_curve(tree, rows)
        scratch = GroupScratch(device, end - begin, k)
        for part in scratch.parts():
            search = [rows, order, end - begin, part, int(is_self), tree, scratch, squared_radius(radius)]
            search += [flat(output) for output in outputs]
            launch(search_nearest_kernel, part.threads, search)
    return indices, sqdists, counts


def search_within(tree: PointTree, queries: Points, radius: float) -> tuple[Integers, Scalars, Integers]:
    """(indices, sqdists, offsets) of all neighbors closer than a radius [m]. Raises ValueError for 2^31 or more."""
    device, total, max_sqdist = queries.device, queries.size, squared_radius(radius)
    order = order_along_curve(tree, queries)
    counts = empty(total, int32, device)
    common = [queries, order, tree]
    kept = empty(total * COUNTED_NEIGHBORS, int64, device) if is_few(queries) else None
    if kept is None:
        launch(count_within_kernel, total, [*common, max_sqdist, counts])
    else:
        launch(keep_within_kernel, total, [*common, max_sqdist, counts, kept])
    offsets, neighbor_count = exclusive_scan(counts, largest=tree.count)  # sync
    indices, sqdists = empty(neighbor_count, int32, device), empty(neighbor_count, float32, device)
    if kept is not None and download(counts).max() <= COUNTED_NEIGHBORS:
        launch(list_kept_kernel, total, [offsets, counts, kept, indices, sqdists])
        return indices, sqdists, offsets
    keys = empty(neighbor_count, int64, device)
    launch(list_within_kernel, total, [*common, max_sqdist, offsets, keys, indices, sqdists])
    return indices, sqdists, offsets


@kernel
def sample_points_kernel(points: array(dtype=vec3), indices: array(dtype=int32), step: int, sample: array(dtype=vec3)):
    i = tid()
    sample[i] = points[indices[i * step]]


def count_around(tree: PointTree, indices: Indices, radius: float) -> float:
    """Mean number of points within a radius [m] of at most SAMPLE_POINTS of some points of a tree."""
    step = -(-indices.size // SAMPLE_POINTS)
    size = -(-indices.size // step)
    sample, counts = empty(size, vec3, tree.device), empty(size, int32, tree.device)
    launch(sample_points_kernel, size, [tree.points, indices, step, sample])
    launch(count_within_kernel, size, [sample, positions(size, tree.device), tree, squared_radius(radius), counts])
    return float(download(counts).mean())  # sync
