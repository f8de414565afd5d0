"""Exact depth maps of synthetic scenes: balls in front of a wall, viewed by cameras on an arc."""

from typing import Any

import numpy as np

import pointloom as loom
from pointloom.photogrammetry.mvs.depth_maps import DepthMap, DepthMaps

SMALL = loom.PinholeCameraIntrinsic(48, 36, 50.0, 51.0, 23.2, 17.9)
LARGE = loom.PinholeCameraIntrinsic(64, 40, 66.0, 65.0, 30.7, 20.4)
WALL = 3.0  # [m] z of the wall
BALLS = ((0.1, -0.05, 2.2, 0.45), (-0.7, 0.3, 2.6, 0.3))  # centers and radii [m]


def pose(x: float, y: float = 0.0, angle: float = 0.0) -> np.ndarray:
    """T_camera_world of a camera at (x, y, 0), rotated about the vertical by an angle [rad]."""
    T = np.eye(4)
    T[:3, :3] = [[np.cos(angle), 0, -np.sin(angle)], [0, 1, 0], [np.sin(angle), 0, np.cos(angle)]]
    T[:3, 3] = -T[:3, :3] @ (x, y, 0.0)
    return T


def cameras(count: int, *, step: float = 0.15, shift: Any = (0.0, 0.0, 0.0)) -> list[Any]:
    """Cameras side by side, rotated toward each other, of two alternating sizes; the world is moved by `shift`."""
    made = []
    for k in range(count):
        at = (k - (count - 1) / 2) * step
        T = pose(at, 0.04 * (-1) ** k, -0.12 * at)
        T[:3, 3] -= T[:3, :3] @ np.asarray(shift)
        made.append(loom.photogrammetry.PosedCamera(LARGE if k % 2 else SMALL, T))
    return made


def true_map(camera: Any, *, balls: Any = BALLS, wall: float = WALL, shift: Any = (0.0, 0.0, 0.0)) -> Any:
    """The exact depth map of a camera, computed in float64."""
    lens, T = camera.intrinsic, np.linalg.inv(camera.T_camera_world)
    v, u = np.mgrid[: lens.height, : lens.width].astype(np.float64)
    local = np.stack([(u - lens.cx) / lens.fx, (v - lens.cy) / lens.fy, np.ones_like(u)], axis=-1)
    rays, center = local @ T[:3, :3].T, T[:3, 3] - np.asarray(shift)
    depth = (wall - center[2]) / rays[..., 2]
    normals = np.broadcast_to((0.0, 0.0, -1.0), rays.shape)
    for x, y, z, radius in balls:
        to = np.array((x, y, z)) - center
        a, b = (rays * rays).sum(-1), (rays * to).sum(-1)
        inside = b * b - a * (to @ to - radius**2)
        near = np.where(inside > 0, (b - np.sqrt(np.maximum(inside, 0))) / a, np.inf)
        hit = near < depth
        depth = np.where(hit, near, depth)
        at = center + rays * depth[..., None]
        normals = np.where(hit[..., None], (at - (x, y, z)) / radius, normals)
    return DepthMap(depth, normals @ camera.T_camera_world[:3, :3].T, np.full(depth.shape, 0.75))


def lifted(depth: Any, camera: Any) -> Any:
    """The points of a depth map in the world, [h, w, 3]."""
    lens, T = camera.intrinsic, np.linalg.inv(camera.T_camera_world)
    v, u = np.mgrid[: lens.height, : lens.width]
    local = np.stack([(u - lens.cx) / lens.fx, (v - lens.cy) / lens.fy, np.ones(u.shape)], -1)
    return (local * np.asarray(depth, np.float64)[..., None]) @ T[:3, :3].T + T[:3, 3]


def all_sources(count: int) -> list[list[int]]:
    return [[j for j in range(count) if j != i] for i in range(count)]


def true_maps(count: int, **scene: Any) -> Any:
    """Exact maps of some cameras, each with all others as sources."""
    posed = cameras(count, shift=scene.get("shift", (0.0, 0.0, 0.0)))
    return DepthMaps(posed, all_sources(count), [true_map(camera, **scene) for camera in posed])


def changed(maps: Any, i: int, depth: Any) -> Any:
    """The maps with another depth for one image."""
    result = list(maps)
    result[i] = DepthMap(depth, result[i].normals, result[i].confidence)
    return DepthMaps(maps.cameras, maps.sources, result)


def moved(cameras: Any, scale: float = 1.0, shift: Any = (0.0, 0.0, 0.0)) -> list[Any]:
    """The cameras in a world that is scaled, then shifted."""
    result = []
    for camera in cameras:
        T = camera.T_camera_world.copy()
        T[:3, 3] = T[:3, 3] * scale - T[:3, :3] @ np.asarray(shift)
        result.append(loom.photogrammetry.PosedCamera(camera.intrinsic, T))
    return result


def resized(maps: Any, scale: float) -> Any:
    """The maps in another unit."""
    made = [DepthMap(each.depth * scale, each.normals, each.confidence) for each in maps]
    return DepthMaps(moved(maps.cameras, scale), maps.sources, made)
