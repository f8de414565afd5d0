"""Base classes of Open3D's geometries."""

from __future__ import annotations

import enum
from typing import Any, ClassVar, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import RIGID_TOLERANCE, check_number, is_plainly_rigid
from ...kernels.linear_algebra import matmul
from ...pcd.motion import map_about
from ..wrapper import Wrapper, column
from . import rotations


class GeometryType(enum.IntEnum):
    """Return values of `get_geometry_type`."""

    Unspecified, PointCloud, VoxelGrid, LineSet, TriangleMesh, Image, RGBDImage, TetraMesh = 0, 1, 2, 4, 6, 8, 9, 10


class Geometry(Wrapper):
    Type = GeometryType
    Unspecified, PointCloud, VoxelGrid, LineSet, TriangleMesh, Image, RGBDImage, TetraMesh = Type
    _dimension: ClassVar[int] = 3

    def dimension(self) -> int:
        """2 for images, else 3."""
        return self._dimension

    def get_geometry_type(self) -> GeometryType:
        return GeometryType.__members__.get(type(self).__name__, GeometryType.Unspecified)


for kind in GeometryType:
    setattr(Geometry, kind.name, kind)  # Geometry.PointCloud is a type, too


class Geometry2D(Geometry):
    _dimension = 2


class Geometry3D(Geometry):
    """Base class of 3D geometries, transformed in place. Methods return the geometry itself."""

    _arrays: ClassVar[dict[str, str]] = {}  # mapped vectors: "points", "normals" or "covariances"

    get_rotation_matrix_from_xyz = staticmethod(rotations.get_rotation_matrix_from_xyz)
    get_rotation_matrix_from_yzx = staticmethod(rotations.get_rotation_matrix_from_yzx)
    get_rotation_matrix_from_zxy = staticmethod(rotations.get_rotation_matrix_from_zxy)
    get_rotation_matrix_from_xzy = staticmethod(rotations.get_rotation_matrix_from_xzy)
    get_rotation_matrix_from_zyx = staticmethod(rotations.get_rotation_matrix_from_zyx)
    get_rotation_matrix_from_yxz = staticmethod(rotations.get_rotation_matrix_from_yxz)
    get_rotation_matrix_from_axis_angle = staticmethod(rotations.get_rotation_matrix_from_axis_angle)
    get_rotation_matrix_from_quaternion = staticmethod(rotations.get_rotation_matrix_from_quaternion)

    def clear(self) -> Self:
        return self._become(self.native.clear())

    def is_empty(self) -> bool:
        return bool(self.native.is_empty())

    def get_min_bound(self) -> NDArray[np.float64]:
        return self.native.get_min_bound()

    def get_max_bound(self) -> NDArray[np.float64]:
        return self.native.get_max_bound()

    def get_center(self) -> NDArray[np.float64]:
        return self.native.get_center()

    def transform(self, arg0: ArrayLike) -> Self:
        """Apply a 4x4 matrix; projective or singular ones transform the points in float64."""
        T = np.asarray(arg0)
        if T.shape == (4, 4) and np.isfinite(T).all() and not is_affine(T):
            return self._map_arrays(T.astype(np.float64))
        return self._moved(self.native.transform(arg0), T[:3, :3])

    def translate(self, translation: ArrayLike, relative: bool = True) -> Self:
        """Translate by a vector. With `relative=False`, move the center there."""
        return self._become(self.native.translate(column("translation", translation), relative))

    def scale(self, scale: float, center: ArrayLike) -> Self:
        """Scale about a point. Zero and negative factors affect the points only."""
        factor, middle = check_number("scale", scale), column("center", center)
        if factor > 0 or not self._arrays:
            return self._become(self.native.scale(scale, middle))
        return self._map_arrays(map_about(factor * np.eye(3), middle), directions=False)

    def rotate(self, R: ArrayLike, center: ArrayLike | None = None) -> Self:
        """Rotate about a point, by default the center. Other matrices than rotations are applied, too."""
        A, middle = np.asarray(R), self.get_center() if center is None else column("center", center)
        if self._arrays and A.shape == (3, 3) and not is_rotation(A):
            return self.transform(map_about(A, middle))
        return self._moved(self.native.rotate(R, middle), A)

    def _moved(self, new: Any, A: NDArray[np.float64]) -> Self:
        """Replace the object by its image under a map with the 3x3 part A."""
        return self._become(new)

    def _map_arrays(self, T: NDArray[np.float64], *, directions: bool = True) -> Self:
        """Apply a 4x4 matrix to the vectors of points, and its 3x3 part to those of normals."""
        A = T[:3, :3]
        for name, kind in self._arrays.items():
            values = np.array(getattr(self, name))
            if kind == "points":
                with np.errstate(divide="ignore", invalid="ignore"):
                    values = (matmul(values, A.T) + T[:3, 3]) / (matmul(values, T[3, :3]) + T[3, 3])[:, None]
            elif not directions:
                continue
            else:
                values = matmul(values, A.T) if kind == "normals" else matmul(A, values, A.T)
            self.assign(name, type(getattr(self, name))(values))
        return self


def is_affine(T: NDArray[Any]) -> bool:
    """True for an invertible affine map."""
    return np.array_equal(T[3], (0, 0, 0, 1)) and np.linalg.matrix_rank(T[:3, :3]) == 3


def is_rotation(A: NDArray[Any]) -> bool:
    """True for a rotation matrix within pointloom's tolerance."""
    T = np.eye(4)
    T[:3, :3] = A
    return is_plainly_rigid(T.tolist(), RIGID_TOLERANCE)
