"""PointCloud: accepted and rejected arguments, precision far from zero, and units of length."""

import copy
import pickle
import warnings
from contextlib import nullcontext

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.coordinates import (
    ORIGIN_LIMIT,
    SPREAD_SAMPLE,
    axes_far_from_zero,
    choose_origin,
    is_plainly_around_zero,
    origin_under,
    sample_points,
)
from pointloom.kernels.lang import vec3, vec3d
from pointloom.kernels.memory import upload

from .full_clouds import EXTRAS, UTM, assert_same, contents, full_cloud, rigid


def test_cloud_returns_its_arrays(device, rng):
    points, normals, colors = rng.random((50, 3)), rng.normal(size=(50, 3)), rng.random((50, 3))
    cloud = loom.PointCloud(points, normals=normals, colors=colors, device=device, ring=np.arange(50))
    assert len(cloud) == 50 and cloud.has_normals and cloud.has_colors and list(cloud.attributes) == ["ring"]
    assert cloud.points.dtype == np.float64 and cloud.normals.dtype == cloud.colors.dtype == np.float32
    np.testing.assert_array_equal(cloud.points, points.astype(np.float32))
    np.testing.assert_array_equal(cloud.normals, normals.astype(np.float32))
    np.testing.assert_array_equal(cloud.colors, colors.astype(np.float32))
    np.testing.assert_array_equal(cloud["ring"], np.arange(50))
    assert "ring" in cloud and "time" not in cloud


def test_an_empty_cloud_takes_every_operation(device):
    for cloud in (loom.PointCloud(device=device), loom.PointCloud([], device=device, ring=np.zeros(0, np.int32))):
        assert len(cloud) == 0 and cloud.points.shape == (0, 3)
        box = loom.AxisAlignedBoundingBox([0] * 3, [1] * 3)
        for result in (
            cloud.voxel_down_sample(0.1), cloud.estimate_normals(radius=1.0), cloud.estimate_normals(max_nn=3),
            cloud.estimate_normals(radius=1.0, max_nn=None), cloud.transform(np.eye(4)), cloud.crop(box),
            cloud.crop(box, invert=True), cloud.select_by_index([]), cloud.select_by_mask(np.zeros(0, bool)),
            cloud.remove_non_finite_points(),
            cloud.estimate_normals(max_nn=3).orient_normals_towards_camera_location(),
            cloud.estimate_normals(max_nn=3).orient_normals_consistent_tangent_plane(2),
        ):  # fmt: skip
            assert len(result) == 0 and list(result.attributes) == list(cloud.attributes)
        assert cloud.get_min_bound().tolist() == cloud.get_max_bound().tolist() == [0, 0, 0]


@pytest.mark.parametrize("dtype", ["i1", "u2", "u4", "i8", "f2", "f4", ">f8", "?"])
def test_points_and_attributes_of_any_numeric_type_are_accepted(device, dtype):
    values = np.array([[0, 1, 0], [1, 1, 0], [1, 0, 1]]).astype(dtype)
    cloud = loom.PointCloud(values, device=device, extra=values[:, 0], wide=values)
    np.testing.assert_array_equal(cloud.points, values.astype(float))
    for name, expected in (("extra", values[:, 0]), ("wide", values)):
        assert cloud[name].dtype == np.dtype(dtype).newbyteorder("=")
        np.testing.assert_array_equal(cloud[name], expected)
    assert len(cloud.voxel_down_sample(0.25)) == 3


def test_8_bit_colors_are_divided_by_255(device):
    cloud = loom.PointCloud(np.zeros((2, 3)), colors=np.array([[255, 0, 51], [1, 2, 3]], np.uint8), device=device)
    np.testing.assert_allclose(cloud.colors, [[1, 0, 0.2], [1 / 255, 2 / 255, 3 / 255]], rtol=6.1e-8)


def test_a_device_that_is_none_is_named():
    for device in ("gpu", "cuda:99", object()):
        with pytest.raises(loom.DeviceError, match="device:"):
            loom.PointCloud(device=device)


