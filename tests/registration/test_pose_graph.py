"""Pose graphs: results of `global_optimization`, and their invariances."""

from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointloom import registration as reg

from .pose_rings import (
    METHODS,
    TIGHT,
    confidences_of,
    cost_of,
    ends_of,
    information,
    poses_of,
    ring,
    shaken,
    solve,
    to_graph,
)
from .poses import as_pose


@pytest.mark.parametrize("seed", [3, pytest.param(8, marks=pytest.mark.slow)])
def test_both_methods_converge_to_the_same_minimum(seed, tolerances):
    """Open3D's Gauss-Newton anchors no node and its system is singular: both results are wrong at one distance."""
    scene = ring(60, seed=seed, noise=0.02, outliers=10)
    for distance in (0.1, 0.3):
        first, second = (solve(scene, method, distance, **TIGHT) for method in METHODS)
        assert ends_of(first) == ends_of(second)
        assert first.report.residual == pytest.approx(second.report.residual, rel=tolerances.graph_cost)
        assert set(scene.wrong) <= set(first.report.pruned_edges.tolist())


def test_the_minimum_cost_is_stationary():
    """No small motion of any node lowers the cost computed here, with contradictions among the certain edges."""
    scene = ring(6, seed=2, noise=0.05, certain=True)
    i, j, X, Lambda, _ = scene.edges[0]
    rng = np.random.default_rng(4)
    scene.edges.append((j, i, shaken(np.linalg.inv(X), rng, 0.1), Lambda, False))
    scene.edges.append((1, 3, shaken(np.linalg.inv(scene.true[3]) @ scene.true[1], rng, 0.2), Lambda, True))
    solved = solve(scene, distance=1.0, **TIGHT)
    assert 0.3 < solved.edges[-1].confidence < 0.99
    poses = poses_of(solved)
    cost, step = cost_of(poses, scene.edges, 1.0), 1e-4
    curvatures = []
    for node in range(1, len(poses)):
        for direction in np.eye(6) * step:
            there = [poses.copy(), poses.copy()]
            for moved, sign in zip(there, (1, -1), strict=True):
                moved[node] = as_pose(sign * direction[:3], sign * direction[3:]) @ moved[node]
            up, down = (cost_of(moved, scene.edges, 1.0) for moved in there)
            curvatures.append(up + down - 2 * cost)
            assert step / 2 * abs(up - down) / curvatures[-1] < 1e-6  # the distance to the minimum along this direction
    assert min(curvatures) > 0


@pytest.mark.parametrize("method", METHODS)
@given(data=st.data())
@settings(max_examples=10, deadline=None)
def test_trees_are_solved_exactly(method, data):
    count = data.draw(st.integers(2, 12))
    rng = np.random.default_rng(data.draw(st.integers(0, 2**32)))
    parents = [data.draw(st.integers(0, i - 1)) for i in range(1, count)]
    true = [as_pose(rng.normal(0, 2, 3), rng.uniform(-10, 10, 3)) for _ in range(count)]
    edges = []
    for child, parent in enumerate(parents, 1):
        i, j = (child, parent) if data.draw(st.booleans()) else (parent, child)
        edges.append((i, j, np.linalg.inv(true[j]) @ true[i], information(rng), False))
    poses = np.array([true[0], *(shaken(T, rng, 0.2) for T in true[1:])])
    solved = solve(SimpleNamespace(poses=poses, edges=edges), method, **TIGHT)
    np.testing.assert_allclose(poses_of(solved), true, rtol=0, atol=1e-6)
    assert solved.report.residual < 1e-9
    assert len(solved.edges) == count - 1


@pytest.mark.parametrize(("method", "reference"), [(METHODS[0], 0), (METHODS[1], 7), (METHODS[0], 19)])
def test_the_reference_pose_is_bitwise_unchanged(reference, method):
    scene = ring(20, seed=5)
    solved = solve(scene, method, reference=reference)
    assert np.array_equal(solved.nodes[reference].pose, scene.poses[reference])
    other = solve(scene, method, reference=0 if reference else 1)
    to_reference = [np.linalg.inv(poses_of(g)[reference]) @ poses_of(g) for g in (solved, other)]
    np.testing.assert_allclose(*to_reference, rtol=0, atol=1e-5)


