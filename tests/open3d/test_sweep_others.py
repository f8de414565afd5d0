"""Results of images, searches, cameras and registration agree with those of Open3D, also with non-finite points."""

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
import pytest

import pointloom.open3d as bridge

FORMATS = ("color_and_depth", "redwood_format", "tum_format", "nyu_format", "sun_format")
METHODS = {
    "remove_non_finite_points": (), "voxel_down_sample": (0.5,), "get_center": (), "get_axis_aligned_bounding_box": (),
    "compute_mean_and_covariance": (), "cluster_dbscan": (1.0, 3), "uniform_down_sample": (3,),
    "remove_duplicated_points": (), "normalize_normals": (), "paint_uniform_color": ([1, 0, 0],),
}  # fmt: skip

# Methods with Open3D's results for non-finite points. The others ignore these points, and spoil results in Open3D.
MISSING = ("remove_non_finite_points", "uniform_down_sample", "normalize_normals", "paint_uniform_color")
MISSING += ("remove_duplicated_points",)


def image(o3d, kind, channels=1):
    values = np.random.default_rng(0).random((12, 16) if channels == 1 else (12, 16, channels))
    return o3d.geometry.Image((values * {"uint8": 255, "uint16": 5000, "float32": 1}[kind]).astype(kind))


def cloud(o3d, is_finite=True):
    random = np.random.default_rng(1)
    points, normals = random.uniform(-1, 2, (40, 3)), random.normal(size=(40, 3))
    if not is_finite:
        points[3], points[7, 1] = np.nan, np.inf
    made = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(points))
    made.normals = o3d.utility.Vector3dVector(normals / np.linalg.norm(normals, axis=1, keepdims=True))
    made.colors = o3d.utility.Vector3dVector(random.random((40, 3)))
    return made


def camera(o3d):
    return o3d.camera.PinholeCameraIntrinsic(16, 12, 20, 20, 7.5, 5.5)


def pose():
    T = np.eye(4)
    T[:3, 3] = 0.1, 0, 0.2
    return T


def flipped(o3d, kind, channels):
    pixels = image(o3d, kind, channels)
    return [pixels.flip_horizontal(), pixels.flip_vertical(), pixels.get_max_bound(), pixels.create_pyramid(2, False)] \
        if kind == "float32" and channels == 1 else [pixels.flip_horizontal(), pixels.get_min_bound()]  # fmt: skip


def filtered(o3d, name):
    pixels, kind = image(o3d, "float32"), getattr(o3d.geometry.ImageFilterType, name)
    return [pixels.filter(kind), o3d.geometry.Image.filter_pyramid(pixels.create_pyramid(2, True), kind)]


def rgbd(o3d, name, is_gray):
    create = getattr(o3d.geometry.RGBDImage, f"create_from_{name}")
    images = create(image(o3d, "uint8", 3), image(o3d, "uint16"), convert_rgb_to_intensity=is_gray)
    return [images, o3d.geometry.PointCloud.create_from_rgbd_image(images, camera(o3d), pose())]


def depth_cloud(o3d, kind, stride, truncation):
    scale = 1.0 if kind == "float32" else 1000.0
    given = image(o3d, kind), camera(o3d), pose(), scale, truncation, stride
    return o3d.geometry.PointCloud.create_from_depth_image(*given)


def searched(o3d, query):
    tree, g = o3d.geometry.KDTreeFlann(cloud(o3d)), o3d.geometry
    params = g.KDTreeSearchParamKNN(3), g.KDTreeSearchParamRadius(0.8), g.KDTreeSearchParamHybrid(0.8, 2)
    found = [tree.search_knn_vector_3d(query, count) for count in (1, 5, 60)]
    found += [tree.search_radius_vector_3d(query, radius) for radius in (0.1, 1.0, 20.0)]
    found += [tree.search_hybrid_vector_3d(query, radius, 7) for radius in (0.1, 1.0, 20.0)]
    return found + [tree.search_vector_3d(query, param) for param in params]


def parameters(o3d, name):
    made = o3d.camera.PinholeCameraIntrinsic(getattr(o3d.camera.PinholeCameraIntrinsicParameters, name))
    return [made.width, made.height, made.intrinsic_matrix, made.get_focal_length(), made.get_principal_point()]


