"""Orientation of normals, spanning trees equal to those of Kruskal, and spreads of values over neighbors."""

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from pointloom.kernels.lang import INFINITY, float64, int32, vec3
from pointloom.kernels.memory import download, upload
from pointloom.kernels.search.point_tree import BUCKET, PointTree
from pointloom.kernels.surface.hollow_side import find_sides
from pointloom.kernels.surface.normals import align_normals, estimate_normals, orient_normals
from pointloom.kernels.surface.orientation import bridge_components
from pointloom.kernels.surface.spanning_tree import MAX_HOPS, Forest, span_neighbors
from pointloom.kernels.surface.value_spreads import spread_values

from ..vectors import vectors

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


@pytest.mark.parametrize("count", [2, MAX_HOPS, MAX_HOPS + 2, 9000])
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


def test_zero_normals_take_the_direction_and_nan_normals_stay(device, tolerances):
    rows = [[0, 0, 0], [1, 1, 1], [2, 0, 0]], [[0, 0, 0], [np.nan] * 3, [0, 0, 0]]
    points, n = (vectors(device, values) for values in rows)
    oriented = orient_normals(points, n, [0, 3, 4], False).numpy()
    np.testing.assert_allclose(oriented[[0, 2]], [[0, 0.6, 0.8]] * 2, rtol=tolerances.unit_length)
    assert np.isnan(oriented[1]).all()
    oriented = orient_normals(points, n, [2, 0, 0], True).numpy()
    assert oriented[[0, 2]].tolist() == [[1, 0, 0], [0, 0, 1]], "a camera on the point gives the z axis"


def test_normals_are_aligned_with_their_references(device):
    n = vectors(device, [[0, 0, 1], [0, 0, 1], [0, 0, 1], [1, 0, 0]])
    align_normals(n, vectors(device, [[0, 0, -2], [0, 1, 0.1], [np.nan] * 3, [0, 1, 0]]))
    assert n.numpy().tolist() == [[0, 0, -1], [0, 0, 1], [0, 0, 1], [1, 0, 0]]


@pytest.mark.parametrize("axis", [0, 1, 2])
@pytest.mark.parametrize("limits", [(12, INFINITY), (None, 5.0)])
def test_a_plane_far_from_zero_has_its_normal(device, rng, limits, axis):
    """8,000 km away, where a float32 is a metre: squares of the coordinates themselves would cost 1e-3 of a normal."""
    i, j = np.divmod(rng.permutation(400), 20)
    offset = np.zeros(3)
    offset[axis] = 2.0**23
    where = vectors(device, np.column_stack([2 * i, 2 * j, i + j]) + offset)
    tree, expected = PointTree(where), np.array([1, 1, -2]) / np.sqrt(6)
    for normals in (estimate_normals(tree, *limits).numpy(), find_sides(tree, 5.0, 5.0).numpy()):
        assert np.abs(np.abs(normals @ expected) - 1).max() < 1e-6
        assert np.linalg.norm(np.cross(normals, expected), axis=1).max() < 1e-6


RADIUS = 0.2


def test_spreads_are_those_of_the_finite_numbers_of_the_neighbors(device, rng):
    points, values = rng.random((300, 3)).astype(np.float32), rng.normal(size=300)
    points[0] = 5.0  # a point without neighbors
    values[1:30:3] = [np.nan, np.inf] * 5
    result = spread_values(PointTree(upload(points, vec3, device)), upload(values, float64, device), RADIUS)
    near = np.linalg.norm(points[:, None].astype(float) - points[None], axis=2) < RADIUS
    groups = [values[row & np.isfinite(values)] for row in near]
    known = np.isfinite(values)
    counts = np.where(known, [len(group) for group in groups], 0)
    np.testing.assert_array_equal(download(result.counts), counts)
    assert counts[0] == 1 and counts.max() > 5
    means = [group.mean() if one else np.nan for group, one in zip(groups, known, strict=True)]
    np.testing.assert_allclose(download(result.means), means, rtol=1e-12, atol=1e-12)
    spreads = [group.std(ddof=1) if n > 1 else np.nan for group, n in zip(groups, counts, strict=True)]
    np.testing.assert_allclose(download(result.deviations), spreads, rtol=1e-9, atol=1e-12)
