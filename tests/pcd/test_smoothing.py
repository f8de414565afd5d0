"""Smoothing: brute force, less noise on known surfaces, preserved attributes, and Open3D's filters."""

from itertools import product

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointloom as loom

from ..scan_cases import on_sets
from .open3d_clouds import cloud_of, search_of


def brute_neighbors(points, row, k, radius):
    """Rows of the k nearest by distance, ties in any order, strictly within the radius."""
    sqdists = ((points - points[row]) ** 2).sum(axis=1)
    rows = np.argsort(sqdists, kind="stable")[: len(points) if k is None else k]
    return rows[sqdists[rows] < radius**2], sqdists


def brute_mls(points, k, radius):
    out = points.copy()
    for row, p in enumerate(points):
        near, sqdists = brute_neighbors(points, row, k, radius)
        if len(near) >= 3:
            w = np.exp(-sqdists[near] / radius**2)[:, None]
            center = (w * points[near]).sum(axis=0) / w.sum()
            n = np.linalg.eigh((w * (points[near] - center)).T @ (points[near] - center))[1][:, 0]
            out[row] = p - n * ((p - center) @ n)
    return out


def brute_bilateral(points, normals, k, radius, sigma_s, sigma_r):
    out = points.copy()
    for row, p in enumerate(points):
        near, sqdists = brute_neighbors(points, row, k, radius)
        heights = (points[near] - p) @ normals[row] / np.linalg.norm(normals[row])
        w = np.exp(-sqdists[near] / (2 * sigma_s**2) - heights**2 / (2 * sigma_r**2))[:, None]
        out[row] = (w * points[near]).sum(axis=0) / w.sum()
    return out


def brute_averages(points, factors, k, fixed):
    for step, factor in enumerate(factors):
        if step == 0 or not fixed:
            every = [brute_neighbors(points, row, None, np.inf)[0] for row in range(len(points))]
            lists = [near[near != row][:k] for row, near in enumerate(every)]
        means = np.stack([points[near].mean(axis=0) for near in lists])
        points = points + factor * (means - points)
    return points


@settings(derandomize=True, deadline=None, max_examples=12)
@given(seed=st.integers(0, 2**32 - 1), count=st.integers(2, 60), k=st.integers(1, 12), missing=st.integers(0, 5))
def test_small_clouds_are_smoothed_as_by_brute_force(seed, count, k, missing):
    rng = np.random.default_rng(seed)
    points = rng.random((count, 3)).astype(np.float32).astype(np.float64)
    normals = rng.normal(size=(count, 3)).astype(np.float32).astype(np.float64)
    all_points = np.insert(points, rng.integers(0, count + 1, missing), [np.nan, np.inf, 0], axis=0)
    good = np.isfinite(all_points).all(axis=1)
    sides = np.full(all_points.shape, 0.5)
    sides[good] = normals
    cloud = loom.PointCloud(all_points, normals=sides, label=np.arange(len(all_points)))
    sizes = {"radius": 0.4, "sigma_s": 0.2, "sigma_r": 0.05}
    cases = [
        (cloud.smooth_mls(radius=0.4, max_nn=k), brute_mls(points, k, 0.4)),
        (cloud.smooth_mls(radius=0.4, max_nn=None), brute_mls(points, None, 0.4)),
        (cloud.smooth_bilateral(max_nn=k, **sizes), brute_bilateral(points, normals, k, *sizes.values())),
        (cloud.smooth_bilateral(max_nn=None, **sizes), brute_bilateral(points, normals, None, *sizes.values())),
        (cloud.smooth_laplacian(1, 0.5, k), brute_averages(points, [0.5], k, False)),
        (cloud.smooth_taubin(2, 0.5, -0.53, k, True), brute_averages(points, [0.5, -0.53] * 2, k, True)),
    ]
    for result, expected in cases:
        np.testing.assert_array_equal(result.points[~good], all_points[~good])
        np.testing.assert_array_equal(result["label"], np.arange(len(all_points)))
        error = np.abs(result.points[good] - expected).max(axis=1)
        assert (error > 1e-5).mean() <= 0.05, "1e-5: planes through near-isotropic neighbors amplify rounding"


def wave(rng, count):
    """Noisy points of a wavy surface."""
    xy = rng.random((count, 2)) * 2
    return np.column_stack([xy, 0.1 * np.sin(3 * xy[:, 0]) + 0.01 * rng.normal(size=count)])


def roof(rng, count=6000):
    """Noisy points of two orthogonal planes that meet along y, and a function that returns their distances."""
    along, y = rng.uniform(-1, 1, count), rng.random(count)
    points = np.column_stack([along, y, -np.abs(along)]) + 0.01 * rng.normal(size=(count, 3))
    return points, lambda p: np.abs(p[:, 2] + np.abs(p[:, 0])) / np.sqrt(2)


