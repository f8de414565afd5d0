"""Nearest triangle of each query.

Nearest-first traversal. A leaf's eight triangles are measured in float32 with error bounds. Overlapping intervals are
resolved in float64 (point_triangle.py), ties by the lower number, so the result is independent of the order. About
5,000 operations per query of a mesh of 70k triangles. On CUDA eight lanes share a query (a lane per child or triangle,
triangle_bounds.py), and final candidates are measured in float64.
"""

import math

import numpy as np

from ..algebra.plain_min_max import larger, smaller
from ..array_types import Indices, Points
from ..arrays.lanes import EIGHT_BITS
from ..arrays.packed_keys import BYTE_MASK
from ..lang import (
    INFINITY,
    WARP,
    array,
    ballot,
    bit_count,
    cuda_func,
    float32,
    float64,
    float_bits,
    func,
    int32,
    int64,
    isfinite,
    kernel,
    lane,
    launch,
    load_six,
    shuffle_xor,
    struct,
    sync_lanes,
    tid,
    vec2d,
    vec3,
    vec4d,
    vector,
)
from ..memory import full
from ..search.bucket_walk import byte_shift
from ..search.hilbert_order import order_in_box
from ..search.point_tree import FAN, LARGEST_SQDIST, SIDES
from .triangle_bounds import MIN_SQDIST, bound_distance, load_corners, sqdist_at, sqdist_limit
from .triangle_tree import LEAF_NUMBERS, LEAF_SIZE, MAX_LEVEL, TriangleTree, level_keys

BYTE_MASK_64 = 255  # in 64 bits
CHILD_MASK = 7  # the bits of a child's index
NO_CHILD = 0x7FFFFFFF  # above the bits of any distance
SQDIST_ENLARGEMENT = 1.000002  # as triangle_bounds.BOX_SQDIST_FACTOR, plus the rounding of this product
NUMBER_AFTER_ALL = 2147483647  # triangle number after all others


@cuda_func
def min_of_group(x: float) -> float:
    lowest = x
    for bit in range(EIGHT_BITS):
        lowest = smaller(shuffle_xor(lowest, 1 << bit), lowest)
    return lowest


@cuda_func
def distance_of_child(
    tree: TriangleTree, level: int, node: int, left: int, q: vec3, is_new: int, earlier: float
) -> float:
    """Squared distance to the box of the lane's child; infinite if its bit is not set. `earlier` if not `is_new`."""
    sqdist = earlier * 1.0
    if is_new == 1:
        own = lane() % FAN
        box = load_six(tree.boxes, (tree.levels[level] + node) * SIDES + own)
        x = max(max(box[0] - q[0], q[0] - box[3]), 0.0)
        y = max(max(box[1] - q[1], q[1] - box[4]), 0.0)
        z = max(max(box[2] - q[2], q[2] - box[5]), 0.0)
        sqdist = x * x + y * y + z * z if ((left >> own) & 1) == 1 else INFINITY
    return sqdist


@cuda_func
def choose_nearer(q: vec3, earlier: int, sqdist: float64, index: int, tree: TriangleTree) -> vec2d:
    """Squared distance [m^2] and position of the nearer of two triangles, ties by number; `sqdist` is -1 if unknown."""
    min_sqdist = sqdist * 1.0
    nearer = earlier + 0
    if min_sqdist < 0.0:
        min_sqdist = sqdist_at(q, earlier, tree)
    others = sqdist_at(q, index, tree)
    if others < min_sqdist or (others == min_sqdist and tree.order[index] < tree.order[earlier]):
        min_sqdist = others
        nearer = index
    return vec2d(min_sqdist, float64(nearer))


@cuda_func
def nearest_of_group(q: vec3, index: int, sqdist: float64, tree: TriangleTree) -> vec2d:
    """Squared distance [m^2] and number of the group's nearest triangle (`index` or -1), infinite if none."""
    min_sqdist = float64(INFINITY)
    number = int(NUMBER_AFTER_ALL)
    if index >= 0:
        number = tree.order[index]
        min_sqdist = sqdist * 1.0
        if sqdist < 0.0:
            min_sqdist = sqdist_at(q, index, tree)
    for bit in range(EIGHT_BITS):
        other = shuffle_xor(min_sqdist, 1 << bit)
        others = shuffle_xor(number, 1 << bit)
        if other < min_sqdist or (other == min_sqdist and others < number):
            min_sqdist = other
            number = others
    return vec2d(min_sqdist, float64(number))


