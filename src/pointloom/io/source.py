"""Memory-mapped input files."""

from __future__ import annotations

import contextlib
import functools
import mmap
import os
import stat
import sys
from collections.abc import Callable, Iterator
from typing import Any, ParamSpec, TypeVar

from ..core.atomic import restore_folder
from ..core.errors import FileError, PointloomError
from ..core.interrupts import signal_exception
from ..core.paths import path_of

# A header without an end would otherwise be searched in gigabytes of payload. Real ones are below 100 KiB.
MAX_HEADER_BYTES = 1 << 20

# More digits than any count needs; int() of longer text would be slow or rejected by Python.
_MAX_DIGITS = 19

Source = bytes | mmap.mmap

_Given = ParamSpec("_Given")
_Table = TypeVar("_Table")


@contextlib.contextmanager
def content_errors(path: Any) -> Iterator[None]:
    """Convert errors that damaged content causes in our code or NumPy to FileError: a safety net below the readers.
    IndexError and TypeError pass, as they indicate bugs."""
    handled = sys.exception()
    try:
        yield
    except PointloomError:
        raise
    except MemoryError as error:
        remedy = "Split it into smaller files, or read it on a machine with more"
        raise FileError(path, "needs more memory than is available", remedy=remedy) from error
    except (ValueError, ArithmeticError, RecursionError) as error:
        _pass_signals(error, handled)
        reason = str(error).split("\n")[0] or type(error).__name__
        raise FileError(path, f"cannot be read: {reason}"[:300]) from error


def netted(reader: Callable[_Given, _Table]) -> Callable[_Given, _Table]:
    """Wrap a reader, whose first argument is the path, in `content_errors`."""

    @functools.wraps(reader)
    def read(*args: _Given.args, **kwargs: _Given.kwargs) -> _Table:
        with content_errors(args[0]):
            return reader(*args, **kwargs)

    return read


def open_source(path: str | os.PathLike[str]) -> Source:
    """Map a regular, non-empty file read-only. Slices are `bytes`, and NumPy can view it without a copy."""
    path = path_of(path)
    restore_folder(path.parent)
    handled = sys.exception()
    try:
        status = path.stat()
        if stat.S_ISDIR(status.st_mode):
            raise FileError(path, "is a folder", remedy="Give the name of a file")
        if not stat.S_ISREG(status.st_mode):
            raise FileError(path, "is not a regular file", remedy="Copy its content into a file first")
        if status.st_size == 0:
            raise FileError(path, "is empty", where="byte 0")
        with path.open("rb") as file:
            try:
                return mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ)
            except (OSError, ValueError):  # file systems without mmap
                return file.read()
    except FileNotFoundError as error:
        raise FileError(path, "does not exist") from error
    except (OSError, ValueError) as error:
        if isinstance(error, FileError):
            raise
        _pass_signals(error, handled)
        raise FileError(path, f"cannot be read: {getattr(error, 'strerror', None) or error}") from error


def _pass_signals(error: BaseException, handled: BaseException | None) -> None:
    """Re-raise an exception of a signal handler if it caused this error."""
    if (stopped := signal_exception(error, handled)) is not None:
        raise stopped from None


def parse_count(path: Any, text: str, what: str, line: int, *, maximum: int = 10**_MAX_DIGITS) -> int:
    """A decimal count in a header, at most `maximum`. Raises `FileError` with the line otherwise."""
    where = f"line {line}"
    if text.startswith("-") and text[1:].isdigit():
        raise FileError(path, f"{what} is negative: {text[:40]}", where=where)
    if not (text.isascii() and text.isdigit()):
        raise FileError(path, f"{what} is not a whole number: {text[:40]!r}", where=where)
    if len(text) > _MAX_DIGITS or int(text) > maximum:
        raise FileError(path, f"{what} is impossibly large: {text[:40]}", where=where)
    return int(text)
