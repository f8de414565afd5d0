"""Animated WebP, one frame at a time, and as many frames as were given.

Pillow packs each picture; the file around the pictures is written here, as animations of Pillow hold all frames in
memory and drop those that are equal.
"""

from __future__ import annotations

import io
import struct
from collections.abc import Iterable
from typing import IO

import numpy as np
from numpy.typing import NDArray

from .gif_writer import changed_box

Picture = NDArray[np.uint8]

QUALITY = 85
TICKS = 1000  # a second: WebP's unit of time
_ANIMATED, _NO_BLENDING = 0x02, 0x02
_HELD = (b"VP8 ", b"VP8L", b"ALPH")  # chunks of a picture


def write_webp(file: IO[bytes], pictures: Iterable[Picture], background: tuple[int, int, int], fps: float) -> int:
    """Write pictures as an animation that repeats.

    Args:
        file: Open for writing at its start, seekable.
        pictures: Each [h, w, 3], uint8, of one size.
        background: Red, green and blue.
        fps: Pictures a second; delays are whole milliseconds, such that the time of all is right.

    Returns:
        The number of frames.
    """
    before: Picture | None = None
    count, size = 0, 4
    for count, picture in enumerate(pictures, 1):
        if before is None:
            height, width = picture.shape[:2]
            file.write(b"RIFF\x00\x00\x00\x00WEBP")
            head = struct.pack("<I", _ANIMATED) + _three(width - 1) + _three(height - 1)
            red, green, blue = background
            size += file.write(_chunk(b"VP8X", head) + _chunk(b"ANIM", bytes([blue, green, red, 255, 0, 0])))
        left, top, right, bottom = changed_box(picture, before)
        left, top = left // 2 * 2, top // 2 * 2  # offsets are even
        delay = round(count * TICKS / fps) - round((count - 1) * TICKS / fps)
        place = _three(left // 2) + _three(top // 2) + _three(right - left - 1) + _three(bottom - top - 1)
        frame = place + _three(delay) + bytes([_NO_BLENDING]) + _packed(picture[top:bottom, left:right])
        size += file.write(_chunk(b"ANMF", frame))
        before = picture
    file.seek(4)
    file.write(struct.pack("<I", size))
    file.seek(0, io.SEEK_END)
    return count


def _packed(picture: Picture) -> bytes:
    """The chunks of one picture."""
    from PIL import Image

    held = io.BytesIO()
    Image.fromarray(np.ascontiguousarray(picture)).save(held, "WEBP", quality=QUALITY, method=4)
    data, place, found = held.getvalue(), 12, b""
    while place < len(data):
        name, size = struct.unpack_from("<4sI", data, place)
        end = place + 8 + size + size % 2
        if name in _HELD:
            found += data[place:end]
        place = end
    return found


def _chunk(name: bytes, data: bytes) -> bytes:
    return name + struct.pack("<I", len(data)) + data + b"\x00" * (len(data) % 2)


def _three(number: int) -> bytes:
    return struct.pack("<I", number)[:3]
