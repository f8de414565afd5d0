"""Smoothing on real scans is Open3D's."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

import pointloom as loom

from ..scan_cases import on_sets

SEARCHES = {
    "hybrid": {"radius": 0.1, "max_nn": 30},
    "count": {"radius": None, "max_nn": 20},
    "radius": {"radius": 0.07, "max_nn": None},
}


CASES = list(product(("fragment", "lidar", "terrain"), SEARCHES))
ON_SEARCHES = on_sets("scan search", shipped=[case for case in CASES if case != ("terrain", "count")], real=CASES)


def open3d_search(search):
    import open3d as o3d

    radius, max_nn = search["radius"], search["max_nn"]
    if radius is None:
        return o3d.geometry.KDTreeSearchParamKNN(max_nn)
    if max_nn is None:
        return o3d.geometry.KDTreeSearchParamRadius(radius)
    return o3d.geometry.KDTreeSearchParamHybrid(radius, max_nn)


@pytest.fixture(scope="module")
def scans(scan_file, fragment, lidar, to_open3d):
    """Points of an indoor fragment, a LiDAR scan and an airborne tile about its middle; normals; and spacings."""
    tile = loom.read_point_cloud(scan_file("lidar-pcl-terrain/CSite1_red2-utm.pcd")).points
    found = {}
    for name, points, spacing in (
        ("fragment", fragment.points[::8], 1.0),
        ("lidar", lidar[::2, :3], 10.0),
        ("terrain", tile[:10000] - np.round(tile.mean(axis=0)), 60.0),
    ):
        held = points.astype(np.float32).astype(np.float64)
        oracle = to_open3d(held)
        oracle.estimate_normals()
        found[name] = held, np.asarray(oracle.normals).astype(np.float32), spacing
    return found


@pytest.fixture(scope="module")
def once(scan_set):
    """A function (key, make) that makes each thing once: what Open3D finds serves every device."""
    made = {}

    def get(key, make):
        if key not in made:
            made[key] = np.asarray(make().points)
        return made[key]

    return get


def scaled(search, factor):
    return search | ({} if search["radius"] is None else {"radius": search["radius"] * factor})


def assert_points(found, expected, start, tolerances, *, share=None):
    """Equal places but for a share whose neighbours are tied at the last place; those are moved no farther."""
    share = tolerances.smoothed_share if share is None else share
    error = np.linalg.norm(found - expected, axis=1)
    equal = error <= tolerances.smoothed_relative * np.abs(start).max()
    assert equal.mean() >= share, f"{1 - equal.mean():.5%} of the points are elsewhere, up to {error.max():.3g} m"
    moves = np.linalg.norm(expected - start, axis=1)
    assert moves.max() > 0 and error.max() <= moves.max()


@ON_SEARCHES
def test_points_on_planes_are_open3ds(device, scan, search, scans, once, to_open3d, tolerances):
    points, _, spacing = scans[scan]
    limits = scaled(SEARCHES[search], spacing)
    expected = once(("mls", scan, search), lambda: to_open3d(points).smooth_mls(open3d_search(limits)))
    found = loom.PointCloud(points, device=device).smooth_mls(**limits)
    assert_points(found.points, expected, points, tolerances)


@ON_SEARCHES
def test_bilateral_means_are_open3ds(device, scan, search, scans, once, to_open3d, tolerances):
    points, normals, spacing = scans[scan]
    limits, sigmas = scaled(SEARCHES[search], spacing), {"sigma_s": 0.05 * spacing, "sigma_r": 0.01 * spacing}
    expected = once(
        ("bilateral", scan, search),
        lambda: to_open3d(points, normals).smooth_bilateral(open3d_search(limits), **sigmas),
    )
    found = loom.PointCloud(points, normals=normals, device=device).smooth_bilateral(**limits, **sigmas)
    assert_points(found.points, expected, points, tolerances)
    np.testing.assert_array_equal(found.normals, normals)


@pytest.mark.parametrize("fixed", [False, True])
@on_sets("scan", shipped=("fragment", "lidar"), real=("fragment", "lidar", "terrain"))
def test_laplacian_passes_are_open3ds(device, scan, fixed, scans, once, to_open3d, tolerances):
    points = scans[scan][0]
    cloud, oracle = loom.PointCloud(points, device=device), to_open3d(points)
    first = once(("laplacian", scan, fixed), lambda: oracle.smooth_laplacian(1, 0.4, 12, fixed))
    assert_points(cloud.smooth_laplacian(1, 0.4, 12, fixed).points, first, points, tolerances)
    second = once(("taubin", scan, fixed), lambda: oracle.smooth_taubin(1, 0.4, -0.45, 12, fixed))
    found = cloud.smooth_taubin(1, 0.4, -0.45, 12, fixed).points
    assert_points(found, second, points, tolerances, share=tolerances.smoothed_share_of_two)


def test_the_defaults_are_open3ds(device, fragment, once, to_open3d, tolerances):
    points = fragment.points[:20000:4]
    cloud, oracle = loom.PointCloud(points, device=device), to_open3d(points)
    for name in ("smooth_mls", "smooth_bilateral"):
        found, expected = getattr(cloud, name)(), once(name, getattr(oracle, name))
        assert not found.has_normals, "Open3D's has the normals that it fitted"
        assert_points(found.points, expected, points, tolerances)
    for name in ("smooth_laplacian", "smooth_taubin"):  # ten passes: ties of any of them spread
        found, expected = getattr(cloud, name)(), once(name, getattr(oracle, name))
        assert np.median(np.linalg.norm(found.points - expected, axis=1)) < 1e-6
        assert np.median(np.linalg.norm(expected - points, axis=1)) > 1e-3
