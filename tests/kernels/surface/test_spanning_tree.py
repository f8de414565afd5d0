"""Spanning trees give the signs of Kruskal's algorithm for the same order of edges, for any graph."""

import itertools

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from pointloom.kernels.lang import int32, vec3
from pointloom.kernels.memory import download, full, upload
from pointloom.kernels.search.point_tree import BUCKET, FAN, LEAF, PointTree
from pointloom.kernels.surface import orientation
from pointloom.kernels.surface.orientation import bridge_components
from pointloom.kernels.surface.spanning_tree import HOPS, Forest, span_neighbors

FIXTURES = [HealthCheck.function_scoped_fixture]
SETTINGS = settings(max_examples=25, deadline=None, suppress_health_check=FIXTURES, derandomize=True)


class Kruskal:
    """Components with signs, joined edge by edge."""

    def __init__(self, count):
        self.labels, self.signs = np.arange(count), np.ones(count)

    def join(self, u, v, sign):
        """Join two vertices whose signs have this product; nothing where they are joined already."""
        if self.labels[u] != self.labels[v]:
            part = self.labels == self.labels[v]
            self.signs[part] *= sign * self.signs[u] * self.signs[v]
            self.labels[part] = self.labels[u]

    def relative(self):
        """Each vertex's component by its lowest vertex, and its sign relative to that one."""
        lowest = np.array([np.flatnonzero(self.labels == label)[0] for label in self.labels], int)
        return lowest, self.signs * self.signs[lowest]


def unit_normals(rng, count, kinds=None):
    normals = rng.normal(size=(count if kinds is None else kinds, 3))
    normals = (normals / np.linalg.norm(normals, axis=1, keepdims=True)).astype(np.float32)
    return normals if kinds is None else normals[rng.integers(0, kinds, count)]


def cosine(normals, u, v):
    a, b = normals[u].astype(float), normals[v].astype(float)
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def sign(normals, u, v):
    return -1.0 if cosine(normals, u, v) < 0 else 1.0


def span_by_kruskal(kruskal, lists, normals):
    count, k = lists.shape
    weights = [np.float32(1 - abs(cosine(normals, v, u))).clip(0) for v in range(count) for u in lists[v]]
    for entry in np.argsort(weights, kind="stable"):  # ties by the listing vertex, then by place
        u, v = entry // k, lists.flat[entry]
        kruskal.join(u, v, sign(normals, u, v))


def bridge_by_kruskal(kruskal, points, normals):
    u, v = np.triu_indices(len(points), 1)
    d = points[v] - points[u]
    sqdists = d[:, 0] * d[:, 0] + d[:, 1] * d[:, 1] + d[:, 2] * d[:, 2]
    for pair in np.argsort(sqdists, kind="stable"):  # ties by the lower rank, then by the higher
        kruskal.join(u[pair], v[pair], sign(normals, u[pair], v[pair]))


def read_forest(forest):
    links = download(forest.links)
    labels, signs = links >> 1, 1.0 - 2 * (links & 1)
    assert (np.unique(labels) == download(forest.roots)).all()
    assert (links[download(forest.roots)] == 2 * download(forest.roots)).all()
    lowest = np.array([np.flatnonzero(labels == label)[0] for label in labels], int)
    return lowest, signs * signs[lowest]


def assert_same(forest, kruskal):
    for result, expected in zip(read_forest(forest), kruskal.relative(), strict=True):
        np.testing.assert_array_equal(result, expected)


def span(device, lists, normals, cut):
    count, k = lists.shape
    parts = [(0, lists[:cut]), (cut, lists[cut:])]
    parts = [(begin, upload(rows.ravel(), int32, device)) for begin, rows in parts if len(rows)]
    forest = Forest(count, device)
    span_neighbors(forest, parts, k, upload(normals, vec3, device))
    return forest


@given(seed=st.integers(0, 10_000), count=st.integers(1, 60), k=st.integers(1, 5), kinds=st.sampled_from([2, 5, 60]))
@SETTINGS
def test_signs_follow_the_minimum_spanning_trees(device, seed, count, k, kinds):
    """Any directed graph, loops, repeats and equal weights among its edges, in one part or in two."""
    rng = np.random.default_rng(seed)
    lists, normals = rng.integers(0, count, (count, k)), unit_normals(rng, count, kinds)
    kruskal = Kruskal(count)
    span_by_kruskal(kruskal, lists, normals)
    assert_same(span(device, lists, normals, int(rng.integers(0, count + 1))), kruskal)


