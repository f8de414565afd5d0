"""Arrays that took long to make, kept in the user's cache folder for the next process.

A file is named by its maker, the parameters and the sources that it was made by, and holds all three; another version
makes its own. It is written whole or not at all, and one that is damaged is made anew: the archive has a checksum of
each array. Where the folder cannot be written to, nothing is kept.
"""

from __future__ import annotations

import contextlib
import functools
import hashlib
import json
import time
import zipfile
import zlib
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..core.atomic import atomic_write
from ..core.errors import PointloomError
from ..kernels.language.cache_folders import cache_folder

LEAST_SECONDS = 0.5  # what is made faster is made again
SOURCES = ("kernels", "cameras", "pcd", "meshing", "data")  # houses whose code makes the data
FORM = 1  # of the files

Arrays = dict[str, NDArray[Any]]


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
        with np.load(path, allow_pickle=False) as file:
            if str(file["key"]) != key:
                return None
            return {name: file[name] for name in file.files if name != "key"}
    except (OSError, ValueError, KeyError, EOFError, zipfile.BadZipFile, zlib.error, NotImplementedError):
        return None


def _write(path: Path, key: str, arrays: Arrays) -> None:
    """Keep the arrays; a disk that is full or read-only keeps nothing."""
    with contextlib.suppress(OSError, PointloomError):
        path.parent.mkdir(parents=True, exist_ok=True)
        with atomic_write(path) as file:
            np.savez_compressed(file, key=np.array(key), **arrays)  # type: ignore[arg-type]
