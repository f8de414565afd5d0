"""Meshes made whole: holes closed, and all that is commonly wrong mended in one call that says what it did."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Self

from ...core.checks import check_positive
from ...core.dropped_results import returns_new
from ...kernels.arrays.select import positions_of
from ...kernels.meshes import clean_triangles
from ...kernels.meshes.holes import Filling, spread_corners, spread_ids
from ...kernels.meshes.mesh_edits import count_unlike
from .mesh_selection import MeshSelection
from .mesh_topology import MeshTopology


@dataclass(frozen=True)
class MeshRepairReport:
    """What `repair` did to a mesh, and what is still wrong with it.

    Attributes:
        removed_non_finite_triangles: Triangles with a corner that was not finite.
        merged_vertices: Vertices that became one with another.
        removed_degenerate_triangles: Triangles that named a vertex twice.
        removed_duplicated_triangles: Triangles that were an earlier one.
        removed_crowding_triangles: Triangles at edges of more than two.
        flipped_triangles: Triangles wound the other way.
        filled_holes: Holes closed.
        added_triangles: Triangles that close them.
        removed_vertices: Vertices that no triangle used at the end.
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
    flipped_triangles: int
    filled_holes: int
    added_triangles: int
    removed_vertices: int
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

        In this order: triangles with a corner that is not finite go; vertices at one position become one; triangles
        that name a vertex twice, repeated ones and the smallest at edges of more than two go; the others are wound
        alike; holes are closed; closed parts are turned outwards; vertices that no triangle uses go.

        Args:
            merge_distance: [m]; vertices closer than this become one, as of `merge_close_vertices`; None for those at
                the same position.
            hole_size: [m]; holes of up to this radius are closed, as of `fill_holes`; None for none of them.

        Returns:
            (mesh, report): a mesh with `is_edge_manifold()`, and a MeshRepairReport. Texture, normals and colours stay.

        Raises:
            ValueError: A number that is not finite and above 0.

        Notes:
            Triangles that cut through each other are neither mended nor reported. Memory is that of `fill_holes`. Same
            bits from run to run and on every device.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 0, 0]]
            >>> mesh = loom.TriangleMesh(corners, [[0, 1, 2], [0, 4, 3], [0, 3, 2]])
            >>> mended, report = mesh.repair(hole_size=1)
            >>> report.merged_vertices, report.filled_holes, report.is_watertight, round(mended.get_volume(), 6)
            (1, 1, True, 0.166667)
        """
        size = None if hole_size is None else check_positive("hole_size", hole_size)
        done: dict[str, Any] = {}
        mesh = self._without(clean_triangles.mask_not_finite(self._arrays["vertices"], self._arrays["triangles"]))
        done["removed_non_finite_triangles"] = len(self) - len(mesh)
        before = mesh._vertex_count
        if merge_distance is None:
            mesh = mesh.remove_duplicated_vertices()
        else:
            mesh = mesh._merge_close("merge_distance", merge_distance)
        done["merged_vertices"] = before - mesh._vertex_count
        for name, step in (
            ("removed_degenerate_triangles", "remove_degenerate_triangles"),
            ("removed_duplicated_triangles", "remove_duplicated_triangles"),
            ("removed_crowding_triangles", "remove_non_manifold_edges"),
        ):
            before, mesh = len(mesh), getattr(mesh, step)()
            done[name] = before - len(mesh)
        whole = mesh
        mesh, _ = mesh.orient_triangles()
        left = None
        if size is not None:
            mesh, filled, left = mesh._fill(size)
            done["filled_holes"] = filled
        mesh, orientable = mesh.orient_triangles(outward=True)
        done["flipped_triangles"] = count_unlike(whole.device_arrays["triangles"], mesh.device_arrays["triangles"])
        done["added_triangles"] = len(mesh) - len(whole)
        before, mesh = mesh._vertex_count, mesh.remove_unreferenced_vertices()
        done = {"filled_holes": 0, "removed_vertices": before - mesh._vertex_count} | done
        report = MeshRepairReport(**done, **mesh._findings(), is_orientable=orientable, holes_left=left)
        return mesh, report

    def _fill(self, hole_size: float) -> tuple[Self, int, int]:
        """(the mesh with its holes filled, how many were, how many of this size were not)."""
        found = Filling(self._arrays["vertices"], self._arrays["triangles"], hole_size)
        arrays: dict[str, Any] = {"triangles": found.triangles}
        if "triangle_uvs" in self._arrays:
            arrays["triangle_uvs"] = spread_corners(self._arrays["triangle_uvs"], found.corners)
        if "triangle_material_ids" in self._arrays:
            arrays["triangle_material_ids"] = spread_ids(self._arrays["triangle_material_ids"], found.corners)
        return self.with_arrays(**arrays), found.filled, found.left

    def _findings(self) -> dict[str, Any]:
        """What may still be wrong, as MeshRepairReport names it."""
        empty = clean_triangles.mask_degenerate(self._arrays["vertices"], self._arrays["triangles"], zero_area=True)
        return {
            "is_watertight": self.is_watertight(),
            "boundary_edges": len(self.get_boundary_edges()),
            "non_manifold_vertices": len(self.get_non_manifold_vertices()),
            "zero_area_triangles": positions_of(empty).size,
        }
