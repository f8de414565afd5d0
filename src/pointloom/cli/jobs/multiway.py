"""Registration of all clouds of a folder: `register_folder`."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Unpack

import numpy as np

from ...cameras.pose_files import write_poses
from ...cameras.trajectory_formats import NUMBERED
from ...core.errors import FileError, FilePath
from ...core.joined_parts import MissingPartsWarning
from ...core.reports import Fields
from ...core.units import without_warnings
from ...io.meshes import tables
from ...io.points.point_cloud import table_of
from ...io.points.scan_files import list_scans
from ...pcd.cloud import PointCloud
from ...pcd.units import common_reference
from ...registration.globally.level_poses import LEVEL
from ...registration.pose_graphs.multiway import FragmentsResult, register_multiway
from ...registration.pose_graphs.pose_graph_files import write_pose_graph
from ...registration.voxel_size import choose_voxel_size
from .job import Job, JobReport, Settings
from .register import read_cloud

_LISTED_CLOUDS = 5  # names of unplaced clouds


@dataclass(frozen=True)
class MultiwayReport(JobReport):
    device: str
    voxel_size: float
    voxel_size_given: bool
    clouds: tuple[str, ...]
    points: int
    result: FragmentsResult

    def to_dict(self) -> dict[str, Any]:
        report = super().to_dict()
        points = report.pop("points")
        del report["result"]
        quality = {name: report[name] for name in ("reliable", "warnings")}  # which name files and options
        return report | {"points": points} | self.result.to_dict(self.clouds) | quality

    def fields(self) -> Fields:
        (_, cloud_count), (_, pairs), *_ = self.result.fields()
        chosen = "" if self.voxel_size_given else ", chosen from the clouds"
        return [
            ("clouds", f"{cloud_count}, {self.points:,} points"),
            ("voxels", f"{self.voxel_size:g} {self.m}{chosen}"),
            ("pairs", pairs),
            ("frame", f"that of {self.clouds[self.result.reference]}"),
            *self.closing(self.device),
        ]


def register_folder(
    folder: FilePath,
    output: FilePath,
    *,
    voxel_size: float | None = None,
    neighbors: int | None = None,
    level: bool = False,
    merged: FilePath | None = None,
    graph: FilePath | None = None,
    **settings: Unpack[Settings],
) -> MultiwayReport:
    """Register the clouds of a folder, in natural order of their names, and write their poses.

    Outputs are checked before the work and omit clouds that could not be placed. Nothing is written if no two clouds
    match.

    Args:
        output: Poses T_reference_cloud, with the cloud's number from 0 as TUM time
            and as first number in .log.
        voxel_size: Voxel size of the downsampled clouds [m]. None chooses it.
        level: All clouds are level.
        merged: File for all placed clouds, with their common attributes.
        graph: A .json file for the pose graph.
    """
    job = Job("multiway", folder, **settings)
    check_outputs(job, output, merged, graph)
    where, paths, clouds = job.device, list_clouds(folder), []
    with job.stage("read", reported=False):
        for done, path in enumerate(paths):
            job.progress("read", done, len(paths))
            clouds.append(read_cloud(path, where, settings.get("columns")))
        job.progress("read", len(paths), len(paths))
    job.unit = common_reference("clouds", clouds)[0]
    with job.stage("voxels", reported=False):
        size = choose_voxel_size(*clouds) if voxel_size is None else voxel_size
    with job.stage("register", reported=False):
        how: dict[str, Any] = {"neighbors": neighbors, "free": LEVEL if level else None}
        result = register_multiway(clouds, voxel_size=size, progress=job.progress, **how)
    is_written = int(result.placed.sum()) > 1
    with job.stage("write", reported=is_written):
        if is_written:
            _write_results(job, result, clouds, output, merged, graph)
    names = tuple(path.name for path in paths)
    lost = [name for name, is_registered in zip(names, result.placed, strict=True) if not is_registered]
    done = job.done(placement_warning(lost, len(names), is_written), *result.graph_warnings)
    points = sum(len(cloud) for cloud in clouds)
    return MultiwayReport(done, str(where), size, voxel_size is not None, names, points, result)


def check_outputs(job: Job, output: FilePath, merged: FilePath | None, graph: FilePath | None) -> None:
    job.check(output, NUMBERED, what="poses")
    job.check(merged)
    if merged is not None and Path(merged).resolve().parent == Path(job.source).resolve():
        reason = f"is in {os.fspath(job.source)}, and the next run would read it as one of the clouds"
        raise FileError(merged, reason, remedy="Choose another folder")
    job.check(graph, (".json",), what="pose graphs")


def list_clouds(folder: FilePath) -> list[Path]:
    """The clouds of a folder, at least two."""
    paths = list_scans(folder)
    if len(paths) < 2:
        raise FileError(folder, f"expected at least two clouds, got {paths[0].name} only", remedy="Pass another folder")
    return paths


def _write_results(
    job: Job,
    result: FragmentsResult,
    clouds: list[PointCloud],
    output: FilePath,
    merged: FilePath | None,
    graph: FilePath | None,
) -> None:
    """Write the outputs. Data that the merged cloud cannot store or that not all clouds have is omitted."""
    write_poses_and_graph(job, result, output, graph)
    if merged is not None:
        with without_warnings(MissingPartsWarning):  # the report names them
            merged_cloud = result.merge(clouds)
        named = dict.fromkeys(name for i in np.flatnonzero(result.placed) for name in _names_of(clouds[i]))
        lost = [name for name in named if name not in _names_of(merged_cloud)]
        job.wrote(merged, [*lost, *tables.write_cloud_table(merged, table_of(merged_cloud), **job.form)])


def write_poses_and_graph(job: Job, result: FragmentsResult, output: FilePath, graph: FilePath | None) -> None:
    write_poses(output, result.trajectory, overwrite=job.form["overwrite"])
    job.wrote(output)
    if graph is not None:
        write_pose_graph(graph, result.pose_graph, overwrite=job.form["overwrite"])
        job.wrote(graph)


def _names_of(cloud: PointCloud) -> list[str]:
    vectors = {"normals": cloud.has_normals, "colors": cloud.has_colors}
    return [*(name for name, is_there in vectors.items() if is_there), *cloud.attributes]


def placement_warning(lost: list[str], count: int, is_written: bool) -> str | None:
    if not lost:
        return None
    if not is_written:
        return f"no two of the {count} clouds overlap; nothing was written; try another --voxel"
    names = ", ".join(lost[:_LISTED_CLOUDS]) + (" and more" if len(lost) > _LISTED_CLOUDS else "")
    return f"{len(lost)} of {count} clouds could not be registered: {names}; try another --voxel, or more --loops"
