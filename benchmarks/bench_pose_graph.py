"""global_optimization of pose graphs: a ring with loop closures, and a grid path whose rows are connected.

Initial poses are those of simulated odometry with drift. One loop closure in twenty is wrong.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from contest import POINTLOOM, Contestant, Operation, Trial, load_open3d, timed
from scenes import inverse, product

NOISE = 2e-4  # [rad] and [m] per edge
DISTANCE = 0.05  # [m] correspondence distance
CORRESPONDENCES = 200
WRONG_FRACTION = 0.05  # of the loop closures


@dataclass(frozen=True)
class Trajectory:
    """Initial poses [n, 4, 4]; edges as (source, target, transformation, uncertain); number of correct edges."""

    poses: np.ndarray
    edges: list[tuple[int, int, np.ndarray, bool]]


def poses_of(twists: np.ndarray) -> np.ndarray:
    """Poses of rotation vectors and translations, [n, 6]."""
    from scipy.spatial.transform import Rotation

    poses = np.tile(np.eye(4), (len(twists), 1, 1))
    poses[:, :3, :3] = Rotation.from_rotvec(twists[:, :3]).as_matrix()
    poses[:, :3, 3] = twists[:, 3:]
    return poses


def simulate(true: np.ndarray, closures: list[tuple[int, int]]) -> Trajectory:
    """Simulate odometry along true poses, and loop closures between the given pairs."""
    rng = np.random.default_rng(1)
    steps = [(i, i + 1) for i in range(len(true) - 1)]
    noise = poses_of(rng.normal(0, NOISE, (len(steps) + len(closures), 6)))
    wrong = poses_of(rng.normal(0, 1, (len(closures), 6)))
    edges = []
    for k, (i, j) in enumerate(steps + closures):
        measured = product(product(inverse(true[j]), true[i]), noise[k])
        if k >= len(steps) and rng.random() < WRONG_FRACTION:
            measured = wrong[k - len(steps)]
        edges.append((i, j, measured, k >= len(steps)))
    poses = [true[0]]
    for edge in edges[: len(steps)]:
        poses.append(product(poses[-1], inverse(edge[2])))
    return Trajectory(np.array(poses), edges)


def ring(count: int) -> Callable[[], Trajectory]:
    def make() -> Trajectory:
        rng = np.random.default_rng(0)
        angles = 2 * np.pi * np.arange(count) / count
        radius = count / 20
        twists = np.zeros((count, 6))
        twists[:, 2], twists[:, 3], twists[:, 4] = angles, radius * np.cos(angles), radius * np.sin(angles)
        starts, spans = rng.integers(0, count, count // 2), rng.integers(2, 20, count // 2)
        pairs = [(int(i), int((i + span) % count)) for i, span in zip(starts, spans, strict=True)]
        return simulate(poses_of(twists), [*pairs, (0, count - 1)])

    return make


def grid(side: int) -> Callable[[], Trajectory]:
    def make() -> Trajectory:
        rows, columns = np.divmod(np.arange(side * side), side)
        columns = np.where(rows % 2, side - 1 - columns, columns)  # back and forth
        twists = np.zeros((side * side, 6))
        twists[:, :3] = np.random.default_rng(0).normal(0, 0.5, (side * side, 3))
        twists[:, 3], twists[:, 4] = rows, columns
        index_of = {cell: i for i, cell in enumerate(zip(rows.tolist(), columns.tolist(), strict=True))}
        pairs = [(index_of[r, c], index_of[r + 1, c]) for r in range(side - 1) for c in range(side)]
        return simulate(poses_of(twists), [(i, j) for i, j in pairs if j - i > 1])

    return make


INFORMATION = np.diag([0.5, 0.5, 0.5, 1, 1, 1]) * CORRESPONDENCES


def prepare_pointloom(scene: Trajectory, device: str) -> Any:
    from pointloom import registration as reg

    edges = [reg.PoseGraphEdge(i, j, X, INFORMATION, uncertain) for i, j, X, uncertain in scene.edges]
    graph = reg.PoseGraph([reg.PoseGraphNode(T) for T in scene.poses], edges)
    option = reg.GlobalOptimizationOption(DISTANCE, reference_node=0)
    return lambda: reg.global_optimization(graph, option=option)


def prepare_open3d(scene: Trajectory, device: str) -> Any:
    o3d = load_open3d().pipelines.registration
    option = o3d.GlobalOptimizationOption(max_correspondence_distance=DISTANCE, reference_node=0)

    def make() -> Any:
        graph = o3d.PoseGraph()
        for T in scene.poses:
            graph.nodes.append(o3d.PoseGraphNode(T))
        for i, j, X, uncertain in scene.edges:
            graph.edges.append(o3d.PoseGraphEdge(i, j, X, INFORMATION, uncertain=uncertain))
        return graph

    def optimize(graph: Any) -> Any:
        method, criteria = o3d.GlobalOptimizationLevenbergMarquardt(), o3d.GlobalOptimizationConvergenceCriteria()
        o3d.global_optimization(graph, method, criteria, option)
        return graph

    return Trial(optimize, setup=make)


def facts(graph: Any) -> tuple[np.ndarray, np.ndarray]:
    """Poses and remaining edges."""
    node_pairs = [(edge.source_node_id, edge.target_node_id) for edge in graph.edges]
    return np.array([node.pose for node in graph.nodes]), np.array(node_pairs)


def check(actual: tuple[np.ndarray, np.ndarray], reference: tuple[np.ndarray, np.ndarray], peer: str) -> None:
    np.testing.assert_array_equal(actual[1], reference[1], err_msg=f"the remaining edges are not {peer}'s")
    # Both stop at a relative residual change of 1e-6: along the weakest modes that is some centimeters.
    np.testing.assert_allclose(actual[0], reference[0], rtol=0, atol=0.05, err_msg=f"the poses are not {peer}'s")


CONTESTANTS = (
    Contestant(POINTLOOM, prepare_pointloom, facts, ("cpu", "cuda")),
    Contestant("open3d-legacy", prepare_open3d, facts),
)
GRAPH = Operation(
    name="pose_graph",
    scenes={"ring 1000": ring(1000), "grid 900": grid(30)},
    quick={"ring 100": ring(100)},
    contestants=CONTESTANTS,
    check=check,
    memory_size="ring 1000",
    targets={"ring 1000": 4, "grid 900": 4},
)
OPERATIONS = (GRAPH,)


@timed(GRAPH)
def test_pose_graph(time_lap) -> None:
    time_lap()
