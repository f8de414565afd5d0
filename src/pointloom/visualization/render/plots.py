"""Plots with axes by matplotlib (extra `pointloom[plot]`, imported on first use).

Figures have their own Agg canvas, so pyplot and its global state are not used.
"""

from __future__ import annotations

import importlib
import os
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.argument_errors import explain_argument_errors
from ...core.checks import check_count, check_name, check_positive, shown
from ...core.errors import FilePath
from ...core.exchange import asnumpy
from ...io.optional_imports import import_for
from ...meshing.volume.distance_field_views import FieldSlice
from ...registration.stations.observations import ControlPoint, StationPair, TargetObservation
from ...registration.stations.result import StationsResult
from .colormaps import check_colormap
from .picture import Picture
from .picture_files import check_picture, write_image

DPI = 128  # a power of two, so that sizes in inches are exact
MIN_SIZE, MAX_SIZE = (320, 240), 16_384  # [px]
PLOT_SIZE = 1280, 960  # [px] of trajectories and station plans

TRUTH = "0.55"
ERROR = "error [m]"
MAX_COORDINATE = 1e12  # [m] positions farther out are not drawn
MAX_VERTICES = 50_000  # of a trajectory that are drawn. The errors along the way are drawn in full

TAIL_QUANTILE = 0.998  # quantile of the errors at which the axis of a histogram ends if the largest is far beyond
MAX_TAIL_RATIO = 1.5  # ... this many times the quantile
MAX_BINS = 60

STATION, UNPLACED, WRONG, TARGET, CONTROL, SIGHT = "0.1", "0.6", "#d61a1a", "#1f78b5", "#1a8c33", "#d9e3ed"
ELLIPSE_CONFIDENCE = 0.95  # of the ellipses of errors
ELLIPSE_SIZE = 0.06  # length of the longest semi-axis over the extent of the plan
PLAN_MARGIN = 0.1  # over the extent of the plan
MAX_NAMED = 60  # up to this number of targets, their names are written
MM_PER_METER = 1000.0

MAP_CELLS = 800  # along the longer side of a map from above
MAP_PERCENTILES = (2, 98)  # of the heights, at the ends of the color scale
PATH_COLOR, LOOP_COLOR = "#d61a1a", "#f08c00"

OCCUPIED_COLOR, UNKNOWN_COLOR = (26, 26, 26), (153, 153, 153)  # of 255


def check_plot(path: FilePath, *, overwrite: bool) -> None:
    """Check matplotlib, extension and path before any work. Raises FileError."""
    check_picture(path, overwrite=overwrite)
    import_for(path, "matplotlib.figure", "plot")


def new_figure(width: int, height: int) -> Any:
    """An empty figure with an Agg canvas of this size [px]. Raises ImportError without matplotlib."""
    figure = _matplotlib("figure").Figure(figsize=(width / DPI, height / DPI), dpi=DPI, layout="constrained")
    _matplotlib("backends.backend_agg").FigureCanvasAgg(figure)
    return figure


def to_picture(figure: Any) -> Picture:
    figure.canvas.draw()
    return Picture(np.asarray(figure.canvas.buffer_rgba())[..., :3].copy())


