"""The nearest triangle of each query by eight lanes of a CUDA warp: a lane a child of a node, a lane a triangle.

Four queries that follow each other on the curve share a warp. In each turn a group goes down into the nearest child of
its node, measures a leaf's eight triangles in float32, or goes up. A lane keeps the nearest of the triangles that it
measured, and takes float64 only where two of its own cannot be told apart by their bounds (triangle_bounds.py). At the
end the lanes whose triangle may still be the nearest of all measure it in float64, at once.

Some 25 turns of 200 instructions for four queries; no arrays of a thread's own.
"""

from ..algebra.plain_min_max import smaller
from ..lang import INFINITY, ballot, bit_count, cuda_func, float64, int64, lane, load_six, shuffle_xor, vec2d, vec3
from ..search.bucket_walk import byte_place
from ..search.point_tree import FAN, LARGEST_SQDIST, SIDES
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
