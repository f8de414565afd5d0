"""The bounds of a cloud."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..kernels.arrays.bounds import bound_points
from ..kernels.extent.mean_covariance import mean_and_covariance
from .boxes import AxisAlignedBoundingBox, OrientedBoundingBox
from .convex_hull import hull_of_cloud
from .minimal_box import fit_principal_box, fit_smallest_box
from .point_arrays import PointArrays


class Bounding(PointArrays):
    """The part of PointCloud that bounds it."""

    def get_min_bound(self) -> NDArray[np.float64]:
        """The lowest coordinates of the finite points [m], shape [3]; zeros for an empty cloud."""
        return self._device_bounds()[0]

    def get_max_bound(self) -> NDArray[np.float64]:
        """The highest coordinates of the finite points [m], shape [3]; zeros for an empty cloud."""
        return self._device_bounds()[1]

    def get_center(self) -> NDArray[np.float64]:
        """The mean of the finite points [m], shape [3]; zeros where there is none."""
        count, mean, _ = mean_and_covariance(self._arrays["points"])
        return mean + self._origin if count else np.zeros(3)

    def get_axis_aligned_bounding_box(self) -> AxisAlignedBoundingBox:
        """The smallest aligned box around the finite points; at zero for an empty cloud."""
        return AxisAlignedBoundingBox(*self._device_bounds())

    def get_oriented_bounding_box(self, robust: bool = False) -> OrientedBoundingBox:
        """The box along the principal axes of the convex hull's vertices, that of the largest variance first.

        Points in a plane, on a line or all equal have boxes with extents of zero (Open3D raises errors of Qhull).

        Args:
            robust: Let Qhull joggle its input, as `compute_convex_hull(joggle_inputs=True)`.

        Returns:
            A box that holds every finite point: it is wider than they are by a few roundings of float64.

        Raises:
            ValueError: No point is finite.

        Example:
            >>> import pointloom as loom
            >>> square = loom.PointCloud([[0, 0, 7], [4, 0, 7], [0, 2, 7], [4, 2, 7]])
            >>> square.get_oriented_bounding_box().extent.round(6).tolist()
            [4.0, 2.0, 0.0]
        """
        extremes, _, positions = hull_of_cloud(self._arrays["points"], bool(robust))
        return OrientedBoundingBox(*fit_principal_box(positions, self._origin, extremes))

    def get_minimal_oriented_bounding_box(self, robust: bool = False) -> OrientedBoundingBox:
        """The box of least volume around the finite points; where they lie in a plane, that of least area.

        Kernels search the frames in which two faces of the box that meet hold an edge of the convex hull each, which
        the smallest box is among. Points in a plane, on a line or all equal have boxes with extents of zero (Open3D
        raises errors of Qhull).

        Args:
            robust: Let Qhull joggle its input, as `compute_convex_hull(joggle_inputs=True)`.

        Returns:
            A box that holds every finite point: it is wider than they are by a few roundings of float64.

        Raises:
            ValueError: No point is finite.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [3, 4, 0], [-4, 3, 0], [0, 0, 2], [3, 4, 2], [-4, 3, 2]]
            >>> round(loom.PointCloud(corners).get_minimal_oriented_bounding_box().volume(), 6)
            50.0

        Notes:
            Time grows with the square of the hull's edges: seconds on two cores for 3,000 vertices. The same from run
            to run. O'Rourke, "Finding minimal enclosing boxes", IJCIS 1985; Jylanki, "An exact algorithm for finding
            minimum oriented bounding boxes", 2015.
        """
        extremes, _, positions = hull_of_cloud(self._arrays["points"], bool(robust))
        return OrientedBoundingBox(*fit_smallest_box(positions, self._origin, extremes, self.device))

    # ------------------------------------------------------------------------------------------ internals

    def _device_bounds(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """The lowest and highest corner [m] of the finite points, [3] each; zeros where there is none."""
        low, high, finite = bound_points(self._arrays["points"])
        if not finite:
            return np.zeros(3), np.zeros(3)
        return low.astype(np.float64) + self._origin, high.astype(np.float64) + self._origin
