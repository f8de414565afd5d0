"""The errors that pointloom raises by name: each says what went wrong, where, and how to mend it."""

from __future__ import annotations

import os

FilePath = str | os.PathLike[str]


class PointloomError(Exception):
    """Base of every named error."""


class FileError(PointloomError, ValueError):
    """A file that cannot be read or written as asked.

    Args:
        path: The file.
        reason: What is wrong with it.
        where: The byte, line or row at which it was seen, such as ``"byte 312"`` or ``"line 7"``.
        remedy: What the user can do.
    """

    def __init__(self, path: FilePath, reason: str, *, where: str = "", remedy: str = ""):
        self.path, self.reason, self.where, self.remedy = os.fspath(path), reason, where, remedy
        place = f"{self.path} ({where})" if where else self.path
        super().__init__(f"{place}: {reason}" + (f". {remedy}" if remedy else ""))

    def __reduce__(self):
        """Survive pickling: the keyword arguments travel along."""
        return _rebuild_file_error, (type(self), self.path, self.reason, self.where, self.remedy)


class DatasetError(FileError):
    """A folder of frames that is incomplete or inconsistent."""


class CameraError(PointloomError, RuntimeError):
    """A depth camera that cannot be opened, was pulled out or sends nothing, or whose driver is missing."""


class DeviceError(PointloomError, RuntimeError):
    """A device that does not exist, or operands that live on different ones."""


def _rebuild_file_error(kind: type[FileError], path: str, reason: str, where: str, remedy: str) -> FileError:
    return kind(path, reason, where=where, remedy=remedy)
