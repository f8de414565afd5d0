"""A city of rectangular blocks, and a scanner that drives along its streets: boxes on a plane, by ray casting.

Points are measured from the position of the scanner at that moment, so scans have motion distortion. All data are
formulas of a seed, and the true poses are given.
"""

from dataclasses import dataclass

import numpy as np

import pointloom as loom

SENSOR_HEIGHT = 1.8  # [m]
SCAN_PERIOD = 0.1  # [s]
CORNER_RADIUS = 4.0  # [m]
# triangles of a box: corner k has its bits as x, y, z
FACES = np.array(
    [[0, 2, 1], [1, 2, 3], [4, 5, 6], [5, 7, 6], [0, 1, 4], [1, 5, 4], [2, 6, 3], [3, 6, 7], [0, 4, 2], [2, 4, 6],
     [1, 3, 5], [3, 7, 5]]
)  # fmt: skip


@dataclass(frozen=True)
class BlockDrive:
    """Scans in the sensor's frame with point times, and the true poses at the ends of the scans."""

    scans: list[np.ndarray]
    times: list[np.ndarray]
    poses: np.ndarray

    def clouds(self, device=None):
        return [loom.PointCloud(p, time=t, device=device) for p, t in zip(self.scans, self.times, strict=True)]


def make_blocks(counts, block=(60.0, 40.0), street=14.0, seed=0, alike=False):
    """Boxes (low, high) [n, 3] of buildings, cars and poles around blocks. `alike`: all blocks are equal."""
    boxes = []
    for column in range(counts[0]):
        for row in range(counts[1]):
            rng = np.random.default_rng((seed, 0) if alike else (seed, column, row))
            corner = np.array([column * (block[0] + street), row * (block[1] + street), 0.0])
            boxes += [(low + corner, high + corner) for low, high in block_boxes(block, street, rng)]
    low, high = (np.array(side) for side in zip(*boxes, strict=True))
    return low, high


def block_boxes(block, street, rng):
    width, depth = block
    boxes = []

    def add(x0, y0, x1, y1, height, base=0.0):
        low, high = np.array([min(x0, x1), min(y0, y1), base]), np.array([max(x0, x1), max(y0, y1), height])
        boxes.append((low, high))

    for length, to_world in (
        (width, lambda a, b: (a, b)),
        (width, lambda a, b: (a, depth - b)),
        (depth, lambda a, b: (b, a)),
        (depth, lambda a, b: (width - b, a)),
    ):
        at = 0.0
        while at < length - 4:
            size = rng.uniform(6, 14)
            end, setback = min(at + size, length), rng.uniform(0, 3)
            add(*to_world(at, setback), *to_world(end, setback + 9), rng.uniform(4, 12))
            door = at + rng.uniform(1, size / 2)
            if door + 3 < end:
                add(*to_world(door, setback - rng.uniform(0.6, 1.5)), *to_world(door + 2.5, setback + 1), 3)
            if rng.random() < 0.5:
                add(*to_world(at + 1, -1.2), *to_world(at + 5.2, -3.0), rng.uniform(1.3, 2.0))
            if rng.random() < 0.6:
                pole = at + rng.uniform(0, size)
                add(*to_world(pole, -0.5), *to_world(pole + 0.3, -0.8), rng.uniform(4, 7))
            at = end + rng.choice([0.0, rng.uniform(1.5, 4)])
    return boxes


def scene_of(low, high):
    corners = np.stack([np.where([k & 1, k >> 1 & 1, k >> 2 & 1], high, low) for k in range(8)], axis=1)
    faces = FACES + 8 * np.arange(len(low))[:, None, None]
    far = 2000.0
    ground = np.array([[-far, -far, 0], [far, -far, 0], [-far, far, 0], [far, far, 0]])
    scene = loom.RaycastingScene()
    scene.add_triangles(corners.reshape(-1, 3).astype(np.float32), faces.reshape(-1, 3).astype(np.uint32))
    scene.add_triangles(ground.astype(np.float32), np.array([[0, 1, 2], [1, 3, 2]], np.uint32))
    return scene


def rounded(corners, spacing=0.1):
    """Points along a polyline [m, 2] with rounded corners, at a spacing [m]."""
    corners = np.asarray(corners, float)
    parts = [corners[:1]]
    for a, b, c in zip(corners, corners[1:], corners[2:], strict=False):
        start, end = b + CORNER_RADIUS * unit(a - b), b + CORNER_RADIUS * unit(c - b)
        t = np.linspace(0, 1, 12)[:, None]
        parts.append((1 - t) ** 2 * start + 2 * t * (1 - t) * b + t**2 * end)
    path = np.concatenate([*parts, corners[-1:]])
    along = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(path, axis=0), axis=1))])
    at = np.arange(0, along[-1], spacing)
    return np.column_stack([np.interp(at, along, path[:, k]) for k in range(2)])


def unit(v):
    return v / np.linalg.norm(v)


def drive_along(
    boxes, corners, speed=8.0, beams=16, azimuths=600, max_range=60.0, noise=0.02, seed=0, height=SENSOR_HEIGHT
):
    """Scans along a polyline [m, 2] at a speed [m/s]."""
    rng, scene, spacing = np.random.default_rng(seed), scene_of(*boxes), 0.1
    path = rounded(corners, spacing)
    ahead = np.roll(path, -1, axis=0) - path
    ahead[-1] = ahead[-2]
    kernel = np.ones(21) / 21
    padded = np.pad(np.unwrap(np.arctan2(ahead[:, 1], ahead[:, 0])), 10, mode="edge")
    headings = np.convolve(padded, kernel, mode="valid")
    length, step = (len(path) - 1) * spacing, speed * SCAN_PERIOD
    along = np.arange(len(path)) * spacing

    def at(s):
        s = np.clip(s, 0, length)
        x, y, heading = (np.interp(s, along, values) for values in (path[:, 0], path[:, 1], headings))
        return np.stack([x, y, np.full_like(x, height)], axis=-1), heading

    rise = np.radians(np.linspace(-15, 12, beams))
    scans, times, poses = [], [], []
    for k in range(int(length / step) + 1):
        fraction = np.repeat(np.arange(1, azimuths + 1) / azimuths, beams)
        azimuth = 2 * np.pi * (fraction - rng.random() / azimuths) - np.pi
        up = np.tile(rise, azimuths)
        rays = np.stack([np.cos(up) * np.cos(azimuth), np.cos(up) * np.sin(azimuth), np.sin(up)], axis=1)
        origins, heading = at((k + fraction - 1) * step)
        c, s = np.cos(heading), np.sin(heading)
        world = np.stack([c * rays[:, 0] - s * rays[:, 1], s * rays[:, 0] + c * rays[:, 1], rays[:, 2]], axis=1)
        t = scene.cast_rays(np.concatenate([origins, world], axis=1).astype(np.float32))["t_hit"].astype(float)
        is_hit = t < max_range
        ranges = t[is_hit] + rng.normal(0, noise, is_hit.sum())
        scans.append((rays[is_hit] * ranges[:, None]).astype(np.float32))
        times.append((k + fraction[is_hit]) * SCAN_PERIOD)
        position, end = at(np.array(k * step))
        T = np.eye(4)
        T[:2, :2] = [[np.cos(end), -np.sin(end)], [np.sin(end), np.cos(end)]]
        T[:3, 3] = position
        poses.append(T)
    return BlockDrive(scans, times, np.array(poses))
