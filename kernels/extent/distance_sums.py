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


class DistanceSums:
    """Sums over distances where they are.

    Attributes:
        whole: float64 device array, all of them: `told` makes numbers of what the host reads.
        largest: The part of it in which the largest finite distance is the greatest number; none is below zero.
    """

    def __init__(self, distances: Doubles, radii: Sequence[float]) -> None:
        device, n = distances.device, distances.size
        runs, limits = Runs(n, device, RUN), upload(np.array(radii), float64, device)
        self._rows, self._radii = runs.rows, len(radii)
        counts = self._rows * self._radii
        self.whole = zeros(2 + self._rows + (counts + 1) // 2, float64, device)
        copy(part_of(self.whole, 0, count_sum, 1), reduce(sum_finite, n, [distances]), count=1)
        within = part_of(self.whole, (2 + self._rows) * DOUBLE, int32, counts)
        self.largest = self.whole[2 : 2 + self._rows]
        launch(count_below_kernel, runs.threads, [distances, runs, limits, within, self.largest])

    def told(self, found: np.ndarray) -> tuple[int, float, float, np.ndarray]:
        """As of `summarize_distances`, of what the host has read."""
        end = 2 + self._rows
        counts = found[end:].view(np.int32)[: self._rows * self._radii].reshape(self._rows, self._radii)
        return int(found[0]), float(found[1]), float(found[2:end].max()), counts.sum(axis=0, dtype=np.int64)


def summarize_distances(distances: Doubles, radii: Sequence[float]) -> tuple[int, float, float, np.ndarray]:
    """(finite distances, their sum, the largest, how many are below each radius as int64 [r]); one sync."""
    sums = DistanceSums(distances, radii)
    return sums.told(download(sums.whole))  # sync
