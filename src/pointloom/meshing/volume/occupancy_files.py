"""Files of occupancy grids: NPZ archives, validated before use.

Members: format, voxel_size, probabilities float64 [4] (hit, miss, min, max), origin, scan_count, keys int64 [m], odds
float32 [512 m], log odds, 1e9 where unknown.
"""

from __future__ import annotations

import math
import os

import numpy as np

from ...io.points.archives import Arrays, Expected, check_arrays, read_archive, rows_of, write_archive
from ...kernels.arrays.block_keys import CELL_BIAS
from ...kernels.volumes.occupancy_blocks import UNKNOWN_LOG_ODDS
from ...kernels.volumes.tsdf_blocks import BLOCK_VOXELS, MAX_BLOCKS, block_box
from .voxel_boxes import find_fault_of_voxel_size

FORMAT = b"pointloom occupancy grid 1"


def log_odds_of(probability: float) -> float:
    return float(np.float32(math.log(probability / (1.0 - probability))))


def find_fault_of_model(hit: float, miss: float, low: float, high: float) -> str:
    if not 0.5 < hit < 1:
        return f"hit: expected a probability above 0.5 and below 1, got {hit:g}"
    if not 0 < miss < 0.5:
        return f"miss: expected a probability above 0 and below 0.5, got {miss:g}"
    if not 0 < low < 0.5 < high < 1:
        return f"min, max: expected 0 < min < 0.5 < max < 1, got {low:g} and {high:g}"
    return ""


def write_grid(path: str | os.PathLike[str], arrays: Arrays, *, overwrite: bool) -> None:
    write_archive(path, FORMAT, arrays, overwrite=overwrite)


def read_grid(path: str | os.PathLike[str]) -> Arrays:
    return read_archive(path, FORMAT, "occupancy grid", "OccupancyGrid.save", _expected, _find_fault)


def check_grid_arrays(arrays: object) -> Arrays:
    return check_arrays(arrays, _expected, _find_fault)


def _expected(arrays: Arrays) -> Expected:
    blocks = rows_of(arrays, "keys")
    return {
        "voxel_size": (np.float64, ()),
        "probabilities": (np.float64, (4,)),
        "origin": (np.float64, (3,)),
        "scan_count": (np.int64, ()),
        "keys": (np.int64, (blocks,)),
        "odds": (np.float32, (blocks * BLOCK_VOXELS,)),
    }


def _find_fault(arrays: Arrays) -> str:
    hit, miss, low, high = arrays["probabilities"].tolist()
    scans, keys, odds = int(arrays["scan_count"]), arrays["keys"], arrays["odds"]
    blocks = len(keys)
    fault = find_fault_of_voxel_size(float(arrays["voxel_size"]))
    fault = f"voxel_size: {fault}" if fault else find_fault_of_model(hit, miss, low, high)
    if fault:
        return fault
    if not np.isfinite(arrays["origin"]).all():
        return "origin: not finite"
    if scans < 0 or (scans == 0 and (blocks or arrays["origin"].any())):
        return f"scan_count: {scans}"
    if blocks > MAX_BLOCKS:
        return f"keys: {blocks:,} blocks, more than {MAX_BLOCKS:,}"
    if blocks and (keys.min() < 0 or np.abs(block_box(keys)).max() > CELL_BIAS - 2 or len(np.unique(keys)) != blocks):
        return "keys: blocks out of range or repeated"
    if not ((odds == UNKNOWN_LOG_ODDS) | ((odds >= log_odds_of(low)) & (odds <= log_odds_of(high)))).all():
        return "odds: outside the clamping range"
    return ""
