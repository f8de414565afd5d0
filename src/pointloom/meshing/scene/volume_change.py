"""Cut and fill between two epochs: `loom.volume_change`."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import LARGEST_NUMBER, check_finite, check_positive, check_shape
from ...core.coordinate_systems import check_crs, common_crs
from ...core.matched_counts import why_few_matched
from ...core.reports import Assessed, Fields, Report, failed, with_warnings
from ...core.units import LengthUnit, symbol_of
from ...kernels.lang import float64
from ...kernels.memory import download, upload
from ...kernels.terrain.cells import CELL_COUNT, CELL_MEAN, CellGroups, heights_of
from ...pcd.change import MIN_POINTS
from ...pcd.cloud import PointCloud
from ...pcd.raster import Raster, common_cells
from ...pcd.raster_cells import GROUND_CLASSES, check_classes, check_lengths, chosen_points, window_of
from ..mesh.mesh import TriangleMesh
from .orthophoto import orthophoto

Surface = PointCloud | TriangleMesh | Raster
Grid = NDArray[np.float64]
CONFIDENCE_95 = 1.96  # quantile of the normal distribution for 95 % of both sides, as in M3C2
# [cells] width of the gaps that are interpolated by default. With 4 points per cell, the least for a spread, 1.8 % of
# the cells are empty, and 1e-7 of all blocks of 2 x 2 cells (Poisson distribution).
GAP_CELLS = 4.0


@dataclass(frozen=True, eq=False)
class VolumeChange(Report, Assessed):
    """Volumes between two epochs, by `loom.volume_change`. Uncertainties are half widths of 95% intervals.

    Attributes:
        cut: Volume that was removed, over all compared cells [m^3].
        fill: Volume that was added.
        net: `fill` minus `cut`. Random errors cancel in it, but add up in `cut` and `fill`.
        cut_uncertainty, fill_uncertainty, net_uncertainty: From the spread in the cells and the registration error. NaN
            if neither is known.
        significant_cut, significant_fill: Sums over the cells whose change exceeds the level of detection. NaN if that
            is unknown.
        area: Area of the compared cells [m^2].
        interpolated_area: Part of it with a height interpolated in a gap, in one epoch at least.
        missing_area: Area of cells with a height in one epoch only.
        difference: Raster of the height of the later epoch minus that of the earlier one.
        level_of_detection: Significant change of each cell at 95% confidence, float64 (rows, columns).
        unit: Unit of length, or None.
    """

    cut: float
    fill: float
    net: float
    cut_uncertainty: float
    fill_uncertainty: float
    net_uncertainty: float
    significant_cut: float
    significant_fill: float
    area: float
    interpolated_area: float
    missing_area: float
    difference: Raster
    level_of_detection: Grid
    unit: LengthUnit | None = None

    @property
    def warnings(self) -> tuple[str, ...]:
        """Failed quality checks. Empty if the result is reliable."""
        cell_area = self.difference.cell**2
        compared, missing = round(self.area / cell_area), round(self.missing_area / cell_area)
        remedy = "use larger cells or a larger max_gap, and the same area for both epochs"
        return failed(why_few_matched(compared, compared + missing, "cells have a height in both epochs", remedy))

    def fields(self) -> Fields:
        unit = symbol_of(self.unit)

        def text(volume: float, uncertainty: float) -> str:
            known = f" +- {uncertainty:,.2f}" if math.isfinite(uncertainty) else ", uncertainty unknown"
            return f"{volume:,.2f}{known} {unit}^3"

        return with_warnings(
            [
                ("cut", text(self.cut, self.cut_uncertainty)),
                ("fill", text(self.fill, self.fill_uncertainty)),
                ("net", text(self.net, self.net_uncertainty)),
                ("significant cut, fill", f"{self.significant_cut:,.2f}, {self.significant_fill:,.2f} {unit}^3"),
                ("compared area", f"{self.area:,.2f} {unit}^2, {self.interpolated_area:,.2f} of it interpolated"),
                ("missing area", f"{self.missing_area:,.2f} {unit}^2"),
            ],
            self,
        )

    def to_dict(self) -> dict[str, Any]:
        """All figures in JSON types, with `reliable` and `warnings`, without the cells."""
        figures = super().to_dict()
        return {name: value for name, value in figures.items() if name not in ("difference", "level_of_detection")}


@dataclass(frozen=True, eq=False)
class _Heights:
    """Heights of an epoch. `variance` is that of a cell's mean height, None for a raster or mesh."""

    raster: Raster
    variance: Grid | None


