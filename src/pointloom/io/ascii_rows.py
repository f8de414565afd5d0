"""Rows of numbers as text, for ASCII PLY, PCD and XYZ. Blank lines are ignored.

Two vectorized passes find and parse the tokens. Only on failure are lines scanned to report the first error.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import chain
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from ..core.errors import FileError, FilePath

# Rows formatted or packed at a time: large enough to amortize Python, small enough to limit memory.
CHUNK_ROWS = 1 << 16

_NUMBER = re.compile(rb"[+-]?(?:\d++(?:\.\d*+)?(?:e[+-]?\d+)?|\.\d+(?:e[+-]?\d+)?|inf(?:inity)?|nan(?:\(\w*\))?)", re.I)


def unix_lines(body: bytes) -> bytes:
    return body.replace(b"\r\n", b"\n").replace(b"\r", b"\n") if b"\r" in body else body


def is_number(word: bytes) -> bool:
    return _NUMBER.fullmatch(word) is not None


def is_float(word: str) -> bool:
    """True if Python reads the word as a number."""
    try:
        float(word)
    except ValueError:
        return False
    return True


_COMMA_LIST = re.compile(r"[+-]?[\d.]*(?:,[\d.]+)+(?:e[+-]?\d+)?", re.I)


def check_decimal_points(path: FilePath, line: int, row: str) -> None:
    """Raise `FileError` for a number with a comma, such as 4471,5, in a row that has another separator."""
    words = [word.strip("\"'") for word in re.split(r"[;\s]+", row.strip())]
    has_columns = ";" in row or "\t" in row.strip()
    for column, word in enumerate(words if len(words) > 1 else (), 1):
        is_list = column == len(words) and word.count(",") > 1 and not has_columns  # as in `name 1,2,3`
        if _COMMA_LIST.fullmatch(word) and not is_list:
            remedy = "Write numbers such as 4471.5, without decimal commas and thousands separators"
            raise FileError(path, f"expected decimal points, got {word[:40]!r}", where=f"line {line}", remedy=remedy)


class AsciiRows:
    """The non-blank lines of a text and their numbers; `first_line` is the line number of the first line, from 1.
    Errors name the column of a table if `is_table`."""

    def __init__(self, path: FilePath, body: bytes, first_line: int, *, is_table: bool = False):
        body = unix_lines(body)
        self._path, self._body, self._first_line, self._is_table = path, body, first_line, is_table
        text = np.frombuffer(body, np.uint8)
        visible = text > 32
        begins = visible.copy()
        begins[1:] &= ~visible[:-1]
        self._tokens = np.flatnonzero(begins)
        ends = np.append(np.flatnonzero(text == 10), len(text))
        tokens_before = np.concatenate(([0], np.searchsorted(self._tokens, ends)))
        self._lines = np.flatnonzero(np.diff(tokens_before))
        #: Index of the first token of each row, and one past the last token, shape [rows + 1].
        self.first = np.append(tokens_before[self._lines], len(self._tokens))
        self.row_count = len(self._lines)

    def where(self, row: int) -> str:
        """The location of a row, or of the end, for errors."""
        line = self._lines[row] if row < self.row_count else self._body.rstrip().count(b"\n")
        return f"line {self._first_line + int(line)}"

    def widths(self) -> NDArray[np.int64]:
        """Number of tokens of each row, shape (rows,)."""
        return np.diff(self.first)

    def check_width(self, begin: int, end: int, width: int) -> None:
        wrong = np.flatnonzero(self.widths()[begin:end] != width)
        if len(wrong):
            row = begin + int(wrong[0])
            value_count = int(self.widths()[row])
            raise FileError(self._path, f"expected {width} values, got {value_count}", where=self.where(row))

    def is_parted_by(self, marks: NDArray[np.int64], width: int) -> bool:
        """True if each row has `width` values with exactly one separator between them.
        `marks` are the positions of the separators, now blanks, ascending."""
        if len(self._tokens) != self.row_count * width or len(marks) != self.row_count * (width - 1):
            return False
        values, between = self._tokens.reshape(-1, width), marks.reshape(-1, width - 1)
        in_rows = (self.widths() == width).all()
        return bool(in_rows and (values[:, :-1] < between).all() and (between < values[:, 1:]).all())

    def numbers(self) -> NDArray[np.float64]:
        """All tokens as flat float64, exact for integers up to 2^53. Raises `FileError` with the line."""
        if not len(self._tokens):
            return np.empty(0)
        try:
            values = np.fromstring(self._body, dtype=np.float64, sep=" ")
        except (ValueError, DeprecationWarning):
            raise self._bad_token() from None
        if len(values) != len(self._tokens):  # "1-2" parses as two numbers. NumPy before 2.3 stops at a bad token
            raise self._bad_token()
        self._check_infinities(values)
        return values

    def words(self) -> list[bytes]:
        """All tokens as bytes, for integers beyond 2^53."""
        return self._body.split()

    def _check_infinities(self, values: NDArray[np.float64]) -> None:
        infinite = np.flatnonzero(np.isinf(values))
        if not len(infinite):
            return
        text = np.frombuffer(self._body, np.uint8)
        begins = self._tokens[infinite]
        begins = begins + np.isin(text[begins], list(b"+-"))
        spelled = np.isin(text[begins], list(b"iI"))
        if not spelled.all():
            row = int(np.searchsorted(self.first, infinite[~spelled][0], side="right")) - 1
            raise FileError(self._path, "a number is beyond the range of float64", where=self.where(row))

    def _bad_token(self) -> FileError:
        for number, line in enumerate(self._body.split(b"\n")):
            for column, token in enumerate(line.split(), 1):
                if not _NUMBER.fullmatch(token):
                    shown = token[:40].decode("ascii", "backslashreplace")
                    where = f"line {self._first_line + number}" + (f", column {column}" if self._is_table else "")
                    return FileError(self._path, f"not a number: {shown!r}", where=where)
        return FileError(self._path, "the text contains something that is not a number")

    def cast(
        self, values: NDArray[np.float64], dtype: np.dtype[Any], what: str, rows: int | NDArray[np.int64]
    ) -> NDArray[Any]:
        """Cast values to the declared type; `rows` is the first row or the row of each value, for errors."""
        if dtype.kind == "f":
            with np.errstate(over="ignore"):
                column = values.astype(dtype)
            bad = np.isinf(column) & np.isfinite(values)
        else:
            limits = np.iinfo(dtype)
            with np.errstate(invalid="ignore"):
                bad = ~((values >= limits.min) & (values <= limits.max) & (np.floor(values) == values))
                column = values.astype(dtype)
        if bad.any():
            k = int(np.flatnonzero(bad)[0])
            row = rows + k if isinstance(rows, int) else int(rows[k])
            reason = f"{what}: {values[k]:.17g} does not fit the declared type {dtype.name}"
            raise FileError(self._path, reason, where=self.where(row))
        return column


def write_rows(file: IO[bytes], columns: Sequence[NDArray[Any]], *, line: str | None = None) -> None:
    """Write columns (n,) as lines; `line` is a %-format with line end, by default lossless."""
    line = row_format(columns) if line is None else line
    for begin in range(0, len(columns[0]), CHUNK_ROWS):
        parts = [column[begin : begin + CHUNK_ROWS].tolist() for column in columns]
        file.write((line * len(parts[0]) % tuple(chain.from_iterable(zip(*parts, strict=True)))).encode("ascii"))


def row_format(columns: Sequence[NDArray[Any]]) -> str:
    """A lossless %-format for a line of these columns."""
    return " ".join(_format(column.dtype) for column in columns) + "\n"


def _format(dtype: np.dtype[Any]) -> str:
    """9 and 17 significant digits identify every float32 and float64."""
    if dtype.kind != "f":
        return "%d"
    return "%.9g" if dtype.itemsize <= 4 else "%.17g"
