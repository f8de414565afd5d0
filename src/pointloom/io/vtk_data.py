"""Polygonal data of VTK files, `VtkData`, and its conversion to tables of points and meshes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..core.coordinates import quiet
from ..core.errors import CLOUD_REMEDY, FileError, FilePath
from ..core.other_geometry import CRS, UNIT, OtherGeometry
from ..core.to_other_libraries import COLORS, NORMALS, UVS, colors_as_bytes
from ..core.units import text_of
from .table import MeshTable, PointTable
from .triangulation import split_faces, triangle_counts

KINDS = ("vertices", "lines", "polygons", "strips")  # in the order of the cells

# Types of numbers by their names in legacy files. Only these are written.
LEGACY_TYPES = {
    "unsigned_char": "u1", "char": "i1", "unsigned_short": "u2", "short": "i2", "unsigned_int": "u4", "int": "i4",
    "vtktypeuint64": "u8", "vtktypeint64": "i8", "unsigned_long": "u8", "long": "i8", "vtkidtype": "i4",
    "float": "f4", "double": "f8",
}  # fmt: skip


@dataclass
class Cells:
    """Cells as the number of points of each, and the points of all in order."""

    lengths: NDArray[np.int64] = field(default_factory=lambda: np.empty(0, np.int64))
    points: NDArray[np.int64] = field(default_factory=lambda: np.empty(0, np.int64))


@dataclass
class VtkData:
    """The content of a VTK file. `cell_data` has the rows of all cells in the order of KINDS."""

    points: NDArray[Any]
    cells: dict[str, Cells] = field(default_factory=lambda: {kind: Cells() for kind in KINDS})
    point_data: dict[str, NDArray[Any]] = field(default_factory=dict)
    cell_data: dict[str, NDArray[Any]] = field(default_factory=dict)
    field_data: dict[str, Any] = field(default_factory=dict)


def check_data(path: FilePath, data: VtkData) -> None:
    """Raise `FileError` if cells refer to missing points, or if arrays do not have a row per point or cell."""
    count = len(data.points)
    for kind, cells in data.cells.items():
        wrong = np.flatnonzero((cells.points < 0) | (cells.points >= count))
        if len(wrong):
            reason = f"{kind}: a cell refers to point {cells.points[wrong[0]]}, but there are {count} points"
            raise FileError(path, reason)
    cell_count = sum(len(cells.lengths) for cells in data.cells.values())
    for of, rows, expected in (("points", data.point_data, count), ("cells", data.cell_data, cell_count)):
        for name, values in rows.items():
            if len(values) != expected:
                raise FileError(path, f"{name}: expected a row for each of {expected} {of}, got {len(values)}")


def points_of(path: FilePath, data: VtkData) -> PointTable:
    """A table of the points. Raises `FileError` if the file has polygons."""
    faces = len(data.cells["polygons"].lengths) + len(data.cells["strips"].lengths)
    if faces:
        raise FileError(path, f"contains a mesh of {faces} polygons", remedy="Use read_triangle_mesh")
    given = OtherGeometry(str(path), data.points)
    _take(given, data)
    given.left_out += [f"cell data {name}" for name in data.cell_data]
    given.warn()
    return PointTable(
        given.points, _floats(given.normals), _floats(given.colors), given.attributes, unit=given.unit, crs=given.crs
    ).checked()


def mesh_of(path: FilePath, data: VtkData) -> MeshTable:
    """A table of the triangulated polygons. Raises `FileError` if there are none."""
    polygons = data.cells["polygons"]
    if len(data.cells["strips"].lengths):
        raise FileError(path, "triangle strips are not supported", remedy="Convert them with vtkTriangleFilter")
    if not len(polygons.lengths):
        raise FileError(path, "contains no faces", remedy=CLOUD_REMEDY)
    given = OtherGeometry(str(path), data.points, corners=polygons.points, lengths=polygons.lengths)
    _take(given, data)
    first = len(data.cells["vertices"].lengths) + len(data.cells["lines"].lengths)
    given.take_faces({name: values[first:] for name, values in data.cell_data.items()})
    given.left_out += ["vertex cells"] if len(data.cells["vertices"].lengths) else []
    given.warn()
    at = split_faces(path, polygons.lengths, polygons.points, data.points)
    repeats = triangle_counts(polygons.lengths)
    of_faces = {name: np.repeat(values, repeats, axis=0) for name, values in given.face_attributes.items()}
    if "colors" in of_faces:
        of_faces["colors"] = of_faces["colors"].astype(np.float32)
    return MeshTable(
        given.points,
        polygons.points[at],
        _floats(given.normals),
        _floats(given.colors),
        given.attributes,
        triangle_attributes=of_faces,
        triangle_uvs=None if given.uvs is None else given.uvs[at.reshape(-1)],
        unit=given.unit,
        crs=given.crs,
    ).checked()


def _take(given: OtherGeometry, data: VtkData) -> None:
    given.take_points(data.point_data)
    given.take_metadata(data.field_data)
    if lines := len(data.cells["lines"].lengths):
        given.left_out.append(f"{lines} lines")


def _floats(values: NDArray[Any] | None) -> NDArray[np.float32] | None:
    return None if values is None else numbers_as(values, np.dtype(np.float32))


def parse_numbers(words: Sequence[bytes], dtype: np.dtype[Any]) -> NDArray[Any]:
    """Words as numbers of a type. Raises ValueError or OverflowError. The longest word does not affect the memory."""
    wide, parse = (np.float64, float) if dtype.kind == "f" else (np.uint64 if dtype == "u8" else np.int64, int)
    return numbers_as(np.fromiter(map(parse, words), wide, len(words)), dtype)


def numbers_as(values: NDArray[Any], dtype: np.dtype[Any]) -> NDArray[Any]:
    """Numbers in a type. Raises ValueError if it cannot represent one of them, apart from rounding of floats."""
    with quiet():
        result = values.astype(dtype)
    is_wrong = np.isinf(result) & np.isfinite(values) if dtype.kind == "f" else result != values
    if is_wrong.any():
        raise ValueError(f"{values[is_wrong][0]} is out of the range of {dtype}")
    return result


def data_of(table: PointTable | MeshTable) -> VtkData:
    """The content of a file for a checked table. Textures are the caller's. Texture coordinates must be per vertex."""
    if isinstance(table, MeshTable):
        data = VtkData(table.vertices)
        normals, colors, triangles = table.vertex_normals, table.vertex_colors, table.triangles
        data.cells["polygons"] = Cells(np.full(len(triangles), 3, np.int64), triangles.reshape(-1).astype(np.int64))
        data.cell_data = _with_colors(table.triangle_attributes.get("colors"), table.triangle_attributes)
    else:
        data = VtkData(table.points)
        normals, colors, count = table.normals, table.colors, len(table.points)
        data.cells["vertices"] = Cells(np.ones(count, np.int64), np.arange(count, dtype=np.int64))
    data.point_data = ({} if normals is None else {NORMALS: normals}) | _with_colors(colors, table.attributes)
    data.field_data = {} if table.unit is None else {UNIT: text_of(table.unit)}
    data.field_data |= {} if table.crs is None else {CRS: table.crs.text}
    return data


def _with_colors(colors: NDArray[Any] | None, attributes: Mapping[str, NDArray[Any]]) -> dict[str, NDArray[Any]]:
    """Attributes with colors in 8 bits. Booleans become bytes, halves float32, as VTK has neither."""
    kinds = {np.dtype(bool): np.uint8, np.dtype(np.float16): np.float32}
    others = {name: np.asarray(values) for name, values in attributes.items() if name != "colors"}
    named = {name: values.astype(kinds.get(values.dtype, values.dtype)) for name, values in others.items()}
    return named if colors is None else {COLORS: colors_as_bytes(colors), **named}


RESERVED = (NORMALS, COLORS, UVS)  # names of arrays with a meaning
