"""Small linear algebra in a fixed order agrees with NumPy's, and its bits do not depend on the kernels of BLAS."""

import os
import subprocess
import sys
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointloom.core.quaternions import nearest_rotations
from pointloom.kernels import linear_algebra as la

SIZES = st.integers(1, 9)
SEEDS = st.integers(0, 2**32 - 1)


def symmetric(rng, n, rank):
    rows = rng.normal(size=(rank, n))
    return rows.T @ rows


SHAPES = [((3,), (3,)), ((2, 3), (3,)), ((3,), (3, 2)), ((2, 3), (3, 4)), ((5, 2, 3), (3,)), ((3,), (5, 3, 2))]
SHAPES += [((5, 2, 3), (3, 4)), ((2, 3), (5, 3, 4)), ((5, 2, 3), (5, 3, 4)), ((7, 1, 2, 3), (5, 3, 4))]
SHAPES += [((0, 3), (3, 3))]


@pytest.mark.parametrize(("left", "right"), SHAPES)
def test_products_are_those_of_numpy(left, right, rng):
    a, b = rng.normal(size=left), rng.normal(size=right)
    result = la.matmul(a, b)
    assert result.shape == (a @ b).shape
    np.testing.assert_allclose(result, a @ b, rtol=1e-13, atol=1e-13)


def test_the_bits_of_a_product_do_not_depend_on_stacks_and_strides(rng):
    A, B, v = rng.normal(size=(50, 4, 4)), rng.normal(size=(50, 4, 4)), rng.normal(size=(50, 4))
    stacked, moved = la.matmul(A, B), la.matmul(A, v[:, :, None])[:, :, 0]
    for k in range(50):
        np.testing.assert_array_equal(la.matmul(A[k], np.asfortranarray(B[k])), stacked[k])
        np.testing.assert_array_equal(la.matmul(A[k].T.copy().T, v[k]), moved[k])
        np.testing.assert_array_equal(la.matmul(v[k], A[k].T), moved[k])


def test_shapes_that_do_not_fit_are_refused():
    with pytest.raises(ValueError, match=r"^matmul:"):
        la.matmul(np.ones((2, 3)), np.ones((1, 3)))


def test_a_product_of_several_is_evaluated_from_left_to_right(rng):
    a, b, c = rng.normal(size=(3, 4, 4))
    np.testing.assert_array_equal(la.matmul(a, b, c), la.matmul(la.matmul(a, b), c))


@settings(deadline=None)
@given(SIZES, SEEDS)
def test_solutions_and_inverses_leave_no_residual(n, seed):
    rng = np.random.default_rng(seed)
    A, b = rng.normal(size=(4, n, n)), rng.normal(size=(4, n, 2))
    result, inverse = la.solve(A, b), la.inv(A)
    sizes = np.abs(A).sum(axis=2).max(axis=1)
    limits = 1e-13 * sizes * np.abs(result).max(axis=(1, 2)), 1e-13 * sizes * np.abs(inverse).max(axis=(1, 2))
    assert (np.abs(A @ result - b).max(axis=(1, 2)) <= limits[0]).all()
    assert (np.abs(A @ inverse - np.eye(n)).max(axis=(1, 2)) <= limits[1]).all()
    np.testing.assert_array_equal(la.solve(A[0], b[0, :, 0]), la.solve(A[0], b[0, :, :1])[:, 0])


SINGULAR = [np.zeros((1, 1)), np.ones((3, 3)), np.diag([1.0, 0.0, 2.0])]
NOT_FINITE = [[[np.nan]], [[1.0, np.inf], [np.inf, 1.0]]]


@pytest.mark.parametrize(
    ("function", "matrix"), [*((la.inv, each) for each in SINGULAR), *((la.eigh, each) for each in NOT_FINITE)]
)
def test_inverses_of_singular_matrices_and_eigenvalues_of_non_finite_ones_are_refused(function, matrix):
    with pytest.raises(np.linalg.LinAlgError):
        function(np.array(matrix))


