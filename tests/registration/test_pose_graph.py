"""Pose graphs: results and invariances of `global_optimization`, Open3D's results, invalid input, and files."""

import json
import re
import tempfile
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

from pointloom import registration as reg
from pointloom.core.errors import FileError
from pointloom.registration.rigid import invert_pose, make_pose, rotation_of

from ..products import few_quick
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
        (
            lambda g: setattr(g.nodes[1], "pose", np.eye(4).ravel()),
            r"nodes\[1\]\.pose: expected shape \[4, 4\], got \[16\]",
        ),
        (
            lambda g: [setattr(node, "pose", np.eye(4).ravel()) for node in g.nodes],
            r"nodes\[0\]\.pose: expected shape \[4, 4\], got \[16\]",
        ),
        (
            lambda g: [setattr(edge, "information", np.eye(3)) for edge in g.edges],
            r"edges\[0\]\.information: expected shape \[6, 6\], got \[3, 3\]",
        ),
        (lambda g: setattr(g.edges[2], "confidence", [1.0]), r"edges\[2\]\.confidence: expected shape \[\], got \[1\]"),
        (
            lambda g: setattr(g.edges[2], "confidence", 10**400),
            r"edges\[2\]\.confidence: expected real numbers, got int",
        ),
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
    with pytest.raises((TypeError, ValueError), match=message):
        reg.global_optimization(graph)


def test_disconnected_components_are_counted():
    nodes = [reg.PoseGraphNode() for _ in range(40)]
    edges = [reg.PoseGraphEdge(i, i + 1) for i in range(39) if i not in (9, 19)]
    expected = r"node 5 to nodes 10, 11, 12, 13, 14, 15, 16, 17, 18, 19 and 20 more\. Optimize the 3 parts"
    with pytest.raises(ValueError, match=expected):
        option = reg.GlobalOptimizationOption(reference_node=5)
        reg.global_optimization(reg.PoseGraph(nodes, edges), option=option)


def solve_from_afar(**criteria):
    """The report of a graph whose first four attempts raise the cost, so that its damping grows."""
    scene, rng = ring(30, seed=4, noise=0.02, loops=4), np.random.default_rng(5)
    scene.poses = np.array([shaken(T, rng, 1.2) for T in scene.poses])
    return solve(scene, distance=5.0, max_iteration=1000, **criteria).report


def test_steps_grow_as_fast_as_the_factors_of_the_damping_allow():
    factors = [(0.0, 0.0), (0.0, 1.0), (0.9, 1.0), (1.0, 1.0)]
    reports = [solve_from_afar(lower_scale_factor=low, upper_scale_factor=high) for low, high in factors]
    counts = [report.iterations for report in reports]
    assert counts == sorted(set(counts)) and counts[1] > 1.5 * counts[0] and counts[3] > 5 * counts[1]
    assert all(report.converged for report in reports)


@pytest.mark.parametrize(("attempts", "ends"), [(3, "max_iteration_lm"), (5, "min_relative_residual_increment")])
def test_attempts_with_more_damping_end_at_their_maximum(attempts, ends):
    report = solve_from_afar(max_iteration_lm=attempts)
    assert report.criterion == ends and (report.iterations > 0) == report.converged == (attempts == 5)


def test_too_few_iterations_are_reported():
    scene = ring(20, seed=14, noise=0.02)
    solved = solve(scene, max_iteration=1)
    assert (solved.report.converged, solved.report.criterion, solved.report.iterations) == (False, "max_iteration", 2)
    assert not solved.report.reliable and "within 2 iterations" in solved.report.warnings[0]
    assert solved.report.residual < solved.report.initial_residual


