"""The covariance of a pose from surface patches, compared with the same formulas in NumPy."""

import numpy as np
import pytest

from pointloom.kernels.odometry.patch_errors import MIN_ROOM, PatchNumbers, fit_patches

LEVER = 3.0


def patches(rng, count: int) -> np.ndarray:
    y, n = rng.uniform(-5, 5, (count, 3)), np.eye(3)[rng.integers(0, 3, count)]
    return np.column_stack([np.cross(y, n), n, rng.normal(0.01, 0.02, count)])


def numbers(count: int, limit: float = 0.03) -> PatchNumbers:
    return PatchNumbers(
        row_count=count, lever=LEVER, prior=0.2, ridge=1e-4, width=4.0, min_width=1e-4, rounds=3, variance=1e-4,
        step_factor=1.0, shift_factor=4.0, limit=limit,
    )  # fmt: skip


@pytest.mark.parametrize("count", [0, 5, 6, 101, 256, MIN_ROOM + 1])
def test_the_covariance_is_that_of_reweighted_least_squares(rng, count):
    rows, planes, given = patches(rng, count), np.diag(np.arange(1.0, 7.0)), numbers(count)
    covariance, normal, variance, _ = fit_patches(rows, planes, given)
    J, r = rows[:, :6] / ([LEVER] * 3 + [1.0] * 3), rows[:, 6]
    expected = (J.T @ J + given.prior * planes) / (count + given.prior) + given.ridge * np.eye(6)
    np.testing.assert_allclose(normal, expected, rtol=1e-12, atol=1e-15)
    step, square = np.zeros(6), 0.0
    for _ in range(given.rounds if count >= 6 else 0):
        left = r + J @ step
        w = 1 / (1 + (left / (given.width * np.median(np.abs(left)))) ** 2) ** 2
        total = w.sum() + given.prior
        A = (J.T @ (J * w[:, None]) + given.prior * planes) / total + given.ridge * np.eye(6)
        step = -np.linalg.solve(A, J.T @ (w * r) / total)
        square = step @ A @ step / 6
    assert variance == pytest.approx(given.variance + square, rel=1e-9)
    expected = variance * np.linalg.inv(expected) + given.shift_factor * np.outer(step, step)
    np.testing.assert_allclose(covariance, expected, rtol=1e-7, atol=1e-12)


def test_a_small_eigenvalue_is_noticed(rng):
    rows = patches(rng, 200)
    lowest = np.linalg.eigvalsh(fit_patches(rows, np.eye(6), numbers(200))[1])[0]
    assert not fit_patches(rows, np.eye(6), numbers(200, 0.99 * lowest))[3]
    assert fit_patches(rows, np.eye(6), numbers(200, 1.01 * lowest))[3]
