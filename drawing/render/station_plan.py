"""A plan of stations: where they stand, what ties them, how far it misses, ellipses of errors: `station_plan`."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_positive
from ...registration.stations.observations import ControlPoint, StationPair, TargetObservation
from ...registration.stations.result import StationsResult
from .axes import Area, Axes, draw_head
from .canvas import WHITE, Canvas, Color
from .colormaps import colormap_table
from .legends import END_ROOM, letter_size, paint_bar
from .plots import check_size
from .ticks import choose_ticks, count_ticks, with_ends

STATION, LOST, WRONG, TARGET, CONTROL = (
    (0.1, 0.1, 0.1), (0.6, 0.6, 0.6), (0.84, 0.1, 0.1), (0.12, 0.47, 0.71), (0.1, 0.55, 0.2)
)  # fmt: skip
SIGHT = (0.85, 0.89, 0.93)  # from a station to a target
COLORMAP = "viridis"
MISSES = "pairs miss by [mm]"
ELLIPSE = 0.06  # of the plan's extent: the longest semi-axis that is drawn
ROOM = 0.1  # of the plan's extent, around what is outermost
TURNS = np.linspace(0, 2 * np.pi, 61)
NAMED = 60  # targets up to which their names are written
LEAST = 320, 240  # [px]
MM = 1000.0
NICE = (1, 2, 5, 10)


def station_plan(
    result: StationsResult,
    *,
    title: str = "stations",
    size: tuple[int, int] = (1280, 960),
    confidence: float = 0.95,
    device: Any = None,
) -> Canvas:
    """Draw stations from above, y up: pairs coloured by how far they miss, sights to targets, ellipses of errors.

    Args:
        result: Of `register_stations`.
        title: Above the plan.
        size: Width and height [px].
        confidence: That the true place lies inside an ellipse, above 0 and below 1.
        device: Where to draw.

    Returns:
        The picture. Red is what was taken out, grey are stations that float free; how much larger ellipses are
        than the plan is told above it.

    Raises:
        ValueError: A size that is too small, or no such confidence.
    """
    share = check_positive("confidence", confidence)
    if share >= 1:
        raise ValueError(f"confidence: expected above 0 and below 1, got {confidence!r}")
    canvas = Canvas.blank(*check_size(size, LEAST), device=device)
    letters = letter_size(canvas)
    places = _places(result)
    extent = float(max(np.ptp(places, axis=0).max(), 1e-3))
    ellipses = _ellipses(result, float(np.sqrt(-2 * np.log(1 - share))))
    longest = max((float(np.abs(curve).max()) for _, _, curve in ellipses), default=0.0)
    times = _round_down(ELLIPSE * extent / longest) if longest > 0 else 1.0
    entries: list[tuple[str, Color]] = [("target", TARGET), ("control", CONTROL), ("taken out", WRONG)]
    used = [bool(result.targets), any(g.kind == "control" for g in result.groups), bool(result.outliers)]
    entries = [entry for entry, there in zip(entries, used, strict=True) if there]
    note = f"ellipses of {share:.0%}, {times:,.0f} times as large" if longest else ""
    note = f"sigma0 {result.sigma0:.2f}, {note}".rstrip(", ")
    area = draw_head(canvas, Area(0, 0, canvas.width, canvas.height), title, note, entries, letters)
    pairs = [g for g in result.groups if g.kind == "pair"]
    misses = np.array([float(np.linalg.norm(g.residual[-3:])) * MM for g in pairs])
    bar, ticks = 0, choose_ticks(0.0, 1.0, 2)
    if len(pairs):
        apart = END_ROOM * letters / max(area.height - 6 * letters, letters)
        ticks = with_ends(
            choose_ticks(0.0, float(misses.max()) or 1.0, count_ticks(area.height, letters)), min(apart, 0.5)
        )
        bar = round(3.5 * letters) + max(canvas.text_width(text, letters) for text in ticks.texts)
        bar = max(bar, canvas.text_width(MISSES, letters) + letters)
    low, high = places.min(axis=0) - ROOM * extent, places.max(axis=0) + ROOM * extent
    plan = Area(area.left, area.top, area.width - bar, area.height)
    axes = Axes(canvas, plan, (low[0], high[0]), (low[1], high[1]), titles=("x [m]", "y [m]"), size=letters, equal=True)
    if len(pairs):
        left = axes.right + letters
        canvas.text(ticks.title(MISSES), left, axes.top, size=letters, anchor="upper left")
        height = axes.bottom - axes.top + 1 - 2 * letters
        paint_bar(canvas, left, axes.top + 2 * letters, round(1.2 * letters), height, COLORMAP, ticks, letters)
    _draw_links(axes, result, pairs, misses)
    for x, y, curve in ellipses:
        axes.polyline(x + times * curve[0], y + times * curve[1], color=STATION, width=1.5)
    _draw_places(axes, result, letters)
    return canvas


def _places(result: StationsResult) -> NDArray[np.float64]:
    """Everything that stands on the plan, [n, 2]."""
    stations = result.poses[result.placed if result.placed.any() else slice(None), :2, 3]
    return np.vstack([stations, *(place[None, :2] for place in result.targets.values())])


def _ellipses(result: StationsResult, times: float) -> list[tuple[float, float, NDArray[np.float64]]]:
    """Of each station that has errors where it stands, and its ellipse about zero [m]."""
    found = []
    first = result.covariances.shape[1] - 3
    for i in np.flatnonzero(result.placed):
        values, vectors = np.linalg.eigh(result.covariances[i][first : first + 2, first : first + 2])
        if values[1] > 0:
            axes = times * np.sqrt(np.maximum(values, 0))[:, None] * np.stack([np.cos(TURNS), np.sin(TURNS)])
            x, y = result.poses[i][:2, 3]
            found.append((float(x), float(y), vectors @ axes))
    return found


def _round_down(value: float) -> float:
    """The largest of 1, 2 or 5 times a power of ten that is no more; at least 1."""
    power = 10.0 ** np.floor(np.log10(max(value, 1.0)))
    return float(max(n * power for n in NICE if n * power <= max(value, 1.0)))


def _draw_links(axes: Axes, result: StationsResult, pairs: list[Any], misses: NDArray[np.float64]) -> None:
    """Sights to targets, pairs in their colours, and above them what was taken out."""
    where = result.poses[:, :2, 3]
    for group in result.groups:
        one = group.observation
        if isinstance(one, TargetObservation) and one.name in result.targets:
            _line(axes, where[one.station], result.targets[one.name][:2], SIGHT, 1.5)
    table, largest = colormap_table(COLORMAP), float(misses.max(initial=0.0)) or 1.0
    for group, miss in zip(pairs, misses, strict=True):
        pair = group.observation
        red, green, blue = table[int(miss / largest * 255)]
        _line(axes, where[pair.source], where[pair.target], (float(red), float(green), float(blue)), 4.0)
    for outlier in result.outliers:
        one = outlier.group.observation
        if isinstance(one, StationPair):
            _line(axes, where[one.source], where[one.target], WRONG, 2.0)
        elif isinstance(one, TargetObservation) and one.name in result.targets:
            _line(axes, where[one.station], result.targets[one.name][:2], WRONG, 2.0)


def _line(axes: Axes, a: NDArray[np.float64], b: NDArray[np.float64], color: Color, width: float) -> None:
    axes.polyline([a[0], b[0]], [a[1], b[1]], color=color, width=width)


def _draw_places(axes: Axes, result: StationsResult, letters: int) -> None:
    """Targets, control and stations, with their names."""
    canvas, held = axes.canvas, {g.observation.name for g in result.groups if isinstance(g.observation, ControlPoint)}
    for name, place in result.targets.items():
        x, y = float(axes.columns(place[0])), float(axes.rows(place[1]))
        color, half = (CONTROL, 0.45 * letters) if name in held else (TARGET, 0.3 * letters)
        canvas.polyline([[x - half, y + half], [x + half, y + half], [x, y - half]], color=color, width=2, closed=True)
        if len(result.targets) <= NAMED:
            canvas.text(name, x + letters * 0.7, y, size=letters, color=color, halo=WHITE)
    for name, T, there in zip(result.names, result.poses, result.placed, strict=True):
        x, y = float(axes.columns(T[0, 3])), float(axes.rows(T[1, 3]))
        if axes.left <= x <= axes.right and axes.top <= y <= axes.bottom:
            color = STATION if there else LOST
            canvas.circle(x, y, 0.4 * letters, fill=color, outline=WHITE, width=1.5)
            canvas.text(name, x + 0.7 * letters, y - 0.8 * letters, size=letters, color=color, halo=WHITE)
