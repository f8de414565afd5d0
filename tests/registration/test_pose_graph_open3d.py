"""Pose graphs against Open3D's: the same poses, confidences and edges, and the failures of its residual."""

from types import SimpleNamespace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from pointloom import registration as reg

from .pose_rings import METHODS, TIGHT, confidences_of, cost_of, ends_of, poses_of, ring, shaken, solve
from .poses import as_pose


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


@pytest.mark.parametrize(
    ("method", "noise", "distance"), [(METHODS[0], 0.02, 0.1), (METHODS[1], 0.02, 0.3), (METHODS[0], 0.05, 0.3)]
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
