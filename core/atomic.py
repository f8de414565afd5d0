"""Outputs appear whole or not at all: written beside their place under a temporary name, then renamed."""

from __future__ import annotations

import contextlib
import errno
import functools
import io
import json
import os
import re
import secrets
import shutil
import sys
from collections.abc import Generator, Iterator, Sequence
from pathlib import Path
from typing import IO, Any

from .errors import FileError
from .interrupts import signal_exception
from .paths import path_of

_REPLACE = "Give another name, or overwrite=True to replace it"
_COMMITTED, _LIST = ".files.new", ".list.json"  # of files that are replaced together
_MAX_ATTEMPTS = 5  # to replace a folder while another process restores the previous one


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
    """A binary file that takes its name when the block ends without an error, and is removed otherwise.

    A new file gets the permissions that `open` would give it. A replaced file keeps its own.
    """
    path = check_writable(path, overwrite=overwrite)
    handled, mode, part, file = sys.exception(), _mode_of(path), part_name(path), None
    opener = functools.partial(os.open, mode=0o666 if mode is None else mode)
    try:
        with (file := _Written(io.FileIO(os.fspath(part), "x", opener=opener))):
            yield file
            file.flush()
        if file.failed is not None:  # a package caught it and went on
            raise file.failed
        if (mode := _mode_of(path)) is not None:
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
        failed = None if file is None else file.failed
        for each in (error, failed):  # Ctrl-C or a time limit, although another error followed from it
            stopped = None if each is None else signal_exception(each, handled)
            if stopped is error:
                raise
            if stopped is not None and isinstance(error, Exception):
                raise stopped from None
        _raise_write_error(path, error, failed)
        raise


def _raise_write_error(path: Path, error: BaseException, failed: BaseException | None) -> None:
    """Raise what the system said, where `error` is another package's error that followed from it."""
    if failed is not None and not isinstance(failed, Exception) and isinstance(error, Exception):
        raise failed
    told = error if isinstance(error, OSError) else failed
    if isinstance(told, OSError) and told.strerror:
        raise FileError(path, f"cannot be written: {told.strerror}") from error


def part_name(path: Path, ending: str = "part") -> Path:
    """A new hidden name in the same folder. `open` and `mkdir` then give the usual permissions, unlike `tempfile`."""
    return path.absolute().with_name(f".{path.name}.{secrets.token_hex(8)}.{ending}")


def _mode_of(path: Path) -> int | None:
    """The permissions of a file or folder; None if it does not exist."""
    try:
        return path.stat().st_mode & 0o777
    except FileNotFoundError:
        return None


_write = io.BufferedWriter.write


class _Written(io.BufferedWriter):
    """A file that stores the exception that ended a write. Packages that write to it may raise another, or none."""

    failed: BaseException | None = None

    def __init__(self, raw: Any):
        super().__init__(raw)
        writing = self._writing()
        next(writing)
        self.write = writing.send  # type: ignore[method-assign, assignment]

    def _writing(self) -> Generator[int, Any, None]:
        """Writes of what is sent. A generator goes on inside of its try block, where a method would begin before it.

        Signals are handled when a function begins, too.
        """
        try:
            count = 0
            while True:
                data = yield count
                count = _write(self, data)
                self.flush()  # handles signals, so a later `seek` of the package must not have to do it
        except BaseException as error:
            self.failed = error
            raise


