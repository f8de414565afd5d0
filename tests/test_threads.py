"""Stateful objects may be used by several threads: calls of one object run one at a time."""

import asyncio
import copy
import itertools
import re
import threading
from concurrent.futures import ThreadPoolExecutor
from enum import Enum
from pathlib import Path
from types import SimpleNamespace
from typing import Any, ClassVar

import numpy as np
import pytest

import pointloom as loom
import pointloom.open3d as o3d
from pointloom.core.serialized import CallLock, Serialized, locked_objects
from pointloom.datasets.scenes.room import room_sequence
from pointloom.io.frames.datasets import Frame

from .core.test_messages import public_classes
from .programs import ROOT

CAMERA = loom.PinholeCameraIntrinsic(40, 30, 32.0, 32.0, 19.5, 14.5)
DEPTH = np.full((30, 40), 1000, np.uint16)
BALL = np.random.default_rng(0).normal(size=(300, 3))
BALL /= np.linalg.norm(BALL, axis=1)[:, None]
ROOM = room_sequence(300, width=80, height=60)
WALK = [ROOM.read(k) for k in range(5)]
STEPS, READERS = 6, 3


def along(step, spacing=2.5):
    return np.array([spacing * step, 0.0, 0.0])


def moved(step):
    T = np.eye(4)
    T[:3, 3] = -along(step)
    return T


def volume_of(device, _=None):
    return loom.TSDFVolume(voxel_size=0.05, color=False, device=device)


def surface(volume):
    mesh = volume.extract_triangle_mesh(0.0)
    return mesh.vertices, mesh.triangles, volume.frame_count


def paged_volume_of(device, folder):
    return loom.PagedTSDFVolume(folder, voxel_size=0.05, color=False, max_blocks=200, device=device)


def room_steps(slam, step):
    slam.step(loom.RGBDImage(WALK[step % 5].color, WALK[step % 5].depth))


def scan_steps(odometry, step):
    odometry.register(loom.PointCloud(BALL * [8, 6, 2] - along(step, 0.1), device=odometry.device))


def add_triangle(scene, step):
    scene.add_triangles(np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]]) + along(step), [[0, 1, 2]])


def record(recorder, step):
    recorder.write(Frame(DEPTH, None, np.eye(4), f"f{step}"))


def recorded(recorder):
    return recorder.count, *sorted(path.name for path in Path(recorder.folder).iterdir())


def cast(scene):
    rays = [[*(along(step) + 0.2), 0, 0, -1] for step in range(STEPS)]
    return scene.cast_rays(rays)["t_hit"], scene.compute_distance(BALL)


def integrate_blocks(grid, step):
    depth, camera = o3d.t.geometry.Image(o3d.core.Tensor(DEPTH)), o3d.core.Tensor(CAMERA.matrix)
    grid.integrate(None, depth, camera, o3d.core.Tensor(moved(step)), depth_max=3.0)


def blocks_of(device, _):
    kinds = (o3d.core.float32, o3d.core.float32)
    where = o3d.core.Device("CUDA:0" if "cuda" in device else "CPU:0")
    return o3d.t.geometry.VoxelBlockGrid(("tsdf", "weight"), kinds, ((1,), (1,)), 0.05, device=where)


def positions(grid):
    return grid.get_curr_positions() if len(grid) else np.zeros(0), len(grid)


