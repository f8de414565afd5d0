"""Commands on heights of cells: `change_of_volume` and `contours_of_file`."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Unpack

import numpy as np

from ...core.errors import FileError, FilePath
from ...core.reports import Fields
from ...core.units import symbol_of
from ...io.meshes import tables
from ...io.points.by_extension import columns_of
from ...io.points.point_cloud import cloud_of
from ...io.table import MeshTable
from ...meshing.mesh.mesh import TriangleMesh
from ...meshing.mesh.mesh_files import mesh_of
from ...meshing.scene.volume_change import VolumeChange, volume_change
from ...pcd.change import MIN_POINTS, M3C2Result
from ...pcd.cloud import PointCloud
from ...pcd.contour_files import check_contour_file, joined_lines, write_contour_file
from ...pcd.geotiff import ENDINGS, check_geotiff
from ...pcd.raster import Raster, read_raster
from ...visualization.change.pictures import draw_change
from ...visualization.render.picture_files import check_picture, write_image
from ...visualization.viewer.view_files import cells_of_raster
from .job import Job, JobReport, Settings, in_words_of_command
from .report_page import check_report_page, write_report_page
from .result_report import ResultReport

OPTIONS = {"registration_error": "--registration-error", "max_gap": "--max-gap", "classify_ground": "pointloom ground"}


@dataclass(frozen=True)
class VolumeOutputs:
    """Files that `change_of_volume` writes.

    Attributes:
        difference: GeoTIFF of the height differences.
        picture: A .png or .webp file of them: from blue (lower) to red (higher), gray if not significant.
        report: An HTML page with the volumes and the picture.
        limit: Difference of the darkest colors [m]. None fits them to the changes.
    """

    difference: FilePath | None = None
    picture: FilePath | None = None
    report: FilePath | None = None
    limit: float | None = None


def change_of_volume(
    before: FilePath,
    after: FilePath,
    outputs: VolumeOutputs,
    *,
    cell: float | None = None,
    registration_error: float = 0.0,
    max_gap: float | None = None,
    **settings: Unpack[Settings],
) -> ResultReport:
    """Volumes of cut and fill between two clouds, meshes or GeoTIFF files. Reliable as that of `volume_change`."""
    job = Job("volume", before, **settings)
    overwrite = job.form["overwrite"]
    if outputs.difference is not None:
        check_geotiff(outputs.difference, overwrite=overwrite)
    if outputs.picture is not None:
        check_picture(outputs.picture, overwrite=overwrite)
    check_report_page(outputs.report, overwrite=overwrite)
    with job.stage("read"):
        paths = before, after
        epochs = [
            _read_surface(job, *each) for each in zip(paths, columns_of(paths, settings.get("columns")), strict=True)
        ]
    grids = [(path, epoch.cell) for path, epoch in zip(paths, epochs, strict=True) if isinstance(epoch, Raster)]
    if cell is None and not grids:
        raise FileError(before, "has no cells", remedy="Pass --cell, for 4 or more points per cell")
    if cell is not None and grids and grids[0][1] != cell:
        raise ValueError(f"--cell: expected {grids[0][1]:g}, that of {grids[0][0]}, got {cell:g}. Leave it out")
    job.unit = epochs[0].unit
    with job.assessed("volume", OPTIONS):
        result = volume_change(epochs[0], epochs[1], cell, registration_error=registration_error, max_gap=max_gap)
    picture = None
    if outputs.picture is not None or outputs.report is not None:
        with job.stage("picture"):
            picture = draw_change(*_changed_cells(result), limit=outputs.limit, title="difference of heights")
    if outputs.difference is not None:
        with job.stage("write"):
            result.difference.write(outputs.difference, overwrite=overwrite)
        job.wrote(outputs.difference)
    if outputs.picture is not None and picture is not None:
        write_image(outputs.picture, picture, overwrite=overwrite)
        job.wrote(outputs.picture)
    warnings = in_words_of_command(result.warnings, OPTIONS)
    if outputs.report is not None and picture is not None:
        fields = [("before", os.fspath(before)), ("after", os.fspath(after)), *_figures(result)]
        unit = symbol_of(result.unit)
        fields += [
            ("cell", f"{result.difference.cell:g} {unit}"),
            ("registration error", f"{registration_error:g} {unit}"),
        ]
        caption = "Heights after minus before. Gray: below the level of detection at 95%"
        title = f"Change of volume, {Path(before).name} to {Path(after).name}"
        write_report_page(outputs.report, title, fields, warnings, [(caption, picture)], overwrite=overwrite)
        job.wrote(outputs.report)
    return _VolumeReport(job.done(*warnings), result, str(job.device))


@dataclass(frozen=True)
class _VolumeReport(ResultReport):
    result: VolumeChange

    def fields(self) -> Fields:
        return [*_figures(self.result), *self.closing(self.device)]


def _figures(result: VolumeChange) -> Fields:
    return [(name, value) for name, value in result.fields() if name != "warning"]


def _read_surface(job: Job, path: FilePath, columns: Sequence[str] | None) -> PointCloud | TriangleMesh | Raster:
    if Path(path).suffix.lower() in ENDINGS:
        return read_raster(path)
    table = tables.read_table(path, columns)
    if isinstance(table, MeshTable):
        return mesh_of(table, path, device=job.device)
    return cloud_of(table, path, device=job.device)


def _changed_cells(result: VolumeChange) -> tuple[PointCloud, Any]:
    """The centers of the compared cells, and their change with its level of detection if that is known."""
    difference, levels = result.difference, result.level_of_detection
    is_known = np.isfinite(difference.values)
    cells, changes, limits = cells_of_raster(difference), difference.values[is_known], levels[is_known]
    changes = changes.astype(np.float64)
    if not np.isfinite(limits).any():
        return cells, changes
    unknown = np.full(len(changes), np.nan)
    up = np.tile(np.array([0, 0, 1], np.float32), (len(changes), 1))
    counts = np.full((len(changes), 2), MIN_POINTS, np.int32)
    return cells, M3C2Result(changes, limits, up, unknown, np.column_stack([unknown, unknown]), counts)


@dataclass(frozen=True)
class ContourReport(JobReport):
    """`lines` is the number of polylines, `lowest` and `highest` are the heights of the outermost."""

    lines: int
    levels: int
    lowest: float | None
    highest: float | None
    crs: str | None

    def fields(self) -> Fields:
        heights = (
            "none" if self.lowest is None else f"{self.levels:,} from {self.lowest:g} to {self.highest:g} {self.m}"
        )
        return [
            ("contours", f"{self.lines:,} lines"),
            ("heights", heights),
            ("system", self.crs or "unknown"),
            *self.closing(),
        ]


def contours_of_file(
    source: FilePath, output: FilePath, *, interval: float, **settings: Unpack[Settings]
) -> ContourReport:
    """Write the contour lines of a GeoTIFF, see `Raster.write_contours`."""
    job = Job("contours", source, **settings)
    overwrite = job.form["overwrite"]
    check_contour_file(output, overwrite=overwrite)
    with job.stage("read"):
        raster = read_raster(source)
    job.unit = raster.unit
    with job.stage("contours"):
        lines = raster.contour_lines(interval)
        polylines = joined_lines(lines)
    with job.stage("write"):
        write_contour_file(output, polylines, raster.crs, overwrite=overwrite)
    job.wrote(output)
    heights = np.unique(lines.points[:, 2])
    ends = (float(heights[0]), float(heights[-1])) if len(heights) else (None, None)
    warning = None if len(heights) else "no contour line crosses the raster"
    return ContourReport(job.done(warning), len(polylines), len(heights), *ends, raster.crs)
