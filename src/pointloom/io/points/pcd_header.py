"""The PCD header: fields, size and encoding.

Point Cloud Library, PCD v0.7 format; .5 and .6 (no VIEWPOINT) are also read.
"""

from __future__ import annotations

import math
import warnings
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ...core.errors import FileError, FilePath
from ...core.escaped_text import escaped
from ..columns import roles_in_lower_case
from ..source import MAX_HEADER_BYTES, Source, parse_count

IDENTITY_VIEWPOINT = (0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0)  # a VIEWPOINT at the origin

#: The encodings of a DATA line.
ENCODINGS = ("ascii", "binary", "binary_compressed")

_VERSIONS = (".5", ".6", ".7", "0.5", "0.6", "0.7")
_KEYS = ("VERSION", "FIELDS", "SIZE", "TYPE", "COUNT", "WIDTH", "HEIGHT", "VIEWPOINT", "POINTS", "DATA")
_TYPES = {"I": "i1 i2 i4 i8", "U": "u1 u2 u4 u8", "F": "f4 f8"}

_ROLES = (("x", "y", "z"), ("normal_x", "normal_y", "normal_z"), ("rgb",), ("rgba",), ("r", "g", "b"))  # in any case

# PCL's largest descriptors have about 2,000 components. A larger COUNT is damage.
_MAX_COMPONENTS = 1 << 20

_Lines = dict[str, tuple[list[str], int]]


@dataclass(frozen=True)
class Field:
    """A field of a point: `count` values of one type; "_" is padding."""

    name: str
    dtype: np.dtype[Any]
    count: int

    @property
    def byte_count(self) -> int:
        return self.dtype.itemsize * self.count


@dataclass(frozen=True)
class PcdHeader:
    """The header: `fields` with padding, `width` x `height`, `encoding`, payload offset `size` (`line_count` lines).
    `viewpoint` is position and quaternion w x y z of the sensor. None at the origin."""

    fields: list[Field]
    width: int
    height: int
    encoding: str
    size: int
    line_count: int
    viewpoint: tuple[float, ...] | None = None

    @property
    def point_count(self) -> int:
        return self.width * self.height

    @property
    def point_bytes(self) -> int:
        return sum(field.byte_count for field in self.fields)


def read_header(path: FilePath, source: Source) -> PcdHeader:
    lines, size, line_count = _header_lines(path, source)
    words, line = lines["DATA"]
    if len(words) != 1 or words[0] not in ENCODINGS:
        raise FileError(
            path,
            f"unknown encoding {' '.join(words)[:60]!r}; supported are {', '.join(ENCODINGS)}",
            where=f"line {line}",
        )
    encoding = words[0]
    words, line = lines.get("VERSION", (["0.7"], 0))
    if len(words) != 1 or words[0] not in _VERSIONS:
        raise FileError(
            path, f"unknown version {' '.join(words)[:60]!r}; supported are 0.5 to 0.7", where=f"line {line}"
        )
    viewpoint = _parse_viewpoint(path, lines)
    width, height = _parse_extent(path, lines)
    return PcdHeader(_parse_fields(path, lines), width, height, encoding, size, line_count, viewpoint)


def _header_lines(path: FilePath, source: Source) -> tuple[_Lines, int, int]:
    """Words and line number by keyword, the offset after the DATA line, and the number of header lines."""
    lines: _Lines = {}
    begin = number = 0
    while "DATA" not in lines:
        number += 1
        where = f"line {number}"
        end = source.find(b"\n", begin, MAX_HEADER_BYTES)
        stop = end if end >= 0 else min(len(source), MAX_HEADER_BYTES)
        try:
            line = bytes(source[begin:stop]).decode("utf-8").strip()
        except UnicodeDecodeError as error:
            location = f"{where}, byte {begin + error.start}"
            raise FileError(path, "the header is not UTF-8 text (or this is not a PCD file)", where=location) from error
        if line and not line.startswith("#"):
            key, *words = line.split()
            key = "FIELDS" if key == "COLUMNS" else key
            if key not in _KEYS:
                what = "unknown header line" if lines else "is not a PCD file: it begins with"
                raise FileError(path, f"{what} {line[:60]!r}", where=where)
            if key in lines:
                raise FileError(path, f"a second {key} line", where=where)
            lines[key] = (words, number)
        if end < 0 and "DATA" not in lines:
            raise FileError(path, "the header has no DATA line", where=where)
        begin = stop + (1 if end >= 0 else 0)
    return lines, begin, number


