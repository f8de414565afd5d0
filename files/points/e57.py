"""E57 files of scans; the package pye57 (libE57Format) reads them. Writing is e57_writer.py's matter.

The points of one scan, or of all with the attribute `scan_index`, each scan moved by its pose T_world_scan; spherical
coordinates become cartesian ones; points that the scanner marked as invalid are left out. Intensities and times that it
marked so are NaN, and colors are white with a warning. Colours are taken to 0..1 by the scan's limits. rowIndex,
columnIndex, returnIndex, returnCount, timeStamp and intensity become attributes of the same name in our spelling, in
the narrowest type that holds them; normals are those of the extension "nor". Of several scans only what all of them
have is kept. Pictures and scanner data are not read. All lengths are metres.

Source: ASTM E2807-11; the extension "nor" of libe57.org.
"""

from __future__ import annotations

import contextlib
import importlib
import os
import warnings
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...core.coordinates import quiet
from ...core.errors import FileError
from ...core.escaped_text import escaped
from ...core.quaternions import quaternions_to_rotations
from ...core.units import METRE
from ..columns import stack_colors, stack_normals
from ..foreign import foreign_errors, import_for
from ..growing import GrowingColumns
from ..source import open_source
from ..table import PointTable

BLOCK = 1 << 18  # points unpacked at a time

CARTESIAN: tuple[str, ...] = ("cartesianX", "cartesianY", "cartesianZ")
_SPHERICAL: tuple[str, ...] = ("sphericalRange", "sphericalAzimuth", "sphericalElevation")
COLORS: tuple[str, ...] = ("colorRed", "colorGreen", "colorBlue")
NORMALS: tuple[str, ...] = ("nor:normalX", "nor:normalY", "nor:normalZ")
_INVALID = ("cartesianInvalidState", "sphericalInvalidState")  # 0 is valid, 1 a direction without a range

_FLAGS = {"intensity": "isIntensityInvalid", "timeStamp": "isTimeStampInvalid"}  # 1 where a point has no such value
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
NARROW = [np.dtype(code) for code in ("u1", "i1", "u2", "i2")]
WIDE = np.dtype("q")  # pye57 takes no 32-bit integers, and 64-bit ones rightly under this of their two names only


class ScanFrame(NamedTuple):
    """The name of a scan and its pose T_world_scan, float64 (4, 4), or None."""

    name: str
    pose: NDArray[np.float64] | None


def read_e57(path: str | os.PathLike[str], *, scan: int | None = None) -> PointTable:
    """Read the points of an E57 file.

    Args:
        path: The file.
        scan: Which scan, from 0; None reads all, which then have the attribute `scan_index`.

    Raises:
        FileError: Missing, no E57 file, damaged, without scans, or pye57 is missing.
        IndexError: There is no such scan.

    Notes:
        Memory: the result and twice the largest scan.
    """
    with open_e57(path) as (image, scans):
        if scan is not None and not 0 <= scan < len(scans):
            raise IndexError(f"scan: expected 0..{len(scans) - 1}, got {scan}")
        if scan is not None:
            return read_scan(path, image, scans[scan])
        tables = [read_scan(path, image, node) for node in scans]
    merged = merge_scans(tables)
    counts = [len(table.points) for table in tables]
    merged.attributes[SCAN_INDEX] = np.repeat(np.arange(len(tables), dtype=np.int32), counts)
    return merged


def describe_e57(path: str | os.PathLike[str]) -> list[dict[str, Any]]:
    """The name, the number of points, the fields and the pose's position [m] of each scan.

    Raises:
        FileError: As `read_e57`.
    """
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


