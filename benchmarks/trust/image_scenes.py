"""Synthetic images with known cameras for checks of focal lengths: the room, and flights over terrain."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from PIL import Image

import pointloom as loom
from pointloom.datasets.scenes.room import film_pose, look_along, room_views

SIZE = (640, 480)
FOCAL = 525.0

_MAKE, _MODEL, _EXIF, _FOCAL, _FOCAL_35 = 0x010F, 0x0110, 0x8769, 0x920A, 0xA405  # EXIF tags
_CELLS = (
    (6, 0.15),
    (24, 0.2),
    (96, 0.25),
    (384, 0.25),
    (1024, 0.15),
)  # cells of the noise on the ground, and its weight


@dataclass
class Shots:
    """Images and their ground truth.

    Attributes:
        poses: Camera to world of each, [n, 4, 4].
        cameras: The camera of each.
        images: uint8 [h, w, 3] each.
        exif: EXIF values of each: (model, focal length [mm], 35 mm equivalent), or None.
    """

    poses: np.ndarray
    cameras: list[loom.CameraModel]
    images: list[np.ndarray]
    exif: list[tuple[str, float, int] | None] = field(default_factory=list)

    def write(self, folder: Path) -> dict[str, tuple[np.ndarray, loom.CameraModel]]:
        """Write them as 0000.jpg and so on; returns pose and camera by name."""
        folder.mkdir(parents=True)
        truth = {}
        for k, image in enumerate(self.images):
            name, exif_fields = f"{k:04d}.jpg", self.exif[k] if self.exif else None
            exif = exif_of(*exif_fields) if exif_fields else b""
            Image.fromarray(image).save(folder / name, quality=95, subsampling=0, exif=exif)
            truth[name] = (self.poses[k], self.cameras[k])
        return truth


def exif_of(model: str, millimeters: float, film: int) -> bytes:
    """EXIF data with a camera's model and its focal length, also as 35 mm equivalent."""
    exif = Image.Exif()
    exif[_MAKE], exif[_MODEL] = "Made", model
    exif[_EXIF] = {_FOCAL: millimeters, _FOCAL_35: film}
    return exif.tobytes()


def film_length(camera: loom.CameraModel) -> int:
    """A camera's 35 mm equivalent focal length by the diagonals, as in the standard, rounded to millimeters."""
    return round(camera.params[0] * math.hypot(36, 24) / math.hypot(camera.width, camera.height))


def pinhole(focal: float = FOCAL, size: tuple[int, int] = SIZE) -> loom.CameraModel:
    """A camera without distortion."""
    return loom.CameraModel("PINHOLE", *size, [focal, focal, size[0] / 2, size[1] / 2])


def room(poses: np.ndarray, focals: list[float], **options: object) -> Shots:
    """The furnished room, each image with its own focal length [px]."""
    images, cameras = [], [pinhole(focal) for focal in focals]
    for k, (pose, camera) in enumerate(zip(poses, cameras, strict=True)):
        frame = room_views(np.array([pose]), camera.intrinsic, seed=k, **options).read(0)  # type: ignore[arg-type]
        images.append(frame.color)
    return Shots(np.array(poses), cameras, images)


def straight_path(count: int = 18, step: float = 0.02) -> np.ndarray:
    """Poses on the path along the walls."""
    return np.array([film_pose(step * k) for k in range(count)])


def dolly(count: int = 18, *, step: float = 0.1, heading: float = 0.4) -> np.ndarray:
    """A camera that moves straight ahead without rotation."""
    ahead = np.array([math.cos(heading), 0.9 * math.sin(heading), -0.15])
    ahead /= np.linalg.norm(ahead)
    start = np.array([0.6, 0.6, 1.5])
    return np.array([look_along(start + step * k * ahead, tuple(ahead)) for k in range(count)])


def sideways(count: int = 14, *, step: float = 0.12) -> np.ndarray:
    """A camera that moves along a wall and looks at it without rotation: a facade."""
    return np.array([look_along(np.array([1.2 + step * k, 0.8, 1.4]), (0.0, 1.0, -0.05)) for k in range(count)])


def turning(count: int = 12, *, degrees: float = 100.0) -> np.ndarray:
    """A camera that rotates in place."""
    poses = []
    for k, yaw in enumerate(np.radians(np.linspace(20, 20 + degrees, count))):
        pitch = math.radians(-10 + 5 * math.sin(k))
        direction = (math.cos(yaw) * math.cos(pitch), math.sin(yaw) * math.cos(pitch), math.sin(pitch))
        poses.append(look_along(np.array([2.5, 2.0, 1.5]), direction))
    return np.array(poses)


# ------------------------------------------------------------------------------------------------------ flights


