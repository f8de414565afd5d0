"""The lowest bit that any coordinate of a cloud has: all are whole multiples of it (algebra/residues.py)."""

from ..algebra.residues import EXPONENT_SHIFT, FIELDS, MANTISSA_BITS, MANTISSA_MASK
from ..lang import array, atomic_min, bit_count, float_bits, int32, kernel, launch, tid, vec3
from ..memory import download, full

NO_BIT = 1000


@kernel
def find_lowest_bit_kernel(points: array(dtype=vec3), lowest: array(dtype=int32)):
    """The exponent of the lowest bit that any coordinate has; the atomic settles the minimum."""
    i = tid()
    p = points[i]
    found = int(NO_BIT)
    for axis in range(3):
        bits = float_bits(p[axis])
        field = (bits >> MANTISSA_BITS) & (FIELDS - 1)
        mantissa = bits & MANTISSA_MASK
        if field > 0:
            mantissa = mantissa + (MANTISSA_MASK + 1)
        if mantissa > 0:
            found = min(found, max(field, 1) - EXPONENT_SHIFT + bit_count((mantissa & (-mantissa)) - 1))
    atomic_min(lowest, 0, found)


def lowest_bit(points):
    """The exponent of the lowest bit of the coordinates of vec3 points, all finite; 0 where all are zero (one sync)."""
    lowest = full(1, NO_BIT, int32, points.device)
    launch(find_lowest_bit_kernel, points.size, [points, lowest])
    bit = int(download(lowest)[0])  # sync
    return 0 if bit == NO_BIT else bit
