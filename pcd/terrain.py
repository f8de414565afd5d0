"""Terrain as rasters, and heights above the ground."""

from __future__ import annotations

import dataclasses
import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..core.checks import check_count, check_finite, check_positive, check_shape, shown
from ..core.devices import resolve_device
from ..core.dropped_results import returns_new
from ..core.errors import FilePath
from ..kernels.lang import float32, vec3
from ..kernels.memory import cast, download, upload
from ..kernels.terrain.cells import CellGroups, FixedCells
from ..kernels.terrain.ground_in_reach import reach_in_cells
from ..kernels.terrain.inverse_distance import interpolate_centres
from .cloud import PointCloud
from .geotiff import geotiff
from .ground import CELL, WINDOW, check_window
from .point_arrays import check_cloud
from .raster_cells import (
    GROUND,
    check_box,
    check_classes,
    check_lengths,
    chosen_points,
    ground_heights,
    heights_above_ground,
    measured_cells,
    raster_values,
    window_of,
)

KINDS = ("dtm", "dsm", "chm", "density", "intensity", "lowest")
METHODS = ("idw", "tin")
NODATA = -9999.0
NEIGHBORS = 8  # that a height between points is made of
MOST_EDGE = 1 << 24  # cells along a side of what gaps are filled in: their centres are float32


@dataclass(frozen=True, eq=False)
class Raster:
    """Values on a grid of square cells, as `loom.rasterize` makes it.

    Attributes:
        values: float32 [rows, columns], the northernmost row first; NaN where there is no value.
        corner: The low x and y of the grid, float64 [2].
        cell: The side of a cell.
        filled: bool [rows, columns], cells that `fill_gaps` gave a value.
        kind: What the values are, such as "dtm".
        crs: The coordinate system as rasterio takes it, such as "EPSG:26910"; None where it is not known.
        nodata: What stands in files for NaN.
    """

    values: NDArray[np.float32]
    corner: NDArray[np.float64]
    cell: float
    filled: NDArray[np.bool_]
    kind: str = ""
    crs: str | None = None
    nodata: float = NODATA

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """Low x, low y, high x, high y of the grid."""
        (x, y), (rows, columns) = self.corner.tolist(), self.values.shape
        return x, y, x + columns * self.cell, y + rows * self.cell

    def __repr__(self) -> str:
        """Its size, and how much of it has values."""
        (rows, columns), known = self.values.shape, int(np.isfinite(self.values).sum())
        made = f", {int(self.filled.sum()):,} of them filled" if self.filled.any() else ""
        return f"Raster({self.kind or 'values'}, {columns} x {rows} cells of {self.cell:g}, {known:,} known{made})"

    @returns_new
    def fill_gaps(self, max_distance: float, *, neighbors: int = NEIGHBORS, device: Any = None) -> Raster:
        """Fill cells without a value by inverse distance from those that have one, and mark them.

        Args:
            max_distance: Between centres of cells [unit of the grid]; what is farther from all values stays empty.
            neighbors: Cells that a value is made of, about: those in the smallest square around that holds so many.
            device: "cpu", "cuda:0"; None is the CPU.

        Returns:
            A Raster, its `filled` set in the cells that were filled.

        Raises:
            ValueError: A distance that is not above 0, a count below 1, or more than 2^24 cells along a side.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> x, y = np.mgrid[0:20, 0:20].reshape(2, -1) + 0.5
            >>> hole = np.hypot(x - 10, y - 10) < 3
            >>> cloud = loom.PointCloud(np.column_stack([x, y, 0.1 * x])[~hole])
            >>> raster = loom.rasterize(cloud, 1.0, "lowest")
            >>> int(np.isnan(raster.values).sum()), int(raster.fill_gaps(5.0).filled.sum())
            (32, 32)
        """
        reach, count = check_positive("max_distance", max_distance), check_count("neighbors", neighbors)
        if max(self.values.shape) > MOST_EDGE:
            raise ValueError(f"values: {self.values.shape} cells are more than 2^24 along a side; fill parts of it")
        upright = self.values[::-1].T  # column by column from the lowest row, as cells are numbered
        columns, rows = upright.shape
        known = np.isfinite(upright)
        x, y = np.nonzero(known)
        if not len(x) or known.all():
            return self
        places = np.column_stack([x + 0.5, y + 0.5, upright[known]])
        cells = FixedCells(np.zeros(2), 1.0, np.zeros(2), np.array([columns, rows]))
        groups = CellGroups(upload(places, vec3, resolve_device(device or "cpu")), cells)
        within = reach / self.cell
        rings = min(math.ceil(within), max(columns, rows))
        heights = download(interpolate_centres(groups, cells, count, within, rings)).reshape(columns, rows)
        made = np.where(known, upright, heights.astype(np.float32)).T[::-1]
        gaps = ~np.isfinite(self.values) & np.isfinite(made)
        return dataclasses.replace(self, values=np.ascontiguousarray(made), filled=self.filled | gaps)

    def write(self, path: FilePath, *, overwrite: bool = True) -> Path:
        """Write a GeoTIFF, whole or not at all: compressed blocks of float32; the second band is 1 where it was filled.

        Args:
            path: The file, which ends in .tif or .tiff.
            overwrite: Whether an existing file may be replaced.

        Raises:
            FileError: The file cannot be written, the package rasterio is missing, or it does not know the `crs`.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> points = np.random.default_rng(0).random((5000, 3)) * (40, 20, 1)
            >>> loom.rasterize(loom.PointCloud(points), 1.0, "dsm", crs="EPSG:26910").write("dsm.tif").name
            'dsm.tif'
        """
        shape, corner = self.values.shape, (self.corner[0], self.corner[1])
        with geotiff(path, shape, corner, self.cell, self, overwrite=overwrite) as file:
            file.write(np.where(np.isfinite(self.values), self.values, np.float32(self.nodata)), 1)
            file.write(self.filled.astype(np.float32), 2)
        return Path(path)


