"""Atomic writing of GeoTIFF files."""

from __future__ import annotations

import importlib
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from types import ModuleType
from typing import Any

from ..core.atomic import atomic_path, check_writable
from ..core.errors import FileError, FilePath

BLOCK_CELLS = 256  # cells per side of a block
ENDINGS = (".tif", ".tiff")
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
                for band, name in enumerate(() if is_image else (metadata.kind, "filled"), start=1):
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
