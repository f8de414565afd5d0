"""Synthetic images along facades with repeating windows: a wall, recessed panes and protruding sills.

All of a facade repeats exactly, except for the unique parts of its kind (`KINDS`). Views of a bare facade that are one
period apart are the same image, so that no method can distinguish their poses.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from image_scenes import Shots, pinhole
from scipy.ndimage import gaussian_filter, map_coordinates

from pointloom.datasets.scenes.room import look_along

SIZE, FOCAL = (320, 240), 300.0
KINDS = ("bare", "stains", "door", "curtains", "signs", "stains", "street", "none repeats")
TILE, UNIQUE = 192, (512, 2048)  # texels of one period, and of the texture that does not repeat
FAR = 40.0, 10.0  # [m] sides of the texture that does not repeat


@dataclass(frozen=True)
class Facade:
    """A facade, and a path along it.

    Attributes:
        kind: Of KINDS.
        period: Distance of neighboring windows [m], and of storeys.
        wide: Periods that an image shows.
        step: Mean step of the camera in periods.
        count: Number of images.
        stain: Standard deviation of the brightness that does not repeat, of 255.
        signs: Rectangles with a unique texture: x and z of the center, width, height [m].
        seed: Of the textures and of the path.
    """

    kind: str
    period: tuple[float, float]
    wide: float
    step: float
    count: int
    stain: float
    signs: np.ndarray
    seed: int

    @property
    def name(self) -> str:
        return f"{self.kind}, {self.wide:.1f} periods wide, steps of {self.step:.2f}, seed {self.seed}"


def facade(seed: int) -> Facade:
    """A random facade; its kind is the remainder of the seed."""
    rng = np.random.default_rng(seed)
    kind, period = KINDS[seed % len(KINDS)], (rng.uniform(2.0, 4.0), rng.uniform(2.5, 3.5))
    wide, step = rng.uniform(1.2, 3.5), rng.choice([rng.uniform(0.15, 0.6), 0.5, 1.0, rng.uniform(0.6, 1.3)])
    step, count = min(step, 0.4 * wide), 8
    length = step * count * period[0]
    signs = np.zeros((0, 4))
    if kind == "door":
        signs = np.array([[rng.uniform(0.2, 0.8) * length, 1.1, 1.2, 2.2]])
    elif kind == "signs":
        many = int((length / period[0] + 2) * 2.0 ** rng.uniform(-1, 2))
        signs = np.column_stack(
            [
                rng.uniform(-period[0], length + period[0], many),
                rng.uniform(0.5, 4.5, many),
                *rng.uniform(0.5, 1.5, (2, many)),
            ]
        )
    stain = 2.0 ** rng.uniform(2, 6) if kind == "stains" else 0.0
    return Facade(kind, period, float(wide), float(step), count, stain, signs, seed)


def render(facade: Facade) -> Shots:
    """Images by a camera that moves along the facade with unequal steps and slightly different directions."""
    rng, (p, _) = np.random.default_rng(facade.seed + 10_000), facade.period
    distance = facade.wide * p * FOCAL / SIZE[0]
    steps = np.cumsum(facade.step * p * rng.uniform(0.75, 1.25, facade.count))
    camera, textures, poses = pinhole(FOCAL, SIZE), _textures(facade), []
    for x in steps:
        eye = np.array([x, -distance * rng.uniform(0.9, 1.1), 1.7 + rng.normal(0, 0.1)])
        yaw, pitch = math.radians(rng.normal(0, 5)), math.radians(4 + rng.normal(0, 3))
        poses.append(look_along(eye, (math.sin(yaw), math.cos(yaw), math.sin(pitch))))
    images = [_view(facade, pose, camera, textures, rng) for pose in poses]
    return Shots(np.array(poses), [camera] * len(poses), images)


def _textures(facade: Facade) -> dict[str, np.ndarray]:
    rng = np.random.default_rng(facade.seed + 20_000)
    tiles = {name: _noise(rng, (TILE, TILE), (0.8, 2.0, 6.0)) for name in ("wall", "pane", "sill")}
    return tiles | {"unique": _noise(rng, UNIQUE, (0.8, 2.0, 6.0))}


def _noise(rng: np.random.Generator, size: tuple[int, int], widths: tuple[float, ...]) -> np.ndarray:
    """Noise that repeats at its edges, with standard deviation 1."""
    layers = [gaussian_filter(rng.normal(0, 1, size), width, mode="wrap") for width in widths]
    total = np.sum([layer / layer.std() for layer in layers], axis=0)
    return total / total.std()


def _repeated(texture: np.ndarray, x: np.ndarray, z: np.ndarray) -> np.ndarray:
    """A texture at positions in units of its sides."""
    at = np.stack([z * texture.shape[0], x * texture.shape[1]])
    return map_coordinates(texture, at, order=1, mode="grid-wrap")


def _view(
    facade: Facade, pose: np.ndarray, camera: object, textures: dict[str, np.ndarray], rng: np.random.Generator
) -> np.ndarray:
    v, u = np.mgrid[: SIZE[1], : SIZE[0]]
    rays = np.stack([(u - SIZE[0] / 2) / FOCAL, (v - SIZE[1] / 2) / FOCAL, np.ones(u.shape)], axis=-1) @ pose[:3, :3].T
    eye, (p, q) = pose[:3, 3], facade.period
    alone = {"none repeats": ("wall", "pane", "sill"), "curtains": ("pane",)}.get(facade.kind, ())

    def on_plane(y: float) -> tuple[np.ndarray, np.ndarray]:
        along = (y - eye[1]) / np.maximum(rays[..., 1], 1e-3)
        return eye[0] + along * rays[..., 0], eye[2] + along * rays[..., 2]

    def unique(x: np.ndarray, z: np.ndarray) -> np.ndarray:
        return _repeated(textures["unique"], x / FAR[0], z / FAR[1])

    def painted(name: str, x: np.ndarray, z: np.ndarray) -> np.ndarray:
        return unique(x, z) if name in alone else _repeated(textures[name], x / p, z / q)

    x, z = on_plane(0.0)
    light = 135 + 22 * painted("wall", x, z) + (facade.stain * unique(x, z) if facade.stain else 0.0)
    inside = (np.abs(x / p % 1 - 0.5) < 0.22) & (np.abs(z / q % 1 - 0.55) < 0.27)
    xs, zs = on_plane(0.3)
    light = np.where(inside, 75 + 25 * painted("pane", xs, zs), light)
    frame = inside & ((np.abs(xs / p % 1 - 0.5) < 0.012) | (np.abs(zs / q % 1 - 0.6) < 0.012))
    light = np.where(frame, 210, light)
    for cx, cz, width, height in facade.signs:
        on = (np.abs(x - cx) < width / 2) & (np.abs(z - cz) < height / 2)
        light = np.where(on, 140 + 45 * unique(x, z), light)
    xs, zs = on_plane(-0.2)
    sill = (np.abs(xs / p % 1 - 0.5) < 0.27) & (np.abs(zs / q % 1 - 0.24) < 0.04)
    light = np.where(sill, 185 + 18 * painted("sill", xs, zs), light)
    down = rays[..., 2] < -1e-3
    along = np.where(down, -eye[2] / np.where(down, rays[..., 2], -1.0), 0.0)
    x, y = eye[0] + along * rays[..., 0], eye[1] + along * rays[..., 1]
    ground = unique(x, y) if facade.kind == "street" else 0.0
    gray = np.where(down & (y < -0.2), 90 + 30 * ground, light) + rng.normal(0, 2.0, light.shape)
    return np.repeat(np.clip(np.rint(gray), 0, 255).astype(np.uint8)[..., None], 3, axis=2)
