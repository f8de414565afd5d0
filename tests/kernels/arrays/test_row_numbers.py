"""Rows named by number: their limits, those from the end, pairs."""

import numpy as np
import pytest

from pointloom.kernels.arrays.row_numbers import distinct_pairs, limits_of, list_partners, pair_up, resolve_rows
from pointloom.kernels.lang import int32, int64
from pointloom.kernels.memory import download, empty, upload


@pytest.mark.parametrize("count", [1, 2, 257, 5000])
def test_limits_are_those_of_numpy(rng, device, count):
    numbers = rng.integers(-(2**62), 2**62, count)
    given = upload(numbers, int64, device)
    assert limits_of(given) == (numbers.min(), numbers.max())
    if count > 1:
        assert limits_of(given, 1, 2) == (numbers[1::2].min(), numbers[1::2].max())


def test_numbers_below_zero_count_from_the_end(device):
    rows = resolve_rows(upload(np.array([0, -1, 6, -7]), int64, device), 7)
    assert download(rows).tolist() == [0, 6, 6, 0]


@pytest.mark.parametrize("count", [0, 1, 3000])
def test_distinct_pairs_are_those_of_numpy(rng, device, count):
    pairs = rng.integers(0, 40, (count, 2)).astype(np.int32)
    if count:
        pairs[0] = 2**31 - 1, 2**31 - 2
    result = download(distinct_pairs(upload(pairs, int32, device)))
    np.testing.assert_array_equal(result.reshape(-1, 2), np.unique(pairs, axis=0))


def test_partners_are_listed_by_row(rng, device):
    rows = rng.permutation(500)[:300].astype(np.int32)
    partners = rng.integers(-1, 50, 300).astype(np.int32)
    labels = rng.permutation(50).astype(np.int32)
    order = np.argsort(rows)
    order = order[partners[order] >= 0]
    for names in (np.zeros(0, np.int32), labels):
        expected = partners[order] if not len(names) else names[partners[order]]
        given = [upload(values, int32, device) for values in (rows, partners, names)]
        np.testing.assert_array_equal(download(list_partners(500, *given)), np.column_stack([rows[order], expected]))


def test_two_columns_make_pairs(device):
    left, right = upload(np.arange(5), int32, device), upload(np.arange(5, 10), int32, device)
    assert download(pair_up(left, right))[3].tolist() == [3, 8]
    assert pair_up(empty(0, int32, device), empty(0, int32, device)).shape == (0, 2)
