"""Device memory, allocated by Warp. On a GPU these functions take the lock of launches (language/device_lock.py), so
they are thread-safe, unlike Warp's own.
"""

from __future__ import annotations

import contextlib
import ctypes
import re
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, overload

import numpy as np
import warp as wp
from numpy.typing import NDArray

from .array_types import Array, Array1, Array2, Array3, Device, DeviceArray, Element, Rank
from .language import device_arrays, device_copies, pools, warp_parts
from .language.casts import cast_into
from .language.device_arrays import flat, rows_of  # noqa: F401  handed on
from .language.device_lock import lock_for, own, why_no_cuda_here
from .language.huge_pages import MIN_MAPPED_BYTES, request_huge_pages
from .language.pinned_results import release_pinned
from .language.pinned_uploads import release_pieces

POOL_FRACTION = 0.5  # of a GPU's memory: maximum of released memory kept by its pool
_pools: set[str] = set()  # GPUs whose pool keeps memory, by name


def _keep_pool(device: Device) -> None:
    """Set a GPU's pool to keep released memory, unless the user set a threshold. CUDA's default returns it to the
    system at each synchronization, which slows the next allocation.
    """
    if device.alias in _pools:
        return
    _pools.add(device.alias)
    if device.is_mempool_enabled and not wp.get_mempool_release_threshold(device):
        wp.set_mempool_release_threshold(device, POOL_FRACTION)


# callbacks that release what is kept for the next call; pieces of page-locked memory first
on_give_back: list[Callable[[], None]] = [release_pieces, release_pinned]


def give_back(device: Device) -> int:
    """Release unused pool memory of a GPU to the system (sync) and return the bytes. 0 on GPUs without arrays."""
    for let_go in on_give_back:
        let_go()
    if not device.is_cuda or device.alias not in _pools:
        return 0
    with lock_for(device):
        device_arrays.drop_blocks(device)
    return pools.trim(device)


class _Allocation:
    """Lock for an allocation. Converts Warp's out-of-memory error to MemoryError."""

    def __init__(self, device: Device | str) -> None:
        self.lock = lock_for(device)
        self.device: Any = device

    def __enter__(self) -> None:
        self.lock.__enter__()
        if getattr(self.device, "is_cuda", False):
            _keep_pool(self.device)

    def __exit__(self, kind: Any, error: BaseException | None, traceback: Any) -> None:
        self.lock.__exit__(kind, error, traceback)
        size = re.match(r"Failed to allocate (\d+) bytes", str(error)) if isinstance(error, RuntimeError) else None
        if size:
            is_gpu = getattr(self.device, "is_cuda", False)
            free = f", {free_bytes(self.device):,} are free" if is_gpu else ""
            raise MemoryError(
                f"{self.device} has no room for an array of {int(size[1]):,} bytes{free}; take fewer points or larger "
                "voxels, work in parts, or release what else holds memory there"
            ) from error
        if isinstance(error, ValueError) and str(error).startswith("Array shapes must not exceed"):
            count = re.search(r"got (\d+)", str(error))
            raise ValueError(
                f"an array of {int(count[1]) if count else 2**31:,} elements: device code counts them in 32 bits, so "
                "take fewer than 2^31 at a time (docs/gpu.md, Largest sizes)"
            ) from error


def free_bytes(device: Device) -> int | None:
    """Free bytes on a device, including the pool. None if unknown."""
    if device.is_cuda:
        return int(device.free_memory) + pools.reserved_bytes(device)
    sizes = []
    with contextlib.suppress(OSError, ValueError, StopIteration):
        lines = Path("/proc/meminfo").read_text(encoding="utf-8").splitlines()
        sizes.append(1024 * next(int(line.split()[1]) for line in lines if line.startswith("MemAvailable:")))
    with contextlib.suppress(OSError, ValueError):  # in containers; "max" is no number
        group = Path("/sys/fs/cgroup")
        sizes.append(int((group / "memory.max").read_text()) - int((group / "memory.current").read_text()))
    return max(0, min(sizes)) if sizes else None


