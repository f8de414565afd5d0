"""Paths as users give them: `~` is their home; anything else than a path is an error that names its type."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

from .errors import FileError


def path_of(path: Any, name: str = "path") -> Path:
    """The path, with `~` and `~name` as a shell has them.

    Args:
        path: The path.
        name: The argument's name, for errors.

    Raises:
        TypeError: Not a path.
    """
    text = path.__fspath__() if isinstance(path, os.PathLike) else path
    if not isinstance(text, str):
        hint = "; it comes first" if name == "path" else ""
        raise TypeError(f"{name}: expected the path of a file or folder, got a {type(path).__name__}{hint}")
    given = Path(text)
    try:
        return given.expanduser()
    except RuntimeError:  # no such user: a file may be called so
        return given


def refuse_link(path: Path) -> Path:
    """The path of an entry in a job's folder, after a check that it is no symbolic link.

    Raises:
        FileError: It is one. Files of the job would be written or removed where it leads.
    """
    if path.is_symlink():
        raise FileError(path, "is a symbolic link", remedy="Replace it by the file or folder it leads to")
    return path


def plain_name(path: Path, name: Any, *, remedy: str = "") -> str:
    """A name read from a file for another file in a folder, after a check that it leads nowhere else.

    Args:
        path: The file that contains the name.
        name: The name.
        remedy: What the user can do.

    Raises:
        FileError: It is no plain file name.
    """
    if not isinstance(name, str) or name in ("", ".", "..") or any(sign in name for sign in "/\\\0"):
        raise FileError(path, f"expected a plain file name, got {name!r}", remedy=remedy)
    return name


def is_file(path: Path) -> bool:
    """True if the file exists; False for a name that no file can have, which a list of names may contain."""
    try:
        return path.is_file()
    except (OSError, ValueError):
        return False
