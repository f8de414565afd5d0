"""Profiles along a polyline: heights of a raster, or the points of a cloud near it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..core.checks import check_finite, check_numeric, check_positive, shown
from ..core.exchange import asnumpy
from ..core.other_geometry import conversion_of
from .cloud import PointCloud
from .raster import Raster

Rows = NDArray[np.float64]
MAX_SAMPLES = 2**24  # of a raster: 0.7 GB


@dataclass(frozen=True, eq=False)
class Profile:
    """Positions along a polyline, in the order of their distances, by `loom.profile`.

    Attributes:
        distances: Distance along the line in plan [m], float64 (n,).
        points: Positions, float64 (n, 3). The height is NaN if the raster has none there.
        offsets: Distance from the line in plan [m], positive to its left, float64 (n,). 0 for rasters.
        indices: Indices of the cloud's points, int64 (n,). None for rasters.
    """

    distances: Rows
    points: Rows
    offsets: Rows
    indices: NDArray[np.int64] | None = None

    @property
    def heights(self) -> Rows:
        """z of the positions [m], float64 (n,)."""
        return self.points[:, 2]


def profile(
    surface: PointCloud | Raster, line: ArrayLike, width: float | None = None, *, spacing: float | None = None
) -> Profile:
    """Heights along a polyline: of a raster at equal distances, or of the points of a cloud near the line.

    Heights of a raster are bilinear between the four cell centers around a position. Points of a cloud belong to the
    nearest segment. Float64 on the CPU.

    Args:
        surface: A raster or a cloud.
        line: Vertices of the polyline, x and y, shape (m, 2).
        width: Width of the strip around the line for clouds [m]. Points beyond its ends are not in it.
        spacing: Distance of the positions for rasters [m]. The last one is the end of the line. If None: a cell.

    Raises:
        TypeError: If `surface` is neither a raster nor a cloud, or the line is not numeric.
        ValueError: If the line has fewer than two different vertices, a length is not positive or missing, or there are
            more than 2^24 positions.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> x, y = np.mgrid[0:20, 0:10].reshape(2, -1) + 0.5
        >>> cloud = loom.PointCloud(np.column_stack([x, y, 0.1 * x]))
        >>> loom.profile(loom.rasterize(cloud, 1.0, "lowest"), [[2, 5], [8, 5]], spacing=2).heights.round(3).tolist()
        [0.2, 0.4, 0.6, 0.8]
        >>> loom.profile(cloud, [[2, 5], [8, 5]], width=0.5).distances.tolist()
        []
        >>> loom.profile(cloud, [[2, 5], [5, 5]], width=1.0).distances.tolist()
        [0.5, 0.5, 1.5, 1.5, 2.5, 2.5]
    """
    if not isinstance(surface, PointCloud | Raster):
        remedy = conversion_of(surface, expected="cloud")
        raise TypeError(f"surface: expected a PointCloud or Raster, got {type(surface).__name__}{remedy}")
    starts, steps, lengths = _segments(line)
    if isinstance(surface, PointCloud):
        if width is None:
            raise ValueError("width: expected the width of the strip for a cloud, got None")
        if spacing is not None:
            raise ValueError(f"spacing: expected None for a cloud, got {shown(spacing)}. It is for rasters")
        return _near_line(asnumpy(surface.points), starts, steps, lengths, check_positive("width", width) / 2)
    if width is not None:
        raise ValueError(f"width: expected None for a raster, got {shown(width)}. It is for clouds")
    gap = surface.cell if spacing is None else check_positive("spacing", spacing)
    total = float(lengths.sum())
    if not total / gap < MAX_SAMPLES:
        raise ValueError(f"spacing: {gap:g} gives more than 2^24 positions along {total:g}. Use a larger one")
    count = int(np.ceil(total / gap * (1 - 1e-12)))  # rounding adds no position next to the end
    distances = np.append(np.arange(count) * gap, total)
    begins = np.concatenate([[0.0], np.cumsum(lengths)])
    segment = np.clip(np.searchsorted(begins, distances, side="right") - 1, 0, len(lengths) - 1)
    xy = starts[segment] + steps[segment] * ((distances - begins[segment]) / lengths[segment])[:, None]
    points = np.column_stack([xy, _bilinear(surface, xy)])
    return Profile(distances, points, np.zeros(len(points)))


def _segments(line: ArrayLike) -> tuple[Rows, Rows, Rows]:
    """Start, step and length of each segment of positive length."""
    vertices = check_numeric("line", line)
    if vertices.ndim != 2 or vertices.shape[1] != 2 or len(vertices) < 2:
        raise ValueError(f"line: expected two or more vertices, shape (m, 2), got shape {vertices.shape}")
    vertices = check_finite("line", vertices).astype(np.float64)
    steps = np.diff(vertices, axis=0)
    lengths = np.hypot(*steps.T)
    is_long = lengths > 0
    if not is_long.any():
        raise ValueError(f"line: expected two different vertices, got {shown(vertices.tolist())}")
    return vertices[:-1][is_long], steps[is_long], lengths[is_long]


def _bilinear(raster: Raster, xy: Rows) -> Rows:
    """Heights between cell centers. NaN outside of them, or if a cell with a weight is empty."""
    heights = raster.values[::-1]
    rows, columns = heights.shape
    column, row = ((xy - raster.corner) / raster.cell - 0.5).T
    total = np.zeros(len(xy))
    for right in (0, 1):
        for up in (0, 1):
            x, y = np.floor(column) + right, np.floor(row) + up
            weight = np.abs(1 - right - (column - np.floor(column))) * np.abs(1 - up - (row - np.floor(row)))
            inside = (x >= 0) & (y >= 0) & (x < columns) & (y < rows)
            values = np.full(len(xy), np.nan)
            values[inside] = heights[y[inside].astype(int), x[inside].astype(int)]
            total += np.where(weight > 0, weight * values, 0.0)
    return total


def _near_line(points: Rows, starts: Rows, steps: Rows, lengths: Rows, radius: float) -> Profile:
    best, distances, offsets = (np.full(len(points), value) for value in (np.inf, np.nan, np.nan))
    begin, last = 0.0, len(lengths) - 1
    for number, (start, step, length) in enumerate(zip(starts, steps, lengths.tolist(), strict=True)):
        low, high = np.minimum(start, start + step) - radius, np.maximum(start, start + step) + radius
        rows = np.flatnonzero(((points[:, :2] >= low) & (points[:, :2] <= high)).all(axis=1))
        direction, away = step / length, points[rows, :2] - start
        along = away[:, 0] * direction[0] + away[:, 1] * direction[1]
        side = direction[0] * away[:, 1] - direction[1] * away[:, 0]
        nearest = np.clip(along, 0.0, length)
        inside = ((along >= 0) | (number > 0)) & ((along <= length) | (number < last))
        separation = np.where(inside, np.hypot(along - nearest, side), np.inf)
        nearer = (separation <= radius) & (separation < best[rows]) & np.isfinite(points[rows, 2])
        rows = rows[nearer]
        best[rows], distances[rows] = separation[nearer], begin + nearest[nearer]
        offsets[rows] = np.copysign(separation[nearer], side[nearer])
        begin += length
    chosen = np.flatnonzero(np.isfinite(best))
    chosen = chosen[np.argsort(distances[chosen], kind="stable")]
    return Profile(distances[chosen], points[chosen], offsets[chosen], chosen)
