"""Reductions over the 32 lanes of a CUDA warp, or groups of eight. All lanes must participate and get the result."""

from ..lang import cuda_func, shuffle_xor, vec3

LANE_BITS = 5  # of a lane index
EIGHT_BITS = 3  # of a lane index within eight


@cuda_func
def least(x: float) -> float:
    found = x
    for bit in range(LANE_BITS):
        found = min(found, shuffle_xor(found, 1 << bit))
    return found


@cuda_func
def most(x: float) -> float:
    found = x
    for bit in range(LANE_BITS):
        found = max(found, shuffle_xor(found, 1 << bit))
    return found


@cuda_func
def sum_of_lanes(x: float) -> float:
    total = x
    for bit in range(LANE_BITS):
        total += shuffle_xor(total, 1 << bit)
    return total


@cuda_func
def least_of_each(p: vec3) -> vec3:
    """Low corner of the lanes' points."""
    return vec3(least(p[0]), least(p[1]), least(p[2]))


@cuda_func
def most_of_each(p: vec3) -> vec3:
    return vec3(most(p[0]), most(p[1]), most(p[2]))


@cuda_func
def least_of_eight(x: float) -> float:
    found = x
    for bit in range(EIGHT_BITS):
        found = min(found, shuffle_xor(found, 1 << bit))
    return found


@cuda_func
def most_of_eight(x: float) -> float:
    found = x
    for bit in range(EIGHT_BITS):
        found = max(found, shuffle_xor(found, 1 << bit))
    return found


@cuda_func
def low_of_eight(p: vec3) -> vec3:
    """Low corner of eight lanes' points."""
    return vec3(least_of_eight(p[0]), least_of_eight(p[1]), least_of_eight(p[2]))


@cuda_func
def high_of_eight(p: vec3) -> vec3:
    return vec3(most_of_eight(p[0]), most_of_eight(p[1]), most_of_eight(p[2]))
