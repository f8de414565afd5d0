"""Points as a table of text: .csv, .txt, .asc and .xyz, one point a line.

Values are parted by commas, by semicolons or by blanks, all of a file alike; the first line of values decides. Blank
lines and lines that begin with '#' are passed over. A line above the values with one whole number, as CloudCompare
writes it, is the number of points and has to be right. What a column means is never guessed:

- A first line of names says it, also behind '#' or '//': x y z, normals nx ny nz (normal_x ...), colours r g b
  (red ...), and any other name, which becomes an attribute. Case does not matter for these and for intensity.
- Without names three columns are x y z. More are refused: six may be normals or colours, the fourth an intensity or a
  time. Names in the file, the extensions .xyzn and .xyzrgb, or `columns` say which. (Open3D reads three and drops the
  rest.)

Colours are whole numbers in 0..255 or parts in 0..1, for the file as a whole; one that holds nothing but 0 and 1 could
be either and is refused unless it is black. Columns Rf, Gf and Bf (CloudCompare) are parts in 0..1. Text has no types:
positions and attributes are float64.
"""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_list, shown
from ...core.errors import FileError
from ..ascii_rows import AsciiRows, is_number, unix_lines
from ..columns import stack_colors, stack_normals
from ..source import open_source
from ..table import PointTable

SUFFIXES = (".xyz", ".csv", ".txt", ".asc")

POSITION, NORMAL, COLOR = ("x", "y", "z"), ("nx", "ny", "nz"), ("r", "g", "b")

_NAMED = {name: name for name in (*POSITION, *NORMAL, *COLOR, "intensity")}
_FRACTIONS = {"rf": "r", "gf": "g", "bf": "b"}  # CloudCompare's names of colours in 0..1
_NAMED |= _FRACTIONS
_NAMED |= {f"normal_{axis}": f"n{axis}" for axis in POSITION} | {"red": "r", "green": "g", "blue": "b"}

_COMMENT = re.compile(rb"^[ \t]*#[^\n]*", re.M)
_MOST_DIGITS = 19  # of a number of points
_PARTED = "Values are parted by commas, semicolons or blanks, decimals by points"


class _Head(NamedTuple):
    """What stands above the values.

    Attributes:
        names: Of the columns; None where the file has none.
        line: The line of the names, from 1.
        lines: How many lines the head takes.
        width: Columns.
        delimiter: Between the values: b",", b";", or None for blanks.
        declared: The number of points, where a line of the head tells it.
    """

    names: list[str] | None
    line: int
    lines: int
    width: int
    delimiter: bytes | None
    declared: int | None = None

    @property
    def full(self) -> float | None:
        """What a full colour is, where the names tell it."""
        return full_of(self.names or ())


def full_of(names: Sequence[str]) -> float | None:
    """What a full colour is, where the names of the columns tell it."""
    return 1.0 if any(name.strip().lower() in _FRACTIONS for name in names) else None


def read_text_table(path: str | os.PathLike[str], columns: Sequence[str] | None = None) -> PointTable:
    """Read a .csv, .txt, .asc or .xyz file.

    Args:
        path: The file.
        columns: What the columns are, in place of the names that the file may have.

    Returns:
        The points in float64, with the normals, colours and attributes that the names tell.

    Raises:
        FileError: Missing, a line with another number of values, a value that is missing or no number, columns whose
            meaning nothing tells, or names that contradict themselves; says where, and how to mend it.
        ValueError: `columns` without x, y and z, or with a name twice.
        TypeError: `columns` that are no names.
    """
    given = None if columns is None else check_columns(columns)
    path = Path(path)
    body = unix_lines(bytes(open_source(path)[:]).removeprefix(b"\xef\xbb\xbf"))
    head = read_head(path, body)
    rows, text = _rows_of(path, body, head)
    width = len(given) if given else head.width
    check_fields(path, rows, text, head.delimiter, head.lines + 1, width)
    names = given or names_of(path, head, width)
    values = rows.numbers().reshape(-1, width)
    if head.declared not in (None, len(values)):
        raise wrong_count(path, head.declared, len(values))
    full = head.full if columns is None else full_of(columns)
    return table_of(path, dict(zip(names, values.T, strict=True)), full)


def wrong_count(path: Any, declared: int | None, count: int) -> FileError:
    """The error of a file whose number of points is another than it declares."""
    reason = f"expected {declared} points, which a line above them declares, found {count}"
    return FileError(path, reason, remedy="It was cut off, or the number is wrong")


