"""Segmentation of a cloud: clusters, planes, planar patches, shapes and regions."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..core.argument_errors import explain_argument_errors
from ..core.checks import check_count, check_fraction, check_positive, check_seed, shown
from ..core.observers import report
from ..core.verbosity import printed_duration
from ..kernels.array_types import AnyArray
from ..kernels.arrays.bounds import bound_points
from ..kernels.arrays.select import gather_rows, invert_mask, positions_of
from ..kernels.extent.masks import mask_finite, usable_rows
from ..kernels.features.eigen_features import measure_curvature
from ..kernels.lang import int32
from ..kernels.linear_algebra import matmul, norm
from ..kernels.memory import full
from ..kernels.search.distinct_points import distinct_points
from ..kernels.search.tree_search import search_nearest
from ..kernels.segmentation.cluster_labels import rank_by_size
from ..kernels.segmentation.dbscan import cluster_points
from ..kernels.segmentation.octree_cells import Octree
from ..kernels.segmentation.patch_growth import Patches
from ..kernels.segmentation.planar_patches import RELATIVE_ROUNDING, Limits, find_seeds
from ..kernels.segmentation.plane_fit import PlaneSearch, label_rows
from ..kernels.segmentation.region_growth import grow_regions
from ..kernels.segmentation.shape_rows import ascending, usable_in_order
from ..kernels.segmentation.shape_search import ShapeLimits, ShapeSearch
from .boxes import OrientedBoundingBox
from .length_checks import check_order, warn_of_long, warn_of_small_plane, warn_of_sparse
from .selection import Selection
from .shape import KINDS, UNKNOWNS, Shape, check_kind
from .shape_checks import shape_of

MAX_SIZE = 2**31 - 2  # more points than a cloud can have
# Upper limit of thresholds.
UNLIMITED_COUNT: dict[str, Any] = {"maximum": 2**63 - 1, "because": "counts have 64 bits"}
EDGE_FRACTION = 0.01  # of the cloud's longest edge: Open3D's default
POINT_FRACTION = 0.001  # of the points: Open3D's default
MIN_POINTS = 10
MAX_SAMPLES = 10_000_000
SEED_MODULUS = 2**30  # sample numbers stay below 2^31
NORMALS = "call cloud = cloud.estimate_normals()"


class Segmentation(Selection):
    """Methods of PointCloud that find clusters, planes, shapes and regions."""

    _internal = ("grow_regions",)

    @explain_argument_errors
    def cluster_dbscan(self, eps: float, min_points: int, print_progress: bool = False) -> NDArray[np.int32]:
        """Cluster points by density (DBSCAN), with the labels of Open3D's legacy implementation.

        A core point has at least `min_points` points within `eps`, itself included. Clusters are numbered by their
        first core. A border point takes the lowest label of its cores. 14 B per point (22 on CUDA) beside the search
        tree. Bitwise reproducible. Ester et al., "A density-based algorithm for discovering clusters", KDD 1996.
        Prokopenko et al., "Fast tree-based algorithms for DBSCAN on GPUs", ICPP 2023.

        Args:
            eps: Exclusive neighbor distance [m].
            min_points: Minimum neighbors of a core point.
            print_progress: Report start and duration on stderr.

        Returns:
            Labels, int32 (n,), from 0, or -1 for noise and points that are not finite.

        Raises:
            ValueError, TypeError: If an argument is not positive, or the extent exceeds `NearestNeighborSearch`.

        Example:
            >>> import pointloom as loom
            >>> cloud = loom.PointCloud([[0, 0, 0], [0.1, 0, 0], [5, 0, 0], [5.1, 0, 0], [9, 0, 0]])
            >>> cloud.cluster_dbscan(eps=0.2, min_points=2).tolist()
            [0, 0, 1, 1, -1]
        """
        check_order("min_points", min_points, "eps", eps)
        search_radius, min_count = check_positive("eps", eps), check_count("min_points", min_points, **UNLIMITED_COUNT)
        with printed_duration(f"clusters of {len(self):,} points", print_progress):
            tree, unit = self.search_tree(), self.unit
            labels, cluster_count = cluster_points(tree, len(self), search_radius, min_count)
        if not cluster_count and min_count > 1:
            warn_of_sparse("eps", tree, search_radius, min_count, unit, "all points are noise")
        elif cluster_count == 1:
            warn_of_long("eps", search_radius, tree.low, tree.high, tree.count, unit, "all points form one cluster")
        report("clusters", cloud=self, labels=labels)
        return self.arrays.hand_out(labels)

    def cluster_euclidean(
        self, tolerance: float, min_cluster_size: int = 1, max_cluster_size: int | None = None
    ) -> NDArray[np.int32]:
        """Find connected components of points with steps shorter than `tolerance`.

        Clusters are numbered by decreasing size (as in PCL), ties by first point. O(n) memory, bitwise reproducible.
        Rusu, PhD thesis, TU Munich 2009, section 6.2.

        Args:
            tolerance: Exclusive step length [m].
            min_cluster_size, max_cluster_size: Allowed number of points; None: no maximum. Other clusters are dropped.

        Returns:
            Labels, int32 (n,), from 0, or -1 for points of dropped clusters and points that are not finite.

        Raises:
            ValueError, TypeError: If an argument is not positive, or the extent exceeds `NearestNeighborSearch`.

        Example:
            >>> import pointloom as loom
            >>> cloud = loom.PointCloud([[9, 0, 0], [0, 0, 0], [0.1, 0, 0], [0.2, 0, 0]])
            >>> cloud.cluster_euclidean(0.15).tolist()
            [1, 0, 0, 0]
            >>> cloud.cluster_euclidean(0.15, min_cluster_size=2).tolist()
            [-1, 0, 0, 0]
        """
        step = check_positive("tolerance", tolerance)
        min_size = check_count("min_cluster_size", min_cluster_size, **UNLIMITED_COUNT)
        max_size = MAX_SIZE
        if max_cluster_size is not None:
            max_size = check_count("max_cluster_size", max_cluster_size, **UNLIMITED_COUNT)
            if max_size < min_size:
                raise ValueError(f"max_cluster_size: expected at least min_cluster_size = {min_size}, got {max_size}")
        labels, cluster_count = cluster_points(self.search_tree(), len(self), step, 1)
        if cluster_count:
            rank_by_size(labels, cluster_count, min(min_size, MAX_SIZE), min(max_size, MAX_SIZE))
        report("clusters", cloud=self, labels=labels)
        return self.arrays.hand_out(labels)

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
        """Find planar patches by robust statistics. The cloud needs normals.

        Unlike Open3D: normals need no consistent side. Planes use medians along the normal; patches merge only into
        patches that they fit, so edges and steps do not join planes. Exact planes are found. Boxes have minimal area to
        0.1 degrees. 4 B per neighbor and about 170 B per point. Bitwise reproducible. Araujo and Oliveira, "A robust
        statistics approach for plane detection in unorganized point clouds", Pattern Recognition 2020.

        Args:
            normal_variance_threshold_deg: Maximum spread of normals about a plane's [degrees]; smaller finds fewer.
            coplanarity_deg: Minimum angle [degrees] of the normal and the section's diagonal; larger finds fewer.
            outlier_ratio: Maximum fraction of outliers in a seed.
            min_plane_edge_length: Minimum longest edge of a patch [m]. 0 for 1% of the cloud's longest edge.
            min_num_points: Minimum points of a seed. 0 for a thousandth of the points, at least 10.
            radius: Exclusive neighbor distance [m]. None for no limit.
            max_nn: Neighbors per point when growing, including the point itself.

        Returns:
            A box per patch, most points first: the columns of R are its two sides and its normal, the last `extent` its
            thickness. It contains all points of the patch, up to rounding.

        Raises:
            ValueError: If the cloud has no normals, or an argument is out of range.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> table = np.random.default_rng(0).random((9000, 3)) * [2, 1, 0.004]
            >>> wall = np.random.default_rng(1).random((9000, 3)) * [2, 0.004, 1] + [0, 2, 1]
            >>> cloud = loom.PointCloud(np.vstack([table, wall])).estimate_normals(max_nn=20)
            >>> sorted(int(np.abs(patch.R[:, 2]).argmax()) for patch in cloud.detect_planar_patches())
            [1, 2]
        """
        spread = float(
            np.radians(_check_degrees("normal_variance_threshold_deg", normal_variance_threshold_deg, allow_zero=True))
        )
        flatness = float(np.radians(_check_degrees("coplanarity_deg", coplanarity_deg, allow_zero=True)))
        fraction = check_positive("outlier_ratio", outlier_ratio, allow_zero=True)
        if fraction > 1:
            raise ValueError(f"outlier_ratio: expected a number in 0..1, got {outlier_ratio!r}")
        shortest = check_positive("min_plane_edge_length", min_plane_edge_length, allow_zero=True)
        min_count = check_count("min_num_points", min_num_points, minimum=0)
        min_count = max(min_count, 3) if min_count else max(MIN_POINTS, int(POINT_FRACTION * len(self)))
        neighbor_count = check_count("max_nn", max_nn, minimum=2)
        search_radius = math.inf if radius is None else check_positive("radius", radius)
        points = self.arrays["points"]
        normals = self.arrays.required("normals", "call cloud = cloud.estimate_normals()")
        distinct = distinct_points(self.search_tree(), neighbor_count)
        if distinct is not None:  # copies of a position have no other neighbors
            first_points = self.select_rows(distinct.firsts)
            limits_of_planes = normal_variance_threshold_deg, coplanarity_deg, outlier_ratio, min_plane_edge_length
            return first_points.detect_planar_patches(*limits_of_planes, min_num_points, radius=radius, max_nn=max_nn)
        rows = usable_rows(points, normals)
        if rows.size < min_count:
            return []
        octree = Octree(points, rows)
        labels = full(len(self), -1, int32, self.device)
        limits = Limits(math.cos(spread), math.cos(flatness), fraction, min_count, RELATIVE_ROUNDING * octree.extent)
        planes = find_seeds(points, normals, labels, limits, octree)
        if not len(planes[0]):
            return []
        neighbors = self._neighbor_graph(min(neighbor_count, rows.size), search_radius)
        patches = Patches(points, normals, labels, planes, neighbors)
        patches.converge()
        boxes = patches.boxes(shortest or EDGE_FRACTION * octree.extent)
        return [OrientedBoundingBox(c + self.arrays.origin, R, extent) for c, R, extent in zip(*boxes, strict=True)]

    def _neighbor_graph(self, max_nn: int, radius: float) -> Any:
        """Nearest neighbors of each point, int32 device array (n, max_nn), -1 if fewer."""
        if len(self) * max_nn >= 2**31:
            raise ValueError(
                f"max_nn: {max_nn} neighbors for each of {len(self)} points are 2^31 or more. Use fewer or downsample "
                "the cloud with voxel_down_sample"
            )
        points = self.arrays["points"]
        return search_nearest(self.search_tree(), points, max_nn, radius)[0]

    @explain_argument_errors
    def segment_plane(
        self,
        distance_threshold: float = 0.01,
        ransac_n: int = 3,
        num_iterations: int = 100,
        probability: float = 0.99999999,
        *,
        seed: int = 0,
    ) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
        """Find the plane with the most inliers (RANSAC).

        Most inliers win, then smaller distances. Samples are scored in growing batches. 28 B per point. Bitwise
        reproducible. Fischler and Bolles, "Random sample consensus", CACM 1981.

        Args:
            distance_threshold: Exclusive inlier distance [m].
            ransac_n: Points per sample. More than 3 use a least-squares plane.
            num_iterations: Maximum number of samples.
            probability: Confidence of an outlier-free sample that ends the search. 1 draws all.
            seed: Random seed.

        Returns:
            (plane_model, inliers): (a, b, c, d) in world coordinates with ax + by + cz + d = 0, float64 (4,), the
            largest component of the unit normal (a, b, c) positive; and ascending int32 indices. The inliers are those
            of the best sample, the model is their least-squares plane.

        Raises:
            ValueError: If an argument is out of range, there are too few finite points, or all samples are collinear.

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
        points = self.arrays["points"]
        low, high, finite = bound_points(points)  # sync
        rows = positions_of(mask_finite(points, True, True), finite)
        if rows.size < settings[1]:
            raise ValueError(
                f"ransac_n: expected at most the {rows.size} finite points of the cloud, got {settings[1]}"
            )
        search = PlaneSearch(points, rows, (low, high))
        plane = search.find(*settings)
        if plane is None:
            raise ValueError(
                f"no plane found: the points of all {settings[2]} samples are collinear. "
                "Raise num_iterations unless the whole cloud is collinear"
            )
        inliers = gather_rows(rows, search.inliers(plane, settings[0])[1])
        if inliers.size == rows.size:
            so = "all points are assigned to one plane"
            warn_of_long("distance_threshold", settings[0], low, high, finite, self.unit, so)
        warn_of_small_plane(inliers.size, settings[1], finite, settings[0], self.unit)
        model = self._world_plane(search.refit(plane, inliers), search.center)
        report("plane", cloud=self, inliers=inliers, model=model)
        return model, self.arrays.hand_out(inliers)

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
        """Find planes one after another, each with the most inliers among the remaining points.

        Args:
            distance_threshold, ransac_n, num_iterations, probability, seed: As of `segment_plane`, for each plane.
            min_points: Minimum inliers of a plane. Fewer end the search.
            max_planes: Maximum number of planes. None for no limit.

        Returns:
            (labels, plane_models): int32 (n,), the plane of each point in order of detection, -1 for none; and float64
            (planes, 4) as `segment_plane`. 32 B per point. Bitwise reproducible.

        Raises:
            ValueError: If an argument is out of range.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> x, y = np.random.default_rng(0).random((2, 500))
            >>> floor, wall = np.column_stack([x, y, 0 * x]), np.column_stack([0 * x[:300], x[:300], y[:300] + 0.1])
            >>> labels, planes = loom.PointCloud(np.vstack([floor, wall])).segment_planes(0.01)
            >>> planes.round(1).tolist(), np.bincount(labels).tolist()
            ([[0.0, 0.0, 1.0, 0.0], [1.0, 0.0, 0.0, 0.0]], [500, 300])
        """
        settings = _check_search(distance_threshold, ransac_n, num_iterations, probability, seed)
        min_count = check_count("min_points", min_points)
        max_count = len(self) if max_planes is None else check_count("max_planes", max_planes)
        points = self.arrays["points"]
        low, high, finite = bound_points(points)  # sync
        rows = positions_of(mask_finite(points, True, True), finite)
        box: tuple[NDArray[Any], NDArray[Any]] | None = (low, high)
        labels = full(len(self), -1, int32, self.device)
        models: list[NDArray[np.float64]] = []
        largest = 0
        while len(models) < max_count and rows.size >= max(min_count, settings[1]):
            search, box = PlaneSearch(points, rows, box), None
            plane = search.find(*settings, first=len(models) * settings[2] % SEED_MODULUS)
            if plane is None:
                break
            mask, inliers = search.inliers(plane, settings[0])
            if inliers.size < min_count:
                break
            largest = largest or inliers.size
            plane_rows = gather_rows(rows, inliers)
            models.append(self._world_plane(search.refit(plane, plane_rows), search.center))
            label_rows(plane_rows, len(models) - 1, labels)
            report("plane", cloud=self, inliers=plane_rows, model=models[-1], number=len(models) - 1)
            rows = gather_rows(rows, positions_of(invert_mask(mask), rows.size - inliers.size))
        if finite and largest == finite:
            so = "all points are assigned to one plane"
            warn_of_long("distance_threshold", settings[0], low, high, finite, self.unit, so)
        warn_of_small_plane(largest, min_count, finite, settings[0], self.unit)
        return self.arrays.hand_out(labels), np.array(models).reshape(-1, 4)

    def _world_plane(self, plane: NDArray[np.float64], center: NDArray[np.float64]) -> NDArray[np.float64]:
        """Convert a plane relative to `center` to world coordinates with a fixed sign."""
        normal = plane[:3] / norm(plane[:3])
        if normal[np.argmax(np.abs(normal))] < 0:
            normal, plane = -normal, -plane
        normal = normal + 0.0  # avoids negative zero
        return np.append(normal, plane[3] - matmul(normal, center + self.arrays.origin))

    @explain_argument_errors
    def segment_shape(
        self,
        kind: str,
        distance_threshold: float = 0.01,
        normal_threshold_deg: float = 20.0,
        *,
        num_iterations: int = 20_000,
        probability: float = 0.9999,
        min_radius: float = 0.0,
        max_radius: float | None = None,
        seed: int = 0,
    ) -> tuple[Shape, NDArray[np.int32]]:
        """Find the sphere, cylinder, cone or torus with the most inliers (RANSAC). The cloud needs normals.

        Samples are local along a space-filling curve, scored on 2,000 points, then on all. The best six are refined. 24
        B per point. Bitwise reproducible. Schnabel, Wahl and Klein, "Efficient RANSAC for point-cloud shape detection",
        CGF 2007. Lukacs, Martin and Marshall, "Faithful least-squares fitting", ECCV 1998.

        Args:
            kind: "sphere", "cylinder" (unbounded; `shape.extent` limits its points), "cone" (one nappe, half angles of
                2 to 86 degrees) or "torus". Planes: `segment_plane`.
            distance_threshold: Exclusive inlier distance from the surface [m].
            normal_threshold_deg: Maximum unsigned angle [degrees] between point and surface normals; 90: ignored.
            num_iterations: Maximum number of samples.
            probability: Confidence of an outlier-free sample that ends the search. 1 draws all.
            min_radius: Minimum radius of a sample's sphere, cylinder or torus tube [m].
            max_radius: Maximum radius of a sample's sphere, cylinder or torus ring [m]. If None: the diagonal of the
                cloud.
            seed: Random seed.

        Returns:
            (shape, inliers): the least-squares shape with its covariance, and ascending int32 indices of its inliers.
            `shape.warnings` lists failed checks: a plane fits as well, the visible part is too small to determine
            radius or kind, or there are no more points on the surface than beside it.

        Raises:
            TypeError, ValueError: If the kind is unknown, the cloud has no normals or too few finite points, there is
                no shape, or an argument is invalid.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> ball = 0.5 * (d := np.random.default_rng(0).normal(size=(2000, 3))) / np.linalg.norm(d, axis=1)[:, None]
            >>> cloud = loom.PointCloud(np.vstack([ball, np.random.default_rng(1).random((500, 3))])).estimate_normals()
            >>> shape, inliers = cloud.segment_shape("sphere", 0.01)
            >>> round(shape.radius, 3), shape.reliable
            (0.5, True)
        """
        number = check_kind(kind, KINDS[1:])
        limits = limits_of(distance_threshold, normal_threshold_deg, min_radius, max_radius)
        max_samples, chance, start = check_samples(num_iterations, probability, seed)
        search, limits = search_of(self, limits)
        unknowns, rows = len(UNKNOWNS[kind]), search.rows
        if rows.size <= unknowns:
            have = f"the cloud has {rows.size} finite points with normals"
            raise ValueError(f"a {kind} has {unknowns} unknowns, but {have}")
        if search.size <= 0.0:
            raise ValueError(f"points: all {rows.size:,} are equal and define no {kind}")
        detected = search.find(number, limits, max_samples, chance, start)
        if detected is None or not detected.rows.size:
            raise ValueError(
                f"no {kind} found: none of {max_samples:,} samples fits within the limits. Raise distance_threshold or "
                "normal_threshold_deg. If the normals are inexact, estimate them with a larger max_nn"
            )
        shape = shape_of(search, detected, limits, self.arrays.origin)
        return shape, self.arrays.hand_out(ascending(detected.rows, len(self)))

    @explain_argument_errors
    def region_growing(
        self,
        smoothness_threshold_deg: float = 3.0,
        curvature_threshold: float = 0.05,
        min_cluster_size: int = 50,
        max_cluster_size: int | None = None,
        *,
        max_nn: int = 30,
    ) -> NDArray[np.int32]:
        """Find smooth regions by normals and curvature, as PCL's RegionGrowing. The cloud needs normals.

        A region grows from low-curvature points to neighbors with similar normals. Independent of seed order, unlike
        PCL: a high-curvature point joins the region whose nearest point has the most similar normal, low-curvature
        points join if either is among the other's neighbors, and high-curvature seeds form no region. 4 B per neighbor
        and 40 B per point. Bitwise reproducible. Rabbani, van den Heuvel and Vosselman, "Segmentation of point clouds
        using smoothness constraint", ISPRS 2006.

        Args:
            smoothness_threshold_deg: Maximum unsigned angle [degrees] between neighboring normals. PCL's default is 30.
            curvature_threshold: Surface variation (0..1/3, as `estimate_curvature`) below which a region grows on.
            min_cluster_size, max_cluster_size: Allowed number of points; None: no maximum. Other regions are dropped.
            max_nn: Neighbors per point, including itself; curvature uses the same neighbors.

        Returns:
            Labels, int32 (n,), from 0 for the largest region, ties by first point, or -1 for none.

        Raises:
            ValueError: If the cloud has no normals, or an argument is out of range.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> x, y = np.random.default_rng(0).random((2, 4000))
            >>> floor, wall = np.column_stack([x, y, 0 * x]), np.column_stack([0 * x, x, y + 0.05])[:2000]
            >>> cloud = loom.PointCloud(np.vstack([floor, wall])).estimate_normals(max_nn=15)
            >>> labels = cloud.region_growing(5.0, 0.01, max_nn=15)
            >>> labels.max() + 1, bool((labels[:4000] == 0).mean() > 0.95)
            (np.int32(2), True)
        """
        angle = _check_degrees("smoothness_threshold_deg", smoothness_threshold_deg)
        limit = check_positive("curvature_threshold", curvature_threshold)
        min_size = check_count("min_cluster_size", min_cluster_size, **UNLIMITED_COUNT)
        max_size = MAX_SIZE
        if max_cluster_size is not None:
            max_size = check_count("max_cluster_size", max_cluster_size, **UNLIMITED_COUNT)
            if max_size < min_size:
                raise ValueError(f"max_cluster_size: expected at least min_cluster_size = {min_size}, got {max_size}")
        count = check_count("max_nn", max_nn, minimum=2)
        normals = self.arrays.required("normals", NORMALS)
        sizes = min(min_size, MAX_SIZE), min(max_size, MAX_SIZE)
        limits = math.cos(math.radians(angle)), limit, *sizes
        distinct = distinct_points(self.search_tree(), count)
        if distinct is None:
            labels = self.grow_regions(normals, count, limits)
        else:  # copies of a position have no other neighbors
            first_points, firsts = self.select_rows(distinct.firsts), distinct.firsts
            labels = first_points.grow_regions(gather_rows(normals, firsts), count, limits)
            labels = gather_rows(labels, distinct.rows)
        report("clusters", cloud=self, labels=labels)
        return self.arrays.hand_out(labels)

    def grow_regions(self, normals: AnyArray, count: int, limits: tuple[float, float, int, int]) -> Any:
        nearest = self._neighbor_graph(min(count, max(len(self), 1)), math.inf)
        curvature = measure_curvature(self.search_tree(), math.inf, count)
        return grow_regions(normals, curvature, nearest, *limits)[0]


