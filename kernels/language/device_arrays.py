"""Arrays on a GPU without Warp's way there: made, described for kernels, cut into parts, released.

`wp.empty` and the release of what it made take 11 us of Python, for two calls of the driver of less than one; a launch
builds a C structure for each of its arrays anew. Here an array is a copy of one that Warp has made, with its own place
in memory, and keeps what a kernel is told of it as the bytes that are passed.

All of it knows how Warp 1.19 keeps an array, as warp_parts.py says: where that is otherwise, or where the program has
Warp look closer (an allocator of its own, a recording for later processes), Warp does it.
"""

from __future__ import annotations

import math
import struct
from typing import Any

import numpy as np
import warp as wp

from . import device_lock, warp_parts
from .device_lock import lock, waiting
from .streams import note_use

Shape = tuple[int, ...]
MAX_EXTENT = 2**31
_DESCRIPTIONS = [struct.Struct(f"=Q8x{n}i{16 - 4 * n}x{n}i{16 - 4 * n}xH6x") for n in range(warp_parts.MAX_AXES + 1)]
_OF_PART = dict.fromkeys(("ctype", "deleter", "_allocator", "_array_interface", "_memory_kind"))
_array: Any = wp.array
_bare = object.__new__


class Unfit(TypeError):  # noqa: N818  no error yet: whoever takes a longer look says whether it is one
    """An argument is not plainly right."""


class Kind:
    """What arrays of a type and a number of axes on a GPU have in common; one object for each.

    An array that has been looked at has its kind as `kind_`, and what a kernel is told of it as `packed_`.
    """

    def __init__(self, dtype: Any, axes: int, device: Any) -> None:
        self.dtype, self.axes, self.device = dtype, axes, device
        self.element_bytes = wp.types.type_size_in_bytes(dtype)
        self.scalar = np.dtype(wp.dtype_to_numpy(getattr(dtype, "_wp_scalar_type_", dtype)))  # of NumPy
        self.inner = tuple(getattr(dtype, "_shape_", ()))  # of an element
        self.pack = _DESCRIPTIONS[axes].pack
        self._like: dict[str, Any] | None = None  # what a new array keeps, but for its place and its shape

    def packed(self, array: Any) -> bytes:
        """What a kernel is told of an array.

        Raises:
            Unfit: It is not of this kind, has gaps, or a gradient.
        """
        if getattr(array, "kind_", None) is not self:
            self.mark(array)
        return array.packed_

    def mark(self, array: Any) -> None:
        """Look at an array, and keep what was found with it.

        Raises:
            Unfit: As `packed`.
        """
        is_fit = type(array) is _array and array.dtype is self.dtype and array.ndim == self.axes
        if not (is_fit and array.device is self.device and array.is_contiguous and array._grad is None):
            raise Unfit
        array.packed_ = self.pack(array.ptr or 0, *array.shape, *array.strides, self.axes)
        array.kind_ = self

    def new(self, shape: Shape, strides: Shape, size: int) -> Any:
        """An array with undefined contents; take the lock.

        Raises:
            RuntimeError: The device has no room for it.
        """
        like = self._like
        if like is None:
            releases = _releases_of(self.device)
            like = dict(vars(wp.empty((0,) * self.axes, dtype=self.dtype, device=self.device)))
            like |= {"kind_": self, "ctype": None, "_allocator": releases, "deleter": releases.deallocate}
            self._like = like
        address = None
        if size:
            device = self.device
            core = warp_parts.context.runtime.core
            address = core.wp_alloc_device_async(device.context, size, warp_parts.CURRENT_STREAM, None)
            if not address:
                raise RuntimeError(f"Failed to allocate {size} bytes on device '{device}'")
        state = like.copy()
        state["ptr"], state["capacity"], state["size"] = address, size, size // self.element_bytes
        state["shape"], state["strides"] = shape, strides
        state["packed_"] = self.pack(address or 0, *shape, *strides, self.axes)
        made = _bare(_array)
        made.__dict__ = state
        return made

    def at(self, whole: Any, address: int | None, shape: Shape, strides: Shape, size: int) -> Any:
        """An array in the memory of another, which stays alive as long as it does."""
        state = whole.__dict__.copy()
        state.update(_OF_PART)
        state["dtype"], state["ndim"], state["kind_"], state["_ref"] = self.dtype, self.axes, self, whole
        state["ptr"], state["capacity"], state["size"] = address, size, size // self.element_bytes
        state["shape"], state["strides"] = shape, strides
        state["packed_"] = self.pack(address or 0, *shape, *strides, self.axes)
        made = _bare(_array)
        made.__dict__ = state
        return made


