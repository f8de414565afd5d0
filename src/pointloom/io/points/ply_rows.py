"""The PLY payload: rows of each element as columns, with every byte or line checked.

Constant-length rows are strided views of memory that was read at once. Other binary rows are scanned once for their
offsets (about 0.2 us a row) and gathered with NumPy. Variable-length text rows are parsed by column.
"""

from __future__ import annotations

from array import array
from collections.abc import Callable
from dataclasses import dataclass
from struct import Struct
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.errors import FileError, FilePath
from ..ascii_rows import AsciiRows
from ..fixed_rows import Column as FixedColumn
from ..fixed_rows import FixedRows
from ..source import SourceFile, check_end
from .ply_header import Element, PlyHeader, Property


@dataclass(frozen=True)
class ListColumn:
    """A list property: list lengths (n,) and concatenated entries."""

    lengths: NDArray[np.int64]
    values: NDArray[Any]


Column = NDArray[Any] | ListColumn
Wanted = Callable[[Element, Property], bool]


def read_rows(path: FilePath, source: SourceFile, header: PlyHeader, wanted: Wanted) -> dict[str, dict[str, Column]]:
    """Decode the wanted properties and check the extent of all others.
    Returns columns by property name by element name, possibly views in the file's byte order."""
    rows = _TextRows(path, source, header) if header.ascii else _BinaryRows(path, source, header)
    columns = {element.name: rows.read(element, wanted) for element in header.elements}
    rows.finish()
    return columns


def find_rows(path: FilePath, source: SourceFile, header: PlyHeader, name: str) -> FixedRows:
    """The rows of a binary element without lists, after checking the extent of all elements."""
    rows = _BinaryRows(path, source, header)
    found = [rows.fixed(element) if element.name == name else rows.skip(element) for element in header.elements]
    rows.finish()
    return next(element_rows for element_rows in found if element_rows is not None)


