"""Groups of points that lie close together."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..core.checks import check_count, check_positive
from ..core.told_arguments import told_arguments
from ..core.verbosity import told_time
from ..core.watching import report
from ..kernels.segmentation.cluster_labels import rank_by_size
from ..kernels.segmentation.dbscan import cluster_points
from .length_doubts import check_order, warn_of_long, warn_of_short
from .selection import Selection

MAX_SIZE = 2**31 - 2  # more points than a cloud holds
# For thresholds: what no cloud reaches is no error.
ANY: dict[str, Any] = {"maximum": 2**63 - 1, "because": "counts have 64 bits"}


class Clusters(Selection):
    """The part of PointCloud that finds clusters."""

    @told_arguments
    def cluster_dbscan(self, eps: float, min_points: int, print_progress: bool = False) -> NDArray[np.int32]:
        """Find clusters by density: cores closer than `eps` to each other, and the points around them.

        A point is a core where at least `min_points` points, itself included, are closer than `eps`. Clusters are
        numbered by their first core in the order of the cloud. A point that is no core takes the lowest label of the
        cores closer than `eps`. The labels are those of Open3D's legacy form.

        Args:
            eps: Distance of neighbours [m], excluded.
            min_points: Neighbours that make a core.
            print_progress: Say on stderr that it begins, and how long it took.

        Returns:
            Labels, int32 [n], from 0; -1 for noise and for points that are not finite.

        Raises:
            ValueError: `eps` or `min_points` not positive, or points that `NearestNeighborSearch` refuses for what they
                span.
            TypeError: `eps` is no number, or `min_points` no whole one.

        Notes:
            O(n) memory whatever `eps` is: 14 B a point beside the search tree (22 on CUDA), no list of neighbours.
            Same bits from run to run, whatever the number of threads. Ester et al. 1996; Prokopenko et al. 2023.

        Example:
            >>> import pointloom as loom
            >>> cloud = loom.PointCloud([[0, 0, 0], [0.1, 0, 0], [5, 0, 0], [5.1, 0, 0], [9, 0, 0]])
            >>> cloud.cluster_dbscan(eps=0.2, min_points=2).tolist()
            [0, 0, 1, 1, -1]
        """
        check_order("min_points", min_points, "eps", eps)
        reach, least = check_positive("eps", eps), check_count("min_points", min_points, **ANY)
        with told_time(f"clusters of {len(self):,} points", print_progress):
            labels, found = self._cluster(reach, least)
        tree, unit = self.search_tree(), self.unit
        if not found and least > 1:
            warn_of_short("eps", tree, reach, unit, "all points are noise")
        elif found == 1:
            warn_of_long("eps", reach, tree.low, tree.high, tree.count, unit, "all of them are one cluster")
        report("clusters", cloud=self, labels=labels)
        return self._handed_out(labels)

    def cluster_euclidean(
        self, tolerance: float, min_cluster_size: int = 1, max_cluster_size: int | None = None
    ) -> NDArray[np.int32]:
        """Find the groups of points that hang together by steps shorter than `tolerance`.

        Clusters are numbered by size, the largest first as in PCL's EuclideanClusterExtraction; those of one size in
        the order of their first points.

        Args:
            tolerance: Length of a step [m], excluded.
            min_cluster_size: Points that a cluster has at least.
            max_cluster_size: Points that a cluster has at most; None for any number. Larger ones are left out, not
                split.

        Returns:
            Labels, int32 [n], from 0; -1 for points of clusters of other sizes and for points that are not finite.

        Raises:
            ValueError: `tolerance` or a size not positive, no size between the two, or points that
                `NearestNeighborSearch` refuses for what they span.
            TypeError: `tolerance` is no number, or a size no whole one.

        Notes:
            O(n) memory, as `cluster_dbscan` with `min_points=1`. Same bits from run to run. Rusu 2009, section 6.2.

        Example:
            >>> import pointloom as loom
            >>> cloud = loom.PointCloud([[9, 0, 0], [0, 0, 0], [0.1, 0, 0], [0.2, 0, 0]])
            >>> cloud.cluster_euclidean(0.15).tolist()
            [1, 0, 0, 0]
            >>> cloud.cluster_euclidean(0.15, min_cluster_size=2).tolist()
            [-1, 0, 0, 0]
        """
        step = check_positive("tolerance", tolerance)
        least = check_count("min_cluster_size", min_cluster_size, **ANY)
        most = MAX_SIZE
        if max_cluster_size is not None:
            most = check_count("max_cluster_size", max_cluster_size, **ANY)
            if most < least:
                raise ValueError(f"max_cluster_size: expected at least min_cluster_size = {least}, got {most}")
        labels, cluster_count = self._cluster(step, 1)
        if cluster_count:
            rank_by_size(labels, cluster_count, min(least, MAX_SIZE), min(most, MAX_SIZE))
        report("clusters", cloud=self, labels=labels)
        return self._handed_out(labels)

    # ------------------------------------------------------------------------------------------ internals

    def _cluster(self, eps: float, min_points: int) -> tuple[Any, int]:
        return cluster_points(self.search_tree(), len(self), eps, min_points)
