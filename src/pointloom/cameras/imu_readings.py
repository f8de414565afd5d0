"""Readings of an inertial measurement unit: `ImuReadings`."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from ..core.attribute_hints import HintedNames
from ..core.checks import LARGEST_NUMBER, check_numeric, check_rigid, check_shape
from ..core.time_checks import check_seconds, check_unit_of_seconds

STANDARD_GRAVITY = 9.80665  # [m/s^2]


@dataclass(frozen=True, eq=False)
class ImuReadings(HintedNames):
    """Readings of a gyroscope and an accelerometer, in the frame of the IMU.

    Args:
        times: Times [s], float64 (n,), not decreasing.
        angular_velocity: [rad/s], float64 (n, 3). NaN if missing.
        linear_acceleration: [m/s^2], float64 (n, 3). Points up at rest. NaN if missing.
        orientation: Quaternions (w, x, y, z) of the sensor's filter, float64 (n, 4), NaN if missing; or None.
        T_sensor_imu: Pose of the IMU in the frame of the scanner or camera, shape (4, 4).

    Raises:
        TypeError: Not numbers.
        ValueError: Shapes that do not match, times that decrease or are not seconds in float64, infinite values, or a
            pose that is not rigid.

    Notes:
        The arrays are read-only.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> times = np.arange(0.0, 1.0, 0.01)
        >>> loom.ImuReadings(times, np.zeros((100, 3)), np.tile([0, 0, 9.81], (100, 1)))
        ImuReadings(100 readings from 0.000 to 0.990 s)
    """

    times: NDArray[np.float64]
    angular_velocity: NDArray[np.float64]
    linear_acceleration: NDArray[np.float64]
    orientation: NDArray[np.float64] | None = None
    T_sensor_imu: NDArray[np.float64] = field(default_factory=lambda: np.eye(4))

    def __post_init__(self):
        times = check_numeric("times", self.times)
        check_seconds("times", times)
        if times.ndim != 1:
            raise ValueError(f"times: expected shape [n], got {list(times.shape)}")
        times = times.astype(np.float64)
        if not np.isfinite(times).all():
            raise ValueError("times: expected finite times, got NaN or infinity")
        check_unit_of_seconds("times", times)
        backward = np.flatnonzero(np.diff(times) < 0)
        if backward.size:
            row = int(backward[0]) + 1
            raise ValueError(
                f"times: expected times that do not decrease, got {times[row]:.6f} s after {times[row - 1]:.6f} s at "
                f"index {row}. Sort the readings by time"
            )
        columns = {"times": times}
        for name, width in (("angular_velocity", 3), ("linear_acceleration", 3), ("orientation", 4)):
            if getattr(self, name) is not None or name != "orientation":
                values = check_shape(name, getattr(self, name), (len(times), width)).copy()
                if (np.abs(values) > LARGEST_NUMBER).any():  # false for NaN, a missing value
                    raise ValueError(f"{name}: expected numbers up to {LARGEST_NUMBER:g}, or NaN if missing")
                columns[name] = values
        columns["T_sensor_imu"] = check_rigid("T_sensor_imu", self.T_sensor_imu).copy()
        for name, values in columns.items():
            values.flags.writeable = False
            object.__setattr__(self, name, values)

    def __len__(self) -> int:
        return len(self.times)

    def __repr__(self) -> str:
        span = f" from {self.times[0]:.3f} to {self.times[-1]:.3f} s" if len(self) else ""
        return f"ImuReadings({len(self):,} readings{span})"
