"""Pose graphs: nodes (poses) and edges (measured motions) for `global_optimization`."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import LARGEST_NUMBER
from ...core.checks import check_count, check_list, check_number, check_rigid, check_shape
from ...kernels.linear_algebra import eigvalsh, matmul
from ..rigid import skews

if TYPE_CHECKING:
    from .reports import GlobalOptimizationReport, RefinementReport

ROTATION_TOLERANCE = 0.02  # as in `check_rigid`: real data sets are rounded to a few digits
LAST_ROW_TOLERANCE = 1e-6
FAR_FROM_DATA = 8.0  # times the data extent: below it a residual of 1 degree is 0.1% off
# Relative tolerance of symmetry (to the largest entry) and of negative eigenvalues (to the trace), for sums stored with
# 7 digits.
INFORMATION_TOLERANCE = 1e-6


@dataclass(eq=False)
class PoseGraphNode:
    """A node: a fragment, a scan or a frame.

    Args:
        pose: T_world_node, float64 [4, 4] [m].

    Raises:
        TypeError, ValueError: Not numbers, or a wrong shape. Rigidity is checked when the graph is used.
    """

    pose: NDArray[np.float64] = field(default_factory=lambda: np.eye(4))

    def __post_init__(self):
        self.pose = check_shape("pose", self.pose, (4, 4))


@dataclass(eq=False)
class PoseGraphEdge:
    """A measured motion between two nodes with its information.

    Args:
        source_node_id: Index of the source node.
        target_node_id: Index of the target node.
        transformation: T_target_source, float64 [4, 4] [m], as from registration.
        information: Symmetric weights, float64 [6, 6], of the residual (rotation [rad] about the source axes, then
            translation [m]), as from `get_information_matrix_from_point_clouds`: the sum of squared displacements of
            the correspondences. [5, 5] is their number.
        uncertain: True for a loop closure that may be wrong, not for odometry.
        confidence: Confidence of an uncertain edge, 0..1, set by `global_optimization`. 1 if certain.

    Raises:
        TypeError, ValueError: Not numbers, or a wrong shape. Ranges are checked when the graph is used.
    """

    source_node_id: int = -1
    target_node_id: int = -1
    transformation: NDArray[np.float64] = field(default_factory=lambda: np.eye(4))
    information: NDArray[np.float64] = field(default_factory=lambda: np.eye(6))
    uncertain: bool = False
    confidence: float = 1.0

    def __post_init__(self):
        self.source_node_id = check_count("source_node_id", self.source_node_id, minimum=-1)
        self.target_node_id = check_count("target_node_id", self.target_node_id, minimum=-1)
        self.transformation = check_shape("transformation", self.transformation, (4, 4))
        self.information = check_shape("information", self.information, (6, 6))
        self.uncertain = bool(self.uncertain)
        self.confidence = check_number("confidence", self.confidence, allow_nan=True, allow_infinite=True)


class PoseGraph:
    """Nodes and edges of a pose graph.

    Args:
        nodes, edges: Initial nodes and edges.

    Attributes:
        nodes: list of PoseGraphNode. Append to it.
        edges: list of PoseGraphEdge. Append to it.
        report: Report of the optimization or alignment. None for graphs that were built or read.

    Example:
        >>> import numpy as np
        >>> import pointloom as loom
        >>> reg = loom.registration
        >>> step = np.eye(4)
        >>> step[0, 3] = -1  # takes coordinates of node 0 to those of node 1, which lies 1 m further along x
        >>> graph = reg.PoseGraph([reg.PoseGraphNode(), reg.PoseGraphNode()])
        >>> graph.edges.append(reg.PoseGraphEdge(0, 1, step))
        >>> solved = reg.global_optimization(graph, option=reg.GlobalOptimizationOption(reference_node=0))
        >>> solved.nodes[1].pose[:3, 3].round(3).tolist()
        [1.0, 0.0, 0.0]
    """

    def __init__(self, nodes: Iterable[PoseGraphNode] = (), edges: Iterable[PoseGraphEdge] = ()):
        self.nodes: list[PoseGraphNode] = check_list("nodes", nodes, "PoseGraphNode")
        self.edges: list[PoseGraphEdge] = check_list("edges", edges, "PoseGraphEdge")
        self.report: GlobalOptimizationReport | RefinementReport | None = None

    def __repr__(self) -> str:
        uncertain = sum(edge.uncertain for edge in self.edges)
        return f"PoseGraph({len(self.nodes)} nodes, {len(self.edges)} edges, {uncertain} of them uncertain)"


@dataclass(frozen=True, eq=False)
class GraphArrays:
    """A checked graph as arrays, with n nodes and m edges: float64 poses [n, 4, 4] and information [m, 6, 6]."""

    poses: NDArray[np.float64]
    source: NDArray[np.int64]
    target: NDArray[np.int64]
    transformations: NDArray[np.float64]
    information: NDArray[np.float64]
    uncertain: NDArray[np.bool_]
    confidences: NDArray[np.float64]

    def edges_at(self, chosen: NDArray[Any]) -> GraphArrays:
        fields = ("source", "target", "transformations", "information", "uncertain", "confidences")
        return dataclasses.replace(self, **{name: getattr(self, name)[chosen] for name in fields})


def center_frames(graph: GraphArrays) -> tuple[GraphArrays, NDArray[np.float64]]:
    """Move the node origins to their data, since far ones couple translation residuals to rotations squared."""
    R, t = graph.transformations[:, :3, :3], graph.transformations[:, :3, 3]
    counts = np.trace(graph.information[:, 3:, 3:], axis1=1, axis2=2) / 3
    known = counts > 0
    counts = np.where(known, counts, 1)
    mixed = graph.information[:, :3, 3:]
    middles = (mixed - mixed.transpose(0, 2, 1))[:, (2, 0, 1), (1, 2, 0)] / (2 * counts[:, None])
    about = _information_about(graph.information, middles)
    sizes = np.sqrt(np.maximum(np.trace(about[:, :3, :3], axis1=1, axis2=2), 0) / (2 * counts))
    across = matmul(R, middles[:, :, None])[:, :, 0] + t
    ends = np.concatenate([graph.source[known], graph.target[known]])
    sums = np.zeros((len(graph.poses), 4))
    np.add.at(sums, ends, np.concatenate([np.c_[middles, sizes][known], np.c_[across, sizes][known]]))
    sums /= np.maximum(np.bincount(ends, minlength=len(sums)), 1)[:, None]
    centers, sizes = sums[:, :3], sums[:, 3]
    centers[np.abs(centers).max(axis=1, initial=0) <= FAR_FROM_DATA * sizes] = 0
    poses, transformations = graph.poses.copy(), graph.transformations.copy()
    poses[:, :3, 3] += matmul(poses[:, :3, :3], centers[:, :, None])[:, :, 0]
    at_source, at_target = centers[graph.source], centers[graph.target]
    transformations[:, :3, 3] += matmul(R, at_source[:, :, None])[:, :, 0] - at_target
    information = _information_about(graph.information, at_source)
    return dataclasses.replace(graph, poses=poses, transformations=transformations, information=information), centers


def _information_about(information: NDArray[np.float64], points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Information matrices [m, 6, 6] with respect to other points, [m, 3]."""
    shift = np.tile(np.eye(6), (len(points), 1, 1))
    shift[:, 3:, :3] = skews(points)
    return matmul(shift.transpose(0, 2, 1), matmul(information, shift))