def test_nan_and_infinite_points_are_preserved(device):
    points = np.array([[np.nan, 0, 0], [np.inf, -np.inf, 1], [1, 2, 3], [2e4, 0, 0]])
    cloud = loom.PointCloud(points, device=device)
    np.testing.assert_array_equal(cloud.points, points)
    assert cloud.get_min_bound().tolist() == [1, 0, 0] and cloud.get_max_bound().tolist() == [2e4, 2, 3]


def test_missing_array_error_suggests_a_fix(device):
    cloud = loom.PointCloud(np.zeros((2, 3)), device=device, ring=[1, 2])
    for call, message in (
        (lambda: cloud.normals, r"no normals: call cloud = cloud\.estimate_normals\(\)"),
        (lambda: cloud.colors, "no colors: assign cloud.colors"),
        (lambda: cloud["time"], "no time: the cloud has points, ring"),
        (lambda: cloud.array("time"), "no time: the cloud has points, ring"),
        (lambda: cloud.orient_normals_towards_camera_location(), "no normals"),
    ):
        with pytest.raises(ValueError, match=message):
            call()
    with pytest.raises(TypeError, match="not a sequence"):
        iter(cloud)


def test_assigned_arrays_are_checked_and_read_back(device, rng):
    cloud = loom.PointCloud(np.zeros((4, 3)), device=device)
    cloud.normals, cloud.colors, cloud["ring"] = np.ones((4, 3)), np.zeros((4, 3)), np.arange(4)
    cloud["points"] = rng.random((4, 3)) + UTM
    assert cloud.origin.tolist() == np.round(cloud.origin).tolist() != [0, 0, 0]
    assert list(contents(cloud)) == ["points", "normals", "colors", "ring", "origin", "grid"]
    for name in ("points", "normals", "colors", "ring"):
        with pytest.raises(ValueError, match=f"{name}:"):
            cloud[name] = np.zeros((5, 3))


def test_read_arrays_are_read_only_copies(device, rng):
    cloud = full_cloud(rng, device)
    before = contents(cloud)
    read = [getattr(cloud, name) for name in ("points", "normals", "colors", "origin")]
    for values in (*read, *(cloud[name] for name in EXTRAS), *(cloud.attributes[name] for name in EXTRAS)):
        with pytest.raises(ValueError, match="read-only"):
            values[:] = 1
        values.copy()[:] = 1
    assert_same(contents(cloud), before)


def test_an_array_is_of_the_library_of_the_cloud_and_shares_its_memory(device, rng):
    cloud = full_cloud(rng, device)
    of_warp = cloud.to(device, arrays="warp")
    for name in cloud.arrays:
        stored, array = cloud.arrays[name], cloud.array(name)
        assert of_warp.array(name) is stored
        if device != "cpu":  # NumPy has no memory there
            assert array is stored and array.__cuda_array_interface__["shape"] == cloud[name].shape
        else:
            assert type(array) is np.ndarray and array.ctypes.data == stored.ptr and array.flags.writeable
            assert (array.shape, array.dtype) == (cloud[name].shape, stored.numpy().dtype)
    if device == "cpu":
        cloud.array("points")[0] = [1, 2, 3]
        assert cloud.points[0].tolist() == [1, 2, 3]


def test_the_origin_stays_at_zero_up_to_its_limit_and_moves_beyond(device):
    at = loom.PointCloud([[ORIGIN_LIMIT, 0, -ORIGIN_LIMIT]], device=device)
    beyond = loom.PointCloud([[ORIGIN_LIMIT + 1, 0, 0], [ORIGIN_LIMIT - 3, 10, 0]], device=device)
    assert at.origin.tolist() == [0, 0, 0] and beyond.origin.tolist() == [ORIGIN_LIMIT - 1, 5, 0]


@pytest.mark.parametrize("dtype", [np.float64, np.float32, np.float16, np.int32])
def test_points_that_are_plainly_around_zero_are_not_far_from_it_by_their_medians(dtype, rng):
    plain_count = 0
    for count in [1, 2, 3, 4, 5, 127, 128, 129, 1000] * 25:  # one point of float64 has an origin
        points = (9 * rng.normal(size=(count, 3)) + 300 * rng.choice([0, 0.3, 1, 2])).astype(dtype)
        points[rng.random(count) < rng.choice([0, 0.3, 0.6])] = 0
        points[:1] *= rng.choice([1, 30])
        if is_plainly_around_zero(points):
            assert not axes_far_from_zero(sample_points(points, SPREAD_SAMPLE)).any()
            plain_count += 1
    assert plain_count > 60


