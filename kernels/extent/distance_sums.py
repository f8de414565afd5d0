"""Sums over distances: how many are finite, their total, the largest, and how many are below some radii."""

import numpy as np

from ..lang import array, atomic_max, float64, int32, isfinite, kernel, launch, reduce, tid
from ..memory import download, upload, zeros
from ..search.neighbor_distances import sum_finite

RUN = 4096  # distances a thread: one atomic a run


@kernel
def count_below_kernel(
    distances: array(dtype=float64),
    run: int,
    radii: array(dtype=float64),
    within: array(dtype=int32, ndim=2),
    largest: array(dtype=float64),
):
    """How many distances of a run are below each radius; and the largest finite one of all."""
    i = tid()
    most = float64(0.0)
    for j in range(i * run, min((i + 1) * run, distances.shape[0])):
        d = distances[j]
        if isfinite(d):
            most = max(most, d)
            for r in range(radii.shape[0]):
                if d < radii[r]:
                    within[i, r] = within[i, r] + 1
    atomic_max(largest, 0, most)  # settles which run's largest is the largest


def summarize_distances(distances, radii):
    """(finite distances, their sum, the largest, how many are below each radius as int64 [r]); two syncs."""
    device, n = distances.device, distances.size
    count, total = download(reduce(sum_finite, n, [distances]))[0].tolist()  # sync
    runs = -(-n // RUN)
    within, largest = zeros((max(runs, 1), len(radii)), int32, device), zeros(1, float64, device)
    launch(count_below_kernel, runs, [distances, RUN, upload(np.array(radii), float64, device), within, largest])
    return int(count), total, float(download(largest)[0]), download(within).sum(axis=0, dtype=np.int64)  # sync
