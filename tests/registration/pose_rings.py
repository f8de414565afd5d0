"""Pose graphs of rings, their solutions, and the cost."""

from types import SimpleNamespace

import numpy as np
from scipy.spatial.transform import Rotation

from pointloom import registration as reg

from .poses import as_pose

METHODS = ("LevenbergMarquardt", "GaussNewton")  # of Open3D
NAMES = dict(zip(METHODS, ("levenberg-marquardt", "gauss-newton"), strict=True))
TIGHT = {"min_relative_increment": 1e-10, "min_relative_residual_increment": 1e-13}
TIGHT |= {"min_right_term": 1e-12, "min_residual": 1e-14}
CORRESPONDENCES = (100, 400)


def shaken(T, rng, size) -> np.ndarray:
    return T @ as_pose(rng.normal(0, size, 3), rng.normal(0, size, 3))


def information(rng) -> np.ndarray:
    """Information of correspondences at random positions, as `get_information_matrix_from_point_clouds` sums it."""
    total = np.zeros((6, 6))
    for x, y, z in rng.normal(0, 1, (rng.integers(*CORRESPONDENCES), 3)):
        G = np.hstack([-np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]]), np.eye(3)])
        total += G.T @ G
    return total


def ring(count, seed, *, noise=0.003, loops=None, outliers=0, certain=False) -> SimpleNamespace:
    """A path around a ring: `true` poses, `poses` by odometry, `edges`, and `wrong`, the indices of false edges."""
    rng = np.random.default_rng(seed)
    angles = 2 * np.pi * np.arange(count) / count
    positions = np.stack([2 * np.cos(angles), 2 * np.sin(angles), 0.1 * np.sin(3 * angles)], axis=1)
    true = [as_pose([0, 0, a], p) @ as_pose(rng.normal(0, 0.3, 3)) for a, p in zip(angles, positions, strict=True)]
    edges = []

    def join(i, j, uncertain):
        measured = shaken(np.linalg.inv(true[j]) @ true[i], rng, noise)
        edges.append((int(i), int(j), measured, information(rng), uncertain))

    for i in range(count - 1):
        join(i, i + 1, False)
    join(0, count - 1, not certain)
    for _ in range(count // 2 if loops is None else loops):
        i, j = rng.choice(count, 2, replace=False)  # loop closures in both directions
        join(i, j, not certain)
    wrong = range(len(edges), len(edges) + outliers)
    for _ in wrong:
        i, j = rng.choice(count, 2, replace=False)
        measured = as_pose(rng.normal(0, 1, 3), rng.normal(0, 1, 3))
        edges.append((int(i), int(j), measured, information(rng), True))
    poses = true[:1]
    for i in range(count - 1):
        poses.append(poses[-1] @ np.linalg.inv(edges[i][2]))
    return SimpleNamespace(true=np.array(true), poses=np.array(poses), edges=edges, wrong=list(wrong))


def to_graph(scene) -> reg.PoseGraph:
    edges = [reg.PoseGraphEdge(*edge[:4], uncertain=edge[4]) for edge in scene.edges]
    return reg.PoseGraph([reg.PoseGraphNode(T) for T in scene.poses], edges)


def solve(scene, method="LevenbergMarquardt", distance=0.05, reference=0, **criteria) -> reg.PoseGraph:
    option = reg.GlobalOptimizationOption(distance, reference_node=reference)
    rules = reg.GlobalOptimizationConvergenceCriteria(**criteria)
    return reg.global_optimization(to_graph(scene), NAMES[method], rules, option)


def poses_of(graph) -> np.ndarray:
    return np.array([node.pose for node in graph.nodes])


def confidences_of(graph) -> np.ndarray:
    return np.array([edge.confidence for edge in graph.edges])


def ends_of(graph) -> list[tuple[int, int]]:
    return [(edge.source_node_id, edge.target_node_id) for edge in graph.edges]


def cost_of(poses, edges, distance, sine_of_half=True) -> float:
    """The cost of each edge; `sine_of_half` False gives Open3D's form."""
    mu = distance**2 * np.mean([edge[3][5, 5] for edge in edges])
    total = 0.0
    for source, target, X, Lambda, uncertain in edges:
        E = np.linalg.inv(X) @ np.linalg.inv(poses[target]) @ poses[source]
        vector = Rotation.from_matrix(E[:3, :3]).as_rotvec()
        angle = np.linalg.norm(vector)
        length = 2 * np.sin(angle / 2) if sine_of_half else np.sin(angle)
        e = np.concatenate([vector * (length / angle if angle else 1.0), E[:3, 3]])
        r = e @ Lambda @ e
        total += mu * r / (mu + r) if uncertain else r
    return total
