"""Invalid arguments are rejected by an error that names them: one table for all operations on clouds.

Values that are not numbers, or not finite, are tested in test_hostile_arguments.py.
"""

import re

import numpy as np
import pytest

import pointloom as loom

CAMERA = loom.PinholeCameraIntrinsic(3, 2, 1, 1, 0, 0)
NAMES = {
    "loom": loom,
    "np": np,
    "nan": np.nan,
    "inf": np.inf,
    "camera": CAMERA,
    "cloud": loom.PointCloud(np.zeros((3, 3)), normals=np.ones((3, 3))),
    "bare": loom.PointCloud(np.zeros((3, 3))),
    "random": loom.PointCloud(np.random.default_rng(0).random((10, 3)), normals=np.ones((10, 3))),
    "gap": loom.PointCloud([[0, 0, 0], [nan := np.nan, 0, 0], [1, 1, 1]]),
    "far": loom.PointCloud([[0, 0, 0], [1e9, 1e9, 1e9]]),
    "pair": loom.PointCloud([[0, 0, 0], [1, 1, 1]]),
    "search": loom.NearestNeighborSearch(np.zeros((2, 3))),
    "selected": loom.PointCloud(np.arange(30.0).reshape(10, 3)),
    "square": [[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]],
    "project": lambda **given: loom.PointCloud([[0, 0, 1.0]]).project_to_depth_image(
        **{"width": 3, "height": 2, "intrinsic": CAMERA} | given
    ),
    "depth_cloud": lambda **given: loom.PointCloud.create_from_depth_image(
        **{"depth": np.full((2, 3), 1000, np.uint16), "intrinsic": CAMERA} | given
    ),
    "changed": lambda **given: loom.m3c2(
        *(loom.PointCloud(np.random.default_rng(seed).random((50, 3)) * 30) for seed in (0, 1)),
        **{"normal_radii": 1.0, "cylinder_radius": 1.0, "max_distance": 2.0} | given,
    ),
    "raster": lambda cell=1.0, **given: loom.rasterize(
        loom.PointCloud(np.random.default_rng(0).random((5, 3)) * 100, classification=[2] * 5), cell, **given
    ),
    "grid": loom.rasterize(loom.PointCloud(np.random.default_rng(0).random((20, 3))), 0.25, "dsm"),
    "lines": loom.LineSet([[0, 0, 0], [1, 0, 0]], [[0, 1]]),
    "tilted": loom.OrientedBoundingBox([1, 0, 0], np.eye(3), [1, 1, 1]),
    "stored": lambda **given: loom.GaussianSplats.from_cloud(
        loom.PointCloud(
            np.zeros((2, 3)),
            **{"f_dc": np.zeros((2, 3)), "opacity": np.zeros(2), "scale": np.zeros((2, 3)), "rot": np.ones((2, 4))}
            | given,
        )
    ),
    "splats": lambda **given: loom.GaussianSplats(
        **{"centers": [[0, 0, 0]] * 2, "scales": [[1, 1, 1]] * 2, "rotations": [[1, 0, 0, 0]] * 2}
        | {"opacities": [0.5, 0.5], "harmonics": [[0, 0, 0]] * 2}
        | given
    ),
}
VALUES = """
loom.profile(grid, [[0, 0], [1, 1]], width=1.0) | width: expected None for a raster
loom.profile(grid, [[0, 0], [1, 1]], spacing=1e-9) | spacing: 1e-09 gives more than 2^24 positions
loom.profile(grid, [[1, 1], [1, 1]]) | line: expected two different vertices
loom.profile(cloud, [[0, 0], [1, 1]]) | width: expected the width of the strip for a cloud, got None
loom.profile(cloud, [[0, 0], [1, 1]], width=1.0, spacing=1.0) | spacing: expected None for a cloud
loom.profile(cloud, [[0, 0, 0], [1, 1, 1]], width=1.0) | line: expected two or more vertices, shape (m, 2)
grid.contour_lines(interval=1e-9) | interval: 1e-09 gives more than
grid.contour_lines(levels=np.linspace(0, 1, 200_000)) | levels: expected at most
lines.get_line_coordinate(1) | line_index: expected one of 1 lines, got 1
tilted.scale(1e300) | scale: expected a factor that keeps the box within
tilted.scale(2, [1e300, 0, 0]) | center
cloud.region_growing(min_cluster_size=5, max_cluster_size=4) | max_cluster_size: expected at least min_cluster_size = 5
cloud.region_growing(max_nn=1) | max_nn
stored(scale=np.zeros((2, 2))) | cloud: expected scale of shape ['n', 3]
stored(opacity=np.zeros((2, 1))) | cloud: expected opacity of shape ['n']
stored(f_rest=np.zeros((2, 10))) | cloud: expected f_rest of 9, 24, 45 or 72 columns, got [2, 10]
stored(f_rest=np.zeros((2, 6))) | cloud: expected f_rest of 9, 24, 45 or 72 columns, got [2, 6]
loom.GaussianSplats.concatenate([]) | splats: expected at least one set, got none
loom.rasterize(loom.PointCloud(np.eye(3), intensity=np.ones((3, 2))), 1.0, "intensity") | intensity: expected one number
loom.PointCloud(np.zeros((3, 100))) | points: expected shape [n, 3], got [3, 100]
loom.PointCloud([[1e300, 0, 0], [-1e300, 0, 0]]) | beyond the float32 range
loom.PointCloud(origin=[0, 0]) | origin
cloud.from_dlpack(np.zeros((4, 2), np.float32)) | points: expected shape [n, 3], got [4, 2]
cloud.from_dlpack(np.zeros((8, 3), np.float32)[::2]) | points: expected a contiguous array
cloud.from_dlpack(np.zeros((4, 3), np.float32), label=np.arange(5)) | label
cloud.from_dlpack(np.zeros((4, 3), np.float32), cube=np.zeros((4, 2, 2))) | cube
cloud.from_dlpack(np.zeros((4, 3), np.float32), origin=[nan, 0, 0]) | origin
loom.PointCloud([[0, 0, 0]], normals=np.zeros((3, 3))) | normals: expected shape [1, 3] as the cloud has 1 points
loom.PointCloud([[0, 0, 0]], normals=[[1e39, 0, 0]]) | normals: 1e+39 is beyond
loom.PointCloud([[0, 0, 0]], colors=np.zeros((2, 3))) | colors: expected shape
loom.PointCloud([[0, 0, 0]], colors=[[1.01] * 3]) | colors: expected 0..1, got 1.01..1.01; divide 8-bit
loom.PointCloud([[0, 0, 0]], colors=[[nan] * 3]) | colors: expected 0..1
loom.PointCloud([[0, 0, 0]], ring=[1, 2]) | ring: expected shape [1] or [1, c]
loom.PointCloud([[1, 2, 3]], unit='ell') | unit
cloud.paint_uniform_color([255, 0, 0]) | divide 8-bit colors by 255
cloud.concatenate([]) | clouds
cloud.to("cpu", arrays="tensorflow") | arrays: expected one of numpy, warp, torch, cupy, jax
cloud.translate([1, 2]) | translation
cloud.rotate(90) | R: expected shape [3, 3], got []: a rotation matrix; scipy
cloud.__array__(copy=False) | so its points are copied
cloud.rotate([[2, 0, 0], [0, 1, 0], [0, 0, 1]]) | R: expected a rigid motion
cloud.scale(0) | scale
cloud.scale(2, [0, 0]) | center
bare.transform(np.diag([1.0, 1, 1, 2])) | transformation
cloud.transform(np.diag([0.0, 1, 1, 1])) | transformation
cloud.cluster_dbscan(0, 1) | eps
cloud.cluster_dbscan(1.0, 0) | min_points
cloud.cluster_euclidean(0) | tolerance
cloud.cluster_euclidean(1, 0) | min_cluster_size
cloud.cluster_euclidean(1, 1, 0) | max_cluster_size
cloud.cluster_euclidean(1, 5, 4) | max_cluster_size: expected at least min_cluster_size = 5
cloud.estimate_covariances(radius=None, max_nn=None) | radius, max_nn: give at least one
cloud.estimate_covariances(radius=0) | radius
cloud.estimate_covariances(max_nn=0) | max_nn
cloud.estimate_normals(radius=None, max_nn=None) | radius, max_nn: give at least one
cloud.estimate_normals(radius=0.0) | radius
cloud.estimate_normals(max_nn=0) | max_nn
cloud.orient_normals_to_align_with_direction((nan, 0, 0)) | expected finite numbers
cloud.orient_normals_towards_camera_location((0, inf, 0)) | expected finite numbers
cloud.orient_normals_consistent_tangent_plane(0) | k
cloud.orient_normals_consistent_tangent_plane(5, lambda_penalty=-1) | lambda_penalty
cloud.orient_normals_consistent_tangent_plane(5, cos_alpha_tol=1.5) | cos_alpha_tol: expected a cosine
bare.orient_normals_consistent_tangent_plane(5) | no normals: call cloud = cloud.estimate_normals()
bare.normalize_normals() | no normals
bare.flip_normals() | no normals
bare.normal_disagreement() | no normals
cloud.normal_disagreement(0) | max_nn
bare.detect_planar_patches() | no normals
bare.region_growing() | no normals
loom.detect_shapes(bare) | no normals
loom.detect_shapes(cloud, kinds=('cube',)) | kinds
bare.project_to_rgbd_image(3, 2, camera) | no colors: assign cloud.colors
cloud.remove_statistical_outlier(0, 1.0) | nb_neighbors
cloud.remove_statistical_outlier(5, 0.0) | std_ratio
cloud.remove_radius_outlier(0, 1.0) | nb_points
cloud.remove_radius_outlier(5, 0.0) | radius
random.detect_planar_patches(normal_variance_threshold_deg=91) | normal_variance_threshold_deg
random.detect_planar_patches(outlier_ratio=1.5) | outlier_ratio
random.detect_planar_patches(min_plane_edge_length=-0.1) | min_plane_edge_length
random.detect_planar_patches(min_num_points=-1) | min_num_points
random.detect_planar_patches(max_nn=1) | max_nn
random.detect_planar_patches(radius=0.0) | radius
random.segment_plane(distance_threshold=0.0) | distance_threshold
random.segment_plane(ransac_n=2) | ransac_n
random.segment_plane(ransac_n=11) | ransac_n: expected at most the 10 finite points of the cloud, got 11
random.segment_plane(num_iterations=0) | num_iterations
random.segment_plane(probability=1.1) | probability
random.segment_plane(seed=2**31) | seed
random.segment_planes(min_points=0) | min_points
random.segment_planes(max_planes=0) | max_planes
cloud.smooth_mls(radius=None, max_nn=None) | radius, max_nn: give at least one
cloud.smooth_mls(radius=0.0) | radius
cloud.smooth_mls(max_nn=0) | max_nn
cloud.smooth_bilateral(sigma_s=0) | sigma_s
cloud.smooth_bilateral(sigma_r=-1) | sigma_r
cloud.smooth_laplacian(iterations=-1) | iterations
cloud.smooth_taubin(mu=inf) | mu
cloud.smooth_taubin(knn=0) | knn
loom.compute_fpfh_feature(cloud, radius=None, max_nn=None) | radius, max_nn: give at least one
loom.compute_fpfh_feature(cloud, radius=0.0) | radius
loom.compute_fpfh_feature(cloud, max_nn=0) | max_nn
loom.compute_fpfh_feature(bare) | FPFH needs normals
loom.compute_eigen_features(cloud, radius=None, max_nn=None) | radius, max_nn: give at least one
loom.compute_eigen_features(cloud, max_nn=0) | max_nn
loom.estimate_curvature(cloud, radius=0.0) | radius
loom.compute_iss_keypoints(cloud, salient_radius=-1.0) | salient_radius
loom.compute_iss_keypoints(cloud, non_max_radius=inf) | non_max_radius
loom.compute_iss_keypoints(cloud, min_neighbors=0) | min_neighbors
loom.compute_metrics(cloud, loom.PointCloud()) | expected at least one finite point
loom.compute_metrics(loom.PointCloud(), cloud) | expected at least one finite point
loom.compute_metrics(cloud, cloud, fscore_radius=[0.0]) | fscore_radius
search.knn_search(np.zeros((1, 3)), 0) | knn: expected an integer >= 1
search.knn_search(np.zeros((1, 2)), 1) | queries: expected shape
search.radius_search(np.zeros((1, 3)), 0) | radius
search.hybrid_search(np.zeros((1, 3)), 1, 0) | max_nn
cloud.hidden_point_removal([0, 0, 5], 0) | radius
cloud.hidden_point_removal([0, 0], 10) | camera_location
cloud.voxel_down_sample(0) | voxel_size: expected a finite number > 0
pair.voxel_down_sample(1e-10) | voxel_size: 1e-10 makes a grid of
pair.voxel_down_sample(1e-320) | more than 2^62; take larger
pair.voxel_down_sample(1.0, 'median') | reduction
pair.voxel_down_sample_and_trace(0) | voxel_size
pair.voxel_down_sample_and_trace(1, [0, 0, nan]) | min_bound
pair.voxel_down_sample_and_trace(1, [0, 0, 0], [1, 2, inf]) | max_bound
pair.voxel_down_sample_and_trace(1e-9, [0, 0, 0], [9, 9, 9]) | voxel_size: 1e-09 gives more than 2^31 voxels
pair.voxel_down_sample_and_trace(1e-8, [0, 0, 0]) | voxel_size: 1e-08 makes a grid of
far.thin(1e-9) | spacing
far.thin(1, (0, nan, 0)) | corner
gap.uniform_down_sample(0) | every_k_points
gap.random_down_sample(1.5) | sampling_ratio: expected a fraction in 0..1, got 1.5
gap.random_down_sample(0.5, seed=2**31) | seed
gap.farthest_point_down_sample(4) | num_samples: expected at most the cloud's 3 points
gap.farthest_point_down_sample(2, -1) | start_index
gap.farthest_point_down_sample(2, 1) | remove_non_finite_points()
loom.classify_ground(pair, cell_size=0.0) | cell_size
loom.classify_ground(pair, slope=-0.1) | slope
loom.classify_ground(pair, max_window=inf) | max_window
loom.classify_ground(pair, scaling=-1) | scaling
loom.classify_ground(pair, cell_size=1e-4, max_window=0.1) | max_window: expected at most 512 cells of 0.0001 m
loom.classify_ground(pair, cell_size=1e-6) | cell_size: 1e-06 m gives a grid of
changed(normal_radii=None) | normal_radii: expected the radii
changed(normal_radii=[1, -1]) | normal_radii
changed(cylinder_radius=0) | cylinder_radius
changed(max_distance=inf) | max_distance
changed(registration_error=-1) | registration_error
changed(orientation=(0, 0, 0)) | orientation
changed(directions=np.zeros((3, 3))) | directions
project(width=4) | intrinsic: made for 3 x 2 pixels, but the image has 4 x 2
project(height=0) | height
project(extrinsic=np.diag([2.0, 2, 2, 1])) | extrinsic: expected a rigid motion
project(depth_scale=0) | depth_scale
depth_cloud(depth=np.zeros((3, 2), np.uint16)) | intrinsic: made for 3 x 2 pixels, but the image has 2 x 3
depth_cloud(depth=np.zeros((2, 3, 1), np.uint16)) | depth: expected
depth_cloud(depth=np.full((2, 3), -1)) | depth: expected integers in 0..65535
depth_cloud(extrinsic=np.diag([1.0, 1, -1, 1])) | extrinsic: expected a rigid motion
depth_cloud(depth_scale=0) | depth_scale
depth_cloud(depth_trunc=0) | depth_trunc
depth_cloud(stride=0) | stride
loom.RGBDImage(np.zeros((3, 3, 3), np.uint8), np.zeros((2, 3), np.uint16)) | color: 3 x 3 pixels, but the depth image
loom.RGBDImage(np.zeros((2, 3, 4), np.uint8), np.zeros((2, 3), np.uint16)) | color: expected shape
loom.RGBDImage.create_from_sun_format(np.zeros((2, 3, 3), np.uint8), np.full((2, 3), 70000)) | depth: expected integers
loom.RGBDImage.create_from_nyu_format(np.zeros((2, 3, 3), np.uint8), np.zeros((2, 3, 1), np.uint16)) | depth: expected
loom.RGBDImage.create_from_sun_format(np.zeros((2, 3, 3), np.uint8), np.zeros((3, 3), np.uint16)) | color: 3 x 2 pixels
loom.filter_depth_bilateral(np.ones((4, 4)), kernel_size=0) | kernel_size
loom.filter_depth_bilateral(np.ones((4, 4)), value_sigma=0) | value_sigma
loom.filter_depth_bilateral(np.ones((4, 4)), dist_sigma=inf) | dist_sigma
loom.erode_depth_edges(np.ones((4, 4)), radius=-1) | radius
loom.erode_depth_edges(np.ones((4, 4)), depth_threshold=0) | depth_threshold
loom.erode_depth_edges(np.ones(4)) | depth: expected shape [h, w], got [4]
loom.SelectionPolygonVolume(square[:2], 'Z', 0, 1) | bounding_polygon: expected at least three corners, got 2
loom.SelectionPolygonVolume([[0, 0, nan]] * 3, 'Z', 0, 1) | bounding_polygon: expected finite numbers
loom.SelectionPolygonVolume(square, 'W', 0, 1) | orthogonal_axis
loom.SelectionPolygonVolume(square, 'Z', 1, 0) | axis_min, axis_max: expected min <= max, got 1 and 0
loom.SelectionPolygonVolume(square, 'Z', 0, inf) | axis_min, axis_max
loom.AxisAlignedBoundingBox([0, 0, 0], [1, -1, 1]) | expected
loom.AxisAlignedBoundingBox([inf] * 3, [inf] * 3) | min_bound, max_bound
loom.AxisAlignedBoundingBox([0, 0, 0], [1, 1, 1]).scale(0, [0, 0, 0]) | scale
loom.AxisAlignedBoundingBox().get_point_indices_within_bounding_box(np.zeros((3, 2))) | points: expected shape
loom.OrientedBoundingBox([0, 0, 0], np.eye(3) * 2, [1, 1, 1]) | R
loom.OrientedBoundingBox([0, 0, inf], np.eye(3), [1, 1, 1]) | center
loom.OrientedBoundingBox([0, 0, 0], np.eye(3), [1, -1, 1]) | extent
loom.OrientedBoundingBox([0, 0, 0], np.eye(3), [1, 1, 1]).scale(-1, [0, 0, 0]) | scale
loom.OrientedBoundingBox.create_from_points([]) | at least one finite point
loom.OrientedBoundingBox.create_from_points_minimal([]) | at least one finite point
loom.LineSet([[0, 0, 0], [1, 1, 1]], [[0, 2]]) | expected indices of 2 points, got 0 to 2
loom.LineSet([[0, 0, 0], [nan, 1, 1]], [[0, 1]]) | points: expected finite coordinates, got 1 points without
loom.project_to_utm(loom.PointCloud([[493994.0, 4877429.0, 130.0]])) | expected longitudes to 360 and latitudes -80..84
loom.project_to_utm(loom.PointCloud([[nan, 0, 0]])) | expected a finite point to determine the UTM zone
loom.project_to_utm(loom.PointCloud([[10.0, 45.0, 0.0], [55.0, 45, 0]]), epsg=32632) | got one at 46
loom.project_to_utm(loom.PointCloud([[10.0, 45.0, 0.0]]), epsg=4326) | expected 32601..32660 or 32701..32760, got 4326
loom.project_to_utm(loom.PointCloud([[10.0, 45.0, 0.0]], normals=[[0, 0, 1]])) | cloud.without("normals")
splats(scales=[[1, 1, 1], [1, 0, 1]]) | scales: expected three finite numbers above 0 in each row, but row 1
splats(rotations=[[1, 0, 0, 0], [0, 0, 0, 0]]) | rotations
splats(opacities=[0.5, 1.5]) | opacities: expected a number from 0 to 1 in each row, but row 1
splats(harmonics=np.zeros((2, 5, 3))) | harmonics: expected shape [2, K, 3]
splats().transform(np.diag([1.0, 2, 1, 1])) | transformation: expected a rotation with one scale
splats().rasterize(camera, np.diag([2, 1, 1, 1])) | extrinsic
splats().rasterize(camera, np.eye(4), near=0) | near
splats().rasterize(camera, np.eye(4), background=(2, 0, 0)) | background
loom.fit_shape(random, 'cube') | kind
loom.fit_shape(random, 'sphere', start=loom.fit_shape(random, 'plane')) | start: expected a sphere, got a plane
loom.fit_shape(random, 'plane', weights=[1.0]) | weights: expected shape [10]
loom.fit_shape(random, 'plane', weights=[-1.0] * 10) | weights: expected numbers >= 0, got -1 at 0
loom.fit_shape(random, 'plane', weights=[0.0] * 10) | 0 finite points with a weight
loom.fit_shape(loom.PointCloud(np.eye(3)), 'sphere') | 4 unknowns
loom.fit_shape(loom.PointCloud(np.ones((30, 3))), 'sphere') | all 30 points are equal
loom.fit_shape(loom.PointCloud(), 'sphere') | has 0 finite points
selected.__getitem__([True] * 9) | expected booleans of shape [10], got bool [9]
selected.__getitem__("label") | the cloud has points
loom.rasterize(random, 1.0) | has no classification; set
raster(cell=1e-4) | more than 2^28
loom.rasterize(loom.PointCloud(np.eye(3), unit="degree", classification=[2] * 3), 1.0) | got degrees
loom.rasterize(loom.PointCloud(np.full((5, 3), nan), classification=[2] * 5), 1.0) | expected finite points, got none
raster(bounds=(0, 0, 0, 1)) | bounds: expected (x0, y0, x1, y1)
raster(kind="dem") | kind: expected 'dtm' or
raster(kind="intensity") | the cloud has no intensity
raster(classes=(2, 256)) | classes: expected LAS classes
raster(corner=(1e90, 0)) | corner: is more than 2^48 cells away
loom.PointCloud([]).compute_convex_hull() | points: expected at least one finite point, got none
loom.PointCloud([[1, 2, 3]]).compute_convex_hull() | are equal
loom.PointCloud(np.outer(np.arange(9.0), [1, 2, 3])).compute_convex_hull() | are collinear
loom.filter_depth_bilateral(np.ones((4, 4)), 2**24) | kernel_size
cloud.smooth_taubin(10**5) | iterations
cloud.segment_plane(num_iterations=2**31 - 1) | num_iterations
search.knn_search(np.zeros((1, 3)), 2**63) | knn
search.hybrid_search(np.zeros((1, 3)), 0.1, 2**24) | max_nn
cloud.estimate_normals(max_nn=2**63) | max_nn
loom.CameraModel("OPENCV_FISH", 640, 480, [1] * 8) | did you mean 'OPENCV_FISHEYE'
loom.CameraModel("EQUIRECTANGULAR", 640, 480, [640, 480]) | EQUIRECTANGULAR is not supported
loom.CameraModel("PINHOLE", 640, 480, [500, 500, 320]) | takes fx, fy, cx, cy; got 3
loom.CameraModel("PINHOLE", 640, 480, [500, -500, 320, 240]) | focal lengths above
loom.CameraModel("PINHOLE", 0, 480, [500, 500, 320, 240]) | width
loom.CameraModel("PINHOLE", 2**16, 2**16, [500, 500, 320, 240]) | 2^28
loom.CameraModel("FOV", 640, 480, [500, 500, 320, 240, 3.2]) | omega
loom.CameraModel("EUCM", 640, 480, [500, 500, 320, 240, 1.1, 1]) | alpha in 0..1
loom.CameraModel("METASHAPE", 640, 480, [1.0, 320, 240, *[0] * 6, -2.0, 0]) | focal lengths above
loom.PinholeCameraIntrinsic(2**31, 1, 1.0, 1.0, 0.0, 0.0) | width
loom.PinholeCameraIntrinsic(2**15, 2**15, 1.0, 1.0, 0.0, 0.0) | width, height
camera.scaled(1e9) | factor
loom.erode_depth_edges(np.ones((4, 4)), 2**24) | radius
cloud.scale(1e200) | scale
pair.scale(1e90) | scale, center: moves the points to
gap.random_down_sample(0.5, seed=10**400) | seed: expected an integer
loom.WorldFrame(91.0, 0.0) | latitude
loom.WorldFrame(0.0, 181.0) | longitude
loom.WorldFrame(0.0, 0.0, 2e5) | altitude
"""
TYPES = """
cloud.to_unit(None) | unit: expected the name of a unit, got None
loom.profile(np.eye(3), [[0, 0], [1, 1]], width=1.0) | surface: expected a PointCloud or Raster, got ndarray
loom.PointCloud([[0, 0, 0], [1, 1]]) | points: expected numbers
loom.PointCloud(np.zeros((2, 3), complex)) | points: expected real numbers, got complex128
loom.PointCloud([[0, 0, 0]], ring=['a']) | ring: expected real numbers
loom.PointCloud([[0, 0, 0]], ring=np.zeros(1, np.longdouble)) | ring: expected numbers of 64 bits at most
cloud.from_dlpack(np.zeros((4, 3))) | points: expected float32, the type of a cloud's arrays, got float64; convert
cloud.from_dlpack([[1.0, 2, 3]]) | points: expected an array with __dlpack__ or __cuda_array_interface__, got list
cloud.from_dlpack(np.broadcast_to(np.zeros(3, np.float32), (4, 3))) | points: ndarray cannot be shared
cloud.concatenate([cloud, 3]) | clouds: expected a PointCloud, got int
cloud + 3 | a cloud and a int cannot be added
1 + cloud | a cloud and a int cannot be added
cloud + cloud.points | a cloud and a ndarray cannot be added: cloud.translate
cloud.points + cloud | a cloud and a ndarray cannot be added: cloud.translate
setattr(cloud, "colors", cloud) | colors: expected an array, got a PointCloud. Pass one of its arrays: other['colors']
loom.PointCloud(cloud) | points: expected an array, got a PointCloud. Use cloud.copy()
loom.PointCloud('scan.ply') | points: expected real numbers, got 'scan.ply'. Read a file with loom.read_point_cloud
loom.RGBDImage('a.png', 'b.png') | depth: expected an array, got a path; loom.read_depth(path) reads it
cloud.crop((0, 1)) | expected a bounding box, got tuple
cloud.estimate_normals(max_nn=2.5) | max_nn: expected an integer
gap.farthest_point_down_sample(2.0) | num_samples: expected an integer, got 2.0
loom.classify_ground([[0, 0, 0]]) | cloud: expected a PointCloud, got list
project(intrinsic='K') | intrinsic: expected a PinholeCameraIntrinsic, got str
depth_cloud(depth=np.zeros((2, 3), complex)) | depth: expected integers or floats, got complex128
loom.RGBDImage(np.zeros((2, 3, 3)), np.zeros((2, 3), np.uint16)) | color: expected uint8, got float64
loom.RGBDImage.create_from_sun_format(np.zeros((2, 3, 3), np.uint8), np.ones((2, 3))) | depth: expected the file's
selected.__getitem__(2) | a mask of shape [n] or indices of shape [k]
selected.__getitem__((slice(None), 2)) | expected an attribute's name, a slice
selected.__getitem__(slice(0.5)) | expected a slice of integers, got slice(None, 0.5
selected.__getitem__(np.zeros((2, 2), int)) | got an array of shape [2, 2]
selected.__getitem__([0.5]) | expected integers, got float64
selected.__getitem__({1}) | got set
loom.AxisAlignedBoundingBox() + 1 | unsupported operand
loom.LineSet([[0, 0, 0], [1, 0, 0]], [[0, 1]]) + np.eye(3) | operand 'LineSet'
splats().rasterize(np.eye(3), np.eye(4)) | intrinsic: expected a PinholeCameraIntrinsic
"""
INDICES = """
gap.farthest_point_down_sample(2, 3) | start_index: 3 is out of range for a cloud of 3 points
gap.farthest_point_down_sample(3, 3) | start_index: 3 is out of range for a cloud of 3 points
cloud.select_by_index([3]) | indices: 3..3 are out of range for a cloud of 3 points
cloud.select_by_index([0, -4], invert=True) | indices: -4..0 are out of range for a cloud of 3 points
cloud.select_by_index(np.array([2**64 - 1], np.uint64)) | indices: 18446744073709551615
selected.__getitem__([10]) | 10..10 are out of range for a cloud of 10 points
loom.compute_fpfh_feature(cloud, indices=[3]) | are out of range for a cloud of 3 points
"""
KINDS = {ValueError: VALUES, TypeError: TYPES, IndexError: INDICES}


@pytest.mark.parametrize(
    ("line", "error"), [(line, error) for error, lines in KINDS.items() for line in lines.strip().splitlines()]
)
def test_invalid_arguments_are_rejected_by_name(line, error):
    call, _, message = line.rpartition(" | ")
    with pytest.raises(error, match=rf"(^|\W){re.escape(message)}(?!\w)"):
        eval(call, dict(NAMES))
