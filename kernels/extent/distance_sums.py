"""Sums over distances: how many are finite, their total, the largest, and how many are below some radii."""

from collections.abc import Sequence

import numpy as np

from ..array_types import Doubles
from ..arrays.runs import Runs, elements_of, row_of
from ..arrays.side_by_side import part_of
from ..lang import array, atomic_add, atomic_max, float64, int32, isfinite, kernel, launch, reduce, tid
from ..memory import copy, download, upload, zeros
from ..search.neighbor_distances import count_sum, sum_finite

RUN = 4096  # distances a thread on the CPU: few atomics a run
DOUBLE = 8  # bytes


@kernel
def count_below_kernel(
    distances: array(dtype=float64),
    runs: Runs,
    radii: array(dtype=float64),
    within: array(dtype=int32),
    largest: array(dtype=float64),
):
    """How many distances of a row's threads are below each radius, and the largest finite one.

    Sums of whole numbers and a maximum: the same in any order.
    """
    i = tid()
    row = row_of(i, runs)
    most = float64(0.0)
    for j in elements_of(i, runs):
        d = distances[j]
        if isfinite(d):
            most = max(most, d)
    atomic_max(largest, row, most)
    for r in range(radii.shape[0]):
        count = 0
        for j in elements_of(i, runs):
            if distances[j] < radii[r]:
                count += 1
        atomic_add(within, row * radii.shape[0] + r, count)


def summarize_distances(distances: Doubles, radii: Sequence[float]) -> tuple[int, float, float, np.ndarray]:
    """(finite distances, their sum, the largest, how many are below each radius as int64 [r]); one sync."""
    device, n = distances.device, distances.size
    runs, limits = Runs(n, device, RUN), upload(np.array(radii), float64, device)
    rows, counts = runs.rows, runs.rows * len(radii)
    whole = zeros(2 + rows + (counts + 1) // 2, float64, device)  # in one array, so that one copy brings all of it
    copy(part_of(whole, 0, count_sum, 1), reduce(sum_finite, n, [distances]), count=1)
    within = part_of(whole, (2 + rows) * DOUBLE, int32, counts)
    launch(count_below_kernel, runs.threads, [distances, runs, limits, within, whole[2 : 2 + rows]])
    found = download(whole)  # sync
    below = found[2 + rows :].view(np.int32)[:counts].reshape(rows, len(radii)).sum(axis=0, dtype=np.int64)
    return int(found[0]), float(found[1]), float(found[2 : 2 + rows].max()), below
