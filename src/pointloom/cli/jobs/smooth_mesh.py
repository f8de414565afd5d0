"""Smooth the mesh of a file: `smooth_mesh_file`."""

from __future__ import annotations

from typing import Any, Unpack

from ...core.errors import FilePath
from ...io.meshes.mesh_formats import MESH_FORMATS
from ...meshing.mesh.smoothed_mesh import smooth_mesh
from .job import Job, Settings
from .result_report import ResultReport


def smooth_mesh_file(
    source: FilePath,
    output: FilePath,
    *,
    method: str = "taubin",
    iterations: int = 10,
    factors: dict[str, Any] | None = None,
    **settings: Unpack[Settings],
) -> ResultReport:
    """Write a mesh with smoothed vertices, normals and colors; `factors` are the parameters of the method."""
    job = Job("smooth-mesh", source, **settings)
    job.check(output, MESH_FORMATS, what="meshes")
    mesh = job.read_mesh()
    with job.stage(method):
        result = smooth_mesh(mesh, method, iterations, **factors or {})
    job.write_mesh(result.mesh, output)
    return ResultReport(job.done(*result.warnings), result, str(mesh.device))
