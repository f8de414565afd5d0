"""Default views of scenes that cameras have seen: `view_scene`, `mesh_of_frames`."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from ...meshing.mesh.mesh import TriangleMesh
from .view import View, fit_view

# Normals within these angles [degrees] of the current up direction refine it: cameras are tilted,
# floors and tables are not.
_CONE_ANGLES = (35.0, 25.0, 15.0, 10.0, 10.0)

_MIN_LEVEL_FRACTION = 0.01  # fraction of the triangles required to define level surfaces


def mesh_of_frames(result: object) -> tuple[TriangleMesh, NDArray[np.float64]] | None:
    """Mesh and poses T_world_camera (n, 4, 4) of a result of `fuse` or `reconstruct`. None for other objects."""
    mesh, poses = getattr(result, "mesh", None), getattr(result, "T_world_camera", None)
    poses = getattr(getattr(result, "trajectory", None), "poses", poses)
    if not isinstance(mesh, TriangleMesh) or not len(mesh) or not isinstance(poses, np.ndarray) or not len(poses):
        return None
    return mesh, poses


def view_scene(
    mesh: TriangleMesh, T_world_camera: NDArray[np.float64], *, width: int = 1280, height: int = 960
) -> View:
    """View from the side of the scene's cameras (n, 4, 4) [m], slightly from the left and above."""
    up = level_up(mesh.triangle_normals, -_mean_direction(T_world_camera[:, :3, 1]))
    forward = next(v for v in _forwards(T_world_camera, up) if np.linalg.norm(v) > 0.2)
    forward = forward / np.linalg.norm(forward)
    direction = forward + 0.35 * np.cross(forward, up) - 0.55 * up
    x, y, z = direction.tolist()
    return fit_view(mesh.vertices, direction=(x, y, z), up=tuple(up.tolist()), width=width, height=height)


def level_up(normals: NDArray[np.floating], up: NDArray[np.float64]) -> NDArray[np.float64]:
    """Up direction from the level surfaces of a scene, given unit normals of equal areas (n, 3).

    Returns the initial `up` if few surfaces face that way.
    """
    level = up
    for angle in _CONE_ANGLES:
        near = normals[normals @ level > math.cos(math.radians(angle))]
        if len(near) <= _MIN_LEVEL_FRACTION * len(normals):
            return up
        level = near.mean(axis=0, dtype=np.float64)
        level = level / np.linalg.norm(level)
    return level


def _mean_direction(directions: NDArray[np.float64]) -> NDArray[np.float64]:
    mean = directions.mean(axis=0)
    if np.linalg.norm(mean) < 0.1:
        mean = directions[0]
    return mean / np.linalg.norm(mean)


def _forwards(T_world_camera: NDArray[np.float64], up: NDArray[np.float64]) -> list[NDArray[np.float64]]:
    """Level viewing directions, best first. At least one is long enough."""
    first = T_world_camera[0, :3]
    candidates = [T_world_camera[:, :3, 2].mean(axis=0), first[:, 2], first[:, 1], first[:, 0]]
    return [vector - up * (vector @ up) for vector in candidates]
