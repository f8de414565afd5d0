"""Stable radix sort of 64-bit keys on all cores of the CPU, from the least significant digit on.

Keys are packed with their positions into one number. For each digit, every block of keys counts its digits, a scan
gives the first place of each digit and block, and the blocks move their keys there. The result does not depend on the
blocks.
"""

from ..array_types import Integers, Keys, LongIntegers
from ..lang import array, int32, int64, kernel, launch, tid
from ..memory import empty

DIGIT = 8  # bits of a digit: more places than pages of a small TLB would be slower
DIGITS = 1 << DIGIT
MIN_BLOCK, MAX_BLOCKS = 1 << 14, 64


@kernel(for_cpu=True)
def pack_keys_kernel(keys: array(dtype=int64), index_bits: int, packed: array(dtype=int64)):
    i = tid()
    packed[i] = (keys[i] << int64(index_bits)) | int64(i)


@kernel(for_cpu=True)
def count_digits_kernel(packed: array(dtype=int64), shift: int, size: int, places: array(dtype=int32)):
    b = tid()
    row = b * DIGITS
    for d in range(row, row + DIGITS):
        places[d] = 0
    for i in range(b * size, min((b + 1) * size, packed.shape[0])):
        d = row + int((packed[i] >> int64(shift)) & int64(DIGITS - 1))
        places[d] = places[d] + 1


@kernel(for_cpu=True)
def scan_digits_kernel(blocks: int, places: array(dtype=int32)):
    """One thread: replace counts by the places of the first key of each digit and block."""
    i = tid()
    place = i
    for d in range(DIGITS):
        for b in range(blocks):
            count = places[b * DIGITS + d]
            places[b * DIGITS + d] = place
            place += count


@kernel(for_cpu=True)
def move_keys_kernel(
    packed: array(dtype=int64), shift: int, size: int, places: array(dtype=int32), moved: array(dtype=int64)
):
    b = tid()
    row = b * DIGITS
    for i in range(b * size, min((b + 1) * size, packed.shape[0])):
        key = packed[i]
        d = row + int((key >> int64(shift)) & int64(DIGITS - 1))
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
    size = max(MIN_BLOCK, -(-count // MAX_BLOCKS))
    blocks = -(-count // size)
    packed, moved, places = (
        empty(n, kind, device) for n, kind in ((count, int64), (count, int64), (blocks * DIGITS, int32))
    )
    launch(pack_keys_kernel, count, [keys, index_bits, packed])
    for shift in range(index_bits, index_bits + bit_count, DIGIT):
        launch(count_digits_kernel, blocks, [packed, shift, size, places])
        launch(scan_digits_kernel, 1, [blocks, places])
        launch(move_keys_kernel, blocks, [packed, shift, size, places, moved])
        packed, moved = moved, packed
    sorted_keys, order = empty(count, int64, device), empty(count, int32, device)
    launch(unpack_keys_kernel, count, [packed, index_bits, sorted_keys, order])
    return sorted_keys, order
