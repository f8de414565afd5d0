"""Segmentation of a cloud: clusters, planes, planar patches, shapes and regions."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..core.checks import check_count, check_positive, check_seed, check_share, shown
from ..core.told_arguments import told_arguments
from ..core.verbosity import told_time
from ..core.watching import report
from ..kernels.arrays.bounds import bound_points
from ..kernels.arrays.select import gather_rows, invert_mask, positions_of
from ..kernels.extent.masks import mask_finite, usable_rows
from ..kernels.features.eigen_features import measure_curvature
from ..kernels.lang import int32
from ..kernels.linear_algebra import matmul, norm
from ..kernels.memory import full
from ..kernels.search.tree_search import search_nearest
from ..kernels.segmentation.cluster_labels import rank_by_size
from ..kernels.segmentation.dbscan import cluster_points
from ..kernels.segmentation.octree_cells import Octree
from ..kernels.segmentation.patch_growth import Patches
from ..kernels.segmentation.planar_patches import ROUNDING, Limits, find_seeds
from ..kernels.segmentation.plane_fit import PlaneSearch, label_rows
from ..kernels.segmentation.region_growth import grow_regions
from ..kernels.segmentation.shape_models import CONE, CYLINDER, SPHERE, TORUS
from ..kernels.segmentation.shape_rows import ascending, usable_in_order
from ..kernels.segmentation.shape_search import ShapeLimits, ShapeSearch
from .boxes import OrientedBoundingBox
from .length_doubts import check_order, warn_of_long, warn_of_short
from .selection import Selection
from .shape import KINDS, UNKNOWNS, Shape
from .shape_verdicts import shape_of

MAX_SIZE = 2**31 - 2  # more points than a cloud holds
# For thresholds: what no cloud reaches is no error.
ANY: dict[str, Any] = {"maximum": 2**63 - 1, "because": "counts have 64 bits"}
EDGE_SHARE = 0.01  # of the cloud's longest edge: Open3D's shortest patch
POINT_SHARE = 0.001  # of the points: Open3D's smallest seed
FEWEST = 10
MOST_SAMPLES = 10_000_000
WRAP = 2**30  # numbers of samples stay below 2^31
NORMALS = "call cloud = cloud.estimate_normals()"


class Segmentation(Selection):
    """The part of PointCloud that divides it into clusters, planes, shapes and regions."""

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

    def _cluster(self, eps: float, min_points: int) -> tuple[Any, int]:
        return cluster_points(self.search_tree(), len(self), eps, min_points)

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

    def _neighbor_graph(self, max_nn: int, radius: float) -> Any:
        """The nearest neighbours of each point, int32 device array [n, max_nn], -1 where there are fewer."""
        if len(self) * max_nn >= 2**31:
            raise ValueError(
                f"max_nn: {max_nn} neighbours for each of {len(self)} points are 2^31 or more; take fewer or thin the "
                "cloud with voxel_down_sample"
            )
        points = self._arrays["points"]
        return search_nearest(self.search_tree(), points, max_nn, radius)[0]

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

    def _world_plane(self, plane: NDArray[np.float64], center: NDArray[np.float64]) -> NDArray[np.float64]:
        """A plane relative to a place of the cloud's own frame, in world coordinates and with its sign fixed."""
        normal = plane[:3] / norm(plane[:3])
        if normal[np.argmax(np.abs(normal))] < 0:
            normal, plane = -normal, -plane
        normal = normal + 0.0  # no minus zero
        return np.append(normal, plane[3] - matmul(normal, center + self._origin))

    @told_arguments
    def segment_sphere(
        self,
        distance_threshold: float = 0.01,
        normal_threshold_deg: float = 20.0,
        num_iterations: int = 20_000,
        probability: float = 0.9999,
        *,
        min_radius: float = 0.0,
        max_radius: float | None = None,
        seed: int = 0,
    ) -> tuple[Shape, NDArray[np.int32]]:
        """Find the sphere with the most points on it (RANSAC with normals); the cloud needs normals.

        Args:
            distance_threshold: Distance [m] from the surface below which a point may be an inlier.
            normal_threshold_deg: Largest angle [degrees] between the point's normal and the surface's, whichever way
                the normal faces; 90 looks at distances alone.
            num_iterations: Samples at most.
            probability: Ends the search once a sample of inliers alone was drawn with this probability; 1 draws all.
            min_radius: Smallest radius of a sample's shape [m].
            max_radius: Largest radius of a sample's shape [m]; None for the diagonal of the cloud.
            seed: Of the samples.

        Returns:
            (shape, inliers): the shape of least squared distances with its covariance, and the indices of the points
            within the limits of it, int32, ascending. `shape.reasons` says what speaks against it: points that lie as
            well on a plane, too small a part to determine the radius or the kind, no more points on the surface than
            beside it.

        Raises:
            ValueError: The cloud has no normals, fewer finite points than the shape has unknowns, no sample spans a
                shape, or an argument is out of range.

        Notes:
            Samples are points near each other: of a run of the cloud's order along a curve, as long as the cloud or a
            power of two shorter. They are made in float64, scored in float32 relative to the middle of the cloud, on
            some 2,000 points first and the best on all; the best six are fitted in float64, each to its points again
            while these grow in number. The same bits from run to run. 24 B of memory a point. Schnabel, Wahl and Klein
            2007; the fit is to true distances (Lukacs, Martin and Marshall 1998).

        Example:
            >>> import numpy as np, pointloom as loom
            >>> ball = 0.5 * (d := np.random.default_rng(0).normal(size=(2000, 3))) / np.linalg.norm(d, axis=1)[:, None]
            >>> cloud = loom.PointCloud(np.vstack([ball, np.random.default_rng(1).random((500, 3))])).estimate_normals()
            >>> shape, inliers = cloud.segment_sphere(0.01)
            >>> round(shape.radius, 3), shape.is_sure
            (0.5, True)
        """
        limits = limits_of(distance_threshold, normal_threshold_deg, min_radius, max_radius)
        return self._segment_shape(SPHERE, limits, num_iterations, probability, seed)

    @told_arguments
    def segment_cylinder(
        self,
        distance_threshold: float = 0.01,
        normal_threshold_deg: float = 20.0,
        num_iterations: int = 20_000,
        probability: float = 0.9999,
        *,
        min_radius: float = 0.0,
        max_radius: float | None = None,
        seed: int = 0,
    ) -> tuple[Shape, NDArray[np.int32]]:
        """Find the cylinder with the most points on it (RANSAC with normals); the cloud needs normals.

        Arguments, result and errors are those of `segment_sphere`. The cylinder has no ends; `shape.extent` says how
        far its points reach along the axis.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> turn, height = np.random.default_rng(0).random((2, 3000)) * [[2 * np.pi], [1.0]]
            >>> pipe = np.column_stack([0.2 * np.cos(turn), 0.2 * np.sin(turn), height])
            >>> shape, inliers = loom.PointCloud(pipe).estimate_normals().segment_cylinder(0.005)
            >>> round(shape.radius, 3), round(float(shape.axis[2]), 3)
            (0.2, 1.0)
        """
        limits = limits_of(distance_threshold, normal_threshold_deg, min_radius, max_radius)
        return self._segment_shape(CYLINDER, limits, num_iterations, probability, seed)

    @told_arguments
    def segment_cone(
        self,
        distance_threshold: float = 0.01,
        normal_threshold_deg: float = 20.0,
        num_iterations: int = 20_000,
        probability: float = 0.9999,
        *,
        seed: int = 0,
    ) -> tuple[Shape, NDArray[np.int32]]:
        """Find the cone with the most points on it (RANSAC with normals); the cloud needs normals.

        Arguments, result and errors are those of `segment_sphere`. Half angles lie between 2 and 86 degrees; of the two
        halves of a double cone one is found.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> turn, height = np.random.default_rng(0).random((2, 3000)) * [[2 * np.pi], [1.0]] + [[0], [0.2]]
            >>> hat = np.column_stack([0.5 * height * np.cos(turn), 0.5 * height * np.sin(turn), height])
            >>> shape, inliers = loom.PointCloud(hat).estimate_normals().segment_cone(0.005)
            >>> round(float(np.tan(shape.half_angle)), 3)
            0.5
        """
        limits = limits_of(distance_threshold, normal_threshold_deg, 0.0, None)
        return self._segment_shape(CONE, limits, num_iterations, probability, seed)

    @told_arguments
    def segment_torus(
        self,
        distance_threshold: float = 0.01,
        normal_threshold_deg: float = 20.0,
        num_iterations: int = 20_000,
        probability: float = 0.9999,
        *,
        min_radius: float = 0.0,
        max_radius: float | None = None,
        seed: int = 0,
    ) -> tuple[Shape, NDArray[np.int32]]:
        """Find the torus with the most points on it (RANSAC with normals); the cloud needs normals.

        Arguments, result and errors are those of `segment_sphere`. Its tube is thinner than its ring; `min_radius` is
        of the tube, `max_radius` of the ring.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> u, v = np.random.default_rng(0).random((2, 4000)) * 2 * np.pi
            >>> q = 0.5 + 0.15 * np.cos(v)
            >>> ring = np.column_stack([q * np.cos(u), q * np.sin(u), 0.15 * np.sin(v)])
            >>> shape, inliers = loom.PointCloud(ring).estimate_normals().segment_torus(0.005)
            >>> round(shape.radius, 2), round(shape.minor_radius, 2)
            (0.5, 0.15)
        """
        limits = limits_of(distance_threshold, normal_threshold_deg, min_radius, max_radius)
        return self._segment_shape(TORUS, limits, num_iterations, probability, seed)

    def _segment_shape(
        self, kind: int, limits: ShapeLimits, num_iterations: Any, probability: Any, seed: Any
    ) -> tuple[Shape, NDArray[np.int32]]:
        most, chance, start = check_samples(num_iterations, probability, seed)
        name = KINDS[kind]
        search, limits = search_of(self, limits)
        unknowns, rows = len(UNKNOWNS[name]), search.rows
        if rows.size <= unknowns:
            have = f"the cloud has {rows.size} finite points with normals"
            raise ValueError(f"a {name} has {unknowns} unknowns, but {have}")
        if search.size <= 0.0:
            raise ValueError(f"points: all {rows.size:,} are equal, which is no {name}")
        found = search.find(kind, limits, most, chance, start)
        if found is None or not found.rows.size:
            raise ValueError(
                f"no {name} found: none of {most:,} samples spans one within the limits; raise distance_threshold or "
                "normal_threshold_deg, or the normals may be inexact: estimate_normals with a larger max_nn"
            )
        shape = shape_of(search, found, limits, self._origin)
        return shape, self._handed_out(ascending(found.rows, len(self)))

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


