"""Image of a scanned scene in an arbitrary frame: `draw_scene`.

Photographed colors contain the light of the scene, so such meshes are drawn unlit (`as_photographed`).
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...meshing.mesh.mesh import TriangleMesh
from .frame_views import view_scene
from .picture_files import write_image
from .render import render

BACKGROUND_COLOR = (0.88, 0.89, 0.91)  # sunlit walls are as white as paper


def draw_scene(path: Any, mesh: TriangleMesh, T_world_camera: NDArray[np.float64], *, overwrite: bool = True) -> None:
    """Render a scene to a .png file from the side of its cameras, given by T_world_camera (n, 4, 4) [m]."""
    view = view_scene(mesh, T_world_camera)
    image = render(as_photographed(mesh), view, background=BACKGROUND_COLOR, mesh_show_back_face=False)
    write_image(path, image, overwrite=overwrite)


def as_photographed(mesh: TriangleMesh) -> dict[str, Any]:
    """Style for `render`: unlit if the mesh has colors."""
    entry: dict[str, Any] = {"geometry": mesh}
    return entry | {"shaded": False} if "vertex_colors" in mesh.arrays else entry
