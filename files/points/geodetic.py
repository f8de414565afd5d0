"""The coordinate system of a LAS file, or of a name, as pyproj's CRS."""

from __future__ import annotations

from typing import Any

from ...core.checks import shown
from ..foreign import foreign_errors, import_for
from .las_crs import find_keys, find_text
from .las_header import LasHeader

_PROJECTED_KEY, _GEOGRAPHIC_KEY = 3072, 2048


def system_of(path: Any, header: LasHeader) -> Any:
    """pyproj's CRS of a file; None if the file has none, or none on the Earth, such as one that gives the unit alone.

    Raises:
        FileError: The system cannot be read, or pyproj is missing; `path` is the file's.
    """
    told = _told(header)
    if told is None:
        return None
    pyproj = import_for(path, "pyproj", "geo")
    with foreign_errors(path, "its coordinate system cannot be read"):
        system = pyproj.CRS.from_user_input(told)
    return system if system.is_geographic or system.is_projected or system.is_compound else None


def system_named(name: str, value: Any) -> Any:
    """pyproj's CRS of what a user calls it, such as "EPSG:25832".

    Raises:
        ValueError: There is none; `name` is the argument's.
        FileError: pyproj is missing.
    """
    pyproj: Any = import_for(name, "pyproj", "geo")
    try:
        return pyproj.CRS.from_user_input(value)
    except pyproj.exceptions.CRSError as error:
        raise ValueError(f"{name}: no coordinate system: {shown(value)}") from error


def _told(header: LasHeader) -> Any:
    text = find_text(header)
    if text:
        return text
    keys = find_keys(header)
    for key in (_PROJECTED_KEY, _GEOGRAPHIC_KEY):
        place, _, code = keys.get(key, (1, 0, 0))
        if place == 0 and 0 < code < 32767:
            return code
    return None
