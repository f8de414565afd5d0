"""Commands of surveyors on files: ground, dtm, merge, transform, split."""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Unpack

import numpy as np
from numpy.typing import NDArray

from ...cameras.pose_text import read_pose
from ...core.coordinate_systems import check_crs
from ...core.coordinates import finite_box
from ...core.errors import FileError, FilePath
from ...core.joined_parts import MissingPartsWarning
from ...core.reports import Fields
from ...core.units import without_warnings
from ...core.wording import few_of, format_fraction
from ...io.meshes import tables
from ...io.meshes.mesh_formats import MESH_FORMATS
from ...io.points.formats import WRITTEN, storing
from ...io.points.las_writer import default_steps, fits_steps
from ...io.points.point_cloud import table_of
from ...io.table import PointTable
from ...kernels.linear_algebra import inv
from ...meshing.mesh.mesh import TriangleMesh
from ...pcd.cloud import PointCloud
from ...pcd.geotiff import ENDINGS, check_geotiff
from ...pcd.ground import TERRAIN_SLOPE, SlopeWarning, classify_ground
from ...pcd.raster_cells import NoGroundError
from ...pcd.terrain import rasterize
from .job import Job, JobReport, Settings
from .rows import RowsReport, label_rows, moved_exactly, read_rows, with_positions

GROUND_CLASS, OTHER_CLASS = 2, 1  # of LAS
MAX_FILES = 1000  # of split: more are probably values that are not classes
MAX_LISTED = 5


@dataclass(frozen=True)
class GroundReport(RowsReport):
    """`points` is the number of ground points."""

    replaced: tuple[str, ...]

    def fields(self) -> Fields:
        fraction = format_fraction(self.points / self.points_in)
        ground = f"{self.points:,} of {self.points_in:,} points, {fraction} (class 2)"
        return [("ground", ground), *self.closing(self.device, self.replaced)]


def classify_ground_of_file(
    source: FilePath,
    output: FilePath,
    *,
    cell_size: float,
    slope: float = TERRAIN_SLOPE,
    max_window: float,
    **settings: Unpack[Settings],
) -> GroundReport:
    """Write a cloud with class 2 for ground. Other points of class 0, 2 or none get class 1."""
    job = Job("ground", source, **settings)
    job.check(output, storing("labels"), what="classes")
    rows = read_rows(job)
    if not len(rows.cloud):
        raise FileError(source, "contains no points")
    with job.assessed("ground", {"slope": "--slope"}, SlopeWarning):
        is_ground = np.asarray(classify_ground(rows.cloud, cell_size, slope, max_window))
    classes = rows.table.attributes.get("classification", np.zeros(len(is_ground), np.uint8))
    rest = np.where(np.isin(classes, (0, GROUND_CLASS)), OTHER_CLASS, classes)
    table, replaced = label_rows(rows.table, "classification", np.where(is_ground, GROUND_CLASS, rest).astype(np.uint8))
    job.write_points(table, output)
    count = int(is_ground.sum())
    warning = None if count else "no point is ground; use a larger --cell or --slope"
    return GroundReport(job.done(warning), str(job.device), len(is_ground), count, tuple(replaced))


@dataclass(frozen=True)
class DtmReport(JobReport):
    device: str
    kind: str
    shape: tuple[int, int]
    cell: float
    known: int
    filled: int
    crs: str | None

    def fields(self) -> Fields:
        rows, columns = self.shape
        size = f"{columns:,} x {rows:,} cells of {self.cell:g} {self.m}, {self.known:,} with a value"
        return [
            (self.kind, size),
            ("filled gaps", f"{self.filled:,} cells"),
            ("system", self.crs or "unknown"),
            *self.closing(self.device),
        ]


def rasterize_file(
    source: FilePath,
    output: FilePath,
    *,
    cell: float,
    kind: str = "dtm",
    method: str = "idw",
    fill: float | None = None,
    crs: str | None = None,
    **settings: Unpack[Settings],
) -> DtmReport:
    """Write a raster of a classified cloud as GeoTIFF, see `rasterize`. `fill` is the reach of `Raster.fill_gaps`."""
    job = Job("dtm", source, **settings)
    job.check(output, ENDINGS, what="rasters")
    overwrite = job.form["overwrite"]
    check_geotiff(output, overwrite=overwrite)
    cloud = job.read_cloud()
    with job.stage("rasterize"):
        try:
            raster = rasterize(cloud, cell, kind, method=method, crs=crs)
        except NoGroundError as error:
            raise FileError(source, "contains no ground points", remedy="Run pointloom ground first") from error
        except ValueError as error:
            if "classification" not in cloud and kind in ("dtm", "chm"):
                remedy = "Run pointloom ground first, or use --kind lowest"
                raise FileError(source, "has no classification", remedy=remedy) from error
            raise
        raster = raster if fill is None else raster.fill_gaps(fill, device=job.device)
    with job.stage("write"):
        raster.write(output, overwrite=overwrite)
    job.wrote(output)
    known, (rows, width) = int(np.isfinite(raster.values).sum()), raster.values.shape
    warning = None if known else "no cell has a value"
    filled = int(raster.filled.sum())
    return DtmReport(job.done(warning), str(job.device), kind, (rows, width), cell, known, filled, raster.crs)