def _check_degrees(name: str, degrees: object, *, allow_zero: bool = False) -> float:
    angle = check_positive(name, degrees, allow_zero=allow_zero)
    if angle > 90:
        raise ValueError(
            f"{name}: expected degrees in 0..90{'' if allow_zero else ', 0 excluded'}, got {shown(degrees)}"
        )
    return angle


def _check_search(
    distance_threshold: object, ransac_n: object, num_iterations: object, probability: object, seed: object
) -> tuple[float, int, int, float, int]:
    chance = check_positive("probability", probability)
    if chance > 1:
        raise ValueError(f"probability: expected a number in 0..1, 0 excluded, got {shown(probability)}")
    return (
        check_positive("distance_threshold", distance_threshold),
        check_count("ransac_n", ransac_n, minimum=3),
        check_count(
            "num_iterations", num_iterations, maximum=MAX_SAMPLES, because="more iterations find no further plane"
        ),
        chance,
        check_seed(seed),
    )


def limits_of(distance: float, degrees: float, smallest: float, largest: float | None) -> ShapeLimits:
    """Validate the limits of a shape search. A maximum radius of 0 means none."""
    max_distance = check_positive("distance_threshold", distance)
    angle = _check_degrees("normal_threshold_deg", degrees)
    min_radius = check_positive("min_radius", smallest, allow_zero=True)
    max_radius = 0.0 if largest is None else check_positive("max_radius", largest)
    if largest is not None and max_radius < min_radius:
        raise ValueError(f"max_radius: expected at least min_radius = {min_radius:g} m, got {shown(largest)}")
    return ShapeLimits(max_distance, max(0.0, math.cos(math.radians(angle))), min_radius, max_radius)


def search_of(cloud: Segmentation, limits: ShapeLimits) -> tuple[ShapeSearch, ShapeLimits]:
    """Search among the finite points with normals, and limits with a maximum radius."""
    points, normals = cloud.arrays["points"], cloud.arrays.required("normals", NORMALS)
    search = ShapeSearch(points, normals, usable_in_order(cloud.search_tree(), points, normals))
    largest = limits.largest or 2 * math.sqrt(3) * search.size
    return search, ShapeLimits(limits.distance, limits.cosine, limits.smallest, largest)


def check_samples(num_iterations: object, probability: object, seed: object) -> tuple[int, float, int]:
    max_samples = check_count(
        "num_iterations", num_iterations, maximum=MAX_SAMPLES, because="more iterations find no further shape"
    )
    return max_samples, check_fraction("probability", probability), check_seed(seed)
