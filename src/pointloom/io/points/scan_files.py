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
from .formats import CLOUD_FORMATS
from .point_cloud import read_point_cloud
from .text_table import check_columns

# Tables beside scans are poses, times and notes. Alone they are the scans.
_TABLES = tuple(extension for extension, format in CLOUD_FORMATS.items() if format.may_be_other)

Scans = str | os.PathLike[str] | Iterable[str | os.PathLike[str] | PointCloud]


def list_scans(folder: FilePath) -> list[Path]:
    """The scans of a folder in natural order: scan2 precedes scan10.

    All formats of `read_point_cloud`. Tables (.csv, .txt) are used only if there is nothing else: they often contain
    times or poses.

    Raises:
        FileError: No folder, no scan, or scans of several formats, whose order is unknown.
    """
    root = path_of(folder, "folder")
    restore_folder(root)
    if not root.is_dir():
        raise FileError(
            folder, "is not a folder" if root.exists() else "does not exist", remedy="Give a folder of scans"
        )
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
