"""Unique keys with counts: sort, mark where a key differs from the one before, compact."""

import numpy as np

from ..lang import array, int32, int64, kernel, launch, struct, tid, uint8
from ..memory import copy, download, empty, upload
from .select import gather_rows, positions_of
from .sort import argsort_keys


@kernel
def mark_run_starts_kernel(keys: array(dtype=int64), starts: array(dtype=uint8)):
    """1 where a sorted key differs from the one before."""
    i = tid()
    first = int(1)
    if i > 0:
        if keys[i] == keys[i - 1]:
            first = 0
    starts[i] = uint8(first)


@kernel
def count_runs_kernel(starts: array(dtype=int32), counts: array(dtype=int32)):
    """The length of each run."""
    i = tid()
    counts[i] = starts[i + 1] - starts[i]


@struct
class UniqueKeys:
    """The distinct keys of an array, ascending, and where each one came from.

    Attributes:
        count: Distinct keys m.
        keys: int64 [m].
        order: int32 [n], positions by key; those of one key in their own order.
        starts: int32 [m + 1], where each key's positions begin in `order`.
    """

    keys: array(dtype=int64)
    order: array(dtype=int32)
    starts: array(dtype=int32)

    def __init__(self, keys, bit_count=63, in_order=None):
        """Find the distinct ones among int64 keys of `bit_count` bits, none negative; one sync.

        `in_order` is what `argsort_keys` would give, where another sort gave it already.
        """
        device = keys.device
        sorted_keys, self.order = in_order or argsort_keys(keys, bit_count)
        marks = empty(keys.size, uint8, device)
        launch(mark_run_starts_kernel, keys.size, [sorted_keys, marks])
        heads = positions_of(marks)
        self.count = heads.size
        self.keys = gather_rows(sorted_keys, heads)
        self.starts = empty(self.count + 1, int32, device)
        copy(self.starts, heads, count=self.count)
        copy(self.starts, upload(np.array([keys.size]), int32, device), count=1, offset=self.count)

    def counts(self):
        """How often each key occurs, int32 [m]."""
        counts = empty(self.count, int32, self.starts.device)
        launch(count_runs_kernel, self.count, [self.starts, counts])
        return counts

    def drop_last(self, key):
        """Forget one key where it is the last of all; its positions stay at the end of `order`."""
        if self.count and int(download(self.keys[self.count - 1 :])[0]) == key:  # sync
            self.count -= 1
            self.keys, self.starts = self.keys[: self.count], self.starts[: self.count + 1]
