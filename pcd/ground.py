"""The ground of airborne and terrestrial scans."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..core.checks import check_finite, check_positive, check_shape
from ..core.units import METRE, is_same, warn_of_units
from ..kernels.array_types import Points
from ..kernels.arrays.bounds import bound_points
from ..kernels.lang import uint8
from ..kernels.memory import zeros
from ..kernels.segmentation.ground import HeightGrid
from ..kernels.terrain.cells import FixedCells, check_cell_numbers
from ..kernels.terrain.ground_in_reach import NearGround, window_over
from .cloud import PointCloud
from .point_arrays import check_cloud

MOST_CELLS = 2**28  # 7 GB of grids
MOST_RADIUS = 512  # cells: as many windows, and some 80,000 reads a cell for all of them


CELL, WINDOW, THRESHOLD, SCALING = 1.0, 18.0, 0.5, 1.25  # [m] the paper's


def classify_ground(
    cloud: PointCloud,
    cell_size: float = CELL,
    slope: float = 0.15,
    max_window: float = WINDOW,
    elevation_threshold: float = THRESHOLD,
    scaling: float = SCALING,
    *,
    corner: ArrayLike | None = None,
) -> NDArray[np.bool_]:
    """Tell the ground from what stands on it, in a scan whose z axis points up.

    The lowest points on a grid are opened by windows of growing radius; what an opening cuts off by more than the
    terrain's slope explains is an object, and the bare earth is interpolated under it. Points near the bare earth are
    ground. The defaults are the paper's single set for all landscapes; docs/ground.md has their errors on real tiles.

    Args:
        cloud: The scan.
        cell_size: Edge of the grid's cells [m], about the distance between points.
        slope: Steepest slope of the terrain, as rise over run: what is steeper is an object.
        max_window: Radius [m] of the largest window, more than half the width of the largest building; up to 512 cells.
        elevation_threshold: Distance [m] from the bare earth that is still ground.
        scaling: Further distance [m] a unit of slope there.
        corner: A corner of the grid's cells, x and y, fixed in space. A point's answer then depends on nothing beyond
            `ground_reach` of it, whatever else the cloud holds: parts of a survey, each with as much around it, give
            the answer of the whole. None starts at the cloud's own corner.

    Returns:
        Booleans of shape [n], for `select_by_mask`; False for points that are not finite.

    Raises:
        TypeError: No PointCloud.
        ValueError: An argument out of range, or a grid of more than 2^28 cells, as one stray point far away makes.

    Warns:
        UnitWarning: The cloud is in another unit than metres, and a length is the default, which is metres.

    Notes:
        Pingel, Clarke and McBride, ISPRS Journal 77, 2013 (SMRF), with octagons for disks. 28 B of memory a cell; the
        same bits from run to run. There are `max_window / cell_size` windows. With a `corner` gaps and what was cut
        away are filled from nearby: where no ground is for some two windows, nothing is ground; windows pass over cells
        without a height, and the ground goes on beyond the outermost points. docs/terrain.md has what that changes.

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
    steepest = check_positive("slope", slope, allow_zero=True)
    window = check_positive("max_window", max_window)
    threshold = check_positive("elevation_threshold", elevation_threshold, allow_zero=True)
    share = check_positive("scaling", scaling, allow_zero=True)
    fixed = None if corner is None else check_finite("corner", check_shape("corner", corner, (2,)))
    _warn_of_defaults(cloud, cell == CELL or window == WINDOW or threshold == THRESHOLD or share == SCALING)
    points = cloud._device_array("points")
    low, high, finite = bound_points(points)
    if not finite:
        return cloud._handed_out(zeros(len(cloud), uint8, cloud.device), dtype=bool)
    if fixed is not None:
        near = _near_ground(points, (low, high), fixed - cloud.origin[:2], cell, window)
        return cloud._handed_out(near.mask(steepest, threshold, share), dtype=bool)
    lowest = low.astype(np.float64)
    with np.errstate(over="ignore"):  # more cells than float64 holds are too many, too
        counts = np.floor((high.astype(np.float64) - lowest) / cell)[:2] + 1
    _check_cells(cell, counts)
    window = min(window, cell * float(counts.max()))
    check_window(window, cell)
    grid = HeightGrid(points, lowest, cell, int(counts[0]), int(counts[1]))
    grid.uncover(steepest, window)
    return cloud._handed_out(grid.near(threshold, share), dtype=bool)


def _near_ground(points: Points, box: tuple[Any, Any], corner: Any, cell: float, window: float) -> NearGround:
    check_window(window, cell)
    radius = math.ceil(window / cell)
    with np.errstate(over="ignore"):
        low, high = (np.floor((end.astype(np.float64)[:2] - corner) / cell) for end in box)
        first, shape = window_over(low, high, radius)
    _check_cells(cell, shape)
    check_cell_numbers(first, shape)
    return NearGround(points, FixedCells(corner, cell, first, shape), radius)


def _check_cells(cell: float, counts: NDArray[np.float64]) -> None:
    if not counts.prod() <= MOST_CELLS:
        raise ValueError(
            f"cell_size: {cell} m makes a grid of {counts[0]:,.0f} x {counts[1]:,.0f} cells, more than 2^28; "
            "take larger cells, or crop stray points away"
        )


def check_window(window: float, cell: float) -> None:
    """Refuse a window of too many cells.

    Raises:
        ValueError: More than 512.
    """
    if window > MOST_RADIUS * cell:
        raise ValueError(
            f"max_window: {window:g} m are more than {MOST_RADIUS} cells of {cell} m; take larger cells or a smaller "
            "window"
        )


def _warn_of_defaults(cloud: PointCloud, has_default: bool) -> None:
    if has_default and not is_same(cloud.unit, METRE):
        remedy = 'give all four lengths in its unit, or cloud.to_unit("metre")'
        warn_of_units(f"cloud: is in {cloud.unit}, and the default lengths are metres: {remedy}")
