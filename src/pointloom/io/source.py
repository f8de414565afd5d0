"""Input files of readers: bytes at any offset, without a memory map, and checked for changes while they are read."""

from __future__ import annotations

import contextlib
import functools
import os
import stat
import sys
import threading
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import IO, Any, NamedTuple, ParamSpec, TypeVar

import numpy as np
from numpy.typing import NDArray

from ..core.atomic import restore_folder
from ..core.errors import FileError, FilePath, PointloomError
from ..core.interrupts import signal_exception
from ..core.paths import input_path, path_of
from ..core.serialized import keep_through_forks
from ..core.units import warn_of_units

# A header without an end would otherwise be searched in gigabytes of payload. Real ones are below 100 KiB.
MAX_HEADER_BYTES = 1 << 20
HEAD_BYTES = 1 << 12  # read at once: headers are shorter, with few exceptions

# More digits than any count needs; int() of longer text would be slow or rejected by Python.
_MAX_DIGITS = 19

# Reads of at most _SMALL_READ_BYTES are served from a window, since headers are read in pieces of a few bytes.
_SMALL_READ_BYTES, _WINDOW_BYTES = 1 << 12, 1 << 13
_BYTES_PER_SEARCH = 1 << 20  # [B] searched at a time
_PADDING = b"\0 \t\r\n"  # bytes that writers append
_MAX_PADDING = 1 << 12  # [B] a memory page. More is reported, as counts in the header may be too small
_MAX_READ = 1 << 30  # [B] by one call of the system, which allows 2 GB


