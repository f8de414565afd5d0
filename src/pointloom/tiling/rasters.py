"""Rasters of tiles and their mosaics.

All tiles share one grid. A cell belongs to the tile that contains its center and depends only on points in the halo, so
the mosaic equals the raster of the complete cloud.
"""

from __future__ import annotations

import dataclasses
import math
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..core.coordinate_systems import map_crs
from ..core.errors import FileError
from ..core.paths import job_file
from ..io.optional_imports import foreign_errors, import_for
from ..io.points.las_crs import crs_of as system_of
from ..io.points.las_crs import find_text
from ..kernels.lru_cache import LruCache
from ..pcd.cloud import PointCloud
from ..pcd.geotiff import geotiff
from ..pcd.raster import NODATA_VALUE, Raster
from ..pcd.raster_cells import NoGroundError
from ..pcd.terrain import OF_HEIGHTS, rasterize
from .manifest import Manifest
from .plan import Plan
from .sources import file_of
from .steps.raster import Rasterize

FOLDER = "rasters"
WINDOW_CELLS = 1024  # cells per side of the mosaic windows: 12 MB
MAX_OPEN = 64  # open rasters of tiles


def write_raster(step: Rasterize, cloud: PointCloud, plan: Plan, folder: Path, index: tuple[int, int]) -> None:
    cells = tile_cells(step, plan, index)
    if cells is None:
        return
    raster = _raster_of(step, cloud, plan, cells)
    raster.write(job_file(raster_path(folder, step.raster, index)))


def _raster_of(step: Rasterize, cloud: PointCloud, plan: Plan, cells: NDArray[np.int64]) -> Raster:
    """Raster of the cells (x0, y0, x1, y1), upper ends exclusive."""
    params, corner = step.params, np.array(step.params["corner"])
    rim = 0 if step.fill is None else math.ceil(step.fill / step.cell)
    options = {name: params[name] for name in ("kind", "reach", "neighbors", "classes", "corner")}
    padded = cells + np.array([-rim, -rim, rim, rim])
    grid = np.array(grid_cells(step, plan))
    padded[:2], padded[2:] = np.maximum(padded[:2], grid[:2]), np.minimum(padded[2:], grid[2:])
    bounds: NDArray[np.float64] = (np.tile(corner, 2) + padded * step.cell).astype(np.float64)
    crs = params["crs"] or crs_of(plan, step.kind)
    try:
        raster = rasterize(cloud, step.cell, bounds=bounds, crs=crs, **options)
    except NoGroundError:
        empty = np.full(((padded[3] - padded[1]), (padded[2] - padded[0])), np.nan, np.float32)
        raster = Raster(empty, bounds[:2], step.cell, np.zeros(empty.shape, bool), step.kind, crs)
    if step.fill is not None:
        raster = raster.fill_gaps(step.fill)
    rows = slice(padded[3] - cells[3], padded[3] - cells[1])
    columns = slice(cells[0] - padded[0], cells[2] - padded[0])
    low = corner + cells[:2] * step.cell
    values, filled = raster.values[rows, columns], raster.filled[rows, columns]
    return dataclasses.replace(raster, values=values, filled=filled, corner=low)


def grid_cells(step: Rasterize, plan: Plan) -> list[int]:
    """Cells of the complete raster: (x0, y0, x1, y1), upper ends exclusive."""
    corner = np.array(step.params["corner"])
    low, high = (np.floor((np.array(plan.data[end])[:2] - corner) / step.cell) for end in ("low", "high"))
    return [*low.astype(np.int64).tolist(), *(high + 1).astype(np.int64).tolist()]


def tile_cells(step: Rasterize, plan: Plan, index: tuple[int, int]) -> NDArray[np.int64] | None:
    """Cells with centers in a tile: (x0, y0, x1, y1), upper ends exclusive. None if there are none."""
    grid, bounds = grid_cells(step, plan), np.empty(4, np.int64)
    for axis in range(2):
        corner, begin = step.params["corner"][axis], plan.corner[axis] + index[axis] * plan.size
        first = max(grid[axis], math.floor((begin - corner) / step.cell) - 2)
        last = min(grid[axis + 2], math.ceil((begin + plan.size - corner) / step.cell) + 2)
        numbers = np.arange(first, last)
        centers = corner + (numbers + 0.5) * step.cell
        owners = np.floor((centers - plan.corner[axis]) / plan.size)
        numbers = numbers[np.clip(owners, 0, plan.shape[axis] - 1) == index[axis]]
        if not len(numbers):
            return None
        bounds[axis], bounds[axis + 2] = numbers[0], numbers[-1] + 1
    return bounds


def raster_path(folder: Path, name: str, index: tuple[int, int]) -> Path:
    return folder / FOLDER / name / f"{index[0]}_{index[1]}.tif"


