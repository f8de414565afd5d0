"""Areas as polygons from GeoJSON (RFC 7946), well-known text (OGC 06-103r4) or corners, and point tests.

An area is a list of polygons, a polygon a list of rings, a ring corners (n, 2). Even-odd rule per polygon, union of
polygons. Edges as in `SelectionPolygonVolume`.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..core.checks import check_finite, check_numeric, shown
from ..core.devices import resolve_device
from ..core.errors import FileError
from ..core.paths import input_path
from ..io.optional_imports import foreign_errors, import_for
from ..io.points.geodetic import system_named, system_of
from ..io.points.las import open_las
from ..kernels.extent.polygons import mask_polygon
from ..kernels.lang import vec2d, vec3d
from ..kernels.memory import download, upload
from ..pcd.polygon_volume import MIN_CORNERS

Ring = NDArray[np.float64]
Area = list[list[Ring]]
SUFFIXES = (".geojson", ".json", ".wkt")
MAX_CORNERS = 1_000_000
MAX_NESTED = 100  # nesting depth of collections
# Possessive quantifiers: linear time for blank text.
_WKT = re.compile(r"(?:SRID=\d++;\s*+)?(MULTI)?POLYGON\s*+(?:(?:ZM|Z|M)\s*+)?(?=\()", re.IGNORECASE)


def parse_area(name: str, value: Any) -> Area:
    """Parse a .geojson, .json or .wkt file, such text, a GeoJSON dictionary, corners (n, 2), or `to_json` output."""
    if isinstance(value, Path) or (isinstance(value, str) and value.lower().endswith(SUFFIXES)):
        path = input_path(value)
        try:
            text = path.read_text("utf-8")
        except (OSError, ValueError) as error:
            raise FileError(path, f"cannot be read: {getattr(error, 'strerror', None) or error}") from error
        try:
            return parse_area(name, _from_text(name, text))
        except (ValueError, TypeError) as error:
            raise FileError(path, str(error)) from error
    is_text = isinstance(value, dict)
    if isinstance(value, str):
        value, is_text = _from_text(name, value), True
    polygons = _polygons_of(name, value) if isinstance(value, dict) else value if _depth(value) == 4 else [[value]]
    checked = [_check_polygon(name, polygon, is_text) for polygon in polygons]
    if not any(checked):
        raise ValueError(f"{name}: expected at least one polygon, got none")
    if sum(len(ring) for polygon in checked for ring in polygon) > MAX_CORNERS:
        raise ValueError(f"{name}: expected at most {MAX_CORNERS:,} corners. Simplify the polygons first")
    return checked


def to_json(area: Area) -> list[Any]:
    return [[ring.tolist() for ring in polygon] for polygon in area]


def _depth(value: object) -> int:
    depth = 0
    while isinstance(value, list | tuple) and len(value) and depth <= 4:
        value, depth = value[0], depth + 1
    return depth


def _from_text(name: str, text: str) -> Any:
    """GeoJSON as a dictionary, or well-known text as polygons of rings."""
    text = text.strip()
    match = _WKT.match(text)
    if match is None:
        try:
            parsed = json.loads(text)
        except (ValueError, RecursionError) as error:
            kinds = "GeoJSON, POLYGON((...)) or MULTIPOLYGON(((...)))"
            raise ValueError(f"{name}: expected {kinds}, got {shown(text)}: {error}") from error
        if not isinstance(parsed, dict):
            raise ValueError(f"{name}: expected an object of GeoJSON, got {shown(parsed)}")
        return parsed
    body = text[match.end() :]
    body = re.sub(r"[^(),]+", lambda part: f"[{','.join(part[0].split())}]" if part[0].strip() else "", body)
    try:
        rings = json.loads(body.replace("(", "[").replace(")", "]"))
    except (ValueError, RecursionError) as error:
        raise ValueError(f"{name}: not well-known text: {error}") from error
    return rings if match[1] else [rings]


def _polygons_of(name: str, geojson: dict[str, Any]) -> Iterator[Any]:
    waiting: list[tuple[Any, int]] = [(geojson, 0)]
    while waiting:
        each, depth = waiting.pop()
        kind = each.get("type") if isinstance(each, dict) else None
        if not isinstance(kind, str) or kind not in _PARTS:
            raise ValueError(f"{name}: expected polygons, got a {shown(each if kind is None else kind)}")
        if depth > MAX_NESTED:
            raise ValueError(f"{name}: expected at most {MAX_NESTED} nested collections of GeoJSON")
        key, is_list = _PARTS[kind]
        if key not in each:
            raise ValueError(f"{name}: not GeoJSON: a {kind} without {key!r}")
        part = each[key]
        if is_list and not isinstance(part, list | tuple):
            raise ValueError(f"{name}: not GeoJSON: expected a list of {key} in a {kind}, got {shown(part)}")
        if key != "coordinates":
            waiting += [(one, depth + 1) for one in (reversed(part) if is_list else [part])]
        elif is_list:
            yield from part
        else:
            yield part


# Members of GeoJSON objects by type, and whether there are several.
_PARTS = {
    "FeatureCollection": ("features", True),
    "Feature": ("geometry", False),
    "GeometryCollection": ("geometries", True),
    "Polygon": ("coordinates", False),
    "MultiPolygon": ("coordinates", True),
}


def _check_polygon(name: str, rings: Any, is_text: bool) -> list[Ring]:
    """Validate the rings of a polygon; `is_text` if they come from text."""
    if not isinstance(rings, list | tuple):
        raise ValueError(f"{name}: expected a list of rings, got {shown(rings)}")
    try:
        return [_check_ring(name, ring) for ring in rings]
    except TypeError as error:
        if not is_text:
            raise
        raise ValueError(str(error)) from error


def _check_ring(name: str, ring: Any) -> Ring:
    corners = check_finite(name, check_numeric(name, ring).astype(np.float64))
    if corners.ndim != 2 or corners.shape[1] not in (2, 3):
        raise ValueError(f"{name}: expected corners of shape [n, 2], got {list(corners.shape)}")
    if len(corners) > 1 and (corners[0] == corners[-1]).all():
        corners = corners[:-1]
    if len(corners) < MIN_CORNERS:
        raise ValueError(f"{name}: expected at least three corners, got {len(corners)}")
    return np.ascontiguousarray(corners[:, :2])


def bounds_of(area: Area) -> tuple[Ring, Ring]:
    corners = np.concatenate([ring for polygon in area for ring in polygon])
    return corners.min(axis=0), corners.max(axis=0)


def in_survey(name: str, area: Area, crs: str | None, sources: list[dict[str, Any]]) -> Area:
    """Transform an area from `crs` (None: the survey's) to a survey's coordinates. Edges stay straight."""
    filled = [source for source in sources if source["points"]]
    if crs is not None:
        area = _transformed(name, area, crs, Path(sources[0]["path"]))
    low, high = bounds_of(area)
    survey_low = np.min([source["low"][:2] for source in filled], axis=0)
    survey_high = np.max([source["high"][:2] for source in filled], axis=0)
    if (low > survey_high).any() or (high < survey_low).any():
        reason = f"{name}: the area {low.tolist()}..{high.tolist()} does not overlap the survey"
        degrees = crs is None and (np.abs([low, high]) <= (180, 90)).all()
        hint = "; is it in degrees? Pass its coordinate system, 'EPSG:4326'" if degrees else ""
        raise ValueError(f"{reason}, {survey_low.tolist()}..{survey_high.tolist()}{hint}")
    return area


def _transformed(name: str, area: Area, crs: str, path: Path) -> Area:
    pyproj: Any = import_for(path, "pyproj", "geo")
    system = system_of(path, open_las(path).header)
    if system is None:
        remedy = "Give the area in the coordinates of the survey, without a coordinate system"
        raise FileError(path, "has no coordinate system, so the area cannot be transformed", remedy=remedy)
    source = system_named(name, crs)
    with foreign_errors(path, "the area cannot be transformed to its coordinate system"):
        transformer = pyproj.Transformer.from_crs(source, system.to_2d(), always_xy=True)
        moved = [[np.column_stack(transformer.transform(*ring.T)) for ring in polygon] for polygon in area]
    if not all(np.isfinite(ring).all() for polygon in moved for ring in polygon):
        raise ValueError(f"{name}: corners in {crs} have no position in the survey's coordinate system")
    return moved


def mask_area(area: Area, points: Any, origin: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Mask of device points inside an area, shape (n,)."""
    mask = np.zeros(points.size, np.bool_)
    for polygon in area:
        inside = np.zeros(points.size, np.bool_)
        for ring in polygon:
            corners = upload(ring, vec2d, points.device)
            inside ^= download(mask_polygon(points, origin, corners, (0, 1, 2), -np.inf, np.inf)) != 0
        mask |= inside
    return mask


def overlapping_boxes(area: Area, lows: Ring, highs: Ring) -> NDArray[np.bool_]:
    """Mask of boxes (n, 2) that overlap an area."""
    corners = upload(np.pad(lows, ((0, 0), (0, 1))), vec3d, resolve_device("cpu"))
    meets = mask_area(area, corners, np.zeros(3))
    for polygon in area:
        for ring in polygon:
            for a, b in zip(np.roll(ring, 1, axis=0), ring, strict=True):
                meets |= _edge_meets(a, b, lows, highs)
    return meets


def _edge_meets(a: Ring, b: Ring, lows: Ring, highs: Ring) -> NDArray[np.bool_]:
    """Mask of boxes that an edge touches (slab test)."""
    enter, leave = np.zeros(len(lows)), np.ones(len(lows))
    for axis in range(2):
        way = b[axis] - a[axis]
        if way == 0:
            outside = (a[axis] < lows[:, axis]) | (a[axis] > highs[:, axis])
            leave = np.where(outside, -1.0, leave)
            continue
        ends = np.stack([(lows[:, axis] - a[axis]) / way, (highs[:, axis] - a[axis]) / way])
        enter, leave = np.maximum(enter, ends.min(axis=0)), np.minimum(leave, ends.max(axis=0))
    return enter <= leave
