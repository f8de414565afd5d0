"""Validate .npy headers before NumPy evaluates them, since Python warns for damaged literals.

Only a process-wide filter could silence these warnings. NEP 1, "A simple file format for NumPy arrays".
"""

from __future__ import annotations

import re
import struct
from typing import IO

import numpy as np

from ..core.errors import FileError, FilePath
from .source import SourceFile, check_end

_LENGTH_FORMATS = {(1, 0): "<H", (2, 0): "<I"}
_MAX_LENGTH = 10_000  # [B] NumPy's own limit for untrusted files
MAX_HEADER_BYTES = 12 + _MAX_LENGTH  # with the signature, the version and the length
# Possessive quantifiers: without them, a damaged header takes time that is exponential in its length.
_EXTENT = r"(?:[0-9]{1,19}+L?|True|False)"  # 19 digits: more than any count needs
_VALUE = rf"'[^'\\]*+'|True|False|\((?:\s*+{_EXTENT}\s*+,?)*+\s*+\)"
_HEADER = re.compile(rf"\s*+\{{(?:\s*+'\w++'\s*+:\s*+(?:{_VALUE})\s*+,?)*+\s*+\}}\s*+")
_STRUCTURED = re.compile(r"\s*\{\s*'descr'\s*:\s*\[")


_FIELD = re.compile(r"\('([^'\\]*)', '([<>|](?:[biu]1|[iuf][248])|\|V\d{1,4})'(?:, \((\d{1,4}),?\))?\)(?:, |,)?")
_FIELDS = re.compile(r"\{'descr': \[(.*)\], 'fortran_order': (?:True|False), 'shape': \(([0-9]{1,19}),\),? ?\}\s*")


def read_structured_header(path: FilePath, source: SourceFile) -> tuple[int, int, np.dtype] | None:
    """The first byte, the number and the type of the rows of a structured array of numbers. None for other arrays."""
    text, begin = _header_text(source)
    if not _STRUCTURED.match(text):
        return None
    found = _FIELDS.fullmatch(text)
    fields, at = [], 0
    while found and at < len(found[1]):
        field = _FIELD.match(found[1], at)
        if field is None:
            break
        fields.append((field[1], np.dtype(field[2]), (int(field[3]),) if field[3] else ()))
        at = field.end()
    if found is None or at < len(found[1]) or not fields or len({name for name, *_ in fields if name}) < 1:
        raise FileError(path, "the header of the structured array is damaged, or it has other fields than numbers")
    names = [name or f"padding {k}" for k, (name, *_) in enumerate(fields)]
    if len(set(names)) < len(names):
        raise FileError(path, f"the structured array has a field twice: {', '.join(names[:10])}")
    dtype = np.dtype([(name, kind, shape) for name, (_, kind, shape) in zip(names, fields, strict=True)])
    count, left = int(found[2]), len(source) - begin
    if count * dtype.itemsize > left:
        reason = f"{count} rows of {dtype.itemsize} bytes need {count * dtype.itemsize} bytes, but it has {left}"
        raise FileError(path, reason, where=f"byte {begin}")
    check_end(path, source, begin + count * dtype.itemsize)
    return begin, count, dtype


def _header_text(source: SourceFile) -> tuple[str, int]:
    """The header's text and the byte after it. Empty if there is no valid header."""
    head = source[0:MAX_HEADER_BYTES]
    version = (head[6], head[7]) if head[:6] == b"\x93NUMPY" and len(head) > 12 else (0, 0)
    if version not in _LENGTH_FORMATS:
        return "", 0
    size = struct.calcsize(_LENGTH_FORMATS[version])
    length = struct.unpack(_LENGTH_FORMATS[version], head[8 : 8 + size])[0]
    end = 8 + size + length
    return (head[8 + size : end].decode("latin-1"), end) if end <= len(head) else ("", 0)


def read_npy_header(stream: IO[bytes]) -> tuple[tuple[int, ...], bool, np.dtype]:
    """Shape, Fortran order and type of the next array (`void` if structured). Raises NumPy's errors of any class."""
    begin = stream.tell()
    version = np.lib.format.read_magic(stream)
    if version not in _LENGTH_FORMATS:
        raise ValueError(f"unknown version {version} of the .npy format")
    size = struct.calcsize(_LENGTH_FORMATS[version])
    field = stream.read(size)
    length = struct.unpack(_LENGTH_FORMATS[version], field)[0] if len(field) == size else 0
    if length > _MAX_LENGTH:
        raise ValueError(f"a header of {length} bytes, expected at most {_MAX_LENGTH}")
    text = stream.read(length).decode("latin-1")
    if _STRUCTURED.match(text):
        return (), False, np.dtype("V")
    if not _HEADER.fullmatch(text):
        raise ValueError(f"its text is not one of .npy: {text[:80]!r}")
    stream.seek(begin + 8)
    read = np.lib.format.read_array_header_1_0 if version == (1, 0) else np.lib.format.read_array_header_2_0
    return read(stream)  # type: ignore[arg-type]