@cuda_func
def find_nearest_of_lanes(q: vec3, is_query: int, tree: TriangleTree, scale: float, bound: float64) -> vec2d:
    """Squared distance [m^2] and number of the nearest triangle of each group's query; infinite if none is within
    `bound`, though one slightly beyond may be found.
    """
    own = lane() % FAN
    group = lane() - own
    searching = is_query + 0
    limit = sqdist_limit(bound)
    index = int(-1)  # of the lane's nearest triangle,
    low = 0.0  # a lower bound of its squared distance,
    sqdist = float64(-1.0)  # and the exact one if it was needed
    level = tree.root
    node = 0
    pending = int64(BYTE_MASK_64) << byte_shift(level)  # one byte per level from 1 on: pending children
    distance = distance_of_child(tree, level, node, BYTE_MASK, q, searching, INFINITY)
    above = float(INFINITY)  # distances of the node of level 1
    while ballot(searching) != 0:
        leaf = -1
        moving = searching + 0
        while ballot(moving) != 0:  # until each active group is at a leaf
            near = (ballot(1 if distance <= limit else 0) >> group) & BYTE_MASK
            leaves_bucket = 1 if near == 0 and level == 0 and tree.root > 0 else 0
            level += leaves_bucket
            node = node >> (EIGHT_BITS * leaves_bucket)
            distance = above if leaves_bucket == 1 else distance
            nearest = min_of_group(distance)
            near = (ballot(1 if distance == nearest and distance <= limit else 0) >> group) & BYTE_MASK
            child = bit_count((near & (-near)) - 1)
            # one assignment to each variable, outside of branches: each in a branch would occupy a register
            found = moving if near != 0 else 0
            descends = found if level > 0 else 0
            ascends = moving - found if level < tree.root else 0
            distance = INFINITY if found == 1 and own == child else distance
            leaf = node * FAN + child if found > descends else leaf
            node = node * FAN + child if descends == 1 else node >> (EIGHT_BITS * ascends)
            level += ascends - descends
            above = distance if descends == 1 and level == 0 else above
            enters = descends if level > 0 else 0
            entered = int64(enters << child) << byte_shift(level + 1)
            pending = (pending & ~entered) | (int64(BYTE_MASK * enters) << byte_shift(level))
            searching -= 1 if moving > found + ascends else 0
            moving = descends + ascends
            left = (int(pending >> byte_shift(level)) & BYTE_MASK) | (BYTE_MASK * (1 - ascends))
            distance = distance_of_child(tree, level, node, left, q, moving, distance)
        upper = float(INFINITY)
        if leaf >= 0:
            interval = bound_distance(load_corners(tree.corners, leaf * LEAF_NUMBERS + own), q, scale)
            upper = smaller((interval[0] + interval[1]) * SQDIST_ENLARGEMENT + MIN_SQDIST, LARGEST_SQDIST)
            lower = interval[0] - interval[1]
            within = smaller(upper, limit)
            if lower <= within:
                if index < 0 or low > within:
                    index = leaf * LEAF_SIZE + own
                    low = lower
                    sqdist = -1.0
                else:
                    nearer = choose_nearer(q, index, sqdist, leaf * LEAF_SIZE + own, tree)
                    sqdist = nearer[0]
                    index = int(nearer[1])
                    low = smaller(lower, low)
                    upper = smaller(float(sqdist) * SQDIST_ENLARGEMENT + MIN_SQDIST, upper)
        limit = smaller(min_of_group(upper), limit)
    if low > limit:
        index = -1
    return nearest_of_group(q, index, sqdist, tree)


NO_TRIANGLE = -1
QUERIES_PER_THREAD = 16
CURVE_LEVELS = 10  # of the curve that orders queries
run_coordinates = vector(48, float32)
run_sqdists = vector(16, float64)
lane_bounds = vector(16, float32)  # upper bounds of eight squared distances, then lower bounds


@func
def bound_distances(corners: array(dtype=float32), leaf: int, q: vec3, scale: float) -> lane_bounds:
    """Bounds of the squared distances [m^2] from a point to a leaf's triangles."""
    bounds = lane_bounds(0.0)
    for j in range(LEAF_SIZE):
        interval = bound_distance(load_corners(corners, leaf * LEAF_NUMBERS + j), q, scale)
        bounds[j] = interval[0] + interval[1]
        bounds[LEAF_SIZE + j] = interval[0] - interval[1]
    return bounds


