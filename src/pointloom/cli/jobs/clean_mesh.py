"""Repair the mesh of a file: `clean_mesh_file`."""

from __future__ import annotations

from typing import Unpack

from ...core.errors import FilePath
from ...io.meshes.mesh_formats import MESH_FORMATS
from ...meshing.mesh.cleaned_mesh import clean_mesh
from .announced_stages import AnnouncedStages
from .job import Job, Settings
from .result_report import ResultReport


def clean_mesh_file(
    source: FilePath,
    output: FilePath,
    *,
    merge: float | None = None,
    fill: float | None = None,
    min_triangles: int = 1,
    min_area: float = 0.0,
    **settings: Unpack[Settings],
) -> ResultReport:
    """Write a repaired mesh and report the repairs and remaining defects. Nothing if no triangle is left.

    `merge` and `fill` are `merge_distance` and `hole_size` of `clean_mesh`.
    """
    job = Job("clean-mesh", source, **settings)
    job.check(output, MESH_FORMATS, what="meshes")
    mesh = job.read_mesh()
    with AnnouncedStages(job.clock, job.progress) as stages:
        sizes = {"merge_distance": merge, "hole_size": fill, "min_area": min_area}
        result = clean_mesh(mesh, **sizes, min_triangles=min_triangles, progress=stages)
    job.write_mesh(result.mesh, output)
    return ResultReport(job.done(*result.warnings), result, str(mesh.device))
