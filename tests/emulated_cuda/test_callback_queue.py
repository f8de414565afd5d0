"""Waits and launches of operations do not grow with the size of their input, nor with their number of rounds.

Each launch costs a program some 20 microseconds of Python and each wait 10, more than most of these kernels take. The
numbers themselves have limits in host_calls.json.
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

FEW, MANY = 10_000, 20_000  # points, more than one block of threads chooses
CALLS = {
    "the box of points": lambda d: bound_points(d.points),
    "offsets": lambda d: exclusive_scan(d.counts),
    "offsets of small counts": lambda d: exclusive_scan(d.counts, largest=4),
    "positions of a mask": lambda d: positions_of(d.mask),
    "unique keys": lambda d: UniqueKeys(d.keys, 10),
    "means of voxels": lambda d: d.cloud.voxel_down_sample(0.1),
    "a tree": lambda d: PointTree(d.points),
    "a forest": lambda d: PointForest([d.points, d.points]),
    "farthest points": lambda d: choose_farthest(d.tree, d.count // 100, 0),
    "normals": lambda d: d.cloud.estimate_normals(max_nn=30),
    "k nearest": lambda d: d.search.knn_search(d.points, 20),
}
COUNTED = ("launches asked for", "waits", "copies to host")


class Data:
    """Arrays on the emulated device."""

    def __init__(self, count):
        rng, device = np.random.default_rng(0), wp.get_device("cuda:0")
        points = rng.random((count, 3)).astype(np.float32)
        self.count = count
        self.points, self.cloud = upload(points, vec3, device), loom.PointCloud(points, device="cuda:0")
        self.counts = upload(rng.integers(0, 5, count), int32, device)
        self.mask = upload(rng.integers(0, 2, count), uint8, device)
        self.keys = upload(rng.integers(0, 900, count), int64, device)
        self.tree, self.search = PointTree(self.points), loom.NearestNeighborSearch(self.cloud)


@pytest.fixture(scope="module")
def data(emulated) -> tuple[Data, Data]:
    return Data(FEW), Data(MANY)


def counts_of(emulated, run) -> dict[str, int]:
    """The counts of a second call, which finds trees and tables."""
    run()
    counts = emulated.count_requests(run)
    return {name: counts[name] for name in COUNTED}


@pytest.mark.parametrize("name", CALLS)
def test_calls_of_the_device_do_not_grow_with_the_points(emulated, data, name):
    """A tree may have another level, whose boxes are a launch."""
    few, many = (counts_of(emulated, lambda d=d: CALLS[name](d)) for d in data)
    assert many["launches asked for"] <= few["launches asked for"] + 1
    assert (many["waits"], many["copies to host"]) == (few["waits"], few["copies to host"])


def test_a_decimation_waits_as_often_for_any_number_of_rounds(emulated):
    mesh = loom.TriangleMesh.create_sphere(resolution=20).to("cuda:0")
    one, other = (counts_of(emulated, lambda n=n: mesh.simplify_quadric_decimation(n)) for n in (500, 60))
    assert one["waits"] == other["waits"]


def test_a_mesh_is_bent_with_as_many_waits_for_any_number_of_iterations(emulated):
    mesh = loom.TriangleMesh.create_sphere(resolution=20).to("cuda:0")
    ends = [0, 1], [[0, 0, 1], [0, 0, -2]]
    few, many = (counts_of(emulated, lambda n=n: mesh.deform_as_rigid_as_possible(*ends, n)) for n in (2, 6))
    assert few["waits"] == many["waits"]


SCENE_QUERIES = ("cast_rays", "list_intersections", "compute_closest_points")


@pytest.mark.parametrize("query", SCENE_QUERIES)
def test_results_of_a_scene_are_copied_together(emulated, query):
    """All arrays of a result are one copy. The number of intersections is another one, before."""
    rays = np.tile([0.1, 0.2, 3.0, 0.0, 0.0, -1.0], (50, 1))[:, : 3 if query == "compute_closest_points" else 6]
    scene = loom.RaycastingScene(device="cuda:0")
    scene.add_triangles(loom.TriangleMesh.create_sphere().to("cuda:0"))
    assert len(getattr(scene, query)(rays)) > 2
    assert counts_of(emulated, lambda: getattr(scene, query)(rays))["copies to host"] <= 2


def test_a_poisson_surface_downloads_no_points(emulated):
    """At five full levels."""
    counts = []
    for size in (1003, 3011):
        ball = np.random.default_rng(0).normal(size=(size, 3))
        ball /= np.linalg.norm(ball, axis=1, keepdims=True)
        cloud = loom.PointCloud(ball, normals=ball).to("cuda:0", arrays="warp")
        run = lambda cloud=cloud: loom.TriangleMesh.create_from_point_cloud_poisson(cloud, 5)  # noqa: E731
        run()  # makes trees and tables
        counts.append(emulated.count_requests(run))
    assert counts[1]["waits"] <= counts[0]["waits"]
    assert counts[1]["bytes to host"] - counts[0]["bytes to host"] <= 400


def test_more_samples_are_spread_with_as_many_waits(emulated):
    mesh = loom.TriangleMesh.create_sphere().to("cuda:0")

    def spread(count):
        return mesh.sample_points_poisson_disk(count).to("cuda:0", arrays="warp")

    few, many = (counts_of(emulated, lambda n=n: spread(n)) for n in (50, 150))
    assert many["waits"] <= few["waits"]
