"""Running sums: exact to rounding, never falling, not raised by a zero, the same bits everywhere."""

import numpy as np
import pytest

from pointloom.kernels.arrays.running_sums import running_sums
from pointloom.kernels.lang import float64
from pointloom.kernels.memory import download, upload


def sums_of(values: np.ndarray, device: str) -> np.ndarray:
    return download(running_sums(upload(values, float64, device))).copy()


@pytest.mark.parametrize("count", [0, 1, 63, 64, 65, 4097, 50_001])
def test_sums_are_those_of_exact_arithmetic(device, rng, count):
    values = rng.random(count) ** 9
    exact = np.cumsum(values.astype(np.longdouble))
    np.testing.assert_allclose(sums_of(values, device), exact.astype(float), rtol=1e-13)


def test_sums_never_fall_and_zeros_never_raise_them(device, rng):
    values = np.where(rng.random(40_000) < 0.6, 0.0, 10.0 ** rng.uniform(-18, 3, 40_000))
    values[200 * np.arange(200)] = 0.0  # the first of each run
    values[200 * np.arange(1, 200) - 1] = 0.0  # and the last
    sums = sums_of(values, device)
    steps = np.diff(sums, prepend=0.0)
    assert (steps >= 0).all()
    assert (steps[values == 0] == 0).all()


def test_the_bits_do_not_depend_on_the_device(device, rng):
    values = rng.random(5000)
    sums, total = [], 0.0
    for first in range(0, 5000, 70):  # runs of the square root of the count, one after the other
        run = values[first : first + 70]
        part = np.cumsum(run)
        sums.append(total + part)
        total = total + part[-1]
    assert sums_of(values, device).tobytes() == np.concatenate(sums).tobytes()
