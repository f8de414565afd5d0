"""Write splats as SPZ version 3, which most readers support: one gzip stream (layout in spz.py)."""

from __future__ import annotations

import gzip
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.atomic import atomic_write
from ...core.errors import FileError, FilePath
from ...pcd.harmonics import signs_of_flip
from ...pcd.splats import fractions_of, unit_quaternions
from ..columns import warn_left_out
from ..table import PointTable
from .splat_rows import check_rounding, to_bytes
from .spz import AXIS_SIGNS, COLOR_SCALE, HEADER, SPZ_MAGIC, SpzHeader

_MAX_BITS = 12  # fractional bits: steps of 0.24 mm, up to 2 km
_SPZ_VERSION = 3


def write_spz(path: FilePath, table: PointTable, *, overwrite: bool = True) -> None:
    """Write splats deterministically. Raises `FileError` if 24 bits would round centers by more than 2 mm."""
    columns = table.attributes
    rest = columns.get("f_rest")
    degree = 0 if rest is None else round((rest.shape[1] / 3 + 1) ** 0.5) - 1
    bits = _fractional_bits(path, table.points)
    if len(table.points) > 0xFFFFFFFF:
        raise FileError(path, f"SPZ stores fewer than 2^32 splats, got {len(table.points):,}")
    header = SpzHeader(SPZ_MAGIC, _SPZ_VERSION, len(table.points), degree, bits, 0, 0)
    rotations = np.roll(unit_quaternions(columns["rot"]), -1, axis=1) * [*AXIS_SIGNS, 1.0]
    parts = [
        _three_bytes(np.rint(table.points.astype(np.float64) * AXIS_SIGNS * 2.0**bits).astype(np.int32)),
        to_bytes(fractions_of(columns["opacity"]) * 255),
        to_bytes((columns["f_dc"].astype(np.float64) * COLOR_SCALE + 0.5) * 255),
        to_bytes((np.maximum(columns["scale"].astype(np.float64), -10.0) + 10) * 16),
        _smallest_three(rotations),
    ]
    if rest is not None:
        parts.append(_harmonics(rest, degree))
    with (
        atomic_write(path, overwrite=overwrite) as file,
        gzip.GzipFile(filename="", mode="wb", fileobj=file, compresslevel=6, mtime=0) as stream,
    ):
        stream.write(HEADER.pack(*header))
        for part in parts:
            stream.write(part.tobytes())
    spare = [name for name in columns if name not in ("f_dc", "f_rest", "opacity", "scale", "rot")]
    warn_left_out(path, ".spz", spare, stacklevel=3)


def _fractional_bits(path: FilePath, points: NDArray[Any]) -> int:
    max_coordinate = float(np.abs(points).max(initial=0.0))
    bits = _MAX_BITS
    while bits > 0 and np.rint(max_coordinate * 2.0**bits) > 2**23 - 1:
        bits -= 1
    check_rounding(path, points, 0.5 / 2**bits if max_coordinate * 2.0**bits < 2**23 else np.inf)
    return bits


def _three_bytes(integers: NDArray[np.int32]) -> NDArray[np.uint8]:
    return np.ascontiguousarray(integers.reshape(-1, 1).astype("<i4").view(np.uint8).reshape(-1, 4)[:, :3])


def _smallest_three(rotations: NDArray[np.float64]) -> NDArray[np.uint32]:
    """Unit quaternions (x, y, z, w) without the largest component, 10 bits for each other."""
    largest = np.abs(rotations).argmax(axis=1)
    sign = np.where(rotations[np.arange(len(rotations)), largest] < 0, -1.0, 1.0)
    packed = largest.astype(np.int64)
    for part in range(4):
        given = np.flatnonzero(largest != part)
        values = (rotations[given, part] * sign[given]) * np.sqrt(2)
        bits = np.minimum(np.rint(np.abs(values) * 511), 511).astype(np.int64)
        packed[given] = packed[given] << 10 | (values < 0).astype(np.int64) << 9 | bits
    return packed.astype("<u4")


def _harmonics(rest: NDArray[Any], degree: int) -> NDArray[np.uint8]:
    """Bytes in steps of 1/16 for degree 1 and 1/8 beyond, red, green, blue per coefficient."""
    values = rest.reshape(len(rest), 3, -1).transpose(0, 2, 1) * signs_of_flip(AXIS_SIGNS, degree)[:, None]
    step = np.where(np.arange(values.shape[1]) < 3, 8, 16)[:, None]
    return np.clip(np.rint(values * 128 / step) * step + 128, 0, 255).astype(np.uint8)
