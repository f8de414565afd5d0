"""Selecting points: duplicates and complements of lists. Crops by boxes are tested in test_cropping.py."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import pointloom as loom

from .any_cloud import NOT_FINITE, clouds, examples, parts
from .open3d_clouds import cloud_of


def first_rows(points):
    """Rows of first occurrences, by a set; a row with a NaN is equal to none."""
    rows, seen = [], set()
    for row, point in enumerate(points.tolist()):
        if np.isnan(point).any() or tuple(point) not in seen:
            rows.append(row)
        seen.add(tuple(point))
    return rows


def open3d_without_duplicates(o3d, points):
    return np.asarray(cloud_of(o3d, points).remove_duplicated_points().points)


@examples(30)
@given(points=clouds(parts(1, 1), NOT_FINITE, st.sampled_from([-0.0, 1e-45, 0.1])))
def test_first_occurrences_of_any_small_cloud_are_left(device, points):
    cloud = loom.PointCloud(points, device=device, row=np.arange(len(points)))
    assert cloud.remove_duplicated_points()["row"].tolist() == first_rows(points.astype(np.float32))


def test_zeros_of_both_signs_are_equal_and_nan_equals_nothing_as_in_open3d(device, oracle):
    points = np.array([[0, 0, 0], [np.nan, 0, 0], [-0.0, 0, 0], [np.nan, 0, 0], [np.inf, 0, 0], [np.inf, 0, 0]])
    cloud = loom.PointCloud(points, device=device, row=np.arange(6))
    assert cloud.remove_duplicated_points()["row"].tolist() == [0, 1, 3, 4]
    expected = oracle("pcd/selection/zeros", open3d_without_duplicates, points)
    np.testing.assert_array_equal(cloud.remove_duplicated_points().points, expected)


@pytest.mark.parametrize("count", [0, 1, 2, 1000])
def test_equal_points_become_the_first_of_them_with_its_attributes(device, count):
    cloud = loom.PointCloud(
        np.full((count, 3), 5.4e6), normals=np.arange(3.0 * count).reshape(-1, 3), time=np.arange(count) / 3,
        device=device,
    )  # fmt: skip
    result = cloud.remove_duplicated_points()
    assert len(result) == min(count, 1)
    np.testing.assert_array_equal(result.points, cloud.points[:1])
    np.testing.assert_array_equal(result.normals, cloud.normals[:1])
    np.testing.assert_array_equal(result["time"], cloud["time"][:1])


KEYS = {
    "a slice": slice(2, 9, 3), "an open slice": slice(None, 4), "a slice from the end": slice(-3, None),
    "a slice backwards": slice(None, None, -2), "a slice beyond": slice(8, 99), "an empty slice": slice(5, 5),
    "a mask": np.arange(10) % 3 == 1, "a list of booleans": [True, False] * 5, "an empty mask": np.zeros(10, bool),
    "indices": np.array([7, 0, 0, 3]), "indices from the end": [-1, -10, 4], "no index": [],
    "unsigned indices": np.array([9, 2], np.uint8), "a view": np.arange(10)[::-3],
}  # fmt: skip


@pytest.mark.parametrize("name", KEYS)
def test_points_are_selected_as_numpy_selects_rows(device, name):
    rng, key = np.random.default_rng(0), KEYS[name]
    cloud = loom.PointCloud(
        np.add(rng.random((10, 3)), [5e5, 5e6, 0]), normals=rng.normal(size=(10, 3)), colors=rng.random((10, 3)),
        label=np.arange(10), weights=rng.random((10, 2)).astype(np.float32), unit="metre", device=device,
    )  # fmt: skip
    result, rows = cloud[key], np.zeros(0, int) if name == "no index" else key
    for attribute in ("points", "normals", "colors", "label", "weights"):
        np.testing.assert_array_equal(result[attribute], cloud[attribute][rows])
        assert result[attribute].dtype == cloud[attribute].dtype
    assert (result.unit, result.device) == (cloud.unit, cloud.device)
    np.testing.assert_array_equal(result.origin, cloud.origin)


def test_arrays_of_the_device_select_too(device):
    import warp as wp

    cloud = loom.PointCloud(np.arange(30.0).reshape(10, 3), device=device)
    indices, mask = np.array([3, -1, 0]), np.arange(10) > 6
    for key in (indices, mask):
        given = wp.array(key, dtype=wp.bool if key.dtype == bool else wp.int64, device=device)
        np.testing.assert_array_equal(cloud[given].points, cloud.points[key])
