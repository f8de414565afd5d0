"""One lock per process for launches, copies, allocations, releases, and recordings.

Neither Taichi's runtime nor Warp's device state is thread-safe: some Warp functions swap a device's stream, and any
call during a recording joins or breaks it. The lock is held while a thread waits for the device. Direct Warp calls of
the program are not covered.
"""

from __future__ import annotations

import os
import threading
from collections import deque
from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext
from functools import partial
from typing import Any

import warp as wp

from ..array_types import Device
from .streams import NonBlockingStream, note_use, order_releases, used

lock = threading.RLock()
_memory_of_host: AbstractContextManager[Any] = nullcontext()
_recording_streams: dict[str, wp.Stream] = {}  # by device name
waiting: deque[tuple[Device | None, Callable[[int, int], None], int, int]] = deque()  # releases
_is_without_cuda = False  # since the fork


def _after_fork() -> None:
    global _is_without_cuda
    lock._at_fork_reinit()  # type: ignore[attr-defined]  # another thread may have held it
    waiting.clear()  # released by the parent
    _is_without_cuda = wp.is_cuda_available()


if hasattr(os, "register_at_fork"):  # not on Windows
    os.register_at_fork(after_in_child=_after_fork)


def why_no_cuda_here() -> str:
    """Reason why this process cannot use Warp's GPUs. Empty if it can."""
    if not _is_without_cuda:
        return ""
    return (
        "this process was forked from one that had started CUDA, which does not come along; start workers with "
        "multiprocessing.get_context('spawn'), or fork before pointloom is used"
    )


def lock_for(device: Device | str) -> AbstractContextManager[Any]:
    """The lock for a GPU, else a null context. Raises RuntimeError if the process was forked after CUDA started."""
    if getattr(device, "is_cpu", False):
        return _memory_of_host
    if _is_without_cuda:
        raise RuntimeError(f"{device}: {why_no_cuda_here()}")
    return lock


def own(values: Any) -> wp.array:
    """Arrange the release of an array under the lock. Take the lock first. Garbage collection may occur in any thread
    and must not block: the release is then deferred to the next allocation or release."""
    if values.device.is_cuda and values.deleter is not None:
        release_pending()
        note_use(values.device)
        device, release = values.device, values.deleter
        values.deleter = partial(release_under_lock, device, release)
    return values


def release_under_lock(
    device: Device, release: Callable[[int, int], None], address: int, size: int, *, sets_context: bool = False
) -> None:
    """Release memory now, or later if another thread has the lock. `sets_context`: `release` sets the CUDA context."""
    if _is_without_cuda:
        return  # owned by the parent
    note_use(device)
    if sets_context and not waiting and not used and lock.acquire(blocking=False):
        try:
            release(address, size)
        finally:
            lock.release()
        return
    waiting.append((None if sets_context else device, release, address, size))
    if lock.acquire(blocking=False):
        try:
            release_pending()
        finally:
            lock.release()


def release_pending() -> None:
    """Run deferred releases. Take the lock."""
    if waiting:
        order_releases()
    while waiting:
        device, release, address, size = waiting.popleft()
        if device is None:
            release(address, size)
            continue
        with device.context_guard:
            release(address, size)


def release_all() -> None:
    """Run deferred releases (take the lock) and recreate the streams of recordings."""
    release_pending()
    _recording_streams.clear()


class Recording:
    """Capture the launches of `body` as one CUDA graph. Its arrays must stay where they are. Take the lock. The stream
    is non-blocking (streams.py), so that other libraries can use the legacy stream meanwhile."""

    def __init__(self, device: Device, body: Callable[[], None]) -> None:
        self._device, self._graphs = device, []
        note_use(device)
        order_releases()  # Warp defers releases until the recording ends
        if device.alias not in _recording_streams:
            _recording_streams[device.alias] = NonBlockingStream(device)
        stream = _recording_streams[device.alias]
        try:
            with wp.ScopedStream(stream, sync_enter=False), wp.ScopedCapture(stream=stream) as capture:
                body()
        except BaseException as error:
            del _recording_streams[device.alias]  # in any state
            if isinstance(error, _Stopped):
                raise error.reason from None
            raise
        assert capture.graph is not None
        self._graphs.append(capture.graph)

    def launch(self) -> None:
        """Run asynchronously, after earlier work of the device."""
        note_use(self._device)
        wp.capture_launch(self._graphs[0])

    def __del__(self) -> None:
        graphs = getattr(self, "_graphs", None)
        if graphs:
            release_under_lock(self._device, lambda _address, _size: graphs.clear(), 0, 0)


class RecordedLoop(Recording):
    """A GPU loop as one graph with a conditional node: runs `body` until `condition` (int32 [1]) is zero."""

    def __init__(self, condition: wp.array, body: Callable[[], None]) -> None:
        super().__init__(condition.device, lambda: record_loop(condition, body))


def record_loop(condition: wp.array, body: Callable[[], None]) -> None:
    """Add a loop to the graph that is being captured."""
    wp.capture_while(condition, _stoppable(body))


def record(device: Device, body: Callable[[], None]) -> Recording:
    """Capture `body` as one graph for `replay`, without running it. Its arrays must exist and outlive the graph."""
    with lock:
        return Recording(device, body)


def replay(recording: Recording) -> None:
    """Run a recording after earlier work of the device."""
    with lock:
        recording.launch()


class _Stopped(Exception):  # noqa: N818
    """Wraps exceptions such as KeyboardInterrupt: Warp ends a recording only for Exception."""

    def __init__(self, reason: BaseException) -> None:
        self.reason = reason


def _stoppable(body: Callable[[], None]) -> Callable[[], None]:
    def run() -> None:
        try:
            body()
        except Exception:
            raise
        except BaseException as error:
            raise _Stopped(error) from None

    return run
