"""The launches of a segment reduction on CUDA: a block of threads a block of elements, then one a segment.

Threads are counted in 32 bits, so more than 2^31 / 256 blocks (8.4 million) go in several launches, each over a part of
the tables: a thread then finds its block by its number within the part.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any

from ..array_types import AnyArray, Integers
from .arguments import MAX_THREADS
from .warp_compiler import REDUCTION_BLOCK, CudaSegmentReduction


def launch_segments(
    run: Callable[..., None],
    kernels: CudaSegmentReduction,
    values: Sequence[Any],
    blocks: Any,
    live: Integers,
    partials: AnyArray,
    out: AnyArray,
) -> None:
    """Sum the vectors of a reduction over segments; take the lock first.

    Args:
        run: Launches a kernel: (kernel, threads, arguments, device, block_dim=...).
        kernels: The reduction's.
        values: Checked arguments of its function.
        blocks, live, partials, out: As of `lang.reduce_segments`.
    """
    device, size = out.device, REDUCTION_BLOCK
    for part in _parts(blocks.count):
        tables = [blocks.firsts[part], blocks.lasts[part], blocks.owners[part], live, partials[part]]
        run(kernels.tiles, (part.stop - part.start) * size, [*values, *tables], device, block_dim=size)
    for part in _parts(out.size):
        tables = [blocks.starts[part.start : part.stop + 1], live[part], partials, out[part]]
        run(kernels.fold_tiles, (part.stop - part.start) * size, tables, device, block_dim=size)


def _parts(count: int) -> Iterator[slice]:
    most = MAX_THREADS // REDUCTION_BLOCK
    for first in range(0, count, most):
        yield slice(first, min(first + most, count))
