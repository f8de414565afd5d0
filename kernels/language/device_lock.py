"""One lock around all that a device is asked to do: launches, copies, allocations, releases, recordings.

Neither Taichi's runtime nor Warp's state of a device is made for several Python threads: Warp has one stream a device,
which some of its functions swap for another one while they run, and what reaches a device during a recording becomes a
part of it or ends it. So threads take turns. The lock is held while a thread waits for the device, too.

What the program asks of Warp itself, beside this package, is outside the lock.
"""

from __future__ import annotations

import os
import threading
from collections import deque
from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext
from typing import Any

import warp as wp

lock = threading.RLock()
os.register_at_fork(after_in_child=lock._at_fork_reinit)  # type: ignore[attr-defined]  # another thread may have held it

_memory_of_host: AbstractContextManager[Any] = nullcontext()
_recording_streams: dict[str, wp.Stream] = {}  # by the name of the device
_released: deque[tuple[Any, Callable[[int, int], None], int, int]] = deque()


def turn_on(device: Any) -> AbstractContextManager[Any]:
    """The lock where the device is a GPU; nothing to wait for where its memory is the host's."""
    return _memory_of_host if getattr(device, "is_cpu", False) else lock


def own(values: Any) -> wp.array:
    """The array, whose memory will be released in turn; take the lock first.

    Python may drop an array in any thread and at any time, in the midst of another thread's recording too, and must not
    wait there: then the release is put off until the next array is made or dropped.
    """
    if values.device.is_cuda and values.deleter is not None:
        _release_pending()
        device, release = values.device, values.deleter

        def release_in_turn(address: int, size: int) -> None:
            _released.append((device, release, address, size))
            if lock.acquire(blocking=False):
                try:
                    _release_pending()
                finally:
                    lock.release()

        values.deleter = release_in_turn
    return values


def _release_pending() -> None:
    while _released:
        device, release, address, size = _released.popleft()
        with device.context_guard:
            release(address, size)


def run_while(condition: wp.array, body: Callable[[], None]) -> None:
    """Record a loop on a GPU as one graph with a conditional node, and launch it.

    The recording has a stream of its own: the device's may be the legacy one, on which nothing can be recorded, where
    the program has read arrays by Warp's own functions in several threads.

    Args:
        condition: int32 device array [1].
        body: Launches over arrays that exist already.
    """
    device: Any = condition.device
    with lock:
        if device.alias not in _recording_streams:
            _recording_streams[device.alias] = wp.Stream(device)
        stream = _recording_streams[device.alias]
        with wp.ScopedStream(stream, sync_enter=False), wp.ScopedCapture(stream=stream) as capture:
            wp.capture_while(condition, body)
        assert capture.graph is not None
        wp.capture_launch(capture.graph)
        del capture  # in turn
