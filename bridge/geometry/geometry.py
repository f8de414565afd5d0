"""The bases of Open3D's shapes: what all of them answer and how they are moved."""

from __future__ import annotations

import enum
from typing import Any, ClassVar, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..held import Held
from . import rotations


class GeometryType(enum.IntEnum):
    """Kinds of shapes: what `get_geometry_type` returns."""

    Unspecified = 0
    PointCloud = 1
    VoxelGrid = 2
    LineSet = 4
    TriangleMesh = 6
    HalfEdgeTriangleMesh = 7
    Image = 8
    RGBDImage = 9
    TetraMesh = 10


class Geometry(Held):
    """What all shapes of Open3D have."""

    Type = GeometryType
    _dimension: ClassVar[int] = 3

    def dimension(self) -> int:
        """2 of images, 3 of all else."""
        return self._dimension

    def get_geometry_type(self) -> GeometryType:
        """Which kind of shape it is."""
        return GeometryType.__members__.get(type(self).__name__, GeometryType.Unspecified)


class Geometry2D(Geometry):
    """Images."""

    _dimension = 2


class Geometry3D(Geometry):
    """Shapes in space: moved in place, each method returns the shape itself."""

    get_rotation_matrix_from_xyz = staticmethod(rotations.get_rotation_matrix_from_xyz)
    get_rotation_matrix_from_yzx = staticmethod(rotations.get_rotation_matrix_from_yzx)
    get_rotation_matrix_from_zxy = staticmethod(rotations.get_rotation_matrix_from_zxy)
    get_rotation_matrix_from_xzy = staticmethod(rotations.get_rotation_matrix_from_xzy)
    get_rotation_matrix_from_zyx = staticmethod(rotations.get_rotation_matrix_from_zyx)
    get_rotation_matrix_from_yxz = staticmethod(rotations.get_rotation_matrix_from_yxz)
    get_rotation_matrix_from_axis_angle = staticmethod(rotations.get_rotation_matrix_from_axis_angle)
    get_rotation_matrix_from_quaternion = staticmethod(rotations.get_rotation_matrix_from_quaternion)

    def clear(self) -> Self:
        """Drop all that it holds."""
        return self._become(self._ours.clear())

    def is_empty(self) -> bool:
        """Whether it holds nothing."""
        return bool(self._ours.is_empty())

    def get_min_bound(self) -> NDArray[np.float64]:
        """The lowest coordinates, shape [3]."""
        return self._ours.get_min_bound()

    def get_max_bound(self) -> NDArray[np.float64]:
        """The highest coordinates, shape [3]."""
        return self._ours.get_max_bound()

    def get_center(self) -> NDArray[np.float64]:
        """The middle, shape [3]."""
        return self._ours.get_center()

    def transform(self, arg0: ArrayLike) -> Self:
        """Move by a 4x4 matrix."""
        return self._become(self._ours.transform(arg0))

    def translate(self, translation: ArrayLike, relative: bool = True) -> Self:
        """Move by a vector; with `relative=False`, the middle there."""
        return self._become(self._ours.translate(translation, relative))

    def scale(self, scale: float, center: ArrayLike) -> Self:
        """Scale about a point."""
        return self._become(self._ours.scale(scale, center))

    def rotate(self, R: ArrayLike, center: Any = None) -> Self:
        """Turn about a point, about the middle where none is given."""
        return self._become(self._ours.rotate(R, center))
