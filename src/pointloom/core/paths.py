"""User-provided paths: `~` is expanded, other types raise."""

from __future__ import annotations

import contextlib
import os
import stat
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from .errors import FileError

RECORDINGS = (".bag", ".mcap", ".db3")  # of robots
CONTOURS = {".gpkg": "GPKG", ".geojson": "GeoJSON", ".dxf": "DXF"}  # of contour lines: GDAL's name of the format
# The specification of Git LFS: a pointer is smaller than 1,024 bytes, and its first line is the version.
_MAX_POINTER_BYTES = 1024
_POINTER_STARTS = (b"version https://git-lfs.github.com/spec/", b"version https://hawser.github.com/spec/")
IN_FOLDERS = tuple(extension for extension in RECORDINGS if extension != ".bag")  # files of a bag of ROS 2


def path_of(path: object, name: str = "path") -> Path:
    """A path with `~` and `~name` expanded. Raises `TypeError`, naming the argument, for other types, and `FileError`
    for names that the system rejects, for which methods of `Path` raise `OSError` or `RuntimeError`."""
    text = path.__fspath__() if isinstance(path, os.PathLike) else path
    if not isinstance(text, str):
        hint = "; it comes first" if name == "path" else ""
        raise TypeError(f"{name}: expected the path of a file or folder, got a {type(path).__name__}{hint}")
    given = path if isinstance(path, Path) else Path(text)
    if text.startswith("~"):
        with contextlib.suppress(RuntimeError):  # no such user: a valid file name
            given = given.expanduser()
    try:
        given.stat()
    except (FileNotFoundError, NotADirectoryError, ValueError):  # reported where the path is used
        pass
    except OSError as error:  # a long name, a loop of links, or a folder that may not be searched
        raise FileError(given, f"cannot be accessed: {error.strerror}") from error
    return given


def input_path(path: Any) -> Path:
    """The path of an input file. Raises `FileError` for pipes and devices, whose content may have no end, and for
    pointers of Git LFS."""
    given = path_of(path)
    mode = size = 0
    with contextlib.suppress(OSError, ValueError):  # reported when the file is opened
        status = given.stat()
        mode, size = status.st_mode, status.st_size
    if mode and not stat.S_ISREG(mode) and not stat.S_ISDIR(mode):
        raise FileError(path, "is not a regular file", remedy="Copy its content into a file first")
    if stat.S_ISREG(mode) and 0 < size < _MAX_POINTER_BYTES:
        _check_no_pointer(given)
    return given


def _check_no_pointer(path: Path) -> None:
    """Raise `FileError` for a pointer of Git LFS in place of the data."""
    with contextlib.suppress(OSError), path.open("rb") as file:
        text = file.read(_MAX_POINTER_BYTES)
        if text.removeprefix(b"\xef\xbb\xbf").startswith(_POINTER_STARTS):
            remedy = "Run `git lfs pull` in its repository, or download the file itself"
            raise FileError(path, "is a pointer of Git LFS, not the data", remedy=remedy)


def is_recording(path: Path) -> bool:
    """True for the name of a robot recording, or a folder of one."""
    if path.is_dir():
        return any(file.suffix in IN_FOLDERS for file in path.iterdir())
    return path.suffix.lower() in RECORDINGS


def recording_remedy(path: object, call: str) -> str:
    """How to read a recording, for readers of other files. Empty for other paths."""
    return f"Read this recording with loom.open_recording(path).{call}" if is_recording(path_of(path)) else ""


@contextlib.contextmanager
def os_errors(path: Path, verb: str) -> Iterator[None]:
    """Convert errors of the operating system to `FileError`; `verb` is what cannot be done, such as "written"."""
    try:
        yield
    except OSError as error:
        if error.strerror is None:  # raised by another package
            raise
        raise FileError(error.filename or path, f"cannot be {verb}: {error.strerror}") from error


def refuse_link(path: Path) -> Path:
    """The path of a job file. Raises `FileError` for a symbolic link, which would redirect writes and removals."""
    if path.is_symlink():
        raise FileError(path, "is a symbolic link", remedy="Replace it with its target")
    return path


def refuse_links(folder: Path, *, recursive: bool = False) -> None:
    """Raise `FileError` if a folder of a job contains a symbolic link. The folder itself may be one of the user."""
    with os_errors(folder, "read"):
        for path in folder.iterdir():
            if refuse_link(path).is_dir() and recursive:
                refuse_links(path, recursive=True)


def job_file(path: Path, root: Path | None = None) -> Path:
    """The path of a file to write in a job's folder, which is created. Raises `FileError` for links below `root`, which
    is by default the folder that contains the file's folder."""
    at = path.parent.parent if root is None else root
    with os_errors(path.parent, "created"):
        for name in path.relative_to(at).parts:
            at = refuse_link(at / name)
        path.parent.mkdir(parents=True, exist_ok=True)
    return path


def plain_name(path: Path, name: object, *, remedy: str = "") -> str:
    """A file name read from `path`. Raises `FileError` if it is not a plain name in the same folder."""
    if not isinstance(name, str) or name in ("", ".", "..") or any(sign in name for sign in "/\\\0"):
        raise FileError(path, f"expected a plain file name, got {name!r}", remedy=remedy)
    return name


def is_file(path: Path) -> bool:
    """True if the file exists. False for invalid names."""
    try:
        return path.is_file()
    except (OSError, ValueError):
        return False
