"""Streams of a GPU that stand apart from CUDA's legacy one, and what that asks for.

The legacy stream, torch's default one, and the streams that Warp makes wait for each other: that is what CUDA calls
blocking. While such a stream records, nobody may use the legacy stream, in any thread: the recording would end with an
error, and so would what the other thread asked for. A stream that does not block has no part in that.

Torch's other streams do not block. Where a program has put our work on one, memory must be released behind it: Warp
releases on the legacy stream, which does not wait for it unless it is told to.
"""

from __future__ import annotations

import ctypes
import weakref
from collections.abc import Callable
from typing import Any

import warp as wp
from warp._src import context

from .driver import driver

_NON_BLOCKING = 1  # CU_STREAM_NON_BLOCKING

# Streams that do not block, with work of ours that no release has waited for: by handle the GPU, and whether it lives
_used: dict[int, tuple[Any, Callable[[], Any]]] = {}


class NonBlockingStream(wp.Stream):
    """A stream of a GPU that does not wait for the legacy stream, nor that for it.

    Args:
        device: The GPU.

    Raises:
        RuntimeError: The driver has none.
    """

    def __init__(self, device: Any) -> None:
        handle = ctypes.c_void_p()
        with device.context_guard:
            error = driver().cuStreamCreate(ctypes.byref(handle), ctypes.c_uint(_NON_BLOCKING))
        if error or not handle.value:
            raise RuntimeError(f"{device}: the driver makes no stream (CUDA error {error})")
        super().__init__(device, cuda_stream=handle.value)

    def __del__(self) -> None:
        handle = self.cuda_stream
        super().__del__()
        if handle and driver is not None:
            driver().cuStreamDestroy_v2(ctypes.c_void_p(handle))


def note_use(device: Any) -> None:
    """What is asked of a GPU now may be on a stream that the release of memory does not wait for by itself."""
    stream = device.stream
    if not stream.is_blocking and not isinstance(stream, NonBlockingStream):
        is_torchs = getattr(stream, "_torch_stream", None) is not None  # which it never gives up
        _used[stream.cuda_stream] = device, (lambda: True) if is_torchs else weakref.ref(stream)


def order_releases() -> None:
    """Have the legacy stream, on which Warp releases memory, wait for all streams in use that it does not wait for.

    A stream is waited for as long as work goes there, and once more after it; the host waits instead where its object
    is gone, and with it perhaps the stream. One that somebody records is left out.
    """
    kept = {}
    while _used:
        handle, (device, stream) = _used.popitem()
        with device.context_guard:
            if stream() is None:
                context.runtime.core.wp_cuda_context_synchronize(device.context)  # sync
                continue
            is_recorded = context.runtime.core.wp_cuda_stream_is_capturing(handle)
            if not is_recorded:
                wait_for(None, handle, device)
            if is_recorded or handle == device.stream.cuda_stream:
                kept[handle] = device, stream
    _used.update(kept)


def wait_for(stream: int | None, other: int, device: Any) -> None:
    """What a stream gets from now on comes after what another has; both by CUDA's handles, None for the legacy one.

    Without a `wp.Stream` of the other's: Warp would forget the stream with that object, whoever else has one of it.
    """
    event = device.stream.cached_event.cuda_event
    context.runtime.core.wp_cuda_stream_wait_stream(stream, other, event, False)
