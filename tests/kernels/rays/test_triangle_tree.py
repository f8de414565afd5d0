"""The tree over triangles contains each triangle once, inside the boxes above it."""

import numpy as np
import pytest

from pointloom import TriangleMesh
from pointloom.kernels.arrays.sort import positions
from pointloom.kernels.memory import download
from pointloom.kernels.rays.split_order import order_by_splits
from pointloom.kernels.rays.triangle_tree import FAN, LEAF_SIZE, TriangleTree


def tree_over(vertices, triangles, device) -> TriangleTree:
    mesh = TriangleMesh(vertices, triangles, device=device)
    return TriangleTree(mesh.arrays["vertices"], mesh.arrays["triangles"])


def soup(count: int, seed: int = 0):
    rng = np.random.default_rng(seed)
    corners = rng.normal(size=(count, 1, 3)) + 0.05 * rng.normal(size=(count, 3, 3))
    return corners.reshape(-1, 3).astype(np.float32), np.arange(3 * count).reshape(-1, 3)


def corners_in_tree(tree: TriangleTree) -> np.ndarray:
    return download(tree.corners).reshape(-1, 3, 3, LEAF_SIZE).transpose(0, 3, 1, 2).reshape(-1, 3, 3)


@pytest.mark.parametrize("count", [1, 2, 7, 8, 9, 63, 64, 65, 200, 700])
def test_the_tree_contains_each_triangle_once(device, count):
    vertices, triangles = soup(count)
    tree = tree_over(vertices, triangles, device)
    order = download(tree.order)
    assert (tree.count, len(order)) == (count, -(-count // LEAF_SIZE) * LEAF_SIZE)
    assert np.sort(order[:count]).tolist() == list(range(count)) and (order[count:] == order[count - 1]).all()
    np.testing.assert_array_equal(corners_in_tree(tree), vertices[triangles[order]])


@pytest.mark.parametrize("count", [1, 9, 65, 700])
def test_a_box_is_that_of_the_triangles_below_it(device, count):
    tree = tree_over(*soup(count), device)
    boxes = download(tree.boxes).reshape(-1, 2, 3, FAN)
    corners = corners_in_tree(tree)
    low, high = (f(corners.reshape(-1, LEAF_SIZE * 3, 3), axis=1) for f in (np.min, np.max))
    for level, first in enumerate(tree.level_firsts[:-1]):
        records = boxes[first : tree.level_firsts[level + 1]].transpose(1, 0, 3, 2).reshape(2, -1, 3)
        np.testing.assert_array_equal(records[0, : len(low)], low)
        np.testing.assert_array_equal(records[1, : len(high)], high)
        assert (records[0, len(low) :] == np.inf).all() and (records[1, len(low) :] == -np.inf).all()
        low, high = (
            f(np.pad(v, ((0, -len(v) % FAN), (0, 0)), constant_values=empty).reshape(-1, FAN, 3), axis=1)
            for f, v, empty in ((np.min, low, np.inf), (np.max, high, -np.inf))
        )
    assert len(low) == 1 and tree.root == len(tree.level_firsts) - 2
    np.testing.assert_array_equal([tree.low, tree.high], [low[0], high[0]])


def test_triangles_that_are_not_finite_are_left_out(device):
    vertices, triangles = soup(20)
    vertices[7], vertices[33] = np.nan, np.inf  # corners of triangles 2 and 11
    tree = tree_over(vertices, triangles, device)
    assert np.sort(download(tree.order)[: tree.count]).tolist() == [i for i in range(20) if i not in (2, 11)]
    nothing = tree_over(np.full((3, 3), np.nan), [[0, 1, 2]], device)
    assert (nothing.count, nothing.root) == (0, 0) and np.isposinf(download(nothing.boxes)[: 3 * FAN]).all()


def ordered(mesh):
    vertices = mesh.arrays["vertices"]
    return order_by_splits(vertices, positions(vertices.size, vertices.device), 8)


def test_a_run_is_halved_along_its_longest_side(device):
    x = np.random.default_rng(0).permutation(64)
    points = np.stack([x, np.zeros(64), np.zeros(64)], axis=1)
    mesh = TriangleMesh(points, device=device)
    order = download(ordered(mesh))
    for run in range(8):
        assert sorted(x[order[8 * run : 8 * run + 8]]) == list(range(8 * run, 8 * run + 8))


def test_coincident_points_are_ordered_by_number(device):
    mesh = TriangleMesh(np.ones((100, 3)), device=device)
    assert download(ordered(mesh)).tolist() == list(range(100))
