"""Selecting points: duplicates, the complement of a list; crops by boxes stand in test_cropping.py."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import pointloom as loom

from .any_cloud import NOT_FINITE, clouds, examples, parts
from .open3d_clouds import cloud_of


def first_rows(points):
    """Rows of first occurrences, by a set; a row with a NaN equals none."""
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
    found = cloud.remove_duplicated_points()
    assert len(found) == min(count, 1)
    np.testing.assert_array_equal(found.points, cloud.points[:1])
    np.testing.assert_array_equal(found.normals, cloud.normals[:1])
    np.testing.assert_array_equal(found["time"], cloud["time"][:1])
