"""The coordinate system of LAS records (WKT or GeoTIFF keys): name, and whether it is geographic.

OGC 01-009 and 18-010 (WKT). GeoTIFF 1.0, section 2.7 (keys).
"""

from __future__ import annotations

import re
import struct
import warnings

from ...core.coordinate_systems import CoordinateSystem, is_geographic_text
from ...core.errors import FilePath
from ...core.escaped_text import escaped
from .las_header import PROJECTION, LasHeader

WKT_RECORD, _GEOTIFF_KEYS_RECORD, _GEOTIFF_ASCII_RECORD = 2112, 34735, 34737
NO_NAME = "unknown"  # name of a system that only defines a unit. PROJ gives it to all systems of its own strings
_MODEL_TYPE, _GEOGRAPHIC_MODEL = 1024, 2

_FIRST_NAME = re.compile(r'\s*\w+\s*\[\s*(?:\w+\s*\[\s*)*"([^"]*)"')  # BOUNDCRS[SOURCECRS[PROJCRS["its name"

# Keys that name the system, best first: citations are text, types are EPSG codes.
_CITATION_KEYS = (3073, 1026, 2049)
_SYSTEM_KEYS, _HEIGHT_KEY = (3072, 2048), 4096
_USER_DEFINED, WKT_BIT = 32767, 16


def crs_name(header: LasHeader) -> str | None:
    """Name of the coordinate system, such as "NAD83 / UTM zone 10N" or "EPSG:26910", or None."""
    text = header.find(PROJECTION, WKT_RECORD)
    if text:
        match = _FIRST_NAME.match(text.decode("utf-8", "replace"))
        if match and match[1] and not (match[1] == NO_NAME and _is_unit(find_text(header))):
            return match[1]
    keys = find_keys(header)
    letters = (header.find(PROJECTION, _GEOTIFF_ASCII_RECORD) or b"").decode("ascii", "replace")
    for key in _CITATION_KEYS:
        location, length, begin = keys.get(key, (0, 0, 0))
        name = (
            letters[begin : begin + length].split("\0")[0].split("|")[0].strip()
            if location == _GEOTIFF_ASCII_RECORD
            else ""
        )
        if name:
            return name
    for key in _SYSTEM_KEYS:
        location, _, code = keys.get(key, (0, 0, 0))
        if key in keys and location == 0 and 0 < code < _USER_DEFINED:
            return f"EPSG:{code}"
    return None


def crs_of(header: LasHeader) -> CoordinateSystem | None:
    """The coordinate system: WKT, or the EPSG codes of GeoTIFF keys ("EPSG:25832+7837"). None for a unit alone.

    Without the WKT bit of the encoding, keys take precedence (LAS 1.4).
    """
    text, keys = find_text(header), find_keys(header)
    plane = next((code for key in _SYSTEM_KEYS if (code := _code_at(keys, key))), 0)
    height = _code_at(keys, _HEIGHT_KEY)
    if plane and not (text and header.encoding & WKT_BIT):
        return CoordinateSystem(f"EPSG:{plane}" + (f"+{height}" if height else ""))
    try:
        return None if not text or _is_unit(text) else CoordinateSystem(text)
    except ValueError:  # damaged text
        return None


def _is_unit(text: str) -> bool:
    """True if a well-known text is a local system, which defines a unit only."""
    return text.upper().startswith(("LOCAL_CS", "ENGCRS", "ENGINEERINGCRS"))


def _code_at(keys: dict[int, tuple[int, ...]], key: int) -> int:
    location, _, code = keys.get(key, (1, 0, 0))
    return code if location == 0 and 0 < code < _USER_DEFINED else 0


class GeographicWarning(UserWarning):
    """The coordinates are degrees of longitude and latitude, but operations expect lengths.

    Example:
        >>> import warnings, pointloom as loom
        >>> from pointloom.io.points.las_crs import GeographicWarning
        >>> with warnings.catch_warnings():
        ...     warnings.simplefilter("error", GeographicWarning)  # refuse such files
    """


def is_geographic(header: LasHeader) -> bool:
    text = find_text(header)
    if text:
        return is_geographic_text(text)
    location, _, value = find_keys(header).get(_MODEL_TYPE, (0, 0, 0))
    return location == 0 and value == _GEOGRAPHIC_MODEL


def warn_of_degrees(path: FilePath, is_lonlat: bool, *, stacklevel: int) -> None:
    if is_lonlat:
        message = (
            f"{path}: x and y are degrees of longitude and latitude, not lengths: project_to_utm(cloud) gives meters"
        )
        warnings.warn(escaped(message), GeographicWarning, stacklevel=stacklevel)


def find_text(header: LasHeader) -> str:
    return (header.find(PROJECTION, WKT_RECORD) or b"").decode("utf-8", "replace").strip("\0 \n")


def find_keys(header: LasHeader) -> dict[int, tuple[int, ...]]:
    """GeoTIFF keys: location of each value, count, and the value or its offset."""
    directory = header.find(PROJECTION, _GEOTIFF_KEYS_RECORD) or b""
    numbers = struct.unpack(f"<{len(directory) // 2}H", directory[: len(directory) // 2 * 2])
    return {numbers[k]: numbers[k + 1 : k + 4] for k in range(4, len(numbers) - 3, 4)}
