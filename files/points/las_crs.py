"""What a LAS file's records say of its coordinate system: well-known text, or GeoTIFF keys.

Only the name is read, to be shown, and whether the coordinates are degrees; las_units.py reads the unit. A cloud keeps
the unit, and not the system.

Source: OGC 01-009 and 18-010 (well-known text); GeoTIFF 1.0, section 2.7 (keys).
"""

from __future__ import annotations

import re
import struct
import warnings
from typing import Any

from ...core.escaped_text import escaped
from .las_header import PROJECTION, LasHeader

WKT, _KEYS, _ASCII = 2112, 34735, 34737
NO_NAME = "unknown"  # of a system that is written to tell a unit alone
_MODEL_TYPE, _GEOGRAPHIC = 1024, 2

# A system of longitude and latitude is named so in both versions of well-known text; a projected one holds such a name
# further in, behind its own.
_PROJECTED_WORDS = re.compile(r"\b(PROJCS|PROJCRS|PROJECTEDCRS|GEOCCS)\s*\[", re.IGNORECASE)
_GEOGRAPHIC_WORDS = re.compile(r"\b(GEOGCS|GEOGCRS|GEOGRAPHICCRS)\s*\[", re.IGNORECASE)

# What names the system, best first: the citations are text, the types numbers of the EPSG register.
_CITATIONS = (3073, 1026, 2049)
_TYPES = (3072, 2048)
_USER_DEFINED = 32767


def crs_name(header: LasHeader) -> str | None:
    """The name of the coordinate system, such as "NAD83 / UTM zone 10N" or "EPSG:26910"; None where none is told."""
    text = header.find(PROJECTION, WKT)
    if text:
        found = re.match(r'\s*\w+\s*\[\s*"([^"]*)"', text.decode("utf-8", "replace"))
        if found and found[1] not in ("", NO_NAME):
            return found[1]
    keys = find_keys(header)
    letters = (header.find(PROJECTION, _ASCII) or b"").decode("ascii", "replace")
    for key in _CITATIONS:
        place, length, begin = keys.get(key, (0, 0, 0))
        name = letters[begin : begin + length].split("\0")[0].split("|")[0].strip() if place == _ASCII else ""
        if name:
            return name
    for key in _TYPES:
        place, _, code = keys.get(key, (0, 0, 0))
        if key in keys and place == 0 and 0 < code < _USER_DEFINED:
            return f"EPSG:{code}"
    return None


class GeographicWarning(UserWarning):
    """The coordinates of a file are degrees of longitude and latitude, which operations take for lengths.

    Example:
        >>> import warnings, pointloom as loom
        >>> from pointloom.files.points.las_crs import GeographicWarning
        >>> with warnings.catch_warnings():
        ...     warnings.simplefilter("error", GeographicWarning)  # refuse such files
    """


def is_geographic(header: LasHeader) -> bool:
    """Whether the records say that x and y are longitude and latitude; False where they say nothing."""
    text = find_text(header)
    if text:
        return bool(_GEOGRAPHIC_WORDS.search(text)) and not _PROJECTED_WORDS.search(text)
    place, _, value = find_keys(header).get(_MODEL_TYPE, (0, 0, 0))
    return place == 0 and value == _GEOGRAPHIC


def warn_of_degrees(path: Any, is_lonlat: bool, *, stacklevel: int) -> None:
    """Say that x and y are degrees, if they are."""
    if is_lonlat:
        message = (
            f"{path}: x and y are degrees of longitude and latitude, not lengths: project_to_utm(cloud) gives metres"
        )
        warnings.warn(escaped(message), GeographicWarning, stacklevel=stacklevel)


def find_text(header: LasHeader) -> str:
    """The well-known text; empty where there is none."""
    return (header.find(PROJECTION, WKT) or b"").decode("utf-8", "replace").strip("\0 \n")


def find_keys(header: LasHeader) -> dict[int, tuple[int, ...]]:
    """GeoTIFF's keys: where each value is, of how many parts, and the value itself or its place there."""
    directory = header.find(PROJECTION, _KEYS) or b""
    numbers = struct.unpack(f"<{len(directory) // 2}H", directory[: len(directory) // 2 * 2])
    return {numbers[k]: numbers[k + 1 : k + 4] for k in range(4, len(numbers) - 3, 4)}
