"""Copies from the host to a GPU whose source may change, or be released, as soon as the call returns.

CUDA reads page-locked memory when the stream reaches the copy: results of a GPU (pinned_results.py), torch's pinned
tensors. GPUs that access the pageable memory of the system may do the same with any array. Elsewhere the driver stages
up to 64 KB of pageable memory before the call returns, and for more the host waits for the earlier work of the stream
(CUDA C++ Programming Guide, "Asynchronous Concurrent Execution"; CUDA Runtime API, "API synchronization behavior").

So the host copies the bytes to page-locked pieces, which it fills while the GPU works. A piece is filled again after
the event that follows its last copy. Take the lock.
"""

from __future__ import annotations

import ctypes
from collections import deque
from typing import Any

import warp as wp
from numpy.typing import NDArray

from ..array_types import Device
from . import warp_parts
from .device_lock import lock, why_no_cuda_here
from .driver import driver
from .pinned_results import Buffer, pool

STAGED_BYTES = 1 << 16  # [B] the driver stages so much pageable memory without a wait
PIECE_BYTES = 1 << 22  # [B] of a piece: the GPU copies one while the host fills the next
_READS_PAGEABLE = "is_cpu_memory_access_from_gpu_supported"  # Warp's property of a device
MAX_PIECES = 16  # of a GPU: 64 MB, a color and depth image of 4,000 x 3,000 pixels


class _Piece:
    """Page-locked memory. `is_followed` is False while copies run that no event follows."""

    def __init__(self, buffer: Buffer, device: Device) -> None:
        self.buffer, self.event, self.is_followed = buffer, wp.Event(device), True
        self.used, self.stream = 0, None  # bytes in use, by copies of this stream

    @property
    def is_read(self) -> bool:
        """True if the GPU has read all."""
        return self.is_followed and self.event.is_complete

    def has_room(self, size: int, stream: object) -> bool:
        """True if another copy of the same stream fits."""
        return self.is_followed and self.stream is stream and size <= PIECE_BYTES - self.used

    def wait(self) -> None:
        """Wait until the GPU has read all."""
        if not self.is_followed:  # a copy was interrupted
            with self.event.device.context_guard:
                driver().cuCtxSynchronize()  # sync
        elif not self.event.is_complete:
            wp.synchronize_event(self.event)  # sync
        self.used, self.is_followed = 0, True

    def give_back(self) -> None:
        """Return the memory to the pool when the GPU has read it."""
        self.wait()
        pool.returned.append(self.buffer)


_pieces: dict[str, deque[_Piece]] = {}  # of each GPU, by its name; the one filled last is at the end


def send(device: Any, target: int, values: NDArray[Any]) -> None:
    """Copy a contiguous array to an address of a GPU."""
    if values.nbytes <= STAGED_BYTES and not getattr(device, _READS_PAGEABLE, True):
        pageable = values.copy()
        _copy(device, target, _address(pageable), values.nbytes)
        return
    source, end = _address(values), values.nbytes
    while end and (piece := _next_piece(device, end)) is not None:
        size = min(end, PIECE_BYTES - piece.used)
        staged = piece.buffer.address + piece.used
        ctypes.memmove(staged, source, size)
        piece.used, piece.is_followed = piece.used + size, False
        _copy(device, target, staged, size)
        device.stream.record_event(piece.event)
        piece.is_followed = True
        source, target, end = source + size, target + size, end - size
    if end:  # the system locks no memory
        _copy(device, target, source, end)
        wait_for_stream(device)  # sync


def wait_for_stream(device: Any) -> None:
    """Wait for the work of the current stream (sync)."""
    if not warp_parts.core().wp_cuda_stream_synchronize(device.stream.cuda_stream):
        raise RuntimeError(f"Failed to synchronize stream on device {device}: {device.runtime.get_error_string()}")


def _address(values: NDArray[Any]) -> int:
    return int(values.__array_interface__["data"][0])


def _copy(device: Any, target: int, source: int, size: int) -> None:
    checked(warp_parts.core().wp_memcpy_h2d(device.context, target, source, size, device.stream.cuda_stream), device)


def checked(done: object, device: Any) -> bool:
    """True if a copy of Warp's library has begun. Raises RuntimeError if not."""
    if not done:
        raise RuntimeError(f"Warp copy error: {device.runtime.get_error_string()}")
    return True


def _next_piece(device: Any, size: int) -> _Piece | None:
    """The piece filled last if there is room; else one that was read, a new one, or the one that is read first."""
    pieces = _pieces.setdefault(device.alias, deque())
    while pieces and pieces[0].buffer.fork_count != pool.fork_count:
        pieces.popleft().give_back()
    if pieces and pieces[-1].has_room(size, device.stream):
        return pieces[-1]
    if not pieces or (len(pieces) < MAX_PIECES and not pieces[0].is_read):
        buffer = pool.take(PIECE_BYTES, device.context_guard)
        if buffer is not None:
            pieces.appendleft(_Piece(buffer, device))
    if not pieces:
        return None
    pieces.rotate(-1)
    pieces[-1].wait()
    pieces[-1].stream = device.stream
    return pieces[-1]


def release_pieces() -> None:
    """Return the memory of uploads to the pool."""
    if why_no_cuda_here():
        return
    with lock:
        for pieces in _pieces.values():
            while pieces:
                pieces.popleft().give_back()
