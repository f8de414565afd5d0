"""Where a LAS file's coordinates lie on the Earth, by pyproj: its system, degrees of WGS 84, and geocentric places.

Heights of a system that tells none of its own count from the ellipsoid, in the unit of the plane. Where the grid of a
height system is not installed, pyproj takes the nearest way that it has.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import shown
from ..foreign import foreign_errors, import_for
from .las_crs import find_keys, find_text
from .las_header import LasHeader
from .las_units import units_of

_GEOCENTRIC, _DEGREES = "EPSG:4978", "EPSG:4979"
_PROJECTED_KEY, _GEOGRAPHIC_KEY = 3072, 2048


class Geodesy:
    """The coordinate system of a file.

    Args:
        path: The file, for errors.
        header: What its header says.

    Attributes:
        system: pyproj's CRS; None where the file tells none.

    Raises:
        FileError: The system cannot be read, or pyproj is missing.
    """

    def __init__(self, path: Any, header: LasHeader):
        self._path, told = path, _told(header)
        self.system: Any = None
        if told is None:
            return
        pyproj = import_for(path, "pyproj", "geo")
        with foreign_errors(path, "its coordinate system cannot be read"):
            self.system = pyproj.CRS.from_user_input(told)
            if self.system.is_geographic or self.system.is_projected or self.system.is_compound:
                whole = self.system if self.system.is_compound else self.system.to_3d()
                self._ways = {
                    name: pyproj.Transformer.from_crs(whole, name, always_xy=True) for name in (_GEOCENTRIC, _DEGREES)
                }
            else:  # no place on the Earth, such as a system that tells the unit alone
                self.system = None
                return
        plane = units_of(header).plane
        metres = plane.metres if plane is not None and plane.metres else 1.0
        self._height_scale = 1.0 if self.system.is_compound else metres

    def to_geocentric(self, points: NDArray[np.float64]) -> NDArray[np.float64]:
        """Metres from the middle of the Earth, [n, 3]."""
        return self._by(_GEOCENTRIC, points)

    def to_degrees(self, points: NDArray[np.float64]) -> NDArray[np.float64]:
        """Longitude, latitude and height of WGS 84, [n, 3]."""
        return self._by(_DEGREES, points)

    def _by(self, name: str, points: NDArray[np.float64]) -> NDArray[np.float64]:
        with foreign_errors(self._path, "its coordinates cannot be transformed"):
            x, y, z = points.T
            found = self._ways[name].transform(x, y, z * self._height_scale, errcheck=True)
        return np.column_stack(found)


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
