"""Read E57 scans with pye57 (libE57Format), transformed by their pose T_world_scan.

All scans together get the attribute `scan_index` and keep common fields, with a warning of the others. Invalid points
are dropped. Invalid intensities and times become NaN, invalid colors white with a warning. Lengths are meters. Images
are not read. ASTM E2807-11; extension "nor" (normals) of libe57.org.
"""

from __future__ import annotations

import contextlib
import importlib
import os
import warnings
from collections.abc import Iterator
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...core.coordinate_systems import CoordinateSystem
from ...core.coordinates import quiet
from ...core.errors import FileError, FilePath
from ...core.escaped_text import escaped
from ...core.joined_parts import common_names
from ...core.paths import path_of
from ...core.quaternions import quaternions_to_rotations
from ...core.units import METRE
from ..columns import stack_colors, stack_normals, warn_of_loss
from ..growing_columns import GrowingColumns
from ..optional_imports import foreign_errors, import_for
from ..source import content_errors, open_source
from ..table import PointTable
from .header_units import crs_of_text

POINTS_PER_BLOCK = 1 << 18  # points unpacked at a time
_MAX_SMALL, _MAX_PER_BYTE = 1 << 16, 8  # points: a coordinate takes at least a bit, unless all are equal and take none

CARTESIAN: tuple[str, ...] = ("cartesianX", "cartesianY", "cartesianZ")
_SPHERICAL: tuple[str, ...] = ("sphericalRange", "sphericalAzimuth", "sphericalElevation")
COLORS: tuple[str, ...] = ("colorRed", "colorGreen", "colorBlue")
NORMALS: tuple[str, ...] = ("nor:normalX", "nor:normalY", "nor:normalZ")
_INVALID = ("cartesianInvalidState", "sphericalInvalidState")  # 0 is valid, 1 a direction without a range

_FLAGS = {"intensity": "isIntensityInvalid", "timeStamp": "isTimeStampInvalid"}  # 1 where a point lacks the value
_COLOR_FLAG = "isColorInvalid"

_SCANNER_DATA = (
    "description", "sensorVendor", "sensorModel", "sensorSerialNumber", "sensorHardwareVersion",
    "sensorSoftwareVersion", "sensorFirmwareVersion", "temperature", "relativeHumidity", "atmosphericPressure",
    "acquisitionStart", "acquisitionEnd",
)  # fmt: skip

SCAN_INDEX = "scan_index"
ATTRIBUTES = {
    "intensity": "intensity", "rowIndex": "row_index", "columnIndex": "column_index",
    "returnIndex": "return_index", "returnCount": "return_count", "timeStamp": "time_stamp",
}  # fmt: skip
_READ = {
    *CARTESIAN, *_SPHERICAL, *COLORS, *NORMALS, *ATTRIBUTES, *_INVALID, *_FLAGS.values(), _COLOR_FLAG,
}  # fmt: skip
NARROW = [np.dtype(code) for code in ("u1", "i1", "u2", "i2")]
WIDE = np.dtype("q")  # pye57 has no 32-bit integers, and 64-bit ones work only under this of their two names


class ScanFrame(NamedTuple):
    name: str
    pose: NDArray[np.float64] | None


def read_e57(path: FilePath, *, scan: int | None = None) -> PointTable:
    """Read the points of one scan, or of all with `scan_index` if `scan` is None.
    Needs memory for the result and twice the largest scan."""
    with open_e57(path) as (image, scans):
        if scan is not None and not 0 <= scan < len(scans):
            raise IndexError(f"scan: expected 0..{len(scans) - 1}, got {scan}")
        warn_of_lost_fields(path, scans if scan is None else [scans[scan]])
        if scan is not None:
            return replace(read_scan(path, scans[scan]), crs=crs_of_image(image))
        tables = [read_scan(path, node) for node in scans]
        crs = crs_of_image(image)
    merged = replace(merge_scans(path, with_points(tables)), crs=crs)
    counts = [len(table.points) for table in tables]
    merged.attributes[SCAN_INDEX] = np.repeat(np.arange(len(tables), dtype=np.int32), counts)
    return merged


