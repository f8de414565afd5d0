"""Motion correction (deskewing) of scans."""

from __future__ import annotations

import math

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_numeric, check_rigid
from ...core.exchange import on_host
from ...core.time_checks import check_span, float32_step, is_single
from ...core.units import warn_of_units
from ...kernels.lang import float64
from ...kernels.linear_algebra import matmul, norm
from ...kernels.memory import cast, download, upload
from ...kernels.odometry.deskewing import bound_times
from ...kernels.odometry.deskewing import deskew_points as move_points
from ...pcd.cloud import PointCloud
from ...pcd.point_arrays import check_cloud
from ..rigid import rotation_vector, skew, to_local

TIME_NAMES = ("time", "timestamp", "timestamps", "t", "time_offset", "offset_time", "gps_time")
MIN_TIMES = 8  # minimum number of distinct times for deskewing
SMALL_ANGLE = 1e-4  # [rad] below it series to fourth order are exact in float64


def deskew_point_cloud(cloud: PointCloud, T_start_end: ArrayLike, timestamps: ArrayLike | None = None) -> PointCloud:
    """Deskew a scan: move every point to where the sensor would have measured it at the end of the scan.

    Assumes constant velocity along a screw between the first and the last time, which is exact for a vehicle in a
    curve.

    Args:
        cloud: Points in the sensor frame, each at its own time.
        T_start_end: Motion during the scan, shape [4, 4]: the last pose in the frame of the first, from odometry or an
            IMU.
        timestamps: Time of each point, shape [n], in any unit and from any origin. None: the cloud's attribute "time",
            "timestamp", "timestamps", "t", "time_offset", "offset_time" or "gps_time".

    Returns:
        The cloud with all attributes, with rotated normals and without covariances. Points with NaN times become NaN,
        their normals too.

    Raises:
        ValueError: No times, a wrong length, no finite time, or a motion that is not rigid. Times that float32 does not
            resolve: since 1970 or of the week, they need float64.

    Notes:
        Uses the time range of points that are finite and not at zero. One launch, 12 B per point, bitwise reproducible.
        Vizzo et al., "KISS-ICP", RA-L 2023, eqs. 2 to 4.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> T = np.eye(4)
        >>> T[0, 3] = 1.0  # the sensor went 1 m along x while it looked at a wall ahead
        >>> scan = loom.PointCloud([[10, 0, 0], [9.5, 1, 0], [9, 2, 0]], time=[0.0, 0.05, 0.1])
        >>> loom.registration.deskew_point_cloud(scan, T).points[:, 0].round(6).tolist()
        [9.0, 9.0, 9.0]
    """
    check_cloud("cloud", cloud)
    T = check_rigid("T_start_end", T_start_end)
    times = point_times(cloud, timestamps)
    if times is None:
        names = ", ".join(TIME_NAMES)
        raise ValueError(f"timestamps: the cloud has no attribute of the names {names}; give timestamps=")
    span = bound_times(cloud.arrays["points"], times)
    first, last = download(span)  # sync
    check_resolution(times, first, last, are_single(cloud, timestamps))
    if first > last and len(cloud) and not np.isfinite(download(times)).any():  # sync, only for errors
        raise ValueError(f"timestamps: expected finite times, got none for {len(cloud):,} points")
    if first == last and len(cloud) > MIN_TIMES:
        warn_of_coarse_times(1, len(cloud))
    twist, normals = twist_of(to_local(T, cloud.origin, cloud.origin)), cloud.arrays.get("normals")
    moved = move_points(cloud.arrays["points"], times, np.zeros(3), span, twist)
    if normals is not None:
        rotation = np.eye(4)
        rotation[:3, :3] = T[:3, :3]
        normals = move_points(normals, times, np.zeros(3), span, twist_of(rotation))
    return cloud.with_points(moved, normals, grid=cloud.grid)


def point_times(cloud: PointCloud, timestamps: ArrayLike | None) -> wp.array | None:
    """The given or the cloud's point times as float64 device array [n]. None if there are none."""
    if timestamps is not None:
        times = check_numeric("timestamps", on_host("timestamps", timestamps))
        if times.shape != (len(cloud),):
            raise ValueError(f"timestamps: expected shape [{len(cloud)}], one for each point, got {list(times.shape)}")
        return upload(times.astype(np.float64), float64, cloud.device)
    for name in TIME_NAMES:
        if name in cloud:
            values = cloud.arrays[name]
            if values.ndim == 1 or values.shape[1:] == (1,):
                return values if values.dtype == float64 and values.ndim == 1 else cast(values.flatten(), float64)
            raise ValueError(
                f"{name}: expected shape [{len(cloud)}], one time for each point, got {list(values.shape)}"
            )
    return None


def are_single(cloud: PointCloud, timestamps: ArrayLike | None) -> bool:
    """True if the point times that `point_times` returns were given with at most 32 bits."""
    if timestamps is not None:
        return is_single(check_numeric("timestamps", on_host("timestamps", timestamps)).dtype)
    name = next((name for name in TIME_NAMES if name in cloud), None)
    return name is not None and is_single(wp.dtype_to_numpy(cloud.arrays[name].dtype))


def check_resolution(times: wp.array, first: float, last: float, are_single: bool) -> None:
    """Raise ValueError if the times of a scan are, or were, float32 numbers too large to resolve it."""
    if not first <= last or times.size <= MIN_TIMES:
        return
    if not are_single:
        is_rounded = float(np.float32(first)) == first < last == float(np.float32(last))
        if not is_rounded or last - first >= MIN_TIMES * float32_step(max(abs(first), abs(last))):
            return
        if len(np.unique(download(times))) >= MIN_TIMES:  # sync, only for suspicious times
            return
    check_span("timestamps", first, last, MIN_TIMES)


def warn_of_coarse_times(distinct: int, count: int) -> None:
    warn_of_units(
        f"timestamps: {count:,} points have {distinct} different times, so the scan is not deskewed. Seconds "
        "since 1970 or of the week need float64. Leave the times out if all points were measured at once.",
        UserWarning,
    )


def twist_of(T: NDArray[np.float64]) -> NDArray[np.float64]:
    """Logarithm (rotation, translation) of a pose, [6]: the inverse of `rigid.pose_of` below half a turn."""
    rotation = rotation_vector(T[:3, :3])
    angle, K = float(norm(rotation)), skew(rotation)
    factor = 1 / 12 + angle**2 / 720 if angle < SMALL_ANGLE else (1 - angle / 2 / math.tan(angle / 2)) / angle**2
    V_inverse = np.eye(3) - K / 2 + factor * matmul(K, K)
    return np.concatenate([rotation, matmul(V_inverse, T[:3, 3])])
