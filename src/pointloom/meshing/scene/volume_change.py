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
from ...core.devices import resolve_device
from ...core.matched_counts import why_few_matched
from ...core.reports import Assessed, Fields, Report, failed, with_warnings
from ...core.units import LengthUnit, symbol_of
from ...pcd.cell_heights import CellHeights, center_heights
from ...pcd.cloud import PointCloud
from ...pcd.raster import Raster, common_cells
from ...pcd.raster_cells import (
    GROUND_CLASSES,
    MAX_CELLS,
    check_classes,
    check_grid_room,
    check_lengths,
    chosen_points,
    window_of,
)
from ..mesh.mesh import TriangleMesh
from .orthophoto import orthophoto

Surface = PointCloud | TriangleMesh | Raster
Grid = NDArray[np.float64]
CONFIDENCE = 0.95
CONFIDENCE_95 = 1.96  # quantile of the normal distribution for 95 % of both sides, as in M3C2
# [cells] width of the gaps that are interpolated by default. With 4 points per cell, the least for a spread, 1.8 % of
# the cells are empty, and 1e-7 of all blocks of 2 x 2 cells (Poisson distribution).
GAP_CELLS = 4.0
HEIGHT_BYTES = 1400  # on the host per cell of a cloud, measured with 1 and 2.25 million cells (2026-11-30)
# Fraction of significant cells next to the missing area, from which the change probably continues there. One in
# twenty is expected without change.
MIN_BORDER_CHANGE = 0.2
# Blocks along an edge for a common shift. With fewer than 9 blocks, most of them may have changed.
MAX_BLOCKS, MIN_BLOCKS = 8, 3
MIN_BLOCK_CELLS = 4  # per block, for a median and a spread
MEDIAN_ERROR = 1.25  # standard deviation of the median of normal errors, in that of the mean
# Variation of a shift over the area, as a fraction of it: more than the geoid varies over a site.
MAX_SHIFT_VARIATION = 0.02