@given(seed=st.integers(0, 10_000), count=st.integers(2, 150), span_first=st.booleans(), lattice=st.booleans())
@SETTINGS
def test_bridges_are_those_of_the_euclidean_spanning_tree(device, seed, count, span_first, lattice):
    """From single points or from parts of them; on a lattice most distances are tied and points fall together."""
    rng = np.random.default_rng(seed)
    points = rng.integers(0, 4, (count, 3)) if lattice else rng.normal(size=(count, 3)) ** 3
    tree = PointTree(upload(points, vec3, device))
    normals, kruskal = unit_normals(rng, count), Kruskal(count)
    forest = Forest(count, device)
    if span_first:
        lists = np.clip(np.arange(count)[:, None] + rng.integers(0, 3, (count, 2)), 0, count - 1)
        forest = span(device, lists, normals, count)
        span_by_kruskal(kruskal, lists, normals)
    bridge_components(forest, tree, upload(normals, vec3, device))
    bridge_by_kruskal(kruskal, download(tree.points)[: tree.count], normals)
    assert forest.roots.size == 1
    assert_same(forest, kruskal)


@pytest.mark.parametrize("count", [2, HOPS, HOPS + 2, 9000])
def test_chains_of_any_length_are_one_component_after_one_round(device, count):
    """Each edge is lighter than the one before it, so every vertex hangs under the next."""
    angles = np.concatenate([[0], np.cumsum(np.linspace(1.2, 0.01, count - 1))])
    normals = np.stack([np.cos(angles), np.sin(angles), 0 * angles], axis=1).astype(np.float32)
    lists = np.minimum(np.arange(count) + 1, count - 1)[:, None]
    forest = span(device, lists, normals, count)
    links = download(forest.links)
    assert len(np.unique(links >> 1)) == 1
    signs = 1.0 - 2 * (links & 1)
    steps = np.array([sign(normals, i, i + 1) for i in range(count - 1)])
    np.testing.assert_array_equal(signs[1:] * signs[:-1], steps)


def test_a_component_far_from_a_dense_one_is_bridged_by_the_nearest_pair(device, rng):
    """The traversal skips its own component: both parts are larger than many buckets."""
    points = np.concatenate([rng.random((3000, 3)), rng.random((2000, 3)) + np.array([40, 0, 0])]).astype(np.float32)
    tree = PointTree(upload(points, vec3, device))
    tree_points = download(tree.points)[: tree.count]
    right = tree_points[:, 0] > 20
    follow = np.arange(5000)  # each vertex lists the next of its side: two components
    for side in (right, ~right):
        ranks = np.flatnonzero(side)
        follow[ranks[:-1]] = ranks[1:]
    normals = unit_normals(rng, 5000)
    forest = span(device, follow[:, None], normals, 5000)
    assert forest.roots.size == 2
    before = 1.0 - 2 * (download(forest.links) & 1)
    bridge_components(forest, tree, upload(normals, vec3, device))
    links = download(forest.links)
    signs = 1.0 - 2 * (links & 1)
    a, b = np.flatnonzero(~right), np.flatnonzero(right)
    d = tree_points[b][None] - tree_points[a][:, None]
    sqdists = d[..., 0] * d[..., 0] + d[..., 1] * d[..., 1] + d[..., 2] * d[..., 2]
    i, j = np.unravel_index(sqdists.argmin(), sqdists.shape)
    assert signs[a[i]] * signs[b[j]] == sign(normals, a[i], b[j])
    for side in (a, b):
        np.testing.assert_array_equal(signs[side] * signs[side[0]], before[side] * before[side[0]])


@pytest.mark.parametrize("count", [2, BUCKET + 1, FAN * BUCKET + 1, 700])
def test_children_that_are_not_there_belong_to_no_component(device, count, rng, monkeypatch):
    """For any previous contents of the memory: here the number of an existing component."""
    monkeypatch.setattr(orientation, "empty", lambda shape, dtype, target: full(shape, 1, dtype, target))
    tree = PointTree(upload(rng.random((count, 3)), vec3, device))
    bridges = orientation.Bridges(tree, Forest(count, device))
    bridges.label_nodes()
    owners, firsts = download(bridges.owners).reshape(-1, FAN), download(tree.levels)
    children = -(-count // LEAF)
    for first, last in itertools.pairwise(firsts):
        level = owners[first:last].ravel()
        assert (level[:children] != orientation.EMPTY).all()
        assert (level[children:] == orientation.EMPTY).all()
        children = last - first


def test_components_whose_squared_distance_is_infinite_are_bridged(device, rng):
    """Then no distance bounds the traversal: it stays inside the tree because missing children have no component."""
    points = rng.random((8 * BUCKET + 1, 3))
    points[7] = [1e25, 0, 0]
    forest, normals = Forest(len(points), device), upload(unit_normals(rng, len(points)), vec3, device)
    bridge_components(forest, PointTree(upload(points, vec3, device)), normals)
    assert forest.roots.size == 1


def test_components_that_hang_under_each_other_are_refused(device):
    forest = Forest(3, device)
    forest.hooks = upload(np.array([2, 4, 0]), int32, device)
    with pytest.raises(RuntimeError, match="in a cycle"):
        forest.merge()


def test_too_many_vertices_and_entries_are_refused():
    with pytest.raises(ValueError, match=r"more than 2\^30"):
        Forest(2**30 + 1, "cpu")
    with pytest.raises(ValueError, match=r"more than 2\^33"):
        span_neighbors(Forest(3, "cpu"), [], 2**32, None)
