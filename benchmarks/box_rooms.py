"""Rooms whose furniture is nothing but boxes that stand parallel to the walls, as a depth camera sees parts of them.

All surfaces of all of them lie in three directions, so that floor, walls and the front of a box of any one lie on those
of any other. Drawn by RaycastingScene, with the noise of a depth camera; everything is drawn from the seed.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

WIDTH, HEIGHT, FOCAL = 160, 120, 131.25  # [px]: 63 by 49 degrees
NEAREST, FAR = 0.35, 4.5  # [m] of depth that is measured
STEEPEST = 0.12  # cosine to the normal below which a ray comes back as nothing
VOXEL = 0.02  # [m] that the pictures of a part are thinned to together
EYE = 1.5  # [m] of the camera above the floor
FACES = np.array(
    [
        *([0, 2, 1], [1, 2, 3], [4, 5, 6], [5, 7, 6], [0, 1, 4], [1, 5, 4]),
        *([2, 6, 3], [3, 6, 7], [0, 4, 2], [2, 4, 6], [1, 3, 5], [3, 7, 5]),
    ]
)


def furnish(seed: int) -> tuple[list[tuple[Array, Array]], Array]:
    """The boxes of a room, low and high corner each, and the room's size [m]."""
    rng = np.random.default_rng([seed, 0])
    size = np.array([rng.uniform(3.2, 6.5), rng.uniform(3.0, 5.5), rng.uniform(2.4, 3.0)])
    boxes = []
    for _ in range(rng.integers(4, 11)):
        extent = np.array([rng.uniform(0.4, 1.8), rng.uniform(0.3, 0.9), rng.uniform(0.35, 2.0)])
        wall = rng.integers(5)  # at a wall, or anywhere
        if wall in (2, 3):
            extent[:2] = extent[1::-1]
        low = np.append(rng.uniform(0, 1, 2) * (size - extent)[:2], 0.0)
        if wall < 4:
            axis = 1 if wall < 2 else 0
            low[axis] = 0.0 if wall % 2 == 0 else size[axis] - extent[axis]
        boxes.append((low, low + extent))
        if rng.random() < 0.4:  # something on it
            top = extent * rng.uniform(0.2, 0.7, 3) * [1, 1, 0.5]
            at = low + np.append(rng.uniform(0, 1, 2) * (extent - top)[:2], extent[2])
            boxes.append((at, at + top))
    return boxes, size


def fragments(seed: int, starts: tuple[float, ...] = (0.0, 65.0, 150.0), frames: int = 5, sweep: float = 80.0):
    """Parts of a room as a camera sees them that turns by a sweep [degrees], beginning at angles [degrees].

    Returns:
        Of each part its points in the frame of its first camera [m], float64 [n, 3], and T_room_camera.
    """
    import pointloom as loom
    from pointloom.datasets.scenes.room import look_along

    boxes, size = furnish(seed)
    rng = np.random.default_rng([seed, 1])
    scene = loom.RaycastingScene()
    for low, high in [(np.zeros(3), size), *boxes]:
        corners = np.array([[(low, high)[i >> k & 1][k] for k in range(3)] for i in range(8)])
        scene.add_triangles(corners.astype(np.float32), FACES)
    inside = [low - 0.3 for low, _ in boxes], [high + 0.3 for _, high in boxes]
    found = []
    for start in starts:
        while True:
            middle = np.append(size[:2] * rng.uniform(0.25, 0.75, 2), EYE + rng.uniform(-0.1, 0.1))
            if not any((middle > low).all() and (middle < high).all() for low, high in zip(*inside, strict=True)):
                break
        points, first = [], None
        for k in range(frames):
            yaw = math.radians(start + sweep * k / max(frames - 1, 1))
            pitch = math.radians(rng.uniform(-35, -5))
            way = (math.cos(yaw) * math.cos(pitch), math.sin(yaw) * math.cos(pitch), math.sin(pitch))
            T = look_along(middle + rng.uniform(-0.1, 0.1, 3), way)
            first = T if first is None else first
            points.append(_picture(scene, T, rng))
        seen = np.concatenate(points)
        cells = np.floor(seen / VOXEL).astype(np.int64)
        seen = seen[np.unique(cells, axis=0, return_index=True)[1]]
        assert first is not None
        found.append(((seen - first[:3, 3]) @ first[:3, :3], first))
    return found


def _picture(scene, T: Array, rng: np.random.Generator) -> Array:
    """Points in the room [m], float64 [n, 3], that a camera at T_room_camera measures."""
    v, u = np.mgrid[:HEIGHT, :WIDTH]
    ways = np.stack([(u - (WIDTH - 1) / 2) / FOCAL, (v - (HEIGHT - 1) / 2) / FOCAL, np.ones(u.shape)], -1)
    shaken = ways + np.append(rng.normal(0, 0.4 / FOCAL, (HEIGHT, WIDTH, 2)), np.zeros((HEIGHT, WIDTH, 1)), -1)
    there = shaken @ T[:3, :3].T
    rays = np.concatenate([np.broadcast_to(T[:3, 3], there.shape), there], -1).astype(np.float32)
    met = scene.cast_rays(rays)
    z = met["t_hit"].astype(np.float64)
    cosine = np.abs((there * met["primitive_normals"]).sum(-1)) / np.linalg.norm(there, axis=-1)
    seen = np.isfinite(z) & (z > NEAREST) & (z < FAR) & (cosine > STEEPEST)
    z = z[seen] + rng.normal(0, 1, seen.sum()) * (0.0012 + 0.0019 * (z[seen] - 0.4) ** 2)  # [m] of a Kinect
    return (ways[seen] * z[:, None]) @ T[:3, :3].T + T[:3, 3]
