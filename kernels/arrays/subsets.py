"""Which rows a subset holds: every k-th, a random choice, those listed or all others.

Writes 4 B a row of the result; the random choice sorts one key a row.
"""

from ..array_types import Device, Indices, Mask
from ..lang import array, func, int32, int64, kernel, launch, tid, uint8
from ..memory import empty, zeros
from .random import random_bits
from .select import invert_mask, positions_of
from .sort import argsort_keys

KEY_BITS = 62  # of a random key at most
WORD_BITS = 63  # of a sort key, its row's index included: the two are then sorted as one number


@kernel
def step_rows_kernel(step: int, rows: array(dtype=int32)):
    """rows[i] = i * step."""
    i = tid()
    rows[i] = i * step


@func
def random_key(seed: int, row: int, dropped_bits: int) -> int64:
    """62 random bits less the lowest few."""
    words = random_bits(seed, row, 0)
    return ((int64(words[0]) << 30) | (int64(words[1]) >> 2)) >> int64(dropped_bits)


@kernel
def draw_keys_kernel(seed: int, dropped_bits: int, keys: array(dtype=int64)):
    """A random key a row."""
    i = tid()
    keys[i] = random_key(seed, i, dropped_bits)


@kernel
def mark_rows_kernel(rows: array(dtype=int32), mask: array(dtype=uint8)):
    """1 at the rows listed; where one is listed twice, both threads write the same."""
    i = tid()
    mask[rows[i]] = 1


def step_rows(count: int, step: int, device: Device) -> Indices:
    """Rows 0, step, 2 step, ... of `count`, int32."""
    rows = empty(-(-count // step), int32, device)
    launch(step_rows_kernel, rows.size, [min(step, count), rows])
    return rows


def draw_rows(count: int, drawn: int, seed: int, device: Device) -> Indices:
    """`drawn` of `count` rows without repeats, each set as likely as any other; int32, ascending.

    Rows are ordered by a random number of 63 bits less those of an index (38 bits for 20 million rows), and the first
    are taken. The numbers depend on nothing but the seed and the count, so neither does the choice.
    """
    if drawn == 0:
        return empty(0, int32, device)
    bits = WORD_BITS - max(1, (count - 1).bit_length())
    keys = empty(count, int64, device)
    launch(draw_keys_kernel, count, [seed, KEY_BITS - bits, keys])
    _, order = argsort_keys(keys, bits)
    return sort_rows(order[:drawn], count, are_distinct=True)


def sort_rows(rows: Indices, count: int, are_distinct: bool = False) -> Indices:
    """The rows of a list, each once, ascending; one sync, none where it is known that each is listed once."""
    return positions_of(_mark(rows, count), rows.size if are_distinct else None)


def other_rows(rows: Indices, count: int, are_distinct: bool = False) -> Indices:
    """The rows of `count` that a list leaves out, ascending; one sync, none where each is listed once."""
    return positions_of(invert_mask(_mark(rows, count)), count - rows.size if are_distinct else None)


def _mark(rows: Indices, count: int) -> Mask:
    mask = zeros(count, uint8, rows.device)
    launch(mark_rows_kernel, rows.size, [rows, mask])
    return mask
