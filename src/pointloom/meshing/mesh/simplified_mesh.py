"""Mesh simplification with a quality check: `simplify_mesh`."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from ...core.checks import check_count, check_fraction, check_positive, check_progress
from ...core.progress import ReportProgress
from ...core.reports import Fields, quality
from ...core.units import symbol_of
from ...core.wording import plain
from .changed_mesh import ChangedMesh, can_be_compared, sizes_before
from .mesh import TriangleMesh
from .mesh_arrays import check_mesh

MAX_COUNT_RATIO = 1.05  # times the target: more triangles are reported
MAX_RMS_RATIO = 0.01  # of the box's diagonal: a larger RMS distance is reported
DISTANCE_SAMPLES = 20_000

_WAYS = {
    "triangles": "to {:,.0f} triangles",
    "ratio": "to a fraction of {:g}",
    "voxel": "one vertex per voxel of {:g} {m}",
}


@dataclass(frozen=True)
class SurfaceShift:
    """Distance between two surfaces [m]: root mean square `rms` and maximum `max`."""

    rms: float
    max: float


@dataclass(frozen=True, kw_only=True, eq=False)
class SimplifiedMesh(ChangedMesh):
    """A simplified mesh and its deviation.

    Attributes:
        mesh: The result.
        by, amount: "triangles", "ratio" or "voxel", and its value.
        target: Requested triangles. None by voxels.
        errors: Distance of the full surface to the new one. None if either has no area.
        max_error: As given.
        diagonal: Of the full mesh's box [m].
        vertices_in, triangles_in: Counts of the input.
        reliable, warnings: True if all quality checks passed, and those that failed.
    """

    by: str
    amount: float
    target: int | None
    errors: SurfaceShift | None
    max_error: float
    diagonal: float

    @property
    def warnings(self) -> tuple[str, ...]:
        count, target = len(self.mesh), self.target
        if not count:
            return ("no triangles remain: use more triangles or smaller voxels",)
        reasons = []
        if target is not None and count > max(target * MAX_COUNT_RATIO, target + 4) and math.isinf(self.max_error):
            reasons.append(f"{count:,} triangles are left instead of {target:,}: repair the mesh with clean_mesh first")
        if self.errors is not None and self.errors.rms > MAX_RMS_RATIO * self.diagonal:
            fraction = self.errors.rms / self.diagonal
            reasons.append(f"the surface moved by {fraction:.1%} of its size: use more triangles or smaller voxels")
        return tuple(reasons)

    def to_dict(self) -> dict[str, Any]:
        errors = None if self.errors is None else {"rms": self.errors.rms, "max": self.errors.max}
        settings = {"by": self.by, "amount": self.amount, "target": self.target, "errors": errors}
        return plain(self.sizes_to_dict() | settings | quality(self))

    def fields(self) -> Fields:
        distance, m = "none measured", symbol_of(self.mesh.unit)
        if self.errors is not None:
            distance = f"{self.errors.rms:.3g} {m} rms, {self.errors.max:.3g} {m} at most"
        return [("simplified", _WAYS[self.by].format(self.amount, m=m)), *self.size_fields(), ("distance", distance)]


def simplify_mesh(
    mesh: TriangleMesh,
    *,
    triangles: int | None = None,
    ratio: float | None = None,
    voxel_size: float | None = None,
    max_error: float = math.inf,
    boundary_weight: float = 1.0,
    progress: ReportProgress | None = None,
) -> SimplifiedMesh:
    """Simplify a mesh and measure the deviation of its surface, as `pointloom simplify`.

    Uses `simplify_quadric_decimation`, or `simplify_vertex_clustering` with quadrics, and distances of 20,000 points of
    the full surface. Bitwise identical on every device.

    Args:
        mesh: The mesh.
        triangles, ratio: Number or fraction (up to 1) of the remaining triangles.
        voxel_size: Keep one vertex per voxel of this edge [m].
        max_error, boundary_weight: As of `simplify_quadric_decimation`.
        progress: Called with each stage when it begins: "simplify", "check".

    Raises:
        TypeError, ValueError: If `mesh` is not a mesh, or an argument is not a number, or if not exactly one of
            triangles, ratio and voxel_size is given, or an argument is out of range or does not apply.

    Warns:
        UserWarning: As of `simplify_quadric_decimation`.

    Example:
        >>> import pointloom as loom
        >>> found = loom.meshing.simplify_mesh(loom.TriangleMesh.create_sphere(), ratio=0.5)
        >>> found.target, len(found.mesh), found.errors.max < 0.02, found.reliable
        (760, 760, True, True)
    """
    check_mesh("mesh", mesh)
    by, amount = _one_of(triangles, ratio, voxel_size)
    farthest = check_positive("max_error", max_error, allow_zero=True, allow_infinite=True)
    weight = check_positive("boundary_weight", boundary_weight, allow_zero=True)
    if by == "voxel" and (farthest, weight) != (math.inf, 1.0):
        raise ValueError("max_error, boundary_weight: apply to triangles or ratio, not to voxel_size")
    report, target = check_progress(progress), None
    report("simplify", 0, 0)
    if by == "voxel":
        small = mesh.simplify_vertex_clustering(amount, "quadric")
    else:
        target = int(amount) if by == "triangles" else max(1, round(amount * len(mesh)))
        small = mesh.simplify_quadric_decimation(target, farthest, weight)
    report("check", 0, 0)
    low, high = mesh.get_axis_aligned_bounding_box()
    return SimplifiedMesh(
        mesh=small,
        **sizes_before(mesh),
        by=by,
        amount=amount,
        target=target,
        errors=_shift_of(small, mesh),
        max_error=farthest,
        diagonal=math.dist(low, high),
    )


def _one_of(triangles: int | None, ratio: float | None, voxel_size: float | None) -> tuple[str, float]:
    given = {"triangles": triangles, "ratio": ratio, "voxel_size": voxel_size}
    names = [name for name, amount in given.items() if amount is not None]
    if len(names) != 1:
        raise ValueError(f"pass one of triangles, ratio and voxel_size, got {' and '.join(names) or 'none'}")
    if triangles is not None:
        return "triangles", check_count("triangles", triangles)
    if voxel_size is not None:
        return "voxel", check_positive("voxel_size", voxel_size)
    fraction = check_fraction("ratio", ratio)
    if not fraction:
        raise ValueError("ratio: expected a fraction above 0, got 0")
    return "ratio", fraction


def _shift_of(small: TriangleMesh, full: TriangleMesh) -> SurfaceShift | None:
    """Distance of the full surface to the simplified one. None if either has no area or non-finite corners."""
    if not can_be_compared(small, full):
        return None
    metrics = full.compute_metrics(small, n_sampled_points=DISTANCE_SAMPLES)
    return SurfaceShift(metrics.rms[0], metrics.max[0])
