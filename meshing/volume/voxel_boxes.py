"""Boxes of voxels on blocks, and the places that scans were measured from."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_finite, check_numeric, check_positive, check_shape
from ...kernels.volumes.tsdf_blocks import SIDE, block_box

Corners = tuple[NDArray[np.int64], NDArray[np.int64]]

SMALLEST_VOXEL = 1.0e-9  # [m], and the largest is 1 / this: float32 holds its half and its inverse


def find_fault_of_voxel_size(size: float) -> str:
    """What no edge of a voxel is, or nothing."""
    if SMALLEST_VOXEL <= size <= 1 / SMALLEST_VOXEL:
        return ""
    return f"expected a voxel size of {SMALLEST_VOXEL:g} to {1 / SMALLEST_VOXEL:g} m, got {size:g}"


def check_voxel_size(value: Any) -> float:
    """The edge of a voxel of a volume [m].

    Raises:
        TypeError: No number.
        ValueError: Not above zero, or too small or large for float32.
    """
    size = check_positive("voxel_size", value)
    if fault := find_fault_of_voxel_size(size):
        raise ValueError(f"voxel_size: {fault}")
    return size


def voxels_of_blocks(keys: NDArray[np.int64]) -> Corners:
    """The first voxel of blocks along each axis, and the one behind the last; zeros of none."""
    if not len(keys):
        return np.zeros(3, np.int64), np.zeros(3, np.int64)
    blocks = SIDE * block_box(keys)
    return blocks.min(axis=0), blocks.max(axis=0) + SIDE


def voxels_in_bounds(
    bounds: Any, origin: NDArray[np.float64], voxel_size: float, outermost: float, beyond: str
) -> Corners:
    """The first voxel that reaches into bounds [m] along each axis, and the one behind the last.

    Args:
        bounds: The lowest and the highest corner, shape [2, 3].
        origin: The lowest corner of voxel (0, 0, 0) [m].
        voxel_size: [m].
        outermost: What coordinates of voxels stay below.
        beyond: What is said of those that do not.

    Raises:
        ValueError: Bounds that are none, or too far away.
    """
    ends = check_finite("bounds", check_shape("bounds", bounds, (2, 3)))
    if not (ends[0] < ends[1]).all():
        raise ValueError(f"bounds: expected a low corner below a high one, got {ends.tolist()}")
    places = (ends - origin) / voxel_size
    if not np.abs(places).max() < outermost:
        raise ValueError(f"bounds: {ends.tolist()} {beyond}")
    low = np.floor(places[0] + 1e-9).astype(np.int64)  # a bound that was meant as a voxel's is one
    return low, np.maximum(np.ceil(places[1] - 1e-9).astype(np.int64), low + 1)


def places_of(name: str, places: Any, count: int) -> NDArray[np.float64]:
    """One place of all, float64 [1, 3], or one a point, [count, 3].

    Raises:
        TypeError, ValueError: Neither, or not finite.
    """
    given = check_numeric(name, places).astype(np.float64)
    if given.shape == (3,):
        given = given[None]
    elif given.shape != (count, 3):
        got = list(given.shape)
        raise ValueError(f"{name}: expected shape [3], or [{count}, 3] as there are {count} points, got {got}")
    return check_finite(name, given)
