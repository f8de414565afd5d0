"""Control grid files: NPZ with format, sizes (grid size [m]), origin float64 [3], cells and shifts.

Cells are ascending keys, int64 [m]. Shifts are float64 [anchors, 3] [m] in anchor order.
"""

from __future__ import annotations

import os
import zipfile
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.atomic import atomic_write
from ...core.devices import DeviceLike, resolve_device
from ...core.errors import FileError, values_of_file
from ...core.paths import input_path
from ...io.optional_imports import foreign_errors
from ...io.points.npz import read_member
from ...kernels.lang import int64
from ...kernels.memory import download, upload, write
from ...kernels.poses.control_lattice import ControlLattice
from .control_grid import ControlGrid

FORMAT = b"pointloom control grid 1"


def write_control_grid(path: str | os.PathLike[str], grid: ControlGrid, *, overwrite: bool = True) -> None:
    with grid._lock:
        lattice = grid.lattice
        members: dict[str, Any] = {
            "format": np.frombuffer(FORMAT, np.uint8),
            "sizes": np.array([grid.grid_size]),
            "origin": grid.origin,
            "cells": np.asarray(download(lattice.cell_keys), np.int64),
            "shifts": np.asarray(download(lattice.shifts), np.float64).reshape(-1, 3),
        }
    with atomic_write(path, overwrite=overwrite) as file:
        np.savez_compressed(file, **members)


def read_control_grid(path: str | os.PathLike[str], *, device: DeviceLike = None) -> ControlGrid:
    members = _read_members(path)
    if members.get("format", np.empty(0)).tobytes() != FORMAT:
        raise FileError(path, "is not a control grid")
    cells, shifts, sizes, origin = (members[name] for name in ("cells", "shifts", "sizes", "origin"))
    is_valid = cells.ndim == 1 and cells.dtype == np.int64 and (np.diff(cells) > 0).all() and shifts.dtype == np.float64
    numbers = sizes.dtype == origin.dtype == np.float64 and all(np.isfinite(a).all() for a in (sizes, origin, shifts))
    if not is_valid or not numbers or sizes.shape != (1,) or origin.shape != (3,):
        raise FileError(path, "contains arrays that do not belong to a control grid")
    where = resolve_device(device)
    with values_of_file(path):
        grid = ControlGrid(float(sizes[0]), device=where)
        grid._origin = origin
        if len(cells):
            grid.lattice = ControlLattice(grid.grid_size, upload(cells, int64, grid.device))
    if shifts.shape != (len(grid), 3):
        raise FileError(path, f"has shifts of shape {list(shifts.shape)} for {len(grid)} anchors")
    if len(grid):
        write(grid.lattice.shifts, shifts)
    return grid


def _read_members(path: str | os.PathLike[str]) -> dict[str, NDArray[Any]]:
    names = ("format", "sizes", "origin", "cells", "shifts")
    try:
        errors = foreign_errors(path, "cannot be read as a control grid")
        with input_path(path).open("rb") as file, errors, zipfile.ZipFile(file) as archive:
            return {name: read_member(path, archive, archive.getinfo(f"{name}.npy"), name) for name in names}
    except FileNotFoundError as error:
        raise FileError(path, "no such file") from error
    except OSError as error:
        raise FileError(path, f"cannot be read as a control grid: {error.strerror or error}") from error
