"""Shapes that boxes are put around."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .boxes import AxisAlignedBoundingBox, OrientedBoundingBox
from .geometry import Geometry3D


class BoundedByBoxes(Geometry3D):
    """A shape with a box around it."""

    def get_axis_aligned_bounding_box(self) -> AxisAlignedBoundingBox:
        """The box along the axes.

        It contains the digits that were assigned and ours, which are rounded to float32: indices of points within it,
        and voxels that begin at it, contain all points.
        """
        box = self._ours.get_axis_aligned_bounding_box()
        assigned = self._out.get(next(iter(self._arrays)))
        if assigned is not None:
            box = box + type(box).create_from_points(assigned.vector._values)
        return AxisAlignedBoundingBox._of(box)

    def get_min_bound(self) -> NDArray[np.float64]:
        """The lowest coordinates, shape [3]."""
        return np.array(self.get_axis_aligned_bounding_box().min_bound)

    def get_max_bound(self) -> NDArray[np.float64]:
        """The highest coordinates, shape [3]."""
        return np.array(self.get_axis_aligned_bounding_box().max_bound)

    def get_oriented_bounding_box(self, robust: bool = False) -> OrientedBoundingBox:
        """The box along the principal axes."""
        return OrientedBoundingBox._of(self._ours.get_oriented_bounding_box(robust))

    def get_minimal_oriented_bounding_box(self, robust: bool = False) -> OrientedBoundingBox:
        """The smallest box."""
        return OrientedBoundingBox._of(self._ours.get_minimal_oriented_bounding_box(robust))
