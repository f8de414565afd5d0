"""Quantiles and medians on a device: NumPy's of the numbers that count, to the last bit."""

import numpy as np
import pytest

from pointloom.kernels.arrays.quantiles import median_above_zero, quantiles_of
from pointloom.kernels.lang import float64
from pointloom.kernels.memory import upload

SHARES = (0.0, 0.02, 0.3, 0.5, 0.98, 1.0)


def numbers(count, seed=0):
    rng = np.random.default_rng(seed)
    values = np.abs(rng.normal(size=count)) * 10.0 ** rng.integers(-300, 300, count)
    values[rng.random(count) < 0.2] = 0.25
    values[rng.random(count) < 0.05] = 5e-324
    return values


@pytest.mark.parametrize("count", [1, 2, 3, 4, 7, 100, 1023])
def test_quantiles_are_bitwise_identical_to_numpy(device, count):
    values = numbers(count, count)
    quantiles = quantiles_of(upload(values, float64, device), SHARES)
    assert quantiles == np.quantile(values, SHARES).tolist()


@pytest.mark.parametrize("count", [1, 2, 3, 4, 7, 100, 1023])
def test_a_median_is_bitwise_identical_to_numpy(device, count):
    values = numbers(count, count)
    median = median_above_zero(upload(values, float64, device))
    assert median == np.median(values)


def test_non_finite_values_are_ignored(device):
    values = numbers(200)
    mixed = values.copy()
    mixed[::3], mixed[1::9], mixed[2::9] = np.nan, np.inf, 0.0
    device_values = upload(mixed, float64, device)
    finite = mixed[np.isfinite(mixed)]
    assert quantiles_of(device_values, SHARES) == np.quantile(finite, SHARES).tolist()
    assert median_above_zero(device_values) == np.median(finite[finite > 0])


@pytest.mark.parametrize("values", [[], [np.nan, np.inf]])
def test_without_a_number_there_is_no_quantile(device, values):
    device_values = upload(np.array(values), float64, device)
    assert quantiles_of(device_values, SHARES) == [] and median_above_zero(device_values) is None
