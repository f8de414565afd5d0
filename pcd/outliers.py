"""Points that stand apart from the rest."""

from __future__ import annotations

from typing import Self

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ..core.checks import check_count, check_positive
from ..core.dropped_results import returns_new
from ..core.verbosity import told_time
from ..kernels.arrays.select import positions_of
from ..kernels.search.neighbor_distances import average_distances, mask_up_to, mean_and_deviation
from ..kernels.segmentation.neighbor_counts import mask_crowded
from .length_doubts import check_order, warn_of_short
from .selection import Selection

ROUNDING = 1 + 1e-12  # where all distances are equal, their mean may round to less


class Outliers(Selection):
    """The part of PointCloud that removes outliers."""

    @returns_new
    def remove_statistical_outlier(
        self, nb_neighbors: int, std_ratio: float, print_progress: bool = False
    ) -> tuple[Self, NDArray[np.int32]]:
        """Remove the points whose neighbours are farther away than is usual in the cloud.

        A point's distance is the mean over its `nb_neighbors` nearest points, itself among them at distance 0, as in
        Open3D. A point stays where that is at most mean + std_ratio * deviation over the cloud.

        Args:
            nb_neighbors: Neighbours that a mean is taken over, the point itself included.
            std_ratio: How many standard deviations above the mean a distance may lie.
            print_progress: Say on stderr that it begins, and how long it took.

        Returns:
            The points that stay, and their indices in this cloud, int32 [m], ascending. Points that are not finite do
            not stay.

        Raises:
            ValueError: A count or ratio that is not positive.

        Notes:
            Points with all their neighbours at their own place stay: Open3D's legacy form removes them (25 of 25
            duplicates), its tensor form does not. O(n) memory, the same bits from run to run. Rusu et al., "Towards
            3D point cloud based object maps for household environments", RAS 56, 2008, section 4.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> points = np.append(np.random.default_rng(0).random((1000, 3)), [[5.0, 5, 5]], axis=0)
            >>> inliers, indices = loom.PointCloud(points).remove_statistical_outlier(20, 3.0)
            >>> 1000 in indices
            False
        """
        check_order("nb_neighbors", nb_neighbors, "std_ratio", std_ratio)
        k = check_count("nb_neighbors", nb_neighbors)
        ratio = check_positive("std_ratio", std_ratio)
        with told_time(f"statistical outliers of {len(self):,} points", print_progress):
            distances = average_distances(self.search_tree(), k)
            count, mean, deviation = mean_and_deviation(distances)
            limit = (mean + ratio * deviation) * ROUNDING if count else 0.0
            return self._keep(mask_up_to(distances, limit))

    @returns_new
    def remove_radius_outlier(
        self, nb_points: int, radius: float, print_progress: bool = False
    ) -> tuple[Self, NDArray[np.int32]]:
        """Remove the points with few neighbours.

        Args:
            nb_points: A point stays where it has at least so many others within the radius (Open3D's legacy rule: more
                than `nb_points` with itself; its tensor form asks for one less).
            radius: Radius [m], the boundary excluded.
            print_progress: Say on stderr that it begins, and how long it took.

        Returns:
            The points that stay, and their indices in this cloud, int32 [m], ascending. Points that are not finite do
            not stay.

        Raises:
            ValueError: A count or radius that is not positive.

        Notes:
            O(n) memory, the same bits from run to run. Counting ends where there are enough, so a large radius costs
            no more than a small one.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> points = np.append(np.random.default_rng(0).random((1000, 3)), [[5.0, 5, 5]], axis=0)
            >>> inliers, indices = loom.PointCloud(points).remove_radius_outlier(nb_points=2, radius=0.3)
            >>> len(inliers), 1000 in indices
            (1000, False)
        """
        check_order("nb_points", nb_points, "radius", radius)
        needed = check_count("nb_points", nb_points) + 1
        reach = check_positive("radius", radius)
        with told_time(f"radius outliers of {len(self):,} points", print_progress):
            kept = self._keep(mask_crowded(self.search_tree(), reach, needed))
        if not len(kept[0]):
            warn_of_short("radius", self.search_tree(), reach, self.unit, "no point is left")
        return kept

    def _keep(self, mask: wp.array) -> tuple[Self, NDArray[np.int32]]:
        rows = positions_of(mask)
        return self._select_rows(rows), self._handed_out(rows)
