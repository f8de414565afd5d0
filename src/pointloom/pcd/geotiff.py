"""Reading and atomic writing of GeoTIFF files."""

from __future__ import annotations

import importlib
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

from ..core.atomic import atomic_path, check_writable
from ..core.errors import FileError, FilePath
from ..core.paths import input_path
from ..core.units import DEGREE, unit_by_length
from .raster_cells import MAX_CELLS

BLOCK_CELLS = 256  # cells per side of a block
ENDINGS = (".tif", ".tiff")
FILLED = "filled"  # description of the second band
NO_GEOREFERENCE = "has no georeference"
MAX_STRETCH = 1e-6  # relative difference of width and height of a cell: 1e-3 cells over 1,000 rows, as MAX_SHIFT
MAX_SMALL, MAX_CELLS_PER_BYTE = 1 << 22, 4096  # missing blocks take no bytes, zlib stores at most 1,032 cells of a byte
_VALUE_BANDS = {"dtype": "float32", "count": 2, "predictor": 3, "interleave": "band"}
_IMAGE_BANDS = {
    "dtype": "uint8", "count": 4, "predictor": 2, "interleave": "pixel", "photometric": "RGB",
    "alpha": "non-premultiplied",
}  # fmt: skip
_MAP_BANDS = {
    "driver": "COG", "blocksize": BLOCK_CELLS, "compress": "deflate", "predictor": "yes", "bigtiff": "if_safer",
    "overviews": "ignore_existing", "overview_resampling": "average", "num_threads": 1,
}  # fmt: skip


@contextmanager
def geotiff(
    path: FilePath,
    shape: tuple[int, int],
    corner: tuple[float, float],
    cell: float,
    metadata: Any,
    *,
    overwrite: bool,
    for_maps: bool = False,
    is_image: bool = False,
) -> Iterator[Any]:
    """GeoTIFF opened for writing blocks, renamed when complete. FileError as `Raster.write`. Two float32 bands (values,
    1 where filled), or RGBA uint8 if `is_image`. `metadata` has `kind`, `crs` and `nodata`. With `for_maps` it is
    rewritten as a Cloud Optimized GeoTIFF."""
    path, rasterio = check_geotiff(path, overwrite=overwrite)
    profile = {
        "driver": "GTiff", "height": shape[0], "width": shape[1], "crs": metadata.crs,
        "transform": rasterio.Affine(cell, 0.0, corner[0], 0.0, -cell, corner[1] + shape[0] * cell),
        "tiled": True, "blockxsize": BLOCK_CELLS, "blockysize": BLOCK_CELLS, "compress": "deflate",
        "BIGTIFF": "IF_SAFER",
        **(_IMAGE_BANDS if is_image else {"nodata": metadata.nodata} | _VALUE_BANDS),
    }  # fmt: skip
    first: Path | None = None
    try:
        with atomic_path(path, overwrite=overwrite) as part:
            first = part.with_suffix(".first") if for_maps else part
            with rasterio.open(first, "w", **profile) as file:
                for band, name in enumerate(() if is_image else (metadata.kind, FILLED), start=1):
                    file.set_band_description(band, name)
                yield file
            if for_maps:
                _check_blocks(rasterio, first)
                rasterio.shutil.copy(first, part, **_MAP_BANDS)
            _check_blocks(rasterio, part)
    except rasterio.errors.CRSError as error:
        raise FileError(path, f"crs: {str(metadata.crs)[:80]!r} is unknown: {error}") from error
    except (rasterio.errors.RasterioError, OSError) as error:
        reason = getattr(error, "strerror", None) or error.__cause__ or error
        raise FileError(path, f"cannot be written: {reason}") from error
    finally:
        if first is not None:
            first.unlink(missing_ok=True)


def check_geotiff(path: FilePath, *, overwrite: bool) -> tuple[Path, Any]:
    """Validate a path. Returns it and rasterio, FileError if not writable or rasterio is missing."""
    checked = check_writable(path, overwrite=overwrite)
    if checked.suffix.lower() not in ENDINGS:
        raise FileError(checked, "is not a GeoTIFF file name", remedy="Use a name that ends in .tif")
    return checked, _rasterio(checked)


