"""A drive as clouds, its true trajectory, and the estimated trajectory; streets of boxes and scans of them."""

from pathlib import Path

import numpy as np

import pointloom as loom
from pointloom.cameras.trajectory import Trajectory
from pointloom.registration import LidarOdometry

ROOT = Path(__file__).parents[2]


def clouds(drive, device, count=None):
    scans = zip(drive.scans[:count], drive.times[:count], strict=True)
    return [loom.PointCloud(points, time=times, device=device) for points, times in scans]


def truth_of(drive, count=None) -> Trajectory:
    poses = drive.poses[:count]
    return Trajectory(np.linalg.inv(poses[0]) @ poses)


def follow(drive, device, count=None, **options) -> LidarOdometry:
    odometry = LidarOdometry(**options)
    for cloud in clouds(drive, device, count):
        odometry.register(cloud)
    return odometry


def sensor_rays(beams=24, azimuths=300):
    rise, angle = np.radians(np.linspace(-22, 14, beams)), np.radians(np.arange(azimuths) * 360 / azimuths)
    e, a = (grid.ravel() for grid in np.meshgrid(rise, angle, indexing="ij"))
    return np.column_stack([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])


def street_of(boxes):
    """A scene of boxes (two corners each) beside a road along x."""
    unit = loom.TriangleMesh.create_box(1, 1, 1)
    corners, triangles = np.asarray(unit.vertices), np.asarray(unit.triangles)
    boxes = [((-200, -40, -2), (200, 40, -1.8)), *boxes]
    vertices = np.vstack([np.array(low) + corners * (np.array(high, float) - low) for low, high in boxes])
    scene = loom.RaycastingScene()
    scene.add_triangles(loom.TriangleMesh(vertices, np.vstack([triangles + 8 * k for k in range(len(boxes))])))
    return scene


def random_street(seed):
    rng, boxes = np.random.default_rng(seed), []
    for i in range(26):
        x = -60 + 6 * i + rng.uniform(0, 2)
        for side in (-1, 1):
            y, (w, d, h) = side * rng.uniform(7, 12), rng.uniform((2, 2, 2), (4.5, 6, 8))
            boxes.append(((x, min(y, y + side * d), -1.8), (x + w, max(y, y + side * d), -1.8 + h)))
    return street_of(boxes)


def street_of_equal_houses(period):
    return street_of(
        ((x, min(9 * side, 13 * side), -1.8), (x + period / 2, max(9 * side, 13 * side), 4.0))
        for x in np.arange(-120, 200, period)
        for side in (-1, 1)
    )


def scan_at(scene, x, device, seed, pitch=0.0, noise=0.01, beams=24):
    """A scan of a street from a position on its middle line. `pitch` [rad] lifts the front, `noise` [m] of ranges."""
    rays = sensor_rays(beams)
    c, s = np.cos(pitch), np.sin(pitch)
    turned = rays @ np.array([[c, 0, -s], [0, 1, 0], [s, 0, c]]).T
    origins = np.tile([x, 0.0, 0.0], (len(rays), 1))
    t = np.asarray(scene.cast_rays(np.hstack([origins, turned]).astype(np.float32))["t_hit"])
    seen = np.isfinite(t) & (t < 40)
    noise = np.random.default_rng(seed).normal(0, noise, seen.sum())
    return loom.PointCloud(rays[seen] * (t[seen] + noise)[:, None], device=device)