def check_pose_graph(graph: PoseGraph) -> GraphArrays:
    """The graph's arrays after vectorized checks of all nodes and edges. Errors name the node or edge."""
    if not isinstance(graph, PoseGraph):
        raise TypeError(f"pose_graph: expected a PoseGraph, got {type(graph).__name__}")
    nodes, edges = graph.nodes, graph.edges
    for name, items, kind in (("nodes", nodes, PoseGraphNode), ("edges", edges, PoseGraphEdge)):
        for i, item in enumerate(items):
            if not isinstance(item, kind):
                raise TypeError(f"{name}[{i}]: expected a {kind.__name__}, got {type(item).__name__}")
    poses = _stacked("nodes", "pose", [node.pose for node in nodes], (4, 4))
    transformations = _stacked("edges", "transformation", [edge.transformation for edge in edges], (4, 4))
    information = _stacked("edges", "information", [edge.information for edge in edges], (6, 6))
    confidences = _stacked("edges", "confidence", [edge.confidence for edge in edges], ())
    ends = _stacked("edges", "node ids", [(edge.source_node_id, edge.target_node_id) for edge in edges], (2,))
    _check_ends(ends, len(nodes))
    _check_poses("nodes", "pose", poses)
    _check_poses("edges", "transformation", transformations)
    information = _check_information(information)
    _refuse(~((confidences >= 0) & (confidences <= 1)), "edges", "confidence: expected 0..1", confidences)
    source, target = ends.astype(np.int64).T
    uncertain = np.array([bool(edge.uncertain) for edge in edges], bool)
    return GraphArrays(poses, source, target, transformations, information, uncertain, confidences)


