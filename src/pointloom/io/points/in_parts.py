"""Read point files in parts, for clouds larger than memory: binary PLY and PCD, LAS and LAZ.

Files are validated first. Text, compressed PCD and rows of variable length must be read whole.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.coordinate_systems import CoordinateSystem
from ...core.coordinates import choose_origin
from ...core.errors import FilePath
from ...core.paths import path_of
from ...core.units import LengthUnit
from ..fixed_rows import FixedRows
from ..source import open_source
from ..table import PointTable
from . import pcd, ply
from .header_units import PCD, PLY, reference_in_header
from .las import LasFile, iterate_las, open_las
from .las_units import units_of
from .pcd_header import read_header as read_pcd_header
from .ply_header import read_header as read_ply_header
from .ply_rows import find_rows

_SAMPLE_POINTS = 4096  # sample size of the median for the origin


class RowsInParts:
    """Fixed-length rows of a file; `table_of` builds a table from a path and some rows.
    `is_proven` is True if the file is large enough for `count` points."""

    is_proven = True

    def __init__(
        self,
        path: Path,
        rows: FixedRows,
        table_of: Callable[[Path, Mapping[str, NDArray[Any]]], PointTable],
        reference: tuple[LengthUnit | None, CoordinateSystem | None],
    ):
        self.path, self.count, self._rows, self._table_of = path, rows.count, rows, table_of
        self.unit, self.crs = reference
        table_of(path, rows.columns(slice(0)))  # raises an error if columns are missing

    def parts(self, size: int) -> Iterator[PointTable]:
        """Yield `size` points at a time. One empty part if there are none."""
        for begin in range(0, max(self.count, 1), size):
            yield self._table(slice(begin, begin + size))

    def sample(self, count: int) -> PointTable:
        """At most `count` points, evenly spaced."""
        return self._table(slice(None, None, -(-self.count // count) or 1))

    def origin(self) -> NDArray[np.float64]:
        return choose_origin(self.sample(_SAMPLE_POINTS).points)

    def _table(self, rows: slice) -> PointTable:
        table = self._table_of(self.path, self._rows.columns(rows))
        table.unit, table.crs = self.unit, self.crs
        return table


class LasInParts:
    def __init__(self, file: LasFile):
        self.path, self.count, self._file = file.path, file.header.point_count, file
        self.is_proven, self.unit = not file.header.is_compressed, units_of(file.header).plane

    def parts(self, size: int) -> Iterator[PointTable]:
        yield from iterate_las(self._file, size)

    def sample(self, count: int) -> PointTable:
        """At most `count` points. Of a compressed file the first of its chunks."""
        return self._file.sample(count)

    def origin(self) -> NDArray[np.float64]:
        return choose_origin(self.sample(_SAMPLE_POINTS).points, np.array(self._file.header.scales, np.float64))


def open_in_parts(path: FilePath) -> RowsInParts | LasInParts | None:
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
        rows = find_rows(path, source, header, "vertex")
        ply.warn_of_lost_values(path, header)
        return RowsInParts(path, rows, ply.table_of, reference_in_header(source, PLY))
    header = read_pcd_header(path, source)
    pcd.warn_of_viewpoint(path, header.viewpoint)
    if header.encoding != "binary":
        return None
    rows = pcd.point_rows(path, source, header)
    return RowsInParts(path, rows, pcd.table_of, reference_in_header(source, PCD))
