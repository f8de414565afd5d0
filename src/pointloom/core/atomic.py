"""Atomic output: files and folders are written under a temporary name and then renamed."""

from __future__ import annotations

import contextlib
import errno
import functools
import hashlib
import io
import json
import os
import re
import secrets
import shutil
import stat
import sys
import tempfile
from collections.abc import Generator, Iterator, Sequence
from pathlib import Path
from typing import IO, Any

from .errors import FileError
from .interrupts import signal_exception
from .paths import path_of

_REPLACE = "Give another name, or overwrite=True to replace it"
_COMMITTED, _LIST = ".files.new", ".list.json"  # names for files that are replaced together
_MAX_SHORT_NAME = 100  # bytes; with 23 more a hidden name is below the 143 bytes of encrypted folders
_MAX_ATTEMPTS = 5  # attempts to replace a folder while another process restores the previous one


def check_writable(path: str | os.PathLike[str], *, overwrite: bool = True) -> Path:
    """Check that a file can be written, before long computations. Raises `FileError` otherwise.
    The rules are those of `open`: links are followed, and read-only files, folders and missing folders are errors."""
    return _check_target(path_of(path), overwrite=overwrite)[0]


def _check_target(path: Path, *, overwrite: bool) -> tuple[Path, Path, os.stat_result | None]:
    """As `check_writable`: (path, the file behind its links, the status of this file or None)."""
    target = _behind_links(path)
    status, folder = _status_of(path, target), target.parent
    if not folder.is_dir():
        raise FileError(path, f"the folder {folder} does not exist", remedy="Make the folder first")
    if not overwrite and os.path.lexists(path) and not (status and stat.S_ISDIR(status.st_mode)):
        raise FileError(path, "exists already", remedy=_REPLACE)
    if status is None:
        if not os.access(folder, os.W_OK | os.X_OK):
            raise FileError(path, f"the folder {folder} is not writable", remedy="Choose another folder")
        return path, target, None
    if stat.S_ISDIR(status.st_mode):
        raise FileError(path, "is a folder", remedy="Give the name of a file")
    if not stat.S_ISREG(status.st_mode) and not _is_stream(status):
        raise FileError(path, "is a socket or a block device", remedy="Give the name of a file")
    if not os.access(target, os.W_OK):
        raise FileError(path, "is read-only", remedy="Change its permissions, or give another name")
    return path, target, status


def _behind_links(path: Path) -> Path:
    """The file or folder that a symbolic link names, which may not exist. Other paths and /dev/stdout are unchanged."""
    if not os.path.islink(path) or _is_stream(_status_of(path, path)):  # noqa: PTH114  no error for a long name
        return path
    return Path(os.path.realpath(path))


def _is_stream(status: os.stat_result | None) -> bool:
    """True for a named pipe or a character device, such as /dev/null."""
    return status is not None and (stat.S_ISFIFO(status.st_mode) or stat.S_ISCHR(status.st_mode))


def _status_of(path: Path, target: Path) -> os.stat_result | None:
    """The status of an existing target. Raises `FileError` for a name that the file system rejects."""
    try:
        return target.stat()
    except FileNotFoundError:
        return None
    except (OSError, ValueError) as error:  # too long, a null character, a folder that may not be searched
        raise FileError(path, f"cannot be written: {getattr(error, 'strerror', None) or error}") from error


@contextlib.contextmanager
def atomic_write(path: str | os.PathLike[str], *, overwrite: bool = True) -> Iterator[IO[bytes]]:
    """A binary file that appears when the block succeeds and is removed otherwise.
    New files get the default permissions of `open`. Replaced files keep permissions, owner and attributes. Files with
    several names, files whose owner or folder excludes a replacement, pipes and devices are written after the block."""
    path, target, status = _check_target(path_of(path), overwrite=overwrite)
    handled, part, file = sys.exception(), _part_of(target, status), None
    opener = functools.partial(os.open, mode=0o666 if status is None else 0o600)
    try:
        with (file := _Written(io.FileIO(os.fspath(part), "x", opener=opener))):
            yield file
            file.flush()
        if file.failed is not None:  # a package caught it and continued
            raise file.failed
        _publish(part, path, overwrite=overwrite)
    except FileExistsError as error:
        part.unlink(missing_ok=True)
        raise FileError(path, "exists already", remedy=_REPLACE) from error
    except BaseException as error:
        part.unlink(missing_ok=True)
        failed = None if file is None else file.failed
        for each in (error, failed):  # Ctrl-C or a time limit, although another error followed
            stopped = None if each is None else signal_exception(each, handled)
            if stopped is error:
                raise
            if stopped is not None and isinstance(error, Exception):
                raise stopped from None
        _raise_write_error(path, error, failed)
        raise


