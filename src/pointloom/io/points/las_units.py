"""Units of LAS coordinates from WKT or GeoTIFF keys. None if missing or incomplete, never guessed.

OGC 01-009 and 18-010 (WKT). GeoTIFF 1.0, sections 2.7 and 6.3.1.3. ASPRS, LAS Specification 1.4-R15, table 4 (encoding
bit 4: WKT overrides keys).
"""

from __future__ import annotations

import math
import re
import struct
from dataclasses import dataclass, field

from ...core.units import DEGREE, FOOT, METRE, US_FOOT, LengthUnit, is_same, unit_by_length, unit_by_name
from .las_crs import find_keys, find_text
from .las_header import PROJECTION, LasHeader

_GEOTIFF_DOUBLES_RECORD = 34736
_MODEL_TYPE, _GEOGRAPHIC_MODEL, _GEOCENTRIC_MODEL = 1024, 2, 3
_GEOCENTRIC_UNIT, _ANGLE_UNIT, _PLANE_UNIT, _PLANE_UNIT_SIZE, _HEIGHT_UNIT = 2052, 2054, 3076, 3077, 4099
_USER_DEFINED = 32767
_DEGREE_CODES = (9102, 9122)
_WKT_BIT = 16

# EPSG codes.
_LENGTH_UNITS = {
    9001: METRE, 9002: FOOT, 9003: US_FOOT, 9036: unit_by_name("kilometre"), 9096: unit_by_name("yard"),
    9005: LengthUnit("Clarke's foot", "Clarke's ft", 0.3047972654),
    9041: LengthUnit("British foot (Sears 1922)", "ft (Sears 1922)", 0.304799471538676),
    9080: LengthUnit("Indian foot", "Indian ft", 0.304799510248147),
    9094: LengthUnit("Gold Coast foot", "Gold Coast ft", 0.304799710181508),
    9095: LengthUnit("British foot (1936)", "ft (1936)", 0.3048007491),
}  # fmt: skip

_TOKEN = re.compile(
    r'\s*(?:"(?P<text>(?:[^"]|"")*)"|(?P<word>[A-Za-z_]\w*)\s*(?P<open>[\[(])?|(?P<number>[-+]?[0-9.][-+0-9.eE]*)'
    r"|(?P<close>[\])])|(?P<comma>,))"
)
_COMPOUNDS = ("COMPD_CS", "COMPOUNDCRS")
_HEIGHTS = ("VERT_CS", "VERTCRS", "VERTICALCRS", "VERTCS")
_ANGLES = ("GEOGCS", "GEOGCRS", "GEOGRAPHICCRS")
_GEODETIC = ("GEODCRS", "GEODETICCRS")  # angles or, in geocentric systems, lengths
_PLANES = ("PROJCS", "PROJCRS", "PROJECTEDCRS", "GEOCCS", "LOCAL_CS", "ENGCRS", "ENGINEERINGCRS")


@dataclass(frozen=True)
class LasUnits:
    """Units of a file: `plane` of x and y, `height` of z, and `warning` if they contradict each other, or None."""

    plane: LengthUnit | None = None
    height: LengthUnit | None = None
    warning: str | None = None


@dataclass
class _Node:
    """`KEYWORD[...]` of WKT, with its contents in order."""

    keyword: str
    items: list[_Node | str | float] = field(default_factory=list)

    @property
    def nodes(self) -> list[_Node]:
        return [item for item in self.items if isinstance(item, _Node)]

    def named(self, *keywords: str) -> list[_Node]:
        return [node for node in self.nodes if node.keyword in keywords]


def units_of(header: LasHeader) -> LasUnits:
    """The units in the records: WKT if present, else keys. If both differ, bit 4 of the encoding decides (LAS 1.4)."""
    text, keys = _units_of_text(find_text(header)), _units_of_keys(header)
    is_text = bool(header.encoding & _WKT_BIT)
    if is_text or not (text.plane and keys.plane):
        declared = text if is_text or text.plane else keys
        return LasUnits(declared.plane, declared.height, _warning_of(declared))
    if is_same(text.plane, keys.plane):
        both = LasUnits(text.plane, text.height or keys.height)
        return LasUnits(both.plane, both.height, _warning_of(both))
    contradiction = f"its GeoTIFF keys declare lengths in {keys.plane}, its well-known text declares {text.plane}"
    return LasUnits(keys.plane, keys.height, f"{contradiction}; the keys are used. Set cloud.unit if they are wrong")


