"""Contexts, streams and events: work is queued by stream and runs when something waits for it."""

import ctypes
import threading
import time
from collections import deque
from collections.abc import Callable
from typing import Any

from .findings import CudaFault, Findings, caller
from .settings import settings

CONTEXT = 0xC0DA0000
CURRENT_STREAM = 0xFFFFFFFFFFFFFFFF  # Warp's WP_CURRENT_STREAM
NOT_READY = 600  # cudaErrorNotReady
LEGACY, PER_THREAD = 1, 2  # CUDA's own names of its default streams, beside 0
NON_BLOCKING = 1  # a stream that the legacy one neither waits for nor is waited for by
LONG_QUEUE = 2000
Operation = Callable[[], Any]


def address_of(x: Any) -> int:
    if x is None or isinstance(x, int):
        return x or 0
    if isinstance(x, (ctypes.c_void_p, ctypes.c_uint64)):
        return x.value or 0
    return ctypes.cast(x, ctypes.c_void_p).value or 0


class Graph:
    def __init__(self, identity: int):
        self.identity = identity
        self.nodes: list[tuple[Operation, str]] = []

    def play(self) -> None:
        for operation, _ in list(self.nodes):
            operation()


class Stream:
    """A queue of operations; one that blocks and the legacy stream wait for each other."""

    def __init__(self, handle: int, priority: int = 0, *, blocks: bool = True):
        self.handle, self.priority, self.blocks = handle, priority, blocks
        self.queue: deque[Operation] = deque()
        self.capture: Graph | None = None


class Event:
    """A mark in a stream: the time at which it was passed, None before."""

    def __init__(self, stream: Stream | None = None):
        self.stream = stream
        self.capture: Any = None  # the recording that it belongs to
        self.passed: float | None = 0.0 if stream is None else None