def check_folder(path: str | os.PathLike[str], marker: str, *, overwrite: bool = True) -> Path:
    """The path, once it is sure that a folder can be made there in place of nothing, or of one with a marker.

    Raises:
        FileError: The folder around it is missing or read-only, it is a file, it may not be replaced, or it holds
            something without the marker.
    """
    path = path_of(path)
    restore_folder(path)
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

    A new folder gets the permissions that `mkdir` would give it. A replaced folder keeps its own. If the process is
    killed while the folder is replaced, the next `check_folder` or `restore_folder` brings the previous one back.

    Raises:
        FileError: As `check_folder`; or a file cannot be written.
    """
    path = check_folder(path, marker, overwrite=overwrite)
    mode, part = _mode_of(path), part_name(path)
    try:
        part.mkdir(0o777 if mode is None else mode | 0o700)
        yield part
        check_folder(path, marker, overwrite=overwrite)
        if (mode := _mode_of(path)) is not None:
            part.chmod(mode)
        _replace_folder(part, path)
    except BaseException as error:
        shutil.rmtree(part, ignore_errors=True)
        if isinstance(error, OSError) and error.strerror:
            raise FileError(path, f"cannot be written: {error.strerror}") from error
        raise


def _replace_folder(part: Path, path: Path) -> None:
    """Rename a folder to a name that another folder may have. The other one is restored if that fails."""
    old = part_name(path, "old")
    for attempt in range(_MAX_ATTEMPTS):
        try:
            with contextlib.suppress(FileNotFoundError):
                path.rename(old)
            part.rename(path)
            break
        except BaseException as error:
            restore_folder(path)  # also where another process just did
            is_back = isinstance(error, OSError) and error.errno in (errno.ENOTEMPTY, errno.EEXIST)
            if not is_back or attempt == _MAX_ATTEMPTS - 1:
                raise
            old = part_name(path, "old")
    for each in _old_folders(path):  # of a process that was killed here, too
        removed = part_name(path)
        with contextlib.suppress(OSError):
            each.rename(removed)  # first: a folder that is half removed must not be restored
            shutil.rmtree(removed, ignore_errors=True)


def restore_folder(path: str | os.PathLike[str]) -> None:
    """Bring a folder back that a killed process had renamed to replace it; nothing if a file or folder exists.

    The folders around the path are restored too, from the outermost one. Call it before a folder is reported as
    missing.
    """
    path = path_of(path).absolute()
    if os.path.lexists(path):
        return
    for place in (*reversed(path.parents), path):
        if not os.path.lexists(place) and (old := _old_folders(place)):
            with contextlib.suppress(OSError):  # another process was faster
                old[-1].rename(place)


def _old_folders(path: Path) -> list[Path]:
    pattern = re.compile(rf"\.{re.escape(path.name)}\.[0-9a-f]{{16}}\.old")
    try:
        with os.scandir(path.absolute().parent) as entries:
            found = [(entry.stat().st_mtime_ns, entry.path) for entry in entries if pattern.fullmatch(entry.name)]
    except OSError:
        return []
    return [Path(name) for _, name in sorted(found)]


@contextlib.contextmanager
def atomic_files(folder: Path, known: Sequence[str]) -> Iterator[Path]:
    """A hidden folder whose files take their places in `folder` together when the block ends without an error.

    All other `known` files of the folder are removed. If the process is killed meanwhile, `finish_files` goes on.

    Args:
        folder: An existing folder, which may contain other files too.
        known: Names of the files that belong together. The last one is removed first and replaced last, so other
            programs that need it never find files of two writers.

    Raises:
        FileError: A file cannot be written.
    """
    finish_files(folder, known)
    part = part_name(folder / "files")
    try:
        part.mkdir()
        yield part
        names = sorted(path.name for path in part.iterdir())
        for name in names:
            if (mode := _mode_of(folder / name)) is not None:
                (part / name).chmod(mode)
        (part / _LIST).write_text(json.dumps(names), encoding="utf-8")
        part.rename(folder / _COMMITTED)
        try:
            _finish_files(folder, known)
        except FileNotFoundError:  # a reader finishes it too
            if (folder / _COMMITTED).exists():
                raise
    except BaseException as error:
        shutil.rmtree(part, ignore_errors=True)
        if isinstance(error, OSError) and error.strerror:
            raise FileError(folder, f"cannot be written: {error.strerror}") from error
        raise


def finish_files(folder: Path, known: Sequence[str]) -> None:
    """Finish the replacement of files by a process that was killed. Call it before the files are looked for.

    Nothing but files of the `known` names is touched, whatever the folder contains.
    """
    with contextlib.suppress(OSError, ValueError):  # a folder that is read-only, or another process is faster
        _finish_files(folder, known)


def _finish_files(folder: Path, known: Sequence[str]) -> None:
    committed = folder / _COMMITTED
    if not committed.is_dir():
        return
    listing = committed / _LIST
    names = json.loads(listing.read_text(encoding="utf-8")) if listing.is_file() else []
    if not isinstance(names, list) or not all(name in known for name in names):
        raise ValueError(f"{listing}: expected names among {', '.join(known)}")
    moved = [name for name in known if name in names and not (committed / name).is_file()]
    for name in reversed(known) if names else ():
        if name not in moved:
            (folder / name).unlink(missing_ok=True)
    for name in known:
        if name in names and name not in moved:
            (committed / name).replace(folder / name)
    listing.unlink(missing_ok=True)
    committed.rmdir()
