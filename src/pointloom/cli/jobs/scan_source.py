"""Scans of a folder or of a recording, in order: `ScanSource`."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from ...core.devices import DeviceLike
from ...core.errors import FileError, FilePath
from ...io.bags.recording import is_recording, open_recording
from ...io.points.scan_files import list_scans, read_scans
from ...pcd.cloud import PointCloud


@dataclass(frozen=True)
class ScanSource:
    """Scans in order: number, name of the first, and an iterator that reads them."""

    count: int
    first: str
    clouds: Iterator[PointCloud]

    @classmethod
    def open(cls, path: FilePath, topic: str | None, columns: Sequence[str] | None, device: DeviceLike) -> ScanSource:
        if is_recording(Path(path)):
            if columns is not None:
                raise FileError(path, "is a recording, which defines its columns", remedy="Leave --columns out")
            recording = open_recording(path)
            chosen = recording.choose_topic(topic)
            count = sum(entry.count for entry in recording.topics if entry.name == chosen)
            return cls(count, chosen, recording.scans(chosen, device=device))
        if topic is not None:
            raise FileError(path, f"is not a recording, so it has no topic {topic!r}", remedy="Leave --topic out")
        files = list_scans(path)
        return cls(len(files), files[0].name, read_scans(files, device=device, columns=columns))
