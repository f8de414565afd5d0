"""Selecting by index and mask, crops by boxes, and points that are not finite."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointloom as loom

from .full_clouds import UTM, full_cloud

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
