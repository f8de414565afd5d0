"""How a mesh hangs together: its edges, neighbours and borders, whether it is a surface, and which way it turns."""

from __future__ import annotations

from itertools import pairwise
from typing import Any, NamedTuple, Self

import numpy as np
from numpy.typing import NDArray

from ...core.array_libraries import view_as
from ...core.dropped_results import returns_new
from ...kernels.array_types import Mask
from ...kernels.arrays.select import gather_rows, positions_of
from ...kernels.lang import int32
from ...kernels.memory import download
from ...kernels.meshes import mesh_edges, orientation
from ...kernels.meshes.boundary_loops import Border, find_loops
from ...kernels.meshes.mesh_edits import count_referenced
from ...kernels.meshes.surface_samples import triangle_areas
from ...kernels.meshes.vertex_neighbors import VertexNeighbors
from .finite_corners import check_finite_corners
from .mesh_measures import MeshMeasures

MOST = 2**31 - 1
MANIFOLD = 2  # triangles that an edge of a closed surface has


class EdgeCounts(NamedTuple):
    """How many edges a mesh has, how many of them belong to one triangle, and how many to more than two."""

    all: int
    boundary: int
    crowded: int


class MeshTopology(MeshMeasures):
    """The part of TriangleMesh that answers questions about its edges and fans."""

    def get_non_manifold_edges(self, allow_boundary_edges: bool = True) -> NDArray[np.int32]:
        """The edges that more than two triangles have.

        Args:
            allow_boundary_edges: Whether edges of one triangle count as manifold; else they are listed as well.

        Returns:
            Two vertex numbers an edge, the lower one first, in ascending order; shape [k, 2]. Open3D's order is that of
            a hash table. A triangle that names a vertex twice has an edge from that vertex to itself.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [0, 0, 1], [1, 0, 0], [-1, 0, 0], [0, 1, 0]]
            >>> mesh = loom.TriangleMesh(corners, [[0, 1, 2], [0, 1, 3], [0, 1, 4]])
            >>> mesh.get_non_manifold_edges().tolist(), len(mesh.get_non_manifold_edges(False))
            ([[0, 1]], 7)
        """
        edges = self._edges()
        found = mesh_edges.mask_counts(edges, MANIFOLD + 1, MOST)
        if not allow_boundary_edges:
            found = mesh_edges.mask_other_counts(edges, MANIFOLD)
        return self._ends(edges, found)

    def get_boundary_edges(self) -> NDArray[np.int32]:
        """The edges that one triangle has alone: two vertex numbers each, the lower one first, ascending; shape [k, 2].

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [2, 1, 3]])
            >>> mesh.get_boundary_edges().tolist()
            [[0, 1], [0, 2], [1, 3], [2, 3]]
        """
        edges = self._edges(padded=True)
        return self._ends(edges, mesh_edges.mask_counts(edges, 1, 1))

    def get_boundaries(self) -> list[NDArray[np.int32]]:
        """The loops that the border of the mesh forms, as lists of vertices.

        Returns:
            One int32 array a loop, in the direction of the triangles there: around a hole clockwise seen from outside.
            A loop passes no vertex twice and begins with its lowest one; loops come in the order of these. Where the
            border leads to an edge of three triangles or more, or to two triangles that turn different ways, it is no
            loop and left out: see `remove_non_manifold_edges`, `orient_triangles`. Open3D has it in
            HalfEdgeTriangleMesh, which takes none of these meshes.

        Notes:
            About 130 B of memory a triangle. Same bits from run to run and on every device.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [2, 1, 3]])
            >>> [loop.tolist() for loop in mesh.get_boundaries()]
            [[0, 1, 3, 2]]
        """
        border = Border(self._arrays["triangles"], self._arrays["vertices"].size)
        rows, loops, starts = find_loops(border)  # sync
        if not loops.count:
            return []
        vertices, ends = self._handed_out(gather_rows(border.vertices, rows)), starts.tolist()
        return [vertices[first:end] for first, end in pairwise(ends)]

    def get_non_manifold_vertices(self) -> NDArray[np.int32]:
        """The vertices whose triangles hang together by the vertex alone, and not by edges at it; ascending.

        Vertices without triangles are none. Triangles that name a vertex twice do not count at it.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]]
            >>> loom.TriangleMesh(corners, [[0, 1, 2], [0, 3, 4]]).get_non_manifold_vertices().tolist()
            [0]
        """
        mask = mesh_edges.find_split_vertices(self._arrays["triangles"], self._arrays["vertices"].size)
        return self._handed_out(positions_of(mask))

    def is_vertex_manifold(self) -> bool:
        """Whether the triangles at each vertex hang together by edges at it; see `get_non_manifold_vertices`.

        Raises:
            ValueError: A triangle has a corner that is not finite.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]]
            >>> loom.TriangleMesh(corners, [[0, 1, 2], [0, 3, 4]]).is_vertex_manifold()
            False
        """
        check_finite_corners("is_vertex_manifold", self)
        return len(self.get_non_manifold_vertices()) == 0

    def is_orientable(self) -> bool:
        """Whether all triangles can be wound so that neighbours turn alike: not so on a Möbius strip or a Klein bottle.

        Edges of three triangles or more ask for nothing here; Open3D's answer for them depends on a hash table. Whether
        the triangles are wound so already is another question: `orient_triangles` does it.

        Raises:
            ValueError: A triangle has a corner that is not finite.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [1, 2, 3]])
            >>> mesh.is_orientable()
            True
        """
        check_finite_corners("is_orientable", self)
        return orientation.Orientation(self._arrays["triangles"], self._arrays["vertices"].size).orientable

    @returns_new
    def orient_triangles(self, *, outward: bool = False) -> tuple[Self, bool]:
        """Wind triangles so that neighbours turn alike.

        Args:
            outward: Wind closed parts so that their outside is outside. Each part is taken for itself, so the wall of a
                hollow inside another part faces the solid's inside, too.

        Returns:
            (mesh, orientable). The first triangle of each part stays as it is, and decides; Open3D begins where a hash
            table does. Parts that cannot be oriented stay as they are, and `orientable` is False. Parts hang together
            by edges of two triangles; edges of more ask for nothing. Texture stays at its corners. Normals of vertices
            stay, too: `compute_vertex_normals` makes them anew.

        Notes:
            About 50 B of memory a half-edge. Same bits from run to run and on every device.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [1, 2, 3]])
            >>> oriented, orientable = mesh.orient_triangles()
            >>> oriented.triangles.tolist(), orientable
            ([[0, 1, 2], [1, 3, 2]], True)
        """
        found = orientation.Orientation(self._arrays["triangles"], self._arrays["vertices"].size)
        if outward:
            found.face_outwards(self._arrays["vertices"], self._arrays["triangles"])
        arrays: dict[str, Any] = {"triangles": orientation.flip_some(self._arrays["triangles"], found.flips)}
        if "triangle_uvs" in self._arrays:
            arrays["triangle_uvs"] = orientation.flip_some_corners(self._arrays["triangle_uvs"], found.flips)
        return self._with_arrays(**arrays), found.orientable

    def euler_poincare_characteristic(self) -> int:
        """Vertices less edges plus triangles: 2 for a closed surface without handles, 0 for a torus.

        Vertices that no triangle uses do not count; in Open3D they do, so that a stray one changes the answer.

        Raises:
            ValueError: A triangle has a corner that is not finite.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [5, 5, 5]], [[0, 1, 2]])
            >>> mesh.euler_poincare_characteristic()
            1
        """
        check_finite_corners("euler_poincare_characteristic", self)
        used = count_referenced(self._arrays["triangles"], self._arrays["vertices"].size)
        return used - self._edges().count + len(self)

    def compute_adjacency_list(self) -> tuple[NDArray[np.int32], NDArray[np.int32]]:
        """The vertices that an edge joins to each vertex.

        Returns:
            (starts, neighbors): `neighbors[starts[v] : starts[v + 1]]` are those of vertex v, ascending; int32 [m + 1]
            and [k]. No vertex is its own neighbour. Open3D keeps sets in `mesh.adjacency_list`.

        Notes:
            About 50 B of memory a half-edge. Same bits from run to run and on every device.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [2, 1, 3]])
            >>> starts, neighbors = mesh.compute_adjacency_list()
            >>> neighbors[starts[0] : starts[1]].tolist(), neighbors[starts[1] : starts[2]].tolist()
            ([1, 2], [0, 2, 3])
        """
        count = self._arrays["vertices"].size
        found = VertexNeighbors(mesh_edges.MeshEdges(self._arrays["triangles"], count), count)
        used = int(download(found.starts[count:])[0])  # sync
        return self._handed_out(found.starts), self._handed_out(view_as(found.vertices, int32, (used,)))

    def compute_triangle_areas(self) -> NDArray[np.float64]:
        """The area [m^2] of each triangle, shape [t]; NaN for those with a corner that is not finite.

        Open3D's tensor mesh stores them; here they are returned.

        Example:
            >>> import pointloom as loom
            >>> loom.TriangleMesh([[0, 0, 0], [2, 0, 0], [0, 1, 0]], [[0, 1, 2]]).compute_triangle_areas().tolist()
            [1.0]
        """
        return self._handed_out(triangle_areas(self._arrays["vertices"], self._arrays["triangles"]))

    def _edges(self, padded: bool = False) -> mesh_edges.UniqueKeys:
        return mesh_edges.find_edges(self._arrays["triangles"], self._arrays["vertices"].size, padded)

    def _ends(self, edges: mesh_edges.UniqueKeys, mask: Mask) -> NDArray[np.int32]:
        ends = mesh_edges.edge_ends(edges, positions_of(mask), self._arrays["vertices"].size)
        return self._handed_out(ends)


def count_edges(mesh: MeshTopology) -> EdgeCounts:
    """How many edges a mesh has, and of which kinds."""
    edges = mesh._edges()
    boundary, crowded = (
        positions_of(mesh_edges.mask_counts(edges, *limits)).size for limits in ((1, 1), (MANIFOLD + 1, MOST))
    )
    return EdgeCounts(edges.count, boundary, crowded)
