"""Base class of geometries with bounding boxes."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .boxes import AxisAlignedBoundingBox, OrientedBoundingBox, oriented_box
from .geometry import Geometry3D


class BoundedByBoxes(Geometry3D):
    _internal = ("assigned_points",)

    def assigned_points(self) -> NDArray[np.float64] | None:
        """The memory of the points if they were assigned or handed out, with their float64 coordinates."""
        shared = self._shared.get(next(iter(self._arrays)))
        return None if shared is None else np.asarray(shared.vector)

    def get_axis_aligned_bounding_box(self) -> AxisAlignedBoundingBox:
        """Axis-aligned bounding box.

        It contains both the assigned float64 coordinates and the float32 ones, so that point indices within it and
        voxels starting at it include all points.
        """
        box = self.native.get_axis_aligned_bounding_box()
        assigned = self.assigned_points()
        if assigned is not None:
            box = box + type(box).create_from_points(assigned)
        return AxisAlignedBoundingBox.from_native(box)

    def get_min_bound(self) -> NDArray[np.float64]:
        return np.array(self.get_axis_aligned_bounding_box().min_bound)

    def get_max_bound(self) -> NDArray[np.float64]:
        return np.array(self.get_axis_aligned_bounding_box().max_bound)

    def get_oriented_bounding_box(self, robust: bool = False) -> OrientedBoundingBox:
        """Box along the principal axes."""
        return oriented_box(self.native.get_oriented_bounding_box(robust))

    def get_minimal_oriented_bounding_box(self, robust: bool = False) -> OrientedBoundingBox:
        return oriented_box(self.native.get_minimal_oriented_bounding_box(robust))
