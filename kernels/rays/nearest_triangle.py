"""The nearest triangle of each query.

A query goes down into the nearest child of a node first, and into the others while they reach into the ball of the
nearest triangle so far. The eight triangles of a leaf are measured as eight lanes in float32, in vector registers:
the foot on the plane where that lies inside, else the nearest of the edges. Each distance comes with a bound of its
error. Where the intervals of two triangles do not overlap the nearer one is known, else both are measured in float64
(point_triangle.py), and of equal ones that of lower number is taken. So the result depends on no order.

About 5,000 operations a query of a mesh of 70k triangles; 12 B read and 4 B written besides the tree. On CUDA eight
lanes share a query.

The nearest triangle of each query by eight lanes of a CUDA warp: a lane a child of a node, a lane a triangle. Four
queries that follow each other on the curve share a warp. In each turn a group goes down into the nearest child of its
node, measures a leaf's eight triangles in float32, or goes up. A lane keeps the nearest of the triangles that it
measured, and takes float64 only where two of its own cannot be told apart by their bounds (triangle_bounds.py). At the
end the lanes whose triangle may still be the nearest of all measure it in float64, at once.

Some 25 turns of 200 instructions for four queries; no arrays of a thread's own.
"""

import math

import numpy as np

from ..algebra.plain_min_max import smaller
from ..array_types import Indices, Points
from ..lang import (
    INFINITY,
    WARP,
    array,
    ballot,
    bit_count,
    cuda_func,
    float32,
    float64,
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
from ..search.bucket_walk import byte_place
from ..search.hilbert_order import order_in_box
from ..search.point_tree import FAN, LARGEST_SQDIST, SIDES, measure_boxes
from .triangle_bounds import SMALLEST, bound_distance, load_corners, measure_place, reach_of
from .triangle_tree import LEAF, LEAF_NUMBERS, TriangleTree

GROUP_BITS = 3  # of a lane's number within its group
BYTE = 255
EVERY = 255  # BYTE in 64 bits
WIDER = 1.000002  # as triangle_bounds.SLACK, and the rounding of this product
LAST = 2147483647  # as a triangle's number: after all others


@cuda_func
def least_of_group(x: float) -> float:
    """The least number of a group's lanes."""
    found = x
    for bit in range(GROUP_BITS):
        found = smaller(shuffle_xor(found, 1 << bit), found)
    return found


@cuda_func
def distance_of_child(tree: TriangleTree, level: int, node: int, left: int, q: vec3) -> float:
    """The squared distance of a point from the box of the lane's child of a node; infinite where its bit is not set."""
    own = lane() % FAN
    box = load_six(tree.boxes, (tree.levels[level] + node) * SIDES + own)
    x = max(max(box[0] - q[0], q[0] - box[3]), 0.0)
    y = max(max(box[1] - q[1], q[1] - box[4]), 0.0)
    z = max(max(box[2] - q[2], q[2] - box[5]), 0.0)
    return x * x + y * y + z * z if ((left >> own) & 1) == 1 else INFINITY


@cuda_func
def settle(q: vec3, earlier: int, sqdist: float64, place: int, tree: TriangleTree) -> vec2d:
    """The nearer of two triangles: its squared distance [m^2] and its place; of equal ones that of lower number.

    Args:
        q: The query.
        earlier: The place of one.
        sqdist: Its squared distance, -1 where it is not known.
        place: The place of the other.
        tree: The tree.
    """
    least = sqdist * 1.0
    found = earlier + 0
    if least < 0.0:
        least = measure_place(q, earlier, tree)
    others = measure_place(q, place, tree)
    if others < least or (others == least and tree.order[place] < tree.order[earlier]):
        least = others
        found = place
    return vec2d(least, float64(found))


@cuda_func
def least_of_kept(q: vec3, place: int, sqdist: float64, tree: TriangleTree) -> vec2d:
    """The squared distance [m^2] and the number of the nearest triangle that a group keeps, infinite without any.

    Args:
        q: The query.
        place: The place of the lane's, -1 for none.
        sqdist: Its squared distance, -1 where it is not known.
        tree: The tree.
    """
    least = float64(INFINITY)
    number = int(LAST)
    if place >= 0:
        number = tree.order[place]
        least = sqdist * 1.0
        if sqdist < 0.0:
            least = measure_place(q, place, tree)
    for bit in range(GROUP_BITS):
        other = shuffle_xor(least, 1 << bit)
        others = shuffle_xor(number, 1 << bit)
        if other < least or (other == least and others < number):
            least = other
            number = others
    return vec2d(least, float64(number))


@cuda_func
def find_nearest_of_lanes(q: vec3, is_query: int, tree: TriangleTree, scale: float, bound: float64) -> vec2d:
    """The squared distance [m^2] and the number of the nearest triangle of each group's query.

    Args:
        q: The query, the same in a group's lanes.
        is_query: 0 in groups without one.
        tree: The tree.
        scale: As of `bound_distance`.
        bound: A squared distance beyond which nothing is looked for.

    Returns:
        Infinite where nothing lies within the bound; something that lies at it or just beyond may be found.
    """
    own = lane() % FAN
    group = lane() - own
    searching = is_query + 0
    reach = reach_of(bound)
    place = int(-1)  # of the nearest triangle of the lane,
    low = 0.0  # a lower bound of its squared distance,
    sqdist = float64(-1.0)  # and this itself where it was needed
    level = tree.root
    node = 0
    pending = int64(EVERY) << byte_place(level)  # a byte a level from 1 on: children not yet looked into
    distance = float(INFINITY)
    above = float(INFINITY)  # the distances of the node of level 1
    if searching == 1:
        distance = distance_of_child(tree, level, node, BYTE, q)
    while ballot(searching) != 0:
        leaf = -1
        moving = searching + 0
        while ballot(moving) != 0:  # until each group that goes on stands before a leaf
            near = (ballot(1 if distance <= reach else 0) >> group) & BYTE
            if near == 0 and level == 0 and tree.root > 0:
                level = 1
                node = node >> GROUP_BITS
                distance = above
            nearest = least_of_group(distance)
            near = (ballot(1 if distance == nearest and distance <= reach else 0) >> group) & BYTE
            child = bit_count((near & (-near)) - 1)
            if moving == 1:
                left = int(BYTE)
                if near != 0:
                    if own == child:
                        distance = INFINITY
                    if level == 0:
                        leaf = node * FAN + child
                        moving = 0
                    else:
                        node = node * FAN + child
                        level -= 1
                        if level == 0:
                            above = distance
                        else:
                            pending = pending & ~(int64(1 << child) << byte_place(level + 1))
                            pending = pending | (int64(EVERY) << byte_place(level))
                elif level < tree.root:
                    level += 1
                    node = node >> GROUP_BITS
                    left = int(pending >> byte_place(level)) & BYTE
                else:
                    searching = 0
                    moving = 0
                if moving == 1:
                    distance = distance_of_child(tree, level, node, left, q)
        upper = float(INFINITY)
        if leaf >= 0:
            found = bound_distance(load_corners(tree.corners, leaf * LEAF_NUMBERS + own), q, scale)
            upper = smaller((found[0] + found[1]) * WIDER + SMALLEST, LARGEST_SQDIST)
            lower = found[0] - found[1]
            within = smaller(upper, reach)
            if lower <= within:
                if place < 0 or low > within:
                    place = leaf * LEAF + own
                    low = lower
                    sqdist = -1.0
                else:
                    settled = settle(q, place, sqdist, leaf * LEAF + own, tree)
                    sqdist = settled[0]
                    place = int(settled[1])
                    low = smaller(lower, low)
                    upper = smaller(float(sqdist) * WIDER + SMALLEST, upper)
        reach = smaller(least_of_group(upper), reach)
    if low > reach:
        place = -1
    return least_of_kept(q, place, sqdist, tree)


NOBODY = -1  # the number of no triangle
RUN = 16  # queries a thread
CURVE_LEVELS = 10  # of the curve that orders queries
lane_numbers = vector(8, float32)
lane_bounds = vector(16, float32)  # upper bounds of eight squared distances, then lower ones


@func
def bound_distances(corners: array(dtype=float32), leaf: int, q: vec3, scale: float) -> lane_bounds:
    """Bounds of the squared distances [m^2] of a point from a leaf's triangles."""
    bounds = lane_bounds(0.0)
    for j in range(LEAF):
        found = bound_distance(load_corners(corners, leaf * LEAF_NUMBERS + j), q, scale)
        bounds[j] = found[0] + found[1]
        bounds[LEAF + j] = found[0] - found[1]
    return bounds


@func
def measure_leaf(leaf: int, q: vec3, tree: TriangleTree, scale: float, best: vec4d) -> vec4d:
    """The best so far after a leaf.

    Args:
        leaf: The leaf.
        q: The query.
        tree: The tree.
        scale: A power of two that brings lengths of triangles near one.
        best: An upper and a lower bound of the squared distance, the distance itself or -1 where it was not needed,
            and the triangle's place or -1.
    """
    bounds = bound_distances(tree.corners, leaf, q, scale)
    shortest = bounds[0]
    for j in range(1, LEAF):
        shortest = smaller(bounds[j], shortest)
    least = smaller(shortest, reach_of(best[0]))  # rounded up
    result = best + vec4d(0.0, 0.0, 0.0, 0.0)
    rivals = 0
    only = 0
    for j in range(LEAF):
        in_reach = 1 if bounds[LEAF + j] <= least else 0
        rivals += in_reach
        only = j if in_reach == 1 else only
    holds = 0
    if best[3] >= 0.0 and best[1] <= float64(shortest):
        holds = 1
    if rivals == 1 and holds == 0:
        place = leaf * LEAF + only
        result = vec4d(float64(bounds[only]), float64(bounds[LEAF + only]), -1.0, float64(place))
    elif rivals > 0:
        if holds == 0:
            result = vec4d(float64(LARGEST_SQDIST), 0.0, float64(LARGEST_SQDIST), -1.0)
        elif best[2] < 0.0:
            result[2] = measure_place(q, int(best[3]), tree)
        lanes = int(LEAF)
        for j in range(lanes):
            if bounds[LEAF + j] <= least:
                place = leaf * LEAF + j
                sqdist = measure_place(q, place, tree)
                nearer = 0
                if sqdist < result[2]:
                    nearer = 1
                elif sqdist == result[2] and result[3] >= 0.0:
                    if tree.order[place] < tree.order[int(result[3])]:
                        nearer = 1
                if nearer == 1:
                    result[2] = sqdist
                    result[3] = float64(place)
        result[0] = result[2] + 0.0
        result[1] = result[2] + 0.0
    return result


@func
def measure_bucket(node: int, q: vec3, tree: TriangleTree, scale: float, best: vec4d) -> vec4d:
    """The best so far after the leaves of a node of level 0, the nearest first."""
    distances = measure_boxes(tree.boxes, node, q, q)
    result = best + vec4d(0.0, 0.0, 0.0, 0.0)
    searching = 1
    while searching == 1:
        j = nearest_of(distances, BYTE)
        if distances[j] <= reach_of(result[0]):
            result = measure_leaf(node * FAN + j, q, tree, scale, result)
            distances[j] = INFINITY
        else:
            searching = 0
    return result


@func
def nearest_of(distances: lane_numbers, wanted: int) -> int:
    """The nearest of those children whose bits are set."""
    nearest = 0
    least = float(INFINITY)
    for j in range(FAN):
        closer = 1 if distances[j] < least else 0
        closer = closer & (wanted >> j)
        nearest = j if closer == 1 else nearest
        least = distances[j] if closer == 1 else least
    return nearest


@func
def find_nearest(q: vec3, tree: TriangleTree, scale: float, near: vec4d) -> vec4d:
    """The nearest triangle as `measure_leaf` has it, or `near` where none is nearer."""
    best = near + vec4d(0.0, 0.0, 0.0, 0.0)
    level = tree.root
    node = 0
    pending = int64(EVERY) << byte_place(level)  # a byte a level: children not yet looked into
    if level == 0:
        best = measure_bucket(0, q, tree, scale, best)
        level = 1
    while level <= tree.root:
        left = int(pending >> byte_place(level)) & BYTE
        chosen = -1
        if left != 0:
            distances = measure_boxes(tree.boxes, tree.levels[level] + node, q, q)
            reach = reach_of(best[0])
            j = nearest_of(distances, left)
            if ((left >> j) & 1) == 1 and distances[j] <= reach:
                chosen = j
        if chosen < 0:
            pending = pending & ~(int64(EVERY) << byte_place(level))
            level += 1
            node = node // FAN
        else:
            pending = pending & ~(int64(1 << chosen) << byte_place(level))
            if level == 1:
                best = measure_bucket(node * FAN + chosen, q, tree, scale, best)
            else:
                node = node * FAN + chosen
                level -= 1
                pending = pending | (int64(EVERY) << byte_place(level))
    return best


@struct
class NearestTriangles:
    """What queries have found so far.

    Attributes:
        sqdists: float64 [n], squared distances [m^2]; infinite where there is none, as for queries that are not finite.
        meshes: int32 [n], which of several; NOBODY where there is none.
        triangles: int32 [n], its triangle, NOBODY likewise.
        order: int32 [n], the queries so that neighbours follow each other.
    """

    sqdists: array(dtype=float64)
    meshes: array(dtype=int32)
    triangles: array(dtype=int32)

    def __init__(self, queries: Points, order: Indices | None = None) -> None:
        """Nothing yet, for vec3 queries; in an order of theirs, if it is given."""
        device, n = queries.device, queries.size
        self.sqdists = full(n, math.inf, float64, device)
        self.meshes, self.triangles = full(n, NOBODY, int32, device), full(n, NOBODY, int32, device)
        self.order = order_in_box(queries, CURVE_LEVELS) if order is None else order

    def look_into(self, tree: TriangleTree, queries: Points, mesh: int) -> None:
        """Go on in one more mesh; of equally near triangles the one of the earlier mesh, then of lower number, stays.

        Args:
            tree: Its TriangleTree.
            queries: Device array of vec3, about the tree's origin; those beyond 1.8e19 m find nothing.
            mesh: Its number.
        """
        n, run = queries.size, RUN
        threads = -(-n // run)
        if queries.device.is_cuda:
            run, threads = 1, -(-n * FAN // WARP) * WARP  # whole warps
        search = [queries, self.order, run, tree, scale_of(tree), mesh, self]
        launch(find_nearest_triangles_kernel, threads, search)


@kernel(most_registers=80)
def find_nearest_triangles_kernel(
    queries: array(dtype=vec3),
    query_order: array(dtype=int32),
    run: int,
    tree: TriangleTree,
    scale: float,
    mesh: int,
    nearest: NearestTriangles,
):
    """Enter a mesh's triangle that is nearer than what a query has, for each of a run of queries."""
    i = tid()
    for rank in range(i * run, min((i + 1) * run, queries.shape[0])):
        row = query_order[rank]
        q = queries[row]
        if tree.count > 0 and isfinite(q):
            least = nearest.sqdists[row]
            bound = min(least, float64(LARGEST_SQDIST))
            best = find_nearest(q, tree, scale, vec4d(bound, 0.0, -1.0, -1.0))
            if best[3] >= 0.0:
                place = int(best[3])
                sqdist = measure_place(q, place, tree)
                if sqdist < least:
                    nearest.sqdists[row] = sqdist
                    nearest.meshes[row] = mesh
                    nearest.triangles[row] = tree.order[place]


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
    """The same, eight lanes a query."""
    i = tid()
    rank = i // FAN
    row = query_order[min(rank, queries.shape[0] - 1)]
    q = queries[row]
    searching = 1 if rank < queries.shape[0] and tree.count > 0 and isfinite(q) else 0
    least = nearest.sqdists[row]
    found = find_nearest_of_lanes(q, searching, tree, scale, min(least, float64(LARGEST_SQDIST)))
    sync_lanes()  # all have read what one writes
    if i % FAN == 0 and found[0] < least:
        nearest.sqdists[row] = found[0]
        nearest.meshes[row] = mesh
        nearest.triangles[row] = int(found[1])


def scale_of(tree: TriangleTree) -> float:
    """A power of two that brings the lengths of a tree's triangles near one."""
    extent = float((tree.high.astype(np.float64) - tree.low).max()) if tree.count else 0.0
    size = extent / math.sqrt(max(1, tree.count))
    return 2.0 ** -round(math.log2(min(max(size, 1e-30), 1e30)))
