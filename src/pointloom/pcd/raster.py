"""Rasters on a grid of square cells: arithmetic, gaps, GeoTIFF."""

from __future__ import annotations

import dataclasses
import math
from dataclasses import dataclass
from numbers import Real
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..core.checks import check_count, check_finite, check_number, check_numeric, check_positive
from ..core.coordinate_systems import check_crs, common_crs
from ..core.devices import DeviceLike, resolve_device
from ..core.dropped_results import returns_new
from ..core.errors import FileError, FilePath
from ..core.units import LengthUnit, common_unit
from ..kernels.lang import vec3
from ..kernels.memory import download, upload
from ..kernels.terrain.cells import CellGroups, FixedCells
from ..kernels.terrain.inverse_distance import interpolate_centers
from .contour_files import check_contour_file, joined_lines, write_contour_file
from .contours import trace_contours
from .geotiff import geotiff, read_geotiff
from .line_set import LineSet

NODATA_VALUE = -9999.0
MIN_NEIGHBORS = 8  # of an interpolated height
MAX_EDGE = 1 << 24  # cells along a side for gap filling: their centers are float32
# Maximum shift between two grids that are used as one, in cells. On a slope of 45 degrees the error is 0.1 % of a cell.
# Rounding of corners at UTM coordinates is 1e-7 of a cell of 1 cm.
MAX_SHIFT = 1e-3
MAX_LEVELS = 10_000  # of contour lines: each takes a pass over the cells


