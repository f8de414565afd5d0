"""What is asked of a mesh: normals, area, volume, its box, and whether it is a closed surface."""

from __future__ import annotations

from typing import Self

import numpy as np
from numpy.typing import NDArray

from ...core.dropped_results import returns_new
from ...kernels.arrays.bounds import bound_points
from ...kernels.memory import download
from ...kernels.meshes import mesh_measures
from ...kernels.meshes.mesh_topology import Topology, examine
from ...pcd.boxes import AxisAlignedBoundingBox
from .mesh_arrays import MeshArrays


class MeshMeasures(MeshArrays):
    """The part of TriangleMesh that measures it."""

    @returns_new
    def compute_vertex_normals(self) -> Self:
        """Set the normal of each vertex to the mean of the triangles around it, weighted by their areas.

        Returns:
            The mesh with unit normals [m, 3]; (0, 0, 1) at vertices without area around them, as Open3D has it, and NaN
            at vertices that are not finite, whose triangles count nowhere.

        Notes:
            O(m + t) memory. Sums run in float64 by ascending triangle: the same bits from run to run.
        """
        vertices, triangles = self._arrays["vertices"], self._arrays["triangles"]
        return self.with_arrays(vertex_normals=mesh_measures.vertex_normals(vertices, triangles))

    def compute_triangle_normals(self) -> NDArray[np.float32]:
        """The unit normals of the triangles by the right-hand rule, shape [t, 3]; (0, 0, 1) for those without area.

        Open3D stores them in its mesh; here they are returned.
        """
        normals = mesh_measures.triangle_normals(self._arrays["vertices"], self._arrays["triangles"])
        return download(normals).reshape(-1, 3)

    def get_surface_area(self) -> float:
        """The area [m^2] of all triangles; those with a corner that is not finite count as none."""
        return mesh_measures.measure(self._arrays["vertices"], self._arrays["triangles"])[0]

    def get_volume(self) -> float:
        """The volume [m^3] that a closed mesh encloses; 0 where there are no triangles.

        Of several parts the volumes are added, of those that look inwards subtracted: a hollow counts as one where its
        wall looks into it, and parts beside each other should all look outwards (`orient_triangles(outward=True)`).

        Raises:
            ValueError: The mesh is not watertight, or neighbouring triangles do not turn the same way. Open3D answers
                for the latter, too: 0.667 for a unit box with one triangle flipped.
        """
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
        """
        topology = self.edge_topology()
        return not topology.has_crowded_edge and (allow_boundary_edges or not topology.has_boundary)

    def is_watertight(self) -> bool:
        """Whether each edge belongs to exactly two triangles, and the triangles at each vertex are one fan.

        A mesh without triangles is not, since it encloses nothing; Open3D says that it is. Unlike Open3D's, the test
        says nothing of triangles that cut through each other: `is_self_intersecting` does.
        """
        return len(self) > 0 and is_closed(self.edge_topology())

    def _signed_volume(self) -> float:
        return mesh_measures.measure(self._arrays["vertices"], self._arrays["triangles"])[1]

    def edge_topology(self) -> Topology:
        """How triangles meet at edges, counted on the device: what `is_watertight` and its kin are told from."""
        return examine(self._arrays["triangles"], self._arrays["vertices"].size)

    def get_axis_aligned_bounding_box(self) -> AxisAlignedBoundingBox:
        """The smallest aligned box around the finite vertices; at zero where there is none.

        It may be taken apart: `low, high = mesh.get_axis_aligned_bounding_box()`.
        """
        low, high, count = bound_points(self._arrays["vertices"])
        if not count:
            return AxisAlignedBoundingBox()
        return AxisAlignedBoundingBox(low.astype(np.float64) + self._origin, high.astype(np.float64) + self._origin)


def is_closed(topology: Topology) -> bool:
    """Whether each edge has two triangles, and the triangles at each vertex are one fan."""
    return not (topology.has_boundary or topology.has_crowded_edge or topology.has_split_vertex)