def solve_by_open3d(o3d, scene, method="LevenbergMarquardt", distance=0.05, reference=0, **values):
    theirs = o3d.pipelines.registration
    graph, criteria = theirs.PoseGraph(), theirs.GlobalOptimizationConvergenceCriteria()
    for T in scene.poses:
        graph.nodes.append(theirs.PoseGraphNode(T))
    for edge in scene.edges:
        graph.edges.append(theirs.PoseGraphEdge(*edge[:4], uncertain=edge[4]))
    for name, value in values.items():
        setattr(criteria, name, value)
    option = theirs.GlobalOptimizationOption(max_correspondence_distance=distance, reference_node=reference)
    theirs.global_optimization(graph, getattr(theirs, f"GlobalOptimization{method}")(), criteria, option)
    return poses_of(graph), confidences_of(graph), np.array(ends_of(graph), np.int32)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(("count", "outliers"), [(8, 0), (20, 5)])
def test_poses_confidences_and_edges_match_open3d(oracle, count, outliers, method, tolerances):
    scene = ring(count, seed=count + outliers, outliers=outliers)
    result, name = solve(scene, method, **TIGHT), f"registration/pose_graphs/{method}_{count}_{outliers}"
    poses, confidences, ends = oracle(name, solve_by_open3d, scene, method, **TIGHT)
    np.testing.assert_array_equal(ends_of(result), ends)
    assert result.report.pruned_edges.tolist() == scene.wrong
    np.testing.assert_allclose(poses_of(result), poses, rtol=0, atol=tolerances.graph_pose)
    np.testing.assert_allclose(confidences_of(result), confidences, rtol=0, atol=tolerances.graph_confidence)
    remaining = [edge for i, edge in enumerate(scene.edges) if i not in result.report.pruned_edges]
    for form in (True, False):
        result_cost, their_cost = (cost_of(some, remaining, 0.05, form) for some in (poses_of(result), poses))
        assert abs(result_cost - their_cost) <= tolerances.graph_cost * their_cost
    assert result.report.residual == pytest.approx(cost_of(poses_of(result), remaining, 0.05), rel=1e-9)


@few_quick(
    1, ("method", "noise", "distance"), [(METHODS[0], 0.02, 0.1), (METHODS[1], 0.02, 0.3), (METHODS[0], 0.05, 0.3)]
)
def test_default_criteria_give_open3ds_residual_and_edges(oracle, noise, distance, method):
    scene = ring(60, seed=4, noise=noise, outliers=10)
    result, name = solve(scene, method, distance), f"registration/pose_graphs/usual_{method}_{noise}_{distance}"
    poses, _, ends = oracle(name, solve_by_open3d, scene, method, distance)
    np.testing.assert_array_equal(ends_of(result), ends)
    assert result.report.pruned_edges.tolist() == scene.wrong
    reference_cost = cost_of(poses, scene.edges, distance)
    assert cost_of(poses_of(result), scene.edges, distance) <= reference_cost * (1 + 1e-5) and result.report.converged


def information_of(o3d, points):
    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(points))
    return o3d.pipelines.registration.get_information_matrix_from_point_clouds(cloud, cloud, 0.01, np.eye(4))


def test_information_has_rotation_first_as_in_open3d(rng, oracle):
    """e^T Lambda e is the sum of squared displacements of the target's points by an error e."""
    points = rng.uniform((2, 0, 1), (4, 2, 3), (500, 3))
    Lambda = oracle("registration/pose_graphs/information", information_of, points)
    E = as_pose(rng.normal(0, 1e-4, 3), rng.normal(0, 1e-4, 3))
    moved = np.sum((points @ E[:3, :3].T + E[:3, 3] - points) ** 2)
    nodes = [reg.PoseGraphNode(E), reg.PoseGraphNode()]
    solved = reg.global_optimization(reg.PoseGraph(nodes, [reg.PoseGraphEdge(0, 1, np.eye(4), Lambda)]))
    assert solved.report.initial_residual == pytest.approx(moved, rel=1e-3)


