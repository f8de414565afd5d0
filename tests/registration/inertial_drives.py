"""A handheld scanner with an IMU in a room: rotating scans with motion distortion, and the readings."""

from types import SimpleNamespace

import numpy as np
from scipy.spatial.transform import Rotation

from pointloom import ImuReadings, PointCloud

GRAVITY = np.array([0.0, 0.0, 9.81])  # measured at rest
PERIOD = 0.1  # [s] of a scan
ROOM = np.array([[-7.0, -5.0, -1.4], [6.0, 4.0, 2.3]])
BOXES = np.array([
    [[-6.9, -4.8, -1.4], [-4.5, -3.0, 0.6]], [[2.5, 2.0, -1.4], [4.0, 3.9, 1.2]], [[4.5, -4.0, -1.4], [5.9, -1.5, 0.2]],
    [[-3.0, 2.5, -1.4], [-2.2, 3.2, 2.3]], [[0.5, -4.9, -1.4], [1.5, -4.2, 1.6]],
])  # fmt: skip


def growing(t):
    """From 0 to 1 within the first second, with continuous accelerations."""
    s = np.clip(t, 0, 1)[:, None]
    return s**3 * (10 - 15 * s + 6 * s**2)


def shake(degrees_per_second, hertz=1.6):
    """Yaw, pitch and roll [rad] of a shake with this largest rate."""
    size = np.radians(degrees_per_second) / (2 * np.pi * hertz)

    def angles(t):
        w = 2 * np.pi * hertz * t
        return size * growing(t) * np.stack([np.sin(w), 0.4 * np.sin(0.7 * w + 1), 0.3 * np.sin(1.3 * w)], 1)

    return angles


def still(t):
    return np.zeros((len(t), 3))


def stroll(t):
    """Positions [m] of a walk that starts at rest, with steps."""
    return np.stack([0.8 * np.sin(0.9 * t), 0.5 * np.sin(0.7 * t), 0.02 * np.sin(9 * t)], 1) * growing(t)


def cast(origins, directions):
    with np.errstate(divide="ignore", invalid="ignore"):
        inverse = 1 / directions
        a, b = ((corner - origins) * inverse for corner in ROOM)
        t = np.maximum(a, b).min(axis=1)
        for low, high in BOXES:
            a, b = (low - origins) * inverse, (high - origins) * inverse
            enter, leave = np.minimum(a, b).max(axis=1), np.maximum(a, b).min(axis=1)
            t = np.where((enter < leave) & (enter > 0) & (enter < t), enter, t)
    return t


def surface_distances(points):
    """Distances [m] of points from the surfaces of the room and its boxes."""
    nearest = np.abs(np.minimum(points - ROOM[0], ROOM[1] - points)).min(axis=1)
    for low, high in BOXES:
        outside = np.linalg.norm(np.maximum(np.maximum(low - points, points - high), 0), axis=1)
        inside = np.minimum(points - low, high - points).min(axis=1)
        nearest = np.minimum(nearest, np.where(outside > 0, outside, inside))
    return nearest


class Drive:
    """Scans `k` from 0.1 k to 0.1 (k + 1) [s], readings with noise and a bias [rad/s], and the true poses.

    `tilt` rotates the scanner's start: the world of odometry is then not level. `T_sensor_imu` is the IMU's pose."""

    def __init__(
        self, count, angles=still, positions=still, *, rate=200.0, bias=(0, 0, 0), noise=1.0, tilt=(0, 0, 0),
        T_sensor_imu=None, start=0.0, beams=20, azimuths=300,
    ):  # fmt: skip
        self.angles, self.positions, self.start = angles, positions, start
        self.tilt = Rotation.from_rotvec(np.radians(tilt))
        self.T_sensor_imu = np.eye(4) if T_sensor_imu is None else T_sensor_imu
        rng, rise = np.random.default_rng(0), np.radians(np.linspace(-25, 25, beams))
        self.scans, self.poses = [], []
        for k in range(count):
            fraction = np.repeat(np.arange(1, azimuths + 1) / azimuths, beams)
            azimuth = 2 * np.pi * (fraction - rng.random() / azimuths) - np.pi
            e = np.tile(rise, azimuths)
            rays = np.stack([np.cos(e) * np.cos(azimuth), np.cos(e) * np.sin(azimuth), np.sin(e)], axis=1)
            times = (k + fraction) * PERIOD
            R, p = self.pose(times)
            ranges = cast(p, R.apply(rays)) + rng.normal(0, 0.01 * noise, len(rays))
            self.scans.append(PointCloud((rays * ranges[:, None]).astype(np.float32), time=start + times))
            self.poses.append(self.matrix((k + 1) * PERIOD))
        self.readings = self.measure(np.arange(0, count * PERIOD + 0.02, 1 / rate), bias, noise, rng)

    def pose(self, t):
        return Rotation.from_euler("ZYX", self.angles(t)) * self.tilt, self.positions(t)

    def matrix(self, t):
        R, p = self.pose(np.array([t]))
        T = np.eye(4)
        T[:3, :3], T[:3, 3] = R.as_matrix()[0], p[0]
        return T

    def measure(self, times, bias, noise, rng):
        d, R_imu, lever = 1e-4, Rotation.from_matrix(self.T_sensor_imu[:3, :3]), self.T_sensor_imu[:3, 3]

        def imu(t):
            R, p = self.pose(t)
            return R * R_imu, p + R.apply(lever)

        (before, p0), (now, p1), (after, p2) = (imu(times + shift) for shift in (-d, 0, d))
        rates = (before.inv() * after).as_rotvec() / (2 * d)
        force = now.inv().apply((p2 - 2 * p1 + p0) / d**2 + GRAVITY)
        rates += np.asarray(bias) + rng.normal(0, 0.003 * noise, rates.shape)
        force += rng.normal(0, 0.05 * noise, force.shape)
        return ImuReadings(self.start + times, rates, force, T_sensor_imu=self.T_sensor_imu)

    def errors(self, odometry):
        """Rotation [degrees] and position [m] errors of each pose, relative to the first scan."""
        truth = np.linalg.inv(self.poses[0]) @ np.array(self.poses)
        difference = np.linalg.inv(truth) @ odometry.poses
        angles = np.degrees(Rotation.from_matrix(difference[:, :3, :3]).magnitude())
        return SimpleNamespace(rotation=angles, position=np.linalg.norm(difference[:, :3, 3], axis=1))
