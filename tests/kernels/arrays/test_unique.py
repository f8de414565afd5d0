"""Unique keys and their counts agree with NumPy."""

import numpy as np
import pytest

from pointloom.kernels.arrays.unique import UniqueKeys, cut_together
from pointloom.kernels.lang import int32, int64
from pointloom.kernels.memory import download, upload


@pytest.mark.parametrize("count", [0, 1, 2, 1000])
def test_unique_keys_have_numpys_counts_and_stable_positions(device, rng, count):
    keys = rng.integers(0, 40, count)
    unique = UniqueKeys(upload(keys, int64, device))
    expected, counts = np.unique(keys, return_counts=True)
    assert (download(unique.keys) == expected).all()
    assert (download(unique.counts()) == counts).all()
    assert (download(unique.order) == np.argsort(keys, kind="stable")).all()
    assert download(unique.starts).tolist() == [0, *np.cumsum(counts)]


@pytest.mark.parametrize("count", [0, 1, 500])
def test_numbers_come_to_the_host_beside_the_count(device, rng, count):
    keys = rng.integers(0, 40, count)
    unique = UniqueKeys(upload(keys, int64, device), 6, beside=upload(np.array([7, -3]), int32, device))
    assert unique.beside == [7, -3] and unique.count == len(np.unique(keys))
    unique.drop_last(int(keys.max(initial=0)))
    assert unique.count == max(len(np.unique(keys)) - 1, 0)


@pytest.mark.parametrize("count", [0, 1, 500])
def test_padding_has_no_positions(device, rng, count):
    keys = rng.integers(0, 40, count)
    unique = UniqueKeys(upload(keys, int64, device), 6, padded=True)
    expected, counts = np.unique(keys, return_counts=True)
    assert unique.count in (len(expected), count)
    assert (download(unique.keys)[: len(expected)] == expected).all()
    starts = download(unique.starts)
    assert starts.tolist() == [0, *np.cumsum(counts), *[count] * (unique.count - len(expected))]


def test_padded_keys_are_cut_to_the_existing_ones(device, rng):
    lists = [rng.integers(0, 40, count) for count in (500, 1, 0, 60)]
    groups = [UniqueKeys(upload(keys, int64, device), 6, padded=True) for keys in lists]
    (result,) = cut_together(groups, upload(np.array([7, -3]), int32, device))
    assert result.tolist() == [7, -3]
    for keys, group in zip(lists, groups, strict=True):
        expected, counts = np.unique(keys, return_counts=True)
        assert group.count == len(expected) and group.summary is None
        assert (download(group.keys) == expected).all() and (download(group.counts()) == counts).all()


def test_the_last_key_is_dropped_only_where_it_is_the_one_named(device):
    keys = upload(np.array([5, 9, 5]), int64, device)
    unique = UniqueKeys(keys)
    unique.drop_last(7)
    assert download(unique.keys).tolist() == [5, 9]
    unique.drop_last(9)
    assert download(unique.keys).tolist() == [5]
    assert download(unique.starts).tolist() == [0, 2]
