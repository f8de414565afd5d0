"""Arrays that took long to make, kept in the user's cache folder for the next process.

A file is named by its maker, the parameters and the sources that it was made by, and holds all three; another version
makes its own. It is written whole or not at all, and one that is damaged is made anew: the archive has a checksum of
each array. Where the folder cannot be written to, nothing is kept. What was not used for longest goes when all of it
passes a gigabyte.
"""

from __future__ import annotations

import contextlib
import functools
import hashlib
import json
import os
import time
import zipfile
import zlib
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from ..core.atomic import atomic_write
from ..core.errors import PointloomError
from ..kernels.language.cache_folders import cache_folder

LEAST_SECONDS = 0.5  # what is made faster is made again
SOURCES = ("kernels", "cameras", "pcd", "meshing", "data")  # houses whose code makes the data
FORM = 1  # of the files
MOST_BYTES = 1 << 30  # of all that is kept

Arrays = dict[str, Any]  # NumPy arrays by name


def data_folder() -> Path:
    """Where made data and public sets are kept: `pointloom/data` in the user's cache folder (XDG_CACHE_HOME)."""
    return cache_folder() / "pointloom" / "data"


def kept(maker: str, parameters: Mapping[str, Any], make: Callable[[], Mapping[str, Any]]) -> Arrays:
    """What `make` gives: arrays by name, from the disk where an earlier call with these parameters left them there.

    Args:
        maker: Name of the function.
        parameters: All that the arrays depend on, as JSON has it.
        make: Makes them; the same bits each time.
    """
    key = json.dumps([FORM, maker, dict(parameters), source_digest()], sort_keys=True)
    path = data_folder() / f"{maker}-{hashlib.sha256(key.encode()).hexdigest()[:16]}.npz"
    found = _read(path, key)
    if found is not None:
        return found
    started = time.perf_counter()
    arrays = {name: np.asarray(values) for name, values in make().items()}
    if time.perf_counter() - started > LEAST_SECONDS:
        _write(path, key, arrays)
    return arrays


@functools.cache
def source_digest() -> str:
    """A digest of all code that made data depend on."""
    root, digest = Path(__file__).parents[1], hashlib.sha256(np.__version__.encode())
    for house in SOURCES:
        for path in sorted((root / house).rglob("*.py")):
            digest.update(path.relative_to(root).as_posix().encode() + b"\0" + path.read_bytes())
    return digest.hexdigest()


def _read(path: Path, key: str) -> Arrays | None:
    """The arrays of a file; None where there is none, or none that is whole and of this key."""
    try:
        with path.open("rb") as held, np.load(held, allow_pickle=False) as file:
            if str(file["key"]) != key:
                return None
            found = {name: file[name] for name in file.files if name != "key"}
    except (OSError, ValueError, KeyError, EOFError, zipfile.BadZipFile, zlib.error, NotImplementedError):
        return None
    with contextlib.suppress(OSError):
        os.utime(path)  # used now
    return found


def _write(path: Path, key: str, arrays: Arrays) -> None:
    """Keep the arrays; a disk that is full or read-only keeps nothing."""
    with contextlib.suppress(OSError, PointloomError):
        path.parent.mkdir(parents=True, exist_ok=True)
        with atomic_write(path) as file:
            np.savez_compressed(file, key=np.array(key), **arrays)  # type: ignore[arg-type]
        _make_room(path)


def _make_room(newest: Path) -> None:
    """Remove what was not used for longest, until the rest is within bounds; the newest stays."""
    found = sorted(((file.stat().st_mtime, file) for file in newest.parent.glob("*.npz")), reverse=True)
    total = 0
    for _, file in found:
        total += file.stat().st_size
        if total > MOST_BYTES and file != newest:
            file.unlink(missing_ok=True)