@dataclass(frozen=True, eq=False)
class Raster:
    """Values on a grid of square cells, created by `loom.rasterize` or `loom.read_raster`.

    Rasters add and subtract where their cells coincide, and numbers are added to all cells: `after - before`.

    Attributes:
        values: float32 (rows, columns), northernmost row first. NaN if empty.
        corner: Minimum x and y, float64 (2,).
        cell: Edge of a cell.
        filled: bool (rows, columns), cells filled by `fill_gaps`.
        kind: Kind of values, such as "dtm".
        crs: Coordinate system as rasterio accepts it, such as "EPSG:26910". None if unknown.
        nodata: Value in files for NaN.
        unit: Unit of the coordinates, of the cloud or of the file's `crs`. None if unknown.
    """

    values: NDArray[np.float32]
    corner: NDArray[np.float64]
    cell: float
    filled: NDArray[np.bool_]
    kind: str = ""
    crs: str | None = None
    nodata: float = NODATA_VALUE
    unit: LengthUnit | None = None

    __array_ufunc__ = None  # NumPy's operators return NotImplemented

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """(x0, y0, x1, y1) of the grid."""
        (x, y), (rows, columns) = self.corner.tolist(), self.values.shape
        return x, y, x + columns * self.cell, y + rows * self.cell

    def __repr__(self) -> str:
        (rows, columns), known = self.values.shape, int(np.isfinite(self.values).sum())
        made = f", {int(self.filled.sum()):,} of them filled" if self.filled.any() else ""
        return f"Raster({self.kind or 'values'}, {columns} x {rows} cells of {self.cell:g}, {known:,} known{made})"

    def __add__(self, other: Raster | float) -> Raster:
        return self._combined("+", other, np.add, "sum")

    def __sub__(self, other: Raster | float) -> Raster:
        return self._combined("-", other, np.subtract, "difference")

    def _combined(self, sign: str, other: Raster | float, compute: np.ufunc, kind: str) -> Raster:
        if isinstance(other, Real):
            change = check_number(f"raster {sign} number", other)
            return dataclasses.replace(self, values=compute(self.values.astype(np.float64), change).astype(np.float32))
        if not isinstance(other, Raster):
            raise TypeError(f"raster {sign} value: expected a Raster or a number, got {type(other).__name__}")
        a, b = common_cells(f"raster {sign} raster", self, other)
        values = compute(a.values.astype(np.float64), b.values).astype(np.float32)
        return dataclasses.replace(a, values=values, filled=a.filled | b.filled, kind=kind)

    @returns_new
    def fill_gaps(self, max_distance: float, *, neighbors: int = MIN_NEIGHBORS, device: DeviceLike = None) -> Raster:
        """Fill empty cells by inverse distance weighting and set `filled` in them.

        Args:
            max_distance: Maximum distance between cell centers [unit of the grid].
            neighbors: Minimum cells with values in the smallest square used.
            device: "cpu" (default) or "cuda:0".

        Raises:
            ValueError: If an argument is out of range, or there are more than 2^24 cells along a side.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> x, y = np.mgrid[0:20, 0:20].reshape(2, -1) + 0.5
            >>> hole = np.hypot(x - 10, y - 10) < 3
            >>> cloud = loom.PointCloud(np.column_stack([x, y, 0.1 * x])[~hole])
            >>> raster = loom.rasterize(cloud, 1.0, "lowest")
            >>> int(np.isnan(raster.values).sum()), int(raster.fill_gaps(5.0).filled.sum())
            (32, 32)
        """
        search_radius, count = check_positive("max_distance", max_distance), check_count("neighbors", neighbors)
        if max(self.values.shape) > MAX_EDGE:
            raise ValueError(
                f"values: expected at most 2^24 cells along a side, got {self.values.shape}. Fill parts of it"
            )
        upright = self.values[::-1].T  # by column from the lowest row, as cells are numbered
        columns, rows = upright.shape
        known = np.isfinite(upright)
        x, y = np.nonzero(known)
        if not len(x) or known.all():
            return self
        known_points = np.column_stack([x + 0.5, y + 0.5, upright[known]])
        cells = FixedCells(np.zeros(2), 1.0, np.zeros(2), np.array([columns, rows]))
        groups = CellGroups(upload(known_points, vec3, resolve_device("cpu" if device is None else device)), cells)
        within = search_radius / self.cell
        rings = math.ceil(min(within, max(columns, rows)))
        heights = download(interpolate_centers(groups, cells, count, within, rings)).reshape(columns, rows)
        made = np.where(known, upright, heights.astype(np.float32)).T[::-1]
        gaps = ~np.isfinite(self.values) & np.isfinite(made)
        return dataclasses.replace(self, values=np.ascontiguousarray(made), filled=self.filled | gaps)

    def contour_lines(self, interval: float | None = None, *, levels: ArrayLike | None = None) -> LineSet:
        """Contour lines between the cell centers by marching squares, in float64.

        Lines end at empty cells.

        Args:
            interval: Height difference of the lines [m], which are at its multiples.
            levels: Heights of the lines instead, shape (n,).

        Raises:
            ValueError: If neither or both are given, a number is not finite or positive, or there are more than 10,000
                levels.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> x, y = np.mgrid[0:20, 0:20].reshape(2, -1) + 0.5
            >>> hill = loom.PointCloud(np.column_stack([x, y, 5 - 0.5 * np.hypot(x - 10, y - 10)]))
            >>> lines = loom.rasterize(hill, 1.0, "lowest").contour_lines(1.0)
            >>> np.unique(lines.points[:, 2]).tolist()
            [-1.0, 0.0, 1.0, 2.0, 3.0, 4.0]
        """
        if (interval is None) == (levels is None):
            raise ValueError("interval, levels: expected one of them, got both or neither")
        heights = self.values[::-1].astype(np.float64)
        known = heights[np.isfinite(heights)]
        if levels is not None:
            chosen = np.unique(
                check_finite("levels", np.atleast_1d(check_numeric("levels", levels))).astype(np.float64)
            )
        else:
            step = check_positive("interval", interval)
            low, high = (float(known.min()) / step, float(known.max()) / step) if known.size else (0.0, -1.0)
            if not high - low < MAX_LEVELS:  # NaN if both are infinite
                raise ValueError(f"interval: {step:g} gives more than {MAX_LEVELS:,} levels. Use a larger one")
            chosen = np.arange(math.ceil(low), math.floor(high) + 1, dtype=np.float64) * step
        if len(chosen) > MAX_LEVELS:
            raise ValueError(f"levels: expected at most {MAX_LEVELS:,}, got {len(chosen):,}")
        return trace_contours(heights, self.corner + self.cell / 2, self.cell, chosen)

    def write_contours(
        self, path: FilePath, interval: float | None = None, *, levels: ArrayLike | None = None, overwrite: bool = True
    ) -> Path:
        """Write contour lines for maps atomically, each as a polyline with its height as z and attribute `elevation`.

        Args:
            path: A .gpkg (GeoPackage), .geojson or .dxf file. GeoJSON has degrees of WGS 84, as its standard demands,
                if the `crs` is known. DXF stores no coordinate system.
            interval, levels: As in `contour_lines`.
            overwrite: Allow replacing an existing file.

        Raises:
            ValueError: As `contour_lines`.
            FileError: If the file cannot be written, pyogrio is missing, or the `crs` is unknown to it.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> x, y = np.mgrid[0:20, 0:20].reshape(2, -1) + 0.5
            >>> hill = loom.PointCloud(np.column_stack([x, y, 5 - 0.5 * np.hypot(x - 10, y - 10)]))
            >>> loom.rasterize(hill, 1.0, "lowest", crs="EPSG:26910").write_contours("hill.gpkg", 1.0).name
            'hill.gpkg'
        """
        check_contour_file(path, overwrite=overwrite)
        lines = joined_lines(self.contour_lines(interval, levels=levels))
        return write_contour_file(path, lines, self.crs, overwrite=overwrite)

    def write(self, path: FilePath, *, overwrite: bool = True) -> Path:
        """Write a compressed float32 GeoTIFF atomically. The second band is 1 in filled cells.

        Args:
            path: The file, ending in .tif or .tiff.
            overwrite: Allow replacing an existing file.

        Raises:
            FileError: If the file cannot be written, rasterio is missing, it does not support the `crs`, or a value
                equals `nodata`.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> points = np.random.default_rng(0).random((5000, 3)) * (40, 20, 1)
            >>> loom.rasterize(loom.PointCloud(points), 1.0, "dsm", crs="EPSG:26910").write("dsm.tif").name
            'dsm.tif'
        """
        if (self.values == np.float32(self.nodata)).any():
            remedy = "Pass another one, as in dataclasses.replace(raster, nodata=-32768.0)"
            raise FileError(path, f"a value equals nodata, {self.nodata:g}", remedy=remedy)
        shape, corner = self.values.shape, (self.corner[0], self.corner[1])
        with geotiff(path, shape, corner, self.cell, self, overwrite=overwrite) as file:
            file.write(np.where(np.isfinite(self.values), self.values, np.float32(self.nodata)), 1)
            file.write(self.filled.astype(np.float32), 2)
        return Path(path)