@func
def measure_leaf(leaf: int, q: vec3, tree: TriangleTree, scale: float, best: vec4d) -> vec4d:
    """Update `best` (upper and lower bound of the squared distance, exact or -1, position or -1) with a leaf."""
    bounds = bound_distances(tree.corners, leaf, q, scale)
    shortest = bounds[0]
    for j in range(1, LEAF_SIZE):
        shortest = smaller(bounds[j], shortest)
    limit = smaller(shortest, sqdist_limit(best[0]))  # rounded up
    result = best + vec4d(0.0, 0.0, 0.0, 0.0)
    rivals = 0
    only = 0
    for j in range(LEAF_SIZE):
        in_range = 1 if bounds[LEAF_SIZE + j] <= limit else 0
        rivals += in_range
        only = j if in_range == 1 else only
    best_remains = 0
    if best[3] >= 0.0 and best[1] <= float64(shortest):
        best_remains = 1
    if rivals == 1 and best_remains == 0:
        index = leaf * LEAF_SIZE + only
        result = vec4d(float64(bounds[only]), float64(bounds[LEAF_SIZE + only]), -1.0, float64(index))
    elif rivals > 0:
        if best_remains == 0:
            result = vec4d(float64(LARGEST_SQDIST), 0.0, float64(LARGEST_SQDIST), -1.0)
        elif best[2] < 0.0:
            result[2] = sqdist_at(q, int(best[3]), tree)
        lanes = int(LEAF_SIZE)
        for j in range(lanes):
            if bounds[LEAF_SIZE + j] <= limit:
                index = leaf * LEAF_SIZE + j
                sqdist = sqdist_at(q, index, tree)
                nearer = 0
                if sqdist < result[2]:
                    nearer = 1
                elif sqdist == result[2] and result[3] >= 0.0:
                    if tree.order[index] < tree.order[int(result[3])]:
                        nearer = 1
                if nearer == 1:
                    result[2] = sqdist
                    result[3] = float64(index)
        result[0] = result[2] + 0.0
        result[1] = result[2] + 0.0
    return result


@func
def find_nearest(q: vec3, tree: TriangleTree, scale: float, near: vec4d) -> vec4d:
    """Nearest triangle as `measure_leaf`, or `near` if none is nearer. A node is measured once: `pending` stores the
    distances to its children, their lowest three bits the child, NO_CHILD after the visit.
    """
    upper = near[0]  # numbers, since a vector would be copied at each node
    lower = near[1]
    exact = near[2]
    index = near[3]
    limit = float_bits(sqdist_limit(upper)) | CHILD_MASK
    level = tree.root
    node = 0
    is_new = 1
    pending = level_keys(0)
    while level <= tree.root:
        at = FAN * (level & MAX_LEVEL)  # never negative, which saves a check of each index
        nearest = int(NO_CHILD)
        if is_new == 1:
            first = (tree.levels[level] + node) * SIDES
            for j in range(FAN):
                box = first + j
                x = larger(larger(tree.boxes[box] - q[0], q[0] - tree.boxes[box + 3 * FAN]), 0.0)
                y = larger(larger(tree.boxes[box + FAN] - q[1], q[1] - tree.boxes[box + 4 * FAN]), 0.0)
                z = larger(larger(tree.boxes[box + 2 * FAN] - q[2], q[2] - tree.boxes[box + 5 * FAN]), 0.0)
                key = (float_bits(x * x + y * y + z * z) & ~CHILD_MASK) | j
                pending[at + j] = key
                nearest = min(nearest, key)
        else:
            for j in range(FAN):
                nearest = min(nearest, pending[at + j])
        is_new = 0
        if nearest > limit:
            node = node // FAN
            level = level + 1
        else:
            child = node * FAN + (nearest & CHILD_MASK)
            pending[at + (nearest & CHILD_MASK)] = NO_CHILD
            if level == 0:
                best = measure_leaf(child, q, tree, scale, vec4d(upper, lower, exact, index))
                upper = best[0]
                lower = best[1]
                exact = best[2]
                index = best[3]
                limit = float_bits(sqdist_limit(upper)) | CHILD_MASK
            else:
                node = child
                level = level - 1
                is_new = 1
    return vec4d(upper, lower, exact, index)