def _stacked(items: str, name: str, values: Sequence[Any], shape: tuple[int, ...]) -> NDArray[np.float64]:
    """The values as one float64 array, checked again since attributes may have been reassigned."""
    try:
        stack = np.array(values, np.float64)
    except (TypeError, ValueError, OverflowError):
        stack = None
    if stack is None or (stack.shape != (len(values), *shape) and len(values)):
        for i, value in enumerate(values):
            check_shape(f"{items}[{i}].{name}", value, shape)
        raise TypeError(f"{items}: expected numbers as {name}")
    return stack.reshape(len(values), *shape)


def _refuse(wrong: NDArray[np.bool_], items: str, expected: str, values: NDArray[Any]) -> None:
    if wrong.any():
        i = int(np.flatnonzero(wrong)[0])
        attribute, _, rest = expected.partition(":")
        value = f"{values[i]:g}" if values.ndim == 1 else values[i].tolist()
        raise ValueError(f"{items}[{i}].{attribute}:{rest}, got {value}")


def _check_ends(ends: NDArray[np.float64], count: int) -> None:
    is_integer = ends == np.floor(ends)
    for column, name in enumerate(("source_node_id", "target_node_id")):
        inside = is_integer[:, column] & (ends[:, column] >= 0) & (ends[:, column] < count)
        expected = f"{name}: expected the index of one of {count} nodes"
        _refuse(~inside, "edges", expected, ends[:, column])
    _refuse(ends[:, 0] == ends[:, 1], "edges", "target_node_id: expected another node than the source", ends[:, 1])


def _check_poses(items: str, name: str, poses: NDArray[np.float64]) -> None:
    R = poses[:, :3, :3]
    with np.errstate(invalid="ignore", over="ignore"):
        skewed = np.abs(matmul(R, R.transpose(0, 2, 1)) - np.eye(3)).max(axis=(1, 2), initial=0) > ROTATION_TOLERANCE
        mirrored = np.einsum("ni,ni->n", np.cross(R[:, 0], R[:, 1]), R[:, 2]) < 0
        other = np.abs(poses[:, 3] - (0, 0, 0, 1)).max(axis=1, initial=0) > LAST_ROW_TOLERANCE
    suspects = skewed | mirrored | other | ~np.isfinite(poses).all(axis=(1, 2))
    for i in np.flatnonzero(suspects):
        check_rigid(f"{items}[{i}].{name}", poses[i], tolerance=ROTATION_TOLERANCE)
    far = np.abs(poses[:, :3, 3]).max(axis=1, initial=0) > LARGEST_NUMBER
    _refuse(far, items, f"{name}: expected a translation of at most {LARGEST_NUMBER:g}", poses[:, :3, 3])


def _check_information(information: NDArray[np.float64]) -> NDArray[np.float64]:
    """The matrices made exactly symmetric, after checks of symmetry and semi-definiteness within rounding."""
    largest = np.abs(information).max(axis=(1, 2), initial=0)
    _refuse(~(largest <= LARGEST_NUMBER), "edges", "information: expected finite numbers", information)
    across = information.transpose(0, 2, 1)
    skewed = np.abs(information - across).max(axis=(1, 2), initial=0) > INFORMATION_TOLERANCE * largest
    _refuse(skewed, "edges", "information: expected a symmetric matrix", information)
    symmetric = (information + across) / 2
    slack = INFORMATION_TOLERANCE * np.trace(symmetric, axis1=1, axis2=2)
    lifted = symmetric + np.maximum(slack, np.finfo(float).tiny)[:, None, None] * np.eye(6)
    try:
        np.linalg.cholesky(lifted)  # much faster than eigenvalues
    except np.linalg.LinAlgError:
        eigenvalues = eigvalsh(symmetric)
        below = eigenvalues[:, 0] < -np.maximum(slack, 0)
        _refuse(below, "edges", "information: expected a positive semi-definite matrix, not eigenvalues", eigenvalues)
    return symmetric
