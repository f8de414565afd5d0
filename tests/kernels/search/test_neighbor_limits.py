"""A limit per point replaces its list of neighbors for any search."""

import numpy as np
import pytest

from pointloom.kernels.features.fpfh import count_angles, sum_histograms
from pointloom.kernels.lang import float32, int32, vec3
from pointloom.kernels.memory import empty, upload
from pointloom.kernels.search import group_scratch
from pointloom.kernels.search.neighbor_limits import Neighborhood
from pointloom.kernels.search.point_tree import PointTree
from pointloom.kernels.surface.neighbor_moments import sum_neighbor_moments

SEARCHES = [(0.2, 12), (np.inf, 12), (0.2, None), (np.inf, None), (0.2, 1), (1e-6, 5), (1e9, 20)]


def tree_of(device, points):
    return PointTree(upload(np.float32(points), vec3, device))


def sorted_sqdists(tree, row):
    """float32 squared distances of a point to all, as the tree computes them, and the order by distance and place."""
    p = tree.points.numpy()[: tree.count]
    d = p - p[row]
    sqdists = d[:, 0] * d[:, 0] + d[:, 1] * d[:, 1] + d[:, 2] * d[:, 2]
    return sqdists, np.lexsort((np.arange(len(p)), sqdists))


def clustered(rng, count=400):
    """A cloud whose density varies, with lattice ties and duplicates."""
    points = rng.random((count, 3)) ** 3
    points[: count // 4] = np.round(points[: count // 4] * 8) / 8
    points[-5:] = points[0]
    return points


@pytest.mark.parametrize(("radius", "max_nn"), SEARCHES)
def test_the_keys_up_to_a_limit_are_the_nearest(device, radius, max_nn, rng):
    tree = tree_of(device, clustered(rng))
    limits = Neighborhood(tree, radius, max_nn).limits.numpy()
    for row in range(0, tree.count, 7):
        sqdists, order = sorted_sqdists(tree, row)
        keys = (sqdists.view(np.int32).astype(np.int64) << 32) | np.arange(tree.count)
        nearest = [j for j in order if float(sqdists[j]) < float(radius) ** 2][:max_nn]
        np.testing.assert_array_equal(np.flatnonzero(keys <= limits[row]), np.sort(nearest))


@pytest.mark.parametrize("spread", [0.0, 1e-3, 1.0])
def test_limits_part_points_at_equal_or_wildly_different_distances(device, spread, rng):
    """Where interpolation leads nowhere the interval is halved: ties by place, and distances of 30 magnitudes."""
    count, k = 300, 20
    points = np.zeros((count, 3))
    points[: count // 2, 0] = 10.0 ** rng.uniform(-15, 0, count // 2) * spread
    tree = tree_of(device, points)
    limits = Neighborhood(tree, 2.0, k).limits.numpy()
    for row in range(0, count, 11):
        sqdists, order = sorted_sqdists(tree, row)
        keys = (sqdists.view(np.int32).astype(np.int64) << 32) | np.arange(count)
        np.testing.assert_array_equal(np.flatnonzero(keys <= limits[row]), np.sort(order[:k]))


def crowded(rng, count=3000):
    """So many points in one place that no group's candidates fit into its scratch memory, and some around it."""
    return np.concatenate([0.01 * rng.normal(size=(count, 3)), rng.normal(size=(200, 3))])


@pytest.mark.parametrize("make", [clustered, crowded])
@pytest.mark.parametrize(("radius", "max_nn"), [(0.2, 12), (np.inf, 12), (0.2, None)])
def test_traversals_and_groups_give_the_same_neighbors(device, make, radius, max_nn, rng, tolerances, monkeypatch):
    tree = tree_of(device, make(rng))
    normals = rng.normal(size=(tree.count, 3))
    normals = upload(np.float32(normals / np.linalg.norm(normals, axis=1, keepdims=True)), vec3, tree.device)
    results = []
    for room in (group_scratch.candidate_room, lambda device, k: 0):
        monkeypatch.setattr(group_scratch, "candidate_room", room)
        neighborhood = Neighborhood(tree, radius, max_nn)
        moments = sum_neighbor_moments(neighborhood).numpy()
        histograms = count_angles(neighborhood, normals, neighborhood.positions)
        features = empty((tree.count, 33), float32, tree.device)
        sum_histograms(neighborhood, histograms, neighborhood.positions, neighborhood.positions, features)
        results.append((moments, histograms.numpy(), features.numpy()))
    (moments, histograms, features), traversal = results
    np.testing.assert_array_equal(moments[:, 0], traversal[0][:, 0])
    np.testing.assert_allclose(moments, traversal[0], rtol=0, atol=1e-12 * np.abs(moments).max())
    np.testing.assert_array_equal(histograms, traversal[1])
    np.testing.assert_allclose(features, traversal[2], rtol=0, atol=tolerances.fpfh_block)


def test_marks_are_the_points_and_their_neighbors(device, rng):
    tree = tree_of(device, clustered(rng))
    chosen = np.array([3, 77, 200], np.int32)
    ranks = upload(chosen, int32, tree.device)
    neighborhood = Neighborhood(tree, 0.3, 10, ranks)
    marked = np.flatnonzero(neighborhood.mark(ranks).numpy())
    expected = set(chosen)
    for row in chosen:
        sqdists, order = sorted_sqdists(tree, row)
        expected |= set([j for j in order if float(sqdists[j]) < 0.3**2][:10])
    assert marked.tolist() == sorted(expected)