def test_without_a_reference_the_mean_stays_as_in_open3d(oracle, tolerances):
    scene = ring(20, seed=1, noise=0.002, outliers=3)
    poses = poses_of(solve(scene, reference=-1, **TIGHT))
    theirs, *_ = oracle("registration/pose_graphs/no_reference", solve_by_open3d, scene, reference=-1, **TIGHT)
    motion = np.abs(poses - scene.poses).max()
    assert motion > 1e-3
    np.testing.assert_allclose(poses, theirs, rtol=0, atol=tolerances.graph_mean_motion)
    rotations = poses[:, :3, :3] @ scene.poses[:, :3, :3].transpose(0, 2, 1)
    skewed = rotations.mean(axis=0) - rotations.mean(axis=0).T
    assert np.abs(skewed).max() < 1e-12  # the mean rotation is zero
    middle = scene.poses[:, :3, 3].mean(axis=0)
    shifts = poses[:, :3, 3] - middle - np.einsum("nij,nj->ni", rotations, scene.poses[:, :3, 3] - middle)
    assert np.abs(shifts.mean(axis=0)).max() < 1e-12


def test_a_loop_closure_wrong_by_180_degrees_is_pruned():
    """Open3D's residual sin(a) is 0 there: it keeps the edge with full confidence."""
    half = (0, 2, as_pose([0, 0, np.pi], [0, 0, 0]), 100 * np.eye(6), True)
    odometry = [(i, i + 1, np.eye(4), 100 * np.eye(6), False) for i in range(2)]
    scene = SimpleNamespace(poses=np.tile(np.eye(4), (3, 1, 1)), edges=[*odometry, half])
    assert solve(scene).report.pruned_edges.tolist() == [2]


@pytest.mark.parametrize("method", METHODS)
def test_results_do_not_depend_on_the_world_origin(method):
    """At UTM coordinates Open3D stops before the first step, as its increment is small relative to the poses."""
    scene = ring(20, seed=1, noise=0.005, outliers=3)
    there = SimpleNamespace(poses=scene.poses.copy(), edges=scene.edges)
    there.poses[:, :3, 3] += (5e5, 5.4e6, 300)
    near, far = solve(scene, method), solve(there, method)
    assert far.report.pruned_edges.tolist() == near.report.pruned_edges.tolist() == scene.wrong
    np.testing.assert_allclose(poses_of(far) - there.poses, poses_of(near) - scene.poses, rtol=0, atol=5e-9)


@pytest.mark.slow
def test_a_path_that_drifts_beyond_90_degrees_is_closed():
    """300 nodes whose initial poses drift by 2.4 rad at the end. Open3D's residual sin(a) decreases again there: it
    converges 45 m off."""
    rng = np.random.default_rng(13)
    count = 300
    true = [as_pose([0, 0, 2 * np.pi * i / count], [0, 0, 0]) @ as_pose([0, 0, 0], [20, 0, 0]) for i in range(count)]
    pairs = [(i, i + 1, 0.02) for i in range(count - 1)] + [(i, i + 150, 0.001) for i in range(0, 150, 30)]
    edges = [
        (i, j, shaken(np.linalg.inv(true[j]) @ true[i], rng, noise), 100 * np.eye(6), False) for i, j, noise in pairs
    ]
    poses = true[:1]
    for edge in edges[: count - 1]:
        poses.append(poses[-1] @ np.linalg.inv(shaken(edge[2], rng, 0.06)))
    assert Rotation.from_matrix(poses[-1][:3, :3] @ true[-1][:3, :3].T).magnitude() > 2
    scene = SimpleNamespace(poses=np.array(poses), edges=edges)
    solved = solve(scene)
    assert solved.report.converged
    assert np.abs(poses_of(solved) - true)[:, :3, 3].max() < 2 < np.abs(poses - np.array(true))[:, :3, 3].max() / 5


def defaults_of(o3d):
    theirs = o3d.pipelines.registration  # an option made without arguments has another distance, see the docstring
    both = theirs.GlobalOptimizationConvergenceCriteria(), theirs.GlobalOptimizationOption(reference_node=-1)
    return [{name: getattr(one, name) for name in dir(one) if not name.startswith("_")} for one in both]


