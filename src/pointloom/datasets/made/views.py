"""Render a colored mesh by ray casting."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...kernels.linear_algebra import matmul
from ...meshing.mesh.mesh import TriangleMesh
from ...meshing.scene.raycasting_scene import RaycastingScene
from ..scenes.room import look_along


@dataclasses.dataclass(frozen=True, eq=False)
class MeshView:
    """A rendered view, float64 (h, w): `depth` along the axis [m], 0 for background, `cosine` of view and normal.
    `colors` (0..1), world `normals` and `points` [m] are (h, w, 3). Background points are the camera position."""

    depth: NDArray[np.float64]
    colors: NDArray[np.float64]
    normals: NDArray[np.float64]
    cosine: NDArray[np.float64]
    points: NDArray[np.float64]


def scene_of(mesh: TriangleMesh) -> RaycastingScene:
    scene = RaycastingScene()
    scene.add_triangles(mesh.vertices.astype(np.float32), mesh.triangles)
    return scene


def look_at(eye: ArrayLike, target: ArrayLike = (0, 0, 0)) -> NDArray[np.float64]:
    """T_world_camera of an upright camera at `eye` [m] that looks at `target`."""
    at = np.asarray(eye, np.float64)
    x, y, z = np.asarray(target) - at
    return look_along(at, (x, y, z))


def ring(count: int, distance: float, heights: tuple[float, ...], *, start: float = 0.0) -> NDArray[np.float64]:
    """Cameras on a ring that look at the origin, (n, 4, 4), with alternating elevations [rad]."""
    poses = []
    for k in range(count):
        azimuth, rise = start + 2 * math.pi * k / count, heights[k % len(heights)]
        away = (math.cos(azimuth) * math.cos(rise), math.sin(azimuth) * math.cos(rise), math.sin(rise))
        poses.append(look_at(distance * np.array(away)))
    return np.array(poses)


def view_mesh(
    mesh: TriangleMesh, scene: RaycastingScene, camera: PinholeCameraIntrinsic, T_world_camera: NDArray[np.float64]
) -> MeshView:
    fx, fy, cx, cy = camera.fx, camera.fy, camera.cx, camera.cy
    v, u = np.mgrid[: camera.height, : camera.width]
    directions = matmul(np.stack([(u - cx) / fx, (v - cy) / fy, np.ones(u.shape)], axis=-1), T_world_camera[:3, :3].T)
    rays = np.concatenate([np.broadcast_to(T_world_camera[:3, 3], directions.shape), directions], axis=-1)
    hits = scene.cast_rays(rays)
    seen = np.isfinite(hits["t_hit"])
    corners = mesh.triangles[np.where(seen, hits["primitive_ids"], 0).astype(np.int64)]
    second, third = hits["primitive_uvs"][..., :1], hits["primitive_uvs"][..., 1:]
    weights = np.stack([1 - second - third, second, third], axis=-2)
    colors = (np.asarray(mesh.vertex_colors)[corners] * weights).sum(axis=-2) * seen[..., None]
    normals = hits["primitive_normals"].astype(np.float64)
    cosine = np.abs((directions * normals).sum(axis=-1)) / np.linalg.norm(directions, axis=-1)
    depth = np.where(seen, hits["t_hit"], 0.0)
    points = T_world_camera[:3, 3] + directions * depth[..., None]
    return MeshView(depth, colors, normals, cosine, points)
