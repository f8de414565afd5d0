"""Sums of counts, and exclusive prefix sums (offsets of variable-sized results)."""

import itertools
from collections.abc import Sequence

import numpy as np
import warp as wp

from ..array_types import Array, Integers, LongIntegers
from ..lang import array, func, int32, int64, kernel, launch, tid
from ..language import device_copies
from ..language.device_lock import lock_for
from ..language.streams import is_blocking
from ..memory import copy, download, empty, host_view, rows_of, upload, zeros
from .row_atomics import add_long
from .runs import Runs, elements_of, row_of
from .side_by_side import read_together
from .tile_scan import TILE_COUNTS, TileScan

MAX_COUNT = 2**31 - 1
RUN_COUNTS = 4096  # counts per thread on the CPU: one atomic per run
FEW_COUNTS = 1 << 17  # counts that NumPy adds up as fast as two cores (0.05 ms, random flags, 2026-11-28)


@func
def find_owner(offsets: array(dtype=int32), i: int) -> int:
    """Last position whose offset is not above i: the owner of the i-th result."""
    low = 0
    high = offsets.shape[0] - 1
    while low < high:
        middle = low + (high - low) // 2
        if offsets[middle + 1] > i:
            high = middle
        else:
            low = middle + 1
    return low


@func
def sum_of_run(i: int, counts: array(dtype=int32), runs: Runs) -> int64:
    part = int64(0)
    for j in elements_of(i, runs):
        part += int64(counts[j])
    return part


@kernel
def sum_counts_kernel(counts: array(dtype=int32), runs: Runs, totals: array(dtype=int64)):
    """Add a thread's counts to a row's."""
    i = tid()
    add_long(totals, row_of(i, runs), sum_of_run(i, counts, runs))


@kernel
def start_offsets_kernel(
    counts: array(dtype=int32), runs: Runs, totals: array(dtype=int64), offsets: array(dtype=int32)
):
    i = tid()
    if i == 0:
        offsets[0] = 0
    add_long(totals, row_of(i, runs), sum_of_run(i, counts, runs))


@kernel
def gather_int_kernel(values: array(dtype=int32), rows: array(dtype=int32), out: array(dtype=int32)):
    i = tid()
    out[i] = values[rows[i]]


def exclusive_scan(counts: Integers, largest: int = MAX_COUNT) -> tuple[Integers, int]:
    """(offsets (n + 1), total): exclusive prefix sums of int32 counts of at most `largest`. One sync. Raises ValueError
    above 2^31 - 1."""
    if counts.device.is_cpu:
        is_bounded, offsets = counts.size * largest <= MAX_COUNT, offsets_of(counts)
        return offsets, _checked(int(download(offsets)[-1] if is_bounded else download(counts).sum(dtype=np.int64)))
    offsets, parts = scan_unread(counts, largest)
    return offsets, _checked(total_of(download(parts)))  # sync


def scan_unread(counts: Integers, largest: int = MAX_COUNT) -> tuple[Integers, Integers | LongIntegers]:
    """As `exclusive_scan` without sync: the offsets, and parts for `total_of`. Offsets are invalid above 2^31 - 1."""
    device, n = counts.device, counts.size
    if n * largest <= MAX_COUNT:  # the last offset is the total
        offsets = offsets_of(counts)
        return offsets, rows_of(offsets, n, n + 1)
    if device.is_cpu:
        return offsets_of(counts), upload(download(counts).sum(dtype=np.int64, keepdims=True), int64, device)
    runs, offsets = Runs(n, device, RUN_COUNTS), empty(n + 1, int32, device)
    parts = zeros(runs.rows, int64, device)
    launch(start_offsets_kernel, runs.threads, [counts, runs, parts, offsets])
    inclusive_scan(counts, rows_of(offsets, 1, n + 1))
    return offsets, parts


def total_of(parts: np.ndarray) -> int:
    """The sum from the parts that the host has read."""
    return int(parts.sum())


def scan_two(counts: Integers, largest: int = MAX_COUNT) -> tuple[Integers, int, int]:
    """As `exclusive_scan` of counts (2 n): (offsets (2 n + 1), sum of the first half, total)."""
    device, n, middle = counts.device, counts.size, counts.size // 2
    if device.is_cpu or n * largest > MAX_COUNT:
        offsets, total = exclusive_scan(counts, largest)
        return offsets, int(download(offsets[middle : middle + 1])[0]), total  # sync
    buffer = zeros(n + 2, int32, device)  # the offsets, and the middle one again
    if n:
        inclusive_scan(counts, rows_of(buffer, 1, n + 1))
    copy(buffer, rows_of(buffer, middle, middle + 1), count=1, offset=n + 1)
    total, first = download(rows_of(buffer, n, n + 2)).tolist()  # sync
    return rows_of(buffer, 0, n + 1), first, total