def describe_e57(path: FilePath) -> list[dict[str, Any]]:
    """Name, point count, fields and position [m] of each scan."""
    with open_e57(path) as (_, scans), foreign_errors(path, "a scan is damaged"):
        return [
            {
                "name": node["name"].value() if node.isDefined("name") else "",
                "points": node["points"].childCount(),
                "fields": [*_fields(node)],
                "position": read_pose(path, node)[1].tolist(),
            }
            for node in scans
        ]


def read_frames(path: FilePath) -> tuple[list[ScanFrame], list[str]]:
    with open_e57(path) as (image, scans), foreign_errors(path, "a scan is damaged"):
        frames = []
        for node in scans:
            pose = None
            if node.isDefined("pose"):
                pose = np.eye(4)
                pose[:3, :3], pose[:3, 3] = read_pose(path, node)
            frames.append(ScanFrame(node["name"].value() if node.isDefined("name") else "", pose))
        beside = ["images"] if image.root().isDefined("images2D") and len(image.root()["images2D"]) else []
        if any(node.isDefined(name) for node in scans for name in _SCANNER_DATA):
            beside.append("scanner data")
    return frames, beside


@contextlib.contextmanager
def open_e57(path: FilePath) -> Iterator[tuple[Any, list[Any]]]:
    source = open_source(path)
    if source[:8] != b"ASTM-E57":
        raise FileError(path, "is not an E57 file: its first eight bytes are not ASTM-E57", where="byte 0")
    libe57 = import_for(path, "pye57.libe57", "e57")
    with foreign_errors(path, "is not an intact E57 file"):
        image = libe57.ImageFile(os.fspath(path), "r")
    source.check_name()
    try:
        with foreign_errors(path, "its list of scans is damaged"):
            data = image.root()["data3D"]
            scans = [data[k] for k in range(len(data))]
        if not scans:
            raise FileError(path, "contains no scan of points")
        yield image, scans
    finally:
        image.close()


def crs_of_image(image: Any) -> CoordinateSystem | None:
    """The coordinate system of the world coordinates (`coordinateMetadata`, ASTM E2807-11, 8.3), or None."""
    root = image.root()
    return crs_of_text(root["coordinateMetadata"].value()) if root.isDefined("coordinateMetadata") else None


def _libe57() -> Any:
    return importlib.import_module("pye57.libe57")


def _fields(scan: Any) -> dict[str, Any]:
    libe57 = _libe57()
    kinds = {
        libe57.NodeType.E57_FLOAT: libe57.FloatNode,
        libe57.NodeType.E57_INTEGER: libe57.IntegerNode,
        libe57.NodeType.E57_SCALED_INTEGER: libe57.ScaledIntegerNode,
    }
    prototype = libe57.StructureNode(scan["points"].prototype())
    nodes = (prototype.get(k) for k in range(prototype.childCount()))
    return {node.elementName(): kinds[node.type()](node) for node in nodes if node.type() in kinds}


def warn_of_lost_fields(path: FilePath, scans: list[Any]) -> None:
    """Warn of fields that a cloud cannot store, and of colors and normals without all components."""
    lost: dict[str, None] = {}
    with foreign_errors(path, "a scan is damaged"):
        for scan in scans:
            prototype = _libe57().StructureNode(scan["points"].prototype())
            names = [prototype.get(k).elementName() for k in range(prototype.childCount())]
            lost |= dict.fromkeys(name for name in names if name not in _READ)
            for triple in (COLORS, NORMALS):
                partial = [name for name in triple if name in names]
                lost |= dict.fromkeys(partial if len(partial) < len(triple) else ())
    if lost:
        warn_of_loss(path, f"fields {', '.join(lost)}", "a cloud cannot store them", stacklevel=4)


