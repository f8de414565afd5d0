"""Pose graph of the submaps of LiDAR SLAM: poses, covariances of relative poses, and their optimization."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ...core.quaternions import nearest_rotations
from ...kernels.linear_algebra import eigh, inv, matmul, norm, solve
from ..pose_errors import PoseCovariance
from ..pose_graphs.connected_parts import connected_parts
from ..pose_graphs.pose_graph import GraphArrays
from ..pose_graphs.pose_graph_optimization import USUAL_CRITERIA, anchors_of, minimize
from ..pose_graphs.pose_graph_system import EdgeMeasurements, NodePoses, NormalEquations
from ..rigid import invert_pose, make_pose, rotation_vector, skew
from .position_priors import (
    FINAL_STEPS,
    MAX_PRIOR_SQUARE,
    NO_PRIORS,
    WIDTH_STEP,
    PositionPriors,
    PositionRow,
    align_path,
    alignment_cost,
    level_measurement,
)

Matrix = NDArray[np.float64]

# Errors of odometry that its covariance does not include, per root of 30 m: KITTI's benchmark reports 0.2 to 0.7 % and
# 0.2 degrees per 100 m for LiDAR odometry.
DRIFT_LENGTH = 30.0  # [m]
DRIFT_TRANSLATION = 0.005  # of the traveled distance
DRIFT_ROTATION = math.radians(0.1)
# Where the map begins anew, since scans do not fit it: headings were lost by up to half a radian.
BREAK_ROTATION, BREAK_TRANSLATION = 0.3, 5.0  # [rad], [m]
# Between sessions before a place is recognized: any rotation, and positions within 10 km.
UNKNOWN_ROTATION, UNKNOWN_TRANSLATION = 3.0, 1e4  # [rad], [m]
# Error of a registered loop that its surfaces do not show: the submaps themselves are bent a little.
LOOP_TRANSLATION, LOOP_ROTATION = 0.05, math.radians(0.1)  # [m], [rad]
GRAPH_DAMPING = 1e-12  # relative to the stiffness of the nodes


@dataclass(frozen=True, eq=False)
class MotionEdge:
    """A measured relative pose T_target_source and its covariance, float64 [6, 6].

    The covariance is of a rotation vector [rad] and the displacement of the source's origin [m], along the source's
    axes.
    """

    source: int
    target: int
    transformation: Matrix
    covariance: Matrix


def odometry_edge(
    nodes: tuple[int, int],
    poses: tuple[Matrix, Matrix],
    errors: tuple[PoseCovariance, PoseCovariance],
    length: float,
    break_count: int = 0,
) -> MotionEdge:
    """The edge of two nodes (source, target) from their odometry poses and the covariances of these.

    `length` [m] is the distance between them, `break_count` the number of scans that do not fit the map before.
    """
    source, target = nodes
    (T_source, T_target), (of_source, of_target) = poses, errors
    position, R = T_source[:3, 3], T_source[:3, :3]
    grown = positive_part(of_source.about(position).matrix - of_target.about(position).matrix)
    matrix = in_axes(grown, R.T) + drift_covariance(length)
    matrix += break_count * np.diag([BREAK_ROTATION**2] * 3 + [BREAK_TRANSLATION**2] * 3)
    return MotionEdge(source, target, matmul(invert_pose(T_target), T_source), matrix)


def drift_covariance(length: float) -> Matrix:
    """Covariance of the errors that a covariance of odometry does not include, over a distance [m]."""
    parts = max(length / DRIFT_LENGTH, 1e-3)
    rotation, translation = DRIFT_ROTATION**2 * parts, (DRIFT_TRANSLATION * DRIFT_LENGTH) ** 2 * parts
    return np.diag([rotation] * 3 + [translation] * 3)


def loop_covariance(error: PoseCovariance, transformation: Matrix) -> Matrix:
    """Covariance of a loop edge from that of the registration, along the source's axes about its origin."""
    R = transformation[:3, :3]
    matrix = in_axes(error.about(transformation[:3, 3]).matrix, R.T)
    return matrix + np.diag([LOOP_ROTATION**2] * 3 + [LOOP_TRANSLATION**2] * 3)


def in_axes(covariance: Matrix, R: Matrix) -> Matrix:
    """A covariance (rotation, translation) along rotated axes."""
    A = np.zeros((6, 6))
    A[:3, :3] = A[3:, 3:] = R
    rotated = matmul(A, covariance, A.T)
    return (rotated + rotated.T) / 2


