"""Observers receive events without an effect on results, and a clock measures and reports its stages."""

import ctypes
import subprocess
import sys
import threading
import time
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import pointloom as loom
from pointloom.core import timing
from pointloom.core.observers import report, standing_for, unwatched, watch, watched
from pointloom.core.timing import Clock, peak_bytes, peak_bytes_of_all

SHIFT = np.array([0.03, -0.02, 0.01])
Events = list[tuple[str, dict[str, Any]]]


def noted(events: Events) -> Any:
    return lambda event, data: events.append((event, data))


def bumps(count: int = 1000) -> np.ndarray:
    x, y = np.random.default_rng(0).uniform(-1, 1, (2, count))
    return np.column_stack([x, y, 0.2 * np.sin(3 * x) * np.cos(4 * y)])


def test_events_are_delivered_outermost_first():
    events: Events = []
    report("before")
    with watch(noted(events)):
        with watch(lambda event, data: events.append(("inner", data))):
            assert watched()
            report("inside", number=1)
        report("one")
    report("after")
    assert events == [("inside", {"number": 1}), ("inner", {"number": 1}), ("one", {})] and not watched()
    with pytest.raises(TypeError, match="callback"), watch(3):  # pyright: ignore[reportArgumentType]
        pass


def test_calls_of_observers_are_not_reported():
    events: Events = []

    def watcher(event: str, data: dict[str, Any]) -> None:
        events.append((event, data))
        report("echo")

    with watch(watcher):
        report("call")
        report("call")
    assert [event for event, _ in events] == ["call", "call"]


def test_an_error_of_a_watcher_ends_the_block_and_is_not_heard_again():
    with pytest.raises(KeyError, match="mine"), watch(lambda event, data: {}["mine"]):
        report("bad")
    report("fine now")
    assert not watched()


def test_threads_do_not_hear_each_other():
    events: Events = []
    with watch(noted(events)):
        other = threading.Thread(target=lambda: report("elsewhere"))
        other.start()
        other.join()
    assert events == []


def test_substitute_clouds_are_reported_as_those_they_replace():
    events: Events = []
    with watch(noted(events)):
        with standing_for(source="whole"), standing_for(source="half", scale=2):
            report("step", source="thin", pose=1)
        with unwatched():
            report("silent")
        report("step", source="thin")
    assert events == [("step", {"source": "whole", "pose": 1, "scale": 2}), ("step", {"source": "thin"})]


def test_icp_reports_its_start_and_every_iteration_as_its_callback(device):
    target, source = (loom.PointCloud(points, device=device) for points in (bumps(), bumps() + SHIFT))
    events: Events = []
    states: list[dict[str, Any]] = []
    with watch(noted(events)):
        result = loom.registration.registration_icp(source, target, 0.2, callback_after_iteration=states.append)
    steps = [data for event, data in events if event == "icp"]
    assert [data["iteration_index"] for data in steps] == list(range(result.iterations + 1))
    assert np.array_equal(steps[0]["transformation"], np.eye(4))
    for step, state in zip(steps[1:], states, strict=True):
        assert np.array_equal(step["transformation"], state["transformation"])
        assert step["fitness"] == state["fitness"] and step["source"] is source and step["target"] is target
    assert events[-1][0] == "registration" and events[-1][1]["result"] is result


def test_multi_scale_icp_reports_the_clouds_that_it_was_given(device):
    target, source = (loom.PointCloud(points, device=device) for points in (bumps(), bumps() + SHIFT))
    rules = [loom.registration.ICPConvergenceCriteria(max_iteration=5)] * 2
    events: Events = []
    with watch(noted(events)):
        loom.registration.multi_scale_icp(source, target, [0.1, -1], rules, [0.3, 0.1])
    assert all(data["source"] is source and data["target"] is target for _, data in events)
    assert sorted({data["scale_index"] for _, data in events}) == [0, 1]


def test_icp_fusion_clusters_and_planes_are_bitwise_identical_with_observers(device):
    camera = loom.PinholeCameraIntrinsic(32, 24, 30.0, 30.0, 15.5, 11.5)
    depth = (1.0 + 0.1 * np.sin(np.mgrid[:24, :32].sum(axis=0) / 4)).astype(np.float32)
    cloud = loom.PointCloud(np.vstack([bumps(), bumps() + 100 * SHIFT]), device=device)
    target, source = (loom.PointCloud(points, device=device) for points in (bumps(), bumps() + SHIFT))

    def work() -> list[np.ndarray]:
        volume = loom.TSDFVolume(voxel_size=0.05, device=device)
        for _ in range(2):
            volume.integrate(depth, camera, np.eye(4))
        mesh = volume.extract_triangle_mesh(0)
        results = [mesh.vertices, mesh.triangles, cloud.cluster_dbscan(0.2, 5), *cloud.segment_plane(0.05)]
        icp = loom.registration.registration_icp(source, target, 0.2)
        statistics = np.array([icp.fitness, icp.inlier_rmse, icp.iterations])
        return [*results, icp.transformation, icp.correspondence_set, statistics]

    events: Events = []
    alone = work()
    with watch(noted(events)):
        observed = work()
    names = list(dict.fromkeys(event for event, _ in events))
    assert names == ["integrate", "clusters", "plane", "icp", "registration"]
    for left, right in zip(alone, observed, strict=True):
        assert np.array_equal(left, right)


