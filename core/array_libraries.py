"""Arrays come back as they came: whose an array is, and results as arrays of that library, without a copy.

An operation gives its results as the library of the first array that it was given has them, or of the arrays that its
cloud was made of: NumPy for NumPy arrays, lists and files, on every device; torch, cupy, jax and Warp for theirs, on
the device where they are. See docs/arrays.md. No library is imported but the one whose array was given.

Source: the Python array API standard (`__dlpack__`); the CUDA array interface, version 3.
"""

from __future__ import annotations

import importlib
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
import warp as wp
from numpy.typing import DTypeLike

from ..kernels.arrays.side_by_side import read_together
from ..kernels.language.device_arrays import seen_as
from ..kernels.language.device_lock import turn_on
from ..kernels.memory import cast, download, empty, move, upload
from .checks import is_on_gpu, shown
from .devices import resolve_device

NUMPY, WARP = "numpy", "warp"
LIBRARIES = (NUMPY, WARP, "torch", "cupy", "jax")
_OTHER_NAMES = {"jaxlib": "jax"}  # packages whose classes are arrays of another one


def library_of(values: Any) -> str:
    """Whose array this is: one of LIBRARIES. Another library's is taken for NumPy's, on a GPU for Warp's."""
    for kind in type(values).__mro__:
        package = kind.__module__.partition(".")[0]
        package = _OTHER_NAMES.get(package, package)
        if package in LIBRARIES:
            return package
    return WARP if is_on_gpu(values) else NUMPY


def check_library(name: str, value: Any) -> str:
    """A library's name, once it is here.

    Raises:
        ValueError: None that is known.
        ImportError: It is not installed.
    """
    if not isinstance(value, str) or value not in LIBRARIES:
        raise ValueError(f"{name}: expected one of {', '.join(LIBRARIES)}, got {shown(value)}")
    _import(value)
    return value


def hand_out(
    array: wp.array,
    library: str,
    *,
    dtype: DTypeLike | None = None,
    shape: tuple[int, ...] | None = None,
    on_host: bool = False,
) -> Any:
    """A device array that nobody else holds as an array of a library.

    NumPy gets a copy from a GPU and the memory itself on the CPU. The others get the memory itself; what they do with
    it on the stream that they name comes after what is queued on Warp's current stream.

    Args:
        array: The result.
        library: One of LIBRARIES.
        dtype: The type that it shall have, as NumPy has it; None for its own. One of as many bytes is the same memory.
        shape: In place of its first axes; None for its own.
        on_host: Whether it shall be on the host, as what was asked about was.
    """
    if library == NUMPY:
        return _formed(download(array), array.ndim, dtype, shape)
    if on_host:
        array = move(array, resolve_device("cpu"))
    if dtype is not None:
        array = _as_type(array, wp.dtype_from_numpy(np.dtype(dtype)))
    if shape is not None and tuple(array.shape) != shape:
        array = view_as(array, array.dtype, shape)
    if library == WARP:
        return array
    with turn_on(array.device):  # its stream waits for ours
        return _import(library).from_dlpack(array)


def _formed(values: np.ndarray, axes: int, dtype: DTypeLike | None, shape: tuple[int, ...] | None) -> np.ndarray:
    """An array's values as `hand_out` has them; `axes` are those that a shape replaces."""
    if dtype is not None and values.dtype != dtype:
        is_same_size = values.dtype.itemsize == np.dtype(dtype).itemsize
        values = values.view(dtype) if is_same_size else values.astype(dtype)
    return values if shape is None else values.reshape((*shape, *values.shape[axes:]))


class Form(NamedTuple):
    """The form of an answer: that of what was asked about.

    Attributes:
        library: Whose arrays it is in.
        on_host: Whether it is on the host.
    """

    library: str
    on_host: bool

    def hand_out(self, array: wp.array, *, dtype: DTypeLike | None = None, shape: tuple[int, ...] | None = None) -> Any:
        """A result in this form, see `hand_out`."""
        return hand_out(array, self.library, dtype=dtype, shape=shape, on_host=self.on_host)

    def hand_out_all(
        self, arrays: Mapping[str, wp.array], types: Mapping[str, DTypeLike], *, shape: tuple[int, ...] | None = None
    ) -> dict[str, Any]:
        """Results of one shape in this form by name, by one wait; `types` are those of results with another one."""
        if self.library != NUMPY:
            return {name: self.hand_out(values, dtype=types.get(name), shape=shape) for name, values in arrays.items()}
        read = read_together([*arrays.values()])  # sync
        found = zip(arrays.items(), read, strict=True)
        return {name: _formed(values, array.ndim, types.get(name), shape) for (name, array), values in found}

    def hand_out_host(self, values: np.ndarray, device: Any) -> Any:
        """A result that was made on the host in this form."""
        return hand_out_host(values, self.library, resolve_device("cpu") if self.on_host else device)


def form_of(values: Any) -> Form:
    """The form of an array that a user gave."""
    return Form(library_of(values), not is_on_gpu(values))


def hand_out_host(values: np.ndarray, library: str, device: Any) -> Any:
    """A result that was made on the host as an array of a library, on a device."""
    if library == NUMPY:
        return values
    return hand_out(upload(values, wp.dtype_from_numpy(values.dtype), device), library)


def _import(library: str) -> Any:
    """The module that has `from_dlpack`."""
    try:
        return importlib.import_module("jax.dlpack" if library == "jax" else library)
    except ImportError as error:
        raise ImportError(f"arrays of {library} need the package {library}: pip install {library}") from error


def _as_type(array: wp.array, scalar: Any) -> wp.array:
    """The array with scalars of another type: the same memory where they have as many bytes."""
    own = getattr(array.dtype, "_wp_scalar_type_", array.dtype)
    if own == scalar:
        return array
    if wp.types.type_size_in_bytes(own) == wp.types.type_size_in_bytes(scalar):
        return view_as(array, scalar, tuple(array.shape))
    return cast(array, scalar)


def view_as(array: wp.array, dtype: Any, shape: tuple[int, ...]) -> wp.array:
    """Another view of an array's memory, of its beginning where it is smaller; keeps the array alive."""
    if not array.size or 0 in shape:  # without memory
        return empty(shape, dtype, array.device)
    seen: Any = seen_as(array, 0, dtype, shape)
    if seen is not None:
        return seen
    view: Any = wp.array(ptr=array.ptr, dtype=dtype, shape=shape, device=array.device, copy=False)
    view._ref = array
    return view
