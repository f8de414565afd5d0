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
from functools import partial
from typing import Any

import warp as wp

from ..array_types import Device
from .streams import NonBlockingStream, note_use, order_releases

lock = threading.RLock()
_memory_of_host: AbstractContextManager[Any] = nullcontext()
_recording_streams: dict[str, wp.Stream] = {}  # by the name of the device
waiting: deque[tuple[Device | None, Callable[[int, int], None], int, int]] = deque()  # releases
_is_without_cuda = False  # since it was forked


def _after_fork() -> None:
    global _is_without_cuda
    lock._at_fork_reinit()  # type: ignore[attr-defined]  # another thread may have held it
    waiting.clear()  # what the parent will release
    _is_without_cuda = wp.is_cuda_available()


if hasattr(os, "register_at_fork"):  # not on Windows
    os.register_at_fork(after_in_child=_after_fork)


def why_no_cuda_here() -> str:
    """Why this process cannot use the GPUs that Warp sees; empty where it can."""
    if not _is_without_cuda:
        return ""
    return (
        "this process was forked from one that had started CUDA, which does not come along; start workers with "
        "multiprocessing.get_context('spawn'), or fork before pointloom is used"
    )


def turn_on(device: Device | str) -> AbstractContextManager[Any]:
    """The lock where the device is a GPU; nothing to wait for where its memory is the host's.

    Raises:
        RuntimeError: The device is a GPU, and this process was forked from one that had started CUDA.
    """
    if getattr(device, "is_cpu", False):
        return _memory_of_host
    if _is_without_cuda:
        raise RuntimeError(f"{device}: {why_no_cuda_here()}")
    return lock


def own(values: Any) -> wp.array:
    """The array, whose memory will be released in turn; take the lock first.

    Python may drop an array in any thread and at any time, in the midst of another thread's recording too, and must not
    wait there: then the release is put off until the next array is made or dropped.
    """
    if values.device.is_cuda and values.deleter is not None:
        release_pending()
        note_use(values.device)
        device, release = values.device, values.deleter
        values.deleter = partial(release_in_turn, device, release)
    return values


def release_in_turn(
    device: Device, release: Callable[[int, int], None], address: int, size: int, *, sets_context: bool = False
) -> None:
    """Release memory at once, or where another thread is at the device, when the next array is made or dropped.

    `sets_context` says that what releases sets its context itself.
    """
    if _is_without_cuda:
        return  # it is the parent's
    note_use(device)
    waiting.append((None if sets_context else device, release, address, size))
    if lock.acquire(blocking=False):
        try:
            release_pending()
        finally:
            lock.release()


def release_pending() -> None:
    """Release what had to wait; take the lock."""
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
    """Release what had to wait for the lock, which is taken, and the streams of recordings, which are made again."""
    release_pending()
    _recording_streams.clear()


class Recording:
    """What a body asks of a GPU as one graph, to be launched as often as wanted; nothing is run before.

    The recording has a stream of its own, which does not block (streams.py): so other libraries go on with their work
    on the legacy stream meanwhile. The device's may be that one, on which nothing can be recorded, where the program
    has read arrays by Warp's own functions in several threads. Take the lock before it is made or launched.

    Args:
        device: The GPU.
        body: Launches over arrays that exist already, and stay where they are while the graph is launched.
    """

    def __init__(self, device: Any, body: Callable[[], None]) -> None:
        self._device, self._graphs = device, []
        note_use(device)
        order_releases()  # Warp puts releases off until the recording ends
        if device.alias not in _recording_streams:
            _recording_streams[device.alias] = NonBlockingStream(device)
        stream = _recording_streams[device.alias]
        try:
            with wp.ScopedStream(stream, sync_enter=False), wp.ScopedCapture(stream=stream) as capture:
                body()
        except BaseException as error:
            del _recording_streams[device.alias]  # whatever state it is in
            if isinstance(error, _Stopped):
                raise error.reason from None
            raise
        assert capture.graph is not None
        self._graphs.append(capture.graph)

    def launch(self) -> None:
        """Run it, behind what the device was asked to do; returns before it has ended."""
        note_use(self._device)
        wp.capture_launch(self._graphs[0])

    def __del__(self) -> None:
        """Release the graph in turn, as `own` does with arrays."""
        graphs = getattr(self, "_graphs", None)
        if graphs:
            release_in_turn(self._device, lambda _address, _size: graphs.clear(), 0, 0)


class RecordedLoop(Recording):
    """A loop on a GPU as one graph with a conditional node, which runs until the condition is zero.

    Args:
        condition: int32 device array [1].
        body: As of Recording.
    """

    def __init__(self, condition: wp.array, body: Callable[[], None]) -> None:
        super().__init__(condition.device, lambda: wp.capture_while(condition, _stoppable(body)))


def record(device: Device, body: Callable[[], None]) -> Recording:
    """What a body asks of a GPU as one graph, for `replay`; nothing is run.

    Args:
        device: The GPU.
        body: Launches, fills and scans over arrays that exist already and outlive the graph.
    """
    with lock:
        return Recording(device, body)


def replay(recording: Recording) -> None:
    """Run what was recorded, behind what the device was asked to do."""
    with lock:
        recording.launch()


class _Stopped(Exception):  # noqa: N818
    """Stands for what is no Exception: Warp ends the recording of a body for those alone, and Ctrl-C is none."""

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
