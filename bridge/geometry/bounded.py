"""Shapes that boxes are put around."""

from __future__ import annotations

from .boxes import AxisAlignedBoundingBox, OrientedBoundingBox
from .geometry import Geometry3D


class BoundedByBoxes(Geometry3D):
    """A shape with a box around it."""

    def get_axis_aligned_bounding_box(self) -> AxisAlignedBoundingBox:
        """The box along the axes."""
        return AxisAlignedBoundingBox._of(self._ours.get_axis_aligned_bounding_box())

    def get_oriented_bounding_box(self, robust: bool = False) -> OrientedBoundingBox:
        """The box along the principal axes."""
        return OrientedBoundingBox._of(self._ours.get_oriented_bounding_box(robust))

    def get_minimal_oriented_bounding_box(self, robust: bool = False) -> OrientedBoundingBox:
        """The smallest box."""
        return OrientedBoundingBox._of(self._ours.get_minimal_oriented_bounding_box(robust))
