"""Tables of points and meshes in NumPy: the common result of readers and input of writers."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..core.checks import check_numeric, check_rows, check_textures
from ..core.coordinate_systems import CoordinateSystem, is_in_degrees
from ..core.coordinates import lengths_of_axes
from ..core.escaped_text import escaped
from ..core.units import LengthUnit
from ..core.up_axis import Direction


@dataclass
class PointTable:
    """The points of a file.

    Attributes:
        points: Positions (n, 3), float32 or float64 as stored.
        normals: Normals as stored, float32 (n, 3), or None.
        colors: Colors in 0..1, float32 (n, 3), or None.
        attributes: Other values per point by name, in their own type, shape (n,) or (n, c).
        grid: (height, width) of an organized cloud, row by row, or None.
        steps: Coordinate steps of the file, float64 (3,), or None.
        is_geographic: True if x and y are longitude and latitude.
        unit: Unit of the coordinates, or None.
        warnings: What contradicts the unit, in sentences.
        viewpoint: Position and quaternion w x y z of the sensor, not applied (PCD), or None.
        crs: Coordinate system, or None.
        origin: Origin of a cloud whose points are float32 about it, float64 (3,). None for points as stored in a file.
    """

    points: NDArray[Any]
    normals: NDArray[Any] | None = None
    colors: NDArray[Any] | None = None
    attributes: dict[str, NDArray[Any]] = field(default_factory=dict)
    grid: tuple[int, int] | None = None
    steps: NDArray[np.float64] | None = None
    is_geographic: bool = False
    unit: LengthUnit | None = None
    warnings: tuple[str, ...] = ()
    viewpoint: tuple[float, ...] | None = None
    crs: CoordinateSystem | None = None
    origin: NDArray[np.float64] | None = None

    @property
    def in_degrees(self) -> bool:
        """True if x and y are longitude and latitude."""
        return self.is_geographic or is_in_degrees(self.unit, self.crs)

    @property
    def unit_lengths(self) -> NDArray[np.float64]:
        """The unit of each axis [m], shape (3,)."""
        return lengths_of_axes(None if self.unit is None else self.unit.meters, in_degrees=self.in_degrees)

    def columns(self) -> dict[str, NDArray[Any]]:
        """All arrays except positions, by name."""
        own = {"normals": self.normals, "colors": self.colors}
        return {name: values for name, values in own.items() if values is not None} | self.attributes

    def checked(self) -> PointTable:
        """The table with validated arrays, for writers. Raises `TypeError` or `ValueError`."""
        points = _floating(check_rows("points", self.points, 3))
        count = len(points)
        if self.grid is not None and (min(self.grid) < 1 or self.grid[0] * self.grid[1] != count):
            raise ValueError(f"grid: expected height x width = {count} points, got {self.grid}")
        return PointTable(
            points,
            _optional_rows("normals", self.normals, count),
            _optional_rows("colors", self.colors, count),
            _checked_attributes(self.attributes, count),
            self.grid,
            self.steps,
            self.is_geographic,
            self.unit,
            self.warnings,
            self.viewpoint,
            self.crs,
            self.origin,
        )


@dataclass
class MeshTable:
    """The triangle mesh of a file.

    Attributes:
        vertices: Positions (m, 3), float32 or float64 as stored.
        triangles: Vertex indices, int32 or int64 (t, 3).
        vertex_normals: As stored, float32 (m, 3), or None.
        vertex_colors: In 0..1, float32 (m, 3), or None.
        attributes: Other values per vertex by name, in their own type, shape (m,) or (m, c).
        triangle_attributes: As `attributes` for triangles; "colors" is in 0..1, float32 (t, 3 or 4).
        triangle_uvs: Texture coordinates of corners, float32 (3 t, 2), origin at the lower left; or None.
        triangle_material_ids: Texture index of each triangle, int32 (t,); None: all use the first.
        textures: Images, uint8 (height, width, 3 or 4), top row first.
        unit: Unit of the positions, or None.
        crs: Coordinate system, or None.
        up: Up direction, or None if unknown.
    """

    vertices: NDArray[Any]
    triangles: NDArray[Any]
    vertex_normals: NDArray[Any] | None = None
    vertex_colors: NDArray[Any] | None = None
    attributes: dict[str, NDArray[Any]] = field(default_factory=dict)
    triangle_attributes: dict[str, NDArray[Any]] = field(default_factory=dict, kw_only=True)
    triangle_uvs: NDArray[Any] | None = None
    triangle_material_ids: NDArray[Any] | None = None
    textures: tuple[NDArray[np.uint8], ...] = ()
    unit: LengthUnit | None = field(default=None, kw_only=True)
    crs: CoordinateSystem | None = field(default=None, kw_only=True)
    up: Direction | None = field(default=None, kw_only=True)

    def checked(self) -> MeshTable:
        """The mesh with validated arrays, for writers. Raises `TypeError` or `ValueError`."""
        vertices = _floating(check_rows("vertices", self.vertices, 3))
        count = len(vertices)
        triangles = check_rows("triangles", self.triangles, 3)
        if triangles.size and triangles.dtype.kind not in "iu":
            raise TypeError(f"triangles: expected whole numbers, got {triangles.dtype}")
        if triangles.size and (triangles.min() < 0 or triangles.max() >= count):
            row = int(np.flatnonzero(((triangles < 0) | (triangles >= count)).any(axis=1))[0])
            raise ValueError(
                f"triangles: row {row} is {triangles[row].tolist()}, but there are vertices 0..{count - 1} only"
            )
        return MeshTable(
            vertices,
            triangles.astype(_index_type(count), copy=False),
            _optional_rows("vertex_normals", self.vertex_normals, count),
            _optional_rows("vertex_colors", self.vertex_colors, count),
            _checked_attributes(self.attributes, count),
            _corner_rows(self.triangle_uvs, len(triangles)),
            _material_ids(self.triangle_material_ids, len(triangles), len(self.textures)),
            check_textures("textures", self.textures),
            triangle_attributes=_checked_attributes(self.triangle_attributes, len(triangles)),
            unit=self.unit,
            crs=self.crs,
            up=self.up,
        )

    def without_texture(self) -> MeshTable:
        return replace(self, triangle_uvs=None, triangle_material_ids=None, textures=())


def _corner_rows(values: Any, count: int) -> NDArray[np.float32] | None:
    return None if values is None else check_rows("triangle_uvs", values, 2, rows=3 * count, dtype=np.float32)


def _material_ids(values: Any, count: int, image_count: int) -> NDArray[np.int32] | None:
    if values is None:
        return None
    ids = check_numeric("triangle_material_ids", values)
    if ids.size and ids.dtype.kind not in "iu":
        raise TypeError(f"triangle_material_ids: expected whole numbers, got {ids.dtype}")
    if ids.shape != (count,):
        raise ValueError(f"triangle_material_ids: expected shape [{count}], got {list(ids.shape)}")
    limit = image_count or 2**31
    if ids.size and (ids.min() < 0 or ids.max() >= limit):
        raise ValueError(f"triangle_material_ids: expected 0..{limit - 1}, got {ids.min()}..{ids.max()}")
    return ids.astype(np.int32)


def _index_type(vertex_count: int) -> Any:
    return np.int32 if vertex_count <= 2**31 else np.int64


def _floating(points: NDArray[Any]) -> NDArray[Any]:
    """Positions as float32 if stored so, else float64, in native byte order."""
    return points.astype(np.float32 if points.dtype in (np.float32, np.float16) else np.float64, copy=False)


def _optional_rows(name: str, values: Any, count: int) -> NDArray[Any] | None:
    return None if values is None else check_rows(name, values, 3, rows=count, dtype=np.float32)


def _checked_attributes(attributes: dict[str, Any], count: int) -> dict[str, NDArray[Any]]:
    checked = {}
    for name, values in attributes.items():
        if not isinstance(name, str):
            raise TypeError(f"attributes: expected names that are strings, got {name!r}")
        array = check_numeric(escaped(name), values)
        if array.ndim not in (1, 2) or len(array) != count:
            raise ValueError(f"{escaped(name)}: expected shape [{count}] or [{count}, c], got {list(array.shape)}")
        checked[name] = array.astype(array.dtype.newbyteorder("="), copy=False)
    return checked
