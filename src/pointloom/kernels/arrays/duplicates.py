"""First occurrences of points with equal coordinate bits (zero equals minus zero)."""

from ..array_types import Cells, Indices, Points
from ..lang import array, compute, float_bits, func, int64, kernel, tid, vec3, vec3i
from .first_rows import first_rows, mask_first_rows
from .select import positions_of

LOW_WORD = 0xFFFFFFFF
MINUS_ZERO = 0x80000000
MAGNITUDE_BITS = 0x7FFFFFFF
INFINITY_BITS = 0x7F800000  # bits of infinity. NaN is above


@func
def coordinate_bits(x: float) -> int64:
    """Bits of a coordinate, equal for zero and minus zero. A float comparison might flush subnormals."""
    bits = int64(float_bits(x)) & int64(LOW_WORD)
    return bits if bits != int64(MINUS_ZERO) else 0


@func
def is_nan(p: vec3) -> int:
    result = 0
    for axis in range(3):
        if (int64(float_bits(p[axis])) & int64(MAGNITUDE_BITS)) > int64(INFINITY_BITS):
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
def list_words_kernel(points: array(dtype=vec3), words: array(dtype=vec3i)):
    """The three coordinates as integers. A point with a NaN gets a row that no other has."""
    i = tid()
    p = points[i]
    row = vec3i(int(coordinate_bits(p[0])), int(coordinate_bits(p[1])), int(coordinate_bits(p[2])))
    if is_nan(p) == 1:
        row = vec3i(MAGNITUDE_BITS, i, 0)
    words[i] = row


def list_words(points: Points) -> Cells:
    return compute(list_words_kernel, points.size, [points], vec3i, points.device)


def find_equal_points(points: Points) -> Indices:
    """First point at each one's position, int32 [n]; those with a NaN map to themselves."""
    return first_rows(list_words(points))


def first_occurrences(points: Points) -> Indices:
    """Rows of vec3 points that equal no earlier row; int32, ascending."""
    return positions_of(mask_first_rows(list_words(points)))
