"""TetraMesh: the tetrahedra of a cloud, as far as the tutorial of alpha shapes asks for them."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...core.known_names import KnownNames
from ...meshing.mesh.mesh import TriangleMesh
from ..held import ours
from ..vectors import Vector3dVector, Vector4iVector
from .point_cloud import PointCloud


class TetraMesh(KnownNames):
    """Vertices and tetrahedra; `TriangleMesh.create_from_point_cloud_alpha_shape` takes one and makes its own anew."""

    def __init__(self, vertices: Any = (), tetras: Any = ()):
        self.vertices, self.tetras = Vector3dVector(vertices), Vector4iVector(tetras)

    vertices: Vector3dVector
    tetras: Vector4iVector

    @classmethod
    def create_from_point_cloud(cls, point_cloud: Any) -> tuple[TetraMesh, list[int]]:
        """The Delaunay tetrahedra of a cloud, and the point of each vertex."""
        cloud = ours(point_cloud, PointCloud, "point_cloud")
        _, tetrahedra, _ = TriangleMesh.create_from_point_cloud_alpha_shape(cloud, np.inf, return_tetrahedra=True)
        return cls(cloud.points, tetrahedra), list(range(len(cloud)))

    def has_vertices(self) -> bool:
        """Whether there are vertices."""
        return len(self.vertices) > 0

    def has_tetras(self) -> bool:
        """Whether there are vertices and tetrahedra."""
        return self.has_vertices() and len(self.tetras) > 0

    def __repr__(self) -> str:
        return f"TetraMesh with {len(self.vertices)} points and {len(self.tetras)} tetrahedra."