def read_raster(path: FilePath) -> Raster:
    """Read a GeoTIFF of one band with its coordinate system, such as a terrain model.

    Files of `Raster.write` are read bit for bit, with `filled` and `kind`. Other values are rounded to float32. Cells
    without data, by nodata value or mask, become NaN.

    Args:
        path: The file, ending in .tif or .tiff. Needs `pip install "pointloom[geo]"`.

    Raises:
        FileError: If the file is damaged, has several bands, more than 2^28 cells, or cells that are not square with
            north up, or rasterio is missing.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> points = np.random.default_rng(0).random((5000, 3)) * (40, 20, 1)
        >>> raster = loom.rasterize(loom.PointCloud(points), 1.0, "dsm", crs="EPSG:26910")
        >>> found = loom.read_raster(raster.write("dsm.tif"))
        >>> bool(np.array_equal(found.values, raster.values, equal_nan=True)), found.kind, found.crs
        (True, 'dsm', 'EPSG:26910')
    """
    return Raster(**read_geotiff(path))


def common_cells(name: str, a: Raster, b: Raster) -> tuple[Raster, Raster]:
    """The cells of two rasters that coincide, on the grid of the first one.

    Raises:
        ValueError: If the grids differ or do not overlap, or the coordinate systems differ.

    Warns:
        UnitWarning: If the units differ.
    """
    system = common_crs(name, (check_crs("crs", a.crs), check_crs("crs", b.crs)))
    unit = common_unit(name, (a.unit, b.unit))
    shapes = np.array([a.values.shape[::-1], b.values.shape[::-1]])
    shift = (b.corner - a.corner) / a.cell
    first = np.round(shift)
    stretch = abs(b.cell / a.cell - 1) * shapes[1].max()
    if not max(float(np.abs(shift - first).max()), stretch) <= MAX_SHIFT:
        raise ValueError(
            f"{name}: expected one grid, got {_grid_text(a)} and {_grid_text(b)}. Create both with one cell and "
            f"corner, as in rasterize(cloud, {a.cell!r}, corner={a.corner.tolist()})"
        )
    low, high = np.maximum(first, 0.0), np.minimum(shapes[0], first + shapes[1])
    if (high <= low).any():
        raise ValueError(f"{name}: expected rasters that overlap, got bounds {a.bounds} and {b.bounds}")
    crs = a.crs or b.crs if system is None else system.text
    parts = []
    for raster, start in ((a, low), (b, low - first)):
        (left, bottom), (columns, rows) = start.astype(int), (high - low).astype(int)
        top = raster.values.shape[0] - bottom - rows
        window = np.s_[top : top + rows, left : left + columns]
        parts.append(
            dataclasses.replace(
                raster, values=raster.values[window], filled=raster.filled[window], cell=a.cell, crs=crs, unit=unit,
                corner=a.corner + low * a.cell,
            )
        )  # fmt: skip
    return parts[0], parts[1]


def _grid_text(raster: Raster) -> str:
    return f"cells of {raster.cell!r} with a corner at {raster.corner.tolist()}"
