"""Statistics of distances: finite count, sum, maximum, and counts below some radii."""

from collections.abc import Sequence

import numpy as np

from ..array_types import Doubles
from ..arrays.row_atomics import add_int, raise_double
from ..arrays.runs import Runs, elements_of, row_of
from ..arrays.side_by_side import part_of
from ..lang import array, float64, int32, isfinite, kernel, launch, reduce, tid
from ..memory import copy, download, upload, zeros
from ..search.neighbor_distances import count_sum, sum_finite

DISTANCES_PER_THREAD = 4096  # on the CPU: few atomics
FLOAT64_BYTES = 8


@kernel
def count_below_kernel(
    distances: array(dtype=float64),
    runs: Runs,
    radii: array(dtype=float64),
    within: array(dtype=int32),
    largest: array(dtype=float64),
):
    i = tid()
    row = row_of(i, runs)
    maximum = float64(0.0)
    for j in elements_of(i, runs):
        d = distances[j]
        if isfinite(d):
            maximum = max(maximum, d)
    raise_double(largest, row, maximum)
    for r in range(radii.shape[0]):
        count = 0
        for j in elements_of(i, runs):
            if distances[j] < radii[r]:
                count += 1
        add_int(within, row * radii.shape[0] + r, count)


class DistanceSums:
    """Statistics on the device: `buffer` float64, all of them for `unpack`; `largest`, the part with the maxima."""

    def __init__(self, distances: Doubles, radii: Sequence[float]) -> None:
        device, n = distances.device, distances.size
        runs, limits = Runs(n, device, DISTANCES_PER_THREAD), upload(np.array(radii), float64, device)
        self._rows, self._radii = runs.rows, len(radii)
        counts = self._rows * self._radii
        self.buffer = zeros(2 + self._rows + (counts + 1) // 2, float64, device)
        copy(part_of(self.buffer, 0, count_sum, 1), reduce(sum_finite, n, [distances]), count=1)
        within = part_of(self.buffer, (2 + self._rows) * FLOAT64_BYTES, int32, counts)
        self.largest = self.buffer[2 : 2 + self._rows]
        launch(count_below_kernel, runs.threads, [distances, runs, limits, within, self.largest])

    def unpack(self, values: np.ndarray) -> tuple[int, float, float, np.ndarray]:
        end = 2 + self._rows
        counts = values[end:].view(np.int32)[: self._rows * self._radii].reshape(self._rows, self._radii)
        return int(values[0]), float(values[1]), float(values[2:end].max()), counts.sum(axis=0, dtype=np.int64)


def summarize_distances(distances: Doubles, radii: Sequence[float]) -> tuple[int, float, float, np.ndarray]:
    """(finite count, sum, maximum, counts below each radius as int64 (r)). One sync."""
    sums = DistanceSums(distances, radii)
    return sums.unpack(download(sums.buffer))  # sync
