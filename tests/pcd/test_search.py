"""Neighbor search is exact on all kinds of clouds and code paths, and its trees are built once for each cloud."""

import copy
import gc
import pickle
import weakref

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial import KDTree

import pointloom as loom
from pointloom.core.devices import resolve_device
from pointloom.kernels.arrays.fingerprint import fingerprint
from pointloom.kernels.lang import vec3
from pointloom.kernels.memory import download, upload
from pointloom.kernels.search import group_scratch, tree_search
from pointloom.kernels.search.hilbert_order import MAX_FEW_POINTS
from pointloom.kernels.search.many_clouds import ManyClouds
from pointloom.kernels.search.point_tree import LEAF, PointTree
from pointloom.kernels.search.tree_search import search_nearest
from pointloom.pcd import cached_tree
from pointloom.pcd.cached_tree import SMALLEST_EXTENT

from .any_cloud import INTEGERS, NOT_FINITE, clouds, examples, real
from .nearest_oracle import EXACT, SHAPES, assert_nearest, make_cloud, queries_for, rows_of, sphere, square_distances


def made_search(shape, rng, device):
    """A cloud, its search, queries, and all squared distances from the queries and from the points."""
    cloud = make_cloud(shape, rng, device)
    queries = queries_for(cloud.points, rng)
    sqdists = square_distances(cloud, queries), square_distances(cloud, cloud.points)
    return cloud, loom.NearestNeighborSearch(cloud), queries, *sqdists


@pytest.mark.parametrize("shape", SHAPES)
def test_k_nearest_agree_with_brute_force(device, shape, rng, tolerances):
    cloud, search, queries, expected, self_sqdists = made_search(shape, rng, device)
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
    cloud, search, queries, expected, self_sqdists = made_search(shape, rng, device)
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
    cloud = loom.PointCloud(points, device=device).arrays["points"]
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
    points = cloud.arrays["points"]
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


@pytest.mark.parametrize("count", [1, tree_search.COUNTED_NEIGHBORS, tree_search.COUNTED_NEIGHBORS + 1])
@pytest.mark.parametrize("query_count", [1, 50, MAX_FEW_POINTS + 1])
def test_a_radius_that_contains_all_points_lists_them_as_the_k_nearest(device, count, query_count, rng):
    points, queries = rng.random((count, 3)), rng.random((query_count, 3))
    queries[1::9] = np.nan
    search = loom.NearestNeighborSearch(points, device=device)
    indices, sqdists, counts = search.radius_search(queries, 2.0)
    expected = search.knn_search(queries, count)
    np.testing.assert_array_equal(counts, expected.counts)
    finite = np.isfinite(queries[:, 0])
    np.testing.assert_array_equal(indices, expected.indices[finite].reshape(-1))
    np.testing.assert_array_equal(sqdists, expected.sqdists[finite].reshape(-1))


@pytest.mark.parametrize("options", [{}, {"k": 5}, {"k": 5, "distance_upper_bound": 0.1}, {"k": 40}])
def test_a_tree_answers_queries_as_that_of_scipy(device, rng, options):
    points, queries = rng.random((30, 3)), rng.random((50, 3))
    tree, theirs = loom.KDTree(points, device=device), KDTree(points)
    for x in (queries, queries[0]):
        for actual, expected in zip(tree.query(x, **options), theirs.query(x, **options), strict=True):
            assert np.shape(actual) == np.shape(expected) and np.asarray(actual).dtype == np.asarray(expected).dtype
            np.testing.assert_allclose(actual, expected, atol=1e-6)  # float32


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


@pytest.fixture
def builds(monkeypatch):
    """The sizes of the trees that clouds build."""
    sizes, original = [], cached_tree.PointTree

    def build(points):
        sizes.append(points.size)
        return original(points)

    monkeypatch.setattr(cached_tree, "PointTree", build)
    return sizes


