"""Motion between scans from a gyroscope and an accelerometer, and the direction of gravity.

The rotation is the integral of the angular velocity minus the bias. The displacement is that of the velocity between
the last two scans, plus the double integral of the acceleration minus gravity. Over a scan interval of 0.1 s an error
of 0.3 m/s^2 of the acceleration, such as 2 degrees of tilt, moves a prediction by 3 mm. No velocity is integrated over
several scans: after 10 s the same error would be 15 m.

Forster et al., "On-Manifold Preintegration for Real-Time Visual-Inertial Odometry", IEEE Transactions on Robotics
33(1), 2017: the Jacobian of a rotation with respect to the bias. Titterton and Weston, "Strapdown Inertial Navigation
Technology", 2004: the coning correction.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...cameras.imu_readings import ImuReadings
from ...core.time_checks import check_time, check_unit_of_seconds
from ...kernels.linear_algebra import inv, matmul, norm
from ..rigid import invert_pose, make_pose, nearest_rotation, rotation_vector, rotations_of
from .lidar_steps import OdometryStep

Matrix = NDArray[np.float64]

MAX_READING_GAP = 0.05  # [s] between readings. Handheld sensors reverse their rotation within 0.15 s
MAX_CLOCK_DIFFERENCE = 60.0  # [s] between the first scan and the readings; more is another clock
MIN_GRAVITY_TIME = 1.0  # [s] of readings: a velocity error of 0.3 m/s then leaves 0.3 m/s^2, 3 mm in 0.1 s
MAX_SCAN_DURATION = 2.0  # [s] more is another unit: scanners need 0.02 to 0.5 s
BIAS_SIGMA = 0.02  # [rad/s] standard deviation of an unknown bias. Data sheets of MEMS gyroscopes: up to 1 degree/s
BIAS_WALK = 1e-4  # [rad/s per root s] random walk of the bias by temperature
ROTATION_SIGMA = 0.003  # [rad] error of the rotation between two scans
MAX_BIAS_ERROR = 4.0  # standard deviations; larger differences are errors of a pose, of the extrinsic or of the unit
PATH_STEPS = 16  # straight parts of a scan's rotation: a 4 Hz shake of 100 degrees/s then deviates by 0.01 degrees


class Increment(NamedTuple):
    """Integrals of readings from one time to another, `duration` [s] later.

    Attributes:
        rotation: R_start_end.
        bias_jacobian: Rotation vector at the end per bias of the angular velocity, negated [s].
        early, late: Integrals [m/s] of the acceleration with gravity, along the axes of the start, weighted from 0 to 1
            and from 1 to 0. None if the acceleration is missing.
    """

    duration: float
    rotation: Matrix
    bias_jacobian: Matrix
    early: Matrix | None
    late: Matrix | None


@dataclass(frozen=True, eq=False)
class LastScan:
    """The previous scan with a time: the IMU's pose, its mean velocity before it, and the integral `early`.

    `is_measured` is True if scans determine the velocity; `anchor` is the time and position of the last sound scan."""

    index: int
    time: float
    pose: Matrix
    is_sound: bool
    anchor: tuple[float, Matrix] | None
    velocity: Matrix | None = None
    duration: float = 0.0
    early: Matrix | None = None
    is_measured: bool = False


@dataclass(frozen=True, eq=False)
class InertialTracker:
    """What is known of the IMU between scans: bias of the gyroscope [rad/s] and the sum of gravity over time."""

    bias: Matrix = field(default_factory=lambda: np.zeros(3))
    bias_covariance: Matrix = field(default_factory=lambda: np.eye(3) * BIAS_SIGMA**2)
    gravity_sum: Matrix = field(default_factory=lambda: np.zeros(3))
    gravity_time: float = 0.0
    last: LastScan | None = None
    has_common_clock: bool = False

    @property
    def gravity(self) -> Matrix | None:
        """Mean acceleration against gravity in world coordinates [m/s^2], which points up. None before 1 s."""
        return self.gravity_sum / self.gravity_time if self.gravity_time >= MIN_GRAVITY_TIME else None

    def predict(self, readings: ImuReadings, index: int, begin: float | None, end: float | None) -> InertialMotion:
        """Predict the motion to the scan `index`, whose points are measured from `begin` to `end` [s]."""
        if end is None:
            return InertialMotion(self, readings, index, math.nan)
        if not self.has_common_clock:
            _check_clock(readings, end)
        known, last = replace(self, has_common_clock=True), self.last
        increment = motion = None
        if last is not None and last.index == index - 1:
            if end <= last.time:
                raise ValueError(
                    f"time, timestamps: expected a scan that ends after the last one at {last.time:.6f} s, got "
                    f"{end:.6f} s. With imu, point times need the clock of the IMU"
                )
            increment = integrate(readings, last.time, end, self.bias)
            motion = None if increment is None else self._motion(last, increment, readings.T_sensor_imu)
        else:
            known = replace(known, last=None)
        path = part = None
        if begin is not None and begin < end:
            path = rotation_path(readings, begin, end, self.bias)
            part = None if known.last is None else min((end - begin) / (end - known.last.time), 1.0)
        return InertialMotion(known, readings, index, end, increment, motion, path, part)

    def _motion(self, last: LastScan, increment: Increment, T_sensor_imu: Matrix) -> Matrix:
        """T_last_sensor."""
        duration, R = increment.duration, last.pose[:3, :3]
        displacement = np.zeros(3)
        if last.velocity is not None:
            displacement = last.velocity * duration
            gravity = self.gravity
            if gravity is not None and last.early is not None and increment.late is not None:
                change = last.early + matmul(R, increment.late) - gravity * (last.duration + duration) / 2
                displacement = displacement + change * duration
        T_last_imu = make_pose(increment.rotation, matmul(R.T, displacement))
        return matmul(T_sensor_imu, T_last_imu, invert_pose(T_sensor_imu))

    def with_rotation(self, increment: Increment, R_start_end: Matrix) -> InertialTracker:
        """Update the bias by the rotation between two scans, with a Kalman filter."""
        difference = rotation_vector(matmul(increment.rotation.T, R_start_end))
        M = -increment.bias_jacobian
        P = self.bias_covariance + np.eye(3) * BIAS_WALK**2 * increment.duration
        S_inverse = inv(matmul(M, P, M.T) + np.eye(3) * ROTATION_SIGMA**2)
        if float(matmul(difference, S_inverse, difference)) > 3 * MAX_BIAS_ERROR**2:
            return replace(self, bias_covariance=P)
        gain = matmul(P, M.T, S_inverse)
        covariance = P - matmul(gain, M, P)
        bias = self.bias + matmul(gain, difference)
        return replace(self, bias=bias, bias_covariance=(covariance + covariance.T) / 2)


@dataclass(frozen=True, eq=False)
class InertialMotion:
    """The predicted motion to a scan.

    Attributes:
        motion: T_last_sensor, or None if readings are missing.
        path: Rotation vectors of the sensor relative to the end of the scan, from its first to its last point, shape
            (PATH_STEPS + 1, 3). None if readings are missing.
        part: Fraction of the interval since the last scan that the points cover, or None.
    """

    tracker: InertialTracker
    readings: ImuReadings
    index: int
    end: float
    increment: Increment | None = None
    motion: Matrix | None = None
    path: Matrix | None = None
    part: float | None = None

    def difference(self, step: OdometryStep) -> float | None:
        """Angle [rad] between the rotation of the gyroscope and that of the scans. None if one of them is unknown."""
        rotation = self._rotation_of(step)
        if rotation is None or self.increment is None:
            return None
        return float(norm(rotation_vector(matmul(self.increment.rotation.T, rotation))))

    def after(self, step: OdometryStep) -> InertialTracker:
        """The tracker after the scan was registered."""
        if math.isnan(self.end):
            return replace(self.tracker, last=None)
        pose, last = matmul(step.pose, self.readings.T_sensor_imu), self.tracker.last
        anchor = (self.end, pose[:3, 3]) if step.is_sound else None if last is None else last.anchor
        now = LastScan(self.index, self.end, pose, step.is_sound, anchor)
        if last is None:
            return replace(self.tracker, last=now)
        duration, early, is_measured = self.end - last.time, None, last.is_sound and step.is_sound
        velocity = (pose[:3, 3] - last.pose[:3, 3]) / duration
        if step.is_sound and not last.is_sound and last.anchor is not None:
            velocity = (pose[:3, 3] - last.anchor[1]) / (self.end - last.anchor[0])
        elif self.increment is not None and self.increment.early is not None:
            early = matmul(last.pose[:3, :3], self.increment.early)
        is_measured = is_measured and not step.is_undetermined and step.iterations > 0
        now = replace(now, velocity=velocity, duration=duration, early=early, is_measured=is_measured)
        tracker, rotation = replace(self.tracker, last=now), self._rotation_of(step)
        if rotation is not None and self.increment is not None:
            tracker = tracker.with_rotation(self.increment, rotation)
        if is_measured and last.is_measured and last.early is not None and early is not None:
            return self._with_gravity(tracker, last, velocity, duration)
        return tracker

    def _rotation_of(self, step: OdometryStep) -> Matrix | None:
        """R_last_imu by the scans."""
        last = self.tracker.last
        is_known = step.is_sound and step.iterations > 0 and not step.undetermined_turns
        if last is None or not last.is_sound or not is_known:
            return None
        return matmul(last.pose[:3, :3].T, step.pose[:3, :3], self.readings.T_sensor_imu[:3, :3])

    def _with_gravity(
        self, tracker: InertialTracker, last: LastScan, velocity: Matrix, duration: float
    ) -> InertialTracker:
        """Add the acceleration that the change of velocity between two intervals does not explain.

        The changes of velocity cancel in the sum but for the first and the last velocity."""
        assert self.increment is not None and self.increment.late is not None
        assert last.early is not None and last.velocity is not None
        late = matmul(last.pose[:3, :3], self.increment.late)
        unexplained = last.early + late - (velocity - last.velocity)
        between = (last.duration + duration) / 2
        return replace(
            tracker, gravity_sum=tracker.gravity_sum + unexplained, gravity_time=tracker.gravity_time + between
        )


def check_imu(imu: object) -> ImuReadings:
    if not isinstance(imu, ImuReadings):
        raise TypeError(f"imu: expected ImuReadings, got {type(imu).__name__}")
    return imu


def span_of_scan(time: float | None, first: float | None, last: float | None) -> tuple[float | None, float | None]:
    """The times [s] of the first and last point of a scan that ends at `time`, or at its last point time. None if
    unknown: without point times, and for a scan without points."""
    has_span = first is not None and last is not None and first <= last
    duration = last - first if has_span and first is not None and last is not None else None
    if duration is not None and duration > MAX_SCAN_DURATION:
        raise ValueError(f"timestamps: expected point times in seconds with imu, got a scan of {duration:.6g} s")
    if time is not None:
        end = check_time("time", time)
        check_unit_of_seconds("time", np.array([end]))
        return None if duration is None else end - duration, end
    if first is None or last is None:
        raise ValueError("time: the scan has no point times. With imu, pass the time of its end [s]")
    if duration is None:
        return None, None
    check_unit_of_seconds("timestamps", np.array([last]))
    return first, last


def integrate(readings: ImuReadings, start: float, end: float, bias: Matrix) -> Increment | None:
    """Integrate the readings between two times. None if readings are missing for more than 50 ms."""
    times = _knots(readings, start, end)
    if times is None:
        return None
    rotations = _rotations(readings, times, bias)
    steps = np.diff(times)[:, None, None]
    to_end = matmul(rotations[-1].T, rotations)  # R_end_time
    jacobian = ((to_end[1:] + to_end[:-1]) / 2 * steps).sum(axis=0)
    force = _interpolated(readings.times, readings.linear_acceleration, times)
    early = late = None
    if np.isfinite(force).all():
        turned = matmul(rotations, force[:, :, None])[:, :, 0]
        weight = ((times - start) / (end - start))[:, None]
        early, late = (_trapezoids(values, times) for values in (turned * weight, turned * (1 - weight)))
    return Increment(end - start, nearest_rotation(rotations[-1]), jacobian, early, late)


def rotation_path(readings: ImuReadings, begin: float, end: float, bias: Matrix) -> Matrix | None:
    """`InertialMotion.path` of a scan, along the axes of the sensor."""
    wanted = np.linspace(begin, end, PATH_STEPS + 1)
    knots = _knots(readings, begin, end)
    if knots is None:
        return None
    times = np.union1d(knots, wanted)
    rotations = _rotations(readings, times, bias)
    to_end = matmul(rotations[-1].T, rotations[np.searchsorted(times, wanted)])
    vectors = np.array([rotation_vector(R) for R in to_end])
    return matmul(vectors, readings.T_sensor_imu[:3, :3].T)


def _knots(readings: ImuReadings, start: float, end: float) -> Matrix | None:
    """The two times and those of the readings between them. None if readings are missing for more than 50 ms."""
    first, last = np.searchsorted(readings.times, (start, end), side="right")
    near = slice(max(first - 1, 0), last + 1)  # with the readings before and after
    times = readings.times[near]
    if not len(times) or not np.isfinite(readings.angular_velocity[near]).all():
        return None
    gap = max(np.diff(times).max(initial=0.0), times[0] - start, end - times[-1])
    return None if gap > MAX_READING_GAP else np.union1d(readings.times[first:last], (start, end))


def _rotations(readings: ImuReadings, times: Matrix, bias: Matrix) -> Matrix:
    """Rotations from each time to the first."""
    rates = _interpolated(readings.times, readings.angular_velocity, times) - bias
    steps = np.diff(times)[:, None]
    vectors = (rates[1:] + rates[:-1]) / 2 * steps + np.cross(rates[:-1], rates[1:]) * (steps * steps / 12)
    products = np.concatenate([np.eye(3)[None], rotations_of(vectors)])
    distance = 1
    while distance < len(products):  # products of 2, 4, 8, ... steps
        products[distance:] = matmul(products[:-distance], products[distance:])
        distance *= 2
    return products


def _interpolated(times: Matrix, values: Matrix, at: Matrix) -> Matrix:
    """Values (n, 3) at other times, linear between readings and constant beyond them."""
    if not len(times):
        return np.full((len(at), 3), np.nan)
    return np.stack([np.interp(at, times, column) for column in values.T], axis=1)


def _trapezoids(values: Matrix, times: Matrix) -> Matrix:
    return ((values[1:] + values[:-1]) / 2 * np.diff(times)[:, None]).sum(axis=0)


def _check_clock(readings: ImuReadings, end: float) -> None:
    if not len(readings):
        raise ValueError("imu: expected readings, got none")
    first, last = readings.times[[0, -1]]
    if not first - MAX_CLOCK_DIFFERENCE <= end <= last + MAX_CLOCK_DIFFERENCE:
        raise ValueError(
            f"imu: expected readings around the end of the scan at {end:.6f} s, got readings from {first:.6f} to "
            f"{last:.6f} s. Both need the same clock"
        )
