"""Weighted similarity between a model and known positions, the up direction, and known lengths.

Gauss-Newton over scale, rotation and translation from a RANSAC estimate (Triggs et al. 1999, section 4; Fischler and
Bolles 1981). GNSS is two to three times more accurate in plan than in height, surveys a hundred times. Up resolves
collinear positions.
"""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import eigvalsh, inv, matmul, solve
from ..rigid import nearest_rotation, rotation_of, scale_of, skew, skews
from .up_direction import upright_rotation

Array = NDArray[np.float64]

MAX_ITERATIONS = 50  # Gauss-Newton iterations. Five are usual
MAX_PAIRS = 4000  # tested camera pairs
CONVERGED_STEP = 1e-12  # step at convergence
MIN_EIGENVALUE_RATIO = 1e-14  # relative to the largest eigenvalue, undetermined below


@dataclass(frozen=True, eq=False)
class Rows:
    """Observed positions [n, 3] with `sigma` [m], up, and `lengths` (model length, length [m], sigma [m]), [m, 3]."""

    source: Array
    target: Array
    sigma: Array
    up: Array | None = None
    up_sigma: float = math.inf
    lengths: Array = field(default_factory=lambda: np.zeros((0, 3)))


@dataclass(frozen=True, eq=False)
class WeightedFit:
    """Optimal similarity with uncertainties [degrees] and the covariance of (log scale, rotation, translation)."""

    T: Array
    scale: float
    scale_sigma: float
    tilt_sigma: float
    yaw_sigma: float
    covariance: Array
    middle: Array

    def of(self, points: Array) -> Array:
        return matmul(points, self.T[:3, :3].T) + self.T[:3, 3]

    def covariance_of(self, points: Array) -> Array:
        """Covariances of transformed (exact) model positions, [n, 3, 3]."""
        J = _derivatives(matmul(points - self.middle, self.T[:3, :3].T))
        return matmul(J, self.covariance, J.transpose(0, 2, 1))


class UndeterminedError(ValueError):
    """The observations do not determine scale, rotation or position."""


def fit_rows(rows: Rows, T: Array) -> WeightedFit:
    scale = scale_of(T)
    R = T[:3, :3] / scale
    middle = rows.source.mean(axis=0)
    x, weights = rows.source - middle, 1 / rows.sigma
    shift = matmul(T[:3, :3], middle) + T[:3, 3]
    anchor = rows.target.mean(axis=0)
    translation, y = shift - anchor, rows.target - anchor
    normal = np.eye(7)
    for _ in range(MAX_ITERATIONS):
        J, r = _system(rows, scale, R, translation, x, y, weights)
        unit = np.linalg.norm(J, axis=0)
        unit[unit == 0] = 1.0
        normal = matmul(J.T, J)
        values = eigvalsh(normal / np.outer(unit, unit))
        if not values[0] > MIN_EIGENVALUE_RATIO * values[-1]:
            raise UndeterminedError("the observations do not determine scale, rotation or position")
        step = -solve(normal / np.outer(unit, unit), matmul((J / unit).T, r)) / unit
        step[:4] *= min(1.0, 0.5 / float(np.abs(step[:4]).max() + 1e-300))
        scale *= math.exp(step[0])
        R = matmul(rotation_of(step[1:4]), R)
        translation = translation + step[4:]
        if np.abs(step[:4]).max() < CONVERGED_STEP and np.abs(step[4:]).max() < CONVERGED_STEP * (1 + np.abs(y).max()):
            break
    R = nearest_rotation(R)  # accumulated rounding
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = scale * R, translation + anchor - matmul(scale * R, middle)
    covariance = inv(normal).astype(np.float64)
    sigmas = np.sqrt(np.diag(covariance))
    degrees = np.degrees(sigmas[1:4])
    return WeightedFit(pose, scale, float(sigmas[0]), float(degrees[:2].max()), float(degrees[2]), covariance, middle)


def _system(
    rows: Rows, scale: float, R: Array, translation: Array, x: Array, y: Array, weights: Array
) -> tuple[Array, Array]:
    """Whitened Jacobian by log scale, left rotation and translation, [k, 7], and residuals."""
    rotated = matmul(scale * x, R.T)
    J = _derivatives(rotated)
    blocks = [(J * weights[:, :, None]).reshape(-1, 7)]
    gaps = [((rotated + translation - y) * weights).reshape(-1)]
    if rows.up is not None and math.isfinite(rows.up_sigma):
        up = matmul(R, rows.up)
        block = np.zeros((3, 7))
        block[:, 1:4] = -skew(up)
        blocks.append(block / rows.up_sigma)
        gaps.append((up - (0.0, 0.0, 1.0)) / rows.up_sigma)
    for length, meters, sigma in rows.lengths.tolist():
        blocks.append(np.array([[scale * length / sigma, 0, 0, 0, 0, 0, 0]]))
        gaps.append(np.array([(scale * length - meters) / sigma]))
    return np.concatenate(blocks), np.concatenate(gaps)


def _derivatives(rotated: Array) -> Array:
    """Derivatives of positions by log scale, left rotation and translation, [n, 3, 7]."""
    J = np.zeros((len(rotated), 3, 7))
    J[:, :, 0] = rotated
    J[:, :, 1:4] = -skews(rotated)
    J[:, :, 4:] = np.eye(3)
    return J


def fit_level(source: Array, target: Array, up: Array) -> Array:
    """RANSAC similarity that keeps `up` [3] vertical, by the median horizontal distance. Target heights may be NaN."""
    upright = upright_rotation(up)
    s = matmul(source, upright.T)
    a, b = s[:, 0] + 1j * s[:, 1], target[:, 0] + 1j * target[:, 1]
    i, j = _pairs(len(a)).T
    with np.errstate(all="ignore"):
        k = (b[j] - b[i]) / (a[j] - a[i])
        shift = b[i] - k * a[i]
        gaps = np.sort(np.abs(k[:, None] * a + shift[:, None] - b), axis=1)
    fraction = gaps[:, len(a) // 2]
    size = np.abs(k)
    fraction[~(np.isfinite(fraction) & np.isfinite(size) & (size > 1e-12))] = np.inf
    best = int(np.argmin(fraction))
    if not math.isfinite(fraction[best]):
        raise UndeterminedError("the positions are not spread out")
    scale, angle = float(size[best]), math.atan2(k[best].imag, k[best].real)
    c, n = math.cos(angle), math.sin(angle)
    T = np.eye(4)
    T[:3, :3] = matmul(scale * np.array([[c, -n, 0], [n, c, 0], [0, 0, 1]]), upright)
    heights = target[:, 2] - scale * s[:, 2]
    height = float(np.nanmedian(heights)) if np.isfinite(heights).any() else 0.0
    T[:3, 3] = shift[best].real, shift[best].imag, height
    return T


def _pairs(count: int) -> NDArray[np.int64]:
    if math.comb(count, 2) <= MAX_PAIRS:
        return np.array(list(itertools.combinations(range(count), 2)))
    rng = np.random.Generator(np.random.PCG64(0))
    pairs = rng.integers(0, count, (MAX_PAIRS, 2))
    return pairs[pairs[:, 0] != pairs[:, 1]]
