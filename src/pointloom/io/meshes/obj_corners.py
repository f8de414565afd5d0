"""Corners of OBJ faces: v, v/vt, v//vn or v/vt/vn, with optional empty parts (1//, 2/2/).

All corners are parsed at once. Only files with an error or numbers over 18 digits are parsed face by face.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...core.errors import FileError, FilePath

KINDS = ("vertices", "texture coordinates", "normals")

_BLANKS = bytes.maketrans(b"\t\v\f\r", b"    ")
_MAX_DIGITS = 18  # always fits int64


@dataclass
class Corners:
    """Concatenated corners of all faces: `lengths` (f,), and indices `vertices`, `uvs`, `normals` (c,), -1 for none.
    `missing` has sentences on missing "texture coordinates" and "normals"."""

    lengths: NDArray[np.int64]
    vertices: NDArray[np.int64]
    uvs: NDArray[np.int64]
    normals: NDArray[np.int64]
    missing: dict[str, str]


def read_corners(
    path: FilePath,
    faces: Sequence[bytes],
    lines: Sequence[int],
    before: Sequence[tuple[int, int, int]],
    counts: tuple[int, int, int],
) -> Corners:
    """Parse the text of `faces`; `before` are the v, vt and vn before each face, `counts` their totals."""
    parsed = _parse_all(faces)
    numbers, given, lengths = _parse_one_by_one(path, faces, lines) if parsed is None else parsed
    is_negative = numbers < 0
    indices = numbers - 1
    if is_negative.any():
        indices = np.where(is_negative, np.repeat(np.array(before), lengths, axis=0) + numbers, indices)
    bad = given & ((indices < 0) | (indices >= np.array(counts)))
    indices[~given] = -1
    missing = {}
    if bad.any():
        face_of = np.repeat(np.arange(len(lengths)), lengths)
        for column, kind in enumerate(KINDS):
            row = int(np.argmax(bad[:, column]))
            if bad[row, column]:
                where = f"line {lines[face_of[row]]}"
                reason = f"a face refers to {numbers[row, column]} of {counts[column]} {kind}"
                if column == 0:
                    raise FileError(path, reason, where=where)
                missing[kind] = f"{reason} ({where})"
    return Corners(lengths, indices[:, 0], indices[:, 1], indices[:, 2], missing)


_Parsed = tuple[NDArray[np.int64], NDArray[np.bool_], NDArray[np.int64]]


def _parse_all(faces: Sequence[bytes]) -> _Parsed | None:
    """Indices (c, 3), which are given, and corners per face. None if one is invalid."""
    text = b"\n".join([*faces, b""]).translate(_BLANKS)
    if text.translate(None, b"0123456789-/ \n"):
        return None
    codes = np.frombuffer(text, np.uint8)
    is_blank, is_slash = codes <= 32, codes == 47
    is_word = ~is_blank
    is_word[1:] &= is_blank[:-1]
    begins = is_word.copy()
    begins[1:] |= is_slash[:-1]
    ends = is_blank.copy()
    ends[0] = False
    ends[1:] &= ~is_blank[:-1]
    begin, end = np.flatnonzero(begins), np.flatnonzero(ends | is_slash)
    digits = end - begin
    firsts = np.flatnonzero(is_word[begin])
    parts = np.diff(np.append(firsts, len(begin)))
    signs = (codes[begin] == 45) & (digits > 1)
    if (
        not len(begin)
        or parts.max() > 3
        or digits.max() > _MAX_DIGITS
        or (digits[firsts] == 0).any()
        or np.count_nonzero(signs) != text.count(b"-")
    ):
        return None
    words_before = np.searchsorted(begin[firsts], np.flatnonzero(codes == 10))
    lengths = np.diff(words_before, prepend=0)
    values = np.fromstring(text.replace(b"/", b" "), np.int64, sep=" ")
    filled = digits > 0
    numbers, given = np.zeros((len(firsts), 3), np.int64), np.zeros((len(firsts), 3), bool)
    if len(begin) == len(firsts) * parts[0] and (parts == parts[0]).all():  # all of one format
        given[:, : parts[0]] = filled.reshape(-1, parts[0])
    else:
        within = np.arange(len(begin)) - np.repeat(firsts, parts)
        given[np.repeat(np.arange(len(firsts)), parts), within] = filled
    numbers[given] = values
    return numbers, given, lengths


def _parse_one_by_one(path: FilePath, faces: Sequence[bytes], lines: Sequence[int]) -> _Parsed:
    """Parse faces one by one. Raises `FileError` with the line of the first error."""
    numbers: list[list[int]] = []
    lengths = []
    for face, line in zip(faces, lines, strict=True):
        words = face.split()
        lengths.append(len(words))
        for word in words:
            numbers.append(_parse(word))
            if not numbers[-1]:
                shown = word[:40].decode("ascii", "backslashreplace")
                remedy = "Corners are v, v/vt, v//vn or v/vt/vn"
                raise FileError(path, f"not a corner of a face: {shown!r}", where=f"line {line}", remedy=remedy)
    table = np.array(numbers, np.int64).reshape(-1, 3)
    given = table != _EMPTY_PART
    return np.where(given, table, 0), given, np.array(lengths)


_EMPTY_PART = -(2**63)


def _parse(word: bytes) -> list[int]:
    parts = word.split(b"/")
    if len(parts) > 3 or not parts[0]:
        return []
    numbers = [_EMPTY_PART] * 3
    for k, part in enumerate(parts):
        digits = part.removeprefix(b"-")
        if part and not digits.isdigit():
            return []
        if part:
            size = digits.lstrip(b"0")
            size = 10**_MAX_DIGITS if len(size) > _MAX_DIGITS else int(size or b"0")
            numbers[k] = -size if part.startswith(b"-") else size
    return numbers
