"""Folders that a run owns: recognized by the content of a marker file, locked, without links."""

from __future__ import annotations

import contextlib
import os
import re
import weakref
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from .errors import FileError, FilePath
from .paths import is_file, os_errors, path_of, refuse_link, refuse_links

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None

_OTHER = "Give another folder, or move these files away"
_EARLIER = "Give --resume to continue it, --force to start over, or another folder with --work"
_PART = re.compile(r"\..*\.[0-9a-f]{16}\.part")  # name of a file that a killed process did not complete


class RunFolder:
    """A folder that a run owns. The files of other programs in it are neither used, replaced nor removed.

    Args:
        folder: The folder, which may not exist.
        marker: Name of the file that identifies a run. Other programs may use the same name.
        is_marker: Returns True if the file is the marker of a run. May raise FileError.
        name: Name of the argument `folder`.
        remedy: How to continue or replace an earlier run.
    """

    def __init__(
        self,
        folder: FilePath,
        marker: str,
        is_marker: Callable[[Path], bool],
        *,
        name: str = "folder",
        remedy: str = _EARLIER,
    ):
        self.path, self.marker, self._is_marker, self._remedy = path_of(folder, name), marker, is_marker, remedy
        self._lock: weakref.finalize[Any, Any] | None = None

    @property
    def is_run(self) -> bool:
        """True if the folder contains an earlier run."""
        if not is_file(refuse_link(self.path / self.marker)):
            return False
        try:
            return self._is_marker(self.path / self.marker)
        except FileError:
            return False

    def check(self, *, resume: bool, overwrite: bool) -> Path:
        """The folder if a run can be created, resumed or replaced in it. Raises FileError otherwise."""
        folder = self.path
        with os_errors(folder, "used"):
            if folder.exists() and not folder.is_dir():
                raise FileError(folder, "is not a folder", remedy="Give the name of a folder as work")
            if not folder.absolute().parent.is_dir():
                raise FileError(folder, f"the folder {folder.parent} does not exist", remedy="Make the folder first")
            # it may contain empty folders and incomplete files of a run that was interrupted at the start
            files = (path for path in folder.rglob("*") if not path.is_dir() and not _PART.fullmatch(path.name))
            is_filled = folder.exists() and next(files, None) is not None
        if is_filled and not self.is_run:
            has_marker = os.path.lexists(folder / self.marker)
            why = f": its {self.marker} is of another program or version" if has_marker else ""
            raise FileError(folder, f"contains files that do not belong to a run{why}", remedy=_OTHER)
        if is_filled and not resume and not overwrite:
            raise FileError(folder, "contains an earlier run", remedy=self._remedy)
        return folder

    def file(self, name: str) -> Path:
        """The path of an own file. Raises FileError if it is a link, which would redirect writes and removals."""
        return refuse_link(self.path / name)

    @contextlib.contextmanager
    def opened(self) -> Iterator[Path]:
        """Create the folder if it is missing and lock it. Raises FileError if it contains links or is in use."""
        with os_errors(self.path, "created"):
            self.path.mkdir(exist_ok=True)
        with locked(self.path):
            refuse_links(self.path)
            yield self.path

    @property
    def is_held(self) -> bool:
        return self._lock is not None and self._lock.alive

    def hold(self, owner: object) -> None:
        """Keep the folder open as `opened` until `release` or the end of an object."""
        with contextlib.ExitStack() as stack:
            stack.enter_context(self.opened())
            self._lock = weakref.finalize(owner, stack.pop_all().close)

    def release(self) -> None:
        if self._lock is not None:
            self._lock()


@contextlib.contextmanager
def locked(folder: FilePath) -> Iterator[None]:
    """Lock a folder against other processes. The lock ends with the process. Raises `FileError` if it is locked."""
    if fcntl is None:
        yield
        return
    with os_errors(path_of(folder, "folder"), "locked"):
        descriptor = os.open(folder, os.O_RDONLY)
    try:
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError as error:
            remedy = "Wait until it is done, or give another folder"
            raise FileError(folder, "another run is using it", remedy=remedy) from error
        except OSError:  # a file system without locks
            pass
        yield
    finally:
        os.close(descriptor)
