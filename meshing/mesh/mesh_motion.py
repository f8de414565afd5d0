"""Meshes moved and painted."""

from __future__ import annotations

from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_color, check_transformation
from ...core.coordinates import origin_under
from ...core.dropped_results import returns_new
from ...core.upward import up_under
from ...kernels.algebra.transform import transform_directions, transform_points
from ...kernels.arrays.bounds import bound_points
from ...kernels.extent.mean_covariance import mean_and_covariance
from ...kernels.lang import vec3
from ...kernels.linear_algebra import det, inv, matmul
from ...kernels.memory import full
from ...kernels.meshes import mesh_edits
from ...pcd.motion import Movable
from ...pcd.units import unit_under
from .finite_corners import check_finite_corners
from .mesh_arrays import MeshArrays


class MeshMotion(MeshArrays, Movable):
    """The part of TriangleMesh that moves and paints it."""

    @returns_new
    def transform(self, transformation: Any) -> Self:
        """Move the mesh by an affine transformation.

        Args:
            transformation: A finite 4x4 matrix with last row (0, 0, 0, 1) and an inverse.

        Returns:
            The moved mesh. Normals turn with the surface (by the inverse transpose; Open3D turns them as if they were
            directions) and keep their lengths. A reflection reverses the triangles: their outside stays outside.

        Raises:
            ValueError: Another matrix.
        """
        return self._mapped("transformation", check_transformation("transformation", transformation))

    def _mapped(self, name: str, T: NDArray[np.float64]) -> Self:
        """The mesh under an affine map; errors call it by the argument that it was made of."""
        A, determinant = T[:3, :3], float(det(T[:3, :3]))
        if determinant == 0:
            raise ValueError(f"{name}: expected a matrix with an inverse, got one that flattens space")
        target = matmul(A, self._origin) + T[:3, 3]
        low, high, finite = bound_points(self._arrays["vertices"])  # sync
        low, high = (low, high) if finite else (np.zeros(3), np.zeros(3))
        origin = origin_under(name, A, target, low, high, target)
        arrays: dict[str, Any] = {"vertices": transform_points(self._arrays["vertices"], A, target - origin)}
        if "vertex_normals" in self._arrays and not np.array_equal(A, np.eye(3)):
            arrays["vertex_normals"] = transform_directions(self._arrays["vertex_normals"], inv(A).T)
        if determinant < 0:
            arrays["triangles"] = mesh_edits.flip_triangles(self._arrays["triangles"])
            if "triangle_uvs" in self._arrays:
                arrays["triangle_uvs"] = mesh_edits.flip_corners(self._arrays["triangle_uvs"])
        mesh = self._with_arrays(origin=origin, **arrays)
        mesh._unit, mesh._up = unit_under(self._unit, A), up_under(self._up, A)
        return mesh

    def _enlarged(self, factor: float) -> Self:
        vertices = transform_points(self._arrays["vertices"], factor * np.eye(3), np.zeros(3))
        return self._with_arrays(origin=self._origin * factor, vertices=vertices)

    def get_center(self) -> NDArray[np.float64]:
        """The mean of the finite vertices [m], shape [3]; zeros where there is none.

        Raises:
            ValueError: A triangle has a corner that is not finite.
        """
        check_finite_corners("get_center", self)
        return self._finite_center()

    def _finite_center(self) -> NDArray[np.float64]:
        count, mean, _ = mean_and_covariance(self._arrays["vertices"])
        return mean + self._origin if count else np.zeros(3)

    @returns_new
    def paint_uniform_color(self, color: ArrayLike) -> Self:
        """The mesh with one colour for all vertices.

        Args:
            color: Red, green and blue, 0..1; Open3D clips what lies outside, here it is an error.

        Raises:
            ValueError: Not three numbers, or outside 0..1.

        Example:
            >>> import pointloom as loom
            >>> loom.TriangleMesh.create_plane().paint_uniform_color([1, 0.5, 0]).vertex_colors[0].tolist()
            [1.0, 0.5, 0.0]
        """
        rgb = check_color("color", color)
        colors = full(self._arrays["vertices"].size, vec3(*rgb.tolist()), vec3, self.device)
        return self._with_arrays(vertex_colors=colors)