CASES = {
    "TSDFVolume.integrate": (volume_of, lambda volume, step: volume.integrate(DEPTH, CAMERA, moved(step)), surface),
    "TSDFVolume.integrate_frames": (
        volume_of,
        lambda volume, step: volume.integrate_frames([DEPTH] * 2, CAMERA, [moved(step)] * 2),
        surface,
    ),
    "TSDFVolume.integrate_points": (
        volume_of,
        lambda volume, step: volume.integrate_points(BALL + along(step), along(step)),
        surface,
    ),
    "TSDFVolume, fused and copied": (
        volume_of,
        lambda volume, step: volume.integrate(DEPTH, CAMERA, moved(step)),
        lambda volume: surface(loom.meshing.fuse_volumes([copy.copy(volume), volume], [np.eye(4)] * 2)),
    ),
    "PagedTSDFVolume": (
        lambda device, folder: loom.PagedTSDFVolume(
            folder, voxel_size=0.05, color=False, max_blocks=200, device=device
        ),
        lambda volume, step: volume.integrate(DEPTH, CAMERA, moved(step)),
        surface,
    ),
    "OccupancyGrid": (
        lambda device, _: loom.OccupancyGrid(0.2, device=device),
        lambda grid, step: grid.insert_scan(BALL + along(step), along(step)),
        lambda grid: (grid.to_point_cloud().points, grid.scan_count),
    ),
    "OccupancyGrid, distances": (
        lambda device, _: loom.OccupancyGrid(0.2, device=device),
        lambda grid, step: grid.insert_scan(BALL + along(step), along(step)),
        lambda grid: (loom.DistanceField.from_occupancy_grid(grid, max_distance=1).distances(BALL),),
    ),
    "RaycastingScene": (lambda device, _: loom.RaycastingScene(device), add_triangle, cast),
    "LidarOdometry": (
        lambda device, _: loom.registration.LidarOdometry(voxel_size=0.5, device=device),
        scan_steps,
        lambda odometry: (np.array(odometry.poses), odometry.map.points),
    ),
    "LidarSLAM": (
        lambda device, _: loom.registration.LidarSLAM(voxel_size=0.5, submap_length=1.0, device=device),
        scan_steps,
        lambda slam: (slam.poses, slam.map.points),
    ),
    "DenseSLAM": (
        lambda device, _: loom.rgbd.DenseSLAM(ROOM.intrinsic, voxel_size=0.05, device=device),
        room_steps,
        lambda slam: (slam.extract_triangle_mesh().vertices, slam.status_counts),
    ),
    "SubmapRecorder": (
        lambda device, _: loom.rgbd.SubmapRecorder(CAMERA, voxel_size=0.05, frames=3, color=False, device=device),
        lambda recorder, step: recorder.add(DEPTH, np.eye(4)),
        lambda recorder: [each.volume.extract_triangle_mesh(0.0).vertices for each in list(recorder.submaps)],
    ),
    "ControlGrid": (
        lambda device, _: loom.rgbd.ControlGrid(1.0, device=device),
        lambda grid, step: grid.touch(loom.PointCloud(BALL + along(step), device=grid.device)),
        positions,
    ),
    "FrameRecorder": (lambda _, folder: loom.FrameRecorder(folder, CAMERA, depth_scale=1000.0), record, recorded),
    "open3d VoxelBlockGrid": (
        blocks_of,
        integrate_blocks,
        lambda grid: (grid.extract_triangle_mesh(0.0).vertex.positions.numpy(),),
    ),
}


@pytest.mark.parametrize("case", CASES)
def test_readers_change_nothing_that_another_thread_writes(case, device, tmp_path):
    make, write, read = CASES[case]
    alone, shared = (make(device, tmp_path / name) for name in ("alone", "shared"))
    for step in range(STEPS):
        write(alone, step)
    is_over, started = threading.Event(), threading.Barrier(READERS + 1)

    def watch():
        started.wait()
        while not is_over.is_set():
            try:
                read(shared)
            except (ValueError, loom.PointloomError):  # an empty volume
                is_over.wait(0.001)

    with ThreadPoolExecutor(READERS) as pool:
        reads = [pool.submit(watch) for _ in range(READERS)]
        try:
            started.wait()
            for step in range(STEPS):
                write(shared, step)
        finally:
            is_over.set()
    for each in reads:
        each.result()
    for actual, expected in zip(read(shared), read(alone), strict=True):
        np.testing.assert_array_equal(actual, expected)


def test_eight_writers_lose_no_frame(device):
    volume = volume_of(device)
    with ThreadPoolExecutor(8) as pool:
        [*pool.map(lambda step: volume.integrate(DEPTH, CAMERA, moved(step % 4)), range(32))]
    assert volume.frame_count == 32
    assert len(volume.extract_triangle_mesh(7.0)) == len(volume.extract_triangle_mesh(0.0)) > 0


ROW = re.compile(r"^\| (.+) \| (free|locked|one thread) \|", re.MULTILINE)


def test_the_thread_safety_of_each_public_class_is_documented():
    table = {
        name: safety
        for names, safety in ROW.findall((ROOT / "docs/robustness.md").read_text())
        for name in re.findall(r"`(\w+)`", names)
    }
    classes = {kind.__name__: kind for kind in public_classes(loom) if not issubclass(kind, Exception)}
    assert sorted(table) == sorted(classes)
    locked = {name for name, kind in classes.items() if issubclass(kind, Serialized)}
    assert {name for name, safety in table.items() if safety == "locked"} == locked | {"LatestFrames", "Viewer"}
    assert {name for name, safety in table.items() if safety == "one thread"} & {
        name for name, kind in classes.items() if issubclass(kind, tuple | Enum)
    } == set()


def test_callbacks_of_the_viewer_read_beside_a_writer(device):
    volume, alone, counts = volume_of(device), volume_of(device), []
    with loom.Viewer(port=0) as viewer:

        def look(step):
            counts.append((volume.frame_count, len(volume.extract_point_cloud(0.0))))
            viewer.add(volume.extract_point_cloud(0.0), name="surface")

        for step in range(STEPS):
            viewer.hooks.calls.call(None, lambda step=step: look(step))
            volume.integrate(DEPTH, CAMERA, moved(step))
            alone.integrate(DEPTH, CAMERA, moved(step))
        is_done = threading.Event()
        viewer.hooks.calls.call(None, is_done.set)
        assert is_done.wait(60)
    assert len(counts) == STEPS and [count for count, _ in counts] == sorted(count for count, _ in counts)
    for actual, expected in zip(surface(volume), surface(alone), strict=True):
        np.testing.assert_array_equal(actual, expected)


