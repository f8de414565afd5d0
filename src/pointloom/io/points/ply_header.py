"""The PLY header: elements, properties, payload offset.

Greg Turk, "The PLY Polygon File Format" (1994), and the later type names (int8..float64).
"""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import cache, lru_cache
from typing import Any, Literal

import numpy as np

from ...core.errors import FileError, FilePath
from ..columns import roles_in_lower_case
from ..source import HEAD_BYTES, MAX_HEADER_BYTES, Source, parse_count

#: PLY's two families of type names, as NumPy codes without byte order.
SCALAR_TYPES = {
    "char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2",
    "int": "i4", "uint": "u4", "float": "f4", "double": "f8",
    "int8": "i1", "uint8": "u1", "int16": "i2", "uint16": "u2",
    "int32": "i4", "uint32": "u4", "float32": "f4", "float64": "f8",
}  # fmt: skip

#: The type names to write: the older family, which every reader supports.
TYPE_NAMES = dict(zip(list(SCALAR_TYPES.values())[:8], SCALAR_TYPES, strict=False))

#: Properties of vertices that are recognized in any case.
_ROLES = (("x", "y", "z"), ("nx", "ny", "nz"), ("red", "green", "blue"), ("r", "g", "b"))

ByteOrder = Literal["=", "<", ">"]

_BYTE_ORDERS: dict[str, ByteOrder] = {"ascii": "=", "binary_little_endian": "<", "binary_big_endian": ">"}


@cache
def _type_of(name: str, byte_order: ByteOrder) -> np.dtype[Any]:
    return np.dtype(SCALAR_TYPES[name]).newbyteorder(byte_order)


@dataclass(frozen=True)
class Property:
    """A property of an element. A list if `count_type` is set."""

    name: str
    dtype: np.dtype[Any]
    count_type: np.dtype[Any] | None = None


@dataclass
class Element:
    name: str
    count: int
    properties: list[Property] = field(default_factory=list)

    @property
    def has_lists(self) -> bool:
        return any(prop.count_type is not None for prop in self.properties)

    @property
    def min_row_bytes(self) -> int:
        return sum((prop.count_type or prop.dtype).itemsize for prop in self.properties)


@dataclass
class PlyHeader:
    """The header: `elements` in file order, payload offset `size`, `line_count`, and `comments`."""

    ascii: bool
    elements: list[Element]
    size: int
    line_count: int
    comments: list[str] = field(default_factory=list)

    def element(self, path: FilePath, name: str) -> Element:
        for element in self.elements:
            if element.name == name:
                return element
        names = ", ".join(element.name for element in self.elements) or "none"
        raise FileError(path, f"the header declares no element {name!r} (it has: {names})")


def read_header(path: FilePath, source: Source) -> PlyHeader:
    """The header, which belongs to all files with the same one: the caller must not change it."""
    end = b"\nend_header\n"
    text, separator, _ = bytes(source[:HEAD_BYTES]).partition(end)
    if separator:
        with suppress(FileError):  # reported below with the path
            return _header_of(text + end)
    return _parse_header(path, source)


@lru_cache(maxsize=32)
def _header_of(text: bytes) -> PlyHeader:
    return _parse_header("", text)


def _parse_header(path: FilePath, source: Source) -> PlyHeader:
    lines, size = _header_lines(path, source)
    byte_order: ByteOrder | None = None
    elements: list[Element] = []
    comments: list[str] = []
    names: set[str] = set()  # of elements
    property_names: set[str] = set()  # of the last element
    for number, line in enumerate(lines[1:], start=2):
        words = line.split()
        if not words or words[0] in ("comment", "obj_info"):
            if words[:1] == ["comment"]:
                comments.append(line[len("comment") :].strip())
            continue
        if words[0] == "format":
            byte_order = _parse_format(path, words, number, again=byte_order is not None)
        elif byte_order is None:
            raise FileError(path, f"expected the format line, got {line[:60]!r}", where=f"line {number}")
        elif words[0] == "element":
            elements.append(_parse_element(path, words, number, names))
            property_names = set()
        elif words[0] == "property":
            if not elements:
                raise FileError(path, "a property precedes all elements", where=f"line {number}")
            prop = _parse_property(path, words, number, byte_order)
            what = f"property {prop.name!r} of element {elements[-1].name!r}"
            _add_name(path, property_names, prop.name, what, number)
            elements[-1].properties.append(prop)
        else:
            raise FileError(path, f"unknown header line {line[:60]!r}", where=f"line {number}")
    if byte_order is None:
        raise FileError(path, "the header has no format line")
    for element in elements:
        if element.name == "vertex":
            spelled = roles_in_lower_case([prop.name for prop in element.properties], _ROLES)
            element.properties = [replace(prop, name=spelled.get(prop.name, prop.name)) for prop in element.properties]
    return PlyHeader(byte_order == "=", elements, size, len(lines) + 1, comments)


