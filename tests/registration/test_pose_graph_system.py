"""Pose graph arithmetic: residuals, Jacobians, rotations and the sparse system against plain formulas."""

from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from pointloom.core.quaternions import nearest_rotations, rotations_to_quaternions
from pointloom.registration.pose_graphs.pose_graph import GraphArrays
from pointloom.registration.pose_graphs.pose_graph_system import EdgeMeasurements, NodePoses, NormalEquations
from pointloom.registration.rigid import rotations_of

ROTATIONS_BY_PI = [[np.pi, 0, 0], [0, np.pi, 0], [0, 0, np.pi], [np.pi / 2**0.5] * 2 + [0]]


def graph_of(seed, *, nodes=5, edges=9) -> GraphArrays:
    """Random nodes, errors of up to some radians, several edges between the same nodes."""
    rng = np.random.default_rng(seed)
    ends = np.array([rng.choice(nodes, 2, replace=False) for _ in range(edges)])
    poses, measured = (np.tile(np.eye(4), (count, 1, 1)) for count in (nodes, edges))
    for T in (poses, measured):
        T[:, :3, :3] = Rotation.random(len(T), random_state=int(rng.integers(2**31))).as_matrix()
        T[:, :3, 3] = rng.uniform(-5, 5, (len(T), 3))
    roots = rng.normal(size=(edges, 6, 6))
    weights = roots @ roots.transpose(0, 2, 1)
    return GraphArrays(poses, *ends.T.astype(np.int64), measured, weights, np.zeros(edges, bool), np.ones(edges))


def parts_of(graph) -> SimpleNamespace:
    poses = NodePoses(graph.poses[:, :3, :3], graph.poses[:, :3, 3])
    return SimpleNamespace(edges=EdgeMeasurements(graph), poses=poses)


@pytest.mark.parametrize("seed", range(2))
def test_residuals_match_their_definition(seed):
    graph = graph_of(seed)
    scene = parts_of(graph)
    errors = scene.edges.errors(scene.poses)
    for k in range(len(graph.source)):
        X, Ts, Tt = graph.transformations[k], graph.poses[graph.source[k]], graph.poses[graph.target[k]]
        E = np.linalg.inv(X) @ np.linalg.inv(Tt) @ Ts
        vector = Rotation.from_matrix(E[:3, :3]).as_rotvec()
        angle = np.linalg.norm(vector)
        expected = np.concatenate([2 * np.sin(angle / 2) / angle * vector, E[:3, 3]])
        np.testing.assert_allclose(errors.residuals[k], expected, rtol=0, atol=1e-13 * max(1, np.abs(expected).max()))
        assert errors.squares[k] == pytest.approx(expected @ graph.information[k] @ expected, rel=1e-12)
        assert errors.scalars[k] == pytest.approx(np.cos(angle / 2), abs=1e-14)


@pytest.mark.parametrize("seed", range(2))
def test_jacobians_match_numerical_derivatives(seed):
    graph = graph_of(seed)
    scene = parts_of(graph)
    jacobians = scene.edges.jacobians(scene.poses, scene.edges.errors(scene.poses))
    step = 1e-6
    for by_node, ends in zip(jacobians, (graph.source, graph.target), strict=True):
        for axis in range(6):
            for edge, node in enumerate(ends):
                change = np.zeros((len(graph.poses), 6))
                change[node, axis] = step
                up, down = (scene.edges.errors(scene.poses.moved(sign * change)).residuals[edge] for sign in (1, -1))
                np.testing.assert_allclose(by_node[edge, :, axis], (up - down) / (2 * step), rtol=0, atol=1e-8)