def test_the_origin_of_a_moved_box_is_that_of_its_corners(rng):
    far_count = 0
    for _ in range(200):
        corners = np.sort(rng.normal(size=(2, 3)) + 10 ** rng.uniform(0, 5) * rng.choice([0, 1], 3), axis=0)
        middle, half = (corners[0] + corners[1]) / 2, (corners[1] - corners[0]) / 2
        is_far = choose_origin(np.stack([middle - half, middle + half])).any()
        assert origin_under("box", np.eye(3), np.zeros(3), *corners, middle).any() == is_far
        far_count += is_far
    assert 20 < far_count < 180


@pytest.mark.parametrize("extent", [1.0, 100.0, 5000.0])
def test_utm_coordinates_survive_to_the_float32_of_their_extent(device, extent, rng, tolerances):
    points = UTM + (rng.random((500, 3)) - 0.5) * extent
    error = np.abs(loom.PointCloud(points, device=device).points - points).max()
    assert error <= tolerances.float32_relative * (extent / 2 + 1) + 1e-9  # half a meter from rounding the origin
    assert error < tolerances.position
    float32_alone = np.abs(points.astype(np.float32) - points).max()
    assert float32_alone > 0.1


@pytest.mark.parametrize(
    ("offset", "extent", "is_coarse"),
    [(UTM, 100, True), ([5000, 0, 0], 1, True), ([5000, 0, 0], 100, False), ([300, 0, 0], 5, False), (UTM, 0, False)],
)
def test_float32_coordinates_that_have_lost_digits_are_warned_about(device, offset, extent, is_coarse, rng):
    exact = rng.random((500, 3)) * extent + offset
    rounded = upload(exact.astype(np.float32), vec3, device)
    for make in (loom.PointCloud, lambda points, **options: loom.TriangleMesh(points, [[0, 1, 2]], **options)):
        for values in (rounded, rounded.numpy()):
            with pytest.warns(UserWarning, match="float64") if is_coarse else nullcontext():
                make(values, device=device)
        make(exact, device=device)


@pytest.mark.parametrize("stray", [[0, 0, 0], [1e7, 0, 0], [0, 0, -1e12]])
def test_one_stray_point_takes_no_precision_from_the_others(device, stray, rng, tolerances):
    for shift in (np.zeros(3), UTM):
        points = np.vstack([[stray], rng.random((500, 3)) + shift])
        cloud = loom.PointCloud(points, device=device)
        limit = 2 * tolerances.float32_relative + 1e-9
        np.testing.assert_allclose(cloud.points[1:], points[1:], rtol=0, atol=limit)
        T = np.eye(4)
        T[:3, 3] = UTM - 2 * shift
        moved = cloud.transform(T)
        np.testing.assert_allclose(moved.points[1:], points[1:] + T[:3, 3], rtol=0, atol=2 * limit)


def test_a_transform_moves_the_origin_with_the_cloud(device, rng, tolerances):
    points = rng.random((100, 3)) * [100, 100, 10]
    T = rigid(rng)
    T[:3, 3] = UTM
    away = loom.PointCloud(points, device=device).transform(T)
    expected = points.astype(np.float32).astype(float) @ T[:3, :3].T + UTM
    np.testing.assert_allclose(away.points, expected, rtol=0, atol=tolerances.position / 50)
    back = away.transform(np.linalg.inv(T))
    assert back.origin.tolist() == [0, 0, 0] and away.origin.any()
    np.testing.assert_allclose(back.points, points, rtol=0, atol=tolerances.position / 50)


def test_a_cloud_that_a_transform_stretches_in_any_direction_keeps_its_precision(device, tolerances):
    """A shear whose rows cancel along the diagonal of the box, but move its corners beyond 1e4."""
    corners = np.stack(np.meshgrid(*[[1000.0, 2000.0]] * 3), -1).reshape(-1, 3) + 1 / 3
    T = np.eye(4)
    T[:3, :3] = [[100, -100, 0], [0, 100, -100], [0, 0, 1]]
    T[:3, 3] = [9e3, 0, 0]
    cloud = loom.PointCloud(corners, device=device).transform(T)
    assert cloud.origin.any()
    expected = corners.astype(np.float32).astype(float) @ T[:3, :3].T + T[:3, 3]
    limit = tolerances.float32_relative * np.abs(expected - cloud.origin).max()
    np.testing.assert_allclose(cloud.points, expected, rtol=0, atol=limit)


