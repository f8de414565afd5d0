"""Copy records and header identification from another LAS file.

Records on point layout (extra bytes, LASzip, COPC) are rewritten. Waveforms (not read) and spatial indexes (point order
may change) are dropped with a warning.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from types import ModuleType
from typing import Any

from ...core.coordinate_systems import is_same_crs
from ...core.errors import FileError, FilePath
from ...core.units import is_same, warn_of_units
from ..columns import warn_of_loss
from ..table import PointTable
from .copc import COPC_HIERARCHY, COPC_INFO
from .las_crs import NO_NAME, WKT_BIT, WKT_RECORD, crs_of
from .las_extra import EXTRA_BYTES, TITLE, join_ranges, value_record
from .las_header import PROJECTION, SPEC, LasHeader, LasRecord
from .las_units import units_of
from .las_wkt import text_of_keys, wkt_of
from .laszip import LASZIP_RECORD as LASZIP

GPS_TIME_BIT = 1
_WAVEFORM_BITS, _SYNTHETIC_RETURNS_BIT = 2 | 4, 8
FIRST_OF_1_4 = 6  # point format
_MAX_RECORD_BYTES = 0xFFFF
_LIBLAS_WKT = ("liblas", WKT_RECORD)  # where libLAS stored WKT before LAS 1.4 defined a record

_LAYOUT = (EXTRA_BYTES, LASZIP, COPC_INFO, COPC_HIERARCHY)
_WAVEFORM_RECORDS = {*range(100, 355), 65535}  # record ids of LASF_Spec: waveform descriptors and waveform data
_SPATIAL_INDEX = ("LAStools", 30)


def needs_1_4(like: LasHeader) -> bool:
    """True if a file's records require LAS 1.4: a WKT coordinate system or extended records."""
    return bool(like.encoding & WKT_BIT) or any(_is_extended(record) for record in _carried(like))


def _is_extended(record: LasRecord) -> bool:
    return record.extended or len(record.data) > _MAX_RECORD_BYTES


def _key(record: LasRecord) -> tuple[str, int]:
    return record.user_id, record.record_id


def _is_projection(record: LasRecord) -> bool:
    return record.user_id == PROJECTION or _key(record) == _LIBLAS_WKT


def _is_waveform(record: LasRecord) -> bool:
    return record.user_id == SPEC and record.record_id in _WAVEFORM_RECORDS


def _carried(like: LasHeader) -> list[LasRecord]:
    records = [record for record in like.records if _key(record) not in (*_LAYOUT, _SPATIAL_INDEX)]
    return [record for record in records if not _is_waveform(record)]


def system_of(header: LasHeader) -> LasHeader:
    """A header with only coordinate system, steps and GPS time type, for points that are not from one file alone."""
    records = tuple(record for record in header.records if _is_projection(record))
    encoding = header.encoding & (GPS_TIME_BIT | WKT_BIT)
    no_origin = {"source_id": 0, "guid": bytes(16), "system": "", "software": "", "created": None}
    return replace(header, records=records, encoding=encoding, **no_origin)


def own_records(header: LasHeader) -> list[str]:
    """Names of copied records other than the coordinate system, such as "LAStools 10"."""
    return [f"{record.user_id} {record.record_id}" for record in _carried(header) if not _is_projection(record)]


def for_tiles(header: LasHeader, layout: Any, *, is_only: bool) -> LasHeader:
    """The template header of tiles. Other records and identification are kept only if there `is_only` one file.
    Extra dimensions of `layout` keep their descriptions, in fixed types."""
    base = replace(header, encoding=header.encoding & ~_WAVEFORM_BITS) if is_only else system_of(header)
    content, size = value_record(layout)
    length = layout.size - layout.num_extra_bytes + size
    return replace(base, records=(*_carried(base), LasRecord(*EXTRA_BYTES, content)), record_length=length)


