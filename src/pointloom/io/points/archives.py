"""Typed NPZ archives, written atomically and validated completely before use."""

from __future__ import annotations

import os
import zipfile
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from ...core.atomic import atomic_write
from ...core.errors import FileError, FilePath
from ...core.escaped_text import escaped
from ...core.paths import input_path
from ..optional_imports import foreign_errors
from .npz import read_arrays, read_member

Arrays = dict[str, NDArray[Any]]
Expected = Mapping[str, tuple[Any, tuple[int, ...]]]  # type and shape of each array


def write_archive(path: FilePath, form: bytes, arrays: Arrays, *, overwrite: bool) -> None:
    members: dict[str, Any] = {"format": np.frombuffer(form, np.uint8)} | arrays
    with atomic_write(path, overwrite=overwrite) as file:
        np.savez_compressed(file, **members)


def read_archive(
    path: FilePath,
    form: bytes,
    what: str,
    writer: str,
    expected_of: Callable[[Arrays], Expected],
    find_fault: Callable[[Arrays], str],
) -> Arrays:
    """The validated arrays of an archive with the member `format` equal to `form`; `what`, `writer` are for messages.
    `expected_of` returns types and shapes of all other arrays, `find_fault` why well-shaped arrays are invalid, or "".
    """
    arrays = _read_members(path, what)
    if arrays.get("format", np.zeros(0)).tobytes() != form:
        raise FileError(path, f"is not a {form.decode()} file", remedy=f"Write one with {writer}")
    if reason := find_wrong_array(arrays, {"format": (np.uint8, (len(form),)), **expected_of(arrays)}):
        raise FileError(path, reason)
    if reason := find_fault(arrays):
        raise FileError(path, reason, remedy="The file was changed after it was saved")
    return arrays


def has_format(path: Path, form: bytes) -> bool:
    """True if a file is an archive with the member `format` equal to `form`."""
    try:
        return read_arrays(path, ("format",)).get("format", np.zeros(0)).tobytes() == form
    except FileError:
        return False


def read_part_of_job(
    path: Path, what: str, expected_of: Callable[[Arrays], Expected], find_fault: Callable[[Arrays], str], remedy: str
) -> Arrays:
    """The validated arrays of an archive without `format`, which a task of a job wrote, as in `read_archive`."""
    try:
        arrays = read_arrays(path)
    except FileError as error:
        reason = f"{what} cannot be read: {error.reason}"
        raise FileError(path, reason, where=error.where, remedy=remedy) from error
    if reason := find_wrong_array(arrays, expected_of(arrays)) or find_fault(arrays):
        raise FileError(path, f"{what} cannot be read: {reason}", remedy=remedy)
    return arrays


def find_wrong_array(arrays: Arrays, expected: Expected) -> str:
    """The first missing, unknown or mistyped array, or ""."""
    if arrays.keys() != expected.keys():
        missing, extra = sorted(expected.keys() - arrays.keys()), sorted(arrays.keys() - expected.keys())
        return f"lacks {', '.join(missing)}" if missing else f"contains unknown arrays {', '.join(extra)}"
    for name, (dtype, shape) in expected.items():
        values = arrays[name]
        if values.dtype != dtype or values.shape != shape:
            got = f"{values.dtype} {list(values.shape)}"
            return f"{name}: expected {np.dtype(dtype)} {list(shape)}, got {got}"
    return ""


def check_arrays(state: Any, expected_of: Callable[[Arrays], Expected], find_fault: Callable[[Arrays], str]) -> Arrays:
    """Validate the arrays of a pickle like those of an archive. Raises `ValueError`."""
    arrays = {name: np.asarray(values) for name, values in dict(state).items()}
    if reason := find_wrong_array(arrays, expected_of(arrays)) or find_fault(arrays):
        raise ValueError(reason)
    return arrays


def rows_of(arrays: Arrays, name: str) -> int:
    return len(arrays[name]) if name in arrays and arrays[name].ndim else 0


def _read_members(path: FilePath, what: str) -> Arrays:
    """The arrays of an NPZ archive, allocated only after their sizes are validated."""
    remedy = "The file may be truncated"
    try:
        arrays = {}
        errors = foreign_errors(path, f"cannot be read as a {what}", remedy=remedy)
        with input_path(path).open("rb") as file, errors, zipfile.ZipFile(file) as archive:
            if min((info.header_offset for info in archive.infolist()), default=0) or not _ends_archive(file):
                raise FileError(path, "there are bytes before or after the archive", remedy="Copy the file again")
            for info in archive.infolist():
                name = info.filename.removesuffix(".npy")
                if name in arrays:
                    raise FileError(path, f"member {name!r} is duplicated")
                arrays[name] = read_member(path, archive, info, name)
        return arrays
    except FileNotFoundError as error:
        raise FileError(path, "no such file") from error
    except OSError as error:
        raise FileError(path, f"cannot be read as a {what}: {error.strerror or error}", remedy=remedy) from error
    except MemoryError as error:
        raise MemoryError(escaped(f"{path}: not enough memory for the {what}")) from error


def _ends_archive(file: IO[bytes]) -> bool:
    """True if the last bytes are a ZIP end record without a comment, as NumPy writes it."""
    file.seek(-22, os.SEEK_END)
    return file.read(4) == b"PK\5\6"