def _header_lines(path: FilePath, source: Source) -> tuple[list[str], int]:
    start = bytes(source[:5])
    if not start.startswith(b"ply") or start[3:4] not in (b"\n", b"\r", b" ", b"\t"):
        raise FileError(path, "is not a PLY file: it does not begin with 'ply'", where="byte 0")
    newline = b"\r" if start[3:4] == b"\r" and start[4:5] != b"\n" else b"\n"
    head = bytes(source[:HEAD_BYTES])
    lines: list[str] = []
    begin = 0
    while True:
        end = head.find(newline, begin)
        if end < 0:  # beyond the head
            end = source.find(newline, begin, MAX_HEADER_BYTES)
        stop = end if end >= 0 else min(len(source), MAX_HEADER_BYTES)
        try:
            line = (head[begin:stop] if stop <= len(head) else bytes(source[begin:stop])).decode("utf-8").strip()
        except UnicodeDecodeError as error:
            location = f"line {len(lines) + 1}, byte {begin + error.start}"
            raise FileError(path, "the header is not UTF-8 text", where=location) from error
        if line == "end_header":
            return lines, stop + (1 if end >= 0 else 0)
        if end < 0:
            raise FileError(path, "the header has no end_header line", where=f"line {len(lines) + 1}")
        lines.append(line)
        begin = end + 1


def _parse_format(path: FilePath, words: list[str], number: int, *, again: bool) -> ByteOrder:
    where = f"line {number}"
    if again:
        raise FileError(path, "a second format line", where=where)
    if len(words) != 3 or words[1] not in _BYTE_ORDERS or words[2] != "1.0":
        known = ", ".join(_BYTE_ORDERS)
        raise FileError(
            path, f"unknown format {' '.join(words[1:])[:60]!r}; supported are {known}, all 1.0", where=where
        )
    return _BYTE_ORDERS[words[1]]


def _parse_element(path: FilePath, words: list[str], number: int, names: set[str]) -> Element:
    if len(words) != 3:
        reason = f"expected 'element <name> <count>', got {' '.join(words)[:60]!r}"
        raise FileError(path, reason, where=f"line {number}")
    _add_name(path, names, words[1], f"element {words[1]!r}", number)
    return Element(words[1], parse_count(path, words[2], f"the count of element {words[1]!r}", number))


def _add_name(path: FilePath, names: set[str], name: str, what: str, number: int) -> None:
    """Add a name to the previous ones. Raises `FileError` if it is one of them."""
    if name in names:
        raise FileError(path, f"{what} is declared twice", where=f"line {number}")
    names.add(name)


def _parse_property(path: FilePath, words: list[str], number: int, byte_order: ByteOrder) -> Property:
    where = f"line {number}"
    is_list = len(words) == 5 and words[1] == "list"
    if not is_list and len(words) != 3:
        forms = "'property <type> <name>' or 'property list <type> <type> <name>'"
        raise FileError(path, f"expected {forms}, got {' '.join(words)[:60]!r}", where=where)
    name = words[-1]
    for word in words[2 if is_list else 1 : -1]:
        if word not in SCALAR_TYPES:
            raise FileError(path, f"property {name!r} has the unknown type {word[:40]!r}", where=where)
    dtype = _type_of(words[-2], byte_order)
    if not is_list:
        return Property(name, dtype)
    count_type = _type_of(words[2], byte_order)
    if count_type.kind == "f":
        raise FileError(path, f"the list {name!r} is counted in {words[2]}, which is not an integer type", where=where)
    return Property(name, dtype, count_type)