def crs_of(plan: Plan, kind: str) -> str | None:
    """Coordinate system of the files for rasterio, for rasters of a kind. None if unknown."""
    header = file_of(plan.sources[0]).header
    return find_text(header) or map_crs("crs", None, system_of(header), with_heights=kind in OF_HEIGHTS)


def mosaics_of(plan: Plan, path: Path) -> list[Path]:
    """Mosaic files beside a result: `result.dtm.tif` beside `result.laz`."""
    stem = path.name.removesuffix(path.suffix).removesuffix(".copc")
    return [path.with_name(f"{stem}.{step.raster}.tif") for step in plan.steps if isinstance(step, Rasterize)]


def write_mosaics(manifest: Manifest, plan: Plan, paths: list[Path], overwrite: bool) -> None:
    """Write a GeoTIFF per raster, window by window. FileError if a tile's raster is wrong or writing fails."""
    steps = [step for step in plan.steps if isinstance(step, Rasterize)]
    for step, path in zip(steps, paths, strict=True):
        _write_mosaic(manifest, plan, step, path, overwrite)


def _write_mosaic(manifest: Manifest, plan: Plan, step: Rasterize, path: Path, overwrite: bool) -> None:
    tiles = manifest.rows("SELECT id, ix, iy FROM tiles ORDER BY id")
    cells_of = {(row["ix"], row["iy"]): cells for row in tiles
            if (cells := tile_cells(step, plan, (row["ix"], row["iy"]))) is not None}  # fmt: skip
    if not cells_of:
        raise FileError(path, f"no cell of {step.cell:g} has its center in a tile", remedy="Use smaller cells")
    boxes = np.array([*cells_of.values()])
    x0, y0, x1, y1 = [*boxes[:, :2].min(axis=0), *boxes[:, 2:].max(axis=0)]
    shape, low = (int(y1 - y0), int(x1 - x0)), np.array(step.params["corner"]) + np.array([x0, y0]) * step.cell
    metadata = SimpleNamespace(kind=step.kind, crs=step.params["crs"] or crs_of(plan, step.kind), nodata=NODATA_VALUE)
    windows: Any = import_for(path, "rasterio.windows", "geo")
    indices = [*cells_of]
    with (
        _Tiles(manifest.folder, step, cells_of) as opened,
        geotiff(path, shape, (low[0], low[1]), step.cell, metadata, overwrite=overwrite, for_maps=True) as file,
    ):
        for top in range(0, shape[0], WINDOW_CELLS):
            for left in range(0, shape[1], WINDOW_CELLS):
                rows, columns = min(WINDOW_CELLS, shape[0] - top), min(WINDOW_CELLS, shape[1] - left)
                box = (x0 + left, y1 - top - rows, x0 + left + columns, y1 - top)
                out = np.zeros((2, rows, columns), np.float32)
                out[0] = 0.0 if step.kind == "density" else NODATA_VALUE
                meet = (boxes[:, 0] < box[2]) & (boxes[:, 2] > box[0]) & (boxes[:, 1] < box[3]) & (boxes[:, 3] > box[1])
                for number in np.flatnonzero(meet):
                    opened.copy_cells(indices[number], boxes[number], box, out)
                file.write(out, window=windows.Window(left, top, columns, rows))


class _Tiles:
    """Rasters of tiles, a few open at a time."""

    def __init__(self, folder: Path, step: Rasterize, cells: dict[Any, Any]):
        self.folder, self.step, self.cells = folder, step, cells
        self.files: LruCache[Any] = LruCache(MAX_OPEN, on_evict=lambda file: file.close())

    def __enter__(self) -> _Tiles:
        return self

    def __exit__(self, *_: object) -> None:
        self.files.clear()

    def copy_cells(self, index: tuple[int, int], cells: Any, box: Any, out: NDArray[np.float32]) -> None:
        """Copy a tile's values in a box of cells. A tile without points has no file."""
        path = raster_path(self.folder, self.step.raster, index)
        if self.files.find(index) is None and not path.exists():
            return
        low, high = np.maximum(cells[:2], box[:2]), np.minimum(cells[2:], box[2:])
        rasterio: Any = import_for(path, "rasterio", "geo")
        with foreign_errors(path, "cannot be read"):
            file = self.files.get(index, 1, lambda: rasterio.open(path))
            if (file.width, file.height) != (cells[2] - cells[0], cells[3] - cells[1]):
                raise FileError(path, "is not the raster that was written", remedy="Plan the job again")
            rows = (int(cells[3] - high[1]), int(cells[3] - low[1]))
            columns = (int(low[0] - cells[0]), int(high[0] - cells[0]))
            out[:, box[3] - high[1] : box[3] - low[1], low[0] - box[0] : high[0] - box[0]] = file.read(
                window=(rows, columns)
            )
