"""Submaps: frames are split into parts, each in the frame of its first camera."""

import numpy as np
import pytest

from pointloom.registration.rigid import pose_of
from pointloom.rgbd.slam.submaps import SubmapRecorder, tracked_run

from .loop_scenes import CAMERA, hall_depth, hall_run, record


def along_x(count, step=0.01):
    return [pose_of(np.array([0, 0, 0, step * i, 0, 0])) for i in range(count)]


def test_each_submap_shares_its_last_frames_with_the_next():
    submaps = record(along_x(25), frames=10, shared=0.2).finish()
    assert [(s.frames[0], s.frames[-1]) for s in submaps] == [(0, 9), (8, 17), (16, 24)]
    assert [s.follows for s in submaps] == [False, True, True]
    assert sum(s.volume.frame_count for s in submaps) == 29


def test_a_submap_without_its_own_frames_is_omitted():
    assert [s.frames[-1] for s in record(along_x(10), frames=10, shared=0.2).finish()] == [9]


def test_a_fast_camera_fills_submaps_sooner():
    submaps = record(along_x(20, step=0.1), frames=100, way=0.5, shared=0.2).finish()
    assert len(submaps) >= 4
    assert all(np.ptp(s.T_world_camera[:, 0, 3]) <= 0.61 for s in submaps)
    turning = [pose_of(np.array([0, 0.1 * i, 0, 0, 0, 0])) for i in range(20)]
    assert len(record(turning, frames=100, way=0.5).finish()) >= 4


def test_a_submap_after_a_loss_follows_none():
    submaps = record([*along_x(5), None, None, *along_x(5)], frames=100).finish()
    assert [s.frames.tolist() for s in submaps] == [[0, 1, 2, 3, 4], [7, 8, 9, 10, 11]]
    assert [s.follows for s in submaps] == [False, False]


def test_a_submap_is_in_the_frame_of_its_first_camera():
    """Also far from the world's origin, where local coordinates stay small."""
    far = pose_of(np.array([0, 0, 1.0, 500_000.0, 5_400_000.0, 300.0]))
    submap = record([far @ pose for pose in along_x(3)]).finish()[0]
    assert np.abs(submap.T_world_submap - far).max() < 1e-9 and (submap.volume.origin == 0).all()
    assert np.abs(submap.T_submap_camera - along_x(3)).max() < 1e-8
    assert np.abs(submap.cloud(0.05).points[:, 2] - 1.5).max() < 1e-4


def test_tracked_poses_are_those_given_to_the_recorder():
    poses = along_x(25)
    submaps = record(poses, frames=10).finish()
    numbers, tracked = tracked_run(submaps)
    assert (numbers == np.arange(25)).all() and np.abs(tracked - poses).max() < 1e-12


def test_a_cloud_of_a_submap_is_on_its_surface(device):
    submap = hall_run(device, 4, (0.0, 1.2))
    cloud = submap.cloud(0.1)
    points = cloud.points @ submap.T_world_submap[:3, :3].T + submap.T_world_submap[:3, 3]
    distances = np.abs(np.abs(points) - [2.0, 2.0, 1.2]).min(axis=1)
    assert len(cloud) > 300 and np.median(distances) < 0.01
    assert cloud.has_normals()


def test_the_submap_in_progress_can_be_extracted():
    recorder = SubmapRecorder(CAMERA, voxel_size=0.1, color=False)
    assert recorder.current is None
    recorder.add(hall_depth(np.eye(4)), np.eye(4))
    assert recorder.current.frames.tolist() == [0]


def test_bad_frames_and_sizes_are_refused():
    recorder = record(along_x(3))
    with pytest.raises(ValueError, match="number:"):
        recorder.add(np.ones((48, 64)), np.eye(4), number=2)
    with pytest.raises(ValueError, match="T_world_camera"):
        recorder.add(np.ones((48, 64)), 2 * np.eye(4))
    for options, message in (
        ({"shared": 0.6}, "shared"),
        ({"frames": 0}, "frames"),
        ({"way": 0.0}, "way"),
        ({"voxel_size": -1.0}, "voxel_size"),
    ):
        with pytest.raises(ValueError, match=message):
            SubmapRecorder(CAMERA, **{"voxel_size": 0.1} | options)
