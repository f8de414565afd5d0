"""The graph of correspondences that keep their distances, its counts and peaks, and the poses found from it."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointloom.kernels.lang import cpu_compiler, int32, int64, vec3
from pointloom.kernels.memory import upload
from pointloom.kernels.poses.consensus_poses import CompatibilityGraph, distinct_poses, find_consensus, order_descending
from pointloom.kernels.poses.pair_fits import PairCoordinates


def make_pairs(p, q, device="cpu"):
    rows = np.repeat(np.arange(len(p), dtype=np.int32)[:, None], 2, axis=1)
    points = [upload(np.asarray(a, np.float32), vec3, device) for a in (p, q)]
    return PairCoordinates(*points, upload(rows, int32, device), np.zeros(3, np.float32), np.zeros(3, np.float32))


def edges_of(graph):
    words = graph.bits.numpy().reshape(graph.count, graph.words).view(np.uint32)
    return ((words[:, :, None] >> np.arange(32, dtype=np.uint32)) & 1).reshape(graph.count, -1).astype(bool)


def distances(p):
    return np.linalg.norm(p[:, None].astype(np.float64) - p[None], axis=2)


def brute_edges(p, q, bound, min_length):
    """The edges, and which of them no rounding can change."""
    a, b = distances(p), distances(q)
    sure = (np.abs(np.abs(a - b) - bound) > 1e-5) & (np.abs(np.minimum(a, b) - min_length) > 1e-5)
    return (np.abs(a - b) <= bound) & (np.minimum(a, b) > min_length), sure


@pytest.mark.parametrize("count", [1, 2, 31, 32, 33, 200])
def test_edges_connect_pairs_of_equal_length(device, rng, count):
    p, q = rng.random((2, count, 3)).astype(np.float32)
    graph = CompatibilityGraph(make_pairs(p, q, device), 0.1, 0.2)
    edges = edges_of(graph)
    expected, sure = brute_edges(p, q, 0.1, 0.2)
    assert not edges[:, count:].any()
    edges = edges[:, :count]
    assert (edges == expected)[sure].all() and sure.mean() > 0.99
    assert (edges == edges.T).all() and not np.diag(edges).any()
    assert (graph.degrees.numpy() == edges.sum(axis=1)).all()


@pytest.mark.parametrize("compiler", ["warp", pytest.param("taichi", marks=pytest.mark.slow)])
@settings(max_examples=30, deadline=None)
@given(rows=st.lists(st.tuples(*[st.integers(0, 4)] * 6).map(lambda t: tuple(map(float, t))), min_size=1, max_size=40))
def test_counts_are_those_of_brute_force_on_lattices_and_duplicates(compiler, rows):
    points = np.array(rows, np.float32)
    with cpu_compiler(compiler):
        graph = CompatibilityGraph(make_pairs(points[:, :3], points[:, 3:]), 0.3, 0.3)
        edges = edges_of(graph)[:, : len(points)].astype(int)
        expected, sure = brute_edges(points[:, :3], points[:, 3:], 0.3, 0.3)
        assert sure.all() and (edges == expected).all()
        common = edges @ edges * edges
        sums = graph.support()
        assert (sums.numpy() == common.sum(axis=1)).all()
        chosen = upload(np.arange(len(points))[::3], int32, "cpu")
        assert (graph.common(chosen).numpy().reshape(-1, len(points)) == common[::3]).all()


def test_support_counts_the_vertices_of_highest_degree_first(device, rng):
    p, q = rng.random((2, 100, 3)).astype(np.float32)
    graph = CompatibilityGraph(make_pairs(p, q, device), 0.2, 0.0)
    full_support, degrees = graph.support().numpy(), graph.degrees.numpy()
    part = graph.support(work=int(degrees.sum()) * graph.words // 4).numpy()
    counted = part > 0
    assert 0 < counted.sum() < 60 and (part[counted] == full_support[counted]).all()
    assert degrees[counted].min() >= degrees[~counted].max()


def test_peaks_are_local_maxima(device, rng):
    p, q = rng.random((2, 150, 3)).astype(np.float32)
    graph = CompatibilityGraph(make_pairs(p, q, device), 0.2, 0.0)
    sums = graph.support()
    values, radius = sums.numpy(), 0.4
    near = (distances(p) < radius) & (distances(q) < radius)
    index = np.arange(150)
    stronger = (values[None] > values[:, None]) | ((values[None] == values[:, None]) & (index[None] < index[:, None]))
    expected = np.flatnonzero(~(near & stronger).any(axis=1) & (values > 0))
    expected = expected[np.argsort(-values[expected], kind="stable")]
    assert 10 < len(expected) < 140
    assert graph.peaks(sums, radius, 1000).numpy().tolist() == expected.tolist()
    assert graph.peaks(sums, radius, 7).numpy().tolist() == expected[:7].tolist()


def test_descending_order_keeps_ties_in_order(device):
    values = upload(np.array([3, 9, 3, 0, 9, 2**40]), int64, device)
    assert order_descending(values).numpy().tolist() == [5, 1, 4, 0, 2, 3]


def test_poses_that_move_the_source_alike_are_one():
    spread = np.vstack([np.eye(3), -np.eye(3)])
    poses = np.tile(np.eye(4), (4, 1, 1))
    poses[1, 0, 3], poses[2, 0, 3], poses[3, 1, 3] = 0.05, 0.3, 1.0
    assert distinct_poses(poses, spread, 0.1).tolist() == [0, 2, 3]
    assert distinct_poses(poses[:0], spread, 0.1).tolist() == []


def test_two_motions_give_two_poses_the_larger_first(device, rng):
    p = rng.random((300, 3))
    q = rng.random((300, 3))
    q[:60] = p[:60] + np.array([0.5, 0, 0])
    q[60:100] = p[60:100][:, [1, 2, 0]]
    poses, saved = find_consensus(make_pairs(p, q, device), 0.02, 0.02, np.vstack([np.eye(3), -np.eye(3)]) / 3)
    assert 59.9 < saved[0] < 66 and 39.9 < saved[1] < 46 and (np.diff(saved) <= 0).all()
    np.testing.assert_allclose(poses[0][:3], np.column_stack([np.eye(3), [0.5, 0, 0]]), atol=1e-3)
    np.testing.assert_allclose(poses[1][:3, :3], np.eye(3)[[1, 2, 0]], atol=1e-3)


@pytest.mark.parametrize("count", [0, 1, 2])
def test_fewer_than_three_correspondences_give_no_pose(device, rng, count):
    p, q = rng.random((2, count, 3))
    poses, saved = find_consensus(make_pairs(p, q, device), 0.1, 0.1, np.eye(3))
    assert poses.shape == (0, 4, 4) and saved.shape == (0,)


def test_coincident_correspondences_give_no_pose(device):
    p = np.ones((50, 3))
    assert len(find_consensus(make_pairs(p, p + 1, device), 0.1, 0.1, np.eye(3))[0]) == 0
