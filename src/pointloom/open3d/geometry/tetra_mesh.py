"""TetraMesh, changed in place as in Open3D, with SciPy's Delaunay tetrahedra."""

from __future__ import annotations

from typing import Any, ClassVar, Self

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import Delaunay, QhullError

from ...meshing.mesh import mesh
from ..argument_types import CloudLike, VectorLike
from ..vectors import Vector3dVector, Vector4iVector
from ..wrapper import unwrap
from .point_cloud import PointCloud
from .triangle_mesh import MeshBase

PARTS = ("vertex_normals", "vertex_colors")
TETRA_CORNERS = 4


class TetraMesh(MeshBase):
    """Vertices and tetrahedra. A `loom.TriangleMesh` without triangles contains the vertices."""

    _kind = mesh.TriangleMesh
    _arrays: ClassVar = {"vertices": "points", "vertex_normals": "normals"}

    def __init__(self, vertices: Any = (), tetras: VectorLike = ()):
        self._wrapped, self._shared, self._tetras = mesh.TriangleMesh(), {}, Vector4iVector(tetras)
        if isinstance(vertices, TetraMesh):
            vars(self).update(vars(vertices.__copy__()))
        else:
            self.vertices = Vector3dVector(vertices)

    def _read(self, name: str) -> NDArray[Any]:
        values = getattr(self._wrapped, name)
        return np.zeros((0, 3)) if values is None else values

    def _token(self, native: Any, name: str) -> tuple[Any, ...] | None:
        arrays = native.arrays
        return (arrays[name], native.origin.tobytes() if name == "vertices" else b"") if name in arrays else None

    def _made(self, changed: list[str]) -> Any:
        count = self._count("vertices")
        parts: dict[str, Any] = {
            name: np.array(getattr(self, name)) for name in PARTS if 0 < count == self._count(name)
        }
        return mesh.TriangleMesh(np.array(self.vertices), np.zeros((0, 3), np.int32), **parts)

    @property
    def tetras(self) -> Vector4iVector:
        """Vertex indices of tetrahedra, int32 (n, 4)."""
        return self._tetras

    @tetras.setter
    def tetras(self, value: VectorLike) -> None:
        self._tetras.refill(np.asarray(Vector4iVector(value)))

    @classmethod
    def create_from_point_cloud(cls, point_cloud: CloudLike) -> tuple[Self, list[int]]:
        """Delaunay tetrahedra of a cloud, and the point index of each vertex.

        Duplicate and non-finite points have no vertex. Raises ValueError if all points are on a plane.
        """
        cloud = unwrap(point_cloud, PointCloud, "point_cloud")
        points = np.array(point_cloud.points if isinstance(point_cloud, PointCloud) else cloud.points)
        finite = np.flatnonzero(np.isfinite(points).all(axis=1))
        if len(finite) < TETRA_CORNERS:
            raise ValueError(f"point_cloud: expected at least {TETRA_CORNERS} finite points, got {len(finite)}")
        try:
            corners = Delaunay(points[finite] - points[finite[0]]).simplices
        except QhullError as error:
            raise ValueError("point_cloud: expected points that are not on one plane") from error
        used, tetras = np.unique(corners, return_inverse=True)
        rows = finite[used]
        return cls(points[rows], tetras.reshape(-1, TETRA_CORNERS)), rows.tolist()

    def clear(self) -> Self:
        self.tetras = ()
        return super().clear()

    def has_tetras(self) -> bool:
        return self.has_vertices() and len(self.tetras) > 0

    def __copy__(self) -> Self:
        made = super().__copy__()
        vars(made)["_tetras"] = Vector4iVector(self._tetras)
        return made

    def __getstate__(self) -> dict[str, Any]:
        return super().__getstate__() | {"tetras": self._tetras}

    def __setstate__(self, state: dict[str, Any]) -> None:
        super().__setstate__(state)
        self._tetras = state["tetras"]

    def __repr__(self) -> str:
        return f"TetraMesh with {self._count('vertices')} points and {len(self.tetras)} tetrahedra."
