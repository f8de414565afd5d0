"""Write the images of a set of photo_sets.py as camera files, and compute the visible points."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from photo_sets import BEND, GPS_NOISE, HEIGHT, LIGHT, SKY, WIDTH, WORLD_ORIGIN, PhotoSet, Stage, View, noise
from PIL import Image
from PIL.TiffImagePlugin import IFDRational
from scipy.ndimage import gaussian_filter

import pointloom as loom

Array = NDArray[np.float64]

BLUR = 0.6  # [px]
EXPOSURE = 0.15
READ_NOISE, SHOT_NOISE = (
    1.5 / 255,
    0.010,
)  # standard deviation of a black pixel; factor of the square root of the brightness
QUALITY = 94
STRIDE = 6  # [px] between ground truth points
SEEN = 3  # minimum number of images that see an evaluated point


def write_set(photos: PhotoSet, folder: Path, seed: int = 0) -> None:
    """Write images and, for a masked set, masks/; the seed selects noise, exposure and position errors."""
    rng, scene = np.random.default_rng([seed, 77]), photos.stage.scene()
    (folder / "images").mkdir(parents=True)
    gains = 1 + EXPOSURE * rng.uniform(-1, 1, len(photos.views))
    for name, view, gain in zip(photos.names, photos.views, gains, strict=True):
        colors, seen = render(photos.stage, scene, view, 2)
        if photos.masked:
            colors = np.where(seen[..., None], colors, _wall())
            (folder / "masks").mkdir(exist_ok=True)
            mask = seen.reshape(HEIGHT, 2, WIDTH, 2).mean((1, 3)) > 0.5
            Image.fromarray((255 * mask).astype(np.uint8)).save(folder / "masks" / f"{name}.png")
        image = _sensor(colors, gain, rng)
        exif, xmp = _metadata(view, photos.has_gps, rng)
        more = {"xmp": xmp} if xmp else {}
        Image.fromarray(image).save(folder / "images" / name, exif=exif, quality=QUALITY, **more)


def rays_of(view: View, step: float, offset: float) -> tuple[Array, Array]:
    """Rays [h, w, 6] through pixels that are `step` apart, and their undistorted positions as x/z and y/z."""
    v, u = np.meshgrid(np.arange(offset, HEIGHT, step), np.arange(offset, WIDTH, step), indexing="ij")
    bent = np.stack([(u - WIDTH / 2) / view.focal, (v - HEIGHT / 2) / view.focal], -1)
    flat = bent.copy()
    for _ in range(20):
        flat = bent / (1 + BEND * (flat**2).sum(-1, keepdims=True))
    T = view.sensor
    directions = np.concatenate([flat, np.ones((*flat.shape[:2], 1))], -1) @ T[:3, :3].T
    return np.concatenate([np.broadcast_to(T[:3, 3], directions.shape), directions], -1), flat


def render(stage: Stage, scene: Any, view: View, finer: int) -> tuple[Array, NDArray[np.bool_]]:
    """Colors [h, w, 3] in 0..1 without noise at `finer` times the size, and a mask of hits."""
    rays, _ = rays_of(view, 1 / finer, 0.5 / finer)
    hits = scene.cast_rays(rays)
    mask = np.isfinite(hits["t_hit"])
    points = rays[..., :3] + rays[..., 3:] * np.where(mask, hits["t_hit"], 0)[..., None]
    colors = np.broadcast_to(SKY, points.shape).copy()
    light = view.sensor[:3, :3] @ [-0.45, -0.6, -0.66] if stage.still_light else LIGHT
    normals = hits["primitive_normals"].astype(float)
    normals *= -np.sign((normals * rays[..., 3:]).sum(-1, keepdims=True))
    shade = stage.shaded + (1 - stage.shaded) * np.clip(normals @ light, 0, 1)
    for number, (_, paint) in enumerate(stage.parts):
        on_mesh = mask & (hits["geometry_ids"] == number)
        if on_mesh.any():
            colors[on_mesh] = paint(points[on_mesh]) * shade[on_mesh, None]
    return np.clip(colors, 0, 1), mask


def _wall() -> Array:
    """The static background of a turntable: blotches and checks, at twice the size."""
    v, u = np.mgrid[: 2 * HEIGHT, : 2 * WIDTH]
    flat = np.stack([u, v, np.zeros_like(u)], -1).reshape(-1, 3).astype(float)
    blotch = noise(flat, 120.0, 5).reshape(2 * HEIGHT, 2 * WIDTH, 1)
    checks = ((u // 70 + v // 70) % 2)[..., None]
    return np.clip(blotch * np.where(checks, (0.9, 0.8, 0.6), (0.4, 0.6, 0.8)) * 1.2, 0, 1)


def _sensor(colors: Array, gain: float, rng: np.random.Generator) -> NDArray[np.uint8]:
    small = colors.reshape(HEIGHT, 2, WIDTH, 2, 3).mean((1, 3))
    light = gaussian_filter(small, (BLUR, BLUR, 0)) * gain
    light = light + rng.normal(0, 1, light.shape) * (READ_NOISE + SHOT_NOISE * np.sqrt(light))
    return np.rint(255 * np.clip(light, 0, 1)).astype(np.uint8)


def _metadata(view: View, has_gps: bool, rng: np.random.Generator) -> tuple[Image.Exif, bytes]:
    exif = Image.Exif()
    exif[0x010F], exif[0x0110] = "Maker", "Camera"
    if view.portrait:
        exif[0x0112] = 6  # stored in sensor orientation: to be rotated by 90 degrees clockwise
    exif.get_ifd(0x8769).update({0x920A: IFDRational(view.film * 100, 700), 0xA405: view.film})
    if not has_gps:
        return exif, b""
    position = view.T_world_camera[:3, 3] + rng.normal(0, 1, 3) * GPS_NOISE
    latitude, longitude, altitude = loom.WorldFrame(*WORLD_ORIGIN).to_geodetic(position[None])[0]
    exif.get_ifd(0x8825).update(
        {1: "N", 2: _degrees(latitude), 3: "E", 4: _degrees(longitude)}
        | {5: b"\0", 6: IFDRational(round(altitude * 1000), 1000)}
    )
    return exif, _xmp(view.T_world_camera[:3, :3], rng)


def _degrees(value: float) -> tuple[IFDRational, IFDRational, IFDRational]:
    degrees, minutes = int(value), int(value % 1 * 60)
    seconds = (value - degrees - minutes / 60) * 3600
    return IFDRational(degrees, 1), IFDRational(minutes, 1), IFDRational(round(seconds * 1_000_000), 1_000_000)


def _xmp(R: Array, rng: np.random.Generator) -> bytes:
    """The gimbal's attitude in DJI's format, rounded to half a degree."""
    yaw = np.degrees(np.arctan2(R[0, 2], R[1, 2]) if abs(R[2, 2]) < 0.9 else np.arctan2(-R[0, 1], -R[1, 1]))
    pitch, roll = np.degrees(np.arcsin(R[2, 2])), np.degrees(np.arctan2(-R[2, 0], -R[2, 1]))
    yaw, pitch, roll = np.array([yaw, pitch, roll if abs(pitch) < 85 else 0.0]) + rng.normal(0, 0.5, 3)
    return (
        '<x:xmpmeta xmlns:x="adobe:ns:meta/"><rdf:Description '
        f'drone-dji:GimbalYawDegree="{yaw:+.2f}" drone-dji:GimbalPitchDegree="{pitch:+.2f}" '
        f'drone-dji:GimbalRollDegree="{roll:+.2f}"/></x:xmpmeta>'
    ).encode()


def seen_points(photos: PhotoSet, cell: float) -> Array:
    """Ground truth points that at least `SEEN` images show, one per cell of this size [m]."""
    scene, points_of_views = photos.stage.scene(), []
    for view in photos.views:
        rays, _ = rays_of(view, STRIDE, STRIDE / 2)
        distances = scene.cast_rays(rays)["t_hit"]
        hit = np.isfinite(distances)
        points_of_views.append(rays[hit][:, :3] + rays[hit][:, 3:] * distances[hit][:, None])
    points = np.concatenate(points_of_views)
    points = points[np.unique(np.floor(points / cell).astype(np.int64), axis=0, return_index=True)[1]]
    counts = np.zeros(len(points), int)
    for view in photos.views:
        T = np.linalg.inv(view.sensor)
        local = points @ T[:3, :3].T + T[:3, 3]
        flat = local[:, :2] / np.maximum(local[:, 2:], 1e-9)
        pixel = view.focal * flat * (1 + BEND * (flat**2).sum(1, keepdims=True)) + (WIDTH / 2, HEIGHT / 2)
        inside = (local[:, 2] > 0) & (pixel >= 0).all(1) & (pixel < (WIDTH, HEIGHT)).all(1)
        rows = np.flatnonzero(inside)
        directions = points[rows] - view.T_world_camera[:3, 3]
        rays = np.concatenate([np.broadcast_to(view.T_world_camera[:3, 3], directions.shape), directions], 1)
        counts[rows[scene.cast_rays(rays)["t_hit"] > 1 - 2e-3]] += 1
    return points[counts >= SEEN]
