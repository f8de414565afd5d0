"""Methods of tensors as functions."""

from __future__ import annotations

from .tensor import Tensor

append, maximum, minimum = Tensor.append, Tensor.maximum, Tensor.minimum
det, inv, lstsq, matmul, solve, svd = Tensor.det, Tensor.inv, Tensor.lstsq, Tensor.matmul, Tensor.solve, Tensor.svd
