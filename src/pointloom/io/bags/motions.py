"""Poses and IMU readings of ROS messages as arrays."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.imu_readings import STANDARD_GRAVITY, ImuReadings
from ...cameras.trajectory import Trajectory
from ...core.checks import LARGEST_NUMBER
from ...core.errors import FileError
from ...core.quaternions import quaternions_to_rotations
from ...core.units import warn_of_units
from .message_chunks import RecordingWarning

IMU = "sensor_msgs/msg/Imu"
#: Message types with a pose, and the path to it.
POSES = {
    "nav_msgs/msg/Odometry": ("pose", "pose"),
    "geometry_msgs/msg/PoseStamped": ("pose",),
    "geometry_msgs/msg/PoseWithCovarianceStamped": ("pose", "pose"),
    "geometry_msgs/msg/TransformStamped": ("transform",),
}
_MAX_NORM_ERROR = 1e-3  # maximum deviation of a quaternion's length from 1
_G_RANGE = (0.5, 2.0)  # median acceleration of drivers that publish g (Livox). In m/s^2 it is 9.8 at rest


def imu_of_messages(
    path: Path, topic: str, messages: Iterable[Any], T_sensor_imu: NDArray[np.float64] | None = None
) -> ImuReadings:
    """The readings of Imu messages. Values with a covariance of -1 (missing, REP 145) are NaN.

    Raises `FileError` with the message number if a value is not finite or times decrease. Accelerations in g are
    converted, with a warning."""
    rows: list[list[float]] = []
    for number, message in enumerate(messages):
        rates, pushes, q = message.angular_velocity, message.linear_acceleration, message.orientation
        parts = [
            (rates.x, rates.y, rates.z, message.angular_velocity_covariance),
            (pushes.x, pushes.y, pushes.z, message.linear_acceleration_covariance),
            (q.w, q.x, q.y, q.z, message.orientation_covariance),
        ]
        row = [stamp_of_header(message.header)]
        for *values, covariance in parts:
            is_missing = covariance[0] == -1
            if not is_missing and not all(abs(value) <= LARGEST_NUMBER for value in values):  # false for NaN
                raise FileError(path, f"{topic}: message {number} contains values that are not finite: {values}")
            row += [np.nan] * len(values) if is_missing else values
        if rows and row[0] < rows[-1][0]:
            reason = f"{topic}: message {number} has the time {row[0]:.6f} s after {rows[-1][0]:.6f} s"
            raise FileError(path, reason, remedy="Sort the messages by the times in their headers")
        rows.append(row)
    table = np.array(rows, np.float64).reshape(-1, 11)
    accelerations = table[:, 4:7]
    sizes = np.linalg.norm(accelerations[np.isfinite(accelerations).all(axis=1)], axis=1)
    size = float(np.median(sizes)) if len(sizes) else 0.0
    if _G_RANGE[0] < size < _G_RANGE[1]:
        message = f"{topic}: accelerations of {size:.2f} on median are read as g, not as m/s^2"
        warn_of_units(f"{path}: {message}", RecordingWarning)
        accelerations = accelerations * STANDARD_GRAVITY
    pose = np.eye(4) if T_sensor_imu is None else T_sensor_imu
    return ImuReadings(table[:, 0], table[:, 1:4], accelerations, table[:, 7:], pose)


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
