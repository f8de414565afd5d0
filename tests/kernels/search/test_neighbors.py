"""Searches by groups, lanes and limits give the neighbors of brute force, with ties by index."""

import numpy as np
import pytest
from scipy.spatial import cKDTree

from pointloom.core.devices import resolve_device
from pointloom.kernels.features.fpfh import count_angles, sum_histograms
from pointloom.kernels.lang import WARP, array, cpu_compiler, float32, int32, kernel, lane, launch, shuffle, tid, vec3
from pointloom.kernels.memory import download, empty, full, upload
from pointloom.kernels.search import group_scratch, nearest_point
from pointloom.kernels.search.group_scratch import GroupScratch
from pointloom.kernels.search.group_search import gather_candidates
from pointloom.kernels.search.lane_search import list_leaves
from pointloom.kernels.search.nearest_point import NO_POINT, find_nearest
from pointloom.kernels.search.neighbor_limits import Neighborhood
from pointloom.kernels.search.point_tree import BUCKET, LEAF, PointTree
from pointloom.kernels.search.tree_search import search_nearest
from pointloom.kernels.segmentation.dbscan import count_lacking
from pointloom.kernels.surface.neighbor_moments import sum_neighbor_moments

SEARCHES = [(0.2, 12), (np.inf, 12), (0.2, None), (np.inf, None), (0.2, 1), (1e-6, 5), (1e9, 20)]


def tree_of(device, points):
    return PointTree(upload(np.float32(points), vec3, device))


def sorted_sqdists(tree, row):
    """float32 squared distances of a point to all, as the tree computes them, and the order by distance and place."""
    p = tree.points.numpy()[: tree.count]
    d = p - p[row]
    sqdists = d[:, 0] * d[:, 0] + d[:, 1] * d[:, 1] + d[:, 2] * d[:, 2]
    return sqdists, np.lexsort((np.arange(len(p)), sqdists))


