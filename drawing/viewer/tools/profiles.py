"""The height of points along a line over the ground: numbers, a plot, a table."""

from __future__ import annotations

import dataclasses
import io
import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ....core.checks import check_finite, check_positive, check_rows
from ....core.units import LengthUnit
from ...render.plots import new_figure, to_picture
from .areas import check_length, quantity_text

BINS = 200  # of the line along the middle of the heights
MOST_DRAWN = 200_000  # points of a plot: of more an even share, since they lie over each other
_DOT = "#5c87b5"
_LINE = (0.75, 0.2, 0.1)


@dataclasses.dataclass(frozen=True, eq=False)
class Profile:
    """Points near a line over the ground, by the way along it.

    Attributes:
        distances: Along the line, seen from above, ascending, float64 [k].
        heights: float64 [k].
        offsets: From the line, to its left above zero, float64 [k].
        rows: Which points they are, int64 [k].
        corners: Where the line's corners lie along it, float64 [m], from 0 to its length.
        width: Of the strip in which points count.
    """

    distances: NDArray[np.float64]
    heights: NDArray[np.float64]
    offsets: NDArray[np.float64]
    rows: NDArray[np.int64]
    corners: NDArray[np.float64]
    width: float


def profile_along(points: Any, path: Any, *, width: float) -> Profile:
    """The points within a strip along a line, seen from above.

    A point counts where it is at most half the width from the line, and lies beside it, not beyond one of its two ends;
    near a corner by the nearer side.

    Args:
        points: Shape [n, 3]; those that are not finite do not count.
        path: The line's corners, shape [m, 3], at least two; their heights have no bearing.
        width: Of the strip, in the unit of the points.

    Raises:
        ValueError: Fewer than two corners, or all one above the other; no width.

    Notes:
        Each side looks at the points in its own box. Memory: 40 B a point. NumPy on one core: ten million points and a
        line of five sides take 3 s of it.

    Example:
        >>> found = profile_along([[0, 0, 5], [1, 0.2, 6], [3, 9, 7]], [[0, 0, 0], [4, 0, 0]], width=1)
        >>> found.distances.tolist(), found.heights.tolist(), found.offsets.tolist()
        ([0.0, 1.0], [5.0, 6.0], [0.0, 0.2])
    """
    rows = check_rows("points", points, 3, dtype=np.float64)
    corners = check_finite("path", check_rows("path", path, 3, dtype=np.float64))[:, :2]
    reach = check_positive("width", width) / 2
    if len(corners) < 2:
        raise ValueError(f"path: expected at least two corners, got {len(corners)}; click on more")
    lengths = np.linalg.norm(np.diff(corners, axis=0), axis=1)
    ends = np.concatenate([[0.0], np.cumsum(lengths)])
    if not ends[-1] > 0:
        raise ValueError("path: its corners lie one above the other, so it has no length seen from above")
    nearest = np.full(len(rows), np.inf)
    along, beside = np.zeros(len(rows)), np.zeros(len(rows))
    for k in np.flatnonzero(lengths > 0).tolist():
        _take_side(rows, corners, k, lengths, ends, reach, nearest, along, beside)
    found = np.flatnonzero(nearest <= reach)
    found = found[np.argsort(along[found], kind="stable")]
    return Profile(along[found], rows[found, 2], beside[found], found, ends, 2 * reach)


def _take_side(
    rows: NDArray[np.float64],
    corners: NDArray[np.float64],
    k: int,
    lengths: NDArray[np.float64],
    ends: NDArray[np.float64],
    reach: float,
    nearest: NDArray[np.float64],
    along: NDArray[np.float64],
    beside: NDArray[np.float64],
) -> None:
    """Give points near a side their place along it, unless another side is nearer."""
    a, b, length = corners[k], corners[k + 1], float(lengths[k])
    low, high = np.minimum(a, b) - reach, np.maximum(a, b) + reach
    with np.errstate(invalid="ignore"):
        near = np.flatnonzero(((rows[:, :2] >= low) & (rows[:, :2] <= high)).all(axis=1) & np.isfinite(rows[:, 2]))
    local, (x, y) = rows[near, :2] - a, (b - a) / length
    forward, left = local[:, 0] * x + local[:, 1] * y, local[:, 1] * x - local[:, 0] * y
    # before the first corner and behind the last there is no line; at the others the next side takes over
    first, last = (0.0 if k == 0 else -math.inf), (length if k == len(lengths) - 1 else math.inf)
    is_beside = (forward >= first) & (forward <= last)
    place = np.clip(forward, 0.0, length)
    distance = np.hypot(forward - place, left)
    better = is_beside & (distance < nearest[near])
    nearest[near[better]] = distance[better]
    along[near[better]] = ends[k] + place[better]
    beside[near[better]] = np.copysign(distance, left)[better]


