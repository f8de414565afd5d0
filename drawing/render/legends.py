"""What explains a picture, drawn on it: `draw_legend`, `draw_color_bar`, `draw_labels`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from ...core.checks import check_list
from .canvas import BLACK, WHITE, Canvas, Color
from .coloring import Coloring
from .colormaps import MISSING, colormap_table
from .lettering import lettering
from .ticks import choose_ticks, count_ticks

GREY = (0.45, 0.45, 0.45)
_PANEL = 0.85  # opacity of what lies behind legends
_CORNERS = ("upper left", "upper right", "lower left", "lower right")
_DOT = 2.5  # [px] radius of the dot beside a label
_WIDEST = 0.45  # of the picture: longer names in a legend are cut


def letter_size(canvas: Canvas) -> int:
    """The size of letters [px] that suits a picture."""
    shorter = min(canvas.width, canvas.height)
    return next(
        (size for limit, size in ((420, 12), (700, 14), (1100, 16), (1500, 20), (2200, 24)) if shorter < limit), 32
    )


def cut_text(text: str, size: float, most: float) -> str:
    """A text that is at most so wide [px], shortened by an ellipsis."""
    letters = lettering()
    if len(text) <= most and letters.width(text, size) <= most:  # a letter is a pixel wide at least
        return text
    text = text[: max(int(most), 0)]
    while text and letters.width(text + "…", size) > most:
        text = text[:-1]
    return text + "…"


def draw_legend(canvas: Canvas, entries: Sequence[tuple[str, Color]], corner: str = "upper left") -> None:
    """Draw names and their colours in a corner of a picture.

    Args:
        canvas: The picture.
        entries: Names and colours; those that find no room are counted in the last line.
        corner: "upper left", "upper right", "lower left" or "lower right".

    Raises:
        ValueError: No such corner.
    """
    if corner not in _CORNERS:
        raise ValueError(f"corner: expected one of {', '.join(_CORNERS)}, got {corner!r}")
    lines = check_list("entries", entries, "names with colours")
    size = letter_size(canvas)
    pitch, pad = round(1.5 * size), round(0.6 * size)
    room = max(1, (canvas.height - 4 * pad) // pitch)
    shown = lines if len(lines) <= room else lines[: room - 1]
    names = [cut_text(str(name), size, _WIDEST * canvas.width) for name, _ in shown]
    if len(shown) < len(lines):
        names.append(f"and {len(lines) - len(shown)} more")
    if not names:
        return
    width = max(canvas.text_width(name, size) for name in names) + size + 3 * pad
    height = pitch * len(names) + 2 * pad - (pitch - size)
    left = pad if "left" in corner else canvas.width - width - pad
    top = pad if "upper" in corner else canvas.height - height - pad
    canvas.rectangle(left, top, width, height, fill=WHITE, outline=(0.75, 0.75, 0.75), opacity=_PANEL)
    rows = [top + pad + size // 2 + k * pitch for k in range(len(names))]
    for (_, color), row in zip(shown, rows, strict=False):
        canvas.rectangle(left + pad, row - size // 2, size, size, fill=color, outline=GREY)
    canvas.texts([(name, left + 2 * pad + size, row) for name, row in zip(names, rows, strict=True)], size=size)


def draw_color_bar(canvas: Canvas, coloring: Coloring, title: str = "") -> None:
    """Draw what colours mean at the right of a picture: a bar with numbers, or for labels a legend.

    Colours without numbers, as RGB, draw nothing.

    Args:
        canvas: The picture.
        coloring: What was coloured.
        title: Above the bar; the coloring's own if empty.
    """
    if coloring.kind == "labels":
        draw_legend(canvas, coloring.entries(), "upper right")
    if coloring.limits is None or coloring.colormap is None:
        return
    size, shown = letter_size(canvas), title or coloring.title
    pad = round(0.6 * size)
    height = round(0.5 * canvas.height)
    ticks = choose_ticks(*coloring.limits, count_ticks(height, size))
    heading = cut_text(ticks.title(shown), size, _WIDEST * canvas.width)
    bar = round(1.2 * size)
    across = bar + size // 2 + max([canvas.text_width(text, size) for text in ticks.texts], default=0)
    none = coloring.has_missing
    across = max(across, canvas.text_width(heading, size), (bar + size // 2 + canvas.text_width("none", size)) * none)
    above, below = 2 * size if heading else size // 2, 2 * size if none else size // 2
    width, full = across + 2 * pad, height + above + below + 2 * pad
    left, top = canvas.width - width - pad, (canvas.height - full) // 2
    canvas.rectangle(left, top, width, full, fill=WHITE, outline=(0.75, 0.75, 0.75), opacity=_PANEL)
    canvas.text(heading, left + pad, top + pad, size=size, anchor="upper left")
    paint_bar(canvas, left + pad, top + pad + above, bar, height, coloring.colormap, ticks, size)
    if none:
        row = top + full - pad - size // 2
        canvas.rectangle(left + pad, row - size // 2, bar, size, fill=MISSING, outline=GREY)
        canvas.text("none", left + pad + bar + size // 2, row, size=size)


def paint_bar(canvas: Canvas, x: int, y: int, width: int, height: int, colormap: str, ticks: Any, size: int) -> None:
    """Draw the bar of a colour map, its low end below, with ticks at its right."""
    rows = np.arange(height)[::-1]
    places = rows * 255 // max(height - 1, 1)
    colors = np.floor(colormap_table(colormap)[places] * 255 + 0.5).astype(np.uint8)
    canvas.image(np.repeat(colors[:, None], width, axis=1), x, y)
    canvas.rectangle(x, y, width, height, outline=GREY)
    places = [y + (height - 1) * (1 - (v - ticks.low) / (ticks.high - ticks.low)) for v in ticks.values]
    for place in places:
        canvas.line(x + width, round(place), x + width + size // 4, round(place), color=GREY)
    texts = [(text, x + width + size // 2, round(p)) for text, p in zip(ticks.texts, places, strict=True)]
    canvas.texts(texts, size=size)


def draw_labels(
    canvas: Canvas, labels: Sequence[tuple[str, float, float]], *, size: float | None = None, color: Color = BLACK
) -> int:
    """Write texts beside places of a picture, each with a dot and a light seam, so that they read on any ground.

    Args:
        canvas: The picture.
        labels: (text, x, y) [px]; what lies outside the picture is left out.
        size: Of the letters [px]; None for what suits the picture.
        color: Of letters and dots.

    Returns:
        How many were left out since they would lie on an earlier one.
    """
    chosen = letter_size(canvas) if size is None else size
    gap, high = round(_DOT) + 4, round(chosen * 1.1)
    taken, texts, dots, hidden = np.empty((0, 4)), [], [], 0
    for text, x, y in check_list("labels", labels, "texts with places"):
        if not (0 <= x < canvas.width and 0 <= y < canvas.height):
            continue
        text = cut_text(str(text), chosen, canvas.width - 4 * gap)
        wide = canvas.text_width(text, chosen)
        left = x + gap if x + gap + wide < canvas.width else max(x - gap - wide, 0)
        row = min(max(y, high / 2), canvas.height - 1 - high / 2)
        box = np.array([min(left, x - _DOT), row - high / 2, max(left + wide, x + _DOT), row + high / 2])
        if ((taken[:, :2] < box[2:]) & (taken[:, 2:] > box[:2])).all(axis=1).any():
            hidden += 1
            continue
        taken = np.vstack([taken, box])
        texts.append((text, left, row))
        dots.append((x, y))
    if dots:
        canvas.dots(dots, radius=_DOT + 1, color=WHITE)
        canvas.dots(dots, radius=_DOT, color=color)
    canvas.texts(texts, size=chosen, color=color, halo=WHITE)
    return hidden
