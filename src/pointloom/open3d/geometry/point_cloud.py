"""PointCloud, changed in place as in Open3D: each method is that of `loom.PointCloud` with the same name."""

from __future__ import annotations

import itertools
from typing import Any, ClassVar, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.joined_parts import MissingPartsWarning
from ...core.units import without_warnings
from ...pcd import cloud
from .. import geometry
from ..argument_types import BoxLike, CameraLike, CloudLike, FrameLike, ImageLike, IndicesLike
from ..indices import flagged
from ..seeds import next_seed
from ..vectors import DoubleVector, IntVector, Matrix3dVector, Vector3dVector
from ..wrapper import Rows, column, unwrap
from .bounded import BoundedByBoxes
from .image import below, depth_of
from .search_param import KDTreeSearchParam, KDTreeSearchParamHybrid, KDTreeSearchParamKNN, keywords_of

KNN = KDTreeSearchParamKNN()
SMOOTHING_NEIGHBORS = KDTreeSearchParamHybrid(0.05, 30)
PATCH_COLORS = (  # of planar patches in turn, as in Open3D
    (0.85, 0.325, 0.098), (0.929, 0.694, 0.125), (0.494, 0.184, 0.556),
    (0.466, 0.674, 0.188), (0.301, 0.745, 0.933), (0.635, 0.078, 0.184),
)  # fmt: skip
VECTORS = ("normals", "colors", "covariances")


