"""Results of the steps of a long computation, kept in a folder: `KeptArrays`."""

from __future__ import annotations

import contextlib
import io
import os
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
from .paths import os_errors
from .progress import ReportProgress, ignore_progress
from .records import digest_of, digest_of_bytes, digest_of_file
from .wording import json_text
from .work_folder import RunFolder

Arrays = Mapping[str, NDArray[Any]]

INPUTS = "inputs.json"
_KIND = "kept steps"  # distinguishes the marker from other files named inputs.json


class KeptArrays:
    """Arrays of finished steps by name, and the progress of those that run. Without a folder every step is computed.

    The manifest lists the files with their digests. A file is listed before it is written, so that all own files are
    listed.
    """

    def __init__(self, run: RunFolder | None = None, inputs: str = "", report: ReportProgress = ignore_progress):
        self._run, self._inputs, self.report = run, inputs, report
        self._digests: dict[str, str] = {}
        if run is not None:
            self._start(run)

    def _start(self, run: RunFolder) -> None:
        manifest = read_json_object(run.file(INPUTS)) if run.is_run else {}
        if manifest.get("inputs") == self._inputs:
            self._digests = manifest["files"]
        else:
            _remove(run, manifest.get("files", ()))
            self._write_manifest(run)

    def _write_manifest(self, run: RunFolder) -> None:
        content = {"kind": _KIND, "inputs": self._inputs, "files": self._digests}
        with atomic_write(run.file(INPUTS)) as file:
            file.write(json_text(content).encode() + b"\n")

    def get(self, name: str, make: Callable[[], Arrays], read: Callable[[Path], Arrays]) -> Arrays:
        """The arrays of a step: those that `read` validates, else computed and written atomically. `read` raises
        FileError for arrays that the step cannot use."""
        if self._run is None:
            return make()
        path = self._run.file(f"{name}.npz")
        known = self._digests.get(path.name)
        with contextlib.suppress(OSError, FileError):
            if known is not None and digest_of_file(path) == known:
                return read(path)
        if known is None and os.path.lexists(path):
            raise FileError(path, "was written by another program", remedy="Move it away, or give another folder")
        arrays, content = make(), io.BytesIO()
        np.savez(content, **arrays)  # type: ignore[arg-type]
        self._digests[path.name] = digest_of_bytes([content.getbuffer()])
        self._write_manifest(self._run)
        with atomic_write(self._run.file(path.name)) as file:
            file.write(content.getbuffer())
        return arrays

    def end(self) -> None:
        """Remove the folder if no step is finished."""
        if self._run is not None and not any((self._run.path / name).exists() for name in self._digests):
            _remove(self._run, (INPUTS,))
            _remove_empty(self._run)


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
    removed first. Raises FileError if the folder is of another program, contains links or is in use.
    """
    if folder is None:
        yield KeptArrays(report=report)
        return
    run = check_kept_arrays(folder)
    with run.opened():
        kept = KeptArrays(run, inputs(), report)
        try:
            yield kept
        finally:
            kept.end()


def check_kept_arrays(folder: FilePath) -> RunFolder:
    """The folder of `kept_arrays`. Raises FileError if it is of another program."""
    run = RunFolder(folder, INPUTS, _is_manifest, name="work")
    run.check(resume=True, overwrite=False)
    return run


def remove_kept_arrays(folder: FilePath) -> None:
    """Remove the files of `kept_arrays`, and the folder if it is empty then. Other folders are left."""
    with contextlib.suppress(FileError):
        run = check_kept_arrays(folder)
        if run.is_run:
            with run.opened():
                _remove(run, (*read_json_object(run.file(INPUTS))["files"], INPUTS))
                _remove_empty(run)


def _remove(run: RunFolder, names: Iterable[str]) -> None:
    """Remove own files, also those that a killed process did not complete."""
    with os_errors(run.path, "written"):
        for name in names:
            run.file(name).unlink(missing_ok=True)
            for part in run.path.glob(f".{name}.*.part"):
                part.unlink(missing_ok=True)


def _remove_empty(run: RunFolder) -> None:
    with contextlib.suppress(OSError):  # it contains other files
        run.path.rmdir()


def _is_manifest(path: Path) -> bool:
    content = read_json_object(path)
    files = content.get("files")
    if content.keys() != {"kind", "inputs", "files"} or content["kind"] != _KIND or not isinstance(files, dict):
        return False
    texts = [content["inputs"], *files.values()]
    is_plain = all(name.endswith(".npz") and not set(name) & set("/\\\0*?[") for name in files)
    return is_plain and all(isinstance(text, str) for text in texts)
