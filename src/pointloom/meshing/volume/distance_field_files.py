"""Files of distance fields: NPZ archives of the source. Distances are recomputed bitwise.

Members: format, origin float64 [3], sizes float64 [2] (voxel size and maximum distance [m], infinite for a dense box),
shape int64 [3] (zeros without an array), is_signed, voxels int32 [k, 3] (occupied).
"""

from __future__ import annotations

import os
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...io.points.archives import Arrays, Expected, check_arrays, read_archive, rows_of, write_archive
from .voxel_boxes import find_fault_of_voxel_size

FORMAT = b"pointloom distance field 1"
MAX_COORDINATE = 2**29  # of voxel coordinates. The supported range is smaller


class FieldSource(NamedTuple):
    """Source of a distance field without its voxels. Fields as of DistanceField."""

    origin: NDArray[np.float64]
    voxel_size: float
    max_distance: float | None
    shape: tuple[int, int, int] | None = None
    signed: bool = False


def arrays_of(source: FieldSource, voxels: NDArray[np.int32]) -> Arrays:
    return {
        "origin": source.origin,
        "sizes": np.array([source.voxel_size, np.inf if source.max_distance is None else source.max_distance]),
        "shape": np.array(source.shape or (0, 0, 0), np.int64),
        "is_signed": np.array(source.signed),
        "voxels": voxels,
    }


def source_of(arrays: Arrays) -> FieldSource:
    voxel_size, limit = arrays["sizes"].tolist()
    x, y, z = arrays["shape"].tolist()
    max_distance = None if limit == np.inf else limit
    return FieldSource(arrays["origin"], voxel_size, max_distance, (x, y, z) if x else None, bool(arrays["is_signed"]))


def write_field(path: str | os.PathLike[str], arrays: Arrays, *, overwrite: bool) -> None:
    write_archive(path, FORMAT, arrays, overwrite=overwrite)


def read_field(path: str | os.PathLike[str]) -> Arrays:
    return read_archive(path, FORMAT, "distance field", "DistanceField.save", _expected, _find_fault)


def check_field_arrays(arrays: object) -> Arrays:
    return check_arrays(arrays, _expected, _find_fault)


def _expected(arrays: Arrays) -> Expected:
    return {
        "origin": (np.float64, (3,)),
        "sizes": (np.float64, (2,)),
        "shape": (np.int64, (3,)),
        "is_signed": (np.bool_, ()),
        "voxels": (np.int32, (rows_of(arrays, "voxels"), 3)),
    }


def _find_fault(arrays: Arrays) -> str:
    voxel_size, limit = arrays["sizes"].tolist()
    shape, voxels = arrays["shape"], arrays["voxels"]
    has_shape = bool((shape > 0).all())
    if fault := find_fault_of_voxel_size(voxel_size):
        return f"sizes: {fault}"
    if not limit > 0:
        return f"sizes: expected a distance above 0, got {limit}"
    if not np.isfinite(arrays["origin"]).all():
        return "origin: not finite"
    if not has_shape and (shape.any() or limit == np.inf or arrays["is_signed"]):
        return f"shape: {shape.tolist()}"
    if not len(voxels):
        return ""
    low, high = (0, shape) if has_shape else (-MAX_COORDINATE, MAX_COORDINATE)
    if not ((voxels >= low) & (voxels < high)).all():
        return "voxels: out of range"
    if len(np.unique(voxels, axis=0)) != len(voxels):
        return "voxels: repeated"
    return ""