def volume_change(
    before: Surface,
    after: Surface,
    cell: float | None = None,
    *,
    registration_error: float = 0.0,
    classes: int | Iterable[int] | None = None,
    max_gap: float | None = None,
    corner: ArrayLike | None = None,
) -> VolumeChange:
    """Volumes of cut and fill between two epochs along z, with their uncertainty.

    Heights are compared on a grid of square cells. A cell of a cloud has the mean height of its points, with the
    variance s^2 / n of that mean. A cell of a mesh has the height of its highest surface at the center. The level of
    detection is that of `m3c2`. Spreads are independent between cells, but the registration error is common to all of
    them, so it is multiplied by the area. Lane, Westaway and Hicks, "Estimation of erosion and deposition volumes in a
    large, gravel-bed, braided river using synoptic remote sensing", 2003. Wheaton et al., "Accounting for uncertainty
    in DEMs from repeat topographic surveys", 2010.

    Args:
        before, after: The earlier and the later epoch, z up: clouds, meshes or rasters.
        cell: Edge of a cell [m], for 4 or more points each. If None: that of a raster.
        registration_error: Standard deviation of the height offset between the epochs [m], measured on stable ground.
        classes: LAS classes of clouds that count. If None: ground (2) if a cloud has such points, otherwise all but
            noise (7 and 18).
        max_gap: Maximum width of gaps of clouds that are interpolated [m], from cells on opposite sides. If None: 4
            cells.
        corner: A corner of cells, x and y. If None: that of a raster, otherwise (0, 0).

    Raises:
        TypeError: If an epoch is not a cloud, mesh or raster.
        ValueError: If an argument is out of range, `cell` is missing, the epochs do not overlap, only one of two clouds
            has ground points, rasters have different grids, or the coordinate systems differ.
        MemoryError: If the grid does not fit into memory.

    Warns:
        UnitWarning: If the epochs have different units.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> rng = np.random.default_rng(0)
        >>> before, after = (rng.random((50_000, 3)) * (20, 20, 0.02) for _ in range(2))
        >>> after[after[:, 0] > 15, 2] += 0.1
        >>> found = loom.volume_change(loom.PointCloud(before), loom.PointCloud(after), 0.5)
        >>> round(found.net, 1), round(found.significant_fill, 1), found.net_uncertainty < 0.1
        (10.0, 10.0, True)
    """
    for name, surface in (("before", before), ("after", after)):
        if not isinstance(surface, Surface):
            raise TypeError(f"{name}: expected a PointCloud, TriangleMesh or Raster, got {type(surface).__name__}")
    error = check_positive("registration_error", registration_error, allow_zero=True, maximum=LARGEST_NUMBER)
    common_crs("before, after", (check_crs("crs", before.crs), check_crs("crs", after.crs)))
    side, start = _grid_for(before, after, cell, corner)
    gap = GAP_CELLS * side if max_gap is None else check_positive("max_gap", max_gap, allow_zero=True)
    counted = _classes_for(before, after, classes)
    first = _heights("before", before, counted[0], side, start, gap)
    second = _heights("after", after, counted[1], side, start, gap)
    return _compare(first, second, error)


def _grid_for(before: Surface, after: Surface, cell: float | None, corner: ArrayLike | None) -> tuple[float, Grid]:
    """Cell and corner of the grid, by a raster if one is given."""
    raster = next((surface for surface in (before, after) if isinstance(surface, Raster)), None)
    side = None if cell is None else check_positive("cell", cell, maximum=LARGEST_NUMBER)
    start = None if corner is None else check_finite("corner", check_shape("corner", corner, (2,)))
    if raster is None:
        if side is None:
            raise ValueError("cell: expected the edge of a cell, got None. Pass it, for 4 or more points per cell")
        return side, np.zeros(2) if start is None else start
    if side is not None and side != raster.cell:
        raise ValueError(f"cell: expected {raster.cell!r}, that of the raster, got {side!r}. Leave it out")
    return raster.cell, raster.corner if start is None else start


def _classes_for(before: Surface, after: Surface, classes: int | Iterable[int] | None) -> list[tuple[int, ...] | None]:
    """Classes that count in each epoch. None: all but noise."""
    numbers = check_classes(classes)
    if numbers is not None:
        for name, surface in (("before", before), ("after", after)):
            if isinstance(surface, PointCloud) and "classification" not in surface:
                raise ValueError(f"classes: expected None, because {name} has no classification, got {list(numbers)}")
        return [numbers, numbers]
    has_ground = [
        isinstance(surface, PointCloud)
        and "classification" in surface
        and bool((np.asarray(surface["classification"]) == GROUND_CLASSES[0]).any())
        for surface in (before, after)
    ]
    if isinstance(before, PointCloud) and isinstance(after, PointCloud) and len(set(has_ground)) > 1:
        name = ("before", "after")[has_ground.index(False)]
        raise ValueError(
            f"{name}: expected ground points (class 2) as in the other cloud, got none. Classify both with "
            "classify_ground, or pass classes"
        )
    return [GROUND_CLASSES if is_known else None for is_known in has_ground]


def _heights(
    name: str, surface: Surface, classes: tuple[int, ...] | None, side: float, corner: Grid, gap: float
) -> _Heights:
    if isinstance(surface, Raster):
        return _Heights(surface, None)
    try:
        if isinstance(surface, TriangleMesh):
            return _Heights(orthophoto(surface, side, corner=corner).heights, None)
        return _heights_of_cloud(surface, classes, side, corner, gap)
    except ValueError as error:
        kind, separator, reason = str(error).partition(": ")
        if separator and kind in ("cloud", "mesh"):
            raise ValueError(f"{name}: {reason}") from error
        raise


