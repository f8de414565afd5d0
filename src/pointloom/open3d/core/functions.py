"""Functions of tensors."""

from __future__ import annotations

from .tensor import Tensor, concatenate  # noqa: F401  handed on


def addmm(input: Tensor, A: Tensor, B: Tensor, alpha: float, beta: float) -> Tensor:
    """beta * input + alpha * A @ B."""
    product = alpha * (A @ B)
    return product + beta * input


append, det, inv, lstsq, lu, lu_ipiv = Tensor.append, Tensor.det, Tensor.inv, Tensor.lstsq, Tensor.lu, Tensor.lu_ipiv
matmul, maximum, minimum, solve, svd = Tensor.matmul, Tensor.maximum, Tensor.minimum, Tensor.solve, Tensor.svd
tril, triu, triul = Tensor.tril, Tensor.triu, Tensor.triul
