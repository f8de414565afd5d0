"""Untrusted SQLite files: only real tables are read, in bounded time, without running code of the file."""

from __future__ import annotations

import bisect
import functools
import itertools
import os
import re
import sqlite3
import struct
from collections.abc import Collection, Iterator
from pathlib import Path
from typing import Any

from .errors import FileError

_CHECK_STEPS = 10_000  # SQLite VM instructions between two checks
_STEPS_PER_BYTE = 20  # steps per byte of a file: a query that needs more rereads pages
_INNER, _LEAF = 5, 13  # kinds of pages of a table
_MAX_DEPTH = 20  # of the tree of a table, in SQLite
_PLAIN = re.compile(r"\s*CREATE\s+(TABLE|(UNIQUE\s+)?INDEX)\b", re.IGNORECASE)
_PLAIN_TABLE = re.compile(r"\s*CREATE\s+TABLE\b", re.IGNORECASE)


def protect(base: sqlite3.Connection, path: str | os.PathLike[str], *, is_bounded: bool = False) -> None:
    """Forbid schema functions with side effects, and bound value sizes and query time.
    `is_bounded` bounds all queries together by the file size, for files that are read once."""
    base.execute("PRAGMA trusted_schema = OFF")
    base.execute("PRAGMA cell_size_check = ON")
    if is_bounded:
        size = max(1 << 20, Path(path).stat().st_size)
        base.setlimit(sqlite3.SQLITE_LIMIT_LENGTH, min(size, 2**31 - 1))
        # Ctrl-C could interrupt a Python function, which SQLite would hide.
        base.set_progress_handler(
            itertools.repeat(0, 1000 + size * _STEPS_PER_BYTE // _CHECK_STEPS).__next__, _CHECK_STEPS
        )


def check_tables(base: sqlite3.Connection, path: str | os.PathLike[str], names: Collection[str]) -> None:
    """Raise `FileError` if names are views, virtual tables, missing, or have computed columns."""
    for name in names:
        rows = base.execute(
            "SELECT type, sql FROM sqlite_master WHERE name = ? COLLATE NOCASE LIMIT 2", (name,)
        ).fetchall()
        is_plain = len(rows) == 1 and rows[0][0] == "table" and _PLAIN_TABLE.match(str(rows[0][1])) is not None
        if sqlite3.sqlite_version_info >= (3, 37):  # the type determined by SQLite
            kinds = base.execute(f"PRAGMA main.table_list({name})").fetchall()
            is_plain &= [row[2] for row in kinds] == ["table"]
        if not is_plain:
            reason = f"expected one table named {name}, got {'no such table' if not rows else 'a view or similar'}"
            raise FileError(path, reason, remedy="Record or copy the file again")
        if any(row[6] for row in base.execute(f"PRAGMA main.table_xinfo({name})")):
            raise FileError(path, f"table {name} has computed columns", remedy="Record or copy the file again")


def check_no_code(base: sqlite3.Connection, path: str | os.PathLike[str], *, remedy: str) -> None:
    """Raise `FileError` if a file has views, triggers or virtual tables, or ends within a page."""
    for kind, name, sql in base.execute("SELECT type, name, sql FROM sqlite_master"):
        if kind not in ("table", "index") or (sql is not None and not _PLAIN.match(sql)):
            raise FileError(path, f"contains a view, trigger or virtual table: {str(name)[:60]!r}", remedy=remedy)
    size, page_size = Path(path).stat().st_size, base.execute("PRAGMA page_size").fetchone()[0]
    if size % page_size:  # SQLite would fill it up with zeros
        reason = f"is cut off: it has {size} bytes, which are not complete pages of {page_size}"
        raise FileError(path, reason, remedy=remedy)


class CutPage:
    """The last page of a file that ends within it. SQLite fills it up with zeros, and reports no error.

    SQLite database file format, section 1.6: a table is a tree of pages, and a long row continues on overflow pages.
    """

    def __init__(self, base: sqlite3.Connection, source: Any, tables: Collection[str]):
        self._source, self._size = source, base.execute("PRAGMA page_size").fetchone()[0]
        self._usable = self._size - source[20:21][0]  # without the bytes reserved at the end of each page
        self.bytes = len(source) % self._size  # 0 if the page is complete
        self._number = len(source) // self._size + 1 if self.bytes else None
        query = "SELECT rootpage FROM sqlite_master WHERE name = ? COLLATE NOCASE"
        self._roots = {table: base.execute(query, (table,)).fetchone()[0] for table in tables} if self.bytes else {}
        self._page = functools.lru_cache(_MAX_DEPTH + 1)(self._parse)

    def contains(self, table: str, row: int, *, beginning: bool = False) -> bool:
        """True if a missing part of the page belongs to a row, or the row is not found. `beginning`: except for its
        overflow pages."""
        if not self.bytes:
            return False
        try:
            page, rest = self._overflow_of(self._roots[table], row)
            while rest > 0 and not beginning:
                if self._is_cut(page, 4 + min(rest, self._usable - 4)):
                    return True
                (page,) = struct.unpack(">I", self._slice(page, 4))
                rest -= self._usable - 4
        except (IndexError, struct.error):
            return True
        return False

    def _overflow_of(self, page: int, row: int) -> tuple[int, int]:
        """First overflow page of a row below a page, and the number of bytes on such pages. IndexError if there is no
        such row, or its beginning is cut off."""
        for _ in range(_MAX_DEPTH):
            is_leaf, cells = self._page(page)
            key, below, rest, end = cells[bisect.bisect_left(cells, (row,))]
            if self._is_cut(page, end) or (is_leaf and key != row):
                break
            if is_leaf:
                return below, rest
            page = below
        raise IndexError("no such row")

    def _is_cut(self, page: int, end: int) -> bool:
        return page == self._number and end > self.bytes

    def _slice(self, page: int, count: int) -> bytes:
        begin = (page - 1) * self._size
        return self._source[begin : begin + count] if page > 0 else b""

    def _parse(self, number: int) -> tuple[bool, list[tuple[int, int, int, int]]]:
        """True for a leaf, and the cells of a page. Of a leaf: the row, its first overflow page, the number of bytes on
        such pages, and the end of the cell in the page. Of an inner page: the last row below it, and the page below."""
        data, begin = self._slice(number, self._size).ljust(self._size, b"\0"), 100 if number == 1 else 0
        kind, count, right = struct.unpack_from(">B2xH3xI", data, begin)
        cells, first = [], begin + (12 if kind == _INNER else 8)
        if kind not in (_INNER, _LEAF) or self._is_cut(number, first + 2 * count):
            raise IndexError("not a complete page of a table")
        for (at,) in struct.iter_unpack(">H", data[first : first + 2 * count]):
            if kind == _INNER:
                cells.append((_varint(data, at + 4)[0], struct.unpack_from(">I", data, at)[0], 0, self._size))
                continue
            length, at = _varint(data, at)
            row, at = _varint(data, at)
            end = at + _local_bytes(length, self._usable)
            rest = length - (end - at)
            cells.append((row, struct.unpack_from(">I", data, end)[0] if rest else 0, rest, end + 4 * (rest > 0)))
        return kind == _LEAF, cells if kind == _LEAF else [*cells, (2**63, right, 0, self._size)]


def _local_bytes(length: int, usable: int) -> int:
    """The bytes of a row of this length that are stored in its leaf."""
    shortest = (usable - 12) * 32 // 255 - 23
    local = shortest + (length - shortest) % (usable - 4)
    return length if length <= usable - 35 else local if local <= usable - 35 else shortest


def _varint(data: bytes, at: int) -> tuple[int, int]:
    """A signed number of 1 to 9 bytes, and the position after it."""
    value, end = 0, at
    while end < at + 8 and data[end] >= 128:
        value, end = value << 7 | data[end] & 127, end + 1
    value = value << 8 | data[end] if end == at + 8 else value << 7 | data[end]
    return value - (value >> 63 << 64), end + 1


def ascending(path: str | os.PathLike[str], rows: Iterator[tuple[Any, ...]]) -> Iterator[tuple[Any, ...]]:
    """Yield rows with ascending ids. Raises `FileError` otherwise: a page of a damaged file is read twice."""
    last: int | None = None
    for row in rows:
        if last is not None and row[0] <= last:
            raise FileError(path, "damaged: rows are out of order", where=f"row {row[0]}")
        last = row[0]
        yield row
