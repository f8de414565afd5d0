"""Functions of tensors."""

from __future__ import annotations

from typing import Any

from .tensor import Tensor, concatenate  # noqa: F401  handed on


def addmm(input: Tensor, A: Tensor, B: Tensor, alpha: float, beta: float) -> Tensor:
    """beta * input + alpha * A @ B."""
    product = alpha * (A @ B)
    return product + beta * input


_methods: Any = Tensor
append, det, inv, lstsq, lu, lu_ipiv = (
    _methods.append,
    _methods.det,
    _methods.inv,
    _methods.lstsq,
    _methods.lu,
    _methods.lu_ipiv,
)
matmul, maximum, minimum, solve, svd = _methods.matmul, _methods.maximum, _methods.minimum, _methods.solve, _methods.svd
tril, triu, triul = _methods.tril, _methods.triu, _methods.triul
