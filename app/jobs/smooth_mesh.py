"""The mesh of a file smoothed: `smooth_mesh_file`."""

from __future__ import annotations

from typing import Any, Unpack

from ...core.errors import FilePath
from ...files.meshes import tables
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
    """Write a mesh with smoothed vertices, normals and colours.

    Args:
        source: A mesh.
        output: A mesh.
        method, iterations: As of `smooth_mesh`.
        factors: The method's own, by their names there.
        settings: As of `Settings`.

    Returns:
        What was done, with the SmoothedMesh. A mesh without triangles is not written.

    Raises:
        FileError: A file that cannot be read or written.
        ValueError: No such method, or a number out of range.
        DeviceError: No such device.
    """
    job = Job("smooth-mesh", source, **settings)
    job.check(output, tables.MESHES, what="meshes")
    mesh = job.read_mesh()
    with job.stage(method):
        found = smooth_mesh(mesh, method, iterations, **factors or {})
    job.write_mesh(found.mesh, output)
    return ResultReport(job.done(*found.warnings), found, str(mesh.device))
