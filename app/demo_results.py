"""What the trial runs share: the folder that their results go to, and the table of errors of a surface."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..pcd.errors import FileError
from ..pcd.io.atomic import atomic_write, check_writable
from .console import format_share, to_json

_SHOWN = (("median", "median"), ("root mean square", "rmse"), ("95 % below", "p95"), ("largest", "largest"))


@contextlib.contextmanager
def output_folder(folder: Path, names: Sequence[str], *, overwrite: bool) -> Iterator[None]:
    """A folder for files of these names, made if need be once they can be written; taken away if it stays empty.

    Raises:
        FileError: It is no folder and cannot be made one, or a file exists already.
    """
    if folder.exists() and not folder.is_dir():
        raise FileError(folder, "is not a folder", remedy="Give the name of a folder")
    made = not folder.exists()
    if made:
        try:
            folder.mkdir()
        except OSError as error:
            reason = f"the folder cannot be made: {error.strerror or error}"
            raise FileError(folder, reason, remedy="Choose a place that exists and may be written") from error
    try:
        for name in names:
            check_writable(folder / name, overwrite=overwrite)
        yield
    finally:
        if made:
            with contextlib.suppress(OSError):  # it holds the outputs
                folder.rmdir()


def write_report(path: str, report: dict[str, Any], *, overwrite: bool) -> None:
    """Write a report as JSON."""
    with atomic_write(path, overwrite=overwrite) as file:
        file.write(to_json(report).encode() + b"\n")


def measure_errors(errors: NDArray[np.float64], voxel_size: float) -> dict[str, float] | None:
    """What is told of distances from the true surface: in metres, and in voxels; None where there is no finite one."""
    errors = errors[np.isfinite(errors)]
    if not len(errors):
        return None
    figures = {
        "median": float(np.median(errors)),
        "rmse": float(np.sqrt(np.mean(errors**2))),
        "p95": float(np.quantile(errors, 0.95)),
        "largest": float(errors.max()),
    }
    in_voxels = {f"{name}_voxels": value / voxel_size for name, value in figures.items()}
    return figures | in_voxels | {"within_half_voxel": float(np.mean(errors <= voxel_size / 2))}


def error_table(errors: dict[str, float] | None) -> str:
    """The errors of a surface as a value of several lines for the terminal."""
    if errors is None:
        return "none: the mesh is empty"
    rows = [(name, errors[key], errors[f"{key}_voxels"]) for name, key in _SHOWN]
    lines = [f"{name:<18}{metres * 1000:>8.2f} mm{voxels:>8.3f} voxels" for name, metres, voxels in rows]
    return "\n".join(
        [*lines, f"{'within half a voxel':<18}{format_share(errors['within_half_voxel']):>9} of the vertices"]
    )
