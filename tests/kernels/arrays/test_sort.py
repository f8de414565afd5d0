"""Stable sorting: what NumPy gives, on every device, to the last element."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from pointloom.kernels.arrays import sort
from pointloom.kernels.arrays.sort import MIN_RUN, argsort_keys
from pointloom.kernels.lang import int64
from pointloom.kernels.memory import upload

SIZES = [0, 1, 2, 255, 256, 257, 70_001]


def assert_sorted_stably(device, keys, bits, starts=None):
    sorted_keys, order = argsort_keys(upload(keys, int64, device), bits, starts)
    expected = np.argsort(keys, kind="stable")
    np.testing.assert_array_equal(order.numpy(), expected)
    np.testing.assert_array_equal(sorted_keys.numpy(), keys[expected])


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("bits", [1, 8, 33, 46, 47, 62, 63])
def test_keys_are_sorted_stably(device, size, bits, rng):
    """On the CPU up to 46 bits of the largest size are packed with the positions, more are sorted by Warp."""
    assert_sorted_stably(device, rng.integers(0, 2**bits, size, dtype=np.int64), bits)


@pytest.mark.parametrize("seconds", [0.0, 1.0])
def test_many_keys_are_sorted_alike_by_numpy_and_by_the_radix_sort(seconds, rng, monkeypatch):
    monkeypatch.setattr(sort, "numpy_seconds", lambda: seconds)
    for bits in (1, 9, 40):
        assert_sorted_stably("cpu", rng.integers(0, 2**bits, 70_001, dtype=np.int64), bits)


@pytest.mark.parametrize("mean", [MIN_RUN // 4, MIN_RUN, 2000])
def test_runs_of_separate_keys_are_sorted_stably(device, mean, rng):
    sizes = rng.integers(0, 2 * mean + 1, 20)  # some may be empty
    sizes[[3, 19]] = 0
    runs = np.repeat(np.arange(20), sizes)
    starts = np.concatenate([[0], np.cumsum(sizes)])
    assert_sorted_stably(device, runs << 20 | rng.integers(0, 50, len(runs)), 25, starts)


@pytest.mark.parametrize("bits", [10, 63])
def test_keys_already_in_order_reversed_and_all_equal_are_sorted_stably(device, bits):
    rising = np.arange(1000, dtype=np.int64)
    for keys in (rising, rising[::-1].copy(), np.full(1000, 2**bits - 1), np.repeat(rising[:10][::-1], 100)):
        assert_sorted_stably(device, keys, bits)


def test_sorting_leaves_the_keys_as_they_are(device, rng):
    for bits in (20, 63):
        keys = rng.integers(0, 2**bits, 500, dtype=np.int64)
        array = upload(keys, int64, device)
        argsort_keys(array, bits)
        np.testing.assert_array_equal(array.numpy(), keys)


@settings(derandomize=True, deadline=None, max_examples=60)
@given(keys=arrays(np.int64, st.integers(0, 60), elements=st.integers(0, 2**63 - 1) | st.integers(0, 5)))
def check_any_keys(device, keys):
    assert_sorted_stably(device, keys, 63)
    assert_sorted_stably(device, keys & 255, 8)


def test_any_keys_are_sorted_stably(device):
    check_any_keys(device)