def slow(operation):
    """An operation whose kernels take seconds to compile."""
    return pytest.param(operation, marks=pytest.mark.slow)


@pytest.fixture
def feet(rng):
    """A cloud in feet, far from zero, with all attributes that operations need."""
    points, normals = rng.random((200, 3)) + np.array([2_500_000, 700_000, 400]), rng.normal(size=(200, 3))
    return loom.PointCloud(points, normals=normals, colors=rng.random((200, 3)), unit="foot", ring=range(200))


@pytest.mark.parametrize("operation", [
    copy.copy, copy.deepcopy, lambda c: pickle.loads(pickle.dumps(c)), lambda c: c.copy(),
    lambda c: c.to("cpu", arrays="warp"), lambda c: c.voxel_down_sample(0.3), lambda c: c.random_down_sample(0.5),
    lambda c: c.select_by_index([1, 2]), lambda c: c.crop(loom.AxisAlignedBoundingBox([0, 0, 0], [3e6] * 3)),
    lambda c: c.without("ring"), lambda c: c.estimate_normals(max_nn=5), lambda c: c.paint_uniform_color([1, 0, 0]),
    lambda c: c.translate([1, 2, 3]), lambda c: c.rotate(np.diag([1.0, -1, -1])), lambda c: c.transform(np.eye(4)),
    lambda c: c + c, lambda c: sum([c, c]),
    lambda c: c.remove_statistical_outlier(5, 2.0)[0], lambda c: c.smooth_laplacian(1, knn=4),
    lambda c: c.remove_non_finite_points(), lambda c: c.farthest_point_down_sample(5),
    lambda c: loom.PointCloud.concatenate([loom.PointCloud(), c]),
    slow(lambda c: loom.TriangleMesh.create_from_point_cloud_ball_pivoting(c, [0.2])),
    lambda c: loom.TriangleMesh.create_from_point_cloud_alpha_shape(c, 0.5).sample_points_uniformly(9),
])  # fmt: skip
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
        slow(lambda a, b: loom.registration.register_multiway([a, b], voxel_size=0.3)),
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