def middle_line(profile: Profile) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The median height of the points in each of 200 parts of the way; NaN of parts without points."""
    ends = np.linspace(0.0, float(profile.corners[-1]), BINS + 1)
    cuts = np.searchsorted(profile.distances, ends)
    cuts[-1] = len(profile.distances)
    pairs = zip(cuts[:-1].tolist(), cuts[1:].tolist(), strict=True)
    medians = [float(np.median(profile.heights[a:b])) if b > a else math.nan for a, b in pairs]
    return (ends[:-1] + ends[1:]) / 2, np.array(medians)


def profile_rows(profile: Profile, unit: LengthUnit | None) -> list[tuple[str, str]]:
    """What is known of a profile, as labels and values; what is not known is said.

    Raises:
        ValueError: In degrees of longitude and latitude.
    """
    check_length(unit)
    length = float(profile.corners[-1])
    rows = [("length", f"{quantity_text(length, unit)}, from above")]
    rows += [("points", f"{len(profile.rows):,} in a strip of {quantity_text(profile.width, unit)}")]
    if not len(profile.rows):
        return [*rows, ("heights", "none: no point lies in the strip")]
    _, medians = middle_line(profile)
    known = medians[np.isfinite(medians)]
    low, high = int(profile.heights.argmin()), int(profile.heights.argmax())
    for name, at in (("lowest", low), ("highest", high)):
        place = quantity_text(float(profile.distances[at]), unit)
        rows.append((name, f"{quantity_text(float(profile.heights[at]), unit)} at {place}"))
    rows += [("from end to end", quantity_text(float(known[-1] - known[0]), unit))]
    missing = 1 - len(known) / BINS
    if missing > 0:
        rows.append(("without points", f"{100 * missing:.1f} % of the way"))
    return rows


def profile_picture(
    profile: Profile, unit: LengthUnit | None, *, colors: Any = None, size: tuple[int, int] = (900, 420)
) -> NDArray[np.uint8]:
    """Heights against the way along the line: the points, and the median of 200 parts.

    Args:
        profile: The points.
        unit: Of their coordinates.
        colors: Of the profile's points, uint8 [k, 3]; None for one.
        size: Width and height [px].

    Returns:
        Shape [h, w, 3], uint8.
    """
    symbol = "units" if unit is None else unit.symbol
    figure = new_figure(*size)
    axes = figure.subplots()
    step = max(1, -(-len(profile.rows) // MOST_DRAWN))
    shown = _DOT if colors is None else np.asarray(colors, np.uint8)[::step] / 255
    axes.scatter(profile.distances[::step], profile.heights[::step], s=2, c=shown)
    for corner in profile.corners[1:-1].tolist():
        axes.axvline(corner, color="0.7", linewidth=1)
    axes.plot(*middle_line(profile), color=_LINE, label="median height")
    axes.legend()
    axes.set(xlabel=f"along the line [{symbol}]", ylabel=f"height [{symbol}]")
    axes.set(xlim=(0.0, float(profile.corners[-1])), title=f"height profile, {len(profile.rows):,} points")
    axes.grid(alpha=0.3)
    return to_picture(figure)


def profile_csv(profile: Profile, points: Any, indices: Any = None) -> bytes:
    """A table of the profile's points: distance, height, offset, x, y, z and, where given, their indices.

    Args:
        profile: The points.
        points: The array that it was made of, shape [n, 3].
        indices: Their numbers in a cloud, shape [n].
    """
    rows = np.asarray(points, np.float64)[profile.rows]
    columns = [profile.distances, profile.heights, profile.offsets, *rows.T]
    names, formats = "distance,height,offset,x,y,z", ["%.6f"] * 6
    if indices is not None:
        columns.append(np.asarray(indices, np.float64)[profile.rows])
        names, formats = f"{names},index", [*formats, "%d"]
    text = io.StringIO()
    np.savetxt(text, np.column_stack(columns), formats, delimiter=",", header=names, comments="")
    return text.getvalue().encode()
