"""MeshBase: vertices with normals and colours, which meshes of triangles and of tetrahedra have in common."""

from __future__ import annotations

from typing import Any, Self

from numpy.typing import ArrayLike

from .. import geometry
from ..held import Rows, column
from ..vectors import Vector3dVector
from .bounded import BoundedByBoxes


class MeshBase(BoundedByBoxes):
    """Vertices, with normals and colours."""

    vertices = Rows(Vector3dVector)
    vertex_normals = Rows(Vector3dVector)
    vertex_colors = Rows(Vector3dVector)

    def has_vertices(self) -> bool:
        """Whether there are vertices."""
        return self._count("vertices") > 0

    def has_vertex_normals(self) -> bool:
        """Whether each vertex has a normal."""
        return 0 < self._count("vertices") == self._count("vertex_normals")

    def has_vertex_colors(self) -> bool:
        """Whether each vertex has a colour."""
        return 0 < self._count("vertices") == self._count("vertex_colors")

    def is_empty(self) -> bool:
        """Whether there are no vertices."""
        return not self.has_vertices()

    def paint_uniform_color(self, color: ArrayLike) -> Self:
        """Give all vertices one colour."""
        return self._become(self._ours.paint_uniform_color(column("color", color)))

    def normalize_normals(self) -> Self:
        """Bring normals to length 1."""
        return self._become(self._ours.normalize_normals())

    def compute_convex_hull(self) -> tuple[Any, list[int]]:
        """A mesh of the hull, and the numbers of the vertices on it."""
        hull, rows = self._ours.compute_convex_hull()
        return geometry.TriangleMesh._of(hull), rows.tolist()