def ways_to_store(values, device):
    """World coordinates after each way to store an array, less what the way added to it."""
    triangles = np.arange(len(values) // 3 * 3).reshape(-1, 3)
    shift, half = np.array([0.125, 0.25, 1.0]), len(values) // 2
    cloud, mesh = loom.PointCloud(values, device=device), loom.TriangleMesh(values, triangles, device=device)
    on_device = loom.PointCloud(upload(values, vec3d, device))
    assigned = loom.PointCloud(np.zeros_like(values), device=device)
    assigned.points = values
    moved_mesh = loom.TriangleMesh(np.zeros_like(values), triangles, device=device)
    moved_mesh.vertices = values
    halves = [loom.PointCloud(part, device=device) for part in (values[:half], values[half:]) if len(part)]
    stored = [cloud.points, on_device.points, assigned.points, mesh.vertices, moved_mesh.vertices]
    stored += [cloud.translate(shift).points - shift, mesh.translate(shift).vertices - shift]
    return [*stored, loom.PointCloud.concatenate(halves).points]


@pytest.mark.parametrize("corner", [[9.1234567, 51.1, 100.0], [-71.3, -0.01, 2000.0], [0.2, 51.5, -30.0]])
@pytest.mark.parametrize("extent", [0.0, 0.0045, 0.5])
def test_degrees_beside_heights_in_meters_keep_the_float32_of_their_extent(device, extent, corner, rng, tolerances):
    count = 1 if extent == 0 else 300
    values = rng.random((count, 3)) * [1.6 * extent, extent, 200] + corner
    limit = 2 * tolerances.float32_relative * (1.6 * extent + 2.0**-6)  # the origin is rounded, and moved points twice
    for stored in ways_to_store(values, device):
        assert np.abs(stored - values)[:, :2].max() <= limit
        assert np.abs(stored - values)[:, 2].max() <= tolerances.float32_relative * 2200


def test_points_in_degrees_have_an_origin_for_any_extent(device, rng, tolerances):
    values = rng.random((300, 3)) * [40, 25, 3000] + [-10, 35, 0]
    cloud = loom.PointCloud(values, device=device)
    assert not cloud.origin.any()
    for options in ({"unit": "degree"}, {"crs": 4326}, {"crs": 'GEOGCRS["any name"]'}, {"crs": "+proj=longlat"}):
        cloud = loom.PointCloud(values, device=device, **options)
        assert cloud.origin[:2].all() and cloud.translate([0, 1, 0]).origin[:2].all()
        assert np.abs(cloud.points - values)[:, :2].max() <= 21 * tolerances.float32_relative
        cloud.points = values
        assert cloud.origin[:2].all()
    assert not loom.PointCloud(values, crs=25832, device=device).origin.any()


@pytest.mark.parametrize(
    "values",
    [
        [[7, 2, 3]],  # exact in float32
        [[0.1, 0.2, 0.3]],
        np.c_[np.random.default_rng(0).random((300, 2)), np.full(300, 2.7)],  # a floor, and one with noise
        np.random.default_rng(0).normal(size=(300, 3)) * [2, 3, 0.001] + [0, 0, 2.7],
        np.random.default_rng(0).random((300, 3)) * [200, 200, 3] + [0, 0, 140.3],  # terrain
        (np.random.default_rng(0).random((300, 3)) * [0.01, 0.01, 200] + [9, 51, 0]).astype(np.float32),
    ],
)
def test_points_that_float32_resolves_keep_a_zero_origin(device, values):
    for made in (loom.PointCloud(values, device=device), loom.TriangleMesh(values, [], device=device)):
        assert not made.origin.any()
        assert not made.translate([0, 0, 0.1]).origin.any() or len(values) == 1


def test_an_axis_that_float32_would_wipe_out_has_an_origin(device, rng, tolerances):
    wall = rng.random((300, 3)) * [0.02, 800, 800] + [5000, -250, 0]
    cloud = loom.PointCloud(wall, device=device)
    assert cloud.origin[0] and not cloud.origin[1:].any()
    assert np.abs(cloud.points - wall)[:, 0].max() <= tolerances.float32_relative


@pytest.mark.parametrize("options", [{}, {"crs": 4326}])
@pytest.mark.parametrize("stray", [[0, 0, 0], [0, 0, 1]])
@pytest.mark.parametrize(("corner", "extent"), [([9.1, 51.2, 100], [0.004, 0.003, 200]), ([5000, 0, 0], [1, 1, 1])])
def test_a_stray_point_takes_no_precision_from_moved_points(device, corner, extent, stray, options, rng, tolerances):
    values = np.vstack([rng.random((300, 3)) * extent + corner, [stray]])
    moved = loom.PointCloud(values, device=device, **options).translate([0.1, 0.1, 0.1]).points
    vertices = loom.TriangleMesh(values, [], device=device).translate([0.1, 0.1, 0.1]).vertices
    for result in (moved, vertices):
        errors = np.abs(result - values - 0.1)[:-1]
        assert errors[:, :2].max() <= 2 * tolerances.float32_relative * (extent[0] + 0.2)  # moved by 0.1, rounded twice


def test_float32_degrees_that_have_lost_digits_are_warned_about(device, rng):
    degrees = (rng.random((300, 3)) * [0.01, 0.01, 300] + [9, 51, 0]).astype(np.float32)
    with pytest.warns(UserWarning, match="float32 coordinates near 51 are multiples of"):
        loom.PointCloud(degrees, device=device, crs=4326)
    with pytest.warns(UserWarning, match="float32 coordinates near 51 are multiples of"):
        loom.PointCloud(upload(degrees, vec3, device), unit="degree")


def test_an_empty_cloud_with_an_origin_moves(device):
    empty = loom.PointCloud([[5e5, 5e6, 100.0]], device=device).select_by_index([])
    for moved in (empty.translate([-5e5, -5e6, -100]), empty.transform(np.eye(4)), empty.scale(2.0, [0, 0, 0])):
        assert len(moved) == 0
