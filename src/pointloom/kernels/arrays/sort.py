"""Stable sort of 64-bit keys.

CUDA: Warp's radix sort. CPU: keys packed with positions if both fit into 63 bits, else Warp's radix sort. Packed keys
are sorted by NumPy on one core, or if there are many and that is faster, by radix_sort.py on all cores. The order is
the same.
"""

import functools
import itertools
import time

import numpy as np
import warp as wp

from ..array_types import Device, Indices, Integers, Keys, LongIntegers
from ..lang import array, compute, func, int32, int64, kernel, launch, struct, tid
from ..language import cpu_pool, device_copies
from ..language.device_lock import lock_for
from ..memory import download, empty, host_view, rows_of
from .radix_sort import radix_argsort

MIN_RADIX = 1 << 14  # keys: NumPy sorts fewer faster
RADIX_SECONDS = 12e-9  # [s] per key and core, AMD EPYC (Zen 4)
SPREAD = 0x9E3779B97F4A7C15  # multiples of it, modulo 2^64, are spread like random words
MIN_RUN = 128  # mean run length in keys: shorter runs are sorted faster together than from a Python loop


@kernel
def fill_positions_kernel(positions: array(dtype=int32)):
    i = tid()
    positions[i] = i


def positions(count: int, device: Device) -> Indices:
    indices = empty(count, int32, device)
    launch(fill_positions_kernel, count, [indices])
    return indices


@kernel
def list_descending_keys_kernel(scores: array(dtype=int32), max_score: int, keys: array(dtype=int64)):
    i = tid()
    keys[i] = int64(max_score - scores[i])


def descending_keys(scores: Integers, max_score: int) -> LongIntegers:
    """Keys of int32 scores whose ascending order is that of descending scores."""
    return compute(list_descending_keys_kernel, scores.size, [scores, max_score], int64, scores.device)


@struct
class SortKeys:
    """Keys written with `put_key`, then sorted with `sort`, without a copy on CUDA, where they include scratch."""

    keys: array(dtype=int64)
    positions: array(dtype=int32)

    def __init__(self, count: int, device: Device) -> None:
        self.count, self.device = count, device
        room = 2 * count if device.is_cuda else 0
        self.keys, self.positions = empty(room or count, int64, device), empty(room, int32, device)

    def sort(self, bit_count: int = 63, starts: np.ndarray | None = None) -> tuple[LongIntegers, Integers]:
        """(sorted keys, order) as of `argsort_keys`. Consumes the keys."""
        if not self.device.is_cuda or not self.count:
            return argsort_keys(self.keys, bit_count, starts)
        _sort_pairs(self.keys, self.positions, self.count, bit_count)
        return rows_of(self.keys, 0, self.count), rows_of(self.positions, 0, self.count)


@func
def put_key(i: int, key: int64, into: SortKeys):
    into.keys[i] = key
    if i < into.positions.shape[0]:
        into.positions[i] = i


@kernel
def copy_pairs_kernel(keys: array(dtype=int64), pair_keys: array(dtype=int64), pair_values: array(dtype=int32)):
    i = tid()
    pair_keys[i] = keys[i]
    pair_values[i] = i


@functools.cache
def numpy_seconds() -> float:
    """Seconds per key of NumPy's sort, of which processors differ tenfold: its AVX-512 code is slow on AMD's Zen 4."""
    words, seconds = (np.arange(MIN_RADIX, dtype=np.uint64) * np.uint64(SPREAD)).view(np.int64), []
    for _ in range(3):
        begin = time.perf_counter()
        np.sort(words)
        seconds.append(time.perf_counter() - begin)
    return min(seconds) / MIN_RADIX


def argsort_keys(keys: Keys, bit_count: int = 63, starts: np.ndarray | None = None) -> tuple[Keys, Integers]:
    """Stable order of non-negative keys (unchanged): (sorted keys int64 (n), order int32 (n)). 40 B per key. `starts`:
    boundaries of runs with ascending key ranges, if known. The CPU sorts them separately.
    """
    count, device = keys.size, keys.device
    if count == 0:
        return empty(0, int64, device), empty(0, int32, device)
    index_bits = max(1, (count - 1).bit_length())
    if not device.is_cuda and bit_count + index_bits <= 63:
        if starts is None and count >= MIN_RADIX and RADIX_SECONDS < cpu_pool.thread_count() * numpy_seconds():
            return radix_argsort(keys, bit_count, index_bits)
        packed = download(keys) << index_bits
        packed |= np.arange(count, dtype=np.int64)
        if starts is None or len(starts) - 1 > count // MIN_RUN:
            packed.sort()
        else:
            for first, end in itertools.pairwise(starts.tolist()):
                packed[first:end].sort()
        sorted_keys, order = empty(count, int64, device), empty(count, int32, device)
        np.bitwise_and(packed, (1 << index_bits) - 1, out=host_view(order), casting="unsafe")
        np.right_shift(packed, index_bits, out=host_view(sorted_keys))
        return sorted_keys, order
    pair_keys, pair_values = empty(2 * count, int64, device), empty(2 * count, int32, device)
    launch(copy_pairs_kernel, count, [keys, pair_keys, pair_values])
    _sort_pairs(pair_keys, pair_values, count, bit_count)
    return rows_of(pair_keys, 0, count), rows_of(pair_values, 0, count)


def _sort_pairs(keys: Keys, values: Integers, count: int, bit_count: int) -> None:
    with lock_for(keys.device), keys.device.context_guard:  # Warp sorts on the current GPU
        if not device_copies.is_sorted(keys, values, count, bit_count):
            wp.utils.radix_sort_pairs(keys, values, count, 0, bit_count)