class _Layout(NamedTuple):
    """Fields of a scan to read, their types, and the pose and color limits to apply."""

    wanted: dict[str, np.dtype[Any]]
    coordinates: tuple[str, ...]
    limits: list[tuple[float, float]]
    R: NDArray[np.float64]
    translation: NDArray[np.float64]

    @property
    def invalid(self) -> str:
        return _INVALID[self.coordinates is _SPHERICAL]


def _layout_of(path: FilePath, scan: Any, *, in_world: bool) -> _Layout:
    fields = _fields(scan)
    R, translation = read_pose(path, scan) if in_world else (np.eye(3), np.zeros(3))
    coordinates = next((names for names in (CARTESIAN, _SPHERICAL) if all(name in fields for name in names)), None)
    if coordinates is None:
        raise FileError(path, f"a scan has no coordinates; its fields are {', '.join(fields)}")
    wanted = {name: np.dtype(np.float64) for name in coordinates}
    wanted |= {name: _narrowest(fields[name]) for name in ATTRIBUTES if name in fields}
    for names in (COLORS, NORMALS):
        wanted |= dict.fromkeys(names, np.dtype(np.float32)) if all(name in fields for name in names) else {}
    flags = [_INVALID[coordinates is _SPHERICAL], *(flag for name, flag in _FLAGS.items() if name in wanted)]
    flags += [_COLOR_FLAG] if COLORS[0] in wanted else []
    wanted |= {name: np.dtype(np.int8) for name in flags if name in fields}
    limits = _color_limits(scan, fields) if COLORS[0] in wanted else []
    return _Layout(wanted, coordinates, limits, R, translation)


@quiet()
def read_scan(path: FilePath, scan: Any, *, in_world: bool = True) -> PointTable:
    """The points of a scan in world coordinates, or in scanner coordinates."""
    with foreign_errors(path, "a scan is damaged"):
        layout = _layout_of(path, scan, in_world=in_world)
        columns = _read_columns(path, scan["points"], layout.wanted)
    return _table_of(path, columns, layout)


def _table_of(
    path: FilePath, columns: dict[str, NDArray[Any]], layout: _Layout, *, is_part: bool = False
) -> PointTable:
    """A table from the columns of a scan. Types of a part do not depend on its values."""
    if layout.invalid in columns:
        valid = columns.pop(layout.invalid) == 0
        columns = {name: values[valid] for name, values in columns.items()}
    for name, flag in _FLAGS.items():
        if flag in columns and (is_part or columns[flag].any()):
            columns[name] = np.where(columns[flag] != 0, np.nan, columns[name].astype(_with_nan(columns[name].dtype)))
    positions = [columns[name] for name in layout.coordinates]
    points = _to_cartesian(*positions, is_spherical=layout.coordinates is _SPHERICAL) @ layout.R.T + layout.translation
    colors = normals = None
    if layout.limits:
        limits = zip(COLORS, layout.limits, strict=True)
        channels = [(columns[name] - low) / (high - low) for name, (low, high) in limits]
        colors = stack_colors(path, [channel.astype(np.float32) for channel in channels])
        if colors is not None and _COLOR_FLAG in columns:
            colors = _with_white(path, colors, columns[_COLOR_FLAG] != 0, is_part=is_part)
    if NORMALS[0] in columns:
        stored = np.stack([columns[name] for name in NORMALS], axis=1)
        normals = stack_normals(path, [*(stored @ layout.R.T).T])
    attributes = {attribute: columns[name] for name, attribute in ATTRIBUTES.items() if name in columns}
    attributes = {name: v.view(np.int64) if v.dtype == np.int64 else v for name, v in attributes.items()}
    return PointTable(points, normals, colors, attributes, unit=METRE)


