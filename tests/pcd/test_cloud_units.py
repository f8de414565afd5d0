"""The unit of a cloud: propagated, converted on request, and checked when two clouds are combined."""

import copy
import pickle
import warnings

import numpy as np
import pytest

import pointloom as loom


def slow(operation):
    """An operation whose kernels take seconds to compile."""
    return pytest.param(operation, marks=pytest.mark.slow)


@pytest.fixture
def feet(rng):
    """A cloud in feet, far from zero, with all attributes that operations need."""
    points, normals = rng.random((200, 3)) + np.array([2_500_000, 700_000, 400]), rng.normal(size=(200, 3))
    return loom.PointCloud(points, normals=normals, colors=rng.random((200, 3)), unit="foot", ring=range(200))


@pytest.mark.parametrize(
    "operation",
    [
        copy.copy,
        copy.deepcopy,
        lambda c: pickle.loads(pickle.dumps(c)),
        lambda c: c.copy(),
        lambda c: c.to("cpu", arrays="warp"),
        lambda c: c.voxel_down_sample(0.3),
        lambda c: c.random_down_sample(0.5),
        lambda c: c.select_by_index([1, 2]),
        lambda c: c.crop(loom.AxisAlignedBoundingBox([0, 0, 0], [3e6] * 3)),
        lambda c: c.without("ring"),
        lambda c: c.estimate_normals(max_nn=5),
        lambda c: c.paint_uniform_color([1, 0, 0]),
        lambda c: c.translate([1, 2, 3]),
        lambda c: c.rotate(np.diag([1.0, -1, -1])),
        lambda c: c.transform(np.eye(4)),
        lambda c: c + loom.PointCloud([[0, 0, 0]]),
        lambda c: sum([c, c]),
        lambda c: c.remove_statistical_outlier(5, 2.0)[0],
        lambda c: c.smooth_laplacian(1, knn=4),
        lambda c: c.remove_non_finite_points(),
        lambda c: c.farthest_point_down_sample(5),
        lambda c: loom.PointCloud.concatenate([loom.PointCloud(), c]),
        slow(lambda c: loom.TriangleMesh.create_from_point_cloud_ball_pivoting(c, [0.2])),
        lambda c: loom.TriangleMesh.create_from_point_cloud_alpha_shape(c, 0.5).sample_points_uniformly(9),
    ],
)
def test_operations_keep_the_unit(operation, feet):
    assert operation(feet).unit == "foot"


@pytest.mark.parametrize("factor", [0.3048, 2.0])
def test_scaled_cloud_has_no_unit(factor, feet):
    mesh = loom.TriangleMesh.create_sphere()
    mesh.unit = "foot"
    assert feet.scale(factor).unit is None and mesh.scale(factor).unit is None
    assert feet.scale(1.0).unit == "foot" and mesh.translate([1, 2, 3]).unit == "foot"


def test_a_unit_is_assigned_by_name_and_moves_no_point():
    cloud = loom.PointCloud([[1, 2, 3]])
    assert cloud.unit is None
    cloud.unit = "Feet"
    assert cloud.unit == "foot" and cloud.points.tolist() == [[1, 2, 3]]
    cloud.unit = None
    assert cloud.unit is None
    with pytest.raises(ValueError, match=r"^unit:"):
        cloud.unit = "ell"
    cloud["unit"] = [7]  # an attribute of that name is unrelated
    assert cloud.unit is None and cloud["unit"].tolist() == [7]


def test_conversion_is_exact_far_from_zero(device, feet):
    cloud = feet.to(device)
    meters = cloud.to_unit("metre")
    assert meters.unit == "metre" and cloud.unit == "foot"
    assert np.array_equal(meters.origin, cloud.origin * 0.3048)
    assert np.abs(meters.points - cloud.points * 0.3048).max() < 1e-7
    assert np.abs(meters.to_unit("foot").points - cloud.points).max() < 3e-7
    assert np.allclose(meters.normals, cloud.normals, atol=1e-6)
    spread = cloud.estimate_covariances(max_nn=9)
    converted = spread.to_unit("metre")
    assert np.allclose(converted["covariances"], spread["covariances"] * 0.3048**2, rtol=1e-5)
    survey = loom.PointCloud([[0, 0, 3937]], unit="US survey foot")
    assert survey.to_unit("metre").points[0, 2] == pytest.approx(1200, rel=1e-7)


def test_conversion_without_a_known_unit_is_rejected():
    with pytest.raises(ValueError, match=r"^unit:"):
        loom.PointCloud([[0, 0, 1]]).to_unit("metre")
    with pytest.raises(ValueError, match="project_to_utm"):
        loom.PointCloud([[8, 48, 1]], unit="degree").to_unit("metre")
    with pytest.raises(ValueError, match="float32"):
        loom.PointCloud([[0, 0, 0], [0, 0, 3e38]], unit="metre").to_unit("millimetre")


def test_meshes_are_converted_too():
    mesh = loom.TriangleMesh([[1e6, 0, 0], [1e6 + 10, 0, 0], [1e6, 10, 0]], [[0, 1, 2]], origin=[1e6, 0, 0])
    mesh.unit = "foot"
    result = mesh.to_unit("metre")
    assert result.get_surface_area() == pytest.approx(50 * 0.3048**2) and result.origin[0] == 304_800
    assert np.allclose(result.vertices, mesh.vertices * 0.3048)


@pytest.mark.parametrize(
    "meeting",
    [
        lambda a, b: a + b,
        lambda a, b: a.compute_point_cloud_distance(b),
        lambda a, b: loom.compute_metrics(a, b, [0.1]),
        lambda a, b: loom.registration.registration_icp(a, b, 0.5),
        lambda a, b: loom.registration.evaluate_registration(a, b, 0.5),
        slow(lambda a, b: loom.registration.register_pair(a, b, init=np.eye(4), voxel_size=0.3)),
        slow(lambda a, b: loom.registration.register_fragments([a, b], voxel_size=0.3)),
        slow(lambda a, b: loom.render([a, b], size=(32, 32))),
    ],
)
def test_two_units_that_meet_are_a_warning(meeting, feet):
    meters = feet.copy()
    meters.unit = "metre"
    with pytest.warns(loom.UnitWarning, match=r"got (foot and metre|metre and foot)\. Convert .* to_unit") as caught:
        meeting(feet, meters)
    assert caught[0].filename == __file__
    meters.unit = None
    with warnings.catch_warnings():
        warnings.simplefilter("error", loom.UnitWarning)
        meeting(feet, meters)  # an unknown unit contradicts nothing


def test_lidar_odometry_counts_in_metres(feet):
    with pytest.warns(loom.UnitWarning, match="LidarOdometry \\(in meters\\)"):
        loom.registration.LidarOdometry().register(feet)


def test_ground_by_lengths_in_metres_is_a_warning_in_feet(feet):
    with pytest.warns(loom.UnitWarning, match=r"^cloud:") as caught:
        loom.classify_ground(feet, cell_size=3.3)
    assert caught[0].filename == __file__
    loom.classify_ground(feet, cell_size=3.3, max_window=59.1, elevation_threshold=1.64, scaling=4.1)
    loom.classify_ground(feet.to_unit("metre"))