def test_the_bilateral_filter_keeps_an_edge_that_planes_round_off(device, rng):
    points, distances = roof(rng)
    cloud = loom.PointCloud(points, device=device).estimate_normals(max_nn=20)
    edge = np.abs(points[:, 0]) < 0.05
    flat = (np.abs(points[:, 0]) > 0.3) & (np.abs(points[:, 0]) < 0.9) & (np.abs(points[:, 1] - 0.5) < 0.3)
    plane = cloud.smooth_mls(radius=0.2, max_nn=None).points
    bilateral = cloud.smooth_bilateral(radius=0.2, max_nn=None, sigma_s=0.1, sigma_r=0.02).points
    assert distances(bilateral)[edge].mean() < 0.6 * distances(plane)[edge].mean()
    assert distances(bilateral)[flat].mean() < 0.4 * distances(points)[flat].mean()


def test_taubin_keeps_a_sphere_that_laplacian_shrinks(device, rng):
    points = rng.normal(size=(4000, 3))
    points *= (1 + 0.01 * rng.normal(size=(4000, 1))) / np.linalg.norm(points, axis=1, keepdims=True)
    cloud = loom.PointCloud(points, device=device)
    for fixed in (False, True):
        filters = (cloud.smooth_laplacian, cloud.smooth_taubin)
        smooth = [each(10, 0.5, knn=20, use_fixed_neighborhoods=fixed).points for each in filters]
        radius = [np.linalg.norm(positions, axis=1).mean() for positions in smooth]
        assert radius[0] < 0.993 < 0.997 < radius[1] < 1.003


OPERATIONS = {
    "mls": lambda cloud: cloud.smooth_mls(radius=0.2, max_nn=20),
    "mls radius": lambda cloud: cloud.smooth_mls(radius=0.2, max_nn=None),
    "mls count": lambda cloud: cloud.smooth_mls(radius=None, max_nn=20),
    "bilateral": lambda cloud: cloud.smooth_bilateral(radius=0.2, max_nn=20, sigma_s=0.1, sigma_r=0.02),
    "laplacian": lambda cloud: cloud.smooth_laplacian(2, knn=8),
    "laplacian fixed": lambda cloud: cloud.smooth_laplacian(2, knn=8, use_fixed_neighborhoods=True),
    "taubin": lambda cloud: cloud.smooth_taubin(2, knn=8),
}


@pytest.mark.parametrize("operation", OPERATIONS.values(), ids=OPERATIONS)
def test_attributes_are_preserved_and_the_cloud_is_unchanged(device, operation, rng):
    points = wave(rng, 300)
    cloud = loom.PointCloud(points, colors=rng.random((300, 3)), label=np.arange(300), device=device)
    before = cloud.points
    result = operation(cloud)
    assert type(result) is loom.PointCloud and str(result.device) == device
    np.testing.assert_array_equal(result["label"], np.arange(300))
    np.testing.assert_array_equal(result.colors, cloud.colors)
    np.testing.assert_array_equal(cloud.points, before)
    assert np.abs(result.points - before).max() > 1e-4 and not result.has_normals


@pytest.mark.parametrize("operation", OPERATIONS.values(), ids=OPERATIONS)
def test_small_degenerate_and_non_finite_clouds_are_smoothed(device, operation):
    points = np.array([[0, 0, 0], [0.1, 0, 0], [0, 0.1, 0.0]])
    for count in (0, 1, 2, 3):
        result = operation(loom.PointCloud(points[:count], device=device)).points
        assert result.shape == (count, 3) and np.isfinite(result).all()
        assert np.abs(result).max(initial=0) <= (0.1 + 1e-7 if count > 1 else 0)
    for fill in (0.3, np.nan):
        same = np.full((70, 3), fill, np.float32)
        np.testing.assert_array_equal(operation(loom.PointCloud(same, device=device)).points, same)


def test_points_of_a_plane_and_of_a_line_stay_on_it(device, rng):
    plane = np.column_stack([rng.random((500, 2)), np.full(500, 0.25)])
    line = np.outer(np.linspace(0, 1, 200), [0.6, 0.0, 0.8])
    for points, normal in ((plane, [0, 0, 1]), (line, [0.8, 0.0, -0.6])):
        cloud = loom.PointCloud(points, device=device)
        height = points[0] @ normal
        for operation in OPERATIONS.values():
            assert np.abs(operation(cloud).points @ normal - height).max() < 2e-7, "two roundings to float32 below 1"
        np.testing.assert_allclose(cloud.smooth_mls(radius=0.2).points, cloud.points, atol=1e-7)


