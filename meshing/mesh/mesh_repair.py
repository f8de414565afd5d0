"""Meshes made whole: holes closed, and all that is commonly wrong mended in one call that says what it did."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Self

import numpy as np

from ...core.checks import check_positive
from ...core.dropped_results import returns_new
from ...kernels.array_types import Mask
from ...kernels.arrays.select import positions_of_each
from ...kernels.arrays.sort import positions
from ...kernels.memory import download
from ...kernels.meshes import clean_triangles
from ...kernels.meshes.corner_vertices import split_fans
from ...kernels.meshes.holes import Filling, spread_corners, spread_ids
from ...kernels.meshes.mesh_components import holds_marked
from ...kernels.meshes.mesh_edges import find_split_vertices, mask_counts
from ...kernels.meshes.mesh_edits import count_unlike
from ...kernels.meshes.orientation import Orientation, flip_some, flip_some_corners
from .mesh_nesting import Parts, choose_sides, find_enclosing
from .mesh_selection import MeshSelection
from .mesh_sheets import cut_and_stitch
from .mesh_topology import MeshTopology

ROUNDING = 1e-9  # of sums of areas


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


class MeshRepair(MeshTopology, MeshSelection):
    """The part of TriangleMesh that closes and mends it."""

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


def _difference(whole: float, rest: float) -> float:
    """What is left of a sum without the rest of it; 0 where that is rounding."""
    return whole - rest if whole - rest > ROUNDING * whole else 0.0
