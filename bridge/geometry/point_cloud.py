"""PointCloud, changed in place as in Open3D: each method is that of `loom.PointCloud` with the same name."""

from __future__ import annotations

from typing import Any, ClassVar, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...pcd import cloud
from .. import geometry
from ..held import Rows, column, ours
from ..indices import flagged
from ..seeds import next_seed
from ..vectors import DoubleVector, IntVector, Matrix3dVector, Vector3dVector
from .bounded import BoundedByBoxes
from .image import below, depth_of
from .search_param import KDTreeSearchParam, KDTreeSearchParamHybrid, KDTreeSearchParamKNN, keywords_of

KNN = KDTreeSearchParamKNN()
NEAR = KDTreeSearchParamHybrid(0.05, 30)
VECTORS = ("normals", "colors", "covariances")


class PointCloud(BoundedByBoxes):
    """Points with normals, colours and covariances: vectors that are assigned, and written to by `np.asarray`.

    Methods that say so change the cloud, the others return a new one. Attributes of files (intensity, labels) travel
    along in the cloud that it holds.
    """

    _kind = cloud.PointCloud
    _arrays: ClassVar = {"points": "points", "normals": "normals", "covariances": "covariances"}

    points = Rows(Vector3dVector)
    normals = Rows(Vector3dVector)
    colors = Rows(Vector3dVector)
    covariances = Rows(Matrix3dVector)

    def __init__(self, points: Any = ()):
        given = ours(points)
        self._held, self._out = given if isinstance(given, cloud.PointCloud) else cloud.PointCloud(), {}
        if isinstance(points, PointCloud):
            self._out = points.__copy__()._out
        elif given is not self._held:
            self.points = given if isinstance(given, np.ndarray | Vector3dVector) else np.asarray(given)

    def _read(self, name: str) -> NDArray[Any]:
        if name not in self._held:
            return np.zeros((0, *getattr(type(self), name).kind._row))
        return getattr(self._held, name)

    def _token(self, ours: Any, name: str) -> tuple[Any, ...] | None:
        if name not in ours:
            return None
        return ours._device_array(name), ours.origin.tobytes() if name == "points" else b""

    def _made(self, changed: list[str]) -> Any:
        count, made = self._count("points"), self._held
        if count == len(made):
            made = made.copy()
            if "points" in changed:
                made.points = np.array(self.points)
        else:
            for name in VECTORS:
                self._vector(name)  # of the old cloud
            changed, made = [*VECTORS], cloud.PointCloud(np.array(self.points), device=made.device)
        for name in (name for name in VECTORS if name in changed):
            if count and len(self._vector(name)) == count:
                setattr(made, name, np.array(self._vector(name)))
            elif name in made:
                made = made.without(name)
        return made

    def has_points(self) -> bool:
        """Whether there are points."""
        return self._count("points") > 0

    def has_normals(self) -> bool:
        """Whether each point has a normal."""
        return self._has("normals")

    def has_colors(self) -> bool:
        """Whether each point has a colour."""
        return self._has("colors")

    def has_covariances(self) -> bool:
        """Whether each point has a covariance."""
        return self._has("covariances")

    def is_empty(self) -> bool:
        """Whether there are no points."""
        return not self.has_points()

    def _has(self, name: str) -> bool:
        return 0 < self._count("points") == self._count(name)

    def __repr__(self) -> str:
        return f"PointCloud with {self._count('points')} points."

    def __add__(self, other: Any) -> PointCloud:
        return PointCloud._of(self._ours + ours(other, PointCloud, "other"))

    def __iadd__(self, other: Any) -> Self:
        return self._become(self._ours + ours(other, PointCloud, "other"))

    # ----------------------------------------------------------------------------------------------- made of images

    @classmethod
    def create_from_depth_image(
        cls,
        depth: Any,
        intrinsic: Any,
        extrinsic: ArrayLike | None = None,
        depth_scale: float = 1000.0,
        depth_trunc: float = 1000.0,
        stride: int = 1,
        project_valid_depth_only: bool = True,
    ) -> Self:
        """The points that a depth image shows; `extrinsic` is world to camera."""
        pixels, farthest = depth_of(depth), below(depth_trunc)
        made = cloud.PointCloud.create_from_depth_image(
            pixels, ours(intrinsic), extrinsic, depth_scale, farthest, stride, project_valid_depth_only
        )
        return cls._of(made)

    @classmethod
    def create_from_rgbd_image(
        cls, image: Any, intrinsic: Any, extrinsic: ArrayLike | None = None, project_valid_depth_only: bool = True
    ) -> Self:
        """The points that an RGBDImage shows, in its colours; `extrinsic` is world to camera."""
        made = cloud.PointCloud.create_from_rgbd_image(
            ours(image), ours(intrinsic), extrinsic, project_valid_depth_only
        )
        return cls._of(made)

    # --------------------------------------------------------------------------------------- that change the cloud

    def paint_uniform_color(self, color: ArrayLike) -> Self:
        """Give all points one colour."""
        return self._become(self._ours.paint_uniform_color(column("color", color)))

    def estimate_normals(self, search_param: KDTreeSearchParam = KNN, fast_normal_computation: bool = True) -> None:
        """Fit normals, to the side of earlier ones; there is one way to do it, fast and exact."""
        self._become(self._ours.estimate_normals(**keywords_of(search_param)))

    def estimate_covariances(self, search_param: KDTreeSearchParam = KNN) -> None:
        """Give each point the covariance of its neighbours."""
        self._become(self._ours.estimate_covariances(**keywords_of(search_param)))

    def normalize_normals(self) -> Self:
        """Bring normals to length 1, if there are some."""
        return self._become(self._ours.normalize_normals()) if self.has_normals() else self

    def orient_normals_to_align_with_direction(self, orientation_reference: ArrayLike = (0.0, 0.0, 1.0)) -> None:
        """Turn normals to the side of a direction."""
        self._become(
            self._ours.orient_normals_to_align_with_direction(column("orientation_reference", orientation_reference))
        )

    def orient_normals_towards_camera_location(self, camera_location: ArrayLike = (0.0, 0.0, 0.0)) -> None:
        """Turn normals towards a point."""
        self._become(self._ours.orient_normals_towards_camera_location(column("camera_location", camera_location)))

    def orient_normals_consistent_tangent_plane(
        self, k: int, lambda_penalty: float = 0.0, cos_alpha_tol: float = 1.0
    ) -> None:
        """Turn normals to one side of the surface."""
        self._become(self._ours.orient_normals_consistent_tangent_plane(k, lambda_penalty, cos_alpha_tol))

    def remove_non_finite_points(self, remove_nan: bool = True, remove_infinite: bool = True) -> Self:
        """Drop points that are no place."""
        return self._become(self._ours.remove_non_finite_points(remove_nan, remove_infinite))

    def remove_duplicated_points(self) -> Self:
        """Keep one of equal points."""
        return self._become(self._ours.remove_duplicated_points())

    # ---------------------------------------------------------------------------------------- that give other clouds

    def voxel_down_sample(self, voxel_size: float) -> PointCloud:
        """One point a voxel, the mean of its points."""
        return PointCloud._of(self._ours.voxel_down_sample(voxel_size))

    def voxel_down_sample_and_trace(
        self, voxel_size: float, min_bound: ArrayLike, max_bound: ArrayLike, approximate_class: bool = False
    ) -> tuple[PointCloud, NDArray[np.int32], list[IntVector]]:
        """As `voxel_down_sample`, with the points of each voxel."""
        corners = column("min_bound", min_bound), column("max_bound", max_bound)
        trace = self._ours.voxel_down_sample_and_trace(voxel_size, *corners, approximate_class)
        return PointCloud._of(trace.cloud), trace.cubic_id, [IntVector(rows) for rows in trace.original_indices]

    def uniform_down_sample(self, every_k_points: int) -> PointCloud:
        """Each k-th point."""
        return PointCloud._of(self._ours.uniform_down_sample(every_k_points))

    def random_down_sample(self, sampling_ratio: float) -> PointCloud:
        """A share of the points, by `o3d.utility.random.seed`."""
        return PointCloud._of(self._ours.random_down_sample(sampling_ratio, next_seed()))

    def farthest_point_down_sample(self, num_samples: int, start_index: int = 0) -> PointCloud:
        """Points far from each other."""
        return PointCloud._of(self._ours.farthest_point_down_sample(num_samples, start_index))

    def select_by_index(self, indices: Any, invert: bool = False) -> PointCloud:
        """The points with these indices, each once and in the order of the cloud, or the others."""
        cloud = self._ours
        flags = flagged("indices", indices, len(cloud), f"cloud of {len(cloud)} points")
        return PointCloud._of(cloud.select_by_index(np.flatnonzero(flags != invert)))

    def crop(self, bounding_box: Any, invert: bool = False) -> PointCloud:
        """The points in a box, or the others."""
        return PointCloud._of(self._ours.crop(ours(bounding_box), invert))

    def remove_statistical_outlier(
        self, nb_neighbors: int, std_ratio: float, print_progress: bool = False
    ) -> tuple[PointCloud, list[int]]:
        """The cloud without points that lie far from their neighbours, and the numbers of those that stay."""
        kept, rows = self._ours.remove_statistical_outlier(nb_neighbors, std_ratio, print_progress)
        return PointCloud._of(kept), rows.tolist()

    def remove_radius_outlier(
        self, nb_points: int, radius: float, print_progress: bool = False
    ) -> tuple[PointCloud, list[int]]:
        """The cloud without points that have few neighbours, and the numbers of those that stay."""
        kept, rows = self._ours.remove_radius_outlier(nb_points, radius, print_progress)
        return PointCloud._of(kept), rows.tolist()

    def smooth_mls(self, search_param: KDTreeSearchParam = NEAR) -> PointCloud:
        """Points moved onto planes of their neighbours."""
        return PointCloud._of(self._ours.smooth_mls(**keywords_of(search_param)))

    def smooth_bilateral(
        self, search_param: KDTreeSearchParam = NEAR, sigma_s: float = 0.05, sigma_r: float = 0.05
    ) -> PointCloud:
        """Points moved along normals, edges kept."""
        reach = keywords_of(search_param)
        return PointCloud._of(self._ours.smooth_bilateral(**reach, sigma_s=sigma_s, sigma_r=sigma_r))

    def smooth_laplacian(
        self, iterations: int = 10, lambda_: float = 0.5, knn: int = 20, use_fixed_neighborhoods: bool = False
    ) -> PointCloud:
        """Points moved towards the mean of their neighbours."""
        return PointCloud._of(self._ours.smooth_laplacian(iterations, lambda_, knn, use_fixed_neighborhoods))

    def smooth_taubin(
        self,
        iterations: int = 10,
        lambda_: float = 0.5,
        mu: float = -0.53,
        knn: int = 20,
        use_fixed_neighborhoods: bool = False,
    ) -> PointCloud:
        """As `smooth_laplacian`, without shrinking."""
        return PointCloud._of(self._ours.smooth_taubin(iterations, lambda_, mu, knn, use_fixed_neighborhoods))

    # --------------------------------------------------------------------------------------------- that measure

    def compute_point_cloud_distance(self, target: Any) -> DoubleVector:
        """The distance of each point to the nearest of another cloud."""
        return DoubleVector(self._ours.compute_point_cloud_distance(ours(target, PointCloud, "target")))

    def compute_nearest_neighbor_distance(self) -> DoubleVector:
        """The distance of each point to its nearest."""
        return DoubleVector(self._ours.compute_nearest_neighbor_distance())

    def compute_mahalanobis_distance(self) -> DoubleVector:
        """The Mahalanobis distance of each point to the cloud."""
        return DoubleVector(self._ours.compute_mahalanobis_distance())

    def compute_mean_and_covariance(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Mean [3] and covariance [3, 3]; zero and the identity without points."""
        return self._ours.compute_mean_and_covariance() if self.has_points() else (np.zeros(3), np.eye(3))

    @staticmethod
    def estimate_point_covariances(input: PointCloud, search_param: KDTreeSearchParam = KNN) -> Matrix3dVector:
        """The covariance of each point's neighbours; the cloud stays as it is."""
        found = ours(input, PointCloud, "input").estimate_covariances(**keywords_of(search_param))
        return Matrix3dVector(found.covariances)

    def cluster_dbscan(self, eps: float, min_points: int, print_progress: bool = False) -> IntVector:
        """A label a point, -1 for noise."""
        return IntVector(self._ours.cluster_dbscan(eps, min_points, print_progress))

    def segment_plane(
        self, distance_threshold: float, ransac_n: int, num_iterations: int, probability: float = 0.99999999
    ) -> tuple[NDArray[np.float64], list[int]]:
        """The plane (a, b, c, d) of most points, and their numbers."""
        plane, rows = self._ours.segment_plane(
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
        """Flat boxes around the planes of the cloud."""
        limits = normal_variance_threshold_deg, coplanarity_deg, outlier_ratio, min_plane_edge_length, min_num_points
        found = self._ours.detect_planar_patches(*limits, **keywords_of(search_param))
        return [geometry.OrientedBoundingBox._of(box) for box in found]

    def compute_convex_hull(self, joggle_inputs: bool = False) -> tuple[Any, list[int]]:
        """A mesh of the hull, and the numbers of the points on it."""
        hull, rows = self._ours.compute_convex_hull(joggle_inputs)
        return geometry.TriangleMesh(hull.vertices, hull.triangles), rows.tolist()

    def hidden_point_removal(self, camera_location: ArrayLike, radius: float) -> tuple[Any, list[int]]:
        """A mesh of the points that a camera sees, and their numbers."""
        surface, rows = self._ours.hidden_point_removal(column("camera_location", camera_location), radius)
        return geometry.TriangleMesh(surface.vertices, surface.triangles), rows.tolist()
