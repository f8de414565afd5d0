"""Rooms furnished with axis-aligned boxes, in partial views of a depth camera.

All surfaces have one of three directions, so floor, walls and box fronts of any room align with those of any other. The
rooms are rendered by RaycastingScene with the noise of a depth camera, all from a seed.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

WIDTH, HEIGHT, FOCAL = 160, 120, 131.25  # [px]: 63 by 49 degrees
NEAREST, FAR = 0.35, 4.5  # [m] measured depth
STEEPEST = 0.12  # minimum cosine of the incidence angle for a measurement
VOXEL = 0.02  # [m] voxel size to which the images of a part are down-sampled together
EYE = 1.5  # [m] camera height above the floor
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
        if rng.random() < 0.4:  # a box on top
            top = extent * rng.uniform(0.2, 0.7, 3) * [1, 1, 0.5]
            at = low + np.append(rng.uniform(0, 1, 2) * (extent - top)[:2], extent[2])
            boxes.append((at, at + top))
    return boxes, size


def fragments(seed: int, starts: tuple[float, ...] = (0.0, 65.0, 150.0), frames: int = 5, sweep: float = 80.0):
    """Partial views of a room by a camera that rotates by `sweep` [degrees], starting at the given angles [degrees].

    Returns:
        For each part its points in the frame of its first camera [m], float64 [n, 3], and T_room_camera.
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
    result = []
    for start in starts:
        while True:
            middle = np.append(size[:2] * rng.uniform(0.25, 0.75, 2), EYE + rng.uniform(-0.1, 0.1))
            if not any((middle > low).all() and (middle < high).all() for low, high in zip(*inside, strict=True)):
                break
        points, first = [], None
        for k in range(frames):
            yaw = math.radians(start + sweep * k / max(frames - 1, 1))
            pitch = math.radians(rng.uniform(-35, -5))
            direction = (math.cos(yaw) * math.cos(pitch), math.sin(yaw) * math.cos(pitch), math.sin(pitch))
            T = look_along(middle + rng.uniform(-0.1, 0.1, 3), direction)
            first = T if first is None else first
            points.append(_image(scene, T, rng))
        thinned = np.concatenate(points)
        cells = np.floor(thinned / VOXEL).astype(np.int64)
        thinned = thinned[np.unique(cells, axis=0, return_index=True)[1]]
        assert first is not None
        result.append(((thinned - first[:3, 3]) @ first[:3, :3], first))
    return result


def _image(scene, T: Array, rng: np.random.Generator) -> Array:
    """Measured points in the room [m], float64 [n, 3], of a camera at T_room_camera."""
    v, u = np.mgrid[:HEIGHT, :WIDTH]
    directions = np.stack([(u - (WIDTH - 1) / 2) / FOCAL, (v - (HEIGHT - 1) / 2) / FOCAL, np.ones(u.shape)], -1)
    shaken = directions + np.append(rng.normal(0, 0.4 / FOCAL, (HEIGHT, WIDTH, 2)), np.zeros((HEIGHT, WIDTH, 1)), -1)
    world_rays = shaken @ T[:3, :3].T
    rays = np.concatenate([np.broadcast_to(T[:3, 3], world_rays.shape), world_rays], -1).astype(np.float32)
    hits = scene.cast_rays(rays)
    z = hits["t_hit"].astype(np.float64)
    cosine = np.abs((world_rays * hits["primitive_normals"]).sum(-1)) / np.linalg.norm(world_rays, axis=-1)
    is_valid = np.isfinite(z) & (z > NEAREST) & (z < FAR) & (cosine > STEEPEST)
    z = z[is_valid] + rng.normal(0, 1, is_valid.sum()) * (
        0.0012 + 0.0019 * (z[is_valid] - 0.4) ** 2
    )  # [m] noise of a Kinect
    return (directions[is_valid] * z[:, None]) @ T[:3, :3].T + T[:3, 3]
