"""Numbers of a rank in runs of float32 numbers, in one launch: one block of a GPU, or one CPU thread, per run.

A run of a few numbers compares all pairs. Else a digit of the result is found per pass, from the highest one, by the
counts of the next digit over the numbers that have the digits so far. The median of m numbers is that of rank m // 2.
"""

from ..array_types import Indices, Integers, Scalars
from ..lang import (
    BLOCK_THREADS,
    WARP,
    array,
    ballot,
    bit_count,
    bits_float,
    float32,
    float_bits,
    func,
    int32,
    kernel,
    lane,
    launch,
    shuffle,
    sync_block,
    tid,
)
from ..memory import empty
from .blocks import WARPS, block_threads
from .bounds import MAGNITUDE_BITS, number_of_bits, ordered_bits

NUMBER_BITS = 32
DIGIT_BITS, DIGITS = 8, 256  # of a pass on the CPU
BLOCK_DIGIT_BITS, BLOCK_DIGITS = 4, 16  # of a pass on a GPU: a lane counts the numbers of one digit
RANK_SCRATCH = 256  # int32 of a run: counts of the digits, or of those of all warps for this pass and the next


@func
def turn_sign(number: int) -> int:
    """The integer with its highest bit inverted: integers in order become bits in order, and back."""
    turned = (number + MAGNITUDE_BITS) + 1
    if number >= 0:
        turned = (number - MAGNITUDE_BITS) - 1
    return turned


@func
def rank_among(j: int, first: int, last: int, values: array(dtype=float32)) -> int:
    """The rank of values[j] among those from `first` to `last`. Equal numbers count by position."""
    own = ordered_bits(values[j])
    rank = int(0)
    for k in range(first, last):
        other = ordered_bits(values[k])
        if other < own or (other == own and k < j):
            rank += 1
    return rank


@func
def number_of_few(
    i: int, at: int, first: int, last: int, rank: int, values: array(dtype=float32), counts: array(dtype=int32)
) -> float:
    """The number of a rank among a few. `counts[at]` is scratch."""
    for j in range(first, last):
        if rank_among(j, first, last, values) == rank:
            counts[at] = float_bits(values[j])
    return bits_float(counts[at])


@number_of_few.on_cuda
def number_of_few_in_block(
    i: int, at: int, first: int, last: int, rank: int, values: array(dtype=float32), counts: array(dtype=int32)
) -> float:
    j = first + i % BLOCK_THREADS
    if j < last:
        if rank_among(j, first, last, values) == rank:
            counts[at] = float_bits(values[j])
    sync_block()
    found = bits_float(counts[at])
    sync_block()
    return found


@func
def number_by_digits(
    i: int, at: int, first: int, last: int, rank: int, values: array(dtype=float32), counts: array(dtype=int32)
) -> float:
    """The number of a rank by its digits. `counts`: scratch from `at` on."""
    digits = int(0)  # found so far
    mask = int(0)  # their bits
    left = rank + 0  # rank among the numbers with these digits
    steps = int(NUMBER_BITS // DIGIT_BITS)  # not unrolled
    for step in range(steps):
        shift = NUMBER_BITS - DIGIT_BITS * (step + 1)
        for digit in range(DIGITS):
            counts[at + digit] = 0
        for j in range(first, last):
            key = turn_sign(ordered_bits(values[j]))
            if (key & mask) == digits:
                own = at + ((key >> shift) & (DIGITS - 1))
                counts[own] = counts[own] + 1
        chosen = int(0)
        while left >= counts[at + chosen]:
            left -= counts[at + chosen]
            chosen += 1
        digits = digits | (chosen << shift)
        mask = -(1 << shift)
    return number_of_bits(turn_sign(digits))


@number_by_digits.on_cuda
def number_by_digits_in_block(
    i: int, at: int, first: int, last: int, rank: int, values: array(dtype=float32), counts: array(dtype=int32)
) -> float:
    thread = i % BLOCK_THREADS
    digits = int(0)
    mask = int(0)
    left = rank + 0
    own_digit = lane() % BLOCK_DIGITS
    turns = (last - first + BLOCK_THREADS - 1) // BLOCK_THREADS
    steps = int(NUMBER_BITS // BLOCK_DIGIT_BITS)  # not unrolled
    for step in range(steps):
        shift = NUMBER_BITS - BLOCK_DIGIT_BITS * (step + 1)
        count = int(0)  # of the warp's numbers with the digit of this lane
        for turn in range(turns):
            j = first + turn * BLOCK_THREADS + thread
            is_counted = int(0)
            digit = int(0)
            if j < last:
                key = turn_sign(ordered_bits(values[j]))
                if (key & mask) == digits:
                    is_counted = 1
                    digit = (key >> shift) & (BLOCK_DIGITS - 1)
            same = ballot(is_counted)
            for bit in range(BLOCK_DIGIT_BITS):
                lanes = ballot((digit >> bit) & 1)
                if ((own_digit >> bit) & 1) == 0:
                    lanes = lanes ^ -1
                same = same & lanes
            count += bit_count(same)
        table = at + (step % 2) * (WARPS * BLOCK_DIGITS) + own_digit
        counts[table + (thread // WARP) * BLOCK_DIGITS] = count
        sync_block()
        total = int(0)
        for warp in range(WARPS):
            total += counts[table + warp * BLOCK_DIGITS]
        chosen = int(-1)
        for digit in range(BLOCK_DIGITS):
            size = shuffle(total, digit)
            if chosen < 0:
                if left < size:
                    chosen = digit
                else:
                    left -= size
        digits = digits | (chosen << shift)
        mask = -(1 << shift)
    return number_of_bits(turn_sign(digits))


@func
def max_few() -> int:
    """Numbers of a run that are compared in pairs: on the CPU below the time of four passes over 256 digits."""
    return 32


@max_few.on_cuda
def max_few_of_block() -> int:
    return BLOCK_THREADS


@func
def number_of_rank(
    i: int, run: int, first: int, last: int, rank: int, values: array(dtype=float32), counts: array(dtype=int32)
) -> float:
    """The number of a rank, from 0 on, in values[first:last], for all threads of the block. No NaN. `counts`: scratch,
    RANK_SCRATCH per run."""
    found = float(0.0)
    if last - first <= max_few():
        found = number_of_few(i, run * RANK_SCRATCH, first, last, rank, values, counts)
    else:
        found = number_by_digits(i, run * RANK_SCRATCH, first, last, rank, values, counts)
    return found


@kernel
def find_numbers_kernel(
    values: array(dtype=float32),
    starts: array(dtype=int32),
    ranks: array(dtype=int32),
    threads: int,
    counts: array(dtype=int32),
    numbers: array(dtype=float32),
):
    i = tid()
    run = i // threads
    number = number_of_rank(i, run, starts[run], starts[run + 1], ranks[run], values, counts)
    if i % threads == 0:
        numbers[run] = number


def numbers_of_ranks(values: Scalars, starts: Indices, ranks: Integers) -> Scalars:
    """The number of a rank, from 0 on, of each run, float32 [r], without a wait. Values without NaN."""
    device, threads = values.device, block_threads(values.device)
    numbers, counts = empty(ranks.size, float32, device), empty(ranks.size * RANK_SCRATCH, int32, device)
    launch(find_numbers_kernel, ranks.size * threads, [values, starts, ranks, threads, counts, numbers])
    return numbers
