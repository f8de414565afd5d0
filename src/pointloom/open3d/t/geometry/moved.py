"""Base class of geometries whose positions are moved in place."""

from __future__ import annotations

from typing import Self

import numpy as np
from numpy.typing import NDArray

from ....kernels.linear_algebra import matmul
from ....pcd.cloud import PointCloud
from ....pcd.motion import map_about
from ...argument_types import TensorLike
from ...core.tensor import Tensor
from .boxes import AxisAlignedBoundingBox, OrientedBoundingBox
from .geometry import Geometry
from .native import native_of, positions_of, write
from .tensor_map import TensorMap, matrix_of


class MovedGeometry(Geometry):
    """A geometry with `point.positions` and maybe `point.normals`. Motions write into their memory, as in Open3D."""

    point: TensorMap

    def get_min_bound(self) -> Tensor:
        return self._measured("min", "get_min_bound")

    def get_max_bound(self) -> Tensor:
        return self._measured("max", "get_max_bound")

    def get_center(self) -> Tensor:
        """Mean of the positions."""
        return self._measured("mean", "get_center")

    def _measured(self, reduction: str, method: str) -> Tensor:
        """A reduction of the positions: in their type on the CPU, by a method of a cloud on a GPU."""
        positions = self.point.positions
        if self.is_cpu:
            return getattr(positions, reduction)((0,))
        return _like(positions, getattr(PointCloud(positions.array), method)())

    def get_axis_aligned_bounding_box(self) -> AxisAlignedBoundingBox:
        return AxisAlignedBoundingBox.create_from_points(self.point.positions)

    def get_oriented_bounding_box(self) -> OrientedBoundingBox:
        """The smallest box."""
        return OrientedBoundingBox.create_from_points(self.point.positions)

    def transform(self, transformation: TensorLike) -> Self:
        """Apply a 4x4 matrix. Normals stay perpendicular to the surface and keep their lengths."""
        return self._map(matrix_of("transformation", transformation, (4, 4)))

    def rotate(self, R: TensorLike, center: TensorLike) -> Self:
        return self._map(map_about(matrix_of("R", R, (3, 3)), matrix_of("center", center, (3,))))

    def translate(self, translation: TensorLike, relative: bool = True) -> Self:
        """Translate by a vector. With `relative=False`, move the center there."""
        step = matrix_of("translation", translation, (3,))
        return self._move(map_about(np.eye(3), np.zeros(3), step if relative else step - self.get_center().numpy()))

    def scale(self, scale: float, center: TensorLike) -> Self:
        """Scale the positions about a point."""
        return self._move(map_about(scale * np.eye(3), matrix_of("center", center, (3,))))

    def _map(self, T: NDArray[np.float64]) -> Self:
        """Apply a 4x4 matrix to positions and normals."""
        if "normals" in self.point:
            turned = native_of(self.point, "normals").transform(T)
            write(self.point.normals, turned.arrays.hand_out(turned.arrays["normals"]))
        return self._move(T)

    def _move(self, T: NDArray[np.float64]) -> Self:
        """Apply a 4x4 matrix to positions, computed in float64."""
        positions = self.point.positions
        if not self.is_cpu:
            write(positions, positions_of(PointCloud(positions.array).transform(T), positions.dtype).array)
            return self
        points = positions.numpy()
        with np.errstate(divide="ignore", invalid="ignore"):
            moved = matmul(points, T[:3, :3].T) + T[:3, 3]
            if not np.array_equal(T[3], (0, 0, 0, 1)):
                moved /= matmul(points, T[3, :3, None]) + T[3, 3]
            points[...] = moved
        return self


def _like(tensor: Tensor, values: NDArray[np.float64]) -> Tensor:
    """Values in the type of a tensor and on its device."""
    return Tensor(values, tensor.dtype, tensor.device)
