"""Fast creation and slicing of arrays, and release of GPU arrays.

`wp.empty` and the release take 11 us of Python for two driver calls of less than 1 us, and 6 us on the CPU. Here arrays
are copies of a Warp array with their own memory, and cache the bytes passed to kernels. This depends on the internals
of Warp 1.19 (warp_parts.py). Warp itself is used if they differ or if it has hooks.
"""

from __future__ import annotations

import functools
import math
import struct
from typing import Any

import numpy as np
import warp as wp

from ..array_types import Device
from . import device_lock, warp_parts
from .device_lock import lock, waiting
from .streams import note_use

Shape = tuple[int, ...]
MAX_EXTENT = 2**31
ALIGNMENT_BYTES = 256  # bytes between addresses of arrays in a block, as of cudaMalloc
# (largest array in a block, bytes of the block). One array keeps its block, so sizes are apart.
BLOCKS = ((1 << 14, 1 << 17), (1 << 18, 1 << 21))
blocks: tuple[tuple[int, int], ...] = BLOCKS  # a test may set another
_DESCRIPTIONS = [struct.Struct(f"=Q8x{n}i{16 - 4 * n}x{n}i{16 - 4 * n}xH6x") for n in range(warp_parts.MAX_AXES + 1)]
_OF_PART = dict.fromkeys(("ctype", "deleter", "_allocator", "_array_interface", "_memory_kind"))
_array: Any = wp.array
_bare = object.__new__


class Unfit(TypeError):  # noqa: N818  not an error yet: a slower check decides
    ...


def makes_arrays_plainly(device: Device) -> bool:
    """True if an array is plain memory of the host, or of Warp's pool on a GPU."""
    try:
        if device.is_cpu:
            is_plain = type(device.default_allocator) is warp_parts.context.CpuDefaultAllocator
        else:
            is_plain = device._custom_allocator is None and device.current_allocator is device.mempool_allocator
        return is_plain and warp_parts.context.runtime._apic_capture is None and warp_parts.is_known()
    except AttributeError:
        return False


class Kind:
    """Arrays of a device, type and number of axes. Checked arrays cache it as `kind_`, launch bytes as `packed_`."""

    def __init__(self, dtype: object, axes: int, device: Device | None) -> None:
        self.dtype, self.axes = dtype, axes
        self.device: Any = device  # None for the properties of the elements alone
        self.element_bytes = wp.types.type_size_in_bytes(dtype)
        self.scalar = np.dtype(wp.dtype_to_numpy(getattr(dtype, "_wp_scalar_type_", dtype)))  # of NumPy
        self.inner = tuple(getattr(dtype, "_shape_", ()))  # of an element
        self.pack = _DESCRIPTIONS[axes].pack

    @functools.cached_property
    def like(self) -> dict[str, Any]:
        """Attributes of a new array, except address and shape."""
        like = dict(vars(wp.empty((0,) * self.axes, dtype=self.dtype, device=self.device)))
        like |= {"kind_": self, "ctype": None}
        if self.device.is_cuda:
            releases = _releases_of(self.device)
            like |= {"_allocator": releases, "deleter": releases.deallocate}
        return like

    def packed(self, array: Any) -> bytes:
        """Launch bytes of an array. Raises Unfit for another kind, gaps, or a gradient."""
        if getattr(array, "kind_", None) is not self:
            self.mark(array)
        return array.packed_

    def mark(self, array: Any) -> None:
        """Check an array and cache the result with it. Raises Unfit as `packed`."""
        is_fit = type(array) is _array and array.dtype is self.dtype and array.ndim == self.axes
        if not (is_fit and array.device is self.device and array.is_contiguous and array._grad is None):
            raise Unfit
        array.packed_ = self.pack(array.ptr or 0, *array.shape, *array.strides, self.axes)
        array.kind_ = self

    def at(self, parent: Any, address: int | None, shape: Shape, strides: Shape, size: int) -> Any:
        """A view of the memory of another array, which it keeps alive."""
        state = parent.__dict__.copy()
        state.update(_OF_PART)
        state["dtype"], state["ndim"], state["kind_"], state["_ref"] = self.dtype, self.axes, self, parent
        state["ptr"], state["capacity"], state["size"] = address, size, size // self.element_bytes
        state["shape"], state["strides"] = shape, strides
        state["packed_"] = self.pack(address or 0, *shape, *strides, self.axes)
        view = _bare(_array)
        view.__dict__ = state
        return view


@functools.cache
def element_kind(dtype: object) -> Kind:
    """Kind of an element type, for its properties that do not depend on axes and device."""
    return Kind(dtype, 1, None)


kinds: dict[tuple[Any, int, str], Kind] = {}


def kind_of(dtype: object, axes: int, device: Device) -> Kind:
    kind = kinds.get((dtype, axes, device.alias))
    if kind is None:
        kind = kinds.setdefault((dtype, axes, device.alias), Kind(dtype, axes, device))
    return kind


