"""Products, eigenvalues, eigenvectors and best rotations of 3 x 3 matrices, against NumPy, LAPACK and its SVD."""

import numpy as np
import pytest

from pointloom.kernels import lang
from pointloom.kernels.algebra.eigen import eigenvalues, smallest_eigenvector
from pointloom.kernels.algebra.rotations import best_rotation
from pointloom.kernels.lang import array, kernel, launch, mat33d, tid, vec3d
from pointloom.kernels.memory import download, empty, upload


@kernel
def solve_kernel(matrices: array(dtype=mat33d), vectors: array(dtype=vec3d)):
    i = tid()
    vectors[i] = smallest_eigenvector(matrices[i])


@kernel
def solve_values_kernel(matrices: array(dtype=mat33d), values: array(dtype=vec3d)):
    i = tid()
    values[i] = eigenvalues(matrices[i])


def solve(device, matrices, solver=solve_kernel):
    eigenvalues = empty(len(matrices), vec3d, device)
    launch(solver, len(matrices), [upload(matrices, mat33d, device), eigenvalues])
    return eigenvalues.numpy()


def random_rotations(rng, count):
    q, r = np.linalg.qr(rng.normal(size=(count, 3, 3)))
    q *= np.sign(np.diagonal(r, axis1=1, axis2=2))[:, None, :]
    return q * np.linalg.det(q)[:, None, None]


def with_values(rng, values, count=500):
    R = random_rotations(rng, count)
    a = R @ (np.asarray(values, float)[:, None] * R.transpose(0, 2, 1))
    return (a + a.transpose(0, 2, 1)) / 2


def assert_solved(device, matrices, tolerances):
    """Each vector is of unit length and one of LAPACK's smallest eigenvalue, and the eigenvalues are LAPACK's."""
    matrices = np.asarray(matrices, float).reshape(-1, 3, 3)
    v = solve(device, matrices)
    size = np.abs(matrices).max(axis=(1, 2))
    scaled = matrices / np.where(size > 0, size, 1)[:, None, None]
    np.testing.assert_allclose(np.linalg.norm(v, axis=1), 1, rtol=tolerances.eigen_residual)
    av = (scaled @ v[:, :, None])[:, :, 0]
    value = (v * av).sum(axis=1)
    residual = np.linalg.norm(av - value[:, None] * v, axis=1)
    assert residual.max() < tolerances.eigen_residual, scaled[residual.argmax()].tolist()
    expected = np.linalg.eigvalsh(scaled)
    np.testing.assert_allclose(value, expected[:, 0], rtol=0, atol=tolerances.eigenvalue_relative)
    eigenvalues = solve(device, matrices, solve_values_kernel) / np.where(size > 0, size, 1)[:, None]
    np.testing.assert_allclose(eigenvalues, expected, rtol=0, atol=tolerances.eigenvalue_relative)
    assert (np.diff(eigenvalues, axis=1) >= -tolerances.eigenvalue_relative).all()


@pytest.mark.parametrize(
    "values",
    [
        (1, 2, 3), (1e-6, 0.5, 1), (0, 0.3, 1), (0, 1e-12, 1), (0.999, 1, 1), (1e-9, 1, 1), (0, 1, 1), (0.5, 0.5, 1),
        (0, 0, 1), (1, 1, 1), (1, 1 + 1e-9, 1 + 2e-9), (1, 1, 1 + 1e-15), (-1, 0, 1), (-3, -2, -1), (-1, -1, 5),
        (0, 1e-8, 1), (1e-16, 1e-8, 1),
    ],
    ids=str,
)  # fmt: skip
def test_eigenvectors_and_eigenvalues_of_matrices_with_given_ones(device, values, rng, tolerances):
    """Distinct, repeated, close and zero eigenvalues; rank 3, 2, 1."""
    assert_solved(device, with_values(rng, values), tolerances)


def open3d_eigenvectors(o3d, matrices):
    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(np.zeros((len(matrices), 3))))
    cloud.covariances = o3d.utility.Matrix3dVector(matrices)
    cloud.estimate_normals()
    return np.asarray(cloud.normals, np.float32)


