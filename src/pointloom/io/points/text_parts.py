"""Text point files read in blocks of lines, with the rules of text.py and text_table.py.

A first pass finds the number of points and the color range.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ...core.errors import FileError, FilePath
from ..ascii_rows import AsciiRows, unix_lines
from ..source import SourceFile, open_source
from ..table import PointTable
from .text import pts_count
from .text_table import (
    COLOR,
    NORMAL,
    POSITION,
    check_fields,
    color_range,
    names_of,
    read_head,
    table_of,
    without_comments,
    wrong_count,
)

BLOCK_BYTES = 1 << 23  # bytes of lines at a time
_MAX_HEADER_BYTES = 1 << 16  # [B] maximum size of the header
_FIXED = {".xyzn": (*POSITION, *NORMAL), ".xyzrgb": (*POSITION, *COLOR)}
_PTS_COLUMNS = {3: POSITION, 4: (*POSITION, "intensity"), 6: (*POSITION, *COLOR), 7: (*POSITION, "intensity", *COLOR)}


class TextInParts:
    """A text file validated by one pass; `count` is the number of points."""

    def __init__(self, path: FilePath):
        self.path = Path(path)
        self._kind, source = self.path.suffix.lower(), open_source(path)
        self._source = source
        begin = 3 if source[:3] == b"\xef\xbb\xbf" else 0
        first = unix_lines(bytes(source[begin : begin + _MAX_HEADER_BYTES]))
        self._declared, self._delimiter, self._lines, full = -1, None, 0, None
        if self._kind == ".pts":
            declared = pts_count(path, first.partition(b"\n")[0])
            self._declared, self._lines, self._names = (-1, 0, None) if declared is None else (declared, 1, None)
        elif self._kind in _FIXED:
            self._names = _FIXED[self._kind]
        else:
            head = read_head(self.path, first)
            self._delimiter, self._lines = head.delimiter, head.lines
            self._declared, full = -1 if head.declared is None else head.declared, head.full
            self._names = tuple(names_of(self.path, head, head.width))
        self._begin = begin
        self._full = full or 1.0
        self.count = self._look(range_is_given=full is not None)

    def _look(self, *, range_is_given: bool) -> int:
        """The first pass: number of points and maximum color value."""
        count, seen = 0, []
        for names, rows in self._rows():
            if COLOR[0] in names:
                colors = rows[:, [names.index(name) for name in COLOR]]
                seen.append([colors.min(), colors.max(), float((np.floor(colors) == colors).all())])
            count += len(rows)
        if self._declared >= 0 and count != self._declared:
            raise wrong_count(self.path, self._declared, count)
        if not count and self._declared != 0:
            raise FileError(self.path, "contains no points")
        if seen and self._kind == ".pts":
            self._full = 255.0
        elif seen and self._kind != ".xyzrgb" and not range_is_given:
            low, high, is_integer = np.array(seen).T
            self._full = color_range(self.path, float(low.min()), float(high.max()), is_integer=bool(is_integer.min()))
        return count

    def parts(self, size: int) -> Iterator[PointTable]:
        """Yield at most `size` points at a time. One empty part if there are none."""
        if not self.count:
            yield PointTable(np.empty((0, 3)))
        for names, rows in self._rows():
            for begin in range(0, len(rows), size):
                columns = rows[begin : begin + size].T
                yield table_of(self.path, dict(zip(names, columns, strict=True)), self._full)

    def _rows(self) -> Iterator[tuple[tuple[str, ...], NDArray[np.float64]]]:
        """Yield column names and the rows of each block of lines."""
        line, names = 1, self._names
        for body in _blocks(self._source, self._begin):
            lines, skip = body.count(b"\n") + (not body.endswith(b"\n")), max(0, self._lines - (line - 1))
            for _ in range(min(skip, lines)):
                body = body.partition(b"\n")[2]
            text = without_comments(body) if self._kind != ".pts" else body
            blank = text if self._delimiter is None else text.replace(self._delimiter, b" ")
            rows = AsciiRows(self.path, blank, line + min(skip, lines), is_table=True)
            if names is None and rows.row_count:
                width = int(rows.widths()[0])
                if width not in _PTS_COLUMNS:
                    raise FileError(self.path, f"expected 3, 4, 6 or 7 values, got {width}", where=rows.where(0))
                names = _PTS_COLUMNS[width]
            if rows.row_count:
                assert names is not None
                check_fields(self.path, rows, text, self._delimiter, line + min(skip, lines), len(names))
                values = rows.numbers().reshape(-1, len(names))
                for name in COLOR if self._kind == ".pts" and COLOR[0] in names else ():  # raises with the line
                    rows.cast(values[:, names.index(name)], np.dtype(np.uint8), "color", 0)
                yield names, values
            line += lines


def _blocks(source: SourceFile, begin: int) -> Iterator[bytes]:
    left = b""
    for at in range(begin, len(source), BLOCK_BYTES):
        block = left + bytes(source[at : at + BLOCK_BYTES])
        is_last = at + BLOCK_BYTES >= len(source)
        if not is_last and block.endswith(b"\r"):  # its LF may follow
            block, carried = block[:-1], b"\r"
        else:
            carried = b""
        block = unix_lines(block)
        end = len(block) if is_last else block.rfind(b"\n") + 1
        left = block[end:] + carried
        if end:
            yield block[:end]