def read_frames(path: str | os.PathLike[str]) -> tuple[list[ScanFrame], list[str]]:
    """The name and the pose of each scan, and what the file has beside points.

    Raises:
        FileError: As `read_e57`.
    """
    with open_e57(path) as (image, scans), foreign_errors(path, "a scan is damaged"):
        frames = []
        for node in scans:
            pose = None
            if node.isDefined("pose"):
                pose = np.eye(4)
                pose[:3, :3], pose[:3, 3] = read_pose(path, node)
            frames.append(ScanFrame(node["name"].value() if node.isDefined("name") else "", pose))
        beside = ["pictures"] if image.root().isDefined("images2D") and len(image.root()["images2D"]) else []
        if any(node.isDefined(name) for node in scans for name in _SCANNER_DATA):
            beside.append("scanner data")
    return frames, beside


@contextlib.contextmanager
def open_e57(path: str | os.PathLike[str]) -> Iterator[tuple[Any, list[Any]]]:
    """The file as libE57 sees it, and its scans."""
    source = open_source(path)
    if source[:8] != b"ASTM-E57":
        raise FileError(path, "is no E57 file: its first eight bytes are not ASTM-E57", where="byte 0")
    libe57 = import_for(path, "pye57.libe57", "e57")
    with foreign_errors(path, "is no intact E57 file"):
        image = libe57.ImageFile(os.fspath(path), "r")
    try:
        with foreign_errors(path, "its list of scans is damaged"):
            data = image.root()["data3D"]
            scans = [data[k] for k in range(len(data))]
        if not scans:
            raise FileError(path, "holds no scan of points")
        yield image, scans
    finally:
        image.close()


def _libe57() -> Any:
    """pye57's module, of which it is known by now that it is there."""
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


@quiet()
def read_scan(path: Any, image: Any, scan: Any, *, placed: bool = True) -> PointTable:
    """The points of a scan, moved by its pose, or in its own coordinates."""
    with foreign_errors(path, "a scan is damaged"):
        fields = _fields(scan)
        R, translation = read_pose(path, scan) if placed else (np.eye(3), np.zeros(3))
        place = next((names for names in (CARTESIAN, _SPHERICAL) if all(name in fields for name in names)), None)
        if place is None:
            raise FileError(path, f"a scan has no coordinates; its fields are {', '.join(fields)}")
        wanted = {name: np.dtype(np.float64) for name in place}
        wanted |= {name: _narrowest(fields[name]) for name in ATTRIBUTES if name in fields}
        for names in (COLORS, NORMALS):
            wanted |= dict.fromkeys(names, np.dtype(np.float32)) if all(name in fields for name in names) else {}
        invalid = _INVALID[place is _SPHERICAL]
        flags = [invalid, *(flag for name, flag in _FLAGS.items() if name in wanted)]
        flags += [_COLOR_FLAG] if COLORS[0] in wanted else []
        wanted |= {name: np.dtype(np.int8) for name in flags if name in fields}
        columns = _read_columns(path, image, scan["points"], wanted)
        limits = _color_limits(scan, fields) if COLORS[0] in wanted else []
    if invalid in columns:
        valid = columns.pop(invalid) == 0
        columns = {name: values[valid] for name, values in columns.items()}
    for name, flag in _FLAGS.items():
        if flag in columns and columns[flag].any():
            columns[name] = np.where(columns[flag] != 0, np.nan, columns[name].astype(_with_nan(columns[name].dtype)))
    points = _to_cartesian(*(columns[name] for name in place), is_spherical=place is _SPHERICAL) @ R.T + translation
    colors = normals = None
    if limits:
        channels = [(columns[name] - low) / (high - low) for name, (low, high) in zip(COLORS, limits, strict=True)]
        colors = stack_colors(path, [channel.astype(np.float32) for channel in channels])
        if colors is not None and _COLOR_FLAG in columns:
            colors = _with_white(path, colors, columns[_COLOR_FLAG] != 0)
    if NORMALS[0] in columns:
        stored = np.stack([columns[name] for name in NORMALS], axis=1)
        normals = stack_normals(path, [*(stored @ R.T).T])
    attributes = {ours: columns[name] for name, ours in ATTRIBUTES.items() if name in columns}
    attributes = {name: v.view(np.int64) if v.dtype == np.int64 else v for name, v in attributes.items()}
    return PointTable(points, normals, colors, attributes, unit=METRE)


