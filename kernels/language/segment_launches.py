"""Launches of a segmented reduction on CUDA: one thread block per block of elements, then one per segment.

Thread counts are 32-bit, so more than 2^31 / 256 blocks (8.4 million) take several launches over parts of the tables.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

import warp as wp

from ..array_types import AnyArray, Integers
from .arguments import MAX_THREADS
from .cuda_launches import UNFIT, CudaLaunch, flattener, prepared_launch
from .device_arrays import kind_of
from .device_lock import lock
from .warp_compiler import REDUCTION_BLOCK, CudaSegmentReduction

if TYPE_CHECKING:
    from ..lang import Reduction

_MAX_BLOCKS = MAX_THREADS // REDUCTION_BLOCK  # blocks or segments of a launch


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
    device, size = out.device, REDUCTION_BLOCK
    for part in _parts(blocks.count):
        tables = [blocks.firsts[part], blocks.lasts[part], blocks.owners[part], live, partials[part]]
        run(kernels.tiles, (part.stop - part.start) * size, [*values, *tables], device, block_dim=size)
    for part in _parts(out.size):
        tables = [blocks.starts[part.start : part.stop + 1], live[part], partials, out[part]]
        run(kernels.fold_tiles, (part.stop - part.start) * size, tables, device, block_dim=size)


class PreparedSegmentSum:
    """Prepared segmented reduction on a GPU, for sizes that fit in one launch."""

    def __init__(self, reduction: Reduction, tiles: CudaLaunch, fold: CudaLaunch, device: Any) -> None:
        self._flatten = flattener(reduction.types, device, reduction.field_paths, len(reduction.takes))
        self._sums, self._tables = kind_of(reduction.vector, 1, device), kind_of(wp.int32, 1, device)
        self._tiles, self._fold = tiles, fold

    @classmethod
    def of(
        cls, reduction: Reduction, values: Sequence[Any], blocks: Any, live: Integers, partials: AnyArray, out: AnyArray
    ) -> PreparedSegmentSum | None:
        """Prepare from the arguments of a launch. None if Warp must launch it. Raises one of UNFIT."""
        kernels, device, size = reduction.cuda, out.device, REDUCTION_BLOCK
        given = [*values, blocks.firsts, blocks.lasts, blocks.owners, live, partials]
        tiles = prepared_launch(kernels.tiles, size, given, device, block_dim=size)
        fold = prepared_launch(kernels.fold_tiles, size, [blocks.starts, live, partials, out], device, block_dim=size)
        return cls(reduction, tiles, fold, device) if tiles.is_known and fold.is_known else None

    def is_launched(
        self, arguments: Sequence[Any], blocks: Any, live: Integers, partials: AnyArray, out: AnyArray
    ) -> bool:
        """Launch. False without any effect for arguments that need conversion."""
        size, packed = REDUCTION_BLOCK, self._tables.packed
        if not 0 < blocks.count <= _MAX_BLOCKS or not 0 < out.size <= _MAX_BLOCKS:
            return False
        try:
            flat, sums = self._flatten(arguments), self._sums.packed(partials)
            tables = (packed(blocks.firsts), packed(blocks.lasts), packed(blocks.owners), packed(live), sums)
            folded = (packed(blocks.starts), packed(live), sums, self._sums.packed(out))
            with lock:
                self._tiles(blocks.count * size, (*flat, *tables))
                self._fold(out.size * size, folded)
        except UNFIT:
            return False
        return True


def _parts(count: int) -> Iterator[slice]:
    for first in range(0, count, _MAX_BLOCKS):
        yield slice(first, min(first + _MAX_BLOCKS, count))
