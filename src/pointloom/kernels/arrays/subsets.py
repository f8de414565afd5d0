"""Row subsets: every k-th, random, listed, or all others."""

from ..array_types import Device, Indices, Mask
from ..lang import array, compute, func, int32, int64, kernel, launch, tid, uint8
from ..memory import empty, zeros
from .random import random_bits
from .select import invert_mask, positions_of
from .sort import argsort_keys

KEY_BITS = 62  # maximum bits of a random key
WORD_BITS = 63  # of a sort key with its row index: sorted as one number
ROW_STREAM = 0x20000000  # of the random numbers: those of the samples and noise that made the rows have other streams


@kernel
def step_rows_kernel(step: int, rows: array(dtype=int32)):
    i = tid()
    rows[i] = i * step


@func
def random_key(seed: int, row: int, dropped_bits: int) -> int64:
    """62 random bits without the lowest few."""
    words = random_bits(seed, row, ROW_STREAM)
    return ((int64(words[0]) << 30) | (int64(words[1]) >> 2)) >> int64(dropped_bits)


@kernel
def draw_keys_kernel(seed: int, dropped_bits: int, keys: array(dtype=int64)):
    i = tid()
    keys[i] = random_key(seed, i, dropped_bits)


@kernel
def mark_rows_kernel(rows: array(dtype=int32), mask: array(dtype=uint8)):
    """Flag the listed rows. Duplicate writers write the same."""
    i = tid()
    mask[rows[i]] = 1


def step_rows(count: int, step: int, device: Device) -> Indices:
    return compute(step_rows_kernel, -(-count // step), [min(step, count)], int32, device)


def draw_rows(count: int, drawn: int, seed: int, device: Device) -> Indices:
    """`drawn` of `count` rows without repeats, uniform and ascending, by random keys from seed and row."""
    if drawn == 0:
        return empty(0, int32, device)
    bits = WORD_BITS - max(1, (count - 1).bit_length())
    keys = compute(draw_keys_kernel, count, [seed, KEY_BITS - bits], int64, device)
    _, order = argsort_keys(keys, bits)
    return sort_rows(order[:drawn], count, are_distinct=True)


def sort_rows(rows: Indices, count: int, are_distinct: bool = False) -> Indices:
    """Sorted unique rows of a list. One sync, none if they are known to be distinct."""
    return positions_of(_mark(rows, count), rows.size if are_distinct else None)


def other_rows(rows: Indices, count: int, are_distinct: bool = False) -> Indices:
    """Rows of `count` that are not listed, ascending. One sync, none if the list is distinct."""
    return positions_of(invert_mask(_mark(rows, count)), count - rows.size if are_distinct else None)


def _mark(rows: Indices, count: int) -> Mask:
    mask = zeros(count, uint8, rows.device)
    launch(mark_rows_kernel, rows.size, [rows, mask])
    return mask