MIN_CHECKED = 1 << 24  # bytes: a query of the system takes 30 us, as long as filling 1 MB


def check_room(device: Device, size: int, what: str) -> None:
    """Raise MemoryError if the device has less than `size` bytes free. Few bytes are not checked."""
    if size < MIN_CHECKED:
        return
    if device.is_cuda and size > device.free_memory:
        give_back(device)
    free = free_bytes(device)
    if free is not None and size > free:
        raise MemoryError(
            f"{what} would take about {size / 1e9:.2f} GB, and {device} has {free / 1e9:.2f} GB free; take a smaller "
            "depth or fewer points, or release what else holds memory there"
        )


@overload
def empty(shape: int | tuple[int], dtype: type[Element], device: Device | str) -> Array1[Element]: ...
@overload
def empty(shape: tuple[int, int], dtype: type[Element], device: Device | str) -> Array2[Element]: ...
@overload
def empty(shape: tuple[int, int, int], dtype: type[Element], device: Device | str) -> Array3[Element]: ...
@overload
def empty(shape: tuple[int, ...], dtype: type[Element], device: Device | str) -> DeviceArray[Element, Any]: ...
def empty(shape: int | tuple[int, ...], dtype: object, device: Device | str) -> Any:
    """Uninitialized array. Raises MemoryError, as all functions here that allocate."""
    home: Any = device if isinstance(device, Device) else wp.get_device(device)
    if home.is_cuda:
        if why_no_cuda_here():
            raise RuntimeError(f"{home}: {why_no_cuda_here()}")
        _keep_pool(home)
        try:
            created = device_arrays.new(shape, dtype, home)
        except RuntimeError:
            with _Allocation(home):
                raise
        return _empty_by_warp(shape, dtype, home) if created is None else created
    extents = (shape,) if type(shape) is int else tuple(map(int, shape))  # type: ignore[arg-type]
    axes = len(extents)
    is_plain = warp_parts.is_known() and type(home.default_allocator) is warp_parts.context.CpuDefaultAllocator
    if not (is_plain and 0 < axes <= warp_parts.MAX_AXES and warp_parts.context.runtime._apic_capture is None):
        return _empty_by_warp(shape, dtype, home)
    kind = device_arrays.kinds.get((dtype, axes, home.alias)) or device_arrays.kind_of(dtype, axes, home)
    size, strides = kind.element_bytes, ()
    for extent in reversed(extents):
        if not 0 <= extent < device_arrays.MAX_EXTENT > size:
            return _empty_by_warp(shape, dtype, home)
        strides, size = (size, *strides), size * extent
    address = warp_parts.context.runtime.core.wp_alloc_host(size, None) if size else None
    if size and not address:  # raises
        return _empty_by_warp(shape, dtype, home)
    if address and size >= MIN_MAPPED_BYTES:
        request_huge_pages(address, size)
    state = kind.like.copy()
    state["ptr"], state["capacity"], state["size"] = address, size, size // kind.element_bytes
    state["shape"], state["strides"] = extents, strides
    state["packed_"] = kind.pack(address or 0, *extents, *strides, axes)
    array = object.__new__(wp.array)
    array.__dict__ = state
    return array


def _empty_by_warp(shape: int | tuple[int, ...], dtype: Any, home: Any) -> Any:
    with _Allocation(home):
        return own(wp.empty(shape, dtype=dtype, device=home))


@overload
def zeros(shape: int | tuple[int], dtype: type[Element], device: Device) -> Array1[Element]: ...
@overload
def zeros(shape: tuple[int, int], dtype: type[Element], device: Device) -> Array2[Element]: ...
@overload
def zeros(shape: tuple[int, int, int], dtype: type[Element], device: Device) -> Array3[Element]: ...
@overload
def zeros(shape: tuple[int, ...], dtype: type[Element], device: Device) -> DeviceArray[Element, Any]: ...
def zeros(shape: int | tuple[int, ...], dtype: Any, device: Device) -> Any:
    created = empty(shape, dtype, device)
    if created.device.is_cpu:
        ctypes.memset(created.ptr or 0, 0, created.capacity)
        return created
    with lock_for(device):
        if not device_arrays.is_zero(created) and not device_copies.is_zeroed(created):
            created.zero_()
    return created


