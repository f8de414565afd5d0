"""LiDAR odometry of a folder of scans: `odometry_of_folder`."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Unpack

import numpy as np
from numpy.typing import NDArray

from ...cameras.trajectory import Trajectory, read_trajectory, write_trajectory
from ...cameras.trajectory_formats import NUMBERED, extensions_of
from ...core.errors import FileError, FilePath
from ...core.reports import Fields, quality, values_of
from ...core.units import warn_of_units
from ...core.wording import format_seconds, plain
from ...io.bags.message_chunks import RecordingWarning
from ...registration.lidar.lidar_odometry import LidarOdometry
from ...registration.lidar.lidar_slam import LidarSLAM
from ...registration.lidar.lidar_steps import OdometrySummary, summarize_steps
from ...registration.lidar.position_readings import PositionReadings
from ...registration.trajectories.trajectory_error import TrajectoryError
from .evaluate import compare
from .job import Job, JobReport, Settings
from .scan_source import ScanSource

FORMATS = ("kitti", "tum", "log")


@dataclass(frozen=True)
class OdometryReport(JobReport):
    """Report of `odometry_of_folder`; `errors` are against the true path, if given."""

    format: str
    device: str
    voxel_size: float
    max_range: float
    min_range: float
    result: OdometrySummary
    points: int
    up: list[float] | None
    errors: TrajectoryError | None

    @property
    def scans_per_second(self) -> float:
        return self.result.scan_count / max(self.done.seconds["register"], 1e-9)

    def to_dict(self) -> dict[str, Any]:
        path = self.result.to_dict()
        speed = {"scans": path.pop("scans"), "points": self.points, "scans_per_second": self.scans_per_second}
        own = {name: value for name, value in values_of(self).items() if name not in ("done", "result", "points")}
        ending = {"errors": own.pop("errors"), "seconds": self.done.seconds, "files": self.done.files, **quality(self)}
        beginning = {"command": self.done.command, "folder": self.done.source}
        return plain(beginning | own | speed | path | ending)

    def fields(self) -> Fields:
        (_, scans), *path = self.result.fields()
        ranges = f"from {self.min_range:g} to {self.max_range:g} m"
        return [
            ("scans", f"{scans}, {self.points:,} points, {self.scans_per_second:.1f} scans/s"),
            ("map", f"voxels of {self.voxel_size:g} m, points {ranges}"),
            *path,
            *([] if self.up is None else [("up", "({:.4f}, {:.4f}, {:.4f}) by the IMU".format(*self.up))]),
            *([] if self.errors is None else self.errors.fields()),
            ("seconds", f"{format_seconds(self.done.seconds)} on {self.device}"),
            ("files", ", ".join(self.done.files) or "none"),
        ]


def odometry_of_folder(
    folder: FilePath,
    output: FilePath,
    *,
    format: str | None = None,
    voxel_size: float | None = None,
    max_range: float = 100.0,
    min_range: float = 5.0,
    truth: FilePath | None = None,
    topics: tuple[str | None, str | None] = (None, None),
    **settings: Unpack[Settings],
) -> OdometryReport:
    """Find the pose of each scan of a folder and write them. Output and truth are checked before the work.

    Nothing is written if no scan has points in range. See `LidarOdometry` for the ranges.

    Args:
        folder: Scans in natural order: .bin as in KITTI, or clouds; a KITTI sequence; or a recording or a folder of
            those.
        output: Poses in a format of `write_trajectory`.
        format: "kitti", "tum" or "log". None for that of the extension. TUM times are those of a recording [s], at the
            end of each scan, or of a KITTI sequence, else the numbers of the scans in a folder.
        truth: File of true poses, one per scan; for a recording also with its times. Errors are aligned by se3.
        topics: Topics of a recording: of clouds (None for the only one), and of IMU readings on the same clock (None to
            use no IMU).
    """
    job = Job("odometry", folder, **settings)
    form = check_poses_output(job, output, format)
    odometry = LidarOdometry(voxel_size=voxel_size, max_range=max_range, min_range=min_range, device=job.device)
    scans = ScanSource.open(folder, topics[0], settings.get("columns"), job.device, imu=topics[1])
    if scans.count < 2:
        raise FileError(folder, f"expected at least two scans, got {scans.first} only", remedy="Pass another folder")
    true_path = None if truth is None else read_trajectory(truth)
    is_timed = scans.is_timed and true_path is not None and true_path.timestamps is not None
    if true_path is not None and len(true_path) != scans.count and not is_timed:
        reason = f"expected {scans.count} poses, one per scan of {os.fspath(folder)}, got {len(true_path)}"
        raise FileError(truth or "", reason, remedy="Pass the true pose of each scan")
    points, times = register_scans(job, odometry, scans)
    summary, path, errors = summarize_steps(odometry.steps), Trajectory(odometry.poses, times), None
    if summary.has_seen:
        with job.stage("write", reported=False):
            write_trajectory(output, path, format=form, overwrite=job.form["overwrite"])
        job.wrote(output)
        if true_path is not None and truth is not None:
            if len(true_path) == len(path):
                path = Trajectory(path.poses)  # compared in order
            errors = compare(path, true_path, folder, truth, "se3")
    done = job.done(*summary.warnings, *(() if errors is None else errors.warnings))
    sizes = odometry.voxel_size, max_range, min_range
    up = None if odometry.up is None else odometry.up.tolist()
    return OdometryReport(done, form, str(job.device), *sizes, summary, points, up, errors)


def register_scans(
    job: Job, odometry: LidarOdometry | LidarSLAM, scans: ScanSource, positions: PositionReadings | None = None
) -> tuple[int, NDArray[np.float64] | None]:
    """Register all scans in sequence, with positions for LidarSLAM.

    Returns:
        The number of their points, and the times of the poses if the scans have them [s].
    """
    points, times = 0, []
    given: dict[str, Any] = {} if positions is None else {"positions": positions}
    job.progress("scans", 0, scans.count)
    for number in range(1, scans.count + 1):
        with job.stage("read", reported=False):
            scan, time = next(scans.scans)
        with job.stage("register", reported=False):
            odometry.register(scan, imu=scans.imu, time=time, **given)
        points += len(scan)
        times.append(time)
        job.progress("scans", number, scans.count)
    missing = times.count(None)
    if scans.is_timed and missing:
        message = f"{missing} of {len(times)} headers have no time, so the poses are numbered"
        warn_of_units(f"{job.source}: {message}", RecordingWarning)
    return points, np.array(times, np.float64) if scans.is_timed and not missing else None


def check_poses_output(job: Job, output: FilePath, format: str | None) -> str:
    """The format of the poses after checking the output."""
    suffix = Path(output).suffix.lower()
    if format is None:
        job.check(output, (*NUMBERED, ".kitti"), what="poses")
        return NUMBERED.get(suffix, "kitti")
    if format not in FORMATS:
        raise ValueError(f"format: expected one of {', '.join(FORMATS)}, got {format!r}")
    job.check(output, extensions_of(format), what=f"poses as {format}")
    return format