def test_functions_run_in_threads_of_an_event_loop(device):
    cloud = loom.PointCloud(BALL, device=device)

    async def both():
        return await asyncio.gather(*[asyncio.to_thread(cloud.voxel_down_sample, 0.3) for _ in range(4)])

    expected = cloud.voxel_down_sample(0.3).points
    for each in asyncio.run(both()):
        np.testing.assert_array_equal(each.points, expected)


def ring_of_threads(objects, enter):
    """Each thread is inside a callback of an object, then uses the next object: the errors, and who ended."""
    met, errors = threading.Barrier(len(objects)), []

    def run(k):
        is_first = iter([True])

        def callback(*_):
            if next(is_first, False):
                met.wait()
                _ = objects[(k + 1) % len(objects)].status_counts

        try:
            enter(objects[k], callback)
        except RuntimeError as error:
            errors.append(str(error))

    threads = [threading.Thread(target=run, args=(k,)) for k in range(len(objects))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    return errors


class Job(Serialized):
    status_counts = property(lambda self: 0)

    def run(self, callback):
        callback()


@pytest.mark.parametrize("count", [2, 3])
@pytest.mark.parametrize("case", ["jobs", "DenseSLAM"])
def test_callbacks_that_use_each_others_objects_raise_in_one_thread(case, count, device):
    if case == "jobs":
        objects, enter = [Job() for _ in range(count)], Job.run
    else:
        make = loom.rgbd.DenseSLAM
        objects = [make(ROOM.intrinsic, voxel_size=0.1, device=device) for _ in range(count)]
        enter = lambda slam, callback: slam.run(WALK[:2], progress=callback)  # noqa: E731
    (error,) = ring_of_threads(objects, enter)
    assert error.startswith(f"this {type(objects[0]).__name__} is in use by another thread, which waits for the call")
    with ThreadPoolExecutor(1) as pool:  # no lock is left behind
        [*pool.map(lambda each: each.status_counts, objects)]


def test_a_ring_of_other_threads_does_not_hold_a_third_one(monkeypatch):
    """What is noted about threads may be old after Ctrl-C."""
    first, second = CallLock(), CallLock()
    first.thread, second.thread = -1, -2
    monkeypatch.setattr(CallLock, "waiting", {-1: second, -2: first})
    assert first.announce(None) == threading.get_ident()


def is_free(item):
    """True if another thread could begin a call of an object now."""

    def try_lock():
        found = item._lock.acquire(blocking=False)
        if found:
            item._lock.release()
        return found

    with ThreadPoolExecutor(1) as pool:
        return pool.submit(try_lock).result()


class Watched(np.ndarray):
    """A view that notes whether its owner is free while it is copied."""

    notes: ClassVar[list[bool]] = []
    owner: ClassVar[Any] = None

    def copy(self, order="C"):
        Watched.notes.append(is_free(Watched.owner))
        return np.array(self)


class Plain(Serialized):
    def __init__(self):
        self.values = np.arange(5)[1:].view(Watched)


class WithState(Plain):
    def __getstate__(self):
        return {"values": self.values}


class Reduced(Plain):
    def __reduce__(self):
        return Reduced, (), {"values": self.values}


@pytest.mark.parametrize("kind", [Plain, WithState, Reduced])
def test_no_other_call_begins_while_the_state_of_a_pickle_is_copied(kind, monkeypatch):
    item = kind()
    monkeypatch.setattr(Watched, "owner", item)
    monkeypatch.setattr(Watched, "notes", [])
    state = item.__reduce__()[2] if kind is Reduced else item.__getstate__()
    assert state["values"].tolist() == [1, 2, 3, 4] and state["values"].flags.owndata
    assert Watched.notes == [False] and is_free(item)


def test_several_objects_are_locked_together_and_in_one_order():
    items, order = [Plain() for _ in range(3)], []
    with locked_objects(items):
        assert [is_free(item) for item in items] == [False] * 3
    assert all(map(is_free, items))

    class Lock:
        def __enter__(self):
            order.append(self)

        def __exit__(self, *_): ...

    owners = [SimpleNamespace(_lock=Lock()) for _ in range(3)]
    for given in itertools.permutations(owners):
        with locked_objects(given):
            pass
    assert order == 6 * order[:3] and {*order} == {owner._lock for owner in owners}


def test_a_second_thread_that_only_waits_gets_its_result():
    jobs, inside, go = [Job(), Job()], threading.Event(), threading.Event()

    def callback():
        inside.set()
        go.wait()
        return jobs[1].status_counts

    with ThreadPoolExecutor(2) as pool:
        first = pool.submit(jobs[0].run, callback)
        inside.wait()
        second = pool.submit(lambda: jobs[0].status_counts)
        go.set()
        assert first.result() is None and second.result() == 0