def positive_part(matrix: Matrix) -> Matrix:
    """The nearest positive semidefinite matrix, in units in which rotations and translations are comparable."""
    scale = np.sqrt(np.maximum(np.abs(np.diag(matrix)), 1e-18))
    values, vectors = eigh(matrix / np.outer(scale, scale))
    positive = matmul(vectors * np.maximum(values, 0.0), vectors.T) * np.outer(scale, scale)
    return (positive + positive.T) / 2


class SubmapGraph:
    """Poses T_world_submap, with the first submap fixed, and the edges that measure their motions.

    Submaps that no edges join with the first one form parts in frames of their own: their first submap is fixed.
    `priors` are given positions of submaps, `reference` is the pose T_world_reference of their frame, if known.
    """

    def __init__(
        self,
        poses: Sequence[Matrix] = (),
        edges: Sequence[MotionEdge] = (),
        priors: PositionPriors = NO_PRIORS,
        reference: Matrix | None = None,
    ):
        self.poses, self.edges, self.priors, self.reference = list(poses), list(edges), priors, reference
        self._system: NormalEquations | None = None
        self._chain: Matrix | None = None
        self._parts: NDArray[np.int32] | None = None

    def with_submap(self, pose: Matrix, edge: MotionEdge | None, positions: Sequence[PositionRow] = ()) -> SubmapGraph:
        """With a submap, its odometry, and given positions of points in its frame."""
        edges = self.edges if edge is None else [*self.edges, edge]
        return SubmapGraph(
            [*self.poses, pose], edges, self.priors.with_rows(len(self.poses), positions), self.reference
        )

    def with_edges(self, edges: Iterable[MotionEdge]) -> SubmapGraph:
        """With more edges. A part that one joins with another is moved as a whole."""
        graph = self
        for edge in edges:
            if not graph.are_joined(edge.source, edge.target):
                expected = matmul(graph.poses[edge.target], edge.transformation)
                graph = graph.moved(edge.source, edge.target, matmul(expected, invert_pose(graph.poses[edge.source])))
            graph = SubmapGraph(graph.poses, [*graph.edges, edge], graph.priors, graph.reference)
        return graph

    @property
    def parts(self) -> NDArray[np.int32]:
        """Number of the part of each submap, and of the reference if known."""
        if self._parts is None:
            source, target = self._ends()
            self._parts = connected_parts(source, target, len(self._stack()))
        return self._parts

    def are_joined(self, a: int, b: int) -> bool:
        return bool(self.parts[a] == self.parts[b])

    def moved(self, node: int, other: int, motion: Matrix) -> SubmapGraph:
        """The part of a node moved onto that of another, or the inverse if it contains the earlier submap."""
        parts = self.parts
        if parts[node] < parts[other]:
            node, motion = other, invert_pose(motion)
        poses = [matmul(motion, T) if part == parts[node] else T for T, part in zip(self._stack(), parts, strict=True)]
        reference = None if self.reference is None else poses.pop()
        return SubmapGraph(poses, self.edges, self.priors, reference)

    def located(self) -> SubmapGraph:
        """The optimized graph, with all parts aligned with the given positions, if any are new."""
        if self.priors.is_aligned.all():
            return self
        graph = self.aligned()
        return self if graph.reference is None else graph.optimized()

    def aligned(self) -> SubmapGraph:
        """The graph with the reference, to which the parts with enough positions are joined."""
        graph = self
        for first in np.unique(self.parts[: len(self.poses)], return_index=True)[1].tolist():
            rows = graph.parts[graph.priors.nodes] == graph.parts[first]
            priors, poses = graph.priors.at(rows), np.array(graph.poses)
            points = priors.world_points(poses)
            found = align_path(points, priors.positions, priors.sigmas)
            reference, is_joined = graph.reference, graph.reference is not None and graph.are_joined(first, -1)
            if found is not None and is_joined and reference is not None:
                costs = [alignment_cost(priors.squares(poses, T)) for T in (invert_pose(found), reference)]
                reference = invert_pose(found) if costs[0] < costs[1] else reference
            elif found is not None and reference is not None:
                graph = graph.moved(first, len(graph.poses), matmul(reference, found))
                reference = graph.reference
            elif found is not None:
                reference = invert_pose(found)
            weights = np.where(rows & (found is not None or is_joined), 1.0, graph.priors.weights)
            graph = SubmapGraph(graph.poses, graph.edges, replace(graph.priors, weights=weights), reference)
        return graph

    def relative_pose(self, source: int, target: int) -> Matrix:
        """T_target_source."""
        return matmul(invert_pose(self.poses[target]), self.poses[source])

    def relative_covariance(self, source: int, target: int) -> Matrix:
        """Covariance of the error of T_target_source along the source's axes, as of `MotionEdge`."""
        if not self.are_joined(source, target):
            return np.diag([UNKNOWN_ROTATION**2] * 3 + [UNKNOWN_TRANSLATION**2] * 3)
        between = self.poses[source][:3, 3] - self.poses[target][:3, 3]
        J = np.zeros((6, 12))
        J[:, :6], J[:, 6:] = np.eye(6), -np.eye(6)
        J[3:, 6:9] = skew(between)
        return in_axes(matmul(J, self._joint_covariance(source, target), J.T), self.poses[source][:3, :3].T)

    def chain_sigma(self, source: int, target: int) -> float:
        """Standard deviation [m] of the distance between two submaps along the odometry alone: an upper bound."""
        if self._chain is None:
            self._chain = _chain_sums(len(self.poses), self.edges)
        low, high = sorted((source, target))
        along, rotations, moments, squares, shifts, breaks = self._chain[:, high] - np.append(0.0, self._chain[1:, low])
        if breaks:
            return math.inf
        lever = rotations * along**2 - 2 * moments * along + squares
        return math.sqrt(max(float(shifts + lever), 0.0))

    def covariance(self, node: int) -> PoseCovariance:
        """Covariance of a pose relative to the first submap of its part, about its position along the world's axes."""
        joint = self._joint_covariance(node, node)
        return PoseCovariance(joint[:6, :6], self.poses[node][:3, 3].copy())

    def square(self, edge: MotionEdge) -> float:
        """Squared Mahalanobis distance of a new edge from the relative pose of the graph, 6 degrees of freedom."""
        expected = self.relative_covariance(edge.source, edge.target) + edge.covariance
        return mahalanobis(edge, self.relative_pose(edge.source, edge.target), expected)

    @property
    def prior_squares(self) -> Matrix:
        """Squared errors of the given positions in standard deviations. NaN if not aligned."""
        if self.reference is None:
            return np.full(len(self.priors), np.nan)
        squares = self.priors.squares(np.array(self.poses), self.reference)
        return np.where(self.priors.is_aligned, squares, np.nan)

    def optimized(self) -> SubmapGraph:
        """The graph with the poses that balance all edges, and the given positions with robust weights."""
        if self.reference is None:
            return self.minimized()
        graph, width, steps = self, self.priors.first_width(self.prior_squares), 0
        while steps < FINAL_STEPS:
            priors = graph.priors.weighted(np.nan_to_num(graph.prior_squares), width)
            graph = SubmapGraph(graph.poses, graph.edges, priors, graph.reference).minimized()
            steps += width <= MAX_PRIOR_SQUARE
            width = max(width / WIDTH_STEP, MAX_PRIOR_SQUARE)
        return graph

    def minimized(self) -> SubmapGraph:
        if len(self._stack()) < 2:
            return self
        graph = self._arrays()
        result = minimize(graph, self._node_poses(), 0, 0.0, USUAL_CRITERIA, damped=True)
        offset, is_fixed = self.poses[0][:3, 3], anchors_of(graph, 0)
        solved = [make_pose(R, t + offset) for R, t in zip(result.poses.rotations, result.poses.positions, strict=True)]
        poses = [T if fixed else new for T, new, fixed in zip(self._stack(), solved, is_fixed, strict=True)]
        reference = None if self.reference is None else poses.pop()
        return SubmapGraph(poses, self.edges, self.priors, reference)

    def _stack(self) -> list[Matrix]:
        return self.poses if self.reference is None else [*self.poses, self.reference]

    def _node_poses(self) -> NodePoses:
        stack = np.array(self._stack())
        return NodePoses(nearest_rotations(stack[:, :3, :3]), stack[:, :3, 3] - stack[0, :3, 3])

    def _ends(self) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        """Sources and targets of the edges, then of the aligned positions and of the level of the first of them."""
        ends = np.array([(edge.source, edge.target) for edge in self.edges], np.int64).reshape(-1, 2)
        nodes = self.priors.nodes[self.priors.is_aligned]
        nodes = np.append(nodes, nodes[:1])
        source = np.append(ends[:, 0], nodes)
        return source, np.append(ends[:, 1], np.full(len(nodes), len(self.poses)))

    def _arrays(self) -> GraphArrays:
        source, target = self._ends()
        measured = np.array([edge.transformation for edge in self.edges]).reshape(-1, 4, 4)
        information = np.array([_inverse(edge.covariance) for edge in self.edges]).reshape(-1, 6, 6)
        if self.reference is not None and len(source) > len(self.edges):
            rows = self.priors.measurements(np.array(self.poses), self.reference)
            level = level_measurement(self.poses[source[-1]], self.reference)
            measured = np.concatenate([measured, rows[0], level[0][None]])
            information = np.concatenate([information, rows[1], level[1][None]])
        return GraphArrays(
            np.array(self._stack()), source, target, measured, information, np.zeros(len(source), bool),
            np.ones(len(source)),
        )  # fmt: skip

    def _joint_covariance(self, a: int, b: int) -> Matrix:
        """Covariance [12, 12] of the motions (rotation, shift) of two nodes along the world's axes."""
        if self._system is None:
            arrays = self._arrays()
            edges, poses = EdgeMeasurements(arrays), self._node_poses()
            system = NormalEquations(edges, anchors_of(arrays, 0))
            system.linearize(poses, edges.errors(poses), np.ones(len(arrays.source)))
            if len(system.free):
                system.solve(GRAPH_DAMPING)  # factors the matrix
            self._system = system
        system, joint = self._system, np.zeros((12, 12))
        rows = {int(node): at for at, node in enumerate(system.free)}
        wanted = [(6 * k, rows[node]) for k, node in enumerate((a, b)) if node in rows]
        right = np.zeros((6 * len(rows), 6 * len(wanted)))
        for k, (_, at) in enumerate(wanted):
            right[6 * at : 6 * at + 6, 6 * k : 6 * k + 6] = np.eye(6)
        if wanted:
            solved = system.factor.solve(right)
            for k, (column, _) in enumerate(wanted):
                for row, at in wanted:
                    joint[row : row + 6, column : column + 6] = solved[6 * at : 6 * at + 6, 6 * k : 6 * k + 6]
        return (joint + joint.T) / 2


