"""Operations in forked and spawned processes, and objects that are sent between them (docs/threads.md)."""

from __future__ import annotations

import multiprocessing
import pickle
import subprocess
import sys

import numpy as np
import pytest

import pointloom as loom

PROGRAM = """
import multiprocessing, os, threading, time, warnings
from concurrent.futures import ProcessPoolExecutor
import numpy as np
import pointloom as loom

POINTS = np.random.default_rng(0).random((20_000, 3))

def work(_=0):
    return float(np.sum(loom.PointCloud(POINTS).compute_nearest_neighbor_distance()))

def fork_and_work(expected):
    child = os.fork()
    if child == 0:
        os._exit(0 if work() == expected else 1)
    return os.waitpid(child, 0)[1] == 0

if __name__ == "__main__":
    warnings.simplefilter("ignore", DeprecationWarning)  # of forks beside threads
    expected = work()
    for method in {methods}:
        with ProcessPoolExecutor(2, mp_context=multiprocessing.get_context(method)) as pool:
            assert list(pool.map(work, range(3))) == [expected] * 3, method
    if "fork" in {methods}:
        is_over = threading.Event()
        def loop():
            while not is_over.is_set():
                work()
        thread = threading.Thread(target=loop)
        thread.start()
        try:
            assert all(fork_and_work(expected) for _ in range(5))
        finally:
            is_over.set()
            thread.join()
    print("done")
"""


@pytest.mark.slow
def test_forked_and_spawned_processes_compute_the_same(tmp_path):
    """Also forks beside a thread that computes."""
    program = tmp_path / "program.py"
    program.write_text(PROGRAM.replace("{methods}", repr(multiprocessing.get_all_start_methods())))
    run = subprocess.run([sys.executable, program], capture_output=True, text=True, timeout=300, check=False)
    assert (run.stdout, run.returncode) == ("done\n", 0), run.stderr


def objects() -> dict[str, object]:
    rng = np.random.default_rng(0)
    cloud = loom.PointCloud(rng.random((100, 3)), colors=rng.random((100, 3)), intensity=np.arange(100))
    volume = loom.TSDFVolume(voxel_size=0.1)
    volume.integrate(
        np.ones((24, 32), np.float32), loom.PinholeCameraIntrinsic(32, 24, 30.0, 30.0, 16.0, 12.0), np.eye(4)
    )
    return {
        "cloud": cloud,
        "mesh": loom.TriangleMesh.create_sphere(),
        "volume": volume,
        "result": loom.registration.registration_icp(cloud, cloud.translate([0.01, 0, 0]), 0.1),
        "search": loom.NearestNeighborSearch(cloud),
        "box": cloud.get_axis_aligned_bounding_box(),
        "trajectory": loom.Trajectory(np.stack([np.eye(4)] * 2)),
        "model": loom.SfmModel(["a"], [loom.CameraModel("PINHOLE", 64, 48, [5, 5, 32, 24])], np.eye(4)[None]),
        "voxels": loom.TriangleMesh.create_sphere().voxelize(0.2),
    }


NAMES = ("box", "cloud", "mesh", "model", "result", "search", "trajectory", "volume", "voxels")


@pytest.mark.parametrize("name", NAMES)
def test_an_object_can_be_sent_to_another_process(name):
    item = objects()[name]
    received = pickle.loads(pickle.dumps(item))
    assert repr(received) == repr(item)
    if isinstance(item, loom.PointCloud | loom.TriangleMesh):
        first, second = (x.points if isinstance(x, loom.PointCloud) else x.vertices for x in (item, received))
        np.testing.assert_array_equal(first, second)
    if isinstance(item, loom.TSDFVolume):
        np.testing.assert_array_equal(
            received.extract_triangle_mesh(0).vertices, item.extract_triangle_mesh(0).vertices
        )


@pytest.mark.parametrize("make", [loom.registration.LidarOdometry, loom.registration.LidarSLAM])
def test_an_odometry_cannot_be_sent(make):
    with pytest.raises(TypeError, match="cannot be copied or pickled"):
        pickle.dumps(make())
