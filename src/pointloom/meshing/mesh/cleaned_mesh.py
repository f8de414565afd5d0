"""Mesh repair with a quality check: `clean_mesh`."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any

from ...core.checks import check_count, check_positive, check_progress
from ...core.progress import ReportProgress
from ...core.reports import Fields, quality
from ...core.units import symbol_of
from ...core.wording import format_fraction, plain
from .changed_mesh import ChangedMesh, fractions_changed, sizes_before
from .measures import finite_area
from .mesh import TriangleMesh
from .mesh_arrays import check_mesh
from .repair import MAX_LOST, MeshRepairReport
from .topology import is_closed

MAX_GONE = 0.02  # fraction of triangles without a partner: above, parts of the surface may be missing
MAX_MERGED = 0.5  # fraction of the vertices: above, the merge distance probably has another unit

# Changes by the repair, in words. The other fields of its report are final states.
_DONE = {
    "removed_non_finite_triangles": "non-finite triangles removed",
    "merged_vertices": "vertices merged",
    "removed_degenerate_triangles": "degenerate triangles removed",
    "removed_duplicated_triangles": "duplicated or opposite triangles removed",
    "removed_crowding_triangles": "triangles at non-manifold edges removed",
    "split_vertices": "vertices added to separate touching surfaces",
    "flipped_triangles": "triangles flipped",
    "filled_holes": "holes filled",
    "added_triangles": "triangles added",
    "removed_parts": "small parts removed",
}
_LEFT = {
    "boundary_edges": "boundary edges",
    "holes_left": "holes not filled",
    "non_manifold_vertices": "non-manifold vertices",
    "zero_area_triangles": "zero-area triangles",
    "self_intersections": "pairs of intersecting triangles",
}


@dataclass(frozen=True, kw_only=True, eq=False)
class CleanedMesh(ChangedMesh):
    """A repaired mesh and its remaining defects.

    Attributes:
        mesh: The result.
        repair: Report of `TriangleMesh.repair` for the complete mesh.
        removed_parts, parts: Small parts removed afterward, and remaining parts.
        is_watertight, boundary_edges, self_intersections: Of the result. Pairs of intersecting triangles.
        was_watertight, area_in: Of the input. Area of its finite triangles [m^2].
        gone: Fraction of the input's surface that is farther than 2% of its box's diagonal from the repaired one. None
            without an area or with a corner that is not finite.
        merge_distance, hole_size: As given [m].
        vertices_in, triangles_in: Counts of the input.
        reliable, warnings: True if all quality checks passed, and those that failed.
    """

    repair: MeshRepairReport
    removed_parts: int
    parts: int
    is_watertight: bool
    boundary_edges: int
    self_intersections: int
    was_watertight: bool
    area_in: float
    gone: float | None = None
    merge_distance: float | None = None
    hole_size: float | None = None

    @property
    def warnings(self) -> tuple[str, ...]:
        if not len(self.mesh):
            return ("no triangles remain",)
        reasons, merge, fill, m = [], self.merge_distance, self.hole_size, symbol_of(self.mesh.unit)
        has_moved = self.gone is None or self.gone > MAX_LOST
        if merge is not None and has_moved and self.repair.merged_vertices > MAX_MERGED * self.vertices_in:
            fraction = format_fraction(self.repair.merged_vertices / self.vertices_in)
            reasons.append(f"{fraction} of the vertices were merged: use a merge_distance below {merge:g} {m}")
        reasons += self._losses()
        if fill is not None and self.repair.holes_left:
            reasons.append(f"{self.repair.holes_left:,} holes of up to {fill:g} {m} are left open")
        if not self.repair.is_orientable:
            reasons.append("a part is not orientable, like a Moebius strip, so it has no inside")
        return tuple(reasons)

    def _losses(self) -> list[str]:
        done, losses = self.repair, []
        removed_fraction = (done.removed_non_finite_triangles + done.removed_crowding_triangles) / max(
            1, self.triangles_in
        )
        lost_fraction = done.lost_area / self.area_in if self.area_in > 0 else 0.0
        lost_fraction = lost_fraction if self.gone is None else self.gone
        look = "compare it with the input (compare_meshes)"
        if removed_fraction > MAX_GONE:
            losses.append(f"{format_fraction(removed_fraction)} of the triangles were removed: {look}")
        if lost_fraction > MAX_LOST:
            losses.append(f"{format_fraction(lost_fraction)} of the area was lost: {look}")
        if self.was_watertight and not done.is_watertight:
            losses.append(f"the input was closed, the result is not: {look}")
        return losses

    def to_dict(self) -> dict[str, Any]:
        return plain(self.sizes_to_dict() | self._figures() | quality(self))

    def fields(self) -> Fields:
        figures = self._figures()
        did = [f"{figures[name]:,} {words}" for name, words in _DONE.items() if figures[name]]
        still = [f"{figures[name]:,} {words}" for name, words in _LEFT.items() if figures[name]]
        if not self.repair.is_orientable:
            still.append("a non-orientable part")
        return [
            *self.size_fields(),
            ("parts", f"{self.parts:,}"),
            ("done", "; ".join(did) or "nothing to repair"),
            ("left", "; ".join(still) or "no defects"),
            ("closed", "yes" if self.is_watertight else "no"),
        ]

    def _figures(self) -> dict[str, Any]:
        ends = {"is_watertight": self.is_watertight, "boundary_edges": self.boundary_edges}
        parts = {"removed_parts": self.removed_parts, "parts": self.parts}
        ends |= {"was_watertight": self.was_watertight, "area_in": self.area_in, "gone": self.gone}
        return asdict(self.repair) | ends | parts | {"self_intersections": self.self_intersections}


def clean_mesh(
    mesh: TriangleMesh,
    *,
    merge_distance: float | None = None,
    hole_size: float | None = None,
    min_triangles: int = 1,
    min_area: float = 0.0,
    progress: ReportProgress | None = None,
) -> CleanedMesh:
    """Repair a mesh, remove small parts and report remaining defects, as `pointloom clean-mesh`.

    Runs `repair`, `remove_small_components` and a self-intersection test. Bitwise identical on every device.

    Args:
        mesh: The mesh.
        merge_distance: Merge vertices closer than this [m]. If None: only equal positions.
        hole_size: Fill holes of up to this radius [m]. If None: none.
        min_triangles, min_area: Minimum triangles and area [m^2] of kept parts.
        progress: Called with each stage when it begins: "repair", "parts", "check".

    Raises:
        TypeError, ValueError: If `mesh` is not a mesh, or an argument is not a number or out of range.

    Example:
        >>> import pointloom as loom
        >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 0, 0], [7, 0, 0], [8, 0, 0], [7, 1, 0]]
        >>> mesh = loom.TriangleMesh(corners, [[0, 1, 2], [0, 4, 3], [0, 3, 2], [5, 6, 7]])
        >>> found = loom.meshing.clean_mesh(mesh, hole_size=1, min_triangles=2)
        >>> found.repair.filled_holes, found.removed_parts, found.is_watertight, found.reliable
        (1, 1, True, True)
    """
    check_mesh("mesh", mesh)
    min_count, smallest_area = (
        check_count("min_triangles", min_triangles),
        check_positive("min_area", min_area, allow_zero=True),
    )
    report = check_progress(progress)
    report("repair", 0, 0)
    repaired, done = mesh.repair(merge_distance=merge_distance, hole_size=hole_size)
    report("parts", 0, 0)
    _, counts, areas = repaired.to(repaired.device, arrays="numpy").cluster_connected_triangles()
    small = int(((counts < min_count) | (areas < smallest_area)).sum())
    left = repaired.remove_small_components(min_count, smallest_area) if small else repaired
    report("check", 0, 0)
    changed = fractions_changed(mesh, repaired)
    return CleanedMesh(
        mesh=left,
        **sizes_before(mesh),
        repair=done,
        removed_parts=small,
        parts=len(counts) - small,
        is_watertight=left.is_watertight() if small else done.is_watertight,
        boundary_edges=len(left.get_boundary_edges()) if small else done.boundary_edges,
        self_intersections=len(left.get_self_intersecting_triangles()),
        was_watertight=is_closed(mesh),
        area_in=finite_area(mesh),
        gone=None if changed is None else changed[0],
        merge_distance=merge_distance,
        hole_size=hole_size,
    )
