"""Export the clouds of a recording: `convert_recording`."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ...cameras.trajectory import read_trajectory
from ...core.atomic import atomic_folder, check_folder
from ...core.errors import FileError, FilePath
from ...core.reports import Fields
from ...io.bags.recording import Recording, open_recording
from ...io.meshes import tables
from ...io.points.formats import WRITTEN
from ...io.points.point_cloud import table_of
from ...pcd.cloud import PointCloud
from .job import Job, JobReport

MARKER = "scans.json"  # marker of a folder: topic, frame and times
KIND = ".ply"  # of the scans of a folder


@dataclass(frozen=True)
class RecordedCloudsReport(JobReport):
    """Report of `convert_recording`; `frame` is None if the clouds stay in the sensor frame."""

    topic: str
    frame: str | None
    scans: int
    points: int

    def title(self, source: str) -> str:
        return f"{source}: {self.topic}"

    def fields(self) -> Fields:
        where = f", in {self.frame}" if self.frame else ""
        return [("scans", f"{self.scans:,}{where}"), ("points", f"{self.points:,}"), *self.closing()]


def convert_recording(
    source: FilePath,
    output: FilePath,
    *,
    topic: str | None = None,
    frame: str | None = None,
    poses: FilePath | None = None,
    as_text: bool = False,
    overwrite: bool = False,
) -> RecordedCloudsReport:
    """Write the clouds of a recording to one file, or to a folder of .ply files and `scans.json` with their times.

    Clouds are transformed into `frame` by the recording's transforms, or by a file of poses T_world_scan, one per scan.
    Only a folder with scans of a recording is overwritten.
    """
    job = Job("convert", source, as_text=as_text, overwrite=overwrite)
    as_folder = not Path(output).suffix or Path(output).is_dir()
    if as_folder:
        check_folder(output, MARKER, overwrite=overwrite)
    else:
        job.check(output, WRITTEN)
    recording = open_recording(source)
    chosen = recording.choose_topic(topic)
    count = sum(entry.count for entry in recording.topics if entry.name == chosen)
    if not as_folder and count > 1 and frame is None and poses is None:
        reason = f"{chosen} has {count} scans, each in the frame of its sensor"
        raise FileError(source, reason, remedy="Pass a folder, or --frame NAME or --poses POSES to write one cloud")
    scans = _moved(recording.scans(chosen, frame=frame, device="cpu"), poses, count, source)
    if as_folder:
        points = _write_folder(job, output, scans, _marker_content(recording, chosen, frame))
    else:
        with job.stage("read"):
            cloud = PointCloud.concatenate(list(scans))
        job.write_cloud(cloud, output)
        points = len(cloud)
    return RecordedCloudsReport(job.done(recording.damage), chosen, frame, count, points)


def _moved(scans: Iterator[PointCloud], poses: FilePath | None, count: int, source: FilePath) -> Iterator[PointCloud]:
    if poses is None:
        return scans
    trajectory = read_trajectory(poses)
    if len(trajectory) != count:
        reason = f"expected {count} poses, one per scan of {os.fspath(source)}, got {len(trajectory)}"
        raise FileError(poses, reason, remedy="Pass one pose per scan, such as those of pointloom odometry")
    return (scan.transform(pose) for scan, pose in zip(scans, trajectory.poses, strict=True))


def _marker_content(recording: Recording, topic: str, frame: str | None) -> dict[str, Any]:
    """Content of the marker file: header times, None for scans without."""
    times = [recording.header_at(row)[0] for row in recording.rows_of(topic)]
    return {"recording": recording.path.name, "topic": topic, "frame": frame, "times": times}


def _write_folder(job: Job, output: FilePath, scans: Iterator[PointCloud], content: dict[str, Any]) -> int:
    """Write one file per scan, atomically. Returns their number of points."""
    points = 0
    with job.stage("write"), atomic_folder(output, MARKER, overwrite=job.form["overwrite"]) as folder:
        for number, scan in enumerate(scans):
            as_text = job.form["as_text"]
            tables.write_cloud_table(folder / f"{number:06d}{KIND}", table_of(scan), as_text=as_text, overwrite=False)
            points += len(scan)
        (folder / MARKER).write_text(json.dumps(content, indent=1) + "\n", encoding="utf-8")
    job.wrote(output)
    return points
