"""Splats in PLY files: of Kerbl et al. 2023 (f_rest_i: all red, then green, then blue), and compressed.

Compressed, 16 B a splat: `chunk` has bounds of 256 splats; packed_position and packed_scale have 11, 10, 11 bits,
packed_rotation 2 bits for the index of the largest component and 10 for each other, packed_color 4 x 8 bits; `sh` has
harmonics in steps of 8 / 255 from -4. PlayCanvas Engine, "gsplat-compressed-data.js", and SuperSplat (MIT).
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.coordinates import quiet
from ...core.errors import FileError, FilePath
from ...pcd.harmonics import degree_of
from ..columns import own, stack_points
from ..points.ply import vertex_columns
from ..points.ply_header import Element, PlyHeader, Property, read_header
from ..points.ply_rows import ListColumn, read_rows
from ..source import SourceFile, open_source
from ..table import PointTable

PACKED = ("packed_position", "packed_rotation", "packed_scale", "packed_color")
_SPLATS_PER_CHUNK = 256  # of a chunk
_FIRST_HARMONIC = 0.28209479177387814
_COUNTS_OF_REST = (9, 24, 45, 72)
_PACKED_BITS = ((21, 11), (11, 10), (0, 11))
Columns = dict[str, NDArray[Any]]


def is_compressed(header: PlyHeader) -> bool:
    vertices = [element for element in header.elements if element.name == "vertex"]
    names = {prop.name for element in vertices for prop in element.properties if prop.count_type is None}
    return names >= {*PACKED}


@quiet()
def read_compressed_ply(path: Path, source: SourceFile, header: PlyHeader) -> PointTable:
    """Read packed splats as columns `f_dc`, `f_rest`, `opacity`, `scale` and `rot`."""
    elements = _read_elements(path, source, header)
    packed = elements["vertex"]
    count = len(packed[PACKED[0]])
    chunks = elements.get("chunk", {})
    bounds = _bounds_of(path, chunks, count)
    number = np.arange(count) // _SPLATS_PER_CHUNK
    points = _between(bounds, "", "xyz", number, _unpacked(packed["packed_position"], _PACKED_BITS))
    scales = _between(bounds, "scale_", "xyz", number, _unpacked(packed["packed_scale"], _PACKED_BITS))
    channels = _unpacked(packed["packed_color"], [(24, 8), (16, 8), (8, 8), (0, 8)])
    colors = channels[:, :3]
    with np.errstate(divide="ignore"):  # 0 and 1 are infinite logits
        opacity = np.log(channels[:, 3]) - np.log1p(-channels[:, 3])
    if "min_r" in bounds:
        colors = _between(bounds, "", "rgb", number, colors)
    attributes = {
        "f_dc": ((colors - 0.5) / _FIRST_HARMONIC).astype(np.float32),
        "scale": scales.astype(np.float32),
        "rot": _rotations(packed["packed_rotation"]).astype(np.float32),
        "opacity": opacity.astype(np.float32),
    }
    if "sh" in elements:
        attributes["f_rest"] = _harmonics(path, elements["sh"], count)
    return PointTable(points.astype(np.float32), attributes=attributes)


def _read_elements(path: Path, source: SourceFile, header: PlyHeader) -> dict[str, Columns]:
    def wanted(element: Element, prop: Property) -> bool:
        return prop.count_type is None and element.name in ("chunk", "vertex", "sh")

    rows = read_rows(path, source, header, wanted)
    elements = {
        name: {key: column for key, column in columns.items() if not isinstance(column, ListColumn)}
        for name, columns in rows.items()
        if name in ("chunk", "vertex", "sh")
    }
    for element, names, code in (("vertex", PACKED, "u4"), ("sh", elements.get("sh", {}), "u1")):
        for name in names:
            kind = elements[element][name].dtype
            if f"{kind.kind}{kind.itemsize}" != code:
                reason = f"{name} of a compressed splat file: expected unsigned integers of {code[1]} bytes, got {kind}"
                raise FileError(path, reason)
    return elements


def _bounds_of(path: Path, chunks: Columns, count: int) -> Columns:
    names = [f"{end}_{what}{axis}" for end in ("min", "max") for what in ("", "scale_") for axis in "xyz"]
    missing = [name for name in names if name not in chunks]
    if missing:
        raise FileError(path, f"element chunk of a compressed splat file has no {', '.join(missing)}")
    colors = [f"{end}_{channel}" for end in ("min", "max") for channel in "rgb"]
    if 0 < sum(name in chunks for name in colors) < len(colors):
        raise FileError(path, f"element chunk of a compressed splat file: expected all of {', '.join(colors)}, or none")
    chunk_count, expected = len(chunks["min_x"]), -(-count // _SPLATS_PER_CHUNK)
    if chunk_count != expected:
        raise FileError(
            path, f"expected {expected} chunks of {_SPLATS_PER_CHUNK} for {count} splats, got {chunk_count}"
        )
    return {name: column.astype(np.float64) for name, column in chunks.items()}


def _unpacked(values: NDArray[Any], bit_fields: Any) -> NDArray[np.float64]:
    """Components of packed integers in 0..1, shape (n, parts). Each place is (lowest bit, number of bits)."""
    integers = values.astype(np.uint32)
    parts = [(integers >> np.uint32(low)) & np.uint32((1 << bits) - 1) for low, bits in bit_fields]
    return np.stack([part / ((1 << bits) - 1) for part, (_, bits) in zip(parts, bit_fields, strict=True)], axis=1)


def _between(
    bounds: Columns, what: str, axes: str, number: NDArray[np.int64], parts: NDArray[np.float64]
) -> NDArray[np.float64]:
    low, high = (np.stack([bounds[f"{end}_{what}{axis}"][number] for axis in axes], axis=1) for end in ("min", "max"))
    return low * (1 - parts) + high * parts


def _rotations(values: NDArray[Any]) -> NDArray[np.float64]:
    """Unit quaternions w, x, y, z. The largest component follows from the other three."""
    others = (_unpacked(values, [(20, 10), (10, 10), (0, 10)]) - 0.5) * np.sqrt(2.0)
    largest = values.astype(np.uint32) >> np.uint32(30)
    missing = np.sqrt(np.maximum(1 - (others**2).sum(axis=1), 0))
    quaternions = np.empty((len(others), 4))
    for part in range(4):
        rows = largest == part
        quaternions[rows] = np.insert(others[rows], part, missing[rows], axis=1)
    return quaternions


def _harmonics(path: Path, columns: Columns, count: int) -> NDArray[np.float32]:
    names = [f"f_rest_{k}" for k in range(len(columns))]
    if len(columns) not in _COUNTS_OF_REST or {*columns} != {*names}:
        raise FileError(
            path, f"element sh: expected 9, 24, 45 or 72 properties f_rest_i, got {', '.join(columns)}"[:300]
        )
    if len(columns[names[0]]) != count:
        raise FileError(path, f"element sh: expected {count} rows, one per splat, got {len(columns[names[0]])}")
    return np.stack([columns[name] * (8 / 255) - 4 for name in names], axis=1).astype(np.float32)


_GROUP_WIDTHS = {"f_dc": 3, "scale": 3, "rot": 4}
_NUMBERED = re.compile(r"(f_dc|f_rest|scale|rot)_(\d+)")
_KNOWN = {"x", "y", "z", "nx", "ny", "nz"}


def read_splat_ply(path: FilePath) -> PointTable:
    """Read splats as columns `f_dc`, `f_rest`, `opacity`, `scale`, `rot`, and others by name."""
    path = Path(path)
    source = open_source(path)
    header = read_header(path, source)
    if is_compressed(header):
        return read_compressed_ply(path, source, header)
    columns = vertex_columns(path, source, header)
    missing = [name for name in ("x", "y", "z", "opacity", "f_dc_0", "scale_0", "rot_0") if name not in columns]
    if missing:
        reason = f"contains no Gaussian splats: vertices have no {', '.join(missing)}"
        raise FileError(path, reason, remedy="read_point_cloud reads points")
    counts: dict[str, int] = {}
    for name in columns:
        if match := _NUMBERED.fullmatch(name):
            counts[match[1]] = counts.get(match[1], 0) + 1
    for group, count in _GROUP_WIDTHS.items():
        if counts[group] != count:
            flat = "; splats of 2D Gaussian Splatting have 2" if (group, counts[group]) == ("scale", 2) else ""
            raise FileError(path, f"expected {count} columns {group}_i, got {counts[group]}{flat}")
    rest = counts.get("f_rest", 0)
    if rest % 3 or degree_of(rest // 3 + 1) is None:
        raise FileError(path, f"expected 0, 9, 24, 45 or 72 columns f_rest_i, got {rest}")
    attributes = {
        group: _stacked(path, columns, group, count) for group, count in (_GROUP_WIDTHS | {"f_rest": rest}).items()
    }
    attributes["opacity"] = own(columns["opacity"]).astype(np.float32)
    if not rest:
        del attributes["f_rest"]
    for name, column in columns.items():
        if name not in _KNOWN | {"opacity"} and not _NUMBERED.fullmatch(name):
            attributes[name] = own(column)
    return PointTable(stack_points([columns[axis] for axis in "xyz"]), attributes=attributes)


def _stacked(path: Path, columns: dict[str, NDArray[Any]], group: str, count: int) -> NDArray[np.float32]:
    names = [f"{group}_{i}" for i in range(count)]
    for name in names:
        if name not in columns:
            raise FileError(path, f"vertices have no {name}, but {count} columns {group}_i")
    out = np.empty((len(columns["x"]), count), np.float32)
    for i, name in enumerate(names):
        out[:, i] = columns[name]
    return out
