"""Stable sort of 64-bit keys.

CUDA: Warp's radix sort, and for a few keys their ranks among all, by a warp per key. CPU: keys packed with positions if
both fit into 63 bits, else Warp's radix sort. Packed keys are sorted by NumPy on one core, many by a radix sort on all
cores, from the least significant digit on: every block of keys counts its digits, a scan gives the first place of each
digit and block, and the blocks move their keys there. All give the same order.
"""

import itertools

import numpy as np
import warp as wp

from ..array_types import Device, Indices, Integers, Keys, LongIntegers
from ..lang import WARP, array, compute, func, int32, int64, kernel, launch, struct, tid
from ..language import device_copies
from ..language.device_lock import lock_for
from ..language.streams import wait_before_larger_scratch
from ..memory import download, empty, host_view, rows_of
from .lanes import sum_int_of_lanes

# NumPy sorts fewer keys faster. Of more, the radix sort takes 12 ns per key and core (AMD Zen 4). NumPy takes 50 ns
# there, and 4 ns on processors with fast compressing stores: only on one to three cores of those NumPy would be faster.
MIN_RADIX_KEYS = 1 << 14
DIGIT_BITS = 8  # more places than pages of a small TLB would be slower
DIGIT_VALUES = 1 << DIGIT_BITS
MIN_BLOCK_KEYS, MAX_BLOCKS = 1 << 14, 64  # of a pass
# Keys that CUDA ranks. Predicted for an H100, not measured: 6 us for so many, where a pass of 8 bits of the radix sort
# takes 8 us at any number below 200,000, and a key has 30 to 63 bits.
MAX_RANKED_KEYS = 4096
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


@func
def rank_of(i: int, own: int, count: int, keys: array(dtype=int64)) -> int:
    """The number of smaller keys, and of equal keys before."""
    rank = int(0)
    for j in range(count):
        if keys[j] < keys[own] or (keys[j] == keys[own] and j < own):
            rank += 1
    return rank


@rank_of.on_cuda
def rank_by_warp(i: int, own: int, count: int, keys: array(dtype=int64)) -> int:
    key = keys[own]
    before = int(0)
    turns = (count + WARP - 1) // WARP
    for turn in range(turns):
        j = turn * WARP + i % WARP
        if j < count:
            other = keys[j]
            if other < key or (other == key and j < own):
                before += 1
    return sum_int_of_lanes(before)


@kernel
def rank_keys_kernel(keys: array(dtype=int64), threads: int, ranked: array(dtype=int64), order: array(dtype=int32)):
    """Sort keys with their positions. `threads`: those per key, a warp on CUDA."""
    i = tid()
    own = i // threads
    rank = rank_of(i, own, ranked.shape[0], keys)
    if i % threads == 0:
        ranked[rank] = keys[own]
        order[rank] = own


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
        if self.count <= MAX_RANKED_KEYS:
            room = rows_of(self.keys, self.count, 2 * self.count), rows_of(self.positions, 0, self.count)
            return _rank_keys(self.keys, *room)
        return _sort_pairs(self.keys, self.positions, self.count, bit_count)


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


@kernel(for_cpu=True)
def pack_keys_kernel(keys: array(dtype=int64), index_bits: int, packed: array(dtype=int64)):
    i = tid()
    packed[i] = (keys[i] << int64(index_bits)) | int64(i)


@kernel(for_cpu=True)
def count_digits_kernel(packed: array(dtype=int64), shift: int, size: int, places: array(dtype=int32)):
    b = tid()
    row = b * DIGIT_VALUES
    for d in range(row, row + DIGIT_VALUES):
        places[d] = 0
    for i in range(b * size, min((b + 1) * size, packed.shape[0])):
        d = row + int((packed[i] >> int64(shift)) & int64(DIGIT_VALUES - 1))
        places[d] = places[d] + 1


@kernel(for_cpu=True)
def scan_digits_kernel(blocks: int, places: array(dtype=int32)):
    """One thread: replace counts by the places of the first key of each digit and block."""
    i = tid()
    place = i
    for d in range(DIGIT_VALUES):
        for b in range(blocks):
            count = places[b * DIGIT_VALUES + d]
            places[b * DIGIT_VALUES + d] = place
            place += count