@overload
def full(shape: int | tuple[int], value: Any, dtype: type[Element], device: Device) -> Array1[Element]: ...
@overload
def full(shape: tuple[int, int], value: Any, dtype: type[Element], device: Device) -> Array2[Element]: ...
@overload
def full(shape: tuple[int, int, int], value: Any, dtype: type[Element], device: Device) -> Array3[Element]: ...
@overload
def full(shape: tuple[int, ...], value: Any, dtype: type[Element], device: Device) -> DeviceArray[Element, Any]: ...
def full(shape: int | tuple[int, ...], value: Any, dtype: Any, device: Device) -> Any:
    created = empty(shape, dtype, device)
    if created.device.is_cpu:
        created.fill_(value)
    else:
        fill(created, value)
    return created


def fill(values: wp.array, value: object) -> None:
    with lock_for(values.device):
        values.fill_(value)


def upload(
    values: np.ndarray, dtype: type[Element], device: Device | str, *, copied: bool = True
) -> DeviceArray[Element, Any]:
    """Copy a NumPy array to a device as `dtype` (vectors take the last axis). A CPU view if `copied` is False."""
    kind = device_arrays.element_kind(dtype)
    values = np.ascontiguousarray(values, dtype=kind.scalar)
    if values.size == 0:
        width = len(kind.inner)
        shape = values.shape[: values.ndim - width] if width else values.shape
        return empty(shape, dtype, device)
    home: Any = device if isinstance(device, Device) else wp.get_device(device)
    if not copied:  # an axis of one element may have any stride, which Warp treats as non-contiguous
        values = values.reshape(-1).reshape(values.shape)
    inner = kind.inner
    outer = values.shape[: values.ndim - len(inner)]
    if outer and values.shape == (*outer, *inner):
        if home.is_cpu and not copied:
            if (made := device_arrays.over(values, dtype, home)) is not None:
                return made
        elif home.is_cpu:  # Warp would make two arrays and a copy, in twice the time
            out = empty(outer, dtype, home)
            np.copyto(np.asarray(out), values)
            return out
        else:
            created = empty(outer, dtype, home)
            write(created, values)
            return created
    on_host: Any = wp.get_device("cpu")
    with _Allocation(on_host):
        out: Any = wp.array(values, dtype=dtype, device=on_host, copy=copied)
    return move(out, home)


def upload_together(tables: Sequence[NDArray[Any]], dtype: type[Element], device: Device) -> list[Array1[Element]]:
    """Upload several small one-dimensional NumPy arrays in one copy, as parts of one array."""
    buffer = upload(np.concatenate(tables), dtype, device)
    ends = np.cumsum([len(table) for table in tables]).tolist()
    parts = zip(tables, ends, strict=True)
    return [rows_of(buffer, end - len(table), end) if len(table) else empty(0, dtype, device) for table, end in parts]


def copy(target: wp.array, source: wp.array, *, count: int, offset: int = 0) -> None:
    """Copy the first `count` elements of one array to another on the same device, starting at element `offset`."""
    if not count:
        return
    if target.device.is_cpu and source.device.is_cpu and target.ndim == source.ndim == 1:
        host_view(target)[offset : offset + count] = host_view(source)[:count]
        return
    with lock_for(target.device):
        if not device_copies.is_copied(target, source, count, offset):
            wp.copy(target, source, dest_offset=offset, count=count)


def fill_column(target: Any, column: int, source: wp.array) -> None:
    """Copy an array (n) to a column of another, (n, c), on the same device."""
    if source.size:
        with lock_for(target.device):
            wp.copy(target[:, column], source)


