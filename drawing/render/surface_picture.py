"""A picture of a surface, seen from the side that it looks to: `draw_surface`."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ...meshing.mesh.mesh import TriangleMesh
from .render import render

BACKDROP = (0.88, 0.89, 0.91)  # white surfaces stand out from it


def draw_surface(mesh: TriangleMesh) -> NDArray[np.uint8]:
    """A picture of a mesh. Of one whose faces look inwards, as a room's, those that look away are left out."""
    return render(mesh, background=BACKDROP, mesh_show_back_face=not looks_inwards(mesh))


def looks_inwards(mesh: TriangleMesh) -> bool:
    """Whether most of the surface faces its middle."""
    corners = mesh.vertices[mesh.triangles]
    middles = corners.mean(axis=1)
    crosses = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    areas = np.linalg.norm(crosses, axis=1)
    outwards = middles - np.average(middles, axis=0, weights=areas if areas.sum() > 0 else None)
    heights = np.einsum("ij,ij->i", crosses, outwards)
    return bool(heights.sum() < -0.3 * np.abs(areas * np.linalg.norm(outwards, axis=1)).sum())
