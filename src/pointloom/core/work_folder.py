"""The folder of a job's stages, protected against accidental replacement."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Iterator
from pathlib import Path

from .errors import FileError, FilePath
from .paths import path_of

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None


def check_work_folder(folder: FilePath, *, marker: str, resume: bool, overwrite: bool) -> Path:
    """Check that a job folder, identified by its `marker` file, can be created, resumed or overwritten."""
    folder = path_of(folder, "folder")
    if folder.exists() and not folder.is_dir():
        raise FileError(folder, "is not a folder", remedy="Give the name of a folder with --work")
    if not folder.absolute().parent.is_dir():
        raise FileError(folder, f"the folder {folder.parent} does not exist", remedy="Make the folder first")
    if not folder.exists() or not any(path.is_file() for path in folder.rglob("*")):
        return folder  # it may contain empty folders of a run that was interrupted at the start
    if not (folder / marker).is_file():
        raise FileError(folder, "contains files that do not belong to a run", remedy="Give another folder with --work")
    if not resume and not overwrite:
        remedy = "Give --resume to continue it, --force to start over, or another folder with --work"
        raise FileError(folder, "contains an earlier run", remedy=remedy)
    return folder


@contextlib.contextmanager
def locked(folder: FilePath) -> Iterator[None]:
    """Lock a folder against other processes. The lock ends with the process. Raises `FileError` if it is locked."""
    if fcntl is None:
        yield
        return
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError as error:
            remedy = "Wait until it is done, or give another folder with --work"
            raise FileError(folder, "another run is using it", remedy=remedy) from error
        except OSError:  # a file system without locks
            pass
        yield
    finally:
        os.close(descriptor)