@pytest.mark.parametrize("anchors", [[0], [2], [1, 4], [0, 1, 2, 3, 4]])
@pytest.mark.parametrize("seed", range(2))
def test_the_sparse_system_equals_the_dense_one(seed, anchors):
    graph = graph_of(seed, edges=14)
    scene = parts_of(graph)
    count = len(graph.poses)
    anchored = np.isin(np.arange(count), anchors)
    system = NormalEquations(scene.edges, anchored)
    errors = scene.edges.errors(scene.poses)
    weights = np.linspace(0.1, 1, len(graph.source))
    system.linearize(scene.poses, errors, weights)
    J = np.zeros((len(graph.source), 6, 6 * count))
    for k, (by_source, by_target) in enumerate(zip(*scene.edges.jacobians(scene.poses, errors), strict=True)):
        J[k, :, 6 * graph.source[k] : 6 * graph.source[k] + 6] = by_source
        J[k, :, 6 * graph.target[k] : 6 * graph.target[k] + 6] = by_target
    H = np.einsum("k,kia,kij,kjb->ab", weights, J, graph.information, J)
    right = -np.einsum("k,kia,kij,kj->a", weights, J, graph.information, errors.residuals)
    free = (6 * system.free[:, None] + np.arange(6)).ravel()
    assert sorted(system.free) == np.flatnonzero(~anchored).tolist()
    scale = np.abs(H).max()
    np.testing.assert_allclose(system.matrix.toarray(), H[np.ix_(free, free)], rtol=0, atol=1e-13 * scale)
    np.testing.assert_allclose(system.right, right[free], rtol=0, atol=1e-13 * np.abs(right).max())
    if len(free):
        solution = system.solve(1e-3)
        expected = np.linalg.solve(H[np.ix_(free, free)] + 1e-3 * np.diag(system.scale), right[free])
        np.testing.assert_allclose(solution, expected, rtol=1e-6, atol=1e-9 * np.abs(expected).max())
        step = system.step_of(solution, count)
        assert np.array_equal(step[system.free].ravel(), solution) and not step[anchored].any()


def test_damping_is_invariant_to_world_rotation():
    graph = graph_of(7, edges=14)
    W = Rotation.from_rotvec([0.4, 1.0, -2.0]).as_matrix()
    steps = []
    for R in (np.eye(3), W):
        poses = NodePoses(R @ graph.poses[:, :3, :3], graph.poses[:, :3, 3] @ R.T)
        edges = EdgeMeasurements(graph)
        system = NormalEquations(edges, np.arange(5) == 0)
        system.linearize(poses, edges.errors(poses), np.ones(14))
        steps.append(system.step_of(system.solve(0.1), 5).reshape(-1, 2, 3) @ R)
    np.testing.assert_allclose(steps[1], steps[0], rtol=0, atol=1e-9 * np.abs(steps[0]).max())


@given(vector=st.tuples(*[st.floats(-4, 4)] * 3))
@settings(max_examples=40, deadline=None)
def test_rotations_and_quaternions_match_scipy(vector):
    R = rotations_of(np.array([vector]))
    expected = Rotation.from_rotvec(vector)
    np.testing.assert_allclose(R[0], expected.as_matrix(), rtol=0, atol=5e-15)
    quaternion = rotations_to_quaternions(R)[0]
    assert quaternion[3] >= 0 and abs(abs(quaternion @ expected.as_quat()) - 1) < 1e-14
    np.testing.assert_allclose(Rotation.from_quat(quaternion).as_matrix(), R[0], rtol=0, atol=1e-14)


@pytest.mark.parametrize("vector", [[0, 0, 0], [1e-9, 0, 0], [1e-170, 0, 0], *ROTATIONS_BY_PI])
def test_rotations_are_exact_near_0_and_180_degrees(vector):
    R = rotations_of(np.array([vector], float))
    quaternion = rotations_to_quaternions(R)[0]
    angle = np.linalg.norm(vector)
    expected = np.append(np.sinc(angle / (2 * np.pi)) / 2 * np.array(vector), np.cos(angle / 2))
    sign = np.sign(quaternion @ expected)
    np.testing.assert_allclose(sign * quaternion, expected, rtol=1e-15, atol=2e-16)


def test_nearest_rotations_correct_rounding():
    R = Rotation.random(20, random_state=1).as_matrix()
    corrected = nearest_rotations(np.round(R, 3))
    assert np.abs(corrected @ corrected.transpose(0, 2, 1) - np.eye(3)).max() < 1e-14
    assert np.abs(corrected - R).max() < 1e-3
