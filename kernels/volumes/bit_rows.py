"""Words of 32 samples along a row of a grid: one bit a sample, and the moves between neighbouring samples.

A row has `width` words; bits beyond its end are zero. Words are int32, so shifts to the right bring the sign in, and
arithmetic on the highest bit goes through uint32, where it is defined.
"""

from ..lang import array, bit_count, func, int32, uint32

WORD = 32  # samples a word
ALL = -1  # a word of ones
LOW_31 = 0x7FFF_FFFF  # clears what a shift to the right brings in


@func
def lowest_bit(word: int) -> int:
    """The place of the lowest bit set; the word is not zero."""
    w = uint32(word)
    return bit_count(int((w & (~w + 1)) - 1))


@func
def bits_below(place: int) -> int:
    """A word with the bits below a place set."""
    return int((1 << uint32(place)) - 1)


@func
def bit(word: int, place: int) -> int:
    """The bit at a place, 0 or 1."""
    return (word >> place) & 1


@func
def above(words: array(dtype=int32), row: int, w: int, width: int) -> int:
    """Word w of a row moved by one sample: bit j is sample j + 1; zero comes in at the end of the row."""
    carry = 0
    if w + 1 < width:
        carry = words[row * width + w + 1] << 31
    return ((words[row * width + w] >> 1) & LOW_31) | carry


@func
def with_below(words: array(dtype=int32), row: int, w: int, width: int) -> int:
    """Bit j is set where sample j or j - 1 is."""
    word = words[row * width + w]
    carry = 0
    if w > 0:
        carry = (words[row * width + w - 1] >> 31) & 1
    return word | (word << 1) | carry


@func
def has_next(w: int, nz: int) -> int:
    """The samples of word w that have a neighbour above them in the row."""
    left = nz - 1 - w * WORD
    mask = int(ALL)
    if left < WORD:
        mask = bits_below(max(left, 0))
    return mask
