"""Legacy VTK files (.vtk, versions 1 to 5.1): polygonal data and unstructured grids, ASCII and binary.

Names are percent-encoded. Binary numbers are big-endian. Kitware, "VTK File Formats" (2022).
"""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import IO, Any
from urllib.parse import quote, unquote

import numpy as np
from numpy.typing import NDArray

from ..core.errors import FileError
from ..core.to_other_libraries import COLORS, NORMALS, UVS
from .ascii_rows import write_rows
from .source import open_source
from .vtk_data import KINDS, LEGACY_TYPES, Cells, VtkData, check_data, parse_numbers

_HEAD = re.compile(rb"# vtk DataFile Version (\d)\.(\d)\s*\n([^\n]{0,512})\n\s*(ASCII|BINARY)\s*\n", re.IGNORECASE)
_KEYWORDS = {"VERTICES": "vertices", "LINES": "lines", "POLYGONS": "polygons", "TRIANGLE_STRIPS": "strips"}
_CELL_KINDS = {1: "vertices", 2: "vertices", 3: "lines", 4: "lines", 5: "polygons", 7: "polygons", 9: "polygons"}
_MAX_DIGITS = 19  # of a count
_WORD_BYTES = 16  # of a typical number and its separator
_TITLE = "pointloom"


def read_legacy(path: Path) -> VtkData:
    """Read the points, cells and arrays of a legacy file."""
    return _Reader(path).read()


