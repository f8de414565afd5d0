"""Kernels in which all threads contribute to a few numbers reduce within a warp before the atomic."""

import numpy as np
import pytest
import warp as wp

from pointloom.kernels.arrays.bounds import bound_points
from pointloom.kernels.arrays.fingerprint import fingerprint
from pointloom.kernels.arrays.lowest_bit import lowest_bit
from pointloom.kernels.arrays.prefix_sum import exclusive_scan
from pointloom.kernels.arrays.runs import Runs
from pointloom.kernels.drawing.placing import find_extremes
from pointloom.kernels.extent.distance_sums import summarize_distances
from pointloom.kernels.images.depth import metric_depth
from pointloom.kernels.lang import WARP, float32, float64, int32, int64, launch, uint16, vec3, vec3i
from pointloom.kernels.memory import full, upload
from pointloom.kernels.odometry.deskewing import bound_times
from pointloom.kernels.rays.triangle_tree import TriangleTree
from pointloom.kernels.search.point_tree import PointTree
from pointloom.kernels.segmentation.dbscan import cluster_points
from pointloom.kernels.surface.orientation import NO_KEY, find_lowest_kernel

COUNT = 20_000


class Data:
    def __init__(self):
        rng, device = np.random.default_rng(0), wp.get_device("cuda:0")
        coordinates = rng.random((COUNT, 3)).astype(np.float32)
        self.points, self.rows = upload(coordinates, vec3, device), upload(rng.permutation(COUNT), int32, device)
        self.times, self.heights = (
            upload(rng.random(COUNT), float64, device),
            upload(coordinates[:, 2], float32, device),
        )
        self.pixels = upload(rng.integers(0, 60_000, COUNT), uint16, device)
        self.triangles = upload(rng.integers(0, COUNT, (COUNT, 3)), vec3i, device)
        self.directions = upload(rng.normal(size=(5, 3)), vec3, device)

    def find_lowest(self) -> None:
        runs, lowest = Runs(COUNT, self.points.device, 1024), full(1, NO_KEY, int64, self.points.device)
        launch(find_lowest_kernel, runs.threads, [self.points, self.rows, runs, lowest])


CASES = {  # kernel -> operation, numbers of a row
    "bound_points_kernel": (lambda d: bound_points(d.points), 7),
    "bound_times_kernel": (lambda d: bound_times(d.points, d.times), 2),
    "bound_triangles_kernel": (lambda d: TriangleTree(d.points, d.triangles), 7),
    "count_below_kernel": (lambda d: summarize_distances(d.times, [0.1, 0.5, 0.9]), 4),
    "find_extremes_kernel": (lambda d: find_extremes(d.points, d.directions), 5),
    "find_first_kernel": (lambda d: cluster_points(PointTree(d.points), COUNT, 0.1, 10), 1),
    "find_lowest_bit_kernel": (lambda d: lowest_bit(d.points), 1),
    "find_lowest_kernel": (lambda d: d.find_lowest(), 1),
    "limit_depth_kernel": (lambda d: metric_depth(d.heights, 1.0, 10.0), 1),
    "scale_depth_kernel": (lambda d: metric_depth(d.pixels, 1000.0, 100.0), 1),
    "start_offsets_kernel": (lambda d: exclusive_scan(d.rows), 1),
    "sum_words_kernel": (lambda d: fingerprint(d.points), 1),
}


@pytest.fixture(scope="module")
def data(emulated) -> Data:
    return Data()


@pytest.mark.parametrize("kernel", CASES)
def test_a_warp_needs_one_atomic_per_number(emulated, data, kernel):
    run, numbers = CASES[kernel]
    counts = emulated.findings
    names = {kernel, kernel.replace("_kernel", "_of_lanes_kernel")}  # the CUDA variant

    def measure() -> np.ndarray:
        emulated.streams.flush_all()
        launched = sum(counts.launches[name][1] for name in names & counts.launches.keys())
        return np.array([launched, sum(counts.atomics[name] for name in names)])

    before = measure()
    run(data)
    threads, atomics = measure() - before
    assert 0 < atomics <= numbers * threads / WARP
