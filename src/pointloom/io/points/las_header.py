"""The header and records of a LAS or LAZ file, validated against the file size before use.

ASPRS, LAS Specification 1.4-R15 (tables 1 to 8), and LAS 1.5 (2025): times of GPS and their offset in the header.
"""

from __future__ import annotations

import math
import struct
from dataclasses import dataclass
from datetime import date, timedelta
from typing import Any

from ...core.coordinates import FLOAT32_MAX
from ...core.errors import FileError, FilePath
from ...core.units import warn_of_units
from ..source import SourceFile, SourcePart

# Header bytes by minor version.
_HEADER_BYTES = {0: 227, 1: 227, 2: 227, 3: 235, 4: 375, 5: 393}

# Bytes per point by point format, without extra bytes. 6 and above are of version 1.4.
_RECORD_BYTES = {0: 20, 1: 28, 2: 26, 3: 34, 4: 57, 5: 63, 6: 30, 7: 36, 8: 38, 9: 59, 10: 67}
_FIRST_NEW_FORMAT = 6

_HEADER = struct.Struct("<4sHH16sBB32s32sHHHIIBHI20s12d")
_RECORD_HEADER = struct.Struct("<H16sHH32s")
_EXTENDED_HEADER = struct.Struct("<H16sHQ32s")

# Bit 7 of the point format marks LASzip. Bit 6 marked an obsolete predecessor.
_COMPRESSED_BIT = 0x80

# Both bits: times are GPS time minus 1e6 times the field at this byte. The first alone: minus _ADJUSTED [s].
_OFFSET_TIME_BITS, _TIME_OFFSET, _ADJUSTED = 1 | 1 << 6, 391, 1e9

PROJECTION = "LASF_Projection"  # user id of the coordinate system records
SPEC = "LASF_Spec"


@dataclass(frozen=True)
class LasRecord:
    """A variable-length record; `data` of extended records is read when needed, except for the coordinate system."""

    user_id: str
    record_id: int
    data: bytes | SourcePart
    description: str = ""
    extended: bool = False

    def __reduce__(self) -> tuple[Any, ...]:
        return LasRecord, (self.user_id, self.record_id, bytes(self.data), self.description, self.extended)


@dataclass(frozen=True)
class LasHeader:
    """A validated header.

    Attributes:
        encoding: Global encoding bits: 1 for GPS time since 1980, 16 for a WKT coordinate system.
        record_length, begin: Bytes of a point, and byte offset of the points.
        scales, offsets: Coordinate steps [unit of the file], and what is added to scaled coordinates.
        bounds: Bounding box, unverified.
        records: Variable-length records, then extended ones.
        time_shift: Seconds that convert GPS times to adjusted standard GPS time, as `encoding` promises (LAS 1.5).
    """

    version: str
    encoding: int
    point_format: int
    is_compressed: bool
    record_length: int
    point_count: int
    begin: int
    scales: tuple[float, float, float]
    offsets: tuple[float, float, float]
    bounds: tuple[tuple[float, ...], tuple[float, ...]]
    records: tuple[LasRecord, ...]
    software: str
    source_id: int
    guid: bytes
    system: str
    created: date | None
    time_shift: float = 0.0

    def find(self, user_id: str, record_id: int) -> bytes | None:
        matches = (record.data for record in self.records if (record.user_id, record.record_id) == (user_id, record_id))
        data = next(matches, None)
        return None if data is None else bytes(data)


def parse_las_header(path: FilePath, source: SourceFile) -> LasHeader:
    """The header of a file. Raises `FileError` if it is invalid or does not match the file size."""
    fields = _unpack_header(path, source)
    minor, header_bytes, begin, point_format, length = fields[5], *fields[10:12], *fields[13:15]
    extended_begin, extended_count, point_count = 0, 0, fields[15]
    waveforms = struct.unpack("<Q", source[227:235])[0] if minor >= 3 else 0
    if minor >= 4:
        extended_begin, extended_count, point_count = struct.unpack("<QIQ", source[235:255])
        _check_counts(path, fields[15], point_count)
    if not header_bytes <= begin <= len(source):
        reason = f"the points should start at byte {begin}, but the header takes {header_bytes} and the file ends"
        raise FileError(path, f"{reason} at byte {len(source)}", where="byte 96")
    is_compressed, point_format = bool(point_format & _COMPRESSED_BIT), point_format & ~_COMPRESSED_BIT
    _check_format(path, minor, point_format, length)
    scales, offsets = _check_scaling(path, fields[17:23])
    records = _read_records(path, source, _RECORD_HEADER, header_bytes, begin, fields[12])
    if not is_compressed:
        end = begin + point_count * length
        _check_extent(path, len(source), begin, length, point_count, has_trailer=bool(extended_count or waveforms))
    else:
        end = begin
    if extended_count:
        if not end <= extended_begin <= len(source):
            reason = f"its extended records should start at byte {extended_begin}, between {end} and {len(source)}"
            raise FileError(path, reason, where="byte 235")
        records += _read_records(path, source, _EXTENDED_HEADER, extended_begin, len(source), extended_count)
    high, low = fields[23::2], fields[24::2]
    return LasHeader(
        f"1.{minor}", fields[2], point_format, is_compressed, length, point_count, begin, scales, offsets,
        (low, high), tuple(records), _text(fields[7]), fields[1], fields[3], _text(fields[6]), _day_of(*fields[8:10]),
        _time_shift(path, source, minor, fields[2]),
    )  # fmt: skip