def check_columns(columns: Sequence[str]) -> list[str]:
    """The names of columns in the library's spelling.

    Raises:
        TypeError: No names.
        ValueError: x, y or z is missing, or a name occurs twice.
    """
    given = check_list("columns", columns, "names such as ['x', 'y', 'z']")
    if not all(isinstance(name, str) for name in given):
        raise TypeError(f"columns: expected names such as ['x', 'y', 'z'], got {shown(given)}")
    names = [_canonical(name) for name in given]
    if reason := _why_wrong(names):
        raise ValueError(f"columns: {reason}, got {given}")
    return names


def read_head(path: Path, body: bytes) -> _Head:
    """The names above the values, the number of points, and what parts the values."""
    comment, names, count, number = (b"", 0), None, None, 0
    for number, end, line in _lines(body):
        bare = line.strip()
        if bare.startswith((b"#", b"//")):
            comment = (bare.lstrip(b"#/"), number) if bare.lstrip(b"#/").strip() else comment
            continue
        if not bare:
            continue
        if bare[:5].lower() == b"ncols":
            remedy = "Convert it to a table, such as by gdal_translate -of XYZ"
            raise FileError(path, "is an Esri grid of heights, expected a table of points", remedy=remedy)
        delimiter = next((mark for mark in (b";", b",") if mark in bare), None)
        fields = _split(bare, delimiter)
        is_values = any(is_number(field) for field in fields if field) or not any(fields)
        if names is None and not is_values:
            words = bare.split(b"\t") if delimiter is None and b"\t" in bare else fields
            names = ([_plain(field) for field in words], number, delimiter)
        elif count is None and _is_count(fields) and _is_wider_below(body, end):
            count = int(fields[0])
        elif names is not None:
            return _Head(*names[:2], number - 1, len(names[0]), delimiter, count)
        else:
            told = _as_names(comment[0], delimiter, len(fields)) if comment[0] else None
            return _Head(told, comment[1], number - 1, len(fields), delimiter, count)
    if names is None:
        raise FileError(path, "holds no points")
    return _Head(*names[:2], number, len(names[0]), names[2], count)


def _is_count(fields: list[bytes]) -> bool:
    return len(fields) == 1 and fields[0].isdigit() and len(fields[0]) < _MOST_DIGITS


def _is_wider_below(body: bytes, end: int) -> bool:
    for _, _, line in _lines(body[end + 1 : end + 1 + (1 << 16)]):
        bare = line.strip()
        if bare and not bare.startswith(b"#"):
            return len(bare.replace(b";", b" ").replace(b",", b" ").split()) > 1
    return False


def _lines(body: bytes) -> Any:
    """Number, place of the end and text of each line, one by one: only the head is looked at."""
    begin, number = 0, 1
    while begin < len(body):
        end = body.find(b"\n", begin)
        end = len(body) if end < 0 else end
        yield number, end, body[begin:end]
        begin, number = end + 1, number + 1


def _split(line: bytes, delimiter: bytes | None) -> list[bytes]:
    return line.split() if delimiter is None else [field.strip() for field in line.split(delimiter)]


def _plain(field: bytes) -> str:
    return field.strip().decode("utf-8", "backslashreplace").strip("\"'").strip()


def _as_names(comment: bytes, delimiter: bytes | None, count: int) -> list[str] | None:
    """A comment as the names of the columns, where it is one: as many words as columns, with x, y and z."""
    for mark in (delimiter, None, b",", b";"):
        names = [_plain(field) for field in _split(comment, mark)]
        if len(names) == count and set(POSITION) <= {_canonical(name) for name in names}:
            return names
    return None


def _canonical(name: str) -> str:
    return _NAMED.get(name.strip().lower(), name.strip())


def names_of(path: Path, head: _Head, width: int) -> list[str]:
    """What each column is.

    Raises:
        FileError: Nothing tells, or the names contradict themselves.
    """
    if head.names is None:
        if width == 3:
            return [*POSITION]
        known = {4: "x y z intensity", 6: "x y z nx ny nz, or x y z r g b", 7: "x y z intensity r g b"}
        remedy = f"Add a first line of names, such as {known.get(width, 'x y z time')}; or give columns="
        if width == 6:
            remedy += "; without names, .xyzn holds normals and .xyzrgb colours in 0..1"
        raise FileError(path, f"has {width} columns, and nothing says what they are", remedy=remedy)
    names = [_canonical(name) for name in head.names]
    if reason := _why_wrong(names):
        remedy = "Correct the names, or give columns= in their place"
        raise FileError(
            path, f"{reason}; the columns are {', '.join(head.names)}"[:300], where=f"line {head.line}", remedy=remedy
        )
    return names


