"""Reductions over the 32 lanes of a CUDA warp, or groups of eight. All lanes must participate and get the result."""

from ..lang import cuda_func, shuffle_xor, vec3

LANE_BITS = 5  # of a lane index
EIGHT_BITS = 3  # of a lane index within eight


@cuda_func
def lane_min(x: float) -> float:
    lowest = x
    for bit in range(LANE_BITS):
        lowest = min(lowest, shuffle_xor(lowest, 1 << bit))
    return lowest


@cuda_func
def lane_max(x: float) -> float:
    highest = x
    for bit in range(LANE_BITS):
        highest = max(highest, shuffle_xor(highest, 1 << bit))
    return highest


@cuda_func
def sum_of_lanes(x: float) -> float:
    total = x
    for bit in range(LANE_BITS):
        total += shuffle_xor(total, 1 << bit)
    return total


@cuda_func
def int_sum_of_lanes(x: int) -> int:
    total = x
    for bit in range(LANE_BITS):
        total += shuffle_xor(total, 1 << bit)
    return total


@cuda_func
def int_min_of_lanes(x: int) -> int:
    lowest = x
    for bit in range(LANE_BITS):
        lowest = min(lowest, shuffle_xor(lowest, 1 << bit))
    return lowest


@cuda_func
def lane_min_corner(p: vec3) -> vec3:
    """Low corner of the lanes' points."""
    return vec3(lane_min(p[0]), lane_min(p[1]), lane_min(p[2]))


@cuda_func
def lane_max_corner(p: vec3) -> vec3:
    return vec3(lane_max(p[0]), lane_max(p[1]), lane_max(p[2]))


@cuda_func
def min_of_eight(x: float) -> float:
    lowest = x
    for bit in range(EIGHT_BITS):
        lowest = min(lowest, shuffle_xor(lowest, 1 << bit))
    return lowest


@cuda_func
def max_of_eight(x: float) -> float:
    highest = x
    for bit in range(EIGHT_BITS):
        highest = max(highest, shuffle_xor(highest, 1 << bit))
    return highest


@cuda_func
def low_of_eight(p: vec3) -> vec3:
    """Low corner of eight lanes' points."""
    return vec3(min_of_eight(p[0]), min_of_eight(p[1]), min_of_eight(p[2]))


@cuda_func
def high_of_eight(p: vec3) -> vec3:
    return vec3(max_of_eight(p[0]), max_of_eight(p[1]), max_of_eight(p[2]))