def _check_angle(name: str, degrees: Any) -> float:
    """An angle of 0..90 degrees, in radians."""
    angle = check_positive(name, degrees, allow_zero=True)
    if angle > 90:
        raise ValueError(f"{name}: expected degrees in 0..90, got {degrees!r}")
    return float(np.radians(angle))


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


def limits_of(distance: Any, degrees: Any, smallest: Any, largest: Any) -> ShapeLimits:
    """What makes a point one of a shape, checked; a largest radius of zero stands for none."""
    reach = check_positive("distance_threshold", distance)
    angle = check_positive("normal_threshold_deg", degrees)
    if angle > 90:
        raise ValueError(f"normal_threshold_deg: expected degrees in 0..90, 0 excluded, got {shown(degrees)}")
    least = check_positive("min_radius", smallest, allow_zero=True)
    most = 0.0 if largest is None else check_positive("max_radius", largest)
    if largest is not None and most < least:
        raise ValueError(f"max_radius: expected at least min_radius = {least:g} m, got {shown(largest)}")
    return ShapeLimits(reach, max(0.0, math.cos(math.radians(angle))), least, most)


def search_of(cloud: Segmentation, limits: ShapeLimits) -> tuple[ShapeSearch, ShapeLimits]:
    """The search among the points that are finite and have normals; the limits with a largest radius."""
    points, normals = cloud._device_array("points"), cloud._required_array("normals", NORMALS)
    search = ShapeSearch(points, normals, usable_in_order(cloud.search_tree(), points, normals))
    largest = limits.largest or 2 * math.sqrt(3) * search.size
    return search, ShapeLimits(limits.distance, limits.cosine, limits.smallest, largest)


def check_samples(num_iterations: Any, probability: Any, seed: Any) -> tuple[int, float, int]:
    """Samples at most, probability and seed of a search, checked."""
    most = check_count(
        "num_iterations", num_iterations, maximum=MOST_SAMPLES, because="a shape not found by then is none"
    )
    return most, check_share("probability", probability), check_seed(seed)