@dataclass(frozen=True)
class MergeReport(JobReport):
    """`sources` are the merged files with their numbers of points, `dropped` the attributes that some lack."""

    device: str
    sources: dict[str, int]
    dropped: tuple[str, ...]
    points: int

    def fields(self) -> Fields:
        dropped = [("dropped", f"{', '.join(self.dropped)} (missing in some files)")] if self.dropped else []
        counts = [(name, f"{count:,}") for name, count in self.sources.items()]
        return [*counts, ("points", f"{self.points:,}"), *dropped, *self.closing(self.device)]


def merge_files(sources: Sequence[FilePath], output: FilePath, **settings: Unpack[Settings]) -> MergeReport:
    """Concatenate clouds in one unit and coordinate system, see `PointCloud.concatenate`. Positions are not rounded to
    float32. LAS gets the finest steps of the sources."""
    job = Job("merge", sources[0], **settings)
    job.check(output)
    read: list[PointTable] = []
    clouds = []
    for source in sources:
        job.source = source
        table, cloud = job.read_exact_cloud()
        read.append(table)
        clouds.append(cloud)
    job.source, job.unit = sources[0], clouds[0].unit
    with job.stage("merge"), without_warnings(MissingPartsWarning):  # the report names them
        merged = PointCloud.concatenate(clouds)
    names = dict.fromkeys(name for cloud in clouds for name in cloud.arrays)
    if not len(merged):
        return MergeReport(job.done("no file has a point; nothing was written"), str(job.device), {}, (), 0)
    job.write_points(_joined(table_of(merged), [table for table in read if len(table.points)]), output)
    dropped = tuple(name for name in names if name not in merged.arrays)
    counts = {os.fspath(source): len(cloud) for source, cloud in zip(sources, clouds, strict=True)}
    return MergeReport(job.done(), str(job.device), counts, dropped, len(merged))


def _joined(merged: PointTable, read: list[PointTable]) -> PointTable:
    """The table of merged clouds with the positions of the files, in the finest of their steps that fits LAS."""
    points = np.concatenate([table.points for table in read])
    points = points.astype(np.promote_types(points.dtype, merged.points.dtype), copy=False)
    given = (default_steps(table.in_degrees) if table.steps is None else table.steps for table in read)
    steps = np.min([np.asarray(each) for each in given], axis=0)
    low, high = finite_box(points)
    has_steps = any(table.steps is not None for table in read)
    is_fit = has_steps and fits_steps(low, high, steps, np.round(low / 2 + high / 2))
    return with_positions(merged, points, steps if is_fit else None)


@dataclass(frozen=True)
class TransformReport(JobReport):
    device: str
    kind: str
    points: int
    matrix: list[list[float]] | None
    crs: str | None

    def fields(self) -> Fields:
        count = ("points" if self.kind == "point cloud" else "vertices", f"{self.points:,}")
        return [count, ("system", self.crs or "unknown"), *self.closing(self.device)]


