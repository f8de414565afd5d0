"""Fit of a depth camera to its frames: focal length, principal point and radial distortion by self-calibration.

A wrong camera deforms the points of a frame, so frames that are rotated against each other do not fit rigidly. The
common parameters and the pose of each pair are estimated together by point-to-plane residuals (Gauss-Newton). Planes
are fitted to inverse depth, which is linear in the image of a plane. A uniform depth scale cannot be estimated, nor can
images that are mirrored alike.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import inv, matmul, norm, solve
from ...registration.rigid import invert_pose, pose_of, rotation_vector

Floats = NDArray[np.float64]

MIN_ROTATION, MAX_ROTATION = math.radians(10.0), math.radians(45.0)  # of a pair
MAX_DISTANCE = 1.0  # [m] between the cameras of a pair
MAX_PAIRS, MIN_PAIRS = 24, 3
MIN_PAIR_POINTS, MIN_POINTS = 60, 300  # of a pair, of all
PLANE_RADIUS = 2  # [cells] of the fitted planes
PLANE_NOISE = 0.004  # [m] at 0 m, and [1/m] times squared depth: maximum root mean square residual of a plane
MIN_COSINE = 0.15  # of the incidence angle
# [m], [1/m]: the expected residual is DEPTH_NOISE + DEPTH_NOISE_GROWTH z^2
DEPTH_NOISE, DEPTH_NOISE_GROWTH = 0.003, 0.004
# Tested depth factors, and the minimum ratio of agreeing points of a better one: true poses of the kitchen and four
# synthetic sites 1.00 to 1.03 | depth 1.2 times too large 1.01 to 2.0, 2 times 1.4 and more (2026-11-29).
DEPTH_FACTORS = 2.0 ** (np.arange(-10, 11) / 4)
MIN_DEPTH_RATIO = 1.25
GAUSS_NEWTON_STEPS, MAX_STEP = 10, 0.15  # Gauss-Newton steps, and largest change of a parameter
FIRST_GATE, GATE_FACTOR, LAST_GATE = 0.25, 0.6, 0.05  # [m] maximum residual: first, factor of each step, minimum
MIN_NORMAL_COSINE = 0.7
OUTLIER_RATIO = 3.0  # in expected residuals, of the Geman-McClure weights
COMMON_PIXELS = 25.0  # cells of a window, whose planes have common errors
# [m] minimum root mean square displacement along normals by a parameter of 1 that no motion explains. Below it noise of
# the normals decides: a floor alone 3 mm, a small table 3 mm | kitchen 10 and more, synthetic sites 13 and more
# (2026-11-29).
MIN_LEVER = 0.006
# Minimum displacement with the fitted camera, relative to MIN_LEVER: a hall of 12 small frames, whose fit ran to three
# times the focal length, 0.25 | a correct camera 0.9, one whose focal length doubles 0.5 (2026-11-29).
FITTED_LEVER_RATIO = 0.5
FIXED_DEVIATION = 1e-9  # deviation of a parameter that is not estimated
# Standard deviations of the parameters before the fit: log focal length, principal point by the focal length (u, v),
# and radial distortion. They keep undetermined parameters near 0.
PRIOR_DEVIATIONS = np.array([0.3, 0.15, 0.15, 0.3])


class CameraView(NamedTuple):
    """Mean inverse depth [1/m] of the cells of a frame, float32 [rows, columns], 0 if sparse; fx, fy, cx, cy."""

    nearness: NDArray[np.float32]
    lens: tuple[float, float, float, float]


class CameraFit(NamedTuple):
    """Corrections of a camera: log focal length, principal point (u, v) in focal lengths, radial distortion of rays.

    `values` and `deviations` are float64 [4], 0 and infinite where undetermined. `residual` and `fitted_residual`: the
    weighted root mean square residual [m] of the given and the fitted camera. `poses`: T_first_second of the `pairs`.
    """

    values: Floats
    deviations: Floats
    residual: float
    fitted_residual: float
    pairs: list[tuple[int, int]]
    poses: list[Floats]


class _Surface(NamedTuple):
    """Smoothed depth [m], normals and rays (x, y) of cells, and those on a plane."""

    depth: Floats
    normals: Floats
    x: Floats
    y: Floats
    is_plane: NDArray[np.bool_]
    lens: tuple[float, float, float, float]


def rotated_pairs(poses: Sequence[Floats] | Floats) -> list[tuple[int, int]]:
    """Index pairs of poses that are rotated against each other and near, spread over the path."""
    pairs = []
    for first in range(len(poses)):
        for second in range(first + 1, len(poses)):
            motion = matmul(invert_pose(poses[first]), poses[second])
            angle = norm(rotation_vector(motion[:3, :3]))
            if MIN_ROTATION < angle < MAX_ROTATION and norm(motion[:3, 3]) < MAX_DISTANCE:
                pairs.append((first, second))
    chosen = np.unique(np.linspace(0, len(pairs) - 1, min(len(pairs), MAX_PAIRS)).astype(int)) if pairs else []
    return [pairs[index] for index in chosen]


def fit_camera(
    views: Sequence[CameraView], poses: Sequence[Floats] | Floats, pairs: list[tuple[int, int]]
) -> CameraFit | None:
    """Fit the camera to pairs of views with approximate poses T_world_camera. None if too few agree."""
    needed = {index for pair in pairs for index in pair}
    surfaces = {index: _surface_of(views[index]) for index in needed}
    ends = [(surfaces[first], surfaces[second]) for first, second in pairs]
    starts = [matmul(invert_pose(poses[first]), poses[second]) for first, second in pairs]
    given = _solve(ends, starts, np.full(4, FIXED_DEVIATION))
    if given is None:
        return None
    is_free, found = given.lever > MIN_LEVER, given
    while is_free.any():
        found = _solve(ends, given.poses, np.where(is_free, PRIOR_DEVIATIONS, FIXED_DEVIATION))
        if found is None:
            return None
        is_kept = is_free & (found.lever > MIN_LEVER * FITTED_LEVER_RATIO)
        if np.array_equal(is_kept, is_free):
            break
        is_free, found = is_kept, given
    deviations = np.where(is_free, found.deviations, math.inf)
    values = np.where(is_free, found.values, 0.0)
    return CameraFit(values, deviations, given.residual, found.residual, pairs, found.poses)


def depth_factor(views: Sequence[CameraView], poses: Sequence[Floats] | Floats) -> float:
    """The factor of the depth with which more points of rotated views agree at their poses T_world_camera, else 1."""
    pairs = rotated_pairs(poses)
    surfaces = {index: _surface_of(views[index]) for index in {index for pair in pairs for index in pair}}
    counts = np.zeros(len(DEPTH_FACTORS))
    for first, second in pairs:
        motion = matmul(invert_pose(poses[first]), poses[second])
        for k, factor in enumerate(DEPTH_FACTORS):
            T = motion.copy()
            T[:3, 3] /= factor
            rows = _rows(surfaces[first], surfaces[second], T, np.zeros(4), LAST_GATE)
            counts[k] += 0 if rows is None else len(rows[0])
    best = int(np.argmax(counts))
    is_better = counts[best] > MIN_DEPTH_RATIO * counts[len(counts) // 2]
    return float(DEPTH_FACTORS[best]) if is_better else 1.0


class _Solution(NamedTuple):
    values: Floats
    deviations: Floats
    lever: Floats
    residual: float
    poses: list[Floats]


class _Normal(NamedTuple):
    """Normal equations of the camera without the poses, those of each pair, and the sums of squares."""

    system: Floats
    right: Floats
    parts: list[tuple[Floats, Floats, Floats] | None]
    cost: float
    weights: float
    point_count: int


def _solve(ends: list[tuple[_Surface, _Surface]], starts: list[Floats], prior: Floats) -> _Solution | None:
    """Gauss-Newton over the camera, with standard deviations `prior`, and the poses of all pairs."""
    values, moved = np.zeros(4), list(starts)
    for step in range(GAUSS_NEWTON_STEPS):
        sums = _normal_equations(ends, moved, values, max(FIRST_GATE * GATE_FACTOR**step, LAST_GATE))
        if sums is None:
            return None
        pull = _noise(sums) / prior**2
        change = np.clip(-solve(sums.system + np.diag(pull), sums.right + pull * values), -MAX_STEP, MAX_STEP)
        values = values + change
        for k, part in enumerate(sums.parts):
            if part is not None:
                inverse, B, g = part
                moved[k] = matmul(pose_of(-matmul(inverse, g + matmul(B, change))), moved[k])
    sums = _normal_equations(ends, moved, values, LAST_GATE)
    if sums is None:
        return None
    known = sums.system + np.diag(_noise(sums) / prior**2)
    lever = 1.0 / np.sqrt(np.diagonal(inv(sums.system + 1e-9 * sums.weights * np.eye(4))) * sums.weights)
    deviations = np.sqrt(np.diagonal(inv(known)) * _noise(sums))
    return _Solution(values, deviations, lever, math.sqrt(sums.cost / sums.weights), moved)


def _noise(sums: _Normal) -> float:
    """Squared residual in expected ones, by the number of cells with a common error."""
    return COMMON_PIXELS * sums.cost / sums.point_count + 1e-12


def _normal_equations(
    ends: list[tuple[_Surface, _Surface]], moved: list[Floats], values: Floats, gate: float
) -> _Normal | None:
    """The normal equations at poses and camera. None if too few pairs or points agree."""
    system, right, cost, weights, count = np.zeros((4, 4)), np.zeros(4), 0.0, 0.0, 0
    parts: list[tuple[Floats, Floats, Floats] | None] = []
    for (first, second), T in zip(ends, moved, strict=True):
        rows = _rows(first, second, T, values, gate)
        if rows is None:
            parts.append(None)
            continue
        r, weight, of_pose, of_camera = rows
        weighted = (of_pose * weight[:, None]).T
        B, g = matmul(weighted, of_camera), (of_pose * (weight * r)[:, None]).sum(0)
        inverse = inv(matmul(weighted, of_pose) + 1e-3 * np.eye(6))
        system += matmul((of_camera * weight[:, None]).T, of_camera) - matmul(B.T, inverse, B)
        right += (of_camera * (weight * r)[:, None]).sum(0) - matmul(B.T, inverse, g)
        parts.append((inverse, B, g))
        cost, weights, count = cost + float((weight * r * r).sum()), weights + float(weight.sum()), count + len(r)
    if count < MIN_POINTS or sum(part is not None for part in parts) < MIN_PAIRS:
        return None
    return _Normal(system, right, parts, cost, weights, count)


def _surface_of(view: CameraView) -> _Surface:
    """Fit planes to the inverse depth in windows of cells."""
    q, (fx, fy, cx, cy) = view.nearness.astype(np.float64), view.lens
    v, u = np.mgrid[: q.shape[0], : q.shape[1]].astype(np.float64)
    n = (2 * PLANE_RADIUS + 1) ** 2
    spread = n * PLANE_RADIUS * (PLANE_RADIUS + 1) / 3.0
    middle, square = _window_sum(q) / n, _window_sum(q * q)
    a, b = (_window_sum(q * u) - u * n * middle) / spread, (_window_sum(q * v) - v * n * middle) / spread
    residual = np.sqrt(np.maximum(square / n - middle**2 - spread / n * (a * a + b * b), 0.0))
    is_full = _window_sum((q > 0).astype(np.float64)) > n - 0.5
    z = np.where(is_full, 1.0 / np.maximum(middle, 1e-6), 0.0)
    normals = np.stack([a * fx, b * fy, middle - a * (u - cx) - b * (v - cy)], axis=-1)
    normals /= np.maximum(np.sqrt((normals**2).sum(-1)), 1e-12)[..., None]
    x, y = (u - cx) / fx, (v - cy) / fy
    cosine = np.abs(normals[..., 0] * x + normals[..., 1] * y + normals[..., 2]) / np.sqrt(1.0 + x * x + y * y)
    is_plane = is_full & (residual * z * z < PLANE_NOISE * (1.0 + z * z)) & (cosine > MIN_COSINE)
    return _Surface(z, normals, x, y, is_plane, view.lens)


def _window_sum(values: Floats) -> Floats:
    """Sum over the windows of cells; windows end at the border."""
    size = 2 * PLANE_RADIUS + 1
    sums = np.cumsum(np.cumsum(np.pad(values, [(PLANE_RADIUS + 1, PLANE_RADIUS)] * 2), axis=0), axis=1)
    return sums[size:, size:] - sums[:-size, size:] - sums[size:, :-size] + sums[:-size, :-size]


def _rays(x: Floats, y: Floats, values: Floats) -> tuple[Floats, Floats]:
    """Corrected rays."""
    x, y = (x - values[1]) * math.exp(-values[0]), (y - values[2]) * math.exp(-values[0])
    factor = 1.0 + values[3] * (x * x + y * y)
    return x * factor, y * factor


def _derivatives(x: Floats, y: Floats, z: Floats, n: Floats, values: Floats) -> Floats:
    """Derivatives of n . point by the parameters, float64 [points, 4]."""
    inverse_focal, square = math.exp(-values[0]), x * x + y * y
    along = (n[:, 0] * x + n[:, 1] * y) * z
    return np.stack([-along, -n[:, 0] * z * inverse_focal, -n[:, 1] * z * inverse_focal, along * square], axis=1)


def _rows(
    first: _Surface, second: _Surface, T: Floats, values: Floats, gate: float
) -> tuple[Floats, Floats, Floats, Floats] | None:
    """Residuals, weights, and derivatives by the pose T_first_second (6) and the camera (4) of every second cell."""
    chosen = np.zeros(second.depth.shape, bool)
    chosen[::2, ::2] = True
    chosen &= second.is_plane
    x, y = _rays(second.x[chosen], second.y[chosen], values)
    z = second.depth[chosen]
    points = matmul(np.stack([x * z, y * z, z], 1), T[:3, :3].T) + T[:3, 3]
    depth = np.maximum(points[:, 2], 1e-6)
    u, v = points[:, 0] / depth, points[:, 1] / depth
    factor = math.exp(values[0]) / (1.0 + values[3] * np.minimum(u * u + v * v, 1.0))
    fx, fy, cx, cy = first.lens
    column = np.rint((u * factor + values[1]) * fx + cx).clip(-1, first.depth.shape[1]).astype(int)
    row = np.rint((v * factor + values[2]) * fy + cy).clip(-1, first.depth.shape[0]).astype(int)
    is_inside = (row >= 0) & (column >= 0) & (row < first.depth.shape[0]) & (column < first.depth.shape[1])
    at = np.where(is_inside, row * first.depth.shape[1] + column, 0)
    x_first, y_first = _rays(first.x.ravel()[at], first.y.ravel()[at], values)
    z_first = first.depth.ravel()[at]
    normals = _stretched(first.normals.reshape(-1, 3)[at], values)
    r = (points[:, 0] - x_first * z_first) * normals[:, 0] + (points[:, 1] - y_first * z_first) * normals[:, 1]
    r += (points[:, 2] - z_first) * normals[:, 2]
    other = matmul(_stretched(second.normals[chosen], values), T[:3, :3].T)
    is_near = is_inside & first.is_plane.ravel()[at] & (points[:, 2] > 0) & (np.abs(r) < gate)
    keep = np.flatnonzero(is_near & ((other * normals).sum(1) > MIN_NORMAL_COSINE))
    if len(keep) < MIN_PAIR_POINTS:
        return None
    n, r = normals[keep], r[keep]
    # The noise is that of depth, so that the weights do not depend on how much the rays are stretched.
    along = np.abs(n[:, 0] * x_first[keep] + n[:, 1] * y_first[keep] + n[:, 2])
    expected = (DEPTH_NOISE + DEPTH_NOISE_GROWTH * z_first[keep] ** 2) * np.maximum(along, MIN_COSINE)
    weight = 1.0 / ((1.0 + (r / expected / OUTLIER_RATIO) ** 2) ** 2 * expected**2)
    of_pose = np.concatenate([np.cross(points[keep], n), n], 1)
    of_camera = _derivatives(x[keep], y[keep], z[keep], matmul(n, T[:3, :3]), values)
    of_camera = of_camera - _derivatives(x_first[keep], y_first[keep], z_first[keep], n, values)
    return r, weight, of_pose, of_camera


def _stretched(normals: Floats, values: Floats) -> Floats:
    """Normals of points whose rays are scaled by the focal length."""
    out = normals * np.array([math.exp(values[0]), math.exp(values[0]), 1.0])
    return out / np.maximum(np.sqrt((out**2).sum(1)), 1e-12)[:, None]
