"""Medians over runs of numbers by one sort of (run, number) keys. The median of m sorted numbers is that at m // 2."""

import numpy as np

from ..array_types import Indices, Integers, Scalars
from ..lang import array, bits_float, float32, float_bits, func, int32, int64, kernel, launch, tid
from ..memory import download, empty
from .sort import SortKeys, put_key

MAGNITUDE_BITS = 0x7FFF_FFFF  # the bits below the sign
SIGN_BIT = 0x8000_0000  # converts signed to unsigned order
LOW_WORD = 0xFFFF_FFFF
KEY_BITS = 32  # bits of a number


@func
def flip_bits(bits: int) -> int:
    """Bits of a float as an integer of the same order, and back."""
    flipped = bits
    if bits < 0:
        flipped = bits ^ MAGNITUDE_BITS
    return flipped


@kernel
def encode_numbers_kernel(values: array(dtype=float32), runs: array(dtype=int32), run_count: int, keys: SortKeys):
    i = tid()
    quantity = i // runs.shape[0]
    run = quantity * run_count + runs[i - quantity * runs.shape[0]]
    number = int64(flip_bits(float_bits(values[i]))) + int64(SIGN_BIT)
    put_key(i, (int64(run) << int64(KEY_BITS)) | number, keys)


@func
def number_of(key: int64) -> float:
    return bits_float(flip_bits(int((key & int64(LOW_WORD)) - int64(SIGN_BIT))))


@kernel
def pick_numbers_kernel(keys: array(dtype=int64), starts: array(dtype=int32), size: int, numbers: array(dtype=float32)):
    """Of each quantity: first numbers of all sorted runs, then the middle ones, then the last."""
    i = tid()
    runs = starts.shape[0] - 1
    quantity = i // runs
    run = i - quantity * runs
    first = quantity * size + starts[run]
    last = quantity * size + starts[run + 1] - 1
    middle = first + (last + 1 - first) // 2
    at = 3 * quantity * runs + run
    numbers[at] = number_of(keys[first])
    numbers[at + runs] = number_of(keys[middle])
    numbers[at + 2 * runs] = number_of(keys[last])


def find_statistics(values: Scalars, runs: Integers, starts: Indices, quantities: int = 1) -> Scalars:
    """As `order_statistics` in one array, without sync. `values`: those of all points, one quantity after another."""
    device, count = values.device, starts.size - 1
    keys = SortKeys(values.size, device)
    launch(encode_numbers_kernel, values.size, [values, runs, count, keys])
    sorted_keys, _ = keys.sort(KEY_BITS + max(1, (quantities * count).bit_length()))
    statistics = empty(3 * quantities * count, float32, device)
    launch(pick_numbers_kernel, quantities * count, [sorted_keys, starts, runs.size, statistics])
    return statistics


def order_statistics(values: Scalars, runs: Integers, starts: Indices) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """(lows, medians, highs) of nonempty runs, NumPy float32 (r). Values without NaN, by ascending run."""
    lows, medians, highs = download(find_statistics(values, runs, starts)).reshape(3, starts.size - 1)  # sync
    return lows, medians, highs
