"""Rows that are resolved in rounds."""

import numpy as np
import pytest

from pointloom.core.devices import resolve_device
from pointloom.kernels.arrays.open_rows import CHECKED_ROUNDS, ROUNDS, resolve_in_rounds
from pointloom.kernels.lang import array, int32, kernel, launch, tid, uint8
from pointloom.kernels.memory import download, upload


@kernel
def wait_some_rounds_kernel(rows: array(dtype=int32), left: array(dtype=int32), open_rows: array(dtype=uint8)):
    i = tid()
    left[rows[i]] = left[rows[i]] - 1
    open_rows[i] = uint8(1 if left[rows[i]] > 0 else 0)


@pytest.mark.parametrize("max_rounds", [1, 3, 5, ROUNDS, ROUNDS + 3])
def test_remaining_rows_are_those_that_need_more_rounds(device, rng, max_rounds):
    round_counts = rng.integers(1, max_rounds + 1, 200)
    round_counts[17] = max_rounds
    warp_device, sizes = resolve_device(device), []
    left = upload(round_counts, int32, warp_device)

    def attempt(rows, open_rows):
        sizes.append(rows.size)
        launch(wait_some_rounds_kernel, rows.size, [rows, left, open_rows])

    remaining = resolve_in_rounds(attempt, len(round_counts), warp_device)
    assert download(remaining).tolist() == np.flatnonzero(round_counts > ROUNDS).tolist()
    looks = range(1, ROUNDS + 1) if warp_device.is_cpu else CHECKED_ROUNDS
    assert len(sizes) == next(look for look in looks if look >= min(max_rounds, ROUNDS))
    assert sizes[0] == 200 and sizes[-1] == (round_counts > max([0, *(n for n in looks if n < len(sizes))])).sum()
