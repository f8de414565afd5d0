"""Untrusted SQLite files: only real tables are read, in bounded time, without running code of the file."""

from __future__ import annotations

import itertools
import os
import re
import sqlite3
from collections.abc import Collection, Iterator
from pathlib import Path
from typing import Any

from .errors import FileError

_CHECK_STEPS = 10_000  # SQLite VM instructions between two checks
_STEPS_PER_BYTE = 20  # steps per byte of a file: a query that needs more rereads pages
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
    for kind, name, sql in base.execute("SELECT type, name, sql FROM sqlite_master"):
        if kind not in ("table", "index") or (sql is not None and not _PLAIN.match(sql)):
            raise FileError(path, f"contains a view, trigger or virtual table: {str(name)[:60]!r}", remedy=remedy)


def ascending(path: str | os.PathLike[str], rows: Iterator[tuple[Any, ...]]) -> Iterator[tuple[Any, ...]]:
    """Yield rows with ascending ids. Raises `FileError` otherwise: a page of a damaged file is read twice."""
    last: int | None = None
    for row in rows:
        if last is not None and row[0] <= last:
            raise FileError(path, "damaged: rows are out of order", where=f"row {row[0]}")
        last = row[0]
        yield row