class _Reader:
    """A position in the bytes of a file, and the content that was read before it."""

    def __init__(self, path: Path):
        self.path, self.body = path, bytes(open_source(path)[:])
        head = _HEAD.match(self.body.replace(b"\r\n", b"\n", 4) if b"\r" in self.body[:1024] else self.body)
        if head is None:
            raise FileError(path, "is not a legacy VTK file: it does not begin with '# vtk DataFile Version'")
        self.is_binary = head[4].upper() == b"BINARY"
        if b"\r" in self.body[:1024] and not self.is_binary:
            self.body = self.body.replace(b"\r\n", b"\n")
        self.is_new = (int(head[1]), int(head[2])) >= (5, 1)  # offsets and connectivity of cells
        self.at = head.end()
        self.data = VtkData(np.empty((0, 3), np.float32))
        self._order: Any = slice(None)  # of the cells of a grid by kind

    def read(self) -> VtkData:
        kind, target, count = "", self.data.field_data, 0
        readers: dict[str, Callable[[], None]] = {"POINTS": self._points, "METADATA": self._skip_metadata}
        readers |= {word: lambda kind=kind: self._cells(kind) for word, kind in _KEYWORDS.items()}
        readers |= {"CELLS": self._grid}
        while word := self._word(optional=True).upper():
            if word == "DATASET":
                kind = self._word().upper()
                if kind not in ("POLYDATA", "UNSTRUCTURED_GRID"):
                    raise self._error(f"the data set {kind} is not supported", "Convert it to POLYDATA")
            elif word in ("POINT_DATA", "CELL_DATA"):
                count = self._count()
                target = self.data.point_data if word == "POINT_DATA" else self.data.cell_data
            elif word in readers and kind:
                readers[word]()
            elif word == "FIELD":
                self._field(target)
            elif kind and target is not self.data.field_data:
                self._attribute(word, target, count)
            else:
                raise self._error(f"unexpected word {word[:40]!r}")
        if not kind:
            raise self._error("contains no data set")
        check_data(self.path, self.data)
        self.data.cell_data = {name: values[self._order] for name, values in self.data.cell_data.items()}
        return self.data

    def _error(self, reason: str, remedy: str = "") -> FileError:
        return FileError(self.path, reason, where=f"byte {self.at}", remedy=remedy)

    def _word(self, *, optional: bool = False) -> str:
        found = re.compile(rb"\s*([^\s]+)[ \t]*").match(self.body, self.at)
        if found is None:
            if optional:
                return ""
            raise self._error("is truncated")
        self.at = found.end()
        return found[1][:256].decode("latin-1")

    def _count(self) -> int:
        word = self._word()
        if not word.isdecimal() or len(word) > _MAX_DIGITS:
            raise self._error(f"expected a count, got {word[:40]!r}")
        return int(word)

    def _type(self) -> str:
        word = self._word().lower()
        if word not in LEGACY_TYPES and word != "string":
            raise self._error(f"the type {word[:40]!r} is not supported")
        return word

    def _numbers(self, count: int, kind: str) -> NDArray[Any]:
        """The next `count` numbers in native byte order."""
        dtype = np.dtype(LEGACY_TYPES[kind])
        if self.is_binary:
            end = self.body.find(b"\n", self.at) + 1
            if not end or self.body[self.at : end].strip():
                raise self._error("expected the end of the line before binary numbers")
            size = count * dtype.itemsize
            if size > len(self.body) - end:
                raise self._error(
                    f"is truncated: {count} numbers need {size} bytes, but {len(self.body) - end} are left"
                )
            self.at = end + size
            return np.frombuffer(self.body, dtype.newbyteorder(">"), count, end).astype(dtype)
        if 2 * count > len(self.body) - self.at + 1:
            raise self._error(f"is truncated: {count} numbers do not fit into {len(self.body) - self.at} bytes")
        words = self._words(count)
        try:
            return parse_numbers(words, dtype)
        except (ValueError, OverflowError) as error:
            raise self._error(f"a value is not a number of the type {kind}") from error

    def _words(self, count: int) -> list[bytes]:
        """The next `count` words. Only the bytes near them are copied, so that many arrays take linear time."""
        size, part, words = _WORD_BYTES * (count + 1), b"", []
        while count and len(words) <= count:
            part = self.body[self.at : self.at + size]
            words = part.split(None, count)
            if self.at + size >= len(self.body):
                break
            size *= 2
        if len(words) < count:
            raise self._error(f"is truncated: {count} numbers are expected, but {len(words)} are left")
        if count:
            self.at += len(part) - (len(words[count]) if len(words) > count else 0)
        return words[:count]

    def _points(self) -> None:
        count, kind = self._count(), self._type()
        values = self._numbers(3 * count, kind).reshape(-1, 3)
        self.data.points = values if values.dtype.kind == "f" else values.astype(np.float64)

    def _cells(self, kind: str) -> None:
        self.data.cells[kind] = self._any_cells()

    def _any_cells(self) -> Cells:
        count, size = self._count(), self._count()
        if self.is_new:
            starts = self._named_numbers("OFFSETS", count)
            points = self._named_numbers("CONNECTIVITY", size)
            lengths = np.diff(starts)
            ends = (starts[0], starts[-1]) if count else (0, 0)
            if ends != (0, size) or lengths.min(initial=0) < 0:
                raise self._error("the offsets of the cells are damaged")
            return Cells(lengths, points)
        rows = self._numbers(size, "int").astype(np.int64)
        if count > size:
            raise self._error(f"the {count} cells do not fit into {size} numbers")
        lengths, is_point, at = np.empty(count, np.int64), np.ones(size, bool), 0
        if count and size % count == 0 and (rows[:: size // count] == size // count - 1).all():
            lengths[:], is_point[:: size // count] = size // count - 1, False
        else:
            for cell in range(count):
                if at >= size or rows[at] < 0:
                    raise self._error(f"the {count} cells do not fit into {size} numbers")
                lengths[cell], is_point[at] = rows[at], False
                at += int(rows[at]) + 1
            if at != size:
                raise self._error(f"the {count} cells have {at} numbers, not {size}")
        return Cells(lengths, rows[is_point])

    def _named_numbers(self, name: str, count: int) -> NDArray[np.int64]:
        if (word := self._word().upper()) != name:
            raise self._error(f"expected {name}, got {word[:40]!r}")
        return self._numbers(count, self._type()).astype(np.int64)

    def _grid(self) -> None:
        """Cells of an unstructured grid, sorted by kind. Volumes are errors, since they have no triangles."""
        cells = self._any_cells()
        if (word := self._word().upper()) != "CELL_TYPES" or self._count() != len(cells.lengths):
            raise self._error(f"expected the types of {len(cells.lengths)} cells, got {word[:40]!r}")
        types = self._numbers(len(cells.lengths), "int")
        unknown = np.setdiff1d(types, [*_CELL_KINDS])
        if len(unknown):
            raise self._error(f"cells of the type {unknown[0]} are not supported", "Extract the surface first")
        ids = np.array([KINDS.index(_CELL_KINDS[number]) for number in types.tolist()], np.int64)
        for number, kind in enumerate(KINDS):
            chosen = ids == number
            self.data.cells[kind] = Cells(cells.lengths[chosen], cells.points[np.repeat(chosen, cells.lengths)])
        self._order = np.argsort(ids, kind="stable")

    def _field(self, target: dict[str, Any]) -> None:
        self._word()  # the name of the field
        for _ in range(self._count()):
            name, width, rows, kind = unquote(self._word()), self._count(), self._count(), self._type()
            if kind == "string":
                self._put(target, name, self._strings(width * rows))
            else:
                self._put(target, name, self._numbers(width * rows, kind), width)
            self._skip_optional_metadata()

    def _put(self, target: dict[str, Any], name: str, values: NDArray[Any], width: int = 1) -> None:
        if name in target:
            raise self._error(f"the array {name[:60]!r} is duplicated")
        if width < 1:
            raise self._error(f"the array {name[:60]!r} has no columns")
        target[name] = values if width == 1 else values.reshape(-1, width)

    def _attribute(self, word: str, target: dict[str, Any], count: int) -> None:
        """An array of the points or cells."""
        if word in ("SCALARS", "NORMALS", "VECTORS", "TENSORS", "GLOBAL_IDS", "PEDIGREE_IDS"):
            name, kind = unquote(self._word()), self._type()
            width = {"NORMALS": 3, "VECTORS": 3, "TENSORS": 9}.get(word, 1)
            if word == "SCALARS":
                line_end = self.body.find(b"\n", self.at)
                rest = self.body[self.at : line_end].split() if line_end >= 0 else []
                width = self._count() if rest else 1
                mark = self.at
                if self._word(optional=True).upper() == "LOOKUP_TABLE":
                    self._word()
                else:
                    self.at = mark
            name = NORMALS if word == "NORMALS" else name
            self._put(target, name, self._numbers(width * count, kind), width)
        elif word == "TEXTURE_COORDINATES":
            self._word()
            width, kind = self._count(), self._type()
            self._put(target, UVS, self._numbers(width * count, kind), width)
        elif word == "COLOR_SCALARS":
            self._word()
            width = self._count()
            kind = "unsigned_char" if self.is_binary else "float"
            self._put(target, COLORS, self._numbers(width * count, kind), width)
        elif word == "LOOKUP_TABLE":  # colors of a scalar, which only displays use
            self._word()
            self._numbers(4 * self._count(), "unsigned_char" if self.is_binary else "float")
        else:
            raise self._error(f"unexpected word {word[:40]!r}")

    def _strings(self, count: int) -> NDArray[Any]:
        texts = []
        self.at = self.body.find(b"\n", self.at) + 1 or len(self.body)
        for _ in range(count):
            if self.is_binary:
                texts.append(self._string())
                continue
            end = self.body.find(b"\n", self.at)
            if end < 0:
                raise self._error("is truncated in a text")
            texts.append(unquote(self.body[self.at : end].decode("utf-8", "replace")))
            self.at = end + 1
        return np.array(texts, str if len(texts) == 1 else object)  # a str array has the width of the longest text

    def _string(self) -> str:
        """A text after its length, whose first two bits are the number of bytes of the length."""
        first = self.body[self.at] if self.at < len(self.body) else 0
        size = (8, 4, 2, 1)[first >> 6]
        length = int.from_bytes(self.body[self.at : self.at + size], "big") & ((1 << (8 * size - 2)) - 1)
        begin = self.at + size
        if begin + length > len(self.body):
            raise self._error("is truncated in a text")
        self.at = begin + length
        return self.body[begin : self.at].decode("utf-8", "replace")

    def _skip_optional_metadata(self) -> None:
        mark = self.at
        if self._word(optional=True).upper() == "METADATA":
            self._skip_metadata()
        else:
            self.at = mark

    def _skip_metadata(self) -> None:
        """Skip lines until an empty one."""
        end = re.compile(rb"\n[ \t]*\n").search(self.body, self.at)
        self.at = len(self.body) if end is None else end.end()


def write_legacy(file: IO[bytes], data: VtkData, *, ascii: bool = False) -> None:
    """Write polygonal data of version 4.2, which all readers support."""
    writer = _Writer(file, ascii)
    kind = "ASCII" if ascii else "BINARY"
    writer.line(f"# vtk DataFile Version 4.2\n{_TITLE}\n{kind}\nDATASET POLYDATA")
    if data.field_data:
        writer.field({name: np.array([text]) for name, text in data.field_data.items()})
    writer.line(f"POINTS {len(data.points)} {_type_of(data.points)}")
    writer.numbers(data.points)
    for word, name in _KEYWORDS.items():
        cells = data.cells[name]
        if len(cells.lengths):
            begins = np.cumsum(cells.lengths) - cells.lengths
            rows = np.insert(cells.points, begins, cells.lengths).astype(np.int32)
            writer.line(f"{word} {len(cells.lengths)} {len(rows)}")
            writer.numbers(rows.reshape(-1, int(cells.lengths[0]) + 1) if ascii else rows)
    cell_count = sum(len(cells.lengths) for cells in data.cells.values())
    for word, count, rows in (
        ("POINT_DATA", len(data.points), data.point_data),
        ("CELL_DATA", cell_count, data.cell_data),
    ):
        if rows:
            writer.line(f"{word} {count}")
            writer.attributes(rows)


class _Writer:
    def __init__(self, file: IO[bytes], ascii: bool):
        self.file, self.ascii = file, ascii

    def line(self, text: str) -> None:
        self.file.write(f"{text}\n".encode())

    def numbers(self, values: NDArray[Any]) -> None:
        if not self.ascii:
            self.file.write(np.ascontiguousarray(values, values.dtype.newbyteorder(">")).tobytes() + b"\n")
            return
        if values.size:
            write_rows(self.file, [*values.reshape(len(values), -1).T])

    def attributes(self, rows: dict[str, NDArray[Any]]) -> None:
        plain = dict(rows)
        if (normals := plain.pop(NORMALS, None)) is not None:
            self.line(f"NORMALS {NORMALS} {_type_of(normals)}")
            self.numbers(normals)
        if (uvs := plain.pop(UVS, None)) is not None:
            self.line(f"TEXTURE_COORDINATES {quote(UVS)} 2 {_type_of(uvs)}")
            self.numbers(uvs)
        if plain:
            self.field(plain)

    def field(self, rows: dict[str, NDArray[Any]]) -> None:
        self.line(f"FIELD FieldData {len(rows)}")
        for name, values in rows.items():
            width = values.shape[1] if values.ndim == 2 else 1
            self.line(f"{quote(name)} {width} {len(values)} {_type_of(values)}")
            if values.dtype.kind != "U":
                self.numbers(values)
                continue
            for text in values.tolist():
                body = text.encode()
                self.file.write(
                    quote(body, safe=" ").encode() + b"\n" if self.ascii else _length_of(body) + body + b"\n"
                )


def _length_of(text: bytes) -> bytes:
    """The length of a text before it. See `_string`."""
    return (len(text) | 3 << 6).to_bytes(1, "big") if len(text) < 1 << 6 else (len(text) | 1 << 30).to_bytes(4, "big")


def _type_of(values: NDArray[Any]) -> str:
    if values.dtype.kind == "U":
        return "string"
    return next(name for name, code in LEGACY_TYPES.items() if values.dtype == np.dtype(code))
