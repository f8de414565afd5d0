"""TetraMesh: Delaunay tetrahedra of a cloud, as needed for alpha shapes."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...core.attribute_hints import KnownNames
from ...meshing.mesh.mesh import TriangleMesh
from ..vectors import Vector3dVector, Vector4iVector
from ..wrapper import unwrap
from .point_cloud import PointCloud


class TetraMesh(KnownNames):
    """Vertices and tetrahedra; `TriangleMesh.create_from_point_cloud_alpha_shape` accepts one but computes its own."""

    def __init__(self, vertices: Any = (), tetras: Any = ()):
        self.vertices, self.tetras = Vector3dVector(vertices), Vector4iVector(tetras)

    vertices: Vector3dVector
    tetras: Vector4iVector

    @classmethod
    def create_from_point_cloud(cls, point_cloud: Any) -> tuple[TetraMesh, list[int]]:
        """Delaunay tetrahedra of a cloud, and the point index of each vertex."""
        cloud = unwrap(point_cloud, PointCloud, "point_cloud")
        _, tetrahedra, _ = TriangleMesh.create_from_point_cloud_alpha_shape(cloud, np.inf, return_tetrahedra=True)
        return cls(cloud.points, tetrahedra), list(range(len(cloud)))

    def has_vertices(self) -> bool:
        return len(self.vertices) > 0

    def has_tetras(self) -> bool:
        return self.has_vertices() and len(self.tetras) > 0

    def __repr__(self) -> str:
        return f"TetraMesh with {len(self.vertices)} points and {len(self.tetras)} tetrahedra."
