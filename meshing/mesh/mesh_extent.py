"""How far meshes reach: boxes around them and their convex hulls; parts of them by Open3D's names."""

from __future__ import annotations

from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.dropped_results import returns_new
from ...kernels.surface.orientation import normalize_vectors
from ...pcd.boxes import OrientedBoundingBox
from ...pcd.cloud import PointCloud
from .mesh_measures import MeshMeasures
from .mesh_selection import MeshSelection


class MeshExtent(MeshMeasures, MeshSelection):
    """The part of TriangleMesh that bounds it."""

    def get_oriented_bounding_box(self, robust: bool = False) -> OrientedBoundingBox:
        """The box along the principal axes of the convex hull's vertices, as `PointCloud.get_oriented_bounding_box`.

        Raises:
            ValueError: No vertex is finite.

        Example:
            >>> import pointloom as loom
            >>> loom.TriangleMesh.create_box(4, 2, 1).get_oriented_bounding_box().extent.round(6).tolist()
            [4.0, 2.0, 1.0]
        """
        return self._corner_cloud().get_oriented_bounding_box(robust)

    def get_minimal_oriented_bounding_box(self, robust: bool = False) -> OrientedBoundingBox:
        """The box of least volume around the vertices, as `PointCloud.get_minimal_oriented_bounding_box`.

        Raises:
            ValueError: No vertex is finite.

        Example:
            >>> import pointloom as loom
            >>> turned = loom.TriangleMesh.create_box(4, 2, 1).rotate([[0.6, -0.8, 0], [0.8, 0.6, 0], [0, 0, 1]])
            >>> round(turned.get_minimal_oriented_bounding_box().volume(), 5)
            8.0
        """
        return self._corner_cloud().get_minimal_oriented_bounding_box(robust)

    @returns_new
    def compute_convex_hull(self, joggle_inputs: bool = False) -> tuple[Self, NDArray[np.int64]]:
        """The convex hull of the finite vertices, as `PointCloud.compute_convex_hull`.

        Args:
            joggle_inputs: Let Qhull move its input by some 1e-11 of its size instead of merging facets.

        Returns:
            The hull as a mesh, and the index of the mesh's vertex at each of its vertices, ascending, int64 [m].

        Raises:
            ValueError: No vertex is finite, or all lie on one line.

        Example:
            >>> import pointloom as loom
            >>> hull, indices = loom.TriangleMesh.create_torus(2, 1).compute_convex_hull()
            >>> hull.is_watertight(), len(indices) == len(hull.vertices)
            (True, True)
        """
        hull, indices = self._corner_cloud().compute_convex_hull(joggle_inputs)
        make: Any = type(self)  # TriangleMesh
        mesh = make(hull.vertices, hull.triangles, device=self._device, origin=self._origin)
        mesh._library = self._library
        return mesh, indices

    @returns_new
    def normalize_normals(self) -> Self:
        """The mesh with vertex normals of unit length; zero ones stay zero.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> mesh = loom.TriangleMesh(np.eye(3), [[0, 1, 2]], vertex_normals=2 * np.eye(3))
            >>> mesh.normalize_normals().vertex_normals.tolist() == np.eye(3).tolist()
            True
        """
        if "vertex_normals" not in self._arrays:
            return self.copy()
        return self._with_arrays(vertex_normals=normalize_vectors(self._arrays["vertex_normals"]))

    @returns_new
    def select_faces_by_mask(self, mask: ArrayLike) -> Self:
        """The triangles where a mask is set, with the vertices that they use.

        Args:
            mask: Booleans of shape [t].

        Raises:
            ValueError: Not booleans, or another shape.

        Example:
            >>> import pointloom as loom
            >>> box = loom.TriangleMesh.create_box()
            >>> box.select_faces_by_mask(box.compute_triangle_normals()[:, 2] > 0.5)
            TriangleMesh(4 vertices, 2 triangles, cpu)
        """
        rows = self._left_by(mask, len(self), "triangles")
        return self._without(rows).remove_unreferenced_vertices()

    def _corner_cloud(self) -> PointCloud:
        """The vertices as a cloud over the same memory."""
        return PointCloud._from_device_arrays({"points": self._arrays["vertices"]}, self._origin, self._library)
