"""Products, inverses and eigenvalues of small float64 matrices in a fixed order of operations.

BLAS and LAPACK select code by processor, so the last bits of their results vary. These functions take the arguments of
NumPy's functions of the same names and are bitwise reproducible across processors.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
EPSILON = float(np.finfo(np.float64).eps)
SHORT = 8  # products of a sum that are added one by one
NEGLIGIBLE = 1e-30  # off-diagonal entry, relative to the largest entry
MAX_STEPS = 60  # per eigenvalue. Two or three are usual
SEPARATED = 1e-6  # relative difference above which eigenvalues have individual eigenvectors


@np.errstate(all="ignore")  # as in BLAS and LAPACK
def matmul(a: Any, b: Any, *others: Any) -> NDArray[Any]:
    """The product `a @ b @ ...` from left to right, with broadcasting. Up to `SHORT` products in ascending order."""
    a, b = np.asarray(a), np.asarray(b)
    left = a if a.ndim > 1 else a[None]
    right = b if b.ndim > 1 else b[:, None]
    if left.shape[-1] != right.shape[-2]:
        raise ValueError(f"matmul: shapes {a.shape} and {b.shape} do not fit")
    if 0 < left.shape[-1] <= SHORT:
        product = left[..., :, :1] * right[..., :1, :]
        for j in range(1, left.shape[-1]):
            product += left[..., :, j : j + 1] * right[..., j : j + 1, :]
    else:
        product = np.einsum("...ij,...jk->...ik", np.ascontiguousarray(left), np.ascontiguousarray(right))
    if b.ndim == 1:
        product = product[..., 0]
    if a.ndim == 1:
        product = product[..., 0] if b.ndim == 1 else product[..., 0, :]
    return matmul(product, *others) if others else product


@np.errstate(all="ignore")  # as in BLAS and LAPACK
def norm(values: Any) -> float:
    """Euclidean norm of all values. (`np.linalg.norm` with an axis has a fixed order already.)"""
    values = np.asarray(values, np.float64)
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


def det(A: Any) -> Any:
    """Determinant of 3x3 matrices, shape (..., 3, 3)."""
    A = np.asarray(A, np.float64)
    a, b, c = A[..., 0, :], A[..., 1, :], A[..., 2, :]
    x = b[..., 1] * c[..., 2] - b[..., 2] * c[..., 1]
    y = b[..., 2] * c[..., 0] - b[..., 0] * c[..., 2]
    z = b[..., 0] * c[..., 1] - b[..., 1] * c[..., 0]
    return a[..., 0] * x + a[..., 1] * y + a[..., 2] * z


@np.errstate(all="ignore")  # as in BLAS and LAPACK
def solve(A: Any, b: Any) -> Array:
    """Solve A X = b for b of shape (..., n, k) or (n) by elimination with pivoting. Raises LinAlgError if singular."""
    A, b = np.asarray(A, np.float64), np.asarray(b, np.float64)
    if b.ndim == 1:
        return solve(A, b[:, None])[:, 0]
    n, shape = A.shape[-1], np.broadcast_shapes(A.shape[:-2], b.shape[:-2])
    left = np.broadcast_to(A, (*shape, *A.shape[-2:])).reshape(-1, n, n)
    right = np.broadcast_to(b, (*shape, *b.shape[-2:])).reshape(-1, *b.shape[-2:])
    M, every = np.concatenate([left, right], axis=2), np.arange(len(left))
    for k in range(n):
        best = k + np.abs(M[:, k:, k]).argmax(axis=1)
        pivot_rows = M[every, best]
        M[every, best] = M[:, k]
        if not pivot_rows[:, k].all():
            raise np.linalg.LinAlgError("Singular matrix")
        M[:, k] = pivot_rows
        factors = M[:, k + 1 :, k] / pivot_rows[:, k, None]
        M[:, k + 1 :, k:] -= factors[:, :, None] * pivot_rows[:, None, k:]
    for k in reversed(range(n)):
        M[:, k, n:] /= M[:, k, k, None]
        M[:, :k, n:] -= M[:, :k, k, None] * M[:, k, None, n:]
    return np.ascontiguousarray(M[:, :, n:]).reshape(*shape, *b.shape[-2:])


def inv(A: Any) -> Array:
    """Inverse of matrices of shape (..., n, n). Raises LinAlgError if singular."""
    return solve(A, np.eye(np.shape(A)[-1]))


def eigh(A: Any) -> tuple[Array, Array]:
    """Eigenvalues in ascending order and eigenvectors as columns of symmetric matrices, shape (..., n, n). Householder
    reflections and implicit QL (Golub and Van Loan, Matrix Computations, 2013, section 8.3). Signs are LAPACK's. For a
    repeated eigenvalue the largest entry is positive.
    """
    A = np.asarray(A, np.float64)
    if A.ndim > 2:
        decompositions = [eigh(one) for one in A.reshape(-1, *A.shape[-2:])]
        values, vectors = np.array([one[0] for one in decompositions]), np.array([one[1] for one in decompositions])
        return values.reshape(A.shape[:-1]), vectors.reshape(A.shape)
    n, size = len(A), float(np.abs(A).max(initial=0.0))
    if not np.isfinite(size):
        raise np.linalg.LinAlgError("Eigenvalues of a matrix with entries that are not finite")
    if size == 0:
        return np.zeros(n), np.eye(n)
    diagonal, beside, rows = _tridiagonal(A / size)
    _diagonalize(diagonal, beside, rows)
    values = np.array(diagonal)
    order = np.argsort(values, kind="stable")
    return values[order] * size, _with_signs(A, values[order], rows[order].T)


def eigvalsh(A: Any) -> Array:
    return eigh(A)[0]


def is_positive_definite(A: Any) -> bool:
    """True if symmetric elimination of a matrix (n, n) finds positive pivots alone. An eighth of the time of `eigh`."""
    A = np.array(A, np.float64)
    for k in range(len(A)):
        if not A[k, k] > 0:
            return False
        A[k + 1 :, k + 1 :] -= A[k + 1 :, k, None] * A[k, k + 1 :] / A[k, k]
    return True


def pinvh(A: Array, rcond: float) -> Array:
    """Pseudoinverse of a symmetric matrix. Eigenvalues up to `rcond` times the largest magnitude count as zero."""
    values, vectors = eigh(A)
    sizes = np.abs(values)
    is_nonzero = sizes > rcond * sizes.max(initial=0.0)
    inverses = np.divide(1.0, values, out=np.zeros_like(values), where=is_nonzero)
    return matmul(vectors * inverses, vectors.T)


def _tridiagonal(A: Array) -> tuple[list[float], list[float], Array]:
    """Diagonal and off-diagonal of Q^T A Q, and the rows of Q^T."""
    A, n = A.copy(), len(A)
    rows = np.eye(n)
    for k in range(n - 2):
        v = A[k + 1 :, k].copy()
        length = norm(v)
        if not length > abs(v[0]):  # already zero below the subdiagonal
            continue
        v[0] += math.copysign(length, v[0])
        v /= norm(v)
        A[k + 1 :, k:] -= 2 * v[:, None] * (v[:, None] * A[k + 1 :, k:]).sum(axis=0)
        A[k:, k + 1 :] -= 2 * (A[k:, k + 1 :] * v).sum(axis=1)[:, None] * v
        rows[k + 1 :] -= 2 * v[:, None] * (v[:, None] * rows[k + 1 :]).sum(axis=0)
    return np.diag(A).tolist(), [*np.diag(A, -1).tolist(), 0.0], rows


def _diagonalize(d: list[float], e: list[float], rows: Array) -> None:
    """Diagonalize a tridiagonal matrix by rotations, applied to the rows too."""
    n = len(d)
    for first in range(n):
        for _ in range(MAX_STEPS):
            last = first
            while last < n - 1 and abs(e[last]) > max(EPSILON * (abs(d[last]) + abs(d[last + 1])), NEGLIGIBLE):
                last += 1
            if last == first:
                break
            _shifted_step(d, e, rows, first, last)
        else:
            raise np.linalg.LinAlgError("Eigenvalues did not converge")


def _shifted_step(d: list[float], e: list[float], rows: Array, first: int, last: int) -> None:
    """One implicit QL step with Wilkinson's shift on the rows from `first` to `last`."""
    g = (d[first + 1] - d[first]) / (2 * e[first])
    g = d[last] - d[first] + e[first] / (g + math.copysign(math.sqrt(g * g + 1), g))
    sine, cosine, shift = 1.0, 1.0, 0.0
    for i in range(last - 1, first - 1, -1):
        f, b = sine * e[i], cosine * e[i]
        r = math.sqrt(f * f + g * g)
        e[i + 1] = r
        if r == 0.0:
            d[i + 1] -= shift
            e[last] = 0.0
            return
        sine, cosine = f / r, g / r
        g = d[i + 1] - shift
        r = (d[i] - g) * sine + 2 * cosine * b
        shift = sine * r
        d[i + 1] = g + shift
        g = cosine * r - b
        below, above = rows[i + 1].copy(), rows[i].copy()
        rows[i + 1], rows[i] = sine * above + cosine * below, cosine * above - sine * below
    d[first] -= shift
    e[first], e[last] = g, 0.0


def _with_signs(A: Array, values: Array, vectors: Array) -> Array:
    """The eigenvectors with LAPACK's signs, for compatibility with stored files."""
    gaps = np.diff(values, prepend=-np.inf, append=np.inf)
    single = np.minimum(gaps[:-1], gaps[1:]) > SEPARATED * np.abs(values).max()
    along = (vectors * np.linalg.eigh(A)[1]).sum(axis=0)  # 1 or -1 for a simple eigenvalue, up to rounding
    largest = vectors[np.abs(vectors).argmax(axis=0), np.arange(len(values))]
    return vectors * np.where(np.where(single, along, largest) < 0, -1.0, 1.0)
