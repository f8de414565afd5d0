"""Points as text tables, one point per line: .csv, .txt, .asc and .xyz, separated by commas, semicolons or blanks.

A header (also after '#' or '//') names the columns. Without one, only x y z are accepted. A first line with one integer
(CloudCompare) is the number of points. Colors are 0..255 or 0..1; ambiguous files raise. Values are float64.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...core.atomic import atomic_write, check_writable
from ...core.checks import check_list, shown
from ...core.errors import FileError, FilePath
from ..ascii_rows import AsciiRows, is_number, row_format, unix_lines, write_rows
from ..attribute_names import NameRules, split_columns
from ..columns import stack_colors, stack_normals
from ..source import open_source
from ..table import PointTable

SUFFIXES = (".xyz", ".csv", ".txt", ".asc")

POSITION, NORMAL, COLOR = ("x", "y", "z"), ("nx", "ny", "nz"), ("r", "g", "b")

_NAMED = {name: name for name in (*POSITION, *NORMAL, *COLOR, "intensity")}
_FRACTIONS = {"rf": "r", "gf": "g", "bf": "b"}  # CloudCompare's names of colors in 0..1
_NAMED |= _FRACTIONS
_NAMED |= {f"normal_{axis}": f"n{axis}" for axis in POSITION} | {"red": "r", "green": "g", "blue": "b"}

_COMMENT = re.compile(rb"^[ \t]*#[^\n]*", re.M)
_MAX_DIGITS = 19  # digits of a point count
_PARTED = "Values are separated by commas, semicolons or blanks, decimals by points"


class _Head(NamedTuple):
    """The header of a text table: column `names` on `line`, number of `lines`, `width`, `delimiter` (None: blanks).
    `declared` is the number of points, if given."""

    names: list[str] | None
    line: int
    lines: int
    width: int
    delimiter: bytes | None
    declared: int | None = None

    @property
    def full(self) -> float | None:
        return full_of(self.names or ())


def full_of(names: Sequence[str]) -> float | None:
    return 1.0 if any(name.strip().lower() in _FRACTIONS for name in names) else None


def read_text_table(path: FilePath, columns: Sequence[str] | None = None) -> PointTable:
    """Read a .csv, .txt, .asc or .xyz file; `columns` replaces the names in the file."""
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


def write_text_table(path: FilePath, table: PointTable, *, overwrite: bool = True) -> None:
    """Write a .csv (commas), .txt or .asc file (blanks) with a header of all columns, losslessly and atomically.

    Colors are named Rf, Gf, Bf as in CloudCompare: fractions in 0..1. An attribute (n, c) has the columns name_0, ...
    """
    path = check_writable(path, overwrite=overwrite)
    table = table.checked()
    if not len(table.points):
        raise FileError(path, "a text table cannot store a cloud without points", remedy="Write .ply")
    columns = dict(zip(POSITION, table.points.T, strict=True))
    for names, values in ((NORMAL, table.normals), (tuple(name.title() for name in _FRACTIONS), table.colors)):
        columns |= {} if values is None else dict(zip(names, values.T, strict=True))
    for name, values in table.attributes.items():
        columns |= split_columns(name, values)
    separator, values = "," if path.suffix.lower() == ".csv" else " ", [*columns.values()]
    with atomic_write(path, overwrite=overwrite) as file:
        file.write(f"{separator.join(columns)}\n".encode())
        write_rows(file, values, line=row_format(values).replace(" ", separator))


def name_rules(path: FilePath, table: PointTable) -> NameRules:
    """Attribute names that `read_text_table` reads unchanged."""
    has_blanks = Path(path).suffix.lower() == ".csv"
    changed = [
        name
        for name, values in table.attributes.items()
        if values.ndim == 1 and (_canonical(name) != name or is_number(name.encode("ascii", "replace")))
    ]

    def is_allowed(letter: str) -> bool:
        return letter.isprintable() and letter not in ",;\"'" and (letter == " ") <= has_blanks

    used = (*POSITION, *NORMAL, *COLOR)
    return NameRules(is_allowed, used, instead={name: f"{name.strip()}_value" for name in changed})


def wrong_count(path: FilePath, declared: int | None, count: int) -> FileError:
    reason = f"expected {declared} points, which a line above them declares, got {count}"
    return FileError(path, reason, remedy="It was cut off, or the number is wrong")


def check_columns(columns: Sequence[str]) -> list[str]:
    """Column names in the library's spelling. Raises `ValueError` if x, y or z is missing or a name is duplicated."""
    given = check_list("columns", columns, "names such as ['x', 'y', 'z']")
    if not all(isinstance(name, str) for name in given):
        raise TypeError(f"columns: expected names such as ['x', 'y', 'z'], got {shown(given)}")
    names = [_canonical(name) for name in given]
    if reason := _why_wrong(names):
        raise ValueError(f"columns: {reason}, got {given}")
    return names


def read_head(path: Path, body: bytes) -> _Head:
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
            names_in_comment = _as_names(comment[0], delimiter, len(fields)) if comment[0] else None
            return _Head(names_in_comment, comment[1], number - 1, len(fields), delimiter, count)
    if names is None:
        raise FileError(path, "contains no points")
    return _Head(*names[:2], number, len(names[0]), names[2], count)


