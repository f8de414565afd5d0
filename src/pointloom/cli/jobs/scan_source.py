"""Scans of a folder or of a recording, in order: `ScanSource`."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import partial
from itertools import count, repeat
from pathlib import Path

from ...cameras.imu_readings import ImuReadings
from ...core.devices import DeviceLike
from ...core.errors import FileError, FilePath
from ...core.paths import is_recording
from ...io.bags.recording import open_recording
from ...io.points.scan_files import list_scans, read_scans
from ...pcd.cloud import PointCloud


@dataclass(frozen=True)
class ScanSource:
    """Scans in order: number, name of the first, and iterators that read them and the times in their headers [s].

    `imu` are the readings of a recording, if wanted.
    """

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
            clouds = recording.scans(chosen, absolute_times=imu is not None, device=device)
            times = (recording.header_at(row)[0] or None for row in recording.rows_of(chosen))  # zero: not set
            return cls(entry.count, chosen, clouds, times, readings)
        for name, value in (("topic", topic), ("imu", imu)):
            if value is not None:
                reason = f"is not a recording, so it has no topic {value!r}"
                raise FileError(path, reason, remedy=f"Leave --{name} out")
        files = list_scans(path)
        times = map(float, count()) if is_numbered else repeat(None)
        return cls(len(files), files[0].name, read_scans(files, device=device, columns=columns), times)
