"""Tables of numbers that users write by hand, with or without a header: targets, control points, positions.

A header names the columns, in any order. Without one, the columns are in a documented order. Columns are separated by
semicolons, tabs, commas or blanks. Decimal commas are read where another separator or quotes make them unambiguous.
"""

from __future__ import annotations

import csv
import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

from ..core.errors import FileError, FilePath
from ..core.paths import input_path
from ..core.units import warn_of_units
from .ascii_rows import check_decimal_points, is_number

MAX_BYTES = 1 << 26  # a table of 500,000 points
MAX_GUESSED_SIGMA = 1.0  # [m] larger ones in rows without a header are rather a coordinate after a name with blanks
MAX_NUMBER = 1e100  # larger numbers are no coordinates, and their squares exceed float64

_AXES = {
    "x": "x easting east e tx pos_x position_x coord_x rechtswert",
    "y": "y northing north n ty pos_y position_y coord_y hochwert",
    "z": "z height elevation elev altitude alt up u h tz pos_z position_z coord_z",
}
_SIGMAS = ("sigma", "std", "stddev", "std_dev", "stdev", "sd", "standard_deviation")
SYNONYMS = {
    "station": "station station_name scan scan_name setup",
    "name": "name id point point_id point_name target target_id target_name label",
    "time": "time timestamp t seconds",
    "sigma": " ".join(_SIGMAS),
    **_AXES,
    **{
        f"sigma_{axis}": " ".join([f"s{axis}", *(f"{s}_{a}" for s in _SIGMAS for a in names.split() if a != "h")])
        for axis, names in _AXES.items()
    },
}
WORDS = ("station", "name", "image", "use")
_UNITS = {"time": "s sec second seconds", "column": "px pixel pixels", "row": "px pixel pixels"}
_UNITS |= {"u": _UNITS["row"], "v": _UNITS["row"], "latitude": "deg degree degrees °"}
_UNITS |= {"longitude": _UNITS["latitude"], **dict.fromkeys(WORDS, "")}
_METERS = "m meter meters metre metres"
_COMMA_NUMBER = re.compile(r"[+-]?\d*,\d*(e[+-]?\d+)?", re.I)


class Row(NamedTuple):
    """Values of one row by column name, without those of empty optional columns."""

    line: int
    words: dict[str, str]
    numbers: dict[str, float]


@dataclass(frozen=True)
class TableForm:
    """The documented columns of a table.

    Attributes:
        orders: Columns without a header, such as "name x y z". A header has the columns of one of them, in any order.
        synonyms: Other names of columns that differ from `SYNONYMS`.
        optional: Columns with empty fields where the default is used.
        are_names_joined: Words before the numbers of a row of blanks are one name.
        needed: Columns that a header must have, where its other columns are all optional.
    """

    orders: tuple[str, ...]
    synonyms: Mapping[str, str] = field(default_factory=dict)
    optional: tuple[str, ...] = ("sigma", "sigma_x", "sigma_y", "sigma_z")
    are_names_joined: bool = False
    needed: tuple[str, ...] = ()

    @property
    def columns(self) -> list[str]:
        return list(dict.fromkeys(name for order in self.orders for name in order.split()))

    @property
    def has_words(self) -> bool:
        return any(name in WORDS for name in self.columns)

    @property
    def text(self) -> str:
        return " or ".join(f"{order.replace(' ', ', ') if self.needed else order}" for order in self.orders)

    def canonical(self, title: str) -> tuple[str | None, str, str]:
        """The column that a title names, or None; its unit; and its name in lower case."""
        name, _, unit = re.sub(r"[\])]\s*$", "", title.strip().lower()).replace("(", "[").partition("[")
        name = re.sub(r"[\s.\-_]+", "_", name.strip()).strip("_")
        for base, ending in ((name, unit.strip()), (name.rpartition("_")[0], unit.strip() or name.rpartition("_")[2])):
            for column in self.columns:
                if base in self.synonyms.get(column, SYNONYMS.get(column, column)).split():
                    is_unit = base == name or ending in _UNITS.get(column, _METERS).split()
                    return (column, ending, name) if is_unit else (None, "", name)
        return None, "", name

    def may_be_mistaken(self, name: str) -> bool:
        """True for an unknown title, such as x_mm, that begins with the name of a documented column."""
        first = name.partition("_")[0]
        return any(first in self.synonyms.get(c, SYNONYMS.get(c, c)).split() for c in (*self.columns, "sigma"))


