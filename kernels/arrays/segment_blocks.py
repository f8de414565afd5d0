"""Segments of elements cut into blocks, the unit of a segmented reduction."""

import numpy as np
from numpy.typing import ArrayLike

from ..array_types import Device
from ..lang import BLOCK, int32
from ..memory import upload_together


class SegmentBlocks:
    """Blocks of segments. None crosses a boundary. `owners`: their segments; `starts`: first block per segment."""

    def __init__(self, firsts: ArrayLike, counts: ArrayLike, device: Device) -> None:
        firsts, counts = np.asarray(firsts, np.int64), np.asarray(counts, np.int64)
        blocks = -(-counts // BLOCK)
        starts = np.concatenate([[0], np.cumsum(blocks)])
        owners = np.repeat(np.arange(len(counts)), blocks)
        rank = np.arange(starts[-1]) - starts[owners]
        begin = firsts[owners] + rank * BLOCK
        end = np.minimum(begin + BLOCK, (firsts + counts)[owners])
        self.firsts, self.lasts, self.owners, self.starts = upload_together([begin, end, owners, starts], int32, device)
        self.count = int(starts[-1])
        self.element_count = int((firsts + counts).max(initial=0))
