"""Validate the chunks and pixel stream of a PNG before decoding.

Decoders skip pixel checksums and fill truncated images with black (no depth). The decoder gets a verified PNG with
stored rows, without texts and profiles. W3C, Portable Network Graphics (third edition), sections 5, 8.1, 10 and 11.2.
"""

from __future__ import annotations

import struct
import zlib
from collections.abc import Iterator
from dataclasses import dataclass

from ...core.errors import FileError, FilePath

PNG_MAGIC = b"\x89PNG\r\n\x1a\n"

# Channels of each color type, and allowed bits per channel.
_COLOR_TYPES = {
    0: (1, (1, 2, 4, 8, 16)), 2: (3, (8, 16)), 3: (1, (1, 2, 4, 8)), 4: (2, (8, 16)), 6: (4, (8, 16)),
}  # fmt: skip

# Adam7: first column and row of each pass, and its pixel steps.
_ADAM7_PASSES = ((0, 0, 8, 8), (4, 0, 8, 8), (0, 4, 4, 8), (2, 0, 4, 4), (0, 2, 2, 4), (1, 0, 2, 2), (0, 1, 1, 2))

_NEEDED = (b"IHDR", b"PLTE", b"tRNS")
_LAST_FILTER = 4  # Paeth filter

_REMEDY = "Fetch or write the file again"


@dataclass(frozen=True)
class PngHeader:
    """The first chunk; `channels` and `bits` are per stored pixel, a palette index counts as one channel."""

    width: int
    height: int
    bits: int
    channels: int
    is_interlaced: bool

    def passes(self) -> Iterator[tuple[int, int]]:
        """Rows of each nonempty pass, and bytes per row including the filter byte."""
        for column, row, across, down in _ADAM7_PASSES if self.is_interlaced else ((0, 0, 1, 1),):
            width = (self.width - column + across - 1) // across
            height = (self.height - row + down - 1) // down
            if width > 0 and height > 0:
                yield height, 1 + (width * self.channels * self.bits + 7) // 8


def parse_png_header(path: FilePath, start: bytes) -> PngHeader:
    if len(start) < 33 or start[8:16] != b"\0\0\0\rIHDR" or zlib.crc32(start[12:29]) != _uint32(start, 29):
        raise FileError(path, "damaged PNG header", where="byte 8", remedy=_REMEDY)
    width, height, bits, color_type, compression, filtering, interlace = struct.unpack(">IIBBBBB", start[16:29])
    if color_type not in _COLOR_TYPES:
        raise FileError(path, f"unknown PNG color type {color_type}", where="byte 25", remedy=_REMEDY)
    channels, allowed = _COLOR_TYPES[color_type]
    if bits not in allowed:
        reason = f"PNG has no {bits} bits a channel for color type {color_type}"
        raise FileError(path, reason, where="byte 24", remedy=_REMEDY)
    if compression or filtering or interlace > 1:
        reason = f"unknown PNG compression {compression}, filter {filtering} or interlacing {interlace}"
        raise FileError(path, reason, where="byte 26", remedy=_REMEDY)
    return PngHeader(width, height, bits, channels, bool(interlace))


def checked_png(path: FilePath, data: bytes) -> bytes:
    """The same image as a PNG with a stored stream. Raises `FileError` if truncated, damaged or animated."""
    header = parse_png_header(path, data[:33])
    chunks, stream = _split_chunks(path, data)
    rows = _inflate(path, stream, header)
    return b"".join((PNG_MAGIC, *chunks, _chunk(b"IDAT", zlib.compress(rows, 0)), _chunk(b"IEND", b"")))


def _split_chunks(path: FilePath, data: bytes) -> tuple[list[bytes], bytes]:
    """The chunks needed before the pixels, and the pixel stream, with checksums verified."""
    view, offset, kind, last = memoryview(data), len(PNG_MAGIC), b"", b""
    needed, pixels = [], []
    while kind != b"IEND":
        if offset + 12 > len(data):
            raise FileError(path, "cut off: the end of the PNG is missing", where=f"byte {len(data)}", remedy=_REMEDY)
        length, kind = _uint32(data, offset), data[offset + 4 : offset + 8]
        end = offset + 8 + length
        if end + 4 > len(data):
            reason = f"cut off or damaged: {length} bytes declared, but {len(data) - offset - 12} present"
            raise FileError(path, reason, where=f"byte {offset}", remedy=_REMEDY)
        if zlib.crc32(view[offset + 4 : end]) != _uint32(data, end):
            reason = "damaged: a PNG checksum does not fit"
            raise FileError(path, reason, where=f"bytes {offset} to {end + 4}", remedy=_REMEDY)
        if kind == b"acTL":
            raise FileError(path, "is an animation", where=f"byte {offset}", remedy="Store its frames one by one")
        if kind == b"IHDR" and offset > len(PNG_MAGIC):
            raise FileError(path, "damaged: a second PNG header", where=f"byte {offset}", remedy=_REMEDY)
        if kind == b"IDAT":
            if pixels and last != b"IDAT":
                raise FileError(path, "damaged: its pixels are not in one run", where=f"byte {offset}", remedy=_REMEDY)
            pixels.append(view[offset + 8 : end])
        elif kind in _NEEDED and not pixels:
            needed.append(data[offset : end + 4])
        elif kind[:1].isupper() and kind != b"IEND":
            reason = f"damaged: a chunk {kind.decode('latin-1')!r} that is unknown, or after the pixels"
            raise FileError(path, reason, where=f"byte {offset}", remedy=_REMEDY)
        offset, last = end + 4, kind
    return needed, b"".join(pixels)


def _inflate(path: FilePath, stream: bytes, header: PngHeader) -> bytes:
    """The rows of the image. Memory is bounded by the expected size plus one byte."""
    expected = sum(height * length for height, length in header.passes())
    inflate = zlib.decompressobj()
    try:
        rows = inflate.decompress(stream, expected + 1)
    except zlib.error as error:
        raise FileError(
            path, f"damaged: the stream of pixels is not a zlib stream ({error})", remedy=_REMEDY
        ) from error
    needed = f"{header.width} x {header.height} pixels of {header.channels} x {header.bits} bits take {expected} bytes"
    if len(rows) > expected:
        raise FileError(
            path, f"damaged: {needed}, but its stream of pixels contains more", where="IDAT", remedy=_REMEDY
        )
    if len(rows) < expected:
        reason = f"cut off or damaged: {needed}, but its stream of pixels contains {len(rows)}"
        raise FileError(path, reason, where="IDAT", remedy=_REMEDY)
    if not inflate.eof or inflate.unused_data:
        how = "continues after its end" if inflate.eof else "lacks its end and checksum"
        raise FileError(path, f"damaged: the stream of pixels {how}", where="IDAT", remedy=_REMEDY)
    at = 0
    for height, length in header.passes():  # Pillow may be configured to continue after an invalid filter
        if max(rows[at : at + height * length : length]) > _LAST_FILTER:
            raise FileError(path, "damaged: a row of pixels has an unknown filter", where="IDAT", remedy=_REMEDY)
        at += height * length
    return rows


def _chunk(kind: bytes, content: bytes) -> bytes:
    return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(content, zlib.crc32(kind)))


def _uint32(data: bytes, offset: int) -> int:
    return int.from_bytes(data[offset : offset + 4], "big")
