"""Clouds of pointloom from tensors, and tensors from them."""

from __future__ import annotations

from typing import Any

import numpy as np

from ....pcd.cloud import PointCloud
from ...core.dtype import Dtype, bool8, float32, float64, int64, uint16
from ...core.tensor import Tensor
from .tensor_map import TensorMap, wrap


def native_of(point: TensorMap, *names: str, **others: Any) -> PointCloud:
    """A cloud with the positions, those of the named attributes that there are, and other arrays."""
    given = {name: point[name] for name in names if name in point}
    if "colors" in given and given["colors"].dtype == uint16:
        given["colors"] = given["colors"].to(float32) / 65535.0
    return PointCloud(point.positions._array, **{name: tensor._array for name, tensor in given.items()}, **others)


def attribute(cloud: PointCloud, name: str) -> Tensor:
    """An attribute of a result as a tensor; points about the cloud's origin."""
    return wrap(cloud._handed_out(cloud._device_array(name)))


def positions_of(cloud: PointCloud, dtype: Dtype) -> Tensor:
    """The points of a result of a type."""
    points = attribute(cloud, "points")
    if cloud.origin.any():
        points = points.to(float64) + Tensor(cloud.origin, float64, points.device)
    return points.to(dtype)


def rows_kept(positions: Tensor, method: str, *args: Any) -> Tensor:
    """Rows of the positions that a method of a cloud keeps, int64."""
    rows = np.arange(positions.shape[0], dtype=np.int32)
    return attribute(getattr(PointCloud(positions._array, row=rows), method)(*args), "row").to(int64)


def mask_of(rows: Tensor, count: int) -> Tensor:
    """True at some rows, shape (count,)."""
    mask = Tensor(np.zeros(count, bool), bool8, rows.device)
    mask[rows] = True
    return mask
