"""PNG files of sound chunks and any content."""

from __future__ import annotations

import struct
import zlib


def png_of(width: int, height: int, *streams: bytes, bits: int = 16, color_type: int = 0, interlace: int = 0) -> bytes:
    """A PNG of sound chunks: a header that says this, and the streams as they are."""

    def chunk(kind: bytes, content: bytes) -> bytes:
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))

    head = struct.pack(">IIBBBBB", width, height, bits, color_type, 0, 0, interlace)
    parts = [chunk(b"IHDR", head), *(chunk(b"IDAT", stream) for stream in streams), chunk(b"IEND", b"")]
    return b"\x89PNG\r\n\x1a\n" + b"".join(parts)


def png_claiming(width: int, height: int) -> bytes:
    """A PNG with a sound header of this size and no pixels to speak of."""
    return png_of(width, height, zlib.compress(bytes(64)))


def with_checksums(data: bytes) -> bytes:
    """The same PNG with the checksum of each chunk made to fit, as far as its lengths lead."""
    data, place = bytearray(data), 8
    while place + 12 <= len(data):
        end = place + 8 + int.from_bytes(data[place : place + 4], "big")
        if end + 4 > len(data):
            break
        data[end : end + 4] = struct.pack(">I", zlib.crc32(data[place + 4 : end]))
        place = end + 4
    return bytes(data)
