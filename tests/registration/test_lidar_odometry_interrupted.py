"""A scan is added to an odometry run completely or not at all after any interruption."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.registration import LidarOdometry

from ..interruptions import run_lines

FILES = (
    "registration/lidar/lidar_odometry.py", "registration/lidar/scan_matching.py", "kernels/odometry/voxel_map.py",
    "kernels/arrays/hash_table.py", "kernels/arrays/atomic_changes.py",
)  # fmt: skip
SHIFTS = (0.0, 0.4, 0.8, 9.0, 9.4)  # voxels are dropped on the way; the fourth scan is far from its predicted pose


def scans(device):
    """A room moving past the scanner, with times; so the second scan deskews the first."""
    rng = np.random.default_rng(0)
    room = rng.uniform(-8, 8, (800, 3)) * [1, 1, 0.3]
    room[np.arange(800), np.arange(800) % 3] = np.where(rng.random(800) < 0.5, -1, 1) * 8.0
    times = np.arange(800) / 800
    return [loom.PointCloud(room - [shift, 0, 0], time=times, device=device) for shift in SHIFTS]


def odometry_over(clouds):
    odometry = LidarOdometry(max_range=14, min_range=0.5, voxel_size=0.5)
    for cloud in clouds:
        odometry.register(cloud)
    return odometry


def state_of(odometry):
    """The complete state that later scans depend on, and the reported results."""
    points = odometry.map.points
    threshold = odometry.threshold
    return odometry.poses.tobytes(), threshold.sqsum, threshold.count, points[np.lexsort(points.T)].tobytes()


@pytest.mark.slow
def test_a_scan_is_registered_completely_or_not_at_all_after_any_interruption(device):
    clouds = scans(device)
    straight = [state_of(odometry_over(clouds[:n])) for n in range(len(clouds) + 1)]
    outcomes = set()
    for n, cloud in list(enumerate(clouds))[1::2]:  # the second restarts the map, the fourth drops voxels
        odometry = odometry_over(clouds[:n])
        total = run_lines(lambda: odometry.register(cloud), FILES)  # noqa: B023  runs at once
        for stop in [total // 3, total // 2, *range(total - 48, total + 1, 6)]:
            odometry = odometry_over(clouds[:n])
            run_lines(lambda: odometry.register(cloud), FILES, stop)  # noqa: B023
            outcomes.add(len(odometry.steps) - n)
            assert state_of(odometry) == straight[len(odometry.steps)], (n, stop)
            for next_cloud in clouds[len(odometry.steps) : n + 1]:
                odometry.register(next_cloud)
            assert state_of(odometry) == straight[len(odometry.steps)], (n, stop)
    assert outcomes == {0, 1}
