"""Compaction and gathering: rows of arrays by mask or by index."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from ..array_types import AnyArray, Array, Indices, Integers, LongIntegers, Mask
from ..lang import array, compute, int32, int64, kernel, launch, tid, uint8, vec3, vec3d, vec3i
from ..memory import contiguous, copy, download, empty, rows_of, upload, zeros
from .prefix_sum import inclusive_scan
from .side_by_side import read_together


@kernel
def count_mask_kernel(mask: array(dtype=uint8), counts: array(dtype=int32)):
    i = tid()
    selected = 0
    if mask[i] != 0:
        selected = 1
    counts[i] = selected


@kernel
def scatter_positions_kernel(mask: array(dtype=uint8), ranks: array(dtype=int32), positions: array(dtype=int32)):
    """Positions of the set elements in order. Ranks count from one."""
    i = tid()
    if mask[i] != 0:
        positions[ranks[i] - 1] = i


@kernel
def number_rows_kernel(rows: array(dtype=int32), numbers: array(dtype=int32)):
    """numbers[rows[i]] = i for distinct rows. Other numbers are undefined."""
    i = tid()
    numbers[rows[i]] = i


@kernel
def gather_vec3_kernel(values: array(dtype=vec3), rows: array(dtype=int32), out: array(dtype=vec3)):
    i = tid()
    out[i] = values[rows[i]]


@kernel
def gather_vec3d_kernel(values: array(dtype=vec3d), rows: array(dtype=int32), out: array(dtype=vec3d)):
    i = tid()
    out[i] = values[rows[i]]


@kernel
def gather_vec3i_kernel(values: array(dtype=vec3i), rows: array(dtype=int32), out: array(dtype=vec3i)):
    i = tid()
    out[i] = values[rows[i]]


@kernel
def gather_keys_kernel(values: array(dtype=int32), rows: array(dtype=int32), keys: array(dtype=int64)):
    i = tid()
    keys[i] = int64(values[rows[i]])


def gather_keys(values: Integers, rows: Indices) -> LongIntegers:
    """values[rows] of int32 as int64 keys to sort."""
    return compute(gather_keys_kernel, rows.size, [values, rows], int64, values.device)


GATHERING = {vec3: gather_vec3_kernel, vec3d: gather_vec3d_kernel, vec3i: gather_vec3i_kernel}


@kernel
def invert_mask_kernel(mask: array(dtype=uint8), inverted: array(dtype=uint8)):
    i = tid()
    value = 0
    if mask[i] == 0:
        value = 1
    inverted[i] = uint8(value)


def invert_mask(mask: Mask) -> Mask:
    return compute(invert_mask_kernel, mask.size, [mask], uint8, mask.device)


@kernel
def mark_negative_kernel(values: array(dtype=int32), marks: array(dtype=int32)):
    i = tid()
    marks[i] = 1 if values[i] < 0 else 0


def mark_negative(values: Integers) -> Integers:
    """int32: 1 where a value is negative, else 0."""
    return compute(mark_negative_kernel, values.size, [values], int32, values.device)


def _ranks_of(mask: Mask) -> Integers:
    """Inclusive counts of set elements, for a nonempty GPU mask."""
    ranks = compute(count_mask_kernel, mask.size, [mask], int32, mask.device)
    inclusive_scan(ranks, ranks)
    return ranks


def positions_of(mask: Mask, count: int | None = None) -> Indices:
    """Positions, int32 ascending, where a uint8 device mask is not zero. One sync, or none if `count` is given."""
    device = mask.device
    if not device.is_cuda or not mask.size:
        return upload(np.flatnonzero(download(mask).view(np.bool_)).astype(np.int32), int32, device)
    ranks = _ranks_of(mask)
    if count is None:
        count = int(download(rows_of(ranks, mask.size - 1, mask.size))[0])  # sync
    positions = empty(count, int32, device)
    launch(scatter_positions_kernel, mask.size, [mask, ranks, positions])
    return positions


def positions_of_each(*masks: Mask) -> list[Indices]:
    """As `positions_of` of several masks on one device. One sync for all."""
    return positions_beside(masks, ())[0]


def positions_beside(masks: Sequence[Mask], beside: Sequence[AnyArray]) -> tuple[list[Indices], list[np.ndarray]]:
    """As `positions_of` of several masks on one device, and other arrays as NumPy. One sync for all."""
    device = masks[0].device
    if not device.is_cuda:
        return [positions_of(mask) for mask in masks], read_together(beside) if beside else []
    counts, every = zeros(len(masks), int32, device), []
    for k, mask in enumerate(masks):
        ranks = _ranks_of(mask) if mask.size else empty(0, int32, device)
        if mask.size:
            copy(counts, rows_of(ranks, mask.size - 1, mask.size), count=1, offset=k)
        every.append(ranks)
    sizes, *read = read_together([counts, *beside])  # sync
    selected = [empty(count, int32, device) for count in sizes.tolist()]
    for mask, ranks, positions in zip(masks, every, selected, strict=True):
        launch(scatter_positions_kernel, mask.size, [mask, ranks, positions])
    return selected, read


@kernel
def gather_counts_kernel(ranks: array(dtype=int32), firsts: array(dtype=int32), counts: array(dtype=int32)):
    """Set elements before each of some positions. Ranks are inclusive."""
    i = tid()
    count = 0
    if firsts[i] > 0:
        count = ranks[firsts[i] - 1]
    counts[i] = count


def positions_and_starts(mask: Mask, firsts: np.ndarray) -> tuple[Indices, np.ndarray]:
    """As `positions_of`, and the counts before some positions (the last is n): int64 on the host (one sync)."""
    device = mask.device
    if not device.is_cuda or not mask.size:
        positions = positions_of(mask)
        return positions, np.searchsorted(download(positions), firsts)
    ranks, counts = _ranks_of(mask), empty(len(firsts), int32, device)
    launch(gather_counts_kernel, len(firsts), [ranks, upload(firsts, int32, device), counts])
    starts = download(counts).astype(np.int64)  # sync
    positions = empty(int(starts[-1]), int32, device)
    launch(scatter_positions_kernel, mask.size, [mask, ranks, positions])
    return positions, starts


def gather_rows(values: Array, rows: Indices) -> Array:
    """values[rows] on the device, for vectors of three and scalar arrays (n) or (n, c). `rows` int32 in 0..n-1."""
    device = values.device
    if values.dtype in GATHERING:
        out: Any = empty(rows.size, values.dtype, device)
        launch(GATHERING[values.dtype], rows.size, [values, rows, out])
        return out
    if not device.is_cuda:
        chosen: Any = upload(download(values)[download(rows)], values.dtype, device)
        return chosen
    return contiguous(values[rows])


@kernel
def list_selected_kernel(rows: array(dtype=int32), offsets: array(dtype=int32), selected: array(dtype=int32)):
    i = tid()
    if offsets[i + 1] > offsets[i]:
        selected[offsets[i]] = rows[i]


def rows_by_offsets(rows: Indices, offsets: Indices, count: int) -> Indices:
    """The `count` rows whose offset increases, in order. `offsets`: exclusive sums of 0 and 1, and the total."""
    selected = empty(count, int32, rows.device)
    launch(list_selected_kernel, rows.size if count else 0, [rows, offsets, selected])
    return selected
