"""Synthetic structure-from-motion models: cameras on a circle that look at points in its center."""

import numpy as np

import pointloom as loom

LENS = loom.CameraModel("SIMPLE_RADIAL", 640, 480, [500.0, 320.0, 240.0, -0.05])
OTHER = loom.CameraModel("OPENCV", 640, 480, [510.0, 505.0, 322.0, 239.0, -0.1, 0.02, 1e-3, -1e-3])


def ring_model(images: int = 6, points: int = 40, *, seed: int = 0) -> loom.SfmModel:
    """Images of two cameras with long and unusual names; points with colors and errors, seen by many images."""
    rng = np.random.default_rng(seed)
    poses = np.tile(np.eye(4), (images, 1, 1))
    for pose, angle in zip(poses, np.arange(images) * (2 * np.pi / images), strict=True):
        forward = -np.array([np.cos(angle), np.sin(angle), 0.1 * np.sin(3 * angle)])
        forward /= np.linalg.norm(forward)
        right = np.cross(forward, [0.0, 0.0, 1.0])
        right /= np.linalg.norm(right)
        pose[:3, :3] = np.stack([right, np.cross(forward, right), forward])
        pose[:3, 3] = pose[:3, :3] @ (4 * forward)
    positions = rng.uniform(-1, 1, (points, 3))
    names = [f"room_{i:02d}_größe.jpg" if i % 2 else f"left/{i:02d}.png" for i in range(images)]
    cameras = [OTHER if i % 3 == 0 else LENS for i in range(images)]
    rows, pixels = [], []
    for i, pose in enumerate(poses):
        pixels_of_points = cameras[i].project(positions @ pose[:3, :3].T + pose[:3, 3])
        for j in np.flatnonzero(np.isfinite(pixels_of_points).all(axis=1) & (rng.random(points) < 0.8)):
            rows.append((i, j))
            pixels.append(pixels_of_points[j])
    errors = rng.random(points)
    errors[::7] = np.nan
    colors = rng.integers(0, 256, (points, 3)).astype(np.uint8)
    return loom.SfmModel(names, cameras, poses, positions, colors, errors, rows, np.round(pixels, 3))


def assert_same(a: loom.SfmModel, b: loom.SfmModel, *, poses: float = 0.0, pixels: float = 0.0) -> None:
    """Check that two models are equal, poses and pixels up to rounding."""
    assert a.names == b.names and a.cameras == b.cameras
    assert np.abs(a.T_camera_world - b.T_camera_world).max(initial=0) <= poses
    assert np.abs(a.pixels - b.pixels).max(initial=0) <= pixels
    for name in ("points", "colors", "errors", "observations"):
        assert np.array_equal(getattr(a, name), getattr(b, name), equal_nan=name == "errors"), name
