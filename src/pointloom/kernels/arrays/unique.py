"""Unique keys with counts: sort, flag changes, compact. On CUDA three launches, a scan and one sync."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..array_types import AnyArray, Indices, Integers, Keys, LongIntegers
from ..lang import array, compute, int32, int64, kernel, launch, struct, tid, uint8
from ..memory import copy, download, empty, full, rows_of, upload
from .prefix_sum import inclusive_scan
from .side_by_side import read_together
from .sort import argsort_keys


@kernel(for_cpu=True)
def mark_run_starts_kernel(keys: array(dtype=int64), starts: array(dtype=uint8)):
    i = tid()
    first = 1
    if i > 0:
        if keys[i] == keys[i - 1]:
            first = 0
    starts[i] = uint8(first)


@kernel
def mark_heads_kernel(keys: array(dtype=int64), ranks: array(dtype=int32)):
    """1 where a sorted key differs from the previous one. Then the last key, low half first."""
    i = tid()
    first = 1
    if i > 0:
        if keys[i] == keys[i - 1]:
            first = 0
    ranks[i] = first
    if i == keys.shape[0] - 1:
        ranks[i + 1] = int(keys[i])
        ranks[i + 2] = int(keys[i] >> 32)


@kernel
def write_heads_kernel(
    sorted_keys: array(dtype=int64), ranks: array(dtype=int32), keys: array(dtype=int64), starts: array(dtype=int32)
):
    """Each key and its start by rank (prefix sums of the flags), and the end."""
    i = tid()
    before = 0
    if i > 0:
        before = ranks[i - 1]
    if ranks[i] > before:
        keys[before] = sorted_keys[i]
        starts[before] = i
    if i == sorted_keys.shape[0] - 1:
        starts[ranks[i]] = i + 1


@kernel
def count_runs_kernel(starts: array(dtype=int32), counts: array(dtype=int32)):
    i = tid()
    counts[i] = starts[i + 1] - starts[i]


@struct
class UniqueKeys:
    """Distinct ascending `keys` (m), `order` of positions by key (stable), `starts` (m + 1) in it; `beside`: extra
    numbers read. If padded, `summary` has the distinct count and the last key, low half first, on the device.
    """

    keys: array(dtype=int64)
    order: array(dtype=int32)
    starts: array(dtype=int32)

    def __init__(
        self,
        keys: Keys,
        bit_count: int = 63,
        in_order: tuple[LongIntegers, Indices] | None = None,
        beside: Integers | None = None,
        padded: bool = False,
    ) -> None:
        """Find the distinct of non-negative int64 keys. One sync. `in_order`: known result of `argsort_keys`. With
        `padded` there is no sync: on CUDA `count` is that of all keys, and the padding has no positions.
        """
        device = keys.device
        sorted_keys, self.order = in_order or argsort_keys(keys, bit_count)
        self._last, self.beside, self.summary = None, [], None
        if device.is_cuda and keys.size:
            self._find_at_once(sorted_keys, beside, padded)
            return
        if beside is not None:
            self.beside = download(beside).tolist()  # sync
        marks = compute(mark_run_starts_kernel, keys.size, [sorted_keys], uint8, device)
        heads = np.flatnonzero(download(marks).view(np.bool_))  # five times as fast as of bytes
        self.count = len(heads)
        self.keys = upload(download(sorted_keys)[heads], int64, device, copied=False)
        self.starts = upload(np.append(heads, keys.size), int32, device, copied=False)

    def _find_at_once(self, sorted_keys: Keys, beside: Integers | None, padded: bool) -> None:
        keys, starts, summary = write_heads(sorted_keys, beside, padded=padded)
        if padded:
            self.count, self.keys, self.starts, self.summary = sorted_keys.size, keys, starts, summary
            return
        self.count, low, high, *self.beside = download(summary).tolist()  # sync
        self._last = (high << 32) | (low & 0xFFFF_FFFF)
        self.keys, self.starts = rows_of(keys, 0, self.count), rows_of(starts, 0, self.count + 1)

    def cut(self, count: int) -> None:
        """Set the distinct count of padded keys."""
        self.count, self.summary = count, None
        self.keys, self.starts = rows_of(self.keys, 0, count), rows_of(self.starts, 0, count + 1)

    def counts(self) -> Integers:
        return compute(count_runs_kernel, self.count, [self.starts], int32, self.starts.device)

    def drop_last(self, key: int) -> None:
        """Remove a key if it is the last. Its positions stay at the end of `order`."""
        if not self.count:
            return
        last = self._last
        if last is None:
            last = int(download(self.keys)[self.count - 1])
        if last == key:
            self._last = None
            self.count -= 1
            self.keys, self.starts = rows_of(self.keys, 0, self.count), rows_of(self.starts, 0, self.count + 1)


def cut_together(groups: Sequence[UniqueKeys], *beside: AnyArray) -> list[NDArray[Any]]:
    """Cut padded ones to their distinct keys, and download arrays `beside` them. One sync."""
    padded = [(group, group.summary) for group in groups if group.summary is not None]
    host = read_together([*(summary for _, summary in padded), *beside]) if padded or beside else []
    for (group, _), summary in zip(padded, host, strict=False):
        group.cut(int(summary[0]))
    return host[len(padded) :]


def write_heads(
    sorted_keys: Keys, beside: Integers | None = None, *, padded: bool = False
) -> tuple[Keys, Integers, Integers]:
    """(keys, starts, summary) of sorted GPU keys as in UniqueKeys, without sync; `summary` is followed by `beside`."""
    n, device = sorted_keys.size, sorted_keys.device
    ranks = empty(n + 2 + (0 if beside is None else beside.size), int32, device)
    if beside is not None:
        copy(ranks, beside, count=beside.size, offset=n + 2)
    launch(mark_heads_kernel, n, [sorted_keys, ranks])
    counted = rows_of(ranks, 0, n)
    inclusive_scan(counted, counted)
    keys = empty(n, int64, device)
    starts = full(n + 1, n, int32, device) if padded else empty(n + 1, int32, device)
    launch(write_heads_kernel, n, [sorted_keys, ranks, keys, starts])
    return keys, starts, rows_of(ranks, n - 1, ranks.size)
