"""The lowest set bit of all coordinates of a cloud, of which all are integer multiples (algebra/residues.py)."""

import numpy as np

from ..algebra.residues import EXPONENT_SHIFT, EXPONENT_VALUES, MANTISSA_BITS, MANTISSA_MASK
from ..array_types import Integers, Points
from ..lang import array, bit_count, float_bits, func, int32, kernel, launch, tid, vec3
from ..memory import download, full
from .row_atomics import lower_int
from .runs import Runs, elements_of, row_of

RUN_POINTS = 1024  # points per thread on the CPU: one atomic each
NO_BIT = 1000


@func
def lowest_bit_of(x: float) -> int:
    """Exponent of the lowest bit of a coordinate. NO_BIT for zero."""
    bits = float_bits(x)
    field = (bits >> MANTISSA_BITS) & (EXPONENT_VALUES - 1)
    mantissa = bits & MANTISSA_MASK
    if field > 0:
        mantissa = mantissa + (MANTISSA_MASK + 1)
    exponent = int(NO_BIT)
    if mantissa > 0:
        exponent = max(field, 1) - EXPONENT_SHIFT + bit_count((mantissa & (-mantissa)) - 1)
    return exponent


@kernel
def find_lowest_bit_kernel(points: array(dtype=vec3), runs: Runs, lowest: array(dtype=int32)):
    i = tid()
    bit = int(NO_BIT)
    for j in elements_of(i, runs):
        p = points[j]
        bit = min(bit, min(lowest_bit_of(p[0]), min(lowest_bit_of(p[1]), lowest_bit_of(p[2]))))
    lower_int(lowest, row_of(i, runs), bit)


def find_lowest_bits(points: Points) -> Integers:
    """Partial results, int32, for `bit_of` on the host. No sync."""
    runs = Runs(points.size, points.device, RUN_POINTS)
    lowest = full(runs.rows, NO_BIT, int32, points.device)
    launch(find_lowest_bit_kernel, runs.threads, [points, runs, lowest])
    return lowest


def bit_of(lowest: np.ndarray) -> int:
    """Exponent of the lowest bit. 0 if all coordinates are zero."""
    bit = int(lowest.min())
    return 0 if bit == NO_BIT else bit


def lowest_bit(points: Points) -> int:
    """Exponent of the lowest bit of finite vec3 points. 0 if all are zero (one sync)."""
    return bit_of(download(find_lowest_bits(points)))  # sync
