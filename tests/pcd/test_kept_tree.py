"""The search tree is built once for all clouds over the same points, goes with them, and follows what they become."""

import copy
import gc
import pickle
import weakref

import numpy as np
import pytest

import pointloom as loom
from pointloom.kernels.arrays.fingerprint import fingerprint
from pointloom.kernels.lang import vec3
from pointloom.kernels.memory import download, upload
from pointloom.pcd import kept_tree
from pointloom.pcd.devices import resolve_device


@pytest.fixture
def builds(monkeypatch):
    """The sizes of the trees that clouds build."""
    sizes, original = [], kept_tree.PointTree

    def build(points):
        sizes.append(points.size)
        return original(points)

    monkeypatch.setattr(kept_tree, "PointTree", build)
    return sizes


def test_operations_on_the_same_points_build_one_tree(device, rng, builds):
    cloud = loom.PointCloud(rng.random((3000, 3)), colors=rng.random((3000, 3)), device=device)
    first = cloud.estimate_normals(max_nn=12)
    again = first.estimate_normals(radius=0.2).estimate_covariances()
    again.cluster_dbscan(0.1, 5)
    again.remove_statistical_outlier(10, 2.0)
    again.remove_radius_outlier(3, 0.2)
    again.compute_nearest_neighbor_distance()
    again.farthest_point_down_sample(10)
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
    cloud._search_tree()
    moved = cloud.transform(np.eye(4))
    chosen = cloud.select_by_index(np.arange(100))
    deep, loaded = copy.deepcopy(cloud), pickle.loads(pickle.dumps(cloud))
    for other in (moved, chosen, deep, loaded):
        assert other._search_tree() is not cloud._search_tree()
    assert builds == [500, 500, 100, 500, 500]


def test_assigned_points_are_searched_and_leave_other_clouds_alone(device, rng):
    points = rng.random((400, 3))
    cloud = loom.PointCloud(points, device=device)
    shared = cloud.copy()
    before = shared.compute_nearest_neighbor_distance()
    cloud.points = 2 * points
    np.testing.assert_allclose(cloud.compute_nearest_neighbor_distance(), 2 * before, rtol=1e-5)
    np.testing.assert_array_equal(shared.compute_nearest_neighbor_distance(), before)


def test_points_that_were_written_in_place_are_noticed(device, rng, builds):
    if device != "cpu":
        pytest.skip("NumPy writes to the CPU's arrays")
    points = np.float32(rng.random((700, 3)))
    cloud = loom.PointCloud.from_dlpack(points)
    lent = loom.PointCloud(points, device=device)
    lent._search_tree()
    view = lent.array("points").numpy()
    for changed, array in ((cloud, points), (lent, view)):
        for step in range(3):
            array[step] += 5.0
            fresh = loom.PointCloud(array)
            np.testing.assert_array_equal(
                changed.compute_nearest_neighbor_distance(), fresh.compute_nearest_neighbor_distance()
            )
    before = len(builds)
    cloud.compute_nearest_neighbor_distance()
    lent.compute_nearest_neighbor_distance()
    assert len(builds) == before  # what was not written is not built again


def test_pickled_buffers_are_copies(rng):
    cloud, buffers = loom.PointCloud(rng.random((50, 3))), []
    before = cloud.points
    pickle.dumps(cloud, 5, buffer_callback=buffers.append)
    for buffer in buffers:
        if not buffer.raw().readonly:
            np.frombuffer(buffer.raw(), np.uint8)[:] = 0
    assert buffers
    np.testing.assert_array_equal(cloud.points, before)


def test_the_tree_goes_with_the_last_cloud(device, rng):
    cloud = loom.PointCloud(rng.random((300, 3)), device=device)
    shared = cloud.estimate_normals(max_nn=5)
    tree, points = weakref.ref(cloud._search_tree()), weakref.ref(cloud._device_array("points"))
    gc.disable()  # nothing may wait for the collector: it does not know how full the device is
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
    found = {original}
    for row in {0, count // 2, count - 1} if count else ():
        for axis in range(3):
            changed = points.copy()
            changed.view(np.uint32)[row, axis] ^= 1
            found.add(fingerprint(upload(changed, vec3, where)))
    if count > 1:
        swapped = points.copy()
        swapped[[0, count - 1]] = swapped[[count - 1, 0]]
        found.add(fingerprint(upload(swapped, vec3, where)))
    assert len(found) == 1 + 3 * len({0, count // 2, count - 1} if count else ()) + (count > 1)


def test_the_kept_tree_is_right_after_smoothing_with_fixed_neighbourhoods(device, rng):
    """That pass moves points by place on the curve; it must not move those of the tree that the cloud keeps."""
    cloud = loom.PointCloud(rng.random((900, 3)), device=device)
    before = download(cloud._search_tree().points).copy()
    cloud.smooth_laplacian(iterations=3, use_fixed_neighborhoods=True)
    np.testing.assert_array_equal(download(cloud._search_tree().points), before)
