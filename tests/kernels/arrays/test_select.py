"""Rows by a mask and by a list: what NumPy gives."""

import numpy as np
import pytest

from pointloom.kernels.arrays.select import gather_rows, positions_of
from pointloom.kernels.lang import float32, float64, int32, int64, uint8, uint16, vec3
from pointloom.kernels.memory import upload


@pytest.mark.parametrize("size", [0, 1, 2, 255, 256, 257, 70_001])
@pytest.mark.parametrize("share", [0.0, 0.3, 1.0])
def test_positions_of_a_mask_are_those_of_flatnonzero(device, size, share, rng):
    mask = (rng.random(size) < share).astype(np.uint8) * rng.integers(1, 256, size).astype(np.uint8)
    result = positions_of(upload(mask, uint8, device))
    assert result.dtype == int32
    np.testing.assert_array_equal(result.numpy(), np.flatnonzero(mask))


@pytest.mark.parametrize(
    ("dtype", "shape"),
    [(float32, (90,)), (float64, (90, 2)), (uint16, (90, 5)), (uint8, (90,)), (int64, (90,)), (vec3, (90, 3))],
)
def test_gathered_rows_are_the_rows(device, dtype, shape, rng):
    values = rng.integers(0, 200, shape)
    rows = rng.integers(0, 90, 400).astype(np.int32)
    for chosen in (rows, rows[:0]):
        gathered = gather_rows(upload(values, dtype, device), upload(chosen, int32, device))
        assert gathered.dtype == dtype
        np.testing.assert_array_equal(gathered.numpy().reshape(len(chosen), *shape[1:]), values[chosen])