@settings(deadline=None)
@given(SIZES, st.integers(0, 9), SEEDS, st.sampled_from([1e-150, 1e-9, 1.0, 1e9, 1e150]))
def test_eigenvectors_are_orthonormal_and_rebuild_the_matrix(n, rank, seed, size):
    A = size * symmetric(np.random.default_rng(seed), n, rank)
    values, vectors = la.eigh(A)
    limit = 1e-13 * np.abs(A).max(initial=0)
    assert (np.diff(values) >= 0).all()
    np.testing.assert_allclose(values, np.linalg.eigvalsh(A), rtol=0, atol=n * limit)
    np.testing.assert_allclose(vectors.T @ vectors, np.eye(n), rtol=0, atol=1e-13)
    np.testing.assert_allclose((vectors * values) @ vectors.T, A, rtol=0, atol=n * limit)


@settings(deadline=None)
@given(st.integers(2, 7), SEEDS)
def test_a_single_eigenvector_has_the_sign_of_lapack(n, seed):
    A = symmetric(np.random.default_rng(seed), n, n) + np.diag(np.arange(0.0, 40.0 * n, 40.0))
    np.testing.assert_allclose(la.eigh(A)[1], np.linalg.eigh(A)[1], rtol=0, atol=1e-10)


def test_the_largest_entry_of_a_repeated_eigenvector_is_positive():
    rotation = nearest_rotations(np.random.default_rng(3).normal(size=(1, 3, 3)))[0]
    _, vectors = la.eigh(rotation @ np.diag([2.0, 2.0, 5.0]) @ rotation.T)
    assert (vectors[:, :2].max(axis=0) == np.abs(vectors[:, :2]).max(axis=0)).all()


def test_eigenvalues_of_a_stack_are_those_of_each(rng):
    A = np.array([symmetric(rng, 3, 3) for _ in range(6)]).reshape(2, 3, 3, 3)
    values, vectors = la.eigh(A)
    np.testing.assert_array_equal(values[1, 2], la.eigh(A[1, 2])[0])
    np.testing.assert_array_equal(vectors[1, 2], la.eigh(A[1, 2])[1])


def test_a_pseudoinverse_ignores_zero_singular_values():
    A = np.diag([4.0, 0.5, 1e-12])
    np.testing.assert_allclose(la.pinvh(A, 1e-9), np.diag([0.25, 2.0, 0.0]), rtol=1e-15)
    np.testing.assert_array_equal(la.pinvh(np.zeros((3, 3)), 1e-9), np.zeros((3, 3)))


@settings(deadline=None)
@given(st.floats(allow_nan=False, allow_infinity=False, min_value=-1e300, max_value=1e300))
def test_cube_roots_are_exact_to_a_rounding(value):
    """By rational arithmetic: a cube has three times the relative error of its root."""
    assert abs(Fraction(la.cube_root(value)) ** 3 - Fraction(value)) <= 3 * Fraction(4e-16) * abs(Fraction(value))


ROOTS = [(0.0, 0.0), (-0.0, -0.0), (np.inf, np.inf), (-np.inf, -np.inf), (1.0, 1.0), (8.0, 2.0), (-27.0, -3.0)]
ROOTS += [(5e-324, 1.7031839360032603e-108)]


@pytest.mark.parametrize(("value", "root"), ROOTS)
def test_cube_roots_of_corner_cases(value, root):
    """`np.cbrt` depends on the processor."""
    assert la.cube_root(value) == root and np.signbit(la.cube_root(value)) == np.signbit(root)


def test_determinants_and_norms_are_those_of_numpy(rng):
    A = rng.normal(size=(5, 3, 3))
    np.testing.assert_allclose(la.det(A), np.linalg.det(A), rtol=1e-12)
    assert la.norm(A[0]) == pytest.approx(np.linalg.norm(A[0]), rel=1e-15)