def trajectory_plot(
    estimate: NDArray[np.float64], truth: NDArray[np.float64], *, times: NDArray[np.float64] | None, title: str
) -> Picture:
    """Plot a trajectory beside the true one in the plane of its two largest extents, and the error along the way.

    Positions are (n, 3) [m] at the same times [s] in the same frame. Non-finite rows are gaps.
    """
    path, true = (np.where(np.abs(rows) < MAX_COORDINATE, rows, np.nan) for rows in (estimate, truth))
    errors = np.linalg.norm(path - true, axis=1)
    finite = errors[np.isfinite(errors)]
    largest = float(finite.max(initial=0.0)) or 1.0
    figure = new_figure(*PLOT_SIZE)
    upper, lower = figure.subplots(2, height_ratios=[2, 1])
    across, along = plane = _main_axes(np.vstack([path, true]))
    step = max(1, -(-len(path) // MAX_VERTICES))
    upper.plot(*true[::step, plane].T, color=TRUTH, linewidth=2.5, label="truth")
    corners = path[::step, plane]
    segments = np.stack([corners[:-1], corners[1:]], axis=1)
    drawn = np.isfinite(segments).all(axis=(1, 2))
    color_of = _color_scale("turbo", 0.0, largest)
    colors = color_of.to_rgba(errors[::step][:-1][drawn])
    upper.add_collection(_matplotlib("collections").LineCollection(segments[drawn], colors=colors, linewidths=1.5))
    ends = path[np.isfinite(path).all(axis=1)][:, plane]
    for name, marker, at in (("start", "o", ends[:1]), ("end", "s", ends[-1:])):
        upper.plot(*at.T, marker, color="black", markerfacecolor="white", zorder=3, label=name)
    _set_plan(upper, "xyz"[across], "xyz"[along])
    upper.legend(loc="upper right")  # "best" is slow for long paths, and Matplotlib then warns
    figure.colorbar(color_of, ax=upper, label=ERROR)
    if len(finite):
        rmse, median, highest = np.sqrt((finite**2).mean()), np.median(finite), finite.max()
        title += f"\n{len(finite):,} poses, error {rmse:.3g} m rmse, {median:.3g} m median, {highest:.3g} m at most"
    upper.set_title(title, parse_math=False)
    lower.plot(np.arange(len(path)) if times is None else times - times[:1], errors, linewidth=1.0)
    lower.set(
        xlabel="pose" if times is None else "time from the first pose [s]", ylabel=ERROR, ylim=(0, 1.05 * largest)
    )
    lower.grid(alpha=0.3)
    return to_picture(figure)


def error_histogram(
    distances: NDArray[np.floating], size: tuple[int, int], *, title: str, label: str, colormap: str, limit: float
) -> Picture:
    """Plot a histogram of distances; `limit` is the distance at the last color. The title counts non-finite values."""
    finite = distances[np.isfinite(distances)].astype(np.float64)
    largest = float(finite.max(initial=0.0)) or 1.0
    tail = float(np.quantile(finite, TAIL_QUANTILE)) if len(finite) else 0.0
    high = tail if 0 < MAX_TAIL_RATIO * tail < largest else largest
    bins = min(MAX_BINS, max(1, round(2 * len(finite) ** 0.5)))
    figure = new_figure(*size)
    axes = figure.subplots()
    counts, edges, bars = axes.hist(finite, bins=bins, range=(0.0, high))
    color_of = _color_scale(colormap, 0.0, limit)
    for bar, color in zip(bars, color_of.to_rgba((edges[:-1] + edges[1:]) / 2), strict=True):
        bar.set_facecolor(color)
    if len(finite):
        for name, value, color in (("median", np.median(finite), "C1"), ("largest", finite.max(), "C3")):
            axes.axvline(value, color=color, label=f"{name} {value:.3g}")
        axes.legend(loc="upper right")
    beyond, missing = len(finite) - int(counts.sum()), distances.size - len(finite)
    title += f"\n{len(finite):,} values" + f", {beyond:,} beyond the axis" * bool(beyond)
    axes.set_title(title + f", {missing:,} not finite" * bool(missing), parse_math=False)
    axes.set(xlabel=label, ylabel="vertices", xlim=(0.0, 1.02 * high))
    axes.locator_params(axis="x", nbins=5)
    return to_picture(figure)


def station_plan(result: StationsResult) -> Picture:
    """Plot stations from above: pairs colored by residuals (outliers red), sights to targets, scaled error ellipses."""
    where = result.poses[:, :2, 3]
    registered = where[result.placed if result.placed.any() else slice(None)]
    positions = np.vstack([registered, *(position[None, :2] for position in result.targets.values())])
    extent = float(max(np.ptp(positions, axis=0).max(), 1e-3))
    figure = new_figure(*PLOT_SIZE)
    axes = figure.subplots()
    _draw_links(figure, axes, result)
    title = f"stations\nsigma0 {result.sigma0:.2f}"
    if enlarged := _draw_ellipses(axes, result, extent):
        title += f", ellipses of {ELLIPSE_CONFIDENCE:.0%}, {enlarged:,.0f} times as large"
    control = {g.observation.name for g in result.groups if isinstance(g.observation, ControlPoint)}
    for name, position in result.targets.items():
        color = CONTROL if name in control else TARGET
        axes.plot(*position[:2], "^", color=color, markersize=9 if name in control else 6, fillstyle="none")
        _write_name(axes, name if len(result.targets) <= MAX_NAMED else "", position, color, -3)
    low, high = positions.min(axis=0) - PLAN_MARGIN * extent, positions.max(axis=0) + PLAN_MARGIN * extent
    for name, position, is_registered in zip(result.names, where, result.placed, strict=True):
        if not ((low <= position) & (position <= high)).all():
            continue  # not placed, and far from the others
        color = STATION if is_registered else UNPLACED
        axes.plot(*position, "o", color=color, markeredgecolor="white", markersize=8)
        _write_name(axes, name, position, color, 4)
    used = [bool(result.targets), bool(control), bool(result.outliers)]
    for name, color, is_used in zip(("target", "control", "outlier"), (TARGET, CONTROL, WRONG), used, strict=True):
        if is_used:
            axes.plot([], [], "-" if color == WRONG else "^", color=color, fillstyle="none", label=name)
    if any(used):
        axes.legend(loc="upper right")
    axes.set_title(title)
    axes.margins(PLAN_MARGIN)
    _set_plan(axes, "x", "y")
    return to_picture(figure)


@explain_argument_errors
def map_plan(
    points: NDArray[np.float64],
    path: NDArray[np.float64],
    loops: Sequence[tuple[NDArray[np.float64], NDArray[np.float64]]],
    title: str,
) -> Picture:
    """Plot a map from above, the path (n, 3) through it, and lines between the positions of each loop [m]."""
    figure = new_figure(*PLOT_SIZE)
    axes = figure.subplots()
    if len(points):
        low, high = points[:, :2].min(axis=0), points[:, :2].max(axis=0)
        cell = max(float((high - low).max()) / MAP_CELLS, 1e-9)
        i, j = np.floor((points[:, :2] - low) / cell).astype(np.int64).T
        heights = np.full((i.max() + 1, j.max() + 1), -np.inf)
        np.maximum.at(heights, (i, j), points[:, 2])
        shown = np.where(np.isfinite(heights), heights, np.nan).T
        limits = np.nanpercentile(shown, MAP_PERCENTILES)
        extent = (low[0], low[0] + heights.shape[0] * cell, low[1], low[1] + heights.shape[1] * cell)
        image = axes.imshow(shown, origin="lower", extent=extent, cmap="viridis", vmin=limits[0], vmax=limits[1])
        figure.colorbar(image, ax=axes, label="height [m]")
    step = max(1, -(-len(path) // MAX_VERTICES))
    axes.plot(*path[::step, :2].T, color=PATH_COLOR, linewidth=1.5, label="path")
    for k, (start, end) in enumerate(loops):
        label = f"{len(loops)} loops" if k == 0 else None
        axes.plot([start[0], end[0]], [start[1], end[1]], color=LOOP_COLOR, linewidth=1.5, label=label)
    _set_plan(axes, "x", "y")
    axes.ticklabel_format(useOffset=False, style="plain")  # coordinates of maps have seven digits
    axes.set_title(title, parse_math=False)
    if len(path):
        axes.legend(loc="upper right")
    return to_picture(figure)


def draw_slice(
    layer: FieldSlice,
    path: str | os.PathLike[str] | None = None,
    *,
    title: str | None = None,
    colormap: str | None = None,
    limit: float | None = None,
    size: tuple[int, int] = (960, 720),
    overwrite: bool = True,
) -> Picture:
    """Plot a layer of a distance field with a color bar. Requires `pip install "pointloom[plot]"`.

    Args:
        layer: Result of `DistanceField.slice`.
        path: A .png or .webp file to write, or None.
        title: Title of the plot. If None, the position of the layer.
        colormap: See `render`. If None: viridis, or coolwarm for negative distances.
        limit: Distance of the last color [m]. If None, the largest known distance.
        size: Width and height [px].
        overwrite: Replace an existing file.

    Returns:
        A Picture, uint8 RGB. Occupied voxels are black (except in signed fields), unknown distances gray.

    Raises:
        TypeError, ValueError: Not a FieldSlice, an empty layer, or an argument out of range.
        FileError, ImportError: The file cannot be written, or matplotlib is not installed.

    Example:
        >>> import pointloom as loom
        >>> field = loom.DistanceField.from_voxels([[0, 0, 0], [9, 3, 0]], 0.1, max_distance=1)
        >>> picture = loom.draw_slice(field.slice("z", 0.05), "slice.png", size=(480, 360))
        >>> picture.shape
        (360, 480, 3)
    """
    if not isinstance(layer, FieldSlice):
        raise TypeError(f"layer: expected a FieldSlice, got {type(layer).__name__}")
    if not layer.distances.size:
        raise ValueError("layer: has no voxels, because its field has none; pass bounds to `DistanceField.slice`")
    values, known = asnumpy(layer.distances), asnumpy(layer.is_known)
    is_signed = bool((values[known] < 0).any())
    finite = np.abs(values[known & np.isfinite(values)])
    high = (float(finite.max(initial=0)) or 1.0) if limit is None else check_positive("limit", limit, maximum=1e100)
    name = check_colormap(colormap or ("coolwarm" if is_signed else "viridis"))
    heading = f"{layer.axis} = {layer.position:g} m" if title is None else check_name("title", title)
    figure = new_figure(*_check_size(size))
    axes = figure.subplots()
    color_of = _color_scale(name, -high * is_signed, high)
    colors, occupied = color_of.to_rgba(values, bytes=True)[..., :3], known & (values == 0) & (not is_signed)
    colors[occupied], colors[~known] = OCCUPIED_COLOR, UNKNOWN_COLOR
    (x0, y0), (x1, y1) = layer.extent.tolist()
    axes.imshow(colors, origin="lower", extent=(x0, x1, y0, y1), interpolation="nearest", zorder=2)
    figure.colorbar(color_of, ax=axes, label="distance [m]")
    unknown = "unknown" if layer.max_distance is None else f"at least {layer.max_distance:g} m"
    patches = [("occupied", OCCUPIED_COLOR, occupied.any()), (unknown, UNKNOWN_COLOR, not known.all())]
    make_patch = _matplotlib("patches").Patch
    if handles := [make_patch(color=np.array(color) / 255, label=text) for text, color, is_used in patches if is_used]:
        figure.legend(handles=handles, loc="outside lower center", ncols=2)
    axes.set_title(heading, parse_math=False)
    _set_plan(axes, *layer.axes)
    picture = to_picture(figure)
    if path is not None:
        write_image(path, picture, overwrite=overwrite)
    return picture


def _matplotlib(module: str) -> Any:
    try:
        return importlib.import_module(f"matplotlib.{module}")
    except ImportError as error:
        raise ImportError('plots require the package matplotlib: pip install "pointloom[plot]"') from error


def _color_scale(colormap: str, low: float, high: float) -> Any:
    return _matplotlib("cm").ScalarMappable(norm=_matplotlib("colors").Normalize(low, high), cmap=colormap)


def _main_axes(positions: NDArray[np.float64]) -> list[int]:
    finite = positions[np.isfinite(positions).all(axis=1)]
    extents = np.ptp(finite, axis=0) if len(finite) else np.zeros(3)
    return sorted(np.argsort(-extents, kind="stable")[:2].tolist())


def _set_plan(axes: Any, across: str, along: str) -> None:
    axes.set_aspect("equal", adjustable="datalim")
    axes.ticklabel_format(useOffset=False, style="plain")
    axes.set(xlabel=f"{across} [m]", ylabel=f"{along} [m]")
    axes.grid(alpha=0.3)


def _draw_links(figure: Any, axes: Any, result: StationsResult) -> None:
    """Draw sights to targets, pairs with a color bar of residuals, and outliers on top."""
    make_lines, where = _matplotlib("collections").LineCollection, result.poses[:, :2, 3]

    def ends_of(groups: list[Any]) -> list[Any]:
        sights = [g.observation for g in groups if isinstance(g.observation, TargetObservation)]
        pairs = [g.observation for g in groups if isinstance(g.observation, StationPair)]
        links = [(where[o.station], result.targets[o.name][:2]) for o in sights if o.name in result.targets]
        return links + [(where[o.source], where[o.target]) for o in pairs]

    pairs = [g for g in result.groups if g.kind == "pair"]
    axes.add_collection(
        make_lines(ends_of([g for g in result.groups if g.kind != "pair"]), colors=SIGHT), autolim=False
    )
    if pairs:
        residuals = np.array([np.linalg.norm(g.residual[-3:]) * MM_PER_METER for g in pairs])
        color_of = _color_scale("viridis", 0.0, float(residuals.max()) or 1.0)
        lines = make_lines(ends_of(pairs), colors=color_of.to_rgba(residuals), linewidths=3)
        axes.add_collection(lines, autolim=False)
        figure.colorbar(color_of, ax=axes, label="residuals of pairs [mm]")
    lines = make_lines(ends_of([o.group for o in result.outliers]), colors=WRONG, linewidths=2)
    axes.add_collection(lines, autolim=False)


def _draw_ellipses(axes: Any, result: StationsResult, extent: float) -> float:
    """Draw the error ellipses of the stations. Returns their scale, 0 if there is none."""
    first = result.covariances.shape[1] - 3
    registered = np.flatnonzero(result.placed)
    values, vectors = np.linalg.eigh(result.covariances[registered][:, first : first + 2, first : first + 2])
    lengths = 2 * np.sqrt(-2 * np.log(1 - ELLIPSE_CONFIDENCE) * np.maximum(values, 0))  # of both axes, ascending
    longest = float(lengths.max(initial=0.0)) / 2
    if not longest > 0:
        return 0.0
    largest = max(ELLIPSE_SIZE * extent / longest, 1.0)
    power = 10.0 ** np.floor(np.log10(largest))
    scale = float(max(n * power for n in (1, 2, 5) if n * power <= largest))
    for i, (short, long), (x, y) in zip(registered, scale * lengths, vectors[:, :, 1], strict=True):
        if long > 0:
            angle, center = np.degrees(np.arctan2(y, x)), result.poses[i, :2, 3]
            axes.add_patch(_matplotlib("patches").Ellipse(center, long, short, angle=angle, fill=False, color=STATION))
    return scale


def _write_name(axes: Any, name: str, position: NDArray[np.float64], color: str, up: int) -> None:
    outline = [_matplotlib("patheffects").withStroke(linewidth=2, foreground="white")]
    text = axes.annotate(
        name, position[:2], xytext=(7, up), textcoords="offset points", color=color, path_effects=outline
    )
    text.set_parse_math(False)


def _check_size(size: Any) -> tuple[int, int]:
    try:
        width, height = size
    except (TypeError, ValueError):
        raise ValueError(f"size: expected width and height [px], got {shown(size)}") from None
    width = check_count("size: width", width, minimum=MIN_SIZE[0], maximum=MAX_SIZE)
    return width, check_count("size: height", height, minimum=MIN_SIZE[1], maximum=MAX_SIZE)
