"""Write E57 files: one scan per value of `scan_index`, with poses if given, positions in meters, 8-bit colors.

Only the attributes of e57.py can be stored. ASTM E2807-11. The extension "nor" (normals) of libe57.org.
"""

from __future__ import annotations

import hashlib
import shutil
import uuid
from collections.abc import Sequence
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.atomic import atomic_write, check_writable, part_name
from ...core.coordinate_systems import CoordinateSystem
from ...core.coordinates import quiet
from ...core.errors import FileError, FilePath
from ...core.quaternions import rotations_to_quaternions
from ..columns import colors_to_bytes
from ..optional_imports import foreign_errors, import_for
from ..table import PointTable
from .e57 import ATTRIBUTES, CARTESIAN, COLORS, NARROW, NORMALS, POINTS_PER_BLOCK, SCAN_INDEX, WIDE, ScanFrame
from .header_units import in_metres
from .las_wkt import wkt_of

_NORMALS_URI = "http://www.libe57.org/E57_NOR_surface_normals.txt"
_FLOATS = ("f4", "f8")
Scan = tuple[str, dict[str, NDArray[Any]], NDArray[np.float64] | None]  # name, columns by E57 names, pose or None


@quiet()
def write_e57(path: FilePath, table: PointTable, *, overwrite: bool = True, frames: Sequence[ScanFrame] = ()) -> None:
    """Write points in world coordinates as E57 atomically; `frames` are names and poses of scans by `scan_index`.
    Points of scans with a pose are stored in scan coordinates."""
    path = check_writable(path, overwrite=overwrite)
    table = check_e57(path, table)
    columns = columns_of(path, table)
    scan_index = table.attributes.get(SCAN_INDEX, np.zeros(len(table.points), np.int32))
    indices = np.unique(scan_index)
    scans: list[Scan] = []
    for number, index in enumerate(indices if len(indices) else [0]):
        chosen = slice(None) if len(indices) <= 1 else scan_index == index
        name, pose = frames[int(index)] if 0 <= index < len(frames) else ScanFrame("", None)
        scan_columns = {n: v[chosen] for n, v in columns.items()}
        scans.append((name or f"Scan {number}", scan_columns if pose is None else _in_scan(scan_columns, pose), pose))
    write_scans(path, scans, overwrite=overwrite, crs=table.crs)


def _in_scan(columns: dict[str, NDArray[Any]], pose: NDArray[np.float64]) -> dict[str, NDArray[Any]]:
    points = np.stack([columns[name] for name in CARTESIAN], axis=1).astype(np.float64)
    columns = columns | dict(zip(CARTESIAN, ((points - pose[:3, 3]) @ pose[:3, :3]).T, strict=True))
    if NORMALS[0] in columns:
        normals = np.stack([columns[name] for name in NORMALS], axis=1) @ pose[:3, :3]
        columns |= dict(zip(NORMALS, normals.T.astype(np.float32), strict=True))
    return columns


def write_scans(path: Path, scans: Sequence[Scan], *, overwrite: bool, crs: CoordinateSystem | None = None) -> None:
    libe57 = import_for(path, "pye57.libe57", "e57")
    folder = part_name(path)
    part = folder / "part.e57"  # libE57 opens files by name
    try:
        with foreign_errors(path, "cannot be written"):
            folder.mkdir(0o700)
            _write_image(libe57, part, scans, crs)
        with atomic_write(path, overwrite=overwrite) as file, part.open("rb") as source:
            shutil.copyfileobj(source, file, 1 << 20)
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def check_e57(path: FilePath, table: PointTable) -> PointTable:
    """The table in meters. Raises `FileError` if E57 cannot store it (non-finite, unknown attribute, degrees)."""
    table = in_metres(path, table.checked(), "E57")
    lost = unstorable_in_e57(table)
    if lost:
        known = ", ".join([*ATTRIBUTES.values(), SCAN_INDEX])
        reason = f"attribute{'s' if len(lost) > 1 else ''} {', '.join(map(repr, lost))} cannot be stored in E57"
        remedy = f"It stores {known}, one finite number per point; drop the others with drop_unsupported=True"
        raise FileError(path, reason, remedy=remedy)
    if not np.isfinite(table.points).all():
        row = int(np.flatnonzero(~np.isfinite(table.points).all(axis=1))[0])
        raise FileError(path, f"point {row} is not finite", remedy="Call remove_non_finite_points() first")
    return table


def unstorable_in_e57(table: PointTable) -> list[str]:
    return [name for name, values in table.attributes.items() if not _is_storable(name, values)]


def _is_storable(name: str, values: NDArray[Any]) -> bool:
    if name not in (*ATTRIBUTES.values(), SCAN_INDEX) or values.ndim != 1:
        return False
    if values.dtype.kind == "f":
        return name != SCAN_INDEX and values.dtype.str[1:] in _FLOATS and bool(np.isfinite(values).all())
    if not len(values) or values.dtype.kind == "b":
        return values.dtype.kind != "b"
    low, high = int(values.min()), int(values.max())
    return high < 2**63 and high - low < 2**63


def columns_of(path: FilePath, table: PointTable) -> dict[str, NDArray[Any]]:
    columns: dict[str, NDArray[Any]] = dict(zip(CARTESIAN, table.points.T, strict=True))
    if table.normals is not None:
        columns |= dict(zip(NORMALS, table.normals.T, strict=True))
    if table.colors is not None:
        columns |= dict(zip(COLORS, colors_to_bytes(path, table.colors).T, strict=True))
    for name, attribute in ATTRIBUTES.items():
        if attribute in table.attributes:
            values = table.attributes[attribute]
            columns[name] = values if values.dtype.kind == "f" or values.dtype in NARROW else values.astype(WIDE)
    return columns


