"""PNG files with valid chunks and any content."""

import struct
import zlib


def png_of(width: int, height: int, *streams: bytes, bits: int = 16, color_type: int = 0, interlace: int = 0) -> bytes:
    """A PNG of valid chunks: a header with these values and the given streams."""

    def chunk(kind: bytes, content: bytes) -> bytes:
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))

    head = struct.pack(">IIBBBBB", width, height, bits, color_type, 0, 0, interlace)
    parts = [chunk(b"IHDR", head), *(chunk(b"IDAT", stream) for stream in streams), chunk(b"IEND", b"")]
    return b"\x89PNG\r\n\x1a\n" + b"".join(parts)


def png_claiming(width: int, height: int) -> bytes:
    """A PNG with a valid header of this size and hardly any pixels."""
    return png_of(width, height, zlib.compress(bytes(64)))


def with_checksums(data: bytes) -> bytes:
    """The same PNG with corrected checksums of all chunks that its lengths lead to."""
    data, offset = bytearray(data), 8
    while offset + 12 <= len(data):
        end = offset + 8 + int.from_bytes(data[offset : offset + 4], "big")
        if end + 4 > len(data):
            break
        data[end : end + 4] = struct.pack(">I", zlib.crc32(data[offset + 4 : end]))
        offset = end + 4
    return bytes(data)
