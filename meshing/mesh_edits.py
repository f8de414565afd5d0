"""Meshes changed: moved, and without what they do not need."""

from __future__ import annotations

from typing import Any, Self

import numpy as np

from ..kernels.algebra.transform import transform_points
from ..kernels.meshes import mesh_edits
from ..pcd.checks import check_transformation
from ..pcd.coordinates import ORIGIN_LIMIT
from ..pcd.dropped_results import returns_new
from .mesh_arrays import MeshArrays


class MeshEdits(MeshArrays):
    """The part of TriangleMesh that changes it."""

    @returns_new
    def transform(self, transformation: Any) -> Self:
        """Move the mesh by an affine transformation.

        Args:
            transformation: A finite 4x4 matrix with last row (0, 0, 0, 1) and an inverse.

        Returns:
            The moved mesh. Normals turn with the surface (by the inverse transpose, at unit length; Open3D turns them
            as if they were directions), and a reflection reverses the triangles, so that their outside stays outside.

        Raises:
            ValueError: Another matrix.
        """
        T = check_transformation("transformation", transformation)
        A, determinant = T[:3, :3], float(np.linalg.det(T[:3, :3]))
        if determinant == 0:
            raise ValueError("transformation: expected a matrix with an inverse, got one that flattens space")
        target = A @ self._origin + T[:3, 3]
        origin = np.round(target) if np.abs(target).max() > ORIGIN_LIMIT else np.zeros(3)
        arrays: dict[str, Any] = {"vertices": transform_points(self._arrays["vertices"], A, target - origin)}
        if "vertex_normals" in self._arrays:
            arrays["vertex_normals"] = mesh_edits.turn_normals(self._arrays["vertex_normals"], np.linalg.inv(A).T)
        if determinant < 0:
            arrays["triangles"] = mesh_edits.flip_triangles(self._arrays["triangles"])
        return self._with(origin=origin, **arrays)

    @returns_new
    def remove_unreferenced_vertices(self) -> Self:
        """Drop the vertices that no triangle uses; the others keep their order."""
        names = [name for name in self._arrays if name != "triangles"]
        vertex_count = self._arrays["vertices"].size
        rows = [self._arrays[name] for name in names]
        triangles, kept = mesh_edits.drop_unreferenced(self._arrays["triangles"], vertex_count, rows)
        return self._with(triangles=triangles, **dict(zip(names, kept, strict=True)))
