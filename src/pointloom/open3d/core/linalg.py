"""Linear algebra and concatenation of tensors, over NumPy arrays."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import scipy.linalg
from numpy.typing import NDArray

from .errors import TensorError

Matrix = NDArray[Any]


def _matrix(name: str, a: Matrix, *, is_square: bool = False, floats: bool = True) -> Matrix:
    if a.ndim != 2 or (is_square and a.shape[0] != a.shape[1]) or not a.size:
        kind = "a square matrix" if is_square else "a matrix (n, m)"
        raise TensorError(f"{name}: expected {kind} with at least one element, got shape {list(a.shape)}")
    if floats and a.dtype.kind != "f":
        raise TensorError(f"{name}: expected Float32 or Float64, got {a.dtype}; tensor.to(dtype) converts it")
    return a


def _solution(function: Callable[..., Any], *matrices: Matrix) -> Any:
    try:
        return function(*matrices)
    except np.linalg.LinAlgError as error:
        raise TensorError(f"self: expected a matrix of full rank, got a singular one ({error})") from error


def _right_side(a: Matrix, b: Matrix) -> Matrix:
    if b.ndim not in (1, 2) or len(b) != len(a) or b.dtype != a.dtype or not b.size:
        raise TensorError(f"B: expected shape ({len(a)},) or ({len(a)}, k) of {a.dtype}, got {b.shape} of {b.dtype}")
    return b


def matmul(a: Matrix, b: Matrix) -> Matrix:
    """a @ b. A vector b is a column, as in Open3D: the result has shape (n, 1)."""
    _matrix("self", a, floats=False)
    column = b[:, None] if b.ndim == 1 else b
    if column.ndim != 2 or len(column) != a.shape[1] or not b.size or b.dtype != a.dtype:
        wanted = f"shape ({a.shape[1]}, k) of {a.dtype}"
        raise TensorError(f"other: expected {wanted}, got {list(b.shape)} of {b.dtype}")
    return a @ column


def det(a: Matrix) -> float:
    return float(scipy.linalg.det(_matrix("self", a, is_square=True)))


def inv(a: Matrix) -> Matrix:
    return _solution(np.linalg.inv, _matrix("self", a, is_square=True))


def solve(a: Matrix, B: Matrix) -> Matrix:
    return _solution(np.linalg.solve, _matrix("self", a, is_square=True), _right_side(a, B))


def lstsq(a: Matrix, B: Matrix) -> Matrix:
    if _matrix("self", a).shape[0] < a.shape[1]:
        raise TensorError(f"self: expected at least as many rows as columns, got shape {list(a.shape)}")
    return np.linalg.lstsq(a, _right_side(a, B), rcond=None)[0]


def svd(a: Matrix) -> tuple[Matrix, ...]:
    """U (n, n), S (min(n, m),) and the transposed V (m, m)."""
    return tuple(np.linalg.svd(_matrix("self", a)))


def concatenate(arrays: Sequence[Matrix], axis: int | None = 0) -> Matrix:
    """Arrays one after another. A single array is split along its first axis. Axis None joins flat arrays."""
    types = [array.dtype for array in arrays]
    if len(set(types)) > 1:
        raise TensorError(f"tensors: expected one dtype, got {', '.join(map(str, types))}; tensor.to(dtype) converts")
    parts = list(arrays[0]) if len(arrays) == 1 else arrays
    return np.concatenate([np.asarray(part) for part in parts], axis=axis)
