"""Headerless LiDAR scans of float32 columns (KITTI, nuScenes), by default x, y, z, intensity.

The file does not define its layout, so invalid sizes, implausible coordinates and other periods raise. Without
`columns`, so do negative intensities. A warning is issued if the size fits another layout and the numbers do not repeat
every four: points of a cube or a sphere have equal statistics in every column. Geiger et al. 2012 (KITTI odometry
benchmark). Caesar et al. 2020 (nuScenes).
"""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ...core.coordinates import quiet
from ...core.errors import FileError, FilePath
from ...core.escaped_text import escaped
from ..source import open_source
from ..table import PointTable
from .text_table import check_columns, table_of

KITTI = ("x", "y", "z", "intensity")
COLUMN_LAYOUTS = {
    3: "x y z",
    4: "x y z intensity (KITTI)",
    5: "x y z intensity ring (nuScenes)",
    6: "x y z intensity ring time",
    7: "x y z and four others",
    8: "x y z and five others",
}
MAX_COORDINATE = 1e6  # [m] beyond any scanner's range. Other data read as float32 nearly always has larger numbers
MIN_COORDINATE = 1e-12  # [m] integers of 8 to 32 bits read as float32 are smaller, or larger than the range
SMALLEST_NORMAL = float(np.finfo(np.float32).tiny)  # integers up to 8,388,607 read as float32 are smaller
MIN_POINTS = 64  # fewer points have no reliable statistics
SAMPLE_NUMBERS = 840 * 120  # numbers in the statistics: whole points in each layout
PERIOD_MARGIN = 0.1  # minimum gain in explained variance of another number of columns over KITTI's


