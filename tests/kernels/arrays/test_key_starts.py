"""Where each number begins in sorted keys."""

import numpy as np
import pytest

from pointloom.kernels.arrays.key_starts import find_key_starts
from pointloom.kernels.lang import int32, int64
from pointloom.kernels.memory import download, empty, upload


@pytest.mark.parametrize("count", [0, 1, 1000])
def test_starts_are_those_of_numpy_with_numbers_that_no_key_has(device, rng, count):
    keys = np.sort(rng.integers(0, 60, count))
    starts = empty(66, int32, device)
    find_key_starts(upload(keys, int64, device), starts)
    np.testing.assert_array_equal(download(starts), np.searchsorted(keys, np.arange(66), side="left"))
