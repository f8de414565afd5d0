"""Numbers of device calls and waits of registration and of frames of depth cameras.

The numbers are those of test_callback_queue.py: launches cost a program some 20 microseconds of Python and waits 10.
"""

import numpy as np
import pytest

import pointloom as loom
from pointloom.kernels.rgbd.alignment import MAX_CACHED, _descents, clear_descents

from ..host_work import room_seen_from

DEVICE = "cuda:0"
COUNT = 20000  # points of a room: each voxel has a plane


@pytest.mark.parametrize("is_straightened", [False, True])
def test_a_scan_waits_for_its_sizes_and_for_its_pose(emulated, is_straightened):
    odometry = loom.registration.LidarOdometry(max_range=30, min_range=0.5, device=DEVICE)
    times = np.arange(COUNT) / COUNT if is_straightened else None
    counts = {}
    for k, x in enumerate((0.0, 0.1, 0.2, 0.4, 0.6)):  # the fourth deviates from the prediction
        scan = loom.PointCloud(room_seen_from(x, COUNT), device=DEVICE)
        counts = emulated.count_requests(lambda: odometry.register(scan, times))  # noqa: B023  runs at once
        if k == 3:
            fourth = counts
    assert odometry.steps[-1].is_sound
    # one of the waits is for a number that was sent with the scan before: it is there
    assert (counts["waits"], counts["graphs made"], counts["graphs"]) == (4, 0, 1)
    assert (fourth["waits"], fourth["graphs made"]) == ((7, 0) if is_straightened else (4, 0))


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
