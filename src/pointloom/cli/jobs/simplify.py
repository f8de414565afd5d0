"""Simplify the mesh of a file: `simplify_file`."""

from __future__ import annotations

import math
from typing import Any, Unpack

from ...core.errors import FilePath
from ...io.meshes.mesh_formats import MESH_FORMATS
from ...meshing.mesh.simplified_mesh import simplify_mesh
from .announced_stages import AnnouncedStages
from .job import Job, Settings
from .result_report import ResultReport

_NAMES = {"triangles": "triangles", "ratio": "ratio", "voxel": "voxel_size"}


def simplify_file(
    source: FilePath,
    output: FilePath,
    *,
    by: str,
    amount: float,
    max_error: float = math.inf,
    boundary_weight: float = 1.0,
    **settings: Unpack[Settings],
) -> ResultReport:
    """Write a mesh with fewer triangles and report its distance from the original.

    `by` is "triangles" (count) or "ratio" (fraction), both by quadric decimation, or "voxel" (vertex clustering),
    `amount` the count, fraction or voxel size [m].
    """
    job = Job("simplify", source, **settings)
    job.check(output, MESH_FORMATS, what="meshes")
    mesh = job.read_mesh()
    with AnnouncedStages(job.clock, job.progress) as stages:
        wanted: dict[str, Any] = {_NAMES[by]: amount}
        result = simplify_mesh(mesh, **wanted, max_error=max_error, boundary_weight=boundary_weight, progress=stages)
    job.write_mesh(result.mesh, output)
    return ResultReport(job.done(*result.warnings), result, str(mesh.device))