@dataclass(frozen=True, eq=False)
class VolumeChange(Report, Assessed):
    """Volumes between two epochs, by `loom.volume_change`. Uncertainties are half widths of 95% intervals.

    Attributes:
        cut: Volume that was removed, over all compared cells [m^3].
        fill: Volume that was added.
        net: `fill` minus `cut`. Random errors cancel in it, but add up in `cut` and `fill`.
        cut_uncertainty, fill_uncertainty, net_uncertainty: From the spread in the cells, the gaps and the registration
            error. NaN if none is known.
        significant_cut, significant_fill: Sums over the cells whose change exceeds the level of detection. NaN if that
            is unknown.
        area: Area of the compared cells [m^2].
        interpolated_area: Part of it with a height interpolated in a gap, in one epoch at least.
        missing_area: Area of cells with a height in one epoch only, also outside of the other epoch.
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
    _border_change: float = 0.0  # see `_change_at_border`

    @property
    def warnings(self) -> tuple[str, ...]:
        """Failed quality checks. Empty if the result is reliable."""
        cell_area = self.difference.cell**2
        compared, missing = round(self.area / cell_area), round(self.missing_area / cell_area)
        remedy = "use larger cells or a larger max_gap, and the same area for both epochs"
        few = why_few_matched(compared, compared + missing, "cells have a height in both epochs", remedy)
        return failed(few, self._why_cut_off(), self._why_shifted())

    def _why_cut_off(self) -> str | None:
        if not self._border_change * self.missing_area > self.net_uncertainty:
            return None
        return (
            f"the cells next to the missing area changed by {self._border_change:.3g} {symbol_of(self.unit)} (mean), "
            "so the net volume lacks a part that exceeds net_uncertainty: survey the missing area, too"
        )

    def _why_shifted(self) -> str | None:
        shift = _common_shift(self.difference.values.astype(np.float64), self.level_of_detection / CONFIDENCE_95)
        if abs(shift) * self.area <= (0.0 if math.isnan(self.net_uncertainty) else self.net_uncertainty):
            return None
        return (
            f"the heights before and after differ by {shift:.3g} {symbol_of(self.unit)} in most of the compared area, "
            "and net_uncertainty does not contain it: probably different height systems or a shift of one survey, not "
            "change; register both on stable ground, and pass registration_error"
        )

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
    """Heights of an epoch. `cells` are None for a raster or mesh."""

    raster: Raster
    cells: CellHeights | None


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

    Heights are compared at the centers of square cells. A cell of a cloud has the mean height of its points, moved to
    the center along the slope and curvature of its neighbors. Gaps have the height of a quadratic surface through the
    cells around them. A cell of a mesh has the height of its highest surface at the center. The level of detection is
    that of `m3c2`.

    Errors of points are independent. Their spread about the surface is propagated through all cells that use a point,
    so the correlation of neighbors and of interpolated cells is included. Errors of the surface in a gap are estimated
    from the fit, and are correlated over two widths of gaps. The registration error is common to all cells, so it is
    multiplied by the area. The result is not reliable if most of the area has the same change, which the interval does
    not contain, or if change continues into the missing area.

    References:
        Lane, Westaway and Hicks, "Estimation of erosion and deposition volumes in a large, gravel-bed, braided river
        using synoptic remote sensing", 2003. Wheaton et al., "Accounting for uncertainty in DEMs from repeat
        topographic surveys", 2010. Rolstad, Haug and Denby, "Spatially integrated geodetic glacier mass balance and its
        uncertainty based on geostatistical analysis", 2009: sums of correlated errors.

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
        MemoryError: If the grid does not fit into memory: about 1.4 kB per cell of a cloud on the host.

    Warns:
        UnitWarning: If the epochs have different units.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> rng = np.random.default_rng(0)
        >>> before, after = (rng.random((50_000, 3)) * (20, 20, 0.02) for _ in range(2))
        >>> after[after[:, 0] > 15, 2] += 0.1
        >>> found = loom.volume_change(loom.PointCloud(before), loom.PointCloud(after), 0.5)
        >>> round(found.net, 1), round(found.significant_fill), found.net_uncertainty < 0.1
        (10.0, 10, True)
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
    check_lengths(cloud)
    points = chosen_points(cloud, classes, is_ground=classes == GROUND_CLASSES)
    window = window_of(points, corner - cloud.origin[:2], side, None, cloud.origin)
    shape = np.array([window.columns, window.rows], np.float64)
    check_grid_room(side, shape, resolve_device("cpu"), HEIGHT_BYTES)
    found = center_heights(points, window, math.ceil(min(gap / side, MAX_CELLS)))
    low = corner + np.array([window.column0, window.row0]) * side
    values = np.ascontiguousarray(_rows_of(found.values + cloud.origin[2]), np.float32)
    filled = np.ascontiguousarray(_rows_of(found.filled))
    return _Heights(Raster(values, low, side, filled, "center", unit=cloud.unit), found)


def _compare(before: _Heights, after: _Heights, error: float) -> VolumeChange:
    first, second = common_cells("before, after", before.raster, after.raster)
    difference = dataclasses.replace(second - first, kind="difference")
    changes = second.values.astype(np.float64) - first.values
    compared = np.isfinite(changes)
    known = [
        (each.cells, _window_in(part, each.raster)) for part, each in ((first, before), (second, after)) if each.cells
    ]
    is_unknown = error == 0 and not known
    variance = sum((_rows_of(cells.cell_variance())[window] for cells, window in known), np.zeros(changes.shape))
    limits = np.where(compared & ~np.bool_(is_unknown), CONFIDENCE_95 * (np.sqrt(variance) + error), np.nan)
    area = difference.cell**2

    def volume(chosen: NDArray[np.bool_]) -> tuple[float, float]:
        """Sum over some cells, and its uncertainty."""
        random = 0.0
        for cells, window in known:
            mask = np.zeros(cells.values.shape, bool)
            _rows_of(mask)[window] = chosen
            random += cells.sum_variance(mask)
        spread = CONFIDENCE_95 * math.hypot(math.sqrt(random), error * float(chosen.sum())) * area
        return float(changes[chosen].sum()) * area, math.nan if is_unknown else spread

    with np.errstate(invalid="ignore"):
        lower, higher, exceeds = changes < 0, changes > 0, np.abs(changes) > limits
    (cut, cut_error), (fill, fill_error), (_, net_error) = volume(lower), volume(higher), volume(compared)
    measured = sum(int(np.isfinite(each.raster.values).sum()) for each in (before, after))
    return VolumeChange(
        -cut + 0.0,
        fill,
        fill + cut,
        cut_error,
        fill_error,
        net_error,
        math.nan if is_unknown else -float(changes[lower & exceeds].sum()) * area + 0.0,
        math.nan if is_unknown else float(changes[higher & exceeds].sum()) * area,
        float(compared.sum()) * area,
        float((compared & difference.filled).sum()) * area,
        float(measured - 2 * compared.sum()) * area,
        difference,
        limits,
        difference.unit,
        _change_at_border(before.raster, after.raster, difference, exceeds),
    )


def _change_at_border(before: Raster, after: Raster, difference: Raster, exceeds: NDArray[np.bool_]) -> float:
    """Mean significant change of the compared cells next to a missing cell. 0 if it can be chance."""
    from scipy.ndimage import binary_dilation  # slow import

    around = []
    for raster in (before, after):
        rows, columns = _window_in(difference, raster)
        known = np.pad(np.isfinite(raster.values), 1)
        around.append(known[rows.start : rows.stop + 2, columns.start : columns.stop + 2])
    missing = binary_dilation(around[0] != around[1], np.ones((3, 3), bool))[1:-1, 1:-1]
    border = missing & np.isfinite(difference.values)
    significant, count = border & exceeds, max(int(border.sum()), 1)
    chance = 1 - CONFIDENCE
    expected = chance + 4 * math.sqrt(chance * CONFIDENCE / count)
    is_chance = significant.sum() <= max(expected, MIN_BORDER_CHANGE) * count
    return 0.0 if is_chance else float(np.abs(difference.values[significant]).astype(np.float64).sum()) / count


def _common_shift(changes: Grid, errors: Grid) -> float:
    """Change that most of the area has in common, from the medians of square blocks. 0 if there is none.

    The blocks in common are those near the densest 40 % of the medians. Change elsewhere, such as a pile, is ignored.
    `errors` are standard deviations of the changes. If they are NaN, the spread in the blocks is used.
    """
    edge = min(MAX_BLOCKS, math.isqrt(int(np.isfinite(changes).sum()) // MIN_BLOCK_CELLS))
    if edge < MIN_BLOCKS:
        return 0.0
    strips = np.array_split(np.stack([changes, errors]), edge, axis=1)
    parts = [part[:, np.isfinite(part[0])] for strip in strips for part in np.array_split(strip, edge, axis=2)]
    blocks = [part for part in parts if part.shape[1] >= MIN_BLOCK_CELLS]
    count = math.ceil(0.4 * len(blocks))
    if count < MIN_BLOCKS:
        return 0.0
    if np.isnan(errors).all():
        blocks = [np.stack([part[0], np.full_like(part[0], _spread(part[0]))]) for part in blocks]
    errors = np.concatenate(blocks, axis=1)[1]
    medians = np.sort([np.median(part[0]) for part in blocks])
    error = MEDIAN_ERROR * float(np.median([math.sqrt((part[1] ** 2).mean() / part.shape[1]) for part in blocks]))
    first = int(np.argmin(medians[count - 1 :] - medians[: len(medians) - count + 1]))
    shift = float(medians[first : first + count].mean())
    common = medians
    for _ in range(5):
        common = medians[np.abs(medians - shift) <= max(2 * error, MAX_SHIFT_VARIATION * abs(shift))]
        if 2 * len(common) <= len(blocks):
            return 0.0
        shift = float(common.mean())
    is_near = np.abs(np.concatenate(blocks, axis=1)[0] - shift) <= np.maximum(
        CONFIDENCE_95 * errors, MAX_SHIFT_VARIATION * abs(shift)
    )
    limit = 3 * max(error, float(common.std())) / math.sqrt(len(common))
    return shift if 2 * is_near.sum() > len(is_near) and abs(shift) > limit else 0.0


def _spread(values: Grid) -> float:
    """Standard deviation of the inner values."""
    return float(np.diff(np.quantile(values, (0.16, 0.84)))[0]) / 2


def _rows_of(cells: NDArray[Any]) -> NDArray[Any]:
    """View of an array (columns, rows) from the south as raster rows from the north."""
    return cells.T[::-1]


def _window_in(part: Raster, raster: Raster) -> tuple[slice, slice]:
    """Rows and columns of a part of a raster."""
    left, bottom = np.round((part.corner - raster.corner) / raster.cell).astype(int)
    rows, columns = part.values.shape
    top = raster.values.shape[0] - bottom - rows
    return slice(top, top + rows), slice(left, left + columns)