def test_defaults_match_open3d(oracle):
    criteria, option = oracle("registration/pose_graphs/defaults", defaults_of)
    defaults = reg.GlobalOptimizationConvergenceCriteria(), reg.GlobalOptimizationOption()
    for mine, theirs in zip(defaults, (criteria, option), strict=True):
        assert theirs == {name: getattr(mine, name) for name in theirs}


def graph_of(count=4, seed=0) -> reg.PoseGraph:
    """A graph whose numbers have the same bits with any version of NumPy and SciPy, as stored answers need them."""
    rng = np.random.default_rng(seed)

    def pose():
        w, x, y, z = (int(number) for number in rng.integers(1, 100, 4))
        T = np.eye(4)
        T[:3, :3] = [
            [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
        ]
        T[:3, :3] /= w * w + x * x + y * y + z * z
        T[:3, 3] = rng.normal(0, 1e3, 3)
        return T

    def information():
        root = rng.normal(size=(6, 6))
        return sum(column[:, None] * column for column in root.T)

    pairs = [(i, i + 1) for i in range(count - 1)] + [(count - 1, 0)]
    edges = [reg.PoseGraphEdge(i, j, pose(), information(), bool(i % 2), 0.3 if i % 2 else 1.0) for i, j in pairs]
    return reg.PoseGraph([reg.PoseGraphNode(pose()) for _ in range(count)], edges)


def assert_same(actual, theirs) -> None:
    assert len(actual.nodes) == len(theirs.nodes) and len(actual.edges) == len(theirs.edges)
    for a, b in zip(actual.nodes, theirs.nodes, strict=True):
        assert np.array_equal(a.pose, b.pose)
    for a, b in zip(actual.edges, theirs.edges, strict=True):
        for name in ("source_node_id", "target_node_id", "uncertain", "confidence"):
            assert getattr(a, name) == getattr(b, name)
        assert np.array_equal(a.transformation, b.transformation)
        assert np.array_equal(a.information, b.information)


@pytest.fixture
def written(tmp_path) -> tuple[Path, dict]:
    """A valid file and its contents."""
    path = tmp_path / "graph.json"
    reg.write_pose_graph(path, graph_of())
    return path, json.loads(path.read_text())


def test_open3d_reads_written_files_exactly(tmp_path, o3d):
    graph = graph_of(7)
    reg.write_pose_graph(tmp_path / "graph.json", graph)
    assert_same(graph, o3d.io.read_pose_graph(str(tmp_path / "graph.json")))


def written_by_open3d(o3d, graph):
    """The text of Open3D's file of a graph."""
    theirs = o3d.pipelines.registration
    other = theirs.PoseGraph()
    for node in graph.nodes:
        other.nodes.append(theirs.PoseGraphNode(node.pose))
    for edge in graph.edges:
        ends = edge.source_node_id, edge.target_node_id
        other.edges.append(
            theirs.PoseGraphEdge(*ends, edge.transformation, edge.information, edge.uncertain, edge.confidence)
        )
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "graph.json"
        o3d.io.write_pose_graph(str(path), other)
        return path.read_text()


def test_files_of_open3d_are_read_exactly(tmp_path, oracle):
    graph = graph_of(5, seed=1)
    (tmp_path / "graph.json").write_text(oracle("registration/pose_graphs/file", written_by_open3d, graph))
    assert_same(reg.read_pose_graph(tmp_path / "graph.json"), graph)


def test_graphs_without_edges_or_nodes_round_trip(tmp_path):
    for graph in (reg.PoseGraph(), reg.PoseGraph([reg.PoseGraphNode()])):
        reg.write_pose_graph(tmp_path / "graph.json", graph)
        assert_same(reg.read_pose_graph(tmp_path / "graph.json"), graph)


def test_assigned_lists_are_written_as_arrays(tmp_path):
    graph = graph_of()
    expected = graph_of()
    graph.nodes[0].pose = graph.nodes[0].pose.tolist()
    graph.edges[1].information = graph.edges[1].information.tolist()
    graph.edges[1].uncertain = np.bool_(graph.edges[1].uncertain)
    graph.edges[2].source_node_id = np.int32(graph.edges[2].source_node_id)
    reg.write_pose_graph(tmp_path / "graph.json", graph)
    assert_same(reg.read_pose_graph(tmp_path / "graph.json"), expected)


IDENTITY = np.eye(4).ravel().tolist()


@pytest.mark.parametrize(
    ("key_path", "value"),
    [
        ("class_name", "PinholeCameraTrajectory"), ("version_major", 2), ("version_minor", True), ("nodes", {}),
        ("edges", None), ("extra", 1), ("nodes[1]", []), ("nodes[1].pose", IDENTITY[:15]),
        ("nodes[1].pose", [*IDENTITY[:15], "1"]), ("nodes[1].pose", [2.0, *IDENTITY[1:]]),
        ("nodes[1].pose", [*IDENTITY[:3], 5.0, *IDENTITY[4:]]), ("nodes[1].class_name", "PoseGraphEdge"),
        ("nodes[1].name", "kitchen"), ("edges[2].source_node_id", 4), ("edges[2].source_node_id", -1),
        ("edges[2].source_node_id", 2**31), ("edges[2].source_node_id", 1.0), ("edges[2].source_node_id", True),
        ("edges[2].target_node_id", 2), ("edges[2].uncertain", 1), ("edges[2].confidence", "high"),
        ("edges[2].confidence", 1.25), ("edges[2].information", IDENTITY), ("edges[2].information", list(range(36))),
        ("edges[2].information", (-np.eye(6)).ravel().tolist()), ("edges[2].information", [1e101] * 36),
        ("edges[2].transformation", [0.0] * 16), ("edges[2].transformation", None), ("edges[2].class_name", None),
    ],
)  # fmt: skip
def test_broken_files_are_rejected_with_the_key_path(key_path, value, written):
    """None removes an edge's key."""
    path, content = written
    *steps, last = key_path.replace("[", ".").replace("]", "").split(".")
    inner = content
    for step in steps:
        inner = inner[int(step) if step.isdigit() else step]
    if value is None and steps:
        del inner[last]
    elif last.isdigit():
        inner[int(last)] = value
    else:
        inner[last] = value
    path.write_text(json.dumps(content))
    with pytest.raises(FileError, match=rf"\b{re.escape(key_path)}(\b|\)|:)"):
        reg.read_pose_graph(path)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (b"", "not JSON"),
        (b"[]", "expected a JSON object, got a list"),
        (b'{"class_name": "PoseGraph", "class_name": "PoseGraph"}', "given twice"),
        (b'{"class_name": NaN}', "NaN is not a number"),
        (b"\xff\xfe\x00", "not valid JSON"),
        (b'{"class_name": "PoseGraph"', "line 1"),
    ],
)
def test_invalid_graphs_are_rejected(text, message, tmp_path):
    path = tmp_path / "graph.json"
    path.write_bytes(text)
    with pytest.raises(FileError, match=message):
        reg.read_pose_graph(path)


