"""Connected components of a graph against SciPy's."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from pointloom.registration.pose_graphs.connected_parts import connected_parts


def scipys(source, target, count) -> np.ndarray:
    return connected_components(coo_matrix((np.ones(len(source)), (source, target)), (count, count)), directed=False)[1]


@given(st.integers(1, 60), st.integers(0, 80), st.integers(0, 2**31 - 1))
@settings(deadline=None)
def test_components_are_numbered_as_in_scipy(count, edges, seed):
    source, target = np.random.default_rng(seed).integers(0, count, (2, edges))
    parts = connected_parts(source, target, count)
    assert parts.dtype == np.int32
    np.testing.assert_array_equal(parts, scipys(source, target, count))


@pytest.mark.parametrize("shape", ["chain", "shuffled chain", "star", "comb"])
def test_long_graphs_are_one_component(shape, rng):
    order = rng.permutation(20_000) if shape.startswith("shuffled") else np.arange(20_000)
    source, target = order[:-1], order[1:]
    if shape == "star":
        source = np.full(19_999, 19_999)
        target = order[:-1]
    if shape == "comb":
        source, target = np.arange(10_000, 20_000), np.arange(10_000)
        source, target = np.append(source, source[:-1]), np.append(target, source[1:])
    assert not connected_parts(source, target, 20_000).any()


def test_a_graph_without_nodes_has_no_components():
    assert connected_parts(np.zeros(0, np.int64), np.zeros(0, np.int64), 0).shape == (0,)