def test_operations_on_the_same_points_build_one_tree(device, rng, builds):
    cloud = loom.PointCloud(rng.random((3000, 3)), colors=rng.random((3000, 3)), device=device)
    first = cloud.estimate_normals(max_nn=12)
    again = first.estimate_normals(radius=0.2).estimate_covariances()
    again.cluster_dbscan(0.1, 5)
    _ = again.remove_statistical_outlier(10, 2.0)
    _ = again.remove_radius_outlier(3, 0.2)
    _ = again.compute_nearest_neighbor_distance()
    _ = again.farthest_point_down_sample(10)
    cloud.compute_point_cloud_distance(again)
    loom.NearestNeighborSearch(again.copy()).knn_search(again, 3)
    assert builds == [3000]


def test_registration_takes_the_trees_that_its_clouds_keep(device, rng, builds):
    points, colors = rng.random((800, 3)), rng.random((800, 3))
    target = loom.PointCloud(points, colors=colors, device=device).estimate_normals(max_nn=12)
    source = loom.PointCloud(points[:700] + 0.003, colors=colors[:700], device=device)
    registration = loom.registration
    first = registration.registration_icp(source, target, 0.1)
    source = source.estimate_normals(max_nn=12)
    again = registration.registration_icp(source, target, 0.1)
    for name in ("ForColoredICP", "ForGeneralizedICP"):
        method = getattr(registration, f"TransformationEstimation{name}")()
        registration.registration_icp(source, target, 0.1, None, method)
    assert builds == [800, 700]
    np.testing.assert_array_equal(first.transformation, again.transformation)


def test_registrations_of_the_same_clouds_sort_them_once(device, rng, monkeypatch):
    made, original = [], ManyClouds.__init__

    def counting(self, clouds, *args, **options):
        made.append([len(points) for points in clouds])
        original(self, clouds, *args, **options)

    monkeypatch.setattr(ManyClouds, "__init__", counting)
    points = upload(np.float32(rng.random((300, 3))), vec3, resolve_device(device))
    source, target = loom.PointCloud(points), loom.PointCloud(rng.random((400, 3)), device=device)
    results = [loom.registration.registration_icp(source, target, 0.2) for _ in range(2)]
    loom.registration.evaluate_registration(source.copy(), target, 0.2)
    assert made == [[300], [400]]
    np.testing.assert_array_equal(*(result.transformation for result in results))
    points.assign(np.float32(rng.random((300, 3))))  # shared: the order is made anew
    result = loom.registration.registration_icp(source, target, 0.2)
    fresh = loom.registration.registration_icp(loom.PointCloud(source.points, device=device), target, 0.2)
    assert made[2:] == [[300], [300]]
    np.testing.assert_array_equal(result.transformation, fresh.transformation)


def test_other_points_have_a_tree_of_their_own(device, rng, builds):
    cloud = loom.PointCloud(rng.random((500, 3)), device=device)
    cloud.search_tree()
    moved = cloud.transform(np.eye(4))
    chosen = cloud.select_by_index(np.arange(100))
    deep, loaded = copy.deepcopy(cloud), pickle.loads(pickle.dumps(cloud))
    for other in (moved, chosen, deep, loaded):
        assert other.search_tree() is not cloud.search_tree()
    assert builds == [500, 500, 100, 500, 500]


def test_assigned_points_are_searched_and_leave_other_clouds_alone(device, rng):
    points = rng.random((400, 3))
    cloud = loom.PointCloud(points, device=device)
    shared = cloud.copy()
    before = shared.compute_nearest_neighbor_distance()
    cloud.points = 2 * points
    np.testing.assert_allclose(cloud.compute_nearest_neighbor_distance(), 2 * before, rtol=1e-5)
    np.testing.assert_array_equal(shared.compute_nearest_neighbor_distance(), before)


