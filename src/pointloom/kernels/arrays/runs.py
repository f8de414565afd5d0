"""Distribution of elements over threads that process many each.

On the CPU threads take contiguous runs, on CUDA strided elements for coalesced access. On CUDA the atomics, one per
warp (row_atomics.py), are spread over `rows` result rows, which the host reduces, to limit contention.
"""

from ..array_types import Device
from ..lang import WARP, func, loop, struct

CUDA_THREADS = 1 << 17  # half the capacity of an H200: 12 B per thread in flight saturate its memory
CUDA_MIN_LENGTH = 4  # elements per thread. Fewer are not worth an atomic
CUDA_SHARE = 512  # threads per result row: 16 atomics, and the host reads few rows


@struct
class Runs:
    """Elements of each thread of a launch: `stride` between threads' first elements, `step` within a thread."""

    rows: int
    count: int
    length: int
    stride: int
    step: int

    def __init__(self, count: int, device: Device, length: int) -> None:
        self.count = count
        if device.is_cuda:
            self.threads = min(CUDA_THREADS, -(-count // (CUDA_MIN_LENGTH * WARP)) * WARP)
            self.length = -(-count // max(1, self.threads))
            self.stride, self.step = 1, max(1, self.threads)
            self.rows = max(1, self.threads // CUDA_SHARE)
        else:
            self.threads, self.length = -(-count // length), length
            self.stride, self.step, self.rows = length, 1, 1


@loop
def elements_of(i: int, runs: Runs) -> int:
    first = i * runs.stride
    for k in range(min(runs.length, (runs.count - 1 - first) // runs.step + 1)):
        yield first + k * runs.step


@func
def row_of(i: int, runs: Runs) -> int:
    """Result row of a thread. One per warp."""
    return (i // WARP) % runs.rows
