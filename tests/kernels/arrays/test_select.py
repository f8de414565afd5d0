"""Rows by mask, list and number, and subsets of rows: those of NumPy."""

import numpy as np
import pytest

from pointloom.core.devices import resolve_device
from pointloom.kernels.arrays.key_starts import find_key_starts
from pointloom.kernels.arrays.row_numbers import distinct_pairs, limits_of, list_partners, pair_up, resolve_rows
from pointloom.kernels.arrays.select import gather_rows, positions_of
from pointloom.kernels.arrays.subsets import draw_rows, other_rows, sort_rows
from pointloom.kernels.lang import cpu_compiler, float32, float64, int32, int64, uint8, uint16, vec3
from pointloom.kernels.memory import download, empty, upload


@pytest.mark.parametrize("size", [0, 1, 2, 255, 256, 257, 70_001])
@pytest.mark.parametrize("fraction", [0.0, 0.3, 1.0])
def test_positions_of_a_mask_are_those_of_flatnonzero(device, size, fraction, rng):
    mask = (rng.random(size) < fraction).astype(np.uint8) * rng.integers(1, 256, size).astype(np.uint8)
    result = positions_of(upload(mask, uint8, device))
    assert result.dtype == int32
    np.testing.assert_array_equal(result.numpy(), np.flatnonzero(mask))


@pytest.mark.parametrize(
    ("dtype", "shape"),
    [(float32, (90,)), (float64, (90, 2)), (uint16, (90, 5)), (uint8, (90,)), (int64, (90,)), (vec3, (90, 3))],
)
def test_gathered_rows_are_the_rows(device, dtype, shape, rng):
    values = rng.integers(0, 200, shape)
    rows = rng.integers(0, 90, 400).astype(np.int32)
    for chosen in (rows, rows[:0]):
        gathered = gather_rows(upload(values, dtype, device), upload(chosen, int32, device))
        assert gathered.dtype == dtype
        np.testing.assert_array_equal(gathered.numpy().reshape(len(chosen), *shape[1:]), values[chosen])


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


@pytest.mark.parametrize("count", [0, 1, 1000])
def test_starts_are_those_of_numpy_with_numbers_that_no_key_has(device, rng, count):
    keys = np.sort(rng.integers(0, 60, count))
    starts = empty(66, int32, device)
    find_key_starts(upload(keys, int64, device), starts)
    np.testing.assert_array_equal(download(starts), np.searchsorted(keys, np.arange(66), side="left"))


def test_a_list_is_sorted_and_its_complement_computed(device, rng):
    rows = rng.integers(0, 500, 300)
    listed = upload(rows, int32, device)
    assert sort_rows(listed, 500).numpy().tolist() == np.unique(rows).tolist()
    assert other_rows(listed, 500).numpy().tolist() == np.setdiff1d(np.arange(500), rows).tolist()


def test_a_draw_depends_on_seed_and_count_alone(device):
    """The rows written here keep it so from version to version."""
    rows = draw_rows(10, 4, 3, device).numpy().tolist()
    with cpu_compiler("warp"):
        assert rows == draw_rows(10, 4, 3, resolve_device("cpu")).numpy().tolist() == [1, 5, 8, 9]
    assert rows != draw_rows(10, 4, 4, device).numpy().tolist()


def test_every_row_and_every_pair_of_rows_is_drawn_as_often(device):
    """Within 5 standard deviations over 600 seeds."""
    count, drawn, seeds = 12, 5, 600
    chosen = np.zeros((seeds, count))
    for seed in range(seeds):
        rows = draw_rows(count, drawn, seed, device).numpy()
        assert (np.diff(rows) > 0).all() and len(rows) == drawn
        chosen[seed, rows] = 1
    together = chosen.T @ chosen
    single, pair = drawn / count, drawn * (drawn - 1) / (count * (count - 1))
    others = together[~np.eye(count, dtype=bool)]
    assert np.abs(np.diag(together) - seeds * single).max() < 5 * np.sqrt(seeds * single * (1 - single))
    assert np.abs(others - seeds * pair).max() < 5 * np.sqrt(seeds * pair * (1 - pair))
