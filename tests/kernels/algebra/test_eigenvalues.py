"""All three eigenvalues, against LAPACK, from zero to huge matrices and every degenerate one."""

import numpy as np
import pytest

from pointloom.core.devices import resolve_device
from pointloom.kernels.algebra.eigen import eigenvalues
from pointloom.kernels.lang import array, kernel, launch, mat33d, tid, vec3d
from pointloom.kernels.memory import empty, upload


@kernel
def solve_values_kernel(matrices: array(dtype=mat33d), values: array(dtype=vec3d)):
    i = tid()
    values[i] = eigenvalues(matrices[i])


def solve(device, matrices):
    where = resolve_device(device)
    values = empty(len(matrices), vec3d, where)
    launch(solve_values_kernel, len(matrices), [upload(matrices, mat33d, where), values])
    return values.numpy()


def assert_solved(device, matrices, tolerances):
    matrices = np.asarray(matrices, float).reshape(-1, 3, 3)
    size = np.abs(matrices).max(axis=(1, 2))[:, None]
    size = np.where(size > 0, size, 1)
    found, expected = solve(device, matrices) / size, np.linalg.eigvalsh(matrices / size[:, :, None])
    np.testing.assert_allclose(found, expected, rtol=0, atol=tolerances.eigenvalue_relative)
    assert (np.diff(found, axis=1) >= -tolerances.eigenvalue_relative).all()


@pytest.mark.parametrize(
    "values",
    [
        (1, 2, 3), (1e-6, 0.5, 1), (0, 0.3, 1), (0, 1e-12, 1), (0.999, 1, 1), (1e-9, 1, 1), (0, 1, 1), (0.5, 0.5, 1),
        (0, 0, 1), (1, 1, 1), (1, 1 + 1e-9, 1 + 2e-9), (1, 1, 1 + 1e-15), (-1, 0, 1), (-3, -2, -1), (-1, -1, 5),
        (0, 1e-8, 1), (1e-16, 1e-8, 1),
    ],
    ids=str,
)  # fmt: skip
@pytest.mark.parametrize("scale", [1e-280, 1.0, 1e300])
def test_eigenvalues_of_matrices_with_given_ones(device, values, scale, rng, tolerances):
    q, _ = np.linalg.qr(rng.normal(size=(300, 3, 3)))
    a = q @ (np.asarray(values, float)[:, None] * q.transpose(0, 2, 1))
    assert_solved(device, (a + a.transpose(0, 2, 1)) / 2 * scale, tolerances)


def test_eigenvalues_of_random_symmetric_matrices(device, rng, tolerances):
    a = rng.normal(size=(5000, 3, 3))
    assert_solved(device, a + a.transpose(0, 2, 1), tolerances)


def test_eigenvalues_of_a_diagonal_are_its_entries_in_order(device):
    diagonals = [(1, 2, 3), (3, 2, 1), (2, 3, 1), (1, 1, 0), (0, 0, 0), (-1, 5, -1), (1e-100, 0, 1e100)]
    found = solve(device, [np.diag(np.array(d, float)) for d in diagonals])
    np.testing.assert_allclose(found, np.sort(np.array(diagonals, float), axis=1), rtol=1e-15)
