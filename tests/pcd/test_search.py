"""Neighbor search is exact: compared with float64 brute force and Open3D, on all kinds of clouds and code paths."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import pointloom as loom
from pointloom.kernels.search import group_scratch, tree_search
from pointloom.kernels.search.point_tree import LEAF, PointTree
from pointloom.kernels.search.tree_search import search_nearest
from pointloom.pcd.cached_tree import SMALLEST_EXTENT

from .any_cloud import INTEGERS, NOT_FINITE, clouds, examples, real
from .nearest_oracle import EXACT, SHAPES, assert_nearest, make_cloud, queries_for, rows_of, sphere, square_distances


@pytest.mark.parametrize("shape", SHAPES)
def test_k_nearest_agree_with_brute_force(device, shape, rng, tolerances):
    cloud = make_cloud(shape, rng, device)
    search = loom.NearestNeighborSearch(cloud)
    queries = queries_for(cloud.points, rng)
    expected, self_sqdists = square_distances(cloud, queries), square_distances(cloud, cloud.points)
    for k in (1, 9, 64):
        assert_nearest(search.knn_search(queries, k), expected, k, np.inf, tolerances, shape in EXACT)
    assert_nearest(search.knn_search(cloud, 20), self_sqdists, 20, np.inf, tolerances, shape in EXACT)


def test_equal_points_have_the_same_neighbors_lowest_indices_first(device, rng):
    points = rng.random((600, 3)) + 1.0
    missing = np.sort(rng.permutation(len(points))[:300])
    points[missing] = 0.0
    cloud = loom.PointCloud(points, device=device)
    result = loom.NearestNeighborSearch(cloud).knn_search(cloud, 20)
    np.testing.assert_array_equal(result.indices[missing], np.tile(missing[:20], (len(missing), 1)))
    assert not result.sqdists[missing].any()


@pytest.mark.parametrize("shape", SHAPES)
def test_radius_search_agrees_with_brute_force(device, shape, rng, tolerances):
    cloud = make_cloud(shape, rng, device)
    search = loom.NearestNeighborSearch(cloud)
    queries = queries_for(cloud.points, rng)
    expected, self_sqdists = square_distances(cloud, queries), square_distances(cloud, cloud.points)
    k = min(15, len(cloud) - 1)
    near = np.sqrt(np.partition(self_sqdists, k, axis=1)[:, k].mean()) or 0.1
    for radius in (near / 30, near, 1e7):
        result = search.hybrid_search(queries, radius, 12)
        assert_nearest(result, expected, 12, radius, tolerances, shape in EXACT)
        result = search.hybrid_search(cloud, radius, 12)
        assert_nearest(result, self_sqdists, 12, radius, tolerances, shape in EXACT)
        rows = rows_of(search.radius_search(queries, radius), len(cloud))
        assert_nearest(rows, expected, len(cloud), radius, tolerances, shape in EXACT)


MORE_THAN_THERE_ARE = {
    "knn_search": lambda c, k: loom.NearestNeighborSearch(c).knn_search(c, k).indices[:, : len(c)].tobytes(),
    "normals": lambda c, k: c.estimate_normals(max_nn=k).normals.tobytes(),
    "covariances": lambda c, k: c.estimate_covariances(max_nn=k).covariances.tobytes(),
    "outliers": lambda c, k: c.remove_statistical_outlier(k, 1.0)[1].tobytes(),
    "planes": lambda c, k: c.smooth_mls(radius=None, max_nn=k).points.tobytes(),
    "means": lambda c, k: c.smooth_laplacian(2, knn=k).points.tobytes(),
    "fixed": lambda c, k: c.smooth_laplacian(2, knn=k, use_fixed_neighborhoods=True).points.tobytes(),
}


@pytest.mark.parametrize("operation", MORE_THAN_THERE_ARE)
def test_asking_for_more_neighbors_than_there_are_takes_all(device, operation, rng):
    """The boxes of 513 points fill their records badly: a traversal without a bound would leave them."""
    cloud = loom.PointCloud(rng.random((8 * 8 * LEAF + 1, 3)), device=device)
    compute = MORE_THAN_THERE_ARE[operation]
    assert compute(cloud, len(cloud) + 1) == compute(cloud, len(cloud) + 70) == compute(cloud, len(cloud))


@pytest.mark.parametrize("far", [1e20, 3e38])
def test_a_point_too_far_for_a_squared_distance_is_nobodys_neighbor_and_an_outlier(device, far, rng):
    points = rng.random((600, 3))
    points[7] = [far, 0, 0]
    cloud = loom.PointCloud(points, device=device)
    indices, _, counts = loom.NearestNeighborSearch(cloud).knn_search(cloud, 600)
    assert counts.tolist() == [599] * 7 + [1] + [599] * 592 and indices[7, 0] == 7
    assert not (np.delete(indices, 7, axis=0) == 7).any()
    assert 7 not in cloud.remove_statistical_outlier(20, 3.0)[1]
    smoothed = cloud.smooth_laplacian(3, knn=599, use_fixed_neighborhoods=True).points
    assert smoothed[7, 0] == np.float32(far) and np.abs(np.delete(smoothed, 7, axis=0)).max() < 1


@pytest.mark.parametrize(("k", "radius"), [(1, 10.0), (10, 0.05), (10, 0.25), (40, 0.7), (40, np.inf)])
def test_gathering_traversal_and_overflow_are_bitwise_identical(device, radius, k, rng, monkeypatch):
    """The density changes by a factor of 400, so that the result of one group misleads the next."""
    points = np.concatenate([sphere(rng, 3001), 0.05 * sphere(rng, 1000)])
    cloud = loom.PointCloud(points, device=device).array("points")
    results = {}
    for room in (0, 8 * LEAF, 500 * LEAF):  # none gathered; too many; all of them
        monkeypatch.setattr(group_scratch, "candidate_room", lambda device, k, room=room: room)
        results[room] = [part.numpy() for part in search_nearest(PointTree(cloud), cloud, k, radius)]
    monkeypatch.undo()
    results["as it is"] = [part.numpy() for part in search_nearest(PointTree(cloud), cloud, k, radius)]
    assert (results[0][2] > 0).all()
    for room, parts in results.items():
        for part, expected in zip(parts, results[0], strict=True):
            np.testing.assert_array_equal(part.view(np.int32), expected.view(np.int32), err_msg=f"room {room}")


@pytest.mark.parametrize("radius", [np.inf, 0.3])
def test_search_in_parts_is_bitwise_identical(device, radius, rng, monkeypatch):
    cloud = loom.PointCloud(sphere(rng, 1001), device=device)
    points = cloud.array("points")
    full = search_nearest(PointTree(points), points, 7, radius)
    monkeypatch.setattr(tree_search, "MAX_ROWS", 7 * 96 + 3)  # parts of 96 queries
    for part, expected in zip(search_nearest(PointTree(points), points, 7, radius), full, strict=True):
        assert part.shape == expected.shape
        np.testing.assert_array_equal(part.numpy().view(np.int32), expected.numpy().view(np.int32))


def open3d_neighbors(o3d, points, queries, radii):
    """Indices and distances within each radius, and the distances of the 8 nearest."""
    search = o3d.core.nns.NearestNeighborSearch(o3d.core.Tensor(points))
    search.knn_index()
    within = []
    for radius in radii:
        search.fixed_radius_index(float(radius))
        within.append([t.numpy() for t in search.fixed_radius_search(o3d.core.Tensor(queries), float(radius), True)])
    return search.knn_search(o3d.core.Tensor(queries), min(8, len(points)))[1].numpy(), within


def test_the_boundary_of_a_radius_is_excluded_as_in_open3d(device, oracle):
    points = np.array([[0.0, 0, 0], [0.5, 0, 0], [0, 0.25, 0], [3, 4, 0]])
    search = loom.NearestNeighborSearch(points, device=device)
    radii = [0.25, 0.5, 5.0, np.nextafter(0.5, 1), float(np.nextafter(np.float32(0.5), np.float32(1)))]
    _, within = oracle("pcd/search/boundary", open3d_neighbors, points, points[:1], radii)
    for radius, (expected, _, _) in zip(radii, within, strict=True):
        assert search.radius_search(points[:1], radius).indices.tolist() == expected.tolist(), radius
        assert search.hybrid_search(points[:1], radius, 4).counts.tolist() == [len(expected)], radius


def test_neighbors_in_a_made_cloud_are_open3ds(device, rng, oracle, tolerances):
    points, queries = (rng.random((n, 3)).astype(np.float32).astype(float) for n in (500, 60))
    search, radii = loom.NearestNeighborSearch(points, device=device), [0.05, 0.2]
    nearest, within = oracle("pcd/search/uniform", open3d_neighbors, points, queries, radii)
    relative = tolerances.sqdist_relative
    np.testing.assert_allclose(search.knn_search(queries, 8).sqdists, nearest, rtol=relative, atol=1e-9)
    for radius, (indices, sqdists, splits) in zip(radii, within, strict=True):
        result = search.radius_search(queries, radius)
        np.testing.assert_array_equal(result.indices, indices)
        np.testing.assert_allclose(result.sqdists, sqdists, rtol=relative, atol=1e-9)
        np.testing.assert_array_equal(result.counts, np.diff(splits))


@pytest.mark.parametrize("scale", [2e-13, 1e18])
def test_neighbors_are_exact_at_any_scale(device, scale, rng, tolerances):
    """Points beyond these scales are rejected: test_cached_tree.py."""
    cloud = loom.PointCloud(rng.random((300, 3)) * scale, device=device, origin=np.zeros(3))
    search = loom.NearestNeighborSearch(cloud)
    assert_nearest(search.knn_search(cloud, 8), square_distances(cloud, cloud.points), 8, np.inf, tolerances)


@pytest.mark.parametrize("radius", [1e-300, 1e30, 1.7e308])
def test_any_positive_radius_is_accepted(device, radius, rng):
    search = loom.NearestNeighborSearch(rng.random((50, 3)), device=device)
    expected = 1 if radius < 1 else 50
    queries = search.cloud
    assert (search.radius_search(queries, radius).counts == expected).all()
    assert (search.hybrid_search(queries, radius, 60).counts == expected).all()


def test_queries_with_another_origin_are_moved_to_the_clouds(device, rng):
    points = rng.random((300, 3)) * 10 + [5e5, 5.4e6, 0]
    search = loom.NearestNeighborSearch(points, device=device)
    queries = loom.PointCloud(points[:50], device=device, origin=[4.9e5, 5.41e6, 3.0])
    assert (queries.origin != search.cloud.origin).any()
    result = search.knn_search(queries, 1)
    np.testing.assert_array_equal(result.indices[:, 0], np.arange(50))


def test_search_ignores_new_points_assigned_to_the_cloud(device, rng):
    points = rng.random((400, 3))
    cloud = loom.PointCloud(points, device=device)
    search = loom.NearestNeighborSearch(cloud)
    before = search.knn_search(points[::-1], 5)
    for shift in (0.3, 5e5):
        cloud.points = points + shift
        for _ in range(4):  # an array of the same size may get the address of a freed one
            after = search.knn_search(points[::-1], 5)
            np.testing.assert_array_equal(after.indices, before.indices)
            np.testing.assert_array_equal(after.sqdists, before.sqdists)


SIZES = [real(1).map(lambda x, size=size: x * size) for size in (1e-25, 1e15)]
SMALL = clouds(INTEGERS, real(10), *SIZES, NOT_FINITE)


@examples(30)
@given(points=SMALL, queries=SMALL, k=st.integers(1, 12), radius=st.sampled_from([1e-20, 1.0, 5.0, 1e14]))
def test_any_small_cloud_is_searched_exactly(device, tolerances, points, queries, k, radius):
    cloud = loom.PointCloud(points, device=device, origin=np.zeros(3))
    finite = cloud.points[np.isfinite(cloud.points).all(axis=1)]
    if len(finite) and 0 < np.ptp(finite, axis=0).max() < SMALLEST_EXTENT:
        with pytest.raises(ValueError, match=r"^points:"):
            loom.NearestNeighborSearch(cloud)
        return
    search = loom.NearestNeighborSearch(cloud)
    expected = square_distances(cloud, queries)
    assert_nearest(search.knn_search(queries, k), expected, k, np.inf, tolerances)
    assert_nearest(search.hybrid_search(queries, radius, k), expected, k, radius, tolerances)
    assert_nearest(rows_of(search.radius_search(queries, radius), 41), expected, 41, radius, tolerances)
    self_sqdists = square_distances(cloud, cloud.points)
    assert_nearest(search.hybrid_search(cloud, radius, k), self_sqdists, k, radius, tolerances)
