"""Scans of a folder or of a recording, in order: `ScanSource`."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import count, repeat
from pathlib import Path

from ...cameras.imu_readings import ImuReadings
from ...core.devices import DeviceLike
from ...core.errors import FileError, FilePath
from ...core.paths import is_recording
from ...io.bags.recording import open_recording
from ...io.points.scan_files import list_scans, read_scan_times, read_scans
from ...kernels.memory import download
from ...kernels.odometry.deskewing import bound_times
from ...pcd.cloud import PointCloud


@dataclass(frozen=True)
class ScanSource:
    """Scans in order: number, name of the first, and an iterator that reads them with their times, None if unknown.

    Times of a recording [s] are those of the last points, to which poses refer, on the clock of the headers; else those
    of the headers. Those of a KITTI sequence are in its `times.txt`. `is_timed`: the times are those of a clock. `imu`
    are the readings of a recording, if wanted.
    """

    count: int
    first: str
    scans: Iterator[tuple[PointCloud, float | None]]
    is_timed: bool = False
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
        is_numbered: bool = False,
    ) -> ScanSource:
        """Scans of a folder or recording. `is_numbered`: the times of those in a folder are their numbers, from 0."""
        if is_recording(Path(path)):
            if columns is not None:
                raise FileError(path, "is a recording, which defines its columns", remedy="Leave --columns out")
            recording = open_recording(path)
            chosen = recording.choose_topic(topic)
            (entry,) = (entry for entry in recording.topics if entry.name == chosen)
            readings = None if imu is None else recording.imu(imu, frame=entry.frame_id or "")
            clouds = recording.scans(chosen, absolute_times=True, device=device)
            stamps = (recording.header_at(row)[0] or None for row in recording.rows_of(chosen))  # zero: not set
            scans = ((cloud, _end_of(cloud, stamp)) for cloud, stamp in zip(clouds, stamps, strict=True))
            return cls(entry.count, chosen, scans, True, readings)
        for name, value in (("topic", topic), ("imu", imu)):
            if value is not None:
                reason = f"is not a recording, so it has no topic {value!r}"
                raise FileError(path, reason, remedy=f"Leave --{name} out")
        files = list_scans(path)
        stored = read_scan_times(path, files)
        times = stored or (map(float, count()) if is_numbered else repeat(None))
        clouds = read_scans(files, device=device, columns=columns)
        return cls(len(files), files[0].name, zip(clouds, times, strict=False), stored is not None)


def _end_of(scan: PointCloud, stamp: float | None) -> float | None:
    """Time of the last point of a scan on the clock of its header, or the header's without point times."""
    if stamp is None or "time" not in scan:
        return stamp
    first, last = download(bound_times(scan.arrays["points"], scan.arrays["time"]))  # sync
    return float(last) if first <= last else stamp
