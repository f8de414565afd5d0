"""Rows that are settled in rounds."""

import numpy as np
import pytest

from pointloom.core.devices import resolve_device
from pointloom.kernels.arrays.open_rows import CHECKED_ROUNDS, ROUNDS, resolve_in_rounds
from pointloom.kernels.lang import array, int32, kernel, launch, tid, uint8
from pointloom.kernels.memory import download, upload


@kernel
def wait_some_rounds_kernel(rows: array(dtype=int32), left: array(dtype=int32), open_rows: array(dtype=uint8)):
    """A row is settled after as many rounds as are left to it."""
    i = tid()
    left[rows[i]] = left[rows[i]] - 1
    open_rows[i] = uint8(1 if left[rows[i]] > 0 else 0)


@pytest.mark.parametrize("most", [1, 3, 5, ROUNDS, ROUNDS + 3])
def test_the_rows_that_are_left_are_those_that_want_more_rounds(device, rng, most):
    wanted = rng.integers(1, most + 1, 200)
    wanted[17] = most
    home, turns = resolve_device(device), []
    left = upload(wanted, int32, home)

    def attempt(rows, open_rows):
        turns.append(rows.size)
        launch(wait_some_rounds_kernel, rows.size, [rows, left, open_rows])

    found = resolve_in_rounds(attempt, len(wanted), home)
    assert download(found).tolist() == np.flatnonzero(wanted > ROUNDS).tolist()
    looks = range(1, ROUNDS + 1) if home.is_cpu else CHECKED_ROUNDS
    assert len(turns) == next(look for look in looks if look >= min(most, ROUNDS))
    assert turns[0] == 200 and turns[-1] == (wanted > max([0, *(n for n in looks if n < len(turns))])).sum()
