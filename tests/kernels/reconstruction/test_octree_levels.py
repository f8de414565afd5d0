"""The octree's levels: leaves that tile the cube, balance, and neighbors, compared with brute force."""

import numpy as np
import pytest

from pointloom.kernels.memory import download
from pointloom.kernels.reconstruction.sample_density import BELOW

from .octree_trees import ball_samples, code_cells, is_cell, leaves_of, slot_cells, tree_of

TREES = [(3, 400, 1.0), (8, 4000, 0.002)]


@pytest.fixture(params=TREES, ids=["full", "clustered"])
def pyramid(request, device):
    depth, count, share = request.param
    return tree_of(ball_samples(count, share), depth, device)


def test_leaves_fill_the_cube_once(pyramid):
    cells, depths = leaves_of(pyramid)
    last = int(depths.max())
    assert (8.0 ** (last - depths)).sum() == 8**last
    size = (1 << (last - depths))[:, None]
    assert (cells >= 0).all() and ((cells + 1) * size <= 2**last).all()
    for level in pyramid.levels[1:]:
        assert len(np.unique(slot_cells(level), axis=0)) == 8 * level.count


def test_leaves_that_touch_differ_by_one_level(pyramid):
    cells, depths = leaves_of(pyramid)
    last = int(depths.max())
    assert last - depths.min() >= (0 if last == 3 else 2)
    steps = np.stack(np.meshgrid(*[[-1, 0, 1]] * 3), axis=-1).reshape(-1, 3)
    for fine in range(int(depths.min()) + 2, last + 1):
        neighbors = (cells[depths == fine][:, None] + steps).reshape(-1, 3)
        for coarse in range(1, fine - 1):
            leaves = cells[depths == coarse]
            assert not np.isin(keys_of(neighbors >> (fine - coarse)), keys_of(leaves)).any()


def keys_of(cells):
    """One number a place; -1 beside the cube is none of its cells."""
    return ((cells + 1).astype(np.int64) * [1 << 42, 1 << 21, 1]).sum(axis=1)


def test_cells_around_a_divided_cell_exist(pyramid):
    for level in pyramid.levels[1:]:
        cells = {tuple(p) for p in slot_cells(level)[is_cell(level)]}
        divided = slot_cells(level)[download(level.divided) == 1]
        for step in np.stack(np.meshgrid(*[[-1, 0, 1]] * 3), axis=-1).reshape(-1, 3):
            neighbors = divided + step
            neighbors = neighbors[((neighbors >= 0) & (neighbors < 1 << level.depth)).all(axis=1)]
            assert {tuple(p) for p in neighbors} <= cells


def test_neighbors_of_a_block_match_its_positions(pyramid):
    steps = np.stack(np.meshgrid(*[[-1, 0, 1]] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    for level in pyramid.levels[1:]:
        positions = download(level.positions).reshape(-1, 3)
        at = {tuple(p): i for i, p in enumerate(positions)}
        expected = [[at.get(tuple(p), -1) for p in position + steps] for position in positions]
        np.testing.assert_array_equal(download(level.around).reshape(-1, 27), expected)


def test_parent_and_child_positions_differ_by_a_factor_of_two(pyramid):
    for above, level in zip(pyramid.levels[1:], pyramid.levels[2:], strict=False):
        parents = download(level.parents)
        np.testing.assert_array_equal(slot_cells(above)[parents], download(level.positions).reshape(-1, 3))
        np.testing.assert_array_equal(download(above.children)[parents], np.arange(level.count))
        np.testing.assert_array_equal(download(level.has_cells), download(above.divided)[parents])


def test_each_sample_cell_has_the_slot_of_its_position(pyramid):
    reached = 0
    parts = (pyramid.cells, pyramid.nodes, pyramid.cells_at, pyramid.levels)
    for cells, nodes, at, level in zip(*(part[1:] for part in parts), strict=False):
        slots = download(nodes.slots)
        exists = slots >= 0
        positions = slot_cells(level)
        np.testing.assert_array_equal(positions[slots[exists]], code_cells(download(cells.codes))[exists])
        assert is_cell(level)[slots[exists & (download(nodes.states) != BELOW)]].all()
        expected = np.full(8 * level.count, -1)
        expected[slots[exists]] = np.flatnonzero(exists)
        np.testing.assert_array_equal(download(at), expected)
        missing = {tuple(p) for p in code_cells(download(cells.codes))[~exists]}
        assert not missing & {tuple(p) for p in positions[is_cell(level)]}
        reached += exists.sum()
    assert reached > 200