_kinds: dict[tuple[Any, int, str], Kind] = {}


def kind_of(dtype: Any, axes: int, device: Any) -> Kind:
    """The kind of such arrays."""
    found = _kinds.get((dtype, axes, device.alias))
    if found is None:
        found = _kinds.setdefault((dtype, axes, device.alias), Kind(dtype, axes, device))
    return found


def new(shape: int | Shape, dtype: Any, device: Any) -> Any:
    """An array on a GPU with undefined contents; None where Warp has to make it, or says what is wrong with its shape.

    Raises:
        RuntimeError: The device has no room for it.
    """
    if not warp_parts.makes_arrays_plainly(device):
        return None
    if type(shape) is int:
        kind = kind_of(dtype, 1, device)
        shape, strides, size = (shape,), (kind.element_bytes,), shape * kind.element_bytes
    else:
        shape = tuple(map(int, shape))  # type: ignore[arg-type]
        if not 0 < len(shape) <= warp_parts.MAX_AXES:
            return None
        kind, strides = _kind_and_strides(dtype, shape, device)
        size = shape[0] * strides[0]
    if min(shape) < 0 or max(shape) >= MAX_EXTENT or strides[0] >= MAX_EXTENT:
        return None
    with lock:
        if waiting:
            device_lock.release_pending()
        note_use(device)
        return kind.new(shape, strides, size)


def rows_of(values: Any, first: int, last: int) -> Any:
    """Rows `first` to below `last` of an array, as `values[first:last]` gives them."""
    kind, first, last = getattr(values, "kind_", None), int(first), int(last)  # addresses are plain numbers
    if kind is None or not 0 <= first < last <= values.shape[0]:
        return values[first:last]
    strides = values.strides
    address = None if values.ptr is None else values.ptr + first * strides[0]
    return kind.at(values, address, (last - first, *values.shape[1:]), strides, (last - first) * strides[0])


def flat(values: Any) -> Any:
    """An array with one axis in the same memory, as `values.flatten()` gives it."""
    seen = values if values.ndim == 1 else seen_as(values, 0, values.dtype, values.size)
    return values.flatten() if seen is None else seen


def seen_as(whole: Any, first: int, dtype: Any, shape: int | Shape) -> Any:
    """The memory of an array on a GPU from a byte on, as elements of another type; None where Warp has to see it so."""
    if getattr(whole, "kind_", None) is None or whole.ptr is None:
        return None
    shape = (shape,) if type(shape) is int else tuple(map(int, shape))  # type: ignore[arg-type]
    if not 0 < len(shape) <= warp_parts.MAX_AXES:
        return None
    first, (kind, strides) = int(first), _kind_and_strides(dtype, shape, whole.device)
    size = shape[0] * strides[0]
    if min(shape) < 0 or not 0 <= first <= first + size <= whole.capacity or strides[0] >= MAX_EXTENT:
        return None
    return kind.at(whole, whole.ptr + first, shape, strides, size)


def _kind_and_strides(dtype: Any, shape: Shape, device: Any) -> tuple[Kind, Shape]:
    kind = kind_of(dtype, len(shape), device)
    return kind, tuple(kind.element_bytes * math.prod(shape[k + 1 :]) for k in range(len(shape)))


class _Releases:
    """Releases the arrays of a GPU in turn with its other work; Warp reads it as their allocator."""

    deallocate_requires_context_guard = False  # the function that releases sets the context itself
    memory_kind = warp_parts.MEMORY_OF_POOL

    def __init__(self, device: Any) -> None:
        self._device = device

    def deallocate(self, address: int, size: int) -> None:
        """Release memory at once, or where another thread is at the device, when the next array is made or dropped."""
        device_lock.release_in_turn(self._device, self._release, address, size, sets_context=True)

    def _release(self, address: int, _: int) -> None:
        warp_parts.context.runtime.core.wp_free_device_async(self._device.context, address, None)


_by_device: dict[str, _Releases] = {}


def _releases_of(device: Any) -> _Releases:
    return _by_device.setdefault(device.alias, _Releases(device))
