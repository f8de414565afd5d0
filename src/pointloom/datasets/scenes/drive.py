"""The path of a scanner along a winding road."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import elementwise

SCAN_PERIOD = 0.1  # [s] duration of a scan
SENSOR_HEIGHT = 1.8  # [m]
SWAY_LENGTH = 40.0  # [m] period of the sway


def road(x: Any) -> Any:
    return 12 * np.sin(x / 60)


def pose_at(s: NDArray[np.float64], sway: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Positions (n, 3) and headings (n,) of the sensor at x = s, swaying up to `sway` [rad]."""
    positions = np.stack([s, 12 * np.sin(s / 60), np.full_like(s, SENSOR_HEIGHT)], axis=-1)
    growing = np.clip(s / SWAY_LENGTH, 0, 1)
    yaw = sway * growing * np.sin(s * (2 * np.pi / SWAY_LENGTH))
    return positions, elementwise(math.atan, 12 / 60 * np.cos(s / 60)) + yaw


def sensor_pose(s: float, sway: float = 0.0) -> NDArray[np.float64]:
    """T_world_sensor at x = s, (4, 4): x ahead, y left, z up."""
    position, heading = pose_at(np.array(s), sway)
    T = np.eye(4)
    T[:2, :2] = [[np.cos(heading), -np.sin(heading)], [np.sin(heading), np.cos(heading)]]
    T[:3, 3] = position
    return T


def rotating_rays(
    beams: NDArray[np.float64], azimuths: int, rng: np.random.Generator
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Directions (n, 3) of one rotation from straight behind, and their fraction of the rotation (n,).
    The start is random within a step: a fixed raster would be registered instead of the street."""
    fraction = np.arange(1, azimuths + 1) / azimuths
    fraction, rise = np.repeat(fraction, len(beams)), np.tile(beams, azimuths)
    azimuth = 2 * np.pi * (fraction - rng.random() / azimuths) - np.pi
    return np.stack([np.cos(rise) * np.cos(azimuth), np.cos(rise) * np.sin(azimuth), np.sin(rise)], axis=1), fraction


def in_world(rays: NDArray[np.float64], headings: NDArray[np.float64]) -> NDArray[np.float64]:
    """Sensor directions (n, 3) with headings (n,) in the street frame."""
    c, s = np.cos(headings), np.sin(headings)
    return np.stack([c * rays[:, 0] - s * rays[:, 1], s * rays[:, 0] + c * rays[:, 1], rays[:, 2]], axis=1)
