"""Monotonic running sums of non-negative float64 numbers, bitwise identical on every device.

Runs depend only on the count. A run's last sum is the same addition as the next run's start, so sums never decrease.
"""

import math

from ..array_types import Doubles
from ..lang import array, float64, kernel, launch, tid
from ..memory import empty

SHORTEST_RUN = 64  # numbers per thread: fewer are not worth a launch


@kernel
def sum_runs_kernel(values: array(dtype=float64), run: int, sums: array(dtype=float64)):
    i = tid()
    total = float64(0.0)
    for j in range(i * run, i * run + min(run, values.shape[0] - i * run)):
        total += values[j]
    sums[i] = total


@kernel
def start_runs_kernel(sums: array(dtype=float64), starts: array(dtype=float64)):
    """Sum of all before each run, and of all, by one thread."""
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
    i = tid()
    part = float64(0.0)
    for j in range(i * run, i * run + min(run, values.shape[0] - i * run)):
        part += values[j]
        running[j] = starts[i] + part


def running_sums(values: Doubles) -> Doubles:
    """Inclusive sums of non-negative float64 values (n)."""
    device, count = values.device, values.size
    run = max(SHORTEST_RUN, math.isqrt(count))
    runs = -(-count // run)
    sums, starts = empty(runs, float64, device), empty(runs + 1, float64, device)
    running = empty(count, float64, device)
    launch(sum_runs_kernel, runs, [values, run, sums])
    launch(start_runs_kernel, min(1, runs), [sums, starts])
    launch(write_running_sums_kernel, runs, [values, run, starts, running])
    return running
