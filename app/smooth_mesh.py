"""The mesh of a file smoothed: `smooth_mesh_file`."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ..meshing.mesh import TriangleMesh
from .clouds import FilePath, closing_fields
from .console import format_share
from .mesh_job import MeshJob, size_fields, sizes_of

METHODS = ("taubin", "laplacian", "simple", "sharpen")
SHRUNK = 0.1  # of the area: more, and the shape goes with the noise


def smooth_mesh_file(
    source: FilePath,
    output: FilePath,
    *,
    method: str = "taubin",
    iterations: int = 10,
    lambda_filter: float = 0.5,
    mu: float = -0.53,
    strength: float = 1.0,
    **settings: Any,
) -> dict[str, Any]:
    """Write a mesh with smoothed vertices, normals and colours.

    Args:
        source: A mesh.
        output: A mesh.
        method: One of METHODS, by `TriangleMesh.filter_smooth_...` or `filter_sharpen`.
        iterations: How often.
        lambda_filter: Of taubin and laplacian.
        mu: Of taubin.
        strength: Of sharpen.
        settings: device, as_text, overwrite and progress as of `MeshJob`.

    Returns:
        What was done, in JSON's types: how far vertices moved [m], and the area before and after.

    Raises:
        FileError: A file that cannot be read or written.
        ValueError: No such method, or a number out of range.
        DeviceError: No such device.
    """
    job = MeshJob("smooth-mesh", source, output, **settings)
    with job.stages(method):
        mesh = _smooth(job.mesh, method, iterations, lambda_filter, mu, strength)
    moved = np.linalg.norm(mesh.vertices - job.mesh.vertices, axis=1)
    moved = moved[np.isfinite(moved)]
    areas = job.mesh.get_surface_area(), mesh.get_surface_area()
    job.write(mesh)
    found = {
        "method": method,
        "iterations": iterations,
        "moved": {"mean": float(moved.mean()), "max": float(moved.max())} if len(moved) else None,
        "area_in": areas[0],
        "area": areas[1],
    }
    return job.report(poor=_why_poor(mesh, method, *areas)) | sizes_of(mesh) | found


def smooth_mesh_fields(report: dict[str, Any]) -> list[tuple[str, str]]:
    """What was done as labels and values for the terminal."""
    moved = report["moved"]
    return [
        ("method", f"{report['method']}, {report['iterations']:,} times"),
        *size_fields(report)[1:],
        ("moved", f"{moved['mean']:.3g} m mean, {moved['max']:.3g} m at most" if moved else "no vertex is finite"),
        ("area", f"{report['area']:.4g} of {report['area_in']:.4g} m^2"),
        *closing_fields(report),
    ]


def _smooth(
    mesh: TriangleMesh, method: str, iterations: int, lambda_filter: float, mu: float, strength: float
) -> TriangleMesh:
    if method == "taubin":
        return mesh.filter_smooth_taubin(iterations, lambda_filter, mu)
    if method == "laplacian":
        return mesh.filter_smooth_laplacian(iterations, lambda_filter)
    if method == "simple":
        return mesh.filter_smooth_simple(iterations)
    if method == "sharpen":
        return mesh.filter_sharpen(iterations, strength)
    raise ValueError(f"method: expected one of {', '.join(METHODS)}, got {method!r}")


def _why_poor(mesh: TriangleMesh, method: str, before: float, after: float) -> str | None:
    if not len(mesh):
        return "the mesh has no triangles, and nothing was written"
    change = after / before - 1 if before > 0 else 0.0
    if not math.isfinite(change) or (method == "sharpen" and change > 1):
        return f"the area grew {after / before:.3g} times: take fewer --iterations or a smaller --strength"
    if method != "sharpen" and change < -SHRUNK:
        return f"{format_share(-change)} of the area are gone with the noise: take fewer --iterations" + (
            "" if method == "taubin" else ", or --method taubin, which shrinks less"
        )
    return None
