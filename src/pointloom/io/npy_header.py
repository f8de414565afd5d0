"""Validate .npy headers before NumPy evaluates them, since Python warns for damaged literals.

Only a process-wide filter could silence these warnings. NEP 1, "A simple file format for NumPy arrays".
"""

from __future__ import annotations

import re
import struct
from typing import IO

import numpy as np

_LENGTH_FORMATS = {(1, 0): "<H", (2, 0): "<I"}
_MAX_LENGTH = 10_000  # [B] NumPy's own limit for untrusted files
MAX_HEADER_BYTES = 12 + _MAX_LENGTH  # with the signature, the version and the length
# Possessive quantifiers: without them, a damaged header takes time that is exponential in its length.
_EXTENT = r"(?:[0-9]{1,19}+L?|True|False)"  # 19 digits: more than any count needs
_VALUE = rf"'[^'\\]*+'|True|False|\((?:\s*+{_EXTENT}\s*+,?)*+\s*+\)"
_HEADER = re.compile(rf"\s*+\{{(?:\s*+'\w++'\s*+:\s*+(?:{_VALUE})\s*+,?)*+\s*+\}}\s*+")
_STRUCTURED = re.compile(r"\s*\{\s*'descr'\s*:\s*\[")


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
