"""One block of a GPU, or one thread of the CPU, that runs all phases of a small problem in one launch.

A kernel takes `block_threads(device)` threads and processes the rows i, i + threads, ... of a phase. `wait_for_block`
separates phases: it is where a second launch would be without it. All threads of the block must reach it.
"""

from ..array_types import Device
from ..lang import BLOCK_THREADS, WARP, array, func, sync_block, vec2d
from .lanes import sum_double_of_lanes

WARPS = BLOCK_THREADS // WARP  # of a block


def block_threads(device: Device) -> int:
    """Number of threads of a launch that is one block on CUDA, one thread on the CPU."""
    return BLOCK_THREADS if device.is_cuda else 1


@func
def wait_for_block():
    """Wait until all threads of the block have arrived, with their writes."""
    pass


@wait_for_block.on_cuda
def wait_for_block_on_cuda():
    sync_block()


@func
def sum_of_block(i: int, value: vec2d, partials: array(dtype=vec2d)) -> vec2d:
    """Sum over the threads of the block in a fixed order, the same for all threads. `partials` (8) is scratch."""
    return value


@sum_of_block.on_cuda
def sum_of_block_on_cuda(i: int, value: vec2d, partials: array(dtype=vec2d)) -> vec2d:
    total = vec2d(sum_double_of_lanes(value[0]), sum_double_of_lanes(value[1]))
    if i % WARP == 0:
        partials[i // WARP] = total
    sync_block()
    total = vec2d(0.0, 0.0)
    for warp in range(WARPS):
        total = total + partials[warp]
    sync_block()
    return total