class Header:
    """The columns of a table, by the titles of its header. None for a column that is ignored."""

    def __init__(self, path: FilePath, form: TableForm, titles: Sequence[str], line: int):
        self.names: list[str | None] = []
        ignored = []
        for number, title in enumerate(titles, 1):
            name, unit, plain = form.canonical(title)
            where = f"line {line}, column {number}"
            units = _UNITS.get(name or "", _METERS).split()
            if name is not None and name not in WORDS and unit and unit not in units:
                reason = f"{name}: expected the unit {units[0]}, got {title!r}"
                raise FileError(path, reason, where=where, remedy="Convert the column and correct its unit")
            if name is None and (not plain or form.may_be_mistaken(plain)):
                reason = f"expected the columns {form.text}, got {title!r}"
                raise FileError(path, reason, where=where, remedy="Rename or remove the column")
            if name is not None and name in self.names:
                remedy = "Keep one of them, or rename the other"
                raise FileError(path, f"two columns are {name}, the second is {title!r}", where=where, remedy=remedy)
            ignored += [title] if name is None else []
            self.names.append(name)
        known = {name for name in self.names if name}
        if not is_complete(form, known):
            is_degrees = any(title.strip().lower().startswith("lat") for title in titles)
            remedy = "Convert degrees to meters of a map" if is_degrees else "Correct the header"
            reason = f"expected the columns {form.text}, got {', '.join(titles)[:200]}"
            raise FileError(path, reason, where=f"line {line}", remedy=remedy)
        if ignored:
            few = ", ".join(map(repr, ignored[:5]))
            warn_of_units(f"{path} (line {line}): ignored the unknown columns {few}", UserWarning)


def is_complete(form: TableForm, names: set[str]) -> bool:
    if form.needed:
        return names >= set(form.needed)
    return any(names == set(order.split()) for order in form.orders)


def split_fields(row: str) -> tuple[list[str], str]:
    """The fields of a row, and its separator: semicolon, tab, comma or blank. Raises `csv.Error`."""
    mark = next((mark for mark in ";\t," if mark in row.strip(" ")), " ")
    if mark == " " and '"' not in row:
        return row.split(), mark
    rows = csv.reader([row.strip(" ")], delimiter=mark, skipinitialspace=True)
    return [word.strip() for word in next(rows)], mark


def _place(line: int, column: int | None) -> str:
    return f"line {line}" if column is None else f"line {line}, column {column}"


class DecimalMarks:
    """Reads the numbers of one table, whose decimals have either points or commas."""

    def __init__(self, path: FilePath):
        self.path = path
        self._lines: dict[str, int] = {}

    def plain(self, word: str, line: int, column: int | None = None) -> str:
        """The number with a decimal point. Other words are returned unchanged."""
        is_comma = len(word) > 1 and _COMMA_NUMBER.fullmatch(word) is not None
        if not is_comma and not ("." in word and is_number(word.encode())):
            return word
        mark = "," if is_comma else "."
        self._lines.setdefault(mark, line)
        if len(self._lines) > 1:
            reason = f"expected decimal {'points' if is_comma else 'commas'} as in line {min(self._lines.values())}"
            remedy = "Write all numbers with decimal points, without thousands separators"
            raise FileError(self.path, f"{reason}, got {word[:40]!r}", where=_place(line, column), remedy=remedy)
        return word.replace(",", ".")

    def number(self, word: str, line: int, column: int) -> float:
        plain, where = self.plain(word, line, column), _place(line, column)
        if not plain:
            raise FileError(self.path, "the column has no value", where=where, remedy="Add it, or remove the line")
        if not is_number(plain.encode()):
            remedy = "Write numbers such as 4471.5, without thousands separators"
            raise FileError(self.path, f"not a number: {word[:40]!r}", where=where, remedy=remedy)
        value = float(re.sub(r"\(.*", "", plain))
        if not math.isfinite(value) or abs(value) >= MAX_NUMBER:
            raise FileError(self.path, f"expected a finite number, got {word[:40]!r}", where=where)
        return value


def table_lines(path: FilePath) -> list[str]:
    """All lines of a table in UTF-8."""
    try:
        if input_path(path).stat().st_size > MAX_BYTES:
            raise FileError(path, f"expected a table of at most {MAX_BYTES >> 20} MiB")
        text = input_path(path).read_text(encoding="utf-8-sig")
    except OSError as error:
        raise FileError(path, f"cannot be read: {error.strerror or error}") from None
    except UnicodeDecodeError:
        raise FileError(path, "is not UTF-8 text", remedy="Save the table as text") from None
    return text.splitlines()


def read_number_table(path: FilePath, form: TableForm) -> list[Row]:
    """Read the rows of a table. Raises `FileError` with line and column."""
    rows: list[Row] = []
    header: Header | None = None
    comments: list[tuple[int, str]] = []
    marks = DecimalMarks(path)
    for line, text in enumerate(table_lines(path), start=1):
        if text.lstrip().startswith("#"):
            comments.append((line, text.strip().lstrip("# ")))
            continue
        text = text if form.has_words else text.split("#", 1)[0]
        if not text.strip():
            continue
        if not rows and header is None:
            if not any(_is_numeric(word) for word in fields_of(path, text, line)[0]):
                header = Header(path, form, titles_of(path, text, line), line)
                continue
            header = _header_in_comments(path, form, comments, fields_of(path, text, line)[0])
        rows.append(_row_of(path, form, header, text, line, marks))
    if not rows:
        raise FileError(path, "contains no rows", remedy=f"Write one row of {form.text} for each entry")
    return rows


