"""Least squares of a pose graph: edge residuals, Jacobians, and sparse normal equations.

The edge error is E = X^-1 T_t^-1 T_s with X = T_target_source measured (Choi, Zhou and Koltun 2015, eq. 6). The
residual is (2 sin(a/2) axis, translation) of E, which grows up to half a turn (Open3D's sin(a) does not). Steps R <-
exp(w) R, t <- t + v do not depend on the world origin.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp
from numpy.typing import NDArray
from scipy.sparse.linalg import splu

from ...core.quaternions import nearest_rotations, rotations_to_quaternions
from ...kernels.arrays.sparse_factor import SparseFactor
from ...kernels.linear_algebra import matmul
from ..rigid import rotations_of, skews
from .pose_graph import GraphArrays

Array = NDArray[np.float64]
# SuperLU as a symmetric solver: no pivoting off the diagonal, an ordering for A + A^T.
SYMMETRIC_MODE = {"diag_pivot_thresh": 0.0, "options": {"SymmetricMode": True}}


@dataclass(frozen=True, eq=False)
class NodePoses:
    rotations: Array
    positions: Array

    def moved(self, step: Array) -> NodePoses:
        """The poses after a step [n, 6]: rotated about their own positions, then shifted."""
        return NodePoses(matmul(rotations_of(step[:, :3]), self.rotations), self.positions + step[:, 3:])


@dataclass(frozen=True, eq=False)
class EdgeErrors:
    """Edge `residuals` (rotation, translation) [m, 6], cosines of half the angle [m], and weighted squares [m]."""

    residuals: Array
    scalars: Array
    squares: Array


class EdgeMeasurements:
    def __init__(self, graph: GraphArrays):
        self.source, self.target = graph.source, graph.target
        self.information = graph.information
        self.rotations = nearest_rotations(graph.transformations[:, :3, :3])
        self.translations = graph.transformations[:, :3, 3]

    def errors(self, poses: NodePoses) -> EdgeErrors:
        to_edge, apart = self._frames(poses)
        quaternions = rotations_to_quaternions(matmul(to_edge, poses.rotations[self.source]))
        translations = _apply(to_edge, apart) - _apply(self.rotations.transpose(0, 2, 1), self.translations)
        residuals = np.concatenate([2 * quaternions[:, :3], translations], axis=1)
        squares = (residuals * _apply(self.information, residuals)).sum(axis=1)
        return EdgeErrors(residuals, quaternions[:, 3], squares)

    def jacobians(self, poses: NodePoses, errors: EdgeErrors) -> tuple[Array, Array]:
        """Derivatives of the residuals by the steps of source and target node, [m, 6, 6] each."""
        to_edge, apart = self._frames(poses)
        turning = errors.scalars[:, None, None] * np.eye(3) - skews(errors.residuals[:, :3]) / 2
        by_source = np.zeros((len(self.source), 6, 6))
        by_target = np.zeros_like(by_source)
        by_source[:, :3, :3] = matmul(turning, to_edge)
        by_source[:, 3:, 3:] = to_edge
        by_target[:, :3, :3] = -by_source[:, :3, :3]
        by_target[:, 3:, :3] = matmul(to_edge, skews(apart))
        by_target[:, 3:, 3:] = -to_edge
        return by_source, by_target

    def _frames(self, poses: NodePoses) -> tuple[Array, Array]:
        """Rotations from the world to the residual frames, [m, 3, 3]. From target to source, [m, 3] [m]."""
        to_edge = matmul(poses.rotations[self.target], self.rotations).transpose(0, 2, 1)
        return to_edge, poses.positions[self.source] - poses.positions[self.target]


class NormalEquations:
    """Sparse normal equations: symbolic structure once, then numeric factorization per step, in fixed order."""

    def __init__(self, edges: EdgeMeasurements, anchored: NDArray[np.bool_], motions: NDArray[np.bool_] | None = None):
        self.edges = edges
        self.free = np.flatnonzero(~anchored)
        count = len(self.free)
        order = np.full(len(anchored), -1)
        order[self.free] = np.arange(count)
        source, target = order[edges.source], order[edges.target]
        order[self.free] = _fill_reducing_order(source, target, count)
        self.free = self.free[np.argsort(order[self.free])]
        source, target = order[edges.source], order[edges.target]
        between = (source >= 0) & (target >= 0)
        low, high = np.minimum(source, target), np.maximum(source, target)
        self.pairs, pair_of = np.unique(low[between] * count + high[between], return_inverse=True)
        self.upper = between & (source < target)
        self.sum_pairs = _sums(pair_of, np.flatnonzero(between), (len(self.pairs), len(source)))
        ends = np.concatenate([source, target])
        self.sum_nodes = _sums(ends[ends >= 0], np.flatnonzero(ends >= 0), (count, len(ends)))
        self._lay_out(count)
        self.moving = None if motions is None else np.tile(motions, count)

    def _lay_out(self, count: int) -> None:
        """Positions of the blocks: diagonal, pairs, and transposes, sorted by row and column."""
        low, high = np.divmod(self.pairs, max(count, 1))
        rows = np.concatenate([np.arange(count), low, high])
        columns = np.concatenate([np.arange(count), high, low])
        self.order = np.lexsort((columns, rows))
        self.columns = columns[self.order]
        self.starts = np.concatenate([[0], np.cumsum(np.bincount(rows, minlength=count))])
        ones = self._matrix(np.ones((len(rows), 6, 6)))
        self.factor = SparseFactor(ones.indptr, ones.indices)
        self.diagonal = np.flatnonzero(ones.indices == np.repeat(np.arange(6 * count), np.diff(ones.indptr)))

    def linearize(self, poses: NodePoses, errors: EdgeErrors, weights: Array) -> None:
        """Linearize with edge weights; sets `right` (minus half the gradient) and `scale` (stiffness), [6 f]."""
        by_source, by_target = self.edges.jacobians(poses, errors)
        information = weights[:, None, None] * self.edges.information
        weighted_source, weighted_target = matmul(information, by_source), matmul(information, by_target)
        source_across, target_across = by_source.transpose(0, 2, 1), by_target.transpose(0, 2, 1)
        ends = np.concatenate([matmul(source_across, weighted_source), matmul(target_across, weighted_target)])
        upper = self.upper[:, None, None]
        between = matmul(
            np.where(upper, source_across, target_across), np.where(upper, weighted_target, weighted_source)
        )
        pulls = np.concatenate(
            [_apply(weighted_source.transpose(0, 2, 1), errors.residuals),
             _apply(weighted_target.transpose(0, 2, 1), errors.residuals)]
        )  # fmt: skip
        nodes = (self.sum_nodes @ ends.reshape(-1, 36)).reshape(-1, 6, 6)
        pairs = (self.sum_pairs @ between.reshape(-1, 36)).reshape(-1, 6, 6)
        self.right = -(self.sum_nodes @ pulls).ravel()
        self.matrix = self._matrix(np.concatenate([nodes, pairs, pairs.transpose(0, 2, 1)]))
        self.scale = _stiffness(nodes)
        if self.moving is not None:
            self._fix(self.moving)

    def _fix(self, moving: NDArray[np.bool_]) -> None:
        columns = np.repeat(np.arange(len(moving)), np.diff(self.matrix.indptr))
        self.matrix.data *= moving[columns] & moving[self.matrix.indices]
        self.matrix.data[self.diagonal[~moving]] = self.scale[~moving]
        self.right[~moving] = 0

    def solve(self, damping: float) -> Array:
        """The step [6 f] with `damping` times the scale on the diagonal. RuntimeError if singular."""
        self._factor(damping)
        return self.factor.solve(self.right)

    def inverse(self, damping: float) -> Array:
        """Inverse of the matrix of `solve`, [6 f, 6 f]. RuntimeError if singular."""
        self._factor(damping)
        return self.factor.solve(np.eye(len(self.right)))

    def _factor(self, damping: float) -> None:
        damped = self.matrix.data.copy()
        damped[self.diagonal] += damping * self.scale
        self.factor.factor(damped)

    def step_of(self, solution: Array, count: int) -> Array:
        step = np.zeros((count, 6))
        step[self.free] = solution.reshape(-1, 6)
        return step

    def _matrix(self, blocks: Array) -> sp.csc_matrix:
        size = 6 * (len(self.starts) - 1)
        rows = sp.bsr_matrix((blocks[self.order], self.columns, self.starts), shape=(size, size)).tocsr()
        return sp.csc_matrix((rows.data, rows.indices, rows.indptr), shape=(size, size))  # symmetric


def _stiffness(nodes: Array) -> Array:
    """Isotropic stiffness of each node, [6 f]. At least 1e-9 of the largest, for undetermined nodes."""
    diagonal = np.diagonal(nodes, axis1=1, axis2=2)
    means = diagonal.reshape(-1, 2, 3).mean(axis=2)
    floor = 1e-9 * means.max(axis=0, initial=0)
    floor = np.where(floor > 0, floor, 1.0)
    return np.repeat(np.maximum(means, floor), 3, axis=1).ravel()


def _fill_reducing_order(source: NDArray[np.int64], target: NDArray[np.int64], count: int) -> NDArray[np.int64]:
    """Node permutation for sparse factors (minimum degree, by SuperLU)."""
    between = (source >= 0) & (target >= 0)
    rows, columns = np.concatenate([[source, target], [target, source]], axis=1)[:, np.tile(between, 2)]
    links = sp.coo_matrix((np.full(len(rows), -1.0), (rows, columns)), shape=(count, count)).tocsc()
    degrees = np.bincount(rows, minlength=count)
    if not count:
        return np.empty(0, np.int64)
    system = (links + sp.diags(degrees + 1.0)).tocsc()
    return splu(system, permc_spec="MMD_AT_PLUS_A", **SYMMETRIC_MODE).perm_c.astype(np.int64)


def _sums(rows: NDArray[np.int64], columns: NDArray[np.int64], shape: tuple[int, int]) -> sp.csr_matrix:
    return sp.csr_matrix((np.ones(len(rows)), (rows, columns)), shape=shape)


def _apply(matrices: Array, vectors: Array) -> Array:
    return matmul(matrices, vectors[:, :, None])[:, :, 0]