@quiet()
def read_kitti_bin(path: FilePath, columns: Sequence[str] | None = None) -> PointTable:
    """Read one scan of float32 columns, including non-finite points; `columns` None means x, y, z, intensity.
    Warns if the layout cannot be verified."""
    names = [*KITTI] if columns is None else check_columns(columns)
    source = open_source(path)
    step = len(names) * 4
    if len(source) % step:
        reason = f"{len(source)} bytes are not a multiple of {step}: float32 {', '.join(names)} per point"
        remedy = f"The file may be cut off, or have other columns{_fitting(len(source))}"
        raise FileError(path, reason, where=f"byte {len(source) // step * step}", remedy=remedy)
    rows = source.array("<f4", len(source) // 4).reshape(-1, len(names)).astype(np.float32, copy=False)
    if columns is None:
        _check_layout(path, rows)
    points = rows[:, [names.index(axis) for axis in ("x", "y", "z")]]
    wild = np.isfinite(points) & (np.abs(points) > MAX_COORDINATE)
    tiny = np.abs(points[points != 0]) < MIN_COORDINATE
    if tiny.sum() > tiny.size / 2:
        reason = f"most coordinates are below {MIN_COORDINATE:g}; this is not a scan of float32 {', '.join(names)}"
        raise FileError(path, reason, remedy="Other types of numbers, such as integers, are not supported")
    if len(points) and ((points[0] != 0) & (np.abs(points[0]) < SMALLEST_NORMAL)).any():
        reason = f"the first point is {points[0].tolist()}: small integers, as of a header, read as float32"
        raise FileError(path, reason, where="byte 0", remedy="Remove the header, or read the array with NumPy")
    if wild.any():
        row, axis = (int(v) for v in np.argwhere(wild)[0])
        reason = f"point {row} has the coordinate {points[row, axis]}; this is not a scan of float32 {', '.join(names)}"
        byte = row * step + 4 * names.index("xyz"[axis])
        raise FileError(path, reason, where=f"byte {byte}", remedy=f"Check the layout{_fitting(len(source))}")
    if columns is None:
        _check_intensities(path, rows[:, 3])
        if not _is_evident(rows):
            _warn_of_layout(path, len(source))
    return table_of(Path(path), dict(zip(names, np.ascontiguousarray(rows.T), strict=True)))


def _fitting(size: int) -> str:
    layouts = [layout for width, layout in COLUMN_LAYOUTS.items() if not size % (4 * width)]
    return f"; give columns= with all names. The size fits {'; '.join(layouts)}" if layouts else ""


def _check_intensities(path: FilePath, intensities: NDArray[np.float32]) -> None:
    below = np.flatnonzero(intensities < 0)
    if len(below):
        row = int(below[0])
        reason = f"point {row} has the intensity {intensities[row]:g}; this is not a scan of float32 {', '.join(KITTI)}"
        remedy = f"Give columns= with the names of all columns, such as {COLUMN_LAYOUTS[3]}"
        raise FileError(path, reason, where=f"byte {16 * row + 12}", remedy=remedy)


def _is_evident(rows: NDArray[np.float32]) -> bool:
    """True if only KITTI's layout fits the size, or its columns explain more variance than those of each other."""
    values = rows.ravel()
    others = [width for width in COLUMN_LAYOUTS if width % 4 and values.size % width == 0]
    if not others or not len(values):
        return True
    best_other = max(float(_explained(values, width).max()) for width in others)
    return float(_explained(values, 4).max()) > best_other + PERIOD_MARGIN


def _warn_of_layout(path: FilePath, size: int) -> None:
    fitting = ", ".join(layout for width, layout in COLUMN_LAYOUTS.items() if width != 4 and not size % (4 * width))
    message = (
        f"{path}: assumed {COLUMN_LAYOUTS[4]}, but the numbers do not show it, and the size also fits {fitting}. "
        "Give columns= with the names of all columns."
    )
    warnings.warn(escaped(message), UserWarning, stacklevel=5)


def _check_layout(path: FilePath, rows: NDArray[np.float32]) -> None:
    """Raise `FileError` if the numbers repeat with another period than four.
    In the right layout the column explains a part of the variance. For any other number of columns it explains no more
    than that."""
    if len(rows) < MIN_POINTS:
        return
    values = rows.ravel()
    explained = {
        width: _explained(values, width) for width in COLUMN_LAYOUTS if values.size % width == 0 and width != 8
    }
    gains = {width: float((part - explained[4]).max()) for width, part in explained.items()}
    max_gain = max(gains.values())
    width = min(period for period, gain in gains.items() if gain >= 0.9 * max_gain)  # multiples explain as much
    if gains[width] <= PERIOD_MARGIN:
        if values.size % 8 or not _has_integer_column(values.reshape(-1, 8)[:SAMPLE_NUMBERS]):
            return
        width = 8
    raise FileError(
        path,
        f"is not a scan of float32 x, y, z, intensity: its numbers repeat every {width}",
        remedy=f"Give columns= with the names of all {width}, such as {COLUMN_LAYOUTS[width]}",
    )


def _explained(values: NDArray[np.float32], width: int) -> NDArray[np.float64]:
    """Fraction of variance explained by the column: of magnitude, sign and integrality."""
    rows = np.nan_to_num(values[:SAMPLE_NUMBERS].astype(np.float64), posinf=0, neginf=0).reshape(-1, width)
    features = np.stack([np.log1p(np.abs(rows)), rows < 0, rows == np.floor(rows)])
    total = features.var(axis=(1, 2))
    between = features.mean(axis=1).var(axis=1)
    return np.divide(between, total, out=np.zeros(3), where=total > 1e-12)


def _has_integer_column(rows: NDArray[np.float32]) -> bool:
    """True if, of 8 columns, one of columns 4 to 6 has only integers in 0..255 and columns 0 to 2 have other values."""
    with np.errstate(invalid="ignore"):
        is_integer = (rows == np.floor(rows)) & (rows >= 0) & (rows <= 255)
    varies = (rows != rows[0]).any(axis=0)
    return bool((is_integer & varies).all(axis=0)[4:7].any() and not is_integer.all(axis=0)[:3].any())
