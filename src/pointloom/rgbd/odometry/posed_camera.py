"""Fit of a depth camera to frames with given poses, and the errors of the poses: `fit_posed_camera`.

A wrong camera, depth unit or pose moves the surfaces of frames apart. Residuals are those of `camera_fit`, linear about
one matching of the points.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import inv, matmul
from ...registration.rigid import invert_pose
from .camera_fit import (
    COMMON_PIXELS,
    FIRST_GATE,
    FIXED_DEVIATION,
    GATE_FACTOR,
    GAUSS_NEWTON_STEPS,
    LAST_GATE,
    MAX_LAST_CHANGE,
    MAX_STEP,
    MIN_PAIRS,
    POSED_PLANE_RADIUS,
    PRIOR_DEVIATIONS,
    CameraView,
    Matches,
    ViewPairs,
    derivatives,
    pose_inverse,
    products_of_pairs,
    robust_weights,
    scatter,
    solve_pairs,
    spread_pairs,
    sums_of_pairs,
    widening,
)

Floats = NDArray[np.float64]

# Deviations before the fit of a camera to given poses.
POSED_PRIOR = np.array([0.3, 0.15, 0.15, 0.2, 0.1, 0.3])
MAX_POSED_PAIRS, MAX_POSED_DISTANCE, POSED_CELL_STEP = 48, 2.0, 4  # pairs, [m] between cameras, every n-th cell
# Errors of correct recordings that all frames have in common: drift of the poses over the recording [m, rad], and depth
# that is off by DEPTH_BIAS z^2 [1/m] in patterns of low order over the image. Both are added to the scatter of frames.
# Poses of KinectFusion and the depth of a Kinect: without them, 75 frames of a kitchen have fitted values of up to 50
# deviations, with them of up to 3 (chosen on frames 0-299, nothing of it is held out, 2026-11-30).
DRIFT, ROTATION_DRIFT = 0.005, 0.0025
MEDIAN_SQUARE = 0.6  # median of a squared deviation in one to three directions, by its variance
# Noise of positions [m] that the scatter covers: a kitchen has up to 0.0045. More noise also biases the fit: it hides
# in the depth of motions that the frames hardly contain: bias and scatter are below NOISE_FACTOR times the excess
# (chosen on sites of seed 301, verified on seeds 302 and 303, 2026-11-30).
USUAL_NOISE, NOISE_FACTOR = 0.004, 4.0
# Log fx and log fy, principal point, radial distortion and log depth, by the parameters of the fit.
TO_FOCAL_LENGTHS = np.eye(6)[[0, 0, 1, 2, 3, 5]]
TO_FOCAL_LENGTHS[:2, 4] = 0.5, -0.5
# Its inverse by rows, and single errors: focal length, fx, fy, principal point (u, v), distortion, depth.
FROM_FOCAL_LENGTHS = np.eye(6)[[0, 0, 1, 2, 3, 5]]
FROM_FOCAL_LENGTHS[:2, [0, 4]] = [[0.5, 1.0], [0.5, -1.0]]
SINGLE_ERRORS = np.vstack([np.eye(6)[0], FROM_FOCAL_LENGTHS])
# Corrections with given poses are reported beyond POSED_SIGMAS deviations, if they move the surface by more than
# MIN_DISPLACEMENT (root mean square [m], three quarters of a default voxel).
POSED_SIGMAS, MIN_DISPLACEMENT = 2.5, 0.015
# Change of a step after which the gate is the last one. Points are matched again for values above CONSIDERABLE of these
# limits that have changed by MAX_UNMATCHED since.
SMALL_CHANGE, CONSIDERABLE, MAX_MATCHINGS, MAX_UNMATCHED = 0.02, 0.8, 4, 0.002
MAX_NEAR_LIMIT = 0.15  # of the pairs, displaced by half the limit: more are aligned again


class PosedCameraFit(NamedTuple):
    """Corrections of a camera with given poses: log fx, log fy, principal point (u, v) in focal lengths, radial
    distortion of rays, and log depth.

    `values` and `displacements` are float64 [6], `covariance` is float64 [6, 6]. A correction of 1 moves the surface by
    the displacement [m], the root mean square along the normals. `residual` and `fitted_residual`: as in CameraFit.
    """

    values: Floats
    covariance: Floats
    displacements: Floats
    residual: float
    fitted_residual: float
    pair_count: int

    @property
    def deviations(self) -> Floats:
        return np.sqrt(np.diag(self.covariance))

    def limits(self) -> Floats:
        """Smallest reported values, float64 [6]."""
        return np.maximum(POSED_SIGMAS * self.deviations, MIN_DISPLACEMENT / np.maximum(self.displacements, 1e-9))

    @property
    def is_considerable(self) -> bool:
        """Whether a value is reported, or may be if points are matched with it."""
        return bool((np.abs(self.values) > CONSIDERABLE * self.limits()).any())


def _posed_pairs(poses: Sequence[Floats] | Floats) -> list[tuple[int, int]]:
    return spread_pairs(poses, 0.0, MAX_POSED_DISTANCE, len(poses), MAX_POSED_PAIRS)


def posed_pairs(views: Sequence[CameraView], poses: Sequence[Floats] | Floats) -> ViewPairs:
    """Pairs of views with known poses T_world_camera."""
    return ViewPairs(views, poses, _posed_pairs(poses), POSED_CELL_STEP, POSED_PLANE_RADIUS)


def fit_posed_camera(
    views: Sequence[CameraView], poses: Sequence[Floats] | Floats, pairs: ViewPairs | None = None
) -> list[PosedCameraFit]:
    """Fit the camera and the depth to views with known poses T_world_camera. `pairs`: those of the views.

    The first fit is that of all parameters, the others are those of one error alone (SINGLE_ERRORS), which are more
    precise. Empty if too few points agree. The poses are not corrected: free poses hide errors of the camera, and
    biased depth then looks like another camera. The deviations contain the scatter over frames (jackknife) and the
    effect of drift and biased depth. Points are matched again only for errors that may be reported.
    """
    pairs, size = posed_pairs(views, poses) if pairs is None else pairs, len(POSED_PRIOR)
    if not pairs.pairs:
        return []
    start, everything = _PosedRows(pairs, np.array(poses), np.zeros(size)), np.eye(size)
    given = start.equations(start.by_camera, np.zeros(size), LAST_GATE)
    given = start.equations(start.by_camera, np.zeros(size), FIRST_GATE) if given is None else given
    if given is None or (complete := start.fit(everything, given.residual)) is None:
        return []
    singles = [start.fit(basis, given.residual) for basis in SINGLE_ERRORS[..., None]]
    return [complete, *(fit for fit in singles if fit is not None)]


def displacements_of_poses(pairs: ViewPairs, limit: float) -> Floats:
    """Displacement of the surface [m] by the error of the poses of each pair that can be aligned.

    It is the root mean square along the normals. Points are matched again only if a considerable fraction is near the
    `limit`.
    """
    if not pairs.pairs:
        return np.empty(0)
    found = _linear_displacements(pairs.given)
    if len(found) >= MIN_PAIRS and (found > 0.5 * limit).mean() < MAX_NEAR_LIMIT:
        return found
    aligned = solve_pairs(pairs, pairs.poses, np.full(len(PRIOR_DEVIATIONS), FIXED_DEVIATION))
    if aligned is None:
        return np.empty(0)
    rows, used = aligned.sums.rows, aligned.sums.used
    counts, p, n = rows.counts[used], rows.points, rows.first_planes[0]
    change = np.array([matmul(a, invert_pose(b)) for a, b in zip(pairs.poses[used], aligned.poses[used], strict=True)])
    T = np.repeat((change - np.eye(4))[:, :3].reshape(-1, 12).T, counts, axis=1)
    moved = [row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + row[3] for row in (T[:4], T[4:8], T[8:])]
    return _rms_of_pairs(moved[0] * n[0] + moved[1] * n[1] + moved[2] * n[2], counts)


def _linear_displacements(rows: Matches) -> Floats:
    """The displacements by small motions, without new matches."""
    counts = rows.counts[rows.counts > 0]
    if not len(counts):
        return np.empty(0)
    J, expected = rows.jacobian(rows.first_planes, np.zeros(len(PRIOR_DEVIATIONS)))[:6], rows.expected()
    moved, gate = np.zeros(len(expected)), FIRST_GATE
    while True:
        r = rows.residuals + moved
        weights = robust_weights(r, expected) * (np.abs(r) < gate)
        right = np.vstack([J, r])
        sums = sums_of_pairs(right * weights, right, counts)
        twists = -matmul(pose_inverse(sums), sums[:, :6, 6:])[..., 0]
        moved = moved + (J * np.repeat(twists.T, counts, axis=1)).sum(axis=0)
        if gate == LAST_GATE:
            return _rms_of_pairs(moved, counts)
        gate = max(GATE_FACTOR * gate, LAST_GATE)


def _rms_of_pairs(values: Floats, counts: NDArray[np.int64]) -> Floats:
    return np.sqrt(np.add.reduceat(values**2, np.cumsum(counts) - counts) / counts)


class _PosedEquations(NamedTuple):
    """Normal equations of each pair by the factors of a basis, in units of the noise, at residuals with weights."""

    systems: Floats
    gradients: Floats
    is_used: NDArray[np.bool_]  # of the pairs of the rows
    residual: float
    noise: float
    residuals: Floats
    weights: Floats


class _PosedRows:
    """Points of pairs with known poses, matched with the camera `values`, and their linear residuals about it."""

    def __init__(self, pairs: ViewPairs, poses: Floats, values: Floats) -> None:
        self.values, self._all, self._poses = values, pairs, poses
        self._rows = rows = pairs.matches(pairs.poses, values, FIRST_GATE) if values.any() else pairs.given
        is_matched = rows.counts > 0
        self._pairs, self._counts = np.array(pairs.pairs)[is_matched], rows.counts[is_matched]
        self._starts = np.cumsum(self._counts) - self._counts
        self._expected = rows.expected()
        self.by_motion, self.by_camera = np.split(rows.jacobian(rows.first_planes, values)[:-1], [6])

    def equations(self, J: Floats, factors: Floats, gate: float) -> _PosedEquations | None:
        """At `values` and `factors` with derivatives `J` of the residuals. None if too few pairs or points agree."""
        if len(self._counts) < MIN_PAIRS:
            return None
        r = self._rows.residuals + (factors[:, None] * J).sum(axis=0)
        is_inside = np.abs(r) < gate
        counts = np.add.reduceat(is_inside, self._starts, dtype=np.int64)
        is_used = counts >= self._all.min_pair_points
        count = int(counts[is_used].sum())
        if count < self._all.min_points or is_used.sum() < MIN_PAIRS:
            return None
        weights = robust_weights(r, self._expected) * (is_inside & np.repeat(is_used, self._counts))
        rows = np.vstack([J, r])
        sums = sums_of_pairs(rows * weights, rows, self._counts)[is_used]
        cost = float(sums[:, -1, -1].sum())
        noise = COMMON_PIXELS * cost / count + 1e-12
        residual = math.sqrt(cost / float(weights.sum()))
        return _PosedEquations(
            sums[:, :-1, :-1] / noise, sums[:, :-1, -1] / noise, is_used, residual, noise, r, weights
        )

    def fit(self, basis: Floats, residual: float) -> PosedCameraFit | None:
        """The fit along the columns of `basis`. `residual`: that of the given camera. None if too few points agree."""
        at, matchings = self, 0
        while True:
            J = matmul(basis.T, at.by_camera)
            factors = at._solution(basis, J)
            found = None if factors is None else at.equations(J, factors, LAST_GATE)
            if factors is None or found is None:
                return None
            fit, change = at._fit_of(basis, J, factors, found, residual), matmul(basis, factors)
            matchings += 1
            if matchings == MAX_MATCHINGS or not fit.is_considerable or np.abs(change).max() < MAX_UNMATCHED:
                return fit
            at = _PosedRows(self._all, self._poses, at.values + change)

    def _solution(self, basis: Floats, J: Floats) -> Floats | None:
        """Gauss-Newton over the factors of the columns of `basis`."""
        prior, factors, gate = 1.0 / POSED_PRIOR**2, np.zeros(basis.shape[1]), FIRST_GATE
        pull = matmul(basis.T, np.diag(prior), basis)
        for _ in range(GAUSS_NEWTON_STEPS):
            found = self.equations(J, factors, gate)
            if found is None:
                return None
            gradient = found.gradients.sum(0) + matmul(basis.T, prior * self.values) + matmul(pull, factors)
            change = np.clip(-matmul(inv(found.systems.sum(0) + pull), gradient), -MAX_STEP, MAX_STEP)
            factors, largest = factors + change, np.abs(change).max()
            if gate == LAST_GATE and largest < MAX_LAST_CHANGE:
                break
            gate = LAST_GATE if largest < SMALL_CHANGE else max(GATE_FACTOR * gate, LAST_GATE)
        return factors

    def _fit_of(
        self, basis: Floats, J: Floats, factors: Floats, found: _PosedEquations, residual: float
    ) -> PosedCameraFit:
        values, to_values = self.values + matmul(basis, factors), matmul(TO_FOCAL_LENGTHS, basis)
        covariance = matmul(to_values, self._covariance(basis, J, values, found), to_values.T)
        values, pair_count = matmul(TO_FOCAL_LENGTHS, values), int(found.is_used.sum())
        return PosedCameraFit(values, covariance, self._displacements, residual, found.residual, pair_count)

    @cached_property
    def _displacements(self) -> Floats:
        rows = self._rows
        moved = matmul(FROM_FOCAL_LENGTHS, derivatives(rows.at_first, rows.first_planes[0], self.values))
        return np.sqrt((moved**2).mean(axis=1))

    def _covariance(self, basis: Floats, J: Floats, values: Floats, found: _PosedEquations) -> Floats:
        prior = np.diag(1.0 / POSED_PRIOR**2)
        pull, weighted = matmul(basis.T, prior, basis), J * (found.weights / found.noise)
        counted = found.systems.sum(0) + pull
        moved = matmul(self._common_errors(weighted, found), inv(counted))
        at_values = matmul(basis.T, prior, values)
        errors = scatter(self._pairs[found.is_used], found.systems, found.gradients, at_values, pull)
        # Products of derivatives at planes of both views contain no noise of normals.
        known = (weighted[:, None] * matmul(basis.T, self._by_camera_at_second)).sum(axis=2)
        factor = widening(counted, 0.5 * (known + known.T) + pull)
        return matmul(factor, errors + matmul(moved.T, moved), factor.T)

    @cached_property
    def _by_camera_at_second(self) -> Floats:
        return self._rows.jacobian(self._rows.second_planes, self.values)[6:-1]

    @cached_property
    def _biased(self) -> Floats:
        return self._rows.biased()

    @cached_property
    def _twists(self) -> list[tuple[Floats, float, float]]:
        """Motions of pairs by rotations and translations along the axes, their drift, and whether they are noisy."""
        poses, (first, second), twists = self._poses, self._pairs.T, []
        to_first = poses[first, :3, :3].transpose(0, 2, 1)
        offset = matmul(to_first, (poses[second, :3, 3] - poses[first, :3, 3])[..., None])[..., 0]
        for axis in range(3):
            direction = to_first[..., axis]
            twists.append((np.hstack([direction, -np.cross(direction, offset)]), ROTATION_DRIFT, 0.0))
            twists.append((np.hstack([0.0 * direction, direction]), DRIFT, 1.0))
        return twists

    def _common_errors(self, weighted: Floats, found: _PosedEquations) -> Floats:
        """Right sides of drift, along each axis of the world and linear or bent over time, and of biased depth."""
        count, (first, second) = len(self._poses), self._pairs.T
        time = np.arange(count) / max(count - 1, 1)
        drift = np.stack([time, 4.0 * time * (1.0 - time)])
        effects = [(self._biased[:, None] * weighted).sum(axis=2)]
        mixed = products_of_pairs(self.by_motion, weighted, self._counts)
        noise = NOISE_FACTOR * max(self._pose_noise(found) - USUAL_NOISE, 0.0)
        for twist, drifted, is_noisy in self._twists:
            effect = (mixed * twist[..., None]).sum(axis=1)
            shapes = drifted * drift
            if noise and is_noisy:
                shapes = np.vstack([shapes, noise * np.eye(count)])
            effects.append(matmul(shapes[:, second] - shapes[:, first], effect))
        return np.vstack(effects)

    def _pose_noise(self, found: _PosedEquations) -> float:
        """Deviation of the positions [m], by axis, from the displacements that pairs would fit better with."""
        planes = np.vstack([self._rows.first_planes[0], found.residuals])
        sums = sums_of_pairs(planes * (found.weights > 0), planes, self._counts)[found.is_used]
        squares = (sums[:, :3, 3] ** 2).sum(axis=1) / (sums[:, :3, :3] ** 2).sum(axis=(1, 2))
        return math.sqrt(float(np.median(squares)) / MEDIAN_SQUARE / 2.0)  # two poses of a pair
