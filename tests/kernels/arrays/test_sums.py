"""Prefix sums, running sums, sums over runs, medians and quantiles: those of NumPy, and an error at 32-bit overflow."""

import itertools
import math

import numpy as np
import pytest

from pointloom.core.devices import resolve_device
from pointloom.kernels.arrays.loop_scan import LoopList
from pointloom.kernels.arrays.prefix_sum import (
    FEW_COUNTS,
    RUN_COUNTS,
    exclusive_scan,
    offsets_of,
    scan_together,
    scan_two,
    sum_counts,
)
from pointloom.kernels.arrays.quantiles import median_above_zero, quantiles_of
from pointloom.kernels.arrays.run_sums import average_vec3, first_rows, sum_columns
from pointloom.kernels.arrays.running_sums import running_sums
from pointloom.kernels.arrays.tile_scan import TILE_COUNTS, TileScan
from pointloom.kernels.lang import float64, int32, uint8, vec3
from pointloom.kernels.memory import download, empty, upload, zeros


@pytest.mark.parametrize("size", [0, 1, 2, RUN_COUNTS - 1, RUN_COUNTS, RUN_COUNTS + 1, 3 * RUN_COUNTS + 7])
def test_offsets_are_the_exclusive_sums(device, size, rng):
    counts = rng.integers(0, 50, size).astype(np.int32)
    offsets, total = exclusive_scan(upload(counts, int32, device))
    np.testing.assert_array_equal(offsets.numpy(), np.concatenate([[0], np.cumsum(counts)]))
    assert total == counts.sum()
    np.testing.assert_array_equal(offsets_of(upload(counts, int32, device)).numpy(), offsets.numpy())
    bounded, same = exclusive_scan(upload(counts, int32, device), largest=49)
    assert same == total and bounded.numpy().tobytes() == offsets.numpy().tobytes()


SCANS = {
    "one": lambda counts, **bound: exclusive_scan(counts, **bound),
    "two": lambda counts, **bound: scan_two(counts, **bound),
    "several": lambda counts, **bound: scan_together([(counts, [counts.size])], **bound),
}


@pytest.mark.parametrize(
    "counts", [[2**31 - 1, 1], [2**31 - 1] * 3, [2**30] * 4, [2**20] * 2**12, [2**14] * (FEW_COUNTS + 1)]
)
def test_an_overflow_of_32_bits_is_an_error(device, counts):
    """Three times 2^31 - 1 wraps round to a positive number, and four times 2^30 to zero."""
    array = upload(np.array(counts, np.int32), int32, device)
    assert sum_counts(array) == sum(counts)
    for scan in SCANS.values():
        with pytest.raises(ValueError, match=rf"{sum(counts)} results are more than 2\^31 - 1"):
            scan(array, largest=max(counts))


@pytest.mark.parametrize("largest", [49, 2**31 - 1])
@pytest.mark.parametrize("at", [[1.0], [0.0, 0.5, 1.0]])
def test_several_arrays_are_scanned_and_read_together(device, rng, at, largest):
    parts = [rng.integers(0, 50, size) for size in (0, 1, RUN_COUNTS + 1)]
    positions = [[int(k * part.size) for k in at] for part in parts]
    given = [(upload(part, int32, device), ends) for part, ends in zip(parts, positions, strict=True)]
    *scans, (_, values) = scan_together(given, upload(np.array([7, -1]), int32, device), largest=largest)
    for part, ends, (offsets, noted) in zip(parts, positions, scans, strict=True):
        expected = np.concatenate([[0], np.cumsum(part)])
        np.testing.assert_array_equal(offsets.numpy(), expected)
        assert noted == expected[ends].tolist()
    assert values == [7, -1]


def test_a_sum_of_exactly_the_largest_number_is_taken(device):
    offsets, total = exclusive_scan(upload(np.array([2**31 - 2, 0, 1], np.int32), int32, device))
    assert total == 2**31 - 1 and offsets.numpy().tolist() == [0, 2**31 - 2, 2**31 - 2, 2**31 - 1]


@pytest.mark.parametrize("half", [0, 1, 37, RUN_COUNTS, 100_003])
def test_counts_of_two_kinds_are_scanned_together(device, rng, half):
    counts = rng.integers(0, 9, 2 * half).astype(np.int32)
    offsets, first, total = scan_two(upload(counts, int32, device))
    np.testing.assert_array_equal(offsets.numpy(), np.concatenate([[0], np.cumsum(counts)]))
    assert (first, total) == (counts[:half].sum(), counts.sum())
    bounded, *sums = scan_two(upload(counts, int32, device), largest=8)
    assert sums == [first, total] and bounded.numpy().tobytes() == offsets.numpy().tobytes()


@pytest.mark.parametrize(
    "size",
    [0, 1, 31, 33, TILE_COUNTS - 1, TILE_COUNTS, TILE_COUNTS + 1, 3 * TILE_COUNTS + 7, TILE_COUNTS * TILE_COUNTS + 1],
)
def test_sums_run_through_all_tiles(device, size, rng):
    warp_device = resolve_device(device)
    counts = rng.integers(0, 50, size).astype(np.int32)
    given, sums, scan = upload(counts, int32, warp_device), empty(size, int32, warp_device), TileScan(size, warp_device)
    scan.run(given, sums, size)
    np.testing.assert_array_equal(download(sums), np.cumsum(counts))
    np.testing.assert_array_equal(download(given), counts)
    scan.run(given, given, size)
    np.testing.assert_array_equal(download(given), np.cumsum(counts))


