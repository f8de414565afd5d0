"""Sample points on the mesh of a file: `sample_mesh_file`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Unpack

from ...core.errors import FileError, FilePath
from ...core.reports import Fields
from ...meshing.mesh.mesh_checks import find_wrong_corner
from .job import Job, JobReport, Settings


@dataclass(frozen=True)
class MeshSamplesReport(JobReport):
    device: str
    vertices_in: int
    triangles_in: int
    points: int
    even: bool
    seed: int
    area: float

    def fields(self) -> Fields:
        how = "evenly" if self.even else "each by itself"
        spacing = (self.area / self.points) ** 0.5 if self.points else 0.0
        return [
            ("triangles", f"{self.triangles_in:,}, {self.area:.4g} {self.m}^2"),
            ("points", f"{self.points:,}, drawn {how}, seed {self.seed}; one in {spacing:.3g} {self.m} squared"),
            *self.closing(self.device),
        ]


def sample_mesh_file(
    source: FilePath,
    output: FilePath,
    *,
    count: int,
    even: bool = False,
    triangle_normals: bool = False,
    seed: int = 0,
    **settings: Unpack[Settings],
) -> MeshSamplesReport:
    """Write points on the surface of a mesh as a cloud. Nothing if it has no area.

    `even` uses Poisson disk sampling, `triangle_normals` the normals of triangles.
    """
    job = Job("sample-mesh", source, **settings)
    job.check(output)
    mesh = job.read_mesh()
    if (wrong := find_wrong_corner(mesh)) is not None:
        raise FileError(source, wrong, remedy="Remove such triangles with pointloom clean-mesh first")
    area, points = mesh.get_surface_area(), 0
    warning = None if area > 0 else "the mesh has no area to draw points from; nothing was written"
    if warning is None:
        with job.stage("sample"):
            draw = mesh.sample_points_poisson_disk if even else mesh.sample_points_uniformly
            cloud = draw(count, use_triangle_normal=triangle_normals, seed=seed)
            points = len(cloud)
        job.write_cloud(cloud, output)
    before = len(mesh.vertices), len(mesh)
    return MeshSamplesReport(job.done(warning), str(mesh.device), *before, points, even, seed, area)
