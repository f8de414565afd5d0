"""Text, lines and shapes on an image: `Canvas`.

Positions are in pixels; (0, 0) is the center of the first pixel. Colors are red, green and blue, 0 to 1. Drawing is
clipped to the image, and non-finite positions are ignored.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import (
    check_count,
    check_finite,
    check_fraction,
    check_number,
    check_positive,
    check_rows,
    check_shape,
)
from ...core.devices import DeviceLike, resolve_device
from ...core.masked_arrays import unmasked
from ...kernels.drawing import canvas as strokes
from ...kernels.drawing.canvas import Paint, Sheet, clip_box
from ...kernels.lang import uint8
from ...kernels.memory import clone, download, upload
from .lettering import lettering
from .picture import Picture

Color = Sequence[float]

DARK_COLOR = (0.1, 0.1, 0.1)
LIGHT_COLOR = (1.0, 1.0, 1.0)
HALO_WIDTH = 2  # [px] outline of letters

_ANCHOR_FRACTIONS = {"left": 0.0, "center": 0.5, "right": 1.0}
_DOWN = ("upper", "middle", "lower")


class Canvas:
    """An image to draw on: a uint8 device array (3 * width * height), modified in place.

    Bitwise identical on every device and with both compilers. Needs 4 B per pixel besides the image.

    Example:
        >>> canvas = Canvas.blank(160, 40)
        >>> canvas.text("25.0 °C", 80, 20, size=16, anchor="center")
        >>> canvas.to_numpy().shape
        (40, 160, 3)
    """

    def __init__(self, picture: Any, width: int, height: int):
        self.width, self.height = check_count("width", width), check_count("height", height)
        if picture.size != 3 * self.width * self.height:
            raise ValueError(f"picture: expected {3 * self.width * self.height} numbers, got {picture.size}")
        self.sheet, self.device = Sheet(picture, self.width, self.height), picture.device

    @classmethod
    def blank(cls, width: int, height: int, background: Color = LIGHT_COLOR, device: DeviceLike = None) -> Self:
        width, height = check_count("width", width), check_count("height", height)
        pixels = np.tile(np.array(_color_bytes("background", background), np.uint8), width * height)
        return cls(upload(pixels, uint8, resolve_device(device)), width, height)

    @classmethod
    def of_image(cls, image: NDArray[np.uint8], device: DeviceLike = None) -> Self:
        values = _check_image(image)
        return cls(upload(values.ravel(), uint8, resolve_device(device)), values.shape[1], values.shape[0])

    def to_numpy(self) -> Picture:
        """The image, shape (h, w, 3), one sync."""
        return Picture(download(self.sheet.picture).reshape(self.height, self.width, 3).copy())

    def copy(self) -> Self:
        return type(self)(clone(self.sheet.picture), self.width, self.height)

    def text_width(self, text: str, size: float = 14) -> int:
        return lettering().width(str(text), size)

    def text(
        self,
        text: str,
        x: float,
        y: float,
        *,
        size: float = 14,
        color: Color = DARK_COLOR,
        anchor: str = "left",
        halo: Color | None = None,
    ) -> None:
        """Write one line of text at a position [px], rounded to integers for crisp letters.

        ASCII letters and some symbols. Others are drawn as a box. `size` is rounded to 12, 14, 16, 20, 24 or 32 px.
        `anchor` is the part of the text at the position: "left", "center" or "right", optionally after "upper" or
        "lower" (for capital letters), for example "upper left". `halo` is the color of an outline for contrast.
        """
        self.texts([(text, x, y)], size=size, color=color, anchor=anchor, halo=halo)

    def texts(
        self,
        entries: Sequence[tuple[str, float, float]],
        *,
        size: float = 14,
        color: Color = DARK_COLOR,
        anchor: str = "left",
        halo: Color | None = None,
    ) -> None:
        """Write several texts (text, x, y) at once, see `text`."""
        paint = self._paint(color, 1.0)
        seam = None if halo is None else self._paint(halo, 0.85, name="halo")
        down, across = _split_anchor(anchor)
        letters = lettering()
        rows = [
            _anchored_glyphs(letters, str(text), x, y, check_positive("size", size), down, across)
            for text, x, y in entries
        ]
        glyphs = np.concatenate(rows) if rows else np.empty((0, 5), np.int32)
        if not len(glyphs):
            return
        low, high = glyphs[:, 3:], glyphs[:, 3:] + glyphs[:, 1:3] - 1
        left, upper, right, lower = *low.min(axis=0).tolist(), *high.max(axis=0).tolist()
        if seam is not None:
            strokes.cover_glyphs(self.sheet, glyphs, letters.atlas(self.device))
            box = clip_box(self.sheet, left - HALO_WIDTH, upper - HALO_WIDTH, right + HALO_WIDTH, lower + HALO_WIDTH)
            strokes.blend_halo(self.sheet, box, HALO_WIDTH, seam)
        else:
            strokes.cover_glyphs(self.sheet, glyphs, letters.atlas(self.device))
        strokes.blend(self.sheet, clip_box(self.sheet, left, upper, right, lower), paint)

    def line(
        self,
        x0: float,
        y0: float,
        x1: float,
        y1: float,
        *,
        color: Color = DARK_COLOR,
        width: float = 1.0,
        opacity: float = 1.0,
    ) -> None:
        self.segments([[x0, y0, x1, y1]], color=color, width=width, opacity=opacity)

    def polyline(
        self, points: ArrayLike, *, color: Color = DARK_COLOR, width: float = 1.0, opacity: float = 1.0
    ) -> None:
        """Draw a polyline through points (n, 2). A non-finite point is a gap."""
        path = check_rows("points", points, 2, dtype=np.float64)
        self.segments(np.hstack([path[:-1], path[1:]]), color=color, width=width, opacity=opacity)

    def segments(
        self, segments: ArrayLike, *, color: Color = DARK_COLOR, width: float = 1.0, opacity: float = 1.0
    ) -> None:
        """Draw segments (x, y, x, y), shape (n, 4), with round ends."""
        ends = check_rows("segments", segments, 4, dtype=np.float64)
        width = check_positive("width", width)
        margin = width / 2 + 2
        high = self.width - 1 + margin, self.height - 1 + margin
        ends, _ = clip_segments(ends, (-margin, -margin), high)
        if len(ends):
            paint = self._paint(color, opacity)
            columns, rows = ends[:, ::2], ends[:, 1::2]
            box = self._box(columns.min(), rows.min(), columns.max(), rows.max(), margin)
            strokes.cover_segments(self.sheet, ends.astype(np.float32), width)
            strokes.blend(self.sheet, box, paint)

    def dots(self, points: ArrayLike, *, radius: float = 3.0, color: Color = DARK_COLOR, opacity: float = 1.0) -> None:
        """Draw filled circles at points (n, 2)."""
        centers = check_rows("points", points, 2, dtype=np.float64)
        diameter = 2 * check_positive("radius", radius)
        self.segments(np.hstack([centers, centers]), color=color, width=diameter, opacity=opacity)

    def rectangle(
        self,
        x: float,
        y: float,
        width: float,
        height: float,
        *,
        fill: Color | None = None,
        outline: Color | None = None,
        line_width: float = 1.0,
        opacity: float = 1.0,
    ) -> None:
        """Draw a rectangle, filled, with an outline inside, or both. Integers cover whole pixels."""
        x, y = check_number("x", x), check_number("y", y)
        width = check_positive("width", width, allow_zero=True)
        height = check_positive("height", height, allow_zero=True)
        line = check_positive("line_width", line_width)
        left, top, right, bottom = x - 0.5, y - 0.5, x - 0.5 + width, y - 0.5 + height
        box = self._box(left, top, right, bottom, 1)
        inner = (left + line, top + line, right - line, bottom - line)
        for color, hole in self._seen(box, (fill, (0.0, 0.0, 0.0, 0.0)), (outline, inner)):
            strokes.cover_box(self.sheet, box, (left, top, right, bottom), hole)
            strokes.blend(self.sheet, box, self._paint(color, opacity))

    def image(self, image: NDArray[np.uint8], x: int, y: int) -> None:
        """Copy an image of shape (h, w, 3) with its first pixel at column x, row y."""
        values = _check_image(image)
        x, y = check_count("x", x, minimum=-(2**20)), check_count("y", y, minimum=-(2**20))
        box = clip_box(self.sheet, x, y, x + values.shape[1] - 1, y + values.shape[0] - 1)
        if box[2] * box[3]:
            table = upload(values.ravel(), uint8, self.device)
            strokes.copy_image(self.sheet, box, table, values.shape[1], x, y)

    def _box(self, left: float, top: float, right: float, bottom: float, margin: float) -> tuple[int, int, int, int]:
        """The cells within a distance of a box, clipped."""
        limits = np.array([left - margin, top - margin, right + margin, bottom + margin])
        limit = float(max(self.width, self.height) + 1)
        low, high = np.floor(limits[:2].clip(-1, limit)).tolist(), np.ceil(limits[2:].clip(-1, limit)).tolist()
        return clip_box(self.sheet, *map(int, low), *map(int, high))

    @staticmethod
    def _seen(box: tuple[int, int, int, int], *strokes: tuple[Color | None, Any]) -> list[tuple[Color, Any]]:
        """The strokes with a color. None if the box has no cell."""
        return [(color, hole) for color, hole in strokes if color is not None and box[2] * box[3]]

    def _paint(self, color: Color, opacity: float, *, name: str = "color") -> Paint:
        return Paint(_color_bytes(name, color), round(255 * check_fraction("opacity", opacity)))


def _color_bytes(name: str, color: Color) -> tuple[int, int, int]:
    fractions = check_finite(name, check_shape(name, color, (3,)))
    red, green, blue = np.floor(fractions.clip(0, 1) * 255 + 0.5).astype(int).tolist()
    return red, green, blue


def _check_image(image: object) -> NDArray[np.uint8]:
    values = np.asarray(unmasked("image", image))
    if values.ndim != 3 or values.shape[2] != 3 or values.dtype != np.uint8 or not values.size:
        is_clear = values.ndim == 3 and values.shape[2] == 4
        remedy = "; render it with an opaque background" if is_clear else ""
        shape = list(values.shape)
        raise ValueError(f"image: expected uint8 of shape [h, w, 3], got {values.dtype} of {shape}{remedy}")
    return np.ascontiguousarray(values)


def _split_anchor(anchor: str) -> tuple[str, float]:
    down, _, across = anchor.rpartition(" ")
    down = down or "middle"
    if across not in _ANCHOR_FRACTIONS or down not in _DOWN:
        raise ValueError(f"anchor: expected left, center or right, alone or after upper or lower, got {anchor!r}")
    return down, _ANCHOR_FRACTIONS[across]


def _anchored_glyphs(
    letters: Any, text: str, x: float, y: float, size: float, down: str, across: float
) -> NDArray[np.int32]:
    """Letters of an anchored text. None if the position is not finite or far outside."""
    if not (np.isfinite(x) and np.isfinite(y) and abs(x) < 2**20 and abs(y) < 2**20):
        return np.empty((0, 5), np.int32)
    glyphs = letters.set(text, size)
    cap = letters.cap_height(size)
    fall = {"upper": cap, "middle": (cap + 1) // 2, "lower": 1}[down]  # capitals end in the row above the pen
    column, row = int(np.floor(x + 0.5)), int(np.floor(y + 0.5))
    back = int(letters.width(text, size) * across)
    glyphs[:, 3] += column - back
    glyphs[:, 4] += row + fall
    return glyphs


MAX_COORDINATE = 1e12  # [px] beyond it clipping would lose its digits

Ends = NDArray[np.float64]
Pair = tuple[float, float]


def clip_segments(segments: Ends, low: Pair, high: Pair) -> tuple[Ends, NDArray[np.int64]]:
    """Clip segments (x, y, x, y) to a box (Liang and Barsky, "A new concept and method for line clipping", 1984).

    Returns the parts (m, 4) and their ascending row indices. Non-finite segments are dropped.

    Example:
        >>> clip_segments(np.array([[-1.0, 0.5, 3.0, 0.5], [5.0, 5.0, 6.0, 6.0]]), (0, 0), (1, 1))[0].tolist()
        [[0.0, 0.5, 1.0, 0.5]]
    """
    rows = np.flatnonzero((np.abs(segments) < MAX_COORDINATE).all(axis=1))
    ends = segments[rows]
    start, way = ends[:, :2], ends[:, 2:] - ends[:, :2]
    enter, leave, is_inside = np.zeros(len(ends)), np.ones(len(ends)), np.ones(len(ends), bool)
    for axis in (0, 1):
        moves = way[:, axis] != 0
        to_low = np.divide(low[axis] - start[:, axis], way[:, axis], out=np.zeros(len(ends)), where=moves)
        to_high = np.divide(high[axis] - start[:, axis], way[:, axis], out=np.ones(len(ends)), where=moves)
        enter = np.maximum(enter, np.where(moves, np.minimum(to_low, to_high), 0.0))
        leave = np.minimum(leave, np.where(moves, np.maximum(to_low, to_high), 1.0))
        is_inside &= moves | ((start[:, axis] >= low[axis]) & (start[:, axis] <= high[axis]))
    is_inside &= enter <= leave
    first = start + enter[:, None] * way
    last = np.where(leave[:, None] < 1, start + leave[:, None] * way, ends[:, 2:])
    return np.hstack([first, last])[is_inside], rows[is_inside]
