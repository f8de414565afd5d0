"""Observers receive the events of algorithms, and results do not depend on observers."""

import threading
from typing import Any

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.observers import report, standing_for, unwatched, watch, watched

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
    assert events == [("inside", {"number": 1}), ("inner", {"number": 1}), ("one", {})]
    assert not watched()
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
        assert step["fitness"] == state["fitness"]
        assert step["source"] is source and step["target"] is target
    assert events[-1][0] == "registration" and events[-1][1]["result"] is result


def test_icp_is_bitwise_identical_with_observers(device):
    target, source = (loom.PointCloud(points, device=device) for points in (bumps(), bumps() + SHIFT))
    register = loom.registration.registration_icp
    alone = register(source, target, 0.2)
    with watch(lambda event, data: None):
        observed = register(source, target, 0.2)
    assert np.array_equal(alone.transformation, observed.transformation)
    for name in ("fitness", "inlier_rmse", "iterations"):
        assert getattr(alone, name) == getattr(observed, name)
    assert np.array_equal(alone.correspondence_set, observed.correspondence_set)


def test_multi_scale_icp_reports_the_clouds_that_it_was_given(device):
    target, source = (loom.PointCloud(points, device=device) for points in (bumps(), bumps() + SHIFT))
    rules = [loom.registration.ICPConvergenceCriteria(max_iteration=5)] * 2
    events: Events = []
    with watch(noted(events)):
        loom.registration.multi_scale_icp(source, target, [0.1, -1], rules, [0.3, 0.1])
    assert all(data["source"] is source and data["target"] is target for _, data in events)
    assert sorted({data["scale_index"] for _, data in events}) == [0, 1]


def test_fusion_clusters_and_planes_are_bitwise_identical_with_observers(device):
    camera = loom.PinholeCameraIntrinsic(32, 24, 30.0, 30.0, 15.5, 11.5)
    depth = (1.0 + 0.1 * np.sin(np.mgrid[:24, :32].sum(axis=0) / 4)).astype(np.float32)
    cloud = loom.PointCloud(np.vstack([bumps(), bumps() + 100 * SHIFT]), device=device)

    def work() -> list[np.ndarray]:
        volume = loom.TSDFVolume(voxel_size=0.05, device=device)
        for _ in range(2):
            volume.integrate(depth, camera, np.eye(4))
        mesh = volume.extract_triangle_mesh(0)
        return [mesh.vertices, mesh.triangles, cloud.cluster_dbscan(0.2, 5), *cloud.segment_plane(0.05)]

    events: Events = []
    alone = work()
    with watch(noted(events)):
        observed = work()
    assert [event for event, _ in events] == ["integrate", "integrate", "clusters", "plane"]
    for left, right in zip(alone, observed, strict=True):
        assert np.array_equal(left, right)


def test_an_error_of_a_watcher_ends_icp_and_leaves_the_clouds_to_others(device):
    cloud = loom.PointCloud(bumps(), device=device)

    def refuse(event: str, data: dict[str, Any]) -> None:
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"), watch(refuse):
        loom.registration.registration_icp(cloud, cloud, 0.2)
    assert loom.registration.registration_icp(cloud, cloud, 0.2).fitness == 1.0