class _BinaryRows:
    def __init__(self, path: FilePath, source: SourceFile, header: PlyHeader):
        self._path, self._source, self._offset = path, source, header.size
        self._begin, self._rest = 0, np.empty(0, np.uint8)  # the file from the first element with lists

    def skip(self, element: Element) -> None:
        self.read(element, lambda element, prop: False)

    def fixed(self, element: Element) -> FixedRows:
        """The rows of an element without lists."""
        self._check_size(element)
        columns, at = {}, 0
        for prop in element.properties:
            columns[prop.name] = FixedColumn(prop.dtype, at)
            at += prop.dtype.itemsize
        rows = FixedRows(self._source, self._offset, element.count if at else 0, at, columns)
        self._offset += element.count * at
        return rows

    def _check_size(self, element: Element) -> int:
        """Bytes that the rows of an element need, at least."""
        available = len(self._source) - self._offset
        needed = element.count * element.min_row_bytes
        if needed > available:
            qualifier = "at least " if element.has_lists else ""
            raise FileError(
                self._path,
                f"truncated: {element.count} rows of element {element.name!r} need {qualifier}{needed} bytes, "
                f"{available} are left ({needed - available} missing)",
                where=f"byte {len(self._source)}",
            )
        return needed

    def read(self, element: Element, wanted: Wanted) -> dict[str, Column]:
        if self._check_size(element) == 0:
            return {prop.name: _empty(prop) for prop in element.properties if wanted(element, prop)}
        if not element.has_lists:
            names = {prop.name for prop in element.properties if wanted(element, prop)}
            rows = self.fixed(element)
            return {name: column for name, column in rows.columns().items() if name in names} if names else {}
        if not len(self._rest):
            self._begin = self._offset
            self._rest = self._source.array(np.uint8, len(self._source) - self._begin, self._begin)
        lengths = self._equal_lengths(element)
        if lengths is None:
            return self._gather(element, wanted)
        return self._view(element, lengths, wanted)

    def finish(self) -> None:
        check_end(self._path, self._source, self._offset)

    def _strided(
        self, offset: int, dtype: np.dtype[Any], shape: tuple[int, ...], strides: tuple[int, ...]
    ) -> NDArray[Any]:
        return np.ndarray(shape, dtype, self._rest, offset - self._begin, strides)

    def _equal_lengths(self, element: Element) -> dict[str, int] | None:
        lengths: dict[str, int] = {}
        counts: list[tuple[Property, int]] = []
        at = self._offset
        for prop in element.properties:
            if prop.count_type is None:
                at += prop.dtype.itemsize
                continue
            if at + prop.count_type.itemsize > len(self._source):
                return None
            counts.append((prop, at))
            length = int(self._strided(at, prop.count_type, (1,), (1,))[0])
            at += prop.count_type.itemsize + max(length, 0) * prop.dtype.itemsize
            lengths[prop.name] = length
        row_bytes = at - self._offset
        if self._offset + row_bytes * element.count > len(self._source) or min(lengths.values(), default=0) < 0:
            return None
        for prop, begin in counts:
            assert prop.count_type is not None
            column = self._strided(begin, prop.count_type, (element.count,), (row_bytes,))
            if (column != lengths[prop.name]).any():
                return None
        return lengths

    def _view(self, element: Element, lengths: dict[str, int], wanted: Wanted) -> dict[str, Column]:
        row_bytes = element.min_row_bytes + sum(
            lengths[prop.name] * prop.dtype.itemsize for prop in element.properties if prop.count_type is not None
        )
        columns: dict[str, Column] = {}
        at = self._offset
        for prop in element.properties:
            size = prop.dtype.itemsize
            if prop.count_type is None:
                if wanted(element, prop):
                    columns[prop.name] = self._strided(at, prop.dtype, (element.count,), (row_bytes,))
                at += size
                continue
            at += prop.count_type.itemsize
            length = lengths[prop.name]
            if wanted(element, prop):
                entries = self._strided(at, prop.dtype, (element.count, length), (row_bytes, size))
                columns[prop.name] = ListColumn(np.full(element.count, length, np.int64), entries.reshape(-1))
            at += length * size
        self._offset += row_bytes * element.count
        return columns

    def _gather(self, element: Element, wanted: Wanted) -> dict[str, Column]:
        at, self._offset = self._row_starts(element)
        columns: dict[str, Column] = {}
        for prop in element.properties:
            size = prop.dtype.itemsize
            if prop.count_type is None:
                if wanted(element, prop):
                    columns[prop.name] = self._pick(at, prop.dtype)
                at = at + size
                continue
            lengths = self._pick(at, prop.count_type).astype(np.int64)
            at = at + prop.count_type.itemsize
            if wanted(element, prop):
                columns[prop.name] = ListColumn(lengths, self._pick(_spread(at, lengths, size), prop.dtype))
            at = at + lengths * size
        return columns

    def _pick(self, offsets: NDArray[np.int64], dtype: np.dtype[Any]) -> NDArray[Any]:
        return self._rest[(offsets - self._begin)[:, None] + np.arange(dtype.itemsize)].view(dtype)[:, 0]

    def _row_starts(self, element: Element) -> tuple[NDArray[np.int64], int]:
        steps: list[tuple[int, Callable[..., tuple[Any, ...]], int, int]] = []
        skip = 0
        for prop in element.properties:
            if prop.count_type is None:
                skip += prop.dtype.itemsize
            else:
                count = prop.count_type
                code = (">" if count.byteorder == ">" else "<") + _STRUCT_CODES[f"{count.kind}{count.itemsize}"]
                steps.append((skip, Struct(code).unpack_from, count.itemsize, prop.dtype.itemsize))
                skip = 0
        rest, first, end, at = self._rest.data, self._begin, len(self._source), self._offset
        starts = array("q")  # grows with the rows that were found
        for row in range(element.count):
            starts.append(at)
            for before, unpack, count_bytes, entry_bytes in steps:
                at += before
                if at + count_bytes > end:
                    raise self._cut(element, row)
                (length,) = unpack(rest, at - first)
                if length < 0:
                    raise FileError(
                        self._path,
                        f"a list of element {element.name!r} has the length {length}",
                        where=f"row {row}, byte {at}",
                    )
                at += count_bytes + length * entry_bytes
            at += skip
            if at > end:
                raise self._cut(element, row)
        return np.frombuffer(starts, np.int64), at

    def _cut(self, element: Element, row: int) -> FileError:
        return FileError(
            self._path,
            f"truncated: row {row} of {element.count} of element {element.name!r} reaches beyond the end of the file",
            where=f"byte {len(self._source)}",
        )


_STRUCT_CODES = {"i1": "b", "u1": "B", "i2": "h", "u2": "H", "i4": "i", "u4": "I"}


