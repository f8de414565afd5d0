"""First occurrences of points: sort by a coordinate hash and compare bits (zero equals minus zero)."""

from ..array_types import Indices, Points
from ..arrays.hash_table import mix_bits
from ..arrays.select import positions_of
from ..arrays.sort import argsort_keys
from ..lang import array, float_bits, func, int32, int64, kernel, launch, tid, uint8, vec3
from ..memory import empty

LOW_WORD = 0xFFFFFFFF
MINUS_ZERO = 0x80000000
MAGNITUDE = 0x7FFFFFFF
INFINITE = 0x7F800000  # bits of infinity. NaN is above
WORD_BITS = 63  # of a sort key with its row index: sorted as one number


@func
def coordinate_bits(x: float) -> int64:
    """Bits of a coordinate, equal for zero and minus zero. A float comparison might flush subnormals."""
    bits = int64(float_bits(x)) & int64(LOW_WORD)
    return bits if bits != int64(MINUS_ZERO) else 0


@func
def is_nan(p: vec3) -> int:
    result = 0
    for axis in range(3):
        if (int64(float_bits(p[axis])) & int64(MAGNITUDE)) > int64(INFINITE):
            result = 1
    return result


@func
def same_point(p: vec3, q: vec3) -> int:
    differing = 0
    for axis in range(3):
        if coordinate_bits(p[axis]) != coordinate_bits(q[axis]):
            differing = 1
    return 1 - differing


@kernel
def hash_points_kernel(points: array(dtype=vec3), bits: int, keys: array(dtype=int64)):
    """Hash of the coordinates with the given number of bits."""
    i = tid()
    p = points[i]
    h = mix_bits(coordinate_bits(p[0]) | (coordinate_bits(p[1]) << 32))
    h = mix_bits(h + coordinate_bits(p[2]))
    keys[i] = h & ((1 << int64(bits)) - 1)


@kernel
def mark_first_kernel(
    points: array(dtype=vec3), keys: array(dtype=int64), order: array(dtype=int32), mask: array(dtype=uint8)
):
    """1 if no earlier point has the same coordinates. NaN equals none."""
    i = tid()
    p = points[order[i]]
    first = 1
    j = i - 1
    if is_nan(p) == 1:
        j = -1
    while j >= 0 and keys[j] == keys[i]:
        if same_point(p, points[order[j]]) == 1:
            first = 0
            j = 0
        j -= 1
    mask[order[i]] = uint8(first)


def first_occurrences(points: Points) -> Indices:
    """Rows of vec3 points that equal no earlier row; int32, ascending."""
    device = points.device
    bits = WORD_BITS - max(1, (points.size - 1).bit_length())
    keys = empty(points.size, int64, device)
    launch(hash_points_kernel, points.size, [points, bits, keys])
    sorted_keys, order = argsort_keys(keys, bits)
    mask = empty(points.size, uint8, device)
    launch(mark_first_kernel, points.size, [points, sorted_keys, order, mask])
    return positions_of(mask)
