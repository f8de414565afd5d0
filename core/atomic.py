"""Outputs appear whole or not at all: written beside their place under a temporary name, then renamed."""

from __future__ import annotations

import contextlib
import io
import os
import shutil
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import IO, Any

from .errors import FileError
from .paths import path_of

_REPLACE = "Give another name, or overwrite=True to replace it"


def check_writable(path: str | os.PathLike[str], *, overwrite: bool = True) -> Path:
    """The path, once it is sure that a file can be made there; call it before any long work.

    Raises:
        FileError: The folder is missing or read-only, the path is a folder, or the file exists and may not be replaced.
    """
    path = path_of(path)
    folder = path.parent
    if not folder.is_dir():
        raise FileError(path, f"the folder {folder} does not exist", remedy="Make the folder first")
    if path.is_dir():
        raise FileError(path, "is a folder", remedy="Give the name of a file")
    if path.exists() and not overwrite:
        raise FileError(path, "exists already", remedy=_REPLACE)
    if not os.access(folder, os.W_OK | os.X_OK):
        raise FileError(path, f"the folder {folder} is not writable", remedy="Choose another folder")
    return path


@contextlib.contextmanager
def atomic_write(path: str | os.PathLike[str], *, overwrite: bool = True) -> Iterator[IO[bytes]]:
    """A binary file that takes its name when the block ends without an error, and is removed otherwise."""
    path = check_writable(path, overwrite=overwrite)
    handle, name = tempfile.mkstemp(prefix=f".{path.name}.", suffix=".part", dir=path.parent)
    part = Path(name)
    file = _Written(io.FileIO(handle, "wb"))
    try:
        with file:
            yield file
            file.flush()
        mode = path.stat().st_mode & 0o777 if path.exists() else 0o666 & ~_umask()
        part.chmod(mode)
        if overwrite:
            part.replace(path)
        else:
            os.link(part, path)  # fails where another process made the file meanwhile
            part.unlink()
    except FileExistsError as error:
        part.unlink(missing_ok=True)
        raise FileError(path, "exists already", remedy=_REPLACE) from error
    except BaseException as error:
        part.unlink(missing_ok=True)
        told = error if isinstance(error, OSError) else file.failed
        if told is not None and told.strerror:
            raise FileError(path, f"cannot be written: {told.strerror}") from error
        raise


class _Written(io.BufferedWriter):
    """A file that remembers why it could not be written: libraries that write to it may tell another reason."""

    failed: OSError | None = None

    def write(self, data: Any, /) -> int:
        try:
            return super().write(data)
        except OSError as error:
            self.failed = error
            raise


def check_folder(path: str | os.PathLike[str], marker: str, *, overwrite: bool = True) -> Path:
    """The path, once it is sure that a folder can be made there in place of nothing, or of one with a marker.

    Raises:
        FileError: The folder around it is missing or read-only, it is a file, it may not be replaced, or it holds
            something without the marker.
    """
    path = path_of(path)
    if path.exists() and not path.is_dir():
        raise FileError(path, "is not a folder", remedy="Give the name of a folder")
    parent = path.absolute().parent
    if not parent.is_dir():
        raise FileError(path, f"the folder {parent} does not exist", remedy="Make the folder first")
    if path.is_dir() and any(path.iterdir()):
        if not (path / marker).is_file():
            raise FileError(path, f"holds other files: there is no {marker}", remedy="Give another folder")
        if not overwrite:
            raise FileError(path, "exists already", remedy=_REPLACE)
    if not os.access(parent, os.W_OK | os.X_OK):
        raise FileError(path, f"the folder {parent} is not writable", remedy="Choose another folder")
    return path


@contextlib.contextmanager
def atomic_folder(path: str | os.PathLike[str], marker: str, *, overwrite: bool = True) -> Iterator[Path]:
    """A folder that takes its name when the block ends without an error, and is removed otherwise.

    Raises:
        FileError: As `check_folder`; or a file cannot be written.
    """
    path = check_folder(path, marker, overwrite=overwrite)
    part = Path(tempfile.mkdtemp(prefix=f".{path.name}.", suffix=".part", dir=path.absolute().parent))
    try:
        yield part
        part.chmod(0o777 & ~_umask())
        check_folder(path, marker, overwrite=overwrite)
        if path.exists():
            old = part.with_suffix(".old")
            path.rename(old)
            part.rename(path)
            shutil.rmtree(old)
        else:
            part.rename(path)
    except BaseException as error:
        shutil.rmtree(part, ignore_errors=True)
        if isinstance(error, OSError) and error.strerror:
            raise FileError(path, f"cannot be written: {error.strerror}") from error
        raise


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
