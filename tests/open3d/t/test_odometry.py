"""Odometry of tensor images: Open3D's numbers, stored, and the true motion."""

import numpy as np
import pytest

import pointloom as loom
import pointloom.open3d as bridge

WIDTH, HEIGHT, FARTHEST = 96, 72, 10.0


@pytest.fixture(scope="module")
def views():
    """Two frames of a synthetic room."""
    return loom.datasets.room_frames(24, width=WIDTH, height=HEIGHT)[:2]


def images_of(package, views, device="CPU:0"):
    """RGBDImages with 16-bit depth in millimeters, and the camera matrix."""
    Tensor, Image, where = package.core.Tensor, package.t.geometry.Image, package.core.Device(device)
    images = []
    for view in views:
        depth = (view.depth * 1000).round().astype(np.uint16)
        arrays = np.ascontiguousarray(view.color), depth
        images.append(package.t.geometry.RGBDImage(*(Image(Tensor(values, device=where)) for values in arrays)))
    return images, Tensor(np.asarray(views[0].intrinsic.matrix))


def pose_of(package, views, method):
    """Transformation, inlier RMSE and fitness of `rgbd_odometry_multi_scale`."""
    (source, target), K = images_of(package, views)
    odometry, start = package.t.pipelines.odometry, package.core.Tensor(np.eye(4))
    levels = [odometry.OdometryConvergenceCriteria(steps) for steps in (8, 4, 2)]
    method = getattr(odometry.Method, method)
    found = odometry.rgbd_odometry_multi_scale(source, target, K, start, 1000.0, FARTHEST, levels, method)
    return found.transformation.numpy(), found.inlier_rmse, found.fitness


def plane_results_of(package, views):
    """The pose by `PointToPlane`, and the information matrix at this pose."""
    (source, target), K = images_of(package, views)
    pose = pose_of(package, views, "PointToPlane")
    depths, T = (source.depth, target.depth), package.core.Tensor(pose[0])
    information = package.t.pipelines.odometry.compute_odometry_information_matrix
    return pose, information(*depths, K, T, 0.07, 1000.0, FARTHEST).numpy()


def compare_poses(actual, expected, tolerance):
    (T, rmse, fitness), (expected_T, expected_rmse, expected_fitness) = actual, expected
    assert np.allclose(T, expected_T, atol=tolerance) and fitness == pytest.approx(expected_fitness, abs=2e-3)
    assert rmse == pytest.approx(expected_rmse, rel=5e-3)


def steps_of(package, views):
    """One step of each method. The maps are those of NumPy, for both packages."""
    odometry, Tensor = package.t.pipelines.odometry, package.core.Tensor
    K = np.asarray(views[0].intrinsic.matrix)
    depths = [view.depth.astype(np.float32) for view in views]
    rays = np.stack(np.meshgrid(np.arange(WIDTH), np.arange(HEIGHT)), axis=-1)
    vertices = [np.dstack([(rays - K[:2, 2]) / K[[0, 1], [0, 1]] * d[..., None], d]).astype(np.float32) for d in depths]
    across = [np.gradient(vertices[1], axis=axis) for axis in (0, 1)]
    normals = np.cross(*across)
    lengths = np.maximum(np.linalg.norm(normals, axis=2, keepdims=True), 1e-12)
    normals = (normals / lengths).astype(np.float32)
    shades = [view.color.astype(np.float32).mean(axis=2) / 255 for view in views]
    slopes = [8 * np.gradient(image, axis=axis) for image in (depths[1], shades[1]) for axis in (1, 0)]
    maps = [Tensor(values[..., None].astype(np.float32)) for values in (*depths, *shades, *slopes)]
    source, target, normal = (Tensor(values) for values in (*vertices, normals))
    camera, start = Tensor(K), Tensor(np.eye(4))
    plane = odometry.compute_odometry_result_point_to_plane(source, target, normal, camera, start, 0.07, 0.05)
    color = odometry.compute_odometry_result_intensity(*maps[:4], *maps[6:], source, camera, start, 0.07, 0.1)
    both = odometry.compute_odometry_result_hybrid(*maps, source, camera, start, 0.07, 0.05, 0.1)
    return [(one.transformation.numpy(), one.inlier_rmse, one.fitness) for one in (plane, color, both)]


def test_odometry_is_that_of_open3d(oracle, views):
    (expected, expected_information), (actual, information) = (
        oracle("open3d/t/odometry", plane_results_of, views),
        plane_results_of(bridge, views),
    )
    compare_poses(actual, expected, 1e-5)
    assert np.allclose(information, expected_information, atol=2e-3 * expected_information.max())


def test_odometry_with_intensity_is_near_that_of_open3d(o3d, views):
    """Open3D returns one of two poses, 3e-4 apart. Intensity alone ends anywhere in images of this size."""
    compare_poses(pose_of(bridge, views, "Hybrid"), pose_of(o3d, views, "Hybrid"), 1e-3)


def test_single_steps_are_those_of_open3d(oracle, views):
    expected = oracle("open3d/t/odometry_steps", steps_of, views)
    for theirs, actual in zip(expected, steps_of(bridge, views), strict=True):
        for number, other in zip(theirs, actual, strict=True):
            assert np.allclose(number, other, atol=1e-5)


def test_point_to_plane_odometry_finds_the_motion(device, views):
    (source, target), K = images_of(bridge, views, device.upper())
    odometry = bridge.t.pipelines.odometry
    levels = [odometry.OdometryConvergenceCriteria(steps) for steps in (20, 10, 5)]
    method = odometry.Method.PointToPlane
    found = odometry.rgbd_odometry_multi_scale(source, target, K, np.eye(4), 1000.0, FARTHEST, levels, method)
    T = np.linalg.inv(views[1].T_world_camera) @ views[0].T_world_camera
    assert np.linalg.norm(T[:3, 3]) > 0.05
    assert np.allclose(found.transformation.numpy(), T, atol=6e-3)


def test_odometry_reports_what_it_cannot_use(views):
    (source, target), K = images_of(bridge, views)
    odometry = bridge.t.pipelines.odometry
    blank = bridge.t.geometry.Image(bridge.core.Tensor(np.zeros((HEIGHT, WIDTH), np.uint16)))
    empty = bridge.t.geometry.RGBDImage(source.color, blank)
    with pytest.raises(RuntimeError, match="do not determine"):
        odometry.rgbd_odometry_multi_scale(source, empty, K)
    with pytest.raises(TypeError, match="source:"):
        odometry.rgbd_odometry_multi_scale(source.depth, target, K)
    with pytest.raises(TypeError, match="criteria_list:"):
        odometry.rgbd_odometry_multi_scale(source, target, K, criteria_list=[3])
    floats = bridge.t.geometry.RGBDImage(source.color.to(bridge.core.float32), source.depth)
    first = [odometry.rgbd_odometry_multi_scale(one, target, K, depth_max=FARTHEST) for one in (source, floats)]
    assert np.allclose(*(one.transformation.numpy() for one in first), atol=1e-3)
