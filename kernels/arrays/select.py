"""Compaction and gathering: rows of arrays by mask or by index."""

from typing import Any

import numpy as np

from ..array_types import Array, Indices, Mask
from ..lang import array, int32, kernel, launch, tid, uint8, vec3
from ..memory import contiguous, download, empty, upload
from .prefix_sum import inclusive_scan


@kernel
def count_mask_kernel(mask: array(dtype=uint8), counts: array(dtype=int32)):
    """1 where the mask is set."""
    i = tid()
    kept = 0
    if mask[i] != 0:
        kept = 1
    counts[i] = kept


@kernel
def scatter_positions_kernel(mask: array(dtype=uint8), ranks: array(dtype=int32), positions: array(dtype=int32)):
    """The positions of the set elements, in order; their ranks count from one."""
    i = tid()
    if mask[i] != 0:
        positions[ranks[i] - 1] = i


@kernel
def gather_vec3_kernel(values: array(dtype=vec3), rows: array(dtype=int32), out: array(dtype=vec3)):
    """out[i] = values[rows[i]]."""
    i = tid()
    out[i] = values[rows[i]]


@kernel
def invert_mask_kernel(mask: array(dtype=uint8), inverted: array(dtype=uint8)):
    """1 where the mask is 0."""
    i = tid()
    value = 0
    if mask[i] == 0:
        value = 1
    inverted[i] = uint8(value)


def invert_mask(mask: Mask) -> Mask:
    """The mask of the other elements."""
    inverted = empty(mask.size, uint8, mask.device)
    launch(invert_mask_kernel, mask.size, [mask, inverted])
    return inverted


def positions_of(mask: Mask, count: int | None = None) -> Indices:
    """The positions where a uint8 device mask of shape [n] is not zero, as int32, ascending.

    One sync; none where it is known that there are `count`.
    """
    device = mask.device
    if not device.is_cuda or not mask.size:
        return upload(np.flatnonzero(download(mask).view(np.bool_)).astype(np.int32), int32, device)
    ranks = empty(mask.size, int32, device)
    launch(count_mask_kernel, mask.size, [mask, ranks])
    inclusive_scan(ranks, ranks)
    known = int(download(ranks[-1:])[0]) if count is None else count  # sync
    positions = empty(known, int32, device)
    launch(scatter_positions_kernel, mask.size, [mask, ranks, positions])
    return positions


def gather_rows(values: Array, rows: Indices) -> Array:
    """values[rows] on the device, for vec3 arrays and for arrays of scalars with one or two axes.

    Args:
        values: Device array of shape [n] or [n, c].
        rows: int32 device array of shape [m], every entry in 0..n-1.
    """
    device = values.device
    if values.dtype == vec3:
        out: Any = empty(rows.size, vec3, device)
        launch(gather_vec3_kernel, rows.size, [values, rows, out])
        return out
    if not device.is_cuda:
        chosen: Any = upload(download(values)[download(rows)], values.dtype, device)
        return chosen
    return contiguous(values[rows])
