"""Prefix sums by tiles, without allocation: in a loop of the device, of few counts, and on every stream in order."""

import itertools

from ..array_types import Device, Integers
from ..lang import WARP, array, int32, kernel, launch, shuffle, tid, vector
from ..memory import empty
from .lanes import LANE_BITS, sum_int_of_lanes

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


class TileScan:
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
