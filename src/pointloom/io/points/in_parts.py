"""Read point files in parts, for clouds larger than memory: binary PLY and PCD (memory-mapped), LAS and LAZ.

Files are validated first. Text, compressed PCD and rows of variable length must be read whole.
"""

from __future__ import annotations

import contextlib
import mmap
import os
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.coordinates import choose_origin
from ...core.paths import path_of
from ...core.units import LengthUnit
from ..source import Source, open_source
from ..table import PointTable
from . import pcd, ply
from .header_units import PCD, PLY, unit_in_header
from .las import LasFile, iterate_las, open_las
from .las_units import units_of
from .pcd_header import read_header as read_pcd_header
from .ply_header import read_header as read_ply_header

_SAMPLE = 4096  # sample size of the median for the origin


class RowsInParts:
    """Fixed-length rows of a mapped file, from views (`columns`); `table_of` builds a table from a path and some rows.
    `is_proven` is True if the file is large enough for `count` points."""

    is_proven = True

    def __init__(
        self,
        path: Path,
        source: Source,
        columns: dict[str, NDArray[Any]],
        table_of: Callable[[Path, dict[str, NDArray[Any]]], PointTable],
        unit: LengthUnit | None,
    ):
        self.path, self.count = path, len(next(iter(columns.values())))
        self._source, self._columns, self._table_of, self.unit = source, columns, table_of, unit

    def parts(self, size: int) -> Iterator[PointTable]:
        """Yield `size` points at a time. One empty part if there are none."""
        for begin in range(0, max(self.count, 1), size):
            yield self._rows(slice(begin, begin + size))

    def sample(self, count: int) -> PointTable:
        """At most `count` points, evenly spaced."""
        return self._rows(slice(None, None, -(-self.count // count) or 1))

    def origin(self) -> NDArray[np.float64]:
        return choose_origin(self.sample(_SAMPLE).points)

    def _rows(self, rows: slice) -> PointTable:
        table = self._table_of(self.path, {name: column[rows] for name, column in self._columns.items()})
        table.unit = self.unit
        _give_back(self._source)
        return table


class LasInParts:
    def __init__(self, file: LasFile):
        self.path, self.count, self._file = file.path, file.header.point_count, file
        self.is_proven, self.unit = not file.header.is_compressed, units_of(file.header).plane

    def parts(self, size: int) -> Iterator[PointTable]:
        for part in iterate_las(self._file, size):
            yield part
            _give_back(self._file.source)

    def sample(self, count: int) -> PointTable:
        """At most `count` points. Of a compressed file the first of its chunks."""
        table = self._file.sample(count)
        _give_back(self._file.source)
        return table

    def origin(self) -> NDArray[np.float64]:
        return choose_origin(self.sample(_SAMPLE).points, np.array(self._file.header.scales, np.float64))


def open_in_parts(path: str | os.PathLike[str]) -> RowsInParts | LasInParts | None:
    """Open a file for reading in parts, without reading points. None if its format must be read whole."""
    path = path_of(path)
    suffix = path.suffix.lower()
    if suffix in (".las", ".laz"):
        return LasInParts(open_las(path))
    if suffix not in (".ply", ".pcd"):
        return None
    source = open_source(path)
    if suffix == ".ply":
        header = read_ply_header(path, source)
        if header.ascii or header.element(path, "vertex").has_lists:
            return None
        columns = _checked_columns(path, ply.vertex_columns(path, source))
        return RowsInParts(path, source, columns, ply.table_of, unit_in_header(source, PLY))
    header = read_pcd_header(path, source)
    pcd.warn_of_viewpoint(path, header.viewpoint)
    if header.encoding != "binary":
        return None
    fields = pcd.point_fields(path, source, header)
    return RowsInParts(path, source, fields, pcd.table_of, unit_in_header(source, PCD))


def _checked_columns(path: Path, columns: dict[str, NDArray[Any]]) -> dict[str, NDArray[Any]]:
    ply.table_of(path, {name: column[:0] for name, column in columns.items()})
    return columns


def _give_back(source: Source) -> None:
    """Release the pages of a mapped file that were read, which would count as used memory until it is closed."""
    if isinstance(source, mmap.mmap):
        with contextlib.suppress(AttributeError, OSError, ValueError):  # systems without this advice
            source.madvise(mmap.MADV_DONTNEED)
