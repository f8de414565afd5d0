"""Distances and outliers: Open3D's on real scans, brute force on random clouds, degenerate cases."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.distance import cdist

import pointloom as loom
from pointloom.core.units import without_warnings

from ..scan_cases import ON_SCANS
from .any_cloud import examples
from .open3d_clouds import cloud_of

lattice = st.lists(st.tuples(*[st.integers(-3, 3)] * 3), min_size=0, max_size=40)


@pytest.fixture(scope="module")
def scans(fragment, lidar, terrain):
    return {"fragment": fragment.points[::4], "lidar": lidar[:, :3].astype(float), "terrain": terrain - terrain.mean(0)}


def open3d_distances(o3d, source, target):
    a, b = cloud_of(o3d, source), cloud_of(o3d, target)
    between, nearest = a.compute_point_cloud_distance(b), a.compute_nearest_neighbor_distance()
    moments, mahalanobis = a.compute_mean_and_covariance(), a.compute_mahalanobis_distance()
    results = [np.asarray(values) for values in (between, nearest, mahalanobis, *moments)]
    metric = o3d.t.geometry.Metric
    names = [metric.ChamferDistance, metric.HausdorffDistance, metric.FScore]
    parameters = o3d.t.geometry.MetricParameters(fscore_radius=FSCORE_RADII)
    clouds = [o3d.t.geometry.PointCloud(points.astype(np.float32)) for points in (source, target)]
    return [*results, clouds[0].compute_metrics(clouds[1], names, parameters).numpy()]


FSCORE_RADII = [0.01, 0.03, 0.1]


def check_distances(device, source, target, expected, tolerances):
    between, nearest, mahalanobis, mean, covariance, metrics = expected
    cloud, other = (loom.PointCloud(points, device=device) for points in (source, target))
    near = {"rtol": tolerances.distance_relative, "atol": tolerances.distance_absolute}
    np.testing.assert_allclose(cloud.compute_point_cloud_distance(other), between, **near)
    np.testing.assert_allclose(cloud.compute_nearest_neighbor_distance(), nearest, **near)
    actual_mean, actual_covariance = cloud.compute_mean_and_covariance()
    spread = np.sqrt(np.trace(covariance))
    np.testing.assert_allclose(actual_mean, mean, atol=tolerances.moment_relative * spread)
    np.testing.assert_allclose(actual_covariance, covariance, atol=tolerances.moment_relative * spread**2)
    result = cloud.compute_mahalanobis_distance()
    np.testing.assert_allclose(result, mahalanobis, rtol=tolerances.mahalanobis_relative)
    result = loom.compute_metrics(cloud, other, fscore_radius=FSCORE_RADII)
    np.testing.assert_allclose([result.chamfer, result.hausdorff, *result.fscore], metrics, rtol=1e-5)


def test_distances_of_two_made_clouds_are_open3ds(device, rng, oracle, tolerances):
    clouds = [rng.random((300, 3)).astype(np.float32).astype(float) for _ in range(2)]
    check_distances(device, *clouds, oracle("pcd/distances/uniform", open3d_distances, *clouds), tolerances)


@ON_SCANS
def test_distances_of_scans_are_open3ds(device, scan, scans, o3d, tolerances):
    source, target = scans[scan][::2], scans[scan][1::2]
    check_distances(device, source, target, open3d_distances(o3d, source, target), tolerances)


def test_a_flat_cloud_has_mahalanobis_distances_within_its_plane(device, rng):
    """Open3D inverts a singular covariance: all its distances are NaN."""
    points = np.column_stack([rng.normal(size=(500, 2)), np.zeros(500)])
    result = loom.PointCloud(points, device=device).compute_mahalanobis_distance()
    inverse = np.linalg.inv(np.cov(points[:, :2].T, bias=True))
    offset = points[:, :2] - points[:, :2].mean(0)
    np.testing.assert_allclose(result**2, np.einsum("ni,ij,nj->n", offset, inverse, offset), rtol=1e-5)


@settings(max_examples=20, deadline=None)
@given(source=lattice, target=lattice)
def test_distances_agree_with_brute_force(source, target):
    a, b = np.array(source, float).reshape(-1, 3), np.array(target, float).reshape(-1, 3)
    result = loom.PointCloud(a).compute_point_cloud_distance(loom.PointCloud(b))
    np.testing.assert_allclose(result, cdist(a, b).min(axis=1, initial=np.inf), rtol=1e-7)
    within = cdist(a, a)
    np.fill_diagonal(within, np.inf)
    nearest = within.min(axis=1, initial=np.inf)
    expected = np.where(np.isinf(nearest), 0, nearest)
    np.testing.assert_allclose(loom.PointCloud(a).compute_nearest_neighbor_distance(), expected, rtol=1e-7)


def test_no_target_is_infinitely_far_and_a_point_that_is_not_finite_has_no_distance(device):
    cloud = loom.PointCloud([[0, 0, 0], [np.nan, 0, 0], [3, 4, 0]], device=device)
    for empty in (np.zeros((0, 3)), np.full((2, 3), np.nan)):
        distances = cloud.compute_point_cloud_distance(loom.PointCloud(empty, device=device))
        assert np.isinf(distances[[0, 2]]).all() and np.isnan(distances[1])
    own = cloud.compute_nearest_neighbor_distance()
    assert own[[0, 2]].tolist() == [5, 5] and np.isnan(own[1])
    assert np.isnan(cloud.compute_mahalanobis_distance()[1])


def test_an_empty_cloud_has_no_distances_and_no_mean(device):
    cloud = loom.PointCloud(device=device)
    assert cloud.compute_point_cloud_distance(loom.PointCloud([[0, 0, 0]], device=device)).shape == (0,)
    assert cloud.compute_nearest_neighbor_distance().shape == (0,)
    assert cloud.compute_mahalanobis_distance().shape == (0,)
    mean, covariance = cloud.compute_mean_and_covariance()
    assert np.isnan(mean).all() and np.isnan(covariance).all()


def test_clouds_with_different_origins_are_compared_in_the_world(device):
    a = loom.PointCloud([[500000.25, 5400000, 10]], device=device)
    b = loom.PointCloud([[500003.25, 5400004, 10], [500900, 5400000, 10]], device=device, origin=[500500, 5400500, 0])
    np.testing.assert_allclose(a.compute_point_cloud_distance(b), [5], atol=1e-3)


@pytest.fixture(scope="module")
def filtered_scans(fragment, lidar, terrain):
    return {"fragment": fragment.points[::2], "lidar": lidar[:, :3].astype(float), "terrain": terrain - terrain.mean(0)}


@ON_SCANS
@pytest.mark.parametrize(("nb_neighbors", "std_ratio"), [(20, 2.0), (6, 0.5)])
def test_statistical_outliers_are_open3ds(device, scan, nb_neighbors, std_ratio, filtered_scans, to_open3d, tolerances):
    points = filtered_scans[scan]
    filtered, indices = loom.PointCloud(points, device=device).remove_statistical_outlier(nb_neighbors, std_ratio)
    _, expected = to_open3d(points).remove_statistical_outlier(nb_neighbors, std_ratio)
    if scan == "terrain":  # its 0.5 m grid has coincident points, which Open3D drops: see below
        twins = np.unique(points, axis=0, return_inverse=True)[1]
        crowded = np.flatnonzero(np.bincount(twins)[twins] >= nb_neighbors)
        expected = np.union1d(expected, crowded)
    differing = np.setxor1d(indices, expected)
    assert len(differing) <= tolerances.outlier_fraction * len(points), f"{len(differing)} points differ"
    np.testing.assert_array_equal(filtered.points, loom.PointCloud(points, device=device).points[indices])
    assert (np.diff(indices) > 0).all()


def inliers_of(cloud):
    """Indices by several filters of a cloud of Open3D or pointloom."""
    inliers = [cloud.remove_statistical_outlier(*limits)[1] for limits in ((20, 2.0), (6, 0.5))]
    return inliers + [cloud.remove_radius_outlier(count, 0.15)[1] for count in (1, 5, 16)]


def open3d_inliers(o3d, points):
    return [np.sort(indices).astype(np.int16) for indices in inliers_of(cloud_of(o3d, points))]


def test_outliers_of_a_made_cloud_are_open3ds(device, rng, oracle):
    points = np.concatenate([rng.normal(size=(800, 3)) * 0.2, rng.random((200, 3)) * 3 - 1.5])
    points = points.astype(np.float32).astype(float)
    inliers = inliers_of(loom.PointCloud(points, device=device))
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


def test_two_copies_of_a_position_are_two_neighbors(device, rng):
    """Copies count once only where all of the nearest points are copies, whose mean distance would be 0."""
    p = np.repeat(rng.random((300, 3)).astype(np.float32).astype(float), 2, axis=0)
    for nb_neighbors, std_ratio in ((6, 0.5), (3, 1.0)):
        distances = np.sort(cdist(p, p), axis=1)[:, :nb_neighbors].mean(axis=1)
        expected = np.flatnonzero(distances <= distances.mean() + std_ratio * distances.std(ddof=1))
        _, indices = loom.PointCloud(p, device=device).remove_statistical_outlier(nb_neighbors, std_ratio)
        assert 0 < len(expected) < len(p)
        np.testing.assert_array_equal(indices, expected)


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
    with without_warnings(loom.UnitWarning):
        assert len(equal.remove_radius_outlier(count, 1e-6)[0]) == 0
