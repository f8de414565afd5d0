"""Selecting points: duplicates, the complement of a list; crops by boxes stand in test_cropping.py."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointloom as loom

from ..scan_cases import on_sets


def first_rows(points):
    """Rows of first occurrences, by a set; a row with a NaN equals none."""
    rows, seen = [], set()
    for row, point in enumerate(points.tolist()):
        if np.isnan(point).any() or tuple(point) not in seen:
            rows.append(row)
        seen.add(tuple(point))
    return rows


@on_sets("digits", shipped=[1], real=[1, 2])
def test_points_left_of_the_fragment_are_open3ds(device, digits, fragment, to_open3d):
    """Rounded to a lattice of 10 cm and of 1 cm, so that most are duplicates."""
    points = np.round(fragment.points, digits).astype(np.float32)
    cloud = loom.PointCloud(points, device=device, row=np.arange(len(points)))
    oracle = to_open3d(points).remove_duplicated_points()
    found = cloud.remove_duplicated_points()
    assert len(found) < len(points) / 2
    np.testing.assert_array_equal(found.points, np.asarray(oracle.points))
    np.testing.assert_array_equal(found.points, points[found["row"]])


def test_points_left_of_a_lidar_scan_are_open3ds(device, lidar, to_open3d, rng):
    points = lidar[rng.integers(0, len(lidar), len(lidar)), :3]
    found = loom.PointCloud(points, device=device).remove_duplicated_points()
    np.testing.assert_array_equal(found.points, np.asarray(to_open3d(points).remove_duplicated_points().points))
    assert len(found) < 0.7 * len(points)


def test_duplicates_at_utm_coordinates_are_removed(device, shipped_file, to_open3d):
    cloud = loom.read_point_cloud(shipped_file("lidar-pcl-terrain/samp21-utm.pcd")).to(device)
    twice = cloud + cloud.select_by_index(np.arange(len(cloud))[::-1])
    found, oracle = twice.remove_duplicated_points(), to_open3d(cloud.points).remove_duplicated_points()
    np.testing.assert_array_equal(found.points, np.asarray(oracle.points))
    assert (found.origin == cloud.origin).all()


number = st.one_of(st.integers(-1, 1).map(float), st.sampled_from([-0.0, 1e-45, 0.1, np.nan, np.inf, -np.inf]))
clouds = st.lists(st.tuples(number, number, number), max_size=40).map(lambda p: np.array(p, float).reshape(-1, 3))


@settings(derandomize=True, deadline=None, max_examples=80)
@given(points=clouds)
def check_any_cloud(device, points):
    cloud = loom.PointCloud(points, device=device, row=np.arange(len(points)))
    assert cloud.remove_duplicated_points()["row"].tolist() == first_rows(points.astype(np.float32))


def test_first_occurrences_of_any_small_cloud_are_left(device):
    check_any_cloud(device)


def test_zeros_of_both_signs_are_equal_and_nan_equals_nothing_as_in_open3d(device, to_open3d):
    points = np.array([[0, 0, 0], [np.nan, 0, 0], [-0.0, 0, 0], [np.nan, 0, 0], [np.inf, 0, 0], [np.inf, 0, 0]])
    cloud = loom.PointCloud(points, device=device, row=np.arange(6))
    assert cloud.remove_duplicated_points()["row"].tolist() == [0, 1, 3, 4]
    np.testing.assert_array_equal(
        cloud.remove_duplicated_points().points, np.asarray(to_open3d(points).remove_duplicated_points().points)
    )


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


@pytest.mark.parametrize("dtype", ["u1", "i2", "u4", "i8", "u8"])
def test_indices_of_any_whole_type_select_and_invert(device, dtype, rng):
    cloud = loom.PointCloud(rng.random((100, 3)), device=device, row=np.arange(100))
    indices = np.array([7, 99, 7, 0]).astype(dtype)
    assert cloud.select_by_index(indices)["row"].tolist() == [7, 99, 7, 0]
    left = cloud.select_by_index(indices, invert=True)["row"]
    assert left.tolist() == sorted(set(range(100)) - {0, 7, 99})
    if dtype in ("i2", "i8"):
        assert cloud.select_by_index(-indices[:1])["row"].tolist() == [93]
        assert 93 not in cloud.select_by_index(-indices[:1], invert=True)["row"]


def test_all_but_some_indices_are_open3ds(device, fragment, legacy_fragment, rng):
    indices = rng.integers(0, len(fragment.points), 5000)
    cloud = loom.PointCloud(fragment.points, device=device)
    for invert in (False, True):
        expected = np.asarray(legacy_fragment.select_by_index(indices, invert).points)
        found = cloud.select_by_index(indices if invert else np.unique(indices), invert)
        np.testing.assert_array_equal(found.points, expected)


def test_two_runs_give_the_same_bits(device, rng):
    cloud = loom.PointCloud(rng.integers(0, 9, (3000, 3)), device=device, row=np.arange(3000))
    first, second = cloud.remove_duplicated_points(), cloud.remove_duplicated_points()
    np.testing.assert_array_equal(first["row"], second["row"])
