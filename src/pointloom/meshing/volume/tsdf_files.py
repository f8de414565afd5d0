"""Files of TSDF volumes: NPZ archives, validated before use.

Members: format, sizes (voxel size, truncation), origin, frame_count, has_color (room for color, colors given), keys
int64 [m], distances float32 [512 m], weights uint16 [512 m], and colors uint16 [512 m, 3] if frames had color.
"""

from __future__ import annotations

import os
from typing import Any

import numpy as np

from ...io.points.archives import Arrays, Expected, check_arrays, read_archive, rows_of, write_archive
from ...kernels.arrays.block_keys import CELL_BIAS
from ...kernels.volumes.tsdf_blocks import BLOCK_VOXELS, MAX_BLOCKS, block_box
from .voxel_boxes import find_fault_of_voxel_size

FORMAT = b"pointloom TSDF volume 1"
LARGEST_TRUNCATION = 1e9  # [m]
VOXEL_ARRAYS = ("keys", "distances", "weights", "colors")


def find_fault_of_sizes(voxel_size: float, truncation: float) -> str:
    if fault := find_fault_of_voxel_size(voxel_size):
        return f"sizes: {fault}"
    if not voxel_size <= truncation <= LARGEST_TRUNCATION:
        return (
            f"sizes: expected a truncation of {voxel_size:g} (a voxel) to {LARGEST_TRUNCATION:g} m, got {truncation:g}"
        )
    return ""


def write_volume_arrays(path: str | os.PathLike[str], arrays: Arrays, *, overwrite: bool) -> None:
    write_archive(path, FORMAT, arrays, overwrite=overwrite)


def read_volume_arrays(path: str | os.PathLike[str]) -> Arrays:
    return read_archive(path, FORMAT, "volume", "TSDFVolume.save", _expected, _find_fault)


def check_volume_arrays(arrays: object) -> Arrays:
    return check_arrays(arrays, _expected, _find_fault)


def _expected(arrays: Arrays) -> Expected:
    blocks = rows_of(arrays, "keys")
    voxels = blocks * BLOCK_VOXELS
    expected: dict[str, tuple[Any, tuple[int, ...]]] = {
        "sizes": (np.float64, (2,)),
        "origin": (np.float64, (3,)),
        "frame_count": (np.int64, ()),
        "has_color": (np.bool_, (2,)),
        "keys": (np.int64, (blocks,)),
        "distances": (np.float32, (voxels,)),
        "weights": (np.uint16, (voxels,)),
    }
    if "has_color" in arrays and arrays["has_color"].all():
        expected["colors"] = (np.uint16, (voxels, 3))
    return expected


def _find_fault(arrays: Arrays) -> str:
    voxel_size, truncation = arrays["sizes"].tolist()
    has_color, colored = arrays["has_color"].tolist()
    frames, keys = int(arrays["frame_count"]), arrays["keys"]
    blocks = len(keys)
    if fault := find_fault_of_sizes(voxel_size, truncation):
        return fault
    if not np.isfinite(arrays["origin"]).all():
        return "origin: not finite"
    if frames < 0 or (frames == 0 and (blocks or colored or arrays["origin"].any())):
        return f"frame_count: {frames}"
    if colored and not has_color:
        return "has_color: colors in a volume without color"
    if blocks > MAX_BLOCKS:
        return f"keys: {blocks:,} blocks, more than {MAX_BLOCKS:,}"
    if blocks and (keys.min() < 0 or np.abs(block_box(keys)).max() > CELL_BIAS - 2 or len(np.unique(keys)) != blocks):
        return "keys: blocks out of range or repeated"
    if not (np.abs(arrays["distances"]) <= 1).all():
        return "distances: not all in -1..1"
    if arrays["weights"].max(initial=0) > frames:
        return f"weights: more than {frames} frames"
    return ""
