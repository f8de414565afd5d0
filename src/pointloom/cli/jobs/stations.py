"""Registration of the scans of one or several E57 files: `register_scans`."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Unpack

from ...core.atomic import atomic_write
from ...core.errors import FileError, FilePath
from ...core.reports import Fields
from ...io.file_formats import listed
from ...io.optional_imports import import_for
from ...io.points.e57_stations import Stations, read_stations, write_stations
from ...io.points.formats import WITH_SCANS
from ...registration.stations.result import StationsResult
from ...registration.stations.stations import register_stations
from ...registration.stations.survey_tables import read_control_points, read_targets
from ...visualization.render.picture_files import write_image
from ...visualization.render.plots import station_plan
from .job import Job, JobReport, Settings
from .report_page import write_report_page

REPORT = {"text": "report.txt", "json": "report.json", "plan": "plan.png", "page": "report.html"}
E57 = (".e57",)


@dataclass(frozen=True)
class StationsReport(JobReport):
    """Report of `register_scans`; `began` is "poses of the file" or "no poses"."""

    device: str
    points: int
    began: str
    result: StationsResult

    def to_dict(self) -> dict[str, Any]:
        report = super().to_dict()
        del report["result"]
        return self.result.to_dict() | report

    def fields(self) -> Fields:
        return [*self.result.fields(), ("began", f"{self.began}; {self.points:,} points"), *self.closing(self.device)]


def register_scans(
    source: FilePath,
    output: FilePath,
    *,
    targets: FilePath | None = None,
    control: FilePath | None = None,
    report: FilePath | None = None,
    free: Sequence[str] | None = None,
    use_poses: bool = True,
    rough: float | None = None,
    voxel_size: float | None = None,
    overlap: float | None = None,
    **settings: Unpack[Settings],
) -> StationsReport:
    """Register the scans of an E57 file and write them with their poses.

    `targets` and `control` are tables (`read_targets`, `read_control_points`), `report` a folder for report.txt,
    report.json, plan.png and report.html. `free` are the degrees of freedom of stations: "x", "y", "z" and "yaw"
    (default), or all six. See `register_stations` for the other options.
    """
    job = Job("stations", source, **settings)
    job.check(output, E57, what="stations")
    report_paths = _check_report(report, overwrite=job.form["overwrite"])
    if Path(source).suffix.lower() not in WITH_SCANS:
        remedy = "Write the scans as one file of stations first"
        raise FileError(source, f"is not an {listed(WITH_SCANS)} file", remedy=remedy)
    with job.stage("read"):
        scans = _filled(read_stations(source, device=job.device), source)
    seen = None if targets is None else read_targets(targets, scans.names)
    known = None if control is None else read_control_points(control)
    job.unit = scans.clouds[0].unit
    given: dict[str, Any] = {
        name: value for name, value in (("rough", rough), ("overlap", overlap)) if value is not None
    }
    posed = use_poses and scans.approximate_poses is not None
    with job.stage("register", reported=False):
        result = register_stations(
            scans if posed else scans.clouds,
            level=free is None or len(free) < 6,
            targets=seen,
            control=known,
            names=scans.names,
            voxel_size=voxel_size,
            progress=job.progress,
            **given,
        )
    with job.stage("write"):
        source_scans = scans if posed else scans.clouds  # the coordinate system is that of the poses
        write_stations(output, source_scans, result.poses, names=scans.names, overwrite=job.form["overwrite"])
    job.wrote(output)
    if report_paths:
        _write_report(job, report_paths, result)
    points, began = sum(len(cloud) for cloud in scans.clouds), "poses of the file" if posed else "no poses"
    return StationsReport(job.done(*result.warnings), str(job.device), points, began, result)


def _filled(scans: Stations, source: FilePath) -> Stations:
    empty = [name for name, cloud in zip(scans.names, scans.clouds, strict=True) if not len(cloud)]
    if empty:
        raise FileError(source, f"scan {empty[0]!r} contains no points", remedy="Remove this scan")
    return scans


def _check_report(folder: FilePath | None, *, overwrite: bool) -> dict[str, Path]:
    if folder is None:
        return {}
    report_folder = Path(folder)
    import_for(report_folder / REPORT["plan"], "matplotlib.figure", "plot")
    if report_folder.exists() and not report_folder.is_dir():
        raise FileError(report_folder, "is not a folder", remedy="Pass the path of a folder for the report")
    paths = {kind: report_folder / name for kind, name in REPORT.items()}
    existing = [path for path in paths.values() if path.exists()]
    if existing and not overwrite:
        raise FileError(existing[0], "exists", remedy="Pass overwrite=True to replace it")
    if not report_folder.exists() and not report_folder.absolute().parent.is_dir():
        raise FileError(report_folder, "its folder does not exist")
    return paths


def _write_report(job: Job, paths: dict[str, Path], result: StationsResult) -> None:
    paths["text"].parent.mkdir(exist_ok=True)
    overwrite = job.form["overwrite"]
    with job.stage("report"):
        texts = {"text": result.report(), "json": json.dumps(result.to_dict(), indent=1, allow_nan=False) + "\n"}
        for kind, text in texts.items():
            with atomic_write(paths[kind], overwrite=overwrite) as file:
                file.write(text.encode())
        plan = station_plan(result)
        write_image(paths["plan"], plan, overwrite=overwrite)
        title, pictures = f"Stations of {Path(job.source).name}", [("Plan with error ellipses", plan)]
        checks = result.warnings
        write_report_page(paths["page"], title, result.fields(), checks, pictures, texts["text"], overwrite=overwrite)
    for path in paths.values():
        job.wrote(path)
