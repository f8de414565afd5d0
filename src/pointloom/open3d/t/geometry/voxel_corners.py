"""The eight voxels around rendered points of a VoxelBlockGrid, and their trilinear weights."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ....kernels.volumes.tsdf_blocks import BLOCK_SIDE, BLOCK_VOXELS, box_keys
from ....meshing.volume.tsdf import TSDFVolume

CELL_OFFSETS = np.array([[i & 1, i >> 1 & 1, i >> 2] for i in range(8)])  # x fastest


def voxels_around(volume: TSDFVolume, points: NDArray[Any], seen: NDArray[np.bool_]) -> dict[str, NDArray[Any]]:
    """For points (h, w, 3) that are `seen` (h, w, 1), arrays (h, w, 8) in the order of `CELL_OFFSETS`.

    index: Rows of the voxels in attributes, int64. 0 where the mask is false.
    mask: True for voxels that were observed.
    interp_ratio: Trilinear weights. 0 where the mask is false.
    """
    arrays = volume.downloaded()
    keys, weights = arrays["keys"], arrays["weights"]
    place = np.where(seen, points - volume.origin, 0.0) / volume.voxel_size
    first = np.floor(place).astype(np.int64)
    blocks, local = np.divmod(first[..., None, :] + CELL_OFFSETS, BLOCK_SIDE)
    wanted, order = box_keys(*np.moveaxis(blocks, -1, 0)), np.argsort(keys)
    if not len(keys):
        return {"index": np.zeros(wanted.shape, np.int64), "mask": wanted != wanted, "interp_ratio": 0.0 * wanted}
    rows = order[np.minimum(np.searchsorted(keys, wanted, sorter=order), len(keys) - 1)]
    x, y, z = np.moveaxis(local, -1, 0)
    observed = weights[rows * BLOCK_VOXELS + (x * BLOCK_SIDE + y) * BLOCK_SIDE + z] > 0
    mask = seen & (keys[rows] == wanted) & observed
    ratio = np.where(CELL_OFFSETS, (place - first)[..., None, :], (1 - place + first)[..., None, :]).prod(axis=-1)
    index = rows * BLOCK_VOXELS + (z * BLOCK_SIDE + y) * BLOCK_SIDE + x
    return {"index": np.where(mask, index, 0), "mask": mask, "interp_ratio": np.where(mask, ratio, 0.0)}
