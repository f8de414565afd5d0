"""The synthetic city of the benchmarks: deterministic scans, rigid true poses, points on the surfaces."""

from __future__ import annotations

import importlib
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

from .programs import benchmarks_on_path


@pytest.fixture(scope="module")
def city() -> Iterator[Any]:
    with benchmarks_on_path():
        yield importlib.import_module("city")


@pytest.fixture(scope="module")
def scenario(city):
    """Short and with few blocks in range."""
    city.SENSORS["short"] = city.spinning(8, 90, -20, 5, max_range=12.0, noise=0.0)
    yield city.Scenario("alike", "short", seed=3, length=1.1, gaps=1, gap_scans=2)
    del city.SENSORS["short"]


@pytest.fixture(scope="module")
def drive(city, scenario):
    return city.make_drive(scenario)


def test_scans_follow_from_the_seed(city, scenario, drive, tmp_path):
    city.load_drive(scenario, tmp_path)
    again = city.load_drive(scenario, tmp_path)
    assert len(again.scans) == len(drive.scans) > 15
    for name in ("scans", "times"):
        for one, other in zip(getattr(drive, name), getattr(again, name), strict=True):
            assert np.array_equal(one, other)
    assert np.array_equal(drive.poses, again.poses)


def test_missing_scans_leave_a_gap(scenario, drive):
    steps = np.diff(drive.numbers)
    assert sorted(set(steps.tolist())) == [1, 3] and (steps == 3).sum() == 1
    assert all(
        k * 0.1 <= t.min() and t.max() <= (k + 1) * 0.1 + 1e-9 for k, t in zip(drive.numbers, drive.times, strict=True)
    )


@pytest.mark.parametrize("route", ["loop", "return", "alike", "tunnel", "deck", "open", "long"])
def test_true_poses_are_rigid_and_smooth(city, route):
    motion = city.Scenario(route).motion
    times = np.arange(0, motion.end, 0.1)
    poses = motion.poses(times)
    R = poses[:, :3, :3]
    assert np.abs(np.swapaxes(R, 1, 2) @ R - np.eye(3)).max() < 1e-12 and np.linalg.det(R).min() > 0
    speed = np.linalg.norm(motion.coordinates(times, 1)[:, :3], axis=1)
    change = np.linalg.norm(motion.coordinates(times, 2)[:, :3], axis=1)
    assert speed[0] < 0.01 and speed.max() < city.MAX_SPEED + 0.5 and change.max() < 6


def test_points_are_on_the_surfaces_at_the_true_poses(city, scenario, drive):
    scene = scenario.scene
    for points, times in zip(drive.scans, drive.times, strict=True):
        T = scenario.motion.poses(times)
        world = np.einsum("nij,nj->ni", T[:, :3, :3], points) + T[:, :3, 3]
        assert len(points) > 200 and scene.compute_distance(world.astype(np.float32)).max() < 2e-3


def test_a_vehicle_hides_what_is_behind_it(city):
    vehicle = city.Vehicle((4.0, 2.0, 1.5), lambda t: (np.column_stack([10 + t, 0 * t, 0 * t]), 0 * t))
    rays = np.array([[1.0, 0, 0], [0, 1, 0], [1, 0, 0]])
    hit, distances = vehicle.cut(np.tile([0, 0, 1.0], (3, 1)), rays, np.array([0.0, 0.0, 0.5]), 50.0)
    assert hit.tolist() == [0, 2] and np.allclose(distances, [8.0, 8.5])


def test_time_and_memory_are_read_at_each_kilometer():
    with benchmarks_on_path():
        drives = importlib.import_module("lidar_drives")
    scans = [(np.zeros((1, 3), np.float32), np.zeros(1))] * 6
    watched = drives.WatchedScans(scans, np.array([0, 400, 999.0, 1000, 1800, 2100]))
    counts = [len(watched.readings) for _ in watched]
    assert counts == [0, 0, 0, 1, 1, 2] and all(size > 0 for _, size in watched.readings)
    assert len(watched) == 6 and watched.readings[0][0] <= watched.readings[1][0]