@contextlib.contextmanager
def atomic_path(path: str | os.PathLike[str], *, overwrite: bool = True) -> Iterator[Path]:
    """As `atomic_write`, for packages that write to a name: a new name, whose file is moved when the block succeeds."""
    path, target, status = _check_target(path_of(path), overwrite=overwrite)
    part = _part_of(target, status)
    try:
        yield part
        _publish(part, path, overwrite=overwrite)
    except FileExistsError as error:
        raise FileError(path, "exists already", remedy=_REPLACE) from error
    finally:
        part.unlink(missing_ok=True)


def _part_of(target: Path, status: os.stat_result | None) -> Path:
    """A new name for the content of a file: in its folder, or in the temporary folder if it cannot be replaced."""
    part = part_name(target)
    return part if _is_replaceable(target, status) else Path(tempfile.gettempdir(), part.name)


def _is_replaceable(target: Path, status: os.stat_result | None) -> bool:
    return os.access(target.parent, os.W_OK | os.X_OK) and not _is_stream(status)


def _publish(part: Path, path: Path, *, overwrite: bool) -> None:
    """Move a complete file to its path. Raises `FileExistsError` for an existing one unless `overwrite`."""
    target = _behind_links(path)
    status = _status_of(path, target)
    if not overwrite:
        _link_new(part, target)
    elif status is None or (_is_replaceable(target, status) and _take_metadata(part, target, status)):
        part.replace(target)
    else:
        _overwrite(part, target)


def _link_new(part: Path, target: Path) -> None:
    """Give a new file its name. Raises `FileExistsError` if another process has created it."""
    try:
        os.link(part, target)
        part.unlink()
    except OSError as error:
        if error.errno not in (errno.EPERM, errno.ENOTSUP, errno.EOPNOTSUPP, errno.ENOSYS):
            raise
        with target.open("xb"):  # file systems without hard links, such as FAT and network drives
            pass
        part.replace(target)


def _take_metadata(part: Path, target: Path, status: os.stat_result) -> bool:
    """Give a new file or folder the owner, permissions and attributes of the existing one.

    Returns False if the owner cannot be kept, or if a file has several names.
    """
    if stat.S_ISREG(status.st_mode) and status.st_nlink > 1:
        return False
    if _owner_of(part.stat()) != (owner := _owner_of(status)):
        try:
            os.chown(part, *owner)
        except OSError:
            return False
    with contextlib.suppress(OSError):  # file systems without permissions
        part.chmod(stat.S_IMODE(status.st_mode))
    for name in os.listxattr(target) if hasattr(os, "listxattr") else ():
        with contextlib.suppress(OSError):
            os.setxattr(part, name, os.getxattr(target, name))
    return True


def _owner_of(status: os.stat_result) -> tuple[int, int]:
    return status.st_uid, status.st_gid


def _overwrite(part: Path, target: Path) -> None:
    """Copy the content into an existing file. Space is reserved first, so that a full disk is no reason for damage."""
    is_file = target.is_file()
    with part.open("rb") as source, target.open("r+b" if is_file else "wb") as file:
        size = os.fstat(source.fileno()).st_size
        if is_file and size and hasattr(os, "posix_fallocate"):
            os.posix_fallocate(file.fileno(), 0, size)
        shutil.copyfileobj(source, file)
        if is_file:
            file.truncate()
    part.unlink()


def _raise_write_error(path: Path, error: BaseException, failed: BaseException | None) -> None:
    if failed is not None and not isinstance(failed, Exception) and isinstance(error, Exception):
        raise failed
    cause = error if isinstance(error, OSError) else failed
    if isinstance(cause, OSError):  # NumPy's have no strerror
        raise FileError(path, f"cannot be written: {cause.strerror or cause}") from error


def part_name(path: Path, ending: str = "part") -> Path:
    """A new hidden name in the same folder. Unlike `tempfile`, permissions are those of `open` and `mkdir`."""
    return path.absolute().with_name(f".{_short_name(path)}.{secrets.token_hex(8)}.{ending}")


