"""Ground classification of airborne and terrestrial scans."""

from __future__ import annotations

import math
import warnings
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..core.checks import check_finite, check_positive, check_shape
from ..core.units import METRE, is_same, warn_of_units
from ..core.wording import format_fraction
from ..kernels.array_types import Mask, Points
from ..kernels.arrays.bounds import bound_points
from ..kernels.lang import uint8
from ..kernels.memory import zeros
from ..kernels.segmentation.ground import HeightGrid, compare_masks
from ..kernels.terrain.cells import FixedCells, check_cell_numbers
from ..kernels.terrain.ground_in_reach import NearGround, window_over
from .cloud import PointCloud
from .point_arrays import check_cloud

MAX_CELLS = 2**28  # 7 GB of grids
MAX_RADIUS = 512  # cells: number of windows, about 80,000 reads per cell in total


# Terrain that may be steeper than `slope`: many of the other points are ground at a steeper slope. They are at most
# 0.35 of them on nine ISPRS tiles. With a margin, they are at least 0.46 in 19 of 24 synthetic quarries, and the other
# 5 lost at most 3.3 % of the ground (2026-11-29). Low wide roofs and bridges have as many, so only a warning is given.
TERRAIN_SLOPE, STEEP_SLOPE = 0.15, 0.45
MAX_CHANGED = 0.42  # of the other points
MIN_CHANGED = 0.03  # of all points: the mean type I error of the tiles
STEEP_MARGIN = 0.5  # windows of extrapolated terrain around steep one: 0.5, 1 and 2 have equal errors in 6 quarries

IF_TERRAIN = f"Pass slope={STEEP_SLOPE:g} if they are terrain"

CELL_SIZE, MAX_WINDOW, HEIGHT_THRESHOLD, SLOPE_SCALING = 1.0, 18.0, 0.5, 1.25  # [m] values of the paper


class SlopeWarning(UserWarning):
    """Terrain may be steeper than the slope of the ground filter."""


def classify_ground(
    cloud: PointCloud,
    cell_size: float = CELL_SIZE,
    slope: float | None = TERRAIN_SLOPE,
    max_window: float = MAX_WINDOW,
    elevation_threshold: float = HEIGHT_THRESHOLD,
    scaling: float = SLOPE_SCALING,
    *,
    corner: ArrayLike | None = None,
) -> NDArray[np.bool_]:
    """Classify ground points of a scan with z up (SMRF).

    The lowest points on a grid are opened with growing windows. Drops beyond the terrain's slope are objects. Points
    near the interpolated bare earth are ground. The defaults are the paper's; docs/terrain.md has their errors on real
    tiles. 28 B per cell. Bitwise reproducible. Pingel, Clarke and McBride, "An improved simple morphological filter for
    the terrain classification of airborne LIDAR data", ISPRS 2013, with octagons instead of disks.

    Args:
        cloud: The scan.
        cell_size: Edge of the grid's cells [m], about the point spacing.
        slope: Maximum slope of the terrain, as rise over run. None, for quarries and terraces without wide low roofs:
            0.15. Without a corner, 0.45 if more than 42% of the other points are then ground, with terrain extrapolated
            beyond the border.
        max_window: Radius of the largest window [m], more than half the width of the largest building. Up to 512 cells.
        elevation_threshold: Maximum distance of ground points from the bare earth [m].
        scaling: Additional distance per unit of slope [m].
        corner: Fixed corner of the grid, x and y. Results then depend only on points within `ground_reach`, so parts of
            a survey give the result of the complete one. See docs/terrain.md. If None: the cloud's corner.

    Returns:
        Booleans of shape (n,), for `select_by_mask`. False for points that are not finite.

    Raises:
        TypeError: If `cloud` is not a PointCloud.
        ValueError: If an argument is out of range, or the grid has more than 2^28 cells.

    Warns:
        UnitWarning: If the cloud is not in meters, and a length is the default in meters.
        UserWarning: If more than 42% of the points that are not ground are ground with a slope of 0.45: steep terrain,
            or wide low roofs and bridges.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> rng = np.random.default_rng(0)
        >>> x, y = rng.uniform(0, 60, (2, 20000))
        >>> house = (abs(x - 30) < 6) & (abs(y - 20) < 8)
        >>> cloud = loom.PointCloud(np.column_stack([x, y, 0.05 * x + np.where(house, 5.0, 0.0)]))
        >>> ground = loom.classify_ground(cloud)
        >>> ground.shape, bool((ground == ~house).all())
        ((20000,), True)
    """
    check_cloud("cloud", cloud)
    cell = check_positive("cell_size", cell_size)
    steepest = TERRAIN_SLOPE if slope is None else check_positive("slope", slope, allow_zero=True)
    window = check_positive("max_window", max_window)
    threshold = check_positive("elevation_threshold", elevation_threshold, allow_zero=True)
    fraction = check_positive("scaling", scaling, allow_zero=True)
    fixed = None if corner is None else check_finite("corner", check_shape("corner", corner, (2,)))
    _warn_of_defaults(
        cloud, cell == CELL_SIZE or window == MAX_WINDOW or threshold == HEIGHT_THRESHOLD or fraction == SLOPE_SCALING
    )
    slopes = [steepest, STEEP_SLOPE] if 0 < steepest < STEEP_SLOPE else [steepest]
    points = cloud.arrays["points"]
    low, high, finite = bound_points(points)
    if not finite:
        return cloud.arrays.hand_out(zeros(len(cloud), uint8, cloud.device), dtype=bool)
    if fixed is not None:
        near = _near_ground(points, (low, high), fixed - cloud.origin[:2], cell, window)
        masks = near.masks(slopes, threshold, fraction)
        _warn_if_steep(_changed_fraction(points, masks), steepest, IF_TERRAIN)
        return cloud.arrays.hand_out(masks[0], dtype=bool)
    lowest = low.astype(np.float64)
    with np.errstate(over="ignore"):  # overflow means too many cells
        counts = np.floor((high.astype(np.float64) - lowest) / cell)[:2] + 1
    window = min(window, cell * float(counts.max()))

    def find(slopes: Sequence[float], margin: int) -> list[Mask]:
        _check_cells(cell, counts + 2 * margin)
        check_window(window, cell)
        columns, rows = (int(count) + 2 * margin for count in counts)
        grid = HeightGrid(points, lowest - [margin * cell, margin * cell, 0], cell, columns, rows)
        return [grid.near(ground, threshold, fraction) for ground in grid.uncover(slopes, window)]

    masks = find(slopes, 0)
    steep, remedy = _changed_fraction(points, masks), IF_TERRAIN
    if slope is None and steep > MAX_CHANGED / 2:  # terrain that rises to the border needs the margin, too
        masks[1:] = find([STEEP_SLOPE], math.ceil(STEEP_MARGIN * window / cell))
        steep = _changed_fraction(points, masks)
        masks = masks[steep > MAX_CHANGED :]
        remedy = f"slope={STEEP_SLOPE:g} was used. Pass slope={TERRAIN_SLOPE:g} if they are objects"
    _warn_if_steep(steep, steepest, remedy)
    return cloud.arrays.hand_out(masks[0], dtype=bool)