def rasterize(
    cloud: PointCloud,
    cell: float,
    kind: str = "dtm",
    *,
    method: str = "idw",
    reach: float | None = None,
    neighbors: int = NEIGHBORS,
    classes: Any = None,
    corner: ArrayLike = (0.0, 0.0),
    bounds: ArrayLike | None = None,
    crs: str | None = None,
) -> Raster:
    """Rasters of a survey: bare earth, surface, canopy height, density, intensity.

    Cells are half-open and counted from a `corner` fixed in space, so that rasters of parts of a survey fit together.

    Args:
        cloud: The survey, z up.
        cell: The side of a cell [m].
        kind: "dtm", the height of the ground at each cell's centre; "dsm", the highest first return in a cell; "chm",
            canopy height: the dsm less the dtm; "density", points per square unit; "intensity", the mean of the
            finite values of that attribute; "lowest", the lowest point in a cell.
        method: Of heights of the ground between its points: "idw", by inverse distance; "tin", on Delaunay triangles,
            made by SciPy on the CPU.
        reach: With "idw" how far a cell's centre may be from ground points [m], 20 cells where it is None; with "tin"
            the longest edge of a triangle, None for any. Cells without ground in reach have no value.
        neighbors: With "idw" the points that count: all those, within reach, of the smallest square of cells around
            that holds so many.
        classes: Classes of LAS of the points that count. None takes ground (2) for the ground, and otherwise all but
            noise (7 and 18).
        corner: A corner of cells, x and y.
        bounds: (x0, y0, x1, y1) that the raster covers; None covers the cloud.
        crs: The coordinate system, for files, as rasterio takes it: "EPSG:26910" or well-known text.

    Returns:
        A Raster. A cell without points has no value, and a density of 0.

    Raises:
        TypeError: No PointCloud.
        ValueError: An argument out of range; coordinates in degrees; no points that count; no classes, where they are
            needed; ground points of which there is no triangle; more than 2^28 cells.
        MemoryError: The raster does not fit into memory.

    Notes:
        "idw" is the default: what a cell is depends on nothing beyond `reach`, so tiles give the same bits, and it runs
        on the device; "tin" is closer on slopes and costs a triangulation (docs/terrain.md has both beside each other).
        Sums are float64 in the points' order; 32 B of memory a cell, 28 B a point. The same bits from run to run.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> rng = np.random.default_rng(0)
        >>> x, y = rng.uniform(0, 50, (2, 20_000))
        >>> tree = np.hypot(x - 25, y - 25) < 5
        >>> z = 0.1 * x + np.where(tree, 8.0, 0.0)
        >>> cloud = loom.PointCloud(np.column_stack([x, y, z]), classification=np.where(tree, 5, 2).astype(np.uint8))
        >>> canopy = loom.rasterize(cloud, 1.0, "chm")
        >>> canopy.values.shape, round(float(np.nanmax(canopy.values)))
        ((50, 50), 8)
    """
    check_cloud("cloud", cloud)
    side = check_positive("cell", cell)
    for name, value, known in (("kind", kind, KINDS), ("method", method, METHODS)):
        if value not in known:
            raise ValueError(f"{name}: expected {' or '.join(map(repr, known))}, got {shown(value)}")
    wanted = check_classes(classes)
    far = None if reach is None else check_positive("reach", reach)
    count = check_count("neighbors", neighbors)
    start = check_finite("corner", check_shape("corner", corner, (2,)))
    box = None if bounds is None else check_box(bounds)
    check_lengths(cloud)
    points = cloud._device_array("points")
    window = window_of(points, start - cloud.origin[:2], side, box, cloud.origin)
    surface = ground = None
    if kind in ("dtm", "chm"):
        chosen = chosen_points(cloud, GROUND if wanted is None else wanted, is_ground=True)
        ground = ground_heights(chosen, window, method, far, count)
    if kind != "dtm":
        surface = measured_cells(cloud, window, kind, None if kind == "chm" else wanted)
    values = raster_values(kind, surface, ground, window, float(cloud.origin[2]))
    low = start + np.array([window.column0, window.row0]) * side
    return Raster(values, low, side, np.zeros(values.shape, bool), kind, crs)


