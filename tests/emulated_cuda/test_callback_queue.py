"""Exact numbers of device calls and waits of the hot operations.

Each launch costs a program some 20 microseconds of Python and each wait 10, more than most of these kernels take.
"""

import numpy as np
import pytest
import warp as wp

import pointloom as loom
from pointloom.kernels.arrays.bounds import bound_points
from pointloom.kernels.arrays.prefix_sum import exclusive_scan
from pointloom.kernels.arrays.select import positions_of
from pointloom.kernels.arrays.unique import UniqueKeys
from pointloom.kernels.lang import int32, int64, uint8, vec3
from pointloom.kernels.memory import upload
from pointloom.kernels.sampling.farthest_points import choose_farthest
from pointloom.kernels.search.point_forest import PointForest
from pointloom.kernels.search.point_tree import PointTree

COUNT = 40_000  # points: five levels of boxes
CALLS = {  # kernels, copies to the host
    "the box of points": (lambda d: bound_points(d.points), 1, 1),
    "offsets": (lambda d: exclusive_scan(d.counts), 1, 1),
    "offsets of small counts": (lambda d: exclusive_scan(d.counts, largest=4), 0, 1),
    "positions of a mask": (lambda d: positions_of(d.mask), 2, 1),
    "unique keys": (lambda d: UniqueKeys(d.keys, 10), 3, 1),
    "means of voxels": (lambda d: d.cloud.voxel_down_sample(0.1), 5, 2),
    "a tree": (lambda d: PointTree(d.points), 5, 1),
    "a forest": (lambda d: PointForest([d.points, d.points]), 11, 2),
}


class Data:
    """Arrays on the emulated device."""

    def __init__(self):
        rng, device = np.random.default_rng(0), wp.get_device("cuda:0")
        points = rng.random((COUNT, 3)).astype(np.float32)
        self.points, self.cloud = upload(points, vec3, device), loom.PointCloud(points, device="cuda:0")
        self.counts = upload(rng.integers(0, 5, COUNT), int32, device)
        self.mask = upload(rng.integers(0, 2, COUNT), uint8, device)
        self.keys = upload(rng.integers(0, 900, COUNT), int64, device)
        self.tree, self.search = PointTree(self.points), loom.NearestNeighborSearch(self.cloud)


@pytest.fixture(scope="module")
def data(emulated) -> Data:
    return Data()


@pytest.mark.parametrize("name", CALLS)
def test_an_operation_makes_few_device_calls(emulated, data, name):
    run, kernels, copies = CALLS[name]
    counts = emulated.count_requests(lambda: run(data))
    assert (counts["launches"], counts["copies to host"]) == (kernels, copies)


ALLOCATIONS = {  # of calls on a cloud whose tree is there
    "normals": (lambda d: d.cloud.estimate_normals(max_nn=30), 3),
    "k nearest": (lambda d: d.search.knn_search(d.points, 20), 6),
}


@pytest.mark.parametrize("name", ALLOCATIONS)
def test_scratch_of_a_search_is_one_allocation(emulated, data, name):
    run, allocations = ALLOCATIONS[name]
    run(data)
    counts = emulated.count_requests(lambda: run(data))
    assert counts["allocations"] == allocations


def test_farthest_points_are_one_graph_and_one_wait(emulated, data):
    counts = emulated.count_requests(lambda: choose_farthest(data.tree, 1000, 0))
    assert (counts["graphs"], counts["copies to host"]) == (1, 1)


def test_decimation_is_one_graph_and_four_waits(emulated):
    """However many rounds: the box, whether a triangle is there twice, what is left, the vertices that are used."""
    mesh = loom.TriangleMesh.create_sphere(resolution=20).to("cuda:0")
    for target in (500, 60):
        counts = emulated.count_requests(lambda target=target: mesh.simplify_quadric_decimation(target))
        assert (counts["graphs"], counts["copies to host"], counts["bytes to host"]) == (1, 4, 80)


def test_a_mesh_is_bent_with_one_wait_a_level(emulated):
    """The copies: fixed vertices, seams, edges, five levels, and whether it converged, for any number of iterations."""
    mesh = loom.TriangleMesh.create_sphere(resolution=20).to("cuda:0")
    for iterations in (2, 6):
        counts = emulated.count_requests(
            lambda iterations=iterations: mesh.deform_as_rigid_as_possible([0, 1], [[0, 0, 1], [0, 0, -2]], iterations)
        )
        assert (counts["graphs made"], counts["graphs"], counts["copies to host"]) == (1, iterations - 1, 9)


def test_results_of_a_scene_need_one_copy(emulated):
    mesh, rays = loom.TriangleMesh.create_sphere(), np.tile([0.1, 0.2, 3.0, 0.0, 0.0, -1.0], (50, 1))
    scene = loom.RaycastingScene(device="cuda:0")
    scene.add_triangles(mesh.to("cuda:0"))
    scene.cast_rays(rays)
    counts = emulated.count_requests(lambda: scene.cast_rays(rays))
    assert counts["copies to host"] == 1
    counts = emulated.count_requests(lambda: scene.list_intersections(rays))
    assert counts["copies to host"] == 2  # how many there are
    counts = emulated.count_requests(lambda: scene.compute_closest_points(rays[:, :3]))
    assert counts["copies to host"] == 1


def test_a_poisson_surface_waits_five_times_and_downloads_no_points(emulated):
    """At five full levels. The table of test_host_calls.py holds the other operations on clouds."""
    counts = []
    for size in (1003, 3011):
        ball = np.random.default_rng(0).normal(size=(size, 3))
        ball /= np.linalg.norm(ball, axis=1, keepdims=True)
        cloud = loom.PointCloud(ball, normals=ball).to("cuda:0", arrays="warp")
        run = lambda cloud=cloud: loom.TriangleMesh.create_from_point_cloud_poisson(cloud, 5)  # noqa: E731
        run()  # makes trees and tables
        counts.append(emulated.count_requests(run))
    assert max(row["copies to host"] for row in counts) <= 5
    assert counts[1]["bytes to host"] - counts[0]["bytes to host"] <= 400


def test_samples_are_spread_with_four_waits(emulated):
    """Whether all corners are finite, the area, the box of the samples, and how many neighbors they have."""
    mesh = loom.TriangleMesh.create_sphere().to("cuda:0")
    counts = emulated.count_requests(lambda: mesh.sample_points_poisson_disk(100).to("cuda:0", arrays="warp"))
    assert counts["copies to host"] == 4
