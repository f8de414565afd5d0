"""The name of a LAS file's coordinate system, from its records: well-known text, or GeoTIFF keys.

Only the name is read, to be shown; a cloud keeps neither the system nor its unit.

Source: OGC 01-009 and 18-010 (well-known text); GeoTIFF 1.0, section 2.7 (keys).
"""

from __future__ import annotations

import re
import struct

from .las_header import PROJECTION, LasHeader

_WKT, _KEYS, _ASCII = 2112, 34735, 34737

# What names the system, best first: the citations are text, the types numbers of the EPSG register.
_CITATIONS = (3073, 1026, 2049)
_TYPES = (3072, 2048)
_USER_DEFINED = 32767


def crs_name(header: LasHeader) -> str | None:
    """The name of the coordinate system, such as "NAD83 / UTM zone 10N" or "EPSG:26910"; None where none is told."""
    text = header.find(PROJECTION, _WKT)
    if text:
        found = re.match(r'\s*\w+\s*\[\s*"([^"]*)"', text.decode("utf-8", "replace"))
        if found and found[1]:
            return found[1]
    directory = header.find(PROJECTION, _KEYS) or b""
    numbers = struct.unpack(f"<{len(directory) // 2}H", directory[: len(directory) // 2 * 2])
    keys = {numbers[k]: numbers[k + 1 : k + 4] for k in range(4, len(numbers) - 3, 4)}
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
