"""Fast fills, copies, scans and sorts on, to, and from a GPU by Warp's native calls on the same stream.

Functions return False or None without any effect if Warp has to do it, such as during a recording. Take the lock.
"""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import pinned_uploads, warp_parts
from .device_arrays import Kind, kind_of, makes_arrays_plainly
from .huge_pages import MIN_MAPPED_BYTES, populate
from .pinned_results import MIN_PINNED_BYTES, fill_pinned
from .pinned_uploads import checked


def _kind(values: Any) -> Kind:
    return getattr(values, "kind_", None) or kind_of(values.dtype, values.ndim, values.device)


def _is_plain(values: Any) -> bool:
    """True for a contiguous GPU array without hooks."""
    is_plain = values.is_contiguous and values._grad is None and values.device.is_cuda
    return is_plain and makes_arrays_plainly(values.device)


def _has_numbers(values: object, scalar: object) -> bool:
    """True for an array of numbers of a type, not of vectors."""
    kind = _kind(values)
    return kind.scalar == scalar and not kind.inner


def is_zeroed(values: Any) -> bool:
    """Set a GPU array to zero."""
    if not _is_plain(values):
        return False
    size = values.size * _kind(values).element_bytes
    if size:
        warp_parts.core().wp_memset_device(values.device.context, values.ptr, 0, size, warp_parts.CURRENT_STREAM)
    return True


def is_copied(target: Any, source: Any, count: int, offset: int = 0) -> bool:
    """Copy the first elements between GPU arrays."""
    count, offset = int(count), int(offset)  # ctypes accepts no NumPy numbers as addresses
    if target.device is not source.device or not (_is_plain(target) and source.is_contiguous):
        return False
    width = _kind(target).element_bytes
    is_inside = 0 < count <= source.size and 0 <= offset <= target.size - count
    if not is_inside or source._grad is not None or _kind(source).element_bytes != width:
        return False
    device, to = target.device, target.ptr + offset * width
    done = warp_parts.core().wp_memcpy_d2d(device.context, to, source.ptr, count * width, device.stream.cuda_stream)
    return checked(done, device)


def is_written(target: Any, values: NDArray[Any]) -> bool:
    """Copy the bytes of a contiguous NumPy array, as many as the target has. The array may change afterwards."""
    device = target.device
    if not _is_plain(target) or device.captures or not values.flags.c_contiguous:
        return False
    kind = _kind(target)
    size = target.size * kind.element_bytes
    if size == 0 or size != values.nbytes or values.dtype != kind.scalar:
        return False
    pinned_uploads.send(device, target.ptr, values)
    return True


def is_sent(target: Any, source: Any) -> bool:
    """Copy a GPU array to a pinned host array of the same type."""
    device = source.device
    if not _is_plain(source) or not source.size or target.dtype is not source.dtype or target.size != source.size:
        return False
    size, stream = source.size * _kind(source).element_bytes, device.stream.cuda_stream
    return checked(warp_parts.core().wp_memcpy_d2h(device.context, target.ptr, source.ptr, size, stream), device)


def fetched(values: Any) -> NDArray[Any] | None:
    """Copy a GPU array to the host (sync)."""
    device = values.device
    if not _is_plain(values) or device.captures or not values.size:
        return None
    kind = _kind(values)
    shape, size = (*values.shape, *kind.inner), values.size * kind.element_bytes
    out = fill_pinned(shape, kind.scalar, device, partial(_fill, values)) if size >= MIN_PINNED_BYTES else None
    if out is None:
        out = np.empty(shape, kind.scalar)
        address = out.__array_interface__["data"][0]
        if size >= MIN_MAPPED_BYTES:
            populate(address, size)  # while the device works
        _fill(values, address, size)
    return out


def _fill(values: Any, address: int, size: int) -> None:
    """Copy a GPU array to host memory (sync)."""
    device = values.device
    stream = device.stream.cuda_stream
    checked(warp_parts.core().wp_memcpy_d2h(device.context, address, values.ptr, size, stream), device)
    pinned_uploads.wait_for_stream(device)  # sync


def is_scanned(counts: Any, sums: Any) -> bool:
    """Inclusive prefix sums of int32 numbers. Take the context of the device, too."""
    if not (_is_plain(counts) and _is_plain(sums) and _has_numbers(counts, np.int32) and sums.dtype is counts.dtype):
        return False
    if counts.device is not sums.device or not 0 < counts.size == sums.size:
        return False
    done = warp_parts.core().wp_array_scan_int_device(counts.ptr, sums.ptr, counts.size, 4, 4, 1, True)
    return checked(done, counts.device)


def is_sorted(keys: Any, values: Any, count: int, bit_count: int) -> bool:
    """Sort int64 keys and int32 values in place, with room for twice `count`. Take the context of the device, too."""
    if not (_is_plain(keys) and _is_plain(values) and _has_numbers(keys, np.int64) and _has_numbers(values, np.int32)):
        return False
    if keys.device is not values.device or not 0 < 2 * count <= min(keys.size, values.size) or not bit_count:
        return False
    warp_parts.core().wp_radix_sort_pairs_int64_device(keys.ptr, values.ptr, count, 0, bit_count, 4)
    return True
