"""How the elements of an array are shared out among threads that take many each: for boxes, sums and extremes.

On the CPU a thread takes a run of neighbours, so long that the atomic at its end costs little. On CUDA it takes every
so-many-th element: lanes side by side read memory side by side, and there are threads enough to keep the chip busy.

Where threads settle their outcome by atomics, thousands at one address would stand in line (an atomic takes about half
a nanosecond there). So on CUDA they go to `rows` rows of results, which the host folds when it has read them.
"""

from ..array_types import Device
from ..lang import WARP, func, loop, struct

CUDA_THREADS = 1 << 17  # half of what an H200 holds at once: 12 B a thread under way are 1.5 MB, enough for its memory
CUDA_LEAST = 4  # elements a thread; fewer are not worth an atomic
CUDA_SHARE = 512  # threads a row of results: their atomics take a quarter of a microsecond, and the host reads few rows


@struct
class Runs:
    """The elements of each thread of a launch.

    Args:
        count: Elements.
        device: Where they are.
        length: Elements of a thread on the CPU.

    Attributes:
        threads: Threads; on CUDA a multiple of WARP.
        rows: Rows of results.
        count: Elements of all.
        length: Elements of a thread at most.
        apart: From a thread's first element to that of the next thread.
        step: From an element of a thread to its next.
    """

    rows: int
    count: int
    length: int
    apart: int
    step: int

    def __init__(self, count: int, device: Device, length: int) -> None:
        self.count = count
        if device.is_cuda:
            self.threads = min(CUDA_THREADS, -(-count // (CUDA_LEAST * WARP)) * WARP)
            self.length = -(-count // max(1, self.threads))
            self.apart, self.step = 1, max(1, self.threads)
            self.rows = max(1, self.threads // CUDA_SHARE)
        else:
            self.threads, self.length = -(-count // length), length
            self.apart, self.step, self.rows = length, 1, 1


@loop
def elements_of(i: int, runs: Runs) -> int:
    """The elements of a thread, in ascending order."""
    first = i * runs.apart
    for k in range(min(runs.length, (runs.count - 1 - first) // runs.step + 1)):
        yield first + k * runs.step


@func
def row_of(i: int, runs: Runs) -> int:
    """The row of results that a thread settles; one for a warp."""
    return (i // WARP) % runs.rows