def test_overwritten_points_are_detected(device, rng, builds):
    if device != "cpu":
        pytest.skip("NumPy writes to the CPU's arrays")
    points = np.float32(rng.random((700, 3)))
    cloud = loom.PointCloud.from_dlpack(points)
    borrowed = loom.PointCloud(points, device=device)
    borrowed.search_tree()
    view = borrowed.array("points")
    for changed, array in ((cloud, points), (borrowed, view)):
        for step in range(3):
            array[step] += 5.0
            fresh = loom.PointCloud(array)
            distances = [one.compute_nearest_neighbor_distance() for one in (changed, fresh)]
            np.testing.assert_array_equal(*distances)
    before = len(builds)
    cloud.compute_nearest_neighbor_distance()
    borrowed.compute_nearest_neighbor_distance()
    assert len(builds) == before  # unchanged points are not rebuilt


@pytest.mark.parametrize("make", [loom.PointCloud, loom.PointCloud.from_dlpack])
def test_only_frozen_points_are_not_compared_with_those_of_the_tree(device, rng, monkeypatch, make):
    first, second = (upload(rng.random((300, 3)).astype(np.float32), vec3, resolve_device(device)) for _ in range(2))
    cloud = make(first, frozen=True)
    assert cloud.arrays["points"].ptr == first.ptr
    tree = cloud.search_tree()
    with monkeypatch.context() as patch:
        patch.setattr(cached_tree, "fingerprint", lambda _: pytest.fail("compared"))
        for one in (cloud, cloud.copy(), cloud.estimate_normals(max_nn=5)):
            assert one.search_tree() is tree
    cloud.points = second
    tree = cloud.search_tree()
    second.assign(2 * second.numpy())
    assert cloud.search_tree() is not tree
    with pytest.raises(TypeError, match=r"^frozen: expected True or False, got"):
        make(first, frozen=np.zeros(300))


def test_pickled_buffers_are_copies(rng):
    cloud, buffers = loom.PointCloud(rng.random((50, 3))), []
    before = cloud.points
    pickle.dumps(cloud, 5, buffer_callback=buffers.append)
    for buffer in buffers:
        if not buffer.raw().readonly:
            np.frombuffer(buffer.raw(), np.uint8)[:] = 0
    assert buffers
    np.testing.assert_array_equal(cloud.points, before)


def test_tree_is_freed_with_the_last_cloud(device, rng):
    cloud = loom.PointCloud(rng.random((300, 3)), device=device)
    shared = cloud.estimate_normals(max_nn=5)
    loom.registration.registration_icp(cloud, shared, 0.1)
    cached = cloud.search_tree(), cloud.arrays.tree.order(), cloud.arrays.tree.forest(), cloud.arrays["points"]
    references = [weakref.ref(part) for part in cached]
    del cached
    gc.disable()  # memory must be freed without the garbage collector, which does not see device memory
    try:
        del cloud
        assert all(reference() is not None for reference in references)
        del shared
        assert all(reference() is None for reference in references)
    finally:
        gc.enable()


