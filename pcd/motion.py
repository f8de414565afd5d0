"""Moving a cloud."""

from __future__ import annotations

from typing import Self

import numpy as np
from numpy.typing import ArrayLike

from ..kernels.algebra.transform import transform_covariances, transform_directions, transform_points
from ..kernels.lang import float32
from .bounding import Bounding
from .checks import check_transformation
from .coordinates import FLOAT32_MAX, split_origin


class Motion(Bounding):
    """The part of PointCloud that moves it."""

    def transform(self, transformation: ArrayLike) -> Self:
        """The cloud under a 4x4 affine map, computed in float64; normals are turned, and keep their lengths.

        Covariances C become A C A^T, with A the map's 3x3 part (Open3D's are right for rotations alone).

        Raises:
            ValueError: Not finite, not invertible, or the last row is not (0, 0, 0, 1).
        """
        T = check_transformation("transformation", transformation)
        A, t = T[:3, :3], T[:3, 3]
        low, high = self._bounds()
        middle, half = A @ ((low + high) / 2) + t, np.abs(A) @ ((high - low) / 2)
        corners = np.stack([middle - half, middle + half])
        _, origin = split_origin(corners)
        carried = np.round(A @ self._origin + t)  # near most of the points still, whatever a stray one does to the box
        if origin.any() and np.abs(corners - carried).max() < FLOAT32_MAX:
            origin = carried
        arrays = dict(self._arrays)
        arrays["points"] = transform_points(arrays["points"], A, A @ self._origin + t - origin)
        if self.has_normals:
            arrays["normals"] = transform_directions(arrays["normals"], np.linalg.inv(A).T)
        if (
            "covariances" in arrays
            and arrays["covariances"].dtype == float32
            and arrays["covariances"].shape[1:] == (9,)
        ):
            arrays["covariances"] = transform_covariances(arrays["covariances"], A)
        cloud = self._with(arrays, grid=self.grid)
        cloud._origin = origin
        return cloud