def test_a_missing_file_and_a_folder_are_rejected(tmp_path):
    with pytest.raises(FileError, match=r"/none\.json:"):
        reg.read_pose_graph(tmp_path / "none.json")
    with pytest.raises(FileError, match="cannot be read"):
        reg.read_pose_graph(tmp_path)


@given(data=st.data())
@settings(max_examples=40, deadline=None)
def test_a_damaged_file_is_read_consistently_or_rejected(data):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "graph.json"
        reg.write_pose_graph(path, graph_of(2))
        text = bytearray(path.read_bytes())
        for _ in range(data.draw(st.integers(1, 3))):
            if not text:
                break
            offset = data.draw(st.integers(0, len(text) - 1))
            kind = data.draw(st.sampled_from(["set", "cut", "drop"]))
            if kind == "set":
                text[offset] = data.draw(st.sampled_from(list(b'0123456789-+.eE,:[]{}" ntf\x00\xff')))
            elif kind == "drop":
                del text[offset]
            elif offset:
                del text[offset:]
        path.write_bytes(text)
        try:
            graph = reg.read_pose_graph(path)
        except FileError:
            return
        reg.write_pose_graph(path, graph)
        assert_same(reg.read_pose_graph(path), graph)


def test_files_are_written_atomically(tmp_path, monkeypatch):
    path = tmp_path / "graph.json"
    reg.write_pose_graph(path, graph_of())
    before = path.read_bytes()
    bad = graph_of()
    bad.edges[0].information = np.full((6, 6), np.nan)
    with pytest.raises(ValueError, match=r"edges\[0\]\.information:"):
        reg.write_pose_graph(path, bad)
    with pytest.raises(FileError, match="exists already"):
        reg.write_pose_graph(path, graph_of(2), overwrite=False)
    assert path.read_bytes() == before
    assert [file.name for file in tmp_path.iterdir()] == ["graph.json"]