@struct
class NearestTriangles:
    """Current results: `sqdists` [m^2], infinite if none; `meshes`, `triangles` or NO_TRIANGLE; query `order`."""

    sqdists: array(dtype=float64)
    meshes: array(dtype=int32)
    triangles: array(dtype=int32)

    def __init__(self, queries: Points, order: Indices | None = None) -> None:
        """Initialize for vec3 queries, with their order if given."""
        device, n = queries.device, queries.size
        self.sqdists = full(n, math.inf, float64, device)
        self.meshes, self.triangles = full(n, NO_TRIANGLE, int32, device), full(n, NO_TRIANGLE, int32, device)
        self.order = order_in_box(queries, CURVE_LEVELS) if order is None else order

    def search(self, tree: TriangleTree, queries: Points, mesh: int) -> None:
        """Update with another mesh. Ties keep the earlier one. `queries` are about its origin, up to 1.8e19 m."""
        n, run = queries.size, QUERIES_PER_THREAD
        threads = -(-n // run)
        if queries.device.is_cuda:
            run, threads = 1, -(-n * FAN // WARP) * WARP  # whole warps
        search = [queries, self.order, run, tree, scale_of(tree), mesh, self]
        launch(find_nearest_triangles_kernel, threads, search)


@kernel(max_registers=80)
def find_nearest_triangles_kernel(
    queries: array(dtype=vec3),
    query_order: array(dtype=int32),
    run: int,
    tree: TriangleTree,
    scale: float,
    mesh: int,
    nearest: NearestTriangles,
):
    i = tid()
    first = i * run
    count = min(run, queries.shape[0] - first)
    coordinates = run_coordinates(0.0)
    known = run_sqdists(0.0)
    for j in range(count):  # at once, since the rows are in random order
        row = query_order[first + j]
        q = queries[row]
        at = 3 * (j & (QUERIES_PER_THREAD - 1))
        coordinates[at] = q[0]
        coordinates[at + 1] = q[1]
        coordinates[at + 2] = q[2]
        known[j & (QUERIES_PER_THREAD - 1)] = nearest.sqdists[row]
    for j in range(count):
        q = vec3(coordinates[3 * j], coordinates[3 * j + 1], coordinates[3 * j + 2])
        if tree.count > 0 and isfinite(q):
            bound = min(known[j], float64(LARGEST_SQDIST))
            best = find_nearest(q, tree, scale, vec4d(bound, 0.0, -1.0, -1.0))
            if best[3] >= 0.0:
                index = int(best[3])
                sqdist = sqdist_at(q, index, tree)
                if sqdist < known[j]:
                    row = query_order[first + j]
                    nearest.sqdists[row] = sqdist
                    nearest.meshes[row] = mesh
                    nearest.triangles[row] = tree.order[index]


@find_nearest_triangles_kernel.on_cuda
def find_nearest_triangles_of_lanes_kernel(
    queries: array(dtype=vec3),
    query_order: array(dtype=int32),
    run: int,
    tree: TriangleTree,
    scale: float,
    mesh: int,
    nearest: NearestTriangles,
):
    """CUDA variant, eight lanes per query."""
    i = tid()
    rank = i // FAN
    row = query_order[min(rank, queries.shape[0] - 1)]
    q = queries[row]
    searching = 1 if rank < queries.shape[0] and tree.count > 0 and isfinite(q) else 0
    known_sqdist = nearest.sqdists[row]
    result = find_nearest_of_lanes(q, searching, tree, scale, min(known_sqdist, float64(LARGEST_SQDIST)))
    sync_lanes()  # all lanes have read before one writes
    if i % FAN == 0 and result[0] < known_sqdist:
        nearest.sqdists[row] = result[0]
        nearest.meshes[row] = mesh
        nearest.triangles[row] = int(result[1])


def scale_of(tree: TriangleTree) -> float:
    """Power of two that normalizes the lengths of a tree's triangles."""
    extent = float((tree.high.astype(np.float64) - tree.low).max()) if tree.count else 0.0
    size = extent / math.sqrt(max(1, tree.count))
    return 2.0 ** -round(math.log2(min(max(size, 1e-30), 1e30)))
