"""A synthetic street and a scanner that drives through it: boxes, poles and ground.

Each point is measured from the scanner's position at that moment, so scans have motion distortion like real ones. All
data are formulas, and the true poses are given.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pointloom.datasets.scenes.drive import SCAN_PERIOD, in_world, pose_at, road, rotating_rays, sensor_pose

MAX_RANGE = 80.0  # [m]
POLE_HEIGHT = 6.0  # [m]
ROSETTE_ANGLE = np.radians(35)  # from the axis of the cone
PETAL_RATE, TURN_RATE = 121.57, 77.93  # [Hz] without a common period


@dataclass(frozen=True)
class Street:
    """Boxes (low and high corners, [b, 3]) and poles (x, y, radius, [p, 3]) on the plane z = 0."""

    low: np.ndarray
    high: np.ndarray
    poles: np.ndarray


@dataclass(frozen=True)
class Drive:
    """Scans in the sensor's frame with point times, and the true poses at the ends of the scans."""

    scans: list[np.ndarray]
    times: list[np.ndarray]
    poses: np.ndarray


def make_street(length: float, seed: int = 0) -> Street:
    """Houses with porches on both sides of a curved road, parked cars, poles."""
    rng = np.random.default_rng(seed)
    low, high, poles = [], [], []
    for side in (-1, 1):
        along = -60.0
        while along < length + 60:
            width, depth, setback = rng.uniform(8, 16), rng.uniform(6, 10), rng.uniform(6, 10)
            height = rng.uniform(5, 12)
            y0 = side * setback + road(along + width / 2)
            near, far = sorted((y0, y0 + side * depth))
            low.append([along, near, 0]), high.append([along + width, far, height])
            porch = sorted((y0, y0 - side * 1.5))
            low.append([along + 2, porch[0], 0]), high.append([along + 4.5, porch[1], 3])
            if rng.random() < 0.7:
                car = along + rng.uniform(0, width)
                middle = road(car) + side * rng.uniform(3.2, 4.2)
                low.append([car, middle - 0.9, 0]), high.append([car + 4.2, middle + 0.9, 1.5])
            poles.append([along + width + 1.5, side * 4.8 + road(along + width), 0.15])
            along += width + rng.uniform(2, 6)
    return Street(np.array(low), np.array(high), np.array(poles))


def cast_rays(street: Street, origins: np.ndarray, directions: np.ndarray) -> np.ndarray:
    """Distances [n] to the first surface; infinite if there is none in range. The origins are close to each other."""
    middle = origins.mean(axis=0)
    bearings = np.arctan2(directions[:, 1], directions[:, 0])
    with np.errstate(divide="ignore"):
        t = np.where(directions[:, 2] < 0, -origins[:, 2] / directions[:, 2], np.inf)
        inverse = 1 / directions
    for low, high in zip(street.low, street.high, strict=True):
        rays = rays_towards(bearings, low[:2] - middle[:2], high[:2] - middle[:2])
        a, b = (low - origins[rays]) * inverse[rays], (high - origins[rays]) * inverse[rays]
        enter, leave = np.minimum(a, b).max(axis=1), np.maximum(a, b).min(axis=1)
        t[rays] = np.where((enter < leave) & (enter > 0) & (enter < t[rays]), enter, t[rays])
    for x, y, radius in street.poles:
        offset = np.array([x, y]) - middle[:2]
        rays = rays_towards(bearings, offset - radius, offset + radius)
        d = directions[rays]
        gap = np.array([x, y]) - origins[rays, :2]
        size = (d[:, :2] ** 2).sum(axis=1)
        along = (gap * d[:, :2]).sum(axis=1) / size
        beside = (gap**2).sum(axis=1) - along**2 * size
        hit = along - np.sqrt(np.maximum(radius**2 - beside, 0) / size)
        is_hit = (beside < radius**2) & (hit > 0) & (hit < t[rays]) & (origins[rays, 2] + hit * d[:, 2] < POLE_HEIGHT)
        t[rays] = np.where(is_hit, hit, t[rays])
    t[t >= MAX_RANGE] = np.inf
    return t


def rays_towards(bearings: np.ndarray, low: np.ndarray, high: np.ndarray) -> np.ndarray:
    """Rays that can hit a box given relative to their mean origin: a superset, as the origins differ by up to 1 m."""
    low, high = low - 1, high + 1
    if (low < 0).all() and (high > 0).all():
        return np.arange(len(bearings))
    if np.linalg.norm(np.clip(0, low, high)) > MAX_RANGE:
        return np.empty(0, np.int64)
    corners = np.array([[x, y] for x in (low[0], high[0]) for y in (low[1], high[1])])
    middle = np.arctan2(*(low + high)[::-1])
    sides = (np.arctan2(corners[:, 1], corners[:, 0]) - middle + np.pi) % (2 * np.pi) - np.pi
    angles = (bearings - middle + np.pi) % (2 * np.pi) - np.pi
    return np.flatnonzero((angles >= sides.min()) & (angles <= sides.max()))


def rosette_rays(number: int, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Directions [n, 3] of scan `number` in a cone around x, and their fraction of its duration [n]."""
    fraction = np.arange(1, count + 1) / count
    time = (number + fraction) * SCAN_PERIOD
    away, around = ROSETTE_ANGLE * np.sin(2 * np.pi * PETAL_RATE * time), 2 * np.pi * TURN_RATE * time
    return np.stack([np.cos(away), np.sin(away) * np.cos(around), np.sin(away) * np.sin(around)], axis=1), fraction


def drive(
    scan_count: int,
    *,
    speed: float = 10.0,
    sway: float = 0.0,
    beams: int = 16,
    azimuths: int = 900,
    noise: float = 0.01,
    seed: int = 0,
    rosette_points: int = 0,
) -> Drive:
    """Scans of a drive along the road at a speed [m/s]; one revolution takes 0.1 s and starts at the rear. With
    `rosette_points` in 0.1 s, those of a rosette around the direction ahead, which never repeats (as of Livox).
    """
    rng, rise = np.random.default_rng(seed), np.radians(np.linspace(-22, 4, beams))
    street = make_street(speed * SCAN_PERIOD * scan_count, seed)
    scans, times, poses = [], [], []
    for k in range(scan_count):
        rays, fraction = rosette_rays(k, rosette_points) if rosette_points else rotating_rays(rise, azimuths, rng)
        positions, headings = pose_at((k + fraction - 1) * speed * SCAN_PERIOD, sway)
        t = cast_rays(street, positions, in_world(rays, headings))
        is_hit = np.isfinite(t)
        ranges = t[is_hit] + rng.normal(0, noise, is_hit.sum())
        scans.append((rays[is_hit] * ranges[:, None]).astype(np.float32))
        times.append((k + fraction[is_hit]) * SCAN_PERIOD)
        poses.append(sensor_pose(k * speed * SCAN_PERIOD, sway))
    return Drive(scans, times, np.array(poses))