def left_out_of(like: LasHeader) -> list[str]:
    waveforms = like.encoding & _WAVEFORM_BITS or any(map(_is_waveform, like.records))
    index = any(_key(record) == _SPATIAL_INDEX for record in like.records)
    return ["waveforms"] * bool(waveforms) + ["spatial index (record LAStools 30)"] * index


def describe_together(laspy: ModuleType, header: Any, headers: Iterable[LasHeader]) -> None:
    """Set the extra bytes record of files with equal dimensions, with joint ranges."""
    records = [record for one_header in headers if (record := one_header.find(*EXTRA_BYTES)) is not None]
    if records:
        other_records = [record for record in header.vlrs if (record.user_id, record.record_id) != EXTRA_BYTES]
        header.vlrs[:] = [*other_records, laspy.VLR(*EXTRA_BYTES, TITLE, join_ranges(records))]


def take_over(laspy: ModuleType, path: FilePath, header: Any, like: LasHeader) -> Any:
    """Copy identification, records and GPS time type to laspy's header. Returns the extended records.
    GeoTIFF keys become WKT in point formats of LAS 1.4. Warns of dropped records."""
    header.global_encoding.value = like.encoding & (GPS_TIME_BIT | WKT_BIT | _SYNTHETIC_RETURNS_BIT)
    header.file_source_id = like.source_id
    for name, text in (("system_identifier", like.system), ("generating_software", like.software)):
        if text:
            setattr(header, name, _ascii(text))
    if like.created is not None:
        header.creation_date = like.created
    header.uuid = type(header.uuid)(bytes_le=like.guid)
    if lost := left_out_of(like):
        warn_of_loss(path, f"{' and the '.join(lost)} of the source", "copies contain only points and other records")
    extended, carried = laspy.vlrs.vlrlist.VLRList(), _carried(like)
    text = text_of_keys(path, like) if header.point_format.id >= FIRST_OF_1_4 else None
    if text is not None:
        header.global_encoding.value |= WKT_BIT
        others = (record for record in carried if not _is_projection(record))
        carried = [LasRecord(PROJECTION, WKT_RECORD, text), *others]
    for record in carried:
        is_extended = _is_extended(record)
        target, data = extended if is_extended else header.vlrs, bytes(record.data)
        target.append(laspy.VLR(_ascii(record.user_id), record.record_id, _ascii(record.description), data))
    return extended


def _ascii(text: str) -> str:
    """Text restricted to the characters of LAS fields."""
    return text.encode("ascii", "replace").decode()


def system_record(laspy: ModuleType, path: FilePath, table: PointTable, like: LasHeader | None) -> Any:
    """The record of the coordinate system, or of the unit alone, unless `like` has a system. Warns if the unit differs.

    Raises:
        FileError: The coordinate system differs from that of `like`.
    """
    unit, declared_crs = table.unit, None if like is None else crs_of(like)
    if not is_same_crs(table.crs, declared_crs):
        reason = f"the coordinate system of the points is {table.crs}, that of the file in like is {declared_crs}"
        raise FileError(path, reason, remedy="Call reproject, or set crs if one of them is wrong")
    if table.crs is not None and declared_crs is None and (text := wkt_of(path, table.crs)):
        return laspy.VLR(PROJECTION, WKT_RECORD, "", text.encode("utf-8") + b"\0")
    if like is not None:
        declared = units_of(like).plane
        if not is_same(unit, declared):
            warn_of_units(
                f"{path}: coordinates in {unit} are written under the coordinate system of a file in {declared}: "
                f'cloud.to_unit("{declared}") converts them'
            )
        return None
    if unit is None or unit.meters is None:
        return None
    name = unit.name.replace('"', '""')
    axes = 'AXIS["Easting",EAST],AXIS["Northing",NORTH]'
    text = f'LOCAL_CS["{NO_NAME}",LOCAL_DATUM["{NO_NAME}",0],UNIT["{name}",{unit.meters!r}],{axes}]'
    return laspy.VLR(PROJECTION, WKT_RECORD, "", text.encode("ascii") + b"\0")
