"""The cached search tree: built once for all clouds with the same points, shared, and updated with them."""

import copy
import gc
import pickle
import weakref

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.devices import resolve_device
from pointloom.kernels.arrays.fingerprint import fingerprint
from pointloom.kernels.lang import vec3
from pointloom.kernels.memory import download, upload
from pointloom.pcd import cached_tree


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
    registration.registration_colored_icp(source, target, 0.1)
    registration.registration_generalized_icp(source, target, 0.1)
    assert builds == [800, 700]
    np.testing.assert_array_equal(first.transformation, again.transformation)


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
    view = borrowed.array("points").numpy()
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
    tree, points = weakref.ref(cloud.search_tree()), weakref.ref(cloud._device_array("points"))
    gc.disable()  # memory must be freed without the garbage collector, which does not see device memory
    try:
        del cloud
        assert tree() is not None
        del shared
        assert tree() is None and points() is None
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
