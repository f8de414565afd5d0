"""Running sums of float64 numbers in a fixed order: the same bits on every device, and never falling.

Numbers are cut into runs whose length depends on their count alone. A thread sums each run, one thread the runs, and a
thread writes each run's sums on top of those before it. 8 B read twice and 8 B written a number.

The last sum of a run is the same addition as the one that the next run begins with, so it has the same bits: no sum is
below the one before, and a number that is zero never raises it.
"""

import math

from ..array_types import Doubles
from ..lang import array, float64, kernel, launch, tid
from ..memory import empty

SHORTEST_RUN = 64  # numbers: below it a thread is not worth its launch


@kernel
def sum_runs_kernel(values: array(dtype=float64), run: int, sums: array(dtype=float64)):
    """The sum of each run."""
    i = tid()
    total = float64(0.0)
    for j in range(i * run, i * run + min(run, values.shape[0] - i * run)):
        total += values[j]
    sums[i] = total


@kernel
def start_runs_kernel(sums: array(dtype=float64), starts: array(dtype=float64)):
    """The sum of all before each run, and of all, by one thread."""
    i = tid()
    total = float64(0.0)
    for r in range(i, sums.shape[0]):
        starts[r] = total
        total += sums[r]
    starts[sums.shape[0]] = total


@kernel
def write_running_sums_kernel(
    values: array(dtype=float64), run: int, starts: array(dtype=float64), running: array(dtype=float64)
):
    """running[j] is the sum of values[0 .. j]."""
    i = tid()
    part = float64(0.0)
    for j in range(i * run, i * run + min(run, values.shape[0] - i * run)):
        part += values[j]
        running[j] = starts[i] + part


def running_sums(values: Doubles) -> Doubles:
    """The sums of float64 values [n], none negative, up to and with each; float64 [n]."""
    device, count = values.device, values.size
    run = max(SHORTEST_RUN, math.isqrt(count))
    runs = -(-count // run)
    sums, starts = empty(runs, float64, device), empty(runs + 1, float64, device)
    running = empty(count, float64, device)
    launch(sum_runs_kernel, runs, [values, run, sums])
    launch(start_runs_kernel, min(1, runs), [sums, starts])
    launch(write_running_sums_kernel, runs, [values, run, starts, running])
    return running