class PointCloud(BoundedByBoxes):
    """Points with normals, colors and covariances as vectors that can be assigned and written to by `np.asarray`.

    Some methods change the cloud, others return a new one, as in Open3D. File attributes (intensity, labels) are
    preserved.
    """

    _kind = cloud.PointCloud
    _arrays: ClassVar = {"points": "points", "normals": "normals", "covariances": "covariances"}

    points = Rows(Vector3dVector)
    normals = Rows(Vector3dVector)
    colors = Rows(Vector3dVector)
    covariances = Rows(Matrix3dVector)

    def __init__(self, points: object = ()):
        given = unwrap(points)
        if hasattr(given, "sample_points_uniformly"):
            unwrap(points, PointCloud, "points")
        self._wrapped, self._shared = given if isinstance(given, cloud.PointCloud) else cloud.PointCloud(), {}
        if isinstance(points, PointCloud):
            vars(self).update(vars(points.__copy__()))
        elif given is not self._wrapped:
            self.points = given if isinstance(given, np.ndarray | Vector3dVector) else np.asarray(given)

    def _read(self, name: str) -> NDArray[Any]:
        if name not in self._wrapped:
            return np.asarray(getattr(type(self), name).kind())
        return getattr(self._wrapped, name)

    def _token(self, native: Any, name: str) -> tuple[Any, ...] | None:
        if name not in native:
            return None
        return native.arrays[name], native.origin.tobytes() if name == "points" else b""

    def _made(self, changed: list[str]) -> Any:
        count, made = self._count("points"), self._wrapped
        if count == len(made):
            made = made.copy()
            if "points" in changed:
                self.vector("covariances")  # stay, as in Open3D
                made.points, changed = np.array(self.points), [*changed, "covariances"]
        else:
            for name in VECTORS:
                self.vector(name)  # of the old cloud
            changed, made = [*VECTORS], cloud.PointCloud(np.array(self.points), device=made.device)
        for name in (name for name in VECTORS if name in changed):
            if count and len(self.vector(name)) == count:
                setattr(made, name, np.array(self.vector(name)))
            elif name in made:
                made = made.without(name)
        return made

    def has_points(self) -> bool:
        return self._count("points") > 0

    def has_normals(self) -> bool:
        return self._has("normals")

    def has_colors(self) -> bool:
        return self._has("colors")

    def has_covariances(self) -> bool:
        return self._has("covariances")

    def is_empty(self) -> bool:
        return not self.has_points()

    def _has(self, name: str) -> bool:
        return 0 < self._count("points") == self._count(name)

    def __repr__(self) -> str:
        return f"PointCloud with {self._count('points')} points."

    def __add__(self, other: object) -> PointCloud:
        return PointCloud.from_native(self._joined(other))

    def __iadd__(self, other: object) -> Self:
        return self._become(self._joined(other))

    def _joined(self, other: object) -> cloud.PointCloud:
        with without_warnings(MissingPartsWarning):  # as in Open3D
            return self.native + unwrap(other, PointCloud, "other")

    @classmethod
    def create_from_depth_image(
        cls,
        depth: ImageLike,
        intrinsic: CameraLike,
        extrinsic: ArrayLike | None = None,
        depth_scale: float = 1000.0,
        depth_trunc: float = 1000.0,
        stride: int = 1,
        project_valid_depth_only: bool = True,
    ) -> Self:
        """Points of a depth image; `extrinsic` is world to camera."""
        pixels, farthest = depth_of(depth), below(depth_trunc)
        made = cloud.PointCloud.create_from_depth_image(
            pixels, unwrap(intrinsic), extrinsic, depth_scale, farthest, stride, project_valid_depth_only
        )
        return cls.from_native(made)

    @classmethod
    def create_from_rgbd_image(
        cls,
        image: FrameLike,
        intrinsic: CameraLike,
        extrinsic: ArrayLike | None = None,
        project_valid_depth_only: bool = True,
    ) -> Self:
        """Colored points of an RGBDImage; `extrinsic` is world to camera."""
        made = cloud.PointCloud.create_from_rgbd_image(
            unwrap(image), unwrap(intrinsic), extrinsic, project_valid_depth_only
        )
        return cls.from_native(made)

    def paint_uniform_color(self, color: ArrayLike) -> Self:
        return self._become(self.native.paint_uniform_color(column("color", color)))

    def estimate_normals(self, search_param: KDTreeSearchParam = KNN, fast_normal_computation: bool = True) -> None:
        """Estimate normals, oriented by existing ones. `fast_normal_computation` has no effect."""
        self._become(self.native.estimate_normals(**keywords_of(search_param)))

    def estimate_covariances(self, search_param: KDTreeSearchParam = KNN) -> None:
        self._become(self.native.estimate_covariances(**keywords_of(search_param)))

    def normalize_normals(self) -> Self:
        return self._become(self.native.normalize_normals()) if self.has_normals() else self

    def orient_normals_to_align_with_direction(self, orientation_reference: ArrayLike = (0.0, 0.0, 1.0)) -> None:
        self._become(
            self.native.orient_normals_to_align_with_direction(column("orientation_reference", orientation_reference))
        )

    def orient_normals_towards_camera_location(self, camera_location: ArrayLike = (0.0, 0.0, 0.0)) -> None:
        self._become(self.native.orient_normals_towards_camera_location(column("camera_location", camera_location)))

    def orient_normals_consistent_tangent_plane(
        self, k: int, lambda_penalty: float = 0.0, cos_alpha_tol: float = 1.0
    ) -> None:
        self._become(self.native.orient_normals_consistent_tangent_plane(k, lambda_penalty, cos_alpha_tol))

    def remove_non_finite_points(self, remove_nan: bool = True, remove_infinite: bool = True) -> Self:
        return self._become(self.native.remove_non_finite_points(remove_nan, remove_infinite))

    def remove_duplicated_points(self) -> Self:
        return self._become(self.native.remove_duplicated_points())

    def voxel_down_sample(self, voxel_size: float) -> PointCloud:
        return PointCloud.from_native(self.native.voxel_down_sample(voxel_size))

    def voxel_down_sample_and_trace(
        self, voxel_size: float, min_bound: ArrayLike, max_bound: ArrayLike, approximate_class: bool = False
    ) -> tuple[PointCloud, NDArray[np.int32], list[IntVector]]:
        corners = column("min_bound", min_bound), column("max_bound", max_bound)
        trace = self.native.voxel_down_sample_and_trace(voxel_size, *corners, approximate_class)
        return PointCloud.from_native(trace.cloud), trace.cubic_id, [IntVector(rows) for rows in trace.original_indices]

    def uniform_down_sample(self, every_k_points: int) -> PointCloud:
        return PointCloud.from_native(self.native.uniform_down_sample(every_k_points))

    def random_down_sample(self, sampling_ratio: float) -> PointCloud:
        """Random fraction of the points, seeded by `o3d.utility.random.seed`."""
        return PointCloud.from_native(self.native.random_down_sample(sampling_ratio, next_seed()))

    def farthest_point_down_sample(self, num_samples: int, start_index: int = 0) -> PointCloud:
        return PointCloud.from_native(self.native.farthest_point_down_sample(num_samples, start_index))

    def select_by_index(self, indices: IndicesLike, invert: bool = False) -> PointCloud:
        """The points with these indices, each once and in the order of the cloud, or the others."""
        cloud = self.native
        flags = flagged("indices", indices, len(cloud), f"cloud of {len(cloud)} points")
        return PointCloud.from_native(cloud.select_by_index(np.flatnonzero(flags != invert)))

    def crop(self, bounding_box: BoxLike, invert: bool = False) -> PointCloud:
        return PointCloud.from_native(self.native.crop(unwrap(bounding_box), invert))

    def remove_statistical_outlier(
        self, nb_neighbors: int, std_ratio: float, print_progress: bool = False
    ) -> tuple[PointCloud, list[int]]:
        """The inlier cloud and its point indices."""
        inliers, rows = self.native.remove_statistical_outlier(nb_neighbors, std_ratio, print_progress)
        return PointCloud.from_native(inliers), rows.tolist()

    def remove_radius_outlier(
        self, nb_points: int, radius: float, print_progress: bool = False
    ) -> tuple[PointCloud, list[int]]:
        """The inlier cloud and its point indices."""
        inliers, rows = self.native.remove_radius_outlier(nb_points, radius, print_progress)
        return PointCloud.from_native(inliers), rows.tolist()

    def _smoothed(self, made: Any) -> PointCloud:
        """A smoothed cloud with the covariances of this one, as in Open3D."""
        kept = {name: values for name, values in self.native.arrays.items() if name == "covariances"}
        return PointCloud.from_native(made.with_arrays(made.arrays | kept))

    def smooth_mls(self, search_param: KDTreeSearchParam = SMOOTHING_NEIGHBORS) -> PointCloud:
        return self._smoothed(self.native.smooth_mls(**keywords_of(search_param)))

    def smooth_bilateral(
        self, search_param: KDTreeSearchParam = SMOOTHING_NEIGHBORS, sigma_s: float = 0.05, sigma_r: float = 0.05
    ) -> PointCloud:
        """Smooth along normals, which are estimated from 30 neighbors if missing."""
        search, cloud = keywords_of(search_param), self.native
        cloud = cloud if self.has_normals() else cloud.estimate_normals(radius=None, max_nn=30)
        return self._smoothed(cloud.smooth_bilateral(**search, sigma_s=sigma_s, sigma_r=sigma_r))

    def smooth_laplacian(
        self, iterations: int = 10, lambda_: float = 0.5, knn: int = 20, use_fixed_neighborhoods: bool = False
    ) -> PointCloud:
        return self._smoothed(self.native.smooth_laplacian(iterations, lambda_, knn, use_fixed_neighborhoods))

    def smooth_taubin(
        self,
        iterations: int = 10,
        lambda_: float = 0.5,
        mu: float = -0.53,
        knn: int = 20,
        use_fixed_neighborhoods: bool = False,
    ) -> PointCloud:
        return self._smoothed(self.native.smooth_taubin(iterations, lambda_, mu, knn, use_fixed_neighborhoods))

    def compute_point_cloud_distance(self, target: CloudLike) -> DoubleVector:
        """Distance of each point to the nearest point of another cloud."""
        return DoubleVector(self.native.compute_point_cloud_distance(unwrap(target, PointCloud, "target")))

    def compute_nearest_neighbor_distance(self) -> DoubleVector:
        return DoubleVector(self.native.compute_nearest_neighbor_distance())

    def compute_mahalanobis_distance(self) -> DoubleVector:
        return DoubleVector(self.native.compute_mahalanobis_distance())

    def compute_mean_and_covariance(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Mean (3,) and covariance (3, 3). Zero and the identity without points."""
        return self.native.compute_mean_and_covariance() if self.has_points() else (np.zeros(3), np.eye(3))

    @staticmethod
    def estimate_point_covariances(input: PointCloud, search_param: KDTreeSearchParam = KNN) -> Matrix3dVector:
        """Covariance of each point's neighbors. The cloud is not changed."""
        result = unwrap(input, PointCloud, "input").estimate_covariances(**keywords_of(search_param))
        return Matrix3dVector(result.covariances)

    def cluster_dbscan(self, eps: float, min_points: int, print_progress: bool = False) -> IntVector:
        """A label per point, -1 for noise."""
        return IntVector(self.native.cluster_dbscan(eps, min_points, print_progress))

    def segment_plane(
        self, distance_threshold: float, ransac_n: int, num_iterations: int, probability: float = 0.99999999
    ) -> tuple[NDArray[np.float64], list[int]]:
        """The plane (a, b, c, d) with most inliers, and their indices."""
        plane, rows = self.native.segment_plane(
            distance_threshold, ransac_n, num_iterations, probability, seed=next_seed()
        )
        return plane, rows.tolist()

    def detect_planar_patches(
        self,
        normal_variance_threshold_deg: float = 60,
        coplanarity_deg: float = 75,
        outlier_ratio: float = 0.75,
        min_plane_edge_length: float = 0.0,
        min_num_points: int = 0,
        search_param: KDTreeSearchParam = KNN,
    ) -> list[Any]:
        limits = normal_variance_threshold_deg, coplanarity_deg, outlier_ratio, min_plane_edge_length, min_num_points
        boxes = self.native.detect_planar_patches(*limits, **keywords_of(search_param))
        made = [geometry.OrientedBoundingBox.from_native(box) for box in boxes]
        for box, color in zip(made, itertools.cycle(PATCH_COLORS), strict=False):
            box.color = color
        return made

    def compute_convex_hull(self, joggle_inputs: bool = False) -> tuple[Any, list[int]]:
        """Mesh of the hull, and the indices of its points."""
        hull, rows = self.native.compute_convex_hull(joggle_inputs)
        return geometry.TriangleMesh(hull.vertices, hull.triangles), rows.tolist()

    def hidden_point_removal(self, camera_location: ArrayLike, radius: float) -> tuple[Any, list[int]]:
        """Mesh of the points visible from a camera, and their indices."""
        surface, rows = self.native.hidden_point_removal(column("camera_location", camera_location), radius)
        return geometry.TriangleMesh(surface.vertices, surface.triangles), rows.tolist()