def test_unwritable_values_are_rejected(tmp_path):
    with pytest.raises(FileError, match=r"/graph\.txt:"):
        reg.write_pose_graph(tmp_path / "graph.txt", graph_of())
    with pytest.raises(FileError, match=r"/graph\.json:"):
        reg.write_pose_graph(tmp_path / "none" / "graph.json", graph_of())
    with pytest.raises(TypeError, match="pose_graph"):
        reg.write_pose_graph(tmp_path / "graph.json", np.eye(4))
    assert not list(tmp_path.iterdir())


LEVEL = ("x", "y", "z", "yaw")


OPTION = reg.GlobalOptimizationOption(max_correspondence_distance=0.1, reference_node=0)


def level_ring(seed, count=8):
    """Leveled stations on a level_ring at UTM coordinates, edges with noise in six DoF, initial errors in four."""
    rng = np.random.default_rng(seed)
    tilts = [rotation_of(rng.normal(0, 0.05, 3) * [1, 1, 0]) for _ in range(count)]
    angles = 2 * np.pi * np.arange(count) / count
    positions = np.stack([20 * np.cos(angles) + 4.5e5, 20 * np.sin(angles) + 5.4e6, 0 * angles + 300], axis=1)
    truth = [
        make_pose(rotation_of(np.array([0, 0, a])) @ R, p) for a, R, p in zip(angles, tilts, positions, strict=True)
    ]
    edges = []
    for a, b in [*((i, (i + 1) % count) for i in range(count)), (0, 4), (2, 6)]:
        error = make_pose(rotation_of(rng.normal(0, 2e-3, 3)), rng.normal(0, 0.02, 3))
        edges.append(
            reg.PoseGraphEdge(a, b, error @ invert_pose(truth[b]) @ truth[a], np.diag([400.0] * 3 + [100.0] * 3))
        )
    rotations = [make_pose(rotation_of(np.array([0, 0, y])), np.zeros(3)) for y in rng.normal(0, 0.05, count)]
    first = [
        make_pose(t[:3, :3] @ T[:3, :3], T[:3, 3] + rng.normal(0, 0.3, 3))
        for t, T in zip(rotations, truth, strict=True)
    ]
    first[0] = truth[0]
    return np.array(first), edges


def residuals(poses, edges):
    rows = []
    for e in edges:
        E = invert_pose(e.transformation) @ invert_pose(poses[e.target_node_id]) @ poses[e.source_node_id]
        w = np.array([E[2, 1] - E[1, 2], E[0, 2] - E[2, 0], E[1, 0] - E[0, 1]]) / np.sqrt(1 + np.trace(E[:3, :3]))
        rows.append(np.r_[w, E[:3, 3]] * np.sqrt(np.diag(e.information)))
    return np.concatenate(rows)


