"""Pictures that lie beside a mesh file and are named in it: found, read, and written together with it."""

from __future__ import annotations

import contextlib
import os
import re
import warnings
from collections.abc import Iterator
from pathlib import Path, PurePosixPath, PureWindowsPath
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from ...core.atomic import atomic_write
from ...core.paths import path_of
from .image_files import encode_png, read_texture


def find_beside(path: str | os.PathLike[str], name: str) -> Path | None:
    """The file that a mesh file names relative to its own folder; None where there is none, or the name is absolute."""
    if not name or PurePosixPath(name).is_absolute() or PureWindowsPath(name).anchor:
        return None
    try:
        found = path_of(path).parent / name.replace("\\", "/")
        return found if found.is_file() else None
    except (OSError, ValueError):  # too long, or with a zero byte
        return None


def read_textures(path: str | os.PathLike[str], names: list[str]) -> tuple[NDArray[np.uint8], ...]:
    """The pictures of these names beside a mesh file; none at all, with a warning, where one is missing.

    Raises:
        FileError: A picture is damaged, or no PNG or JPEG.
    """
    places = [find_beside(path, name) for name in names]
    missing = [name for name, place in zip(names, places, strict=True) if place is None]
    if missing:
        warn_left_behind(path, f"its picture {missing[0]!r} does not lie beside it")
        return ()
    return tuple(read_texture(place) for place in places if place is not None)


def warn_left_behind(path: Any, reason: str) -> None:
    """Warn that textures are left behind, for a reason."""
    warnings.warn(f"{path}: the textures are left behind, since {reason}", UserWarning, stacklevel=5)


def derived_name(path: str | os.PathLike[str], ending: str) -> str:
    """A file name from that of a mesh file, without characters that a list of names could be parted at."""
    return re.sub(r"[^A-Za-z0-9._-]", "_", Path(path).stem) + ending


def picture_names(path: str | os.PathLike[str], count: int) -> list[str]:
    """The names under which the pictures of a mesh file are written."""
    return [derived_name(path, f"_{k}.png") for k in range(count)]


@contextlib.contextmanager
def write_with(
    path: str | os.PathLike[str], beside: dict[str, bytes | NDArray[np.uint8]], *, overwrite: bool
) -> Iterator[IO[bytes]]:
    """A binary file, with others beside it that appear before it does, each whole or not at all.

    Args:
        path: The file.
        beside: What else is written, by name: bytes, or pictures as PNG.
        overwrite: Whether existing files may be replaced.
    """
    with contextlib.ExitStack() as files:
        main = files.enter_context(atomic_write(path, overwrite=overwrite))
        for name, content in beside.items():
            other = files.enter_context(atomic_write(Path(path).parent / name, overwrite=overwrite))
            other.write(content if isinstance(content, bytes) else encode_png(content))
        yield main
