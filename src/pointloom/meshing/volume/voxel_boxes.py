"""Boxes of voxels on blocks, and sensor positions."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_finite, check_numeric, check_positive, check_shape
from ...kernels.volumes.tsdf_blocks import BLOCK_SIDE, block_box

Corners = tuple[NDArray[np.int64], NDArray[np.int64]]

SMALLEST_VOXEL = 1.0e-9  # [m], the largest is 1 / this: half and inverse fit into float32


def find_fault_of_voxel_size(size: float) -> str:
    if SMALLEST_VOXEL <= size <= 1 / SMALLEST_VOXEL:
        return ""
    return f"expected a voxel size of {SMALLEST_VOXEL:g} to {1 / SMALLEST_VOXEL:g} m, got {size:g}"


def check_voxel_size(value: object) -> float:
    size = check_positive("voxel_size", value)
    if fault := find_fault_of_voxel_size(size):
        raise ValueError(f"voxel_size: {fault}")
    return size


def voxels_of_blocks(keys: NDArray[np.int64]) -> Corners:
    """First voxel of blocks along each axis, and the one after the last, or zeros if none."""
    if not len(keys):
        return np.zeros(3, np.int64), np.zeros(3, np.int64)
    blocks = BLOCK_SIDE * block_box(keys)
    return blocks.min(axis=0), blocks.max(axis=0) + BLOCK_SIDE


def voxels_in_bounds(
    bounds: ArrayLike | None, origin: NDArray[np.float64], voxel_size: float, outermost: float, beyond: str
) -> Corners:
    """First voxel that overlaps bounds [m], and the one after the last. ValueError (`beyond`) from `outermost` on."""
    ends = check_finite("bounds", check_shape("bounds", bounds, (2, 3)))
    if not (ends[0] < ends[1]).all():
        raise ValueError(f"bounds: expected a low corner below a high one, got {ends.tolist()}")
    cells = (ends - origin) / voxel_size
    if not np.abs(cells).max() < outermost:
        raise ValueError(f"bounds: {ends.tolist()} {beyond}")
    low = np.floor(cells[0] + 1e-9).astype(np.int64)  # tolerance for bounds at voxel borders
    return low, np.maximum(np.ceil(cells[1] - 1e-9).astype(np.int64), low + 1)


def check_positions(name: str, positions: object, count: int) -> NDArray[np.float64]:
    """One position, float64 (1, 3), or one per point, (count, 3)."""
    given = check_numeric(name, positions).astype(np.float64)
    if given.shape == (3,):
        given = given[None]
    elif given.shape != (count, 3):
        got = list(given.shape)
        raise ValueError(f"{name}: expected shape [3], or [{count}, 3], one row per point, got {got}")
    return check_finite(name, given)
