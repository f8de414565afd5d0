"""Bit sets of samples along grid rows, 32 per int32 word, with shifts between neighbors.

A row has `width` words. Bits beyond its end are zero. Right shifts of int32 copy the sign bit, so arithmetic on the
highest bit goes through uint32.
"""

from ..lang import array, bit_count, func, int32, uint32

WORD_BITS = 32  # samples per word
ALL_BITS = -1  # all bits set
LOW_31 = 0x7FFF_FFFF  # clears the sign bits of a right shift


@func
def lowest_bit(word: int) -> int:
    """Index of the lowest bit set. The word is not zero."""
    w = uint32(word)
    return bit_count(int((w & (~w + 1)) - 1))


@func
def bits_below(index: int) -> int:
    return int((1 << uint32(index)) - 1)


@func
def bit(word: int, index: int) -> int:
    return (word >> index) & 1


@func
def above(words: array(dtype=int32), row: int, w: int, width: int) -> int:
    """Word w of a row shifted by one sample: bit j is sample j + 1, zero beyond the row."""
    carry = 0
    if w + 1 < width:
        carry = words[row * width + w + 1] << 31
    return ((words[row * width + w] >> 1) & LOW_31) | carry


@func
def with_below(words: array(dtype=int32), row: int, w: int, width: int) -> int:
    """Bit j is set if sample j or j - 1 is."""
    word = words[row * width + w]
    carry = 0
    if w > 0:
        carry = (words[row * width + w - 1] >> 31) & 1
    return word | (word << 1) | carry


@func
def has_next(w: int, nz: int) -> int:
    left = nz - 1 - w * WORD_BITS
    mask = int(ALL_BITS)
    if left < WORD_BITS:
        mask = bits_below(max(left, 0))
    return mask
