"""Surface reconstruction from a point file: `mesh_file`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ...core.devices import DeviceLike
from ...core.errors import FilePath
from ...core.progress import ReportProgress
from ...io.meshes.mesh_formats import MESH_FORMATS
from ...meshing.mesh.cloud_surface import create_surface
from ...visualization.render.picture_files import check_picture, write_image
from ...visualization.render.surface_picture import draw_surface
from .announced_stages import AnnouncedStages
from .job import Job
from .result_report import ResultReport


def mesh_file(
    source: FilePath,
    output: FilePath,
    *,
    picture: FilePath | None = None,
    device: DeviceLike = "auto",
    as_text: bool = False,
    overwrite: bool = False,
    progress: ReportProgress | None = None,
    up: str | None = None,
    columns: Sequence[str] | None = None,
    **options: Any,
) -> ResultReport:
    """Write a surface through the points of a cloud and its image. Outputs are checked before the work.

    An empty mesh is not written. STL has no normals and colors. `options` are those of `create_surface`.
    """
    form = {"as_text": as_text, "overwrite": overwrite, "up": up}
    job = Job("mesh", source, device=device, progress=progress, columns=columns, **form)
    job.check(output, MESH_FORMATS, what="meshes")
    if picture is not None:
        check_picture(picture, overwrite=overwrite)
    cloud = job.read_cloud()
    with AnnouncedStages(job.clock, job.progress) as stages:
        result = create_surface(cloud, progress=stages, **options)
    job.write_mesh(result.mesh, output)
    if picture is not None and len(result.mesh):
        with job.stage("picture"):
            write_image(picture, draw_surface(result.mesh), overwrite=overwrite)
        job.wrote(picture)
    return ResultReport(job.done(*result.warnings), result, str(cloud.device))
