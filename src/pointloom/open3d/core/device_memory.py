"""Warp arrays under tensors on a GPU: copies to and from the host, and views by NumPy's rules for keys."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ...core.array_libraries import view_as
from ...core.devices import resolve_device
from ...core.exchange import share
from ...kernels.language.device_lock import lock, lock_for
from ...kernels.memory import contiguous, download, empty, host_view, upload
from .errors import TensorError

MAX_AXES = 4  # of a Warp array


class _Address:
    """An array interface of device memory. NumPy computes views of it and must not read it."""

    def __init__(self, array: wp.array, shape: tuple[int, ...]):
        strides = array.strides if shape else ()
        typestr = wp.dtype_to_numpy(array.dtype)
        self.__array_interface__ = {
            "data": (array.ptr or 1, False),
            "shape": shape,
            "strides": tuple(strides),
            "typestr": np.dtype(typestr).str,
            "version": 3,
        }


def wrapped(array: wp.array) -> Any:
    """A Warp array on the CPU as NumPy, one on a GPU with scalars as elements. Both share the memory."""
    return host_view(array) if array.device.is_cpu else as_scalars(array)


def shared(source: Any) -> Any:
    """The memory of a DLPack capsule, or of an array of another library, as a Warp array or NumPy's."""
    if not hasattr(source, "__dlpack__"):
        with lock:
            return wp.from_dlpack(source)
    shape = tuple(getattr(source, "shape", (1,)))
    if 0 < len(shape) <= MAX_AXES and 0 not in shape:
        return share("source", source)
    return np.from_dlpack(source)  # a shape that Warp does not have


def numpy_dtype(array: wp.array) -> np.dtype[Any]:
    return np.dtype(wp.dtype_to_numpy(array.dtype))


def as_scalars(array: wp.array) -> Any:
    """The array with scalars as elements: vectors become a last axis."""
    scalar = getattr(array.dtype, "_wp_scalar_type_", array.dtype)
    if scalar is array.dtype:
        return array
    return view_as(contiguous(array), scalar, (*array.shape, *array.dtype._shape_))


def to_device(values: NDArray[Any], device: str) -> Any:
    """A copy on a device. A number becomes an array of one element."""
    if values.ndim > MAX_AXES:
        raise TensorError(f"device: expected at most {MAX_AXES} axes on a GPU, got {values.ndim}")
    return upload(np.atleast_1d(values), wp.dtype_from_numpy(values.dtype), resolve_device(device))


def to_host(array: wp.array, shape: tuple[int, ...]) -> NDArray[Any]:
    """A writable copy."""
    return np.array(download(contiguous(array))).reshape(shape)


def view(array: wp.array, shape: tuple[int, ...], change: Callable[[NDArray[Any]], Any]) -> tuple[Any, tuple[int, ...]]:
    """A view of a device array and its shape. `change` computes a view of a NumPy array and reads no element."""
    seen = change(np.asarray(_Address(array, shape)))
    if seen.size == 0:
        return empty(seen.shape or (0,), array.dtype, array.device), seen.shape
    address = seen.__array_interface__["data"][0]
    made: Any = wp.array(
        ptr=address,
        dtype=array.dtype,
        shape=seen.shape or (1,),
        strides=seen.strides or (seen.itemsize,),
        device=array.device,
        copy=False,
    )
    made._ref = array
    return made, seen.shape


def write(target: wp.array, shape: tuple[int, ...], values: NDArray[Any]) -> None:
    """Write values that broadcast to the shape of an array or a view of it."""
    source = to_device(np.broadcast_to(values, shape).astype(numpy_dtype(target)), str(target.device))
    if source.size:
        with lock_for(target.device):
            wp.copy(target, source)
