"""Fewer triangles for the mesh of a file: `simplify_file`."""

from __future__ import annotations

import math
from typing import Any, Unpack

from ...core.errors import FilePath
from ...files.meshes import tables
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
    """Write a mesh of fewer triangles, and say how far it lies from the one that was read.

    Args:
        source: A mesh.
        output: A mesh.
        by: "triangles" for so many, "ratio" for a share of them, both by quadric decimation; "voxel" for one vertex a
            voxel.
        amount: The count, the share, or the edge of a voxel [m].
        max_error, boundary_weight: As of `simplify_mesh`.
        settings: As of `Settings`.

    Returns:
        What was done, with the SimplifiedMesh. Nothing is written where no triangle is left.

    Raises:
        FileError: A file that cannot be read or written.
        ValueError: An amount out of range.
        DeviceError: No such device.
    """
    job = Job("simplify", source, **settings)
    job.check(output, tables.MESHES, what="meshes")
    mesh = job.read_mesh()
    with AnnouncedStages(job.clock, job.tell) as told:
        wanted: dict[str, Any] = {_NAMES[by]: amount}
        found = simplify_mesh(mesh, **wanted, max_error=max_error, boundary_weight=boundary_weight, progress=told)
    job.write_mesh(found.mesh, output)
    return ResultReport(job.done(*found.warnings), found, str(mesh.device))
