"""The rotation that fits a matrix best, against the singular value decomposition; never a reflection."""

import numpy as np
import pytest

from pointloom.kernels.algebra.rotations import best_rotation
from pointloom.kernels.lang import array, kernel, launch, mat33d, tid
from pointloom.kernels.memory import empty, upload


@kernel
def fit_kernel(matrices: array(dtype=mat33d), rotations: array(dtype=mat33d)):
    i = tid()
    rotations[i] = best_rotation(matrices[i])


def fit(device, matrices):
    rotations = empty(len(matrices), mat33d, device)
    launch(fit_kernel, len(matrices), [upload(np.asarray(matrices, float), mat33d, device), rotations])
    return rotations.numpy()


def random_rotations(rng, count):
    q, r = np.linalg.qr(rng.normal(size=(count, 3, 3)))
    q *= np.sign(np.diagonal(r, axis1=1, axis2=2))[:, None, :]
    return q * np.linalg.det(q)[:, None, None]


@pytest.mark.parametrize(
    "values", [(3, 2, 1), (3, 2, 0), (3, 2, -1), (1, 1, 0.5), (3, 1e-3, 1e-6), (1, 0.5, -0.49)], ids=str
)
@pytest.mark.parametrize("scale", [1e-200, 1.0, 1e200])
def test_the_rotation_is_that_of_the_decomposition(device, rng, values, scale):
    """For U diag(values) V' it is V U', U and V rotations: the trace is then the sum of the values."""
    U, V = random_rotations(rng, 200), random_rotations(rng, 200)
    S = U @ (np.array(values)[:, None] * V.transpose(0, 2, 1))
    R = fit(device, scale * S)
    gap = min(values[0] + values[2], values[1] + values[2])  # between the largest two traces, halved
    np.testing.assert_allclose(R, V @ U.transpose(0, 2, 1), rtol=0, atol=1e-11 / gap)  # and 1e-12 for no rotation
    np.testing.assert_allclose(R @ R.transpose(0, 2, 1), np.tile(np.eye(3), (200, 1, 1)), rtol=0, atol=1e-14)
    np.testing.assert_allclose(np.linalg.det(R), 1, rtol=1e-14)


def test_a_line_is_rotated_by_the_smallest_angle(device):
    """One pair (p, q) leaves a turn about q open."""
    p, q = np.array([1.0, 0, 0]), np.array([0, 1.0, 0])
    (R,) = fit(device, [np.outer(p, q)])
    np.testing.assert_allclose(R, [[0, -1, 0], [1, 0, 0], [0, 0, 1]], rtol=0, atol=1e-5)  # decided by 1e-12


def test_invalid_or_zero_matrices_give_the_identity(device):
    matrices = [np.zeros((3, 3)), np.full((3, 3), np.nan), np.diag([np.inf, 1, 1]), np.eye(3)]
    np.testing.assert_array_equal(fit(device, matrices), [np.eye(3)] * 4)
