"""Distances within and between clouds: Open3D's on real scans, brute force on random ones, defined in odd cases."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.distance import cdist

import pointloom as loom

from ..scan_cases import ON_SCANS

lattice = st.lists(st.tuples(*[st.integers(-3, 3)] * 3), min_size=0, max_size=40)


def halves(points):
    """Two clouds of one scan that hold different points."""
    return points[::2], points[1::2]


@pytest.fixture(scope="module")
def scans(fragment, lidar, terrain):
    """Points of the indoor fragment, of a LiDAR frame, and of a terrain tile about its own middle."""
    return {"fragment": fragment.points[::4], "lidar": lidar[:, :3].astype(float), "terrain": terrain - terrain.mean(0)}


@ON_SCANS
def test_distances_to_another_cloud_are_open3ds(device, scan, scans, to_open3d, tolerances):
    source, target = halves(scans[scan])
    found = loom.PointCloud(source, device=device).compute_point_cloud_distance(loom.PointCloud(target, device=device))
    expected = np.asarray(to_open3d(source).compute_point_cloud_distance(to_open3d(target)))
    np.testing.assert_allclose(found, expected, rtol=tolerances.distance_relative, atol=tolerances.distance_absolute)


@ON_SCANS
def test_distances_to_the_nearest_neighbour_are_open3ds(device, scan, scans, to_open3d, tolerances):
    found = loom.PointCloud(scans[scan], device=device).compute_nearest_neighbor_distance()
    expected = np.asarray(to_open3d(scans[scan]).compute_nearest_neighbor_distance())
    np.testing.assert_allclose(found, expected, rtol=tolerances.distance_relative, atol=tolerances.distance_absolute)


@ON_SCANS
def test_mean_covariance_and_mahalanobis_distances_are_open3ds(device, scan, scans, to_open3d, tolerances):
    cloud, oracle = loom.PointCloud(scans[scan], device=device), to_open3d(scans[scan])
    mean, covariance = cloud.compute_mean_and_covariance()
    expected_mean, expected_covariance = oracle.compute_mean_and_covariance()
    spread = np.sqrt(np.trace(expected_covariance))
    np.testing.assert_allclose(mean, expected_mean, atol=tolerances.moment_relative * spread)
    np.testing.assert_allclose(covariance, expected_covariance, atol=tolerances.moment_relative * spread**2)
    expected = np.asarray(oracle.compute_mahalanobis_distance())
    np.testing.assert_allclose(cloud.compute_mahalanobis_distance(), expected, rtol=tolerances.mahalanobis_relative)


def test_the_covariance_at_utm_coordinates_is_that_of_the_centred_cloud(device, terrain, tolerances):
    shifted = loom.PointCloud(terrain - terrain.mean(0), device=device).compute_mean_and_covariance()[1]
    mean, covariance = loom.PointCloud(terrain, device=device).compute_mean_and_covariance()
    np.testing.assert_allclose(mean, terrain.mean(0), atol=tolerances.position)
    np.testing.assert_allclose(covariance, shifted, atol=tolerances.moment_relative * np.trace(shifted))


def test_a_flat_cloud_has_mahalanobis_distances_within_its_plane(device, rng, to_open3d):
    """Open3D inverts a singular covariance: all its distances are NaN."""
    points = np.column_stack([rng.normal(size=(500, 2)), np.zeros(500)])
    assert np.isnan(np.asarray(to_open3d(points).compute_mahalanobis_distance())).all()
    found = loom.PointCloud(points, device=device).compute_mahalanobis_distance()
    inverse = np.linalg.inv(np.cov(points[:, :2].T, bias=True))
    offset = points[:, :2] - points[:, :2].mean(0)
    np.testing.assert_allclose(found**2, np.einsum("ni,ij,nj->n", offset, inverse, offset), rtol=1e-5)


@settings(max_examples=40, deadline=None)
@given(source=lattice, target=lattice)
def test_distances_are_those_of_brute_force(source, target):
    a, b = np.array(source, float).reshape(-1, 3), np.array(target, float).reshape(-1, 3)
    found = loom.PointCloud(a).compute_point_cloud_distance(loom.PointCloud(b))
    np.testing.assert_allclose(found, cdist(a, b).min(axis=1, initial=np.inf), rtol=1e-7)
    own = cdist(a, a)
    np.fill_diagonal(own, np.inf)
    nearest = own.min(axis=1, initial=np.inf)
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


def test_metrics_are_those_of_open3ds_tensor_form(device, fragment):
    import open3d as o3d

    source, target = halves(fragment.points[::10])
    target = target + np.array([0.01, 0, 0.02])
    radii = [0.01, 0.03, 0.1]
    metric = o3d.t.geometry.Metric
    expected = (
        o3d.t.geometry.PointCloud(source.astype(np.float32))
        .compute_metrics(
            o3d.t.geometry.PointCloud(target.astype(np.float32)),
            [metric.ChamferDistance, metric.HausdorffDistance, metric.FScore],
            o3d.t.geometry.MetricParameters(fscore_radius=radii),
        )
        .numpy()
    )
    found = loom.compute_metrics(
        loom.PointCloud(source, device=device), loom.PointCloud(target, device=device), fscore_radius=radii
    )
    # Open3D sums 5,000 distances in float32
    np.testing.assert_allclose([found.chamfer, found.hausdorff, *found.fscore], expected, rtol=1e-5)


def test_metrics_of_a_cloud_with_itself_are_perfect_and_of_far_ones_zero(device, rng):
    cloud = loom.PointCloud(rng.random((100, 3)), device=device)
    assert loom.compute_metrics(cloud, cloud)[:2] == (0, 0)
    assert loom.compute_metrics(cloud, cloud).fscore.tolist() == [100]
    far = loom.PointCloud(rng.random((100, 3)) + 50, device=device)
    assert loom.compute_metrics(cloud, far).fscore.tolist() == [0]


def test_metrics_refuse_clouds_without_points_and_radii_without_extent(device):
    cloud, empty = loom.PointCloud([[0, 0, 0]], device=device), loom.PointCloud(device=device)
    with pytest.raises(ValueError, match=r"target: .*no finite point"):
        loom.compute_metrics(cloud, empty)
    with pytest.raises(ValueError, match=r"source: .*no finite point"):
        loom.compute_metrics(empty, cloud)
    with pytest.raises(ValueError, match="fscore_radius: expected a finite number > 0"):
        loom.compute_metrics(cloud, cloud, fscore_radius=[0.0])
