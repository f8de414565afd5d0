"""Other packages that read and write files for us: loaded where they are needed, their errors made ours."""

from __future__ import annotations

import contextlib
import importlib
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from ..core.errors import FileError
from ..core.interrupts import signal_exception


def import_for(path: Any, module: str, extra: str) -> Any:
    """A module of an optional package, which is loaded only where such a file is used.

    Args:
        path: The file, for errors.
        module: The module's name.
        extra: The extra of pointloom that installs the package.

    Raises:
        FileError: The package is missing.
    """
    try:
        return importlib.import_module(module)
    except ImportError as error:
        reason = f"{Path(path).suffix.lower()} needs the package {module.split('.')[0]}"
        raise FileError(path, reason, remedy=f'pip install "pointloom[{extra}]"') from error


@contextlib.contextmanager
def foreign_errors(path: Any, what: str, *, remedy: str = "") -> Iterator[None]:
    """Turn the errors that another package raises for a file into a FileError.

    Exceptions that are no errors of the package pass unchanged: a FileError, a MemoryError, everything that is no
    Exception (KeyboardInterrupt, time limits of test runners), and everything that a signal handler raised. The panics
    of packages in Rust are no Exception either, but they are errors.

    Args:
        path: The file, for errors.
        what: The beginning of the reason.
        remedy: What the user can do.

    Raises:
        FileError: The package raised an error.
    """
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
    """Ignore the errors that another package raises for a part of a file that is not needed.

    As with `foreign_errors`, a MemoryError and what a signal handler raised pass.
    """
    handled = sys.exception()
    try:
        yield
    except MemoryError:
        raise
    except Exception as error:
        if (stopped := signal_exception(error, handled)) is not None:
            raise stopped from None


def _is_panic(error: BaseException) -> bool:
    """True for a panic of a package in Rust. Each package has its own class of this name."""
    return (type(error).__module__, type(error).__name__) == ("pyo3_runtime", "PanicException")
