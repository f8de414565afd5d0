"""A PNG file's chunks and its stream of pixels, held against its header before a decoder sees them.

Decoders skip the checksums of the pixels, and where the stream ends before the picture does they leave the rest black:
no depth where there was some. Here every checksum is verified, and the stream is inflated and its length compared with
what size, depth, colour type and interlacing ask for. What goes on to the decoder is a PNG with the same rows, stored,
so that they are inflated once, and without what is no pixel: texts and profiles, however much they would unpack to.

Source: W3C, Portable Network Graphics (third edition), sections 5, 8.1, 10 and 11.2.
"""

from __future__ import annotations

import struct
import zlib
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from ...core.errors import FileError

PNG_MAGIC = b"\x89PNG\r\n\x1a\n"

# Channels of each colour type, and the bits that a channel may have.
_COLOR_TYPES = {
    0: (1, (1, 2, 4, 8, 16)), 2: (3, (8, 16)), 3: (1, (1, 2, 4, 8)), 4: (2, (8, 16)), 6: (4, (8, 16)),
}  # fmt: skip

# Adam7: first column and row of each pass, and the steps between its pixels.
_PASSES = ((0, 0, 8, 8), (4, 0, 8, 8), (0, 4, 4, 8), (2, 0, 4, 4), (0, 2, 2, 4), (1, 0, 2, 2), (0, 1, 1, 2))

_NEEDED = (b"IHDR", b"PLTE", b"tRNS")
_LAST_FILTER = 4  # Paeth's

_REMEDY = "Fetch or write the file again"


@dataclass(frozen=True)
class PngHeader:
    """What the first chunk says; `channels` and `bits` are those of a pixel as stored, a palette's index being one."""

    width: int
    height: int
    bits: int
    channels: int
    is_interlaced: bool

    def passes(self) -> Iterator[tuple[int, int]]:
        """Rows of each pass that has any, and the bytes of a row, the first of which names its filter."""
        for column, row, across, down in _PASSES if self.is_interlaced else ((0, 0, 1, 1),):
            width = (self.width - column + across - 1) // across
            height = (self.height - row + down - 1) // down
            if width > 0 and height > 0:
                yield height, 1 + (width * self.channels * self.bits + 7) // 8


def parse_png_header(path: Any, start: bytes) -> PngHeader:
    """The header of a PNG file, from its first 33 bytes.

    Raises:
        FileError: Damaged, or a combination that PNG does not have.
    """
    if len(start) < 33 or start[8:16] != b"\0\0\0\rIHDR" or zlib.crc32(start[12:29]) != _uint32(start, 29):
        raise FileError(path, "damaged PNG header", where="byte 8", remedy=_REMEDY)
    width, height, bits, color_type, compression, filtering, interlace = struct.unpack(">IIBBBBB", start[16:29])
    if color_type not in _COLOR_TYPES:
        raise FileError(path, f"unknown PNG colour type {color_type}", where="byte 25", remedy=_REMEDY)
    channels, allowed = _COLOR_TYPES[color_type]
    if bits not in allowed:
        reason = f"PNG has no {bits} bits a channel for colour type {color_type}"
        raise FileError(path, reason, where="byte 24", remedy=_REMEDY)
    if compression or filtering or interlace > 1:
        reason = f"unknown PNG compression {compression}, filter {filtering} or interlacing {interlace}"
        raise FileError(path, reason, where="byte 26", remedy=_REMEDY)
    return PngHeader(width, height, bits, channels, bool(interlace))


def whole_png(path: Any, data: bytes) -> bytes:
    """The same picture as a PNG whose stream is stored, once all of it is there and nothing more.

    Raises:
        FileError: Cut off, damaged, an animation, or a stream of pixels that is shorter or longer than the header asks.
    """
    header = parse_png_header(path, data[:33])
    chunks, stream = _split_chunks(path, data)
    rows = _inflate(path, stream, header)
    return b"".join((PNG_MAGIC, *chunks, _chunk(b"IDAT", zlib.compress(rows, 0)), _chunk(b"IEND", b"")))


