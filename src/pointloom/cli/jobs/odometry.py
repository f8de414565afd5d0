"""LiDAR odometry of a folder of scans: `odometry_of_folder`."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import partial
from itertools import repeat
from pathlib import Path
from typing import Any, Unpack

from ...cameras.imu_readings import ImuReadings
from ...cameras.pose_files import FORMATS as POSE_FORMATS
from ...cameras.trajectory import Trajectory, read_trajectory, write_trajectory
from ...core.devices import DeviceLike
from ...core.errors import FileError, FilePath
from ...core.reports import Fields, quality, values_of
from ...core.wording import format_seconds, plain
from ...io.bags.recording import is_recording, open_recording
from ...io.points.scan_files import list_scans, read_scans
from ...pcd.cloud import PointCloud
from ...registration.lidar.lidar_odometry import LidarOdometry
from ...registration.lidar.lidar_steps import OdometrySummary, summarize_steps
from ...registration.trajectories.trajectory_error import TrajectoryError
from .evaluate import compare
from .job import Job, JobReport, Settings

FORMATS = {"kitti": (".kitti", ".txt"), "tum": (".txt", ".tum"), "log": (".log",)}  # extensions of each


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
        folder: Scans in natural order: .bin as in KITTI, or clouds; or a recording, .bag, .mcap, .db3 or a folder of
            those.
        output: Poses: .txt or .tum (TUM), .log (Open3D) or .kitti.
        format: "kitti", "tum" or "log". None for that of the extension. TUM times are scan numbers.
        truth: File of true poses, one per scan. Errors are aligned by se3.
        topics: Topics of a recording: of clouds (None for the only one), and of IMU readings on the same clock (None to
            use no IMU).
    """
    job = Job("odometry", folder, **settings)
    form = _check_output(job, output, format)
    odometry = LidarOdometry(voxel_size=voxel_size, max_range=max_range, min_range=min_range, device=job.device)
    scans = _Scans.open(folder, topics[0], settings.get("columns"), job.device, imu=topics[1])
    if scans.count < 2:
        raise FileError(folder, f"expected at least two scans, got {scans.first} only", remedy="Pass another folder")
    true_path = None if truth is None else read_trajectory(truth)
    if true_path is not None and len(true_path) != scans.count:
        reason = f"expected {scans.count} poses, one per scan of {os.fspath(folder)}, got {len(true_path)}"
        raise FileError(truth or "", reason, remedy="Pass the true pose of each scan")
    points = _register_scans(job, odometry, scans)
    summary, path, errors = summarize_steps(odometry.steps), Trajectory(odometry.poses), None
    if summary.has_seen:
        with job.stage("write", reported=False):
            write_trajectory(output, path, format=form, overwrite=job.form["overwrite"])
        job.wrote(output)
        if true_path is not None and truth is not None:
            errors = compare(path, true_path, folder, truth, "se3")
    done = job.done(*summary.warnings, *(() if errors is None else errors.warnings))
    sizes = odometry.voxel_size, max_range, min_range
    up = None if odometry.up is None else odometry.up.tolist()
    return OdometryReport(done, form, str(job.device), *sizes, summary, points, up, errors)


@dataclass(frozen=True)
class _Scans:
    """Scans in order: number, name of the first, and iterators that read them and the times in their headers [s]."""

    count: int
    first: str
    clouds: Iterator[PointCloud]
    times: Iterator[float | None] = field(default_factory=partial(repeat, None))
    imu: ImuReadings | None = None

    @classmethod
    def open(
        cls,
        path: FilePath,
        topic: str | None,
        columns: Sequence[str] | None,
        device: DeviceLike,
        *,
        imu: str | None = None,
    ) -> _Scans:
        if is_recording(Path(path)):
            if columns is not None:
                raise FileError(path, "is a recording, which defines its columns", remedy="Leave --columns out")
            recording = open_recording(path)
            chosen = recording.choose_topic(topic)
            (entry,) = (entry for entry in recording.topics if entry.name == chosen)
            readings = None if imu is None else recording.imu(imu, frame=entry.frame_id or "")
            clouds = recording.scans(chosen, absolute_times=imu is not None, device=device)
            times = (recording.header_at(row)[0] for row in recording.rows_of(chosen))
            return cls(entry.count, chosen, clouds, times, readings)
        for name, value in (("topic", topic), ("imu", imu)):
            if value is not None:
                reason = f"is not a recording, so it has no topic {value!r}"
                raise FileError(path, reason, remedy=f"Leave --{name} out")
        files = list_scans(path)
        return cls(len(files), files[0].name, read_scans(files, device=device, columns=columns))


def _register_scans(job: Job, odometry: LidarOdometry, scans: _Scans) -> int:
    points = 0
    job.progress("scans", 0, scans.count)
    for number in range(1, scans.count + 1):
        with job.stage("read", reported=False):
            scan, time = next(scans.clouds), next(scans.times)
        with job.stage("register", reported=False):
            if scans.imu is None:
                odometry.register(scan)
            else:  # the last point time, else the time in the header
                odometry.register(scan, imu=scans.imu, time=None if "time" in scan else time)
        points += len(scan)
        job.progress("scans", number, scans.count)
    return points


def _check_output(job: Job, output: FilePath, format: str | None) -> str:
    """The format of the poses after checking the output."""
    suffix = Path(output).suffix.lower()
    if format is None:
        job.check(output, (*POSE_FORMATS, ".kitti"), what="poses")
        return POSE_FORMATS.get(suffix, "kitti")
    if format not in FORMATS:
        raise ValueError(f"format: expected one of {', '.join(FORMATS)}, got {format!r}")
    job.check(output, FORMATS[format], what=f"poses as {format}")
    return format
