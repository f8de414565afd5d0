"""Optional packages for file formats: loaded on demand, with their errors converted."""

from __future__ import annotations

import contextlib
import importlib
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from ..core.errors import FileError, FilePath
from ..core.interrupts import signal_exception


def import_for(path: FilePath, module: str, extra: str) -> Any:
    """Import a module of an optional package for a file. Raises `FileError` naming the `extra` that installs it."""
    try:
        return importlib.import_module(module)
    except ImportError as error:
        reason = f"{Path(path).suffix.lower()} needs the package {module.split('.')[0]}"
        raise FileError(path, reason, remedy=f'pip install "pointloom[{extra}]"') from error


@contextlib.contextmanager
def foreign_errors(path: FilePath, what: str, *, remedy: str = "") -> Iterator[None]:
    """Convert errors of another package to FileError; `what` starts the reason.
    FileError, MemoryError, non-Exception (KeyboardInterrupt, test time limits) and exceptions of signal handlers pass
    unchanged. Panics of Rust packages are converted, although they are no Exception."""
    handled = sys.exception()
    try:
        yield
    except (FileError, MemoryError):
        raise
    except BaseException as error:
        if not isinstance(error, Exception) and not _is_panic(error):
            raise
        stopped = signal_exception(error, handled)
        if stopped is error:
            raise
        if stopped is not None:
            raise stopped from None
        reason = str(error).split("\n")[0][:300] or type(error).__name__
        raise FileError(path, f"{what}: {reason}", remedy=remedy) from error


@contextlib.contextmanager
def ignored_errors() -> Iterator[None]:
    """Ignore errors of another package on an optional part of a file, except MemoryError and signal handlers'."""
    handled = sys.exception()
    try:
        yield
    except MemoryError:
        raise
    except Exception as error:
        if (stopped := signal_exception(error, handled)) is not None:
            raise stopped from None


def _is_panic(error: BaseException) -> bool:
    """True for a panic of a Rust package. Each package has its own class of this name."""
    return (type(error).__module__, type(error).__name__) == ("pyo3_runtime", "PanicException")
