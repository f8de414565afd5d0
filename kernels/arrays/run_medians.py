"""Medians over runs of numbers: one sort of (run, number) pairs for all runs together.

A number's bits are turned so that they order as the number does, and stand below the number of its run in a 64-bit
key. 12 B written a number beside the sort. Of a run of m sorted numbers the median is that at position m // 2.
"""

import numpy as np

from ..array_types import Indices, Integers, Scalars
from ..lang import array, bits_float, float32, float_bits, func, int32, int64, kernel, launch, tid
from ..memory import download, empty
from .sort import SortKeys, put_key

MAGNITUDE = 0x7FFF_FFFF  # the bits below the sign
LOWEST = 0x8000_0000  # turns signed into unsigned order
LOW_WORD = 0xFFFF_FFFF
KEY_BITS = 32  # bits of a number


@func
def turn_bits(bits: int) -> int:
    """Bits of a float as an integer that orders as the float does, and back."""
    turned = bits
    if bits < 0:
        turned = bits ^ MAGNITUDE
    return turned


@kernel
def encode_numbers_kernel(values: array(dtype=float32), runs: array(dtype=int32), keys: SortKeys):
    """The run above the number."""
    i = tid()
    number = int64(turn_bits(float_bits(values[i]))) + int64(LOWEST)
    put_key(i, (int64(runs[i]) << int64(KEY_BITS)) | number, keys)


@kernel
def pick_numbers_kernel(keys: array(dtype=int64), starts: array(dtype=int32), found: array(dtype=float32)):
    """The first numbers of all sorted runs, then those in the middle, then the last ones."""
    i = tid()
    runs = starts.shape[0] - 1
    first = starts[i]
    last = starts[i + 1] - 1
    middle = first + (last + 1 - first) // 2
    found[i] = bits_float(turn_bits(int((keys[first] & int64(LOW_WORD)) - int64(LOWEST))))
    found[runs + i] = bits_float(turn_bits(int((keys[middle] & int64(LOW_WORD)) - int64(LOWEST))))
    found[2 * runs + i] = bits_float(turn_bits(int((keys[last] & int64(LOW_WORD)) - int64(LOWEST))))


def find_statistics(values: Scalars, runs: Integers, starts: Indices) -> Scalars:
    """The least numbers of all runs, then the medians, then the largest; as of `order_statistics`, but no sync."""
    device, count = values.device, starts.size - 1
    keys = SortKeys(values.size, device)
    launch(encode_numbers_kernel, values.size, [values, runs, keys])
    sorted_keys, _ = keys.sort(KEY_BITS + max(1, count.bit_length()))
    found = empty(3 * count, float32, device)
    launch(pick_numbers_kernel, count, [sorted_keys, starts, found])
    return found


def order_statistics(values: Scalars, runs: Integers, starts: Indices) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The least, the median and the largest number of each run.

    Args:
        values: float32 device array of shape [m], none NaN.
        runs: int32 device array of shape [m], the run of each number, ascending.
        starts: int32 device array of shape [r + 1], where the runs begin; none empty.

    Returns:
        (lows, medians, highs): float32 NumPy arrays of shape [r].
    """
    lows, medians, highs = download(find_statistics(values, runs, starts)).reshape(3, starts.size - 1)  # sync
    return lows, medians, highs
