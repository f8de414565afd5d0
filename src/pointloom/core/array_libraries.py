"""Results in the array library of the input, without a copy: NumPy, torch, cupy, jax or Warp (docs/arrays.md).

The first array argument, or the arrays of the cloud, determine the library. Only that library is imported. Python array
API standard (`__dlpack__`). CUDA array interface, version 3.
"""

from __future__ import annotations

import importlib
from collections.abc import Mapping
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np
import warp as wp
from numpy.typing import DTypeLike

from ..kernels.arrays.side_by_side import read_together
from ..kernels.language.device_arrays import reinterpreted
from ..kernels.language.device_lock import lock_for
from ..kernels.memory import cast, download, empty, host_view, move, upload
from .checks import is_on_gpu, shown
from .devices import resolve_device

NUMPY, WARP = "numpy", "warp"
LIBRARIES = (NUMPY, WARP, "torch", "cupy", "jax")
_OTHER_NAMES = {"jaxlib": "jax"}  # packages whose classes are arrays of another library


def library_of(values: object) -> str:
    """The library of an array, one of LIBRARIES. Unknown ones count as NumPy, on a GPU as Warp."""
    for kind in type(values).__mro__:
        package = kind.__module__.partition(".")[0]
        package = _OTHER_NAMES.get(package, package)
        if package in LIBRARIES:
            return package
    return WARP if is_on_gpu(values) else NUMPY


def check_library(name: str, value: object) -> str:
    """A library name. Raises `ValueError` if unknown and `ImportError` if not installed."""
    if not isinstance(value, str) or value not in LIBRARIES:
        raise ValueError(f"{name}: expected one of {', '.join(LIBRARIES)}, got {shown(value)}")
    _import(value)
    return value


def library_for(arrays: str | None, values: object = None) -> str:
    """The requested library of results (`arrays`). If None: that of an array."""
    if arrays is None:
        return NUMPY if type(values) is np.ndarray else library_of(values)
    return check_library("arrays", arrays)


def hand_out(
    array: wp.array,
    library: str,
    *,
    dtype: DTypeLike | None = None,
    shape: tuple[int, ...] | None = None,
    on_host: bool = False,
) -> Any:
    """Return a device array that has no other owner as an array of a library, reshaped and cast as requested.
    NumPy gets a copy from a GPU and shared memory on the CPU. Others share memory and are ordered after Warp's current
    stream. `shape` replaces the first axes. A `dtype` of the same size shares memory."""
    if library == NUMPY:
        values = download(array)
        return values if dtype is None and shape is None else _formed(values, array.ndim, dtype, shape)
    if on_host:
        array = move(array, resolve_device("cpu"))
    if dtype is not None:
        array = _as_type(array, wp.dtype_from_numpy(np.dtype(dtype)))
    if shape is not None and tuple(array.shape) != shape:
        array = view_as(array, array.dtype, shape)
    if library == WARP:
        return array
    if array.device.is_cpu:  # of NumPy: Warp's own release of a shared array ends an exception that is being raised
        return _import(library).from_dlpack(host_view(array))
    with lock_for(array.device):  # its stream waits for pointloom's
        return _import(library).from_dlpack(array)


def shared_view(array: wp.array, library: str) -> Any:
    """A device array as an array of a library over the same memory, with the components of vectors as last axis.

    NumPy has no memory on a GPU and gets Warp's array there. Warp has vectors, so its arrays are unchanged.
    """
    if library != NUMPY:
        return hand_out(array, library)
    return host_view(array) if array.device.is_cpu else array


def hand_out_copy(array: wp.array, library: str, dtype: DTypeLike | None = None) -> Any:
    """`hand_out`, but NumPy arrays share no memory with the CPU's device arrays."""
    result = hand_out(array, library, dtype=dtype)
    is_shared = library == NUMPY and array.device.is_cpu and not result.flags.owndata
    return result.copy() if is_shared else result


def owned(array: wp.array) -> np.ndarray:
    """A NumPy copy of a device array (sync). A GPU's is the download itself."""
    return download(array) if array.device.is_cuda else download(array).copy()


def _formed(values: np.ndarray, axes: int, dtype: DTypeLike | None, shape: tuple[int, ...] | None) -> np.ndarray:
    """Values as in `hand_out`; `axes` is the number of replaced axes."""
    if dtype is not None and values.dtype != dtype:
        is_same_size = values.dtype.itemsize == np.dtype(dtype).itemsize
        values = values.view(dtype) if is_same_size else values.astype(dtype)
    return values if shape is None else values.reshape((*shape, *values.shape[axes:]))


class Form(NamedTuple):
    """The array library and location (`on_host`) of a result, as of the input."""

    library: str
    on_host: bool

    def hand_out(self, array: wp.array, *, dtype: DTypeLike | None = None, shape: tuple[int, ...] | None = None) -> Any:
        return hand_out(array, self.library, dtype=dtype, shape=shape, on_host=self.on_host)

    def hand_out_all(
        self,
        arrays: Mapping[Any, wp.array],
        types: Mapping[Any, DTypeLike] = MappingProxyType({}),
        *,
        shape: tuple[int, ...] | None = None,
    ) -> dict[Any, Any]:
        """Return results by name with one synchronization; `types` are changed types, `shape` is that of all."""
        if self.library != NUMPY:
            return {name: self.hand_out(values, dtype=types.get(name), shape=shape) for name, values in arrays.items()}
        read = read_together([*arrays.values()])  # sync
        pairs = zip(arrays.items(), read, strict=True)
        return {name: _formed(values, array.ndim, types.get(name), shape) for (name, array), values in pairs}

    def hand_out_host(self, values: np.ndarray, device: Any) -> Any:
        return hand_out_host(values, self.library, resolve_device("cpu") if self.on_host else device)


def form_of(values: object) -> Form:
    return Form(library_of(values), not is_on_gpu(values))


def hand_out_host(values: np.ndarray, library: str, device: Any) -> Any:
    if library == NUMPY:
        return values
    return hand_out(upload(values, wp.dtype_from_numpy(values.dtype), device), library)


def _import(library: str) -> Any:
    try:
        return importlib.import_module("jax.dlpack" if library == "jax" else library)
    except ImportError as error:
        raise ImportError(f"arrays of {library} need the package {library}: pip install {library}") from error


def _as_type(array: wp.array, scalar: Any) -> wp.array:
    """Cast scalars. Same-size types share memory."""
    own = getattr(array.dtype, "_wp_scalar_type_", array.dtype)
    if own == scalar:
        return array
    if wp.types.type_size_in_bytes(own) == wp.types.type_size_in_bytes(scalar):
        return view_as(array, scalar, tuple(array.shape))
    return cast(array, scalar)


def view_as(array: wp.array, dtype: Any, shape: tuple[int, ...]) -> wp.array:
    """A view of an array's memory, possibly shorter, that keeps the array alive."""
    if not array.size or 0 in shape:  # empty
        return empty(shape, dtype, array.device)
    seen: Any = reinterpreted(array, 0, dtype, shape)
    if seen is not None:
        return seen
    view: Any = wp.array(ptr=array.ptr, dtype=dtype, shape=shape, device=array.device, copy=False)
    view._ref = array
    return view