def _write_image(libe57: ModuleType, path: Path, scans: Sequence[Scan], crs: CoordinateSystem | None) -> None:
    image = libe57.ImageFile(str(path), "w")
    try:
        image.extensionsAdd("", libe57.E57_V1_0_URI)
        if any(NORMALS[0] in columns for _, columns, _ in scans):
            image.extensionsAdd("nor", _NORMALS_URI)
        root = image.root()
        root.set("formatName", libe57.StringNode(image, "ASTM E57 3D Imaging Data File"))
        digests = [_digest(number, *scan) for number, scan in enumerate(scans)]
        root.set("guid", libe57.StringNode(image, _guid(b"".join(digests))))
        root.set("versionMajor", libe57.IntegerNode(image, libe57.E57_FORMAT_MAJOR))
        root.set("versionMinor", libe57.IntegerNode(image, libe57.E57_FORMAT_MINOR))
        if crs is not None:
            root.set("coordinateMetadata", libe57.StringNode(image, wkt_of(path, crs) or crs.text))
        data = libe57.VectorNode(image, True)
        root.set("data3D", data)
        root.set("images2D", libe57.VectorNode(image, True))
        for (name, columns, pose), digest in zip(scans, digests, strict=True):
            _write_scan(libe57, image, data, _guid(digest), name, columns, pose)
    finally:
        image.close()


def _digest(number: int, name: str, columns: dict[str, NDArray[Any]], pose: NDArray[np.float64] | None) -> bytes:
    digest = hashlib.sha256(f"{number} {name}".encode())
    for field, values in columns.items():
        digest.update(field.encode())
        digest.update(np.ascontiguousarray(values).data)
    if pose is not None:
        digest.update(np.ascontiguousarray(pose).data)
    return digest.digest()


def _guid(data: bytes) -> str:
    """A GUID derived from the data, so that equal scans give equal files."""
    return f"{{{uuid.UUID(bytes=hashlib.sha256(data).digest()[:16], version=4)}}}"


def _pose_node(libe57: ModuleType, image: Any, pose: NDArray[np.float64]) -> Any:
    node = libe57.StructureNode(image)
    quaternion = rotations_to_quaternions(np.asarray(pose, np.float64)[None, :3, :3])[0]
    for field, names, values in (("rotation", "xyzw", quaternion), ("translation", "xyz", pose[:3, 3])):
        part = libe57.StructureNode(image)
        for name, value in zip(names, values, strict=True):
            part.set(name, libe57.FloatNode(image, float(value)))
        node.set(field, part)
    return node


def _write_scan(
    libe57: ModuleType,
    image: Any,
    scans: Any,
    guid: str,
    name: str,
    columns: dict[str, NDArray[Any]],
    pose: NDArray[np.float64] | None,
) -> None:
    node, prototype = libe57.StructureNode(image), libe57.StructureNode(image)
    node.set("guid", libe57.StringNode(image, guid))
    node.set("name", libe57.StringNode(image, name))
    if pose is not None:
        node.set("pose", _pose_node(libe57, image, pose))
    if COLORS[0] in columns:
        limits = libe57.StructureNode(image)
        for channel in COLORS:
            limits.set(f"{channel}Minimum", libe57.IntegerNode(image, 0))
            limits.set(f"{channel}Maximum", libe57.IntegerNode(image, 255))
        node.set("colorLimits", limits)
    for field, values in columns.items():
        if values.dtype.kind == "f":
            precision = libe57.E57_SINGLE if values.dtype.itemsize == 4 else libe57.E57_DOUBLE
            prototype.set(field, libe57.FloatNode(image, 0.0, precision))
        else:
            low, high = _integer_range(values)
            prototype.set(field, libe57.IntegerNode(image, low, low, high))
    vector = libe57.CompressedVectorNode(image, prototype, libe57.VectorNode(image, True))
    node.set("points", vector)
    scans.append(node)
    count = len(columns[CARTESIAN[0]])
    blocks = {field: np.empty(max(1, min(count, POINTS_PER_BLOCK)), values.dtype) for field, values in columns.items()}
    buffers = libe57.VectorSourceDestBuffer()
    for field, block in blocks.items():
        buffers.append(libe57.SourceDestBuffer(image, field, block, len(block), True, True))
    writer = None
    try:
        writer = vector.writer(buffers)
        for begin in range(0, count, POINTS_PER_BLOCK):
            added = min(POINTS_PER_BLOCK, count - begin)
            for field, values in columns.items():
                blocks[field][:added] = values[begin : begin + added]
            writer.write(added)
        writer.close()
    except BaseException:
        # libE57 crashes if the image is closed before its writer. No Python code may run first: Ctrl-C could end it.
        try:
            if writer is not None:
                writer.close()
        except Exception:  # the first error is the cause
            pass
        raise


def _integer_range(values: NDArray[Any]) -> tuple[int, int]:
    """The range of an integer field: that of a narrow type, which is then restored when reading, else of the values."""
    if values.dtype in NARROW:
        return int(np.iinfo(values.dtype).min), int(np.iinfo(values.dtype).max)
    return (int(values.min()), int(values.max())) if len(values) else (0, 0)
