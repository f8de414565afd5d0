"""Rows of equal length in a file, as columns that are read when they are needed."""

from __future__ import annotations

import io
import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any, NamedTuple, cast

import numpy as np
from numpy.typing import NDArray

from ..core.errors import FileError
from .npy_header import MAX_HEADER_BYTES, read_npy_header
from .optional_imports import foreign_errors
from .source import SourceFile
from .table import PointTable

# [B] read at a time. 190 MB of PLY take 0.42 s of CPU with 64 kB, 0.23 s with 512 kB, 0.20 s with 4 to 16 MB and 0.23 s
# at once, which needs twice the memory (2026-11-27).
_BLOCK_BYTES = 1 << 23


NO_TABLE: Any = PointTable(cast(Any, None))  # given where a table has to be allocated


class Column(NamedTuple):
    """The position of a column: `offset` in a row [B], and `width` values of a type."""

    dtype: np.dtype[Any]
    offset: int
    width: int = 1


class FixedRows:
    """`count` rows of `row_bytes` from byte `begin` of a file, which must be long enough."""

    def __init__(self, source: SourceFile, begin: int, count: int, row_bytes: int, columns: dict[str, Column]):
        self._source, self._begin, self._row_bytes, self._columns = source, begin, row_bytes, columns
        self.count = count

    def columns(self, rows: slice = slice(None), buffer: NDArray[np.uint8] | None = None) -> dict[str, NDArray[Any]]:
        """Read some rows: views (n,) or (n, width) by name, in the file's byte order, of new memory or of a buffer."""
        first, end, step = rows.indices(self.count)
        count, begin = max(end - first, 0), self._begin + first * self._row_bytes
        if not count:
            return {name: np.empty(_shape(0, column), column.dtype) for name, column in self._columns.items()}
        if step != 1:
            data = self._source.every(step, np.dtype((np.void, self._row_bytes)), count, begin)
        else:
            size = count * self._row_bytes
            data = np.empty(size, np.uint8) if buffer is None else buffer[:size]
            self._source.read_into(data, begin)
            data = data.view(np.dtype((np.void, self._row_bytes)))
        return {
            name: np.ndarray(
                _shape(len(data), column),
                column.dtype,
                data,
                column.offset,
                (self._row_bytes, column.dtype.itemsize)[: 1 + (column.width > 1)],
            )
            for name, column in self._columns.items()
        }

    def table(self, table_of: Callable[[Mapping[str, NDArray[Any]], PointTable | None], PointTable]) -> PointTable:
        """Read all rows by block; `table_of` writes the table of some rows into parts of the result."""
        size = max(_BLOCK_BYTES // max(self._row_bytes, 1), 1)
        if self.count <= size:
            return table_of(self.columns(), None)
        result = _stretched(table_of(self.columns(slice(0)), None), self.count)
        buffer = np.empty(min(size, self.count) * self._row_bytes, np.uint8)
        for begin in range(0, self.count, size):
            rows = slice(begin, min(begin + size, self.count))
            table_of(self.columns(rows, buffer), _part(result, rows))
        return result


class StoredArray:
    """An array of a .npy file, whose rows are read when they are used: `len`, rows and slices as of an array.

    Args:
        source: The file.
        begin: The byte where the array's header begins.
        kinds: Allowed kinds of values, as letters of NumPy. `FileError` is raised for others and for truncated arrays.
    """

    def __init__(self, source: SourceFile, begin: int = 0, kinds: str = "biuf"):
        stream = io.BytesIO(source[begin : begin + MAX_HEADER_BYTES])
        where = f"byte {begin}"
        with foreign_errors(source.path, f"the header of the array at {where} is damaged"):
            self.shape, is_by_columns, self.dtype = read_npy_header(stream)
        width = math.prod(self.shape[1:])
        if self.dtype.kind not in kinds or not self.shape or not width or (is_by_columns and len(self.shape) > 1):
            reason = f"expected rows of numbers, got an array of {self.dtype} {list(self.shape)}"
            raise FileError(source.path, reason, where=where)
        first, size = begin + stream.tell(), math.prod(self.shape) * self.dtype.itemsize
        if size > len(source) - first:
            reason = f"is truncated: an array of {self.dtype} {list(self.shape)} needs {size:,} bytes, "
            raise FileError(source.path, f"{reason}but has {max(len(source) - first, 0):,}", where=where)
        self.end, self._source, self._first = first + size, source, first
        self._row_bytes = width * self.dtype.itemsize
        self._rows = FixedRows(source, first, len(self), self._row_bytes, {"": Column(self.dtype, 0, width)})

    def __len__(self) -> int:
        return self.shape[0]

    def __getitem__(self, rows: int | slice) -> Any:
        if isinstance(rows, slice):
            return self._rows.columns(rows)[""].reshape(-1, *self.shape[1:])
        begin = self._first + range(len(self))[rows] * self._row_bytes
        row = self._source[begin : begin + self._row_bytes]  # from the window of the file, for binary searches
        return np.frombuffer(row, self.dtype).reshape(self.shape[1:])[()]


def _stretched(table: PointTable, count: int) -> PointTable:
    """An uninitialized table of `count` rows with the types of a table."""

    def stretched(values: NDArray[Any] | None) -> NDArray[Any] | None:
        return None if values is None else np.empty((count, *values.shape[1:]), values.dtype)

    return _changed(table, stretched)


def _part(table: PointTable, rows: slice) -> PointTable:
    return _changed(table, lambda values: None if values is None else values[rows])


def _changed(table: PointTable, change: Callable[[Any], Any]) -> PointTable:
    attributes = {name: change(values) for name, values in table.attributes.items()}
    return replace(
        table,
        points=change(table.points),
        normals=change(table.normals),
        colors=change(table.colors),
        attributes=attributes,
    )


def _shape(count: int, column: Column) -> tuple[int, ...]:
    return (count, column.width) if column.width > 1 else (count,)
