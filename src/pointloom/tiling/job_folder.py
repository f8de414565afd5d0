"""The folder of a job: created, checked, and cleared if planning failed."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from ..core.errors import FileError
from .manifest import NAME
from .unindexed_files import is_made


@contextmanager
def remove_on_failure(folder: Path) -> Iterator[None]:
    """Remove converted files and a new folder if planning fails."""
    is_new = not folder.exists()
    try:
        yield
    except BaseException:
        if folder.is_dir() and not (folder / NAME).exists():
            for made in filter(is_made, folder.iterdir()):
                shutil.rmtree(made, ignore_errors=True)
            if is_new and not any(folder.iterdir()):
                folder.rmdir()
        raise


def make_folder(folder: Path) -> None:
    """Create a run's folder, which may exist and be empty. FileError otherwise."""
    check_folder(folder)
    try:
        folder.mkdir(exist_ok=True)
    except OSError as error:
        raise FileError(folder, f"cannot be created: {error.strerror or error}") from error
    if not os.access(folder, os.W_OK | os.X_OK):
        raise FileError(folder, "is not writable", remedy="Choose another folder")


def check_folder(folder: Path) -> None:
    """Raise FileError unless a folder is missing, empty, or left by an interrupted plan."""
    if folder.exists() and not folder.is_dir():
        raise FileError(folder, "is not a folder", remedy="Give the name of a folder")
    try:
        inside = folder.iterdir() if folder.exists() else ()
        other = [path for path in inside if path.suffix != ".part" and not is_made(path)]
    except OSError as error:
        raise FileError(folder, f"cannot be created: {error.strerror or error}") from error
    if other:
        raise FileError(folder, "contains files that do not belong to a job", remedy="Give another folder")
