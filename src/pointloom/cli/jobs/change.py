"""Change between two files: `change_files` by M3C2 of two clouds or cloud to mesh."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple, Unpack

import numpy as np
from numpy.typing import NDArray

from ...core.errors import FileError, FilePath
from ...core.reports import Fields
from ...core.units import UnitWarning, without_warnings
from ...core.wording import format_fraction
from ...io.meshes import tables
from ...io.points.by_extension import columns_of
from ...io.points.formats import storing
from ...io.points.point_cloud import cloud_of, table_of
from ...io.table import MeshTable
from ...meshing.mesh.mesh import TriangleMesh
from ...meshing.mesh.mesh_files import mesh_of
from ...meshing.scene.cloud_change import compare_cloud_to_mesh
from ...pcd.change import m3c2
from ...pcd.cloud import PointCloud
from ...pcd.point_spacing import distance_of_nearest, probe_points, rounded_up
from ...pcd.search import NearestNeighborSearch
from ...pcd.units import common_reference
from ...visualization.change.pictures import draw_change, paint_change
from ...visualization.render.picture_files import check_picture
from .job import Job, JobReport, Settings, in_words_of_command
from .report_page import check_report_page, write_report_page
from .rows import with_positions

CYLINDER_POINTS = 20  # points of the first epoch in a cylinder of the default radius
NORMAL_RADII = (1.0, 2.0, 4.0)  # over the cylinder radius
MAX_DISTANCE_FACTOR = 6.0  # maximum distance over the cylinder radius
UP_AXIS = (0.0, 0.0, 1.0)
OPTIONS = {"registration_error": "--registration-error", "max_distance": "--max-distance", "radii": "--cylinder"}


@dataclass(frozen=True)
class ChangeReport(JobReport):
    """Report of `change_files`.

    `cores`, `known` and `significant` are the numbers of core points, of those with a distance, and of those that
    changed by more than the level of detection. The latter have the given median and 98% range [m]. `level` is the
    median level of detection [m], `lengths` are the radii and the maximum distance [m].
    """

    later: str
    method: str
    device: str
    cores: int
    known: int
    significant: int
    median: float | None
    lowest: float | None
    highest: float | None
    level: float | None
    lengths: dict[str, Any]
    registration_error: float

    def fields(self) -> Fields:
        return [*self.figures(), *self.closing(self.device)]

    def figures(self) -> Fields:
        m, fraction = self.m, self.significant / max(self.known, 1)
        changed = f"{self.significant:,} of {self.known:,} points with a distance, {format_fraction(fraction)}"
        if self.median is not None:
            changed += f", by {self.median:.3g} {m} (median; 98 % by {self.lowest:.3g} to {self.highest:.3g})"
        level = (
            "none" if self.level is None else f"{self.level:.3g} {m} (median), registration {self.registration_error:g}"
        )
        lengths = ", ".join(
            f"{name.replace('_', ' ')} {_format_lengths(value)}" for name, value in self.lengths.items()
        )
        return [
            ("changed", changed),
            ("noise", level),
            ("measured", f"{self.method} at {self.cores:,} points, {lengths or 'point by point'} {m}".rstrip()),
        ]


@dataclass(frozen=True)
class ChangeOutputs:
    """Files that `change_files` writes.

    Attributes:
        points: Core points with distance and level of detection as attributes.
        painted: Core points in the colors of the image.
        picture: A .png or .webp file: change from blue to red, gray if not significant.
        report: An HTML page with the figures, the failed checks and the picture.
        limit: Distance of the darkest colors [m]. None fits them to the changes.
    """

    points: FilePath | None = None
    painted: FilePath | None = None
    picture: FilePath | None = None
    report: FilePath | None = None
    limit: float | None = None


@dataclass(frozen=True)
class ChangeMeasure:
    """How change is measured.

    By default half of the points have 20 neighbors within `cylinder_radius` [m], and `normal_radii` and `max_distance`
    follow from it. For a mesh, it is the radius of averaging. `cores` is the cell size of core points [m], None for all
    points.
    """

    cores: float | None = None
    normal_radii: Sequence[float] | None = None
    cylinder_radius: float | None = None
    max_distance: float | None = None
    registration_error: float = 0.0
    orientation: tuple[float, float, float] = UP_AXIS


def change_files(
    earlier: FilePath,
    later: FilePath,
    *,
    outputs: ChangeOutputs | None = None,
    measure: ChangeMeasure | None = None,
    **settings: Unpack[Settings],
) -> ChangeReport:
    """Measure how far a surface has moved from an earlier cloud or mesh to a later cloud, with the level of detection.

    Reliable as the result of `m3c2` or `compare_cloud_to_mesh`.
    """
    outputs, measure = outputs or ChangeOutputs(), measure or ChangeMeasure()
    job = Job("change", earlier, **settings)
    job.check(outputs.points, storing("labels"), what="attributes")
    job.check(outputs.painted, storing("colors"), what="colors")
    if outputs.picture is not None:
        check_picture(outputs.picture, overwrite=job.form["overwrite"])
    check_report_page(outputs.report, overwrite=job.form["overwrite"])
    with job.stage("read"):
        stored, first, after = _read(job, earlier, later, settings.get("columns"))
    if isinstance(first, PointCloud):
        compared, searched = _with_cloud(job, first, after, measure), first
    else:
        compared, searched = _with_mesh(job, first, after, measure), after
    _write(job, compared, outputs, stored if measure.cores is None else stored[_thinned_rows(searched, measure.cores)])
    if outputs.picture is not None or outputs.report is not None:
        _write_picture(job, later, compared, outputs, measure.registration_error)
    return _report(job, later, compared, measure.registration_error)


class Compared(NamedTuple):
    """Measurement: method, core points, result, columns besides the significance, and lengths."""

    method: str
    where: PointCloud
    result: Any
    columns: dict[str, NDArray[Any]]
    lengths: dict[str, Any]


def _read(
    job: Job, earlier: FilePath, later: FilePath, columns: Sequence[str] | None
) -> tuple[NDArray[Any], PointCloud | TriangleMesh, PointCloud]:
    """The positions to measure at as stored in their file, and both epochs."""
    paths = earlier, later
    tables_read = [tables.read_table(*each) for each in zip(paths, columns_of(paths, columns), strict=True)]
    job.unit = common_reference(f"{earlier}, {later}", tables_read)[0]
    first, second = tables_read
    if isinstance(second, MeshTable):
        raise FileError(later, "is a mesh", remedy="Pass the mesh first: the cloud is compared with it")
    after = _filled(cloud_of(second, later, device=job.device), later)
    if isinstance(first, MeshTable):
        return second.points, mesh_of(first, earlier, device=job.device), after
    return first.points, _filled(cloud_of(first, earlier, device=job.device), earlier), after


def _thinned_rows(cloud: PointCloud, spacing: float) -> NDArray[np.int32]:
    """The rows of the points that `thin` keeps."""
    rows = PointCloud.from_device_arrays({"points": cloud.arrays["points"]}, cloud.origin)
    rows["row"] = np.arange(len(cloud), dtype=np.int32)
    return rows.thin(spacing)["row"]


def _with_mesh(job: Job, mesh: TriangleMesh, after: PointCloud, measure: ChangeMeasure) -> Compared:
    where = after if measure.cores is None else after.thin(measure.cores)
    with job.stage("change"), without_warnings(UnitWarning):  # of the units that `_read` compared
        options = {"radius": measure.cylinder_radius, "max_distance": measure.max_distance}
        result = compare_cloud_to_mesh(where, mesh, registration_error=measure.registration_error, **options)
    columns = {"distance": result.distances, "beside": result.beside.astype(np.uint8)}
    return Compared("cloud to mesh", where, result, columns, {name: v for name, v in options.items() if v is not None})


def _with_cloud(job: Job, before: PointCloud, after: PointCloud, measure: ChangeMeasure) -> Compared:
    where = before if measure.cores is None else before.thin(measure.cores)
    radius = measure.cylinder_radius or _radius_for(before, job.source)
    radii = measure.normal_radii or [radius * times for times in NORMAL_RADII]
    lengths = {
        "normal_radii": [*map(float, radii)],
        "cylinder_radius": radius,
        "max_distance": measure.max_distance or MAX_DISTANCE_FACTOR * radius,
    }
    with job.stage("change"), without_warnings(UnitWarning):  # of the units that `_read` compared
        options: dict[str, Any] = {"registration_error": measure.registration_error}
        options["orientation"] = measure.orientation
        result = m3c2(before, after, core_points=where, **lengths, **options)
    columns = {"distance": result.distances, "points_before": result.counts[:, 0], "points_after": result.counts[:, 1]}
    return Compared("m3c2", where, result, columns, lengths)


def _filled(cloud: PointCloud, path: FilePath) -> PointCloud:
    if not len(probe_points(cloud)):
        raise FileError(path, "contains no finite point, so there is nothing to compare", remedy="Pass another file")
    return cloud


def _radius_for(cloud: PointCloud, path: FilePath) -> float:
    distance = distance_of_nearest(NearestNeighborSearch(cloud), probe_points(cloud), CYLINDER_POINTS)
    if not distance:
        reason = f"has fewer than {CYLINDER_POINTS} points, or all at the same position"
        raise FileError(path, f"{reason}: the radius of the cylinder cannot be estimated", remedy="Pass --cylinder")
    return rounded_up(distance)


def _write(job: Job, compared: Compared, outputs: ChangeOutputs, stored: NDArray[Any]) -> None:
    where, result = compared.where, compared.result
    if outputs.points is not None:
        cloud = where.copy()
        for name, values in compared.columns.items():
            cloud[name] = values.astype(np.float32) if values.dtype == np.float64 else np.ascontiguousarray(values)
        cloud["level_of_detection"] = result.level_of_detection.astype(np.float32)
        cloud["significant"] = result.is_significant.astype(np.uint8)
        job.write_points(with_positions(table_of(cloud), stored), outputs.points)
    if outputs.painted is not None:
        painted = table_of(paint_change(where, result, limit=outputs.limit))
        job.write_points(with_positions(painted, stored), outputs.painted)


def _write_picture(job: Job, later: FilePath, compared: Compared, outputs: ChangeOutputs, error: float) -> None:
    """Write the picture and the page with it."""
    overwrite = job.form["overwrite"]
    with job.stage("picture"):
        picture = draw_change(
            compared.where, compared.result, outputs.picture, limit=outputs.limit, overwrite=overwrite
        )
    if outputs.picture is not None:
        job.wrote(outputs.picture)
    if outputs.report is None:
        return
    with job.stage("report"):
        report = _report(job, later, compared, error)
        fields: Fields = [("before", os.fspath(job.source)), ("after", os.fspath(later)), *report.figures()]
        title = f"Change, {Path(job.source).name} to {Path(later).name}"
        pictures = [("Distances at the core points. Gray: below the level of detection at 95%", picture)]
        write_report_page(outputs.report, title, fields, report.warnings, pictures, overwrite=overwrite)
    job.wrote(outputs.report)


def _report(job: Job, later: FilePath, compared: Compared, registration_error: float) -> ChangeReport:
    result, method = compared.result, compared.method
    known, changed = np.isfinite(result.distances), result.is_significant
    moved = result.distances[changed]
    ends = [float(value) for value in np.quantile(moved, (0.5, 0.01, 0.99))] if len(moved) else [None] * 3
    levels = result.level_of_detection[np.isfinite(result.level_of_detection)]
    return ChangeReport(
        job.done(*in_words_of_command(result.warnings, OPTIONS)),
        os.fspath(later),
        method,
        str(job.device),
        len(known),
        int(known.sum()),
        int(changed.sum()),
        *ends,
        level=float(np.median(levels)) if len(levels) else None,
        lengths=compared.lengths,
        registration_error=registration_error,
    )


def _format_lengths(value: Any) -> str:
    return ", ".join(f"{one:.3g}" for one in value) if isinstance(value, list) else f"{value:.3g}"
