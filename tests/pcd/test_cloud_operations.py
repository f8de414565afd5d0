"""Operations of PointCloud: preserved attributes, unchanged operands, and transforms."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.devices import check_same_device

from .full_clouds import EXTRAS, UTM, assert_same, contents, full_cloud, rigid

NORMALS_ALONE = ["estimate_normals", "orient to direction", "orient to camera", "orient alike", "normalize", "flip"]


def operations():
    box = loom.AxisAlignedBoundingBox([2, 2, 2], [8, 8, 8])
    oriented = loom.OrientedBoundingBox([5, 5, 5], np.eye(3), [6, 6, 6])
    T = np.diag([2.0, 2, 2, 1])
    return {
        "select_by_index": lambda c: c.select_by_index([3, 1, 1]),
        "select_by_index inverted": lambda c: c.select_by_index([3, 1], invert=True),
        "select_by_mask": lambda c: c.select_by_mask(np.arange(len(c)) % 2 == 0),
        "crop": lambda c: c.crop(box),
        "crop inverted": lambda c: c.crop(box, invert=True),
        "crop turned": lambda c: c.crop(oriented),
        "remove_non_finite_points": lambda c: c.remove_non_finite_points(),
        "voxel_down_sample": lambda c: c.voxel_down_sample(3.0),
        "transform": lambda c: c.transform(T),
        "estimate_normals": lambda c: c.estimate_normals(radius=4.0),
        "estimate_normals within": lambda c: c.estimate_normals(radius=4.0, max_nn=None),
        "orient to direction": lambda c: c.orient_normals_to_align_with_direction([1, 0, 0]),
        "orient to camera": lambda c: c.orient_normals_towards_camera_location([0, 0, 99]),
        "orient alike": lambda c: c.orient_normals_consistent_tangent_plane(8),
        "normalize": lambda c: c.normalize_normals(),
        "flip": lambda c: c.flip_normals(),
        "copy": lambda c: c.copy(),
    }


@pytest.mark.parametrize("name", operations())
def test_operations_keep_all_attributes_and_their_operand(device, name, rng):
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


@pytest.mark.parametrize("name", ["transform", *NORMALS_ALONE, "copy"])
def test_an_operation_shares_the_arrays_that_it_did_not_change(device, name, rng):
    cloud = full_cloud(rng, device)
    cloud.grid = (20, 10)
    result = operations()[name](cloud)
    changed = {"copy": (), "transform": ("points", "normals")}.get(name, ("normals",))
    assert result.grid == (20, 10)
    for array in ("points", "normals", "colors", *EXTRAS):
        assert (result.array(array) is cloud.array(array)) == (array not in changed), array


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


def test_a_cloud_moved_to_another_device_and_back_is_the_same(device, rng, monkeypatch):
    """Without a GPU the cloud only claims another device: everything except the copy itself is tested."""
    cloud = full_cloud(rng, device, shift=UTM)
    cloud.grid = (20, 10)
    assert cloud.to(cloud.device) is cloud
    if not cloud.device.is_cuda:
        monkeypatch.setattr(
            loom.PointCloud, "device", property(lambda c: "cuda:7" if c is cloud else c.array("points").device)
        )
    there = cloud.to("cpu")
    assert str(there.device) == "cpu" and there is not cloud
    assert_same(contents(there), contents(cloud))
    assert_same(contents(there.to(device)), contents(cloud))


def test_operands_on_two_devices_are_an_error(rng, monkeypatch):
    """A stand-in for a second device tests the rule without a GPU."""
    cloud, other = loom.PointCloud(rng.random((9, 3))), loom.PointCloud(rng.random((9, 3)))
    search = loom.NearestNeighborSearch(cloud)
    monkeypatch.setattr(
        loom.PointCloud, "device", property(lambda c: "cuda:7" if c is other else c.array("points").device)
    )
    for call in (lambda: search.knn_search(other, 1), lambda: search.radius_search(other, 1.0)):
        with pytest.raises(loom.DeviceError, match="queries:"):
            call()
    with pytest.raises(loom.DeviceError, match="left:"):
        check_same_device("left", "a", "b")


@pytest.mark.parametrize("scale", [1.0, 0.001, 250.0])
def test_transform_agrees_with_numpy_in_float64(device, scale, rng, tolerances):
    cloud, T = full_cloud(rng, device), rigid(rng)
    T[:3, :3] *= scale
    result = cloud.transform(T)
    expected = cloud.points @ T[:3, :3].T + T[:3, 3]
    size = np.abs(expected - result.origin).max()
    np.testing.assert_allclose(result.points, expected, rtol=0, atol=tolerances.transform_relative * size)
    rotated = cloud.normals.astype(float) @ (T[:3, :3] / scale).T
    np.testing.assert_allclose(result.normals, rotated, rtol=0, atol=tolerances.unit_length)


def test_normals_stay_normal_to_a_sheared_plane(device, rng, tolerances):
    A = np.array([[1, 2, 0], [0, 1, 0.5], [0.3, 0, -2]])
    n = np.array([0.6, 0, 0.8])
    u, v = np.array([0, 1, 0.0]), np.array([0.8, 0, -0.6])
    T = np.eye(4)
    T[:3, :3] = A
    transformed = loom.PointCloud(np.zeros((1, 3)), normals=n[None], device=device).transform(T).normals[0]
    for across in (u, v):
        assert abs(transformed @ (A @ across)) < 4 * tolerances.unit_length
    np.testing.assert_allclose(np.linalg.norm(transformed), 1, rtol=tolerances.unit_length)
