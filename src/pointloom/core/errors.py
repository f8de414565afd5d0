"""Named errors of pointloom; messages contain cause, location and remedy."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Iterator
from pathlib import Path

from .escaped_text import escaped

MAX_NAMES = 10_000  # maximum names of a folder searched for similar ones
_ABSENT = ("does not exist", "cannot be read: ")

# How to use a file without faces where a mesh is expected.
CLOUD_REMEDY = (
    "Read it as a point cloud with read_point_cloud. "
    "loom.meshing.create_surface, or the command pointloom mesh, makes a mesh"
)

# Maintained programs that convert formats which no reader or writer has.
_CONVERTERS = dict.fromkeys(
    (".fbx", ".usd", ".usda", ".usdc", ".usdz"), "Blender (blender.org) imports and exports it, and .glb"
) | {".3mf": "trimesh converts it from and to .glb: trimesh.load(source).export(target)"}

FilePath = str | os.PathLike[str]


class PointloomError(Exception):
    """Base class of all named errors."""


class FileError(PointloomError, ValueError):
    """A file cannot be read or written as requested.

    Args:
        path: The file.
        reason: What is wrong.
        where: The byte, line or row, such as ``"byte 312"`` or ``"line 7"``.
        remedy: What the user can do. For a missing file: similar names that exist.
    """

    def __init__(self, path: FilePath, reason: str, *, where: str = "", remedy: str = ""):
        if not remedy and reason.startswith(_ABSENT):
            remedy = _near_paths(os.fspath(path))
        elif (converter := _CONVERTERS.get(Path(os.fsdecode(path)).suffix.lower(), "")) not in remedy:
            remedy = f"{remedy}. {converter}" if remedy else converter
        self.path, self.reason, self.where, self.remedy = os.fspath(path), *map(escaped, (reason, where, remedy))
        location = f"{escaped(self.path)} ({self.where})" if where else escaped(self.path)
        super().__init__(f"{location}: {self.reason}" + (f". {self.remedy}" if remedy else ""))

    def __reduce__(self):
        return _rebuild_file_error, (type(self), self.path, self.reason, self.where, self.remedy)


class DatasetError(FileError):
    """A folder of frames is incomplete or inconsistent."""


class CameraError(PointloomError, RuntimeError):
    """A depth camera cannot be opened, was disconnected or sends nothing, or its driver is missing."""


class DeviceError(PointloomError, RuntimeError):
    """A device does not exist, or operands are on different devices."""


@contextlib.contextmanager
def values_of_file(path: FilePath, *, where: str = "") -> Iterator[None]:
    """Convert errors of argument checks on values from a file to FileError."""
    try:
        yield
    except FileError:
        raise
    except (ValueError, TypeError, OverflowError) as error:
        raise FileError(path, str(error), where=where) from error


def _near_paths(path: str) -> str:
    """Similar names beside a missing path, or its first missing folder."""
    from difflib import get_close_matches  # imported only for errors

    absent = Path(path)
    if os.path.lexists(absent):
        return ""
    if any(sign in path for sign in "*?"):
        return "Read one file at a time: sorted(pathlib.Path(folder).glob(pattern)) lists them"
    while not absent.parent.exists():
        absent = absent.parent
    try:
        with os.scandir(absent.parent) as entries:
            names = [entry.name for _, entry in zip(range(MAX_NAMES), entries, strict=False)]
    except OSError:
        return ""
    folder = "" if absent == Path(path) else f"The folder {absent} does not exist"
    lower_name = absent.name.lower()
    alike = [name for name in names if name.lower() == lower_name or Path(name).stem.lower() == lower_name]
    near = get_close_matches(lower_name, [name.lower() for name in names], n=3, cutoff=0.7)
    candidates = dict.fromkeys([*sorted(alike), *(name for like in near for name in names if name.lower() == like)])
    if not candidates:
        return folder
    suggestions = " or ".join(str(absent.with_name(name)) for name in list(candidates)[:3])
    return f"{folder}; did you mean {suggestions}?" if folder else f"Did you mean {suggestions}?"


def _rebuild_file_error(kind: type[FileError], path: str, reason: str, where: str, remedy: str) -> FileError:
    return kind(path, reason, where=where, remedy=remedy)
