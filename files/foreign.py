"""Other packages that read and write files for us: loaded where they are needed, their errors made ours."""

from __future__ import annotations

import contextlib
import importlib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from ..core.errors import FileError


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
def foreign_errors(path: Any, what: str) -> Iterator[None]:
    """Turn whatever another package raises over a file into a FileError; Rust's panics are no Exception."""
    try:
        yield
    except (FileError, MemoryError, KeyboardInterrupt, SystemExit, GeneratorExit):
        raise
    except BaseException as error:
        reason = str(error).split("\n")[0] or type(error).__name__
        raise FileError(path, f"{what}: {reason}") from error
