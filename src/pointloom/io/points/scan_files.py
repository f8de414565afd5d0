"""Sequences of scans: a folder, files, or clouds."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

from ...core.atomic import restore_folder
from ...core.devices import DeviceLike
from ...core.errors import FileError, FilePath
from ...core.other_geometry import conversion_of
from ...core.paths import path_of
from ...pcd.cloud import PointCloud
from ..number_tables import TableForm, read_number_table
from .formats import CLOUD_FORMATS
from .point_cloud import read_point_cloud
from .text_table import check_columns

# Tables beside scans are poses, times and notes. Alone they are the scans.
_TABLES = tuple(extension for extension, format in CLOUD_FORMATS.items() if format.may_be_other)

KITTI_SCANS, KITTI_TIMES = "velodyne", "times.txt"  # of a sequence of the odometry benchmark
_TIMES = TableForm(("time",))

Scans = str | os.PathLike[str] | Iterable[str | os.PathLike[str] | PointCloud]


def list_scans(folder: FilePath) -> list[Path]:
    """The scans of a folder in natural order: scan2 precedes scan10.

    All formats of `read_point_cloud`. Tables (.csv, .txt) are used only if there is nothing else: they often contain
    times or poses. The scans of a KITTI sequence are those in its folder `velodyne`.

    Raises:
        FileError: No folder, no scan, or scans of several formats, whose order is unknown.
    """
    root = path_of(folder, "folder")
    restore_folder(root)
    if not root.is_dir():
        raise FileError(
            folder, "is not a folder" if root.exists() else "does not exist", remedy="Give a folder of scans"
        )
    root = root / KITTI_SCANS if is_kitti_sequence(root) else root
    files = [path for path in root.iterdir() if path.suffix.lower() in CLOUD_FORMATS and path.is_file()]
    if not files:
        raise FileError(folder, "contains no scan", remedy=f"Scans end in {' '.join(CLOUD_FORMATS)}")
    files = [path for path in files if path.suffix.lower() not in _TABLES] or files
    kinds = sorted({path.suffix.lower() for path in files})
    if len(kinds) > 1:
        raise FileError(
            folder, f"contains files of several types: {', '.join(kinds)}", remedy="Give a list of the scans"
        )
    return sorted(files, key=natural_key)


def is_kitti_sequence(folder: Path) -> bool:
    """True for a folder with scans in its folder `velodyne`, as KITTI's odometry benchmark has."""
    return (folder / KITTI_SCANS).is_dir() and any((folder / KITTI_SCANS).glob("*.bin"))


def read_scan_times(folder: FilePath, scans: Sequence[Path]) -> list[float] | None:
    """The times [s] of the scans of a KITTI sequence, from its `times.txt`. None for other folders.

    Scans are named by the row of their time if some of them are missing.

    Raises:
        FileError: Not one number per line, a scan without a time, or times that do not increase.
    """
    path = path_of(folder, "folder") / KITTI_TIMES
    if not is_kitti_sequence(path.parent) or not path.is_file():
        return None
    times = [row.numbers["time"] for row in read_number_table(path, _TIMES)]
    is_complete = len(times) == len(scans)
    rows = [int(scan.stem) if scan.stem.isdecimal() and not is_complete else row for row, scan in enumerate(scans)]
    if max(rows) >= len(times):
        raise FileError(path, f"has {len(times)} times, and none for {scans[rows.index(max(rows))].name}")
    found = [times[row] for row in rows]
    wrong = next((k for k in range(1, len(found)) if not found[k] > found[k - 1]), None)
    if wrong is not None:
        reason = f"the time of {scans[wrong].name} is {found[wrong]:g} s, after {found[wrong - 1]:g} s"
        raise FileError(path, reason, remedy="The times must increase")
    return found


def natural_key(path: Path) -> tuple[list[tuple[int, int, str]], str]:
    """Sort key with numbers in names as numbers. Ties are broken by the text."""
    parts = re.split(r"(\d+)", path.name)
    return [(1, int(part), "") if part.isdigit() else (0, 0, part) for part in parts if part], path.name


def read_scans(
    scans: Scans, *, device: DeviceLike = None, columns: Sequence[str] | None = None
) -> Iterator[PointCloud]:
    """Iterate over the scans of a folder or list of files, read lazily, or over clouds."""
    if columns is not None:
        check_columns(columns)
    if isinstance(scans, PointCloud):
        raise TypeError("scans: expected a folder, files or clouds, got one PointCloud; put it into a list")
    try:
        each = iter(list_scans(scans) if isinstance(scans, str | os.PathLike) else scans)
    except TypeError as error:
        given = f"{type(scans).__name__}{conversion_of(scans, expected='cloud')}"
        raise TypeError(f"scans: expected a folder, files or clouds, got {given}") from error
    for scan in each:
        if isinstance(scan, PointCloud):
            yield scan
        elif isinstance(scan, str | os.PathLike):
            yield read_point_cloud(scan, device=device, columns=columns)
        else:
            given = f"{type(scan).__name__}{conversion_of(scan, expected='cloud')}"
            raise TypeError(f"scans: expected files or clouds, got {given}")
