"""Conversion and normals of point files: `convert_file` and `estimate_normals_of_file`."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Unpack

import numpy as np

from ...core.errors import FileError, FilePath
from ...core.reports import Fields
from ...io.meshes import tables
from ...io.meshes.mesh_formats import MESH_FORMATS
from ...io.points.formats import WRITTEN, storing
from ...io.table import MeshTable
from .job import Job, JobReport, Settings


@dataclass(frozen=True)
class ConvertReport(JobReport):
    """Report of `convert_file`; `kind` is "mesh" or "point cloud", `points` includes vertices."""

    kind: str
    points: int
    triangles: int | None = None

    def title(self, source: str) -> str:
        return f"{source}: {self.kind}"

    def to_dict(self) -> dict[str, Any]:
        return {name: value for name, value in super().to_dict().items() if name != "triangles" or value is not None}

    def fields(self) -> Fields:
        count = f"{self.points:,}"
        if self.triangles is None:
            return [("points", count), *self.closing()]
        return [("vertices", count), ("triangles", f"{self.triangles:,}"), *self.closing()]


def convert_file(
    source: FilePath,
    output: FilePath,
    *,
    as_text: bool = False,
    overwrite: bool = False,
    up: str | None = None,
    columns: Sequence[str] | None = None,
) -> ConvertReport:
    """Write a cloud or mesh in another format without rounding. A mesh becomes a cloud if the output has no triangles.

    In .las and .laz, coordinates are rounded to thousandths, unless the source is LAS: then its scale and coordinate
    system are kept. From a y-up file to another, `up` "z" rotates a mesh that was stored with z up. Warns
    if 16-bit colors are rounded, attributes are renamed, or records are omitted.
    """
    job = Job("convert", source, as_text=as_text, overwrite=overwrite, up=up, columns=columns)
    job.check(output, dict.fromkeys((*WRITTEN, *MESH_FORMATS)), what="clouds and meshes")
    suffix = Path(output).suffix.lower()
    with job.stage("read"):  # between two y-up files, `up` is the axis of the stored data
        table = tables.read_table(source, columns, up="y") if job.is_within_upright(output) else job.read_table()
    if isinstance(table, MeshTable) and suffix in MESH_FORMATS:
        with job.stage("write"):
            job.write_table(table, output)
        return ConvertReport(job.done(), "mesh", len(table.vertices), len(table.triangles))
    if suffix not in WRITTEN:
        raise FileError(source, f"contains no triangles, which {suffix} needs", remedy="Write .ply or .pcd")
    if isinstance(table, MeshTable):
        job.left_out += ["triangles"] + ["textures"] * (table.triangle_uvs is not None)
        table = tables.points_of(table)
    job.write_points(table, output)
    return ConvertReport(job.done(), "point cloud", len(table.points))


@dataclass(frozen=True)
class NormalsReport(JobReport):
    device: str
    radius: float | None
    max_nn: int
    points: int

    def fields(self) -> Fields:
        return [("points", f"{self.points:,}"), *self.closing(self.device)]


def estimate_normals_of_file(
    source: FilePath,
    output: FilePath,
    *,
    radius: float | None = None,
    max_nn: int = 30,
    toward: tuple[float, float, float] | None = None,
    direction: tuple[float, float, float] | None = None,
    **settings: Unpack[Settings],
) -> NormalsReport:
    """Write a cloud with estimated normals, optionally oriented `toward` a point [m] or in a `direction`.

    Uses `max_nn` neighbors (with the point) within `radius` [m] or at any distance.
    """
    job = Job("normals", source, **settings)
    job.check(output, storing("normals"), what="normals")
    table, cloud = job.read_exact_cloud()
    with job.assessed("normals", {"radius": "--radius"}):
        with_normals = cloud.estimate_normals(radius=radius, max_nn=max_nn)
        if toward is not None:
            with_normals = with_normals.orient_normals_towards_camera_location(toward)
        if direction is not None:
            with_normals = with_normals.orient_normals_to_align_with_direction(direction)
    warning = (
        None if np.isfinite(cloud.points).all(axis=1).any() else "no point is finite, so no normals were estimated"
    )
    job.write_points(replace(table, normals=with_normals.normals), output)
    return NormalsReport(job.done(warning), str(cloud.device), radius, max_nn, len(cloud))
