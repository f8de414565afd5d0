"""The folder in which a job leaves the files of its stages: nothing in it is lost that somebody wants to keep."""

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
    """The folder of the stages, once it is sure that nothing in it is replaced that somebody wants to keep.

    Args:
        folder: The folder; its parent is there.
        marker: The file that each run of the job leaves in it, and first of all.
        resume: Whether an earlier run is gone on with.
        overwrite: Whether one is replaced.

    Raises:
        FileError: It is a file, its parent is missing, it holds an earlier run and is neither to be kept nor replaced,
            or it holds something else.
    """
    folder = path_of(folder, "folder")
    if folder.exists() and not folder.is_dir():
        raise FileError(folder, "is not a folder", remedy="Give the name of a folder with --work")
    if not folder.absolute().parent.is_dir():
        raise FileError(folder, f"the folder {folder.parent} does not exist", remedy="Make the folder first")
    if not folder.exists() or not any(path.is_file() for path in folder.rglob("*")):
        return folder  # it may hold empty folders, of a run that was interrupted at its very beginning
    if not (folder / marker).is_file():
        raise FileError(folder, "holds other files than those of a run", remedy="Give another folder with --work")
    if not resume and not overwrite:
        remedy = "Give --resume to go on with it, --force to begin anew, or another folder with --work"
        raise FileError(folder, "holds an earlier run", remedy=remedy)
    return folder


@contextlib.contextmanager
def held(folder: FilePath) -> Iterator[None]:
    """Keep other processes from working in a folder meanwhile; one that ends in whatever way lets go of it.

    Raises:
        FileError: Another does.
    """
    if fcntl is None:
        yield
        return
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError as error:
            remedy = "Wait until it is done, or give another folder with --work"
            raise FileError(folder, "another run works in it", remedy=remedy) from error
        except OSError:  # a file system without locks
            pass
        yield
    finally:
        os.close(descriptor)
