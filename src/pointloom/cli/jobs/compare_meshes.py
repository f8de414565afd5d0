"""Distances between the meshes of two files: `compare_mesh_files`."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any, Unpack

import numpy as np

from ...core.devices import DeviceLike
from ...core.errors import FileError, FilePath
from ...core.reports import Fields, quality
from ...core.wording import plain
from ...io.meshes.mesh_formats import storing
from ...meshing.mesh.conversion import mesh_table
from ...meshing.mesh.mesh import TriangleMesh
from ...meshing.mesh.mesh_checks import find_wrong_corner
from ...meshing.mesh.mesh_comparison import MeshComparison, compare_meshes
from ...meshing.mesh.mesh_files import read_triangle_mesh
from ...visualization.render.error_picture import draw_errors
from ...visualization.render.picture_files import write_image
from ...visualization.render.plots import check_plot
from ...visualization.render.surface_picture import looks_inwards
from .job import Job, JobReport, Settings

_TITLE = "distances of A from B, at the vertices of A"


@dataclass(frozen=True)
class ErrorMaps:
    """Outputs of the distances of the first mesh from the second: a colored mesh, and a .png image with a histogram."""

    mesh: FilePath | None = None
    picture: FilePath | None = None

    def check(self, job: Job) -> None:
        job.check(self.mesh, storing("colors"), what="colored meshes")
        if self.picture is not None:
            check_plot(self.picture, overwrite=job.form["overwrite"])

    def write(self, job: Job, first: TriangleMesh, second: TriangleMesh) -> None:
        if self.mesh is None and self.picture is None:
            return
        with job.stage("map"):
            colored, distances = first.compute_error_map(second)
        if self.picture is not None:
            with job.stage("picture"):
                image = draw_errors(first, np.asarray(distances), _TITLE, back_faces=not looks_inwards(first))
                write_image(self.picture, image, overwrite=job.form["overwrite"])
        if self.mesh is not None:
            job.write_table(mesh_table(colored), self.mesh)
        if self.picture is not None:
            job.wrote(self.picture)


@dataclass(frozen=True)
class ComparisonReport(JobReport):
    """Report of `compare_mesh_files`. The first file is the source."""

    second: str
    result: MeshComparison

    def to_dict(self) -> dict[str, Any]:
        done = self.done
        files = {"command": done.command, "first": done.source, "second": self.second}
        ends = {"seconds": done.seconds, "left_out": done.left_out, "files": done.files}
        return plain(files | self.result.to_dict() | ends | quality(self))

    def fields(self) -> Fields:
        return [*self.result.fields(), *self.closing(self.result.device)]


def compare_mesh_files(
    first: FilePath,
    second: FilePath,
    *,
    samples: int = 100_000,
    thresholds: list[float] | None = None,
    limit: float | None = None,
    maps: ErrorMaps | None = None,
    seed: int = 0,
    **settings: Unpack[Settings],
) -> ComparisonReport:
    """Measure distances between the surfaces of two meshes. Options as in `compare_meshes`."""
    job, drawn = Job("compare-meshes", first, **settings), maps or ErrorMaps()
    drawn.check(job)
    where = job.device
    with job.stage("read"):
        meshes = [_read(path, where, job.up_of(path)) for path in (first, second)]
    with job.stage("compare"):
        result = compare_meshes(*meshes, thresholds=thresholds, samples=samples, limit=limit, seed=seed)
    drawn.write(job, *meshes)
    return ComparisonReport(job.done(*result.warnings), os.fspath(second), result)


def _read(path: FilePath, device: DeviceLike, up: str | None) -> TriangleMesh:
    mesh = read_triangle_mesh(path, device=device, up=up)
    if (wrong := find_wrong_corner(mesh)) is not None:
        raise FileError(path, wrong, remedy="Remove such triangles with pointloom clean-mesh first")
    if not mesh.get_surface_area() > 0:
        raise FileError(path, "contains no triangle with a positive area, so no distance can be computed")
    return mesh
