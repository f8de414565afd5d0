"""Pose graphs that are empty, disconnected, underdetermined or invalid, and arguments out of range."""

from types import SimpleNamespace

import numpy as np
import pytest

from pointloom import registration as reg

from .pose_rings import METHODS, TIGHT, poses_of, ring, solve, to_graph
from .poses import as_pose


def test_nodes_separated_by_pruning_are_named():
    """A node connected only by a wrong edge keeps its pose, and the report names it."""
    scene = ring(8, seed=11, certain=True)
    good = scene.edges[0][3]
    for x in (1.0, -30.0):
        scene.edges.append((8, 2, as_pose([0, 0, 0], [x, 0, 0]), good, True))
    scene.poses = np.concatenate([scene.poses, [as_pose([0, 0, 0], [100, 0, 0])]])
    solved = solve(scene, distance=0.05)
    assert len(solved.edges) == len(scene.edges) - 1 and not len(solved.report.unreached_nodes)
    option = reg.GlobalOptimizationOption(0.05, edge_prune_threshold=1.0, reference_node=0)
    solved = reg.global_optimization(to_graph(scene), option=option)
    assert solved.report.unreached_nodes.tolist() == [8] and "1 nodes" in solved.report.warnings[-1]
    assert all(not edge.uncertain for edge in solved.edges)
    assert len(solved.nodes) == 9 and np.isfinite(poses_of(solved)).all()


def test_graphs_of_at_most_two_nodes():
    """Open3D crashes without nodes."""
    empty = reg.global_optimization(reg.PoseGraph())
    assert (empty.nodes, empty.edges, empty.report.iterations) == ([], [], 0)
    T = as_pose([0.1, 0.2, 0.3], [1, 2, 3])
    for reference in (-1, 0):
        option = reg.GlobalOptimizationOption(reference_node=reference)
        single = reg.global_optimization(reg.PoseGraph([reg.PoseGraphNode(T)]), option=option)
        np.testing.assert_allclose(single.nodes[0].pose, T, rtol=0, atol=1e-12)
        assert single.report.converged


@pytest.mark.parametrize("method", METHODS)
def test_undetermined_motions_are_unchanged(method):
    """Information of rank 5, and none at all: the rest is solved, those directions keep their values."""
    flat = np.diag([50.0, 50, 0, 0, 0, 100])  # a plane: no information about x, y and rotation about z
    start = as_pose([0, 0, 0.3], [0.4, 0.2, 0.1])
    edges = [(0, 1, np.eye(4), flat, False), (1, 2, np.eye(4), np.zeros((6, 6)), False)]
    poses = np.array([np.eye(4), start, as_pose([0.1, 0, 0], [7, 8, 9])])
    solved = poses_of(solve(SimpleNamespace(poses=poses, edges=edges), method, **TIGHT))
    np.testing.assert_allclose(solved[1], as_pose([0, 0, 0.3], [0.4, 0.2, 0]), rtol=0, atol=1e-7)
    np.testing.assert_allclose(solved[2], poses[2], rtol=0, atol=1e-9)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda g: g.edges.__delitem__(slice(3, None)), r"no path of edges joins node 0 to nodes 4, 5, 6, 7\."),
        (lambda g: setattr(g.nodes[1], "pose", np.full((4, 4), np.nan)), r"nodes\[1\]\.pose: .* NaN"),
        (lambda g: setattr(g.nodes[1], "pose", np.eye(3)), r"nodes\[1\]\.pose: expected shape \[4, 4\], got \[3, 3\]"),
        (lambda g: setattr(g.edges[4], "information", np.full((6, 6), np.inf)), r"edges\[4\]\.information: .* finite"),
        (lambda g: setattr(g.edges[0], "confidence", 0.5), r"edges\[0\]\.confidence: expected 1 for a certain edge"),
        (lambda g: setattr(g.edges[8], "confidence", np.nan), r"edges\[8\]\.confidence: expected 0\.\.1, got nan"),
        (
            lambda g: [setattr(edge, "information", np.zeros((6, 6))) for edge in g.edges],
            r"expected the number of correspondences in information\[5, 5\]",
        ),
    ],
)
def test_invalid_graphs_are_rejected_by_name(change, message):
    graph = to_graph(ring(8, seed=13, loops=6))
    change(graph)
    with pytest.raises(ValueError, match=message):
        reg.global_optimization(graph)


def test_disconnected_components_are_counted():
    nodes = [reg.PoseGraphNode() for _ in range(40)]
    edges = [reg.PoseGraphEdge(i, i + 1) for i in range(39) if i not in (9, 19)]
    expected = r"node 5 to nodes 10, 11, 12, 13, 14, 15, 16, 17, 18, 19 and 20 more\. Optimize the 3 parts"
    with pytest.raises(ValueError, match=expected):
        option = reg.GlobalOptimizationOption(reference_node=5)
        reg.global_optimization(reg.PoseGraph(nodes, edges), option=option)


def test_too_few_iterations_are_reported():
    scene = ring(20, seed=14, noise=0.02)
    solved = solve(scene, max_iteration=1)
    assert (solved.report.converged, solved.report.criterion, solved.report.iterations) == (False, "max_iteration", 2)
    assert not solved.report.reliable and "within 2 iterations" in solved.report.warnings[0]
    assert solved.report.residual < solved.report.initial_residual