def transform_file(
    source: FilePath,
    output: FilePath,
    *,
    pose: FilePath | None = None,
    inverse: bool = False,
    translate: tuple[float, float, float] | None = None,
    scale: float | None = None,
    epsg: str | None = None,
    from_crs: str | None = None,
    unit: str | None = None,
    **settings: Unpack[Settings],
) -> TransformReport:
    """Write a cloud or mesh transformed by a pose file, a translation, a scale, to a coordinate system or a unit."""
    job = Job("transform", source, **settings)
    job.check(output, dict.fromkeys((*WRITTEN, *MESH_FORMATS)), what="clouds and meshes")
    matrix = np.eye(4)
    if pose is not None:
        matrix = inv(read_pose(pose)) if inverse else read_pose(pose)
    if translate is not None:
        matrix[:3, 3] = translate
    matrix[:3, :3] *= 1.0 if scale is None else scale
    is_mesh = tables.is_mesh_file(source) and Path(output).suffix.lower() in MESH_FORMATS
    table, shape = (None, job.read_mesh()) if is_mesh else job.read_exact_cloud()
    if from_crs is not None:
        shape.crs = check_crs("from_crs", from_crs)
        table = table if table is None else replace(table, crs=shape.crs)
    with job.stage("transform"):
        moved = shape.reproject(epsg) if epsg else shape.to_unit(unit) if unit else shape.transform(matrix)
    job.unit = moved.unit
    known = None if epsg or unit else matrix.tolist()
    system = None if moved.crs is None else moved.crs.name
    if isinstance(moved, TriangleMesh):
        job.write_mesh(moved, output)
        return TransformReport(job.done(), str(job.device), "mesh", len(moved.vertices), known, system)
    with job.stage("write"):
        like = source if moved.crs == shape.crs and moved.unit == shape.unit else None
        moved_table = table_of(moved)
        if table is not None:
            moved_table = moved_exactly(table, moved_table, None if epsg or unit else matrix)
        left_out = tables.write_cloud_table(output, moved_table, source=like, system_only=True, **job.form)
        job.wrote(output, left_out)
    return TransformReport(job.done(), str(job.device), "point cloud", len(moved), known, system)


@dataclass(frozen=True)
class SplitReport(JobReport):
    device: str
    by: str
    parts: dict[str, int]

    def fields(self) -> Fields:
        counts = [(name, f"{count:,} points") for name, count in self.parts.items()]
        return [("by", self.by), *counts, *self.closing(self.device)]


def split_file(
    source: FilePath,
    folder: FilePath,
    *,
    by: str | None = None,
    cell: float | None = None,
    extension: str | None = None,
    **settings: Unpack[Settings],
) -> SplitReport:
    """Write one file per value of an attribute, or per square cell of a grid along x and y, into a folder."""
    job, root = Job("split", source, **settings), Path(folder)
    suffix = f".{extension}" if extension else Path(source).suffix
    if suffix.lower() not in WRITTEN:
        raise FileError(source, f"clouds are not written to {suffix}", remedy="Pass another format with --format")
    if root.exists() and not root.is_dir():
        raise FileError(folder, "is not a folder")
    rows = read_rows(job)
    keys, names = _parts_of(source, rows.table.attributes, rows.table.points, by, cell)
    stem = Path(source).name.partition(".")[0]
    outputs = [root / f"{stem}_{name}{suffix}" for name in names]
    root.mkdir(parents=True, exist_ok=True)
    for output in outputs:
        job.check(output)
    parts = {}
    for number, output in enumerate(outputs):
        chosen = np.flatnonzero(keys == number)
        job.write_points(rows.take(chosen), output)
        parts[output.name] = len(chosen)
    lost = int((keys < 0).sum())
    warning = f"{lost:,} points without a finite position or value were not written" if lost else None
    return SplitReport(job.done(warning), str(job.device), by or f"cells of {cell:g}", parts)


def _parts_of(
    source: FilePath, attributes: dict[str, NDArray[Any]], points: NDArray[Any], by: str | None, cell: float | None
) -> tuple[NDArray[np.int64], list[str]]:
    """Number of the part of each point, -1 for none, and the names of the parts."""
    if by is None or cell is not None:
        if by is not None or cell is None:
            raise ValueError("by, cell: expected one of them")
        values = np.floor(points[:, :2].astype(np.float64) / cell)
    elif by not in attributes or attributes[by].ndim != 1:
        known = few_of([name for name, column in attributes.items() if column.ndim == 1], MAX_LISTED)
        raise FileError(
            source, f"has no attribute {by!r} with one number per point", remedy=f"It has {known or 'none'}"
        )
    else:
        values = attributes[by][:, None]
    finite = np.isfinite(values).all(axis=1)
    different, inverse = np.unique(values[finite], axis=0, return_inverse=True)
    if not 0 < len(different) <= MAX_FILES:
        reason = f"would give {len(different):,} files, expected 1 to {MAX_FILES:,}"
        raise FileError(source, reason, remedy="Split by classes or by larger cells")
    keys = np.full(len(values), -1, np.int64)
    keys[finite] = inverse.reshape(-1)
    label = "" if by is None else f"{re.sub(r'[^A-Za-z0-9]+', '_', by)}_"
    return keys, [label + "_".join(f"{number:.17g}" for number in row.tolist()) for row in different]
