"""Outliers: Open3D's sets on real scans, brute force on random clouds, and corrected special cases."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.distance import cdist

import pointloom as loom

from ..scan_cases import ON_SCANS
from .any_cloud import examples
from .open3d_clouds import cloud_of


@pytest.fixture(scope="module")
def scans(fragment, lidar, terrain):
    return {"fragment": fragment.points[::2], "lidar": lidar[:, :3].astype(float), "terrain": terrain - terrain.mean(0)}


@ON_SCANS
@pytest.mark.parametrize(("nb_neighbors", "std_ratio"), [(20, 2.0), (6, 0.5)])
def test_statistical_outliers_are_open3ds(device, scan, nb_neighbors, std_ratio, scans, to_open3d, tolerances):
    points = scans[scan]
    filtered, indices = loom.PointCloud(points, device=device).remove_statistical_outlier(nb_neighbors, std_ratio)
    _, expected = to_open3d(points).remove_statistical_outlier(nb_neighbors, std_ratio)
    if scan == "terrain":  # its 0.5 m grid has coincident points, which Open3D drops: see below
        twins = np.unique(points, axis=0, return_inverse=True)[1]
        crowded = np.flatnonzero(np.bincount(twins)[twins] >= nb_neighbors)
        expected = np.union1d(expected, crowded)
    differing = np.setxor1d(indices, expected)
    assert len(differing) <= tolerances.outlier_share * len(points), f"{len(differing)} points differ"
    np.testing.assert_array_equal(filtered.points, loom.PointCloud(points, device=device).points[indices])
    assert (np.diff(indices) > 0).all()


def open3d_inliers(o3d, points):
    cloud = cloud_of(o3d, points)
    inliers = [cloud.remove_statistical_outlier(*limits)[1] for limits in ((20, 2.0), (6, 0.5))]
    inliers += [cloud.remove_radius_outlier(count, 0.15)[1] for count in (1, 5, 16)]
    return [np.sort(indices).astype(np.int16) for indices in inliers]


def test_outliers_of_a_made_cloud_are_open3ds(device, rng, oracle):
    points = np.concatenate([rng.normal(size=(800, 3)) * 0.2, rng.random((200, 3)) * 3 - 1.5])
    points = points.astype(np.float32).astype(float)
    cloud = loom.PointCloud(points, device=device)
    inliers = [cloud.remove_statistical_outlier(*limits)[1] for limits in ((20, 2.0), (6, 0.5))]
    inliers += [cloud.remove_radius_outlier(count, 0.15)[1] for count in (1, 5, 16)]
    for indices, expected in zip(inliers, oracle("pcd/outliers/blob", open3d_inliers, points), strict=True):
        assert 0 < len(expected) < 1000
        np.testing.assert_array_equal(indices, expected)


clouds = st.lists(st.tuples(*[st.integers(-3, 3)] * 3), min_size=1, max_size=60)


@examples(20)
@given(
    points=clouds,
    nb_points=st.integers(1, 8),
    radius=st.sampled_from([0.5, 1.0, 1.001, 2.0, 100.0]),
    scale=st.sampled_from([1.0, 2.0**-10]),  # coordinates and distances stay exact in float32
)
def test_radius_outliers_agree_with_brute_force(points, nb_points, radius, scale):
    """On a lattice many points are at exactly the radius, which is excluded."""
    p = np.array(points, float) * scale
    inside = cdist(np.array(points, float), np.array(points, float)) < radius
    _, indices = loom.PointCloud(p).remove_radius_outlier(nb_points, np.nextafter(radius * scale, 0))
    np.testing.assert_array_equal(indices, np.flatnonzero(inside.sum(axis=1) > nb_points))


@examples(20)
@given(points=clouds, nb_neighbors=st.integers(1, 70), std_ratio=st.sampled_from([0.3, 1.0, 2.5]))
def test_statistical_outliers_agree_with_brute_force(points, nb_neighbors, std_ratio):
    p = np.array(points, float)
    distances = np.sort(cdist(p, p), axis=1)[:, :nb_neighbors].mean(axis=1)
    deviation = distances.std(ddof=1) if len(p) > 1 else 0
    limit = distances.mean() + std_ratio * deviation
    clear = np.abs(distances - limit) > 1e-6  # float32 distances decide ties either way
    _, indices = loom.PointCloud(p).remove_statistical_outlier(nb_neighbors, std_ratio)
    is_inlier = np.isin(np.arange(len(p)), indices)
    np.testing.assert_array_equal(is_inlier[clear], (distances <= limit)[clear])


FILTERS = {
    "statistical": lambda cloud: cloud.remove_statistical_outlier(5, 1.0),
    "radius": lambda cloud: cloud.remove_radius_outlier(2, 0.1),
}


@pytest.mark.parametrize("name", FILTERS)
@pytest.mark.parametrize("count", [0, 1, 2])
def test_tiny_clouds(device, name, count):
    filtered, indices = FILTERS[name](loom.PointCloud(np.arange(3.0 * count).reshape(-1, 3), device=device))
    assert len(filtered) == len(indices) == (count if name == "statistical" else 0)


@pytest.mark.parametrize("count", [9, 1000])
def test_identical_points_are_no_outliers(device, count):
    """A ring: all mean distances are equal, regardless of the rounding of their mean."""
    angle = np.arange(count) * 2 * np.pi / count
    ring = loom.PointCloud(np.stack([np.cos(angle), np.sin(angle), 0 * angle], 1), device=device)
    assert len(ring.remove_statistical_outlier(5, 3.0)[0]) == count
    equal = loom.PointCloud(np.ones((count, 3)), device=device)
    assert len(equal.remove_statistical_outlier(5, 0.1)[0]) == count
    assert len(equal.remove_radius_outlier(count - 1, 1e-6)[0]) == count
    assert len(equal.remove_radius_outlier(count, 1e-6)[0]) == 0
