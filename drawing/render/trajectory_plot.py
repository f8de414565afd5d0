"""A path beside the true one, seen from above, and how far it is off along the way: `trajectory_plot`."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_rows, check_shape
from .axes import Area, Axes, draw_head
from .canvas import BLACK, WHITE, Canvas
from .colormaps import MISSING, check_colormap, colormap_table
from .legends import END_ROOM, letter_size, paint_bar
from .plots import check_size, draw_curve, finite_range
from .ticks import Ticks, choose_ticks, count_ticks, format_number, with_ends

ERROR = "error [m]"
TRUTH = (0.55, 0.55, 0.55)
ESTIMATE = (0.12, 0.47, 0.71)  # without errors to colour it by
FARTHEST = 1e12  # [m] positions farther out are none
LEAST = 320, 240  # [px]
_LOWEST = 7  # heights of letters: without so many the error along the way is left out
_UPPER = 0.68  # of the picture: the path


def trajectory_plot(
    estimate: ArrayLike,
    truth: ArrayLike | None = None,
    *,
    times: ArrayLike | None = None,
    title: str = "",
    colormap: str = "turbo",
    size: tuple[int, int] = (1280, 960),
    device: Any = None,
) -> Canvas:
    """Draw a path beside the true one, and its distance from it along the way beneath.

    Args:
        estimate: Positions [m], shape [n, 3]; gaps where they are not finite.
        truth: The true positions of the same moments, in the same frame, shape [n, 3]; None draws the path alone.
        times: When they were there [s], shape [n]; None numbers them.
        title: Above the plot.
        colormap: Of the error along the path.
        size: Width and height [px].
        device: Where to draw.

    Returns:
        The picture: the two axes of the three that the paths extend along most, in one scale.

    Raises:
        ValueError: Other shapes, or a size that is too small.
    """
    path = _near(check_rows("estimate", estimate, 3, dtype=np.float64))
    true = None if truth is None else _near(check_rows("truth", truth, 3, rows=len(path), dtype=np.float64))
    moments = np.arange(len(path)) if times is None else check_shape("times", times, (len(path),))
    if times is not None and len(moments):
        moments = moments - moments[0]
    check_colormap(colormap)
    canvas = Canvas.blank(*check_size(size, LEAST), device=device)
    letters = letter_size(canvas)
    errors = None if true is None else _distances(path, true)
    entries = [] if true is None else [("truth", TRUTH)]
    whole = draw_head(canvas, Area(0, 0, canvas.width, canvas.height), title, _note(errors), entries, letters)
    if true is None or errors is None:
        _draw_path(canvas, whole, path, path, None, letters)
        return canvas
    largest = finite_range([errors])[1] or 1.0
    high = round(_UPPER * whole.height)
    if whole.height - high < _LOWEST * letters:
        high = whole.height
    apart = END_ROOM * letters / max(high - 6 * letters, letters)  # of the bar, which is that much shorter
    ticks = with_ends(choose_ticks(0.0, largest, count_ticks(whole.height // 2, letters)), min(apart, 0.5))
    bar = round(3.5 * letters) + max(canvas.text_width(text, letters) for text in ticks.texts)
    bar = max(bar, canvas.text_width(ticks.title(ERROR), letters) + letters)
    upper = Area(whole.left, whole.top, whole.width - bar, high)
    axes = _draw_path(canvas, upper, path, true, _colors(errors, largest, colormap), letters)
    _draw_bar(axes, ticks, colormap)
    if high < whole.height:
        lower = Area(whole.left, whole.top + high, whole.width, whole.height - high)
        title = "pose" if times is None else "time from the first pose [s]"
        ends = finite_range([moments]), (0.0, 1.05 * largest)
        whole_numbers = times is None, False
        below = Axes(canvas, lower, *ends, titles=(title, ERROR), size=letters, whole=whole_numbers)
        draw_curve(below, moments, errors, color=ESTIMATE)
    return canvas


def _draw_bar(axes: Axes, ticks: Ticks, colormap: str) -> None:
    """What the colours of the path mean, at the right of its frame."""
    size, left = axes.size, axes.right + axes.size
    height = axes.bottom - axes.top + 1 - 2 * size
    axes.canvas.text(ticks.title(ERROR), left, axes.top, size=size, anchor="upper left")
    paint_bar(axes.canvas, left, axes.top + 2 * size, round(1.2 * size), height, colormap, ticks, size)


def _draw_path(
    canvas: Canvas,
    area: Area,
    path: NDArray[np.float64],
    true: NDArray[np.float64],
    colors: NDArray[np.uint8] | None,
    letters: int,
) -> Axes:
    """The paths from above, with where they start and end."""
    across, along = _main_axes(np.vstack([path, true]))
    ends = [_with_margin(*finite_range([path[:, axis], true[:, axis]])) for axis in (across, along)]
    titles = f"{'xyz'[across]} [m]", f"{'xyz'[along]} [m]"
    axes = Axes(canvas, area, ends[0], ends[1], titles=titles, size=letters, equal=True)
    width = max(1.5, letters / 8)
    if path is not true:
        axes.polyline(true[:, across], true[:, along], color=TRUTH, width=width + 1)
    axes.polyline(
        path[:, across], path[:, along], color=ESTIMATE, colors=None if colors is None else colors[:-1], width=width
    )
    rows = np.flatnonzero(np.isfinite(path).all(axis=1))
    if len(rows):
        places = path[rows[[0, -1]]]
        columns, lines = axes.columns(places[:, across]), axes.rows(places[:, along])
        names, marks = ["start", "end"], list(zip(columns.tolist(), lines.tolist(), strict=True))
        if math.dist(*marks) < 2 * letters:
            names, marks = ["start and end"], marks[:1]
        for name, (column, line) in zip(names, marks, strict=True):
            _mark_place(canvas, name, column, line, letters, axes.right)
    return axes


def _mark_place(canvas: Canvas, name: str, column: float, line: float, letters: int, right: int) -> None:
    """A ring about a place, and its name beside it on the side where there is room."""
    radius = 0.45 * letters
    canvas.circle(column, line, radius, fill=WHITE, outline=BLACK, width=2)
    gap, fits = radius + 4, column + radius + 4 + canvas.text_width(name, letters) < right
    canvas.text(
        name, column + gap if fits else column - gap, line, size=letters, anchor="left" if fits else "right", halo=WHITE
    )


def _main_axes(positions: NDArray[np.float64]) -> tuple[int, int]:
    """The two axes along which positions extend most, in their order."""
    extents = [high - low for low, high in (finite_range([positions[:, axis]]) for axis in range(3))]
    extents = [extent if np.isfinite(positions[:, axis]).any() else 0.0 for axis, extent in enumerate(extents)]
    first, second = sorted(sorted(range(3), key=lambda axis: -extents[axis])[:2])
    return first, second


def _with_margin(low: float, high: float) -> tuple[float, float]:
    """Ends of an axis with room for marks at the ends of a path."""
    pad = 0.05 * (high - low)
    return low - pad, high + pad


def _near(positions: NDArray[np.float64]) -> NDArray[np.float64]:
    """Positions; those too far for any path are not finite."""
    return np.where(np.abs(positions) < FARTHEST, positions, np.nan)


def _distances(path: NDArray[np.float64], true: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.linalg.norm(path - true, axis=1)


def _colors(errors: NDArray[np.float64], largest: float, colormap: str) -> NDArray[np.uint8]:
    """A colour for each error, grey where there is none."""
    is_there = np.isfinite(errors)
    places = np.floor(np.where(is_there, errors, 0.0) / largest * 255 + 0.5).clip(0, 255).astype(np.int64)
    colors = colormap_table(colormap)[places]
    colors[~is_there] = MISSING
    return np.floor(colors * 255 + 0.5).astype(np.uint8)


def _note(errors: NDArray[np.float64] | None) -> str:
    """The errors in a line."""
    found = np.empty(0) if errors is None else errors[np.isfinite(errors)]
    if not len(found):
        return ""
    rmse = format_number(float(np.sqrt((found**2).mean())))
    median, most = format_number(float(np.median(found))), format_number(float(found.max()))
    return f"{len(found):,} pose{'s' * (len(found) != 1)}, {rmse} m rmse, {median} median, {most} at most"
