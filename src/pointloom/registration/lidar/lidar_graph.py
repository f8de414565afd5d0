"""Pose graph of the submaps of LiDAR SLAM: poses, covariances of relative poses, and their optimization."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...core.quaternions import nearest_rotations
from ...kernels.linear_algebra import eigh, inv, matmul, norm, solve
from ..pose_errors import PoseCovariance
from ..pose_graphs.pose_graph import GraphArrays
from ..pose_graphs.pose_graph_optimization import USUAL_CRITERIA, minimize
from ..pose_graphs.pose_graph_system import EdgeMeasurements, NodePoses, NormalEquations
from ..rigid import invert_pose, make_pose, rotation_vector, skew

Matrix = NDArray[np.float64]

# Errors of odometry that its covariance does not include, per root of 30 m: KITTI's benchmark reports 0.2 to 0.7 % and
# 0.2 degrees per 100 m for LiDAR odometry.
DRIFT_LENGTH = 30.0  # [m]
DRIFT_TRANSLATION = 0.005  # of the traveled distance
DRIFT_ROTATION = math.radians(0.1)
# Where the map begins anew, since scans do not fit it: headings were lost by up to half a radian.
BREAK_ROTATION, BREAK_TRANSLATION = 0.3, 5.0  # [rad], [m]
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
    """Poses T_world_submap, with the first submap fixed, and the edges that measure their motions."""

    def __init__(self, poses: Sequence[Matrix] = (), edges: Sequence[MotionEdge] = ()):
        self.poses, self.edges = list(poses), list(edges)
        self._system: NormalEquations | None = None
        self._chain: Matrix | None = None

    def with_submap(self, pose: Matrix, edge: MotionEdge | None) -> SubmapGraph:
        return SubmapGraph([*self.poses, pose], self.edges if edge is None else [*self.edges, edge])

    def relative_pose(self, source: int, target: int) -> Matrix:
        """T_target_source."""
        return matmul(invert_pose(self.poses[target]), self.poses[source])

    def relative_covariance(self, source: int, target: int) -> Matrix:
        """Covariance of the error of T_target_source along the source's axes, as of `MotionEdge`."""
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
        along, rotations, moments, squares, shifts = self._chain[:, high] - np.append(0.0, self._chain[1:, low])
        lever = rotations * along**2 - 2 * moments * along + squares
        return math.sqrt(max(float(shifts + lever), 0.0))

    def covariance(self, node: int) -> PoseCovariance:
        """Covariance of a pose relative to the first submap, about its position along the world's axes."""
        joint = self._joint_covariance(node, node)
        return PoseCovariance(joint[:6, :6], self.poses[node][:3, 3].copy())

    def square(self, edge: MotionEdge) -> float:
        """Squared Mahalanobis distance of a new edge from the relative pose of the graph, 6 degrees of freedom."""
        expected = self.relative_covariance(edge.source, edge.target) + edge.covariance
        return mahalanobis(edge, self.relative_pose(edge.source, edge.target), expected)

    def optimized(self) -> SubmapGraph:
        """The graph with the poses that balance all edges."""
        if len(self.poses) < 2:
            return self
        graph, poses = self._arrays(), self._node_poses()
        result = minimize(graph, poses, 0, 0.0, USUAL_CRITERIA, damped=True)
        offset = self.poses[0][:3, 3]
        solved = [make_pose(R, t + offset) for R, t in zip(result.poses.rotations, result.poses.positions, strict=True)]
        return SubmapGraph([self.poses[0], *solved[1:]], self.edges)

    def _node_poses(self) -> NodePoses:
        stack = np.array(self.poses)
        return NodePoses(nearest_rotations(stack[:, :3, :3]), stack[:, :3, 3] - stack[0, :3, 3])

    def _arrays(self) -> GraphArrays:
        count = len(self.edges)
        return GraphArrays(
            np.array(self.poses),
            np.array([edge.source for edge in self.edges], np.int64),
            np.array([edge.target for edge in self.edges], np.int64),
            np.array([edge.transformation for edge in self.edges]).reshape(-1, 4, 4),
            np.array([_inverse(edge.covariance) for edge in self.edges]).reshape(-1, 6, 6),
            np.zeros(count, bool),
            np.ones(count),
        )

    def _joint_covariance(self, a: int, b: int) -> Matrix:
        """Covariance [12, 12] of the motions (rotation, shift) of two nodes along the world's axes."""
        if self._system is None:
            edges, poses = EdgeMeasurements(self._arrays()), self._node_poses()
            system = NormalEquations(edges, np.arange(len(self.poses)) == 0)
            system.linearize(poses, edges.errors(poses), np.ones(len(self.edges)))
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
    """Distance along the odometry, and sums up to each node, [5, n].

    Of the rotation variances, these times the distance and its square, and of the translation variances.
    """
    rows = np.zeros((5, count))
    for edge in edges:
        if edge.source == edge.target + 1:
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
