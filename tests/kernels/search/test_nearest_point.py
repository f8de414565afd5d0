"""The nearest point by lanes is the one that the search for k finds: ties, radii, twins, sparse queries, NaN."""

import numpy as np
import pytest

from pointloom.kernels.lang import vec3
from pointloom.kernels.memory import upload
from pointloom.kernels.search import nearest_point
from pointloom.kernels.search.nearest_point import NO_POINT, find_nearest
from pointloom.kernels.search.point_tree import PointTree
from pointloom.kernels.search.tree_search import search_nearest


def clouds(rng):
    lattice = np.stack(np.meshgrid(*[np.arange(7.0)] * 3, indexing="ij"), -1).reshape(-1, 3)
    scattered = rng.random((2001, 3))
    dense = np.concatenate([rng.random((500, 3)), 1e-3 * rng.random((500, 3))])
    spoiled = scattered.copy()
    spoiled[rng.integers(0, 2001, 300), rng.integers(0, 3, 300)] = np.nan
    return {
        "scattered": (scattered, rng.random((1003, 3)) * 1.5 - 0.25),
        "ties": (lattice, rng.permutation(lattice) + 0.5),
        "two densities": (dense, rng.random((701, 3))),
        "all equal": (np.ones((300, 3)), np.ones((50, 3))),
        "far away": (scattered, scattered + np.array([1000, 0, 0])),
        "not finite": (spoiled, spoiled[::-1].copy()),
        "one point": (np.zeros((1, 3)), rng.random((9, 3))),
        "nothing": (np.full((5, 3), np.nan), rng.random((9, 3))),
        "few queries": (scattered, rng.random((3, 3))),
    }


@pytest.mark.parametrize("name", list(clouds(np.random.default_rng(0))))
@pytest.mark.parametrize("radius", [np.inf, 0.5, 0.05, 1e-30])
def test_the_nearest_point_is_the_first_that_the_search_finds(device, name, radius, rng, monkeypatch):
    target, queries = (upload(p.astype(np.float32), vec3, device) for p in clouds(rng)[name])
    tree = PointTree(target)
    indices, sqdists, counts = (part.numpy() for part in search_nearest(tree, queries, 1, radius))
    for sparse in (0, 10**9):  # each query alone; all in groups
        monkeypatch.setattr(nearest_point, "SPARSE", sparse)
        keys = find_nearest(tree, queries, radius=radius).numpy()
        np.testing.assert_array_equal(keys >= 0, counts == 1)
        assert (keys[counts == 0] == NO_POINT).all()
        np.testing.assert_array_equal((keys & 0xFFFFFFFF)[counts == 1], indices[counts == 1, 0])
        np.testing.assert_array_equal((keys >> 32)[counts == 1], sqdists[counts == 1, 0].view(np.int32))


@pytest.mark.parametrize("name", list(clouds(np.random.default_rng(0))))
def test_a_point_is_not_the_nearest_other_one(device, name, rng, monkeypatch):
    points = clouds(rng)[name][0]
    finite = np.isfinite(points).all(axis=1)
    array = upload(points.astype(np.float32), vec3, device)
    tree = PointTree(array)
    expected = np.full(len(points), NO_POINT)
    p = points.astype(np.float32)
    for row in np.flatnonzero(finite):
        squares = (p - p[row]) ** 2
        sqdists = (squares[:, 0] + squares[:, 1]) + squares[:, 2]
        sqdists[row] = np.nan
        if np.isfinite(sqdists).any():
            best = np.nanargmin(sqdists)
            expected[row] = (int(sqdists[best : best + 1].view(np.int32)[0]) << 32) | best
    for sparse in (0, 10**9):
        monkeypatch.setattr(nearest_point, "SPARSE", sparse)
        np.testing.assert_array_equal(find_nearest(tree, array, others=True).numpy(), expected)
