"""Records of the operations on clouds. digests.py runs them on every cloud."""

from __future__ import annotations

import pickle
import tempfile
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import scenes
from digest_scenes import HEIGHT, WIDTH, SampledSurface, about, loom, pose_of, reg
from operation import Operation, records


def there_and_back(value: Any, ending: str, write: str, read: str, **options: Any) -> Any:
    """A value after writing and reading a file."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"file{ending}"
        getattr(loom(), write)(path, value, **options)
        return getattr(loom(), read)(path)


def cloud_file(cloud: Any, ending: str, **options: Any) -> Any:
    return there_and_back(cloud, ending, "write_point_cloud", "read_point_cloud", **options)


def with_common_arrays(*clouds: Any) -> list[Any]:
    """The clouds without the arrays that only some of them have."""
    names = set.intersection(*(set(cloud.arrays) for cloud in clouds))
    return [cloud.without(*(name for name in cloud.arrays if name not in names)) for cloud in clouds]


def ground_of(p: SampledSurface, **options: Any) -> Any:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # the surface is steeper than the slope
        return loom().classify_ground(p.cloud, 4 * p.spacing, 0.05, 30 * p.spacing, p.spacing, **options)


def alpha_shape(p: SampledSurface, alpha: Any, **options: Any) -> Any:
    return loom().TriangleMesh.create_from_point_cloud_alpha_shape(p.cloud, alpha, **options)


def detail_tree(p: SampledSurface) -> Any:
    from pointloom.visualization.viewer.detail_tree import DetailTree

    tree = DetailTree.from_cloud(p.cloud)
    return [tree.counts, tree.levels, tree.middles, *(tree.indices_of(i) for i in range(len(tree)))]


def moved_splats(p: SampledSurface) -> Any:
    cloud = p.cloud.remove_non_finite_points()
    rng, count = np.random.default_rng(0), len(cloud)
    shape = [np.exp(rng.normal(-3, 1, (count, 3))), rng.normal(size=(count, 4)), rng.uniform(0.01, 0.99, count)]
    splats = loom().GaussianSplats(cloud.points, *shape, rng.normal(size=(count, 9, 3)), device=cloud.device)
    return splats.clean(min_opacity=0.1, max_scale=0.2).transform(p.pose).cloud


def search(p: SampledSurface) -> Any:
    return loom().NearestNeighborSearch(p.cloud)


def icp(p: SampledSurface, method: str = "PointToPoint", **options: Any) -> Any:
    """ICP with an estimator whose options are given by keyword."""
    estimation = getattr(reg(), f"TransformationEstimation{method}")(**options)
    return reg().registration_icp(p.source, p.facing, p.max_distance, None, estimation)


def ndt(p: SampledSurface, **options: Any) -> Any:
    """NDT with options given by keyword."""
    option = reg().NormalDistributionsTransformOption(12 * p.spacing, **options)
    return reg().registration_ndt(p.source, p.facing, option)


def from_poses(p: SampledSurface) -> list[Any]:
    """ICP from three poses at once."""
    starts = [about(p.middle, pose_of(degrees, np.zeros(3))) for degrees in (-1.0, 0.0, 3.0)]
    plane = reg().TransformationEstimationPointToPlane()
    return reg().registration_icp_batch(p.source, p.facing, p.max_distance, np.array(starts), plane)


def halved(p: SampledSurface) -> Any:
    """The cloud with every second point classified as ground."""
    cloud = p.cloud.copy()
    cloud["classification"] = np.arange(len(cloud)) % 2 + 1
    return cloud


def depth_lens(p: SampledSurface) -> Any:
    return loom().PinholeCameraIntrinsic(WIDTH, HEIGHT, 150, 150, WIDTH / 2, HEIGHT / 2)


SIZE = (WIDTH, HEIGHT)
CALLS: dict[str, Callable[[SampledSurface], Any]] = {
    "voxel_down_sample": lambda p: p.facing.voxel_down_sample(4 * p.spacing),
    "voxel_down_sample, nearest": lambda p: p.cloud.voxel_down_sample(4 * p.spacing, reduction="nearest"),
    "thin": lambda p: p.cloud.thin(4 * p.spacing),
    "voxel_down_sample_and_trace": lambda p: p.cloud.voxel_down_sample_and_trace(4 * p.spacing),
    "voxel_down_sample_and_trace, box": lambda p: p.cloud.voxel_down_sample_and_trace(
        4 * p.spacing, p.middle - p.size, p.middle + p.size, approximate_class=True
    ),
    "uniform_down_sample": lambda p: p.facing.uniform_down_sample(5),
    "random_down_sample": lambda p: p.facing.random_down_sample(0.3, seed=3),
    "farthest_point_down_sample": lambda p: p.cloud.farthest_point_down_sample(min(150, len(p.cloud)), 1),
    "farthest_point_indices": lambda p: p.cloud.farthest_point_indices(min(50, len(p.cloud)), 2),
    "select_by_index": lambda p: p.facing.select_by_index(np.arange(0, len(p.cloud), 3), invert=True),
    "select_by_mask": lambda p: p.facing.select_by_mask(np.arange(len(p.cloud)) % 3 == 0),
    "crop, box": lambda p: p.cloud.crop(p.box),
    "crop, box inverted": lambda p: p.cloud.crop(p.box, invert=True),
    "crop, turned box": lambda p: p.cloud.crop(p.rotated_box),
    "crop, polygon": lambda p: p.cloud.crop(p.polygon),
    "crop_point_cloud inverted": lambda p: p.polygon.crop_point_cloud(p.cloud, invert=True),
    "crop_in_polygon": lambda p: p.polygon.crop_in_polygon(p.cloud),
    "get_point_indices_within_bounding_box": lambda p: [
        box.get_point_indices_within_bounding_box(points)
        for box in (p.box, p.rotated_box)
        for points in (p.cloud, p.cloud.points)
    ],
    "remove_non_finite_points": lambda p: [
        p.cloud.remove_non_finite_points(remove_nan=nan, remove_infinite=infinite)
        for nan, infinite in ((True, True), (True, False), (False, True))
    ],
    "remove_duplicated_points": lambda p: p.cloud.remove_duplicated_points(),
    "paint_uniform_color": lambda p: p.cloud.paint_uniform_color([0.1, 0.5, 1]),
    "+": lambda p: sum(with_common_arrays(p.cloud, p.other)),
    "concatenate": lambda p: loom().PointCloud.concatenate(with_common_arrays(p.facing, p.other, p.cloud)),
    "splats, cleaned and moved": lambda p: moved_splats(p),
    "transform": lambda p: p.facing.estimate_covariances(max_nn=8).transform(p.pose),
    "estimate_normals, knn": lambda p: p.cloud.estimate_normals(max_nn=15),
    "estimate_normals, radius": lambda p: p.cloud.estimate_normals(radius=3 * p.spacing, max_nn=None),
    "estimate_normals, hybrid": lambda p: p.cloud.estimate_normals(radius=3 * p.spacing, max_nn=20),
    "estimate_normals, again": lambda p: p.facing.flip_normals().estimate_normals(max_nn=30),
    "estimate_covariances, knn": lambda p: p.cloud.estimate_covariances(max_nn=15),
    "estimate_covariances, radius": lambda p: p.cloud.estimate_covariances(radius=3 * p.spacing, max_nn=None),
    "estimate_covariances, hybrid": lambda p: p.cloud.estimate_covariances(radius=3 * p.spacing, max_nn=20),
    "flip_normals": lambda p: p.facing.flip_normals(),
    "normalize_normals": lambda p: p.facing.normalize_normals(),
    "orient_normals_to_align_with_direction": lambda p: p.facing.orient_normals_to_align_with_direction([0.1, 0.2, -1]),
    "orient_normals_towards_camera_location": lambda p: p.facing.orient_normals_towards_camera_location(p.middle),
    "normal_disagreement": Operation(
        lambda p: [p.facing.normal_disagreement(k) for k in (1, 12)], neighbor_tolerance=2e-3
    ),
    "orient_normals_consistent_tangent_plane": lambda p: p.facing.orient_normals_consistent_tangent_plane(12),
    "orient_normals_consistent_tangent_plane, penalty": lambda p: p.facing.orient_normals_consistent_tangent_plane(
        8, 0.5, 0.9
    ),
    "compute_point_cloud_distance": lambda p: p.cloud.compute_point_cloud_distance(p.other),
    "compute_nearest_neighbor_distance": lambda p: p.cloud.compute_nearest_neighbor_distance(),
    "compute_mean_and_covariance": lambda p: p.cloud.compute_mean_and_covariance(),
    "compute_mahalanobis_distance": lambda p: p.cloud.compute_mahalanobis_distance(),
    "compute_metrics": lambda p: loom().compute_metrics(p.cloud, p.other, [0.5 * p.spacing, 2 * p.spacing]),
    "m3c2": lambda p: loom().m3c2(
        p.cloud,
        p.other,
        normal_radii=[3 * p.spacing, 5 * p.spacing],
        cylinder_radius=3 * p.spacing,
        max_distance=8 * p.spacing,
        core_points=p.cloud.uniform_down_sample(3),
    ),
    "knn_search": lambda p: search(p).knn_search(p.other, 8),
    "knn_search, array": lambda p: search(p).knn_search(p.other.points[::3], 40),
    "hybrid_search": lambda p: search(p).hybrid_search(p.other, 2 * p.spacing, 10),
    "radius_search": lambda p: search(p).radius_search(p.other.uniform_down_sample(4), 2 * p.spacing),
    "remove_statistical_outlier": lambda p: p.cloud.remove_statistical_outlier(20, 1.5),
    "remove_radius_outlier": lambda p: p.cloud.remove_radius_outlier(10, 2 * p.spacing),
    "cluster_dbscan": lambda p: p.cloud.cluster_dbscan(1.3 * p.spacing, 8),
    "cluster_dbscan, one point": lambda p: p.cloud.cluster_dbscan(0.8 * p.spacing, 1),
    "cluster_euclidean": lambda p: p.cloud.cluster_euclidean(0.9 * p.spacing),
    "cluster_euclidean, sizes": lambda p: p.cloud.cluster_euclidean(0.9 * p.spacing, 5, 2000),
    "segment_plane": lambda p: p.cloud.segment_plane(p.spacing, 3, 200),
    "segment_plane, 6 points": lambda p: p.cloud.segment_plane(p.spacing, 6, 100, probability=0.999, seed=5),
    "segment_planes": lambda p: p.cloud.segment_planes(p.spacing, max_planes=3),
    "region_growing": lambda p: p.facing.region_growing(12.0, 0.02, 10, max_nn=15),
    "detect_planar_patches": lambda p: p.facing.detect_planar_patches(max_nn=20),
    "hidden_point_removal": lambda p: p.cloud.hidden_point_removal(p.above(1.5), 150 * p.size),
    "compute_convex_hull": lambda p: p.cloud.compute_convex_hull(),
    "compute_convex_hull, joggled": lambda p: p.cloud.compute_convex_hull(joggle_inputs=True),
    "alpha_shape": lambda p: alpha_shape(p, 2 * p.spacing),
    "alpha_shape, several": lambda p: alpha_shape(p, [1.5 * p.spacing, 3 * p.spacing], return_tetrahedra=True),
    "get_axis_aligned_bounding_box": lambda p: p.cloud.get_axis_aligned_bounding_box(),
    "get_oriented_bounding_box": lambda p: p.cloud.get_oriented_bounding_box(),
    "get_oriented_bounding_box, robust": lambda p: p.cloud.get_oriented_bounding_box(robust=True),
    "get_minimal_oriented_bounding_box": lambda p: p.cloud.get_minimal_oriented_bounding_box(),
    "compute_fpfh_feature, hybrid": lambda p: loom().compute_fpfh_feature(p.facing, radius=3 * p.spacing, max_nn=50),
    "compute_fpfh_feature, knn": lambda p: loom().compute_fpfh_feature(p.facing, max_nn=20),
    "compute_fpfh_feature, radius": lambda p: loom().compute_fpfh_feature(
        p.facing, radius=1.5 * p.spacing, max_nn=None
    ),
    "compute_fpfh_feature, some": lambda p: loom().compute_fpfh_feature(
        p.facing, radius=3 * p.spacing, max_nn=50, indices=np.arange(0, len(p.facing), 11)
    ),
    "compute_iss_keypoints": lambda p: loom().compute_iss_keypoints(p.cloud, return_indices=True),
    "compute_iss_keypoints, radii": lambda p: loom().compute_iss_keypoints(p.cloud, 6 * p.spacing, 5 * p.spacing),
    "compute_eigen_features, knn": lambda p: loom().compute_eigen_features(p.cloud, max_nn=20),
    "compute_eigen_features, radius": lambda p: loom().compute_eigen_features(
        p.cloud, radius=2 * p.spacing, max_nn=None
    ),
    "estimate_curvature": lambda p: loom().estimate_curvature(p.cloud, radius=4 * p.spacing, max_nn=20),
    "create_from_point_cloud_ball_pivoting": lambda p: loom().TriangleMesh.create_from_point_cloud_ball_pivoting(
        p.facing
    ),
    "create_from_point_cloud_ball_pivoting, radii": lambda p: loom().TriangleMesh.create_from_point_cloud_ball_pivoting(
        p.facing, [1.2 * p.spacing, 2.5 * p.spacing]
    ),
    "smooth_mls": lambda p: p.cloud.smooth_mls(radius=3.4 * p.spacing, max_nn=30),
    "smooth_mls, knn": lambda p: p.facing.smooth_mls(radius=None, max_nn=15),
    "smooth_bilateral": lambda p: p.facing.smooth_bilateral(
        radius=3 * p.spacing, max_nn=30, sigma_s=2 * p.spacing, sigma_r=p.spacing
    ),
    "smooth_laplacian": lambda p: p.cloud.smooth_laplacian(2),
    "smooth_laplacian, fixed": lambda p: p.cloud.smooth_laplacian(3, 0.3, 12, use_fixed_neighborhoods=True),
    "smooth_taubin": lambda p: p.cloud.smooth_taubin(2),
    "smooth_taubin, fixed": lambda p: p.cloud.smooth_taubin(3, knn=12, use_fixed_neighborhoods=True),
    "classify_ground": lambda p: ground_of(p),
    "classify_ground, corner": Operation(  # coarser grids begin at the corner
        lambda p: ground_of(p, corner=(0, 0)), offset_tolerance=None
    ),
    "height_above_ground": lambda p: loom().height_above_ground(halved(p), reach=20 * p.spacing, cell=2 * p.spacing),
    "rasterize": lambda p: loom().rasterize(halved(p), 3 * p.spacing, "chm").values,
    "rasterize, triangles": Operation(  # heights are float32
        lambda p: loom().rasterize(halved(p), 3 * p.spacing, "dtm", method="tin").values, offset_tolerance=1e-4
    ),
    "project_to_depth_image": lambda p: p.cloud.project_to_depth_image(
        *SIZE, depth_lens(p), p.camera, depth_max=2 * p.size
    ),
    "project_to_rgbd_image": lambda p: p.cloud.paint_uniform_color([1, 0.5, 0]).project_to_rgbd_image(
        *SIZE, depth_lens(p), p.camera, depth_max=2 * p.size
    ),
    "detail tree": detail_tree,
    "pickle": lambda p: pickle.loads(pickle.dumps(p.facing)),
    "write and read .npz": lambda p: cloud_file(p.facing, ".npz"),
    "write and read .ply": lambda p: cloud_file(p.facing, ".ply"),
    "icp, point to point": lambda p: icp(p),
    "icp, point to plane": lambda p: icp(p, "PointToPlane"),
    "icp, symmetric": lambda p: icp(p, "Symmetric"),
    "icp, generalized": lambda p: icp(p, "ForGeneralizedICP"),
    "icp, generalized, own covariances": lambda p: reg().registration_icp(
        p.other.transform(scenes.inverse(p.pose)),
        p.cloud,
        p.max_distance,
        None,
        reg().TransformationEstimationForGeneralizedICP(),
    ),
    "icp, generalized, voxels": lambda p: icp(p, "ForGeneralizedICP", voxel_size=4 * p.spacing),
    "registration_ndt": lambda p: ndt(p),
    "registration_ndt, one voxel": lambda p: ndt(p, neighbor_search_type=0, min_points_per_voxel=4),
    "registration_icp_batch, three poses": from_poses,
    "evaluate_registration": lambda p: reg().evaluate_registration(p.source, p.cloud, p.max_distance),
    "get_information_matrix_from_point_clouds": Operation(  # rotations are about the origin
        lambda p: reg().get_information_matrix_from_point_clouds(p.source, p.cloud, p.max_distance, p.pose),
        offset_tolerance=None,
    ),
    "assess_registration": Operation(
        lambda p: reg().assess_registration(p.source, p.cloud, p.pose, p.max_distance), counts_host_work=True
    ),
}
ON_CLOUDS = records(CALLS)
