"""Repair of a mesh: orientation, holes, non-manifold vertices, and all of them with a report."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from ...core.checks import check_positive
from ...core.reports import AssessedRecord, failed
from ...core.wording import format_fraction
from ...kernels.array_types import Mask
from ...kernels.arrays.select import positions_of_each
from ...kernels.arrays.sort import positions
from ...kernels.memory import download
from ...kernels.meshes import clean_triangles
from ...kernels.meshes.corner_vertices import split_fans
from ...kernels.meshes.holes import Filling, spread_corners, spread_ids
from ...kernels.meshes.mesh_components import has_marked
from ...kernels.meshes.mesh_edges import find_split_vertices, mask_counts
from ...kernels.meshes.mesh_edits import count_unlike
from ...kernels.meshes.orientation import Orientation
from .closed_parts import Parts, choose_sides, find_enclosing
from .measures import finite_area, get_surface_area
from .mesh_arrays import Mesh, MeshArrays
from .selection import drop_triangles, merge_close
from .sheets import cut_and_stitch, find_flips, flipped_mesh
from .topology import is_watertight, unique_edges

AREA_ROUNDING = 1e-9  # relative, of area sums
MAX_LOST = 0.01  # fraction of the area, without copies, above which parts of the surface may be missing


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


def orient_triangles(mesh: Mesh, *, outward: bool) -> tuple[Mesh, bool]:
    """As `TriangleMesh.orient_triangles`."""
    result = Orientation(mesh.arrays["triangles"], mesh.arrays["vertices"].size)
    if outward:
        result.face_outwards(mesh.arrays["vertices"], mesh.arrays["triangles"])
    return flipped_mesh(mesh, result.flips), result.orientable


def fill_holes(mesh: Mesh, hole_size: float) -> Mesh:
    """As `TriangleMesh.fill_holes`."""
    return _fill_small_holes(mesh, check_positive("hole_size", hole_size))[0]


def repair(mesh: Mesh, *, merge_distance: float | None, hole_size: float | None) -> tuple[Mesh, MeshRepairReport]:
    """As `TriangleMesh.repair`."""
    size = None if hole_size is None else check_positive("hole_size", hole_size)
    removed = clean_triangles.mask_not_finite(mesh.arrays["vertices"], mesh.arrays["triangles"])
    clean = drop_triangles(mesh, removed)
    before = clean.arrays.vertex_count
    finite = clean if merge_distance is None else merge_close(clean, "merge_distance", merge_distance)
    stitched = cut_and_stitch(finite)
    flipped = find_flips(stitched.mesh)
    clean = flipped_mesh(stitched.mesh, flipped)
    area, filled, left = get_surface_area(clean), 0, None
    if size is not None:
        clean, filled, left = _fill_small_holes(clean, size)
    added = len(clean) - flipped.size
    clean, orientable = _nested(clean, flipped)
    area_in = finite_area(mesh)
    report = MeshRepairReport(
        removed_non_finite_triangles=len(mesh) - len(finite),
        merged_vertices=stitched.merged + before - finite.arrays.vertex_count,
        removed_degenerate_triangles=stitched.degenerate,
        removed_duplicated_triangles=stitched.copies,
        removed_crowding_triangles=stitched.crowding,
        split_vertices=stitched.split,
        flipped_triangles=stitched.flipped + count_unlike(stitched.mesh.arrays["triangles"], clean.arrays["triangles"]),
        filled_holes=filled,
        added_triangles=added + stitched.halved,
        removed_vertices=stitched.unused,
        lost_area=_difference(area_in, stitched.copied_area + area),
        area_in=area_in,
        is_orientable=orientable,
        holes_left=left,
        **_findings(clean),
    )
    return clean, report


def split_non_manifold_vertices(mesh: Mesh) -> Mesh:
    """As `TriangleMesh.split_non_manifold_vertices`."""
    triangles, count = mesh.arrays["triangles"], mesh.arrays.vertex_count
    split, rows = split_fans(triangles, count)
    return mesh.with_arrays(triangles=split, **mesh.arrays.vertices_at(rows))


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


def _findings(mesh: MeshArrays) -> dict[str, Any]:
    """Remaining defects, by the field names of MeshRepairReport."""
    vertices, triangles = mesh.arrays["vertices"], mesh.arrays["triangles"]
    boundary, split, empty = positions_of_each(  # sync
        mask_counts(unique_edges(mesh, padded=True), 1, 1),
        find_split_vertices(triangles, vertices.size),
        clean_triangles.mask_degenerate(vertices, triangles, zero_area=True),
    )
    return {
        "is_watertight": is_watertight(mesh),  # sync
        "boundary_edges": boundary.size,
        "non_manifold_vertices": split.size,
        "zero_area_triangles": empty.size,
    }


def _difference(total: float, rest: float) -> float:
    """Difference of sums. 0 if it is below the rounding error."""
    return total - rest if total - rest > AREA_ROUNDING * total else 0.0
