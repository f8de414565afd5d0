"""Stable sorting, sorting of pairs, and unique keys with their counts: those of NumPy."""

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from pointloom.kernels.arrays import sort
from pointloom.kernels.arrays.pair_sort import MAX_BUCKET_PAIRS, MIN_PAIRS, argsort_pairs
from pointloom.kernels.arrays.sort import MIN_RUN, argsort_keys
from pointloom.kernels.arrays.unique import UniqueKeys, cut_together
from pointloom.kernels.lang import int32, int64
from pointloom.kernels.memory import download, upload

SIZES = [0, 1, 2, 255, 256, 257, sort.MAX_RANKED_KEYS, sort.MAX_RANKED_KEYS + 1, 70_001]


def assert_sorted_stably(device, keys, bits, starts=None):
    original = upload(keys, int64, device)
    sorted_keys, order = argsort_keys(original, bits, starts)
    expected = np.argsort(keys, kind="stable")
    np.testing.assert_array_equal(order.numpy(), expected)
    np.testing.assert_array_equal(sorted_keys.numpy(), keys[expected])
    np.testing.assert_array_equal(original.numpy(), keys)


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("bits", [1, 8, 33, 46, 47, 62, 63])
def test_keys_are_sorted_stably(device, size, bits, rng):
    """On the CPU up to 46 bits of the largest size are packed with the positions, more are sorted by Warp."""
    assert_sorted_stably(device, rng.integers(0, 2**bits, size, dtype=np.int64), bits)


@pytest.mark.parametrize("min_radix_keys", [0, 1 << 20])
def test_many_keys_are_sorted_alike_by_numpy_and_by_the_radix_sort(min_radix_keys, rng, monkeypatch):
    monkeypatch.setattr(sort, "MIN_RADIX_KEYS", min_radix_keys)
    for bits in (1, 9, 40):
        assert_sorted_stably("cpu", rng.integers(0, 2**bits, 70_001, dtype=np.int64), bits)


@pytest.mark.parametrize(("count", "blocks"), [(1, 1), (100, 1), (101, 2), (700, 7), (701, 7), (705, 7), (5000, 7)])
def test_the_radix_sort_has_few_blocks_of_many_keys(rng, monkeypatch, count, blocks):
    """At most 7 blocks, of at least 100 keys: the counts of digits, 1 KB a block, do not grow with the keys."""
    monkeypatch.setattr(sort, "MIN_BLOCK_KEYS", 100)
    monkeypatch.setattr(sort, "MAX_BLOCKS", 7)
    launched, launch = [], sort.launch
    monkeypatch.setattr(
        sort, "launch", lambda kernel, n, given: (launched.append((kernel, n)), launch(kernel, n, given))
    )
    keys = rng.integers(0, 2**9, count, dtype=np.int64)
    sorted_keys, order = sort.radix_argsort(upload(keys, int64, "cpu"), 9, max(1, (count - 1).bit_length()))
    np.testing.assert_array_equal(order.numpy(), np.argsort(keys, kind="stable"))
    np.testing.assert_array_equal(sorted_keys.numpy(), np.sort(keys))
    assert [n for kernel, n in launched if kernel is sort.count_digits_kernel] == [blocks] * 2


@pytest.mark.parametrize("mean", [MIN_RUN // 4, MIN_RUN, 2000])
def test_runs_of_separate_keys_are_sorted_stably(device, mean, rng):
    sizes = rng.integers(0, 2 * mean + 1, 20)  # some may be empty
    sizes[[3, 19]] = 0
    runs = np.repeat(np.arange(20), sizes)
    starts = np.concatenate([[0], np.cumsum(sizes)])
    assert_sorted_stably(device, runs << 20 | rng.integers(0, 50, len(runs)), 25, starts)


@settings(derandomize=True, deadline=None, max_examples=60, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(keys=arrays(np.int64, st.integers(0, 60), elements=st.integers(0, 2**63 - 1) | st.integers(0, 5)))
def test_any_keys_are_sorted_stably(device, keys):
    assert_sorted_stably(device, keys, 63)
    assert_sorted_stably(device, keys & 255, 8)


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
    keys = np.concatenate([keys, np.full(MAX_BUCKET_PAIRS - 4 + more, 7)])
    keys = (rng.permutation(keys) << 3) | rng.integers(0, 8, len(keys))
    _, order = argsort_pairs(upload(keys, int64, device), 3, MIN_PAIRS)
    np.testing.assert_array_equal(download(order), np.argsort(keys, kind="stable"))


@pytest.mark.parametrize("count", [0, 1, 2, 1000])
def test_unique_keys_have_numpys_counts_and_stable_positions(device, rng, count):
    keys = rng.integers(0, 40, count)
    unique = UniqueKeys(upload(keys, int64, device))
    expected, counts = np.unique(keys, return_counts=True)
    assert (download(unique.keys) == expected).all() and (download(unique.counts()) == counts).all()
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
    assert unique.count in (len(expected), count) and (download(unique.keys)[: len(expected)] == expected).all()
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
    assert download(unique.keys).tolist() == [5] and download(unique.starts).tolist() == [0, 2]
