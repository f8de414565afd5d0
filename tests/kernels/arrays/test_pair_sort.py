"""Pairs of small numbers are ordered as a stable sort of their keys orders them."""

import numpy as np
import pytest

from pointloom.kernels.arrays.pair_sort import LONGEST, MIN_PAIRS, argsort_pairs
from pointloom.kernels.lang import int64
from pointloom.kernels.memory import download, upload


@pytest.mark.parametrize("bits", [0, 14])
@pytest.mark.parametrize("size", [0, 1, 100, MIN_PAIRS, MIN_PAIRS + 1])
def test_the_order_is_that_of_a_stable_sort(rng, device, size, bits):
    count = 9000
    firsts = rng.integers(0, count - 1, size)  # the last number is unused
    keys = (firsts.astype(np.int64) << bits) | rng.integers(0, 1 << bits, size)
    ordered, order = argsort_pairs(upload(keys, int64, device), bits, count)
    expected = np.argsort(keys, kind="stable")
    np.testing.assert_array_equal(download(order), expected)
    np.testing.assert_array_equal(download(ordered), keys[expected])


@pytest.mark.parametrize("more", [0, 1])
def test_many_pairs_of_one_first_number_are_ordered_too(rng, device, more):
    keys = np.repeat(np.arange(MIN_PAIRS // 4, dtype=np.int64), 4)
    keys = np.concatenate([keys, np.full(LONGEST - 4 + more, 7)])
    keys = (rng.permutation(keys) << 3) | rng.integers(0, 8, len(keys))
    _, order = argsort_pairs(upload(keys, int64, device), 3, MIN_PAIRS)
    np.testing.assert_array_equal(download(order), np.argsort(keys, kind="stable"))
