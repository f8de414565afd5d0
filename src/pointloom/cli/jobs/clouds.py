"""Conversion and normals of point files: `convert_file` and `estimate_normals_of_file`."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Unpack

import numpy as np

from ...core.errors import FileError, FilePath
from ...core.escaped_text import escaped
from ...core.reports import Fields
from ...core.units import symbol_of
from ...core.wording import format_fraction
from ...io.meshes import tables
from ...io.points.formats import WRITTEN
from ...io.table import MeshTable, PointTable
from .job import Job, JobReport, Settings

if TYPE_CHECKING:
    from ...pcd.cloud import PointCloud

OF_8_BITS = (".ply", ".pcd", ".pts", ".e57")
COLOR_STEP = 1 / 65535  # of the finest integer colors in files
WITH_NORMALS = (".ply", ".pcd", ".npz", ".xyzn", ".las", ".laz", ".e57")


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
    up: str = "y",
    columns: Sequence[str] | None = None,
) -> ConvertReport:
    """Write a cloud or mesh in another format without rounding. A mesh becomes a cloud if the output has no triangles.

    In .las and .laz, coordinates are rounded to thousandths, unless the source is LAS: then its scale and coordinate
    system are kept. Warns if 16-bit colors are rounded, attributes are renamed, or records are omitted.
    """
    job = Job("convert", source, as_text=as_text, overwrite=overwrite, up=up, columns=columns)
    allowed = (*WRITTEN, *(suffix for suffix in tables.MESHES if suffix not in WRITTEN))
    job.check(output, allowed, what="clouds and meshes")
    with job.stage("read"):
        table = job.read_table()
    suffix = Path(output).suffix.lower()
    if isinstance(table, MeshTable) and suffix in tables.MESHES:
        with job.stage("write"):
            job.write_table(table, output)
        return ConvertReport(job.done(), "mesh", len(table.vertices), len(table.triangles))
    if suffix not in WRITTEN:
        raise FileError(source, f"contains no triangles, which {suffix} needs", remedy="Write .ply or .pcd")
    if isinstance(table, MeshTable):
        job.left_out += ["triangles"] + ["textures"] * (table.triangle_uvs is not None)
        table = tables.points_of(table)
    job.write_points(table, output)
    if Path(source).suffix.lower() in (*tables.LAS, ".e57"):
        _warn_of_rounded_colors(output, table)
    return ConvertReport(job.done(), "point cloud", len(table.points))


def _warn_of_rounded_colors(output: FilePath, table: PointTable) -> None:
    """Warn if a format has fewer bits for colors than the table."""
    suffix = Path(output).suffix.lower()
    if table.colors is None or suffix not in OF_8_BITS:
        return
    full = np.float32(255)
    if (np.abs(np.rint(table.colors * full) / full - table.colors) > COLOR_STEP / 2).any():
        message = f"{output}: colors are rounded to the 8 bits a channel of {suffix}; .laz and .npz keep 16"
        warnings.warn(escaped(message), UserWarning, stacklevel=3)


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
    job.check(output, WITH_NORMALS, what="normals")
    cloud = job.read_cloud()
    with job.stage("normals", judged=True):
        with_normals = cloud.estimate_normals(radius=radius, max_nn=max_nn)
        if toward is not None:
            with_normals = with_normals.orient_normals_towards_camera_location(toward)
        if direction is not None:
            with_normals = with_normals.orient_normals_to_align_with_direction(direction)
    with job.stage("check"):
        warning = None if radius is None else _warning(cloud, radius)
    job.write_cloud(with_normals, output)
    return NormalsReport(job.done(warning), str(cloud.device), radius, max_nn, len(cloud))


def _warning(cloud: PointCloud, radius: float) -> str | None:
    """Warn if the radius is so small that most points have no plane, from a sample."""
    from ...pcd.point_spacing import distance_of_nearest, probe_points, rounded_up
    from ...pcd.search import NearestNeighborSearch

    probes, search = probe_points(cloud), NearestNeighborSearch(cloud)
    if not len(probes):
        return "no point is finite, so no normals were estimated"
    isolated = float(np.mean(search.hybrid_search(probes, radius, 3).counts < 3))
    if isolated <= 0.5:
        return None
    m = symbol_of(cloud.unit)
    few = f"{format_fraction(isolated)} of the points have fewer than 3 neighbors within {radius:g} {m}"
    reason = f"{few}, so their normals are meaningless"
    third = distance_of_nearest(search, probes, 3)
    if third is None:
        return f"{reason}; the cloud has fewer points"
    return f"{reason}; half of the points have 3 within {rounded_up(third):g} {m}: use a larger --radius"
