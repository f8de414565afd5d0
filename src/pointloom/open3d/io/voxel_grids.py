"""Files of voxel grids (PLY) and octrees (JSON), as Open3D writes them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_positive, check_rigid
from ...core.errors import FileError, values_of_file
from ..geometry.voxel_grid import VoxelGrid
from .ply_elements import (
    FilePath,
    check_ply,
    color_columns,
    colors_of,
    integers_of,
    numbers_of,
    read_elements,
    write_elements,
)

LIMITS = np.iinfo(np.int32)  # of voxel indices
ROTATION_COLUMNS = [f"r{row}{column}" for row in range(3) for column in range(3)]


def read_voxel_grid(filename: FilePath, format: str = "auto", print_progress: bool = False) -> VoxelGrid:
    """Read a .ply with an origin, a voxel size and voxel indices. Raises FileError."""
    path = check_ply(filename, format)
    elements = read_elements(path, "origin", "voxel_size", "vertex")
    cells = integers_of(path, elements, "vertex", "x", "y", "z", low=LIMITS.min, high=LIMITS.max)
    origin, size = numbers_of(path, elements, "origin", "x", "y", "z"), numbers_of(path, elements, "voxel_size", "val")
    if len(origin) != 1 or len(size) != 1:
        raise FileError(path, f"expected one origin and one voxel size, got {len(origin)} and {len(size)}")
    with values_of_file(path):
        edge = check_positive("voxel_size", float(size[0, 0]), allow_zero=not len(cells))
    _, counts = np.unique(cells, axis=0, return_counts=True)
    if (counts > 1).any():
        raise FileError(path, f"expected each voxel once, got {int((counts > 1).sum())} of them more than once")
    made = VoxelGrid.from_cells(origin[0], edge, cells, colors_of(path, elements, "vertex"))
    if "rotation" in elements:
        made.rotation = _rotation(path, numbers_of(path, elements, "rotation", *ROTATION_COLUMNS))
    return made


def _rotation(path: Path, rows: NDArray[np.float64]) -> Any:
    if len(rows) != 1:
        raise FileError(path, f"expected one rotation, got {len(rows)}")
    matrix = np.eye(4)
    matrix[:3, :3] = rows.reshape(3, 3)
    with values_of_file(path):
        return check_rigid("rotation", matrix)[:3, :3]


def write_voxel_grid(
    filename: FilePath,
    voxel_grid: object,
    write_ascii: bool = False,
    compressed: bool = False,
    print_progress: bool = False,
) -> bool:
    """Write a .ply with 8-bit colors."""
    if not isinstance(voxel_grid, VoxelGrid):
        raise TypeError(f"voxel_grid: expected a VoxelGrid, got {type(voxel_grid).__name__}")
    cells, colors = voxel_grid.cells_and_colors()
    elements = {
        "origin": dict(zip("xyz", voxel_grid.origin.reshape(3, 1), strict=True)),
        "rotation": dict(zip(ROTATION_COLUMNS, voxel_grid.rotation.reshape(9, 1), strict=True)),
        "voxel_size": {"val": np.array([voxel_grid.voxel_size])},
        "vertex": dict(zip("xyz", cells.astype(np.float64).T, strict=True)) | color_columns(colors),
    }
    write_elements(check_ply(filename), elements, ascii=write_ascii)
    return True
