"""Sums of counts, and exclusive prefix sums (offsets of variable-sized results)."""

from collections.abc import Sequence

import numpy as np
import warp as wp

from ..array_types import Array, Integers, LongIntegers
from ..lang import array, func, int32, int64, kernel, launch, tid
from ..language import device_copies
from ..language.device_lock import lock_for
from ..memory import download, empty, host_view, rows_of, upload, zeros
from .row_atomics import add_long
from .runs import Runs, elements_of, row_of

RUN = 4096  # counts per thread on the CPU: one atomic per run


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
def note_offsets_kernel(offsets: array(dtype=int32), indices: array(dtype=int32), copied: array(dtype=int64)):
    """Copy the offsets at some positions next to the totals for the host."""
    i = tid()
    copied[i] = int64(offsets[indices[i]])


@kernel
def copy_middle_kernel(offsets: array(dtype=int32), slot: int, totals: array(dtype=int64)):
    """Copy the middle offset next to the totals for the host."""
    i = tid()
    totals[slot + i] = int64(offsets[offsets.shape[0] // 2])


def exclusive_scan(counts: Integers) -> tuple[Integers, int]:
    """(offsets (n + 1), total): exclusive prefix sums of int32 counts. One sync. Raises ValueError above 2^31 - 1."""
    if counts.device.is_cpu:
        return offsets_of(counts), _checked(int(download(counts).sum(dtype=np.int64)))
    offsets, parts = scan_unread(counts)
    return offsets, _checked(total_of(download(parts)))  # sync


def scan_unread(counts: Integers) -> tuple[Integers, LongIntegers]:
    """As `exclusive_scan` without sync: the offsets, and parts for `total_of`. Offsets are invalid above 2^31 - 1."""
    device, n = counts.device, counts.size
    if n == 0:
        return zeros(1, int32, device), zeros(1, int64, device)
    runs = Runs(n, device, RUN)
    parts = zeros(runs.rows, int64, device)
    if device.is_cuda:
        offsets = empty(n + 1, int32, device)
        launch(start_offsets_kernel, runs.threads, [counts, runs, parts, offsets])
        inclusive_scan(counts, rows_of(offsets, 1, n + 1))
        return offsets, parts
    host_view(parts)[0] = download(counts).sum(dtype=np.int64)
    return offsets_of(counts), parts


def total_of(parts: np.ndarray) -> int:
    """The sum from the parts that the host has read."""
    return int(parts.sum())


def scan_two(counts: Integers) -> tuple[Integers, int, int]:
    """As `exclusive_scan` of counts (2 n): (offsets (2 n + 1), sum of the first half, total)."""
    n = counts.size
    if not counts.device.is_cuda or n == 0:
        offsets, total = exclusive_scan(counts)
        return offsets, int(download(offsets[n // 2 : n // 2 + 1])[0]), total
    runs, offsets = Runs(n, counts.device, RUN), empty(n + 1, int32, counts.device)
    totals = zeros(runs.rows + 1, int64, counts.device)
    launch(start_offsets_kernel, runs.threads, [counts, runs, totals, offsets])
    inclusive_scan(counts, rows_of(offsets, 1, n + 1))
    launch(copy_middle_kernel, 1, [offsets, runs.rows, totals])
    host = download(totals)  # sync
    return offsets, int(host[-1]), _checked(int(host[:-1].sum()))


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
    parts: Sequence[tuple[Integers, Sequence[int]]], beside: Integers | None = None
) -> list[tuple[Integers, list[int]]]:
    """As `exclusive_scan` of several arrays with one sync. `parts`: (counts, positions whose offsets the host needs),
    `beside`: an int32 array to read too. Returns (offsets (n + 1), host offsets) per part, then (`beside`, its values).
    """
    device = parts[0][0].device
    if not device.is_cuda:
        scans = [exclusive_scan(counts)[0] for counts, _ in parts]
        host = [(o, download(o)[list(indices)].tolist()) for o, (_, indices) in zip(scans, parts, strict=True)]
        return host if beside is None else [*host, (beside, download(beside).tolist())]
    every = [Runs(counts.size, device, RUN) for counts, _ in parts]
    sizes = [[runs.rows, len(indices)] for runs, (_, indices) in zip(every, parts, strict=True)]
    ends = np.cumsum(sizes).reshape(-1, 2).tolist()
    others = 0 if beside is None else beside.size
    wanted = upload(np.concatenate([*(indices for _, indices in parts), range(others)]), int32, device)
    copied, results, first, at = zeros(ends[-1][1] + others, int64, device), [], 0, 0
    for (counts, indices), runs, (middle, end) in zip(parts, every, ends, strict=True):
        offsets = zeros(counts.size + 1, int32, device)
        if counts.size:
            launch(start_offsets_kernel, runs.threads, [counts, runs, copied[first:middle], offsets])
            inclusive_scan(counts, rows_of(offsets, 1, offsets.size))
        if indices:
            launch(note_offsets_kernel, len(indices), [offsets, wanted[at : at + len(indices)], copied[middle:end]])
        results.append((offsets, first, middle, end))
        first, at = end, at + len(indices)
    if others:
        launch(note_offsets_kernel, others, [beside, wanted[at:], copied[first:]])
    host = download(copied)  # sync
    for _, begin, middle, _ in results:
        _checked(int(host[begin:middle].sum()))
    scanned = [(offsets, host[middle:end].tolist()) for offsets, _, middle, end in results]
    return scanned if beside is None else [*scanned, (beside, host[first:].tolist())]


def _checked(total: int) -> int:
    if total > 2**31 - 1:
        raise ValueError(f"{total} results are more than 2^31 - 1; ask for fewer at a time")
    return total


def inclusive_scan(counts: Array, sums: Array) -> None:
    """sums[i] = counts[0] + ... + counts[i] by Warp's scan on CUDA; int32 device arrays (n), which may be the same."""
    with lock_for(counts.device), counts.device.context_guard:  # Warp scans on the current GPU
        if not device_copies.is_scanned(counts, sums):
            wp.utils.array_scan(counts, sums, inclusive=True)


def sum_counts(counts: Integers) -> int:
    """Sum of an int32 device array in 64 bits, since 32 could overflow."""
    return sum_each(counts)[0]  # sync


def sum_each(*counts: Integers) -> list[int]:
    """As `sum_counts` of several arrays of one size. One sync for all."""
    runs, device = Runs(counts[0].size, counts[0].device, RUN), counts[0].device
    totals = zeros(len(counts) * runs.rows, int64, device)
    for k, part in enumerate(counts):
        launch(sum_counts_kernel, runs.threads, [part, runs, totals[k * runs.rows : (k + 1) * runs.rows]])
    return download(totals).reshape(-1, runs.rows).sum(axis=1).tolist()  # sync