MATRICES = st.sampled_from(["any", "nearly a rotation", "mirrored", "of rank 2", "large", "nothing"])


@settings(deadline=None)
@given(MATRICES, SEEDS)
def test_nearest_rotations_are_those_of_the_singular_values(kind, seed):
    rng = np.random.default_rng(seed)
    M = rng.normal(size=(20, 3, 3))
    U, sizes, Vt = np.linalg.svd(M)
    changed = {
        "nearly a rotation": U @ Vt + 1e-6 * M, "mirrored": -U @ Vt @ np.diag([1.0, 2.0, 3.0]), "large": 1e9 * M,
        "of rank 2": (U * np.array([1.0, 0.7, 0.0])) @ Vt, "nothing": 0 * M,
    }  # fmt: skip
    M = changed.get(kind, M)
    U, sizes, Vt = np.linalg.svd(M)
    sign = np.sign(np.linalg.det(U @ Vt))
    U[:, :, 2] *= sign[:, None]
    result = nearest_rotations(M)
    np.testing.assert_allclose(result @ result.transpose(0, 2, 1), np.broadcast_to(np.eye(3), M.shape), atol=1e-13)
    np.testing.assert_allclose(np.linalg.det(result), 1.0, atol=1e-13)
    clear = sizes[:, 1] + sign * sizes[:, 2] > 0.02 * sizes[:, 0]  # else many are as near
    np.testing.assert_allclose(result[clear], (U @ Vt)[clear], rtol=0, atol=1e-10)


def test_a_rotation_keeps_its_bits(rng):
    R = nearest_rotations(rng.normal(size=(200, 3, 3)))
    np.testing.assert_array_equal(nearest_rotations(R), R)


SCRIPT = """
import hashlib
import numpy as np
from pointloom.core.quaternions import nearest_rotations
from pointloom.kernels import linear_algebra as la
rng = np.random.default_rng(0)
A, B = rng.normal(size=(2, 30, 6, 6))
M = la.matmul(A, A.transpose(0, 2, 1))
found = [M, la.inv(A), *la.eigh(M), la.solve(A, B), la.det(A[:, :3, :3]), la.pinvh(M[0], 1e-9), np.array(la.norm(A))]
found += [nearest_rotations(A[:, :3, :3]), la.matmul(rng.normal(size=(500, 300)), rng.normal(size=(300, 200)))]
print(*(hashlib.sha256(np.ascontiguousarray(one).tobytes()).hexdigest() for one in found))
print(hashlib.sha256((A @ A.transpose(0, 2, 1)).tobytes()).hexdigest())
"""


@pytest.mark.slow
def test_results_do_not_depend_on_the_kernels_of_blas():
    lines = []
    for kernels in ("Prescott", "Haswell"):
        command, environment = [sys.executable, "-c", SCRIPT], {**os.environ, "OPENBLAS_CORETYPE": kernels}
        done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
        lines.append(done.stdout.splitlines())
    assert lines[0][0] == lines[1][0]
    blas = np.show_config(mode="dicts")["Build Dependencies"]["blas"]["name"]
    core = getattr(np, "_core", None) or np.core  # np.core in NumPy 1
    if "openblas" in blas and core._multiarray_umath.__cpu_features__.get("AVX2"):
        assert lines[0][1] != lines[1][1]  # the bits of `@` do, so this test can fail


@pytest.mark.parametrize("smallest", [1e-9, 0.3, -1e-9, -2.0])
def test_a_matrix_is_positive_definite_if_its_smallest_eigenvalue_is_positive(smallest, rng):
    for n in (1, 2, 6):
        Q, _ = np.linalg.qr(rng.normal(size=(n, n)))
        A = (Q * np.linspace(smallest, 1, n) if n > 1 else Q * smallest) @ Q.T
        assert la.is_positive_definite((A + A.T) / 2) == (smallest > 0)
    assert not la.is_positive_definite(np.zeros((3, 3))) and not la.is_positive_definite(np.full((2, 2), np.nan))
