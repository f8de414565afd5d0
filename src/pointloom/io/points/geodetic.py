"""Coordinate systems of LAS files or names as pyproj CRS."""

from __future__ import annotations

from typing import Any

from ...core.checks import shown
from ...core.errors import FilePath
from ..optional_imports import foreign_errors, import_for
from .las_crs import find_keys, find_text
from .las_header import LasHeader

_PROJECTED_KEY, _GEOGRAPHIC_KEY = 3072, 2048


def system_of(path: FilePath, header: LasHeader) -> Any:
    """The pyproj CRS of a file. None without a system on the Earth, such as a unit alone."""
    declared = _declared_system(header)
    if declared is None:
        return None
    pyproj = import_for(path, "pyproj", "geo")
    with foreign_errors(path, "its coordinate system cannot be read"):
        system = pyproj.CRS.from_user_input(declared)
    return system if system.is_geographic or system.is_projected or system.is_compound else None


def system_named(name: str, value: object) -> Any:
    """The pyproj CRS of a name such as "EPSG:25832"; `name` is the argument's, for errors."""
    pyproj: Any = import_for(name, "pyproj", "geo")
    try:
        return pyproj.CRS.from_user_input(value)
    except pyproj.exceptions.CRSError as error:
        raise ValueError(f"{name}: expected a coordinate system, got {shown(value)}") from error


def _declared_system(header: LasHeader) -> Any:
    text = find_text(header)
    if text:
        return text
    keys = find_keys(header)
    for key in (_PROJECTED_KEY, _GEOGRAPHIC_KEY):
        location, _, code = keys.get(key, (1, 0, 0))
        if location == 0 and 0 < code < 32767:
            return code
    return None