def new(shape: int | Shape, dtype: object, device: Device, *, in_block: bool = True) -> Any:
    """An uninitialized array of a GPU; a small one is a zeroed part of a block unless `in_block` is False. None if Warp
    has to create it. Raises RuntimeError if device memory is exhausted."""
    shape = (shape,) if type(shape) is int else tuple(map(int, shape))  # type: ignore[arg-type]
    axes = len(shape)
    if not 0 < axes <= warp_parts.MAX_AXES or not makes_arrays_plainly(device):
        return None
    kind = kinds.get((dtype, axes, device.alias)) or kind_of(dtype, axes, device)
    size, strides = kind.element_bytes, ()
    for extent in reversed(shape):
        if not 0 <= extent < MAX_EXTENT > size:
            return None
        strides, size = (size, *strides), size * extent
    core, address = warp_parts.context.runtime.core, None
    with lock:
        if waiting:
            device_lock.release_pending()
        state, stream = kind.like.copy(), note_use(device)
        place = _place_for(device, stream, size) if in_block else None
        if place is not None:
            (address, state["block_"]), state["deleter"] = place, None
        elif size:
            address = core.wp_alloc_device_async(device.context, size, warp_parts.CURRENT_STREAM, None)
    if size and not address:
        raise RuntimeError(f"Failed to allocate {size} bytes on device '{device}'")
    state["ptr"], state["capacity"], state["size"] = address, size, size // kind.element_bytes
    state["shape"], state["strides"] = shape, strides
    state["packed_"] = kind.pack(address or 0, *shape, *strides, axes)
    array = _bare(_array)
    array.__dict__ = state
    return array


class Block:
    """Memory for the next small arrays of a stream: an allocation with its release takes four times as long as a part
    of a block. It is zero, no part is used twice, and it is released with the last of them."""

    def __init__(self, device: Device, size: int) -> None:
        self.array = new(size, wp.uint8, device, in_block=False)
        self.first, self.end = self.array.ptr, self.array.ptr + size
        warp_parts.core().wp_memset_device(device.context, self.first, 0, size, warp_parts.CURRENT_STREAM)


def _place_for(device: Device, stream: Any, size: int) -> tuple[int, Any] | None:
    """The address of an array in a block of the current stream, and the block's array. None for large arrays, if the
    stream is not Warp's own, or if Warp records one of the device: a graph must allocate its arrays itself. Take the
    lock."""
    if not size or not stream.owner or device.captures:
        return None
    for largest, room in blocks:
        if size <= largest:
            current = stream.__dict__.setdefault("blocks_", {})
            block = current.get(room)
            if block is None or block.first + size > block.end:
                block = current[room] = Block(device, room)
            address = block.first
            block.first += -(-size // ALIGNMENT_BYTES) * ALIGNMENT_BYTES
            return address, block.array
    return None


def is_zero(values: object) -> bool:
    """True if a new array is part of a block."""
    return "block_" in values.__dict__


def drop_blocks(device: Device) -> None:
    """Start new blocks with the next arrays of the current stream. Take the lock."""
    device.stream.__dict__.pop("blocks_", None)


def over(values: np.ndarray, dtype: object, device: Device) -> Any:
    """A CPU array over the memory of a contiguous NumPy array (n, ..., *element), which it keeps alive. None if Warp
    has to create it."""
    axes = values.ndim - len(element_kind(dtype).inner)
    if not 0 < axes <= warp_parts.MAX_AXES or not makes_arrays_plainly(device):
        return None
    if not values.nbytes or max(values.shape) >= MAX_EXTENT:
        return None
    kind = kinds.get((dtype, axes, device.alias)) or kind_of(dtype, axes, device)
    shape = values.shape[:axes]
    state, strides = kind.like.copy(), values.strides[:axes]
    state["ptr"], state["capacity"], state["size"] = values.ctypes.data, values.nbytes, math.prod(shape)
    state["shape"], state["strides"], state["_ref"], state["deleter"] = shape, strides, values, None
    state["packed_"] = kind.pack(state["ptr"], *shape, *strides, axes)
    array = _bare(_array)
    array.__dict__ = state
    return array


def rows_of(values: Any, first: int, last: int) -> Any:
    kind, first, last = getattr(values, "kind_", None), int(first), int(last)  # addresses are plain numbers
    if kind is None or not 0 <= first < last <= values.shape[0]:
        return values[first:last]
    strides = values.strides
    address = None if values.ptr is None else values.ptr + first * strides[0]
    return kind.at(values, address, (last - first, *values.shape[1:]), strides, (last - first) * strides[0])


def flat(values: Any) -> Any:
    view = values if values.ndim == 1 else reinterpreted(values, 0, values.dtype, values.size)
    return values.flatten() if view is None else view


def reinterpreted(parent: Any, first: int, dtype: Any, shape: int | Shape) -> Any:
    """View of an array's memory from a byte on as another type. None if Warp has to create it."""
    if getattr(parent, "kind_", None) is None or parent.ptr is None:
        return None
    shape = (shape,) if type(shape) is int else tuple(map(int, shape))  # type: ignore[arg-type]
    if not 0 < len(shape) <= warp_parts.MAX_AXES:
        return None
    kind = kinds.get((dtype, len(shape), parent.device.alias)) or kind_of(dtype, len(shape), parent.device)
    first, strides = int(first), (kind.element_bytes,)
    for extent in shape[:0:-1]:
        strides = (extent * strides[0], *strides)
    size = shape[0] * strides[0]
    if min(shape) < 0 or not 0 <= first <= first + size <= parent.capacity or strides[0] >= MAX_EXTENT:
        return None
    return kind.at(parent, parent.ptr + first, shape, strides, size)


class _Releases:
    """Allocator for Warp that releases GPU arrays under the lock."""

    deallocate_requires_context_guard = False  # the release function sets the context itself
    memory_kind = warp_parts.MEMORY_OF_POOL

    def __init__(self, device: Device) -> None:
        self._device = device

    def deallocate(self, address: int, size: int) -> None:
        """Release memory now, or with the next array if another thread has the lock."""
        device_lock.release_under_lock(self._device, self._release, address, size, sets_context=True)

    def _release(self, address: int, _: int) -> None:
        warp_parts.context.runtime.core.wp_free_device_async(self._device.context, address, None)


_by_device: dict[str, _Releases] = {}


def _releases_of(device: Device) -> _Releases:
    return _by_device.setdefault(device.alias, _Releases(device))
