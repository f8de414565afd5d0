"""Products, inverses and eigenvalues of small float64 matrices in a fixed order of operations.

BLAS and LAPACK select code by processor, so the last bits of their results vary. These functions take the arguments of
NumPy's functions of the same names and are bitwise reproducible across processors. Elimination and eigenvalues are
compiled kernels of one thread (`small_matrices.py`), on arrays that are kept for the next call.
"""

from __future__ import annotations

import contextlib
import functools
import math
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .launches import bind
from .memory import host_view
from .small_matrices import Eigenproblems, Systems, decompose_kernel, solve_systems_kernel

Array = NDArray[np.float64]
EPSILON = float(np.finfo(np.float64).eps)
MAX_KEPT = 128  # numbers of a matrix whose arrays are kept for the next call


def matmul(a: ArrayLike, b: ArrayLike, *others: Any) -> NDArray[Any]:
    """The product `a @ b @ ...` from left to right, with broadcasting. Up to 8 products in ascending order."""
    a, b = np.asarray(a), np.asarray(b)
    left = a if a.ndim > 1 else a[None]
    right = b if b.ndim > 1 else b[:, None]
    if left.shape[-1] != right.shape[-2]:
        raise ValueError(f"matmul: shapes {a.shape} and {b.shape} do not fit")
    count = left.shape[-1]
    with np.errstate(all="ignore"):  # as in BLAS and LAPACK
        if left.ndim == right.ndim == 2 and 0 < count < 8 and left.size <= 64:  # NumPy adds below 8 one by one
            product = np.add.reduce(left[:, :, None] * right, axis=1)
        elif 0 < count <= 8:
            product = left[..., :, :1] * right[..., :1, :]
            for j in range(1, count):
                product += left[..., :, j : j + 1] * right[..., j : j + 1, :]
        else:
            product = np.einsum("...ij,...jk->...ik", np.ascontiguousarray(left), np.ascontiguousarray(right))
    if b.ndim == 1:
        product = product[..., 0]
    if a.ndim == 1:
        product = product[..., 0] if b.ndim == 1 else product[..., 0, :]
    return matmul(product, *others) if others else product


def norm(values: ArrayLike) -> float:
    """Euclidean norm of all values. (`np.linalg.norm` with an axis has a fixed order already.)"""
    values = np.asarray(values, np.float64)
    if values.shape == (3,):  # NumPy adds so few one by one too, in three times the time
        x, y, z = values.tolist()
        return math.sqrt(x * x + y * y + z * z)
    with np.errstate(all="ignore"):  # as in BLAS and LAPACK
        return math.sqrt(float((values * values).sum()))


def elementwise(function: Callable[..., float], *arrays: Any) -> Array:
    """Apply a function of `math` to each element. NumPy's versions depend on the processor's vector units."""
    return np.asarray(np.frompyfunc(function, len(arrays), 1)(*arrays), np.float64)


