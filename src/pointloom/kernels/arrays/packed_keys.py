"""A non-negative number above an index in one 64-bit key, ordered by number, then index.

Bits of non-negative float32 values compare as the values, so a minimum over keys includes the index.
"""

from ..lang import array, atomic_min, bits_float, float_bits, func, int64

BYTE_MASK = 0xFF
INDEX_MASK = 0xFFFF_FFFF  # the half of a key with the index
NO_KEY = 0x7FFF_FFFF_FFFF_FFFF  # above every key: initial value of a minimum


@func
def pack_bits(bits: int, index: int) -> int64:
    """Key of a number given by its bits, or of an integer."""
    return (int64(bits) << 32) | int64(index)


@func
def pack_key(number: float, index: int) -> int64:
    return pack_bits(float_bits(number), index)


@func
def key_bits(key: int64) -> int:
    return int(key >> 32)


@func
def key_number(key: int64) -> float:
    return bits_float(key_bits(key))


@func
def key_index(key: int64) -> int:
    return int(key & int64(INDEX_MASK))


@func
def key_limit(number: float) -> int64:
    return ((int64(float_bits(number)) + 1) << 32) - 1


@func
def last_key(bits: int) -> int64:
    """Largest key of a number given by its bits."""
    return (int64(bits) << 32) | int64(INDEX_MASK)


@func
def offer_cell(cell: int, depth: float, index: int, words: array(dtype=int64)):
    """Keep the nearer content of a cell (the atomic resolves the race); words only decrease: stale reads are safe."""
    word = pack_key(depth, index)
    if word < words[cell]:
        atomic_min(words, cell, word)