def iterate_e57(path: FilePath, size: int, *, scan: int | None = None) -> Iterator[PointTable]:
    """Parts of at most `size` points in world coordinates, of one scan or of all with `scan_index`, in bounded memory.

    The parts have the fields and types that the complete file has, except that an attribute with an invalid flag is a
    float even if all values are valid.
    """
    with content_errors(path), open_e57(path) as (image, scans):
        if scan is not None and not 0 <= scan < len(scans):
            raise IndexError(f"scan: expected 0..{len(scans) - 1}, got {scan}")
        crs, numbers = crs_of_image(image), range(len(scans)) if scan is None else [scan]
        warn_of_lost_fields(path, [scans[number] for number in numbers])
        with foreign_errors(path, "a scan is damaged"):
            layouts = {number: _layout_of(path, scans[number], in_world=True) for number in numbers}
        nothing = [
            _table_of(path, {name: np.empty(0, dtype) for name, dtype in layout.wanted.items()}, layout, is_part=True)
            for layout in [layouts[n] for n in numbers if scans[n]["points"].childCount()] or [layouts[numbers[0]]]
        ]
        common = merge_scans(path, nothing)
        for number, layout in layouts.items():
            for columns in _blocks_of(path, scans[number]["points"], layout.wanted, size):
                with quiet():
                    table = _table_of(path, columns, layout, is_part=True)
                table.attributes = {n: table.attributes[n].astype(v.dtype) for n, v in common.attributes.items()}
                table.normals = None if common.normals is None else table.normals
                table.colors, table.crs = None if common.colors is None else table.colors, crs
                if scan is None:
                    table.attributes[SCAN_INDEX] = np.full(len(table.points), number, np.int32)
                if len(table.points):
                    yield table


def _blocks_of(
    path: FilePath, vector: Any, wanted: dict[str, np.dtype[Any]], size: int
) -> Iterator[dict[str, NDArray[Any]]]:
    """Views of blocks of at most `size` rows. Raises `FileError` at the end if rows are missing."""
    libe57, count = _libe57(), vector.childCount()
    byte_count = path_of(path).stat().st_size
    blocks = {name: np.empty(min(count, size), dtype) for name, dtype in wanted.items()}
    if not count:
        return
    buffers, image, row_count = libe57.VectorSourceDestBuffer(), vector.destImageFile(), 0
    with foreign_errors(path, "a scan is damaged"):
        for name, block in blocks.items():
            buffers.append(libe57.SourceDestBuffer(image, name, block, len(block), True, True))
        reader = vector.reader(buffers)
    try:
        while True:
            with foreign_errors(path, "a scan is damaged"):
                added = reader.read()
            if not added:
                break
            row_count += added
            if row_count > max(_MAX_SMALL, _MAX_PER_BYTE * byte_count):
                raise FileError(path, f"a scan of {count:,} points does not fit into {byte_count:,} bytes")
            yield {name: block[:added] for name, block in blocks.items()}
    finally:
        reader.close()
    if row_count != count:
        raise FileError(path, f"truncated: a scan has {row_count} of {count} points")


def _with_nan(dtype: np.dtype[Any]) -> np.dtype[Any]:
    """The float type that represents all numbers of a type. For 64-bit integers only up to 2^53."""
    return np.result_type(dtype, np.float32)


def _with_white(
    path: FilePath, colors: NDArray[Any], is_missing: NDArray[np.bool_], *, is_part: bool
) -> NDArray[Any] | None:
    """Set missing colors to white with a warning. None if all are missing, except in a part."""
    if is_missing.all() and not is_part:
        return None
    if is_missing.any():
        message = f"{path}: {np.count_nonzero(is_missing)} of {len(colors)} points have no color; they are white"
        warnings.warn(escaped(message), UserWarning, stacklevel=5)
        colors = np.where(is_missing[:, None], np.float32(1), colors)
    return colors


