"""LiDAR odometry over many scans, one by one or as a trajectory."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...cameras.imu_readings import ImuReadings
from ...cameras.trajectory import Trajectory
from ...core.checks import check_callback, check_finite, check_numeric, check_shape
from ...core.devices import DeviceLike
from ...core.time_checks import check_seconds
from ...io.points.scan_files import Scans, read_scans
from .lidar_odometry import LidarOdometry
from .lidar_steps import OdometryStep


def iterate_odometry(
    scans: Scans,
    *,
    imu: ImuReadings | None = None,
    timestamps: NDArray[np.float64] | None = None,
    device: DeviceLike = None,
    columns: Sequence[str] | None = None,
    **options: Any,
) -> Iterator[OdometryStep]:
    """Register scans one by one, and yield each step. Arguments and errors as of `run_odometry`."""
    odometry = LidarOdometry(device=device, **options)
    for number, scan in enumerate(read_scans(scans, device=device, columns=columns)):
        if timestamps is not None and number >= len(timestamps):
            raise ValueError(f"timestamps: expected one for each scan, got {len(timestamps)} for more scans")
        odometry.register(scan, imu=imu, time=None if timestamps is None else timestamps[number])
        yield odometry.steps[-1]


def run_odometry(
    scans: Scans,
    *,
    timestamps: ArrayLike | None = None,
    imu: ImuReadings | None = None,
    progress: Callable[[OdometryStep], None] | None = None,
    device: DeviceLike = None,
    columns: Sequence[str] | None = None,
    **options: Any,
) -> Trajectory:
    """Estimate the trajectory of a scanner: T_world_sensor of each scan, the first at the identity.

    Args:
        scans: A folder in natural order (scan2 before scan10); or files (KITTI's .bin, .ply, .pcd, .las, ...); or
            clouds.
        timestamps: Time of each scan [s], for gaps between scans and for the trajectory. With `imu`: of its end.
        imu: Readings of an IMU, as of `LidarOdometry.register`. Its clock is that of `timestamps`, or without them
            that of the point times.
        progress: Called with the OdometryStep of each scan.
        device: Device of files and map; None: the CPU, or that of the first cloud.
        columns: Column names of .bin, .csv, .txt and .xyz files, as of `read_point_cloud`.
        **options: As of LidarOdometry.

    Returns:
        A Trajectory; `write_trajectory` writes it as KITTI or TUM.

    Raises:
        FileError, ValueError: No scans, one that cannot be read, or a wrong number of timestamps.

    Example:
        >>> import pointloom as loom
        >>> wall = loom.PointCloud([[10, 0.5 * i, 0.5 * j] for i in range(-20, 20) for j in range(20)])
        >>> loom.registration.run_odometry([wall, wall], timestamps=[0.0, 0.1]).poses.shape
        (2, 4, 4)
    """
    times = None if timestamps is None else check_finite("timestamps", check_numeric("timestamps", timestamps))
    if times is not None:
        check_seconds("timestamps", times)
        if times.ndim != 1:
            raise ValueError(f"timestamps: expected shape [n], one for each scan, got {list(times.shape)}")
    poses, report_step = [], check_callback("progress", progress)
    steps = iterate_odometry(scans, imu=imu, timestamps=times, device=device, columns=columns, **options)
    for step in steps:
        poses.append(step.pose)
        if report_step is not None:
            report_step(step)
    times = None if times is None else check_shape("timestamps", times, (len(poses),))
    return Trajectory(np.array(poses).reshape(-1, 4, 4), times)
