"""What is asked of a mesh: normals, area, volume, its box, and whether it is a closed surface."""

from __future__ import annotations

from typing import Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_rows
from ...core.dropped_results import returns_new
from ...kernels.arrays.bounds import bound_points
from ...kernels.memory import download
from ...kernels.meshes import mesh_measures
from ...kernels.meshes.mesh_topology import Topology, examine
from ...pcd.boxes import AxisAlignedBoundingBox
from ...pcd.point_arrays import read_only
from .finite_corners import check_finite_corners
from .mesh_arrays import MeshArrays

SAME_NORMAL = 1e-3  # what rounding makes of float32 normals


class MeshMeasures(MeshArrays):
    """The part of TriangleMesh that measures it."""

    @returns_new
    def compute_vertex_normals(self) -> Self:
        """Set the normal of each vertex to the mean of the triangles around it, weighted by their areas.

        Returns:
            The mesh with unit normals [m, 3]; (0, 0, 1) at vertices without area around them (Open3D: zero), and NaN at
            vertices that are not finite, whose triangles count nowhere.

        Notes:
            O(m + t) memory. Sums run in float64 by ascending triangle: the same bits from run to run.
        """
        vertices, triangles = self._arrays["vertices"], self._arrays["triangles"]
        return self._with_arrays(vertex_normals=mesh_measures.vertex_normals(vertices, triangles))

    def compute_triangle_normals(self) -> NDArray[np.float32]:
        """The unit normals of the triangles by the right-hand rule, shape [t, 3].

        They are (0, 0, 1) for triangles without area, and NaN for those with a corner that is not finite.

        Open3D stores them in its mesh; here they are returned.
        """
        normals = mesh_measures.triangle_normals(self._arrays["vertices"], self._arrays["triangles"])
        return download(normals).reshape(-1, 3)

    @property
    def triangle_normals(self) -> NDArray[np.float32]:
        """The unit normals of the triangles, as `compute_triangle_normals` gives them: those of the triangles always.

        Assigning takes what they are, for code that copies them from mesh to mesh, and nothing else.
        """
        return read_only(self.compute_triangle_normals().copy())

    @triangle_normals.setter
    def triangle_normals(self, values: ArrayLike) -> None:
        given = check_rows("triangle_normals", values, 3, rows=len(self), dtype=np.float64)
        if not np.allclose(given, self.compute_triangle_normals(), rtol=0, atol=SAME_NORMAL, equal_nan=True):
            raise ValueError(
                "triangle_normals: these are not the triangles' own, which no mesh keeps apart from its triangles; "
                "orient_triangles() turns triangles, vertex_normals shade"
            )

    def get_surface_area(self) -> float:
        """The area [m^2] of all triangles.

        Raises:
            ValueError: A triangle has a corner that is not finite.
        """
        check_finite_corners("get_surface_area", self)
        return self._finite_area()

    def get_volume(self) -> float:
        """The volume [m^3] that a closed mesh encloses; 0 where there are no triangles.

        It is closed where each edge belongs to exactly two triangles; parts may touch at vertices.

        Of several parts the volumes are added, of those that look inwards subtracted: a hollow counts as one where its
        wall looks into it, and parts beside each other should all look outwards (`orient_triangles(outward=True)`).

        Raises:
            ValueError: A triangle has a corner that is not finite, the mesh is not watertight, or neighboring triangles
                do not turn the same way. Open3D answers for the latter, too: 0.667 for a unit box with one triangle
                flipped.
        """
        check_finite_corners("get_volume", self)
        topology = self.edge_topology()
        if not is_closed(topology):
            raise ValueError("get_volume: the mesh is not watertight, so it encloses no volume")
        if topology.has_twisted_edge:
            raise ValueError("get_volume: neighbouring triangles turn different ways; orient them alike")
        return abs(self._signed_volume())

    def is_edge_manifold(self, allow_boundary_edges: bool = True) -> bool:
        """Whether no edge belongs to more than two triangles.

        Args:
            allow_boundary_edges: Whether edges of one triangle only are allowed.

        Raises:
            ValueError: A triangle has a corner that is not finite.
        """
        check_finite_corners("is_edge_manifold", self)
        topology = self.edge_topology()
        return not topology.has_crowded_edge and (allow_boundary_edges or not topology.has_boundary)

    def is_watertight(self) -> bool:
        """Whether each edge belongs to exactly two triangles: then the mesh has a volume.

        A mesh without triangles is not, since it encloses nothing; Open3D says that it is. Open3D's test also asks that
        the triangles at each vertex are one fan and that none cut through each other, neither of which lets water out:
        `is_vertex_manifold` and `is_self_intersecting` tell.

        Raises:
            ValueError: A triangle has a corner that is not finite.

        Example:
            >>> import pointloom as loom
            >>> box = loom.TriangleMesh.create_box()
            >>> box.is_watertight(), loom.TriangleMesh(box.vertices, box.triangles[1:]).is_watertight()
            (True, False)
        """
        check_finite_corners("is_watertight", self)
        return self._is_closed()

    def _is_closed(self) -> bool:
        """True if there are triangles and each edge has two of them; corners need not be finite."""
        return len(self) > 0 and is_closed(self.edge_topology())

    def _finite_area(self) -> float:
        """The area [m^2] of the triangles whose corners are finite."""
        return mesh_measures.measure(self._arrays["vertices"], self._arrays["triangles"])[0]

    def _signed_volume(self) -> float:
        return mesh_measures.measure(self._arrays["vertices"], self._arrays["triangles"])[1]

    def edge_topology(self) -> Topology:
        """How triangles meet at edges, counted on the device: what `is_watertight` and its kin are told from."""
        return examine(self._arrays["triangles"], self._arrays["vertices"].size)

    def get_axis_aligned_bounding_box(self) -> AxisAlignedBoundingBox:
        """The smallest aligned box around the finite vertices; at zero if none are. `low, high = box` unpacks it."""
        low, high, count = bound_points(self._arrays["vertices"])
        if not count:
            return AxisAlignedBoundingBox()
        return AxisAlignedBoundingBox(low.astype(np.float64) + self._origin, high.astype(np.float64) + self._origin)

    def get_min_bound(self) -> NDArray[np.float64]:
        """The lowest coordinates of the finite vertices [m], shape [3]; zeros where there is none."""
        return self.get_axis_aligned_bounding_box().min_bound

    def get_max_bound(self) -> NDArray[np.float64]:
        """The highest coordinates of the finite vertices [m], shape [3]; zeros where there is none."""
        return self.get_axis_aligned_bounding_box().max_bound


def is_closed(topology: Topology) -> bool:
    """Whether each edge has two triangles."""
    return not (topology.has_boundary or topology.has_crowded_edge)