@pytest.mark.parametrize("count", [0, 1, 255, 256, 257, 10_000])
def test_a_fingerprint_changes_with_any_bit_and_any_exchange(device, rng, count):
    where = resolve_device(device)
    points = np.float32(rng.normal(size=(count, 3)))
    points[::7] = np.nan
    original = fingerprint(upload(points, vec3, where))
    assert fingerprint(upload(points, vec3, where)) == original
    fingerprints = {original}
    for row in {0, count // 2, count - 1} if count else ():
        for axis in range(3):
            changed = points.copy()
            changed.view(np.uint32)[row, axis] ^= 1
            fingerprints.add(fingerprint(upload(changed, vec3, where)))
    if count > 1:
        swapped = points.copy()
        swapped[[0, count - 1]] = swapped[[count - 1, 0]]
        fingerprints.add(fingerprint(upload(swapped, vec3, where)))
    assert len(fingerprints) == 1 + 3 * len({0, count // 2, count - 1} if count else ()) + (count > 1)


def test_cached_tree_is_unchanged_by_smoothing_with_fixed_neighborhoods(device, rng):
    """The pass reorders points along the curve; it must not modify those of the cached tree."""
    cloud = loom.PointCloud(rng.random((900, 3)), device=device)
    before = download(cloud.search_tree().points).copy()
    _ = cloud.smooth_laplacian(iterations=3, use_fixed_neighborhoods=True)
    np.testing.assert_array_equal(download(cloud.search_tree().points), before)


CORNERS = np.array([[0, 0, 0], [1, 0, 0], [0, 2, 0], [0, 0, 4.0], [3, 3, 3]])
ICP = loom.registration.registration_icp
SEARCHES = {
    "search": loom.NearestNeighborSearch,
    "dbscan": lambda c: c.cluster_dbscan(0.5, 1),
    "euclidean": lambda c: c.cluster_euclidean(0.5),
    "statistical": lambda c: c.remove_statistical_outlier(3, 1.0),
    "radius": lambda c: c.remove_radius_outlier(3, 1.0),
    "distance": lambda c: c.compute_point_cloud_distance(c),
    "nearest": lambda c: c.compute_nearest_neighbor_distance(),
    "normals": lambda c: c.estimate_normals(max_nn=4),
    "farthest": lambda c: c.farthest_point_down_sample(2),
    "features": lambda c: loom.compute_fpfh_feature(loom.PointCloud(c.points, normals=CORNERS + 1), max_nn=4),
    "icp": lambda c: ICP(c, c, 1.0),
    "icp_batch": lambda c: loom.registration.registration_icp_batch([c, c], [c, c.copy()], 1.0),
    "icp_targets": lambda c: loom.registration.registration_icp_batch(c, [c, loom.PointCloud(2 * c.points)], 1.0),
}


@pytest.mark.parametrize("operation", list(SEARCHES))
@pytest.mark.parametrize(
    ("scale", "message"),
    [
        (1e-20, r"^(points|targets): expected an extent .* got [48]e-20 m: .* underflow float32.*scale\([123]e\+19"),
        (1e20, r"^(points|targets): expected most points within 5e\+18 m .* overflow float32. .*scale\([12]e-21"),
    ],
)
def test_points_with_overflowing_squared_distances_are_rejected(operation, scale, message):
    """All points would coincide or be out of range of each other."""
    cloud = loom.PointCloud(CORNERS * scale)
    for _ in range(2):  # and no cached tree remains for the next call
        with pytest.raises(ValueError, match=message):
            SEARCHES[operation](cloud)


@pytest.mark.parametrize("scale", [1e-20, 9e-14, 1e20, 1e30])
def test_rejected_points_are_measured_after_the_suggested_scaling(device, scale, rng):
    points = rng.random((50, 3))
    cloud = loom.PointCloud(points * scale, device=device)
    with pytest.raises(ValueError, match=r"^points:") as error:
        cloud.compute_nearest_neighbor_distance()
    factor = float(str(error.value).split("scale(")[1].split(",")[0])
    distances = np.linalg.norm(points[:, None] - points, axis=2) + 9 * np.eye(50)
    scaled = cloud.scale(factor, cloud.get_center())
    result = scaled.compute_nearest_neighbor_distance()
    np.testing.assert_allclose(result, distances.min(axis=1) * scale * factor, rtol=1e-5)


@pytest.mark.parametrize(
    "points", [np.full((7, 3), 1e-20), np.zeros((1, 3)), np.full((3, 3), np.nan), np.zeros((0, 3))]
)
def test_coincident_points_are_not_too_close(device, points):
    assert not np.nan_to_num(loom.PointCloud(points, device=device).compute_nearest_neighbor_distance()).any()


def test_half_of_the_points_may_be_out_of_range(device, rng):
    """They are nobody's neighbors. With more of them, few points remain to be measured."""
    points = rng.random((20, 3))
    points[:9] *= 1e25
    distances = loom.PointCloud(points, device=device).compute_nearest_neighbor_distance()
    assert (distances[9:] < 1).all()
    points[9:11] *= 1e25
    with pytest.raises(ValueError, match=r"^points:"):
        loom.PointCloud(points, device=device).compute_nearest_neighbor_distance()