def test_leveled_nodes_stay_exactly_level_and_converge():
    first, edges = level_ring(0)
    graph = reg.PoseGraph([reg.PoseGraphNode(T) for T in first], edges)
    solved = reg.global_optimization(graph, option=OPTION, free=LEVEL)
    poses = np.array([node.pose for node in solved.nodes])
    assert np.abs(poses[:, 2, :3] - first[:, 2, :3]).max() < 1e-12  # up in each node's coordinates
    middle = first[0, :3, 3]

    def moved(x):
        result = first.copy()
        for k, (yaw, *shift) in enumerate(x.reshape(-1, 4), start=1):
            result[k, :3, :3] = rotation_of(np.array([0, 0, yaw])) @ first[k, :3, :3]
            result[k, :3, 3] = first[k, :3, 3] - middle + shift
        result[0, :3, 3] = 0
        return result

    best = least_squares(lambda x: residuals(moved(x), edges), np.zeros(4 * (len(first) - 1)), xtol=1e-14, ftol=1e-14)
    dense = moved(best.x)
    dense[:, :3, 3] += middle
    assert np.abs(poses - dense).max() < 1e-6
    unconstrained = reg.global_optimization(graph, option=OPTION)
    assert np.abs(np.array([n.pose for n in unconstrained.nodes])[:, 2, :3] - first[:, 2, :3]).max() > 1e-4


def test_fixed_components_stay_and_all_free_is_no_constraint():
    first, edges = level_ring(1)
    graph = reg.PoseGraph([reg.PoseGraphNode(T) for T in first], edges)
    rail = np.array([n.pose for n in reg.global_optimization(graph, option=OPTION, free=["x", "z"]).nodes])
    assert np.abs(rail[:, :3, :3] - first[:, :3, :3]).max() < 1e-12
    assert np.array_equal(rail[:, 1, 3], first[:, 1, 3])
    assert np.abs(rail[:, 0, 3] - first[:, 0, 3]).max() > 1e-2
    plain, named = (reg.global_optimization(graph, option=OPTION, free=f) for f in (None, [*LEVEL, "roll", "pitch"]))
    assert [n.pose.tobytes() for n in plain.nodes] == [n.pose.tobytes() for n in named.nodes]


def test_the_mean_of_level_poses_is_preserved():
    first, edges = level_ring(2)
    graph = reg.PoseGraph([reg.PoseGraphNode(T) for T in first], edges)
    poses = np.array([n.pose for n in reg.global_optimization(graph, free=LEVEL).nodes])
    assert np.abs(poses[:, 2, :3] - first[:, 2, :3]).max() < 1e-12
    assert abs((poses - first)[:, 2, 3].mean()) < 1e-9


@pytest.mark.parametrize(
    ("lengths", "uncertain", "warning"),
    [
        ([-3.01], True, None), ([-3.02], False, None), ([], True, None), ([-3.01, -5, 9], True, None),
        ([-5], True, "too few edges to decide"), ([-5, 3, 9], True, "none of 3 uncertain edges"),
        ([-5], False, "4 of 4 certain edges contradict"), ([-5, 3], False, "certain edges contradict"),
    ],
)  # fmt: skip
def test_contradicting_edges_are_reported(lengths, uncertain, warning):
    def along(x):
        return as_pose([0, 0, 0], [x, 0, 0])

    for weight in (1.0, 5000.0):
        information = weight * np.eye(6)
        edges = [reg.PoseGraphEdge(i, i + 1, along(-1), information) for i in range(3)]
        edges += [reg.PoseGraphEdge(0, 3, along(x), information, uncertain=uncertain) for x in lengths]
        option = reg.GlobalOptimizationOption(max_correspondence_distance=0.1, reference_node=0)
        graph = reg.PoseGraph([reg.PoseGraphNode(along(i)) for i in range(4)], edges)
        report = reg.global_optimization(graph, option=option).report
        assert report.reliable == (warning is None) and (warning or "") in "".join(report.warnings)
        assert set(report.to_dict()) >= {"residual", "warnings"} and not any(n[0] == "_" for n in report.to_dict())