def _parse_fields(path: FilePath, lines: _Lines) -> list[Field]:
    names, line = _require(path, lines, "FIELDS")
    columns: dict[str, list[str]] = {"COUNT": ["1"] * len(names)}
    numbers: dict[str, int] = {"COUNT": line}
    for key in ("SIZE", "TYPE", "COUNT"):
        if key != "COUNT" or key in lines:
            columns[key], numbers[key] = _require(path, lines, key)
        if len(columns[key]) != len(names):
            reason = f"{key} has {len(columns[key])} entries for {len(names)} fields"
            raise FileError(path, reason, where=f"line {numbers[key]}")
    fields: list[Field] = []
    seen: set[str] = set()
    for k, name in enumerate(names):
        if name in seen and name != "_":
            raise FileError(path, f"field {name!r} is declared twice", where=f"line {line}")
        seen.add(name)
        code = columns["TYPE"][k].lower() + columns["SIZE"][k]
        if code not in _TYPES.get(columns["TYPE"][k], "").split():
            reason = f"field {name!r} has the unknown type {columns['TYPE'][k]!r} of size {columns['SIZE'][k]!r}"
            raise FileError(path, reason, where=f"line {numbers['TYPE']}")
        count = parse_count(
            path, columns["COUNT"][k], f"the COUNT of field {name!r}", numbers["COUNT"], maximum=_MAX_COMPONENTS
        )
        if count < 1:
            raise FileError(path, f"field {name!r} has a COUNT of 0", where=f"line {numbers['COUNT']}")
        fields.append(Field(name, np.dtype(code).newbyteorder("<"), count))
    spelled = roles_in_lower_case(names, _ROLES)
    return [replace(field, name=spelled.get(field.name, field.name)) for field in fields]


def _parse_extent(path: FilePath, lines: _Lines) -> tuple[int, int]:
    """Width and height, checked against POINTS. Older files may omit some of the three, or have 0 for a grid."""
    numbers = {key: _parse_one(path, lines, key) for key in ("WIDTH", "HEIGHT", "POINTS") if key in lines}
    height = numbers.get("HEIGHT", 1)
    if "WIDTH" not in numbers:
        if "POINTS" not in numbers or height != 1:
            raise FileError(path, "the header has no WIDTH line")
        return numbers["POINTS"], 1
    width = numbers["WIDTH"]
    points = numbers.get("POINTS", width * height)
    if width * height == 0 and points:  # as PCL where HEIGHT is 0, and Open3D
        message = f"{path}: WIDTH x HEIGHT is 0, so that the {points} points of POINTS are one row"
        warnings.warn(escaped(message), UserWarning, stacklevel=5)
        return points, 1
    if points != width * height:
        raise FileError(
            path, f"POINTS is {points}, but WIDTH x HEIGHT is {width * height}", where=f"line {lines['POINTS'][1]}"
        )
    return width, height


def _parse_one(path: FilePath, lines: _Lines, key: str) -> int:
    words, line = lines[key]
    if len(words) != 1:
        raise FileError(path, f"{key}: expected one number, got {' '.join(words)[:60]!r}", where=f"line {line}")
    return parse_count(path, words[0], key, line)


def _require(path: FilePath, lines: _Lines, key: str) -> tuple[list[str], int]:
    if key not in lines:
        raise FileError(path, f"the header has no {key} line")
    return lines[key]


def _parse_viewpoint(path: FilePath, lines: _Lines) -> tuple[float, ...] | None:
    if "VIEWPOINT" not in lines:
        return None
    words, line = lines["VIEWPOINT"]
    try:
        numbers = tuple(float(word) for word in words)
    except ValueError:
        numbers = ()
    if len(numbers) != 7 or not all(map(math.isfinite, numbers)):
        raise FileError(path, f"VIEWPOINT: expected 7 numbers, got {' '.join(words)[:60]!r}", where=f"line {line}")
    return None if numbers in (IDENTITY_VIEWPOINT, (0.0,) * 7) else numbers