def write(target: Any, values: np.ndarray) -> None:
    """Overwrite an array with a NumPy array of the same type and size, which may change afterwards."""
    if target.device.is_cpu:
        view = np.asarray(target) if target.ptr else target.numpy()  # as host_view, whose call would take longer
        view.reshape(-1)[:] = values.reshape(-1)
        return
    with lock_for(target.device):
        if not device_copies.is_written(target, values):
            _write_by_warp(target, upload(values, target.dtype, wp.get_device("cpu"), copied=False))


def _write_by_warp(target: Any, source: Any) -> None:
    """Copy an array of the host to a GPU, and wait: Warp's copy may read the source later. Take the lock."""
    wp.copy(target, source, count=target.size)
    if not target.device.captures:
        wp.synchronize_stream(target.device.stream)  # sync


def clone(values: Array) -> Array:
    out: Any = empty(values.shape, values.dtype, values.device)
    if values.device.is_cpu:
        wp.copy(out, values)
        return out
    with lock_for(values.device):
        wp.copy(out, values)
    return out


def contiguous(values: Array) -> Array:
    """The array itself if contiguous, else a contiguous copy."""
    return values if values.is_contiguous else clone(values)


@overload
def cast(values: DeviceArray[Any, Rank], dtype: type[Element]) -> DeviceArray[Element, Rank]: ...
@overload
def cast(values: wp.array, dtype: type[Element]) -> DeviceArray[Element, Any]: ...
def cast(values: Any, dtype: Any) -> Any:
    """Convert the elements to another type with C semantics."""
    out = empty(values.shape, dtype, values.device)
    if values.size:
        cast_into(out, contiguous(values))
    return out


def move(values: Array, device: Device) -> Array:
    """The array on another device, or itself if it is there already."""
    if values.device == device:
        return values
    home: Any = values.device
    with lock_for(device), lock_for(home):
        out: Any = empty(values.shape, values.dtype, device)
        if home.is_cpu:
            if not device_copies.is_written(out, host_view(values)):
                _write_by_warp(out, values)
            return out
        if out.device.is_cuda:
            out.device.stream.wait_stream(home.stream)  # Warp copies on the stream of the other GPU only
        wp.copy(out, values)
        if out.device.is_cpu:
            wp.synchronize_stream(home.stream)  # sync
    return out


def download(values: Any) -> NDArray[Any]:
    """The array as NumPy, read-only: a copy from a GPU (sync), a view on the CPU."""
    if values.device.is_cpu:  # as host_view, whose call would take longer
        return np.asarray(values) if values.ptr else values.numpy()
    with lock_for(values.device):
        fetched = device_copies.fetched(values)  # sync
    if fetched is not None:
        return fetched
    return move(values, wp.get_device("cpu")).numpy()


def host_view(values: Any) -> NDArray[Any]:
    """Writable NumPy view of a CPU array."""
    assert values.device.is_cpu
    return np.asarray(values) if values.ptr else values.numpy()  # avoids overhead of Warp


class Readback:
    """Asynchronous copies of small arrays to the host: `send` starts the copy, `read` waits for it."""

    def __init__(self, values: wp.array) -> None:
        self.values: Any = values
        self._host: Any = None  # host memory, filled asynchronously
        self._host_view: Any = None  # the same memory as NumPy
        self._event: Any = None
        self._is_sent = False

    def send(self) -> None:
        device = self.values.device
        if device.is_cpu:
            return
        with lock_for(device):
            if self._host is None:
                self._host = wp.empty(self.values.shape, dtype=self.values.dtype, device="cpu", pinned=True)
                self._host_view, self._event = self._host.numpy(), wp.Event(device)
            if not device_copies.is_sent(self._host, self.values):
                wp.copy(self._host, self.values)
            device.stream.record_event(self._event)
            self._is_sent = True

    def forget(self) -> None:
        """Discard the sent values, which are outdated."""
        self._is_sent = False

    def read(self, *, has_waited: bool = False) -> NDArray[Any]:
        """The values at the time of `send`, or the current ones. Sync unless the stream `has_waited` since."""
        if not self._is_sent:
            return download(self.values)
        with lock_for(self.values.device):
            if not has_waited:
                wp.synchronize_event(self._event)
            return self._host_view.copy()
