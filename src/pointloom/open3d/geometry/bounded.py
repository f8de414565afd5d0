"""Base class of geometries with bounding boxes."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .boxes import AxisAlignedBoundingBox, OrientedBoundingBox
from .ellipsoids import OrientedBoundingEllipsoid, fit_ellipsoid
from .geometry import Geometry3D


class BoundedByBoxes(Geometry3D):
    def get_axis_aligned_bounding_box(self) -> AxisAlignedBoundingBox:
        """Axis-aligned bounding box.

        It contains both the assigned float64 coordinates and the float32 ones, so that point indices within it and
        voxels starting at it include all points.
        """
        box = self._native.get_axis_aligned_bounding_box()
        assigned = self._shared.get(next(iter(self._arrays)))
        if assigned is not None:
            box = box + type(box).create_from_points(assigned.vector._values)
        return AxisAlignedBoundingBox._of(box)

    def get_min_bound(self) -> NDArray[np.float64]:
        return np.array(self.get_axis_aligned_bounding_box().min_bound)

    def get_max_bound(self) -> NDArray[np.float64]:
        return np.array(self.get_axis_aligned_bounding_box().max_bound)

    def get_oriented_bounding_box(self, robust: bool = False) -> OrientedBoundingBox:
        """Box along the principal axes."""
        return OrientedBoundingBox._of(self._native.get_oriented_bounding_box(robust))

    def get_minimal_oriented_bounding_box(self, robust: bool = False) -> OrientedBoundingBox:
        return OrientedBoundingBox._of(self._native.get_minimal_oriented_bounding_box(robust))

    def get_oriented_bounding_ellipsoid(self, robust: bool = False) -> OrientedBoundingEllipsoid:
        """Ellipsoid of smallest volume around the points."""
        name = next(iter(self._arrays))
        assigned = self._shared.get(name)
        points = self._read(name) if assigned is None else assigned.vector._values
        return OrientedBoundingEllipsoid(*fit_ellipsoid(points, robust))
