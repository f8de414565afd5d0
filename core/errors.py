"""The errors that pointloom raises by name: each says what went wrong, where, and how to mend it."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Iterator
from pathlib import Path

from .escaped_text import escaped

MOST_NAMES = 10_000  # of a folder that are looked through for one like a name that is not there
_ABSENT = ("does not exist", "cannot be read: ")

FilePath = str | os.PathLike[str]


class PointloomError(Exception):
    """Base of every named error."""


class FileError(PointloomError, ValueError):
    """A file that cannot be read or written as asked.

    Args:
        path: The file.
        reason: What is wrong with it.
        where: The byte, line or row at which it was seen, such as ``"byte 312"`` or ``"line 7"``.
        remedy: What the user can do. Of a file that is not there: names like its own that are.
    """

    def __init__(self, path: FilePath, reason: str, *, where: str = "", remedy: str = ""):
        if not remedy and reason.startswith(_ABSENT):
            remedy = _near_paths(os.fspath(path))
        self.path, self.reason, self.where, self.remedy = os.fspath(path), *map(escaped, (reason, where, remedy))
        place = f"{escaped(self.path)} ({self.where})" if where else escaped(self.path)
        super().__init__(f"{place}: {self.reason}" + (f". {self.remedy}" if remedy else ""))

    def __reduce__(self):
        """Survive pickling: the keyword arguments travel along."""
        return _rebuild_file_error, (type(self), self.path, self.reason, self.where, self.remedy)


class DatasetError(FileError):
    """A folder of frames that is incomplete or inconsistent."""


class CameraError(PointloomError, RuntimeError):
    """A depth camera that cannot be opened, was pulled out or sends nothing, or whose driver is missing."""


class DeviceError(PointloomError, RuntimeError):
    """A device that does not exist, or operands that live on different ones."""


@contextlib.contextmanager
def values_of_file(path: FilePath, *, where: str = "") -> Iterator[None]:
    """Turn the errors of argument checks, for values that were read from a file, into a FileError with its path."""
    try:
        yield
    except FileError:
        raise
    except (ValueError, TypeError, OverflowError) as error:
        raise FileError(path, str(error), where=where) from error


def _near_paths(path: str) -> str:
    """The names beside a path that is not there which are like it, or the first of its folders that is not there."""
    from difflib import get_close_matches  # only errors pay for it

    absent = Path(path)
    if os.path.lexists(absent):
        return ""
    if any(sign in path for sign in "*?"):
        return "One file is read at a time: sorted(pathlib.Path(folder).glob(pattern)) lists them"
    while not absent.parent.exists():
        absent = absent.parent
    try:
        with os.scandir(absent.parent) as entries:
            names = [entry.name for _, entry in zip(range(MOST_NAMES), entries, strict=False)]
    except OSError:
        return ""
    folder = "" if absent == Path(path) else f"There is no folder {absent}"
    own = absent.name.lower()
    alike = [name for name in names if name.lower() == own or Path(name).stem.lower() == own]
    near = get_close_matches(own, [name.lower() for name in names], n=3, cutoff=0.7)
    found = dict.fromkeys([*sorted(alike), *(name for like in near for name in names if name.lower() == like)])
    if not found:
        return folder
    said = " or ".join(str(absent.with_name(name)) for name in list(found)[:3])
    return f"{folder}; did you mean {said}?" if folder else f"Did you mean {said}?"


def _rebuild_file_error(kind: type[FileError], path: str, reason: str, where: str, remedy: str) -> FileError:
    return kind(path, reason, where=where, remedy=remedy)
