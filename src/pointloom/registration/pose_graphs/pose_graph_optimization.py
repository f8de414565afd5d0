"""Pose graph optimization with a line process that rejects wrong loop closures.

Minimizes over poses and confidences l (Choi, Zhou and Koltun 2015, eq. 2 and section 5), with l = 1 for certain edges:

    sum over edges of l r + mu (sqrt(l) - 1)^2,    r = e^T Lambda e.

The best l is (mu / (mu + r))^2, which makes the cost mu r / (mu + r) (Geman and McClure). Steps are Gauss-Newton or
Levenberg-Marquardt (Marquardt 1963) with the damping rule of Nielsen 1999.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_count, check_fraction, check_positive, shown
from ...core.dropped_results import returns_new
from ...core.quaternions import nearest_rotations, rotations_to_quaternions
from ...kernels.linear_algebra import elementwise, matmul
from ..icp.constraint import MOTIONS, check_free
from ..rigid import nearest_rotation
from .connected_parts import connected_parts
from .pose_graph import GraphArrays, PoseGraph, PoseGraphNode, center_frames, check_pose_graph
from .pose_graph_system import EdgeErrors, EdgeMeasurements, NodePoses, NormalEquations
from .reports import GlobalOptimizationReport

Array = NDArray[np.float64]
MAX_STEPS = 100_000
MAX_NAMED = 10  # nodes listed in an error


@dataclass(frozen=True)
class GlobalOptimizationOption:
    """Options of the pose graph optimization.

    Args:
        max_correspondence_distance: Correspondence distance [m] used when the edges were measured. An uncertain edge
            with this root mean square residual gets the confidence 1/4 (if it has the mean number of correspondences).
        edge_prune_threshold: Uncertain edges with at most this confidence are removed, 0..1.
        preference_loop_closure: Factor of the line process weight. Larger keeps more uncertain edges.
        reference_node: Node whose pose is fixed; -1 fixes the mean motion of all poses to the identity.

    Raises:
        TypeError: Not numbers.
        ValueError: Out of range.

    Notes:
        Open3D's default of `max_correspondence_distance` is 0.075 without any argument, else 0.03 as here.
    """

    max_correspondence_distance: float = 0.03
    edge_prune_threshold: float = 0.25
    preference_loop_closure: float = 1.0
    reference_node: int = -1

    def __post_init__(self):
        for name in ("max_correspondence_distance", "preference_loop_closure"):
            object.__setattr__(self, name, check_positive(name, getattr(self, name)))
        object.__setattr__(
            self, "edge_prune_threshold", check_fraction("edge_prune_threshold", self.edge_prune_threshold)
        )
        object.__setattr__(self, "reference_node", check_count("reference_node", self.reference_node, minimum=-1))


@dataclass(frozen=True)
class GlobalOptimizationConvergenceCriteria:
    """Stopping criteria; `report.criterion` is the name of the one that was met.

    Args:
        max_iteration: Maximum steps in each of the two passes.
        min_relative_increment: Step length relative to the poses (rotation vectors [rad], centered positions [m]).
        min_relative_residual_increment: Relative decrease of the residual in a step.
        min_right_term: Largest entry of half the gradient.
        min_residual: The residual.
        max_iteration_lm: Maximum attempts with growing damping per step.
        upper_scale_factor: Largest damping factor after a successful step, below 1.
        lower_scale_factor: Smallest damping factor.

    Raises:
        TypeError: Not numbers.
        ValueError: Out of range.
    """

    max_iteration: int = 100
    min_relative_increment: float = 1e-6
    min_relative_residual_increment: float = 1e-6
    min_right_term: float = 1e-6
    min_residual: float = 1e-6
    max_iteration_lm: int = 20
    upper_scale_factor: float = 2 / 3
    lower_scale_factor: float = 1 / 3

    def __post_init__(self):
        for name in ("max_iteration", "max_iteration_lm"):
            reason = "more iterations do not converge"
            steps = check_count(name, getattr(self, name), maximum=MAX_STEPS, because=reason)
            object.__setattr__(self, name, steps)
        for name in ("min_relative_increment", "min_relative_residual_increment", "min_right_term", "min_residual"):
            object.__setattr__(self, name, check_positive(name, getattr(self, name), allow_zero=True))
        for name in ("lower_scale_factor", "upper_scale_factor"):
            object.__setattr__(self, name, check_fraction(name, getattr(self, name)))
        if self.lower_scale_factor > self.upper_scale_factor:
            raise ValueError(
                "lower_scale_factor: expected at most upper_scale_factor, "
                f"got {self.lower_scale_factor} and {self.upper_scale_factor}"
            )


LEVENBERG_MARQUARDT, GAUSS_NEWTON = METHODS = ("levenberg-marquardt", "gauss-newton")
USUAL_CRITERIA = GlobalOptimizationConvergenceCriteria()
USUAL_OPTION = GlobalOptimizationOption()


@returns_new
def global_optimization(
    pose_graph: PoseGraph,
    method: str = LEVENBERG_MARQUARDT,
    criteria: GlobalOptimizationConvergenceCriteria = USUAL_CRITERIA,
    option: GlobalOptimizationOption = USUAL_OPTION,
    *,
    free: Sequence[str] | None = None,
) -> PoseGraph:
    """Optimize the poses of a pose graph, and remove loop closures that contradict the rest.

    Two passes: optimize, remove uncertain edges of low confidence, optimize, remove again. The confidence is (mu / (mu
    + r))^2 with the weighted squared residual r and mu = preference_loop_closure x max_correspondence_distance^2 x mean
    number of correspondences (information[5, 5]).

    Args:
        pose_graph: Connected nodes with initial poses, and edges. Not modified. Contradicting certain edges are
            balanced, and the report warns of them.
        method: "levenberg-marquardt" (damped steps, which also converge from inexact initial poses) or "gauss-newton"
            (full steps, which stop if one does not lower the residual: faster near the optimum).
        criteria: Stopping criteria.
        option: Options.
        free: Free motions of the nodes in the world frame, of "x", "y", "z", "roll", "pitch" and "yaw"; None: all. The
            others keep the given poses: ("x", "y", "z", "yaw") keeps scans level. Zero, one, or all rotations.

    Returns:
        A new graph with optimized poses, remaining edges, their confidences, and a `report`. (Open3D works in place.)

    Raises:
        TypeError: An argument has another type.
        ValueError: An invalid node or edge, a certain edge with a confidence other than 1, uncertain edges without
            correspondences, a reference node out of range, or unconnected nodes. The message names them. Two free
            rotations; or free rotations with fixed positions and no reference node.

    Notes:
        Differs from Open3D: the rotation residual is 2 sin(a/2) instead of sin(a), which is 0 for a half turn. A last
        step that lowers the residual is kept. Results do not depend on the world origin; bad graphs raise.
        Sparse normal equations on the host in float64. Bitwise reproducible. Choi, Zhou and Koltun, "Robust
        reconstruction of indoor scenes", CVPR 2015, section 5.

    Example:
        >>> import numpy as np
        >>> import pointloom as loom
        >>> reg = loom.registration
        >>> def along_x(x):
        ...     return np.array([[1, 0, 0, x], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1.0]])
        >>> nodes = [reg.PoseGraphNode(along_x(x)) for x in (0, 1.1, 2.2)]
        >>> odometry = [reg.PoseGraphEdge(i, i + 1, along_x(-1.1)) for i in range(2)]
        >>> loops = [reg.PoseGraphEdge(0, 2, along_x(x), uncertain=True) for x in (-2.17, -5)]
        >>> option = reg.GlobalOptimizationOption(max_correspondence_distance=0.1, reference_node=0)
        >>> solved = reg.global_optimization(reg.PoseGraph(nodes, odometry + loops), option=option)
        >>> [f"{node.pose[0, 3]:.2f}" for node in solved.nodes], solved.report.pruned_edges.tolist()
        (['0.00', '1.09', '2.18'], [3])
    """
    if not isinstance(method, str) or method not in METHODS:
        raise ValueError(f"method: expected one of {', '.join(METHODS)}, got {shown(method)}")
    damped = method == LEVENBERG_MARQUARDT
    for name, value, kind in (
        ("criteria", criteria, GlobalOptimizationConvergenceCriteria),
        ("option", option, GlobalOptimizationOption),
    ):
        if not isinstance(value, kind):
            raise TypeError(f"{name}: expected a {kind.__name__}, got {shown(value)}")
    motions = _check_motions(free, option)
    graph = check_pose_graph(pose_graph)
    reference = _check_optimizable(graph, option)
    if not len(graph.poses):
        return _with_report(PoseGraph(), graph, [], 0, np.empty(0, np.int64))
    given, centers = graph.poses, np.zeros((len(graph.poses), 3))
    if motions is None or motions[3:].all():  # else the nodes' own positions are fixed
        graph, centers = center_frames(graph)
    pivot = graph.poses[reference, :3, 3]
    poses = NodePoses(nearest_rotations(graph.poses[:, :3, :3]), graph.poses[:, :3, 3] - pivot)
    remaining, confidences, passes = np.arange(len(graph.source)), graph.confidences, []
    for _ in range(2):
        part = graph.edges_at(remaining)
        weight = _line_process_weight(part, option)
        result = minimize(part, poses, reference, weight, criteria, damped=damped, motions=motions)
        is_accepted = ~part.uncertain | (result.confidences > option.edge_prune_threshold)
        remaining, confidences, poses = remaining[is_accepted], result.confidences[is_accepted], result.poses
        passes.append(result)
    world_poses = _world_poses(graph.poses, poses, pivot, option.reference_node)
    world_poses[:, :3, 3] -= matmul(world_poses[:, :3, :3], centers[:, :, None])[:, :, 0]
    if option.reference_node >= 0:
        world_poses[reference] = given[reference]
    edges = [
        dataclasses.replace(
            pose_graph.edges[i],
            source_node_id=int(graph.source[i]),
            target_node_id=int(graph.target[i]),
            confidence=confidence,
        )
        for i, confidence in zip(remaining.tolist(), confidences.tolist(), strict=True)
    ]
    solved = PoseGraph([PoseGraphNode(T) for T in world_poses], edges)
    distance = option.max_correspondence_distance
    return _with_report(solved, graph, passes, reference, remaining, _contradiction(graph, remaining, poses, distance))


def _check_motions(free: object, option: GlobalOptimizationOption) -> NDArray[np.bool_] | None:
    """Mask of the free motions in the order of MOTIONS; None: all."""
    if free is None:
        return None
    names = check_free(free)
    motions = np.array([name in names for name in MOTIONS])
    if motions[:3].sum() == 2:
        rotations = " and ".join(name for name in names if name in MOTIONS[:3])
        raise ValueError(
            f"free: {rotations} combine to rotations about the third axis. Free one rotation, all three, or none"
        )
    if motions[:3].any() and not motions[3:].all() and option.reference_node < 0:
        raise ValueError(
            "free: rotations without x, y and z do not preserve the mean pose. Pass option= with a reference_node"
        )
    return None if motions.all() else motions


def _check_optimizable(graph: GraphArrays, option: GlobalOptimizationOption) -> int:
    """Check that the graph determines all poses. The anchor node."""
    count = len(graph.poses)
    if option.reference_node >= count > 0:
        raise ValueError(f"option.reference_node: expected -1 or one of {count} nodes, got {option.reference_node}")
    wrong = np.flatnonzero(~graph.uncertain & (graph.confidences != 1))
    if len(wrong):
        raise ValueError(
            f"edges[{wrong[0]}].confidence: expected 1 for a certain edge, got {graph.confidences[wrong[0]]}"
        )
    if graph.uncertain.any() and not (graph.information[:, 5, 5] > 0).any():
        raise ValueError(
            "edges: expected the number of correspondences in information[5, 5] of uncertain edges, got 0 in all"
        )
    reference = max(option.reference_node, 0)
    if count:
        parts = parts_of(graph)
        unreached = np.flatnonzero(parts != parts[reference])
        if len(unreached):
            raise ValueError(
                f"pose_graph: no path of edges joins node {reference} to {_listed(unreached)}. Optimize the "
                f"{parts.max() + 1} parts one by one, or add edges between them"
            )
    return reference


def _listed(nodes: Sequence[Any] | NDArray[Any]) -> str:
    named = ", ".join(str(node) for node in nodes[:MAX_NAMED])
    more = f" and {len(nodes) - MAX_NAMED} more" if len(nodes) > MAX_NAMED else ""
    return f"{'node' if len(nodes) == 1 else 'nodes'} {named}{more}"


def _line_process_weight(graph: GraphArrays, option: GlobalOptimizationOption) -> float:
    """mu: the squared residual of an average edge at the maximum correspondence distance."""
    if not len(graph.source):
        return 0.0
    mean = float(graph.information[:, 5, 5].mean())
    return option.preference_loop_closure * option.max_correspondence_distance**2 * mean


def _world_poses(given: Array, poses: NodePoses, pivot: Array, reference: int) -> Array:
    """World poses [n, 4, 4] with the reference, or the mean of all, unchanged."""
    rotations, positions = poses.rotations, poses.positions
    if reference < 0:
        rotations, positions = _without_mean_motion(given[:, :3, :3], given[:, :3, 3] - pivot, rotations, positions)
    world_poses = np.tile(np.eye(4), (len(given), 1, 1))
    world_poses[:, :3, :3], world_poses[:, :3, 3] = rotations, positions + pivot
    return world_poses


def _without_mean_motion(
    old_rotations: Array, old_positions: Array, rotations: Array, positions: Array
) -> tuple[Array, Array]:
    """Move the new poses so that the (chordal) mean motion from the old ones is the identity."""
    middle = old_positions.mean(axis=0)
    changes = matmul(rotations, nearest_rotations(old_rotations).transpose(0, 2, 1))
    shifts = positions - middle - np.einsum("nij,nj->ni", changes, old_positions - middle)
    R = nearest_rotation(changes.mean(axis=0)).T
    return matmul(R, rotations), matmul(positions - middle - shifts.mean(axis=0), R.T) + middle


def _contradiction(graph: GraphArrays, remaining: NDArray[np.int64], poses: NodePoses, distance: float) -> str:
    """The warning of edges that contradict each other; "" if they agree.

    A certain edge is off by the root mean square displacement of its correspondences at the final poses.
    """
    certain = graph.edges_at(np.flatnonzero(~graph.uncertain))
    squares = EdgeMeasurements(certain).errors(poses).squares
    counts = certain.information[:, 5, 5]
    off = np.sqrt(np.divide(squares, counts, out=np.zeros(len(squares)), where=counts > 0))
    if (off > distance).any():
        worst = int(off.argmax())
        pair = f"{certain.source[worst]} to {certain.target[worst]}"
        apart = f"up to {off.max():.3g} m apart ({pair}), beyond max_correspondence_distance ({distance:g} m)"
        count = f"{int((off > distance).sum())} of {len(off)} certain edges"
        return f"{count} contradict the others: their correspondences are {apart}"
    uncertain, kept = int(graph.uncertain.sum()), int(graph.uncertain[remaining].sum())
    if uncertain and not kept:
        none = f"none of {uncertain} uncertain edges agrees with the others"
        return f"too few edges to decide: {none}, so no loop confirms the poses"
    return ""


def _with_report(
    solved: PoseGraph,
    graph: GraphArrays,
    passes: list[Pass],
    reference: int,
    remaining: NDArray[np.int64],
    contradiction: str = "",
) -> PoseGraph:
    unreached = np.empty(0, np.int64)
    if len(graph.poses):
        parts = parts_of(graph.edges_at(remaining))
        unreached = np.flatnonzero(parts != parts[reference])
    last = passes[-1] if passes else None
    solved.report = GlobalOptimizationReport(
        iterations=sum(result.iterations for result in passes),
        initial_residual=passes[0].initial_residual if passes else 0.0,
        residual=last.residual if last else 0.0,
        line_process_weight=last.weight if last else 0.0,
        converged=last is None or last.criterion.startswith("min_"),
        criterion=last.criterion if last else "no nodes",
        pruned_edges=np.setdiff1d(np.arange(len(graph.source)), remaining),
        unreached_nodes=unreached,
        _contradiction=contradiction,
    )
    return solved


INITIAL_DAMPING = 1e-5  # relative to the stiffness: nearly full first steps (Nielsen, for good initial values)
# Lower bound of the damping: keeps undetermined motions at rest without slowing others.
MIN_DAMPING = 1e-12
DAMPING_GROWTH = 2.0  # factor of the damping after a failed step, doubled each time
# Relative change of the residual due to rounding in sums of some thousand float64 products.
MIN_CHANGE = 1e-12


@dataclass(frozen=True, eq=False)
class Pass:
    """Result of one optimization pass; `weight` is mu of the line process, `criterion` names what stopped it."""

    poses: NodePoses
    confidences: Array
    iterations: int
    initial_residual: float
    residual: float
    weight: float
    criterion: str


def minimize(
    graph: GraphArrays,
    poses: NodePoses,
    reference: int,
    weight: float,
    criteria: GlobalOptimizationConvergenceCriteria,
    *,
    damped: bool,
    motions: NDArray[np.bool_] | None = None,
) -> Pass:
    """Minimize from these poses, with the reference and one node of each unconnected part fixed."""
    descent = _Descent(graph, poses, anchors_of(graph, reference), weight, criteria, damped, motions)
    initial = descent.residual
    criterion = descent.run()
    return Pass(descent.poses, descent.confidences, descent.iterations, initial, descent.residual, weight, criterion)


def parts_of(graph: GraphArrays) -> NDArray[np.int32]:
    return connected_parts(graph.source, graph.target, len(graph.poses))


def anchors_of(graph: GraphArrays, reference: int) -> NDArray[np.bool_]:
    """Mask [n] of the reference and the first node of each other component."""
    parts = parts_of(graph)
    firsts = np.unique(parts, return_index=True)[1]
    firsts[parts[reference]] = reference
    anchors = np.zeros(len(parts), bool)
    anchors[firsts] = True
    return anchors


class _Descent:
    def __init__(
        self,
        graph: GraphArrays,
        poses: NodePoses,
        anchored: NDArray[np.bool_],
        weight: float,
        criteria: GlobalOptimizationConvergenceCriteria,
        damped: bool,
        motions: NDArray[np.bool_] | None,
    ):
        self.uncertain, self.criteria, self.damped = graph.uncertain, criteria, damped
        self.weight = max(weight, np.finfo(np.float64).tiny)
        self.edges = EdgeMeasurements(graph)
        self.system = NormalEquations(self.edges, anchored, motions)
        self.poses = poses
        self.errors, self.confidences, self.residual = self._evaluate(poses)
        self.damping, self.growth, self.iterations = INITIAL_DAMPING if damped else MIN_DAMPING, DAMPING_GROWTH, 0

    def run(self) -> str:
        if not len(self.system.free):
            return "min_right_term"
        while self.iterations < self.criteria.max_iteration:
            reason = "min_residual" if self.residual < self.criteria.min_residual else self._step()
            if reason:
                return reason
        return "max_iteration"

    def _step(self) -> str:
        """Take one step, with more damping until the residual falls. Returns the criterion that was met, or ""."""
        system, criteria = self.system, self.criteria
        system.linearize(self.poses, self.errors, self.confidences)
        if np.abs(system.right).max() < criteria.min_right_term:
            return "min_right_term"
        for _ in range(criteria.max_iteration_lm if self.damped else 1):
            try:
                solution = system.solve(self.damping)
            except RuntimeError:  # numerically singular
                self._increase_damping()
                continue
            if _length(solution) < criteria.min_relative_increment * (
                _extent(self.poses) + criteria.min_relative_increment
            ):
                return "min_relative_increment"
            poses = self.poses.moved(system.step_of(solution, len(self.poses.positions)))
            errors, confidences, residual = self._evaluate(poses)
            gain = self.residual - residual
            if gain > 0:
                self._reduce_damping(
                    gain / float((solution * (self.damping * system.scale * solution + system.right)).sum())
                )
                is_converged = gain < criteria.min_relative_residual_increment * self.residual
                self.poses, self.errors, self.confidences, self.residual = poses, errors, confidences, residual
                self.iterations += 1
                return "min_relative_residual_increment" if is_converged else ""
            fraction = MIN_CHANGE if self.damped else max(MIN_CHANGE, criteria.min_relative_residual_increment)
            if -gain <= fraction * self.residual:
                return "min_relative_residual_increment"
            self._increase_damping()
        return "max_iteration_lm" if self.damped else "no descent"

    def _evaluate(self, poses: NodePoses) -> tuple[EdgeErrors, Array, float]:
        """Residuals of the edges, their confidences, and the total residual: the sum of sqrt(l) r."""
        errors = self.edges.errors(poses)
        fraction = np.ones(len(self.uncertain))
        fraction[self.uncertain] = self.weight / (self.weight + errors.squares[self.uncertain])
        return errors, fraction * fraction, float((fraction * errors.squares).sum())

    def _increase_damping(self) -> None:
        self.damping *= self.growth
        self.growth *= DAMPING_GROWTH

    def _reduce_damping(self, ratio: float) -> None:
        """Reduce the damping by the gain ratio (Nielsen 1999, eq. 2.21)."""
        if self.damped:
            factor = 1 - (2 * ratio - 1) ** 3
            factor = min(max(factor, self.criteria.lower_scale_factor), self.criteria.upper_scale_factor)
            self.damping, self.growth = max(self.damping * factor, MIN_DAMPING), DAMPING_GROWTH


def _length(values: Array) -> float:
    return float(np.sqrt((values * values).sum()))  # np.linalg.norm depends on the number of threads


def _extent(poses: NodePoses) -> float:
    """Norm of all poses: rotation vectors [rad], and positions about their mean [m]."""
    quaternions = rotations_to_quaternions(poses.rotations)
    half_angles = elementwise(math.atan2, np.sqrt((quaternions[:, :3] ** 2).sum(axis=1)), quaternions[:, 3])
    centered = poses.positions - poses.positions.mean(axis=0)
    return float(np.sqrt((4 * half_angles * half_angles).sum() + (centered * centered).sum()))
