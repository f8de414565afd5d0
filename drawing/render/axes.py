"""The frame of a plot: `Axes`, with ticks, grid and titles."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .canvas import Canvas, Color
from .clipping import clip_segments
from .legends import GREY, cut_text
from .ticks import Ticks, choose_ticks, count_ticks, widen

GRID = (0.89, 0.89, 0.89)


@dataclasses.dataclass(frozen=True)
class Area:
    """A part of a picture [px]: its first column and row, its width and height."""

    left: int
    top: int
    width: int
    height: int


class Axes:
    """A frame with ticks inside an area of a canvas, drawn when it is made; everything lies within the area.

    Args:
        canvas: The picture.
        area: Where on it.
        x, y: Ends of the two axes.
        titles: Of the two axes.
        size: Of letters [px].
        equal: Whether both axes have one scale; the ends of one are then moved apart.
        whole: Whether ticks of x and y are whole numbers.

    Attributes:
        left, top, right, bottom: The frame [px].
        x, y: The Ticks, with the ends as drawn.
    """

    def __init__(
        self,
        canvas: Canvas,
        area: Area,
        x: tuple[float, float],
        y: tuple[float, float],
        *,
        titles: tuple[str, str],
        size: int,
        equal: bool = False,
        whole: tuple[bool, bool] = (False, False),
    ):
        self.canvas, self.size, self._area = canvas, size, area
        self.top = area.top + size // 2 + 1
        self.bottom = area.top + area.height - 1 - round(3.3 * size)
        self.bottom = max(self.bottom, self.top + 2)
        self.right = area.left + area.width - 1 - 2 * size
        most = count_ticks(self.bottom - self.top, size)
        x, y = widen(*x), widen(*y)
        for _ in range(2 if equal else 1):  # the wider the numbers of y, the less room for x
            self.y = choose_ticks(*y, most, whole=whole[1])
            letters = max([canvas.text_width(text, size) for text in self.y.texts], default=0)
            self.left = min(area.left + round(2.3 * size) + letters, self.right - 2)
            if equal:
                x, y = self._one_scale(x, y)
        self.y = choose_ticks(*y, most, whole=whole[1])
        self.x = self._ticks_across(x, whole[0])
        self._draw(titles)

    def columns(self, values: ArrayLike) -> NDArray[np.float64]:
        """Columns [px] of values along x."""
        return self.left + _share(values, self.x) * (self.right - self.left)

    def rows(self, values: ArrayLike) -> NDArray[np.float64]:
        """Rows [px] of values along y."""
        return self.bottom - _share(values, self.y) * (self.bottom - self.top)

    def polyline(self, x: ArrayLike, y: ArrayLike, **style: Any) -> None:
        """Draw lines from each place to the next, inside the frame; style as of `Canvas.polyline`."""
        path = np.column_stack([self.columns(x), self.rows(y)])
        segments, rows = clip_segments(
            np.hstack([path[:-1], path[1:]]), (self.left, self.top), (self.right, self.bottom)
        )
        if style.get("colors") is not None:
            style["colors"] = style["colors"][rows]
        self.canvas.segments(segments, **style)

    def dots(self, x: ArrayLike, y: ArrayLike, **style: Any) -> None:
        """Draw dots at those places that lie inside the frame; style as of `Canvas.dots`."""
        places = np.column_stack([self.columns(x), self.rows(y)])
        is_inside = ((places >= (self.left, self.top)) & (places <= (self.right, self.bottom))).all(axis=1)
        if style.get("colors") is not None:
            style["colors"] = style["colors"][is_inside]
        if is_inside.any():
            self.canvas.dots(places[is_inside], **style)

    def _one_scale(self, x: tuple[float, float], y: tuple[float, float]) -> tuple[tuple[float, float], ...]:
        """Ends of both axes with as many units a pixel."""
        wide, high = self.right - self.left, self.bottom - self.top
        scale = max((x[1] - x[0]) / wide, (y[1] - y[0]) / high)
        middles = (x[0] + x[1]) / 2, (y[0] + y[1]) / 2
        return tuple((m - scale * n / 2, m + scale * n / 2) for m, n in zip(middles, (wide, high), strict=True))

    def _ticks_across(self, x: tuple[float, float], whole: bool) -> Ticks:
        """Ticks of x whose numbers do not touch."""
        room = self.right - self.left
        for most in range(max(2, room // (3 * self.size)), 2, -1):
            ticks = choose_ticks(*x, most, whole=whole)
            widest = max([self.canvas.text_width(text, self.size) for text in ticks.texts], default=0)
            if len(ticks.values) < 2 or (widest + self.size) * (len(ticks.values) - 1) <= room * _spread(ticks):
                return ticks
        return choose_ticks(*x, 2, whole=whole)

    def _draw(self, titles: tuple[str, str]) -> None:
        canvas, size = self.canvas, self.size
        columns = np.round(self.columns(self.x.values)).tolist()
        rows = np.round(self.rows(self.y.values)).tolist()
        grid = [[c, self.top, c, self.bottom] for c in columns] + [[self.left, r, self.right, r] for r in rows]
        canvas.segments(np.array(grid, np.float64).reshape(-1, 4), color=GRID)
        width, height = self.right - self.left + 1, self.bottom - self.top + 1
        canvas.rectangle(self.left, self.top, width, height, outline=GREY)
        below = []
        for text, column in zip(
            self.x.texts, columns, strict=True
        ):  # the last number may be wider than what is beside it
            reach = canvas.text_width(text, size) / 2 + 3
            inside = min(max(column, self._area.left + reach), self._area.left + self._area.width - reach)
            below.append((text, inside, self.bottom + size // 2 + 1))
        canvas.texts(below, size=size, anchor="upper center")
        beside = [(text, self.left - size // 2, r) for text, r in zip(self.y.texts, rows, strict=True)]
        canvas.texts(beside, size=size, anchor="right")
        across, along = (ticks.title(title) for ticks, title in zip((self.x, self.y), titles, strict=True))
        middle = (self.left + self.right) / 2
        place = self.bottom + round(2.0 * size)
        canvas.text(cut_text(across, size, width), middle, place, size=size, anchor="upper center")
        letters = max([canvas.text_width(text, size) for text in self.y.texts], default=0)
        place = self.left - letters - round(0.9 * size)
        middle = (self.top + self.bottom) / 2
        canvas.text(cut_text(along, size, height), place, middle, size=size, anchor="lower center", turned=True)


def draw_head(
    canvas: Canvas, area: Area, title: str, note: str, entries: Sequence[tuple[str, Color]], size: int
) -> Area:
    """Write what stands above a plot: a title, a note at its right, and what its colours mean; gives the area left.

    The note takes a line of its own where it does not fit beside the title; entries take as many as they need.
    """
    pad, pitch = round(0.8 * size), round(1.6 * size)
    left, right, row = area.left + pad, area.left + area.width - 2 * size, area.top + pad + size // 2
    room = right - left
    title = cut_text(title, size, room)
    canvas.text(title, left, row, size=size)
    if note:
        note = cut_text(note, size, room)
        if title and canvas.text_width(title, size) + canvas.text_width(note, size) + 2 * size > room:
            row += pitch
        canvas.text(note, right, row, size=size, color=GREY, anchor="right")
    row += pitch * bool(title or note)
    column = left
    for name, color in entries:
        name = cut_text(name, size, room - 2 * size)
        wide = canvas.text_width(name, size) + round(1.8 * size)
        if column > left and column + wide > right:
            column, row = left, row + pitch
        canvas.line(column, row, column + size, row, color=color, width=max(2, size // 6))
        canvas.text(name, column + round(1.4 * size), row, size=size)
        column += wide + size
    row += pitch * bool(entries)
    used = row - area.top - size // 2
    return Area(area.left, area.top + used, area.width, area.height - used)


def _share(values: ArrayLike, ticks: Ticks) -> NDArray[np.float64]:
    """How far along an axis values lie, 0 to 1 inside it."""
    with np.errstate(over="ignore", invalid="ignore"):
        return (np.asarray(values, np.float64) - ticks.low) / (ticks.high - ticks.low)


def _spread(ticks: Ticks) -> float:
    """The share of an axis between its first tick and its last."""
    return (ticks.values[-1] - ticks.values[0]) / (ticks.high - ticks.low)
