"""Covariances: Open3D's on real scans, exact far from the origin, defined in every degenerate neighborhood."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial import cKDTree

import pointloom as loom

from ..scan_cases import ON_SCANS
from .any_cloud import examples
from .open3d_clouds import covariances_of

SEARCHES = {
    "hybrid": {"radius": 0.1, "max_nn": 30},
    "count": {"max_nn": 20},
    "radius": {"radius": 0.05, "max_nn": None},
}


def untied(points, search):
    """True where the last neighbor within the count is nearer than the next one; otherwise the choice is free."""
    k = search["max_nn"]
    if k is None:
        return np.ones(len(points), bool)
    distances = cKDTree(points).query(points, k + 1)[0]
    return distances[:, k] > distances[:, k - 1] * (1 + 1e-6)


def assert_agree(actual, expected, tolerances):
    """Compare relative to the largest entry of each matrix, except for neighbors at exactly the radius."""
    sizes = np.abs(expected).max(axis=(1, 2))
    errors = np.abs(actual - expected).max(axis=(1, 2))
    fraction = (errors <= tolerances.covariance_relative * sizes).mean()
    assert fraction >= tolerances.normal_share, f"{fraction:.5f} of the covariances agree"


@pytest.fixture(scope="module")
def scans(fragment, lidar, terrain):
    """Points by name, rounded to float32, and a length [m] that scales the searches; the tile is centered."""
    tile = (terrain - np.round(terrain.mean(axis=0))).astype(np.float32).astype(float)
    return {
        "fragment": (fragment.points[::10], 1.0),
        "lidar": (lidar[:, :3].astype(float), 10.0),
        "terrain": (tile, 40.0),
    }


@ON_SCANS
@pytest.mark.parametrize("search", SEARCHES)
def test_covariances_of_scans_are_open3ds(device, scan, search, scans, o3d, tolerances):
    points, scale = scans[scan]
    limits = dict(SEARCHES[search])
    if "radius" in limits:
        limits["radius"] *= scale
    result = loom.PointCloud(points, device=device).estimate_covariances(**limits).covariances
    sure = untied(points, limits)
    assert sure.mean() > 0.5
    assert_agree(result[sure], covariances_of(o3d, points, limits)[sure], tolerances)


@pytest.mark.parametrize("search", SEARCHES)
def test_covariances_of_a_bumpy_surface_are_open3ds(device, search, rng, oracle, tolerances):
    xy = rng.random((200, 2))
    points = np.column_stack([xy, 0.1 * np.sin(9 * xy[:, 0])]).astype(np.float32).astype(float)
    result = loom.PointCloud(points, device=device).estimate_covariances(**SEARCHES[search]).covariances
    expected = oracle(f"pcd/covariances/{search}", covariances_of, points, SEARCHES[search])
    assert_agree(result, expected, tolerances)


@given(
    seed=st.integers(0, 10_000),
    count=st.integers(1, 60),
    lattice=st.booleans(),
    spoiled=st.booleans(),
    search=st.sampled_from([{"max_nn": 1}, {"max_nn": 7}, {"radius": 1.5}, {"radius": 1.5, "max_nn": None}]),
)
@examples(15)
def test_covariances_agree_with_numpy_for_the_same_neighbors(device, seed, count, lattice, spoiled, search, tolerances):
    rng = np.random.default_rng(seed)
    points = (rng.integers(0, 4, (count, 3)) if lattice else rng.normal(size=(count, 3))).astype(np.float32)
    if spoiled:
        points[rng.random(count) < 0.2, rng.integers(0, 3)] = rng.choice([np.nan, np.inf])
    cloud = loom.PointCloud(points, device=device)
    result = cloud.estimate_covariances(**search).covariances
    finite = np.isfinite(points).all(axis=1)
    with np.errstate(invalid="ignore"):
        sqdists = ((points[:, None].astype(float) - points[None]) ** 2).sum(axis=2)
    for row in range(count):
        if not finite[row]:
            assert np.isnan(result[row]).all()
            continue
        near = np.flatnonzero(sqdists[row] < search.get("radius", np.inf) ** 2)
        near = near[np.argsort(sqdists[row, near])]
        k = search.get("max_nn", 30) or count
        if len(near) > k and sqdists[row, near[k - 1]] == sqdists[row, near[k]]:
            continue  # a tie: either is valid
        near = near[:k]
        expected = np.cov(points[near].astype(float).T, bias=True) if len(near) >= 3 else np.eye(3)
        size = np.abs(expected).max()
        assert np.abs(result[row] - expected).max() <= tolerances.covariance_relative * size


def test_equal_and_collinear_points_have_their_plain_covariance(device):
    equal = loom.PointCloud(np.full((40, 3), 0.3), device=device).estimate_covariances(max_nn=10).covariances
    np.testing.assert_array_equal(equal, 0)
    line = np.outer([-1.0, 0, 1], [0, 0, 3.0])
    result = loom.PointCloud(line, device=device).estimate_covariances(radius=100.0).covariances
    np.testing.assert_array_equal(result, np.tile(np.diag([0, 0, 6]), (3, 1, 1)))


def test_covariances_are_matrices_that_travel_with_their_points(device, rng):
    bare = loom.PointCloud(np.zeros((2, 3)), device=device)
    with pytest.raises(ValueError, match=r"no covariances: call estimate_covariances\(\)"):
        _ = bare.covariances
    with pytest.raises(ValueError, match="covariances:"):
        bare.covariances = np.zeros((2, 9))
    bare.covariances = np.arange(18.0).reshape(2, 3, 3)
    assert bare.has_covariances and bare.covariances.dtype == np.float32
    np.testing.assert_array_equal(bare.covariances, np.arange(18.0).reshape(2, 3, 3))
    cloud = loom.PointCloud(rng.random((100, 3)), device=device).estimate_covariances(max_nn=8)
    rows = [5, 3, 99]
    np.testing.assert_array_equal(cloud.select_by_index(rows).covariances, cloud.covariances[rows])
    assert cloud.attributes["covariances"].shape == (100, 9)
    np.testing.assert_array_equal(cloud.covariances, cloud.covariances.transpose(0, 2, 1))


def test_stored_covariances_do_not_change_the_normals_fitted(device, rng):
    """Open3D uses them instead of the requested neighbors."""
    cloud = loom.PointCloud(rng.random((50, 3)), device=device)
    expected = cloud.estimate_normals(max_nn=8).normals
    cloud.covariances = np.tile(np.diag([1.0, 2, 3]), (50, 1, 1))
    np.testing.assert_array_equal(cloud.estimate_normals(max_nn=8).normals, expected)


def test_lists_made_in_parts_give_the_same(device, rng, monkeypatch):
    cloud = loom.PointCloud(rng.random((1003, 3)), device=device)
    full = cloud.estimate_covariances(max_nn=9).covariances
    monkeypatch.setattr("pointloom.kernels.surface.covariances.LIST_ENTRIES", 1000)
    np.testing.assert_array_equal(cloud.estimate_covariances(max_nn=9).covariances, full)


def test_covariances_rotate_with_the_cloud(device, rng, tolerances):
    cloud = loom.PointCloud(rng.random((500, 3)) * [3, 2, 1], device=device).estimate_covariances(max_nn=12)
    T, cosine, sine = np.eye(4), np.cos(0.7), np.sin(0.7)
    T[:3] = [[cosine, -sine, 0, 5], [sine, cosine, 0, -1], [0, 0, 1, 2]]
    expected = T[:3, :3] @ cloud.covariances.astype(float) @ T[:3, :3].T
    rotated = cloud.transform(T).covariances
    np.testing.assert_allclose(rotated, expected, atol=tolerances.float32_relative * np.abs(expected).max())
    assert np.abs(rotated - cloud.covariances).max() > 0.01
