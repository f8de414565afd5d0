"""Launches of a segmented reduction on CUDA: one thread block per block of elements.

Thread counts are 32-bit, so more than 2^31 / 256 blocks (8.4 million) take several launches over parts of the tables.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import warp as wp

from ..array_types import AnyArray, Integers
from .arguments import MAX_THREADS
from .cuda_launches import CudaLaunch, prepared_launch
from .device_arrays import kind_of
from .device_lock import lock
from .prepared_launches import UNFIT, flattener
from .warp_compiler import REDUCTION_BLOCK, CudaSegmentReduction

if TYPE_CHECKING:
    from .launched import LaunchedReduction

MAX_BLOCKS = MAX_THREADS // REDUCTION_BLOCK  # of a launch


def launch_segments(
    run: Callable[..., None],
    kernels: CudaSegmentReduction,
    values: Sequence[Any],
    blocks: Any,
    live: Integers,
    partials: AnyArray,
    out: AnyArray,
) -> None:
    """Sum the vectors of a reduction over segments. Take the lock first. Arguments as in `lang.reduce_segments`."""
    size = REDUCTION_BLOCK
    for first in range(0, blocks.count, MAX_BLOCKS):
        threads = min(MAX_BLOCKS, blocks.count - first) * size
        given = [*values, *_tables(blocks), live, first, blocks.count, partials, out]
        run(kernels.tiles, threads, given, out.device, block_dim=size)


def _tables(blocks: Any) -> tuple[Integers, ...]:
    return blocks.firsts, blocks.lasts, blocks.owners, blocks.starts


class PreparedSegmentSum:
    """Prepared segmented reduction on a GPU, for sizes that fit in one launch."""

    def __init__(self, reduction: LaunchedReduction, tiles: CudaLaunch, device: Any) -> None:
        self._flatten = flattener(reduction.types, device, reduction.field_paths, len(reduction.takes))
        self._sums, self._table = kind_of(reduction.vector, 1, device), kind_of(wp.int32, 1, device)
        self._tiles = tiles

    @classmethod
    def of(
        cls,
        reduction: LaunchedReduction,
        values: Sequence[Any],
        blocks: Any,
        live: Integers,
        partials: AnyArray,
        out: AnyArray,
    ) -> PreparedSegmentSum | None:
        """Prepare from the arguments of a launch. None if Warp must launch it. Raises one of UNFIT."""
        device, size = out.device, REDUCTION_BLOCK
        given = [*values, *_tables(blocks), live, 0, blocks.count, partials, out]
        tiles = prepared_launch(reduction.cuda.tiles, size, given, device, block_dim=size)
        return cls(reduction, tiles, device) if tiles.is_known else None

    def is_launched(
        self, arguments: Sequence[Any], blocks: Any, live: Integers, partials: AnyArray, out: AnyArray
    ) -> bool:
        """Launch. False without any effect for arguments that need conversion."""
        table, sums, count = self._table.packed, self._sums.packed, blocks.count
        if not 0 < count <= MAX_BLOCKS:
            return False
        try:
            flat, tables = self._flatten(arguments), map(table, _tables(blocks))
            with lock:
                packed = (*flat, *tables, table(live), 0, count, sums(partials), sums(out))
                self._tiles(count * REDUCTION_BLOCK, packed)
        except UNFIT:
            return False
        return True
