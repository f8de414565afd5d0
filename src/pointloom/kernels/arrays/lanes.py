"""Reductions over the 32 lanes of a CUDA warp, or groups of eight. All lanes must participate and get the result."""

from ..lang import cuda_func, float64, int64, shuffle_xor, vec3

LANE_BITS = 5  # of a lane index
EIGHT_BITS = 3  # of a lane index within eight
LOW_WORD = 0xFFFF_FFFF


@cuda_func
def min_of_lanes(x: float) -> float:
    lowest = x
    for bit in range(LANE_BITS):
        lowest = min(lowest, shuffle_xor(lowest, 1 << bit))
    return lowest


@cuda_func
def max_of_lanes(x: float) -> float:
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
def low_of_lanes(p: vec3) -> vec3:
    """Low corner of the lanes' points."""
    return vec3(min_of_lanes(p[0]), min_of_lanes(p[1]), min_of_lanes(p[2]))


@cuda_func
def high_of_lanes(p: vec3) -> vec3:
    return vec3(max_of_lanes(p[0]), max_of_lanes(p[1]), max_of_lanes(p[2]))


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


@cuda_func
def min_int_of_eight(x: int) -> int:
    lowest = x
    for bit in range(EIGHT_BITS):
        lowest = min(lowest, shuffle_xor(lowest, 1 << bit))
    return lowest


@cuda_func
def max_int_of_eight(x: int) -> int:
    highest = x
    for bit in range(EIGHT_BITS):
        highest = max(highest, shuffle_xor(highest, 1 << bit))
    return highest


@cuda_func
def min_int_of_lanes(x: int) -> int:
    lowest = x
    for bit in range(LANE_BITS):
        lowest = min(lowest, shuffle_xor(lowest, 1 << bit))
    return lowest


@cuda_func
def max_int_of_lanes(x: int) -> int:
    highest = x
    for bit in range(LANE_BITS):
        highest = max(highest, shuffle_xor(highest, 1 << bit))
    return highest


@cuda_func
def sum_int_of_lanes(x: int) -> int:
    total = x
    for bit in range(LANE_BITS):
        total += shuffle_xor(total, 1 << bit)
    return total


@cuda_func
def bits_of_lanes(x: int) -> int:
    """Bits set in any lane."""
    bits = x
    for bit in range(LANE_BITS):
        bits = bits | shuffle_xor(bits, 1 << bit)
    return bits


@cuda_func
def shuffle_xor_long(x: int64, mask: int) -> int64:
    """`shuffle_xor` of int64, by halves."""
    low = shuffle_xor(int(x), mask)
    high = shuffle_xor(int(x >> 32), mask)
    return (int64(high) << 32) | (int64(low) & int64(LOW_WORD))


@cuda_func
def min_long_of_lanes(x: int64) -> int64:
    lowest = x
    for bit in range(LANE_BITS):
        lowest = min(lowest, shuffle_xor_long(lowest, 1 << bit))
    return lowest


@cuda_func
def max_long_of_lanes(x: int64) -> int64:
    highest = x
    for bit in range(LANE_BITS):
        highest = max(highest, shuffle_xor_long(highest, 1 << bit))
    return highest


@cuda_func
def sum_long_of_lanes(x: int64) -> int64:
    total = x
    for bit in range(LANE_BITS):
        total += shuffle_xor_long(total, 1 << bit)
    return total


@cuda_func
def max_double_of_lanes(x: float64) -> float64:
    highest = x
    for bit in range(LANE_BITS):
        highest = max(highest, shuffle_xor(highest, 1 << bit))
    return highest


@cuda_func
def sum_double_of_lanes(x: float64) -> float64:
    total = x
    for bit in range(LANE_BITS):
        total += shuffle_xor(total, 1 << bit)
    return total
