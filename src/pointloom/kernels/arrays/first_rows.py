"""First of equal rows of three integers, by an ordered hash table of row numbers.

Amble and Knuth, "Ordered hash tables", The Computer Journal 17, 1974: row numbers ascend along a probe sequence, so
insertion needs only `atomic_min`, and the first equal row of a probe is the lowest one. O(n) time, about 30 B per row.
"""

from ..array_types import Cells, Indices, Mask
from ..lang import array, atomic_min, compute, func, int32, int64, kernel, launch, tid, uint8, vec3i
from ..memory import full
from .hash_table import mix_bits

EMPTY_SLOT = 0x7FFFFFFF  # an empty slot, larger than any row number
MIN_SLOTS_PER_ROW = 2  # minimum number of slots per row
LOW_WORD = 0xFFFFFFFF


@func
def hash_row(row: vec3i) -> int64:
    h = mix_bits((int64(row[0]) & int64(LOW_WORD)) | (int64(row[1]) << 32))
    return mix_bits(h + (int64(row[2]) & int64(LOW_WORD)))


@func
def same_row(a: vec3i, b: vec3i) -> int:
    same = 0
    if a[0] == b[0] and a[1] == b[1] and a[2] == b[2]:
        same = 1
    return same


@kernel
def insert_rows_kernel(rows: array(dtype=vec3i), mask: int64, slots: array(dtype=int32)):
    """Insert row numbers, moving higher ones on. The lowest of equal rows stays, others may."""
    i = tid()
    carried = i
    slot = hash_row(rows[i]) & mask
    while carried >= 0:
        old = atomic_min(slots, int(slot), carried)  # resolves the race for the slot: the lower number stays
        if old == EMPTY_SLOT:
            carried = -1
        elif same_row(rows[old], rows[carried]) == 1:
            carried = -1
        else:
            carried = max(old, carried)
            slot = (slot + 1) & mask


@func
def find_row(row: vec3i, rows: array(dtype=vec3i), mask: int64, slots: array(dtype=int32)) -> int:
    """Number of the first row equal to a row of the table."""
    slot = hash_row(row) & mask
    first = slots[int(slot)]
    while same_row(rows[first], row) == 0:
        slot = (slot + 1) & mask
        first = slots[int(slot)]
    return first


@kernel
def find_rows_kernel(rows: array(dtype=vec3i), mask: int64, slots: array(dtype=int32), firsts: array(dtype=int32)):
    i = tid()
    firsts[i] = find_row(rows[i], rows, mask, slots)


@kernel
def mask_first_rows_kernel(
    rows: array(dtype=vec3i), mask: int64, slots: array(dtype=int32), of_first: int, marks: array(dtype=uint8)
):
    i = tid()
    first = find_row(rows[i], rows, mask, slots)
    marks[i] = uint8(of_first if first == i else 1 - of_first)


def _slots_of(rows: Cells) -> tuple[Indices, int]:
    """The hash table, and the mask of its slot numbers."""
    mask = (1 << (MIN_SLOTS_PER_ROW * max(1, rows.size) - 1).bit_length()) - 1
    slots = full(mask + 1, EMPTY_SLOT, int32, rows.device)
    launch(insert_rows_kernel, rows.size, [rows, mask, slots])
    return slots, mask


def first_rows(rows: Cells) -> Indices:
    """Number of the first row equal to each one, int32 [n]."""
    slots, mask = _slots_of(rows)
    return compute(find_rows_kernel, rows.size, [rows, mask, slots], int32, rows.device)


def mask_first_rows(rows: Cells, of_first: int = 1) -> Mask:
    """uint8 [n]: `of_first` (0 or 1) for rows that are the first of equal ones, the other value for the others."""
    slots, mask = _slots_of(rows)
    return compute(mask_first_rows_kernel, rows.size, [rows, mask, slots, of_first], uint8, rows.device)