def _warning_of(units: LasUnits) -> str | None:
    plane, height = units.plane, units.height
    if plane is None or height is None or height.meters is None:
        return None
    factor = height.meters / (plane.meters or 1.0)  # degrees become meters
    if is_same(plane, height) or factor == 1:
        return None
    first = "" if plane.meters else "cloud = project_to_utm(cloud); "
    remedy = f"{first}points = cloud.points.copy(); points[:, 2] *= {factor:.10g}; cloud.points = points"
    return f"x and y are in {plane}, z is in {height}, so that lengths are wrong; to fix it: {remedy}"


def _units_of_text(text: str) -> LasUnits:
    root = _parse(text)
    if root is None:
        return LasUnits()
    while root.keyword == "BOUNDCRS":  # a system and its transformation to another
        inner = [node for source in root.named("SOURCECRS") for node in source.nodes]
        if not inner:
            return LasUnits()
        root = inner[0]
    parts = root.nodes if root.keyword in _COMPOUNDS else [root]
    planes = [part for part in parts if part.keyword in (*_PLANES, *_ANGLES, *_GEODETIC)]
    heights = [part for part in parts if part.keyword in _HEIGHTS]
    if not planes:
        return LasUnits()
    axes = planes[0].named("AXIS")
    axis_units = [_unit_below(axis) for axis in axes]
    shared = _unit_below(planes[0])
    sides = [unit or shared for unit in axis_units[:2]] or [shared]
    plane = sides[0] if all(side == sides[0] for side in sides) else None
    if heights:
        axis = heights[0].named("AXIS")
        height = _unit_below(heights[0]) or (_unit_below(axis[0]) if axis else None)
    else:
        height = axis_units[2] if len(axis_units) > 2 else None
    return LasUnits(plane, height)


def _unit_below(node: _Node) -> LengthUnit | None:
    nodes = node.named("UNIT", "LENGTHUNIT", "ANGLEUNIT")
    if len(nodes) != 1 or len(nodes[0].items) < 2:
        return None
    name, size = nodes[0].items[:2]
    if not isinstance(name, str) or not isinstance(size, float):
        return None
    is_angle = nodes[0].keyword == "ANGLEUNIT" or (nodes[0].keyword == "UNIT" and node.keyword in _ANGLES)
    if is_angle or (unit_by_name(name) is DEGREE and node.keyword not in _PLANES):
        return DEGREE if abs(size / math.radians(1) - 1) < 1e-6 else None
    return unit_by_length(name, size)


def _parse(text: str) -> _Node | None:
    top, at = _Node(""), 0
    stack = [top]
    text = text.strip("\0 \t\r\n")
    while at < len(text):
        token = _TOKEN.match(text, at)
        if token is None or (len(stack) == 1 and top.items):  # no token, or several systems
            return None
        at = token.end()
        if token["open"]:
            node = _Node(token["word"].upper())
            stack[-1].items.append(node)
            stack.append(node)
        elif token["close"]:
            if len(stack) == 1:
                return None
            stack.pop()
        elif token["number"]:
            try:
                stack[-1].items.append(float(token["number"]))
            except ValueError:
                return None
        elif token["text"] is not None:
            stack[-1].items.append(token["text"].replace('""', '"'))
    root = top.items[0] if len(stack) == 1 and top.items else None
    return root if isinstance(root, _Node) else None


def _units_of_keys(header: LasHeader) -> LasUnits:
    keys = find_keys(header)

    def code(key: int) -> int | None:
        location, _, value = keys.get(key, (-1, 0, 0))
        return value if location == 0 else None

    model = code(_MODEL_TYPE)
    height = _LENGTH_UNITS.get(code(_HEIGHT_UNIT) or 0)
    if model == _GEOGRAPHIC_MODEL:
        return LasUnits(DEGREE if code(_ANGLE_UNIT) in (None, *_DEGREE_CODES) else None, height)
    key = _GEOCENTRIC_UNIT if model == _GEOCENTRIC_MODEL else _PLANE_UNIT
    if code(key) != _USER_DEFINED:
        return LasUnits(_LENGTH_UNITS.get(code(key) or 0), height)
    location, _, index = keys.get(_PLANE_UNIT_SIZE, (0, 0, 0))
    numbers = header.find(PROJECTION, _GEOTIFF_DOUBLES_RECORD) or b""
    if key != _PLANE_UNIT or location != _GEOTIFF_DOUBLES_RECORD or 8 * (index + 1) > len(numbers):
        return LasUnits(None, height)
    size = struct.unpack_from("<d", numbers, 8 * index)[0]
    return LasUnits(unit_by_length("", size), height)
