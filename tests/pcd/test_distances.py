"""Distances within and between clouds: Open3D's on real scans, brute force on random ones, degenerate cases."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.distance import cdist

import pointloom as loom

from ..scan_cases import ON_SCANS
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