def test_plane_normals_take_the_sides_of_those_before(device, rng):
    points = wave(rng, 1500)
    cloud = loom.PointCloud(np.vstack([points, [[50, 50, 50]]]), device=device)
    signs = rng.choice([-1.0, 1.0], len(cloud))
    cloud.normals = np.outer(signs, [0, 0, 2.0])
    result = cloud.smooth_mls(radius=0.2, max_nn=40)
    assert (np.sign(result.normals[:, 2]) == signs).all()
    assert result.normals[-1].tolist() == [0, 0, 2 * signs[-1]], "too few neighbors: as it was"
    np.testing.assert_allclose(np.linalg.norm(result.normals[:-1], axis=1), 1, atol=3e-7)
    slope = 0.3 * np.cos(3 * result.points[:-1, 0])
    true = np.column_stack([-slope, np.zeros_like(slope), np.ones_like(slope)]) / np.sqrt(1 + slope**2)[:, None]
    assert np.median(np.abs((result.normals[:-1] * true).sum(axis=1))) > 0.995


def test_a_point_without_a_side_is_left_by_the_bilateral_filter(device, rng):
    points = wave(rng, 500)
    normals = np.tile([0, 0, 3.0], (500, 1))
    normals[:10], normals[10:20] = 0, np.nan
    result = loom.PointCloud(points, normals=normals, device=device).smooth_bilateral(radius=0.3, max_nn=20).points
    np.testing.assert_array_equal(result[:20], points.astype(np.float32)[:20])
    assert (np.abs(result[20:] - points[20:]).max(axis=1) > 1e-6).all()
    unit = loom.PointCloud(points, normals=normals / 3, device=device).smooth_bilateral(radius=0.3, max_nn=20).points
    np.testing.assert_allclose(result, unit, atol=1e-6, err_msg="the length of a normal does not count")


def test_tiny_and_huge_deviations_are_the_limits(device, rng):
    points = wave(rng, 400)
    cloud = loom.PointCloud(points, normals=np.tile([0, 0, 1.0], (400, 1)), device=device)
    unchanged = cloud.smooth_bilateral(radius=0.3, max_nn=20, sigma_s=1e-200, sigma_r=1e-30).points
    np.testing.assert_array_equal(unchanged, cloud.points)
    wide = cloud.smooth_bilateral(radius=None, max_nn=20, sigma_s=1e200, sigma_r=1e200).points
    near = loom.NearestNeighborSearch(cloud).knn_search(cloud, 20).indices
    np.testing.assert_allclose(wide, cloud.points[near].mean(axis=1), atol=1e-6)


def test_more_duplicates_than_neighbors_stay_together(device, rng):
    points = rng.random((15, 3))
    for fixed in (False, True):
        alone, copied = (
            loom.PointCloud(each, device=device, origin=np.zeros(3)).smooth_laplacian(4, 0.5, 10, fixed).points
            for each in (points, np.repeat(points, 40, axis=0))
        )
        np.testing.assert_array_equal(copied, np.repeat(alone, 40, axis=0))
        assert np.abs(alone - points).max() > 0.1


def test_zero_iterations_and_zero_factors_change_nothing(device, rng):
    cloud = loom.PointCloud(rng.random((200, 3)), device=device)
    for result in (
        cloud.smooth_laplacian(0), cloud.smooth_laplacian(0, use_fixed_neighborhoods=True), cloud.smooth_taubin(0),
        cloud.smooth_laplacian(2, 0.0), cloud.smooth_laplacian(2, 0.0, use_fixed_neighborhoods=True),
    ):  # fmt: skip
        np.testing.assert_array_equal(result.points, cloud.points)


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
    fraction = tolerances.smoothed_fraction if fraction is None else fraction
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
    smooth = [cloud.smooth_mls(search), cloud.smooth_bilateral(search, 0.1, 0.05)]
    smooth += [cloud.smooth_laplacian(1, 0.4, 12), cloud.smooth_taubin(1, 0.4, -0.45, 12, True)]
    return [np.asarray(moved.points).astype(np.float32) for moved in smooth]


def test_points_of_a_made_cloud_are_open3ds(device, oracle, tolerances):
    cloud = loom.PointCloud(SEED_CLOUD, normals=SEED_NORMALS, device=device)
    results = [cloud.smooth_mls(**WIDE), cloud.smooth_bilateral(**WIDE, sigma_s=0.1, sigma_r=0.05)]
    results += [cloud.smooth_laplacian(1, 0.4, 12), cloud.smooth_taubin(1, 0.4, -0.45, 12, True)]
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
    assert_points(result, second, points, tolerances, fraction=tolerances.smoothed_fraction_of_two)


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
