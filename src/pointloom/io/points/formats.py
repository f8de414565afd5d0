"""Formats of clouds by extension. Readers and writers are imported when they are used, so that `--help` stays fast."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from ..file_formats import CloudFormat

if TYPE_CHECKING:
    from ..file_formats import CloudCodec


def _codec(name: str) -> CloudCodec:
    from . import codecs

    return getattr(codecs, name)


_NUMBERS = CloudFormat("XYZ", lambda: _codec("XYZ"), stores=(), encoding="text")
_TABLE = CloudFormat("text", lambda: _codec("TABLE"), encoding="text", has_named_columns=True)
_LAS = CloudFormat("LAS", lambda: _codec("LAS"), stores_crs=True)
_VTK = CloudFormat("VTK", lambda: _codec("VTK"), stores_crs=True, has_8_bit_colors=True)

CLOUD_FORMATS = {
    ".ply": CloudFormat("PLY", lambda: _codec("PLY"), encoding="either", stores_crs=True, has_8_bit_colors=True),
    ".pcd": CloudFormat(
        "PCD", lambda: _codec("PCD"), encoding="either", stores_viewpoint=True, stores_crs=True, has_8_bit_colors=True
    ),
    ".npz": CloudFormat("NPZ", lambda: _codec("NPZ"), stores_crs=True),
    ".npy": CloudFormat("NPY", lambda: _codec("NPY"), has_named_columns=True),
    ".xyz": replace(_NUMBERS, has_named_columns=True),
    ".xyzn": replace(_NUMBERS, name="XYZN", load=lambda: _codec("XYZN"), stores=("normals",)),
    ".xyzrgb": replace(_NUMBERS, name="XYZRGB", load=lambda: _codec("XYZRGB"), stores=("colors",)),
    ".pts": replace(_NUMBERS, name="PTS", load=lambda: _codec("PTS"), stores=("colors",), has_8_bit_colors=True),
    ".csv": replace(_TABLE, may_be_other=True),
    ".txt": replace(_TABLE, may_be_other=True),
    ".asc": _TABLE,
    ".bin": CloudFormat("KITTI", lambda: _codec("KITTI"), is_written=False, has_named_columns=True),
    ".las": _LAS,
    ".laz": _LAS,
    ".e57": CloudFormat(
        "E57", lambda: _codec("E57"), stores=("normals", "colors"), has_scans=True, stores_crs=True,
        has_8_bit_colors=True,
    ),
    ".ptx": CloudFormat("PTX", lambda: _codec("PTX"), is_written=False, encoding="text", has_scans=True),
    ".vtk": replace(_VTK, encoding="either"),
    ".vtp": _VTK,
    ".obj": CloudFormat("OBJ", lambda: _codec("OBJ"), is_written=False, encoding="text"),
}  # fmt: skip

#: The extensions that clouds are written to.
WRITTEN = tuple(extension for extension, format in CLOUD_FORMATS.items() if format.is_written)

WITH_NAMED_COLUMNS = tuple(extension for extension, format in CLOUD_FORMATS.items() if format.has_named_columns)
WITH_SCANS = tuple(extension for extension, format in CLOUD_FORMATS.items() if format.has_scans)


def storing(array: str) -> tuple[str, ...]:
    """The written extensions that store an array, see `CloudFormat.stores`."""
    return tuple(extension for extension in WRITTEN if array in CLOUD_FORMATS[extension].stores)
