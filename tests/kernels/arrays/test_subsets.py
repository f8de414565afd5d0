"""Rows of subsets: steps, lists, complements and draws."""

import numpy as np
import pytest

from pointloom.core.devices import resolve_device
from pointloom.kernels.arrays.subsets import draw_rows, other_rows, sort_rows, step_rows
from pointloom.kernels.lang import cpu_compiler, int32
from pointloom.kernels.memory import upload


@pytest.mark.parametrize(("count", "step"), [(0, 1), (1, 1), (1, 9), (10, 3), (9, 3), (5, 2**40)])
def test_steps_are_those_of_a_slice(device, count, step):
    assert step_rows(count, step, device).numpy().tolist() == list(range(count))[::step]


def test_a_list_is_sorted_and_its_complement_computed(device, rng):
    rows = rng.integers(0, 500, 300)
    listed = upload(rows, int32, device)
    assert sort_rows(listed, 500).numpy().tolist() == np.unique(rows).tolist()
    assert other_rows(listed, 500).numpy().tolist() == np.setdiff1d(np.arange(500), rows).tolist()


def test_a_draw_depends_on_seed_and_count_alone(device):
    """The rows written here keep it so from version to version."""
    rows = draw_rows(10, 4, 3, device).numpy().tolist()
    with cpu_compiler("warp"):
        assert rows == draw_rows(10, 4, 3, resolve_device("cpu")).numpy().tolist() == [1, 3, 8, 9]
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
