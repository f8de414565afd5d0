"""Prefix sums equal NumPy's, and raise an error on 32-bit overflow."""

import numpy as np
import pytest

from pointloom.kernels.arrays.prefix_sum import RUN, exclusive_scan, offsets_of, scan_two, sum_counts
from pointloom.kernels.lang import int32
from pointloom.kernels.memory import upload


@pytest.mark.parametrize("size", [0, 1, 2, RUN - 1, RUN, RUN + 1, 3 * RUN + 7])
def test_offsets_are_the_exclusive_sums(device, size, rng):
    counts = rng.integers(0, 50, size).astype(np.int32)
    offsets, total = exclusive_scan(upload(counts, int32, device))
    np.testing.assert_array_equal(offsets.numpy(), np.concatenate([[0], np.cumsum(counts)]))
    assert total == counts.sum()
    np.testing.assert_array_equal(offsets_of(upload(counts, int32, device)).numpy(), offsets.numpy())


@pytest.mark.parametrize("counts", [[2**31 - 1, 1], [2**31 - 1] * 3, [2**30] * 4, [2**20] * 2**12])
def test_an_overflow_of_32_bits_is_an_error(device, counts):
    """Three times 2^31 - 1 wraps round to a positive number, and four times 2^30 to zero."""
    array = upload(np.array(counts, np.int32), int32, device)
    assert sum_counts(array) == sum(counts)
    with pytest.raises(ValueError, match=rf"{sum(counts)} results are more than 2\^31 - 1"):
        exclusive_scan(array)


def test_a_sum_of_exactly_the_largest_number_is_taken(device):
    offsets, total = exclusive_scan(upload(np.array([2**31 - 2, 0, 1], np.int32), int32, device))
    assert total == 2**31 - 1 and offsets.numpy().tolist() == [0, 2**31 - 2, 2**31 - 2, 2**31 - 1]


@pytest.mark.parametrize("half", [0, 1, 37, RUN, 100_003])
def test_counts_of_two_kinds_are_scanned_together(device, rng, half):
    counts = rng.integers(0, 9, 2 * half).astype(np.int32)
    offsets, first, total = scan_two(upload(counts, int32, device))
    np.testing.assert_array_equal(offsets.numpy(), np.concatenate([[0], np.cumsum(counts)]))
    assert (first, total) == (counts[:half].sum(), counts.sum())


def test_a_sum_beyond_32_bits_of_two_kinds_is_refused(device):
    with pytest.raises(ValueError, match="more than 2\\^31 - 1"):
        scan_two(upload(np.array([2**31 - 2, 2], np.int32), int32, device))
