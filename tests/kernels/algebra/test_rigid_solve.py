"""Small solves of registration against LAPACK and SciPy: systems of six, eigenvectors, fits of pairs, rotations."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from pointloom.kernels.algebra.rigid_solve import (
    diagonalize,
    eigensystem,
    euler_motion,
    fit_pose,
    move,
    pair_sums,
    rotate,
    rotation_about,
    solve_system,
    square,
    sums_of_pair,
    triangle,
    vec6d,
)
from pointloom.kernels.lang import array, float64, func, kernel, launch, mat44d, tid, vec3d
from pointloom.kernels.memory import empty, upload, zeros
from pointloom.registration.rigid import fit_pose as fit_by_svd

UPPER = np.triu_indices(6)


@kernel
def solve_kernel(systems: array(dtype=triangle), sides: array(dtype=vec6d), solutions: array(dtype=vec6d)):
    i = tid()
    solutions[i] = solve_system(systems[i], sides[i])


@kernel
def diagonalize_kernel(matrices: array(dtype=square), n: int, out: array(dtype=eigensystem)):
    i = tid()
    out[i] = diagonalize(matrices[i], n)


@func
def add_pair(sums: pair_sums, p: vec3d, q: vec3d, w: float64) -> pair_sums:
    return sums + sums_of_pair(p, q, w)


@kernel
def fit_kernel(
    sources: array(dtype=vec3d), targets: array(dtype=vec3d), weights: array(dtype=float64), pairs: int, scaling: int,
    poses: array(dtype=mat44d),
):  # fmt: skip
    i = tid()
    sums = pair_sums(float64(0.0))
    for j in range(i * pairs, (i + 1) * pairs):
        sums = add_pair(sums, sources[j], targets[j], weights[j])
    poses[i] = fit_pose(sums, scaling)


@kernel
def rotate_kernel(
    steps: array(dtype=vec6d), quaternions: array(dtype=float64, ndim=2), points: array(dtype=vec3d),
    motions: array(dtype=mat44d), rotated: array(dtype=mat44d), moved: array(dtype=vec3d),
    directions: array(dtype=vec3d),
):  # fmt: skip
    i = tid()
    motions[i] = euler_motion(steps[i])
    rotated[i] = rotation_about(quaternions[i, 0], quaternions[i, 1], quaternions[i, 2], quaternions[i, 3])
    moved[i] = move(motions[i], points[i])
    directions[i] = rotate(motions[i], points[i])


def solve(device, matrices, sides):
    solutions = empty(len(matrices), vec6d, device)
    upper = np.ascontiguousarray(np.asarray(matrices, float)[:, UPPER[0], UPPER[1]])
    launch(solve_kernel, len(upper), [upload(upper, triangle, device), upload(sides, vec6d, device), solutions])
    return solutions.numpy()


def eigen(device, matrices):
    """Eigenvalues [m, n] and eigenvectors as columns [m, n, n] of symmetric matrices [m, n, n]."""
    n = matrices.shape[1]
    rows = np.zeros((len(matrices), 36))
    rows[:, : n * n] = matrices.reshape(len(matrices), -1)
    systems = empty(len(matrices), eigensystem, device)
    launch(diagonalize_kernel, len(matrices), [upload(rows, square, device), n, systems])
    systems = systems.numpy()
    return systems[:, 36 : 36 + n], systems[:, : n * n].reshape(-1, n, n)


def fit(device, sources, targets, weights=None, scaling=False):
    (m, k, _) = sources.shape
    weights = np.ones((m, k)) if weights is None else weights
    poses = empty(m, mat44d, device)
    flat = [upload(np.ascontiguousarray(a).reshape(-1, 3), vec3d, device) for a in (sources, targets)]
    launch(fit_kernel, m, [*flat, upload(weights.ravel(), float64, device), k, int(scaling), poses])
    return poses.numpy()


def symmetric(rng, values, count):
    n = len(values)
    Q = np.linalg.qr(rng.normal(size=(count, n, n)))[0]
    A = Q @ (np.asarray(values, float)[:, None] * Q.transpose(0, 2, 1))
    return (A + A.transpose(0, 2, 1)) / 2


def test_a_system_that_is_not_finite_has_no_step_of_zeros(device):
    """Which would be taken for convergence."""
    systems = np.tile(np.eye(6), (21 + 3, 1, 1))
    for k, (i, j) in enumerate(np.argwhere(np.triu(np.ones((6, 6))))):
        systems[k, i, j] = systems[k, j, i] = np.nan
    systems[21, 2, 2], systems[22, 3, 4] = np.inf, -np.inf
    solutions = solve(device, systems, np.ones((24, 6)))
    assert not np.isfinite(solutions[:23]).all(axis=1).any() and (solutions[23] == 1).all()


SIZES = (1e-150, 1e-6, 1.0, 1e9, 1e150)


@pytest.mark.parametrize("size", SIZES)
def test_systems_are_solved_as_with_lapack(device, rng, tolerances, size):
    systems = symmetric(rng, [1, 2, 5, 10, 30, 100], 300)
    sides = rng.normal(size=(300, 6))
    solutions = solve(device, systems * size, sides * size)
    expected = np.linalg.solve(systems, sides[..., None])[..., 0]
    np.testing.assert_allclose(solutions, expected, atol=tolerances.solve_of_six)


def test_an_undetermined_unknown_stays_zero(device, rng, tolerances):
    systems, sides = symmetric(rng, [1, 2, 5, 10, 30, 100], 6), rng.normal(size=(6, 6))
    for k in range(6):
        systems[k, k] = systems[k, :, k] = 0.0
        sides[k, k] = 0.0
    solutions = solve(device, systems, sides)
    for k in range(6):
        rest = np.delete(np.arange(6), k)
        assert solutions[k, k] == 0
        expected = np.linalg.solve(systems[k][np.ix_(rest, rest)], sides[k, rest])
        np.testing.assert_allclose(solutions[k, rest], expected, atol=tolerances.solve_of_six)
    np.testing.assert_array_equal(solve(device, np.zeros((3, 6, 6)), np.ones((3, 6))), 0)


def test_an_unknown_with_a_pivot_of_rounding_error_stays_zero(device, rng, tolerances):
    """Five rows for six unknowns: what is left of the last pivot is noise of 1e-16, of either sign."""
    rotations = np.linalg.qr(rng.normal(size=(300, 5, 5)))[0]
    rows = rotations @ np.concatenate([np.tile(np.eye(5), (300, 1, 1)), 0.2 * rng.normal(size=(300, 5, 1))], axis=2)
    systems, sides = np.einsum("mki,mkj->mij", rows, rows), np.einsum("mki,mk->mi", rows, rng.normal(size=(300, 5)))
    solutions = solve(device, systems, sides)
    assert (solutions[:, 5] == 0).all()
    expected = np.linalg.solve(systems[:, :5, :5], sides[:, :5, None])[..., 0]
    np.testing.assert_allclose(solutions[:, :5], expected, atol=tolerances.solve_of_six)


def test_a_system_of_few_rows_gets_a_step_that_satisfies_it(device, rng, tolerances):
    """The rows of one or two pairs: the step is finite and has the residuals of least squares."""
    rows = rng.normal(size=(200, 2, 6))
    sides = np.einsum("mki,mk->mi", rows, rng.normal(size=(200, 2)))
    systems = np.einsum("mki,mkj->mij", rows, rows)
    solutions = solve(device, systems, sides)
    assert np.isfinite(solutions).all()
    np.testing.assert_allclose(np.einsum("mij,mj->mi", systems, solutions), sides, atol=1e-6)  # of pivots cut at 1e-15


VALUES = (
    *([1, 2], [3, 3, 3], [0, 1, 1e-12], [-1, 1, 2, 2], [0, 0, 0, 1], [1e-9, 1e-6, 1e-3, 1, 2], [1, 2, 3, 4, 5, 6]),
    *([0, 0, 0, 0, 0, 1], [1e-12, 1e-12, 1e-6, 1, 1, 1], [-3, -2, -1, 1, 2, 3]),
)


@pytest.mark.parametrize("values", VALUES)
@pytest.mark.parametrize("size", [1e-100, 1.0, 1e100])
def test_eigenvectors_match_lapack(device, rng, tolerances, values, size):
    matrices, n = symmetric(rng, values, 100), len(values)
    (eigenvalues, vectors), limit = eigen(device, matrices * size), tolerances.jacobi * np.abs(values).max()
    np.testing.assert_allclose(np.sort(eigenvalues, axis=1) / size, np.linalg.eigvalsh(matrices), atol=limit)
    np.testing.assert_allclose(vectors.transpose(0, 2, 1) @ vectors, np.tile(np.eye(n), (100, 1, 1)), atol=1e-13)
    rebuilt = np.einsum("mik,mk,mjk->mij", vectors, eigenvalues / size, vectors)
    np.testing.assert_allclose(rebuilt, matrices, atol=limit)


def test_diagonal_and_zero_matrices_have_the_axes(device):
    matrices = np.stack([np.zeros((6, 6)), np.eye(6), np.diag([6.0, 5, 4, 3, 2, 1])])
    values, vectors = eigen(device, matrices)
    np.testing.assert_array_equal(values, [np.zeros(6), np.ones(6), [6, 5, 4, 3, 2, 1]])
    np.testing.assert_array_equal(vectors, np.tile(np.eye(6), (3, 1, 1)))


@pytest.mark.parametrize("scaling", [False, True])
@pytest.mark.parametrize("shape", ["cloud", "flat", "three", "mirrored"])
def test_pairs_are_fitted_as_by_singular_values(device, rng, tolerances, shape, scaling):
    k = 3 if shape == "three" else 20
    sources = rng.normal(size=(100, k, 3)) * ([1, 1, 0] if shape == "flat" else [1, 1, 1])
    R = Rotation.random(100, rng).as_matrix()
    targets = sources @ R.transpose(0, 2, 1) * 1.3 + rng.normal(size=(100, 1, 3)) + 0.02 * rng.normal(size=(100, k, 3))
    targets = targets * ([1, 1, -1] if shape == "mirrored" else [1, 1, 1])
    weights = rng.uniform(0.1, 2, (100, k))
    result = fit(device, sources, targets, weights, scaling)
    given = zip(sources, targets, weights, strict=True)
    expected = [fit_by_svd(*pair, weights=w, with_scaling=scaling) for *pair, w in given]
    np.testing.assert_allclose(result, expected, atol=tolerances.pair_fit)
    assert (np.linalg.det(result[:, :3, :3]) > 0).all()


@pytest.mark.parametrize("k", [1, 2, 5])
def test_collinear_pairs_are_fitted_with_the_smallest_rotation(device, rng, k):
    """What a line leaves open, the turn about itself, is left as it is."""
    along, before = np.linspace(-1, 2, k)[:, None], np.array([1.0, 0, 0])
    after = np.array([np.cos(0.5), np.sin(0.5), 0])
    pose = fit(device, (along * before)[None], (along * after + [1, 2, 3])[None])[0]
    np.testing.assert_allclose(along * before @ pose[:3, :3].T + pose[:3, 3], along * after + [1, 2, 3], atol=1e-9)
    rotation = Rotation.from_matrix(pose[:3, :3]).as_rotvec()
    np.testing.assert_allclose(rotation, [0, 0, 0 if k == 1 else 0.5], atol=1e-5)


@pytest.mark.parametrize("side", ["targets", "sources"])
def test_pairs_that_share_a_point_are_not_rotated(device, rng, side):
    """Many sources of one target, as ICP has them far away: no rotation fits better than another."""
    sources, targets = rng.normal(size=(200, 4, 3)), np.repeat(rng.normal(size=(200, 1, 3)), 4, axis=1)
    poses = fit(device, *((sources, targets) if side == "targets" else (targets, sources)))
    np.testing.assert_allclose(poses[:, :3, :3], np.tile(np.eye(3), (200, 1, 1)), atol=1e-3)


def test_pairs_without_weight_leave_the_identity(device, rng):
    poses = fit(device, rng.normal(size=(4, 5, 3)), rng.normal(size=(4, 5, 3)), np.zeros((4, 5)))
    np.testing.assert_array_equal(poses, np.tile(np.eye(4), (4, 1, 1)))


def test_rotations_match_scipy(device, rng):
    steps, quaternions, points = rng.normal(size=(200, 6)), rng.normal(size=(200, 4)), rng.normal(size=(200, 3))
    motions, rotated, moved, directions = (zeros(200, t, device) for t in (mat44d, mat44d, vec3d, vec3d))
    given_arrays = [upload(steps, vec6d, device), upload(quaternions, float64, device), upload(points, vec3d, device)]
    launch(rotate_kernel, 200, [*given_arrays, motions, rotated, moved, directions])
    R = Rotation.from_euler("xyz", steps[:, :3]).as_matrix()
    np.testing.assert_allclose(motions.numpy()[:, :3, :3], R, atol=1e-14)
    np.testing.assert_array_equal(motions.numpy()[:, :3, 3], steps[:, 3:])
    np.testing.assert_array_equal(motions.numpy()[:, 3], np.tile([0, 0, 0, 1.0], (200, 1)))
    np.testing.assert_allclose(rotated.numpy()[:, :3, :3], Rotation.from_quat(quaternions).as_matrix(), atol=1e-14)
    np.testing.assert_allclose(directions.numpy(), np.einsum("mij,mj->mi", R, points), atol=1e-14)
    np.testing.assert_allclose(moved.numpy(), np.einsum("mij,mj->mi", R, points) + steps[:, 3:], atol=1e-14)
