"""Topology and repair of a mesh: edges, boundaries, orientation, holes, intersections, boolean operations."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import Any, NamedTuple, Self, TypeVar

import numpy as np
from numpy.typing import NDArray

from ...core.array_libraries import view_as
from ...core.checks import check_positive
from ...core.devices import check_same_device
from ...core.dropped_results import returns_new
from ...core.reports import AssessedRecord, failed
from ...core.wording import format_fraction
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
from ...kernels.meshes.mesh_components import has_marked
from ...kernels.meshes.mesh_edges import find_split_vertices, mask_counts
from ...kernels.meshes.mesh_edits import count_referenced, count_unlike, shift_triangles
from ...kernels.meshes.orientation import Orientation
from ...kernels.meshes.surface_samples import triangle_areas
from ...kernels.meshes.vertex_neighbors import VertexNeighbors
from ...kernels.rays.cutting_triangles import find_meeting_pairs
from ...kernels.rays.triangle_tree import TriangleTree
from ...pcd.units import common_reference
from .finite_corners import REMEDY, check_finite_corners, find_wrong_corner
from .flat_polygons import LIBRARY, load_manifold
from .mesh_arrays import MeshArrays, check_mesh
from .mesh_measures import MeshMeasures
from .mesh_nesting import Parts, choose_sides, find_enclosing
from .mesh_rows import TEXTURE
from .mesh_sheets import cut_and_stitch, find_flips, flipped_mesh
from .surface_values import with_attributes_of

Mesh = TypeVar("Mesh", bound="MeshRepair")

MAX_INT32 = 2**31 - 1
TRIANGLES_PER_EDGE = 2  # triangles per edge of a closed surface
AREA_ROUNDING = 1e-9  # relative, of area sums
MAX_LOST = 0.01  # fraction of the area, without copies, above which parts of the surface may be missing


class EdgeCounts(NamedTuple):
    """Number of edges: all, of one triangle, of more than two triangles."""

    all: int
    boundary: int
    crowded: int


@dataclass(frozen=True)
class MeshRepairReport(AssessedRecord):
    """Counts of the changes that `repair` made, and the remaining defects.

    Attributes:
        removed_non_finite_triangles: Triangles with a corner that was not finite.
        merged_vertices: Vertices merged into another one.
        removed_degenerate_triangles: Triangles with a repeated vertex.
        removed_duplicated_triangles: Copies of another triangle, in either orientation.
        removed_crowding_triangles: Triangles without a partner at an edge of more than two triangles.
        split_vertices: Vertices added where sheets or fans of triangles were separated.
        flipped_triangles: Triangles with reversed orientation.
        filled_holes, added_triangles: Closed holes. Triangles that fill them or come from splitting at contacts.
        removed_vertices: Vertices that no triangle used at the end.
        lost_area: Area of removed triangles that were not copies [m^2].
        is_watertight, is_orientable: Properties of the result, as the methods of `TriangleMesh`.
        boundary_edges: Remaining edges of one triangle.
        holes_left: Remaining holes of up to `hole_size`. None if holes were not filled.
        non_manifold_vertices: Vertices whose triangles are not connected by edges.
        zero_area_triangles: Triangles without area that remain, because removing them would open the mesh.
        area_in: Area of the finite triangles of the input [m^2].

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
    area_in: float = 0.0

    @property
    def warnings(self) -> tuple[str, ...]:
        """Failed quality checks. Empty if the result is reliable. `clean_mesh` also compares it with the input."""
        lost = format_fraction(min(self.lost_area / self.area_in, 1.0)) if self.area_in > 0 else ""
        return failed(
            f"{lost} of the area was lost: compare it with the input (compare_meshes)"
            if self.area_in > 0 and self.lost_area > MAX_LOST * self.area_in
            else None,
            f"{self.holes_left:,} holes are left open" if self.holes_left else None,
            None if self.is_orientable else "a part is not orientable, like a Moebius strip, so it has no inside",
        )