def test_a_duplicate_edge_counts_as_one_of_twice_the_information():
    scene = ring(10, seed=7, noise=0.02, certain=True)
    i, j, X, Lambda, _ = scene.edges[3]
    doubled = SimpleNamespace(poses=scene.poses, edges=[*scene.edges, scene.edges[3]])
    weighted = SimpleNamespace(poses=scene.poses, edges=list(scene.edges))
    weighted.edges[3] = (i, j, X, 2 * Lambda, False)
    A, B = (poses_of(solve(s, **TIGHT)) for s in (doubled, weighted))
    np.testing.assert_allclose(A, B, rtol=0, atol=1e-8)
    assert np.abs(A - poses_of(solve(scene, **TIGHT))).max() > 1e-5


def test_contradictory_certain_edges_are_balanced():
    two = [(0, 1, as_pose([0, 0, 0], [x, 0, 0]), weight * np.eye(6), False) for x, weight in ((1, 1), (2, 3))]
    solved = solve(SimpleNamespace(poses=np.tile(np.eye(4), (2, 1, 1)), edges=two), **TIGHT)
    np.testing.assert_allclose(solved.nodes[1].pose, as_pose([0, 0, 0], [-1.75, 0, 0]), rtol=0, atol=1e-7)
    assert solved.report.residual == pytest.approx(0.75**2 + 3 * 0.25**2)
    assert len(solved.edges) == 2


def test_an_edge_at_the_threshold_is_dropped():
    """Open3D's rule: edges with a confidence above the threshold are kept."""
    certain = reg.PoseGraphEdge(0, 1)
    loop = reg.PoseGraphEdge(0, 1, uncertain=True)  # met exactly: confidence 1
    for threshold, count in ((1.0, 1), (1 - 1e-9, 2)):
        option = reg.GlobalOptimizationOption(edge_prune_threshold=threshold)
        graph = reg.PoseGraph([reg.PoseGraphNode(), reg.PoseGraphNode()], [certain, loop])
        assert len(reg.global_optimization(graph, option=option).edges) == count


def test_confidence_follows_from_the_residual():
    scene = ring(12, seed=8, noise=0.01)
    solved, distance = solve(scene, distance=0.1), 0.1
    assert len(solved.edges) == len(scene.edges)
    mu = distance**2 * np.mean([edge.information[5, 5] for edge in solved.edges])  # of certain ones too, as Open3D
    assert solved.report.line_process_weight == pytest.approx(mu)
    for edge in solved.edges:
        alone = [(edge.source_node_id, edge.target_node_id, edge.transformation, edge.information, False)]
        r = cost_of(poses_of(solved), alone, distance)
        assert edge.confidence == (pytest.approx((mu / (mu + r)) ** 2, rel=1e-9) if edge.uncertain else 1)
    assert any(0.25 < edge.confidence < 0.999 for edge in solved.edges)


def test_preference_and_threshold_determine_the_remaining_edges():
    scene = ring(12, seed=8, noise=0.02)
    graph, counts = to_graph(scene), []
    before = poses_of(graph), confidences_of(graph)
    for preference, threshold in ((0.1, 0.25), (1.0, 0.25), (10.0, 0.25), (1.0, 0.0), (1.0, 1.0)):
        option = reg.GlobalOptimizationOption(0.05, threshold, preference, 0)
        solved = reg.global_optimization(graph, option=option)
        assert all(edge.confidence > threshold for edge in solved.edges if edge.uncertain)
        counts.append(sum(edge.uncertain for edge in solved.edges))
    uncertain = sum(edge.uncertain for edge in graph.edges)
    assert counts[0] < counts[1] < counts[2] == counts[3] == uncertain, counts
    assert counts[4] == 0
    assert graph.report is None and len(graph.edges) == len(scene.edges), "the graph that was given stays as it was"
    for old, new in zip(before, (poses_of(graph), confidences_of(graph)), strict=True):
        np.testing.assert_array_equal(old, new)