def height_above_ground(
    cloud: PointCloud,
    *,
    reach: float = 20.0,
    neighbors: int = NEIGHBORS,
    cell: float = 1.0,
    corner: ArrayLike = (0.0, 0.0),
    classes: Any = GROUND,
) -> NDArray[np.float32]:
    """The height of each point above the ground points near it.

    The ground is interpolated by inverse distance in plan, as `loom.rasterize` does.

    Args:
        cloud: A classified survey, z up.
        reach: How far ground points may be from a point in plan [m].
        neighbors: Ground points that count: all those, within reach, of the smallest square of cells around the
            point's that holds so many; its own cell and the next ones at least.
        cell: The side of those cells [m], about the distance between ground points.
        corner: A corner of the cells, fixed in space.
        classes: Classes of LAS that are ground.

    Returns:
        float32 [n]; NaN where no ground is within reach, and for points that are not finite.

    Raises:
        TypeError: No PointCloud.
        ValueError: An argument out of range; coordinates in degrees; a cloud without `classification`, or without
            ground.

    Notes:
        The answer depends on nothing beyond `reach` of a point. 28 B of memory a point and 4 B a cell.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> ground = np.random.default_rng(0).random((2000, 3)) * (20, 20, 0)
        >>> cloud = loom.PointCloud(np.vstack([ground, [[10, 10, 7]]]), classification=np.array([2] * 2000 + [5]))
        >>> float(loom.height_above_ground(cloud)[-1])
        7.0
    """
    check_cloud("cloud", cloud)
    far, side = check_positive("reach", reach), check_positive("cell", cell)
    count = check_count("neighbors", neighbors)
    start = check_finite("corner", check_shape("corner", corner, (2,)))
    wanted = check_classes(classes)
    check_lengths(cloud)
    points = cloud._device_array("points")
    ground = chosen_points(cloud, GROUND if wanted is None else wanted, is_ground=True)
    return cloud._handed_out(
        cast(heights_above_ground(points, ground, start - cloud.origin[:2], side, far, count), float32)
    )


def ground_reach(cell_size: float = CELL, max_window: float = WINDOW) -> float:
    """How far around a point, along x and along y, `classify_ground` with a `corner` looks.

    Args:
        cell_size: As `classify_ground` has it.
        max_window: Likewise.

    Returns:
        A length [m]: the two small fillings before the openings, the closing of low points, the largest window twice,
        the filling of the bare earth, and a cell or two of its slope.

    Raises:
        ValueError: A length that is not above 0, or a window of more than 512 cells.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.pcd.terrain import ground_reach
        >>> ground_reach(cell_size=1.0, max_window=18.0)
        141.0
    """
    cell, window = check_positive("cell_size", cell_size), check_positive("max_window", max_window)
    check_window(window, cell)
    return (reach_in_cells(math.ceil(window / cell)) + 1) * cell
