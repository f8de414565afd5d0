"""Coordinate reference systems: name, EPSG code, comparison and transformation.

A system is a text: "EPSG:25832", "EPSG:25832+7837" (with heights), well-known text or a PROJ string. Codes and equal
texts are compared without pyproj. OGC 01-009 and 18-010 (WKT). EPSG register.
"""

from __future__ import annotations

import dataclasses
import functools
import importlib
import re
from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .checks import shown
from .errors import PointloomError
from .units import LengthUnit

_CODES = re.compile(r"EPSG:(\d+)(?:\+(\d+))?", re.IGNORECASE)
_WKT_NAME = re.compile(r'\s*(?:[A-Za-z_]\w*\s*[\[(]\s*)+"((?:[^"]|"")*)"')
# Names of geographic systems in both versions of WKT. A projected system contains such a name nested inside its own.
_PROJECTED_WORDS = re.compile(r"\b(PROJCS|PROJCRS|PROJECTEDCRS|GEOCCS)\s*\[", re.IGNORECASE)
_GEOGRAPHIC_WORDS = re.compile(r"\b(GEOGCS|GEOGCRS|GEOGRAPHICCRS)\s*\[", re.IGNORECASE)
_PROJECTED_CODES = (range(2000, 3819), range(20000, 32768))  # EPSG codes of projected systems only
_GEOGRAPHIC_CODES = range(4001, 4904)  # EPSG: geographic systems with x and y only, but 4328 to 4390 (geocentric)
_ROOT_CODE = re.compile(r'(?:AUTHORITY|ID)\s*\[\s*"EPSG"\s*,\s*"?(\d+)"?\s*\]\s*\]\s*$')
NO_NAMES = ("", "unknown", "unnamed")  # of different systems
MAX_CODE = 999_999  # largest number of an authority: EPSG to 32767, ESRI to 104992
MAX_UNIT_DIFFERENCE = 1e-9  # of a unit's length, rounding of its text
TANGENT_LENGTH = 1.0  # [units of the source] length of the tangents that are transformed with a normal


@dataclasses.dataclass(frozen=True, eq=False)
class CoordinateSystem:
    """A coordinate reference system. It equals its EPSG code and any text of the same system.

    Attributes:
        text: "EPSG:25832", "EPSG:25832+7837" with heights, well-known text, or a PROJ string.

    Raises:
        TypeError: The text is no string.
        ValueError: The text is empty or contains control characters.

    Example:
        >>> import pointloom as loom
        >>> cloud = loom.PointCloud([[412300.0, 5651200.0, 120.0]], crs="EPSG:25832")
        >>> cloud.crs.epsg, cloud.crs == 25832
        (25832, True)
    """

    text: str

    def __post_init__(self) -> None:
        if not isinstance(self.text, str):
            raise TypeError(f"crs: expected a text such as 'EPSG:25832', got {type(self.text).__name__}")
        text = " ".join(self.text.split())
        if not text or not text.isprintable():
            raise ValueError(f"crs: expected a text such as 'EPSG:25832', got {shown(self.text)}")
        object.__setattr__(self, "text", self.text.strip() if _WKT_NAME.match(text) else text)

    @property
    def epsg(self) -> int | None:
        """EPSG code of the system, of its horizontal part if it has heights. None if its text has none."""
        codes = self.codes
        return None if codes is None else codes[0]

    @property
    def codes(self) -> tuple[int, int | None] | None:
        """EPSG codes of the horizontal and vertical part. None if the text has no code."""
        if match := _CODES.fullmatch(self.text):
            return int(match[1]), int(match[2]) if match[2] else None
        match = _ROOT_CODE.search(self.text) if _WKT_NAME.match(self.text) else None
        return None if match is None or self.text.upper().startswith("COMP") else (int(match[1]), None)

    @property
    def name(self) -> str:
        """Its code, or the name in its text: "EPSG:25832", "NAD83 / UTM zone 10N"."""
        match = _WKT_NAME.match(self.text)
        return match[1].replace('""', '"') if match else self.text

    def __str__(self) -> str:
        return self.name

    def __repr__(self) -> str:
        return f"CoordinateSystem({self.name!r})"

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, CoordinateSystem | str | int) or isinstance(other, bool):
            return NotImplemented
        try:
            system = check_crs("crs", other)
        except ValueError:
            return False
        if system is None or self.text == system.text:
            return system is not None
        parts = _parts(self)
        return parts[0] is not None and parts == _parts(system)

    def __hash__(self) -> int:
        return hash(_parts(self)[0])