def _is_count(fields: list[bytes]) -> bool:
    return len(fields) == 1 and fields[0].isdigit() and len(fields[0]) < _MAX_DIGITS


def _is_wider_below(body: bytes, end: int) -> bool:
    for _, _, line in _lines(body[end + 1 : end + 1 + (1 << 16)]):
        bare = line.strip()
        if bare and not bare.startswith(b"#"):
            return len(bare.replace(b";", b" ").replace(b",", b" ").split()) > 1
    return False


def _lines(body: bytes) -> Any:
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
    """Column names in a comment, if it has one word per column with x, y and z. Else None."""
    for mark in (delimiter, None, b",", b";"):
        names = [_plain(field) for field in _split(comment, mark)]
        if len(names) == count and set(POSITION) <= {_canonical(name) for name in names}:
            return names
    return None


def _canonical(name: str) -> str:
    return _NAMED.get(name.strip().lower(), name.strip())


def names_of(path: Path, head: _Head, width: int) -> list[str]:
    """The name of each column. Raises `FileError` if they are unknown or contradictory."""
    if head.names is None:
        if width == 3:
            return [*POSITION]
        known = {4: "x y z intensity", 6: "x y z nx ny nz, or x y z r g b", 7: "x y z intensity r g b"}
        remedy = f"Add a first line of names, such as {known.get(width, 'x y z time')}; or give columns="
        if width == 6:
            remedy += "; without names, .xyzn stores normals and .xyzrgb colors in 0..1"
        raise FileError(path, f"has {width} columns without names", remedy=remedy)
    names = [_canonical(name) for name in head.names]
    if reason := _why_wrong(names):
        remedy = "Correct the names, or give columns= instead"
        raise FileError(
            path, f"{reason}; the columns are {', '.join(head.names)}"[:300], where=f"line {head.line}", remedy=remedy
        )
    return names


def _why_wrong(names: Sequence[str]) -> str:
    if not all(names):
        return f"column {list(names).index('') + 1} has no name"
    twice = next((name for name, count in Counter(names).items() if count > 1), None)
    if twice is not None:
        return f"two columns are named {twice}"
    missing = [name for name in POSITION if name not in names]
    if missing:
        return f"no column is named {', '.join(missing)}"
    for what, triple in (("normals", NORMAL), ("colors", COLOR)):
        there = [name for name in triple if name in names]
        if 0 < len(there) < 3:
            return f"{what} need {', '.join(triple)}, but there is only {', '.join(there)}"
    return ""


def _rows_of(path: Path, body: bytes, head: _Head) -> tuple[AsciiRows, bytes]:
    begin = 0
    for _ in range(head.lines):
        begin = body.find(b"\n", begin) + 1 or len(body)
    text = body[begin:]
    text = without_comments(text)
    blank = text if head.delimiter is None else text.replace(head.delimiter, b" ")
    rows = AsciiRows(path, blank, head.lines + 1, is_table=True)
    if not rows.row_count:
        raise FileError(path, "contains no points")
    return rows, text


def without_comments(text: bytes) -> bytes:
    return _COMMENT.sub(b"", text) if b"#" in text else text


def check_fields(path: Path, rows: AsciiRows, text: bytes, delimiter: bytes | None, first: int, width: int) -> None:
    """Raise `FileError` at the first row without one value per column."""
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
            raise FileError(path, f"expected {width} values, got {len(fields)}", where=where, remedy=_PARTED)
        for column, field in enumerate(fields, 1):
            if not field:
                remedy = "Add it (nan if it was not measured), or remove the line"
                raise FileError(path, f"column {column} has no value", where=where, remedy=remedy)
            if not is_number(field):
                shown = field[:40].decode("ascii", "backslashreplace")
                raise FileError(path, f"not a number: {shown!r}", where=f"{where}, column {column}", remedy=_PARTED)
    raise FileError(path, f"expected {width} values in each line", remedy=_PARTED)


def table_of(path: Path, columns: dict[str, NDArray[Any]], full: float | None = None) -> PointTable:
    """Build a table from named columns; `full` is the maximum color value (1 or 255), if known."""

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
    """Colors, float32 (n, 3). If `full` is None it is derived from the range of values."""
    if full is None:
        is_integer = all(bool((np.floor(channel) == channel).all()) for channel in channels)
        low, high = min(float(channel.min()) for channel in channels), max(float(channel.max()) for channel in channels)
        full = color_range(path, low, high, is_integer=is_integer)
    kind = np.uint8 if full == 255 else np.float32
    return stack_colors(path, [channel.astype(kind) for channel in channels])


def color_range(path: Path, low: float, high: float, *, is_integer: bool) -> float:
    """Derive the maximum color value (1 or 255) from the range of values. Raises `FileError` if it is ambiguous."""
    if not is_integer or low < 0 or high > 255:
        if high > 1:
            reason = f"colors from {low:g} to {high:g} are neither fractions in 0..1 nor integers in 0..255"
            raise FileError(path, reason, remedy="Scale them to 0..1")
        return 1.0
    if high == 1:
        reason = "all colors are 0 or 1, which may be in 0..1 or in 0..255"
        raise FileError(path, reason, remedy="Write .xyzrgb for colors in 0..1, .pts for integers in 0..255")
    return 255.0
