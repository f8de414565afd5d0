"""Sort, scan and compaction: what NumPy gives, on every device, to the last element."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from pointloom.kernels.arrays.bounds import RUN as BOUND_RUN
from pointloom.kernels.arrays.bounds import bound_points
from pointloom.kernels.arrays.prefix_sum import RUN, exclusive_scan, sum_counts
from pointloom.kernels.arrays.run_sums import average_vec3, first_rows, sum_columns
from pointloom.kernels.arrays.select import gather_rows, positions_of
from pointloom.kernels.arrays.sort import argsort_keys
from pointloom.kernels.lang import float32, float64, int32, int64, uint8, uint16, vec3
from pointloom.kernels.memory import download, upload
from pointloom.pcd.devices import resolve_device

SIZES = [0, 1, 2, 255, 256, 257, 70_001]


def on(device):
    return resolve_device(device)


def assert_sorted_stably(device, keys, bits):
    sorted_keys, order = argsort_keys(upload(keys, int64, on(device)), bits)
    expected = np.argsort(keys, kind="stable")
    np.testing.assert_array_equal(order.numpy(), expected)
    np.testing.assert_array_equal(sorted_keys.numpy(), keys[expected])


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("bits", [1, 8, 33, 46, 47, 62, 63])
def test_keys_are_sorted_stably(device, size, bits, rng):
    """Up to 46 bits these sizes take the packed sort on the CPU, above it the radix sort of pairs."""
    assert_sorted_stably(device, rng.integers(0, 2**bits, size, dtype=np.int64), bits)


@pytest.mark.parametrize("bits", [10, 63])
def test_keys_already_in_order_reversed_and_all_equal_are_sorted_stably(device, bits):
    rising = np.arange(1000, dtype=np.int64)
    for keys in (rising, rising[::-1].copy(), np.full(1000, 2**bits - 1), np.repeat(rising[:10][::-1], 100)):
        assert_sorted_stably(device, keys, bits)


def test_sorting_leaves_the_keys_as_they_are(device, rng):
    for bits in (20, 63):
        keys = rng.integers(0, 2**bits, 500, dtype=np.int64)
        array = upload(keys, int64, on(device))
        argsort_keys(array, bits)
        np.testing.assert_array_equal(array.numpy(), keys)


@pytest.mark.parametrize("size", [0, 1, 2, RUN - 1, RUN, RUN + 1, 3 * RUN + 7])
def test_offsets_are_the_exclusive_sums(device, size, rng):
    counts = rng.integers(0, 50, size).astype(np.int32)
    offsets, total = exclusive_scan(upload(counts, int32, on(device)))
    np.testing.assert_array_equal(offsets.numpy(), np.concatenate([[0], np.cumsum(counts)]))
    assert total == counts.sum()


@pytest.mark.parametrize(
    "counts",
    [
        [2**31 - 1, 1],
        [2**31 - 1] * 3,  # wraps round to a positive 32-bit number
        [2**30] * 4,  # wraps round to zero
        [2**20] * 2**12,
    ],
)
def test_a_sum_beyond_32_bits_is_an_error_and_not_a_small_number(device, counts):
    array = upload(np.array(counts, np.int32), int32, on(device))
    assert sum_counts(array) == sum(counts)
    with pytest.raises(ValueError, match=rf"{sum(counts)} results are more than 2\^31 - 1"):
        exclusive_scan(array)


def test_a_sum_of_exactly_the_largest_number_is_taken(device):
    offsets, total = exclusive_scan(upload(np.array([2**31 - 2, 0, 1], np.int32), int32, on(device)))
    assert total == 2**31 - 1 and offsets.numpy().tolist() == [0, 2**31 - 2, 2**31 - 2, 2**31 - 1]


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("share", [0.0, 0.3, 1.0])
def test_positions_of_a_mask_are_those_of_flatnonzero(device, size, share, rng):
    mask = (rng.random(size) < share).astype(np.uint8) * rng.integers(1, 256, size).astype(np.uint8)
    found = positions_of(upload(mask, uint8, on(device)))
    assert found.dtype == int32
    np.testing.assert_array_equal(found.numpy(), np.flatnonzero(mask))


@pytest.mark.parametrize(
    ("dtype", "shape"),
    [(float32, (90,)), (float64, (90, 2)), (uint16, (90, 5)), (uint8, (90,)), (int64, (90,)), (vec3, (90, 3))],
)
def test_gathered_rows_are_the_rows(device, dtype, shape, rng):
    values = rng.integers(0, 200, shape)
    rows = rng.integers(0, 90, 400).astype(np.int32)
    for chosen in (rows, rows[:0]):
        found = gather_rows(upload(values, dtype, on(device)), upload(chosen, int32, on(device)))
        assert found.dtype == dtype
        np.testing.assert_array_equal(found.numpy().reshape(len(chosen), *shape[1:]), values[chosen])


def test_an_uploaded_array_is_a_copy(device, rng):
    values = rng.random((7, 3)).astype(np.float32)
    array = upload(values, vec3, on(device))
    kept = values.copy()
    values[:] = 0
    np.testing.assert_array_equal(download(array), kept)


@pytest.mark.parametrize("size", [1, BOUND_RUN - 1, BOUND_RUN, BOUND_RUN + 1, 2 * BOUND_RUN + 1])
def test_the_box_holds_the_finite_points(device, size, rng):
    points = rng.normal(size=(size, 3)).astype(np.float32)
    points[rng.integers(0, size, size // 10)] = [np.nan, 99, -99]
    points[rng.integers(0, size, size // 10)] = [50, np.inf, 0]
    finite = np.isfinite(points).all(axis=1)
    low, high, count = bound_points(upload(points, vec3, on(device)))
    assert count == finite.sum() > 0
    np.testing.assert_array_equal(low, points[finite].min(axis=0))
    np.testing.assert_array_equal(high, points[finite].max(axis=0))


@pytest.mark.parametrize("points", [np.zeros((0, 3)), np.full((5, 3), np.nan), np.full((5, 3), np.inf)])
def test_the_box_of_no_finite_point_is_empty(device, points):
    low, high, count = bound_points(upload(points, vec3, on(device)))
    assert count == 0 and (low == np.inf).all() and (high == -np.inf).all()


def test_the_box_of_minus_zero_is_zero(device):
    low, high, _ = bound_points(upload(np.array([[-0.0, 0.0, -0.0]]), vec3, on(device)))
    assert not np.signbit(low).any() and not np.signbit(high).any()


def test_means_over_runs_are_those_of_float64(device, rng):
    sizes = np.array([1, 2, 7, 300, 1])
    starts = np.concatenate([[0], np.cumsum(sizes)]).astype(np.int32)
    order = rng.permutation(starts[-1]).astype(np.int32)
    vectors = (rng.random((starts[-1], 3)) * 1000).astype(np.float32)
    columns = rng.normal(size=(starts[-1], 4))
    where = [upload(a, int32, on(device)) for a in (order, starts)]
    parts = [order[a:b] for a, b in itertools.pairwise(starts)]
    expected = np.array([vectors[p].astype(np.float64).sum(axis=0) / len(p) for p in parts]).astype(np.float32)
    found = average_vec3(upload(vectors, vec3, on(device)), *where).numpy()
    np.testing.assert_array_max_ulp(found, expected, 1)
    found = sum_columns(upload(columns, float64, on(device)), *where, mean=True).numpy()
    np.testing.assert_allclose(found, [columns[p].mean(axis=0) for p in parts], rtol=1e-12, atol=1e-15)
    assert first_rows(*where).numpy().tolist() == [p[0] for p in parts]


def test_a_mean_of_vectors_leaves_out_those_that_are_not_finite(device):
    values = np.array([[1, 2, 3], [np.nan, 0, 0], [3, 2, 1], [0, np.inf, 0], [np.nan] * 3], np.float32)
    starts = np.array([0, 4, 5], np.int32)
    order = np.arange(5, dtype=np.int32)
    found = average_vec3(
        upload(values, vec3, on(device)), upload(order, int32, on(device)), upload(starts, int32, on(device))
    ).numpy()
    assert found[0].tolist() == [2, 2, 2] and np.isnan(found[1]).all()


@settings(derandomize=True, deadline=None, max_examples=60)
@given(keys=arrays(np.int64, st.integers(0, 60), elements=st.integers(0, 2**63 - 1) | st.integers(0, 5)))
def check_any_keys(device, keys):
    assert_sorted_stably(device, keys, 63)
    assert_sorted_stably(device, keys & 255, 8)
    mask = (keys & 1).astype(np.uint8)
    np.testing.assert_array_equal(positions_of(upload(mask, uint8, on(device))).numpy(), np.flatnonzero(mask))
    counts = (keys & 1023).astype(np.int32)
    offsets, total = exclusive_scan(upload(counts, int32, on(device)))
    assert offsets.numpy().tolist() == [0, *np.cumsum(counts)] and total == counts.sum()


def test_any_keys_are_sorted_selected_and_scanned(device):
    check_any_keys(device)