def check_crs(name: str, value: object) -> CoordinateSystem | None:
    """A system from a `CoordinateSystem`, text, EPSG code, or an object with `to_wkt()` such as `pyproj.CRS`."""
    if value is None or isinstance(value, CoordinateSystem):
        return value
    if hasattr(value, "to_wkt"):
        system: Any = value
        value = system.to_epsg() or system.to_wkt()
    if isinstance(value, int | np.integer) and not isinstance(value, bool):
        if not 0 < value <= MAX_CODE:
            raise ValueError(f"{name}: expected an EPSG code 1..{MAX_CODE}, got {shown(value)}")
        value = f"EPSG:{int(value)}"
    if not isinstance(value, str):
        got = type(value).__name__
        raise TypeError(f"{name}: expected a coordinate system such as 'EPSG:25832' or 25832, got {got}")
    text = value.strip()
    if not (_CODES.fullmatch(text) or _WKT_NAME.match(text) or "+proj" in text or ":" in text):
        raise ValueError(f"{name}: expected a coordinate system such as 'EPSG:25832' or 25832, got {shown(value)}")
    return CoordinateSystem(text)


def common_crs(name: str, systems: Iterable[CoordinateSystem | None]) -> CoordinateSystem | None:
    """The common system. Unknown systems adopt that of the others.

    Raises:
        ValueError: Two systems differ.
    """
    known = [system for system in systems if system is not None]
    for system in known[1:]:
        if not is_same_crs(system, known[0]):
            target = f"EPSG:{known[0].epsg}" if known[0].epsg else known[0].name
            raise ValueError(
                f"{name}: expected one coordinate system, got {known[0].name} and {system.name}. Convert one with "
                f"reproject({target!r}), or set its crs if it is wrong"
            )
    if len(known) > 1:
        known.sort(key=lambda system: _parts(system)[1] is None)  # one with heights first
    return known[0] if known else None


def is_same_crs(a: CoordinateSystem | None, b: CoordinateSystem | None) -> bool:
    """True if the horizontal parts are the same, and the vertical parts, too, if both have one."""
    if a is None or b is None or a.text == b.text:
        return True
    (plane_a, heights_a), (plane_b, heights_b) = _parts(a), _parts(b)
    return _can_be_same(plane_a, plane_b) and _can_be_same(heights_a, heights_b)


def _can_be_same(a: int | str | None, b: int | str | None) -> bool:
    return a is None or b is None or a == b


def is_geographic_text(text: str) -> bool:
    """True if x and y of a system in well-known text are longitude and latitude."""
    return bool(_GEOGRAPHIC_WORDS.search(text)) and not _PROJECTED_WORDS.search(text)


def is_in_degrees(unit: LengthUnit | None, crs: CoordinateSystem | None) -> bool:
    """True if x and y are degrees, by their unit or their coordinate system."""
    return (unit is not None and unit.meters is None) or (crs is not None and _is_text_in_degrees(crs.text))


@functools.lru_cache(256)
def _is_text_in_degrees(text: str) -> bool:
    if _WKT_NAME.match(text) and "GEODCRS" not in text.upper() and "GEODETICCRS" not in text.upper():
        return is_geographic_text(text)
    codes = CoordinateSystem(text).codes
    if codes is not None and any(codes[0] in projected for projected in _PROJECTED_CODES):
        return False  # without pyproj, whose import is slow
    try:
        system = pyproj_crs("crs", CoordinateSystem(text))
    except (PointloomError, ValueError):  # no pyproj, or unknown to it
        return (codes is not None and codes[0] in _GEOGRAPHIC_CODES) or bool(re.search(r"\+proj=(long|lat)", text))
    system = system.source_crs if system.is_bound else system
    return bool((system.sub_crs_list[0] if system.is_compound else system).is_geographic)


def map_crs(name: str, given: str | None, own: CoordinateSystem | None, *, with_heights: bool = False) -> str | None:
    """Coordinate system of a map as rasterio accepts it: the given one, else that of the data. Without the vertical
    part of a code unless `with_heights`.

    Raises:
        ValueError: Both are known and differ.
    """
    if own is None or given is not None:
        return given if own is None or common_crs(name, (check_crs("crs", given), own)) else None
    plane, heights = own.codes or (None, None)
    return own.text if plane is None or (with_heights and heights) else f"EPSG:{plane}"


@functools.lru_cache(256)
def _parts_of_text(text: str) -> tuple[int | str | None, int | str | None]:
    codes = CoordinateSystem(text).codes
    if codes is not None:
        return codes
    try:
        system = pyproj_crs("crs", CoordinateSystem(text))
    except (PointloomError, ValueError):  # no pyproj, or unknown to it: cannot be compared
        return None, None
    system = system.source_crs if system.is_bound else system
    parts = system.sub_crs_list if system.is_compound else [system]
    identities = [part.to_epsg() or (part.to_wkt() if part.name in NO_NAMES else part.name) for part in parts]
    return identities[0], identities[1] if len(identities) > 1 else None


