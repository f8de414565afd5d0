"""Device memory: Warp owns it on every device; these few functions are all that host code needs."""

from __future__ import annotations

from typing import Any

import numpy as np
import warp as wp
from numpy.typing import NDArray


def empty(shape: int | tuple[int, ...], dtype: Any, device: Any) -> wp.array:
    """An array with undefined contents."""
    return wp.empty(shape, dtype=dtype, device=device)


def zeros(shape: int | tuple[int, ...], dtype: Any, device: Any) -> wp.array:
    """An array of zeros."""
    return wp.zeros(shape, dtype=dtype, device=device)


def full(shape: int | tuple[int, ...], value: Any, dtype: Any, device: Any) -> wp.array:
    """An array of one value."""
    return wp.full(shape, value, dtype=dtype, device=device)


def upload(values: np.ndarray, dtype: Any, device: Any) -> wp.array:
    """A copy of a NumPy array on a device, as an array of `dtype` (vectors take the last axis)."""
    scalar = wp.dtype_to_numpy(getattr(dtype, "_wp_scalar_type_", dtype))
    values = np.ascontiguousarray(values, dtype=scalar)
    if values.size == 0:
        width = len(getattr(dtype, "_shape_", ()))
        shape = values.shape[: values.ndim - width] if width else values.shape
        return wp.empty(shape, dtype=dtype, device=device)
    return wp.array(values, dtype=dtype, device=device, copy=True)


def copy(target: wp.array, source: wp.array, *, count: int, offset: int = 0) -> None:
    """Copy the first `count` elements of one array to another on the same device, from element `offset` on."""
    if count:
        wp.copy(target, source, dest_offset=offset, count=count)


def cast(values: wp.array, dtype: Any) -> wp.array:
    """The array with its elements converted to another type, on its device."""
    out = wp.empty(values.shape, dtype=dtype, device=values.device)
    if values.size:
        wp.utils.array_cast(values, out)
    return out


def move(values: wp.array, device: Any) -> wp.array:
    """The array on another device; itself where it is there already."""
    moved: wp.array = values.to(device)  # type: ignore[assignment]
    return moved


def download(values: wp.array) -> NDArray[Any]:
    """The array as NumPy: a copy from a GPU (sync), a view on the CPU; treat it as read-only."""
    return values.numpy()
