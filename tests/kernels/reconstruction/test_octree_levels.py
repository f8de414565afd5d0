"""The octree's levels: leaves that tile the cube, balance, and neighbors, all by brute force from places."""

from __future__ import annotations

import numpy as np
import pytest

from pointloom.kernels.memory import download
from pointloom.kernels.reconstruction.sample_density import BELOW

from .octree_trees import ball_samples, code_places, is_cell, leaves_of, slot_places, tree_of

TREES = [(3, 400, 1.0), (8, 4000, 0.002)]


@pytest.fixture(params=TREES, ids=["full", "clustered"])
def pyramid(request, device):
    depth, count, share = request.param
    return tree_of(ball_samples(count, share), depth, device)


def test_leaves_fill_the_cube_once(pyramid):
    places, depths = leaves_of(pyramid)
    last = int(depths.max())
    assert (8.0 ** (last - depths)).sum() == 8**last
    size = (1 << (last - depths))[:, None]
    assert (places >= 0).all() and ((places + 1) * size <= 2**last).all()
    for level in pyramid.levels[1:]:
        assert len(np.unique(slot_places(level), axis=0)) == 8 * level.count


def test_leaves_that_touch_differ_by_one_level(pyramid):
    places, depths = leaves_of(pyramid)
    last = int(depths.max())
    assert last - depths.min() >= (0 if last == 3 else 2)
    steps = np.stack(np.meshgrid(*[[-1, 0, 1]] * 3), axis=-1).reshape(-1, 3)
    for fine in range(int(depths.min()) + 2, last + 1):
        beside = (places[depths == fine][:, None] + steps).reshape(-1, 3)
        for coarse in range(1, fine - 1):
            leaves = places[depths == coarse]
            assert not np.isin(keys_of(beside >> (fine - coarse)), keys_of(leaves)).any()


def keys_of(places):
    """One number a place; -1 beside the cube is none of its cells."""
    return ((places + 1).astype(np.int64) * [1 << 42, 1 << 21, 1]).sum(axis=1)


def test_cells_around_a_divided_cell_exist(pyramid):
    for level in pyramid.levels[1:]:
        cells = {tuple(p) for p in slot_places(level)[is_cell(level)]}
        divided = slot_places(level)[download(level.divided) == 1]
        for step in np.stack(np.meshgrid(*[[-1, 0, 1]] * 3), axis=-1).reshape(-1, 3):
            beside = divided + step
            beside = beside[((beside >= 0) & (beside < 1 << level.depth)).all(axis=1)]
            assert {tuple(p) for p in beside} <= cells


def test_blocks_around_a_block_are_those_of_its_places(pyramid):
    steps = np.stack(np.meshgrid(*[[-1, 0, 1]] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    for level in pyramid.levels[1:]:
        places = download(level.positions).reshape(-1, 3)
        at = {tuple(p): i for i, p in enumerate(places)}
        wanted = [[at.get(tuple(p), -1) for p in place + steps] for place in places]
        np.testing.assert_array_equal(download(level.around).reshape(-1, 27), wanted)


def test_children_and_parents_are_halves_and_doubles(pyramid):
    for above, level in zip(pyramid.levels[1:], pyramid.levels[2:], strict=False):
        parents = download(level.parents)
        np.testing.assert_array_equal(slot_places(above)[parents], download(level.positions).reshape(-1, 3))
        np.testing.assert_array_equal(download(above.children)[parents], np.arange(level.count))
        np.testing.assert_array_equal(download(level.has_cells), download(above.divided)[parents])


def test_each_cell_of_samples_has_the_slot_of_its_place(pyramid):
    reached = 0
    for cells, reach, at, level in zip(
        pyramid.cells[1:], pyramid.nodes[1:], pyramid.cells_at[1:], pyramid.levels[1:], strict=False
    ):
        slots = download(reach.slots)
        found = slots >= 0
        places = slot_places(level)
        np.testing.assert_array_equal(places[slots[found]], code_places(download(cells.codes))[found])
        assert is_cell(level)[slots[found & (download(reach.states) != BELOW)]].all()
        wanted = np.full(8 * level.count, -1)
        wanted[slots[found]] = np.flatnonzero(found)
        np.testing.assert_array_equal(download(at), wanted)
        missing = {tuple(p) for p in code_places(download(cells.codes))[~found]}
        assert not missing & {tuple(p) for p in places[is_cell(level)]}
        reached += found.sum()
    assert reached > 200