def _parts(system: CoordinateSystem) -> tuple[int | str | None, int | str | None]:
    """Identities of the horizontal and vertical part: EPSG codes, else names; None if unknown."""
    return _parts_of_text(system.text)


def _pyproj() -> Any:
    try:
        return importlib.import_module("pyproj")
    except ImportError as error:
        raise PointloomError('crs: needs the package pyproj: pip install "pointloom[geo]"') from error


def pyproj_crs(name: str, system: CoordinateSystem) -> Any:
    """The system as `pyproj.CRS`.

    Raises:
        PointloomError: pyproj is not installed.
        ValueError: pyproj does not contain the system.
    """
    pyproj = _pyproj()
    try:
        return pyproj.CRS.from_user_input(system.text)
    except pyproj.exceptions.CRSError as error:
        raise ValueError(f"{name}: pyproj does not contain the coordinate system {shown(system.name)}") from error


class Reprojection:
    """Transformation of points between two systems in float64, by pyproj on the CPU.

    Heights are transformed if both systems have a vertical part. Otherwise they stay.

    Raises:
        PointloomError: pyproj is not installed.
        ValueError: A system is unknown, or heights would be in another unit than x and y.
    """

    def __init__(self, source: CoordinateSystem, target: CoordinateSystem):
        self.target = target
        systems = [pyproj_crs("crs", source), pyproj_crs("epsg", target)]
        self._has_heights = all(system.is_compound for system in systems)
        planes = [system.sub_crs_list[0] if system.is_compound else system for system in systems]
        self._system = systems[1] if self._has_heights else planes[1]
        if not self._has_heights:
            factors = [plane.axis_info[0].unit_conversion_factor for plane in planes]
            are_lengths = all(plane.is_projected for plane in planes)
            if are_lengths and abs(factors[0] / factors[1] - 1) > MAX_UNIT_DIFFERENCE:
                names = [plane.axis_info[0].unit_name for plane in planes]
                raise ValueError(
                    f"epsg: x and y would be in {names[1]}, and heights stay in {names[0]}. Use systems with heights, "
                    "such as 'EPSG:2994+6360'"
                )
        pair = systems if self._has_heights else planes
        self._transformer = _pyproj().Transformer.from_crs(*pair, always_xy=True)

    @property
    def unit_name(self) -> str:
        """Name of the unit of x and y after the transformation."""
        return str(self._system.axis_info[0].unit_name)

    def points(self, points: NDArray[np.float64]) -> NDArray[np.float64]:
        """Transformed points (n, 3). Non-finite points stay non-finite.

        Raises:
            ValueError: Finite points have no position in the target system.
        """
        x, y, z = np.asarray(points, np.float64).T
        moved = self._transformer.transform(x, y, z) if self._has_heights else (*self._transformer.transform(x, y), z)
        result = np.column_stack(moved)
        lost = np.isfinite(points).all(axis=1) & ~np.isfinite(result).all(axis=1)
        if lost.any():
            raise ValueError(
                f"epsg: {int(lost.sum()):,} of {len(points):,} points have no position in {self.target.name}. Crop to "
                "the area of that system first"
            )
        result[~np.isfinite(points).all(axis=1)] = np.nan
        return result

    def normals(self, points: NDArray[np.float64], normals: NDArray[Any]) -> NDArray[np.float64]:
        """Normals (n, 3) at points before the transformation, as those of the transformed surface, of their length.

        Raises:
            ValueError: The target is in degrees.
        """
        if self.unit_name == "degree":
            raise ValueError('epsg: normals in degrees are undefined. Reproject cloud.without("normals")')
        lengths = np.linalg.norm(normals, axis=1, keepdims=True)
        axes = np.eye(3)[np.abs(normals).argmin(axis=1)]
        start, first = self.points(points), np.cross(normals, axes)
        first /= np.maximum(np.linalg.norm(first, axis=1, keepdims=True), np.finfo(float).tiny)
        second = np.cross(normals, first) / np.maximum(lengths, np.finfo(float).tiny)
        ends = [self.points(points + TANGENT_LENGTH * tangent) - start for tangent in (first, second)]
        turned = np.cross(ends[0], ends[1])
        return turned * (lengths / np.maximum(np.linalg.norm(turned, axis=1, keepdims=True), np.finfo(float).tiny))
