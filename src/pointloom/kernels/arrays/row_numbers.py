"""Row numbers given by users, on the device: limits, negative numbers, pairs. Integer atomics, order-independent."""

import numpy as np

from ..array_types import Array2, Indices, Integers, LongIntegers
from ..lang import array, atomic_add, atomic_max, atomic_min, compute, int32, int64, kernel, launch, tid, uint8
from ..memory import download, empty, fill_column, upload, zeros
from .select import positions_of
from .unique import UniqueKeys, count_runs_kernel

EMPTY_LIMITS = (2**63 - 1, -(2**63))  # limits of an empty array
FIRST_NUMBER_FACTOR = 2**32  # factor of the first number of a pair in a 64-bit key


@kernel
def find_limits_kernel(numbers: array(dtype=int64), first: int, step: int, limits: array(dtype=int64)):
    """Minimum and maximum of every step-th number from the first on."""
    i = tid()
    number = numbers[first + i * step]
    if number < limits[0]:
        atomic_min(limits, 0, number)
    if number > limits[1]:
        atomic_max(limits, 1, number)


@kernel
def count_numbers_kernel(numbers: array(dtype=int32), counts: array(dtype=int32)):
    """Occurrences of each number, without negative ones."""
    i = tid()
    if numbers[i] >= 0:
        atomic_add(counts, numbers[i], 1)


def count_numbers(numbers: Integers, count: int) -> Integers:
    """Occurrences of 0 to count - 1 in a list, int32. Negative numbers are ignored."""
    counts = zeros(count, int32, numbers.device)
    launch(count_numbers_kernel, numbers.size, [numbers, counts])
    return counts


@kernel
def resolve_rows_kernel(numbers: array(dtype=int64), count: int64, rows: array(dtype=int32)):
    i = tid()
    number = numbers[i]
    if number < 0:
        number = number + count
    rows[i] = int(number)


@kernel
def scatter_partners_kernel(
    rows: array(dtype=int32),
    matches: array(dtype=int32),
    new_indices: array(dtype=int32),
    partners: array(dtype=int32),
    paired: array(dtype=uint8),
):
    """Partner of each row and whether it has one, from another order of the rows."""
    i = tid()
    partner = matches[i]
    is_paired = 0
    if partner >= 0:
        is_paired = 1
        if new_indices.shape[0] > 0:
            partner = new_indices[partner]
    partners[rows[i]] = partner
    paired[rows[i]] = uint8(is_paired)


@kernel
def pack_pairs_kernel(pairs: array(dtype=int32, ndim=2), keys: array(dtype=int64)):
    """Pack a pair of non-negative numbers into one key, the first above the second."""
    i = tid()
    keys[i] = int64(pairs[i, 0]) * int64(FIRST_NUMBER_FACTOR) + int64(pairs[i, 1])


@kernel
def unpack_pairs_kernel(keys: array(dtype=int64), pairs: array(dtype=int32, ndim=2)):
    i = tid()
    pairs[i, 0] = int(keys[i] // int64(FIRST_NUMBER_FACTOR))
    pairs[i, 1] = int(keys[i] % int64(FIRST_NUMBER_FACTOR))


@kernel
def write_partners_kernel(rows: array(dtype=int32), partners: array(dtype=int32), pairs: array(dtype=int32, ndim=2)):
    i = tid()
    row = rows[i]
    pairs[i, 0] = row
    pairs[i, 1] = partners[row]


def limits_of(numbers: LongIntegers, first: int = 0, step: int = 1) -> tuple[int, int]:
    """Minimum and maximum of every step-th int64 device number (one sync). At least one is needed."""
    limits = upload(np.array(EMPTY_LIMITS, np.int64), int64, numbers.device)
    launch(find_limits_kernel, (numbers.size - first + step - 1) // step, [numbers, first, step, limits])
    low, high = download(limits)  # sync
    return int(low), int(high)


def resolve_rows(numbers: LongIntegers, count: int) -> Indices:
    """int64 numbers in -count .. count - 1 as int32 rows."""
    return compute(resolve_rows_kernel, numbers.size, [numbers, count], int32, numbers.device)


def run_lengths(offsets: Indices) -> Integers:
    """Lengths of runs, int32 (n), from their offsets, int32 (n + 1)."""
    return compute(count_runs_kernel, offsets.size - 1, [offsets], int32, offsets.device)


def pair_up(left: Integers, right: Integers) -> Array2[int32]:
    """Pairs of the numbers of two int32 arrays, int32 (n, 2)."""
    pairs = empty((left.size, 2), int32, left.device)
    for column, numbers in enumerate((left, right)):
        fill_column(pairs, column, numbers)
    return pairs


def distinct_pairs(pairs: Array2[int32]) -> Array2[int32]:
    """Sorted unique pairs of int32 (m, 2), none negative. One sync."""
    keys = compute(pack_pairs_kernel, pairs.shape[0], [pairs], int64, pairs.device)
    unique = UniqueKeys(keys)
    distinct = empty((unique.count, 2), int32, pairs.device)
    launch(unpack_pairs_kernel, unique.count, [unique.keys, distinct])
    return distinct


def list_partners(count: int, rows: Indices, matches: Integers, new_indices: Integers) -> Array2[int32]:
    """Pairs (row, partner) by row, one sync; `matches`: partners of `rows` or -1, in `new_indices` unless empty."""
    partners, paired = empty(count, int32, rows.device), zeros(count, uint8, rows.device)
    launch(scatter_partners_kernel, rows.size, [rows, matches, new_indices, partners, paired])
    paired_rows = positions_of(paired)
    pairs = empty((paired_rows.size, 2), int32, rows.device)
    launch(write_partners_kernel, paired_rows.size, [paired_rows, partners, pairs])
    return pairs
