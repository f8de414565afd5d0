"""Flat patches of a cloud."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ..core.checks import check_count, check_positive
from ..kernels.extent.masks import usable_rows
from ..kernels.lang import int32
from ..kernels.memory import full
from ..kernels.search.tree_search import search_nearest
from ..kernels.segmentation.octree_cells import Octree
from ..kernels.segmentation.patch_growth import Patches
from ..kernels.segmentation.planar_patches import ROUNDING, Limits, find_seeds
from .boxes import OrientedBoundingBox
from .selection import Selection

EDGE_SHARE = 0.01  # of the cloud's longest edge: Open3D's shortest patch
POINT_SHARE = 0.001  # of the points: Open3D's smallest seed
FEWEST = 10


class PlanarPatches(Selection):
    """The part of PointCloud that finds flat patches."""

    def detect_planar_patches(
        self,
        normal_variance_threshold_deg: float = 60.0,
        coplanarity_deg: float = 75.0,
        outlier_ratio: float = 0.75,
        min_plane_edge_length: float = 0.0,
        min_num_points: int = 0,
        *,
        radius: float | None = None,
        max_nn: int = 30,
    ) -> list[OrientedBoundingBox]:
        """Find the flat parts of a cloud by robust statistics; the cloud needs normals.

        Args:
            normal_variance_threshold_deg: How far [degrees] normals may spread about a plane's; smaller finds fewer.
            coplanarity_deg: How thin a plane must be, as the angle [degrees] between its normal and the diagonal of
                its cross section; larger finds fewer.
            outlier_ratio: Largest share of outliers among the points of a seed.
            min_plane_edge_length: Shortest patch [m], by its longest edge; 0 for 1 % of the cloud's longest edge.
            min_num_points: Points of a seed at least; 0 for a thousandth of the points, and 10 at least.
            radius: Neighbours closer than this [m]; None for no limit.
            max_nn: Neighbours that a patch grows to from each of its points, the point itself included.

        Returns:
            A box for each patch, that of the most points first: the columns of R are its two sides and its normal,
            the last number of `extent` its thickness. It holds all points of the patch, up to rounding.

        Raises:
            ValueError: The cloud has no normals, or an argument is out of range.

        Notes:
            Araujo and Oliveira, Pattern Recognition 100, 2020. Where it differs from Open3D: normals need no common
            side. Planes lie at the median of the heights along their normal; Open3D's, at the medians of the
            coordinates, miss slanted walls. A patch merges into a larger one that it fits, so what lies along an edge
            ties no two walls together, as it does in Open3D; nor does a step or a bend of a floor tie its parts, which
            are patches of their own. Points in an exact plane are one (Open3D finds none
            without noise). Patches grow side by side, not one after the other. The box has the least area to a tenth
            of a degree (Open3D's search stops at 5 degrees) and holds all points along its normal, too. Points whose
            position or normal is not finite belong to no patch. 4 B of memory a neighbour and about 120 B a point; the
            same bits from run to run.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> table = np.random.default_rng(0).random((9000, 3)) * [2, 1, 0.004]
            >>> wall = np.random.default_rng(1).random((9000, 3)) * [2, 0.004, 1] + [0, 2, 1]
            >>> cloud = loom.PointCloud(np.vstack([table, wall])).estimate_normals(max_nn=20)
            >>> sorted(int(np.abs(patch.R[:, 2]).argmax()) for patch in cloud.detect_planar_patches())
            [1, 2]
        """
        spread = _check_angle("normal_variance_threshold_deg", normal_variance_threshold_deg)
        flatness = _check_angle("coplanarity_deg", coplanarity_deg)
        share = check_positive("outlier_ratio", outlier_ratio, allow_zero=True)
        if share > 1:
            raise ValueError(f"outlier_ratio: expected a number in 0..1, got {outlier_ratio!r}")
        shortest = check_positive("min_plane_edge_length", min_plane_edge_length, allow_zero=True)
        fewest = check_count("min_num_points", min_num_points, minimum=0)
        fewest = max(fewest, 3) if fewest else max(FEWEST, int(POINT_SHARE * len(self)))
        neighbor_count = check_count("max_nn", max_nn, minimum=2)
        reach = math.inf if radius is None else check_positive("radius", radius)
        points = self._arrays["points"]
        normals = self._required_array("normals", "call cloud = cloud.estimate_normals()")
        rows = usable_rows(points, normals)
        if rows.size < fewest:
            return []
        octree = Octree(points, rows)
        labels = full(len(self), -1, int32, self.device)
        limits = Limits(math.cos(spread), math.cos(flatness), share, fewest, ROUNDING * octree.extent)
        planes = find_seeds(points, normals, labels, limits, octree)
        if not len(planes[0]):
            return []
        neighbors = self._neighbor_graph(min(neighbor_count, rows.size), reach)
        patches = Patches(points, normals, labels, planes, neighbors)
        patches.settle()
        boxes = patches.boxes(shortest or EDGE_SHARE * octree.extent)
        return [OrientedBoundingBox(c + self._origin, R, extent) for c, R, extent in zip(*boxes, strict=True)]

    # ------------------------------------------------------------------------------------------ internals

    def _neighbor_graph(self, max_nn: int, radius: float) -> Any:
        """The nearest neighbours of each point, int32 device array [n, max_nn], -1 where there are fewer."""
        if len(self) * max_nn >= 2**31:
            raise ValueError(
                f"max_nn: {max_nn} neighbours for each of {len(self)} points are 2^31 or more; take fewer or thin the "
                "cloud with voxel_down_sample"
            )
        points = self._arrays["points"]
        return search_nearest(self.search_tree(), points, max_nn, radius)[0]


def _check_angle(name: str, degrees: Any) -> float:
    """An angle of 0..90 degrees, in radians."""
    angle = check_positive(name, degrees, allow_zero=True)
    if angle > 90:
        raise ValueError(f"{name}: expected degrees in 0..90, got {degrees!r}")
    return float(np.radians(angle))