def fields_of(path: FilePath, text: str, line: int) -> tuple[list[str], str]:
    """As `split_fields`. The error names the file and the line."""
    try:
        return split_fields(text)
    except csv.Error as error:
        raise FileError(path, f"is not a row of a table: {error}", where=f"line {line}") from None


def titles_of(path: FilePath, text: str, line: int) -> list[str]:
    """The titles of a header, with units that blanks separate from them, such as x [m]."""
    titles = fields_of(path, re.sub(r"\s+(?=[\[(])", "", text), line)[0]
    while titles and not titles[-1]:
        titles.pop()
    return titles


def _header_in_comments(
    path: FilePath, form: TableForm, comments: list[tuple[int, str]], fields: list[str]
) -> Header | None:
    """The header in the last comment that names the columns, such as # name x y z."""
    for line, text in reversed(comments):
        titles = titles_of(path, text, line) if text else []
        names = [form.canonical(title)[0] for title in titles]
        known = {name for name in names if name}
        if is_complete(form, known) and (None not in names or len(names) == len(fields)):
            return Header(path, form, titles, line)
        if len(names) == len(fields) and len(known) > len(names) // 2:
            return Header(path, form, titles, line)  # raises: a column is missing, or has another unit
    return None


def _is_numeric(word: str) -> bool:
    return is_number(word.encode()) or (len(word) > 1 and re.fullmatch(r"[+-]?[\d.,]+", word) is not None)


def _row_of(path: FilePath, form: TableForm, header: Header | None, text: str, line: int, marks: DecimalMarks) -> Row:
    fields, mark = fields_of(path, text, line)
    if mark in ", ":
        check_decimal_points(path, line, text)
    orders = [order.split() for order in form.orders] if header is None else [header.names]
    names = _fitting(orders, fields)
    is_excess = mark == "," and len(fields) >= len(orders[0])
    if names is None and mark != ";" and not is_excess and (form.are_names_joined or not form.has_words):
        fields = _joined(form, orders[0], re.split(r"[,\s]+", text.strip()))
        names = _fitting(orders, fields)
    if names is None:
        expected = form.text if header is None else f"{len(header.names)} columns as in the header"
        remedy = "" if header is None else "Separate names with blanks from numbers by commas, semicolons or tabs"
        raise FileError(path, f"expected {expected}, got {len(fields)} columns", where=f"line {line}", remedy=remedy)
    words, numbers = {}, {}
    for column, (name, word) in enumerate(zip(names, fields, strict=False), 1):
        if name in WORDS:
            words[name] = word
        elif name is not None and (word or name not in form.optional):
            numbers[name] = marks.number(word, line, column)
    if header is None:
        _check_guess(path, form, list(zip(names, fields, strict=False)), Row(line, words, numbers), mark)
    return Row(line, words, numbers)


def _fitting(orders: Sequence[Sequence[str | None]], fields: list[str]) -> Sequence[str | None] | None:
    """The order with as many columns as fields. Removes empty fields at the end."""
    by_width = {len(order): order for order in orders}
    while fields and not fields[-1] and len(fields) not in by_width:
        fields.pop()
    return by_width.get(len(fields))


def _joined(form: TableForm, names: Sequence[str | None], fields: list[str]) -> list[str]:
    """Fields between blanks, with one field for a name with blanks."""
    excess = len(fields) - len(names)
    if excess <= 0 or not form.has_words:
        return fields
    first = next(k for k, name in enumerate(names) if name in WORDS)
    return [*fields[:first], " ".join(fields[first : first + excess + 1]), *fields[first + excess + 1 :]]


def _check_guess(path: FilePath, form: TableForm, fields: list[tuple[str | None, str]], row: Row, mark: str) -> None:
    """Refuse rows without a header whose standard deviations may be coordinates: decimal commas between commas, and
    names with blanks between blanks."""
    sigmas = [value for name, value in row.numbers.items() if name.startswith("sigma")]
    given = [word for name, word in fields if name not in WORDS]
    are_commas = mark == "," and len(sigmas) == 3 and all(re.fullmatch(r"[+-]?\d+", word) for word in given)
    is_name = mark == " " and form.has_words and bool(sigmas)
    is_name = is_name and (given[0].isdigit() or min(sigmas) > MAX_GUESSED_SIGMA)
    if are_commas or is_name:
        what = "decimal commas" if are_commas else "a name with blanks"
        reason = f"the {len(fields)} columns may be {form.text}, or contain {what}"
        remedy = "Add a header with the names of the columns, or separate them by semicolons"
        raise FileError(path, reason, where=f"line {row.line}", remedy=remedy)
