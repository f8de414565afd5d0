"""Convert GeoTIFF keys to WKT, as required by LAS 1.4 point formats 6 and up, with pyproj.

Only EPSG systems with matching units are converted, not user-defined ones. ASPRS, LAS Specification 1.4-R15, section
2.4. GeoTIFF 1.0, section 2.7.
"""

from __future__ import annotations

import warnings
from dataclasses import replace
from typing import Any

from ...core.coordinate_systems import CoordinateSystem, pyproj_crs
from ...core.errors import FileError, FilePath, PointloomError
from ...core.escaped_text import escaped
from ...core.units import LengthUnit
from ..optional_imports import import_for
from .las_crs import WKT_RECORD, crs_name, find_keys, find_text
from .las_header import PROJECTION, LasHeader, LasRecord
from .las_units import units_of

_PROJECTED_KEY, _GEOGRAPHIC_KEY, _VERTICAL_KEY = 3072, 2048, 4096
_USER_DEFINED, _WKT_BIT = 32767, 16
MAX_UNIT_DIFFERENCE = 1e-9  # of a unit's length


class LostSystemWarning(UserWarning):
    """A coordinate system could not be converted to the new file's format.

    Example:
        >>> import warnings, pointloom as loom
        >>> from pointloom.io.points.las_wkt import LostSystemWarning
        >>> with warnings.catch_warnings():
        ...     warnings.simplefilter("error", LostSystemWarning)  # refuse that
    """


def text_of_keys(path: FilePath, header: LasHeader) -> bytes | None:
    """The keys as WKT version 1, which LAS readers support. None, with a warning, if there is no equivalent."""
    keys = find_keys(header)
    if find_text(header) or header.encoding & _WKT_BIT or not keys:  # with the bit set, keys are ignored
        return None
    codes = [_code(keys, key) for key in (_PROJECTED_KEY, _GEOGRAPHIC_KEY)]
    code = next((code for code in codes if code), 0)
    if not code or _is_user_defined(keys, _PROJECTED_KEY):
        return _lost(header, "its keys describe a system that the EPSG register does not name")
    try:
        pyproj: Any = import_for(path, "pyproj", "geo")
    except FileError as error:
        return _lost(header, str(error))
    try:
        system = _registered(pyproj, code)
        height = _code(keys, _VERTICAL_KEY)
        heights: Any = _registered(pyproj, height) if height else None
    except ValueError as error:
        return _lost(header, str(error))
    units, is_2d = units_of(header), heights is None
    if _is_user_defined(keys, _VERTICAL_KEY):
        return _lost(header, "its keys describe heights that the EPSG register does not name")
    if system.is_projected and not _counts_in(system, units.plane):
        return _lost(header, f"its keys declare {units.plane}, but EPSG:{code} uses {system.axis_info[0].unit_name}")
    if not (is_2d or _counts_in(heights, units.height)):
        return _lost(
            header,
            f"its keys declare heights in {units.height}, but EPSG:{height} uses {heights.axis_info[0].unit_name}",
        )
    if is_2d and units.height not in (None, units.plane):
        return _lost(header, f"its keys declare heights in {units.height} without a height system")
    if not is_2d:
        system = pyproj.crs.CompoundCRS(f"{system.name} + {heights.name}", [system, heights])
    return system.to_wkt("WKT1_GDAL").encode("utf-8") + b"\0"


def wkt_of(path: FilePath, crs: CoordinateSystem) -> str | None:
    """A system as well-known text: its own, else by pyproj in version 1. None, with a warning, if there is none."""
    if crs.text.endswith(("]", ")")):
        return crs.text
    try:
        return str(pyproj_crs("crs", crs).to_wkt("WKT1_GDAL"))
    except (PointloomError, ValueError) as error:
        message = f"{path}: the coordinate system {crs.name} is not written: {error}"
        warnings.warn(escaped(message), LostSystemWarning, stacklevel=2)
        return None


def _registered(pyproj: Any, code: int) -> Any:
    try:
        return pyproj.CRS.from_epsg(code)
    except pyproj.exceptions.CRSError as error:
        raise ValueError(f"pyproj does not contain EPSG:{code}: {error}") from error


def _counts_in(system: Any, unit: LengthUnit | None) -> bool:
    factor = system.axis_info[0].unit_conversion_factor
    return unit is None or not unit.meters or abs(unit.meters / factor - 1) <= MAX_UNIT_DIFFERENCE


def with_system(header: LasHeader, text: str) -> LasHeader:
    other_records = tuple(record for record in header.records if record.user_id != PROJECTION)
    record = LasRecord(PROJECTION, WKT_RECORD, text.encode("utf-8") + b"\0")
    return replace(header, records=(*other_records, record), encoding=header.encoding | _WKT_BIT)


def _code(keys: dict[int, tuple[int, ...]], key: int) -> int:
    location, _, code = keys.get(key, (1, 0, 0))
    return code if location == 0 and 0 < code < _USER_DEFINED else 0


def _is_user_defined(keys: dict[int, tuple[int, ...]], key: int) -> bool:
    return keys.get(key, (1, 0, 0))[::2] == (0, _USER_DEFINED)


def _lost(header: LasHeader, reason: str) -> None:
    name = crs_name(header) or "of its keys"
    message = f"the coordinate system {name} is written only as GeoTIFF keys, which many readers ignore in point "
    warnings.warn(escaped(f"{message}formats of LAS 1.4: {reason}"), LostSystemWarning, stacklevel=2)
