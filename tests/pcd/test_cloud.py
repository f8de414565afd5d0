"""PointCloud: what it accepts and refuses, what each operation keeps, and that no operation changes its operand."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointloom as loom
from pointloom.pcd.coordinates import ORIGIN_LIMIT
from pointloom.pcd.devices import check_same_device

UTM = np.array([5.01234e5, 5.412345e6, 212.5])
EXTRAS = ("ring", "time", "label", "pair", "half", "flag")


def full_cloud(rng, device, count=200, shift=0.0):
    """A cloud with normals, colours and attributes of many types."""
    normals = rng.normal(size=(count, 3))
    return loom.PointCloud(
        rng.random((count, 3)) * 10 + shift,
        normals=normals / np.linalg.norm(normals, axis=1, keepdims=True),
        colors=rng.random((count, 3)),
        device=device,
        ring=rng.integers(0, 64, count).astype(np.uint8),
        time=rng.random(count) + 1.7e9,
        label=rng.integers(-(2**31), 2**31, count).astype(np.int32),
        pair=rng.random((count, 2)).astype(np.float32),
        half=rng.random(count).astype(np.float16),
        flag=rng.random(count) < 0.5,
    )


def contents(cloud):
    """Everything that a cloud holds, copied."""
    names = ["points", *(n for n in ("normals", "colors") if n in cloud), *cloud.attributes]
    return {n: cloud.array(n).numpy().copy() for n in names} | {"origin": cloud.origin, "grid": cloud.grid}


def assert_same(left, right):
    assert list(left) == list(right)
    for name, values in left.items():
        if name != "grid":
            assert values.dtype == right[name].dtype, name
        np.testing.assert_array_equal(values, right[name], err_msg=name)


def rigid(rng, shift=1.0):
    q, r = np.linalg.qr(rng.normal(size=(3, 3)))
    q = q * np.sign(np.diag(r))
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = q if np.linalg.det(q) > 0 else -q, rng.normal(size=3) * shift
    return T


# ------------------------------------------------------------------------------------------------ construction


def test_a_cloud_gives_back_what_it_was_made_of(device, rng):
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
        ):  # fmt: skip
            assert len(result) == 0 and list(result.attributes) == list(cloud.attributes)
        assert cloud.get_min_bound().tolist() == cloud.get_max_bound().tolist() == [0, 0, 0]


@pytest.mark.parametrize("dtype", ["i1", "u1", "i2", "u4", "i8", "f2", "f4", "f8", ">f4", ">f8", ">i2", "?"])
def test_points_and_attributes_of_any_number_type_are_taken(device, dtype):
    values = np.array([[0, 1, 0], [1, 1, 0], [1, 0, 1]]).astype(dtype)
    cloud = loom.PointCloud(values, device=device, extra=values[:, 0], wide=values)
    np.testing.assert_array_equal(cloud.points, values.astype(float))
    for name, expected in (("extra", values[:, 0]), ("wide", values)):
        assert cloud[name].dtype == np.dtype(dtype).newbyteorder("=")
        np.testing.assert_array_equal(cloud[name], expected)
    assert len(cloud.voxel_down_sample(0.25)) == 3


def test_whole_numbers_beyond_the_origins_limit_are_exact(device):
    points = np.array([[500_000, 5_400_000, 10], [500_003, 5_400_001, -10]])
    np.testing.assert_array_equal(loom.PointCloud(points, device=device).points, points)


def test_8_bit_colours_are_divided_by_255(device):
    cloud = loom.PointCloud(np.zeros((2, 3)), colors=np.array([[255, 0, 51], [1, 2, 3]], np.uint8), device=device)
    np.testing.assert_allclose(cloud.colors, [[1, 0, 0.2], [1 / 255, 2 / 255, 3 / 255]], rtol=6.1e-8)


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        ({"points": np.zeros((3, 100))}, ValueError, r"points: expected shape \[n, 3\], got \[3, 100\]"),
        ({"points": np.zeros(3)}, ValueError, r"points: expected shape \[n, 3\], got \[3\]"),
        ({"points": np.zeros((3, 0))}, ValueError, r"points: expected shape \[n, 3\], got \[3, 0\]"),
        ({"points": np.zeros((2, 3, 3))}, ValueError, r"points: expected shape \[n, 3\], got \[2, 3, 3\]"),
        ({"points": "abc"}, TypeError, "points: expected real numbers"),
        ({"points": [[0, 0, 0], [1, 1]]}, TypeError, "points: expected numbers"),
        ({"points": np.zeros((2, 3), complex)}, TypeError, "points: expected real numbers, got complex128"),
        ({"points": [[1e300, 0, 0], [-1e300, 0, 0]]}, ValueError, "points: .* reach beyond float32"),
        ({"origin": [0, np.nan, 0]}, ValueError, "origin: expected finite numbers"),
        ({"origin": [0, 0]}, ValueError, r"origin: expected shape \[3\], got \[2\]"),
        ({"normals": np.zeros((3, 3))}, ValueError, r"normals: expected shape \[2, 3\] as the cloud has 2 points"),
        ({"normals": np.zeros((2, 2))}, ValueError, r"normals: expected shape \[n, 3\], got \[2, 2\]"),
        ({"normals": [[1e39, 0, 0]] * 2}, ValueError, r"normals: 1e\+39 is beyond the range of float32"),
        ({"colors": np.zeros((1, 3))}, ValueError, "colors: expected shape"),
        ({"colors": np.full((2, 3), 1.01)}, ValueError, "colors: expected 0..1, got 1.01..1.01; divide 8-bit"),
        ({"colors": np.full((2, 3), -0.01)}, ValueError, "colors: expected 0..1"),
        ({"colors": np.full((2, 3), 255)}, ValueError, "colors: expected 0..1, got 255..255; divide 8-bit"),
        ({"colors": np.full((2, 3), np.nan)}, ValueError, "colors: expected 0..1, got nan"),
        ({"colors": [[1e300, 0, 0]] * 2}, ValueError, "colors: expected 0..1"),
        ({"ring": np.zeros(3)}, ValueError, r"ring: expected shape \[2\] or \[2, c\], got \[3\]"),
        ({"ring": 5}, ValueError, r"ring: expected shape \[2\] or \[2, c\], got \[\]"),
        ({"ring": np.zeros((2, 2, 2))}, ValueError, r"ring: expected shape \[2\] or \[2, c\], got \[2, 2, 2\]"),
        ({"ring": ["a", "b"]}, TypeError, "ring: expected real numbers"),
        ({"ring": np.zeros(2, np.longdouble)}, TypeError, "ring: expected numbers of 64 bits at most"),
        ({"device": "gpu"}, loom.DeviceError, "device: expected one of cpu"),
        ({"device": "cuda:99"}, loom.DeviceError, "device: expected one of cpu"),
        ({"device": object()}, loom.DeviceError, "device: expected one of cpu"),
    ],
)
def test_wrong_arguments_are_named(arguments, error, message):
    with pytest.raises(error, match=message):
        loom.PointCloud(**({"points": np.zeros((2, 3))} | arguments))


def test_nan_and_infinite_points_are_taken_and_kept(device):
    points = np.array([[np.nan, 0, 0], [np.inf, -np.inf, 1], [1, 2, 3], [2e4, 0, 0]])
    cloud = loom.PointCloud(points, device=device)
    np.testing.assert_array_equal(cloud.points, points)
    assert cloud.get_min_bound().tolist() == [1, 0, 0] and cloud.get_max_bound().tolist() == [2e4, 2, 3]


def test_a_missing_array_is_an_error_that_says_what_to_do(device):
    cloud = loom.PointCloud(np.zeros((2, 3)), device=device, ring=[1, 2])
    for call, message in (
        (lambda: cloud.normals, r"no normals: call estimate_normals\(\)"),
        (lambda: cloud.colors, "no colors: assign cloud.colors"),
        (lambda: cloud["time"], "no time: the cloud has points, ring"),
        (lambda: cloud.array("time"), "no time: the cloud has points, ring"),
        (lambda: cloud.orient_normals_towards_camera_location(), "no normals"),
    ):
        with pytest.raises(ValueError, match=message):
            call()
    with pytest.raises(TypeError, match="no sequence"):
        iter(cloud)


def test_what_is_assigned_is_checked_and_read_back(device, rng):
    cloud = loom.PointCloud(np.zeros((4, 3)), device=device)
    cloud.normals, cloud.colors, cloud["ring"] = np.ones((4, 3)), np.zeros((4, 3)), np.arange(4)
    cloud["points"] = rng.random((4, 3)) + UTM
    assert cloud.origin.tolist() == np.round(cloud.origin).tolist() != [0, 0, 0]
    assert list(contents(cloud)) == ["points", "normals", "colors", "ring", "origin", "grid"]
    for name in ("points", "normals", "colors", "ring"):
        with pytest.raises(ValueError, match=f"{name}: expected"):
            cloud[name] = np.zeros((5, 3))


def test_reading_gives_copies(device, rng):
    cloud = full_cloud(rng, device)
    before = contents(cloud)
    for name in ("points", "normals", "colors", "origin"):
        getattr(cloud, name)[:] = 7
    for name in EXTRAS:
        cloud[name][:] = 1
        cloud.attributes[name][:] = 1
    assert_same(contents(cloud), before)


def test_the_device_array_is_shared_and_not_copied(device, rng):
    cloud = full_cloud(rng, device)
    array = cloud.array("points")
    assert cloud.array("points") is array and array.shape == (200,)
    if not array.device.is_cuda:
        view = np.asarray(array)
        view[0] = [1, 2, 3]
        assert cloud.points[0].tolist() == [1, 2, 3]
        assert np.shares_memory(np.from_dlpack(cloud.array("time")), cloud.array("time").numpy())


# ------------------------------------------------------------------------------------------------ far coordinates


def test_the_origin_stays_at_zero_up_to_its_limit_and_moves_beyond(device):
    at = loom.PointCloud([[ORIGIN_LIMIT, 0, -ORIGIN_LIMIT]], device=device)
    beyond = loom.PointCloud([[ORIGIN_LIMIT + 1, 0, 0], [ORIGIN_LIMIT - 3, 10, 0]], device=device)
    assert at.origin.tolist() == [0, 0, 0] and beyond.origin.tolist() == [ORIGIN_LIMIT - 1, 5, 0]


@pytest.mark.parametrize("extent", [1.0, 100.0, 5000.0])
def test_utm_coordinates_survive_to_the_float32_of_their_extent(device, extent, rng, tolerances):
    points = UTM + (rng.random((500, 3)) - 0.5) * extent
    error = np.abs(loom.PointCloud(points, device=device).points - points).max()
    assert error <= tolerances.float32_relative * (extent / 2 + 1) + 1e-9  # half a metre from rounding the origin
    assert error < tolerances.position
    float32_alone = np.abs(points.astype(np.float32) - points).max()
    assert float32_alone > 0.1


def test_utm_coordinates_survive_every_operation(device, rng, tolerances):
    cloud = full_cloud(rng, device, shift=UTM)
    exact = cloud.points
    T = np.eye(4)
    T[:3, 3] = [1e5, -2e5, 3]
    box = loom.AxisAlignedBoundingBox(UTM + 2, UTM + 8)
    inside = ((exact >= UTM + 2) & (exact <= UTM + 8)).all(axis=1)
    limit = tolerances.position / 100
    np.testing.assert_allclose(cloud.transform(T).points, exact + T[:3, 3], rtol=0, atol=limit)
    np.testing.assert_allclose(cloud.transform(T).transform(np.linalg.inv(T)).points, exact, rtol=0, atol=limit)
    np.testing.assert_array_equal(cloud.crop(box).points, exact[inside])
    np.testing.assert_array_equal(cloud.select_by_index([5, -1]).points, exact[[5, -1]])
    np.testing.assert_allclose(cloud.get_min_bound(), exact.min(axis=0), rtol=0, atol=1e-9)
    one = cloud.voxel_down_sample(1000.0)
    np.testing.assert_allclose(one.points, exact.mean(axis=0)[None], rtol=0, atol=limit)


@pytest.mark.parametrize("stray", [[0, 0, 0], [1e7, 0, 0], [0, 0, -1e12]])
def test_one_stray_point_takes_no_precision_from_the_others(device, stray, rng, tolerances):
    for shift in (np.zeros(3), UTM):
        points = np.vstack([rng.random((500, 3)) + shift, [stray]])
        cloud = loom.PointCloud(points, device=device)
        limit = 2 * tolerances.float32_relative + 1e-9
        np.testing.assert_allclose(cloud.points[:-1], points[:-1], rtol=0, atol=limit)
        T = np.eye(4)
        T[:3, 3] = UTM - 2 * shift
        moved = cloud.transform(T)
        np.testing.assert_allclose(moved.points[:-1], points[:-1] + T[:3, 3], rtol=0, atol=2 * limit)


def test_zeros_of_missing_measurements_take_no_precision_from_a_far_cloud(device, rng, tolerances):
    points = np.vstack([np.zeros((9000, 3)), rng.random((500, 3)) + UTM])
    found = loom.PointCloud(points, device=device).points
    np.testing.assert_allclose(found[9000:], points[9000:], rtol=0, atol=2 * tolerances.float32_relative + 1e-9)


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
    """A shear whose rows cancel along the diagonal of the box, and still carry its corners beyond 1e4."""
    corners = np.stack(np.meshgrid(*[[1000.0, 2000.0]] * 3), -1).reshape(-1, 3) + 1 / 3
    T = np.eye(4)
    T[:3, :3] = [[100, -100, 0], [0, 100, -100], [0, 0, 1]]
    T[:3, 3] = [9e3, 0, 0]
    cloud = loom.PointCloud(corners, device=device).transform(T)
    assert cloud.origin.any()
    expected = corners.astype(np.float32).astype(float) @ T[:3, :3].T + T[:3, 3]
    limit = tolerances.float32_relative * np.abs(expected - cloud.origin).max()
    np.testing.assert_allclose(cloud.points, expected, rtol=0, atol=limit)


# ------------------------------------------------------------------------------------------------ operations


def operations():
    box = loom.AxisAlignedBoundingBox([2, 2, 2], [8, 8, 8])
    turned = loom.OrientedBoundingBox([5, 5, 5], np.eye(3), [6, 6, 6])
    T = np.diag([2.0, 2, 2, 1])
    return {
        "select_by_index": lambda c: c.select_by_index([3, 1, 1]),
        "select_by_index inverted": lambda c: c.select_by_index([3, 1], invert=True),
        "select_by_mask": lambda c: c.select_by_mask(np.arange(len(c)) % 2 == 0),
        "crop": lambda c: c.crop(box),
        "crop inverted": lambda c: c.crop(box, invert=True),
        "crop turned": lambda c: c.crop(turned),
        "remove_non_finite_points": lambda c: c.remove_non_finite_points(),
        "voxel_down_sample": lambda c: c.voxel_down_sample(3.0),
        "transform": lambda c: c.transform(T),
        "estimate_normals": lambda c: c.estimate_normals(radius=4.0),
        "estimate_normals within": lambda c: c.estimate_normals(radius=4.0, max_nn=None),
        "orient to direction": lambda c: c.orient_normals_to_align_with_direction([1, 0, 0]),
        "orient to camera": lambda c: c.orient_normals_towards_camera_location([0, 0, 99]),
        "copy": lambda c: c.copy(),
    }


@pytest.mark.parametrize("name", operations())
def test_an_operation_carries_all_attributes_and_leaves_its_operand_as_it_was(device, name, rng):
    cloud = full_cloud(rng, device)
    before = contents(cloud)
    result = operations()[name](cloud)
    assert_same(contents(cloud), before)
    assert result is not cloud and set(contents(result)) == set(before)
    for attribute in EXTRAS:
        assert result[attribute].dtype == cloud[attribute].dtype and len(result[attribute]) == len(result) > 0
    after = contents(result)
    result.points, result.colors, result["ring"] = result.points + 1, np.zeros((len(result), 3)), np.ones(len(result))
    assert_same(contents(cloud), before), "what is assigned to the result does not reach the operand"
    again = operations()[name](cloud)
    assert_same(contents(again), after)


@pytest.mark.parametrize(
    ("name", "own"),
    [
        ("transform", {"points", "normals"}), ("estimate_normals", {"normals"}), ("orient to direction", {"normals"}),
        ("orient to camera", {"normals"}), ("copy", set()),
    ],
)  # fmt: skip
def test_an_operation_shares_the_arrays_that_it_did_not_change(device, name, own, rng):
    cloud = full_cloud(rng, device)
    result = operations()[name](cloud)
    for array in ("points", "normals", "colors", *EXTRAS):
        assert (result.array(array) is cloud.array(array)) == (array not in own), array


@pytest.mark.parametrize(
    "name", ["select_by_index", "select_by_mask", "crop", "crop inverted", "crop turned", "remove_non_finite_points"]
)
def test_each_selected_point_keeps_its_own_attributes(device, name, rng):
    cloud = full_cloud(rng, device)
    cloud["row"] = np.arange(len(cloud))
    result = operations()[name](cloud)
    rows = result["row"]
    for array in ("points", "normals", "colors", *EXTRAS):
        np.testing.assert_array_equal(result[array], cloud[array][rows])


def test_a_cloud_moved_to_where_it_is_is_itself(device, rng):
    cloud = full_cloud(rng, device)
    assert cloud.to(device) is cloud and cloud.to(cloud.device) is cloud
    with pytest.raises(loom.DeviceError, match="device: expected one of"):
        cloud.to("cuda:99")


def test_a_cloud_moved_to_another_device_and_back_is_the_same(device, rng, monkeypatch):
    """Without a GPU the cloud is said to be elsewhere: then all but the copy itself is tested."""
    cloud = full_cloud(rng, device, shift=UTM)
    cloud.grid = (20, 10)
    if not cloud.device.is_cuda:
        monkeypatch.setattr(
            loom.PointCloud, "device", property(lambda c: "cuda:7" if c is cloud else c.array("points").device)
        )
    there = cloud.to("cpu")
    assert str(there.device) == "cpu" and there is not cloud
    assert_same(contents(there), contents(cloud))
    assert_same(contents(there.to(device)), contents(cloud))


def test_operands_on_two_devices_are_an_error(rng, monkeypatch):
    """A stand-in for a second device, so that the rule is held where there is no GPU."""
    cloud, other = loom.PointCloud(rng.random((9, 3))), loom.PointCloud(rng.random((9, 3)))
    search = loom.NearestNeighborSearch(cloud)
    monkeypatch.setattr(
        loom.PointCloud, "device", property(lambda c: "cuda:7" if c is other else c.array("points").device)
    )
    for call in (lambda: search.knn_search(other, 1), lambda: search.radius_search(other, 1.0)):
        with pytest.raises(loom.DeviceError, match=r"queries: operands on cuda:7 and cpu; move one with .to\('cpu'\)"):
            call()
    with pytest.raises(loom.DeviceError, match="left: operands on a and b"):
        check_same_device("left", "a", "b")


# ------------------------------------------------------------------------------------------------ selection


def test_indices_select_in_their_order_with_repeats_and_count_from_the_end(device, rng):
    cloud = full_cloud(rng, device)
    indices = [7, -1, 7, 0, -200, 199]
    np.testing.assert_array_equal(cloud.select_by_index(indices).points, cloud.points[indices])
    few = np.array([7, -1, 7], np.int8)
    np.testing.assert_array_equal(cloud.select_by_index(few)["label"], cloud["label"][few])
    left = np.setdiff1d(np.arange(200), np.array(indices) % 200)
    np.testing.assert_array_equal(cloud.select_by_index(indices, invert=True).points, cloud.points[left])
    assert len(cloud.select_by_index([])) == 0 and len(cloud.select_by_index([], invert=True)) == 200


@pytest.mark.parametrize(
    ("indices", "error", "message"),
    [
        ([3], IndexError, "indices: 3..3 reach beyond a cloud of 3 points"),
        ([0, -4], IndexError, "indices: -4..0 reach beyond a cloud of 3 points"),
        (np.array([2**64 - 1], np.uint64), IndexError, "indices: 18446744073709551615"),
        ([0.0, 1.0], TypeError, "indices: expected whole numbers, got float64"),
        ([True, False, True], TypeError, "indices: expected whole numbers, got bool; for a mask see select_by_mask"),
        (["a"], TypeError, "indices: expected real numbers"),
    ],
)
def test_wrong_indices_are_refused(indices, error, message):
    for invert in (False, True):
        with pytest.raises(error, match=message):
            loom.PointCloud(np.zeros((3, 3))).select_by_index(indices, invert=invert)


def test_a_mask_selects_where_it_is_set(device, rng):
    cloud = full_cloud(rng, device)
    mask = rng.random(200) < 0.4
    np.testing.assert_array_equal(cloud.select_by_mask(mask).points, cloud.points[mask])
    np.testing.assert_array_equal(cloud.select_by_mask(list(map(bool, mask)), invert=True).points, cloud.points[~mask])
    for wrong in (mask.astype(int), mask[:5], mask[:, None], []):
        with pytest.raises(ValueError, match=r"mask: expected booleans of shape \[200\], got"):
            cloud.select_by_mask(wrong)


@pytest.mark.parametrize("invert", [False, True])
def test_cropping_selects_what_open3d_selects_faces_included(device, invert, rng, to_open3d):
    import open3d as o3d

    points = np.concatenate([rng.integers(-4, 5, (2000, 3)) / 4.0, rng.random((1000, 3)) * 2 - 1])
    cloud, oracle = loom.PointCloud(points, device=device), to_open3d(points.astype(np.float32))
    low, high = np.array([-0.5, -1, 0.25]), np.array([0.5, 0.75, 1])
    found = cloud.crop(loom.AxisAlignedBoundingBox(low, high), invert)
    expected = np.asarray(oracle.crop(o3d.geometry.AxisAlignedBoundingBox(low, high), invert).points)
    np.testing.assert_array_equal(found.points, expected)
    R = o3d.geometry.get_rotation_matrix_from_xyz((0.3, -0.5, 1.1))
    for turn in (np.eye(3), R):
        found = cloud.crop(loom.OrientedBoundingBox((low + high) / 2, turn, high - low), invert)
        box = o3d.geometry.OrientedBoundingBox((low + high) / 2, turn, high - low)
        np.testing.assert_array_equal(found.points, np.asarray(oracle.crop(box, invert).points))
    assert 0 < len(found) < 3000


def test_cropping_to_a_face_typed_in_float64_keeps_the_points_on_it(device):
    points = np.array([[0.1, 0.2, 0.3], [0.1, 0.2, 0.4], [UTM[0] % 1, 0.7, 0.9]])
    for shift in (0.0, UTM):
        cloud = loom.PointCloud(points + shift, device=device)
        for point in points + shift:
            assert len(cloud.crop(loom.AxisAlignedBoundingBox(point, point))) == 1


def test_the_bounds_of_a_cloud_crop_all_of_it(device, rng):
    cloud = full_cloud(rng, device, shift=UTM)
    box = loom.AxisAlignedBoundingBox(cloud.get_min_bound(), cloud.get_max_bound())
    assert len(cloud.crop(box)) == 200 and len(cloud.crop(box, invert=True)) == 0


@pytest.mark.parametrize(
    "make",
    [
        lambda: loom.AxisAlignedBoundingBox([0, 0, 0], [1, -1, 1]),
        lambda: loom.AxisAlignedBoundingBox([0, np.nan, 0], [1, 1, 1]),
        lambda: loom.AxisAlignedBoundingBox([0, 0], [1, 1]),
        lambda: loom.OrientedBoundingBox([0, 0, 0], np.eye(3) * 2, [1, 1, 1]),
        lambda: loom.OrientedBoundingBox([0, 0, 0], np.diag([1, 1, -1]), [1, 1, 1]),
        lambda: loom.OrientedBoundingBox([0, 0, np.inf], np.eye(3), [1, 1, 1]),
        lambda: loom.OrientedBoundingBox([0, 0, 0], np.eye(3), [1, -1, 1]),
    ],
)
def test_boxes_that_are_none_are_refused(make):
    with pytest.raises(ValueError, match="expected"):
        make()
    with pytest.raises(TypeError, match="expected a bounding box, got tuple"):
        loom.PointCloud().crop((0, 1))


@pytest.mark.parametrize("remove_nan", [True, False])
@pytest.mark.parametrize("remove_infinite", [True, False])
def test_points_that_are_not_finite_are_removed_as_in_open3d(device, remove_nan, remove_infinite, rng, to_open3d):
    points = rng.random((300, 3)).astype(np.float32)
    points[::3, 0], points[1::7, 2], points[6, 1] = np.nan, np.inf, -np.inf
    cloud = loom.PointCloud(points, device=device, row=np.arange(300))
    found = cloud.remove_non_finite_points(remove_nan, remove_infinite)
    expected = to_open3d(points).remove_non_finite_points(remove_nan, remove_infinite)
    np.testing.assert_array_equal(found.points, np.asarray(expected.points))
    np.testing.assert_array_equal(points[found["row"]], found.points)


# ------------------------------------------------------------------------------------------------ transform


@pytest.mark.parametrize("scale", [1.0, 0.001, 250.0])
def test_a_transform_is_that_of_numpy_in_float64(device, scale, rng, tolerances):
    cloud, T = full_cloud(rng, device), rigid(rng)
    T[:3, :3] *= scale
    result = cloud.transform(T)
    expected = cloud.points @ T[:3, :3].T + T[:3, 3]
    size = np.abs(expected - result.origin).max()
    np.testing.assert_allclose(result.points, expected, rtol=0, atol=tolerances.transform_relative * size)
    turned = cloud.normals.astype(float) @ (T[:3, :3] / scale).T
    np.testing.assert_allclose(result.normals, turned, rtol=0, atol=tolerances.unit_length)


def test_normals_stay_normal_to_a_sheared_plane(device, rng, tolerances):
    A = np.array([[1, 2, 0], [0, 1, 0.5], [0.3, 0, -2]])
    n = np.array([0.6, 0, 0.8])
    u, v = np.array([0, 1, 0.0]), np.array([0.8, 0, -0.6])
    T = np.eye(4)
    T[:3, :3] = A
    turned = loom.PointCloud(np.zeros((1, 3)), normals=n[None], device=device).transform(T).normals[0]
    assert abs(turned @ (A @ u)) < 4 * tolerances.unit_length and abs(turned @ (A @ v)) < 4 * tolerances.unit_length
    np.testing.assert_allclose(np.linalg.norm(turned), 1, rtol=tolerances.unit_length)


@pytest.mark.parametrize(
    "matrix",
    [
        np.eye(3), np.full((4, 4), np.nan), np.diag([1.0, 1, 1, 2]), np.diag([0.0, 1, 1, 1]), np.zeros((4, 4)),
        np.ones((4, 4)), np.diag([np.inf, 1, 1, 1]),
    ],
    ids=["3x3", "nan", "last row", "singular", "zero", "ones", "infinite"],
)  # fmt: skip
def test_a_matrix_that_is_no_affine_map_is_refused(matrix, rng):
    for cloud in (loom.PointCloud(rng.random((3, 3))), loom.PointCloud(rng.random((3, 3)), normals=np.ones((3, 3)))):
        with pytest.raises(ValueError, match="transformation: expected"):
            cloud.transform(matrix)


# ------------------------------------------------------------------------------------------------ any small cloud

number = st.one_of(
    st.integers(-3, 3).map(float),
    st.floats(-100, 100, width=32, allow_subnormal=False),
    st.sampled_from([np.nan, np.inf, -np.inf, 5e5, 1e-20]),
)
clouds = st.lists(st.tuples(number, number, number), max_size=40).map(lambda p: np.array(p, float).reshape(-1, 3))


@settings(derandomize=True, deadline=None, max_examples=60)
@given(points=clouds, seed=st.integers(0, 100))
def check_any_cloud(device, points, seed):
    rng = np.random.default_rng(seed)
    cloud = loom.PointCloud(points, device=device, row=np.arange(len(points)))
    held = cloud.points
    finite = np.isfinite(held).all(axis=1)
    np.testing.assert_array_equal(finite, np.isfinite(points).all(axis=1))
    np.testing.assert_allclose(held[finite], points[finite], rtol=1.2e-7, atol=0.07)  # 1e6 apart: 6.0e-8 of it
    assert cloud.remove_non_finite_points()["row"].tolist() == np.flatnonzero(finite).tolist()
    mask = rng.random(len(points)) < 0.5
    assert cloud.select_by_mask(mask)["row"].tolist() == np.flatnonzero(mask).tolist()
    low, high = np.sort(rng.uniform(-4, 4, (2, 3)), axis=0)
    inside = ((held >= low) & (held <= high)).all(axis=1)
    near_a_face = (np.abs(held - low) < 0.1).any(axis=1) | (np.abs(held - high) < 0.1).any(axis=1)
    found = np.isin(np.arange(len(points)), cloud.crop(loom.AxisAlignedBoundingBox(low, high))["row"])
    assert (found == inside)[~near_a_face].all()
    if finite.any():
        np.testing.assert_array_equal(cloud.get_min_bound(), held[finite].min(axis=0))
        np.testing.assert_array_equal(cloud.get_max_bound(), held[finite].max(axis=0))


def test_any_small_cloud_is_selected_as_numpy_selects(device):
    check_any_cloud(device)
