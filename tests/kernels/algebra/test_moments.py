"""Steps in which moments are whole numbers."""

import numpy as np
import pytest

from pointloom.kernels.algebra.moments import MAX_EXACT_POINTS, steps_for
from pointloom.kernels.lang import array, float32, int32, kernel, launch, tid
from pointloom.kernels.memory import download, empty, upload


@kernel
def measure_steps_kernel(sqdist: float, counts: array(dtype=int32), steps: array(dtype=float32)):
    i = tid()
    steps[i] = steps_for(sqdist, counts[i])


@pytest.mark.parametrize("sqdist", [1e-6, 1.0, 3.99, 4.0, 1e8])
def test_products_of_any_number_of_differences_fit_into_64_bits(device, sqdist):
    counts = np.array([1, MAX_EXACT_POINTS, MAX_EXACT_POINTS + 1, 2**31 - 1])
    steps = empty(len(counts), float32, device)
    launch(measure_steps_kernel, len(counts), [sqdist, upload(counts, int32, device), steps])
    result = download(steps).astype(float)
    assert (counts * (np.sqrt(sqdist) * result + 0.5) ** 2 < 2.0**63).all()
    assert result[0] == result[1] > result[2] == result[3] and np.sqrt(sqdist) * result[2] >= 2**14
