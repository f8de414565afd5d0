"""Smoothing on real scans agrees with Open3D."""

from itertools import product

import numpy as np
import pytest

import pointloom as loom

from ..scan_cases import on_sets
from .open3d_clouds import cloud_of, search_of

SEARCHES = {
    "hybrid": {"radius": 0.1, "max_nn": 30},
    "count": {"radius": None, "max_nn": 20},
    "radius": {"radius": 0.07, "max_nn": None},
}


CASES = list(product(("fragment", "lidar", "terrain"), SEARCHES))
ON_SEARCHES = on_sets("scan search", shipped=[case for case in CASES if case != ("terrain", "count")], real=CASES)


@pytest.fixture(scope="module")
def scans(scan_file, fragment, lidar, o3d):
    """Points of an indoor fragment, a LiDAR scan and a centered airborne tile; normals; and spacings."""
    tile = loom.read_point_cloud(scan_file("lidar-pcl-terrain/CSite1_red2-utm.pcd")).points
    arrays = {}
    for name, points, spacing in (
        ("fragment", fragment.points[::8], 1.0),
        ("lidar", lidar[::2, :3], 10.0),
        ("terrain", tile[:10000] - np.round(tile.mean(axis=0)), 60.0),
    ):
        rounded = points.astype(np.float32).astype(np.float64)
        oracle = cloud_of(o3d, rounded)
        oracle.estimate_normals()
        arrays[name] = rounded, np.asarray(oracle.normals).astype(np.float32), spacing
    return arrays


def scaled(search, factor):
    return search | ({} if search["radius"] is None else {"radius": search["radius"] * factor})


def assert_points(actual, expected, start, tolerances, *, fraction=None):
    """Check for equal positions, except for a fraction with tied last neighbors, whose displacement is not larger."""
    fraction = tolerances.smoothed_share if fraction is None else fraction
    error = np.linalg.norm(actual - expected, axis=1)
    equal = error <= tolerances.smoothed_relative * np.abs(start).max()
    assert equal.mean() >= fraction, f"{1 - equal.mean():.5%} of the points are elsewhere, up to {error.max():.3g} m"
    moves = np.linalg.norm(expected - start, axis=1)
    assert moves.max() > 0 and error.max() <= moves.max()


SEED_CLOUD = np.random.default_rng(5).random((300, 3)).astype(np.float32).astype(float)
SEED_NORMALS = np.float32(np.random.default_rng(6).normal(size=(300, 3))).astype(float)
WIDE = {"radius": 0.3, "max_nn": 20}


def open3d_smoothed(o3d):
    """The points of one synthetic cloud after each operation."""
    cloud, search = cloud_of(o3d, SEED_CLOUD, SEED_NORMALS), search_of(o3d, **WIDE)
    smooth = [
        cloud.smooth_mls(search),
        cloud.smooth_bilateral(search, 0.1, 0.05),
        cloud.smooth_laplacian(1, 0.4, 12),
        cloud.smooth_taubin(1, 0.4, -0.45, 12, True),
    ]
    return [np.asarray(moved.points).astype(np.float32) for moved in smooth]


def test_points_of_a_made_cloud_are_open3ds(device, oracle, tolerances):
    cloud = loom.PointCloud(SEED_CLOUD, normals=SEED_NORMALS, device=device)
    results = [
        cloud.smooth_mls(**WIDE),
        cloud.smooth_bilateral(**WIDE, sigma_s=0.1, sigma_r=0.05),
        cloud.smooth_laplacian(1, 0.4, 12),
        cloud.smooth_taubin(1, 0.4, -0.45, 12, True),
    ]
    for moved, expected in zip(results, oracle("pcd/smoothing/uniform", open3d_smoothed), strict=True):
        assert_points(moved.points, expected, SEED_CLOUD, tolerances)


@ON_SEARCHES
def test_points_on_planes_are_open3ds(device, scan, search, scans, o3d, tolerances):
    points, _, spacing = scans[scan]
    limits = scaled(SEARCHES[search], spacing)
    expected = np.asarray(cloud_of(o3d, points).smooth_mls(search_of(o3d, **limits)).points)
    result = loom.PointCloud(points, device=device).smooth_mls(**limits)
    assert_points(result.points, expected, points, tolerances)


@ON_SEARCHES
def test_bilateral_means_are_open3ds(device, scan, search, scans, o3d, tolerances):
    points, normals, spacing = scans[scan]
    limits, sigmas = scaled(SEARCHES[search], spacing), {"sigma_s": 0.05 * spacing, "sigma_r": 0.01 * spacing}
    filtered = cloud_of(o3d, points, normals).smooth_bilateral(search_of(o3d, **limits), **sigmas)
    expected = np.asarray(filtered.points)
    result = loom.PointCloud(points, normals=normals, device=device).smooth_bilateral(**limits, **sigmas)
    assert_points(result.points, expected, points, tolerances)
    np.testing.assert_array_equal(result.normals, normals)


@pytest.mark.parametrize("fixed", [False, True])
@on_sets("scan", shipped=("fragment", "lidar"), real=("fragment", "lidar", "terrain"))
def test_laplacian_passes_are_open3ds(device, scan, fixed, scans, o3d, tolerances):
    points = scans[scan][0]
    cloud, oracle = loom.PointCloud(points, device=device), cloud_of(o3d, points)
    first = np.asarray(oracle.smooth_laplacian(1, 0.4, 12, fixed).points)
    assert_points(cloud.smooth_laplacian(1, 0.4, 12, fixed).points, first, points, tolerances)
    second = np.asarray(oracle.smooth_taubin(1, 0.4, -0.45, 12, fixed).points)
    result = cloud.smooth_taubin(1, 0.4, -0.45, 12, fixed).points
    assert_points(result, second, points, tolerances, fraction=tolerances.smoothed_share_of_two)


def test_the_defaults_are_open3ds(device, fragment, o3d, tolerances):
    points = fragment.points[:20000:4]
    cloud, oracle = loom.PointCloud(points, device=device), cloud_of(o3d, points)
    for name in ("smooth_mls", "smooth_bilateral"):
        result, expected = getattr(cloud, name)(), np.asarray(getattr(oracle, name)().points)
        assert not result.has_normals, "Open3D's has the normals that it fitted"
        assert_points(result.points, expected, points, tolerances)
    for name in ("smooth_laplacian", "smooth_taubin"):  # ten passes: ties of each of them propagate
        result, expected = getattr(cloud, name)(), np.asarray(getattr(oracle, name)().points)
        assert np.median(np.linalg.norm(result.points - expected, axis=1)) < 1e-6
        assert np.median(np.linalg.norm(expected - points, axis=1)) > 1e-3
