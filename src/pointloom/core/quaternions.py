"""Convert rotations to and from unit quaternions (x, y, z, w). Nearest rotations of matrices."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..kernels.linear_algebra import det, eigh

NEARLY_SINGULAR = 1e-3  # a determinant, as a fraction of the cube of the Frobenius norm. A rotation's is 0.19
MAX_NEWTON_STEPS = 20
NEARLY_ONE = 0.1
ROUNDING_STEP = 1e-15  # smaller steps count as zero, so a rotation is unchanged bitwise
CONVERGED_STEP = 1e-9  # change of a step. Convergence is quadratic, so only rounding remains


def quaternions_to_rotations(quaternions: NDArray[np.float64]) -> NDArray[np.float64]:
    x, y, z, w = quaternions.T
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ]
    return np.moveaxis(np.array(rows), 2, 0)


def rotations_to_quaternions(R: NDArray[np.float64]) -> NDArray[np.float64]:
    """Unit quaternions (x, y, z, w), w >= 0, (n, 4), of rotations (n, 3, 3).
    The longest of the four rows of 4 q q^T, which are linear in R (Shepperd 1978), is accurate at any angle. Apply
    `nearest_rotations` to rounded matrices first."""
    products = np.empty((len(R), 4, 4))
    across, twist = R + R.transpose(0, 2, 1), R - R.transpose(0, 2, 1)
    products[:, :3, :3] = across
    trace = np.trace(R, axis1=1, axis2=2)
    for axis in range(3):
        products[:, axis, axis] = 1 - trace + 2 * R[:, axis, axis]
    products[:, 3, :3] = products[:, :3, 3] = np.stack([twist[:, 2, 1], twist[:, 0, 2], twist[:, 1, 0]], axis=1)
    products[:, 3, 3] = 1 + trace
    every = np.arange(len(R))
    rows = products[every, np.argmax(products[:, range(4), range(4)], axis=1)]
    rows /= np.sqrt((rows * rows).sum(axis=1))[:, None]
    return np.where(rows[:, 3:] < 0, -rows, rows)


def nearest_rotations(M: NDArray[np.float64]) -> NDArray[np.float64]:
    """The nearest rotations of matrices (n, 3, 3) in the Frobenius norm.
    Newton iteration for the polar factor (Higham 1986), or Horn's quaternion (1987) for nearly singular or mirrored
    matrices."""
    M = np.asarray(M, np.float64)
    sizes = _sizes(M)
    is_regular = det(M) > NEARLY_SINGULAR * sizes**3
    if is_regular.all():
        return _polar_factors(np.ldexp(M, 1 - np.frexp(sizes[:, None, None])[1]))
    R = np.empty(M.shape)
    R[is_regular] = _polar_factors(np.ldexp(M[is_regular], 1 - np.frexp(sizes[is_regular, None, None])[1]))
    R[~is_regular] = _best_rotations(M[~is_regular])
    return R


def _polar_factors(R: NDArray[np.float64]) -> NDArray[np.float64]:
    for _ in range(MAX_NEWTON_STEPS):
        after, before = R[:, [1, 2, 0]], R[:, [2, 0, 1]]
        cofactors = after[:, :, [1, 2, 0]] * before[:, :, [2, 0, 1]] - after[:, :, [2, 0, 1]] * before[:, :, [1, 2, 0]]
        inverses = cofactors / det(R)[:, None, None]  # transposed
        scales = np.sqrt(_sizes(inverses) / _sizes(R))[:, None, None]
        roots = np.sqrt(np.where(np.abs(scales - 1) < NEARLY_ONE, 1.0, scales))
        steps = (inverses / roots - R * roots) / 2
        lengths = np.abs(steps).max(axis=(1, 2), keepdims=True, initial=0.0)
        R = R * roots + np.where(lengths < ROUNDING_STEP, 0.0, steps)
        if not (lengths > CONVERGED_STEP).any():
            break
    return R


def _sizes(M: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.sqrt((M * M).sum(axis=(1, 2)))


def _best_rotations(M: NDArray[np.float64]) -> NDArray[np.float64]:
    """Rotations R that maximize trace(R^T M), from the main eigenvector of a 4x4 matrix."""
    N = np.zeros((len(M), 4, 4))
    N[:, :3, :3] = M + M.transpose(0, 2, 1) - 2 * np.trace(M, axis1=1, axis2=2)[:, None, None] * np.eye(3)
    N[:, :3, 3] = np.stack([M[:, 2, 1] - M[:, 1, 2], M[:, 0, 2] - M[:, 2, 0], M[:, 1, 0] - M[:, 0, 1]], axis=1)
    N[:, 3, :3] = N[:, :3, 3]
    return _polar_factors(quaternions_to_rotations(eigh(N)[1][:, :, 3]))  # without the rounding of the quaternions
