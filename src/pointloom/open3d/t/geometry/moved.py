"""Base class of geometries whose positions are moved in place."""

from __future__ import annotations

from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from ....pcd.cloud import PointCloud
from ....pcd.motion import map_about
from ...core.tensor import Tensor
from .boxes import AxisAlignedBoundingBox, OrientedBoundingBox
from .geometry import Geometry
from .tensor_map import TensorMap, matrix_of, wrap


class MovedGeometry(Geometry):
    """A geometry with `point.positions` and maybe `point.normals`. Motions write into their memory, as in Open3D."""

    point: TensorMap

    def get_min_bound(self) -> Tensor:
        return self.point.positions.min((0,))

    def get_max_bound(self) -> Tensor:
        return self.point.positions.max((0,))

    def get_center(self) -> Tensor:
        """Mean of the positions."""
        return self.point.positions.mean((0,))

    def get_axis_aligned_bounding_box(self) -> AxisAlignedBoundingBox:
        return AxisAlignedBoundingBox.create_from_points(self.point.positions)

    def get_oriented_bounding_box(self) -> OrientedBoundingBox:
        """The smallest box."""
        return OrientedBoundingBox.create_from_points(self.point.positions)

    def transform(self, transformation: Any) -> Self:
        """Apply a 4x4 matrix. Normals stay perpendicular to the surface and keep their lengths."""
        return self._map(matrix_of("transformation", transformation, (4, 4)))

    def rotate(self, R: Any, center: Any) -> Self:
        return self._map(map_about(matrix_of("R", R, (3, 3)), matrix_of("center", center, (3,))))

    def translate(self, translation: Any, relative: bool = True) -> Self:
        """Translate by a vector. With `relative=False`, move the center there."""
        positions = self.point.positions
        step = _like(positions, matrix_of("translation", translation, (3,)))
        positions[:] = positions + (step if relative else step - self.get_center())
        return self

    def scale(self, scale: float, center: Any) -> Self:
        positions = self.point.positions
        middle = _like(positions, matrix_of("center", center, (3,)))
        positions[:] = (positions - middle) * scale + middle
        return self

    def _map(self, T: NDArray[np.float64]) -> Self:
        """Apply a 4x4 matrix to positions and normals."""
        positions = self.point.positions
        if "normals" in self.point:
            normals = self.point.normals
            turned = PointCloud(positions._array, normals=normals._array).transform(T)
            normals[:] = wrap(turned._handed_out(turned._device_array("normals"))).to(normals.dtype)
        moved = positions.matmul(_like(positions, T[:3, :3].T)) + _like(positions, T[:3, 3])
        if not np.array_equal(T[3], (0, 0, 0, 1)):
            moved = moved / (positions.matmul(_like(positions, T[3, :3, None])) + float(T[3, 3]))
        positions[:] = moved
        return self


def _like(tensor: Tensor, values: NDArray[np.float64]) -> Tensor:
    """Values in the type of a tensor and on its device."""
    return Tensor(values, tensor.dtype, tensor.device)
