"""Coordinate systems of ground control to WGS 84: UTM by own formulas, others by pyproj.

Heights are unchanged (ellipsoid or sea level). UTM zones of ETRS89 are treated as WGS 84, within a meter.
"""

from __future__ import annotations

import re
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import shown
from ...core.escaped_text import escaped
from ...io.optional_imports import foreign_errors, import_for
from ...io.points.geodetic import system_named
from ...pcd.geodesy import MAX_ELLIPSOID_HEIGHT, from_utm
from ...pcd.geographic import NORTHERN_EPSG_BASE, SOUTHERN_EPSG_BASE

Array = NDArray[np.float64]

ETRS89_UTM_BASE = 25800  # EPSG base of the European UTM zones 28 to 38
UTM_EASTINGS, UTM_NORTHINGS = (1e5, 9e5), (0.0, 1e7)  # [m] range of a UTM zone with margins

_ZONE = re.compile(r"\bUTM\s*(?:zone\s*)?(\d{1,2})\s*([NS])?\b", re.IGNORECASE)
_PROJ_ZONE = re.compile(r"\+zone=(\d{1,2})\b")


def to_geodetic(positions: Array, crs: str, path: str) -> Array:
    """Latitude, longitude [degrees], height [m], [n, 3]; `crs`: EPSG code, ODM's "WGS84 UTM 32N", or PROJ text."""
    if (np.abs(positions[:, 2]) > MAX_ELLIPSOID_HEIGHT).any():
        raise ValueError(f"crs: expected heights below {MAX_ELLIPSOID_HEIGHT:g} m, got {positions[:, 2].max():g}")
    if (code := utm_code(crs)) is not None:
        return from_utm(_checked(positions, crs), code)
    if is_degrees(crs):
        degrees = positions[:, [1, 0, 2]]
        if (wrong := (np.abs(degrees[:, :2]) > (90.0, 180.0)).any(axis=1)).any():
            result = positions[np.flatnonzero(wrong)[0], :2].tolist()
            raise ValueError(f"crs: {escaped(crs)} is in degrees, x the longitude and y the latitude; got {result}")
        return degrees
    pyproj: Any = import_for(path, "pyproj", "geo")
    system = system_named("crs", crs)
    _check_unit(system, crs)
    with foreign_errors(path, "its coordinates cannot be transformed"):
        way = pyproj.Transformer.from_crs(system, "EPSG:4326", always_xy=True)
        longitude, latitude = way.transform(positions[:, 0], positions[:, 1], errcheck=True)
    result = np.column_stack([latitude, longitude, positions[:, 2]])
    if not np.isfinite(result).all():
        raise ValueError(f"crs: the positions are outside of {escaped(crs)}, such as {positions[0, :2].tolist()}")
    return result


def _checked(positions: Array, crs: str) -> Array:
    for k, what, (low, high) in ((0, "x", UTM_EASTINGS), (1, "y", UTM_NORTHINGS)):
        wrong = np.flatnonzero(~((positions[:, k] >= low) & (positions[:, k] <= high)))
        if len(wrong):
            raise ValueError(
                f"crs: {what} is {positions[wrong[0], k]:.10g}, and {crs} has {low:g}..{high:g} m there: x is the "
                "easting and y the northing of the zone; degrees are EPSG:4326"
            )
    return positions


def utm_code(crs: str) -> int | None:
    """EPSG code (WGS 84) of a UTM zone in common notations. None for other systems."""
    text = crs.strip()
    if match := re.fullmatch(r"EPSG:(\d{1,6})", text, re.IGNORECASE):
        code = int(match[1])
        if ETRS89_UTM_BASE + 28 <= code <= ETRS89_UTM_BASE + 38:
            return NORTHERN_EPSG_BASE + code - ETRS89_UTM_BASE
        return code if any(base < code <= base + 60 for base in (NORTHERN_EPSG_BASE, SOUTHERN_EPSG_BASE)) else None
    if "+proj=utm" in text and (match := _PROJ_ZONE.search(text)):
        if "+units=" in text and "+units=m" not in text.split():
            return None
        base = SOUTHERN_EPSG_BASE if "+south" in text else NORTHERN_EPSG_BASE
    elif (match := _ZONE.search(text)) and "WGS84" in text.upper().replace(" ", ""):
        base = SOUTHERN_EPSG_BASE if (match[2] or "N").upper() == "S" else NORTHERN_EPSG_BASE
    else:
        return None
    return base + int(match[1]) if 1 <= int(match[1]) <= 60 else None


def is_degrees(crs: str) -> bool:
    text = crs.strip().lower()
    return text in ("epsg:4326", "epsg:4979", "wgs84") or "+proj=longlat" in text or "+proj=latlong" in text


def _check_unit(system: Any, crs: str) -> None:
    """Reject feet, since the unit of the heights is then unknown."""
    if not system.is_projected:
        raise ValueError(f"crs: expected meters of a map or EPSG:4326, got {shown(crs)}, {system.type_name}")
    units = {axis.unit_name for axis in system.axis_info}
    if units - {"metre"}:
        raise ValueError(f"crs: {escaped(crs)} is in {min(units - {'metre'})}; convert positions and heights to meters")
