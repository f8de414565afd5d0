"""LiDAR scans as KITTI stores them: float32 x, y, z, intensity, one point after another, without any header.

Nothing in such a file says what it holds, so the reader can only refuse what cannot be one: a size that is no whole
number of points, coordinates that no scanner measures.

Source: Geiger et al. 2012; the development kit of the KITTI odometry benchmark.
"""

from __future__ import annotations

import os

import numpy as np

from ...core.errors import FileError
from ..source import open_source
from ..table import PointTable

COLUMNS = 4
FARTHEST = 1e6  # [m] no scanner sees as far; other data read as float32 nearly always holds larger numbers


def read_kitti_bin(path: str | os.PathLike[str]) -> PointTable:
    """Read one scan, with the attribute `intensity`.

    Points that are not finite are kept.

    Raises:
        FileError: Missing, empty, not a multiple of 16 bytes, or numbers that are no coordinates; says where.
    """
    source = open_source(path)
    step = COLUMNS * 4
    if len(source) % step:
        reason = f"{len(source)} bytes are not a multiple of {step}: float32 x, y, z, intensity a point"
        remedy = "The file may be cut off, or have other columns"
        raise FileError(path, reason, where=f"byte {len(source) // step * step}", remedy=remedy)
    rows = np.frombuffer(source, "<f4").reshape(-1, COLUMNS).astype(np.float32)
    with np.errstate(invalid="ignore"):
        wild = np.isfinite(rows[:, :3]) & (np.abs(rows[:, :3]) > FARTHEST)
    if wild.any():
        row, column = (int(v) for v in np.argwhere(wild)[0])
        reason = f"point {row} has the coordinate {rows[row, column]}; this is no scan of float32 x, y, z, intensity"
        raise FileError(path, reason, where=f"byte {row * step + 4 * column}")
    return PointTable(np.ascontiguousarray(rows[:, :3]), attributes={"intensity": rows[:, 3].copy()})
