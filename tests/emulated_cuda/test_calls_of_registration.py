"""Waits and graphs of scans of a LiDAR and of frames of depth cameras."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.kernels.rgbd.alignment import MAX_CACHED, _descents, clear_descents

DEVICE = "cuda:0"
COUNT = 20000  # points of a room: each voxel has a plane


def room_seen_from(x: float, count: int) -> np.ndarray:
    """Points of the walls of a room relative to a position in it, the same ones for each position."""
    rng, rows = np.random.default_rng(0), np.arange(count)
    room = rng.uniform(-8, 8, (count, 3)) * [1, 1, 0.3]
    room[rows, rows % 3] = np.where(rng.random(count) < 0.5, -1, 1) * 8.0
    return room - [x, 0, 0]


@pytest.mark.parametrize("is_straightened", [False, True])
def test_scans_of_more_points_wait_as_often_and_share_a_graph(emulated, is_straightened):
    waits = []
    for count in (COUNT, 3 * COUNT // 2):
        odometry = loom.registration.LidarOdometry(max_range=30, min_range=0.5, device=DEVICE)
        times = np.arange(count) / count if is_straightened else None
        for x in (0.0, 0.1, 0.2, 0.3, 0.4):
            scan = loom.PointCloud(room_seen_from(x, count), device=DEVICE)
            counts = emulated.count_requests(lambda: odometry.register(scan, times))  # noqa: B023  runs at once
        assert odometry.steps[-1].is_sound
        assert counts["graphs made"] == 0
        waits.append(counts["waits"])
    assert waits[1] == waits[0]


def frame_of_a_relief(k: float):
    """A frame of a relief with stripes, a little farther on for another k."""
    v, u = np.mgrid[:72, :96]
    depth = 1.5 + 0.2 * np.sin((u + k) / 13) * np.cos(v / 11) + 0.1 * np.sin((v - k) / 7)
    shade = 127 + 60 * np.sin((u + k) / 3 + v / 9) + 50 * np.cos(v / 4 - (u + k) / 17)
    camera = loom.PinholeCameraIntrinsic(96, 72, 90.0, 90.0, 47.5, 35.5)
    return loom.rgbd.OdometryFrame(depth.astype(np.float32), camera, shade.astype(np.uint8), device=DEVICE)


def test_frames_of_the_same_size_share_a_graph_and_wait_once(emulated):
    clear_descents()
    first, second, third = (frame_of_a_relief(k) for k in range(3))
    align = loom.rgbd.align_frames
    counts = emulated.count_requests(lambda: align(first, second))
    assert (counts["graphs made"], counts["waits"]) == (1, 1)
    results = []
    counts = emulated.count_requests(lambda: results.append(align(second, third)))
    assert (counts["graphs made"], counts["graphs"], counts["waits"]) == (0, 1, 1)
    clear_descents()
    fresh = align(second, third)  # cached data of other frames are not used
    np.testing.assert_array_equal(results[0].transformation, fresh.transformation)
    np.testing.assert_array_equal(results[0].information, fresh.information)
    for k in range(2 * MAX_CACHED):
        camera = loom.PinholeCameraIntrinsic(64 + 8 * k, 48, 60.0, 60.0, 31.5, 23.5)
        frame = loom.rgbd.OdometryFrame(np.ones((48, 64 + 8 * k), np.float32), camera, device=DEVICE)
        align(frame, frame)
    assert _descents.size == MAX_CACHED
