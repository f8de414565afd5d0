"""Distances between clouds and within one."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ..core.devices import check_same_device
from ..core.units import common_unit
from ..kernels.extent.mean_covariance import mahalanobis_distances, mean_and_covariance
from ..kernels.linear_algebra import pinvh
from ..kernels.search.neighbor_distances import nearest_distances
from .point_arrays import PointArrays, check_cloud
from .selection import Selection

if TYPE_CHECKING:
    from .cloud import PointCloud

FLAT = 1e-12  # a variance below this share of the largest is rounding of float32 coordinates, not spread


class Distances(Selection):
    """The part of PointCloud that measures distances."""

    def compute_point_cloud_distance(self, target: PointCloud) -> NDArray[np.float64]:
        """The distance of each point to the nearest point of another cloud.

        Args:
            target: The other cloud, on the same device.

        Returns:
            Distances [m], float64 [n]; infinite where the target has no finite point (Open3D: 0, which reads as a
            perfect match) or all lie farther than 1.8e19 m, 0 below 1e-19 m, NaN for points that are not finite.

        Raises:
            TypeError: The target is no cloud.
            ValueError: Points that `NearestNeighborSearch` refuses for what they span.
            DeviceError: The clouds are on different devices.

        Notes:
            O(n + m) memory, the same bits from run to run.

        Example:
            >>> import pointloom as loom
            >>> loom.PointCloud([[0, 0, 0], [0, 0, 3]]).compute_point_cloud_distance(loom.PointCloud([[0, 4, 0]]))
            array([4., 5.])
        """
        check_cloud("target", target)
        return self._handed_out(measure_to(self, target))

    def compute_nearest_neighbor_distance(self) -> NDArray[np.float64]:
        """The distance of each point to the nearest other point of the cloud.

        Returns:
            Distances [m], float64 [n]; 0 where another point lies at the same place, and, as Open3D has it, where
            there is no other point. NaN for points that are not finite.

        Raises:
            ValueError: Points that `NearestNeighborSearch` refuses for what they span.

        Notes:
            O(n) memory, the same bits from run to run.
        """
        points = self._arrays["points"]
        return self._handed_out(nearest_distances(self.search_tree(), points, others=True, missing=0.0))

    def compute_mean_and_covariance(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """The mean [m], shape [3], and the covariance [m^2], shape [3, 3], of the finite points.

        The covariance is divided by their number, as Open3D's is, and taken about the mean, so that coordinates of any
        size do no harm. NaN where no point is finite.
        """
        _, mean, covariance = mean_and_covariance(self._arrays["points"])
        return mean + self._origin, covariance

    def compute_mahalanobis_distance(self) -> NDArray[np.float64]:
        """How far each point lies from the mean, in standard deviations of the cloud in that direction.

        Returns:
            float64 [n]; NaN for points that are not finite. Directions in which the cloud has no extent do not count,
            so a flat cloud has distances within its plane (Open3D gives NaN for all of it).
        """
        points = self._arrays["points"]
        count, mean, covariance = mean_and_covariance(points)
        inverse = pinvh(covariance, FLAT) if count else np.zeros((3, 3))
        return self._handed_out(mahalanobis_distances(points, np.nan_to_num(mean), inverse))


def measure_to(source: PointArrays, target: PointArrays) -> wp.array:
    """The distance of each point of a cloud to the nearest of another, a float64 device array."""
    check_same_device("queries", source.device, target.device)
    common_unit("source, target", (source.unit, target.unit))
    return nearest_distances(target.search_tree(), source._points_about(target.origin))