@kernel(for_cpu=True)
def move_keys_kernel(
    packed: array(dtype=int64), shift: int, size: int, places: array(dtype=int32), moved: array(dtype=int64)
):
    b = tid()
    row = b * DIGIT_VALUES
    for i in range(b * size, min((b + 1) * size, packed.shape[0])):
        key = packed[i]
        d = row + int((key >> int64(shift)) & int64(DIGIT_VALUES - 1))
        place = places[d]
        places[d] = place + 1
        moved[place] = key


@kernel(for_cpu=True)
def unpack_keys_kernel(
    packed: array(dtype=int64), index_bits: int, keys: array(dtype=int64), order: array(dtype=int32)
):
    i = tid()
    key = packed[i]
    keys[i] = key >> int64(index_bits)
    order[i] = int(key & ((int64(1) << int64(index_bits)) - int64(1)))


def radix_argsort(keys: Keys, bit_count: int, index_bits: int) -> tuple[LongIntegers, Integers]:
    """(sorted keys, order) as of `argsort_keys`. Bits of keys and positions are at most 63 in all."""
    count, device = keys.size, keys.device
    size = max(MIN_BLOCK_KEYS, -(-count // MAX_BLOCKS))
    blocks = -(-count // size)
    packed, moved = empty(count, int64, device), empty(count, int64, device)
    places = empty(blocks * DIGIT_VALUES, int32, device)
    launch(pack_keys_kernel, count, [keys, index_bits, packed])
    for shift in range(index_bits, index_bits + bit_count, DIGIT_BITS):
        launch(count_digits_kernel, blocks, [packed, shift, size, places])
        launch(scan_digits_kernel, 1, [blocks, places])
        launch(move_keys_kernel, blocks, [packed, shift, size, places, moved])
        packed, moved = moved, packed
    sorted_keys, order = empty(count, int64, device), empty(count, int32, device)
    launch(unpack_keys_kernel, count, [packed, index_bits, sorted_keys, order])
    return sorted_keys, order


def argsort_keys(keys: Keys, bit_count: int = 63, starts: np.ndarray | None = None) -> tuple[Keys, Integers]:
    """Stable order of non-negative keys (unchanged): (sorted keys int64 (n), order int32 (n)). 40 B per key. `starts`:
    boundaries of runs with ascending key ranges, if known. The CPU sorts them separately.
    """
    count, device = keys.size, keys.device
    if count == 0:
        return empty(0, int64, device), empty(0, int32, device)
    index_bits = max(1, (count - 1).bit_length())
    if not device.is_cuda and bit_count + index_bits <= 63:
        if starts is None and count >= MIN_RADIX_KEYS:
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
    if device.is_cuda and count <= MAX_RANKED_KEYS:
        return _rank_keys(keys, empty(count, int64, device), empty(count, int32, device))
    pair_keys, pair_values = empty(2 * count, int64, device), empty(2 * count, int32, device)
    launch(copy_pairs_kernel, count, [keys, pair_keys, pair_values])
    return _sort_pairs(pair_keys, pair_values, count, bit_count)


def _rank_keys(keys: Keys, ranked: LongIntegers, order: Integers) -> tuple[LongIntegers, Integers]:
    launch(rank_keys_kernel, order.size * WARP, [keys, WARP, ranked, order])
    return ranked, order


def _sort_pairs(keys: Keys, values: Integers, count: int, bit_count: int) -> tuple[LongIntegers, Integers]:
    """The first pairs in order. The arrays have room for as many again."""
    with lock_for(keys.device), keys.device.context_guard:  # Warp sorts on the current GPU
        if keys.device.is_cuda:
            wait_before_larger_scratch(keys.device, count, bit_count)
        if not device_copies.is_sorted(keys, values, count, bit_count):
            wp.utils.radix_sort_pairs(keys, values, count, 0, bit_count)
    return rows_of(keys, 0, count), rows_of(values, 0, count)
