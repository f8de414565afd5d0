"""A picture of a scanned scene, whose frame may lie anyhow: `draw_scene`, from where `view_scene` says.

Colours that cameras took have the light of the scene in them, and scanned surfaces are rough: such a mesh is drawn as
bright as its colours are (`as_photographed`).
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...meshing.mesh.mesh import TriangleMesh
from .picture_files import save_picture
from .render import render
from .view import View, fit_view

BACKDROP = (0.88, 0.89, 0.91)  # sunlit walls are as white as paper

# Surfaces whose normals lie within these angles [degrees] of what counts as up so far refine it: cameras are held up to
# a quarter turn off level, floors and tables are not.
_NARROWING = (35.0, 25.0, 15.0, 10.0, 10.0)

_FEW = 0.01  # share of the triangles below which there is no level surface to go by


def draw_scene(path: Any, mesh: TriangleMesh, T_world_camera: NDArray[np.float64], *, overwrite: bool = True) -> None:
    """Draw a scene as its cameras saw it, from `view_scene`.

    Args:
        path: A .png file.
        mesh: The scene, on the device that draws it.
        T_world_camera: Where the cameras were, shape [n, 4, 4] [m].
        overwrite: Replace the file if it exists.

    Raises:
        FileError: The place cannot be written.
    """
    view = view_scene(mesh, T_world_camera)
    image = render(as_photographed(mesh), view, background=BACKDROP, mesh_show_back_face=False)
    save_picture(path, image, overwrite=overwrite)


def as_photographed(mesh: TriangleMesh) -> dict[str, Any]:
    """A mesh for `render` whose colours, if it has any, are those of photographs; without any it is lit."""
    entry: dict[str, Any] = {"geometry": mesh}
    return entry | {"shaded": False} if "vertex_colors" in mesh._device_arrays else entry


def view_scene(
    mesh: TriangleMesh, T_world_camera: NDArray[np.float64], *, width: int = 1280, height: int = 960
) -> View:
    """The view of a scene from the side that its cameras were on, a little from the left and from above them.

    Args:
        mesh: The scene.
        T_world_camera: Where the cameras were, shape [n, 4, 4] [m].
        width: Columns [px].
        height: Rows [px].
    """
    up = level_up(mesh.compute_triangle_normals(), -_mean_direction(T_world_camera[:, :3, 1]))
    forward = next(v for v in _forwards(T_world_camera, up) if np.linalg.norm(v) > 0.2)
    forward = forward / np.linalg.norm(forward)
    direction = forward + 0.35 * np.cross(forward, up) - 0.55 * up
    x, y, z = direction.tolist()
    return fit_view(mesh.vertices, direction=(x, y, z), up=tuple(up.tolist()), width=width, height=height)


def level_up(normals: NDArray[np.floating], up: NDArray[np.float64]) -> NDArray[np.float64]:
    """What is up by the level surfaces of a scene: floors, tables, seats.

    Args:
        normals: Unit normals of equally large pieces of surface, shape [n, 3].
        up: A first guess, a unit vector; kept where few surfaces face that way.
    """
    level = up
    for angle in _NARROWING:
        near = normals[normals @ level > math.cos(math.radians(angle))]
        if len(near) <= _FEW * len(normals):
            return up
        level = near.mean(axis=0, dtype=np.float64)
        level = level / np.linalg.norm(level)
    return level


def _mean_direction(directions: NDArray[np.float64]) -> NDArray[np.float64]:
    """The mean of unit vectors, or the first where they cancel out."""
    mean = directions.mean(axis=0)
    if np.linalg.norm(mean) < 0.1:
        mean = directions[0]
    return mean / np.linalg.norm(mean)


def _forwards(T_world_camera: NDArray[np.float64], up: NDArray[np.float64]) -> list[NDArray[np.float64]]:
    """Level directions to look along, the best first; one at least is long enough."""
    first = T_world_camera[0, :3]
    candidates = [T_world_camera[:, :3, 2].mean(axis=0), first[:, 2], first[:, 1], first[:, 0]]
    return [vector - up * (vector @ up) for vector in candidates]
