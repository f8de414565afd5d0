"""Non-blocking streams of a GPU, and the order of memory releases.

The legacy stream, torch's default stream, and Warp's streams block each other. While a blocking stream records, any use
of the legacy stream fails in all threads. Torch's other streams do not block. If the library runs on one of them,
releases must wait for it, since Warp releases on the legacy stream.
"""

from __future__ import annotations

import ctypes
import functools
import weakref
from collections.abc import Callable
from typing import Any

import warp as wp

from ..array_types import Device
from .driver import driver

_NON_BLOCKING = 1  # CU_STREAM_NON_BLOCKING
_NO_TIMING = 2  # CU_EVENT_DISABLE_TIMING

# Non-blocking streams in use that no release has waited for: by handle the GPU, and whether the stream exists
used: dict[int, tuple[Any, Callable[[], Any]]] = {}


class NonBlockingStream(wp.Stream):
    """A GPU stream that does not synchronize with the legacy stream. Raises RuntimeError if the driver has none."""

    def __init__(self, device: Device) -> None:
        handle = ctypes.c_void_p()
        with device.context_guard:
            error = driver().cuStreamCreate(ctypes.byref(handle), ctypes.c_uint(_NON_BLOCKING))
        if error or not handle.value:
            raise RuntimeError(f"{device}: the driver makes no stream (CUDA error {error})")
        super().__init__(device, cuda_stream=handle.value)
        self._is_blocking = (
            False  # else Warp queries the driver, which breaks a recording of the stream (CUDA error 900)
        )

    def __del__(self) -> None:
        handle = self.cuda_stream
        super().__del__()
        _sorted.pop(handle, None)
        if handle and driver is not None:
            driver().cuStreamDestroy_v2(ctypes.c_void_p(handle))


def note_use(device: Device) -> Any:
    """Note that the current stream may have to be waited for before a release, and return it."""
    stream = device.stream
    if getattr(stream, "_is_blocking", None) is True:  # known to Warp
        return stream
    if not isinstance(stream, NonBlockingStream) and not _blocks(stream):
        is_torchs = getattr(stream, "_torch_stream", None) is not None  # which it never releases
        used[stream.cuda_stream] = device, (lambda: True) if is_torchs else weakref.ref(stream)
    return stream


def is_blocking(device: Device) -> bool:
    """True if the legacy stream of a GPU waits for its current stream."""
    return note_use(device).cuda_stream not in used


_sorted: dict[int, tuple[int, int]] = {}  # by handle of a non-blocking stream: most keys sorted there, and most bits


def wait_before_larger_scratch(device: Device, count: int, bits: int) -> None:
    """Wait before a sort of Warp on a non-blocking stream that needs more scratch than those before: Warp releases the
    former scratch on the legacy stream, which could run before the sort that uses it."""
    if is_blocking(device):
        return
    handle = device.stream.cuda_stream
    known = _sorted.get(handle, (0, 0))
    if (count > known[0] or bits > known[1]) and not _is_recorded(handle, device):
        _check(device, driver().cuCtxSynchronize())  # sync
        _sorted[handle] = max(count, known[0]), max(bits, known[1])


def _blocks(stream: Any) -> bool:
    """True if a stream synchronizes with the legacy stream. A recorded one of unknown kind counts as one that does
    not: a query would break the recording."""
    if getattr(stream, "_is_blocking", True) is None and _is_recorded(stream.cuda_stream, stream.device):
        return False
    return stream.is_blocking


def order_releases() -> None:
    """Make the legacy stream, which releases memory, wait for all non-blocking streams in use. If a stream's object is
    gone, the host waits. Recording streams are left out."""
    remaining = {}
    while used:
        handle, (device, stream) = used.popitem()
        with device.context_guard:
            if stream() is None:
                _check(device, driver().cuCtxSynchronize())  # sync
                continue
            is_recorded = _is_recorded(handle, device)
            if not is_recorded:
                wait_for(None, handle, device)
            if is_recorded or handle == device.stream.cuda_stream:
                remaining[handle] = device, stream
    used.update(remaining)


def wait_for(stream: int | None, other: int, device: Device) -> None:
    """Make a stream wait for another (CUDA handles, None: legacy), without a `wp.Stream`, which would unregister it."""
    with device.context_guard:
        event = _event(device.alias)
        _check(device, driver().cuEventRecord(event, ctypes.c_void_p(other)))
        _check(device, driver().cuStreamWaitEvent(ctypes.c_void_p(stream), event, ctypes.c_uint(0)))


@functools.cache
def _event(_: str) -> ctypes.c_void_p:
    """An event of a GPU, whose context is current. Its waits end with the call that makes them."""
    event = ctypes.c_void_p()
    if error := driver().cuEventCreate(ctypes.byref(event), ctypes.c_uint(_NO_TIMING)):
        raise RuntimeError(f"the driver makes no event (CUDA error {error})")
    return event


def _is_recorded(handle: int, device: Device) -> bool:
    status = ctypes.c_int()
    _check(device, driver().cuStreamIsCapturing(ctypes.c_void_p(handle), ctypes.byref(status)))
    return status.value != 0


def _check(device: Device, error: int) -> None:
    if error:
        raise RuntimeError(f"{device}: the driver does not order its streams (CUDA error {error})")
