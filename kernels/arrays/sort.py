"""Stable order of 64-bit keys: the primitive under voxel grids, search trees and unique keys.

On CUDA Warp's radix sort (24 B read and written a pass of 8 bits). On the CPU the keys are packed with their positions
into one word and sorted by NumPy's vector sort where both fit into 63 bits, since that is twice as fast as a radix
sort of pairs there; else Warp's radix sort. All are stable, so equal keys keep their order and the result is unique.
"""

import numpy as np
import warp as wp

from ..lang import array, int32, int64, kernel, launch, tid
from ..language.device_lock import turn_on
from ..memory import copy, download, empty, host_view


@kernel
def fill_positions_kernel(positions: array(dtype=int32)):
    """positions[i] = i."""
    i = tid()
    positions[i] = i


def positions(count, device):
    """0, 1, 2, ... as an int32 device array [count]."""
    places = empty(count, int32, device)
    launch(fill_positions_kernel, count, [places])
    return places


def argsort_keys(keys, bit_count=63):
    """The stable order of keys that are not negative.

    Args:
        keys: int64 device array of shape [n]; left as it is.
        bit_count: Bits that the keys use; fewer sort faster.

    Returns:
        (sorted keys, order): int64 [n] and int32 [n], with `sorted = keys[order]`. 40 B of memory a key.
    """
    count, device = keys.size, keys.device
    if count == 0:
        return empty(0, int64, device), empty(0, int32, device)
    index_bits = max(1, (count - 1).bit_length())
    if not device.is_cuda and bit_count + index_bits <= 63:
        packed = download(keys) << index_bits
        packed |= np.arange(count, dtype=np.int64)
        packed.sort()
        sorted_keys, order = empty(count, int64, device), empty(count, int32, device)
        np.bitwise_and(packed, (1 << index_bits) - 1, out=host_view(order), casting="unsafe")
        np.right_shift(packed, index_bits, out=host_view(sorted_keys))
        return sorted_keys, order
    pair_keys, pair_values = empty(2 * count, int64, device), empty(2 * count, int32, device)
    copy(pair_keys, keys, count=count)
    launch(fill_positions_kernel, count, [pair_values[:count]])
    with turn_on(device):
        wp.utils.radix_sort_pairs(pair_keys, pair_values, count, 0, bit_count)
    return pair_keys[:count], pair_values[:count]
