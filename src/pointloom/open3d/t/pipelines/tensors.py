"""Tensors as arguments and results of the pipelines."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.device import Device
from ...core.dtype import Dtype, float64
from ...core.tensor import Tensor
from ..geometry.tensors import host_of


def on_host(value: object) -> NDArray[Any]:
    """The values of a tensor or of an array on any device, as a NumPy array."""
    return np.asarray(host_of(value))


def tensor_of(values: object, dtype: Dtype, device: Device | None = None) -> Tensor:
    """A tensor of this type, on the CPU by default."""
    return Tensor(on_host(values), dtype, device)


def as_matrix(value: object) -> Tensor:
    """A float64 tensor on the CPU, as Open3D's results are, from a tensor or an array."""
    return tensor_of(value, float64)
