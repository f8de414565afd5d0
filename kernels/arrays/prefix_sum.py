"""Exclusive prefix sums: where each of many variable-sized results goes."""

import numpy as np
import warp as wp

from ..lang import array, atomic_add, int32, int64, kernel, launch, tid
from ..language.device_lock import turn_on
from ..memory import download, empty, host_view, zeros

RUN = 4096  # counts a thread: one atomic a run


@kernel
def sum_counts_kernel(counts: array(dtype=int32), run: int, total: array(dtype=int64)):
    """The sum of one run of counts; integers, so the order of the atomics does not matter."""
    i = tid()
    part = int64(0)
    for j in range(i * run, i * run + min(run, counts.shape[0] - i * run)):
        part += int64(counts[j])
    atomic_add(total, 0, part)


@kernel
def fill_last_offset_kernel(counts: array(dtype=int32), offsets: array(dtype=int32)):
    """The total, behind the last offset."""
    i = tid()
    last = counts.shape[0] - 1
    offsets[last + 1 + i] = offsets[last] + counts[last]


def exclusive_scan(counts):
    """Offsets of runs of the given lengths.

    Args:
        counts: int32 device array of shape [n], none negative.

    Returns:
        (offsets, total): int32 device array of shape [n + 1], and the sum as a Python number (one sync).

    Raises:
        ValueError: The sum passes 2^31 - 1.
    """
    device, n = counts.device, counts.size
    if n == 0:
        return zeros(1, int32, device), 0
    offsets = empty(n + 1, int32, device)
    total = sum_counts(counts)
    if total > 2**31 - 1:
        raise ValueError(f"{total} results are more than 2^31 - 1; ask for fewer at a time")
    if not device.is_cuda:
        host = host_view(offsets)
        host[0] = 0
        np.cumsum(download(counts), out=host[1:], dtype=np.int32)
        return offsets, total
    with turn_on(device):
        wp.utils.array_scan(counts, offsets[:n], inclusive=False)
    launch(fill_last_offset_kernel, 1, [counts, offsets])
    return offsets, total


def sum_counts(counts):
    """The sum of an int32 device array as a Python number, in 64 bits: 32 could wrap back to a positive number."""
    total = zeros(1, int64, counts.device)
    launch(sum_counts_kernel, -(-counts.size // RUN), [counts, RUN, total])
    return int(download(total)[0])  # sync
