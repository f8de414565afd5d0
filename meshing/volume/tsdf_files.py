"""Files of TSDF volumes: NPZ archives whose arrays are checked against each other before one is used.

Members: format, sizes (voxel size, truncation), origin, frame_count, has_color (room for colour, colours given), keys
int64 [m], distances float32 [512 m], weights uint16 [512 m], and colors uint16 [512 m, 3] where frames had colour.
"""

from __future__ import annotations

import os
from typing import Any

import numpy as np

from ...files.points.archives import Arrays, Expected, read_archive, rows_of, write_archive
from ...kernels.arrays.block_keys import BIAS
from ...kernels.volumes.tsdf_blocks import BLOCK_VOXELS, MAX_BLOCKS, block_box

FORMAT = b"pointloom TSDF volume 1"
VOXEL_ARRAYS = ("keys", "distances", "weights", "colors")


def write_volume_arrays(path: str | os.PathLike[str], arrays: Arrays, *, overwrite: bool) -> None:
    """Write the arrays of a volume, whole or not at all."""
    write_archive(path, FORMAT, arrays, overwrite=overwrite)


def read_volume_arrays(path: str | os.PathLike[str]) -> Arrays:
    """The arrays of a saved volume, checked against each other."""
    return read_archive(path, FORMAT, "volume", "TSDFVolume.save", _expected, _find_fault)


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
    """What no saved volume holds, or nothing."""
    voxel_size, truncation = arrays["sizes"].tolist()
    has_color, colored = arrays["has_color"].tolist()
    frames, keys = int(arrays["frame_count"]), arrays["keys"]
    blocks = len(keys)
    if not (0 < voxel_size <= truncation < np.inf):
        return f"sizes: expected 0 < voxel size <= truncation, got {voxel_size} and {truncation}"
    if not np.isfinite(arrays["origin"]).all():
        return "origin: not finite"
    if frames < 0 or (frames == 0 and (blocks or colored or arrays["origin"].any())):
        return f"frame_count: {frames}"
    if colored and not has_color:
        return "has_color: colours without room for them"
    if blocks > MAX_BLOCKS:
        return f"keys: {blocks:,} blocks, more than {MAX_BLOCKS:,}"
    if blocks and (keys.min() < 0 or np.abs(block_box(keys)).max() > BIAS - 2 or len(np.unique(keys)) != blocks):
        return "keys: blocks out of range or repeated"
    if not (np.abs(arrays["distances"]) <= 1).all():
        return "distances: not all in -1..1"
    if arrays["weights"].max(initial=0) > frames:
        return f"weights: more than {frames} frames"
    return ""