@dataclass(frozen=True)
class Ground:
    """Terrain seen from above: heights on a grid [m], and its brightness.

    Attributes:
        heights: float64 [n, n], over a square from 0 to `extent`.
        light: uint8 [m, m, 3] over the same square.
        extent: Side of the square [m].
    """

    heights: np.ndarray
    light: np.ndarray
    extent: float

    def view(self, T: np.ndarray, camera: loom.CameraModel, *, rolled: np.ndarray | None = None) -> np.ndarray:
        """Render an image, uint8 [h, w, 3].

        Args:
            T: Camera to world, z up.
            camera: With its distortion.
            rolled: Motion during the readout from the first row to the last [m].
        """
        v, u = np.mgrid[: camera.height, : camera.width].reshape(2, -1)
        rays = np.asarray(camera.unproject(np.column_stack([u, v]).astype(np.float64)))
        directions = rays @ T[:3, :3].T
        eyes = np.broadcast_to(T[:3, 3], directions.shape)
        if rolled is not None:
            eyes = eyes + (v / camera.height - 0.5)[:, None] * rolled
        level = np.zeros(len(directions))
        for _ in range(
            12
        ):  # the slope of the ground times that of a ray is below one half: each iteration halves the error
            at = eyes + ((level - eyes[:, 2]) / directions[:, 2])[:, None] * directions
            level = _sampled(self.heights, at[:, :2] / self.extent)
        at = eyes + ((level - eyes[:, 2]) / directions[:, 2])[:, None] * directions
        colors = _sampled(self.light.astype(np.float64), at[:, :2] / self.extent)
        noise = np.random.default_rng(int(abs(T[:3, 3]).sum() * 1e6) % 2**32).normal(0, 2, colors.shape)
        return np.clip(np.rint(colors + noise), 0, 255).astype(np.uint8).reshape(camera.height, camera.width, 3)


def ground(relief: float, *, extent: float = 160.0, seed: int = 0) -> Ground:
    """Soft hills of `relief` [m] (standard deviation), with a non-repeating texture."""
    rng = np.random.default_rng(seed)
    heights = _grain(rng, 512, ((4, 0.6), (10, 0.3), (24, 0.1)))
    heights = relief * (heights - heights.mean()) / heights.std()
    layers = [_grain(rng, 3072, _CELLS) for _ in range(2)]
    gray, tint = ((layer - layer.mean()) / layer.std() for layer in layers)
    light = 120 + 38 * gray[..., None] + 12 * tint[..., None] * np.array([1.0, 0.2, -0.8])
    return Ground(heights, np.clip(light, 0, 255).astype(np.uint8), extent)


def flight(
    rows: int = 3,
    columns: int = 6,
    *,
    height: float = 50.0,
    forward: float = 9.0,
    spacing: float = 16.0,
    tremble: float = 1.5,
    tilt: float = 0.0,
    start: tuple[float, float] = (58.0, 64.0),
    wind: float = 0.3,
    seed: int = 3,
) -> np.ndarray:
    """Rows of nadir images, as taken by a drone; `tremble` and `tilt` in degrees, the rest in m."""
    rng, poses = np.random.default_rng(seed), []
    for j in range(rows):
        for i in range(columns):
            position = start[0] + forward * i, start[1] + spacing * j, height
            eye = np.array(position) + rng.normal(0, wind, 3)
            a, b = np.radians(rng.normal(0, tremble, 2))
            a += math.radians(tilt) * (1 if (i + j) % 2 else -1)
            down = np.array([math.sin(b), math.sin(a), -math.cos(a) * math.cos(b)])
            poses.append(look_along(eye, tuple(down), up=(0.0, 1.0, 0.0)))
    return np.array(poses)


def flown(land: Ground, poses: np.ndarray, camera: loom.CameraModel, *, rolled: float = 0.0) -> Shots:
    """The images of a flight with a rolling shutter and this motion during readout, alternating by row."""
    images = []
    for k, pose in enumerate(poses):
        motion = np.array([rolled * (1 if (k // 6) % 2 == 0 else -1), 0.0, 0.0])
        images.append(land.view(pose, camera, rolled=motion if rolled else None))
    return Shots(poses, [camera] * len(poses), images)


def _grain(rng: np.random.Generator, size: int, cells: tuple[tuple[int, float], ...]) -> np.ndarray:
    """Noise of several sizes, [size, size]."""
    total = np.zeros((size, size))
    for count, weight in cells:
        rough = Image.fromarray(rng.normal(0, 1, (count, count)).astype(np.float32))
        total += weight * np.asarray(rough.resize((size, size), Image.Resampling.BICUBIC))
    return total


def _sampled(values: np.ndarray, where: np.ndarray) -> np.ndarray:
    """Interpolated values of a grid over the unit square, [n] or [n, c]; clamped at its edge."""
    count = values.shape[0]
    position = np.clip(where, 0, 1) * (count - 1)
    x, y = (np.minimum(position[:, k].astype(int), count - 2) for k in (0, 1))
    p, q = position[:, 0] - x, position[:, 1] - y
    if values.ndim == 3:
        p, q = p[:, None], q[:, None]
    upper = values[y, x] * (1 - p) + values[y, x + 1] * p
    return upper * (1 - q) + (values[y + 1, x] * (1 - p) + values[y + 1, x + 1] * p) * q
