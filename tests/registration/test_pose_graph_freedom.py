"""Pose graphs with restricted degrees of freedom: fixed components stay, free components reach the optimum."""

import numpy as np
from scipy.optimize import least_squares

import pointloom as loom
from pointloom.registration.rigid import invert_pose, make_pose, rotation_of

reg = loom.registration
LEVEL = ("x", "y", "z", "yaw")
OPTION = reg.GlobalOptimizationOption(max_correspondence_distance=0.1, reference_node=0)


def ring(seed, count=8):
    """Leveled stations on a ring at UTM coordinates, edges with noise in six DoF, initial errors in four."""
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
    first, edges = ring(0)
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
    first, edges = ring(1)
    graph = reg.PoseGraph([reg.PoseGraphNode(T) for T in first], edges)
    rail = np.array([n.pose for n in reg.global_optimization(graph, option=OPTION, free=["x", "z"]).nodes])
    assert np.abs(rail[:, :3, :3] - first[:, :3, :3]).max() < 1e-12
    assert np.array_equal(rail[:, 1, 3], first[:, 1, 3])
    assert np.abs(rail[:, 0, 3] - first[:, 0, 3]).max() > 1e-2
    plain, named = (reg.global_optimization(graph, option=OPTION, free=f) for f in (None, [*LEVEL, "roll", "pitch"]))
    assert [n.pose.tobytes() for n in plain.nodes] == [n.pose.tobytes() for n in named.nodes]


def test_the_mean_of_level_poses_is_preserved():
    first, edges = ring(2)
    graph = reg.PoseGraph([reg.PoseGraphNode(T) for T in first], edges)
    poses = np.array([n.pose for n in reg.global_optimization(graph, free=LEVEL).nodes])
    assert np.abs(poses[:, 2, :3] - first[:, 2, :3]).max() < 1e-12
    assert abs((poses - first)[:, 2, 3].mean()) < 1e-9
