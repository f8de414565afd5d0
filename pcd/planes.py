"""Planes in a cloud."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..core.checks import check_count, check_positive, check_seed, shown
from ..core.told_arguments import told_arguments
from ..core.watching import report
from ..kernels.arrays.bounds import bound_points
from ..kernels.arrays.select import gather_rows, invert_mask, positions_of
from ..kernels.extent.masks import mask_finite
from ..kernels.lang import int32
from ..kernels.linear_algebra import matmul, norm
from ..kernels.memory import full
from ..kernels.segmentation.plane_fit import PlaneSearch, label_rows
from .length_doubts import warn_of_long
from .planar_patches import PlanarPatches

MOST_SAMPLES = 10_000_000
WRAP = 2**30  # numbers of samples stay below 2^31


class Planes(PlanarPatches):
    """The part of PointCloud that finds planes."""

    @told_arguments
    def segment_plane(
        self,
        distance_threshold: float = 0.01,
        ransac_n: int = 3,
        num_iterations: int = 100,
        probability: float = 0.99999999,
        *,
        seed: int = 0,
    ) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
        """Find the plane with the most points on it (RANSAC).

        Args:
            distance_threshold: Distance [m] from the plane below which a point is an inlier.
            ransac_n: Points of a sample; with more than 3 the plane of a sample is its least-squares plane.
            num_iterations: Samples at most.
            probability: Ends the search once a sample of inliers alone was drawn with this probability; 1 draws all.
            seed: Of the samples.

        Returns:
            (plane_model, inliers). The model is (a, b, c, d) in world coordinates with ax + by + cz + d = 0, float64
            [4]; (a, b, c) is a unit normal whose largest component is positive: that of level ground points up.
            The inliers are indices, int32, ascending: as in Open3D those of the best sample's plane, while the model
            is the least-squares plane of these inliers, so some may lie beyond the threshold of the model.

        Raises:
            ValueError: An argument out of range, fewer finite points than `ransac_n`, or all samples on lines (Open3D
                returns a plane of zeros and all points).

        Notes:
            The best plane has the most inliers, of equals the smaller distances, as in Open3D. Samples are made in
            float64, scored in float32 relative to the middle of the cloud, and inliers are listed in float64; the same
            bits from run to run and for any number of threads. Of points that are not finite none is drawn or counted.
            The final fit minimises the squared distances to the plane (Open3D's those along an axis). Batches of 32,
            96, 288, ... samples are scored together, and the search may only end between them. 28 B of memory a point.
            Fischler and Bolles 1981.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> x, y = np.random.default_rng(0).random((2, 1000))
            >>> table = np.column_stack([x, y, np.full(1000, 0.7)])
            >>> cloud = loom.PointCloud(np.vstack([table, np.random.default_rng(1).random((300, 3))]))
            >>> (a, b, c, d), inliers = cloud.segment_plane(0.005)
            >>> round(float(c), 2), round(float(d), 2), inliers[:1000].tolist() == list(range(1000))
            (1.0, -0.7, True)
        """
        settings = _check_search(distance_threshold, ransac_n, num_iterations, probability, seed)
        points = self._arrays["points"]
        low, high, finite = bound_points(points)  # sync
        rows = positions_of(mask_finite(points, True, True), finite)
        if rows.size < settings[1]:
            raise ValueError(f"ransac_n: {settings[1]} points a sample, but the cloud has {rows.size} finite points")
        search = PlaneSearch(points, rows, (low, high))
        plane = search.find(*settings)
        if plane is None:
            raise ValueError(
                f"the points span no plane: those of all {settings[2]} samples lie on lines; "
                "raise num_iterations unless the whole cloud does"
            )
        inliers = gather_rows(rows, search.inliers(plane, settings[0])[1])
        if inliers.size == rows.size:
            so = "all of them are taken for one plane"
            warn_of_long("distance_threshold", settings[0], low, high, finite, self.unit, so)
        model = self._world_plane(search.refit(plane, inliers), search.center)
        report("plane", cloud=self, inliers=inliers, model=model)
        return model, self._handed_out(inliers)

    def segment_planes(
        self,
        distance_threshold: float = 0.01,
        ransac_n: int = 3,
        num_iterations: int = 100,
        probability: float = 0.99999999,
        *,
        min_points: int = 100,
        max_planes: int | None = None,
        seed: int = 0,
    ) -> tuple[NDArray[np.int32], NDArray[np.float64]]:
        """Find one plane after another: the plane with the most points, then that of the points left, and so on.

        Args:
            distance_threshold: As of `segment_plane`, like the three that follow.
            ransac_n: Points of a sample.
            num_iterations: Samples at most for each plane.
            probability: Ends the search for a plane early.
            min_points: Fewer inliers are no plane, and end the search.
            max_planes: Planes at most; None for no limit.
            seed: Of the samples.

        Returns:
            (labels, plane_models): int32 [n], the plane of each point in the order found, -1 for none and for points
            that are not finite; and float64 [planes, 4] as of `segment_plane`.

        Raises:
            ValueError: An argument out of range.

        Notes:
            Points stay on the device, which holds 32 B more a point. The first plane is that of `segment_plane`.
            The same bits from run to run.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> x, y = np.random.default_rng(0).random((2, 500))
            >>> floor, wall = np.column_stack([x, y, 0 * x]), np.column_stack([0 * x[:300], x[:300], y[:300] + 0.1])
            >>> labels, planes = loom.PointCloud(np.vstack([floor, wall])).segment_planes(0.01)
            >>> planes.round(1).tolist(), np.bincount(labels).tolist()
            ([[0.0, 0.0, 1.0, 0.0], [1.0, 0.0, 0.0, 0.0]], [500, 300])
        """
        settings = _check_search(distance_threshold, ransac_n, num_iterations, probability, seed)
        fewest = check_count("min_points", min_points)
        most = len(self) if max_planes is None else check_count("max_planes", max_planes)
        points = self._arrays["points"]
        low, high, finite = bound_points(points)  # sync
        rows = positions_of(mask_finite(points, True, True), finite)
        box: tuple[NDArray[Any], NDArray[Any]] | None = (low, high)
        labels = full(len(self), -1, int32, self.device)
        models: list[NDArray[np.float64]] = []
        while len(models) < most and rows.size >= max(fewest, settings[1]):
            search, box = PlaneSearch(points, rows, box), None
            plane = search.find(*settings, first=len(models) * settings[2] % WRAP)
            if plane is None:
                break
            mask, inliers = search.inliers(plane, settings[0])
            if inliers.size < fewest:
                break
            found = gather_rows(rows, inliers)
            models.append(self._world_plane(search.refit(plane, found), search.center))
            label_rows(found, len(models) - 1, labels)
            report("plane", cloud=self, inliers=found, model=models[-1], number=len(models) - 1)
            rows = gather_rows(rows, positions_of(invert_mask(mask), rows.size - inliers.size))
        return self._handed_out(labels), np.array(models).reshape(-1, 4)

    # ------------------------------------------------------------------------------------------ internals

    def _world_plane(self, plane: NDArray[np.float64], center: NDArray[np.float64]) -> NDArray[np.float64]:
        """A plane relative to a place of the cloud's own frame, in world coordinates and with its sign fixed."""
        normal = plane[:3] / norm(plane[:3])
        if normal[np.argmax(np.abs(normal))] < 0:
            normal, plane = -normal, -plane
        normal = normal + 0.0  # no minus zero
        return np.append(normal, plane[3] - matmul(normal, center + self._origin))


def _check_search(
    distance_threshold: Any, ransac_n: Any, num_iterations: Any, probability: Any, seed: Any
) -> tuple[float, int, int, float, int]:
    """Distance, points a sample, samples, probability and seed of a search, checked."""
    chance = check_positive("probability", probability)
    if chance > 1:
        raise ValueError(f"probability: expected a number in 0..1, 0 excluded, got {shown(probability)}")
    return (
        check_positive("distance_threshold", distance_threshold),
        check_count("ransac_n", ransac_n, minimum=3),
        check_count(
            "num_iterations", num_iterations, maximum=MOST_SAMPLES, because="a plane not found by then is none"
        ),
        chance,
        check_seed(seed),
    )