def cube_root(value: float) -> float:
    """Real cube root by Newton's iteration, since libraries differ."""
    if value == 0 or not math.isfinite(value):
        return value
    fraction, exponent = math.frexp(abs(value))
    third = -(-exponent // 3)
    fraction = math.ldexp(fraction, exponent - 3 * third)  # 1/8 to 1
    root = (fraction + 2.0) / 3.0
    for _ in range(6):
        root -= (root - fraction / (root * root)) / 3.0
    return math.copysign(math.ldexp(root, third), value)


def det(A: ArrayLike) -> Any:
    """Determinant of 3x3 matrices, shape (..., 3, 3)."""
    A = np.asarray(A, np.float64)
    if A.shape == (3, 3):
        (a0, a1, a2), (b0, b1, b2), (c0, c1, c2) = A.tolist()  # a tenth of the time of NumPy's scalars
        return a0 * (b1 * c2 - b2 * c1) + a1 * (b2 * c0 - b0 * c2) + a2 * (b0 * c1 - b1 * c0)
    a, b, c = A[..., 0, :], A[..., 1, :], A[..., 2, :]
    x = b[..., 1] * c[..., 2] - b[..., 2] * c[..., 1]
    y = b[..., 2] * c[..., 0] - b[..., 0] * c[..., 2]
    z = b[..., 0] * c[..., 1] - b[..., 1] * c[..., 0]
    return a[..., 0] * x + a[..., 1] * y + a[..., 2] * z


class _Systems:
    """Arrays of systems [A, X], shape (b, n, n + k), and their elimination."""

    def __init__(self, *shape: int) -> None:
        p = Systems(shape)
        self.run = bind(solve_systems_kernel, [p])
        self.systems, self.failed = host_view(p.systems), host_view(p.failed)


class _Decompositions:
    """Arrays of symmetric matrices, shape (b, n, n), and their decomposition."""

    def __init__(self, count: int, n: int) -> None:
        p = Eigenproblems(count, n)
        self.run = bind(decompose_kernel, [p])
        self.matrices, self.lapack, self.rows = (host_view(a) for a in (p.matrices, p.lapack, p.rows))
        self.values, self.failed = host_view(p.values), host_view(p.failed)


# Idle ones by shape: their allocation would take longer than a small kernel. A second thread, or a signal handler that
# calls in between, gets others.
_systems: dict[tuple[int, ...], list[_Systems]] = {}
_decompositions: dict[tuple[int, ...], list[_Decompositions]] = {}


def solve(A: ArrayLike, b: ArrayLike) -> Array:
    """Solve A X = b for b of shape (..., n, k) or (n) by elimination with pivoting. Raises LinAlgError if singular."""
    A, b = np.asarray(A, np.float64), np.asarray(b, np.float64)
    if b.ndim == 1:
        return solve(A, b[:, None])[:, 0]
    n, shape = A.shape[-1], ()
    if A.ndim > 2 or b.ndim > 2:
        shape = np.broadcast_shapes(A.shape[:-2], b.shape[:-2])
    sizes = (math.prod(shape), n, n + b.shape[-1])
    try:
        arrays = _systems[sizes].pop()
    except (KeyError, IndexError):
        arrays = _Systems(*sizes)
    systems = arrays.systems.reshape(*shape, n, n + b.shape[-1])
    systems[..., :n], systems[..., n:] = A, b
    arrays.run()
    is_singular, solution = arrays.failed[0], systems[..., n:].copy()
    if systems.size <= MAX_KEPT:
        _systems.setdefault(sizes, []).append(arrays)
    if is_singular:
        raise np.linalg.LinAlgError("Singular matrix")
    return solution


def inv(A: ArrayLike) -> Array:
    """Inverse of matrices of shape (..., n, n). Raises LinAlgError if singular."""
    A = np.asarray(A, np.float64)
    return solve(A, _identity(A.shape[-1]))


@functools.lru_cache(maxsize=16)
def _identity(n: int) -> Array:
    return np.eye(n)


def eigh(A: ArrayLike) -> tuple[Array, Array]:
    """Eigenvalues in ascending order and eigenvectors as columns of symmetric matrices, shape (..., n, n). Householder
    reflections and implicit QL (Golub and Van Loan, Matrix Computations, 2013, section 8.3). Signs are LAPACK's. For a
    repeated eigenvalue the largest entry is positive.
    """
    A = np.asarray(A, np.float64)
    if not A.size:
        return np.zeros(A.shape[:-1]), np.zeros(A.shape)
    sizes = (A.size // A.shape[-1] ** 2, A.shape[-1])
    try:
        arrays = _decompositions[sizes].pop()
    except (KeyError, IndexError):
        arrays = _Decompositions(*sizes)
    arrays.matrices.reshape(A.shape)[:] = A
    with contextlib.suppress(np.linalg.LinAlgError):  # of entries that are not finite
        arrays.lapack.reshape(A.shape)[:] = np.linalg.eigh(A)[1]
    arrays.run()
    failed, values = arrays.failed[0], arrays.values.reshape(A.shape[:-1]).copy()
    vectors = arrays.rows.reshape(A.shape).swapaxes(-2, -1).copy("K")
    if A.size <= MAX_KEPT:
        _decompositions.setdefault(sizes, []).append(arrays)
    if failed:
        problem = "of a matrix with entries that are not finite" if failed < 0 else "did not converge"
        raise np.linalg.LinAlgError(f"Eigenvalues {problem}")
    return values, vectors


def eigvalsh(A: ArrayLike) -> Array:
    return eigh(A)[0]


def is_positive_definite(A: ArrayLike) -> bool:
    """True if symmetric elimination of a matrix (n, n) finds positive pivots alone. An eighth of the time of `eigh`."""
    rows = np.asarray(A, np.float64).tolist()
    for k, row in enumerate(rows):
        pivot = row[k]
        if not pivot > 0:
            return False
        for below in rows[k + 1 :]:
            factor = below[k]
            for j in range(k + 1, len(rows)):
                below[j] -= factor * row[j] / pivot
    return True


def pinvh(A: Array, rcond: float) -> Array:
    """Pseudoinverse of a symmetric matrix. Eigenvalues up to `rcond` times the largest magnitude count as zero."""
    values, vectors = eigh(A)
    sizes = np.abs(values)
    is_nonzero = sizes > rcond * sizes.max(initial=0.0)
    inverses = np.divide(1.0, values, out=np.zeros_like(values), where=is_nonzero)
    return matmul(vectors * inverses, vectors.T)
