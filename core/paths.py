"""Paths as users give them: `~` is their home, and what is no path is told by what it is."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any


def path_of(path: Any) -> Path:
    """The path, with `~` and `~name` as a shell has them.

    Raises:
        TypeError: Not a path.
    """
    if not isinstance(path, str | os.PathLike):
        raise TypeError(f"path: expected the path of a file or folder, got a {type(path).__name__}; it comes first")
    given = Path(path)
    try:
        return given.expanduser()
    except RuntimeError:  # no such user: a file may be called so
        return given
