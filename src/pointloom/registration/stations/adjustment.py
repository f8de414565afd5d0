"""Least-squares adjustment of stations with 4 or 6 degrees of freedom: pairs, targets, control, levels and positions.

Rows are whitened. Gauss-Newton with step halving. Undetermined common motions (the datum) are fixed at the reference.
With whitened rows A and cofactors Q, R = I - A Q A^T and v_g^T R_gg^-1 v_g of a group is chi-squared (Baarda, "A
testing procedure for use in geodetic networks", 1968).
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import scipy.sparse as sp
from numpy.typing import NDArray

from ...kernels.arrays.sparse_factor import SparseFactor
from ...kernels.linear_algebra import eigh, elementwise, inv, matmul
from ..pose_errors import root_of_covariance
from ..pose_graphs.pose_graph import GraphArrays
from ..pose_graphs.pose_graph_system import EdgeMeasurements, NodePoses
from ..rigid import rotations_of, skew
from .observations import Array, ControlPoint, StationPair, TargetObservation
from .pair_errors import PairErrors

LEVEL_ROWS = [2, 3, 4, 5]  # yaw, x, y, z of the six motions
MIN_EIGENVALUE_RATIO = 1e-12  # relative to the largest eigenvalue: undetermined below
NO_MOTION = 1e-12  # squared length of a zero vector of motions
MIN_ROW_REDUNDANCY = 1e-6  # minimum redundancy of a tested row
MAX_STEPS, MAX_HALVINGS = 60, 12
CONVERGED_STEP = 1e-7  # total step in standard deviations at convergence
SQUARES_ROUNDING = 1e-12  # relative to the sum of squares


@dataclass(frozen=True, eq=False)
class Observed:
    """The observations in level frames; `tilt_sigma`: standard deviation of up [rad], `pair_factor`: sigma factor.

    `errors`: correlated errors of pairs (source, target). The errors of the others are independent.
    """

    pairs: Sequence[StationPair] = ()
    targets: Sequence[TargetObservation] = ()
    control: Sequence[ControlPoint] = ()
    tilt_sigma: float = 0.0
    positions: tuple[Array, float] | None = None
    pair_factor: float = 1.0
    errors: Mapping[tuple[int, int], PairErrors] = field(default_factory=dict)

    def without(self, group: Group) -> Observed:
        names = {"pair": "pairs", "target": "targets", "control": "control"}
        name = names[group.kind]
        remaining = [one for one in getattr(self, name) if one is not group.observation]
        return dataclasses.replace(self, **{name: remaining})


@dataclass(frozen=True, eq=False)
class Group:
    """Rows of one observation, its test `statistic` with `freedom` degrees of freedom, and `redundancy` 0..1."""

    kind: str
    observation: Any
    rows: slice
    residual: Array
    statistic: float = np.nan
    freedom: int = 0
    redundancy: float = 0.0


@dataclass(frozen=True, eq=False)
class Adjusted:
    """Result of an adjustment; `covariances` [n, d, d] of (yaw, x, y, z) or (rotation, translation), a priori."""

    poses: Array
    targets: dict[str, Array]
    covariances: Array
    target_covariances: dict[str, Array]
    groups: list[Group]
    squares: float
    redundancy: int
    loose: NDArray[np.bool_]
    datum: int
    converged: bool


class _Rows:
    def __init__(self) -> None:
        self.entries: list[tuple[NDArray[Any], NDArray[Any], Array]] = []  # rows, columns, values
        self.right: list[Array] = []
        self.groups: list[Group] = []
        self.count = 0

    def add(
        self,
        kind: str,
        observation: TargetObservation | ControlPoint | StationPair | int,
        residual: Array,
        root: Array,
        blocks: list[tuple[int, Array]],
    ) -> None:
        k = len(root)
        for first, J in blocks:
            rows, columns = np.indices((k, J.shape[1]))
            self.entries.append(((rows + self.count).ravel(), (columns + first).ravel(), matmul(root, J).ravel()))
        self.right.append(matmul(root, residual))
        self.groups.append(Group(kind, observation, slice(self.count, self.count + k), residual))
        self.count += k


class _Network:
    def __init__(self, observed: Observed, count: int, level: bool, pivot: Array):
        self.observed, self.count, self.level, self.pivot = observed, count, level, pivot
        self.size = 4 if level else 6
        self.motions = LEVEL_ROWS if level else list(range(6))
        known = {point.name for point in observed.control}
        times: dict[str, int] = {}
        for one in observed.targets:
            times[one.name] = times.get(one.name, 0) + 1
        self.names = [name for name, n in times.items() if n + (name in known) > 1]
        self.column = {name: self.size * count + 3 * k for k, name in enumerate(self.names)}
        self.unknowns = self.size * count + 3 * len(self.names)
        pairs = observed.pairs
        self.information = np.array([pair.information for pair in pairs]).reshape(-1, 6, 6)
        self.edges = EdgeMeasurements(
            GraphArrays(
                np.empty((0, 4, 4)),
                np.array([pair.source for pair in pairs], np.int64),
                np.array([pair.target for pair in pairs], np.int64),
                np.array([pair.transformation for pair in pairs]).reshape(-1, 4, 4),
                self.information,
                np.zeros(len(pairs), bool),
                np.ones(len(pairs)),
            )
        )
        self.roots = [root_of(M[np.ix_(self.motions, self.motions)]) / observed.pair_factor for M in self.information]

    def rows(self, poses: NodePoses, points: dict[str, Array]) -> _Rows:
        rows, observed = _Rows(), self.observed
        self._add_pairs(rows, poses)
        for one in observed.targets:
            if one.name in self.column:
                # in the station's axes: a common rotation changes no residual
                Rt, apart = poses.rotations[one.station].T, poses.positions[one.station] - points[one.name]
                J = np.hstack([matmul(Rt, skew(apart)), Rt])[:, self.motions]
                blocks = [(self.size * one.station, J), (self.column[one.name], -Rt)]
                rows.add("target", one, np.asarray(one.position) + matmul(Rt, apart), np.eye(3) / one.sigma, blocks)
        for point in observed.control:
            if point.name in self.column:
                root = np.diag(1 / np.asarray(point.sigma))
                residual = points[point.name] - (np.asarray(point.position) - self.pivot)
                rows.add("control", point, residual, root, [(self.column[point.name], np.eye(3))])
        if observed.tilt_sigma and not self.level:
            upright = skew(np.array([0.0, 0.0, 1.0]))
            for i, R in enumerate(poses.rotations):  # up in the station's axes
                J = np.hstack([matmul(R.T, upright), np.zeros((3, 3))])[:2]
                rows.add("level", i, R[2, :2].copy(), np.eye(2) / observed.tilt_sigma, [(6 * i, J)])
        if observed.positions is not None:
            shift = np.hstack([np.zeros((3, 3)), np.eye(3)])[:, self.motions]
            for i, position in enumerate(observed.positions[0]):
                if np.isfinite(position).all():
                    residual = poses.positions[i] - (position - self.pivot)
                    rows.add("position", i, residual, np.eye(3) / observed.positions[1], [(self.size * i, shift)])
        return rows

    def _add_pairs(self, rows: _Rows, poses: NodePoses) -> None:
        if not len(self.observed.pairs):
            return
        errors = self.edges.errors(poses)
        by_source, by_target = self.edges.jacobians(poses, errors)
        chosen = np.ix_(self.motions, self.motions)
        for k, pair in enumerate(self.observed.pairs):
            blocks = [(self.size * pair.source, by_source[k][chosen]), (self.size * pair.target, by_target[k][chosen])]
            rows.add("pair", pair, errors.residuals[k][self.motions], self.roots[k], blocks)

    def matrix(self, rows: _Rows) -> sp.csr_matrix:
        parts = [np.concatenate(part) for part in zip(*rows.entries, strict=True)] or [np.empty(0)] * 3
        return sp.csr_matrix((parts[2], (parts[0], parts[1])), shape=(rows.count, self.unknowns))

    def moved(self, poses: NodePoses, points: dict[str, Array], step: Array) -> tuple[NodePoses, dict[str, Array]]:
        steps = np.zeros((self.count, 6))
        steps[:, self.motions] = step[: self.size * self.count].reshape(self.count, self.size)
        moved = {name: points[name] + step[first : first + 3] for name, first in self.column.items()}
        return NodePoses(matmul(rotations_of(steps[:, :3]), poses.rotations), poses.positions + steps[:, 3:]), moved


def adjust(first: Array, observed: Observed, *, level: bool, reference: int = 0) -> Adjusted:
    """The least-squares poses from initial ones [n, 4, 4]; `reference` fixes the datum."""
    pivot = first[:, :3, 3].mean(axis=0)
    network, count = _Network(observed, len(first), level, pivot), len(first)
    poses, points = NodePoses(first[:, :3, :3].copy(), first[:, :3, 3] - pivot), {}
    for one in observed.targets:
        if one.name in network.column and one.name not in points:
            at = matmul(poses.rotations[one.station], np.asarray(one.position))
            points[one.name] = at + poses.positions[one.station]
    poses, points, converged = _descend(network, poses, points, reference)
    rows = network.rows(poses, points)
    A = network.matrix(rows)
    Q, datum, nullity, loose = _cofactors(A, network, reference)
    right = np.concatenate([*rows.right, np.empty(0)])
    groups = [_tested(group, A, Q, right) for group in rows.groups]
    size, rotations = network.size, poses.rotations
    if level:
        yaws = elementwise(math.atan2, rotations[:, 1, 0], rotations[:, 0, 0])
        rotations = rotations_of(np.stack([0 * yaws, 0 * yaws, yaws], axis=1))
    adjusted_poses = np.tile(np.eye(4), (count, 1, 1))
    adjusted_poses[:, :3, :3], adjusted_poses[:, :3, 3] = rotations, poses.positions + pivot
    blocks = [slice(size * i, size * (i + 1)) for i in range(count)]
    spots = [slice(column, column + 3) for column in network.column.values()]
    covariances = _covariances(A, Q, rows.groups, network, [*blocks, *spots])
    return Adjusted(
        adjusted_poses,
        {name: point + pivot for name, point in points.items()},
        np.array(covariances[:count]),
        dict(zip(network.column, covariances[count:], strict=True)),
        groups,
        float((right * right).sum()),
        rows.count - network.unknowns + nullity,
        loose,
        datum,
        converged,
    )


def root_of(information: Array) -> Array:
    """W with W^T W = information, one row per informative direction."""
    values, vectors = eigh((information + information.T) / 2)
    is_positive = values > MIN_EIGENVALUE_RATIO * max(values[-1], 0.0)
    return np.sqrt(values[is_positive])[:, None] * vectors[:, is_positive].T


def _descend(
    network: _Network, poses: NodePoses, points: dict[str, Array], reference: int
) -> tuple[NodePoses, dict[str, Array], bool]:
    """Iterate until steps are a small fraction of the standard deviations."""
    rows = network.rows(poses, points)
    for _ in range(MAX_STEPS):
        A, right = network.matrix(rows), np.concatenate([*rows.right, np.empty(0)])
        H, left, _, stiff = _conditions(A, network, reference)
        datum = _datum_constraints(H, left, stiff)
        N = (A.T @ A).tocsc()
        step = -_factor_of(N + datum).solve(A.T @ right)
        if float(np.sqrt(max((step * (N @ step)).sum(), 0.0))) < CONVERGED_STEP:
            return poses, points, True
        squares = float((right * right).sum())
        for _ in range(MAX_HALVINGS):
            moved = network.moved(poses, points, step)
            rows = network.rows(*moved)
            if float(sum((part * part).sum() for part in rows.right)) <= squares * (1 + SQUARES_ROUNDING):
                break
            step = step / 2
        else:
            return poses, points, False
        poses, points = moved
    return poses, points, False


def _null_space(A: sp.csr_matrix) -> tuple[Array, Array]:
    N = np.asarray((A.T @ A).todense())
    stiff = np.sqrt(np.maximum(np.diag(N), 1e-300))
    stiff = np.where(np.diag(N) > 0, stiff, 1.0)
    values, vectors = eigh(N / stiff[:, None] / stiff[None])
    return vectors[:, values < MIN_EIGENVALUE_RATIO * max(values[-1], 1.0)], stiff


def _conditions(A: sp.csr_matrix, network: _Network, reference: int) -> tuple[Array, Array, Array, Array]:
    """Conditions for the datum and for loose stations, null space, stiffness."""
    Z, stiff = _null_space(A)
    part = slice(network.size * reference, network.size * (reference + 1))
    H = np.zeros((0, network.unknowns))
    if Z.shape[1]:
        squares, U = eigh(matmul(Z[part], Z[part].T))
        H = np.zeros((int((squares > NO_MOTION).sum()), network.unknowns))
        H[:, part] = U[:, squares > NO_MOTION].T
    # what remains undetermined with the datum fixed is loose
    left = matmul(Z, _kernel(matmul(H, Z))) if Z.shape[1] else Z
    return H, left, Z, stiff


def _kernel(M: Array) -> Array:
    squares, vectors = eigh(matmul(M.T, M))
    return vectors[:, squares <= NO_MOTION]


def _factor_of(system: sp.spmatrix) -> SparseFactor:
    columns = sp.csc_matrix(system)
    factor = SparseFactor(columns.indptr, columns.indices)
    factor.factor(columns.data)
    return factor


def _datum_constraints(H: Array, left: Array, stiff: Array) -> sp.csc_matrix:
    full = matmul(H.T, H) + matmul(left, left.T)
    return sp.csc_matrix(full * stiff[:, None] * stiff[None])


def _cofactors(A: sp.csr_matrix, network: _Network, reference: int) -> tuple[Array, int, int, NDArray[np.bool_]]:
    """Cofactors of the unknowns, numbers of datum and of all conditions, mask of loose stations."""
    H, left, Z, stiff = _conditions(A, network, reference)
    N = (A.T @ A).tocsc()
    Q = _factor_of(N + _datum_constraints(H, left, stiff)).solve(np.eye(network.unknowns))
    Q = (Q + Q.T) / 2 * stiff[:, None] * stiff[None]
    if Z.shape[1]:  # the conditions are exact: their contribution is subtracted
        C = np.vstack([H, left.T])
        G = matmul(Z, inv(matmul(C, Z)))
        Q = Q - matmul(G, G.T)
    Q = Q / stiff[:, None] / stiff[None]
    moves = (left.reshape(network.unknowns, -1) ** 2).sum(axis=1)[: network.size * network.count]
    loose = moves.reshape(network.count, network.size).sum(axis=1) > 1e-6
    return Q, len(H), Z.shape[1], loose


def _covariances(
    A: sp.csr_matrix, Q: Array, groups: Sequence[Group], network: _Network, parts: Sequence[slice]
) -> list[Array]:
    """Covariances of parts of the unknowns. Pairs with known errors are correlated within blocks of space."""
    errors, keys, by_block, by_row = network.observed.errors, [], [], []
    for k, group in enumerate(groups):  # pairs are the first groups
        rows = A[group.rows]
        columns = np.unique(rows.indices)
        gain = matmul(np.asarray(rows[:, columns].todense()), Q[columns])
        one = errors.get((group.observation.source, group.observation.target)) if group.kind == "pair" else None
        if one is None:
            by_row.append(gain)
            continue
        root = network.roots[k] * network.observed.pair_factor
        keys.append(one.blocks)
        by_block.append(matmul(one.influences, root.T, gain))
        by_row.append(matmul(root_of_covariance(matmul(root, one.common, root.T)), gain))
    if not keys:
        return [Q[part, part] for part in parts]
    _, block = np.unique(np.concatenate(keys), return_inverse=True)
    shared = np.zeros((int(block.max()) + 1, Q.shape[1]))
    np.add.at(shared, block.reshape(-1), np.concatenate(by_block))
    total = np.concatenate([shared, *by_row])
    return [matmul(total[:, part].T, total[:, part]) for part in parts]


def _tested(group: Group, A: sp.csr_matrix, Q: Array, right: Array) -> Group:
    part = A[group.rows]
    columns = np.unique(part.indices)
    dense = np.asarray(part[:, columns].todense())
    R = np.eye(len(dense)) - matmul(dense, Q[np.ix_(columns, columns)], dense.T)
    values, vectors = eigh((R + R.T) / 2)
    is_testable = values > MIN_ROW_REDUNDANCY
    along = matmul(vectors[:, is_testable].T, right[group.rows])
    statistic = float((along * along / values[is_testable]).sum()) if is_testable.any() else np.nan
    fraction = float(np.clip(np.trace(R) / max(len(R), 1), 0, 1))
    return dataclasses.replace(group, statistic=statistic, freedom=int(is_testable.sum()), redundancy=fraction)