def registered(o3d, distance):
    module, clouds = o3d.pipelines.registration, [cloud(o3d), cloud(o3d)]
    clouds[1].translate([0.02, 0.01, -0.01])
    to_planes = module.TransformationEstimationPointToPlane()
    results = [module.evaluate_registration(*clouds, distance), module.registration_icp(*clouds, distance)]
    results += [module.registration_icp(*clouds, distance, np.eye(4), to_planes), module.RegistrationResult()]
    information = module.get_information_matrix_from_point_clouds(*clouds, distance, np.eye(4))
    return [[r.transformation, r.fitness, r.inlier_rmse, r.correspondence_set] for r in results] + [information]


def called(o3d, method, is_finite):
    shape = cloud(o3d, is_finite)
    return [getattr(shape, method)(*METHODS[method]), shape]


def cases() -> dict[str, Callable[[Any], Any]]:
    """The functions of a package by name."""
    calls = [(flipped, kind, channels) for kind in ("uint8", "uint16", "float32") for channels in (1, 3)]
    calls += [(filtered, name) for name in ("Gaussian3", "Gaussian5", "Gaussian7", "Sobel3dx", "Sobel3dy")]
    calls += [(rgbd, name, is_gray) for name in FORMATS for is_gray in (False, True)]
    calls += [(depth_cloud, *given) for given in (("uint16", 1, 1000.0), ("uint16", 2, 3.0), ("float32", 1, 0.5))]
    calls += [(searched, query) for query in ([0.0, 0, 0], [0.5, 0.5, 0.5], [9.0, 9, 9])]
    calls += [(parameters, f"{name}Default") for name in ("PrimeSense", "Kinect2DepthCamera", "Kinect2ColorCamera")]
    calls += [(registered, distance) for distance in (0.001, 0.1, 0.5)]
    calls += [(called, method, finite) for method in METHODS for finite in (True, method not in MISSING)]
    return {f"{call.__name__} {given}": partial(_call, call, given) for call, *given in calls}


def _call(function, given, o3d):
    return function(o3d, *given)


def arrays_of(value) -> list[np.ndarray]:
    """The arrays of a result."""
    if hasattr(value, "get_box_points"):
        return arrays_of(value.get_box_points())
    if hasattr(value, "points"):
        return [np.array(getattr(value, name), float) for name in ("points", "normals", "colors")]
    if hasattr(value, "depth"):
        return [*arrays_of(value.color), *arrays_of(value.depth)]
    if isinstance(value, list | tuple) and not all(isinstance(item, int | float) for item in value):
        return [array for part in value for array in arrays_of(part)]
    return [np.array(value, float)]


def results(o3d) -> dict[str, np.ndarray]:
    """Shape, sum of magnitudes and weighted sum of each array of each case. Errors count as -1."""
    found = {}
    for name, call in cases().items():
        rows = []
        try:
            arrays = arrays_of(call(o3d))
        except Exception:
            arrays = [np.full(1, -1.0)]  # an error
        for array in arrays:  # voxels have no order
            weights = np.ones(array.size) if "voxel" in name else np.cos(np.arange(array.size))
            values = np.nan_to_num(array.reshape(-1), posinf=9.0)
            rows += [*array.shape, np.abs(values).sum(), values @ weights]
        found[name] = np.array(rows)
    return found


@pytest.mark.slow
def test_results_of_other_classes_agree_with_open3d(oracle):
    expected, actual = oracle("open3d/other_results", results), results(bridge)
    assert len(actual) > 40 and actual.keys() == expected.keys()
    for name, values in actual.items():
        np.testing.assert_allclose(values, expected[name], rtol=2e-5, atol=2e-5, err_msg=name)


def test_searches_find_all_finite_points_and_no_others():
    tree, finite = bridge.geometry.KDTreeFlann(cloud(bridge, False)), [i for i in range(40) if i not in (3, 7)]
    for found in (
        tree.search_knn_vector_3d([0.5, 0.5, 0.5], 60),
        tree.search_radius_vector_3d([0.5, 0.5, 0.5], 20.0),
        tree.search_hybrid_vector_3d([0.5, 0.5, 0.5], 20.0, 60),
    ):
        assert found[0] == 38 and sorted(found[1]) == finite and np.isfinite(found[2]).all()
    none = bridge.geometry.KDTreeFlann(np.full((3, 2), np.nan))
    assert none.search_knn_vector_3d([0, 0, 0], 1)[0] == none.search_radius_vector_3d([0, 0, 0], 1.0)[0] == 0