def _short_name(path: Path) -> str:
    """The name of a path, or a digest in place of a long one, so that hidden names fit into a file system."""
    name = os.fsencode(path.name)
    return path.name if len(name) <= _MAX_SHORT_NAME else hashlib.sha256(name).hexdigest()[:32]


def _mode_of(path: Path) -> int | None:
    try:
        return path.stat().st_mode & 0o777
    except FileNotFoundError:
        return None


_write = io.BufferedWriter.write


class _Written(io.BufferedWriter):
    """A file that stores the exception of a failed write, since packages may raise another or none."""

    failed: BaseException | None = None

    def __init__(self, raw: Any):
        super().__init__(raw)
        writing = self._writing()
        next(writing)
        self.write = writing.send  # type: ignore[method-assign, assignment]

    def _writing(self) -> Generator[int, Any, None]:
        """Write what is sent. A generator resumes inside its try block. A signal may hit a method before it."""
        try:
            count = 0
            while True:
                data = yield count
                count = _write(self, data)
                self.flush()  # handles signals, so that a later `seek` of the package need not
        except BaseException as error:
            self.failed = error
            raise


def check_folder(path: str | os.PathLike[str], marker: str, *, overwrite: bool = True) -> Path:
    """Check that a folder can be created, or may replace one that contains `marker`. Raises `FileError` otherwise."""
    path = path_of(path)
    restore_folder(path)
    target = _behind_links(path)
    status, parent = _status_of(path, target), target.absolute().parent
    if status is not None and not stat.S_ISDIR(status.st_mode):
        raise FileError(path, "is not a folder", remedy="Give the name of a folder")
    if not parent.is_dir():
        raise FileError(path, f"the folder {parent} does not exist", remedy="Make the folder first")
    is_filled = path.is_dir() and any(not _is_part(entry.name, target) for entry in path.iterdir())
    if is_filled:
        if not (path / marker).is_file():
            raise FileError(path, f"contains other files: there is no {marker}", remedy="Give another folder")
        if not overwrite:
            raise FileError(path, "exists already", remedy=_REPLACE)
    if status is not None and not os.access(target, os.W_OK):
        raise FileError(path, "is read-only", remedy="Change its permissions, or give another name")
    remedy = "Choose another folder" + ", or empty this one first" * is_filled
    if (status is None or is_filled) and not os.access(parent, os.W_OK | os.X_OK):
        raise FileError(path, f"the folder {parent} is not writable", remedy=remedy)
    if is_filled and os.path.ismount(target):
        raise FileError(path, "is a mount point, which cannot be replaced", remedy=remedy)
    return path


def _is_part(name: str, folder: Path) -> bool:
    """True for the hidden folder in which `atomic_folder` writes, also that of a killed process."""
    return re.fullmatch(rf"\.{re.escape(_short_name(folder.absolute()))}\.[0-9a-f]{{16}}\.part", name) is not None


@contextlib.contextmanager
def atomic_folder(path: str | os.PathLike[str], marker: str, *, overwrite: bool = True) -> Iterator[Path]:
    """A folder that appears when the block succeeds and is removed otherwise.
    New folders get default permissions. Replaced folders keep theirs. An empty folder that cannot be renamed (its
    parent is read-only, or it is a mount point) is filled by renaming each entry, `marker` last. After a crash during
    replacement, the next `check_folder` or `restore_folder` restores the previous folder."""
    path = check_folder(path, marker, overwrite=overwrite)
    target = _behind_links(path)
    mode, parent = _mode_of(target), target.absolute().parent
    is_fixed = os.path.ismount(target) or not os.access(parent, os.W_OK | os.X_OK)
    part = part_name(target / target.absolute().name if is_fixed else target)
    try:
        part.mkdir(0o777 if mode is None else mode | 0o700)
        yield part
        check_folder(path, marker, overwrite=overwrite)
        if is_fixed:
            _fill_folder(part, target, marker)
        else:
            if (status := _status_of(path, target)) is not None:
                _take_metadata(part, target, status)
            _replace_folder(part, target)
    except BaseException as error:
        shutil.rmtree(part, ignore_errors=True)
        if isinstance(error, OSError) and error.strerror:
            raise FileError(path, f"cannot be written: {error.strerror}") from error
        raise