class Streams:
    """The device's queues, its current state, and the handles given to Warp."""

    def __init__(self, findings: Findings):
        self.findings = findings
        self.lock = threading.RLock()
        self.handles: dict[int, Any] = {}
        self.next_handle = 0x1000
        self.legacy = Stream(0)
        self.streams: dict[int, Stream] = {0: self.legacy, LEGACY: self.legacy, PER_THREAD: Stream(PER_THREAD)}
        self.currents: dict[int, Stream] = {}  # by the context of a device
        self.of_thread = threading.local()
        self.captures = self.blocking_captures = 0
        self.after_wait: Operation = lambda: None  # what the device does whenever something has waited for it

    @property
    def contexts(self) -> list[int | None]:
        """The contexts of the calling thread, the current one last: CUDA stores them by thread."""
        if not hasattr(self.of_thread, "contexts"):
            self.of_thread.contexts = [None]
        return self.of_thread.contexts

    @property
    def current(self) -> Stream:
        """The stream of the device whose context is current."""
        return self.stream(CURRENT_STREAM)

    def handle(self, thing: Any) -> int:
        self.next_handle += 16
        self.handles[self.next_handle] = thing
        return self.next_handle

    def named(self, handle: Any) -> Any:
        return self.handles[address_of(handle)]

    def stream(self, handle: Any, context: Any = None) -> Stream:
        """The stream of a handle; the current one is that of a context, or of the current context."""
        number = address_of(handle)
        if number != CURRENT_STREAM:
            return self.streams[number]
        return self.currents.get(address_of(context) or self.contexts[-1] or CONTEXT, self.legacy)

    def enqueue(self, stream: Stream, operation: Operation, kind: str) -> None:
        """Queue an operation, or record it where the stream is captured."""
        if stream.capture is not None:
            stream.capture.nodes.append((operation, kind))
            return
        if stream is self.legacy:  # it waits for all others that block, and is waited for
            self.refuse_legacy()
            self.flush_blocking()
            operation()
            return
        if stream.blocks and self.legacy.queue:
            self.wait_for(stream, self.legacy)
        stream.queue.append(operation)
        if not settings.lazy or len(stream.queue) > LONG_QUEUE:
            self.flush(stream)

    def refuse_legacy(self) -> None:
        """The legacy stream waits for all others that block, which none that is captured allows."""
        if self.blocking_captures:
            refused = "operation would make the legacy stream depend on a capturing blocking stream"
            self.findings.fault(f"{refused} ({caller()})")

    def flush(self, stream: Stream, count: int | None = None) -> None:
        with self.lock:
            while stream.queue and count != 0:
                operation = stream.queue.popleft()
                try:
                    operation()
                except CudaFault:
                    stream.queue.clear()  # the context of a real device is lost; here what was queued is
                    raise
                if count is not None:
                    count -= 1

    def flush_all(self) -> None:
        for stream in list(self.streams.values()):
            self.flush(stream)

    def flush_blocking(self) -> None:
        """Run what the legacy stream waits for, and what is queued on it."""
        for stream in list(self.streams.values()):
            if stream.blocks:
                self.flush(stream)

    def _flush_until(self, event: Event) -> None:
        while event.passed is None and event.stream is not None and event.stream.queue:
            self.flush(event.stream, 1)

    def _record(self, stream: Stream) -> Event:
        event = Event(stream)
        stream.queue.append(lambda: setattr(event, "passed", time.perf_counter()))
        return event

    def wait_for(self, stream: Stream, other: Stream) -> None:
        """What a stream gets from now on comes after what another has now."""
        event = self._record(other)
        stream.queue.append(lambda: self._flush_until(event))

    def on_legacy(self, operation: Operation) -> None:
        """Run an operation on the legacy stream, after what is queued on it and on those that block."""
        busy = [s for s in self.streams.values() if s.queue and s.blocks]
        if not busy:
            operation()
            return
        last = self.current if self.current in busy else busy[0]
        for other in busy:
            if other is not last:
                self.wait_for(last, other)
        last.queue.append(operation)

    def wp_cuda_context_get_current(self):
        return self.contexts[-1]

    def wp_cuda_context_set_current(self, context):
        self.contexts[-1] = address_of(context) or None

    def wp_cuda_context_push_current(self, context):
        self.contexts.append(address_of(context))

    def wp_cuda_context_pop_current(self):
        if len(self.contexts) > 1:
            self.contexts.pop()

    def wp_cuda_context_get_device_ordinal(self, context):
        return (address_of(context) or CONTEXT) - CONTEXT

    def wp_cuda_context_get_stream(self, context):
        return self.currents.get(address_of(context) or CONTEXT, self.legacy).handle or None

    def wp_cuda_context_set_stream(self, context, stream, sync):
        key, new = address_of(context) or CONTEXT, self.stream(stream)
        old, self.currents[key] = self.currents.get(key, self.legacy), new
        if sync and old is not new and not self.captures:
            self.wait_for(new, old)

    def wp_cuda_context_synchronize(self, _):
        if self.captures:
            return self.findings.refuse(f"operation not permitted when stream is capturing: synchronize ({caller()})")
        self.findings.counts["waits"] += 1
        self.flush_all()
        self.after_wait()
        return True

    def wp_cuda_stream_create(self, _, priority):
        return self.add(Stream(0, priority))

    def add(self, stream: Stream) -> int:
        """A stream's handle."""
        stream.handle = self.handle(stream)
        self.streams[stream.handle] = stream
        return stream.handle

    def wp_cuda_stream_destroy(self, context, stream):
        stream_object = self.streams.get(address_of(stream))
        if stream_object is not None:
            self.wp_cuda_stream_unregister(context, stream)
            self.flush(stream_object)
            del self.streams[stream_object.handle]

    def wp_cuda_stream_unregister(self, context, stream):
        """Warp forgets a stream, the current one too: what it does by itself goes to the legacy stream then."""
        key = address_of(context) or CONTEXT
        if key in self.currents and self.currents[key].handle == address_of(stream):
            self.currents[key] = self.legacy

    def wp_cuda_stream_get_current(self):
        return self.current.handle or None

    def wp_cuda_stream_is_capturing(self, stream):
        return int(self.stream(stream).capture is not None)

    def wp_cuda_stream_is_blocking(self, stream):
        if self.stream(stream).capture:
            return self.findings.refuse(f"operation not permitted when stream is capturing: flags ({caller()})")
        return int(self.stream(stream).blocks)

    def wp_cuda_stream_get_priority(self, stream):
        return self.stream(stream).priority

    def wp_cuda_stream_get_capture_id(self, stream):
        capture = self.stream(stream).capture
        return capture.identity if capture else 0

    def wp_cuda_thread_exchange_capture_mode(self, mode):
        return mode

    def wp_cuda_stream_query(self, stream):
        stream_object = self.stream(stream)
        if not stream_object.queue:
            return 0
        self.flush(stream_object, len(stream_object.queue) // 2 + 1)  # repeated queries make progress
        return NOT_READY

    def wp_cuda_stream_synchronize(self, stream):
        stream_object = self.stream(stream)
        if stream_object.capture:
            return self.findings.refuse(f"operation not permitted when stream is capturing: synchronize ({caller()})")
        self.findings.counts["waits"] += 1
        self.flush(stream_object)
        self.after_wait()
        return True

    def wp_cuda_stream_wait_stream(self, stream, other, event, external=False):
        waiting, awaited = self.stream(stream), self.stream(other)
        if awaited.capture and not waiting.capture:
            waiting.capture = awaited.capture
        elif not waiting.capture:
            self.wait_for(waiting, awaited)

    def wp_cuda_event_create(self, *_):
        return self.handle(Event())

    def wp_cuda_event_destroy(self, event):
        self.handles.pop(address_of(event), None)

    def wp_cuda_event_record(self, event, stream, external=False):
        stream_object = self.stream(stream)
        self.handles[address_of(event)] = Event() if stream_object.capture else self._record(stream_object)

    def wp_cuda_event_query(self, event):
        return 0 if self.named(event).passed is not None else NOT_READY

    def wp_cuda_event_synchronize(self, event):
        self.findings.counts["waits"] += 1
        self._flush_until(self.named(event))
        self.after_wait()
        return True

    def wp_cuda_event_elapsed_time(self, start, end):
        return 1e3 * (self.named(end).passed - self.named(start).passed)

    def wp_cuda_stream_wait_event(self, stream, event, external=False):
        waiting, mark = self.stream(stream), self.named(event)
        if waiting.capture is None and mark.stream is not None:
            waiting.queue.append(lambda: self._flush_until(mark))
