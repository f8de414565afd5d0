"""Samples gathered into cells: counts, means and normals of every level, and the density that the tree goes by."""

import numpy as np
import pytest

from pointloom.kernels.lang import launch, vec3
from pointloom.kernels.memory import download, empty, upload
from pointloom.kernels.reconstruction.sample_cells import Cube, gather_samples, sample_rows
from pointloom.kernels.reconstruction.sample_density import ENDS, ON

from .octree_trees import CORNER, SIDE, ball_samples, code_cells, tree_of


def spline(t):
    t = np.abs(t)
    return np.where(t < 0.5, 0.75 - t**2, np.where(t < 1.5, 0.5 * (1.5 - t) ** 2, 0))


@pytest.mark.parametrize("by_length", [False, True])
def test_cells_contain_the_sums_of_their_points(device, by_length):

    rng = np.random.default_rng(1)
    points = ball_samples(500)
    normals = (points * rng.uniform(0.5, 2, (500, 1))).astype(np.float32)
    points = points.copy()
    points[7], normals[8], normals[9] = np.nan, np.inf, 0
    arrays = [upload(a, vec3, device) for a in (points, normals)]
    rows = sample_rows(*arrays)
    np.testing.assert_array_equal(download(rows), np.delete(np.arange(500), [7, 8, 9]))
    positions = (points.astype(float)[download(rows)] - CORNER) / SIDE
    sizes = np.linalg.norm(normals.astype(float)[download(rows)], axis=1, keepdims=True)
    weights = sizes if by_length else np.ones_like(sizes)
    units = normals.astype(float)[download(rows)] / sizes * weights
    levels = gather_samples(*arrays, rows, Cube(CORNER, SIDE), 4, by_length)
    assert len(levels) == 5 and levels[0].count == 1
    for depth, cells in enumerate(levels):
        expected, member = np.unique(np.floor(positions * 2**depth).astype(int), axis=0, return_inverse=True)
        cell_indices = code_cells(download(cells.codes))
        order = np.lexsort(cell_indices.T[::-1])
        np.testing.assert_array_equal(cell_indices[order], expected)
        sums = [np.zeros((len(expected), k)) for k in (1, 3, 3, 1)]
        for total, values in zip(sums, (np.ones_like(sizes), positions, units, weights), strict=True):
            np.add.at(total, member.ravel(), values)
        count, mean, normal, weight = sums
        np.testing.assert_array_equal(download(cells.counts)[order], count[:, 0])
        np.testing.assert_allclose(download(cells.means)[order], mean / count, atol=2e-7)
        np.testing.assert_allclose(download(cells.sums)[order], normal, atol=2e-4)
        np.testing.assert_allclose(download(cells.weights)[order], weight[:, 0], rtol=1e-6)


def test_the_density_is_that_of_splines_by_brute_force(device):
    pyramid = tree_of(ball_samples(600), 4, device)
    assert len(pyramid.densities) == 3  # evaluated up to two levels above the finest
    above = np.full(1, 600 / 1.5)
    for depth in (1, 2):
        cells, nodes, n = pyramid.cells[depth], pyramid.nodes[depth], 1 << depth
        at = download(cells.means).astype(float) * n
        centers = np.stack(np.meshgrid(*[np.arange(n) + 0.5] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
        weights = spline(at[:, None] - centers).prod(axis=2)  # [cells of samples, cells]
        w = weights @ (download(cells.counts) @ weights) / (1.5 * 0.59375)
        np.testing.assert_allclose(download(nodes.densities), w, rtol=1e-5)
        parents = download(cells.parents)
        between = depth - 1 + np.log(np.maximum(above[parents], 1)) / np.log(np.maximum(above[parents], 1) / w)
        local = np.where(w < 1, between, depth + (np.log(np.maximum(w, 1)) / np.log(4) if depth == 2 else 1))
        np.testing.assert_allclose(download(nodes.depths), local, atol=1e-5)
        np.testing.assert_array_equal(download(nodes.states), np.where(local > depth, ON, ENDS))
        above = w


def test_the_splines_of_all_cells_add_up_to_one(device, write_kernels):
    module = write_kernels(
        "spline_sums",
        """
        from pointloom.kernels.reconstruction.splines import corner_weight, spline_weight
        @kernel
        def sum_splines_kernel(shares: array(dtype=vec3), sums: array(dtype=vec3)):
            i = tid()
            f = shares[i]
            total = float(0.0)
            slope = float(0.0)
            for k in range(3):
                total += spline_weight(f[0], k - 1)
                slope += spline_weight(f[0], k - 1) * (float(k) - 0.5)
            corners = float(0.0)
            for corner in range(8):
                corners += corner_weight(f, corner)
            sums[i] = vec3(total, slope - f[0], corners)
        """,
    )
    shares = np.random.default_rng(0).random((100, 3))
    shares[0], shares[1] = 0, 1
    sums = empty(100, vec3, device)
    launch(module.sum_splines_kernel, 100, [upload(shares, vec3, device), sums])
    np.testing.assert_allclose(download(sums), np.tile([1.0, 0, 1], (100, 1)), atol=3e-7)
