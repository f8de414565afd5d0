"""Factors of sparse symmetric matrices solve what SuperLU solves."""

import numpy as np
import pytest
import scipy.sparse as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from pointloom.kernels.arrays.sparse_factor import SparseFactor, solve_symmetric


def sparse_system(n, seed, density=0.2):
    rng = np.random.default_rng(seed)
    part = sp.random(n, n, density=density, random_state=rng)
    system = part + part.T
    return (system + sp.diags(np.asarray(abs(system).sum(axis=1)).ravel() + rng.uniform(0.5, 2, n))).tocsc()


@settings(deadline=None)
@given(st.integers(1, 40), st.integers(0, 2**32 - 1))
def test_solutions_are_those_of_a_dense_system(n, seed):
    A, right = sparse_system(n, seed), np.random.default_rng(seed).normal(size=(n, 3))
    factor = SparseFactor(A.indptr, A.indices)
    factor.factor(A.data)
    np.testing.assert_allclose(factor.solve(right), np.linalg.solve(A.toarray(), right), rtol=0, atol=1e-12)
    np.testing.assert_array_equal(factor.solve(right[:, 1]), factor.solve(right)[:, 1])


def test_a_pattern_serves_other_numbers():
    A = sparse_system(30, 1)
    factor = SparseFactor(A.indptr, A.indices)
    factor.factor(A.data)
    factor.factor(2 * A.data)
    np.testing.assert_allclose(2 * A @ factor.solve(np.arange(30.0)), np.arange(30.0), atol=1e-12)


def test_indefinite_systems_are_solved():
    A = sp.csc_matrix(np.array([[1.0, 2.0, 0.0], [2.0, 1.0, 0.5], [0.0, 0.5, -3.0]]))
    factor = SparseFactor(A.indptr, A.indices)
    factor.factor(A.data)
    np.testing.assert_allclose(A @ factor.solve(np.ones(3)), np.ones(3), atol=1e-14)


def test_dense_systems_are_solved_alike():
    A, right = sparse_system(25, 2).toarray(), np.arange(50.0).reshape(25, 2)
    np.testing.assert_allclose(A @ solve_symmetric(A, right), right, atol=1e-12)


@pytest.mark.parametrize("matrix", [[[0.0]], [[1.0, 1.0], [1.0, 1.0]]])
def test_a_singular_matrix_is_refused(matrix):
    A = np.array(matrix)
    rows = np.tile(np.arange(len(A)), len(A))
    factor = SparseFactor(np.arange(0, A.size + 1, len(A)), rows)
    with pytest.raises(RuntimeError, match="singular"):
        factor.factor(A.ravel())


def test_a_system_without_unknowns_has_no_solution_to_give():
    factor = SparseFactor(np.zeros(1, np.int32), np.zeros(0, np.int32))
    factor.factor(np.zeros(0))
    assert factor.solve(np.zeros(0)).shape == (0,)
