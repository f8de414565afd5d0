"""Volumes, distance fields and occupancy as files of OpenVDB."""

from __future__ import annotations

import math
import os

import numpy as np

from ...core.paths import path_of
from ...files.points.vdb import SIDE, VdbGrid, write_vdb_grids
from ...kernels.linear_algebra import elementwise
from ...kernels.memory import download
from ...kernels.volumes.distance_sweeps import FAR
from ...kernels.volumes.occupancy_blocks import UNKNOWN
from ...kernels.volumes.tsdf_blocks import BLOCK_VOXELS, block_box
from .distance_field import DistanceField
from .occupancy import OccupancyGrid
from .tsdf import TSDFVolume

SHADES = 65535.0  # a colour's steps


def write_vdb(
    path: str | os.PathLike[str], volume: TSDFVolume | DistanceField | OccupancyGrid, *, overwrite: bool = True
) -> None:
    """Write a volume to an OpenVDB file (.vdb), for Blender, Houdini and what else reads these.

    Args:
        path: The file.
        volume: A TSDFVolume: grids "distance" [m], a level set whose active voxels are those that were seen, "weight"
            (frames) and, where frames had colour, "color" in 0..1. A DistanceField: "distance" [m], active where it is
            known. An OccupancyGrid: "probability", active where something is known.
        overwrite: Whether a file may be replaced.

    Raises:
        TypeError: None of these.
        FileError: The place cannot be written, or the file exists and may not be replaced.

    Notes:
        All voxels keep their bits, blocks are the file's leaves, and the grid's transform gives metres in the world.
        Inactive voxels are the background: the truncation, `max_distance` (infinite without one), a probability of 0.5.
        Written whole or not at all, without packing; the same bytes from run to run. Nothing but NumPy is needed.

    Example:
        >>> import pointloom as loom
        >>> field = loom.DistanceField.from_voxels([[0, 0, 0]], 0.1, max_distance=0.5)
        >>> loom.write_vdb("field.vdb", field)
    """
    path = path_of(path)
    if isinstance(volume, TSDFVolume):
        grids = _volume_grids(volume)
    elif isinstance(volume, DistanceField):
        grids = [_field_grid(volume)]
    elif isinstance(volume, OccupancyGrid):
        grids = [_occupancy_grid(volume)]
    else:
        kinds = "a TSDFVolume, a DistanceField or an OccupancyGrid"
        raise TypeError(f"volume: expected {kinds}, got {type(volume).__name__}")
    write_vdb_grids(path, grids, overwrite=overwrite)


def _volume_grids(volume: TSDFVolume) -> list[VdbGrid]:
    arrays = volume._downloaded()
    blocks, weights = block_box(arrays["keys"]), arrays["weights"].reshape(-1, BLOCK_VOXELS)
    place, size, seen = volume.origin, volume.voxel_size, weights > 0
    metres = arrays["distances"].reshape(-1, BLOCK_VOXELS) * np.float32(volume.truncation)
    grids = [VdbGrid("distance", blocks, metres, seen, volume.truncation, place, size, "level set")]
    grids.append(VdbGrid("weight", blocks, weights.astype(np.float32), seen, 0.0, place, size))
    if "colors" in arrays:
        colors = (arrays["colors"] / np.float32(SHADES)).reshape(-1, BLOCK_VOXELS, 3)
        grids.append(VdbGrid("color", blocks, colors, seen, 0.0, place, size))
    return grids


def _field_grid(field: DistanceField) -> VdbGrid:
    blocks = block_box(download(field._blocks.keys))
    sqdists = download(field._blocks.sqdists).reshape(-1, BLOCK_VOXELS)
    known = np.abs(sqdists) != FAR
    if field.shape is not None:  # blocks reach beyond a dense box
        voxels = np.stack(np.unravel_index(np.arange(BLOCK_VOXELS), (SIDE,) * 3), axis=1)
        at = blocks[:, None] * SIDE + voxels
        known &= ((at >= 0) & (at < field.shape)).all(axis=2)
    metres = np.sqrt(np.abs(sqdists).astype(np.float64)) * field.voxel_size
    metres = np.where(sqdists < 0, -metres, metres).astype(np.float32)
    beyond = np.inf if field.max_distance is None else field.max_distance
    place = field.origin + 0.5 * field.voxel_size
    return VdbGrid("distance", blocks, metres, known, beyond, place, field.voxel_size)


def _occupancy_grid(grid: OccupancyGrid) -> VdbGrid:
    arrays = grid._downloaded()
    odds = arrays["odds"].reshape(-1, BLOCK_VOXELS)
    known = odds != UNKNOWN
    chances = 1.0 / (1.0 + elementwise(math.exp, -np.where(known, odds, 0.0).astype(np.float64)))
    place = grid.origin + 0.5 * grid.voxel_size
    blocks = block_box(arrays["keys"])
    return VdbGrid("probability", blocks, chances.astype(np.float32), known, 0.5, place, grid.voxel_size)