class _TextRows:
    def __init__(self, path: FilePath, source: SourceFile, header: PlyHeader):
        self._path = path
        self._rows = AsciiRows(path, bytes(source[header.size :]), header.line_count + 1)
        self._next = 0
        for element in header.elements:  # fast, and before any parsing
            if element.properties:
                self._claim(element)
        self.finish()
        self._next = 0
        self._values = self._rows.numbers()

    def read(self, element: Element, wanted: Wanted) -> dict[str, Column]:
        if not element.properties or not element.count:
            return {prop.name: _empty(prop) for prop in element.properties if wanted(element, prop)}
        begin = self._claim(element)
        if element.has_lists:
            return self._parse_lists(element, begin, wanted)
        width = len(element.properties)
        self._rows.check_width(begin, begin + element.count, width)
        first = self._rows.first[begin]
        table = self._values[first : first + element.count * width].reshape(-1, width)
        return {
            prop.name: self._rows.cast(table[:, k], prop.dtype, f"{element.name} {prop.name}", begin)
            for k, prop in enumerate(element.properties)
            if wanted(element, prop)
        }

    def finish(self) -> None:
        if self._next < self._rows.row_count:
            raise FileError(
                self._path,
                f"{self._rows.row_count - self._next} lines follow the declared payload",
                where=self._rows.where(self._next),
                remedy="The counts in the header are too small, or the file was damaged",
            )

    def _claim(self, element: Element) -> int:
        begin, left = self._next, self._rows.row_count - self._next
        if element.count > left:
            raise FileError(
                self._path,
                f"truncated: element {element.name!r} has {left} of {element.count} rows",
                where=self._rows.where(self._rows.row_count),
            )
        self._next += element.count
        return begin

    def _parse_lists(self, element: Element, begin: int, wanted: Wanted) -> dict[str, Column]:
        """Parse rows with lists, one property at a time for all rows."""
        rows = slice(begin, begin + element.count)
        at, end = self._rows.first[rows].copy(), self._rows.first[1:][rows]
        columns: dict[str, Column] = {}
        lists = [k for k, prop in enumerate(element.properties) if prop.count_type is not None]
        for k, prop in enumerate(element.properties):
            what = f"{element.name} {prop.name}"
            if element.name == "face" and k == lists[-1] + 1 and self._are_undeclared_lists(at, end):
                return columns
            self._require(at < end, begin, "the line ends too early")
            head = self._values[at]
            at += 1
            if prop.count_type is None:
                if wanted(element, prop):
                    columns[prop.name] = self._rows.cast(head, prop.dtype, what, begin)
                continue
            lengths = self._rows.cast(head, prop.count_type, f"length of {what}", begin).astype(np.int64)
            self._require(lengths >= 0, begin, f"negative length of {what}")
            self._require(lengths <= end - at, begin, "the line ends too early")
            if wanted(element, prop):
                values = self._values[_spread(at, lengths, 1)]
                row_of = np.repeat(np.arange(begin, begin + element.count), lengths)
                columns[prop.name] = ListColumn(lengths, self._rows.cast(values, prop.dtype, what, row_of))
            at += lengths
        self._require(at == end, begin, "the line has more values than declared")
        return columns

    def _are_undeclared_lists(self, at: NDArray[np.int64], end: NDArray[np.int64]) -> bool:
        """True if the rest of each row is a list although scalars are declared.
        VCGlib writes colors of corners this way: nine values after their count where the header declares red to alpha.
        """
        sizes = end - at - 1
        return bool((sizes > 4).all() and (self._values[np.minimum(at, len(self._values) - 1)] == sizes).all())

    def _require(self, good: NDArray[np.bool_], begin: int, reason: str) -> None:
        if not good.all():
            raise FileError(self._path, reason, where=self._rows.where(begin + int(np.flatnonzero(~good)[0])))


def _empty(prop: Property) -> Column:
    values = np.empty(0, prop.dtype)
    return values if prop.count_type is None else ListColumn(np.empty(0, np.int64), values)


def _spread(starts: NDArray[np.int64], lengths: NDArray[np.int64], step: int) -> NDArray[np.int64]:
    ends = np.cumsum(lengths)
    within = np.arange(ends[-1] if len(ends) else 0) - np.repeat(ends - lengths, lengths)
    return np.repeat(starts, lengths) + within * step