@contextlib.contextmanager
def part_folder(part: Path) -> Iterator[None]:
    """A new folder that the block fills and renames. Removed at the end if not renamed. FileError if unwritable."""
    try:
        part.mkdir(parents=True)
        yield
    except FileError:
        raise
    except OSError as error:
        raise FileError(part, f"cannot be written: {error.strerror or error}") from error
    finally:
        shutil.rmtree(part, ignore_errors=True)


def _fill_folder(part: Path, target: Path, marker: str) -> None:
    """Move the entries of a folder into an empty one, which is empty again on failure."""
    names = sorted((path.name for path in part.iterdir()), key=marker.__eq__)
    try:
        for name in names:
            (part / name).rename(target / name)
        part.rmdir()
    except BaseException:
        for name in names:
            if os.path.lexists(target / name) and not os.path.lexists(part / name):
                (target / name).rename(part / name)
        raise


def _replace_folder(part: Path, path: Path) -> None:
    """Rename a folder over an existing one, which is restored on failure."""
    old = part_name(path, "old")
    for attempt in range(_MAX_ATTEMPTS):
        try:
            with contextlib.suppress(FileNotFoundError):
                path.rename(old)
            part.rename(path)
            break
        except BaseException as error:
            restore_folder(path)  # also if another process has just done so
            is_back = isinstance(error, OSError) and error.errno in (errno.ENOTEMPTY, errno.EEXIST)
            if not is_back or attempt == _MAX_ATTEMPTS - 1:
                raise
            old = part_name(path, "old")
    for each in _old_folders(path):  # also of a killed process
        removed = part_name(path)
        with contextlib.suppress(OSError):
            each.rename(removed)  # first: a partly removed folder must not be restored
            shutil.rmtree(removed, ignore_errors=True)


def restore_folder(path: str | os.PathLike[str]) -> None:
    """Restore a folder renamed by an interrupted replacement, outermost first. Call it before reporting it missing."""
    path = path_of(path).absolute()
    if os.path.lexists(path):
        return
    for missing in (*reversed(path.parents), path):
        if not os.path.lexists(missing) and (old := _old_folders(missing)):
            with contextlib.suppress(OSError):  # another process was faster
                old[-1].rename(missing)


def _old_folders(path: Path) -> list[Path]:
    pattern = re.compile(rf"\.{re.escape(_short_name(path))}\.[0-9a-f]{{16}}\.old")
    try:
        with os.scandir(path.absolute().parent) as entries:
            folders = [(entry.stat().st_mtime_ns, entry.path) for entry in entries if pattern.fullmatch(entry.name)]
    except OSError:
        return []
    return [Path(name) for _, name in sorted(folders)]


@contextlib.contextmanager
def atomic_files(folder: Path, known: Sequence[str]) -> Iterator[Path]:
    """A hidden folder whose files move to `folder` together when the block succeeds. Other `known` files are removed.
    The last `known` file is removed first and replaced last, so that readers never see a mixture. After a crash,
    `finish_files` continues. Symbolic links, pipes and devices are written one by one, before the others."""
    finish_files(folder, known)
    for name in known:
        if os.path.lexists(folder / name):
            check_writable(folder / name)
    part = part_name(folder / "files")
    try:
        part.mkdir()
        yield part
        names = sorted(path.name for path in part.iterdir())
        for path in map(part.joinpath, names):
            target = folder / path.name
            if not os.path.lexists(target):
                continue
            if target.is_symlink() or _is_stream(_status_of(target, target)):
                with path.open("rb") as source, atomic_write(target) as file:
                    shutil.copyfileobj(source, file)
                path.unlink()
            else:
                _take_metadata(path, target, target.stat())
        (part / _LIST).write_text(json.dumps(names), encoding="utf-8")
        part.rename(folder / _COMMITTED)
        try:
            _finish_files(folder, known)
        except FileNotFoundError:  # readers also complete it
            if (folder / _COMMITTED).exists():
                raise
    except BaseException as error:
        shutil.rmtree(part, ignore_errors=True)
        if isinstance(error, OSError) and error.strerror:
            raise FileError(folder, f"cannot be written: {error.strerror}") from error
        raise


def finish_files(folder: Path, known: Sequence[str]) -> None:
    """Complete an interrupted `atomic_files`. Only files with `known` names are touched. Call it before reading."""
    with contextlib.suppress(OSError, ValueError):  # a read-only folder, or another process is faster
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
