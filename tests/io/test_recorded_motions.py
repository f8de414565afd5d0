"""IMU readings and poses from recordings written by rosbags."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import pointloom as loom
from pointloom.core.errors import FileError

pytest.importorskip("rosbags")

from .test_recorded_frames import Writer


def vector(store, values, kind="Vector3"):
    return store.types[f"geometry_msgs/msg/{kind}"](*map(float, values))


def quaternion(store, q):
    return store.types["geometry_msgs/msg/Quaternion"](*map(float, q))


@pytest.mark.parametrize("form", ["bag1", "mcap"])
def test_readings_are_arrays_with_nan_for_missing_values(tmp_path, form):
    with Writer(tmp_path, form) as out:
        for i in range(20):
            none = np.array([-1.0, *[0.0] * 8]) if i < 5 else np.zeros(9)
            parts = [quaternion(out.store, [0, 0, 0.6, 0.8]), none]
            parts += [vector(out.store, [0.1, i, 0.3]), np.zeros(9), vector(out.store, [0, 0, 9.81]), np.zeros(9)]
            out.send("/imu", "sensor_msgs/msg/Imu", 1 + 0.01 * i, *parts)
    imu = loom.open_recording(out.path).imu()
    assert len(imu) == 20
    np.testing.assert_allclose(imu.times, 1 + 0.01 * np.arange(20), atol=1e-9)
    np.testing.assert_array_equal(imu.angular_velocity[:, 1], np.arange(20))
    np.testing.assert_array_equal(imu.linear_acceleration, np.tile([0, 0, 9.81], (20, 1)))
    assert np.isnan(imu.orientation[:5]).all() and imu.orientation[5:].tolist() == [[0.8, 0, 0, 0.6]] * 15


@pytest.mark.parametrize("kind", ["geometry_msgs/msg/PoseStamped", "nav_msgs/msg/Odometry"])
def test_poses_are_a_trajectory(tmp_path, kind):
    rotations = Rotation.from_rotvec(np.outer(np.linspace(0, 2, 6), [0.1, 0.2, 1.0]))
    with Writer(tmp_path) as out:
        types = out.store.types
        for i, q in enumerate(rotations.as_quat()):
            position = vector(out.store, [500_000 + i, 2 * i, 3], "Point")
            pose = types["geometry_msgs/msg/Pose"](position, quaternion(out.store, q))
            if kind.endswith("Odometry"):
                spread = types["geometry_msgs/msg/PoseWithCovariance"](pose, np.zeros(36))
                still = types["geometry_msgs/msg/Twist"](vector(out.store, [0] * 3), vector(out.store, [0] * 3))
                speed = types["geometry_msgs/msg/TwistWithCovariance"](still, np.zeros(36))
                out.send("/pose", kind, 1.0 + i, "base", spread, speed)
            else:
                out.send("/pose", kind, 1.0 + i, pose)
    path = loom.open_recording(out.path).trajectory()
    np.testing.assert_allclose(path.poses[:, :3, :3], rotations.as_matrix(), atol=1e-12)
    np.testing.assert_array_equal(path.poses[:, 0, 3], 500_000 + np.arange(6))
    np.testing.assert_array_equal(path.timestamps, 1.0 + np.arange(6))


def test_invalid_poses_and_topics_of_other_types_are_named(tmp_path):
    with Writer(tmp_path) as out:
        place, rotation = vector(out.store, [0] * 3, "Point"), quaternion(out.store, [0] * 4)
        pose = out.store.types["geometry_msgs/msg/Pose"](place, rotation)
        out.send("/pose", "geometry_msgs/msg/PoseStamped", 1.0, pose)
    recording = loom.open_recording(out.path)
    with pytest.raises(FileError, match=r"/run:.*0"):
        recording.trajectory()
    with pytest.raises(FileError, match=r"/run:.*sensor_msgs/msg/Imu"):
        recording.imu()
    with pytest.raises(FileError, match="/run:"):
        recording.trajectory("/x")
