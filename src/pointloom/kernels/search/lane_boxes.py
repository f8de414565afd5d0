"""Boxes around the points of a CUDA warp, two for each eight lanes, and the tree nodes near them, a child per lane."""

from ..algebra.plain_min_max import larger
from ..arrays.lanes import high_of_eight, low_of_eight, max_of_eight
from ..arrays.packed_keys import BYTE_MASK
from ..lang import INFINITY, WARP, array, ballot, cuda_func, float32, int32, lane, shuffle, vec3, vector
from .point_tree import FAN, SIDES, measure_box, square_distance
from .tree_walk import lowest_bit

two_boxes = vector(12, float32)


@cuda_func
def point_of_lane(p: vec3, owner: int) -> vec3:
    return vec3(shuffle(p[0], owner), shuffle(p[1], owner), shuffle(p[2], owner))


@cuda_func
def boxes_of_eight(p: vec3, is_used: int) -> two_boxes:
    """Two boxes of the used points of eight lanes: low and high corners. The points are split where neighboring lanes
    are farthest apart, since the curve can jump within a leaf and one box would contain a large part of the cloud."""
    own = lane() & (FAN - 1)
    after = point_of_lane(p, min(lane() + 1, WARP - 1))
    gap = square_distance(p, after) if own < FAN - 1 else -1.0
    largest = max_of_eight(gap)
    widest = flags_of_eight(1 if gap == largest else 0)
    is_before = 1 if own <= lowest_bit(widest) else 0
    nowhere = vec3(INFINITY, INFINITY, INFINITY)
    low = nowhere
    high = -nowhere
    low_after = nowhere
    high_after = -nowhere
    if is_used == 1:
        if is_before == 1:
            low = p
            high = p
        else:
            low_after = p
            high_after = p
    a = low_of_eight(low)
    b = high_of_eight(high)
    c = low_of_eight(low_after)
    d = high_of_eight(high_after)
    return two_boxes(a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2], d[0], d[1], d[2])


@cuda_func
def is_child_near(boxes: array(dtype=float32), node: int, around: two_boxes, bound: float) -> int:
    """1 if a node's child, one per lane, is within the squared distance `bound` of the boxes of the lane's eight."""
    child = lane() & (FAN - 1)
    a = measure_box(boxes, node, child, vec3(around[0], around[1], around[2]), vec3(around[3], around[4], around[5]))
    b = measure_box(boxes, node, child, vec3(around[6], around[7], around[8]), vec3(around[9], around[10], around[11]))
    return 1 if min(a, b) <= bound else 0


@cuda_func
def flags_of_eight(flag: int) -> int:
    """Flags of the own eight lanes as bits."""
    own = lane() & (FAN - 1)
    return (ballot(flag) >> (lane() - own)) & BYTE_MASK


@cuda_func
def flags_of_any_eight(flag: int) -> int:
    """Bit j is set if lane j of any eight lanes has the flag."""
    bits = ballot(flag)
    bits = bits | (bits >> (2 * FAN))
    return (bits | (bits >> FAN)) & BYTE_MASK


@cuda_func
def nearby_children(boxes: array(dtype=float32), node: int, around: two_boxes, bound: float) -> int:
    """`children_within` with one child per lane. Bits are set for children near the boxes of any eight lanes."""
    return flags_of_any_eight(is_child_near(boxes, node, around, bound))


@cuda_func
def nearby_nodes(
    levels: array(dtype=int32),
    first: int,
    boxes: array(dtype=float32),
    around: two_boxes,
    bound: float,
    level: int,
    node: int,
) -> int:
    """`nearby_children` for a node given by its level. The levels of its tree start at `first`."""
    return nearby_children(boxes, levels[first + level] + node, around, bound)


@cuda_func
def is_child_inside(boxes: array(dtype=float32), record: int, around: two_boxes, bound: float) -> int:
    """1 if all points of a node's child, one per lane, are within the squared distance `bound` of all points of the
    lane's eight. Rounded monotonically, as `measure_farthest`."""
    at = record * SIDES + (lane() & (FAN - 1))
    a = vec3(min(around[0], around[6]), min(around[1], around[7]), min(around[2], around[8]))
    b = vec3(max(around[3], around[9]), max(around[4], around[10]), max(around[5], around[11]))
    x = larger(boxes[at + 3 * FAN] - a[0], b[0] - boxes[at])
    y = larger(boxes[at + 4 * FAN] - a[1], b[1] - boxes[at + FAN])
    z = larger(boxes[at + 5 * FAN] - a[2], b[2] - boxes[at + 2 * FAN])
    return 1 if x * x + y * y + z * z <= bound else 0