def test_eigenvectors_have_the_sign_of_open3d(device, rng, oracle):
    """Whichever eigenvalue is the best separated: its rule follows from the order of its steps."""
    values = [(0.1, 0.5, 1), (1e-6, 0.5, 1), (0.1, 0.9, 1), (0.01, 0.011, 1), (0.0, 1e-3, 1)]
    matrices = np.concatenate([with_values(rng, each, 100) for each in values])
    dots = (solve(device, matrices) * oracle("kernels/eigen/signs", open3d_eigenvectors, matrices)).sum(axis=1)
    assert (dots > 0.999).all()


@pytest.mark.parametrize("scale", [1e-300, 1e-100, 1e-30, 1.0, 1e30, 1e100, 1e300])
def test_eigenvectors_do_not_depend_on_scale(device, scale, rng, tolerances):
    for values in ((0.1, 0.5, 1), (0, 0, 1), (0, 1, 1)):
        assert_solved(device, with_values(rng, values, 100) * scale, tolerances)


@pytest.mark.parametrize("tiny", [1e-12, 1e-60, 1e-110, 1e-150, 1e-300])
def test_eigenvectors_where_off_diagonals_nearly_vanish(device, tiny, rng, tolerances):
    """The cube of the deviator's size underflows long before the deviator does."""
    a = np.zeros((6, 3, 3))
    for j, diagonal in enumerate([(1, 1, 1), (1, 1, 0), (0, 1, 1), (1, 0, 1), (0, 0, 1), (0.5, 1, 0.5)]):
        a[j] = np.diag(diagonal)
        a[j, 0, 1] = a[j, 1, 0] = tiny
        a[j, 1, 2] = a[j, 2, 1] = -tiny
    assert_solved(device, a, tolerances)


@pytest.mark.parametrize(
    "diagonal",
    [(1, 2, 3), (2, 1, 3), (3, 2, 1), (1, 1, 2), (1, 2, 1), (2, 1, 1), (0, 0, 1), (0, 1, 0), (1, 0, 0), (-1, -1, 0)],
    ids=str,
)
def test_the_axis_of_a_smallest_diagonal_is_taken(device, diagonal, tolerances):
    """Open3D takes (0, 0, 1) for diag(0, 0, 1), whose eigenvalue is the largest: the direction of a vertical line."""
    v = solve(device, np.diag(np.array(diagonal, float))[None])[0]
    assert sorted(np.abs(v)) == [0, 0, 1] and diagonal[int(np.abs(v).argmax())] == min(diagonal)


@pytest.mark.parametrize("factor", [0.0, 1.0, 1e-30, 1e30, -2.0])
def test_a_multiple_of_the_identity_gives_the_z_axis(device, factor):
    assert solve(device, factor * np.eye(3)[None])[0].tolist() == [0, 0, 1]


SOURCE = """
    from pointloom.kernels.algebra.matrices import multiply{size}

    @kernel
    def multiply_kernel(a: array(dtype=mat{size}d), b: array(dtype=mat{size}d), product: array(dtype=mat{size}d)):
        i = tid()
        product[i] = multiply{size}(a[i], b[i])
"""


@pytest.mark.parametrize("size", [3, 4])
def test_a_product_rounds_after_each_step(write_kernels, rng, device, size):
    kernels = write_kernels(f"products_{size}", SOURCE.format(size=11 * size))
    kind = getattr(lang, f"mat{11 * size}d")
    a, b = rng.normal(size=(2, 3000, size, size))
    product = empty(len(a), kind, device)
    lang.launch(kernels.multiply_kernel, len(a), [upload(a, kind, device), upload(b, kind, device), product])
    expected = a[:, :, 0, None] * b[:, 0, None, :]
    for k in range(1, size):
        expected = expected + a[:, :, k, None] * b[:, k, None, :]
    np.testing.assert_array_equal(download(product).reshape(expected.shape), expected)


@kernel
def fit_kernel(matrices: array(dtype=mat33d), rotations: array(dtype=mat33d)):
    i = tid()
    rotations[i] = best_rotation(matrices[i])


def fit(device, matrices):
    rotations = empty(len(matrices), mat33d, device)
    launch(fit_kernel, len(matrices), [upload(np.asarray(matrices, float), mat33d, device), rotations])
    return rotations.numpy()


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