def _heights_of_cloud(
    cloud: PointCloud, classes: tuple[int, ...] | None, side: float, corner: Grid, gap: float
) -> _Heights:
    """Mean heights of the points in each cell. Cells with fewer than 4 points have the pooled variance of a point."""
    check_lengths(cloud)
    points = chosen_points(cloud, classes, is_ground=classes == GROUND_CLASSES)
    window = window_of(points, corner - cloud.origin[:2], side, None, cloud.origin)
    groups, heights = CellGroups(points, window), heights_of(points)
    squared = upload(np.square(download(heights)), float64, points.device)
    count, means, squares = (
        np.asarray(download(groups.measure(values, kind))).reshape(window.columns, window.rows).T[::-1]
        for values, kind in ((heights, CELL_COUNT), (heights, CELL_MEAN), (squared, CELL_MEAN))
    )
    sums = np.maximum(squares - means**2, 0.0) * count  # of squared deviations
    spread_cells = count >= 2
    freedom = float((count[spread_cells] - 1).sum())
    pooled = float(sums[spread_cells].sum()) / freedom if freedom else np.nan
    variance = np.full(count.shape, pooled)
    enough = count >= MIN_POINTS
    variance[enough] = sums[enough] / (count[enough] - 1)
    low = corner + np.array([window.column0, window.row0]) * side
    values = (means + cloud.origin[2]).astype(np.float32)
    raster = Raster(values, low, side, np.zeros(values.shape, bool), "mean", unit=cloud.unit)
    return _Heights(_interpolated(raster, gap), variance / np.maximum(count, 1))


def _interpolated(raster: Raster, gap: float) -> Raster:
    """Interpolate gaps up to a width. Cells outside of the outline remain empty."""
    from scipy.ndimage import binary_closing  # slow import

    cells = math.ceil(min(gap / raster.cell, max(raster.values.shape)) / 2)
    known = np.isfinite(raster.values)
    if not cells or known.all():
        return raster
    square = np.ones((2 * cells + 1, 2 * cells + 1), bool)
    closed = binary_closing(np.pad(known, cells), square)[cells:-cells, cells:-cells]
    filled = raster.fill_gaps(math.sqrt(2) * (cells + 1) * raster.cell)
    outside = ~(known | closed)
    values = np.where(outside, np.float32(np.nan), filled.values)
    return dataclasses.replace(filled, values=values, filled=filled.filled & ~outside)


def _compare(before: _Heights, after: _Heights, error: float) -> VolumeChange:
    first, second = common_cells("before, after", before.raster, after.raster)
    difference = dataclasses.replace(second - first, kind="difference")
    changes = second.values.astype(np.float64) - first.values
    compared = np.isfinite(changes)
    variances = (_variance_in(first, before), _variance_in(second, after))
    variance = np.zeros(changes.shape)
    for part in variances:
        variance = variance if part is None else variance + part
    is_unknown = error == 0 and all(part is None for part in variances)
    limits = np.where(compared, CONFIDENCE_95 * (np.sqrt(variance) + error), np.nan)
    if is_unknown:
        limits = np.full(changes.shape, np.nan)
    area = difference.cell**2

    def volume(cells: NDArray[np.bool_]) -> tuple[float, float]:
        """Sum over some cells, and its uncertainty."""
        random = math.sqrt(float(variance[cells].sum())) * area
        spread = CONFIDENCE_95 * math.hypot(random, error * float(cells.sum()) * area)
        return float(changes[cells].sum()) * area, math.nan if is_unknown else spread

    with np.errstate(invalid="ignore"):
        lower, higher, exceeds = changes < 0, changes > 0, np.abs(changes) > limits
    (cut, cut_error), (fill, fill_error), (net, net_error) = volume(lower), volume(higher), volume(compared)
    in_one = np.isfinite(first.values) != np.isfinite(second.values)
    return VolumeChange(
        -cut + 0.0,
        fill,
        net,
        cut_error,
        fill_error,
        net_error,
        math.nan if is_unknown else -volume(lower & exceeds)[0] + 0.0,
        math.nan if is_unknown else volume(higher & exceeds)[0],
        float(compared.sum()) * area,
        float((compared & difference.filled).sum()) * area,
        float(in_one.sum()) * area,
        difference,
        limits,
        difference.unit,
    )


def _variance_in(part: Raster, heights: _Heights) -> Grid | None:
    """Variances of the cells of a part of a raster."""
    if heights.variance is None:
        return None
    raster = heights.raster
    columns, rows = np.round((part.corner - raster.corner) / raster.cell).astype(int)
    top = raster.values.shape[0] - rows - part.values.shape[0]
    return heights.variance[top : top + part.values.shape[0], columns : columns + part.values.shape[1]]