def test_fewer_counts_than_the_capacity(device, rng):
    warp_device, size, capacity = resolve_device(device), TILE_COUNTS + 5, 3 * TILE_COUNTS
    counts = rng.integers(0, 50, capacity).astype(np.int32)
    sums = upload(np.full(capacity, -7, np.int32), int32, warp_device)
    TileScan(capacity, warp_device).run(upload(counts, int32, warp_device), sums, size)
    np.testing.assert_array_equal(download(sums), [*np.cumsum(counts[:size]), *[-7] * (capacity - size)])


@pytest.mark.parametrize("fraction", [0.0, 0.3, 1.0])
def test_marks_are_listed_in_their_order(device, rng, fraction):
    warp_device, size = resolve_device(device), 2 * TILE_COUNTS + 77
    mask = (rng.random(size) < fraction).astype(np.uint8)
    counts, marks = zeros(3, int32, warp_device), LoopList(size, warp_device)
    marks.find(upload(mask, uint8, warp_device), size, counts, 1)
    assert download(counts).tolist() == [0, mask.sum(), 0]
    np.testing.assert_array_equal(download(marks.rows)[: mask.sum()], np.flatnonzero(mask))


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
    assert (steps >= 0).all() and (steps[values == 0] == 0).all()


def test_the_bits_do_not_depend_on_the_device(device, rng):
    values = rng.random(5000)
    sums, total = [], 0.0
    for first in range(0, 5000, 70):  # runs of the square root of the count, one after the other
        run = values[first : first + 70]
        part = np.cumsum(run)
        sums.append(total + part)
        total = total + part[-1]
    assert sums_of(values, device).tobytes() == np.concatenate(sums).tobytes()


def test_means_over_runs_are_those_of_float64(device, rng):
    sizes = np.array([1, 2, 7, 300, 1])
    starts = np.concatenate([[0], np.cumsum(sizes)]).astype(np.int32)
    order = rng.permutation(starts[-1]).astype(np.int32)
    vectors = (rng.random((starts[-1], 3)) * 1000).astype(np.float32)
    columns = rng.normal(size=(starts[-1], 4))
    where = [upload(a, int32, device) for a in (order, starts)]
    parts = [order[a:b] for a, b in itertools.pairwise(starts)]
    expected = np.array([vectors[p].astype(np.float64).sum(axis=0) / len(p) for p in parts]).astype(np.float32)
    result = average_vec3(upload(vectors, vec3, device), *where).numpy()
    np.testing.assert_array_max_ulp(result, expected, 1)
    for mean in (False, True):
        result = sum_columns(upload(columns, float64, device), *where, mean).numpy()
        expected = [columns[p].mean(axis=0) if mean else columns[p].sum(axis=0) for p in parts]
        np.testing.assert_allclose(result, expected, rtol=1e-12, atol=1e-15 if mean else 3e-13)  # of 300 rows
    assert first_rows(*where).numpy().tolist() == [p[0] for p in parts]


def test_a_mean_leaves_out_rows_that_are_not_finite(device):
    values = np.array([[1, 2, 3], [np.nan, 0, 0], [3, 2, 1], [0, np.inf, 0], [np.nan] * 3], np.float32)
    where = [upload(np.array(a), int32, device) for a in ([0, 1, 2, 3, 4], [0, 4, 5])]
    rows = upload(values.astype(np.float64), float64, device)
    for means in (average_vec3(upload(values, vec3, device), *where), sum_columns(rows, *where, mean=True)):
        assert means.numpy()[0].tolist() == [2, 2, 2] and np.isnan(means.numpy()[1]).all()
    assert np.isnan(sum_columns(rows, *where).numpy()[0]).tolist() == [True, False, False]


@pytest.mark.parametrize("offset", [1.7e9, -1.7e18])
def test_means_of_large_numbers_are_exact(device, rng, offset):
    values = offset + rng.random((20_000, 2)) * abs(offset) * 1e-9
    values[5, 0] = 1e30 * np.sign(offset)
    where = [upload(np.array(a), int32, device) for a in (np.arange(20_000), [0, 6, 20_000])]
    means = sum_columns(upload(values, float64, device), *where, mean=True).numpy()
    expected = [[math.fsum(column) / len(part) for column in part.T] for part in (values[:6], values[6:])]
    np.testing.assert_array_max_ulp(means, np.array(expected), 1)


FRACTIONS = (0.0, 0.02, 0.3, 0.5, 0.98, 1.0)


def numbers(count, seed=0):
    rng = np.random.default_rng(seed)
    values = np.abs(rng.normal(size=count)) * 10.0 ** rng.integers(-300, 300, count)
    values[rng.random(count) < 0.2] = 0.25
    values[rng.random(count) < 0.05] = 5e-324
    return values


@pytest.mark.parametrize("count", [1, 2, 3, 4, 7, 100, 1023])
def test_quantiles_and_medians_are_bitwise_identical_to_numpy(device, count):
    values = numbers(count, count)
    assert quantiles_of(upload(values, float64, device), FRACTIONS) == np.quantile(values, FRACTIONS).tolist()
    assert median_above_zero(upload(values, float64, device)) == np.median(values)


def test_non_finite_values_are_ignored(device):
    values = numbers(200)
    mixed = values.copy()
    mixed[::3], mixed[1::9], mixed[2::9] = np.nan, np.inf, 0.0
    device_values = upload(mixed, float64, device)
    finite = mixed[np.isfinite(mixed)]
    assert quantiles_of(device_values, FRACTIONS) == np.quantile(finite, FRACTIONS).tolist()
    assert median_above_zero(device_values) == np.median(finite[finite > 0])


@pytest.mark.parametrize("values", [[], [np.nan, np.inf]])
def test_without_a_number_there_is_no_quantile(device, values):
    device_values = upload(np.array(values), float64, device)
    assert quantiles_of(device_values, FRACTIONS) == [] and median_above_zero(device_values) is None
