"""Operations in forked and spawned processes, and objects that are sent between them (docs/threads.md)."""

from __future__ import annotations

import copy
import multiprocessing
import os
import pickle
import subprocess
import sys
import threading
import warnings
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest

import pointloom as loom
from pointloom.cameras.panoramas import Panorama
from pointloom.cameras.undistortion import Undistortion
from pointloom.core import serialized
from pointloom.core.serialized import Serialized

from .small_scenes import digest

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


class TwoCounts(Serialized):
    """Counts that are equal between calls."""

    def __init__(self) -> None:
        self.first, self.second = 0, 0
        self.is_inside, self.may_leave = threading.Event(), threading.Event()

    def change(self) -> None:
        self.first += 1
        self.is_inside.set()
        self.may_leave.wait()
        self.second += 1

    def counts(self) -> tuple[int, int]:
        return self.first, self.second


def answer_of_child(ask: Callable[[], object]) -> str:
    """What a call returns in a forked process, or its error."""
    reading, writing = os.pipe()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)  # of forks beside threads
        child = os.fork()
    if child == 0:
        try:
            text = str(ask())
        except BaseException as error:
            text = f"{type(error).__name__}: {error}"
        os.write(writing, text.encode())
        os._exit(0)
    os.close(writing)
    with os.fdopen(reading, "rb") as file:
        text = file.read().decode()
    os.waitpid(child, 0)
    return text


@pytest.fixture
def changing() -> Iterator[TwoCounts]:
    """An object that another thread is changing."""
    counts = TwoCounts()
    thread = threading.Thread(target=counts.change)
    thread.start()
    counts.is_inside.wait()
    yield counts
    counts.may_leave.set()
    thread.join()


needs_fork = pytest.mark.skipif(not hasattr(os, "fork"), reason="the system cannot fork")


@needs_fork
def test_a_fork_waits_for_a_running_call(changing, monkeypatch):
    monkeypatch.setattr(serialized, "FORK_SECONDS", 60.0)
    threading.Timer(0.05, changing.may_leave.set).start()
    assert answer_of_child(changing.counts) == "(1, 1)"
    assert changing.counts() == (1, 1)


@needs_fork
def test_a_child_refuses_an_object_that_was_changing_for_long(changing, monkeypatch):
    monkeypatch.setattr(serialized, "FORK_SECONDS", 0.01)
    other = TwoCounts()
    assert answer_of_child(changing.counts).startswith("RuntimeError: this TwoCounts was in use by another thread")
    assert answer_of_child(other.counts) == "(0, 0)"
    answer = answer_of_child(lambda: answer_of_child(changing.counts))  # a child of the child
    assert answer.startswith("RuntimeError: this TwoCounts")
    changing.may_leave.set()
    changing.is_inside.clear()
    changing.change()
    assert changing.counts() == (2, 2)


@needs_fork
def test_a_call_may_fork_and_its_child_may_use_the_object():
    counts = TwoCounts()
    with counts._lock:
        assert answer_of_child(counts.counts) == "(0, 0)"
    assert counts.counts() == (0, 0)


def test_a_pickle_has_the_state_of_the_call_that_made_it():
    """pickle reads the arrays of the state when the lock is released, so they are copies."""
    camera, depth = loom.PinholeCameraIntrinsic(32, 24, 30.0, 30.0, 16.0, 12.0), np.ones((24, 32), np.float32)
    volume, grid = loom.TSDFVolume(voxel_size=0.1), loom.OccupancyGrid(0.1)
    volume.integrate(depth, camera, np.eye(4))
    grid.insert_scan(np.eye(3), [0.5, 0.5, 0.5])
    for one, change in (
        (volume, lambda: volume.integrate(2 * depth, camera, np.eye(4))),
        (grid, lambda: grid.insert_scan(np.eye(3) / 2, [0.5, 0.5, 0.5])),
    ):
        before = digest(one.downloaded())
        constructor, arguments, state, *_ = one.__reduce_ex__(4)
        change()
        made = constructor(*arguments)
        made.__setstate__(state)
        assert digest(made.downloaded()) == before != digest(one.downloaded())


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


def behaving() -> dict[str, tuple[object, Callable[[Any], object]]]:
    """Objects with device arrays, and what they compute."""
    rng, lens = np.random.default_rng(0), loom.CameraModel("SIMPLE_RADIAL", 64, 48, [50, 32, 24, -0.1])
    body = loom.PointCloud(rng.random((300, 3)) * [1, 1, 0.2]).estimate_normals(max_nn=10)
    moved, image = body.translate([0.01, 0, 0]), rng.integers(0, 256, (48, 64, 3)).astype(np.uint8)
    camera, depth = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5), 1500 + 9 * image[:, :, 0].astype(int)
    planes = loom.registration.TransformationEstimationPointToPlane()
    frame = loom.rgbd.OdometryFrame(depth.astype(np.uint16), camera, image)
    return {
        "deformation": (loom.registration.register_nonrigid(body, moved).deformation, lambda x: x.transform(body)),
        "undistortion": (Undistortion(lens), lambda x: x.apply(image)),
        "panorama": (Panorama(64, 32), lambda x: x.apply(image[:32])),
        "frame": (frame, lambda x: [x.coarsest(), loom.rgbd.align_frames(x, frame).transformation]),
        "result": (
            loom.registration.registration_icp(body, moved, 0.1, None, planes),
            lambda x: [x.transformation, x.correspondence_set, x.covariance.matrix],
        ),
    }


@pytest.mark.parametrize("copied", [lambda x: pickle.loads(pickle.dumps(x)), copy.deepcopy], ids=["pickle", "deepcopy"])
@pytest.mark.parametrize("name", ["deformation", "undistortion", "panorama", "frame", "result"])
def test_a_sent_object_computes_the_same(name, copied):
    one, compute = behaving()[name]
    assert digest(compute(copied(one))) == digest(compute(one))


CAMERA = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
SESSIONS = {
    "LidarOdometry": loom.registration.LidarOdometry,
    "LidarSLAM": loom.registration.LidarSLAM,
    "DenseSLAM": lambda: loom.rgbd.DenseSLAM(CAMERA, voxel_size=0.05),
    "SlamModel": lambda: loom.rgbd.DenseSLAM(CAMERA, voxel_size=0.05).model,
}


@pytest.mark.parametrize("name", SESSIONS)
def test_a_session_cannot_be_sent(name):
    for copied in (pickle.dumps, copy.copy, copy.deepcopy):
        with pytest.raises(TypeError, match=f"{name} cannot be copied or pickled"):
            copied(SESSIONS[name]())