def _why_wrong(names: Sequence[str]) -> str:
    """Why columns cannot have these names; empty where they can."""
    if not all(names):
        return f"column {list(names).index('') + 1} has no name"
    twice = next((name for k, name in enumerate(names) if name in names[:k]), None)
    if twice is not None:
        return f"two columns are named {twice}"
    missing = [name for name in POSITION if name not in names]
    if missing:
        return f"no column is named {', '.join(missing)}"
    for what, triple in (("normals", NORMAL), ("colours", COLOR)):
        there = [name for name in triple if name in names]
        if 0 < len(there) < 3:
            return f"{what} need {', '.join(triple)}, and there is only {', '.join(there)}"
    return ""


def _rows_of(path: Path, body: bytes, head: _Head) -> tuple[AsciiRows, bytes]:
    begin = 0
    for _ in range(head.lines):
        begin = body.find(b"\n", begin) + 1 or len(body)
    text = body[begin:]
    text = without_comments(text)
    blank = text if head.delimiter is None else text.replace(head.delimiter, b" ")
    rows = AsciiRows(path, blank, head.lines + 1)
    if not rows.row_count:
        raise FileError(path, "holds no points")
    return rows, text


def without_comments(text: bytes) -> bytes:
    """A text with lines that begin with '#' left blank."""
    return _COMMENT.sub(b"", text) if b"#" in text else text


def check_fields(path: Path, rows: AsciiRows, text: bytes, delimiter: bytes | None, first: int, width: int) -> None:
    """Hold that each row of a text, whose first line has a number, has one value for each column.

    Raises:
        FileError: The first row that has not, with its line.
    """
    if delimiter is None:
        rows.check_width(0, rows.row_count, width)
        return
    marks = np.flatnonzero(np.frombuffer(text, np.uint8) == delimiter[0])
    if rows.is_parted_by(marks, width):
        return
    for number, line in enumerate(text.split(b"\n"), first):
        fields, where = _split(line, delimiter), f"line {number}"
        if not line.strip():
            continue
        if len(fields) != width:
            raise FileError(path, f"expected {width} values, found {len(fields)}", where=where, remedy=_PARTED)
        for column, field in enumerate(fields, 1):
            if not field:
                remedy = "Give it, as nan where it was not measured, or remove the line"
                raise FileError(path, f"column {column} has no value", where=where, remedy=remedy)
            if not is_number(field):
                shown = field[:40].decode("ascii", "backslashreplace")
                raise FileError(path, f"not a number: {shown!r}", where=where, remedy=_PARTED)
    raise FileError(path, f"expected {width} values in each line", remedy=_PARTED)


def table_of(path: Path, columns: dict[str, NDArray[Any]], full: float | None = None) -> PointTable:
    """The table of columns by their names; `full` is what a full colour is, 1 or 255, where that is known.

    Raises:
        FileError: Nothing tells what the colours are, or normals that are none.
    """

    def taken(names: tuple[str, ...]) -> list[NDArray[Any]]:
        return [columns.pop(name) for name in names if name in columns]

    points = np.ascontiguousarray(np.stack(taken(POSITION), axis=1))
    normals, colors = taken(NORMAL), taken(COLOR)
    return PointTable(
        points,
        stack_normals(path, normals) if normals else None,
        _colors_of(path, colors, full) if colors else None,
        {name: values.copy() for name, values in columns.items()},
    )


def _colors_of(path: Path, channels: list[NDArray[np.float64]], full: float | None) -> NDArray[np.float32]:
    """Colours, float32 [n, 3]; where nothing says what a full one is, by the range of their values.

    Raises:
        FileError: Out of both ranges, or in both.
    """
    if full is None:
        whole = all(bool((np.floor(channel) == channel).all()) for channel in channels)
        low, high = min(float(channel.min()) for channel in channels), max(float(channel.max()) for channel in channels)
        full = color_range(path, low, high, whole=whole)
    kind = np.uint8 if full == 255 else np.float32
    return stack_colors(path, [channel.astype(kind) for channel in channels])


def color_range(path: Path, low: float, high: float, *, whole: bool) -> float:
    """What a full colour is, 1 or 255, by the least and the largest value and whether all are whole.

    Raises:
        FileError: Out of both ranges, or in both.
    """
    if not whole or low < 0 or high > 255:
        if high > 1:
            reason = f"colours from {low:g} to {high:g} are neither parts in 0..1 nor whole numbers in 0..255"
            raise FileError(path, reason, remedy="Scale them to 0..1")
        return 1.0
    if high == 1:
        reason = "all colours are 0 or 1, which may be parts of 1 or of 255"
        raise FileError(path, reason, remedy="Write .xyzrgb for colours in 0..1, .pts for whole numbers in 0..255")
    return 255.0
