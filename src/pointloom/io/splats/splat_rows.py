"""Splats as headerless rows of 32 bytes: `.splat`.

float32 x, y, z; float32 standard deviations; uint8 red, green, blue, opacity; uint8 quaternion (w, x, y, z) as 128 +
128 q. The format of antimatter15/splat.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.atomic import atomic_write
from ...core.errors import FileError, FilePath
from ...pcd.harmonics import DEGREE_0_HARMONIC
from ...pcd.splats import fractions_of, logits_of, unit_quaternions
from ..columns import warn_left_out
from ..source import open_source
from ..table import PointTable

_ROW_TYPE = np.dtype([("point", "<f4", 3), ("scale", "<f4", 3), ("color", "u1", 4), ("rot", "u1", 4)])
_MAX_SCALE = 1e6  # larger than any splat. Other data read as float32 nearly always has larger numbers


def read_splat(path: FilePath) -> PointTable:
    """Read splats of degree 0 as columns `f_dc`, `opacity`, `scale`, `rot`. Raises `FileError` for implausible data."""
    source = open_source(path)
    if len(source) % _ROW_TYPE.itemsize:
        reason = f"{len(source)} bytes are not a multiple of {_ROW_TYPE.itemsize}, the bytes of a splat"
        where = f"byte {len(source) // _ROW_TYPE.itemsize * _ROW_TYPE.itemsize}"
        raise FileError(path, reason, where=where, remedy="The file may be cut off")
    rows = source.array(_ROW_TYPE, len(source) // _ROW_TYPE.itemsize)
    sizes = rows["scale"]
    with np.errstate(invalid="ignore"):
        wrong = ((sizes < 0) | (sizes > _MAX_SCALE)).any(axis=1)
    if wrong.any():
        row = int(np.argmax(wrong))
        reason = f"splat {row} has the scales {sizes[row].tolist()}; this is not a .splat file"
        raise FileError(path, reason, where=f"byte {row * _ROW_TYPE.itemsize + 12}")
    colors = rows["color"].astype(np.float64) / 255
    with np.errstate(divide="ignore", invalid="ignore"):
        scale = np.log(sizes.astype(np.float64)).astype(np.float32)
        opacity = logits_of(colors[:, 3])
    attributes: dict[str, NDArray[Any]] = {
        "f_dc": ((colors[:, :3] - 0.5) / DEGREE_0_HARMONIC).astype(np.float32),
        "opacity": opacity,
        "scale": scale,
        "rot": ((rows["rot"].astype(np.float32) - 128) / 128),
    }
    return PointTable(np.ascontiguousarray(rows["point"], np.float32), attributes=attributes)


def write_splat(path: FilePath, table: PointTable, *, overwrite: bool = True) -> None:
    """Write splats as rows of 32 bytes. Higher harmonics and other attributes are dropped with a warning."""
    columns = table.attributes
    spare = [name for name in columns if name not in ("f_dc", "opacity", "scale", "rot")]
    points = table.points.astype(np.float32)
    check_rounding(path, table.points, np.abs(table.points - points).max(initial=0.0))
    rows = np.empty(len(points), _ROW_TYPE)
    rows["point"] = points
    with np.errstate(over="ignore"):
        rows["scale"] = np.exp(columns["scale"].astype(np.float64))
    rows["color"][:, :3] = to_bytes((0.5 + DEGREE_0_HARMONIC * columns["f_dc"].astype(np.float64)) * 255)
    rows["color"][:, 3] = to_bytes(fractions_of(columns["opacity"]) * 255)
    rows["rot"] = to_bytes(unit_quaternions(columns["rot"]) * 128 + 128)
    with atomic_write(path, overwrite=overwrite) as file:
        file.write(rows.tobytes())
    warn_left_out(path, ".splat", spare, stacklevel=3)


def to_bytes(values: NDArray[np.float64]) -> NDArray[np.uint8]:
    return np.clip(np.rint(values), 0, 255).astype(np.uint8)


def check_rounding(path: FilePath, points: NDArray[Any], error: float) -> None:
    """Raise `FileError` if a format would round centers by more than 2 mm."""
    if error > 2e-3:
        low, high = points.min(axis=0).tolist(), points.max(axis=0).tolist()
        reason = f"centers from {low} to {high} m would be rounded by {error:.2g} m"
        raise FileError(path, reason, remedy="translate the splats to near the origin, or write .ply")
