"""Arrays that come to the host together are those that come one by one."""

import numpy as np
import pytest

from pointloom.kernels.arrays.side_by_side import read_together
from pointloom.kernels.lang import float64, int32, uint8, vec3
from pointloom.kernels.memory import download, upload


@pytest.mark.parametrize("count", [0, 1, 77])
def test_each_has_its_type_its_shape_and_its_numbers(device, rng, count):
    matrix = upload(rng.normal(size=(max(count, 2), 6)), float64, device)
    arrays = [
        upload(rng.integers(0, 99, count), int32, device),
        upload(rng.normal(size=(count, 3)), vec3, device),
        matrix,
        matrix[:, 1],  # with gaps
        upload(rng.integers(0, 2, count), uint8, device),
    ]
    for read, values in zip(read_together(arrays), arrays, strict=True):
        alone = download(values)
        assert (read.dtype, read.shape) == (alone.dtype, alone.shape)
        np.testing.assert_array_equal(read, alone)
