"""Segments of elements cut into blocks, the unit of a segmented reduction."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..array_types import Array1, Device
from ..lang import ELEMENTS_PER_BLOCK, int32
from ..language.warp_compiler import partial_rows
from ..memory import empty, upload_together, zeros


class SegmentBlocks:
    """Blocks of segments, at least one each. None crosses a boundary. `owners`: their segments; `starts`: first block
    per segment. `sizes`: elements of the blocks of each segment, such as those of `block_elements`.
    """

    def __init__(
        self, firsts: ArrayLike, counts: ArrayLike, device: Device, sizes: ArrayLike = ELEMENTS_PER_BLOCK
    ) -> None:
        firsts, counts = np.asarray(firsts, np.int64), np.asarray(counts, np.int64)
        sizes = np.broadcast_to(np.asarray(sizes, np.int64), counts.shape)
        blocks = np.maximum(-(-counts // sizes), 1)
        starts = np.concatenate([[0], np.cumsum(blocks)])
        owners = np.repeat(np.arange(len(counts)), blocks)
        rank = np.arange(starts[-1]) - starts[owners]
        begin = firsts[owners] + rank * sizes[owners]
        end = np.minimum(begin + sizes[owners], (firsts + counts)[owners])
        self.firsts, self.lasts, self.owners, self.starts = upload_together([begin, end, owners, starts], int32, device)
        self.count = int(starts[-1])
        self.element_count = int((firsts + counts).max(initial=0))

    def partials(self, vector: Any) -> Array1[Any]:
        """Scratch for sums of a vector over the segments, for one sum at a time."""
        if self.starts.device.is_cuda:
            return zeros(partial_rows(vector, self.count, self.starts.size - 1), vector, self.starts.device)
        return empty(self.count, vector, self.starts.device)