class MeshRepair(MeshMeasures):
    """Methods of TriangleMesh for topology, repair, intersection tests and boolean operations.

    Intersection tests include the edges and corners of triangles and are exact for the stored float32 coordinates.
    Triangles without area count as edges. Lists of triangles omit those with a corner that is not finite;
    `is_self_intersecting` and `is_intersecting` raise ValueError for them.
    """

    def get_non_manifold_edges(self, allow_boundary_edges: bool = True) -> NDArray[np.int32]:
        """List the edges of more than two triangles.

        Args:
            allow_boundary_edges: If False, edges of one triangle are listed too.

        Returns:
            Vertex indices of shape (k, 2), the lower one first, in ascending order.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [0, 0, 1], [1, 0, 0], [-1, 0, 0], [0, 1, 0]]
            >>> mesh = loom.TriangleMesh(corners, [[0, 1, 2], [0, 1, 3], [0, 1, 4]])
            >>> mesh.get_non_manifold_edges().tolist(), len(mesh.get_non_manifold_edges(False))
            ([[0, 1]], 7)
        """
        edges = _unique_edges(self)
        mask = mesh_edges.mask_counts(edges, TRIANGLES_PER_EDGE + 1, MAX_INT32)
        if not allow_boundary_edges:
            mask = mesh_edges.mask_other_counts(edges, TRIANGLES_PER_EDGE)
        return self._ends(edges, mask)

    def get_boundary_edges(self) -> NDArray[np.int32]:
        """Edges of exactly one triangle: vertex indices of shape (k, 2), the lower one first, in ascending order.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [2, 1, 3]])
            >>> mesh.get_boundary_edges().tolist()
            [[0, 1], [0, 2], [1, 3], [2, 3]]
        """
        edges = _unique_edges(self, padded=True)
        return self._ends(edges, mesh_edges.mask_counts(edges, 1, 1))

    def get_boundaries(self) -> list[NDArray[np.int32]]:
        """Trace the boundary loops of the mesh.

        About 130 B of memory per triangle. Bitwise identical on every device.

        Returns:
            One int32 array of vertices per loop, in triangle orientation (clockwise around a hole seen from outside). A
            loop starts with its lowest vertex and visits no vertex twice. Boundaries at edges of three or more
            triangles or at inconsistent orientations are omitted: see `remove_non_manifold_edges`, `orient_triangles`.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [2, 1, 3]])
            >>> [loop.tolist() for loop in mesh.get_boundaries()]
            [[0, 1, 3, 2]]
        """
        border = Border(self.arrays["triangles"], self.arrays["vertices"].size)
        rows, loops, starts = find_loops(border)  # sync
        if not loops.count:
            return []
        vertices, ends = self.arrays.hand_out(gather_rows(border.vertices, rows)), starts.tolist()
        return [vertices[first:end] for first, end in pairwise(ends)]

    def get_non_manifold_vertices(self) -> NDArray[np.int32]:
        """List the vertices whose triangles are not connected by edges at the vertex, in ascending order.

        Vertices without triangles and triangles with a repeated vertex do not count.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]]
            >>> loom.TriangleMesh(corners, [[0, 1, 2], [0, 3, 4]]).get_non_manifold_vertices().tolist()
            [0]
        """
        mask = mesh_edges.find_split_vertices(self.arrays["triangles"], self.arrays["vertices"].size)
        return self.arrays.hand_out(positions_of(mask))

    def is_vertex_manifold(self) -> bool:
        """True if the triangles at each vertex are connected by edges. See `get_non_manifold_vertices`.

        Raises:
            ValueError: If a triangle has a corner that is not finite.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]]
            >>> loom.TriangleMesh(corners, [[0, 1, 2], [0, 3, 4]]).is_vertex_manifold()
            False
        """
        check_finite_corners("is_vertex_manifold", self)
        return len(self.get_non_manifold_vertices()) == 0

    def is_orientable(self) -> bool:
        """True if all triangles can be oriented consistently. False for a Möbius strip or a Klein bottle.

        Edges of three or more triangles impose no constraint. `orient_triangles` applies the orientation.

        Raises:
            ValueError: If a triangle has a corner that is not finite.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [1, 2, 3]])
            >>> mesh.is_orientable()
            True
        """
        check_finite_corners("is_orientable", self)
        return orientation.Orientation(self.arrays["triangles"], self.arrays["vertices"].size).orientable

    @returns_new
    def orient_triangles(self, *, outward: bool = False) -> tuple[Self, bool]:
        """Orient neighboring triangles consistently.

        About 50 B of memory per half-edge. Bitwise identical on every device.

        Args:
            outward: Orient closed parts outward. Each part is oriented alone, also if it is inside another part.

        Returns:
            (mesh, orientable). Each part keeps the orientation of its first triangle. Parts that cannot be oriented
            stay unchanged, and `orientable` is False. Edges of more than two triangles do not connect parts. Vertex
            normals of flipped triangles are flipped to the side of the new triangles.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [1, 2, 3]])
            >>> oriented, orientable = mesh.orient_triangles()
            >>> oriented.triangles.tolist(), orientable
            ([[0, 1, 2], [1, 3, 2]], True)
        """
        result = orientation.Orientation(self.arrays["triangles"], self.arrays["vertices"].size)
        if outward:
            result.face_outwards(self.arrays["vertices"], self.arrays["triangles"])
        return flipped_mesh(self, result.flips), result.orientable

    def euler_poincare_characteristic(self) -> int:
        """Euler characteristic V - E + F: 2 for a closed surface without handles, 0 for a torus.

        Unreferenced vertices do not count (in Open3D they do).

        Raises:
            ValueError: If a triangle has a corner that is not finite.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [5, 5, 5]], [[0, 1, 2]])
            >>> mesh.euler_poincare_characteristic()
            1
        """
        check_finite_corners("euler_poincare_characteristic", self)
        used = count_referenced(self.arrays["triangles"], self.arrays["vertices"].size)
        return used - _unique_edges(self).count + len(self)

    def compute_adjacency_list(self) -> tuple[NDArray[np.int32], NDArray[np.int32]]:
        """List the neighbors of each vertex along edges.

        About 50 B of memory per half-edge. Bitwise identical on every device.

        Returns:
            (starts, neighbors), int32 of shape (m + 1,) and (k,): `neighbors[starts[v] : starts[v + 1]]` belong to
            vertex v, ascending.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [2, 1, 3]])
            >>> starts, neighbors = mesh.compute_adjacency_list()
            >>> neighbors[starts[0] : starts[1]].tolist(), neighbors[starts[1] : starts[2]].tolist()
            ([1, 2], [0, 2, 3])
        """
        count = self.arrays["vertices"].size
        neighbors = VertexNeighbors(mesh_edges.MeshEdges(self.arrays["triangles"], count), count)
        used = int(download(neighbors.starts[count:])[0])  # sync
        return self.arrays.hand_out(neighbors.starts), self.arrays.hand_out(view_as(neighbors.vertices, int32, (used,)))

    def compute_triangle_areas(self) -> NDArray[np.float64]:
        """Area of each triangle [m^2], shape (t,). NaN if a corner is not finite.

        Example:
            >>> import pointloom as loom
            >>> loom.TriangleMesh([[0, 0, 0], [2, 0, 0], [0, 1, 0]], [[0, 1, 2]]).compute_triangle_areas().tolist()
            [1.0]
        """
        return self.arrays.hand_out(triangle_areas(self.arrays["vertices"], self.arrays["triangles"]))

    def _ends(self, edges: mesh_edges.UniqueKeys, mask: Mask) -> NDArray[np.int32]:
        ends = mesh_edges.edge_ends(edges, positions_of(mask), self.arrays["vertices"].size)
        return self.arrays.hand_out(ends)

    @returns_new
    def fill_holes(self, hole_size: float = 1e6) -> Self:
        """Close holes with triangles between their boundary vertices.

        Each loop of `get_boundaries` counts as a hole, the outer rim of an open surface too: choose `hole_size` below
        it. The triangulation has the smallest dihedral angles, then the shortest sides. It suits holes that are small
        relative to the shape. New triangles may intersect others. O(n^3) time and 44 n^2 B for a hole of n vertices,
        about 130 B per triangle. Bitwise identical on every device. Barequet and Sharir, "Filling gaps in the boundary
        of a polyhedron", CAGD 1995. Liepa, "Filling holes in meshes", SGP 2003, section 3.

        Args:
            hole_size: Maximum distance of boundary vertices from the center of their bounding box [m].

        Returns:
            The mesh, old triangles first. Not filled: holes of more than 1,000 vertices or with a vertex that is not
            finite, holes that need an edge of three triangles, and single triangles. `repair` reports counts.

        Raises:
            ValueError: If `hole_size` is not finite and positive.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
            >>> mesh = loom.TriangleMesh(corners, [[0, 2, 1], [0, 1, 3], [0, 3, 2]])
            >>> mesh.fill_holes().triangles[3].tolist(), mesh.fill_holes().is_watertight()
            ([2, 3, 1], True)
        """
        return _fill_small_holes(self, check_positive("hole_size", hole_size))[0]

    @returns_new
    def repair(
        self, *, merge_distance: float | None = None, hole_size: float | None = None
    ) -> tuple[Self, MeshRepairReport]:
        """Repair common mesh defects and report the changes.

        Steps: remove triangles that are not finite or degenerate, and unused vertices; stitch coincident borders. Split
        edges of more than two triangles into sheets by angle and non-manifold vertices into fans. Remove duplicate
        triangles and those without a partner at a crowded edge. Orient each part as most of its triangles. Fill holes.
        Orient closed parts by nesting. Consistently oriented closed parts are not joined to others. Nested parts keep
        their orientation; outermost parts face outward. Intersecting triangles are neither repaired nor reported.
        Memory as `fill_holes`. Bitwise identical on every device. Guéziec et al., "Cutting and stitching: converting
        sets of polygons to manifold surfaces", IEEE TVCG 2001.

        Args:
            merge_distance: Merge vertices closer than this [m], as `merge_close_vertices`. If None: equal ones.
            hole_size: Fill holes of up to this radius [m], as `fill_holes`. If None: none.

        Returns:
            (mesh, report): an edge- and vertex-manifold mesh, and a MeshRepairReport. Texture, colors and attributes
            stay. Vertex normals of flipped triangles are flipped to their side.

        Raises:
            ValueError: If a number is not finite and positive.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 0, 0]]
            >>> mesh = loom.TriangleMesh(corners, [[0, 1, 2], [0, 4, 3], [0, 3, 2]])
            >>> mended, report = mesh.repair(hole_size=1)
            >>> report.merged_vertices, report.filled_holes, report.is_watertight, round(mended.get_volume(), 6)
            (1, 1, True, 0.166667)
        """
        size = None if hole_size is None else check_positive("hole_size", hole_size)
        removed = clean_triangles.mask_not_finite(self.arrays["vertices"], self.arrays["triangles"])
        mesh = self.drop_triangles(removed)
        before = mesh.arrays.vertex_count
        finite = mesh if merge_distance is None else mesh.merge_close("merge_distance", merge_distance)
        stitched = cut_and_stitch(finite)
        flipped = find_flips(stitched.mesh)
        mesh = flipped_mesh(stitched.mesh, flipped)
        area, filled, left = mesh.get_surface_area(), 0, None
        if size is not None:
            mesh, filled, left = _fill_small_holes(mesh, size)
        added = len(mesh) - flipped.size
        mesh, orientable = _nested(mesh, flipped)
        area_in = self.finite_area()
        report = MeshRepairReport(
            removed_non_finite_triangles=len(self) - len(finite),
            merged_vertices=stitched.merged + before - finite.arrays.vertex_count,
            removed_degenerate_triangles=stitched.degenerate,
            removed_duplicated_triangles=stitched.copies,
            removed_crowding_triangles=stitched.crowding,
            split_vertices=stitched.split,
            flipped_triangles=stitched.flipped
            + count_unlike(stitched.mesh.arrays["triangles"], mesh.arrays["triangles"]),
            filled_holes=filled,
            added_triangles=added + stitched.halved,
            removed_vertices=stitched.unused,
            lost_area=_difference(area_in, stitched.copied_area + area),
            area_in=area_in,
            is_orientable=orientable,
            holes_left=left,
            **_findings(mesh),
        )
        return mesh, report

    @returns_new
    def split_non_manifold_vertices(self) -> Self:
        """Duplicate vertices so that each fan of triangles has its own vertex.

        About 80 B of memory per triangle. Bitwise identical on every device.

        Returns:
            A vertex-manifold mesh, unless a triangle repeats a vertex. New vertices follow the old ones and copy
            position, normal and color. Edges of more than two triangles stay: see `repair`.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]]
            >>> mesh = loom.TriangleMesh(corners, [[0, 1, 2], [0, 3, 4]]).split_non_manifold_vertices()
            >>> mesh.triangles.tolist(), mesh.vertices[5].tolist()
            ([[0, 1, 2], [5, 3, 4]], [0.0, 0.0, 0.0])
        """
        triangles, count = self.arrays["triangles"], self.arrays.vertex_count
        split, rows = split_fans(triangles, count)
        return self.with_arrays(triangles=split, **self.arrays.vertices_at(rows))

    def is_self_intersecting(self) -> bool:
        """True if two triangles without a common vertex intersect. See `get_self_intersecting_triangles`.

        Raises:
            ValueError: If a triangle has a corner that is not finite.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [2, 0, 0], [0, 2, 0], [0.5, 0.5, -1], [0.5, 0.5, 1], [3, 3, 1]]
            >>> loom.TriangleMesh(corners, [[0, 1, 2], [3, 4, 5]]).is_self_intersecting()
            True
        """
        check_finite_corners("is_self_intersecting", self)
        return len(self.get_self_intersecting_triangles()) > 0

    def get_self_intersecting_triangles(self) -> NDArray[np.int32]:
        """List pairs of intersecting triangles without a common vertex.

        O(n log n) time, O(n + k) memory. Bitwise identical on every device. Guigue and Devillers, "Fast and robust
        triangle-triangle overlap test", JGT 2003. Shewchuk, "Adaptive precision floating-point arithmetic", DCG 1997.

        Returns:
            int32 of shape (k, 2), the lower index first, ascending. Coincident vertices with two indices count as two,
            so in a triangle soup all neighbors intersect.

        Raises:
            ValueError: If there are 2^31 pairs or more.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [2, 0, 0], [0, 2, 0], [0.5, 0.5, -1], [0.5, 0.5, 1], [3, 3, 1]]
            >>> loom.TriangleMesh(corners, [[0, 1, 2], [3, 4, 5]]).get_self_intersecting_triangles().tolist()
            [[0, 1]]
        """
        vertices, triangles = self.arrays["vertices"], self.arrays["triangles"]
        tree = TriangleTree(vertices, triangles)
        first, second = find_meeting_pairs(tree, vertices, triangles, triangles, within=True)
        return self.arrays.hand_out(pair_up(first, second))

    def is_intersecting(self, other: MeshArrays) -> bool:
        """True if a triangle of this mesh intersects one of another mesh.

        Meshes inside each other do not intersect: see `RaycastingScene.compute_occupancy`.

        Args:
            other: A mesh on the same device. Its vertices are rounded to float32 about this mesh's `origin`.

        Raises:
            TypeError, DeviceError: If `other` is not a mesh, or if the meshes are on different devices.
            ValueError: If there are 2^31 pairs or more, or a triangle has a corner that is not finite.

        Example:
            >>> import pointloom as loom
            >>> floor = loom.TriangleMesh([[0, 0, 0], [2, 0, 0], [0, 2, 0]], [[0, 1, 2]])
            >>> wall = loom.TriangleMesh([[0.5, 0.5, -1], [0.5, 0.5, 1], [3, 3, 1]], [[0, 1, 2]])
            >>> floor.is_intersecting(wall)
            True
        """
        check_mesh("other", other)
        check_same_device("other", self.device, other.device)
        check_finite_corners("is_intersecting", self)
        check_finite_corners("is_intersecting: other", other)
        if not len(self) or not len(other):
            return False
        own = self.arrays["vertices"]
        shifts = [np.zeros(3), other.origin - self.arrays.origin]
        vertices = concatenate_points([own, other.arrays["vertices"]], shifts)
        theirs = shift_triangles(other.arrays["triangles"], own.size)
        tree = TriangleTree(vertices, theirs)
        return find_meeting_pairs(tree, vertices, self.arrays["triangles"], theirs, within=False)[0].size > 0

    @returns_new
    def boolean_union(self, mesh: Self) -> Self:
        """Union of two closed meshes as solids, computed on the CPU by manifold3d (`pip install "pointloom[mesh]"`).

        Computed in float64, rounded once to float32. Reproducibility depends on manifold3d.

        Args:
            mesh: A closed, outward-oriented mesh on any device. This mesh must be so too.

        Returns:
            The surface on this mesh's device, relative to its origin. Empty if nothing remains. Vertex colors are
            interpolated if both meshes have them. Normals are recomputed. Texture is dropped. Attributes of both meshes
            are those of the nearest surface point.

        Raises:
            ValueError, TypeError: If a mesh is not closed or not oriented outward, or if `mesh` is not a mesh.
            ImportError: If manifold3d is not installed.

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
        """Difference of two closed meshes: this solid without the other one. Arguments and errors as `boolean_union`.

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
        """Intersection of two closed meshes as solids. Arguments and errors as `boolean_union`.

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
        check_mesh("mesh", other)
        library = load_manifold(name)
        with_colors = "vertex_colors" in self.arrays and "vertex_colors" in other.arrays
        solids = [
            _solid(library, mesh, self.arrays.origin, with_colors, f"{name}: {what}")
            for what, mesh in (("the mesh", self), ("mesh: it", other))
        ]
        result = operation(*solids)
        _check_status(result, name)
        vertices, triangles, colors = _arrays_of(result)
        make: Any = type(self)  # TriangleMesh
        mesh = make(
            vertices + self.arrays.origin,
            triangles,
            vertex_colors=np.clip(colors, 0, 1) if with_colors else None,
            device=self.device,
            origin=self.arrays.origin,
        )
        mesh.unit, mesh.crs = common_reference(f"{name}: the meshes", (self, other))
        both = self.concatenate([part.with_arrays(**dict.fromkeys(TEXTURE)) for part in (self, other)])
        mesh.arrays.up = both.arrays.up
        if any(both.arrays.attributes.values()):
            source = make(both.vertices, both.triangles, device=self.device, origin=self.arrays.origin)
            source.arrays.attributes = both.arrays.attributes
            mesh = with_attributes_of(mesh, source)
        both_have_normals = "vertex_normals" in self.arrays and "vertex_normals" in other.arrays
        return mesh.compute_vertex_normals() if both_have_normals else mesh


def _unique_edges(mesh: Mesh, padded: bool = False) -> mesh_edges.UniqueKeys:
    return mesh_edges.find_edges(mesh.arrays["triangles"], mesh.arrays["vertices"].size, padded)


def _fill_small_holes(mesh: Mesh, hole_size: float) -> tuple[Mesh, int, int]:
    """(mesh with filled holes, number filled, number not filled)."""
    filling = Filling(mesh.arrays["vertices"], mesh.arrays["triangles"], hole_size)
    arrays: dict[str, Any] = {"triangles": filling.triangles}
    if "triangle_uvs" in mesh.arrays:
        arrays["triangle_uvs"] = spread_corners(mesh.arrays["triangle_uvs"], filling.corners)
    if "triangle_material_ids" in mesh.arrays:
        arrays["triangle_material_ids"] = spread_ids(mesh.arrays["triangle_material_ids"], filling.corners)
    if mesh.arrays.attributes["triangle_attributes"]:
        sources = spread_ids(positions(len(mesh), mesh.device), filling.corners)
        arrays |= mesh.arrays.attributes_at("triangle_attributes", sources)
    return mesh.with_arrays(**arrays), filling.filled, filling.left


def _nested(mesh: Mesh, flipped: Mask) -> tuple[Mesh, bool]:
    """(mesh with closed parts oriented by nesting, orientable); `flipped` marks inconsistently oriented input."""
    vertices, triangles = mesh.arrays["vertices"], mesh.arrays["triangles"]
    orientation = Orientation(triangles, vertices.size)
    measured = orientation.measure_parts(vertices, triangles)
    several = np.count_nonzero(measured.closed & (measured.volumes != 0)) > 1  # a single part cannot be nested
    labels = download(measured.labels) if several else np.empty(0, np.int64)  # sync
    parts = Parts(labels, measured.closed, measured.volumes)
    is_fixed = ~has_marked(measured.labels, flipped, len(measured.closed))  # sync
    orientation.flip_parts(measured.labels, choose_sides(parts, find_enclosing(vertices, triangles, parts), is_fixed))
    return flipped_mesh(mesh, orientation.flips), orientation.orientable


def _findings(mesh: Mesh) -> dict[str, Any]:
    """Remaining defects, by the field names of MeshRepairReport."""
    vertices, triangles = mesh.arrays["vertices"], mesh.arrays["triangles"]
    boundary, split, empty = positions_of_each(  # sync
        mask_counts(_unique_edges(mesh, padded=True), 1, 1),
        find_split_vertices(triangles, vertices.size),
        clean_triangles.mask_degenerate(vertices, triangles, zero_area=True),
    )
    return {
        "is_watertight": mesh.is_watertight(),  # sync
        "boundary_edges": boundary.size,
        "non_manifold_vertices": split.size,
        "zero_area_triangles": empty.size,
    }


def count_edges(mesh: MeshRepair) -> EdgeCounts:
    edges = _unique_edges(mesh)
    boundary, crowded = (
        positions_of(mesh_edges.mask_counts(edges, *limits)).size
        for limits in ((1, 1), (TRIANGLES_PER_EDGE + 1, MAX_INT32))
    )
    return EdgeCounts(edges.count, boundary, crowded)


def _difference(total: float, rest: float) -> float:
    """Difference of sums. 0 if it is below the rounding error."""
    return total - rest if total - rest > AREA_ROUNDING * total else 0.0


def _solid(library: Any, mesh: Any, origin: NDArray[np.float64], with_colors: bool, what: str) -> Any:
    """Convert a mesh to a manifold relative to `origin`. Raise ValueError if it is not a solid."""
    if len(mesh):
        if (wrong := find_wrong_corner(mesh)) is not None:
            raise ValueError(f"{what} has NaN or infinite corners: {wrong}; {REMEDY}")
        topology = mesh.edge_topology()
        if topology.has_boundary or topology.has_crowded_edge:
            raise ValueError(f"{what} is not closed. Close holes with repair(hole_size=...) first")
        if topology.has_twisted_edge:
            raise ValueError(f"{what} has inconsistently oriented triangles. Call orient_triangles() first")
        if mesh.signed_volume() < 0:
            raise ValueError(f"{what} faces inward. Call orient_triangles(outward=True) first")
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
        raise ValueError(f"{what} is rejected by {LIBRARY}: {status.name}")


def _arrays_of(solid: Any) -> tuple[NDArray[np.float64], NDArray[np.int64], NDArray[np.float64]]:
    """(positions (m, 3), triangles (t, 3), other columns); merges vertices that differ only in the latter."""
    mesh = solid.to_mesh64()
    properties = np.asarray(mesh.vert_properties)
    target = np.arange(len(properties))
    target[np.asarray(mesh.merge_from_vert, np.int64)] = np.asarray(mesh.merge_to_vert, np.int64)
    rows, triangles = np.unique(target[np.asarray(mesh.tri_verts, np.int64)], return_inverse=True)
    return properties[rows, :3], triangles.reshape(-1, 3), properties[rows, 3:]