def _chain_sums(count: int, edges: Sequence[MotionEdge]) -> Matrix:
    """Distance along the odometry, and sums up to each node, [6, n].

    Of the rotation variances, these times the distance and its square, of the translation variances, and of the number
    of submaps without odometry, which begin a session.
    """
    rows = np.zeros((6, count))
    rows[5, 1:] = 1
    for edge in edges:
        if edge.source == edge.target + 1:
            rows[5, edge.source] = 0
            rotation, translation = np.diag(edge.covariance).reshape(2, 3).sum(axis=1)
            rows[:2, edge.source] = norm(edge.transformation[:3, 3]), rotation
            rows[4, edge.source] = translation
    rows[0] = np.cumsum(rows[0])
    rows[2], rows[3] = rows[1] * rows[0], rows[1] * rows[0] ** 2
    rows[1:] = np.cumsum(rows[1:], axis=1)
    return rows


def _inverse(covariance: Matrix) -> Matrix:
    """Inverse of a covariance whose rotations and translations differ by orders of magnitude."""
    scale = 1 / np.sqrt(np.diag(covariance))
    information = inv(covariance * np.outer(scale, scale)) * np.outer(scale, scale)
    return (information + information.T) / 2


def motion_between(measured: Matrix, expected: Matrix) -> Matrix:
    """Rotation vector and shift, [6], along the source's axes from an expected to a measured T_target_source."""
    difference = matmul(invert_pose(expected), measured)
    return np.concatenate([rotation_vector(difference[:3, :3]), difference[:3, 3]])


def mahalanobis(edge: MotionEdge, expected: Matrix, covariance: Matrix) -> float:
    motion = motion_between(edge.transformation, expected)
    scale = 1 / np.sqrt(np.diag(covariance))
    return float(matmul(motion * scale, solve(covariance * np.outer(scale, scale), motion * scale)))


def shift_of(edge: MotionEdge, expected: Matrix) -> float:
    """Displacement [m] of the source's origin from an expected pose."""
    return float(norm(motion_between(edge.transformation, expected)[3:]))