def offsets_of(counts: Integers) -> Integers:
    """Offsets only, without sync, if the sum is known to be below 2^31."""
    if counts.device.is_cpu:
        offsets = empty(counts.size + 1, int32, counts.device)
        host = host_view(offsets)
        host[0] = 0
        np.cumsum(download(counts), out=host[1:], dtype=np.int32)
        return offsets
    offsets = zeros(counts.size + 1, int32, counts.device)
    if counts.size:
        inclusive_scan(counts, rows_of(offsets, 1, offsets.size))
    return offsets


def scan_together(
    parts: Sequence[tuple[Integers, Sequence[int]]], beside: Integers | None = None, *, largest: int
) -> list[tuple[Integers, list[int]]]:
    """As `exclusive_scan` of several arrays with one sync. `parts`: (counts, positions whose offsets the host needs, at
    last n). `beside`: an int32 array to read too. Returns (offsets (n + 1), host offsets) per part, then (`beside`,
    its values).
    """
    others = [] if beside is None else [(beside, range(beside.size))]
    if parts[0][0].device.is_cpu:
        every = [*((exclusive_scan(counts, largest)[0], at) for counts, at in parts), *others]
        return [(values, download(values)[list(at)].tolist()) for values, at in every]
    scans = [scan_unread(counts, largest) for counts, _ in parts]
    arrays = [*(offsets for offsets, _ in scans), *(values for values, _ in others)]
    positions = [at for _, at in (*parts, *others)]
    unbounded = [totals for _, totals in scans if totals.dtype is int64]  # the others are the last offsets
    host, *read = read_together([_gather(arrays, positions), *unbounded])  # sync
    for totals in read:
        _checked(total_of(totals))
    ends = itertools.pairwise(itertools.accumulate(map(len, positions), initial=0))
    return [(values, host[first:last].tolist()) for values, (first, last) in zip(arrays, ends, strict=True)]


def _gather(arrays: Sequence[Integers], positions: Sequence[Sequence[int]]) -> Integers:
    """Elements of several GPU arrays at some positions."""
    device, first = arrays[0].device, 0
    is_run = [isinstance(at, range) or len(at) == 1 for at in positions]
    wanted = None if all(is_run) else upload(np.concatenate(positions), int32, device)
    gathered = empty(sum(map(len, positions)), int32, device)
    for values, at, run in zip(arrays, positions, is_run, strict=True):
        last = first + len(at)
        if run:
            copy(gathered, rows_of(values, at[0], at[-1] + 1), count=len(at), offset=first)
        else:
            arguments = [values, rows_of(wanted, first, last), rows_of(gathered, first, last)]
            launch(gather_int_kernel, len(at), arguments)
        first = last
    return gathered


def _checked(total: int) -> int:
    if total > MAX_COUNT:
        raise ValueError(f"{total} results are more than 2^31 - 1; ask for fewer at a time")
    return total


def inclusive_scan(counts: Array, sums: Array) -> None:
    """sums[i] = counts[0] + ... + counts[i]; int32 device arrays (n), which may be the same.

    On CUDA Warp's scan releases its scratch on the legacy stream. Where that does not wait for the current stream,
    another stream could get the memory before the scan has run, so tiles are scanned there. One tile is one launch.
    """
    if counts.device.is_cuda and (counts.size <= TILE_COUNTS or not is_blocking(counts.device)):
        TileScan(counts.size, counts.device).run(counts, sums, counts.size)
        return
    with lock_for(counts.device), counts.device.context_guard:  # Warp scans on the current GPU
        if not device_copies.is_scanned(counts, sums):
            wp.utils.array_scan(counts, sums, inclusive=True)


def sum_counts(counts: Integers) -> int:
    """Sum of an int32 device array in 64 bits, since 32 could overflow."""
    return sum_each(counts)[0]  # sync


def sum_each(*counts: Integers) -> list[int]:
    """As `sum_counts` of several arrays of one size. One sync for all."""
    device = counts[0].device
    if device.is_cpu and counts[0].size <= FEW_COUNTS:
        return [int(download(part).sum(dtype=np.int64)) for part in counts]
    runs = Runs(counts[0].size, device, RUN_COUNTS)
    totals = zeros(len(counts) * runs.rows, int64, device)
    for k, part in enumerate(counts):
        launch(sum_counts_kernel, runs.threads, [part, runs, totals[k * runs.rows : (k + 1) * runs.rows]])
    return download(totals).reshape(-1, runs.rows).sum(axis=1).tolist()  # sync
