"""A depth camera and a spinning scanner in a synthetic site, with noise and faults."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from places import Site

from pointloom.datasets.scenes.room import look_along

Array = NDArray[np.float64]

WIDTH, HEIGHT, FOCAL = 320, 240, 262.5  # [px]
NEAREST, FARTHEST = 0.35, 4.5  # [m] range of a first-generation Kinect
BASELINE, FOCAL_IR, STEP = 0.075, 570.0, 0.125  # [m, px, px] of its disparities (Khoshelham and Elberink 2012)
SLANT = 0.12  # minimum cosine of the incidence angle for a return
RATE = 30.0  # [Hz]


@dataclass(frozen=True)
class CameraFrame:
    """A frame for `loom.rgbd.track`: depth [m], colors, time [s], and the true pose T_world_camera."""

    depth: NDArray[np.float32]
    color: NDArray[np.uint8]
    timestamp: float
    name: str
    pose: Array


class DepthCamera:
    """Renders a site; images have `scale` times WIDTH x HEIGHT, and the focal length is multiplied by `zoom`."""

    def __init__(self, site: Site, seed: int = 0, *, scale: float = 1, zoom: float = 1.0):
        import pointloom as loom

        self.site, self.seed = site, seed
        self.scene = loom.RaycastingScene()
        self.scene.add_triangles(site.vertices.astype(np.float32), site.triangles.astype(np.uint32))
        width, height, self.focal = round(scale * WIDTH), round(scale * HEIGHT), scale * zoom * FOCAL
        cx, cy = (width - 1) / 2, (height - 1) / 2
        self.intrinsic = loom.PinholeCameraIntrinsic(width, height, self.focal, self.focal, cx, cy)
        v, u = np.mgrid[:height, :width]
        self.rays = np.stack([(u - cx) / self.focal, (v - cy) / self.focal, np.ones(u.shape)], axis=-1)

    def take(self, pose: Array, index: int) -> CameraFrame:
        rng = np.random.default_rng([self.seed, index])
        directions = self.rays @ pose[:3, :3].T
        jitter = rng.normal(0, 0.4 / self.focal, (*directions.shape[:2], 2))
        bent = (self.rays + np.concatenate([jitter, np.zeros((*directions.shape[:2], 1))], axis=-1)) @ pose[:3, :3].T
        hits = self.scene.cast_rays(_rays(pose, bent))
        z, normals = hits["t_hit"].astype(float), hits["primitive_normals"].astype(float)
        cosines = np.abs((bent * normals).sum(-1)) / np.linalg.norm(bent, axis=-1)
        is_valid = np.isfinite(z) & (z > NEAREST) & (z < FARTHEST) & (cosines > SLANT)
        z = np.where(is_valid, z, 1.0)
        z = z + rng.normal(0, 1, z.shape) * (0.0012 + 0.0019 * (z - 0.4) ** 2)
        disparity = np.round(BASELINE * FOCAL_IR / z / STEP) * STEP
        depth = np.where(is_valid, np.rint(1000 * BASELINE * FOCAL_IR / disparity) / 1000, 0).astype(np.float32)
        return CameraFrame(depth, self._paint(pose, directions, rng), index / RATE, f"{index:06d}", pose)

    def image(self, pose: Array, index: int) -> NDArray[np.uint8]:
        """Render colors only."""
        return self._paint(pose, self.rays @ pose[:3, :3].T, np.random.default_rng([self.seed, index]))

    def _paint(self, pose: Array, directions: Array, rng: np.random.Generator) -> NDArray[np.uint8]:
        hits = self.scene.cast_rays(_rays(pose, directions))
        z, normals = hits["t_hit"].astype(float), hits["primitive_normals"].astype(float)
        is_hit = np.isfinite(z)
        points = pose[:3, 3] + directions[is_hit] * z[is_hit][:, None]
        light = np.abs(normals[is_hit] @ np.array([0.3, 0.5, 0.81]))
        values = np.full(directions.shape[:2], 205.0)  # the sky
        values[is_hit] = 130 * (0.75 + 0.25 * light) + self.site.shades(points)
        tinted = values[..., None] * np.array([1.0, 0.96, 0.9]) + rng.normal(0, 2, (*directions.shape[:2], 3))
        return np.clip(tinted, 0, 255).astype(np.uint8)

    def film(self, poses: Sequence[Array]) -> list[CameraFrame]:
        return [self.take(pose, k) for k, pose in enumerate(poses)]


def _rays(pose: Array, directions: Array) -> NDArray[np.float32]:
    return np.concatenate([np.broadcast_to(pose[:3, 3], directions.shape), directions], axis=-1).astype(np.float32)


def in_hand(poses: Sequence[Array], seed: int) -> list[Array]:
    """Add handheld jitter to poses: tenths of a degree, some millimeters."""
    rng = np.random.default_rng([seed, 8])
    rates, phases = rng.uniform(2, 20, (6, 3)), rng.uniform(0, 6.28, (6, 3))
    shaken = []
    for k, pose in enumerate(poses):
        waves = np.sin(rates * k / RATE + phases).sum(axis=1)
        a, b, c = np.radians(0.2) * waves[:3]
        rotation = np.array([[1, -c, b], [c, 1, -a], [-b, a, 1.0]])
        u, _, w = np.linalg.svd(rotation)
        T = np.eye(4)
        T[:3, :3], T[:3, 3] = u @ w, 0.0012 * waves[3:]
        shaken.append(pose @ T)
    return shaken


def walking_path(count: int, seed: int, *, start: float = -8.0, speed: float = 0.7, height: float = 1.4) -> list[Array]:
    """Frames of a path along x, looking around."""
    poses = []
    for k in range(count):
        t = k / RATE
        yaw, pitch = 0.5 * math.sin(0.9 * t + seed), -0.35 + 0.15 * math.sin(1.3 * t)
        direction = np.array([math.cos(yaw) * math.cos(pitch), math.sin(yaw) * math.cos(pitch), math.sin(pitch)])
        poses.append(look_along(np.array([start + speed * t, 0.15 * math.sin(0.7 * t), height]), direction))
    return in_hand(poses, seed)


def around(
    count: int, seed: int, *, radius: float = 1.3, height: float = 1.45, angle: float = 2 * math.pi
) -> list[Array]:
    """A path around the origin, looking at it."""
    poses = []
    for k in range(count):
        a = angle * k / count + seed
        eye = np.array([radius * math.cos(a), radius * math.sin(a), height + 0.1 * math.sin(3 * a)])
        poses.append(look_along(eye, np.array([0, 0, 0.78]) - eye))
    return in_hand(poses, seed)


def climb(count: int, seed: int, *, speed: float = 0.35) -> list[Array]:
    """A path up the stairs, looking at the steps."""
    poses = []
    for k in range(count):
        x = speed * k / RATE
        yaw = 0.12 * math.sin(0.8 * k / RATE + seed)
        poses.append(look_along(np.array([x, 0.0, 1.5 + 0.6 * x]), np.array([math.cos(yaw), math.sin(yaw), -0.25])))
    return in_hand(poses, seed)


def frozen(
    frames: Sequence[CameraFrame], start: int, end: int | None = None, *, noise: float = 0.0
) -> list[CameraFrame]:
    """Frames whose depth is that of one frame up to noise [m], while their color continues."""
    last, still = len(frames) if end is None else end, frames[start].depth
    changed = []
    for k, f in enumerate(frames):
        if start < k < last:
            rng = np.random.default_rng([k, 9])
            z = np.where(still > 0, np.round(still + rng.normal(0, noise, still.shape), 3), 0) if noise else still
            f = dataclasses.replace(f, depth=z.astype(np.float32))
        changed.append(f)
    return changed


def delayed(frames: Sequence[CameraFrame], count: int, start: int = 0, end: int | None = None) -> list[CameraFrame]:
    """Frames with depth delayed by `count` frames, from the first possible one, or between two frames only."""
    last = len(frames) if end is None else end
    late = [
        dataclasses.replace(f, depth=frames[max(k - count, 0)].depth) if start <= k < last else f
        for k, f in enumerate(frames)
    ]
    return late if start else late[count:]


def with_gripper(frames: Sequence[CameraFrame], fraction: float, seed: int, *, side: str = "low") -> list[CameraFrame]:
    """Frames with an object fixed to the camera in the lower or left part of the image, 0.5 m away."""
    rng = np.random.default_rng([seed, 11])
    height, width = frames[0].depth.shape
    v, u = np.mgrid[:height, :width]
    mask = v >= round(height * (1 - fraction)) if side == "low" else u < round(width * fraction)
    x, y = u * (WIDTH / width), v * (HEIGHT / height)
    shape = 0.5 + 0.08 * np.sin(x / 31) * np.cos(y / 17)
    paint = (120 + 60 * np.sin(x / 9) * np.sin(y / 13))[..., None] * np.array([1.0, 0.8, 0.6])
    changed = []
    for f in frames:
        depth, color = f.depth.copy(), f.color.copy()
        noise = rng.normal(0, 0.0013, depth.shape)
        depth[mask] = (shape + noise)[mask].astype(np.float32)
        color[mask] = np.clip(paint + rng.normal(0, 2, paint.shape), 0, 255).astype(np.uint8)[mask]
        changed.append(dataclasses.replace(f, depth=depth, color=color))
    return changed


def covered(frames: Sequence[CameraFrame], start: int, end: int) -> list[CameraFrame]:
    """Frames of which some are blank."""
    blank = [dataclasses.replace(f, depth=np.zeros_like(f.depth), color=np.zeros_like(f.color)) for f in frames]
    return [blank[k] if start <= k < end else f for k, f in enumerate(frames)]


class Scanner:
    """A spinning LiDAR with several beams; a scan is a snapshot."""

    def __init__(self, site: Site, *, beams: int = 24, azimuths: int = 720, seed: int = 0, noise: float = 0.01):
        import pointloom as loom

        self.scene = loom.RaycastingScene()
        self.scene.add_triangles(site.vertices.astype(np.float32), site.triangles.astype(np.uint32))
        self.beams, self.azimuths, self.seed, self.noise = beams, azimuths, seed, noise

    def scan(self, pose: Array, index: int, movers: Sequence[tuple[Array, Array]] = ()) -> NDArray[np.float32]:
        """Points in the sensor's frame; movers are boxes, low and high corners in the world."""
        rng = np.random.default_rng([self.seed, index])
        angles = 2 * math.pi * (np.arange(self.azimuths) + rng.random()) / self.azimuths
        rise = np.radians(np.linspace(-25, 15, self.beams))
        a, e = np.meshgrid(angles, rise)
        directions = np.stack([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)], axis=-1).reshape(-1, 3)
        world = directions @ pose[:3, :3].T
        t = self.scene.cast_rays(_rays(pose, world))["t_hit"].astype(float)
        for low, high in movers:
            with np.errstate(divide="ignore", invalid="ignore"):
                first, second = (low - pose[:3, 3]) / world, (high - pose[:3, 3]) / world
            enter, leave = np.minimum(first, second).max(axis=1), np.maximum(first, second).min(axis=1)
            t = np.where((enter < leave) & (enter > 0) & (enter < t), enter, t)
        is_hit = np.isfinite(t) & (t < 60) & (t > 0.4)
        ranges = t[is_hit] + rng.normal(0, self.noise, int(is_hit.sum()))
        return (directions[is_hit] * ranges[:, None]).astype(np.float32)


def drive(count: int, step: float, *, height: float = 1.5, start: float = -15.0, sway: float = 0.15) -> list[Array]:
    """Poses along x that accelerate from rest to `step` meters per scan, with oscillating heading."""
    poses, x = [], start
    for k in range(count):
        x += step * min(k / 5, 1.0)
        yaw = sway * math.sin(0.25 * k)
        T = np.eye(4)
        T[:2, :2] = [[math.cos(yaw), -math.sin(yaw)], [math.sin(yaw), math.cos(yaw)]]
        T[:3, 3] = x, 0.0, height
        poses.append(T)
    return poses


def cloud_of(frames: Sequence[CameraFrame], intrinsic: Any, voxel_size: float = 0.02) -> Array:
    """Frames fused at their true poses, as points in the frame of the first [m]."""
    import pointloom as loom

    volume = loom.TSDFVolume(voxel_size=voxel_size, color=False)
    for f in frames:
        volume.integrate(f.depth, intrinsic, np.linalg.inv(f.pose), depth_scale=1.0, depth_max=4.0)
    points = volume.extract_point_cloud(weight_threshold=0.0).points
    T = frames[0].pose
    return (points - T[:3, 3]) @ T[:3, :3]