def _with_nan(dtype: np.dtype[Any]) -> np.dtype[Any]:
    """The type of floats that holds all numbers of a type, of 64-bit integers those up to 2^53."""
    return np.result_type(dtype, np.float32)


def _with_white(path: Any, colors: NDArray[Any], is_missing: NDArray[np.bool_]) -> NDArray[Any] | None:
    """The colors, white where a point has none, with a warning; None if no point has one."""
    if is_missing.all():
        return None
    if is_missing.any():
        message = f"{path}: {np.count_nonzero(is_missing)} of {len(colors)} points have no color; they are white"
        warnings.warn(escaped(message), UserWarning, stacklevel=4)
        colors = np.where(is_missing[:, None], np.float32(1), colors)
    return colors


def _read_columns(path: Any, image: Any, vector: Any, wanted: dict[str, np.dtype[Any]]) -> dict[str, NDArray[Any]]:
    """The fields of all points; memory follows what the file delivers, not what it says."""
    libe57 = _libe57()
    count = vector.childCount()
    blocks = {name: np.empty(min(count, BLOCK), dtype) for name, dtype in wanted.items()}
    columns = GrowingColumns(count, is_proven=False)
    columns.append({name: block[:0] for name, block in blocks.items()})
    if not count:
        return columns.finish()
    buffers = libe57.VectorSourceDestBuffer()
    for name, block in blocks.items():
        buffers.append(libe57.SourceDestBuffer(image, name, block, len(block), True, True))
    reader, found = vector.reader(buffers), 0
    try:
        while added := reader.read():
            columns.append({name: block[:added] for name, block in blocks.items()})
            found += added
    finally:
        reader.close()
    if found != count:
        raise FileError(path, f"truncated: a scan has {found} of {count} points")
    return columns.finish()


def _to_cartesian(
    x: NDArray[np.float64], y: NDArray[np.float64], z: NDArray[np.float64], *, is_spherical: bool
) -> NDArray[np.float64]:
    """Positions [n, 3]; spherical ones are range [m], azimuth and elevation [rad] (ASTM E2807-11, section 8.4.4)."""
    if is_spherical:
        reach, azimuth, elevation = x, y, z
        flat = reach * np.cos(elevation)
        x, y, z = flat * np.cos(azimuth), flat * np.sin(azimuth), reach * np.sin(elevation)
    return np.stack([x, y, z], axis=1)


def read_pose(path: Any, scan: Any) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Rotation [3, 3] and translation [3] of T_world_scan; the identity where the scan has no pose."""
    quaternion, translation = np.array([0, 0, 0, 1.0]), np.zeros(3)
    if scan.isDefined("pose/rotation"):
        quaternion = np.array([scan["pose"]["rotation"][axis].value() for axis in "xyzw"], np.float64)
    if scan.isDefined("pose/translation"):
        translation = np.array([scan["pose"]["translation"][axis].value() for axis in "xyz"], np.float64)
    norm = np.linalg.norm(quaternion)
    if not (np.isfinite(translation).all() and np.isfinite(norm) and norm > 0):
        raise FileError(path, f"a scan's pose is no motion: {np.roll(quaternion, 1).tolist()}, {translation.tolist()}")
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
    """What black and full brightness are for each channel: the scan's limits, else the range of the stored type."""
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


def merge_scans(tables: list[PointTable]) -> PointTable:
    """The points of all scans with what every one of them has; an attribute takes a type that holds all its values."""
    names = [name for name in tables[0].attributes if all(name in table.attributes for table in tables)]
    normals = [table.normals for table in tables if table.normals is not None]
    colors = [table.colors for table in tables if table.colors is not None]
    return PointTable(
        np.concatenate([table.points for table in tables]),
        np.concatenate(normals) if len(normals) == len(tables) else None,
        np.concatenate(colors) if len(colors) == len(tables) else None,
        {name: np.concatenate([table.attributes[name] for table in tables]) for name in names},
        unit=METRE,
    )
