"""Topology and repair of a mesh: edges, boundaries, orientation, holes, intersections, boolean operations."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Any, NamedTuple, Self

import numpy as np
from numpy.typing import NDArray

from ...core.array_libraries import view_as
from ...core.checks import check_positive
from ...core.devices import check_same_device
from ...core.dropped_results import returns_new
from ...core.units import common_unit
from ...kernels.array_types import Mask
from ...kernels.arrays.concatenation import concatenate_points
from ...kernels.arrays.row_numbers import pair_up
from ...kernels.arrays.select import gather_rows, positions_of, positions_of_each
from ...kernels.arrays.sort import positions
from ...kernels.lang import int32
from ...kernels.memory import download
from ...kernels.meshes import clean_triangles, mesh_edges, orientation
from ...kernels.meshes.boundary_loops import Border, find_loops
from ...kernels.meshes.corner_vertices import split_fans
from ...kernels.meshes.holes import Filling, spread_corners, spread_ids
from ...kernels.meshes.mesh_components import holds_marked
from ...kernels.meshes.mesh_edges import find_split_vertices, mask_counts
from ...kernels.meshes.mesh_edits import count_referenced, count_unlike, shift_triangles
from ...kernels.meshes.orientation import Orientation, flip_some, flip_some_corners
from ...kernels.meshes.surface_samples import triangle_areas
from ...kernels.meshes.vertex_neighbors import VertexNeighbors
from ...kernels.rays.cutting_triangles import find_meeting_pairs
from ...kernels.rays.triangle_tree import TriangleTree
from .finite_corners import REMEDY, check_finite_corners, find_wrong_corner
from .flat_polygons import LIBRARY, load_manifold
from .mesh_arrays import MeshArrays, check_mesh
from .mesh_measures import MeshMeasures
from .mesh_nesting import Parts, choose_sides, find_enclosing
from .mesh_sheets import cut_and_stitch

if TYPE_CHECKING:
    from .mesh import TriangleMesh

MOST = 2**31 - 1
MANIFOLD = 2  # triangles that an edge of a closed surface has
ROUNDING = 1e-9  # of sums of areas


class EdgeCounts(NamedTuple):
    """How many edges a mesh has, how many of them belong to one triangle, and how many to more than two."""

    all: int
    boundary: int
    crowded: int


@dataclass(frozen=True)
class MeshRepairReport:
    """What `repair` did to a mesh, and what is still wrong with it.

    Attributes:
        removed_non_finite_triangles: Triangles with a corner that was not finite.
        merged_vertices: Vertices that became one with another.
        removed_degenerate_triangles: Triangles that named a vertex twice.
        removed_duplicated_triangles: Triangles that were another one, or its other side.
        removed_crowding_triangles: Triangles for which there was no partner at an edge of more than two.
        split_vertices: Vertices added where sheets or fans of triangles came apart.
        flipped_triangles: Triangles wound the other way.
        filled_holes: Holes closed.
        added_triangles: Triangles that close them, and those made of one where a surface touches itself along an edge.
        removed_vertices: Vertices that no triangle used at the end.
        lost_area: Area that went with triangles which were no copies [m^2].
        is_watertight: Whether the mesh is closed now, as of `TriangleMesh.is_watertight`.
        is_orientable: Whether neighbours turn alike now.
        boundary_edges: Edges of one triangle that are left.
        holes_left: Holes of up to `hole_size` that are left; None where none were to be filled.
        non_manifold_vertices: Vertices whose triangles hang together by the vertex alone.
        zero_area_triangles: Triangles without area; without them a closed mesh would have holes.

    Example:
        >>> import pointloom as loom
        >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2], [1, 2, 0], [2, 2, 0]])
        >>> _, report = mesh.repair()
        >>> report.removed_degenerate_triangles, report.removed_duplicated_triangles, report.is_watertight
        (1, 1, False)
    """

    removed_non_finite_triangles: int
    merged_vertices: int
    removed_degenerate_triangles: int
    removed_duplicated_triangles: int
    removed_crowding_triangles: int
    split_vertices: int
    flipped_triangles: int
    filled_holes: int
    added_triangles: int
    removed_vertices: int
    lost_area: float
    is_watertight: bool
    is_orientable: bool
    boundary_edges: int
    holes_left: int | None
    non_manifold_vertices: int
    zero_area_triangles: int


class MeshRepair(MeshMeasures):
    """The part of TriangleMesh that examines its topology, repairs it and combines it with other meshes.

    Intersections: triangles include their edges and corners, so triangles that touch intersect. The decision is exact
    for the stored float32 coordinates, whatever their size: float64 with an error bound, and integers where the bound
    leaves it open. Open3D reports triangles that are apart in one plane (#5117, #5525) and misses some that touch.
    Triangles without area count as edges. Lists of triangles omit those with a corner that is not finite;
    `is_self_intersecting` and `is_intersecting` raise ValueError for them.
    """

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

    @returns_new
    def fill_holes(self, hole_size: float = 1e6) -> Self:
        """Close the holes of the mesh by triangles between the vertices of their borders.

        Each loop of `get_boundaries` is taken for a hole, the rim of an open surface too: give a size that tells them
        apart. The new triangles turn as those around them and make no edge of three triangles. The triangulation of a
        hole is the one that bends least, then that of the shortest sides: fit for holes that are small beside the shape
        of the surface.

        Args:
            hole_size: [m]; a hole is filled where no vertex of its border lies farther from the middle of their box.

        Returns:
            The mesh with its triangles first. Left open are holes of more than 1,000 vertices, those with a vertex that
            is not finite, those that only an edge of three triangles could close, and the border of a triangle alone.
            Normals and colours stay; new triangles take texture and material from the corners at the border. `repair`
            counts what was filled and what was left.

        Raises:
            ValueError: No finite number above 0.

        Notes:
            Open3D goes through VTK, whose triangles may turn against those around them. O(n^3) time and 44 n^2 B of
            memory for a hole of n vertices, about 130 B a triangle of the mesh. New triangles may cut through others.
            Same bits from run to run and on every device. Barequet and Sharir 1995; Liepa 2003, section 3.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
            >>> mesh = loom.TriangleMesh(corners, [[0, 2, 1], [0, 1, 3], [0, 3, 2]])
            >>> mesh.fill_holes().triangles[3].tolist(), mesh.fill_holes().is_watertight()
            ([2, 3, 1], True)
        """
        return self._fill(check_positive("hole_size", hole_size))[0]

    @returns_new
    def repair(
        self, *, merge_distance: float | None = None, hole_size: float | None = None
    ) -> tuple[Self, MeshRepairReport]:
        """Mend what is commonly wrong with a mesh, and say what was done and what is still wrong.

        In this order: triangles with a corner that is not finite or that name a vertex twice go, and vertices that no
        triangle uses; borders that lie on each other are sewn up; edges of more than two triangles are split into
        sheets by angle, and vertices of several fans into one each; what is there twice goes, such as the second side
        of a surface, and single triangles for which no partner is left at an edge of more than two; the others are
        wound as most of their part are; holes are closed; closed parts are turned by what they lie within.

        What is right stays as it is. A closed part that is wound alike is joined to nothing that it touches. Parts
        within others stay the hollows or the solids that they were, those within none look outwards, and those that
        were wound both ways look outwards or inwards by how many lie around them.

        Args:
            merge_distance: [m]; vertices closer than this become one, as of `merge_close_vertices`; None for those at
                the same position.
            hole_size: [m]; holes of up to this radius are closed, as of `fill_holes`; None for none of them.

        Returns:
            (mesh, report): a mesh with `is_edge_manifold()` and `is_vertex_manifold()`, closed where it was, and a
            MeshRepairReport. Texture, normals and colours stay.

        Raises:
            ValueError: A number that is not finite and above 0.

        Notes:
            Triangles that cut through each other are neither mended nor reported. Memory is that of `fill_holes`. Same
            bits from run to run and on every device. Guéziec et al., "Cutting and stitching: converting sets of
            polygons to manifold surfaces", IEEE TVCG 7(2), 2001.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 0, 0]]
            >>> mesh = loom.TriangleMesh(corners, [[0, 1, 2], [0, 4, 3], [0, 3, 2]])
            >>> mended, report = mesh.repair(hole_size=1)
            >>> report.merged_vertices, report.filled_holes, report.is_watertight, round(mended.get_volume(), 6)
            (1, 1, True, 0.166667)
        """
        size = None if hole_size is None else check_positive("hole_size", hole_size)
        mesh = self._without(clean_triangles.mask_not_finite(self._arrays["vertices"], self._arrays["triangles"]))
        before = mesh._vertex_count
        finite = mesh if merge_distance is None else mesh._merge_close("merge_distance", merge_distance)
        found = cut_and_stitch(finite)
        mesh, orientation = found.mesh, Orientation(found.mesh._device_arrays["triangles"], found.mesh._vertex_count)
        orientation.follow_most()
        mesh, flipped = found.mesh._flipped(orientation.flips), orientation.flips
        area, filled, left = mesh.get_surface_area(), 0, None
        if size is not None:
            mesh, filled, left = mesh._fill(size)
        added = len(mesh) - flipped.size
        mesh, orientable = mesh._nested(flipped)
        report = MeshRepairReport(
            removed_non_finite_triangles=len(self) - len(finite),
            merged_vertices=found.merged + before - finite._vertex_count,
            removed_degenerate_triangles=found.degenerate,
            removed_duplicated_triangles=found.copies,
            removed_crowding_triangles=found.crowding,
            split_vertices=found.split,
            flipped_triangles=count_unlike(found.mesh._device_arrays["triangles"], mesh._device_arrays["triangles"]),
            filled_holes=filled,
            added_triangles=added + found.halved,
            removed_vertices=found.unused,
            lost_area=_difference(self._finite_area(), found.copied_area + area),
            is_orientable=orientable,
            holes_left=left,
            **mesh._findings(),
        )
        return mesh, report

    @returns_new
    def split_non_manifold_vertices(self) -> Self:
        """Give each fan of triangles a vertex of its own where several hang together by the vertex alone.

        Returns:
            A mesh with `is_vertex_manifold()` where no triangle names a vertex twice. New vertices stand behind the old
            ones, with their position, normal and colour; the fan with the lowest triangle keeps the old one. Triangles,
            their texture and vertices without triangles stay. Edges stay what they are: those of more than two
            triangles are split by `repair`.

        Notes:
            About 80 B of memory a triangle. Same bits from run to run and on every device. Open3D lists these vertices
            and leaves them.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]]
            >>> mesh = loom.TriangleMesh(corners, [[0, 1, 2], [0, 3, 4]]).split_non_manifold_vertices()
            >>> mesh.triangles.tolist(), mesh.vertices[5].tolist()
            ([[0, 1, 2], [5, 3, 4]], [0.0, 0.0, 0.0])
        """
        triangles, count = self._arrays["triangles"], self._vertex_count
        split, rows = split_fans(triangles, count)
        return self._with_arrays(triangles=split, **self._vertices_at(rows))

    def _fill(self, hole_size: float) -> tuple[Self, int, int]:
        """(the mesh with its holes filled, how many were, how many of this size were not)."""
        found = Filling(self._arrays["vertices"], self._arrays["triangles"], hole_size)
        arrays: dict[str, Any] = {"triangles": found.triangles}
        if "triangle_uvs" in self._arrays:
            arrays["triangle_uvs"] = spread_corners(self._arrays["triangle_uvs"], found.corners)
        if "triangle_material_ids" in self._arrays:
            arrays["triangle_material_ids"] = spread_ids(self._arrays["triangle_material_ids"], found.corners)
        sources = spread_ids(positions(len(self), self._device), found.corners)
        arrays |= self._attributes_at("triangle_attributes", sources)
        return self._with_arrays(**arrays), found.filled, found.left

    def _flipped(self, flips: Mask) -> Self:
        """The mesh with the triangles wound the other way where a uint8 device mask is set."""
        arrays: dict[str, Any] = {"triangles": flip_some(self._arrays["triangles"], flips)}
        if "triangle_uvs" in self._arrays:
            arrays["triangle_uvs"] = flip_some_corners(self._arrays["triangle_uvs"], flips)
        return self._with_arrays(**arrays)

    def _nested(self, flipped: Mask) -> tuple[Self, bool]:
        """(the mesh with its closed parts turned by what they lie within, whether all can be wound alike).

        The first triangles are those of a mask, uint8: what was flipped belongs to parts that were not wound alike as
        they were given.
        """
        vertices, triangles = self._arrays["vertices"], self._arrays["triangles"]
        found = Orientation(triangles, vertices.size)
        measured = found.measure_parts(vertices, triangles)
        several = np.count_nonzero(measured.closed & (measured.volumes != 0)) > 1  # else no part lies within another
        labels = download(measured.labels) if several else np.empty(0, np.int64)  # sync
        parts = Parts(labels, measured.closed, measured.volumes)
        kept = ~holds_marked(measured.labels, flipped, len(measured.closed))  # sync
        found.turn_parts(measured.labels, choose_sides(parts, find_enclosing(vertices, triangles, parts), kept))
        return self._flipped(found.flips), found.orientable

    def _findings(self) -> dict[str, Any]:
        """What may still be wrong, as MeshRepairReport names it."""
        vertices, triangles = self._arrays["vertices"], self._arrays["triangles"]
        boundary, split, empty = positions_of_each(  # sync
            mask_counts(self._edges(padded=True), 1, 1),
            find_split_vertices(triangles, vertices.size),
            clean_triangles.mask_degenerate(vertices, triangles, zero_area=True),
        )
        return {
            "is_watertight": self.is_watertight(),  # sync
            "boundary_edges": boundary.size,
            "non_manifold_vertices": split.size,
            "zero_area_triangles": empty.size,
        }

    def is_self_intersecting(self) -> bool:
        """Whether any two triangles without a common vertex have a point in common.

        Raises:
            ValueError: A triangle has a corner that is not finite.

        Notes:
            As of `get_self_intersecting_triangles`.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [2, 0, 0], [0, 2, 0], [0.5, 0.5, -1], [0.5, 0.5, 1], [3, 3, 1]]
            >>> loom.TriangleMesh(corners, [[0, 1, 2], [3, 4, 5]]).is_self_intersecting()
            True
        """
        check_finite_corners("is_self_intersecting", self)
        return len(self.get_self_intersecting_triangles()) > 0

    def get_self_intersecting_triangles(self) -> NDArray[np.int32]:
        """The pairs of triangles without a common vertex that have a point in common.

        Returns:
            int32 [k, 2], the lower number first, ascending. Vertices at one place with two numbers are two vertices,
            so in a soup of triangles all neighbours meet; as in Open3D.

        Raises:
            ValueError: 2^31 pairs or more.

        Notes:
            O(n log n) time for a surface, O(n + k) memory; Open3D tests all pairs. Same bits from run to run and on
            every device. Guigue and Devillers 2003; Shewchuk 1997 for the bounds.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [2, 0, 0], [0, 2, 0], [0.5, 0.5, -1], [0.5, 0.5, 1], [3, 3, 1]]
            >>> loom.TriangleMesh(corners, [[0, 1, 2], [3, 4, 5]]).get_self_intersecting_triangles().tolist()
            [[0, 1]]
        """
        vertices, triangles = self._arrays["vertices"], self._arrays["triangles"]
        tree = TriangleTree(vertices, triangles)
        first, second = find_meeting_pairs(tree, vertices, triangles, triangles, within=True)
        return self._handed_out(pair_up(first, second))

    def is_intersecting(self, other: TriangleMesh) -> bool:
        """Whether a triangle of this mesh and one of another have a point in common.

        Where one mesh lies inside the other, the surfaces have none: see `RaycastingScene.compute_occupancy`.

        Args:
            other: Another mesh on the same device; where its `origin` is another one, its vertices are rounded to
                float32 about this one's.

        Raises:
            TypeError: No mesh.
            DeviceError: The meshes are on different devices.
            ValueError: 2^31 pairs of triangles or more, or a triangle with a corner that is not finite.

        Example:
            >>> import pointloom as loom
            >>> floor = loom.TriangleMesh([[0, 0, 0], [2, 0, 0], [0, 2, 0]], [[0, 1, 2]])
            >>> wall = loom.TriangleMesh([[0.5, 0.5, -1], [0.5, 0.5, 1], [3, 3, 1]], [[0, 1, 2]])
            >>> floor.is_intersecting(wall)
            True
        """
        check_mesh("other", other)
        check_same_device("other", self._device, other.device)
        check_finite_corners("is_intersecting", self)
        check_finite_corners("is_intersecting: other", other)
        if not len(self) or not len(other):
            return False
        own = self._arrays["vertices"]
        shifts = [np.zeros(3), other.origin - self._origin]
        vertices = concatenate_points([own, other._device_arrays["vertices"]], shifts)
        theirs = shift_triangles(other._device_arrays["triangles"], own.size)
        tree = TriangleTree(vertices, theirs)
        return find_meeting_pairs(tree, vertices, self._arrays["triangles"], theirs, within=False)[0].size > 0

    @returns_new
    def boolean_union(self, mesh: Self) -> Self:
        """The solid that two closed meshes fill together.

        Computed on the host, whatever the device: by the package manifold3d, which `pip install "pointloom[mesh]"`
        brings. Open3D goes through VTK and takes a tolerance; here there is none to choose.

        Args:
            mesh: A closed mesh on any device, whose triangles look outwards, as must those of this one.

        Returns:
            The surface of the solid, on the device of this mesh, relative to its origin. Colours of vertices go along
            where both meshes have them, on the cut between those of its triangle's corners; normals are made anew where
            both have them; texture is left behind. An empty mesh where nothing is left.

        Raises:
            ValueError: A mesh that is not closed, or whose triangles turn different ways or inwards.
            TypeError: No mesh.
            ImportError: manifold3d is not installed.

        Notes:
            The cut is made in float64 and rounded once to float32. The same bits from run to run are manifold's promise
            and not ours.

        Example:
            >>> import pointloom as loom
            >>> import numpy as np
            >>> corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
            >>> sides = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
            >>> solid, other = loom.TriangleMesh(corners, sides), loom.TriangleMesh(corners + [0.2, 0, 0], sides)
            >>> both = solid.boolean_union(other)
            >>> both.is_watertight(), 1 / 6 < both.get_volume() < 1 / 3
            (True, True)
        """
        return self._combine(mesh, "boolean_union", lambda a, b: a + b)

    @returns_new
    def boolean_difference(self, mesh: Self) -> Self:
        """The solid that this closed mesh fills and another does not; all else as `boolean_union`.

        Args:
            mesh: What is taken away.

        Raises:
            ValueError: A mesh that is not closed, or whose triangles turn different ways or inwards.
            TypeError: No mesh.
            ImportError: manifold3d is not installed.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> corners = np.array([[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2]])
            >>> sides = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
            >>> solid, corner = loom.TriangleMesh(corners, sides), loom.TriangleMesh(corners / 2 - 0.1, sides)
            >>> solid.boolean_difference(corner).get_volume() < solid.get_volume()
            True
        """
        return self._combine(mesh, "boolean_difference", lambda a, b: a - b)

    @returns_new
    def boolean_intersection(self, mesh: Self) -> Self:
        """The solid that two closed meshes both fill; all else as `boolean_union`.

        Args:
            mesh: The other one.

        Raises:
            ValueError: A mesh that is not closed, or whose triangles turn different ways or inwards.
            TypeError: No mesh.
            ImportError: manifold3d is not installed.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> corners = np.array([[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2]])
            >>> sides = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
            >>> solid, other = loom.TriangleMesh(corners, sides), loom.TriangleMesh(corners + 5, sides)
            >>> len(solid.boolean_intersection(other))
            0
        """
        return self._combine(mesh, "boolean_intersection", lambda a, b: a ^ b)

    def _combine(self, other: Self, name: str, operation: Any) -> Self:
        if not isinstance(other, MeshArrays):
            raise TypeError(f"mesh: expected a TriangleMesh, got {type(other).__name__}")
        library = load_manifold(name)
        with_colors = "vertex_colors" in self._arrays and "vertex_colors" in other._device_arrays
        solids = [
            _solid(library, mesh, self._origin, with_colors, f"{name}: {what}")
            for what, mesh in (("the mesh", self), ("mesh: it", other))
        ]
        result = operation(*solids)
        _check_status(result, name)
        vertices, triangles, colors = _arrays_of(result)
        make: Any = type(self)  # TriangleMesh
        mesh = make(
            vertices + self._origin,
            triangles,
            vertex_colors=np.clip(colors, 0, 1) if with_colors else None,
            device=self._device,
            origin=self._origin,
        )
        mesh.unit = common_unit(f"{name}: the meshes", (self.unit, other.unit))
        both_have_normals = "vertex_normals" in self._arrays and "vertex_normals" in other._device_arrays
        return mesh.compute_vertex_normals() if both_have_normals else mesh


def count_edges(mesh: MeshRepair) -> EdgeCounts:
    """How many edges a mesh has, and of which kinds."""
    edges = mesh._edges()
    boundary, crowded = (
        positions_of(mesh_edges.mask_counts(edges, *limits)).size for limits in ((1, 1), (MANIFOLD + 1, MOST))
    )
    return EdgeCounts(edges.count, boundary, crowded)


def _difference(whole: float, rest: float) -> float:
    """What is left of a sum without the rest of it; 0 where that is rounding."""
    return whole - rest if whole - rest > ROUNDING * whole else 0.0


def _solid(library: Any, mesh: Any, origin: NDArray[np.float64], with_colors: bool, what: str) -> Any:
    """A mesh as manifold holds it, relative to an origin; refused where it is no solid."""
    if len(mesh):
        if (wrong := find_wrong_corner(mesh)) is not None:
            raise ValueError(f"{what} has corners that are not finite: {wrong}; {REMEDY}")
        topology = mesh.edge_topology()
        if topology.has_boundary or topology.has_crowded_edge:
            raise ValueError(f"{what} is not closed, so it is no solid; repair(hole_size=...) closes holes")
        if topology.has_twisted_edge:
            raise ValueError(f"{what} has neighbouring triangles that turn different ways; see orient_triangles")
        if mesh._signed_volume() < 0:
            raise ValueError(f"{what} looks inwards; orient_triangles(outward=True) turns it")
    columns = [mesh.vertices - origin]
    if with_colors:
        columns.append(mesh.vertex_colors)
    properties = np.ascontiguousarray(np.column_stack(columns), np.float64)
    solid = library.Manifold(library.Mesh64(properties, np.ascontiguousarray(mesh.triangles, np.uint64)))
    _check_status(solid, what)
    return solid


def _check_status(solid: Any, what: str) -> None:
    status = solid.status()
    if status.name != "NoError":
        raise ValueError(f"{what} is no solid to {LIBRARY}: {status.name}")


def _arrays_of(solid: Any) -> tuple[NDArray[np.float64], NDArray[np.int64], NDArray[np.float64]]:
    """(positions [m, 3], triangles [t, 3], further columns): vertices that differ in the latter alone become one."""
    mesh = solid.to_mesh64()
    properties = np.asarray(mesh.vert_properties)
    target = np.arange(len(properties))
    target[np.asarray(mesh.merge_from_vert, np.int64)] = np.asarray(mesh.merge_to_vert, np.int64)
    kept, triangles = np.unique(target[np.asarray(mesh.tri_verts, np.int64)], return_inverse=True)
    return properties[kept, :3], triangles.reshape(-1, 3), properties[kept, 3:]
