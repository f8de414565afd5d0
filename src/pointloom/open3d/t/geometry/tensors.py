"""Tensors as arguments and results of pointloom's functions."""

from __future__ import annotations

from typing import Any

import numpy as np
import warp as wp
from numpy.typing import DTypeLike

from ....core.checks import is_on_gpu
from ....core.gpu_arrays import take_numbers
from ....kernels.memory import cast, clone, download
from ...argument_types import DeviceArray
from ...core.tensor import Tensor


def values_of(value: object) -> Any:
    """The array of a tensor on its device. Other values are returned unchanged."""
    return value.array if isinstance(value, Tensor) else value


def host_of(value: object) -> Any:
    """The NumPy array of a tensor or of an array on a GPU. Other values are returned unchanged."""
    if isinstance(value, Tensor):
        return value.numpy()
    return download(take_numbers("values", value)) if is_on_gpu(value) else value


def new_tensor(array: DeviceArray, dtype: DTypeLike | None = None, shape: tuple[int, ...] | None = None) -> Tensor:
    """Copy an array of NumPy or Warp into a tensor, with another type or shape if given."""
    if is_on_gpu(array):
        numbers = take_numbers("array", array)
        kind = numbers.dtype if dtype is None else wp.dtype_from_numpy(np.dtype(dtype))
        made: Any = clone(numbers) if numbers.dtype == kind else cast(numbers, kind)
    else:
        made = np.array(array if isinstance(array, np.ndarray) else download(array), dtype)
    return Tensor.from_array(made if shape is None else made.reshape(shape))