def test_an_error_of_a_watcher_ends_icp_and_leaves_the_clouds_to_others(device):
    cloud = loom.PointCloud(bumps(), device=device)

    def refuse(event: str, data: dict[str, Any]) -> None:
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"), watch(refuse):
        loom.registration.registration_icp(cloud, cloud, 0.2)
    assert loom.registration.registration_icp(cloud, cloud, 0.2).fitness == 1.0


@pytest.fixture
def now(monkeypatch):
    hands = [10.0]
    monkeypatch.setattr(timing.time, "perf_counter", lambda: hands[0])
    return hands


def test_a_repeated_stage_adds_to_its_seconds(now):
    clock = Clock()
    for stage, seconds in (("read", 2.0), ("fuse", 1.0), ("read", 0.5)):
        now[0] += seconds
        clock.stop(stage)
    assert clock.seconds == {"read": 2.5, "fuse": 1.0} and list(clock.cpu_seconds) == ["read", "fuse"]


def test_time_between_stages_is_not_counted(now):
    clock = Clock()
    now[0] += 5.0
    with clock.stage("read"):
        now[0] += 1.0
    now[0] += 5.0
    clock.restart()
    now[0] += 0.25
    clock.stop("write")
    assert clock.seconds == {"read": 1.0, "write": 0.25}


def test_stages_are_reported_when_they_begin(now):
    steps = []
    clock = Clock(lambda *step: steps.append(step))
    with clock.stage("read"):
        assert steps == [("read", 0, 0)]
    clock.stop("write")
    assert steps == [("read", 0, 0)]


def test_a_stage_that_fails_is_not_counted(now):
    clock = Clock()
    with pytest.raises(KeyError), clock.stage("read"):
        raise KeyError
    assert clock.seconds == {}


@pytest.mark.slow
def test_seconds_of_the_cpu_are_those_of_processes_too():
    clock, start = Clock(), time.process_time()
    subprocess.run([sys.executable, "-c", "sum(range(3_000_000))"], check=True)
    clock.stop("count")
    assert clock.cpu_seconds["count"] > time.process_time() - start


@pytest.mark.parametrize(("system", "unit"), [("linux", 1024), ("darwin", 1)])
def test_peak_memory_is_counted_in_bytes_from_the_unit_of_the_system(system, unit, monkeypatch):
    assert 1 << 20 < peak_bytes() <= peak_bytes_of_all() < 1 << 45
    peaks = {"of this process": 7, "of children": 9}
    usage = SimpleNamespace(RUSAGE_SELF="of this process", RUSAGE_CHILDREN="of children")
    usage.getrusage = lambda who: SimpleNamespace(ru_maxrss=peaks[who])
    monkeypatch.setitem(sys.modules, "resource", usage)
    monkeypatch.setattr(sys, "platform", system)
    monkeypatch.setattr(timing, "peak_of_process", lambda: 0)
    assert (peak_bytes(), peak_bytes_of_all()) == (7 * unit, 9 * unit)


def test_peak_memory_is_not_that_of_the_program_that_started_the_process():
    ballast = np.ones(2**26)
    code = "from pointloom.core.timing import peak_bytes; print(peak_bytes())"
    started = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert int(started.stdout) < ballast.nbytes < peak_bytes()


def test_windows_reports_peak_memory(monkeypatch):
    """PROCESS_MEMORY_COUNTERS has 72 bytes: its size and a count of 4 bytes each, then the peak."""

    def fill(process, counters, size):
        assert (process.value, size) == (2**64 - 1, 72)
        ctypes.memmove(ctypes.byref(counters._obj, 8), (123 << 20).to_bytes(8, "little"), 8)

    libraries = {"kernel32": SimpleNamespace(K32GetProcessMemoryInfo=fill)}
    monkeypatch.setattr(ctypes, "WinDLL", libraries.__getitem__, raising=False)
    monkeypatch.setitem(sys.modules, "resource", None)
    monkeypatch.setattr(sys, "platform", "win32")
    assert peak_bytes() == peak_bytes_of_all() == 123 << 20
