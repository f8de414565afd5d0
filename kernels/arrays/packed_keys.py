"""A number that is not negative above an index, in one 64-bit key: keys in order are numbers in order, ties by index.

The bits of a float32 that is not negative compare as the number does, so a minimum over keys (an atomic one too) finds
the least number and the index that goes with it.
"""

from ..lang import array, atomic_min, bits_float, float_bits, func, int64

INDEX_MASK = 0xFFFF_FFFF  # the half of a key that holds the index
NO_KEY = 0x7FFF_FFFF_FFFF_FFFF  # beyond every key: what a minimum begins with


@func
def pack_bits(bits: int, index: int) -> int64:
    """The key of a number given by its bits; of a whole number, by itself."""
    return (int64(bits) << 32) | int64(index)


@func
def pack_key(number: float, index: int) -> int64:
    """The key of a number and an index."""
    return pack_bits(float_bits(number), index)


@func
def key_bits(key: int64) -> int:
    """The bits of a key's number."""
    return int(key >> 32)


@func
def key_number(key: int64) -> float:
    """A key's number."""
    return bits_float(key_bits(key))


@func
def key_index(key: int64) -> int:
    """A key's index."""
    return int(key & int64(INDEX_MASK))


@func
def key_limit(number: float) -> int64:
    """The largest key of a number: keys of numbers up to it lie up to this one."""
    return ((int64(float_bits(number)) + 1) << 32) - 1


@func
def last_key(bits: int) -> int64:
    """The largest key of a number given by its bits."""
    return (int64(bits) << 32) | int64(INDEX_MASK)


@func
def offer_cell(cell: int, depth: float, index: int, words: array(dtype=int64)):
    """Keep the nearer of a cell's content and this one.

    The plain read can only be too large, as words only shrink; it saves the atomic where it cannot win. The atomic
    settles the race for the cell.
    """
    word = pack_key(depth, index)
    if word < words[cell]:
        atomic_min(words, cell, word)
