"""Random synthetic rooms, and fragments of them as fused from a depth camera."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

GRAY = (0.7, 0.7, 0.7)
WALL = 0.2  # [m] wall thickness
VOXEL = 0.02  # [m] of the fusion
WIDTH, HEIGHT, FOCAL = 320, 240, 262.5  # [px] of the camera
FAR = 4.0  # [m] maximum fused depth


def furnish(seed: int) -> tuple[object, Array]:
    """A room with one to eleven pieces of furniture, and its size [m], generated from a seed."""
    from pointloom.datasets.scenes.furniture import SolidBuilder

    rng = np.random.default_rng(seed)
    size = np.array([rng.uniform(3, 6), rng.uniform(2.8, 5), rng.uniform(2.35, 2.9)])
    x, y, z = size
    room, w = SolidBuilder(), WALL
    for center, extent in (
        ((x / 2, y / 2, -w / 2), (x + 2 * w, y + 2 * w, w)),
        ((x / 2, y / 2, z + w / 2), (x + 2 * w, y + 2 * w, w)),
        ((-w / 2, y / 2, z / 2), (w, y, z)),
        ((x + w / 2, y / 2, z / 2), (w, y, z)),
        ((x / 2, -w / 2, z / 2), (x + 2 * w, w, z)),
        ((x / 2, y + w / 2, z / 2), (x + 2 * w, w, z)),
    ):
        room.box(center, extent, GRAY)
    for _ in range(rng.integers(1, 12)):
        piece = PIECES[rng.integers(len(PIECES))]
        along = rng.uniform(0.15, 0.85)
        deep = rng.uniform(0.25, 0.4)
        wall = rng.integers(5)  # at a wall, or anywhere
        angle = (0, 180, -90, 90, rng.uniform(0, 360))[wall]
        at = ((along * x, deep), (along * x, y - deep), (deep, along * y), (x - deep, along * y))
        position = at[wall] if wall < 4 else rng.uniform(0.25, 0.75, 2) * size[:2]
        room.set_frame(float(position[0]), float(position[1]), angle=float(angle))
        piece(room, rng)
    return room, size


def _cupboard(room, rng) -> None:
    w, d, h = rng.uniform(0.4, 1.6), rng.uniform(0.3, 0.6), rng.uniform(0.5, 2.1)
    room.box((0, 0, h / 2), (w, d, h), GRAY, radius=0.01)


def _shelf(room, rng) -> None:
    w, d, boards, gap = rng.uniform(0.6, 1.4), rng.uniform(0.2, 0.4), rng.integers(2, 6), rng.uniform(0.3, 0.45)
    for k in range(boards):
        room.box((0, 0, 0.05 + gap * k), (w, d, 0.03), GRAY)
        if rng.random() < 0.7:
            high = rng.uniform(0.1, 0.25)
            at = rng.uniform(-0.3, 0.3) * w
            room.box((at, 0, 0.065 + gap * k + high / 2), (rng.uniform(0.1, 0.4) * w, 0.7 * d, high), GRAY)
    for side in (-w / 2, w / 2):
        room.box((side, 0, gap * boards / 2), (0.03, d, gap * boards), GRAY)


def _table(room, rng) -> None:
    w, d, h = rng.uniform(0.7, 1.8), rng.uniform(0.5, 0.9), rng.uniform(0.4, 0.8)
    room.box((0, 0, h - 0.02), (w, d, 0.04), GRAY)
    for sx in (-1, 1):
        for sy in (-1, 1):
            room.cylinder((sx * (w / 2 - 0.05), sy * (d / 2 - 0.05), h / 2 - 0.02), 0.03, h - 0.04, GRAY)
    for _ in range(rng.integers(4)):
        side = rng.uniform(0.08, 0.3, 3)
        at = rng.uniform(-0.35, 0.35, 2) * (w, d)
        room.box((at[0], at[1], h + side[2] / 2), tuple(side), GRAY, tilt=(2, float(rng.uniform(0, 90))))


def _sofa(room, rng) -> None:
    w, d, h = rng.uniform(0.8, 2.2), rng.uniform(0.7, 0.95), rng.uniform(0.35, 0.48)
    room.box((0, 0, h / 2), (w, d, h), GRAY, radius=0.05)
    room.box((0, -d / 2 + 0.1, h), (w, 0.2, rng.uniform(0.7, 0.9)), GRAY, radius=0.08)
    for side in (-1, 1):
        room.box((side * w / 2, 0, h / 2 + 0.1), (0.2, d, h + 0.2), GRAY, radius=0.08)


def _plant(room, rng) -> None:
    r, h = rng.uniform(0.12, 0.3), rng.uniform(0.3, 0.6)
    room.cylinder((0, 0, h / 2), r, h, GRAY, rounding=0.02)
    for _ in range(rng.integers(1, 8)):
        at = rng.normal(0, 0.15, 2)
        room.sphere((at[0], at[1], h + rng.uniform(0.1, 0.6)), rng.uniform(0.05, 0.2), GRAY)


def _chair(room, rng) -> None:
    w, h = rng.uniform(0.36, 0.5), rng.uniform(0.4, 0.5)
    room.box((0, 0, h), (w, w, 0.05), GRAY, radius=0.02)
    room.box((0, -w / 2, h + 0.25), (w, 0.04, 0.45), GRAY, tilt=(0, float(rng.uniform(0, 12))))
    for sx in (-1, 1):
        for sy in (-1, 1):
            room.cylinder((sx * (w / 2 - 0.03), sy * (w / 2 - 0.03), h / 2 - 0.02), 0.02, h - 0.04, GRAY)


PIECES = (_cupboard, _shelf, _table, _sofa, _plant, _chair)


def fragments(
    seed: int, starts: tuple[float, ...], frames: int = 12, sweep: float = 100.0
) -> list[tuple[Array, Array]]:
    """Partial views of a room by a camera that rotates by `sweep` [degrees], starting at the given angles [degrees].

    Returns:
        Points in the frame of each part's first camera [m], and T_room_camera.
    """
    import pointloom as loom
    from pointloom.datasets.scenes.room import look_along
    from pointloom.kernels.memory import download
    from pointloom.kernels.scenes.depth_noise import measure_depth
    from pointloom.kernels.scenes.room import Room

    parts, size = furnish(seed)
    rng = np.random.default_rng([seed, 1])
    camera = loom.PinholeCameraIntrinsic(WIDTH, HEIGHT, FOCAL, FOCAL, (WIDTH - 1) / 2, (HEIGHT - 1) / 2)
    x, y, z = size.tolist()
    high = (x + 0.3, y + 0.3, z + 0.3)
    solids = parts.solids("cpu")  # type: ignore[attr-defined]
    room = Room(
        solids,
        np.array(parts.paints),
        np.array(parts.patterns),
        lamp=(x / 2, y / 2, z - 0.3),
        low=(-0.3,) * 3,
        high=high,
    )
    result = []
    for start in starts:
        volume = loom.TSDFVolume(voxel_size=VOXEL, color=False)
        middle = np.array([x, y, 0]) * (0.5 + rng.uniform(-0.15, 0.15, 3)) + [0, 0, rng.uniform(1.2, 1.7)]
        poses = []
        for k in range(frames):
            yaw = math.radians(start + sweep * k / frames)
            pitch = math.radians(-22 + 14 * math.sin(2.1 * k))
            eye = middle + 0.25 * np.array([-math.cos(yaw), -math.sin(yaw), 0.2 * math.sin(k)])
            direction = (math.cos(yaw) * math.cos(pitch), math.sin(yaw) * math.cos(pitch), math.sin(pitch))
            T = look_along(eye, direction)
            depth, incidence, _ = room.render(camera, T)
            measured = measure_depth(depth, incidence, WIDTH, HEIGHT, seed=seed, frame=1000 * len(result) + k)
            values = np.array(download(measured), np.float32).reshape(HEIGHT, WIDTH)
            volume.integrate(values, camera, np.linalg.inv(T), depth_scale=1.0, depth_max=FAR)
            poses.append(T)
        T = poses[0]
        points = volume.extract_point_cloud(weight_threshold=0.0).points
        result.append(((points - T[:3, 3]) @ T[:3, :3], T))
    return result
