"""Stable order of 64-bit keys: the primitive under voxel grids, search trees and unique keys.

On CUDA Warp's radix sort (24 B read and written a pass of 8 bits). On the CPU the keys are packed with their positions
into one word and sorted by NumPy's vector sort where both fit into 63 bits, since that is twice as fast as a radix
sort of pairs there; else Warp's radix sort. All are stable, so equal keys keep their order and the result is unique.
"""

import itertools

import numpy as np
import warp as wp

from ..array_types import Device, Indices, Integers, Keys, LongIntegers
from ..lang import array, func, int32, int64, kernel, launch, struct, tid
from ..language.device_lock import turn_on
from ..memory import download, empty, host_view, rows_of

LEAST_RUN = 128  # keys in the mean: shorter runs are sorted sooner all at once than in turn from Python


@kernel
def fill_positions_kernel(positions: array(dtype=int32)):
    """positions[i] = i."""
    i = tid()
    positions[i] = i


def positions(count: int, device: Device) -> Indices:
    """0, 1, 2, ... as an int32 device array [count]."""
    places = empty(count, int32, device)
    launch(fill_positions_kernel, count, [places])
    return places


@struct
class SortKeys:
    """Keys that a kernel makes in order to have them sorted: `put_key` in the kernel, then `sort` on the host.

    On CUDA it fills what the radix sort works on, so that nothing is copied or numbered before.

    Attributes:
        keys: int64, one a position; on CUDA room for as many behind them.
        positions: int32, likewise; on the CPU there are none.
    """

    keys: array(dtype=int64)
    positions: array(dtype=int32)

    def __init__(self, count: int, device: Device) -> None:
        self.count, self.device = count, device
        room = 2 * count if device.is_cuda else 0
        self.keys, self.positions = empty(room or count, int64, device), empty(room, int32, device)

    def sort(self, bit_count: int = 63, starts: np.ndarray | None = None) -> tuple[LongIntegers, Integers]:
        """(sorted keys, order) of the keys, which are gone then; as of `argsort_keys`."""
        if not self.device.is_cuda or not self.count:
            return argsort_keys(self.keys, bit_count, starts)
        _sort_pairs(self.keys, self.positions, self.count, bit_count)
        return rows_of(self.keys, 0, self.count), rows_of(self.positions, 0, self.count)


@func
def put_key(i: int, key: int64, into: SortKeys):
    """Set the key of a position."""
    into.keys[i] = key
    if i < into.positions.shape[0]:
        into.positions[i] = i


@kernel
def copy_pairs_kernel(keys: array(dtype=int64), pair_keys: array(dtype=int64), pair_values: array(dtype=int32)):
    """The same keys, and their positions."""
    i = tid()
    pair_keys[i] = keys[i]
    pair_values[i] = i


def argsort_keys(keys: Keys, bit_count: int = 63, starts: np.ndarray | None = None) -> tuple[Keys, Integers]:
    """The stable order of keys that are not negative.

    Args:
        keys: int64 device array of shape [n]; left as it is.
        bit_count: Bits that the keys use; fewer sort faster.
        starts: Where runs of keys begin, on the host, ascending from 0 to n, if it is known that all keys of a run are
            smaller than those of the next: on the CPU they are sorted one by one.

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
        if starts is None or len(starts) - 1 > count // LEAST_RUN:
            packed.sort()
        else:
            for first, end in itertools.pairwise(starts.tolist()):
                packed[first:end].sort()
        sorted_keys, order = empty(count, int64, device), empty(count, int32, device)
        np.bitwise_and(packed, (1 << index_bits) - 1, out=host_view(order), casting="unsafe")
        np.right_shift(packed, index_bits, out=host_view(sorted_keys))
        return sorted_keys, order
    pair_keys, pair_values = empty(2 * count, int64, device), empty(2 * count, int32, device)
    launch(copy_pairs_kernel, count, [keys, pair_keys, pair_values])
    _sort_pairs(pair_keys, pair_values, count, bit_count)
    return rows_of(pair_keys, 0, count), rows_of(pair_values, 0, count)


def _sort_pairs(keys: Keys, values: Integers, count: int, bit_count: int) -> None:
    with turn_on(keys.device), keys.device.context_guard:  # Warp sorts on whichever GPU is current
        wp.utils.radix_sort_pairs(keys, values, count, 0, bit_count)
