"""Prefix sums inside a device loop, without allocation (prefix_sum.py has the others), by tiles."""

import itertools

import numpy as np

from ..array_types import Device, Integers, Mask
from ..lang import WARP, array, int32, kernel, launch, shuffle, tid, uint8, vector
from ..memory import empty, host_view
from .lanes import LANE_BITS, sum_int_of_lanes
from .select import count_mask_kernel

TILE_COUNTS = 1024  # counts per warp: 32 per lane
LOADED = 8  # counts of a lane that are loaded before the first is used or stored: a load after a store waits for it
loaded_counts = vector(8, int32)


@kernel
def sum_tiles_kernel(counts: array(dtype=int32), count: int, sums: array(dtype=int32)):
    """Sum of each tile, by the first of its 32 threads."""
    i = tid()
    tile = i // WARP
    if i % WARP == 0:
        total = 0
        for j in range(tile * TILE_COUNTS, min((tile + 1) * TILE_COUNTS, count)):
            total += counts[j]
        sums[tile] = total


@sum_tiles_kernel.on_cuda
def sum_tiles_of_lanes_kernel(counts: array(dtype=int32), count: int, sums: array(dtype=int32)):
    i = tid()
    tile = i // WARP
    lane = i % WARP
    total = 0
    n = int(WARP) // LOADED
    for part in range(n):
        first = tile * TILE_COUNTS + part * LOADED * WARP + lane
        for step in range(LOADED):
            j = first + step * WARP
            value = counts[min(j, count - 1)]
            total += value if j < count else 0
    total = sum_int_of_lanes(total)
    if lane == 0:
        sums[tile] = total


@kernel
def scan_tiles_kernel(counts: array(dtype=int32), count: int, before: array(dtype=int32), sums: array(dtype=int32)):
    """Inclusive sums of a tile, on top of the sums `before` of earlier tiles."""
    i = tid()
    tile = i // WARP
    if i % WARP == 0:
        total = 0
        if tile > 0:
            total = before[tile - 1]
        for j in range(tile * TILE_COUNTS, min((tile + 1) * TILE_COUNTS, count)):
            total += counts[j]
            sums[j] = total


@scan_tiles_kernel.on_cuda
def scan_tiles_of_lanes_kernel(
    counts: array(dtype=int32), count: int, before: array(dtype=int32), sums: array(dtype=int32)
):
    """CUDA variant: warp scans of 32 counts in five steps."""
    i = tid()
    tile = i // WARP
    lane = i % WARP
    start = 0
    if tile > 0:
        start = before[tile - 1]
    n = int(WARP) // LOADED
    for part in range(n):
        first = tile * TILE_COUNTS + part * LOADED * WARP + lane
        loaded = loaded_counts(0)
        for step in range(LOADED):
            j = first + step * WARP
            value = counts[min(j, count - 1)]
            loaded[step] = value if j < count else 0
        for step in range(LOADED):
            total = loaded[step]
            for bit in range(LANE_BITS):
                lower = shuffle(total, max(lane - (1 << bit), 0))
                total += lower if lane >= (1 << bit) else 0
            j = first + step * WARP
            if j < count:
                sums[j] = start + total
            start += shuffle(total, WARP - 1)


class LoopScan:
    """Scratch memory for prefix sums of up to `size` counts."""

    def __init__(self, size: int, device: Device) -> None:
        self.levels: list[Integers] = []
        while size > TILE_COUNTS:
            size = -(-size // TILE_COUNTS)
            self.levels.append(empty(size, int32, device))

    def run(self, counts: Integers, sums: Integers, count: int) -> None:
        """sums[i] = counts[0] + ... + counts[i] for the first `count` of int32 arrays, which may be the same."""
        rows, sizes = [counts, *self.levels], [count]
        for lower, upper in itertools.pairwise(rows):
            tiles = -(-sizes[-1] // TILE_COUNTS)
            launch(sum_tiles_kernel, tiles * WARP, [lower, sizes[-1], upper])
            sizes.append(tiles)
        above = rows[-1]  # not read: there is one tile
        for row, size in zip(reversed(rows), reversed(sizes), strict=True):
            out = sums if row is counts else row
            launch(scan_tiles_kernel, -(-size // TILE_COUNTS) * WARP, [row, size, above, out])
            above = out


@kernel
def list_marked_kernel(
    mask: array(dtype=uint8), ranks: array(dtype=int32), slot: int, rows: array(dtype=int32), counts: array(dtype=int32)
):
    """Positions of the flags in order (ranks count from one), and their count."""
    i = tid()
    if mask[i] != 0:
        rows[ranks[i] - 1] = i
    if i + 1 == mask.shape[0]:
        counts[slot] = ranks[i]


class LoopList:
    """Positions of up to `capacity` flags in ascending order, in a device loop; `rows` int32 (capacity)."""

    def __init__(self, capacity: int, device: Device) -> None:
        self.rows, self.ranks = empty(capacity, int32, device), empty(capacity if device.is_cuda else 0, int32, device)
        self._scan = LoopScan(capacity, device)

    def find(self, mask: Mask, count: int, counts: Integers, slot: int) -> None:
        """List the flags among the first `count` of a mask, and write counts[slot]. Not recordable on the CPU."""
        if not mask.device.is_cuda:
            rows = np.flatnonzero(host_view(mask)[:count].view(np.bool_))
            host_view(self.rows)[: len(rows)] = rows
            host_view(counts)[slot] = len(rows)
            return
        launch(count_mask_kernel, mask.size, [mask, self.ranks])
        self._scan.run(self.ranks, self.ranks, mask.size)
        launch(list_marked_kernel, mask.size, [mask, self.ranks, slot, self.rows, counts])
