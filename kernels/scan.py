"""Exclusive prefix sums: where each of many variable-sized results goes."""

import numpy as np
import warp as wp

from .lang import array, int32, kernel, launch, tid
from .memory import empty

MAX_SAFE_COUNT = 2**20  # beyond this many runs of up to 2^11 the sum could wrap to a positive number


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
    offsets = empty(n + 1, int32, device)
    if n == 0:
        offsets.zero_()
        return offsets, 0
    if not device.is_cuda:
        host = offsets.numpy()
        host[0] = 0
        total = int(counts.numpy().sum(dtype=np.int64))
        _check_total(total)
        np.cumsum(counts.numpy(), out=host[1:], dtype=np.int32)
        return offsets, total
    wp.utils.array_scan(counts, offsets[:n], inclusive=False)
    launch(fill_last_offset_kernel, 1, [counts, offsets])
    total = int(offsets[n : n + 1].numpy()[0])  # sync
    if total < 0 or n > MAX_SAFE_COUNT:
        _check_total(int(counts.numpy().sum(dtype=np.int64)))  # sync; the 32-bit sum may have wrapped
    return offsets, total


def _check_total(total: int) -> None:
    if total > 2**31 - 1:
        raise ValueError(f"{total} results are more than 2^31 - 1; ask for fewer at a time")
