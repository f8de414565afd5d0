"""What a file holds, in NumPy: the one shape that every reader returns and every writer takes."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..core.checks import check_numeric, check_rows, check_textures
from ..core.units import LengthUnit


@dataclass
class PointTable:
    """The points of one file.

    Attributes:
        points: Positions, shape [n, 3], float32 or float64 as the file has them.
        normals: Unit normals as stored, float32 [n, 3], or None.
        colors: Colours in 0..1, float32 [n, 3], or None.
        attributes: Every other per-point value by name, in its own type, shape [n] or [n, c].
        grid: (height, width) of an organised cloud, whose points then run row by row; None otherwise.
        steps: Steps of the coordinates where the file holds whole multiples of such, float64 [3]; None otherwise.
        is_geographic: Whether the file says that x and y are longitude and latitude.
        unit: Of the coordinates, where the file tells it.
        unit_doubt: What the file says against that unit, in a sentence, or None.
        viewpoint: Position and quaternion w x y z of the sensor, not applied to the points (PCD); None at the origin.
    """

    points: NDArray[Any]
    normals: NDArray[Any] | None = None
    colors: NDArray[Any] | None = None
    attributes: dict[str, NDArray[Any]] = field(default_factory=dict)
    grid: tuple[int, int] | None = None
    steps: NDArray[np.float64] | None = None
    is_geographic: bool = False
    unit: LengthUnit | None = None
    unit_doubt: str | None = None
    viewpoint: tuple[float, ...] | None = None

    def checked(self) -> PointTable:
        """The same table with every array checked, as the writers need it.

        Raises:
            TypeError: An array that is not numeric.
            ValueError: An array whose shape does not go with the number of points, or a grid that does not.
        """
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
            self.unit_doubt,
            self.viewpoint,
        )


@dataclass
class MeshTable:
    """The triangle mesh of one file.

    Attributes:
        vertices: Positions, shape [m, 3], float32 or float64 as the file has them.
        triangles: Rows of three vertex indices, int32 or int64 [t, 3].
        vertex_normals: As stored, float32 [m, 3], or None.
        vertex_colors: In 0..1, float32 [m, 3], or None.
        attributes: Every other per-vertex value by name, in its own type, shape [m] or [m, c].
        triangle_attributes: The same for triangles, shape [t] or [t, c]; "colors": 0..1, float32 [t, 3] or [t, 4].
        triangle_uvs: Texture coordinates of corners, float32 [3 t, 2], (0, 0) the lower left corner; or None.
        triangle_material_ids: Which of the textures each triangle has, int32 [t]; None where all have the first.
        textures: Pictures, uint8 [height, width, 3 or 4], top row first.
        unit: Of the positions, where the file tells it.
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

    def checked(self) -> MeshTable:
        """The same mesh with every array checked, as the writers need it.

        Raises:
            TypeError: An array that is not numeric, or triangles that are not whole numbers.
            ValueError: An array of another shape, or a triangle that names a vertex which does not exist.
        """
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
        )

    def without_texture(self) -> MeshTable:
        """The mesh without texture coordinates, material numbers and pictures."""
        return replace(self, triangle_uvs=None, triangle_material_ids=None, textures=())


def _corner_rows(values: Any, count: int) -> NDArray[np.float32] | None:
    return None if values is None else check_rows("triangle_uvs", values, 2, rows=3 * count, dtype=np.float32)


def _material_ids(values: Any, count: int, picture_count: int) -> NDArray[np.int32] | None:
    if values is None:
        return None
    ids = check_numeric("triangle_material_ids", values)
    if ids.size and ids.dtype.kind not in "iu":
        raise TypeError(f"triangle_material_ids: expected whole numbers, got {ids.dtype}")
    if ids.shape != (count,):
        raise ValueError(f"triangle_material_ids: expected shape [{count}], got {list(ids.shape)}")
    most = picture_count or 2**31
    if ids.size and (ids.min() < 0 or ids.max() >= most):
        raise ValueError(f"triangle_material_ids: expected 0..{most - 1}, got {ids.min()}..{ids.max()}")
    return ids.astype(np.int32)


def _index_type(vertex_count: int) -> Any:
    """The integer type for triangles: 32 bits wherever they reach."""
    return np.int32 if vertex_count <= 2**31 else np.int64


def _floating(points: NDArray[Any]) -> NDArray[Any]:
    """Positions in float32 where they are, in float64 otherwise; always in the machine's byte order."""
    return points.astype(np.float32 if points.dtype in (np.float32, np.float16) else np.float64, copy=False)


def _optional_rows(name: str, values: Any, count: int) -> NDArray[Any] | None:
    return None if values is None else check_rows(name, values, 3, rows=count, dtype=np.float32)


def _checked_attributes(attributes: dict[str, Any], count: int) -> dict[str, NDArray[Any]]:
    checked = {}
    for name, values in attributes.items():
        if not isinstance(name, str):
            raise TypeError(f"attributes: expected names that are strings, got {name!r}")
        array = check_numeric(name, values)
        if array.ndim not in (1, 2) or len(array) != count:
            raise ValueError(f"{name}: expected shape [{count}] or [{count}, c], got {list(array.shape)}")
        checked[name] = array.astype(array.dtype.newbyteorder("="), copy=False)
    return checked