def clustered(rng, count=400):
    """A cloud whose density varies, with lattice ties and duplicates."""
    points = rng.random((count, 3)) ** 3
    points[: count // 4] = np.round(points[: count // 4] * 8) / 8
    points[-5:] = points[0]
    return points


def assert_limits(tree, radius, max_nn):
    limits = Neighborhood(tree, radius, max_nn).limits.numpy()
    for row in range(0, tree.count, 7):
        sqdists, order = sorted_sqdists(tree, row)
        keys = (sqdists.view(np.int32).astype(np.int64) << 32) | np.arange(tree.count)
        nearest = [j for j in order if float(sqdists[j]) < float(radius) ** 2][:max_nn]
        np.testing.assert_array_equal(np.flatnonzero(keys <= limits[row]), np.sort(nearest))


@pytest.mark.parametrize(("radius", "max_nn"), SEARCHES)
def test_the_keys_up_to_a_limit_are_the_nearest(device, radius, max_nn, rng):
    assert_limits(tree_of(device, clustered(rng)), radius, max_nn)


@pytest.mark.parametrize("spread", [0.0, 1e-3, 1.0])
def test_limits_part_points_at_equal_or_wildly_different_distances(device, spread, rng):
    """Where interpolation leads nowhere the interval is halved: ties by place, and distances of 30 magnitudes."""
    points = np.zeros((300, 3))
    points[:150, 0] = 10.0 ** rng.uniform(-15, 0, 150) * spread
    assert_limits(tree_of(device, points), 2.0, 20)


def crowded(rng, count=3000):
    """So many points in one place that no group's candidates fit into its scratch memory, and some around it."""
    return np.concatenate([0.01 * rng.normal(size=(count, 3)), rng.normal(size=(200, 3))])


@pytest.mark.parametrize("make", [clustered, crowded])
@pytest.mark.parametrize(("radius", "max_nn"), [(0.2, 12), (np.inf, 12), (0.2, None)])
def test_traversals_and_groups_give_the_same_neighbors(device, make, radius, max_nn, rng, tolerances, monkeypatch):
    tree = tree_of(device, make(rng))
    normals = rng.normal(size=(tree.count, 3))
    normals = upload(np.float32(normals / np.linalg.norm(normals, axis=1, keepdims=True)), vec3, tree.device)
    results = []
    for room in (group_scratch.candidate_room, lambda device, k: 0):
        monkeypatch.setattr(group_scratch, "candidate_room", room)
        neighborhood = Neighborhood(tree, radius, max_nn)
        moments = sum_neighbor_moments(neighborhood).numpy()
        histograms = count_angles(neighborhood, normals, neighborhood.positions)
        features = empty((tree.count, 33), float32, tree.device)
        sum_histograms(neighborhood, histograms, neighborhood.positions, neighborhood.positions, features)
        results.append((moments, histograms.numpy(), features.numpy()))
    (moments, histograms, features), traversal = results
    np.testing.assert_array_equal(moments[:, 0], traversal[0][:, 0])
    np.testing.assert_allclose(moments, traversal[0], rtol=0, atol=1e-12 * np.abs(moments).max())
    np.testing.assert_array_equal(histograms, traversal[1])
    np.testing.assert_allclose(features, traversal[2], rtol=0, atol=tolerances.fpfh_block)


def clouds(rng):
    lattice = np.stack(np.meshgrid(*[np.arange(7.0)] * 3, indexing="ij"), -1).reshape(-1, 3)
    scattered = rng.random((2001, 3))
    dense = np.concatenate([rng.random((500, 3)), 1e-3 * rng.random((500, 3))])
    spoiled = scattered.copy()
    spoiled[rng.integers(0, 2001, 300), rng.integers(0, 3, 300)] = np.nan
    return {
        "scattered": (scattered, rng.random((1003, 3)) * 1.5 - 0.25),
        "ties": (lattice, rng.permutation(lattice) + 0.5),
        "two densities": (dense, rng.random((701, 3))),
        "all equal": (np.ones((300, 3)), np.ones((50, 3))),
        "far away": (scattered, scattered + np.array([1000, 0, 0])),
        "not finite": (spoiled, spoiled[::-1].copy()),
        "one point": (np.zeros((1, 3)), rng.random((9, 3))),
        "nothing": (np.full((5, 3), np.nan), rng.random((9, 3))),
        "few queries": (scattered, rng.random((3, 3))),
    }


@pytest.mark.parametrize("name", list(clouds(np.random.default_rng(0))))
@pytest.mark.parametrize("radius", [np.inf, 0.5, 0.05, 1e-30])
def test_the_nearest_point_is_the_first_that_the_search_finds(device, name, radius, rng, monkeypatch):
    target, queries = (upload(p.astype(np.float32), vec3, device) for p in clouds(rng)[name])
    tree = PointTree(target)
    indices, sqdists, counts = (part.numpy() for part in search_nearest(tree, queries, 1, radius))
    for sparse in (0, 10**9):  # each query alone; all in groups
        monkeypatch.setattr(nearest_point, "MAX_POINTS_PER_QUERY", sparse)
        keys = find_nearest(tree, queries, radius=radius).numpy()
        np.testing.assert_array_equal(keys >= 0, counts == 1)
        assert (keys[counts == 0] == NO_POINT).all()
        np.testing.assert_array_equal((keys & 0xFFFFFFFF)[counts == 1], indices[counts == 1, 0])
        np.testing.assert_array_equal((keys >> 32)[counts == 1], sqdists[counts == 1, 0].view(np.int32))


@pytest.mark.parametrize("name", list(clouds(np.random.default_rng(0))))
def test_the_nearest_point_does_not_depend_on_the_order_of_queries(device, name, rng, monkeypatch):
    target, points = (p.astype(np.float32) for p in clouds(rng)[name])
    tree, queries = PointTree(upload(target, vec3, device)), upload(points, vec3, device)
    expected = find_nearest(tree, queries, radius=0.5).numpy()
    is_finite = np.isfinite(points).all(axis=1)
    shuffled = rng.permutation(len(points))
    orders = PointTree(queries).order.numpy(), shuffled[np.argsort(~is_finite[shuffled], kind="stable")]
    monkeypatch.setattr(nearest_point, "order_along_curve", None)  # not called if an order is given
    for order in orders:
        given = upload(order, int32, device)
        np.testing.assert_array_equal(find_nearest(tree, queries, radius=0.5, order=given).numpy(), expected)


@pytest.mark.parametrize("name", list(clouds(np.random.default_rng(0))))
def test_a_point_is_not_the_nearest_other_one(device, name, rng, monkeypatch):
    points = clouds(rng)[name][0]
    finite = np.isfinite(points).all(axis=1)
    array = upload(points.astype(np.float32), vec3, device)
    tree = PointTree(array)
    expected = np.full(len(points), NO_POINT)
    p = points.astype(np.float32)
    for row in np.flatnonzero(finite):
        squares = (p - p[row]) ** 2
        sqdists = (squares[:, 0] + squares[:, 1]) + squares[:, 2]
        sqdists[row] = np.nan
        if np.isfinite(sqdists).any():
            best = np.nanargmin(sqdists)
            expected[row] = (int(sqdists[best : best + 1].view(np.int32)[0]) << 32) | best
    for sparse in (0, 10**9):
        monkeypatch.setattr(nearest_point, "MAX_POINTS_PER_QUERY", sparse)
        np.testing.assert_array_equal(find_nearest(tree, array, others=True).numpy(), expected)


@kernel
def gather_kernel(center: vec3, max_sqdist: float, tree: PointTree, scratch: GroupScratch, sizes: array(dtype=int32)):
    i = tid()
    sizes[i] = gather_candidates(center, center, 0, max_sqdist, tree, tree.order, scratch, i * scratch.gather)


@pytest.mark.parametrize("compiler", ["taichi", "warp"])
@pytest.mark.parametrize("count", [1, LEAF - 1, LEAF, 3 * LEAF + 5, 300])
def test_values_after_the_last_candidate_are_infinite(compiler, count, rng, monkeypatch):
    """Eight candidates are measured at a time: memory that held numbers near the query must not look like points."""
    warp_device = resolve_device("cpu")
    monkeypatch.setattr(group_scratch, "candidate_room", lambda device, k: 64 * LEAF)
    made = lambda shape, dtype, device: full(shape, {float32: 0.5}.get(dtype, 1), dtype, device)  # noqa: E731
    monkeypatch.setattr(group_scratch, "empty", made)
    points = rng.random((count, 3)).astype(np.float32)
    tree, scratch = PointTree(upload(points, vec3, warp_device)), GroupScratch(warp_device, 1, 8)
    sizes = empty(1, int32, warp_device)
    with cpu_compiler(compiler):
        launch(gather_kernel, 1, [[0.5, 0.5, 0.5], 4.0, tree, scratch, sizes])
    size, rows = int(download(sizes)[0]), [download(a) for a in (scratch.xs, scratch.ys, scratch.zs)]
    assert size == count
    np.testing.assert_array_equal(np.stack(rows, 1)[:size], points[download(scratch.ids)[:size]])
    for row in rows:
        assert np.isinf(row[size : -(-size // LEAF) * LEAF]).all() and (row[-(-size // LEAF) * LEAF :] == 0.5).all()


@pytest.mark.parametrize("compiler", ["taichi", "warp"])
def test_too_many_candidates_do_not_overflow_the_scratch_memory(compiler, rng, monkeypatch):
    warp_device = resolve_device("cpu")
    monkeypatch.setattr(group_scratch, "candidate_room", lambda device, k: 2 * LEAF)
    tree = PointTree(upload(rng.random((50, 3)).astype(np.float32), vec3, warp_device))
    scratch, sizes = GroupScratch(warp_device, 1, 8), empty(1, int32, warp_device)
    scratch.xs, scratch.ys, scratch.zs = (full(4 * LEAF, 0.5, a.dtype, warp_device) for a in (scratch.xs,) * 3)
    with cpu_compiler(compiler):
        launch(gather_kernel, 1, [[0.5, 0.5, 0.5], 4.0, tree, scratch, sizes])
    assert int(download(sizes)[0]) == 2 * LEAF + 1
    for row in (scratch.xs, scratch.ys, scratch.zs):
        assert (download(row)[2 * LEAF :] == 0.5).all()


@kernel
def count_leaves_kernel(
    sqdists: array(dtype=float32), tree: PointTree, scratch: GroupScratch, sizes: array(dtype=int32)
):
    i = tid()
    sizes[i // WARP] = 0  # warps search on CUDA alone


@count_leaves_kernel.on_cuda
def count_leaves_of_lanes_kernel(
    sqdists: array(dtype=float32), tree: PointTree, scratch: GroupScratch, sizes: array(dtype=int32)
):
    i = tid()
    rank = min(i, tree.count - 1)
    start = shuffle(rank // BUCKET, 0)
    size = list_leaves(tree.points[rank], sqdists[rank], start, tree, scratch, (i // WARP) * scratch.gather)
    if lane() == 0:
        sizes[i // WARP] = size


def scene_points(name, rng, count=20_000):
    """Points of a bumpy surface, of a spinning LiDAR in a room, or in a cube [m]."""
    if name == "cube":
        return rng.random((count, 3))
    if name == "surface":
        xy = rng.uniform(-2, 2, (count, 2))
        return np.column_stack([xy, 0.2 * np.sin(3 * xy[:, 0]) * np.cos(2 * xy[:, 1])])
    azimuth, ring = np.divmod(np.arange(count), 32)
    azimuth, slope = 2 * np.pi * azimuth * 32 / count, np.tan(np.radians(-25 + 40 * ring / 31))
    x, y = np.cos(azimuth), np.sin(azimuth)
    flat = np.minimum(12 / np.maximum(np.abs(x), 1e-9), 7 / np.maximum(np.abs(y), 1e-9))  # [m] to the walls
    flat = np.where(slope < 0, np.minimum(flat, -1.7 / np.minimum(slope, -1e-9)), flat)  # or the floor
    return np.column_stack([x * flat, y * flat, slope * flat]) + rng.normal(0, 0.01, (count, 3))


@pytest.mark.parametrize("scene", ["surface", "lidar", "cube"])
def test_no_warp_has_many_more_leaves_than_the_others(device, scene, rng):
    """The curve jumps within some leaves. One box for such a leaf would contain much of the cloud, and its warp would
    run alone on the GPU, with 20 to 74 times the mean number of leaves."""
    tree = tree_of(device, scene_points(scene, rng))
    if not tree.device.is_cuda:
        pytest.skip("warps search on CUDA alone")
    points = tree.points.numpy()[: tree.count]
    sqdists = upload(cKDTree(points).query(points, 20)[0][:, -1] ** 2, float32, tree.device)
    scratch, warps = GroupScratch(tree.device, tree.count, 20), -(-tree.count // WARP)
    sizes = empty(warps, int32, tree.device)
    scratch.gather, scratch.ids = 2000, empty(2000 * warps, int32, tree.device)
    launch(count_leaves_kernel, warps * WARP, [sqdists, tree, scratch, sizes])
    leaves = download(sizes)
    assert leaves.min() >= 1 and leaves.max() < 6 * leaves.mean()


@kernel
def count_core_leaves_kernel(needed: int, max_sqdist: float, tree: PointTree, sizes: array(dtype=int32)):
    i = tid()
    sizes[i // WARP] = 0  # warps search on CUDA alone


@count_core_leaves_kernel.on_cuda
def count_core_leaves_of_lanes_kernel(needed: int, max_sqdist: float, tree: PointTree, sizes: array(dtype=int32)):
    i = tid()
    counted = count_lacking(tree.points[min(i, tree.count - 1)], needed, i // BUCKET, tree, max_sqdist)
    if lane() == 0:
        sizes[i // WARP] = counted[1]


@pytest.mark.parametrize(("scene", "radius"), [("surface", 0.1), ("lidar", 0.45), ("cube", 0.074)])
def test_no_warp_counts_neighbors_in_many_more_leaves_than_the_others(device, scene, radius, rng):
    tree = tree_of(device, scene_points(scene, rng))
    if not tree.device.is_cuda:
        pytest.skip("warps search on CUDA alone")
    warps = -(-tree.count // WARP)
    sizes = empty(warps, int32, tree.device)
    launch(count_core_leaves_kernel, warps * WARP, [10, radius**2, tree, sizes])
    leaves = download(sizes)
    assert leaves.min() >= 1 and leaves.max() < 3 * leaves.mean()  # 3.9 times with one box per eight points
    launch(count_core_leaves_kernel, warps * WARP, [1, radius**2, tree, sizes])
    assert download(sizes).max() <= 8  # each point is its own neighbor, so no warp leaves its bucket