def read_geotiff(path: FilePath) -> dict[str, Any]:
    """Fields of a `Raster` from a GeoTIFF with one band of values, and perhaps one of filled cells. FileError as
    `read_raster`."""
    path = input_path(path)
    if path.suffix.lower() not in ENDINGS:
        raise FileError(path, "is not a GeoTIFF file name", remedy="Use a name that ends in .tif")
    rasterio = _rasterio(path)
    try:
        with rasterio.open(path, driver="GTiff") as file:
            _check_layout(path, file)
            return _fields_of(file)
    except rasterio.errors.NotGeoreferencedWarning as error:  # if warnings are errors
        raise FileError(path, NO_GEOREFERENCE) from error
    except MemoryError as error:
        raise FileError(path, "needs more memory than is available", remedy="Read parts of it") from error
    except (rasterio.errors.RasterioError, OSError, ValueError) as error:
        if isinstance(error, FileError):
            raise
        raise FileError(path, f"is not an intact GeoTIFF: {str(error.__cause__ or error)[:300]}") from error


def _check_layout(path: Path, file: Any) -> None:
    if file.count != 1 and (file.count, file.descriptions[1]) != (2, FILLED):
        remedy = "Extract the band of heights, as in gdal_translate -b 1 in.tif out.tif"
        raise FileError(path, f"expected one band, got {file.count}", remedy=remedy)
    if np.issubdtype(file.dtypes[0], np.complexfloating):
        raise FileError(path, f"expected real values, got {file.dtypes[0]}")
    cells, size = file.width * file.height, path.stat().st_size
    if cells > MAX_CELLS:
        raise FileError(path, f"{file.width:,} x {file.height:,} cells are more than 2^28", remedy="Read parts of it")
    if cells > max(MAX_SMALL, MAX_CELLS_PER_BYTE * size):
        reason = (
            f"{file.width:,} x {file.height:,} cells do not fit into {size:,} bytes: most of its blocks are missing"
        )
        raise FileError(
            path, reason, remedy="Write all blocks, as in gdal_translate -co SPARSE_OK=FALSE in.tif out.tif"
        )
    a, b, c, d, e, f = tuple(file.transform)[:6]
    if file.transform.is_identity:
        raise FileError(path, NO_GEOREFERENCE)
    if not (np.isfinite([a, c, e, f]).all() and a > 0 and b == d == 0 and abs(a + e) <= MAX_STRETCH * a):
        remedy = "Resample it, as in gdalwarp -tr 1 1 in.tif out.tif"
        raise FileError(path, f"expected square cells with north up, got {[a, b, d, e]}", remedy=remedy)


def _fields_of(file: Any) -> dict[str, Any]:
    (scale, shift), cell = (file.scales[0], file.offsets[0]), float(file.transform.a)
    stored = file.read(1)
    values = stored.astype(np.float32) if (scale, shift) == (1, 0) else (stored * scale + shift).astype(np.float32)
    values[file.read_masks(1) == 0] = np.nan
    filled = np.zeros(values.shape, bool) if file.count == 1 else file.read(2) == 1
    nodata = file.nodata
    crs, unit = file.crs, None
    if crs is not None:
        name, meters = crs.linear_units_factor if crs.is_projected else ("", 0.0)
        unit = DEGREE if crs.is_geographic else unit_by_length(name, meters)
    return {
        "values": values,
        "corner": np.array([file.transform.c, _lower_edge(float(file.transform.f), cell, len(values))]),
        "cell": cell,
        "filled": filled,
        "kind": file.descriptions[0] or "",
        "crs": None if crs is None else crs.to_string(),
        "unit": unit,
    } | ({} if nodata is None or not np.isfinite(nodata) else {"nodata": float(nodata)})


def _lower_edge(top: float, cell: float, rows: int) -> float:
    """The lower edge of rows below `top`: the multiple of the cell if it gives this top, as `rasterize` computes it."""
    edge = top - rows * cell
    nearest = round(edge / cell) * cell
    return nearest if nearest + rows * cell == top else edge


def _check_blocks(rasterio: ModuleType, part: Path) -> None:
    """Read every block back, since GDAL does not report a full disk on close. RasterioError if one is damaged."""
    with rasterio.open(part) as file:
        levels = len(file.overviews(1))
    for level in (None, *range(levels)):
        with rasterio.open(part) if level is None else rasterio.open(part, overview_level=level) as file:
            for band in file.indexes:
                for _, window in file.block_windows(band):
                    file.read(band, window=window)


def _rasterio(path: Path) -> Any:
    try:
        for name in ("errors", "shutil"):
            importlib.import_module(f"rasterio.{name}")
        return importlib.import_module("rasterio")
    except ImportError as error:
        remedy = 'pip install "pointloom[geo]"'
        raise FileError(path, "GeoTIFF needs the package rasterio", remedy=remedy) from error
