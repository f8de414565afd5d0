"""Poses and IMU readings of ROS messages as arrays."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.trajectory import Trajectory
from ...core.errors import FileError
from ...core.quaternions import quaternions_to_rotations

IMU = "sensor_msgs/msg/Imu"
#: Message types with a pose, and the path to it.
POSES = {
    "nav_msgs/msg/Odometry": ("pose", "pose"),
    "geometry_msgs/msg/PoseStamped": ("pose",),
    "geometry_msgs/msg/PoseWithCovarianceStamped": ("pose", "pose"),
    "geometry_msgs/msg/TransformStamped": ("transform",),
}
_MAX_NORM_ERROR = 1e-3  # maximum deviation of a quaternion's length from 1


@dataclass(frozen=True, eq=False)
class ImuReadings:
    """IMU measurements in the sensor frame.

    Attributes:
        times: Header times [s], float64 (n,).
        angular_velocity: [rad/s], float64 (n, 3).
        linear_acceleration: [m/s^2], float64 (n, 3). Points up at rest.
        orientation: Quaternions (w, x, y, z) of the sensor's filter, float64 (n, 4). NaN if missing.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.io.bags.recording import Recording
        >>> def up_of(recording: Recording):
        ...     return recording.imu().linear_acceleration[:100].mean(axis=0)  # as `registration.leveled` takes it
    """

    times: NDArray[np.float64]
    angular_velocity: NDArray[np.float64]
    linear_acceleration: NDArray[np.float64]
    orientation: NDArray[np.float64]

    def __len__(self) -> int:
        return len(self.times)


def imu_of_messages(messages: Iterable[Any]) -> ImuReadings:
    """The readings of Imu messages. Values with a covariance of -1 (missing, REP 145) are NaN."""
    rows = []
    for message in messages:
        rates, pushes, q = message.angular_velocity, message.linear_acceleration, message.orientation
        parts = [
            (rates.x, rates.y, rates.z, message.angular_velocity_covariance),
            (pushes.x, pushes.y, pushes.z, message.linear_acceleration_covariance),
            (q.w, q.x, q.y, q.z, message.orientation_covariance),
        ]
        row = [stamp_of_header(message.header)]
        for *values, covariance in parts:
            row += [np.nan] * len(values) if covariance[0] == -1 else values
        rows.append(row)
    table = np.array(rows, np.float64).reshape(-1, 11)
    return ImuReadings(table[:, 0].copy(), table[:, 1:4].copy(), table[:, 4:7].copy(), table[:, 7:].copy())


def trajectory_of_messages(path: Path, topic: str, kind: str, messages: Iterable[Any]) -> Trajectory:
    """The poses of messages. Raises `FileError` with the message number if one is invalid."""
    rows: list[list[float]] = []
    for number, message in enumerate(messages):
        pose = message
        for part in POSES[kind]:
            pose = getattr(pose, part)
        position, q = (
            (pose.translation, pose.rotation) if hasattr(pose, "rotation") else (pose.position, pose.orientation)
        )
        row = [stamp_of_header(message.header), position.x, position.y, position.z, q.x, q.y, q.z, q.w]
        length = np.linalg.norm(row[4:])
        if not np.isfinite(row).all() or abs(length - 1) > _MAX_NORM_ERROR:
            reason = (
                f"{topic}: message {number} contains no pose: {row[1:4]}, rotation {row[4:]} of length {length:.3g}"
            )
            raise FileError(path, reason)
        rows.append(row)
    table = np.array(rows, np.float64).reshape(-1, 8)
    poses = np.tile(np.eye(4), (len(table), 1, 1))
    poses[:, :3, :3], poses[:, :3, 3] = quaternions_to_rotations(table[:, 4:]), table[:, 1:4]
    return Trajectory(poses, timestamps=table[:, 0].copy())


def stamp_of_header(header: Any) -> float:
    return float(header.stamp.sec) + float(header.stamp.nanosec) * 1e-9
