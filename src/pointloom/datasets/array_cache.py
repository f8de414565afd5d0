"""Disk cache for generated arrays in the user's cache folder.

File names contain generator, parameters and a source digest. Files are atomic and checksummed. Damaged ones are
regenerated, and the least recently used are removed above 1 GB.
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

MIN_SECONDS = 0.5  # [s] faster results are not cached
SOURCES = ("kernels", "cameras", "pcd", "meshing", "datasets")  # packages whose code affects the data
FORMAT_VERSION = 1  # of the files
MAX_BYTES = 1 << 30  # of all that is kept

Arrays = dict[str, Any]  # NumPy arrays by name


def data_folder() -> Path:
    """The folder of generated and public data: `pointloom/datasets` in the user's cache folder (XDG_CACHE_HOME)."""
    return cache_folder() / "pointloom" / "datasets"


def cached(maker: str, parameters: Mapping[str, Any], make: Callable[[], Mapping[str, Any]]) -> Arrays:
    """Arrays by name from the cache, or from `make`, which must be deterministic in the JSON `parameters`."""
    key = json.dumps([FORMAT_VERSION, maker, dict(parameters), source_digest()], sort_keys=True)
    path = data_folder() / f"{maker}-{hashlib.sha256(key.encode()).hexdigest()[:16]}.npz"
    arrays_read = _read(path, key)
    if arrays_read is not None:
        return arrays_read
    started = time.perf_counter()
    arrays = {name: np.asarray(values) for name, values in make().items()}
    if time.perf_counter() - started > MIN_SECONDS:
        _write(path, key, arrays)
    return arrays


@functools.cache
def source_digest() -> str:
    root, digest = Path(__file__).parents[1], hashlib.sha256(np.__version__.encode())
    for package in SOURCES:
        for path in sorted((root / package).rglob("*.py")):
            digest.update(path.relative_to(root).as_posix().encode() + b"\0" + path.read_bytes())
    return digest.hexdigest()


def _read(path: Path, key: str) -> Arrays | None:
    try:
        with path.open("rb") as stream, np.load(stream, allow_pickle=False) as file:
            if str(file["key"]) != key:
                return None
            arrays = {name: file[name] for name in file.files if name != "key"}
    except (OSError, ValueError, KeyError, EOFError, zipfile.BadZipFile, zlib.error, NotImplementedError):
        return None
    with contextlib.suppress(OSError):
        os.utime(path)  # mark as used
    return arrays


def _write(path: Path, key: str, arrays: Arrays) -> None:
    """Store the arrays, unless the disk is full or read-only."""
    with contextlib.suppress(OSError, PointloomError):
        path.parent.mkdir(parents=True, exist_ok=True)
        with atomic_write(path) as file:
            np.savez_compressed(file, key=np.array(key), **arrays)  # type: ignore[arg-type]
        _make_room(path)


def _make_room(newest: Path) -> None:
    """Remove the least recently used files until the limit is met. The newest stays."""
    files = sorted(((file.stat().st_mtime, file) for file in newest.parent.glob("*.npz")), reverse=True)
    total = 0
    for _, file in files:
        total += file.stat().st_size
        if total > MAX_BYTES and file != newest:
            file.unlink(missing_ok=True)
