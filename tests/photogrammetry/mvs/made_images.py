"""Images of a textured plane by several cameras, with exact brightness and depth."""

import numpy as np
from numpy.typing import NDArray

import pointloom as loom
from pointloom.photogrammetry.mvs.posed_images import SparsePoints

WIDTH, HEIGHT, FOCAL = 48, 36, 50.0
NORMAL, DISTANCE = np.array([0.3, 0.1, -1.0]) / np.sqrt(1.1), 2.0  # n . X = -distance, toward the first camera


def texture(a: NDArray[np.float64], b: NDArray[np.float64]) -> NDArray[np.float64]:
    """Brightness 0..1 at points of the plane: waves of many directions, down to a few pixels long."""
    rng = np.random.default_rng(5)
    total = np.zeros_like(a)
    for _ in range(24):
        angle, phase, wave = rng.uniform(0, np.pi), rng.uniform(0, 2 * np.pi), rng.uniform(8.0, 40.0)
        total += np.sin(wave * (a * np.cos(angle) + b * np.sin(angle)) + phase)
    return np.clip(0.5 + total / 14.0, 0.0, 1.0)


def intrinsic(scale: float = 1.0) -> loom.PinholeCameraIntrinsic:
    camera = loom.PinholeCameraIntrinsic(WIDTH, HEIGHT, FOCAL, FOCAL, (WIDTH - 1) / 2, (HEIGHT - 1) / 2)
    return camera.scaled(scale)


def camera_at(x: float, y: float = 0.0, scale: float = 1.0) -> loom.photogrammetry.PosedCamera:
    """A camera that looks along z, shifted sideways."""
    T = np.eye(4)
    T[:2, 3] = -x, -y
    return loom.photogrammetry.PosedCamera(intrinsic(scale), T)


def look(camera: loom.photogrammetry.PosedCamera) -> tuple[NDArray[np.uint8], NDArray[np.float64]]:
    """The gray image [h, w] and the depth [h, w] of the plane for a camera."""
    lens = camera.intrinsic
    v, u = np.mgrid[: lens.height, : lens.width].astype(np.float64)
    rays = np.stack([(u - lens.cx) / lens.fx, (v - lens.cy) / lens.fy, np.ones_like(u)], axis=-1)
    rays = rays @ camera.T_camera_world[:3, :3]
    depth = (-DISTANCE - NORMAL @ camera.center) / (rays @ NORMAL)
    points = camera.center + rays * depth[..., None]
    return (255 * texture(points[..., 0], points[..., 1])).astype(np.uint8), depth


def scene(cameras: list[loom.photogrammetry.PosedCamera]) -> tuple[list[NDArray[np.uint8]], SparsePoints]:
    """The images of these cameras, and the points of every sixth pixel of the first."""
    depth = look(cameras[0])[1][::6, ::6]
    lens = cameras[0].intrinsic
    v, u = np.mgrid[: lens.height : 6, : lens.width : 6].astype(np.float64)
    seen = np.stack([(u - lens.cx) / lens.fx * depth, (v - lens.cy) / lens.fy * depth, depth], axis=-1).reshape(-1, 3)
    points = (seen - cameras[0].T_camera_world[:3, 3]) @ cameras[0].T_camera_world[:3, :3]
    pairs = [(i, k) for i in range(len(cameras)) for k in range(len(points))]
    return [look(camera)[0] for camera in cameras], SparsePoints(points, pairs)


def three() -> list[loom.photogrammetry.PosedCamera]:
    return [camera_at(0.0), camera_at(0.18), camera_at(-0.05, 0.15)]
