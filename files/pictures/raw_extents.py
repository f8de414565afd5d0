"""Whether all pixels that a TIFF or DNG promises lie in its file: strips and tiles of each of its directories.

What is read is the table of contents alone (TIFF 6.0, Adobe 1992; SubIFDs of the DNG specification, chapter 4).
"""

from __future__ import annotations

import struct
from collections.abc import Iterator

from ...core.errors import FileError, FilePath

_MAGIC = {b"II*\0": "<", b"MM\0*": ">"}
_SIZES = {1: 1, 2: 1, 3: 2, 4: 4, 5: 8, 6: 1, 7: 1, 8: 2, 9: 4, 10: 8, 11: 4, 12: 8, 13: 4}  # bytes of each TIFF type
_FORMS = {1: "B", 3: "H", 4: "I", 13: "I"}
_PARTS = ((273, 279), (324, 325))  # offsets and lengths of strips, of tiles
_SUB = 330  # directories below one
_MOST = 64  # directories: a DNG has some five; more, or a ring of them, is damage
_AGAIN = "Fetch or write the file again"


def check_extents(path: FilePath, data: bytes) -> None:
    """Refuse a file that ends before its pixels do.

    Raises:
        FileError: Cut off, damaged, or no TIFF.
    """
    order = _MAGIC.get(data[:4])
    if order is None:
        raise FileError(path, "is no DNG", where="byte 0", remedy="Convert it to PNG or JPEG")
    try:
        for entries in _directories(data, order):
            for offsets, lengths in _PARTS:
                for start, count in zip(entries.get(offsets, ()), entries.get(lengths, ()), strict=False):
                    if start + count > len(data):
                        raise FileError(path, f"cut off: {len(data)} bytes, of {start + count}", remedy=_AGAIN)
    except (struct.error, IndexError, ValueError) as error:
        if isinstance(error, FileError):
            raise
        raise FileError(path, "cut off or damaged: its table of contents makes no sense", remedy=_AGAIN) from error


def _directories(data: bytes, order: str) -> Iterator[dict[int, tuple[int, ...]]]:
    waiting, seen = [struct.unpack_from(f"{order}I", data, 4)[0]], set[int]()
    while waiting:
        place = waiting.pop()
        if not place or place in seen:
            continue
        seen.add(place)
        if len(seen) > _MOST:
            raise ValueError("too many directories")
        (count,) = struct.unpack_from(f"{order}H", data, place)
        entries = dict(_entry(data, order, place + 2 + 12 * k) for k in range(count))
        waiting += [*struct.unpack_from(f"{order}I", data, place + 2 + 12 * count), *entries.get(_SUB, ())]
        yield entries


def _entry(data: bytes, order: str, place: int) -> tuple[int, tuple[int, ...]]:
    """The tag of an entry and its whole numbers; none of other types."""
    tag, kind, count = struct.unpack_from(f"{order}HHI", data, place)
    if kind not in _FORMS or tag not in (_SUB, *(tag for pair in _PARTS for tag in pair)):
        return tag, ()
    size = _SIZES[kind] * count
    where = place + 8 if size <= 4 else struct.unpack_from(f"{order}I", data, place + 8)[0]
    return tag, struct.unpack_from(f"{order}{count}{_FORMS[kind]}", data, where)
