"""Normals of a cloud: fitted to neighbours, turned to a side."""

from __future__ import annotations

from typing import Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..kernels.normals import align_normals, estimate_normals, orient_normals
from ..kernels.point_tree import PointTree
from .checks import check_count, check_finite, check_positive, check_shape
from .point_arrays import PointArrays


class Normals(PointArrays):
    """The part of PointCloud that deals with normals."""

    def estimate_normals(self, *, radius: float | None = None, max_nn: int | None = 30) -> Self:
        """Fit a plane to the neighbours of each point.

        Args:
            radius: Search radius [m], the boundary excluded; with `max_nn` the nearest `max_nn` within it. None
                searches by count alone.
            max_nn: Neighbours a fit, the point itself included; None takes all within the radius.

        Returns:
            The cloud with unit normals, shape [n, 3]; (0, 0, 1) where fewer than 3 neighbours are found, NaN for
            points that are not finite. The sign follows earlier normals where there were any.

        Raises:
            ValueError: Neither limit given, or one out of range.

        Notes:
            O(n) memory. Same bits from run to run. Hoppe et al. 1992, section 3.1. Covariances are centred, so
            coordinates of any size do no harm (Open3D's legacy form turns 57 % of normals at UTM coordinates), and
            one NaN spoils no other point's normal.
        """
        if radius is None and max_nn is None:
            raise ValueError("radius, max_nn: give at least one of them")
        reach = np.inf if radius is None else check_positive("radius", radius)
        count = None if max_nn is None else check_count("max_nn", max_nn, minimum=1)
        points = self._arrays["points"]
        normals = estimate_normals(PointTree(points), points, count, reach)
        if self.has_normals:
            align_normals(normals, self._arrays["normals"])
        return self._with(self._arrays | {"normals": normals}, grid=self.grid)

    def orient_normals_to_align_with_direction(self, orientation_reference: ArrayLike = (0.0, 0.0, 1.0)) -> Self:
        """The cloud with each normal on the side of a direction; a zero normal becomes the direction.

        Raises:
            ValueError: The cloud has no normals, or a direction of another shape or not finite.
        """
        shaped = check_shape("orientation_reference", orientation_reference, (3,))
        reference = check_finite("orientation_reference", shaped)
        return self._orient(reference, to_point=False)

    def orient_normals_towards_camera_location(self, camera_location: ArrayLike = (0.0, 0.0, 0.0)) -> Self:
        """The cloud with each normal on the side of a camera [m].

        Raises:
            ValueError: The cloud has no normals, or a place of another shape or not finite.
        """
        location = check_finite("camera_location", check_shape("camera_location", camera_location, (3,)))
        return self._orient(location - self._origin, to_point=True)

    # ------------------------------------------------------------------------------------------ internals

    def _orient(self, reference: NDArray[np.float64], *, to_point: bool) -> Self:
        normals = self._require("normals", "call estimate_normals() first")
        oriented = orient_normals(self._arrays["points"], normals, reference, to_point)
        return self._with(self._arrays | {"normals": oriented}, grid=self.grid)
