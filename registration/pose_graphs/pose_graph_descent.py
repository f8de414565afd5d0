"""Descent of a pose graph's residual, with the line process that sets the confidence of uncertain edges.

Minimised over poses and confidences l (Choi, Zhou and Koltun 2015, eq. 2 and section 5), with l = 1 of certain edges:

    sum over edges of l r + mu (sqrt(l) - 1)^2,    r = e^T Lambda e.

The best l at given poses is (mu / (mu + r))^2; with it an uncertain edge costs mu r / (mu + r), which never passes mu
(the function of Geman and McClure). Steps solve the normal equations with the confidences held: full ones (Gauss and
Newton), or damped ones (Marquardt 1963), the damping after Nielsen 1999.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ...core.quaternions import rotations_to_quaternions
from ...kernels.linear_algebra import elementwise
from .connected_parts import connected_parts
from .pose_graph import GraphArrays
from .pose_graph_system import EdgeMeasurements, Misfit, NodePoses, NormalEquations

if TYPE_CHECKING:
    from .pose_graph_optimization import GlobalOptimizationConvergenceCriteria

Array = NDArray[np.float64]
INITIAL_DAMPING = 1e-5  # of the stiffness: nearly full steps from the start, as Nielsen advises where it is a good one
# Damping never falls below this: it keeps motions that no edge determines at rest, and slows no other by more than it.
LEAST_DAMPING = 1e-12
GROWTH = 2.0  # of the damping after a step that failed; doubled with each further one
# Relative change of the residual that is rounding: sums of some thousand products of float64.
ROUNDING = 1e-12


@dataclass(frozen=True, eq=False)
class Pass:
    """What one descent over a fixed set of edges found.

    Attributes:
        poses: The nodes'.
        confidences: The edges' at these poses, [m].
        iterations: Steps that were taken.
        initial_residual: Before the first step.
        residual: After the last.
        weight: mu of the line process.
        reason: The criterion that stopped it, by its name; "no descent" where a full step did not lower the residual.
    """

    poses: NodePoses
    confidences: Array
    iterations: int
    initial_residual: float
    residual: float
    weight: float
    reason: str


def minimise(
    graph: GraphArrays,
    poses: NodePoses,
    reference: int,
    weight: float,
    criteria: GlobalOptimizationConvergenceCriteria,
    *,
    damped: bool,
    motions: NDArray[np.bool_] | None = None,
) -> Pass:
    """Descend from these poses; the reference stays, and where it is not joined to all, one node of each other part.

    Where there are `motions`, bool [6], nodes move along those of the world's axes alone.
    """
    descent = _Descent(graph, poses, anchors_of(graph, reference), weight, criteria, damped, motions)
    initial = descent.residual
    reason = descent.run()
    return Pass(descent.poses, descent.confidences, descent.iterations, initial, descent.residual, weight, reason)


def parts_of(graph: GraphArrays) -> NDArray[np.int32]:
    """The connected part that each node belongs to, [n]."""
    return connected_parts(graph.source, graph.target, len(graph.poses))


def anchors_of(graph: GraphArrays, reference: int) -> NDArray[np.bool_]:
    """The reference and the first node of each part that no path joins to it, as a mask [n]."""
    parts = parts_of(graph)
    firsts = np.unique(parts, return_index=True)[1]
    firsts[parts[reference]] = reference
    anchors = np.zeros(len(parts), bool)
    anchors[firsts] = True
    return anchors


class _Descent:
    """The state between steps."""

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
        self.misfit, self.confidences, self.residual = self._evaluate(poses)
        self.damping, self.growth, self.iterations = INITIAL_DAMPING if damped else LEAST_DAMPING, GROWTH, 0

    def run(self) -> str:
        """Take steps until a criterion is met; returns its name."""
        if not len(self.system.free):
            return "min_right_term"
        while self.iterations < self.criteria.max_iteration:
            reason = "min_residual" if self.residual < self.criteria.min_residual else self._step()
            if reason:
                return reason
        return "max_iteration"

    def _step(self) -> str:
        """Take one step, damped more until it leads down; returns the criterion that is met, or ""."""
        system, criteria = self.system, self.criteria
        system.linearise(self.poses, self.misfit, self.confidences)
        if np.abs(system.right).max() < criteria.min_right_term:
            return "min_right_term"
        for _ in range(criteria.max_iteration_lm if self.damped else 1):
            try:
                solution = system.solve(self.damping)
            except RuntimeError:  # singular to the last digit
                self._damp_more()
                continue
            if _length(solution) < criteria.min_relative_increment * (
                _extent(self.poses) + criteria.min_relative_increment
            ):
                return "min_relative_increment"
            poses = self.poses.moved(system.step_of(solution, len(self.poses.positions)))
            misfit, confidences, residual = self._evaluate(poses)
            gain = self.residual - residual
            if gain > 0:
                self._ease(gain / float((solution * (self.damping * system.scale * solution + system.right)).sum()))
                settled = gain < criteria.min_relative_residual_increment * self.residual
                self.poses, self.misfit, self.confidences, self.residual = poses, misfit, confidences, residual
                self.iterations += 1
                return "min_relative_residual_increment" if settled else ""
            share = ROUNDING if self.damped else max(ROUNDING, criteria.min_relative_residual_increment)
            if -gain <= share * self.residual:
                return "min_relative_residual_increment"
            self._damp_more()
        return "max_iteration_lm" if self.damped else "no descent"

    def _evaluate(self, poses: NodePoses) -> tuple[Misfit, Array, float]:
        """Misfits of the edges, their confidences, and the residual: sums of sqrt(l) r, which the formula above is."""
        misfit = self.edges.misfit(poses)
        share = np.ones(len(self.uncertain))
        share[self.uncertain] = self.weight / (self.weight + misfit.squares[self.uncertain])
        return misfit, share * share, float((share * misfit.squares).sum())

    def _damp_more(self) -> None:
        self.damping *= self.growth
        self.growth *= GROWTH

    def _ease(self, ratio: float) -> None:
        """Damp less, the more so the better the step did what its linear model said (Nielsen 1999, eq. 2.21)."""
        if self.damped:
            factor = 1 - (2 * ratio - 1) ** 3
            factor = min(max(factor, self.criteria.lower_scale_factor), self.criteria.upper_scale_factor)
            self.damping, self.growth = max(self.damping * factor, LEAST_DAMPING), GROWTH


def _length(values: Array) -> float:
    return float(np.sqrt((values * values).sum()))  # not np.linalg.norm, whose sum depends on the number of threads


def _extent(poses: NodePoses) -> float:
    """Length of all poses as one vector: rotation vectors [rad], and positions about their mean [m]."""
    quaternions = rotations_to_quaternions(poses.rotations)
    half_angles = elementwise(math.atan2, np.sqrt((quaternions[:, :3] ** 2).sum(axis=1)), quaternions[:, 3])
    centred = poses.positions - poses.positions.mean(axis=0)
    return float(np.sqrt((4 * half_angles * half_angles).sum() + (centred * centred).sum()))
