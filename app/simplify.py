"""Fewer triangles for the mesh of a file: `simplify_file`."""

from __future__ import annotations

import math
from typing import Any

from ..meshing.mesh import TriangleMesh
from .clouds import FilePath, closing_fields
from .mesh_job import MeshJob, size_fields, sizes_of

MISSED = 1.05  # times the triangles wanted: more, and the target is missed
FAR = 0.01  # of the box's diagonal: a root mean square distance above this is another surface
SAMPLES = 20_000


def simplify_file(
    source: FilePath,
    output: FilePath,
    *,
    by: str,
    amount: float,
    max_error: float = math.inf,
    boundary_weight: float = 1.0,
    **settings: Any,
) -> dict[str, Any]:
    """Write a mesh of fewer triangles, and say how far it lies from the one that was read.

    Args:
        source: A mesh.
        output: A mesh.
        by: "triangles" for so many, "ratio" for a share of them, both by quadric decimation; "voxel" for one vertex a
            voxel.
        amount: The count, the share, or the edge of a voxel [m].
        max_error: Quadric decimation ends where a collapse would cost more than this.
        boundary_weight: Of borders in quadric decimation.
        settings: device, as_text, overwrite and progress as of `MeshJob`.

    Returns:
        What was done, in JSON's types; "errors" are distances [m] between the surfaces. Nothing is written where no
        triangle is left.

    Raises:
        FileError: A file that cannot be read or written.
        ValueError: No such way, or an amount out of range.
        DeviceError: No such device.
    """
    job = MeshJob("simplify", source, output, **settings)
    target = None
    with job.stages("simplify"):
        if by == "voxel":
            mesh = job.mesh.simplify_vertex_clustering(amount, "quadric")
        elif by in ("triangles", "ratio"):
            target = int(amount) if by == "triangles" else max(1, round(amount * len(job.mesh)))
            mesh = job.mesh.simplify_quadric_decimation(target, max_error, boundary_weight)
        else:
            raise ValueError(f"by: expected triangles, ratio or voxel, got {by!r}")
    with job.stages("check"):
        errors = _distances(mesh, job.mesh)
    job.write(mesh)
    found = {"by": by, "amount": amount, "target": target, "errors": errors}
    return job.report(poor=_why_poor(mesh, job.mesh, target, errors, max_error)) | sizes_of(mesh) | found


def simplify_fields(report: dict[str, Any]) -> list[tuple[str, str]]:
    """What was done as labels and values for the terminal."""
    ways = {"triangles": "to {:,.0f} triangles", "ratio": "to a share of {:g}", "voxel": "one vertex a voxel of {:g} m"}
    errors = report["errors"]
    distance = "none measured"
    if errors is not None:
        distance = f"{errors['rms']:.3g} m rms, {errors['max']:.3g} m at most"
    return [
        ("simplified", ways[report["by"]].format(report["amount"])),
        *size_fields(report),
        ("distance", distance),
        *closing_fields(report),
    ]


def _distances(mesh: TriangleMesh, full: TriangleMesh) -> dict[str, float] | None:
    """How far the full surface lies from the simplified one [m]; None where either has no area."""
    if not (mesh.get_surface_area() > 0 and full.get_surface_area() > 0):
        return None
    found = full.compute_metrics(mesh, n_sampled_points=SAMPLES)
    return {"rms": found.rms[0], "max": found.max[0]}


def _why_poor(
    mesh: TriangleMesh, full: TriangleMesh, target: int | None, errors: dict[str, float] | None, max_error: float
) -> str | None:
    if not len(mesh):
        return "no triangle is left, and nothing was written; take more triangles or smaller voxels"
    reasons = []
    if target is not None and len(mesh) > max(target * MISSED, target + 4) and math.isinf(max_error):
        reasons.append(f"{len(mesh):,} triangles are left where {target:,} were asked: mend it with clean-mesh first")
    low, high = full.get_axis_aligned_bounding_box()
    diagonal = math.dist(low, high)
    if errors is not None and errors["rms"] > FAR * diagonal:
        share = errors["rms"] / diagonal
        reasons.append(f"the surface moved by {share:.1%} of its size: take more triangles or smaller voxels")
    return "; ".join(reasons) or None
