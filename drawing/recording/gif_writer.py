"""Animated GIF, one frame at a time: one palette for all frames, and as many frames as were given.

Pillow packs each picture; the file around the pictures is written here. Pillow's own animations merge frames that are
equal and round each delay for itself, so that a recording would lose steps and play at another pace.
"""

from __future__ import annotations

import io
import struct
from collections.abc import Iterable, Sequence
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

Picture = NDArray[np.uint8]

TICKS = 100  # a second: GIF's unit of time
COLORS = 256
_FIXED = 2  # entries: the background, black for letters
_SAMPLED = 160  # [px] of the longer side of the pictures that the palette is made of
_HEADER, _TABLE = 13, 3 * COLORS  # bytes before the colour table, and in it


def make_palette(pictures: Sequence[Picture], background: tuple[int, int, int]) -> NDArray[np.uint8]:
    """Colours for all frames, from some of them: the background first, black second, shape [256, 3]."""
    from PIL import Image

    step = max(1, max(pictures[0].shape[:2]) // _SAMPLED)
    pixels = np.concatenate([picture[::step, ::step].reshape(-1, 3) for picture in pictures])
    pixels = pixels[(pixels != np.array(background, np.uint8)).any(axis=1)]
    palette = np.zeros((COLORS, 3), np.uint8)
    palette[0] = background
    if len(pixels):
        image = Image.fromarray(pixels[None])
        found = np.array(image.quantize(COLORS - _FIXED, Image.Quantize.MEDIANCUT).getpalette(), np.uint8)
        found = found.reshape(-1, 3)[: COLORS - _FIXED]
        palette[_FIXED : _FIXED + len(found)] = found
    return palette


def write_gif(file: IO[bytes], pictures: Iterable[Picture], palette: NDArray[np.uint8], fps: float) -> int:
    """Write pictures as an animation that repeats.

    Args:
        file: Open for writing.
        pictures: Each [h, w, 3], uint8, of one size.
        palette: As `make_palette` makes it.
        fps: Pictures a second, at most 50: delays are whole hundredths of a second, such that the time of all
            is right.

    Returns:
        The number of frames.
    """
    from PIL import Image

    holder = Image.new("P", (1, 1))
    holder.putpalette(palette.tobytes())
    before: Picture | None = None
    count = 0
    for count, picture in enumerate(pictures, 1):
        marks = _indices(picture, palette, holder)
        height, width = marks.shape
        if before is None:
            file.write(b"GIF89a" + struct.pack("<HHBBB", width, height, 0xF7, 0, 0) + palette.tobytes())
            file.write(b"\x21\xff\x0bNETSCAPE2.0\x03\x01\x00\x00\x00")
        left, top, right, bottom = changed_box(marks, before)
        delay = round(count * TICKS / fps) - round((count - 1) * TICKS / fps)
        file.write(b"\x21\xf9\x04" + struct.pack("<BHB", 1 << 2, delay, 0) + b"\x00")
        file.write(b"\x2c" + struct.pack("<HHHHB", left, top, right - left, bottom - top, 0))
        file.write(_packed(marks[top:bottom, left:right], palette))
        before = marks
    file.write(b"\x3b")
    return count


def changed_box(picture: NDArray[Any], before: NDArray[Any] | None) -> tuple[int, int, int, int]:
    """Left, top, right and bottom of what differs from the picture before; one pixel where nothing does."""
    if before is None:
        return 0, 0, picture.shape[1], picture.shape[0]
    differs = picture != before
    if differs.ndim == 3:
        differs = differs.any(axis=2)
    rows, columns = np.flatnonzero(differs.any(axis=1)), np.flatnonzero(differs.any(axis=0))
    if not len(rows):
        return 0, 0, 1, 1
    return int(columns[0]), int(rows[0]), int(columns[-1]) + 1, int(rows[-1]) + 1


def _indices(picture: Picture, palette: NDArray[np.uint8], holder: Any) -> NDArray[np.uint8]:
    """The entry of the palette nearest to each pixel; the background's own is exact."""
    from PIL import Image

    image = Image.fromarray(picture).quantize(palette=holder, dither=Image.Dither.NONE)
    marks = np.array(image, np.uint8)
    marks[(picture == palette[0]).all(axis=2)] = 0
    return marks


def _packed(marks: NDArray[np.uint8], palette: NDArray[np.uint8]) -> bytes:
    """The compressed pixels of a picture, as they stand behind its descriptor."""
    from PIL import Image

    image = Image.frombytes("P", (marks.shape[1], marks.shape[0]), marks.tobytes())
    image.putpalette(palette.tobytes())
    held = io.BytesIO()
    image.save(held, "GIF", optimize=False, interlace=0)
    data = held.getvalue()
    place = _HEADER + _TABLE
    while data[place] == 0x21:  # extensions: a label, then blocks, each after its length
        place += 2
        while data[place]:
            place += data[place] + 1
        place += 1
    if data[place] != 0x2C or data[place + 9] & 0x80 or data[10] & 0x87 != 0x87 or data[-1] != 0x3B:
        raise RuntimeError("Pillow packed a GIF in a way that is not known")
    return data[place + 10 : -1]
