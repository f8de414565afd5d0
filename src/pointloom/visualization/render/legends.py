"""Legends, color bars and labels on an image."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_list
from .canvas import DARK_COLOR, LIGHT_COLOR, Canvas, Color
from .coloring import Coloring
from .colormaps import MISSING_COLOR, colormap_table
from .lettering import lettering
from .ticks import Ticks, choose_ticks, count_ticks, with_ends

FRAME_COLOR = (0.45, 0.45, 0.45)
_PANEL_OPACITY = 0.85  # opacity of the background of legends
_CORNERS = ("upper left", "upper right", "lower left", "lower right")
_LINE_PITCH = 1.5  # line height over font size
END_ROOM = 1.3  # minimum distance of ticks to the ends over font size
_DOT_RADIUS = 2.5  # [px]
KEY_CANVAS = (2100, 1600)  # [px] at half of the size on a page, its letters have 12 px and the bar has 400
_MAX_WIDTH_FRACTION = 0.45  # of the image width: longer names are shortened


def letter_size(canvas: Canvas) -> int:
    return _letters_for(canvas.width, canvas.height)


def _letters_for(width: int, height: int) -> int:
    shorter = min(width, height)
    return next(
        (size for limit, size in ((420, 12), (700, 14), (1100, 16), (1500, 20), (2200, 24)) if shorter < limit), 32
    )


def cut_text(text: str, size: float, max_width: float) -> str:
    """A text shortened with an ellipsis to a width [px]."""
    letters = lettering()
    if len(text) <= max_width and letters.width(text, size) <= max_width:  # a letter is at least one pixel wide
        return text
    text = text[: max(int(max_width), 0)]
    while text and letters.width(text + "…", size) > max_width:
        text = text[:-1]
    return text + "…"


@dataclasses.dataclass(frozen=True)
class _Panel:
    """Size of a panel [px], its font size, and its margin and padding `pad`."""

    size: int
    pad: int
    width: int
    height: int

    @property
    def band(self) -> tuple[int, int]:
        """Width and height [px] that it takes in a corner."""
        return self.width + 2 * self.pad, self.height + 2 * self.pad


def _lay_legend(names: Sequence[str], width: int, height: int) -> tuple[_Panel, list[str]]:
    """Panel and lines of a legend. The last line counts omitted entries."""
    size = _letters_for(width, height)
    pitch, pad = round(_LINE_PITCH * size), round(0.6 * size)
    room = max(1, (height - 4 * pad) // pitch)
    shown = names if len(names) <= room else names[: room - 1]
    lines = [cut_text(str(name), size, _MAX_WIDTH_FRACTION * width) for name in shown]
    if len(shown) < len(names):
        lines.append(f"and {len(names) - len(shown)} more")
    widest = max([lettering().width(line, size) for line in lines], default=0)
    return _Panel(size, pad, widest + size + 3 * pad, pitch * len(lines) + 2 * pad - (pitch - size)), lines


def legend_size(entries: Sequence[tuple[str, Color]], width: int, height: int) -> tuple[int, int]:
    return _lay_legend([name for name, _ in entries], width, height)[0].band if entries else (0, 0)


def draw_legend(canvas: Canvas, entries: Sequence[tuple[str, Color]], corner: str = "upper left") -> None:
    """Draw names and colors in a corner: "upper left", "upper right", "lower left" or "lower right"."""
    if corner not in _CORNERS:
        raise ValueError(f"corner: expected one of {', '.join(_CORNERS)}, got {corner!r}")
    lines = check_list("entries", entries, "names with colors")
    if not lines:
        return
    panel, names = _lay_legend([name for name, _ in lines], canvas.width, canvas.height)
    size, pad, pitch = panel.size, panel.pad, round(_LINE_PITCH * panel.size)
    left = pad if "left" in corner else canvas.width - panel.width - pad
    top = pad if "upper" in corner else canvas.height - panel.height - pad
    canvas.rectangle(
        left, top, panel.width, panel.height, fill=LIGHT_COLOR, outline=(0.75, 0.75, 0.75), opacity=_PANEL_OPACITY
    )
    rows = [top + pad + size // 2 + k * pitch for k in range(len(names))]
    shown = len(names) if len(names) == len(lines) else len(names) - 1
    for (_, color), row in zip(lines[:shown], rows, strict=False):
        canvas.rectangle(left + pad, row - size // 2, size, size, fill=color, outline=FRAME_COLOR)
    canvas.texts([(name, left + 2 * pad + size, row) for name, row in zip(names, rows, strict=True)], size=size)


@dataclasses.dataclass(frozen=True)
class _Bar(_Panel):
    """Panel of a color bar: width and height of the bar [px], heading, offset below it, and ticks."""

    bar: int
    tall: int
    heading: str
    above: int
    ticks: Ticks


def _lay_bar(coloring: Coloring, title: str, width: int, height: int) -> _Bar | None:
    """Panel of a color bar. None for colors without numbers."""
    if coloring.limits is None or coloring.colormap is None:
        return None
    size = _letters_for(width, height)
    pad, tall, bar = round(0.6 * size), round(0.5 * height), round(1.2 * size)
    ticks = with_ends(choose_ticks(*coloring.limits, count_ticks(tall, size)), END_ROOM * size / max(tall, 1))
    heading = cut_text(ticks.title(title or coloring.title), size, _MAX_WIDTH_FRACTION * width)
    widths = lettering().width
    across = bar + size // 2 + max([widths(text, size) for text in ticks.texts], default=0)
    none = coloring.has_missing
    across = max(across, widths(heading, size), (bar + size // 2 + widths("none", size)) * none)
    above, below = 2 * size if heading else size // 2, 2 * size if none else size // 2
    return _Bar(size, pad, across + 2 * pad, tall + above + below + 2 * pad, bar, tall, heading, above, ticks)


def color_bar_size(coloring: Coloring, width: int, height: int) -> tuple[int, int, bool]:
    """Width and height [px] of a color bar, and whether it fills the right side (a legend of labels is in a corner)."""
    panel = _lay_bar(coloring, "", width, height)
    if panel is not None:
        return *panel.band, True
    return *legend_size(coloring.entries() if coloring.kind == "labels" else [], width, height), False


def draw_color_bar(canvas: Canvas, coloring: Coloring, title: str = "") -> None:
    """Draw a color bar at the right, or a legend for labels. Nothing for colors without numbers."""
    if coloring.kind == "labels":
        draw_legend(canvas, coloring.entries(), "upper right")
    panel = _lay_bar(coloring, title, canvas.width, canvas.height)
    if panel is None or coloring.colormap is None:
        return
    size, pad, bar, tall = panel.size, panel.pad, panel.bar, panel.tall
    left, top = canvas.width - panel.width - pad, (canvas.height - panel.height) // 2
    canvas.rectangle(
        left, top, panel.width, panel.height, fill=LIGHT_COLOR, outline=(0.75, 0.75, 0.75), opacity=_PANEL_OPACITY
    )
    canvas.text(panel.heading, left + pad, top + pad, size=size, anchor="upper left")
    paint_bar(canvas, left + pad, top + pad + panel.above, bar, tall, coloring.colormap, panel.ticks, size)
    if coloring.has_missing:
        row = top + panel.height - pad - size // 2
        canvas.rectangle(left + pad, row - size // 2, bar, size, fill=MISSING_COLOR, outline=FRAME_COLOR)
        canvas.text("none", left + pad + bar + size // 2, row, size=size)


def key_of(coloring: Coloring) -> tuple[str, NDArray[np.uint8]]:
    """The color bar or legend of a coloring as a text and an image by itself, at twice its size on a page."""
    canvas = Canvas.blank(*KEY_CANVAS)
    draw_color_bar(canvas, coloring)
    picture = canvas.to_numpy()
    rows, columns = (np.flatnonzero((picture < 255).any(axis=axis)) for axis in ((1, 2), (0, 2)))
    text = coloring.title
    if coloring.limits is not None:
        text = f"{text}, colors from {coloring.limits[0]:.4g} to {coloring.limits[1]:.4g}"
    return text, np.ascontiguousarray(picture[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1])


def paint_bar(canvas: Canvas, x: int, y: int, width: int, height: int, colormap: str, ticks: Any, size: int) -> None:
    """Draw the bar of a colormap with ticks at its right."""
    rows = np.arange(height)[::-1]
    positions = rows * 255 // max(height - 1, 1)
    colors = np.floor(colormap_table(colormap)[positions] * 255 + 0.5).astype(np.uint8)
    canvas.image(np.repeat(colors[:, None], width, axis=1), x, y)
    canvas.rectangle(x, y, width, height, outline=FRAME_COLOR)
    positions = [y + (height - 1) * (1 - (v - ticks.low) / (ticks.high - ticks.low)) for v in ticks.values]
    for position in positions:
        canvas.line(x + width, round(position), x + width + size // 4, round(position), color=FRAME_COLOR)
    texts = [(text, x + width + size // 2, round(p)) for text, p in zip(ticks.texts, positions, strict=True)]
    canvas.texts(texts, size=size)


def draw_labels(
    canvas: Canvas,
    labels: Sequence[tuple[str, float, float]],
    *,
    size: float | None = None,
    color: Color = DARK_COLOR,
    halo: Color = LIGHT_COLOR,
) -> int:
    """Write texts (text, x, y) [px] with a dot and an outline. Those outside the image are omitted.

    Returns the number of texts omitted because they would overlap an earlier one.
    """
    chosen = letter_size(canvas) if size is None else size
    gap, high = round(_DOT_RADIUS) + 4, round(chosen * 1.1)
    taken, texts, dots, hidden = np.empty((0, 4)), [], [], 0
    for text, x, y in check_list("labels", labels, "texts with positions"):
        if not (0 <= x < canvas.width and 0 <= y < canvas.height):
            continue
        text = cut_text(str(text), chosen, canvas.width - 4 * gap)
        wide = canvas.text_width(text, chosen)
        left = x + gap if x + gap + wide < canvas.width else max(x - gap - wide, 0)
        row = min(max(y, high / 2), canvas.height - 1 - high / 2)
        box = np.array([min(left, x - _DOT_RADIUS), row - high / 2, max(left + wide, x + _DOT_RADIUS), row + high / 2])
        if ((taken[:, :2] < box[2:]) & (taken[:, 2:] > box[:2])).all(axis=1).any():
            hidden += 1
            continue
        taken = np.vstack([taken, box])
        texts.append((text, left, row))
        dots.append((x, y))
    if dots:
        canvas.dots(dots, radius=_DOT_RADIUS + 1, color=halo)
        canvas.dots(dots, radius=_DOT_RADIUS, color=color)
    canvas.texts(texts, size=chosen, color=color, halo=halo)
    return hidden
