"""Plots of numbers as pictures: `histogram`, `curves`; paths are drawn by trajectory_plot.py.

What they are for is looking: the numbers themselves are in reports. Each gives a Canvas, whose `to_numpy()` is written
with `save_picture`.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_count, check_list, check_name, check_number, check_numeric, check_shape, shown
from .axes import Area, Axes, draw_head
from .canvas import Canvas
from .coloring import label_color
from .colormaps import check_colormap, colormap_table
from .legends import letter_size
from .ticks import format_number, widen

Limits = tuple[float, float]

PLAIN = (0.36, 0.53, 0.71)  # bars without a colour map
LEAST, MOST = (200, 160), 16_384  # [px] of a plot's width and height: smaller, the numbers of the axes find no room
HUGE = 1e300  # greater numbers count as infinite: their differences would be
_SAMPLE = 1_000_000  # values that quantiles come from
_TAIL = 0.002  # share of the values at either end that may lie beyond a histogram
_FAR = 1.5  # ... where the whole range is so many times the rest's
_DENSE = 16  # points a column from which a curve is drawn by the extremes of each half column
_HALVES = 2


def histogram(
    values: ArrayLike,
    *,
    title: str = "",
    labels: tuple[str, str] = ("value", "count"),
    bins: int | None = None,
    limits: Limits | None = None,
    colormap: str | None = None,
    color_limits: Limits | None = None,
    marks: Sequence[tuple[str, float]] = (),
    size: tuple[int, int] = (640, 480),
    device: Any = None,
) -> Canvas:
    """Draw how often values occur.

    Args:
        values: Any shape; what is not finite does not count, and is told.
        title: Above the plot.
        labels: Of the two axes, with their units: ("distance [m]", "points").
        bins: How many; None takes one for some pixels of width, fewer for few values.
        limits: Ends of the axis; None takes all values but far ones, whose number is told.
        colormap: Bars take its colours.
        color_limits: The values at the two ends of the map; None takes the ends of the axis.
        marks: Names and values to be marked by lines: ("median", 0.01).
        size: Width and height [px].
        device: Where to draw.

    Raises:
        TypeError: Not numbers.
        ValueError: A size, limits or bins that make no picture, or an unknown colour map.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> distances = np.abs(np.random.default_rng(0).normal(0, 0.01, 1000))
        >>> plot = loom.plots.histogram(distances, labels=("distance [m]", "points"), marks=[("median", 0.007)])
        >>> plot.to_numpy().shape
        (480, 640, 3)
    """
    canvas = Canvas.blank(*check_size(size), device=device)
    area = Area(0, 0, canvas.width, canvas.height)
    draw_histogram(
        canvas,
        area,
        values,
        title=title,
        labels=labels,
        bins=bins,
        limits=limits,
        colormap=colormap,
        color_limits=color_limits,
        marks=marks,
    )
    return canvas


def draw_histogram(
    canvas: Canvas,
    area: Area,
    values: ArrayLike,
    *,
    title: str = "",
    labels: tuple[str, str] = ("value", "count"),
    bins: int | None = None,
    limits: Limits | None = None,
    colormap: str | None = None,
    color_limits: Limits | None = None,
    marks: Sequence[tuple[str, float]] = (),
) -> None:
    """Draw a histogram into a part of a picture, as `histogram`."""
    numbers = _check_numbers("values", values).ravel()
    finite = numbers[np.isfinite(numbers)]
    size = letter_size(canvas)
    title, labels, named = check_name("title", title), _check_labels(labels), _check_marks(marks)
    ends = widen(*(_main_range(finite) if limits is None else _check_ends("limits", limits)))
    count = check_count("bins", bins) if bins is not None else _bin_count(finite, area.width, size)
    heights, edges = np.histogram(finite, count, ends)
    beyond = len(finite) - int(heights.sum())
    notes = [f"{len(finite):,} value" + "s" * (len(finite) != 1)]
    notes += [f"{beyond:,} beyond"] * (beyond > 0)
    notes += [f"{len(numbers) - len(finite):,} not finite"] * (len(finite) < len(numbers))
    entries = [(f"{name} {format_number(value)}", label_color(k + 1)) for k, (name, value) in enumerate(named)]
    inner = draw_head(canvas, area, title, ", ".join(notes), entries, size)
    most = max(1.0, 1.05 * float(heights.max()))
    axes = Axes(canvas, inner, ends, (0.0, most), titles=labels, size=size, whole=(False, True))
    filled, colors = np.flatnonzero(heights), None
    if colormap is not None:
        low, high = widen(*(ends if color_limits is None else _check_ends("color_limits", color_limits)))
        shares = ((edges[filled] + edges[filled + 1]) / 2 - low) / (high - low)
        colors = colormap_table(check_colormap(colormap))[np.floor(shares.clip(0, 1) * 255 + 0.5).astype(int)]
    _draw_bars(axes, edges, heights, filled, colors)
    for k, (_, value) in enumerate(named):
        axes.polyline([value, value], [0.0, most], color=label_color(k + 1), width=2)


def _draw_bars(
    axes: Axes, edges: NDArray[Any], heights: NDArray[Any], filled: NDArray[np.int64], colors: NDArray[Any] | None
) -> None:
    """Bars of the bins that hold something, whose colours these are."""
    begins, ends = (np.round(axes.columns(edges[at])).astype(int).tolist() for at in (filled, filled + 1))
    tops, (first, second) = np.round(axes.rows(heights[filled])).astype(int).tolist(), np.round(axes.columns(edges[:2]))
    gap = int(second - first > 4)
    for k, (begin, end, top) in enumerate(zip(begins, ends, tops, strict=True)):
        color = PLAIN if colors is None else colors[k].tolist()
        top = min(top, axes.bottom - 1)  # even a bar of one among millions is seen
        axes.canvas.rectangle(begin + 1, top, max(end - begin - gap, 1), axes.bottom - top, fill=color)


def curves(
    series: Mapping[str, ArrayLike],
    *,
    x: ArrayLike | None = None,
    title: str = "",
    labels: tuple[str, str] = ("number", "value"),
    limits: Limits | None = None,
    size: tuple[int, int] = (640, 480),
    device: Any = None,
) -> Canvas:
    """Draw values as lines, one after the other from left to right.

    Args:
        series: Names and values, shape [n] each; what is not finite is a gap. A single value is a dot.
        x: Where the values lie along the axis, shape [n]; None numbers them from 0.
        title: Above the plot.
        labels: Of the two axes, with their units.
        limits: Ends of the axis of values; None takes all that are finite.
        size: Width and height [px].
        device: Where to draw.

    Raises:
        TypeError: Not numbers, or no mapping from names.
        ValueError: Another shape, not as many values as places, or a size that makes no picture.

    Example:
        >>> import pointloom as loom
        >>> loom.plots.curves({"fitness": [0.2, 0.6, 0.9]}, labels=("step", "share")).to_numpy().shape
        (480, 640, 3)
    """
    canvas = Canvas.blank(*check_size(size), device=device)
    area = Area(0, 0, canvas.width, canvas.height)
    draw_curves(canvas, area, series, x=x, title=title, labels=labels, limits=limits)
    return canvas


def draw_curves(
    canvas: Canvas,
    area: Area,
    series: Mapping[str, ArrayLike],
    *,
    x: ArrayLike | None = None,
    title: str = "",
    labels: tuple[str, str] = ("number", "value"),
    limits: Limits | None = None,
) -> None:
    """Draw curves into a part of a picture, as `curves`."""
    if not isinstance(series, Mapping):
        raise TypeError(f"series: expected a dict of names and values, got {shown(series)}")
    title, labels = check_name("title", title), _check_labels(labels)
    given = None if limits is None else _check_ends("limits", limits)
    size = letter_size(canvas)
    places = None if x is None else _check_row("x", x)
    rows = {str(name): _check_row(str(name), values) for name, values in series.items()}
    for name, values in rows.items():
        if places is not None and len(values) != len(places):
            raise ValueError(f"{name}: expected as many values as x, {len(places)}, got {len(values)}")
    entries = [(name, label_color(k)) for k, name in enumerate(rows)] if len(rows) > 1 else []
    inner = draw_head(canvas, area, title, "", entries, size)
    across = finite_range([np.arange(len(v)) for v in rows.values()] if places is None else [places])
    along = finite_range(rows.values()) if given is None else given
    if given is None:
        low, high = widen(*along)
        along = low - 0.03 * (high - low), high + 0.03 * (high - low)
    axes = Axes(canvas, inner, across, along, titles=labels, size=size, whole=(places is None, False))
    for k, values in enumerate(rows.values()):
        draw_curve(axes, np.arange(len(values)) if places is None else places, values, color=label_color(k))


def draw_curve(axes: Axes, x: NDArray[Any], y: NDArray[Any], **style: Any) -> None:
    """Draw one curve into a frame; of many points the extremes of each column, which look the same."""
    width = axes.right - axes.left
    if len(x) > _DENSE * width and bool((np.diff(x) >= 0).all()):
        x, y = _thin(axes, x, y)
    style = {"width": max(1.5, axes.size / 10), **style}
    axes.polyline(x, y, **style)
    is_there = np.isfinite(y)
    lone = is_there & ~np.r_[False, is_there[:-1]] & ~np.r_[is_there[1:], False]
    axes.dots(x[lone], y[lone], radius=style["width"] + 0.5, color=style["color"])


def _thin(axes: Axes, x: NDArray[Any], y: NDArray[Any]) -> tuple[NDArray[Any], NDArray[Any]]:
    """The first, least, greatest and last finite value of each half column; gaps that are narrower than two close."""
    there = np.flatnonzero(np.isfinite(y) & np.isfinite(x))
    if not len(there):
        return x[:0], y[:0]
    values, columns = y[there], np.floor(_HALVES * axes.columns(x[there])).astype(np.int64)
    starts = np.flatnonzero(np.r_[True, np.diff(columns) > 0])
    kept = [starts, np.r_[starts[1:], len(there)] - 1]
    sizes = np.diff(np.r_[starts, len(there)])
    for extremes in (np.minimum.reduceat(values, starts), np.maximum.reduceat(values, starts)):
        places = np.flatnonzero(values == np.repeat(extremes, sizes))
        kept.append(places[np.r_[True, np.diff(columns[places]) > 0]])
    rows = np.unique(np.concatenate(kept))
    gaps = np.flatnonzero(np.diff(columns[rows]) > 2 * _HALVES) + 1
    thin_x, thin_y = x[there[rows]].astype(np.float64), values[rows].astype(np.float64)
    return np.insert(thin_x, gaps, np.nan), np.insert(thin_y, gaps, np.nan)


def _main_range(values: NDArray[Any]) -> Limits:
    """The ends of an axis for values: all of them, or without few that lie far from the rest."""
    if not len(values):
        return 0.0, 1.0
    low, high = float(values.min()), float(values.max())
    sample = values[:: max(1, -(-len(values) // _SAMPLE))]
    near, far = np.quantile(sample.astype(np.float64), (_TAIL, 1 - _TAIL)).tolist()
    if near < far and high - low > _FAR * (far - near):
        return (low if near - low <= 0.1 * (far - near) else near), (high if high - far <= 0.1 * (far - near) else far)
    return low, high


def _bin_count(values: NDArray[Any], width: int, size: int) -> int:
    """How many bars: some pixels each, fewer for few values, an odd number for one value, which is in the middle."""
    if not len(values) or values.min() == values.max():
        return 11
    return max(1, min(width // max(size // 2, 6), round(2 * math.sqrt(len(values)))))


def finite_range(rows: Iterable[NDArray[Any]]) -> Limits:
    """The extent of all that is finite; 0 and 1 without any."""
    ends = [(float(v.min()), float(v.max())) for v in (row[np.isfinite(row)] for row in rows) if len(v)]
    return (min(low for low, _ in ends), max(high for _, high in ends)) if ends else (0.0, 1.0)


def _check_numbers(name: str, values: ArrayLike) -> NDArray[Any]:
    """Numbers; those so large that differences may overflow count as not finite."""
    numbers = check_numeric(name, values)
    if numbers.dtype.kind == "b":
        return numbers.astype(np.uint8)
    if numbers.dtype == np.float64 and numbers.size and not np.abs(numbers).max() < HUGE:
        numbers = np.where(np.abs(numbers) < HUGE, numbers, np.nan)
    return numbers


def _check_row(name: str, values: ArrayLike) -> NDArray[Any]:
    row = _check_numbers(name, values)
    if row.ndim != 1:
        raise ValueError(f"{name}: expected shape [n], got {list(row.shape)}")
    return row


def _check_labels(labels: Any) -> tuple[str, str]:
    """What stands at the two axes."""
    names = check_list("labels", labels, "the names of two axes")
    if len(names) != 2:
        raise ValueError(f"labels: expected the names of two axes, got {len(names)}")
    return check_name("labels[0]", names[0]), check_name("labels[1]", names[1])


def _check_ends(name: str, limits: Any) -> Limits:
    """The two ends of an axis, whatever they are: `widen` parts those that are no range."""
    low, high = check_shape(name, limits, (2,)).tolist()
    return low, high


def _check_marks(marks: Any) -> list[tuple[str, float]]:
    """Names and the values that are marked by them."""
    checked = []
    for k, mark in enumerate(check_list("marks", marks, "names and values")):
        pair = check_list(f"marks[{k}]", mark, "a name and a value")
        if len(pair) != 2:
            raise ValueError(f"marks[{k}]: expected a name and a value, got {shown(mark)}")
        value = check_number(f"marks[{k}]", pair[1], allow_nan=True, allow_infinite=True)
        checked.append((str(pair[0]), value))
    return checked


def check_size(size: Any, least: tuple[int, int] = LEAST) -> tuple[int, int]:
    """Width and height [px] of a plot.

    Raises:
        ValueError: Too small for the numbers of the axes, or no pair.
    """
    try:
        width, height = size
    except (TypeError, ValueError):
        raise ValueError(f"size: expected width and height [px], got {shown(size)}") from None
    because = "pictures this large are not plots"
    width = check_count("size: width", width, minimum=least[0], maximum=MOST, because=because)
    return width, check_count("size: height", height, minimum=least[1], maximum=MOST, because=because)
