"""The mesh of a file mended: `clean_mesh_file`."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

from .clouds import FilePath, closing_fields
from .console import format_share
from .mesh_job import MeshJob, size_fields, sizes_of

MOST_MERGED = 0.5  # of the vertices: a larger merge distance was likely meant for another mesh or unit

# What repair removes or changes, in words; the rest of its report is what it found at the end.
_DONE = {
    "removed_non_finite_triangles": "triangles that are not finite removed",
    "merged_vertices": "vertices merged",
    "removed_degenerate_triangles": "degenerate triangles removed",
    "removed_duplicated_triangles": "repeated triangles removed",
    "removed_crowding_triangles": "triangles at crowded edges removed",
    "flipped_triangles": "triangles turned",
    "filled_holes": "holes filled",
    "added_triangles": "triangles added",
}


def clean_mesh_file(
    source: FilePath,
    output: FilePath,
    *,
    merge: float | None = None,
    fill: float | None = None,
    min_triangles: int = 1,
    min_area: float = 0.0,
    **settings: Any,
) -> dict[str, Any]:
    """Write a mesh without what is commonly wrong with one, and say what was done and what is still wrong.

    Args:
        source: A mesh.
        output: A mesh.
        merge: Vertices closer than this become one [m]; None for those at one position.
        fill: Holes of up to this radius [m] are closed; None for none.
        min_triangles: Parts with fewer triangles go.
        min_area: Parts with a smaller area [m^2] go.
        settings: device, as_text, overwrite and progress as of `MeshJob`.

    Returns:
        What was done, in JSON's types, with what `TriangleMesh.repair` reports. Nothing is written where no triangle is
        left.

    Raises:
        FileError: A file that cannot be read or written.
        ValueError: A number out of range.
        DeviceError: No such device.
    """
    job = MeshJob("clean-mesh", source, output, **settings)
    with job.stages("repair"):
        mesh, done = job.mesh.repair(merge_distance=merge, hole_size=fill)
    with job.stages("parts"):
        _, counts, areas = mesh.cluster_connected_triangles()
        small = int(((counts < min_triangles) | (areas < min_area)).sum())
        if small:
            mesh = mesh.remove_small_components(min_triangles, min_area)
    with job.stages("check"):
        crossings = len(mesh.get_self_intersecting_triangles())
    job.write(mesh)
    found = asdict(done) | {"removed_parts": small, "parts": len(counts) - small, "self_intersections": crossings}
    if small:
        found |= {"is_watertight": mesh.is_watertight(), "boundary_edges": len(mesh.get_boundary_edges())}
    report = job.report(poor=_why_poor(len(mesh), len(job.mesh.vertices), found, merge, fill))
    return report | sizes_of(mesh) | found


def clean_mesh_fields(report: dict[str, Any]) -> list[tuple[str, str]]:
    """What was done as labels and values for the terminal."""
    did = [f"{report[name]:,} {words}" for name, words in _DONE.items() if report[name]]
    if report["removed_parts"]:
        did.append(f"{report['removed_parts']:,} small parts removed")
    left = {
        "boundary_edges": "edges at a border",
        "holes_left": "holes not filled",
        "non_manifold_vertices": "vertices where parts only touch",
        "zero_area_triangles": "triangles without area",
        "self_intersections": "pairs of triangles that cut through each other",
    }
    still = [f"{report[name]:,} {words}" for name, words in left.items() if report[name]]
    if not report["is_orientable"]:
        still.append("a part with one side only")
    return [
        *size_fields(report),
        ("parts", f"{report['parts']:,}"),
        ("done", "; ".join(did) or "nothing to mend"),
        ("left", "; ".join(still) or "nothing wrong"),
        ("closed", "yes" if report["is_watertight"] else "no"),
        *closing_fields(report),
    ]


def _why_poor(
    triangle_count: int, vertex_count: int, found: dict[str, Any], merge: float | None, fill: float | None
) -> str | None:
    if not triangle_count:
        return "no triangle is left, and nothing was written"
    reasons = []
    if merge is not None and found["merged_vertices"] > MOST_MERGED * vertex_count:
        share = format_share(found["merged_vertices"] / vertex_count)
        reasons.append(f"{share} of the vertices were merged: take a smaller --merge than {merge:g} m")
    if fill is not None and found["holes_left"]:
        reasons.append(f"{found['holes_left']:,} holes of up to {fill:g} m are left open")
    if not found["is_orientable"]:
        reasons.append("a part has one side only, as a Moebius strip: there is no inside")
    return "; ".join(reasons) or None
