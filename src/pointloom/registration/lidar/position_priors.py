"""Given positions as priors of the pose graph of LiDAR SLAM: residuals, robust weights, and the initial alignment.

The positions are in a frame of their own, the reference, whose pose in the world of the map is estimated. Wrong
positions get low weights by the kernel of Geman and McClure, whose width falls as in Yang et al., "Graduated
Non-Convexity for Robust Spatial Perception", RA-L 2020.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import matmul
from ..rigid import make_pose, skews

Array = NDArray[np.float64]

MAX_PRIOR_SQUARE = 16.3  # squared error in sigmas that 0.1 % of correct positions exceed (chi-square of 3)
WIDTH_QUANTILE, WIDTH_STEP = 0.7, 4.0  # of the squared errors: first width of the kernel, and its factor per step
FINAL_STEPS = 3  # with the last width
TILT_SIGMA = 0.1  # [rad] between the z axes of the scanner and of the reference, as a scanner may be mounted
MIN_ALIGNED, MIN_ALIGNED_FRACTION = 4, 0.5  # positions that agree with an alignment: two always do
MIN_EXTENT_SIGMAS = 10.0  # horizontal extent of these: the heading is then known to 8 degrees
ALIGNED_DRIFT = 0.02  # of the extent: drift of the path before it is aligned, and errors of the heading
PAIR_COUNT, ROW_COUNT = 600, 500  # of positions for an alignment: two thirds wrong ones leave 60 right pairs


class PositionRow(NamedTuple):
    """A given position of a point [m] in some frame, with sigmas [m], and its share: see `PositionPriors`.

    `time` [s] and the `velocity` [m/s] of the point are for the check of the clock.
    """

    point: Array
    position: Array
    sigma: Array
    share: float
    time: float = 0.0
    velocity: Array = np.zeros(3)


@dataclass(frozen=True, eq=False)
class PositionPriors:
    """Positions of points of submaps: `points` [m] in the frame of the submap `nodes`, `positions` and `sigmas` [m].

    `shares` are 1, or less for positions that follow each other faster than their errors change. `weights` are 0 until
    the submap is aligned with the reference, then the confidence 0..1. Positions are relative to `origin` [m]: a lever
    of thousands of kilometers would cost digits. `times` [s], and `velocities` [m/s] of the points in the frame of the
    submap, are for the check of the clock.
    """

    nodes: NDArray[np.int64] = field(default_factory=lambda: np.zeros(0, np.int64))
    points: Array = field(default_factory=lambda: np.zeros((0, 3)))
    positions: Array = field(default_factory=lambda: np.zeros((0, 3)))
    sigmas: Array = field(default_factory=lambda: np.zeros((0, 3)))
    shares: Array = field(default_factory=lambda: np.zeros(0))
    weights: Array = field(default_factory=lambda: np.zeros(0))
    origin: Array = field(default_factory=lambda: np.zeros(3))
    times: Array = field(default_factory=lambda: np.zeros(0))
    velocities: Array = field(default_factory=lambda: np.zeros((0, 3)))

    def __len__(self) -> int:
        return len(self.nodes)

    def with_rows(self, node: int, rows: Sequence[PositionRow]) -> PositionPriors:
        """With positions of a submap."""
        if not rows:
            return self
        points, positions, sigmas = (np.array([getattr(row, name) for row in rows]) for name in PositionRow._fields[:3])
        origin = self.origin if len(self) else positions[0]
        return PositionPriors(
            np.append(self.nodes, np.full(len(rows), node)), np.vstack([self.points, points]),
            np.vstack([self.positions, positions - origin]), np.vstack([self.sigmas, sigmas]),
            np.append(self.shares, [row.share for row in rows]), np.append(self.weights, np.zeros(len(rows))), origin,
            np.append(self.times, [row.time for row in rows]),
            np.vstack([self.velocities, [row.velocity for row in rows]]),
        )  # fmt: skip

    def at(self, rows: NDArray[np.bool_]) -> PositionPriors:
        columns = {name: values if name == "origin" else values[rows] for name, values in vars(self).items()}
        return PositionPriors(**columns)

    @property
    def is_aligned(self) -> NDArray[np.bool_]:
        return self.weights > 0

    def world_points(self, poses: Array) -> Array:
        T = poses[self.nodes]
        return matmul(T[:, :3, :3], self.points[:, :, None])[:, :, 0] + T[:, :3, 3]

    def squares(self, poses: Array, reference: Array) -> Array:
        """Squared error of each position in standard deviations, [p]. `reference`: T_world_reference."""
        R, t = reference[:3, :3], reference[:3, 3]
        errors = (matmul(self.world_points(poses) - t, R) - self.positions) / self.sigmas
        return (errors * errors).sum(axis=1)

    def first_width(self, squares: Array) -> float:
        """Width of the kernel at which most of the aligned positions count."""
        known = squares[self.is_aligned]
        return max(MAX_PRIOR_SQUARE, WIDTH_STEP * float(np.quantile(known, WIDTH_QUANTILE)) if len(known) else 0.0)

    def weighted(self, squares: Array, width: float) -> PositionPriors:
        return replace(self, weights=np.where(self.is_aligned, (width / (width + squares)) ** 2, 0.0))

    def measurements(self, poses: Array, reference: Array) -> tuple[Array, Array]:
        """Poses T_reference_submap of the aligned positions and their information [p, 6, 6], as edges of the graph.

        They constrain rotations only through the offset of the point, at the current orientations of the graph.
        """
        rows = self.at(self.is_aligned)
        R = matmul(reference[:3, :3].T, poses[rows.nodes][:, :3, :3])
        edges = np.tile(np.eye(4), (len(rows), 1, 1))
        edges[:, :3, :3] = R
        edges[:, :3, 3] = rows.positions - matmul(R, rows.points[:, :, None])[:, :, 0]
        precisions = (rows.weights * rows.shares)[:, None] / rows.sigmas**2
        precision = matmul(R.transpose(0, 2, 1) * precisions[:, None], R)
        J = np.concatenate([-skews(rows.points), np.tile(np.eye(3), (len(rows), 1, 1))], axis=2)
        information = matmul(J.transpose(0, 2, 1), precision, J)
        return edges, (information + information.transpose(0, 2, 1)) / 2


NO_PRIORS = PositionPriors()


def level_measurement(pose: Array, reference: Array) -> tuple[Array, Array]:
    """T_reference_submap with the present heading, and its information [6, 6]: both z axes point up."""
    R = matmul(reference[:3, :3].T, pose[:3, :3])
    return make_pose(heading_of(complex(R[0, 0], R[1, 0])), np.zeros(3)), np.diag([TILT_SIGMA**-2] * 2 + [0.0] * 4)


def heading_of(direction: complex) -> Array:
    """Rotation about z of the x axis to a direction x + iy."""
    c, s = direction.real / abs(direction), direction.imag / abs(direction)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


def alignment_cost(errors: Array) -> float:
    return float(np.minimum(errors, MAX_PRIOR_SQUARE).sum())


def path_cost(T: Array, points: Array, positions: Array, sigmas: Array) -> float:
    """Cost of an alignment of a path that drifts, as `align_path` minimizes it."""
    extent = float(np.ptp(points[:, :2], axis=0).max())
    return alignment_cost(_squares(T, points, positions, np.sqrt(sigmas**2 + (ALIGNED_DRIFT * extent) ** 2)))


def align_path(points: Array, positions: Array, sigmas: Array) -> Array | None:
    """Heading and shift T_reference_world of points [n, 3] with most of the given positions. None if undetermined."""
    step = max(1, len(points) // ROW_COUNT)
    p, q = points[::step], positions[::step]
    if len(p) < MIN_ALIGNED:
        return None
    i, j = np.random.Generator(np.random.PCG64(0)).integers(0, len(p), (PAIR_COUNT, 2)).T
    along, given = _horizontal(p[j] - p[i]), _horizontal(q[j] - q[i])
    extent = float(np.abs(along).max())
    sigma = np.sqrt(sigmas[::step] ** 2 + (ALIGNED_DRIFT * extent) ** 2)
    turns = np.conj(along) * given
    best, cost = np.eye(4), math.inf
    for k in np.flatnonzero(np.abs(turns) > 0):
        T = _about(heading_of(complex(turns[k])), p[[i[k], j[k]]], q[[i[k], j[k]]])
        value = alignment_cost(_squares(T, p, q, sigma))
        best, cost = (T, value) if value < cost else (best, cost)
    for _ in range(FINAL_STEPS):
        agrees = _squares(best, p, q, sigma) <= MAX_PRIOR_SQUARE
        if agrees.sum() < max(MIN_ALIGNED, MIN_ALIGNED_FRACTION * len(p)):
            return None
        a, b = (_horizontal(rows[agrees] - rows[agrees].mean(axis=0)) for rows in (p, q))
        turn = complex((np.conj(a) * b).sum())
        if 2 * np.abs(a).max() < MIN_EXTENT_SIGMAS * np.median(sigmas[::step][agrees][:, :2]) or not turn:
            return None
        best = _about(heading_of(turn), p[agrees], q[agrees])
    return best


def _horizontal(vectors: Array) -> NDArray[np.complex128]:
    return vectors[:, 0] + 1j * vectors[:, 1]


def _about(R: Array, points: Array, positions: Array) -> Array:
    return make_pose(R, positions.mean(axis=0) - matmul(R, points.mean(axis=0)))


def _squares(T: Array, points: Array, positions: Array, sigma: Array) -> Array:
    errors = (matmul(points, T[:3, :3].T) + T[:3, 3] - positions) / sigma
    return (errors * errors).sum(axis=1)
