"""Clouds of pointloom from tensors, and tensors from them, on the device of the tensors."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import warp as wp

from ....core.array_libraries import view_as
from ....core.gpu_arrays import take_indices
from ....kernels.arrays.subsets import mark_rows_kernel
from ....kernels.lang import launch, uint8
from ....kernels.language.device_lock import lock_for
from ....kernels.memory import cast, zeros
from ....pcd.cloud import PointCloud
from ...argument_types import DeviceArray
from ...core.dtype import Dtype, float32, float64, uint16
from ...core.tensor import Tensor
from .tensor_map import TensorMap, count_of, wrap


def native_of(point: TensorMap, *names: str) -> PointCloud:
    """A cloud with the positions and the named attributes, if present, each as columns."""
    given = {name: point[name] for name in names if name in point}
    if "colors" in given and given["colors"].dtype == uint16:
        given["colors"] = given["colors"].to(float32) / 65535.0
    return PointCloud(point.positions.array, **{name: columns_of(tensor).array for name, tensor in given.items()})


def attribute(cloud: PointCloud, name: str, dtype: Dtype | None = None) -> Tensor:
    """An attribute of a result as a tensor, of a type if given. Points are about the cloud's origin."""
    tensor = wrap(cloud.arrays.hand_out(cloud.arrays[name]))
    return tensor if dtype is None else converted(tensor, dtype)


def positions_of(cloud: PointCloud, dtype: Dtype) -> Tensor:
    """The points of a result, of a type."""
    if not cloud.origin.any():
        return attribute(cloud, "points", dtype)
    points = attribute(cloud, "points", float64)
    return converted(points + Tensor(cloud.origin, float64, points.device), dtype)


def converted(tensor: Tensor, dtype: Dtype) -> Tensor:
    """A tensor with another type, on its device."""
    if tensor.dtype == dtype or tensor.device.name == "cpu":
        return tensor.to(dtype)
    return wrap(cast(tensor.array, wp.dtype_from_numpy(dtype.numpy)))


def select(point: TensorMap, method: str, *args: Any) -> tuple[TensorMap, Tensor]:
    """The points that a method of a cloud keeps, with all attributes, and their rows, int32."""
    columns = {f"_{name}": columns_of(tensor).array for name, tensor in point.items()}
    rows = np.arange(count_of(point), dtype=np.int32)
    result = getattr(PointCloud(point.positions.array, rows=rows, **columns), method)(*args)
    kept = result[0] if isinstance(result, tuple) else result
    return rows_of(kept, point), attribute(kept, "rows")


def rows_of(kept: PointCloud, point: TensorMap) -> TensorMap:
    """The columns of a result in the types and shapes of the tensors that they come from."""
    return TensorMap(
        point.primary_key,
        {
            name: attribute(kept, f"_{name}", tensor.dtype).reshape((len(kept), *tensor.shape[1:]))
            for name, tensor in point.items()
        },
    )


def columns_of(tensor: Tensor, dtype: Dtype | None = None) -> Tensor:
    """An attribute as columns (n, c)."""
    columns = tensor.reshape((tensor.shape[0], math.prod(tensor.shape[1:])))
    return columns if dtype is None else converted(columns, dtype)


def mask_of(rows: Tensor, count: int) -> Tensor:
    """True at some rows, shape (count,)."""
    if rows.device.name == "cpu":
        mask = np.zeros(count, bool)
        mask[rows.numpy()] = True
        return Tensor.from_numpy(mask)
    device = rows.array.device
    numbers = take_indices("indices", rows.array, device, count, of=f"cloud of {count} points")
    flags = zeros(count, uint8, device)
    launch(mark_rows_kernel, numbers.size, [numbers, flags])
    return wrap(view_as(flags, wp.bool, (count,)))


def write(tensor: Tensor, values: DeviceArray) -> None:
    """Write an array into the memory of a tensor."""
    source = converted(wrap(values), tensor.dtype)
    if tensor.device.name == "cpu":
        tensor.array[...] = source.array
        return
    with lock_for(tensor.array.device):
        wp.copy(tensor.array, source.array)
