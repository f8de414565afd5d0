"""Results of the steps of a long computation, kept in a folder: `KeptArrays`."""

from __future__ import annotations

import contextlib
import os
import shutil
import zipfile
from collections.abc import Callable, Iterable, Iterator, Mapping
from importlib import metadata
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .atomic import atomic_write
from .devices import DeviceLike
from .errors import FileError, FilePath
from .json_files import read_json_object
from .paths import os_errors, path_of
from .progress import ReportProgress, ignore_progress
from .records import digest_of, digest_of_bytes
from .wording import json_text
from .work_folder import check_work_folder, locked

Arrays = Mapping[str, NDArray[Any]]

INPUTS = "inputs.json"
_DAMAGED = (OSError, EOFError, ValueError, KeyError, zipfile.BadZipFile)


class KeptArrays:
    """Arrays of finished steps by name, and the progress of those that run. Without a folder every step is computed."""

    def __init__(self, folder: Path | None = None, report: ReportProgress = ignore_progress):
        self._folder, self.report = folder, report

    def get(self, name: str, make: Callable[[], Arrays]) -> Arrays:
        """The arrays of a step, read from the folder or computed and written atomically."""
        if self._folder is None:
            return make()
        path = self._folder / f"{name}.npz"
        with contextlib.suppress(*_DAMAGED), path.open("rb") as file, np.load(file) as stored:
            return {key: stored[key] for key in stored.files}
        arrays: Mapping[str, Any] = make()
        with atomic_write(path) as file:
            np.savez(file, **arrays)
        return arrays


def digest_of_inputs(settings: object, arrays: Iterable[NDArray[Any]], device: DeviceLike) -> str:
    """Digest of settings (numbers, strings and lists), arrays, the device and the version of pointloom."""
    listed = [np.ascontiguousarray(array) for array in arrays]
    forms = [[list(array.shape), array.dtype.str] for array in listed]
    content = digest_of_bytes(array.view(np.uint8).reshape(-1) for array in listed)
    return digest_of([repr(settings), forms, content, str(device), metadata.version("pointloom")])


@contextlib.contextmanager
def kept_arrays(
    folder: FilePath | None, inputs: Callable[[], str], report: ReportProgress = ignore_progress
) -> Iterator[KeptArrays]:
    """Keep the steps of the block in a folder, if any. `inputs` returns a digest of all inputs: steps of others are
    removed first. Raises FileError if the folder contains other files or is in use.
    """
    if folder is None:
        yield KeptArrays(None, report)
        return
    root = check_work_folder(path_of(folder, "work"), marker=INPUTS, resume=True, overwrite=False)
    with os_errors(root, "written"):
        root.mkdir(exist_ok=True)
    with locked(root):
        expected = {"inputs": inputs()}
        with os_errors(root, "written"):
            if _content_of(root / INPUTS) != expected:
                for path in root.glob("*.npz"):
                    path.unlink()
                with atomic_write(root / INPUTS) as file:
                    file.write(json_text(expected).encode() + b"\n")
        try:
            yield KeptArrays(root, report)
        finally:
            if not any(root.glob("*.npz")):
                remove_kept_arrays(root)


def remove_kept_arrays(folder: FilePath) -> None:
    """Remove a folder of `kept_arrays`. Other folders are left."""
    if (Path(folder) / INPUTS).is_file():
        shutil.rmtree(folder, ignore_errors=True)


def _content_of(path: Path) -> dict[str, Any] | None:
    if not os.path.lexists(path):
        return None
    try:
        return read_json_object(path)
    except FileError:
        return None
