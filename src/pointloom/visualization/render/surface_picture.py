"""Image of a surface from its outer side: `draw_surface`."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ...meshing.mesh.mesh import TriangleMesh
from .render import render

BACKGROUND_COLOR = (0.88, 0.89, 0.91)  # contrast to white surfaces


def draw_surface(mesh: TriangleMesh) -> NDArray[np.uint8]:
    """Render a mesh. Back faces are hidden if the faces look inwards, as for a room."""
    return render(mesh, background=BACKGROUND_COLOR, mesh_show_back_face=not looks_inwards(mesh))


def looks_inwards(mesh: TriangleMesh) -> bool:
    """True if most of the surface faces its center."""
    corners = mesh.vertices[mesh.triangles]
    middles = corners.mean(axis=1)
    crosses = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    areas = np.linalg.norm(crosses, axis=1)
    outwards = middles - np.average(middles, axis=0, weights=areas if areas.sum() > 0 else None)
    heights = np.einsum("ij,ij->i", crosses, outwards)
    return bool(heights.sum() < -0.3 * np.abs(areas * np.linalg.norm(outwards, axis=1)).sum())