def _read_columns(path: FilePath, vector: Any, wanted: dict[str, np.dtype[Any]]) -> dict[str, NDArray[Any]]:
    """Read the fields of all points. Memory is bounded by the delivered data, not by the declared count."""
    columns = GrowingColumns(vector.childCount(), is_proven=False)
    columns.append({name: np.empty(0, dtype) for name, dtype in wanted.items()})
    for block in _blocks_of(path, vector, wanted, POINTS_PER_BLOCK):
        columns.append(block)
    return columns.finish()


def _to_cartesian(
    x: NDArray[np.float64], y: NDArray[np.float64], z: NDArray[np.float64], *, is_spherical: bool
) -> NDArray[np.float64]:
    """Positions (n, 3). Spherical input is range [m], azimuth and elevation [rad] (ASTM E2807-11, section 8.4.4)."""
    if is_spherical:
        distance, azimuth, elevation = x, y, z
        flat = distance * np.cos(elevation)
        x, y, z = flat * np.cos(azimuth), flat * np.sin(azimuth), distance * np.sin(elevation)
    return np.stack([x, y, z], axis=1)


def read_pose(path: FilePath, scan: Any) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Rotation (3, 3) and translation (3,) of T_world_scan, or identity without a pose."""
    quaternion, translation = np.array([0, 0, 0, 1.0]), np.zeros(3)
    if scan.isDefined("pose/rotation"):
        quaternion = np.array([scan["pose"]["rotation"][axis].value() for axis in "xyzw"], np.float64)
    if scan.isDefined("pose/translation"):
        translation = np.array([scan["pose"]["translation"][axis].value() for axis in "xyz"], np.float64)
    norm = np.linalg.norm(quaternion)
    if not (np.isfinite(translation).all() and np.isfinite(norm) and norm > 0):
        raise FileError(
            path, f"a scan's pose is not a rigid motion: {np.roll(quaternion, 1).tolist()}, {translation.tolist()}"
        )
    return quaternions_to_rotations((quaternion / norm)[None])[0], translation


def _narrowest(node: Any) -> np.dtype[Any]:
    libe57 = _libe57()
    if isinstance(node, libe57.FloatNode):
        return np.dtype(np.float32 if node.precision() == libe57.E57_SINGLE else np.float64)
    if isinstance(node, libe57.ScaledIntegerNode):
        return np.dtype(np.float64)
    low, high = node.minimum(), node.maximum()
    fitting = (dtype for dtype in NARROW if np.iinfo(dtype).min <= low and high <= np.iinfo(dtype).max)
    return next(fitting, WIDE)


def _color_limits(scan: Any, fields: dict[str, Any]) -> list[tuple[float, float]]:
    """Minimum and maximum of each channel: the scan's limits, else the range of the stored type."""
    libe57 = _libe57()
    limits = []
    for name in COLORS:
        low, high = 0.0, 1.0
        if all(scan.isDefined(f"colorLimits/{name}{end}") for end in ("Minimum", "Maximum")):
            low, high = (float(scan["colorLimits"][f"{name}{end}"].value()) for end in ("Minimum", "Maximum"))
        elif isinstance(fields[name], libe57.IntegerNode):
            low, high = float(fields[name].minimum()), float(fields[name].maximum())
        limits.append((low, high) if high > low else (low, low + 1))
    return limits


def merge_scans(path: FilePath, tables: list[PointTable]) -> PointTable:
    """Concatenate scans with the fields that all of them have, and warn of the others. Attribute types are promoted."""
    columns = [table.columns() for table in tables]
    names = common_names(path, columns, "scans")
    joined = {name: np.concatenate([column[name] for column in columns]) for name in names}
    points = np.concatenate([table.points for table in tables])
    return PointTable(points, joined.pop("normals", None), joined.pop("colors", None), joined, unit=METRE)


def with_points(tables: list[PointTable]) -> list[PointTable]:
    """The scans that have points. The first one if none has."""
    return [table for table in tables if len(table.points)] or tables[:1]
