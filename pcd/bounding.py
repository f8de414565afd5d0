"""The bounds of a cloud."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..kernels.bounds import bound_points
from .point_arrays import PointArrays


class Bounding(PointArrays):
    """The part of PointCloud that bounds it."""

    def get_min_bound(self) -> NDArray[np.float64]:
        """The lowest coordinates of the finite points [m], shape [3]; zeros for an empty cloud."""
        return self._bounds()[0]

    def get_max_bound(self) -> NDArray[np.float64]:
        """The highest coordinates of the finite points [m], shape [3]; zeros for an empty cloud."""
        return self._bounds()[1]

    # ------------------------------------------------------------------------------------------ internals

    def _bounds(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        low, high, finite = bound_points(self._arrays["points"])
        if not finite:
            return np.zeros(3), np.zeros(3)
        return low.astype(np.float64) + self._origin, high.astype(np.float64) + self._origin