def _split_chunks(path: Any, data: bytes) -> tuple[list[bytes], bytes]:
    """The chunks that a decoder needs before the pixels, and the pixels' stream; all are of a right checksum."""
    view, place, kind, last = memoryview(data), len(PNG_MAGIC), b"", b""
    needed, pixels = [], []
    while kind != b"IEND":
        if place + 12 > len(data):
            raise FileError(path, "cut off: the end of the PNG is missing", where=f"byte {len(data)}", remedy=_REMEDY)
        length, kind = _uint32(data, place), data[place + 4 : place + 8]
        end = place + 8 + length
        if end + 4 > len(data):
            reason = f"cut off or damaged: {length} bytes announced, {len(data) - place - 12} there"
            raise FileError(path, reason, where=f"byte {place}", remedy=_REMEDY)
        if zlib.crc32(view[place + 4 : end]) != _uint32(data, end):
            reason = "damaged: a PNG checksum does not fit"
            raise FileError(path, reason, where=f"bytes {place} to {end + 4}", remedy=_REMEDY)
        if kind == b"acTL":
            raise FileError(path, "an animation", where=f"byte {place}", remedy="Store its frames one by one")
        if kind == b"IHDR" and place > len(PNG_MAGIC):
            raise FileError(path, "damaged: a second PNG header", where=f"byte {place}", remedy=_REMEDY)
        if kind == b"IDAT":
            if pixels and last != b"IDAT":
                raise FileError(path, "damaged: its pixels are not in one run", where=f"byte {place}", remedy=_REMEDY)
            pixels.append(view[place + 8 : end])
        elif kind in _NEEDED and not pixels:
            needed.append(data[place : end + 4])
        elif kind[:1].isupper() and kind != b"IEND":
            reason = f"damaged: a chunk {kind.decode('latin-1')!r} that is unknown, or behind the pixels"
            raise FileError(path, reason, where=f"byte {place}", remedy=_REMEDY)
        place, last = end + 4, kind
    return needed, b"".join(pixels)


def _inflate(path: Any, stream: bytes, header: PngHeader) -> bytes:
    """The rows of the picture; memory follows what the stream delivers, and ends one byte behind what is asked for."""
    expected = sum(height * length for height, length in header.passes())
    inflate = zlib.decompressobj()
    try:
        rows = inflate.decompress(stream, expected + 1)
    except zlib.error as error:
        raise FileError(path, f"damaged: the stream of pixels is not zlib's ({error})", remedy=_REMEDY) from error
    asked = f"{header.width} x {header.height} pixels of {header.channels} x {header.bits} bits take {expected} bytes"
    if len(rows) > expected:
        raise FileError(path, f"damaged: {asked}, but its stream of pixels holds more", where="IDAT", remedy=_REMEDY)
    if len(rows) < expected:
        reason = f"cut off or damaged: {asked}, but its stream of pixels holds {len(rows)}"
        raise FileError(path, reason, where="IDAT", remedy=_REMEDY)
    if not inflate.eof or inflate.unused_data:
        how = "goes on behind its end" if inflate.eof else "lacks its end and checksum"
        raise FileError(path, f"damaged: the stream of pixels {how}", where="IDAT", remedy=_REMEDY)
    at = 0
    for height, length in header.passes():  # Pillow may have been told to go on behind a wrong filter
        if max(rows[at : at + height * length : length]) > _LAST_FILTER:
            raise FileError(path, "damaged: a row of pixels has an unknown filter", where="IDAT", remedy=_REMEDY)
        at += height * length
    return rows


def _chunk(kind: bytes, content: bytes) -> bytes:
    return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(content, zlib.crc32(kind)))


def _uint32(data: bytes, place: int) -> int:
    return int.from_bytes(data[place : place + 4], "big")