def _time_shift(path: FilePath, source: SourceFile, minor: int, encoding: int) -> float:
    """Difference of the file's offset of GPS times and that of adjusted standard GPS time [s], with a warning."""
    if minor < 5 or encoding & _OFFSET_TIME_BITS != _OFFSET_TIME_BITS:
        return 0.0
    offset = 1e6 * int.from_bytes(source[_TIME_OFFSET : _TIME_OFFSET + 2], "little")
    if offset != _ADJUSTED:
        message = f"{path}: GPS times have an offset of {offset:,.0f} s; they are converted to that of LAS 1.4, 1e9 s"
        warn_of_units(message, UserWarning)
    return offset - _ADJUSTED


def _day_of(day: int, year: int) -> date | None:
    if not (1 <= day <= 366 and 1 <= year <= 9999):
        return None
    return date(year, 1, 1) + timedelta(day - 1) if (year, day) < (9999, 366) else None


def _unpack_header(path: FilePath, source: SourceFile) -> tuple[Any, ...]:
    if source[:4] != b"LASF":
        raise FileError(path, "is not a LAS file: its first four bytes are not LASF", where="byte 0")
    if len(source) < _HEADER.size:
        reason = f"truncated: {len(source)} bytes, but the shortest header has {_HEADER.size}"
        raise FileError(path, reason, where=f"byte {len(source)}")
    fields = _HEADER.unpack(source[: _HEADER.size])
    major, minor, header_bytes = fields[4], fields[5], fields[10]
    if major != 1 or minor not in _HEADER_BYTES:
        raise FileError(
            path, f"LAS {major}.{minor} is not supported", where="byte 24", remedy="Supported are 1.0 to 1.5"
        )
    if header_bytes < _HEADER_BYTES[minor] or len(source) < _HEADER_BYTES[minor]:
        reason = f"LAS 1.{minor} has a header of {_HEADER_BYTES[minor]} bytes, but the file declares {header_bytes}"
        raise FileError(path, f"{reason} and contains {len(source)}", where="byte 94")
    return fields


def _check_counts(path: FilePath, legacy: int, count: int) -> None:
    if legacy and legacy != count:
        reason = f"the header counts {count} points in one field and {legacy} in another"
        raise FileError(path, reason, where="byte 107", remedy="Repair it with the program that wrote it")


def _check_format(path: FilePath, minor: int, point_format: int, length: int) -> None:
    if point_format not in _RECORD_BYTES:
        raise FileError(path, f"unknown point format {point_format}", where="byte 104", remedy="Supported are 0 to 10")
    if point_format >= _FIRST_NEW_FORMAT and minor < 4:
        raise FileError(path, f"point format {point_format} came with LAS 1.4, the file is 1.{minor}", where="byte 104")
    if length < _RECORD_BYTES[point_format]:
        reason = (
            f"points of {length} bytes cannot store format {point_format}, which takes {_RECORD_BYTES[point_format]}"
        )
        raise FileError(path, reason, where="byte 105")


def _check_scaling(path: FilePath, values: tuple[float, ...]) -> tuple[Any, Any]:
    scales, offsets = values[:3], values[3:]
    if not all(math.isfinite(scale) and scale > 0 for scale in scales):
        raise FileError(path, f"the scales {list(scales)} are not finite numbers above 0", where="byte 131")
    if not all(math.isfinite(offset) for offset in offsets):
        raise FileError(path, f"the offsets {list(offsets)} are not finite", where="byte 155")
    if max(abs(offset) + scale * 2**31 for scale, offset in zip(scales, offsets, strict=True)) > FLOAT32_MAX:
        reason = f"the scales {list(scales)} and offsets {list(offsets)} exceed {FLOAT32_MAX:.3g}"
        raise FileError(path, reason, where="byte 131")
    return scales, offsets


def _check_extent(path: FilePath, size: int, begin: int, length: int, count: int, *, has_trailer: bool) -> None:
    """Check the point count against the file size. Only known records may follow the points."""
    stored = (size - begin) // length
    if stored < count:
        reason = f"truncated: the header counts {count} points, the file contains {stored}"
        raise FileError(path, reason, where=f"byte {begin + stored * length}")
    if stored > count and not has_trailer:
        reason = f"the header counts {count} points, but the file contains {stored}"
        remedy = "Its writer may have been interrupted: repair the header"
        raise FileError(path, reason, where=f"byte {begin + count * length}", remedy=remedy)


def _read_records(
    path: FilePath, source: SourceFile, form: struct.Struct, begin: int, end: int, count: int
) -> list[LasRecord]:
    """The records from `begin`, none beyond `end`. Extended records are read later, except coordinate systems."""
    if count > (end - begin) // form.size:
        reason = f"{count} records cannot fit into the {end - begin} bytes from byte {begin} to {end}"
        raise FileError(path, reason, where="byte 100" if form is _RECORD_HEADER else "byte 243")
    records, at = [], begin
    for number in range(count):
        if end - at < form.size:
            raise FileError(path, f"record {number} of {count} is cut off", where=f"byte {at}")
        _, user_id, record_id, length, description = form.unpack(source[at : at + form.size])
        at += form.size
        if length > end - at:
            reason = f"record {number} of {count} has {length} bytes, but {end - at} are left"
            raise FileError(path, reason, where=f"byte {at}")
        extended, name = form is _EXTENDED_HEADER, _text(user_id)
        is_lazy = extended and name != PROJECTION
        data = SourcePart(source, at, length) if is_lazy else source[at : at + length]
        records.append(LasRecord(name, record_id, data, _text(description), extended))
        at += length
    return records


def _text(field: bytes) -> str:
    return field.split(b"\0")[0].decode("utf-8", "replace").strip()
