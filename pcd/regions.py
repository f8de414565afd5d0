"""Smooth regions of a cloud."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from ..core.checks import check_count, check_positive, shown
from ..core.told_arguments import told_arguments
from ..core.watching import report
from ..kernels.features.eigen_features import measure_curvature
from ..kernels.segmentation.region_growth import grow_regions
from .clusters import ANY, MAX_SIZE
from .shapes import NORMALS, Shapes


class Regions(Shapes):
    """The part of PointCloud that grows smooth regions."""

    @told_arguments
    def region_growing(
        self,
        smoothness_threshold_deg: float = 3.0,
        curvature_threshold: float = 0.05,
        min_cluster_size: int = 50,
        max_cluster_size: int | None = None,
        *,
        max_nn: int = 30,
    ) -> NDArray[np.int32]:
        """Find smooth regions by normals and curvature, PCL's RegionGrowing; the cloud needs normals.

        A region grows from a point of small curvature to its neighbours whose normals are within an angle of the
        point's own, and on from those of small curvature.

        Args:
            smoothness_threshold_deg: Largest angle [degrees] between the normals of two neighbours, whichever way they
                face; PCL's default is 30.
            curvature_threshold: Surface variation (0 .. 1/3, as `estimate_curvature`) below which a region grows on
                from a point.
            min_cluster_size: Points of a region at least.
            max_cluster_size: Points of a region at most; None for any number. Larger ones are left out, not split.
            max_nn: Neighbours that a region grows to from each point, the point itself included; curvature is that of
                the same neighbours.

        Returns:
            Labels, int32 [n], from 0 for the largest region, those of one size by their first points; -1 for none.

        Raises:
            ValueError: The cloud has no normals, or an argument is out of range.

        Notes:
            Equal to PCL's regions but for what depends there on the order of its seeds: a point of larger curvature
            that two regions reach is PCL's first region's, and here the region's whose nearest point agrees with its
            normal best; two points of small curvature are joined where either is among the other's nearest, in PCL only
            where the one that is reached first lists the other; and a region of PCL's whose seed is of large curvature
            is none here. 4 B of memory a neighbour and 40 B a point; the same bits from run to run. Rabbani, van den
            Heuvel and Vosselman 2006.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> x, y = np.random.default_rng(0).random((2, 4000))
            >>> floor, wall = np.column_stack([x, y, 0 * x]), np.column_stack([0 * x, x, y + 0.05])[:2000]
            >>> cloud = loom.PointCloud(np.vstack([floor, wall])).estimate_normals(max_nn=15)
            >>> labels = cloud.region_growing(5.0, 0.01, max_nn=15)
            >>> labels.max() + 1, bool((labels[:4000] == 0).mean() > 0.95)
            (np.int32(2), True)
        """
        angle = check_positive("smoothness_threshold_deg", smoothness_threshold_deg)
        if angle > 90:
            said = shown(smoothness_threshold_deg)
            raise ValueError(f"smoothness_threshold_deg: expected degrees in 0..90, 0 excluded, got {said}")
        limit = check_positive("curvature_threshold", curvature_threshold)
        least = check_count("min_cluster_size", min_cluster_size, **ANY)
        most = MAX_SIZE
        if max_cluster_size is not None:
            most = check_count("max_cluster_size", max_cluster_size, **ANY)
            if most < least:
                raise ValueError(f"max_cluster_size: expected at least min_cluster_size = {least}, got {most}")
        count = check_count("max_nn", max_nn, minimum=2)
        normals = self._required_array("normals", NORMALS)
        nearest = self._neighbor_graph(min(count, max(len(self), 1)), math.inf)
        curvature = measure_curvature(self.search_tree(), math.inf, count)
        cosine = math.cos(math.radians(angle))
        labels, _ = grow_regions(normals, curvature, nearest, cosine, limit, min(least, MAX_SIZE), min(most, MAX_SIZE))
        report("clusters", cloud=self, labels=labels)
        return self._handed_out(labels)
