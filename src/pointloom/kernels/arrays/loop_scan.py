"""Positions of flags inside a device loop, without allocation."""

import numpy as np

from ..array_types import Device, Integers, Mask
from ..lang import array, int32, kernel, launch, tid, uint8
from ..memory import empty, host_view
from .select import count_mask_kernel
from .tile_scan import TileScan


@kernel
def list_marked_kernel(
    mask: array(dtype=uint8), ranks: array(dtype=int32), slot: int, rows: array(dtype=int32), counts: array(dtype=int32)
):
    """Positions of the flags in order (ranks count from one), and their count."""
    i = tid()
    if mask[i] != 0:
        rows[ranks[i] - 1] = i
    if i + 1 == mask.shape[0]:
        counts[slot] = ranks[i]


class LoopList:
    """Positions of up to `capacity` flags in ascending order, in a device loop; `rows` int32 (capacity)."""

    def __init__(self, capacity: int, device: Device) -> None:
        self.rows, self.ranks = empty(capacity, int32, device), empty(capacity if device.is_cuda else 0, int32, device)
        self._scan = TileScan(capacity, device)

    def find(self, mask: Mask, count: int, counts: Integers, slot: int) -> None:
        """List the flags among the first `count` of a mask, and write counts[slot]. Not recordable on the CPU."""
        if not mask.device.is_cuda:
            rows = np.flatnonzero(host_view(mask)[:count].view(np.bool_))
            host_view(self.rows)[: len(rows)] = rows
            host_view(counts)[slot] = len(rows)
            return
        launch(count_mask_kernel, mask.size, [mask, self.ranks])
        self._scan.run(self.ranks, self.ranks, mask.size)
        launch(list_marked_kernel, mask.size, [mask, self.ranks, slot, self.rows, counts])
