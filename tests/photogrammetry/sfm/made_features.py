"""Synthetic features of points seen by cameras with known poses, without images and COLMAP."""

from collections.abc import Sequence

import numpy as np

import pointloom as loom
from pointloom.photogrammetry.sfm.feature_rays import FeatureRays

WIDTH, HEIGHT, FOCAL = 640, 480, 525.0
POINTS = 100
CAMERA = loom.CameraModel("PINHOLE", WIDTH, HEIGHT, [FOCAL, FOCAL, 320.0, 240.0])


def looking(center: np.ndarray, at: np.ndarray, roll: float) -> np.ndarray:
    """T_camera_world of a camera that looks at a point."""
    z = (at - center) / np.linalg.norm(at - center)
    x = np.cross([0.0, 1.0, 0.0], z)
    x /= np.linalg.norm(x)
    R = np.stack([x, np.cross(z, x), z])
    c, s = np.cos(roll), np.sin(roll)
    T = np.eye(4)
    T[:3, :3] = np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]]) @ R
    T[:3, 3] = -T[:3, :3] @ center
    return T


def camera_row(count: int = 7) -> loom.SfmModel:
    """Cameras in an uneven row in front of a point cluster; text and numeric order of names agree."""
    along = np.linspace(-1, 1, count) ** 3 + np.linspace(-1, 1, count)
    poses = [
        looking(np.array([x, 0.2 * np.sin(3 * x), -0.3 * x * x]), np.array([0.3 * x, 0.1 * k / count, 4.0]), 0.1 * x)
        for k, x in enumerate(along)
    ]
    return loom.SfmModel([f"IMG_{10 + k}.png" for k in range(count)], [CAMERA] * count, np.array(poses))


def features_of(model: loom.SfmModel, *, count: int = POINTS, noise: float = 0.2, strangers: int = 40) -> FeatureRays:
    """Features of `count` points in the images of a model, and `strangers` unmatched features."""
    rng = np.random.default_rng(0)
    points = rng.uniform(-1, 1, (count, 3)) * (1.2, 0.8, 0.8) + (0, 0, 4.0)
    looks = some_looks(rng, count)
    pixels, rays, descriptors = [], [], []
    for camera, T in zip(model.cameras, model.T_camera_world, strict=True):
        seen = camera.project(points @ T[:3, :3].T + T[:3, 3]) + noise * rng.standard_normal((count, 2))
        alien = rng.uniform((0, 0), (WIDTH, HEIGHT), (strangers, 2))
        order = rng.permutation(count + strangers)
        pixels.append(np.concatenate([seen, alien])[order])
        changed = np.clip(looks + rng.integers(-6, 7, looks.shape), 0, 255).astype(np.uint8)
        descriptors.append(np.concatenate([changed, some_looks(rng, strangers)])[order])
        rays.append(camera.unproject(pixels[-1])[:, :2])
    firsts = np.arange(len(model) + 1) * (count + strangers)
    return FeatureRays(firsts, np.concatenate(pixels), np.concatenate(rays), np.concatenate(descriptors))


def some_looks(rng: np.random.Generator, count: int) -> np.ndarray:
    """Descriptors like SIFT's: of length 512, dominated by few entries."""
    values = rng.exponential(size=(count, 128))
    return np.clip(512 * values / np.linalg.norm(values, axis=1, keepdims=True), 0, 255).astype(np.uint8)


def with_poses(model: loom.SfmModel, T_camera_world: np.ndarray, focal: float = FOCAL) -> loom.SfmModel:
    """The same images with other poses, or another focal length."""
    camera = loom.CameraModel("PINHOLE", WIDTH, HEIGHT, [focal, focal, 320.0, 240.0])
    return loom.SfmModel(model.names, [camera] * len(model), T_camera_world)


def rays_as(model: loom.SfmModel, features: FeatureRays) -> FeatureRays:
    """The features with rays computed by the lenses of a model."""
    rays = [camera.unproject(features.pixels[features.of(i)])[:, :2] for i, camera in enumerate(model.cameras)]
    return FeatureRays(features.firsts, features.pixels, np.concatenate(rays), features.descriptors)


def seen_model(camera: loom.CameraModel, names: Sequence[str], angle: float = 0.1) -> loom.SfmModel:
    """Three cameras side by side, the second rotated by an angle [rad], and 60 points with exact observations."""
    rng, poses = np.random.default_rng(0), np.tile(np.eye(4), (3, 1, 1))
    poses[1, :3, :3] = [[np.cos(angle), 0, np.sin(angle)], [0, 1, 0], [-np.sin(angle), 0, np.cos(angle)]]
    poses[:, 0, 3] = -0.1 * np.arange(3)
    points = np.column_stack([rng.uniform(-1.2, 1.2, 60), rng.uniform(-0.8, 0.8, 60), rng.uniform(2, 3, 60)])
    pixels = np.concatenate([camera.project(points @ T[:3, :3].T + T[:3, 3]) for T in poses])
    observations = np.array([(i, k) for i in range(3) for k in range(60)])
    inside = ((pixels >= 0) & (pixels <= (camera.width - 1, camera.height - 1))).all(axis=1)
    seen = {"observations": observations[inside], "pixels": pixels[inside]}
    colors = rng.integers(0, 256, (60, 3), np.uint8)
    return loom.SfmModel(names, [camera] * 3, poses, points=points, colors=colors, **seen)
