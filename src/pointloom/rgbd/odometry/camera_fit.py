"""Fit of a depth camera to its frames: focal lengths, principal point, distortion and depth by self-calibration.

A wrong camera deforms the points of a frame, so frames that are rotated against each other do not fit rigidly. The
common parameters and the pose of each pair are estimated together by point-to-plane residuals (Gauss-Newton). Planes
are fitted to inverse depth, which is linear in the image of a plane. Images that are mirrored alike fit any camera. A
uniform factor of the depth fits, too, but not the translations of given poses.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import eigh, inv, matmul, solve
from ...registration.rigid import invert_pose, rotations_of

Floats = NDArray[np.float64]

MIN_ROTATION, MAX_ROTATION = math.radians(10.0), math.radians(45.0)  # of a pair
MAX_DISTANCE = 1.0  # [m] between the cameras of a pair
MAX_PAIRS, MIN_PAIRS = 60, 3
MAX_POSES = 2000  # poses among which pairs are chosen
MAX_FACTOR_PAIRS = 24  # of the factor of the depth
MIN_PAIR_POINTS, MIN_POINTS = 60, 300  # of a pair, of all, at every second cell of every second row
# [cells] of the fitted planes, with free and with given poses. Planes of 5 x 5 cells smooth rough ground and hide small
# surfaces: a forest then has a focal length 0.10 too short (log), 0.03 with 3 x 3 cells. The last 150 frames of a
# kitchen have 0.07 and 0.04. Given poses need the larger planes: with the smaller ones, 14 instead of 11 of 60 wrong
# cameras of the kitchen are accepted (chosen on the kitchen and on sites of seeds 500 and 501, 2026-11-30).
PLANE_RADIUS, POSED_PLANE_RADIUS = 1, 2
PLANE_NOISE = 0.004  # [m] at 0 m, and [1/m] times squared depth: maximum root mean square residual of a plane
MIN_COSINE = 0.15  # of the incidence angle
# [m], [1/m]: the expected residual is DEPTH_NOISE + DEPTH_NOISE_GROWTH z^2
DEPTH_NOISE, DEPTH_NOISE_GROWTH = 0.003, 0.004
# Smallest factor of the depth that is reported, and standard deviations beyond it. True poses of ten parts of a kitchen
# have 0.97 to 1.07. None of 210 walks with 0 to 50 mm of pose noise is reported (2026-11-29).
MIN_DEPTH_FACTOR, DEPTH_SIGMAS = 1.1, 2.0
MAX_GAP = 2  # largest difference of the indices of near pairs
GAUSS_NEWTON_STEPS, MAX_STEP = 10, 0.15  # Gauss-Newton steps, and largest change of a parameter
# [rad], [m], focal lengths: change of the camera and of the median pair in the last step. A hundredth of the smallest
# correction that is reported.
MAX_LAST_CHANGE = 5e-4
FIRST_GATE, GATE_FACTOR, LAST_GATE = 0.25, 0.6, 0.05  # [m] maximum residual: first, factor of each step, minimum
MIN_NORMAL_COSINE = 0.7
OUTLIER_RATIO = 3.0  # in expected residuals, of the Geman-McClure weights
COMMON_PIXELS = 25.0  # cells of a window, whose planes have common errors
# Largest deviation of a determined parameter, relative to PRIOR_DEVIATIONS: the frames then have more information.
MAX_DEVIATION_RATIO = 0.5
FIXED_DEVIATION = 1e-9  # deviation of a parameter that is not estimated
# Standard deviations of the parameters before the fit: log focal length, principal point by the focal length (u, v),
# radial distortion, log fx / fy and log depth. They keep undetermined parameters near 0. Pairs of free poses determine
# no factor of the depth, and fx / fy only together with the rotations.
PRIOR_DEVIATIONS = np.array([0.3, 0.15, 0.15, 0.3, FIXED_DEVIATION, FIXED_DEVIATION])
MIN_INFORMATION_RATIO = 0.02  # of information without the noise of normals to that with it: less is none
BIAS_RAY = 0.5  # ray x, y at which a pattern has its value
# Depth of correct recordings is off by up to DEPTH_BIAS z^2 [1/m], in patterns of low order over the image.
DEPTH_BIAS = 0.0012


class CameraView(NamedTuple):
    """Mean inverse depth [1/m] of the cells of a frame, float32 [rows, columns], 0 if sparse; fx, fy, cx, cy."""

    nearness: NDArray[np.float32]
    lens: tuple[float, float, float, float]


class CameraFit(NamedTuple):
    """Corrections of a camera: log focal length, principal point (u, v) in focal lengths, radial distortion of rays,
    log fx / fy, and log depth.

    `values` and `deviations` are float64 [6], 0 and infinite where undetermined. `residual` and `fitted_residual`: the
    weighted root mean square residual [m] of the given and the fitted camera. `poses`: T_first_second of the `pairs`.
    """

    values: Floats
    deviations: Floats
    residual: float
    fitted_residual: float
    pairs: list[tuple[int, int]]
    poses: Floats


def rotated_pairs(poses: Sequence[Floats] | Floats) -> list[tuple[int, int]]:
    """Index pairs of poses that are rotated against each other and near, spread over the path."""
    return spread_pairs(poses, MIN_ROTATION, MAX_DISTANCE, len(poses))


def spread_pairs(
    poses: Sequence[Floats] | Floats, min_rotation: float, max_distance: float, max_gap: int, max_pairs: int = MAX_PAIRS
) -> list[tuple[int, int]]:
    T = np.array(poses, np.float64).reshape(-1, 4, 4)
    sampled = np.linspace(0, len(T) - 1, min(len(T), MAX_POSES)).astype(int)
    T, found = T[sampled], [np.empty((0, 2), int)]
    for first in range(len(T)):
        others = T[first + 1 : first + max_gap + 1]
        cosine = ((others[:, :3, :3] * T[first, :3, :3]).sum(axis=(1, 2)) - 1.0) / 2.0
        distance = np.sqrt(((others[:, :3, 3] - T[first, :3, 3]) ** 2).sum(axis=1))
        angle = np.arccos(np.clip(cosine, -1.0, 1.0))
        near = np.flatnonzero((angle >= min_rotation) & (angle < MAX_ROTATION) & (distance < max_distance))
        found.append(np.column_stack([np.full(len(near), first), first + 1 + near]))
    pairs = sampled[np.concatenate(found)]
    chosen = np.unique(np.linspace(0, len(pairs) - 1, min(len(pairs), max_pairs)).astype(int)) if len(pairs) else []
    return [(first, second) for first, second in pairs[chosen].tolist()]


class ViewPairs:
    """Pairs of views at poses T_world_camera: the points on planes of all pairs.

    Attributes:
        pairs: Indices of the compared views.
        poses: T_first_second of the pairs at the given poses, float64 [pairs, 4, 4].

    Each `cell_step`-th cell of each `cell_step`-th row of the second views is used. Planes have `radius` [cells].
    """

    def __init__(
        self,
        views: Sequence[CameraView],
        poses: Sequence[Floats] | Floats,
        pairs: list[tuple[int, int]],
        cell_step: int = 2,
        radius: int = PLANE_RADIUS,
    ) -> None:
        self.pairs = pairs
        motions = [matmul(invert_pose(poses[first]), poses[second]) for first, second in self.pairs]
        self.poses = np.array(motions).reshape(-1, 4, 4)
        if not self.pairs:
            return
        surfaces = {
            index: _surface_of(views[index], radius) for index in sorted({i for pair in self.pairs for i in pair})
        }
        starts = dict(
            zip(surfaces, np.cumsum([0] + [s.is_plane.size for s in surfaces.values()]).tolist(), strict=False)
        )
        sampled = {k: starts[k] + np.flatnonzero(s.is_plane & s.is_sampled(cell_step)) for k, s in surfaces.items()}
        self._cells = np.concatenate([s.cells for s in surfaces.values()], axis=1)
        self._is_plane = np.concatenate([s.is_plane.ravel() for s in surfaces.values()])
        self._counts = np.array([len(sampled[second]) for _, second in self.pairs])
        self._second = self._cells[:, np.concatenate([sampled[second] for _, second in self.pairs])]
        first = [(starts[k], *surfaces[k].is_plane.shape, *views[k].lens) for k, _ in self.pairs]
        self._first = np.repeat(np.array(first, np.float64).T, self._counts, axis=1)
        self._pair = np.repeat(np.arange(len(self.pairs)), self._counts)
        self.min_pair_points, self.min_points = (4 * count // cell_step**2 for count in (MIN_PAIR_POINTS, MIN_POINTS))

    @cached_property
    def given(self) -> Matches:
        """Matches at the given poses and camera."""
        return self.matches(self.poses, np.zeros(len(PRIOR_DEVIATIONS)), FIRST_GATE)

    def matches(self, poses: Floats, values: Floats, gate: float) -> Matches:
        """Points of second views that agree with the first ones, of pairs with enough of them."""
        z, x, y = self._second[0] * math.exp(values[5]), *_rays(self._second[4], self._second[5], values)
        T = np.repeat(poses[:, :3].reshape(-1, 12).T, self._counts, axis=1)
        points = np.stack([(row[0] * x + row[1] * y + row[2]) * z + row[3] for row in (T[:4], T[4:8], T[8:])])
        depth = np.maximum(points[2], 1e-6)
        u, v = points[0] / depth, points[1] / depth
        factor = 1.0 / (1.0 + values[3] * np.minimum(u * u + v * v, 1.0))
        x_scale, y_scale = _scales(values)
        start, rows, columns, fx, fy, cx, cy = self._first
        column = np.rint((u * factor * x_scale + values[1]) * fx + cx)
        row = np.rint((v * factor * y_scale + values[2]) * fy + cy)
        is_inside = (column >= 0) & (column < columns) & (row >= 0) & (row < rows) & (points[2] > 0)
        seen = np.flatnonzero(is_inside)
        at = (start[seen] + row[seen] * columns[seen] + column[seen]).astype(int)
        is_plane = self._is_plane[at]
        seen, at = seen[is_plane], at[is_plane]
        first, p, T = self._cells[:, at], points[:, seen], T[:, seen]
        n, m = _corrected_normals(first, values), _corrected_normals(self._second[:, seen], values)
        z_first, x_first, y_first = first[0] * math.exp(values[5]), *_rays(first[4], first[5], values)
        r = (p[0] - x_first * z_first) * n[0] + (p[1] - y_first * z_first) * n[1] + (p[2] - z_first) * n[2]
        back = np.stack([T[k] * n[0] + T[4 + k] * n[1] + T[8 + k] * n[2] for k in range(3)])
        forth = np.stack([T[k] * m[0] + T[k + 1] * m[1] + T[k + 2] * m[2] for k in (0, 4, 8)])
        agrees = (np.abs(r) < gate) & (back[0] * m[0] + back[1] * m[1] + back[2] * m[2] > MIN_NORMAL_COSINE)
        counts = np.bincount(self._pair[seen[agrees]], minlength=len(self.pairs))
        is_enough = counts >= self.min_pair_points
        keep = np.flatnonzero(agrees & is_enough[self._pair[seen]])
        at_second = np.stack([x[seen], y[seen], z[seen]])[:, keep]
        at_first = np.stack([x_first, y_first, z_first])[:, keep]
        first_planes, second_planes = np.stack([n, back])[..., keep], np.stack([forth, m])[..., keep]
        counts = np.where(is_enough, counts, 0)
        return Matches(r[keep], p[:, keep], first_planes, second_planes, at_first, at_second, counts)


def fit_camera(views: ViewPairs) -> CameraFit | None:
    """Fit the camera to pairs of views with approximate poses. None if too few agree."""
    given = solve_pairs(views, views.poses, np.full(len(PRIOR_DEVIATIONS), FIXED_DEVIATION)) if views.pairs else None
    if given is None:
        return None
    found = solve_pairs(views, given.poses, PRIOR_DEVIATIONS)
    if found is None:
        return None
    deviations = _deviations(found, np.array(views.pairs)[found.sums.used])
    values = np.where(np.isfinite(deviations), found.values, 0.0)
    return CameraFit(values, deviations, given.residual, found.residual, views.pairs, found.poses)


def _bias_patterns(cells: Floats, n: Floats) -> Floats:
    """Displacements along normals [6, points] by errors of inverse depth: constant, linear and quadratic ones."""
    x, y = cells[:2] / BIAS_RAY
    along = (n[0] * cells[0] + n[1] * cells[1] + n[2]) * cells[2] ** 2
    return along * np.stack([np.ones_like(x), x, y, x * x, x * y, y * y])


def widening(counted: Floats, known: Floats) -> Floats:
    """Factor of errors where noise of the normals counts as information, at most 1 / MIN_INFORMATION_RATIO."""
    information, axes = eigh(counted)
    white = axes / np.sqrt(information)
    ratios, inner = eigh(matmul(matmul(white.T, known), white))
    inner = matmul(white, inner)
    return matmul(matmul(inner / np.maximum(ratios, MIN_INFORMATION_RATIO), inner.T), counted)


def scatter(
    pairs: NDArray[np.int64], systems: Floats, gradients: Floats, prior_gradient: Floats, prior: Floats
) -> Floats:
    """Covariance from the solutions without any one of the views (jackknife). `prior`: its information."""
    views = np.unique(pairs)
    kept = np.array([(pairs != view).all(axis=1) for view in views], np.float64)
    remaining = matmul(kept, systems.reshape(len(pairs), -1)).reshape(-1, *systems.shape[1:])
    changes = -matmul(inv(remaining + prior), (matmul(kept, gradients) + prior_gradient)[..., None])[..., 0]
    changes -= changes.mean(axis=0)
    return (len(views) - 1) / len(views) * matmul(changes.T, changes)


def depth_factor(views: Sequence[CameraView], poses: Sequence[Floats] | Floats) -> float:
    """The factor of the depth that fits poses T_world_camera better, else 1.

    The translations between views are estimated from their depth alone. A regression of the given ones on them has a
    slope that is too small by their noise, the inverse slope of the other regression is too large by noise of the given
    ones. The factor is between both. It is 1 unless both differ from 1 by MIN_DEPTH_FACTOR and DEPTH_SIGMAS deviations,
    also without any one view.
    """
    is_complete = True
    for gap, is_zero in ((len(poses), False), (MAX_GAP, False), (MAX_GAP, True)):
        if is_zero and is_complete:  # no pair was moved apart by a translation that is too long
            break
        # Long translations are precise. Short ones are not confused with those to the next step of a staircase.
        chosen = spread_pairs(poses, 0.0, math.inf, gap, MAX_FACTOR_PAIRS)
        pairs = ViewPairs(views, poses, chosen, radius=POSED_PLANE_RADIUS)
        start = pairs.poses.copy()
        start[:, :3, 3] *= not is_zero
        found = solve_pairs(pairs, start, np.full(len(PRIOR_DEVIATIONS), FIXED_DEVIATION)) if pairs.pairs else None
        is_complete &= found is not None and bool(found.sums.used.all())
        if found is None:
            continue
        if (factor := _factor_between(pairs, found, len(poses))) != 1.0:
            return factor
    return 1.0


def _factor_between(pairs: ViewPairs, found: _Solution, view_count: int) -> float:
    """The factor from all pairs, if those without any one of the views agree: one wrong pose is no unit."""
    used, information = np.flatnonzero(found.sums.used), inv(found.sums.inverse[:, 3:, 3:])
    a, b = pairs.poses[used, :3, 3, None], found.poses[used, :3, 3, None]
    weighted_a, weighted_b = matmul(information, a), matmul(information, b)
    views = np.array(pairs.pairs)[used]
    kept = np.vstack([np.ones(len(used)), [(views != view).all(axis=1) for view in range(view_count)]])
    aa, ab, bb = (
        (kept * (x * y).sum(axis=(1, 2))).sum(axis=1) for x, y in ((a, weighted_a), (a, weighted_b), (b, weighted_b))
    )
    if (ab <= 0.0).any():
        return 1.0
    low, high = ab / bb, aa / ab
    deviation = np.sqrt(_noise(found.sums) / bb + np.maximum(high / low - 1.0, 0.0) / (3 * view_count))
    margin = math.log(MIN_DEPTH_FACTOR) + DEPTH_SIGMAS * deviation
    is_reported = (np.log(low) > margin).all() or (np.log(high) < -margin).all()
    return math.sqrt(low[0] * high[0]) if is_reported else 1.0


class Matches(NamedTuple):
    """Residuals [m] and points of second views in the first ones, coordinates first, in the order of the pairs.

    `first_planes`, `second_planes`: normals of the planes of the first and of the second view, seen from the first and
    from the second one, (2, 3, n). `at_first`, `at_second`: rays (x, y) and depth in the views.
    """

    residuals: Floats
    points: Floats
    first_planes: Floats
    second_planes: Floats
    at_first: Floats
    at_second: Floats
    counts: NDArray[np.int64]  # of each pair

    def expected(self) -> Floats:
        """Expected residuals [m]. The noise is that of depth: it does not depend on how much the rays are stretched."""
        (x, y, z), n = self.at_first, self.first_planes[0]
        along = np.maximum(np.abs(n[0] * x + n[1] * y + n[2]), MIN_COSINE)
        return (DEPTH_NOISE + DEPTH_NOISE_GROWTH * z**2) * along

    def weights(self) -> Floats:
        return robust_weights(self.residuals, self.expected())

    def jacobian(self, planes: Floats, values: Floats) -> Floats:
        """Derivatives of the residuals by the motion and the camera, and the residuals, (13, n).

        The rays at the planes are those of the moved points: their noise is nearly the same in all derivatives. The
        depth of the planes themselves would make the fitted focal length too long.
        """
        p, (n, back) = self.points, planes
        turned = (p[1] * n[2] - p[2] * n[1], p[2] * n[0] - p[0] * n[2], p[0] * n[1] - p[1] * n[0])
        there = np.stack([p[0] / p[2], p[1] / p[2], p[2]])
        of_camera = derivatives(self.at_second, back, values) - derivatives(there, n, values)
        return np.stack([*turned, *n, *of_camera, self.residuals])

    def biased(self) -> Floats:
        """Residuals by errors of inverse depth, float64 [6, points]: constant, linear and quadratic ones."""
        return DEPTH_BIAS * (
            _bias_patterns(self.at_second, self.first_planes[1]) - _bias_patterns(self.at_first, self.first_planes[0])
        )


def robust_weights(residuals: Floats, expected: Floats) -> Floats:
    return 1.0 / ((1.0 + (residuals / expected / OUTLIER_RATIO) ** 2) ** 2 * expected**2)


class _Solution(NamedTuple):
    values: Floats
    residual: float
    poses: Floats
    sums: _Normal


class _Normal(NamedTuple):
    """Normal equations of the camera without the poses, and of the poses of the `used` pairs: `inverse` of their
    matrices, the products `mixed` with the camera (6, 6), and the gradients. The sums of squares.
    """

    system: Floats
    right: Floats
    inverse: Floats
    mixed: Floats
    gradients: Floats
    used: NDArray[np.bool_]
    cost: float
    weights: float
    point_count: int
    rows: Matches


def solve_pairs(views: ViewPairs, starts: Floats, prior: Floats) -> _Solution | None:
    """Gauss-Newton over the camera, with standard deviations `prior`, and the poses of all pairs."""
    values, moved = np.zeros(len(PRIOR_DEVIATIONS)), starts.copy()
    for step in range(GAUSS_NEWTON_STEPS):
        gate = max(FIRST_GATE * GATE_FACTOR**step, LAST_GATE)
        sums = _normal_equations(views, moved, values, gate)
        if sums is None:
            return None
        pull = _noise(sums) / prior**2
        change = np.clip(-solve(sums.system + np.diag(pull), sums.right + pull * values), -MAX_STEP, MAX_STEP)
        values = values + change
        twists = -matmul(sums.inverse, (sums.gradients + matmul(sums.mixed, change))[..., None])[..., 0]
        R = rotations_of(twists[:, :3])
        moved[sums.used, :3] = matmul(R, moved[sums.used, :3])
        moved[sums.used, :3, 3] += twists[:, 3:]
        median_twist = float(np.median(np.abs(twists).max(axis=1)))
        if gate == LAST_GATE and max(np.abs(change).max(), median_twist) < MAX_LAST_CHANGE:
            break
    sums = _normal_equations(views, moved, values, LAST_GATE)
    if sums is None:
        return None
    return _Solution(values, math.sqrt(sums.cost / sums.weights), moved, sums)


def _noise(sums: _Normal) -> float:
    """Squared residual in expected ones, by the number of cells with a common error."""
    return COMMON_PIXELS * sums.cost / sums.point_count + 1e-12


def _normal_equations(views: ViewPairs, poses: Floats, values: Floats, gate: float) -> _Normal | None:
    """The normal equations at poses and camera. None if too few pairs or points agree."""
    rows = views.matches(poses, values, gate)
    used = rows.counts > 0
    if len(rows.residuals) < views.min_points or used.sum() < MIN_PAIRS:
        return None
    weights, J = rows.weights(), rows.jacobian(rows.first_planes, values)
    sums = sums_of_pairs(J * weights, J, rows.counts[used])
    cost = float(sums[:, -1, -1].sum())
    return _Normal(*_without_poses(sums), used, cost, float(weights.sum()), len(weights), rows)


def sums_of_pairs(left: Floats, right: Floats, counts: NDArray[np.int64]) -> Floats:
    """Symmetric matrices [pairs, n, n] of the products of rows, left and right (n, points), from the lower ones."""
    low, high = np.tril_indices(len(left))
    sums = np.empty((len(counts), len(left), len(left)))
    products = np.add.reduceat(left[low] * right[high], np.cumsum(counts) - counts, axis=1)
    sums[:, low, high] = sums[:, high, low] = products.T
    return sums


def _without_poses(sums: Floats) -> tuple[Floats, Floats, Floats, Floats, Floats]:
    """Normal equations of the camera without the poses, and the inverse, mixed part and gradients of each pose."""
    inverse = pose_inverse(sums)
    mixed, gradients = sums[:, :6, 6:-1], sums[:, :6, -1]
    by_camera = matmul(mixed.transpose(0, 2, 1), inverse)
    system = (sums[:, 6:-1, 6:-1] - matmul(by_camera, mixed)).sum(0)
    right = (sums[:, 6:-1, -1] - matmul(by_camera, gradients[..., None])[..., 0]).sum(0)
    return system, right, inverse, mixed, gradients


def _deviations(found: _Solution, pairs: NDArray[np.int64]) -> Floats:
    """Standard deviations of the camera, infinite where the frames do not determine it.

    They contain the scatter over frames and the effect of biased depth, as those of posed frames. They are not smaller
    than those by the information.
    """
    systems, known, rights = _camera_equations(found)
    deviations, total = np.full(len(PRIOR_DEVIATIONS), math.inf), systems.sum(0)
    size = len(total)
    prior = PRIOR_DEVIATIONS[:size]
    information, axes = eigh(known.sum(0) * (prior[:, None] * prior))  # relative to the prior; below 0: noise
    ratios = np.sqrt((axes**2 / (1.0 + np.maximum(information, 0.0))).sum(axis=1))
    pull = np.diag(1.0 / prior**2)
    factor = widening(total + pull, known.sum(0) + pull)
    effects = matmul(inv(total + pull), rights[..., 1:].sum(0))
    prior_gradient = found.values[:size] / prior**2
    covariance = scatter(pairs, systems, rights[..., 0], prior_gradient, pull) + matmul(effects, effects.T)
    spread = np.sqrt(np.diag(matmul(matmul(factor, covariance), factor.T)))
    largest = np.maximum(spread, ratios * prior)
    deviations[:size] = np.where(largest < MAX_DEVIATION_RATIO * prior, largest, math.inf)
    return deviations


def _camera_equations(found: _Solution) -> tuple[Floats, Floats, Floats]:
    """Normal equations of each pair by the estimated parameters without the poses, in units of the noise.

    The matrices, those without the noise of normals, and the products with the residuals and the patterns of biased
    depth. In the first matrices, noise of the normals counts as information: a floor alone would determine the camera.
    The second ones contain products of derivatives at planes of the one and of the other view, whose noise is
    independent. In both, the first ones remove the poses: matrices of poses without noise may be singular, and one such
    pair of 60 spoils the sum.
    """
    rows, noise = found.sums.rows, _noise(found.sums)
    counts, weights = rows.counts[found.sums.used], rows.weights()
    size = 6 + int((PRIOR_DEVIATIONS > FIXED_DEVIATION).sum())
    views = [rows.jacobian(planes, found.values)[:size] for planes in (rows.first_planes, rows.second_planes)]
    sums = [sums_of_pairs(J * weights, J, counts) for J in views]
    removals = [
        np.concatenate([-matmul(pose_inverse(s), s[:, :6, 6:]), np.tile(np.eye(size - 6), (len(s), 1, 1))], axis=1)
        for s in sums
    ]
    left = removals[0].transpose(0, 2, 1)
    known = matmul(matmul(left, products_of_pairs(views[0] * weights, views[1], counts)), removals[1])
    causes = np.vstack([rows.residuals, rows.biased()])
    rights = matmul(left, products_of_pairs(views[0] * weights, causes, counts))
    systems = matmul(matmul(left, sums[0]), removals[0])
    return systems / noise, 0.5 * (known + known.transpose(0, 2, 1)) / noise, rights / noise


def products_of_pairs(left: Floats, right: Floats, counts: NDArray[np.int64]) -> Floats:
    """Matrices [pairs, n, m] of the products of rows, left (n, points) and right (m, points)."""
    return np.add.reduceat(left[:, None] * right, np.cumsum(counts) - counts, axis=2).transpose(2, 0, 1)


def pose_inverse(sums: Floats) -> Floats:
    return inv(sums[:, :6, :6] + 1e-3 * np.eye(6))


class _Surface(NamedTuple):
    """Cells of a view: smoothed depth [m], normals and rays (x, y), float64 (6, cells), and those on a plane."""

    cells: Floats
    is_plane: NDArray[np.bool_]

    def is_sampled(self, step: int) -> NDArray[np.bool_]:
        """Each `step`-th cell of each `step`-th row."""
        chosen = np.zeros(self.is_plane.shape, bool)
        chosen[::step, ::step] = True
        return chosen


def _surface_of(view: CameraView, radius: int) -> _Surface:
    """Fit planes to the inverse depth in windows of cells."""
    q, (fx, fy, cx, cy) = view.nearness.astype(np.float64), view.lens
    v, u = np.mgrid[: q.shape[0], : q.shape[1]].astype(np.float64)
    n = (2 * radius + 1) ** 2
    spread = n * radius * (radius + 1) / 3.0
    sums = _window_sums(np.stack([q, q * q, q * u, q * v, (q > 0).astype(np.float64)]), radius)
    middle, square = sums[0] / n, sums[1]
    a, b = (sums[2] - u * n * middle) / spread, (sums[3] - v * n * middle) / spread
    residual = np.sqrt(np.maximum(square / n - middle**2 - spread / n * (a * a + b * b), 0.0))
    is_full = sums[4] > n - 0.5
    z = np.where(is_full, 1.0 / np.maximum(middle, 1e-6), 0.0)
    normals = np.stack([a * fx, b * fy, middle - a * (u - cx) - b * (v - cy)])
    normals /= np.maximum(np.sqrt((normals**2).sum(0)), 1e-12)
    x, y = (u - cx) / fx, (v - cy) / fy
    cosine = np.abs(normals[0] * x + normals[1] * y + normals[2]) / np.sqrt(1.0 + x * x + y * y)
    is_plane = is_full & (residual * z * z < PLANE_NOISE * (1.0 + z * z)) & (cosine > MIN_COSINE)
    return _Surface(np.stack([z, *normals, x, y]).reshape(6, -1), is_plane)


def _window_sums(values: Floats, radius: int) -> Floats:
    """Sums over the windows of cells of each image; windows end at the border."""
    rows, columns = values.shape[1:]
    padded = np.pad(values, ((0, 0), (radius, radius), (radius, radius)))
    vertical = sum((padded[:, k : k + rows] for k in range(1, 2 * radius + 1)), padded[:, :rows].copy())
    return sum((vertical[..., k : k + columns] for k in range(1, 2 * radius + 1)), vertical[..., :columns].copy())


def _scales(values: Floats) -> tuple[float, float]:
    """Factors of fx and fy."""
    return math.exp(values[0] + 0.5 * values[4]), math.exp(values[0] - 0.5 * values[4])


def _rays(x: Floats, y: Floats, values: Floats) -> tuple[Floats, Floats]:
    """Corrected rays."""
    x_scale, y_scale = _scales(values)
    x, y = (x - values[1]) / x_scale, (y - values[2]) / y_scale
    factor = 1.0 + values[3] * (x * x + y * y)
    return x * factor, y * factor


def derivatives(cells: Floats, n: Floats, values: Floats) -> Floats:
    """Derivatives of n . point by the parameters, float64 [6, points], at rays (x, y) and depth."""
    x, y, z = cells
    (x_scale, y_scale), square = _scales(values), x * x + y * y
    along_x, along_y = n[0] * x * z, n[1] * y * z
    along = along_x + along_y
    center = -n[0] * z / x_scale, -n[1] * z / y_scale
    return np.stack([-along, *center, along * square, 0.5 * (along_y - along_x), along + n[2] * z])


def _corrected_normals(cells: Floats, values: Floats) -> Floats:
    """Normals [3, points] of cells of a _Surface whose rays are corrected.

    Along x and y, the gradient of n . ray changes with the rays. Its value at the cell is kept.
    """
    if not values[:5].any():
        return cells[1:4]
    (x_scale, y_scale), n, (x, y) = _scales(values), cells[1:4], cells[4:6]
    level = n[0] * x + n[1] * y + n[2]
    x, y = (x - values[1]) / x_scale, (y - values[2]) / y_scale
    a, b, square = n[0] * x_scale, n[1] * y_scale, x * x + y * y
    factor = 1.0 + values[3] * square
    radial = 2.0 * values[3] * (a * x + b * y) / (factor + 2.0 * values[3] * square)
    a, b = (a - radial * x) / factor, (b - radial * y) / factor
    out = np.stack([a, b, level - factor * (a * x + b * y)])
    return out / np.maximum(np.sqrt((out**2).sum(0)), 1e-12)