class SourceFile:
    """A file as bytes: `len`, slices and `find` as of `bytes`, and arrays that are read into new memory.

    A memory map is not used: if another program cuts a mapped file, the next access ends the process (SIGBUS). Each
    read checks the size and the time of modification, and raises `FileError` if the file has changed since it was
    opened. A file that was replaced by another of the same name remains readable.
    """

    def __init__(self, path: Path):
        self.path = path
        self._file = os.open(path, os.O_RDONLY | getattr(os, "O_BINARY", 0))
        self._stamp = _Stamp.of(os.fstat(self._file))
        self._window = (0, b"")
        self._lock = threading.Lock()  # for systems where reading moves the position of the file
        keep_through_forks(self)

    def __del__(self) -> None:
        if (file := getattr(self, "_file", None)) is not None:
            os.close(file)

    def __len__(self) -> int:
        return self._stamp.size

    def __getitem__(self, part: slice) -> bytes:
        begin, end, _ = part.indices(len(self))
        if end - begin > _SMALL_READ_BYTES:
            return self._read(begin, end - begin)
        at, window = self._window
        if not at <= begin <= end <= at + len(window):
            at, window = begin, self._read(begin, min(_WINDOW_BYTES, len(self) - begin))
            self._window = at, window
        return window[begin - at : max(end - at, 0)]

    def find(self, text: bytes, begin: int = 0, end: int | None = None) -> int:
        """The first position of a text within `begin` and `end`, or -1."""
        end, overlap, size = min(len(self), len(self) if end is None else end), len(text) - 1, _SMALL_READ_BYTES
        while begin + overlap < end:
            block = self[begin : min(begin + size, end)]
            if (at := block.find(text)) >= 0:
                return begin + at
            begin, size = begin + len(block) - overlap, _BYTES_PER_SEARCH
        return -1

    def array(self, dtype: Any, count: int, begin: int = 0) -> NDArray[Any]:
        """Read `count` items from byte `begin` into a new array. Raises ValueError beyond the end, as NumPy does."""
        dtype = np.dtype(dtype)
        values = np.empty(count * dtype.itemsize, np.uint8)
        self.read_into(values, begin)
        return values.view(dtype)

    def every(self, step: int, dtype: Any, count: int, begin: int = 0) -> NDArray[Any]:
        """Read every `step`-th of `count` items from byte `begin` into a new array."""
        dtype = np.dtype(dtype)
        values = np.empty((-(-count // step), dtype.itemsize), np.uint8)
        for k, row in enumerate(values):
            self.read_into(row, begin + k * step * dtype.itemsize)
        return values.reshape(-1).view(dtype)

    def read_into(self, values: NDArray[np.uint8], begin: int) -> None:
        """Fill an array of bytes from byte `begin`."""
        if begin + len(values) > len(self):
            raise ValueError(f"{begin + len(values) - len(self)} bytes are missing")
        buffer, at = values.data, 0
        while at < len(buffer):
            part = buffer[at : at + _MAX_READ]
            if not (count := self._read_part(part, begin + at)):
                raise self._changed(os.fstat(self._file).st_size)
            at += count
        self.check_unchanged()

    def check_unchanged(self) -> None:
        """Raise `FileError` if the file has changed since it was opened."""
        now = _Stamp.of(os.fstat(self._file))
        if now != self._stamp:
            raise self._changed(now.size)

    @contextlib.contextmanager
    def errors(self) -> Iterator[None]:
        """Report errors of other packages that read the file as its change, if it has changed."""
        try:
            yield
        except FileError as error:
            try:
                self.check_unchanged()
            except FileError as changed:
                raise changed from error
            raise

    def reopen(self) -> IO[bytes]:
        """The same file as a stream. Raises `FileError` if the name belongs to another file by now."""
        stream = self.path.open("rb")
        now = _Stamp.of(os.fstat(stream.fileno()))
        if now != self._stamp:
            stream.close()
            raise self._changed(now.size)
        return stream

    def check_name(self) -> None:
        """Raise `FileError` if the name belongs to another file by now, for readers that open it several times."""
        self.reopen().close()

    def _read(self, begin: int, size: int) -> bytes:
        parts, end = [], begin + size
        while begin < end:
            parts.append(self._read_bytes(begin, min(end - begin, _MAX_READ)))
            if not parts[-1]:
                raise self._changed(os.fstat(self._file).st_size)
            begin += len(parts[-1])
        self.check_unchanged()
        return b"".join(parts)  # the part itself if it is the only one

    def _read_part(self, buffer: memoryview, begin: int) -> int:
        if hasattr(os, "preadv"):
            return os.preadv(self._file, [buffer], begin)
        data = self._read_bytes(begin, len(buffer))
        buffer[: len(data)] = data
        return len(data)

    def _read_bytes(self, begin: int, size: int) -> bytes:
        if hasattr(os, "pread"):
            return os.pread(self._file, size, begin)
        with self._lock:
            os.lseek(self._file, begin, os.SEEK_SET)
            return os.read(self._file, size)

    def _changed(self, size: int) -> FileError:
        return changed_error(self.path, len(self), size)


Source = bytes | SourceFile


@dataclass(frozen=True)
class SourcePart:
    """Bytes of a file that are read when `bytes` is called."""

    file: SourceFile
    begin: int
    size: int

    def __len__(self) -> int:
        return self.size

    def __bytes__(self) -> bytes:
        return self.file[self.begin : self.begin + self.size]


class _Stamp(NamedTuple):
    """The identity of a file and of its content, as far as the system reports it."""

    device: int
    inode: int
    size: int
    modified: int

    @classmethod
    def of(cls, status: os.stat_result) -> _Stamp:
        return cls(status.st_dev, status.st_ino, status.st_size, status.st_mtime_ns)


def changed_error(path: FilePath, expected: int, given: int) -> FileError:
    """The error for a file that another program changes while it is read."""
    found = f"{given:,}" if given != expected else "as many bytes, with another time of modification"
    reason = f"was changed while it was read: expected {expected:,} bytes, got {found}"
    return FileError(path, reason, remedy="Read it again when the other program has finished writing")


_Given = ParamSpec("_Given")
_Table = TypeVar("_Table")


@contextlib.contextmanager
def content_errors(path: FilePath) -> Iterator[None]:
    """Convert errors that damaged content causes in our code or NumPy to FileError: a safety net below the readers.
    IndexError and TypeError pass, as they indicate bugs. A file that was changed meanwhile raises FileError, too."""
    handled, stamp = sys.exception(), _PathStamp(path)
    try:
        yield
    except PointloomError as error:
        if isinstance(error, FileError):
            stamp.check_unchanged(error)
        raise
    except MemoryError as error:
        remedy = "Split it into smaller files, or read it on a machine with more"
        raise FileError(path, "needs more memory than is available", remedy=remedy) from error
    except (ValueError, ArithmeticError, RecursionError) as error:
        _pass_signals(error, handled)
        stamp.check_unchanged(error)
        reason = str(error).split("\n")[0] or type(error).__name__
        raise FileError(path, f"cannot be read: {reason}"[:300]) from error
    stamp.check_unchanged()


class _PathStamp:
    """The stamp of the file that a path names. None if it has none, which the reader reports."""

    def __init__(self, path: FilePath) -> None:
        self._given = path
        try:
            self._path: Path | None = path_of(path)
        except TypeError:
            self._path = None
        self._before = self._read()

    def _read(self) -> _Stamp | None:
        try:
            return None if self._path is None else _Stamp.of(self._path.stat())
        except (OSError, ValueError):
            return None

    def check_unchanged(self, error: Exception | None = None) -> None:
        """Raise `FileError` if the file has changed. A complete result of a replaced file is kept."""
        before, after = self._before, self._read()
        if before is None or after is None or after == before:
            return
        is_same_file = (after.device, after.inode) == (before.device, before.inode)
        if is_same_file or error is not None:
            raise changed_error(self._given, before.size, after.size) from error


def netted(reader: Callable[_Given, _Table]) -> Callable[_Given, _Table]:
    """Wrap a reader, whose first argument is the path, in `content_errors`."""

    @functools.wraps(reader)
    def read(*args: _Given.args, **kwargs: _Given.kwargs) -> _Table:
        path: Any = args[0]
        with content_errors(path):
            return reader(*args, **kwargs)

    return read


def open_source(path: FilePath) -> SourceFile:
    """Open a regular, non-empty file for reading at any offset."""
    path = path_of(path)
    handled = sys.exception()
    try:
        try:
            return _opened(path)
        except FileNotFoundError:
            restore_folder(path.parent)
            return _opened(path)
    except FileNotFoundError as error:
        raise FileError(path, "does not exist") from error
    except (OSError, ValueError) as error:
        if isinstance(error, FileError):
            raise
        _pass_signals(error, handled)
        raise FileError(path, f"cannot be read: {getattr(error, 'strerror', None) or error}") from error


def _opened(path: Path) -> SourceFile:
    status = path.stat()
    if stat.S_ISDIR(status.st_mode):
        raise FileError(path, "is a folder", remedy="Give the name of a file")
    if stat.S_ISREG(status.st_mode) and status.st_size == 0:
        raise FileError(path, "is empty", where="byte 0")
    return SourceFile(input_path(path))


def _pass_signals(error: BaseException, handled: BaseException | None) -> None:
    """Re-raise an exception of a signal handler if it caused this error."""
    if (stopped := signal_exception(error, handled)) is not None:
        raise stopped from None


def check_end(path: FilePath, source: SourceFile, end: int) -> None:
    """Raise `FileError` if bytes other than zeros and white space follow the payload, which ends at byte `end`."""
    left = len(source) - end
    for begin in range(end, len(source), _BYTES_PER_SEARCH):
        if source[begin : begin + _BYTES_PER_SEARCH].strip(_PADDING):
            remedy = "The counts in the header are too small, or the file was damaged"
            raise FileError(path, f"{left} bytes follow the declared payload", where=f"byte {end}", remedy=remedy)
    if left > _MAX_PADDING:
        message = f"{path}: {left:,} bytes of zeros or white space after the declared payload are left out"
        warn_of_units(message, UserWarning)


def parse_count(path: FilePath, text: str, what: str, line: int, *, maximum: int = 10**_MAX_DIGITS) -> int:
    """A decimal count in a header, at most `maximum`. Raises `FileError` with the line otherwise."""
    where = f"line {line}"
    if text.startswith("-") and text[1:].isdigit():
        raise FileError(path, f"{what} is negative: {text[:40]}", where=where)
    if not (text.isascii() and text.isdigit()):
        raise FileError(path, f"{what} is not a whole number: {text[:40]!r}", where=where)
    if len(text) > _MAX_DIGITS or int(text) > maximum:
        raise FileError(path, f"{what} is impossibly large: {text[:40]}", where=where)
    return int(text)