def _changed_fraction(points: Points, masks: Sequence[Mask]) -> float:
    """Fraction of the points outside the first mask that the second mask accepts. 0 if they are few."""
    if len(masks) < 2:
        return 0.0
    objects, changed = compare_masks(points, *masks)  # sync
    return changed / objects if changed > MIN_CHANGED * points.size else 0.0


def _warn_if_steep(steep: float, slope: float, remedy: str) -> None:
    if steep <= MAX_CHANGED:
        return
    warnings.warn(
        f"{format_fraction(steep)} of the points that are not ground with slope={slope:g} are ground with slope="
        f"{STEEP_SLOPE:g}: steeper slopes, terraces, or low wide objects such as roofs and bridges. {remedy}",
        SlopeWarning,
        stacklevel=3,
    )


def _near_ground(
    points: Points, box: tuple[Any, Any], corner: NDArray[np.float64], cell: float, window: float
) -> NearGround:
    check_window(window, cell)
    radius = max(1, math.ceil(window / cell))  # the quotient may underflow
    with np.errstate(over="ignore"):
        low, high = (np.floor((end.astype(np.float64)[:2] - corner) / cell) for end in box)
        first, shape = window_over(low, high, radius)
    _check_cells(cell, shape)
    check_cell_numbers(first, shape)
    return NearGround(points, FixedCells(corner, cell, first, shape), radius)


def _check_cells(cell: float, counts: NDArray[np.float64]) -> None:
    if not counts.prod() <= MAX_CELLS:
        raise ValueError(
            f"cell_size: {cell} m gives a grid of {counts[0]:,.0f} x {counts[1]:,.0f} cells, more than 2^28; "
            "use a larger cell_size, or crop outliers"
        )


def check_window(window: float, cell: float) -> None:
    if window > MAX_RADIUS * cell:
        raise ValueError(
            f"max_window: expected at most {MAX_RADIUS} cells of {cell} m, got {window:g} m. Use larger cells or a "
            "smaller window"
        )


def _warn_of_defaults(cloud: PointCloud, has_default: bool) -> None:
    if has_default and not is_same(cloud.unit, METRE):
        remedy = 'Pass all four lengths in its unit, or convert with cloud.to_unit("metre")'
        warn_of_units(f"cloud: expected meters, the unit of the default lengths, got {cloud.unit}. {remedy}")
