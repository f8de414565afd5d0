"""The functions of CUDA's driver that pointloom calls past Warp, as its library has them."""

from typing import Any

from .memory import Memory
from .settings import settings
from .streams import NON_BLOCKING, Stream, Streams, address_of

NAMES = ("libcuda.so.1", "libcuda.so", "nvcuda.dll")
SUCCESS, INVALID_VALUE, INVALID_DEVICE, INVALID_CONTEXT, INVALID_HANDLE = 0, 1, 101, 201, 400
OUT_OF_MEMORY, ALREADY_REGISTERED, NOT_REGISTERED = 2, 712, 713
CAPTURE_UNSUPPORTED = 900
RESERVED, USED = 5, 7  # attributes of a pool


def is_driver(name: str) -> bool:
    return name in NAMES


class Driver:
    """libcuda.so; each function returns CUDA's number of an error, 0 for none."""

    def __init__(self, streams: Streams, memory: Memory, pinned: dict[int, tuple[int, Any]]) -> None:
        self._streams, self._memory, self._pinned = streams, memory, pinned
        self.max_locked_bytes = 1 << 40  # a test may set another

    def cuStreamCreate(self, out: Any, flags: Any) -> int:
        """A stream of the current context; the flags select whether it and the legacy stream wait for each other."""
        number = getattr(flags, "value", flags)
        if self._streams.contexts[-1] is None:
            return INVALID_CONTEXT
        if number not in (0, NON_BLOCKING):
            return INVALID_VALUE
        out._obj.value = self._streams.add(Stream(0, blocks=number != NON_BLOCKING))
        return SUCCESS

    def cuStreamDestroy_v2(self, stream: Any) -> int:
        stream_object = self._streams.streams.pop(address_of(stream), None)
        if stream_object is None:
            return INVALID_HANDLE
        self._streams.flush(stream_object)
        return SUCCESS

    def cuStreamIsCapturing(self, stream: Any, out: Any) -> int:
        """Whether launches on a stream are recorded."""
        out._obj.value = self._streams.wp_cuda_stream_is_capturing(stream)
        return SUCCESS

    def cuEventCreate(self, out: Any, _: Any) -> int:
        """An event that nothing was recorded in yet."""
        if self._streams.contexts[-1] is None:
            return INVALID_CONTEXT
        out._obj.value = self._streams.wp_cuda_event_create()
        return SUCCESS

    def cuEventRecord(self, event: Any, stream: Any) -> int:
        """Record what a stream has queued, and which recording it belongs to."""
        self._streams.wp_cuda_event_record(event, stream)
        self._streams.named(event).capture = self._streams.stream(stream).capture
        return SUCCESS

    def cuStreamWaitEvent(self, stream: Any, event: Any, _: Any) -> int:
        """Queue a wait for an event. A stream that waits for a recorded one joins its recording."""
        waiting, capture = self._streams.stream(stream), self._streams.named(event).capture
        if capture and not waiting.capture:
            waiting.capture = capture
        elif not waiting.capture:
            self._streams.wp_cuda_stream_wait_event(stream, event)
        return SUCCESS

    def cuCtxSynchronize(self) -> int:
        """Wait for all streams."""
        return SUCCESS if self._streams.wp_cuda_context_synchronize(None) else CAPTURE_UNSUPPORTED

    def cuMemHostRegister_v2(self, pointer: Any, size: Any, flags: Any) -> int:
        """Lock the pages of host memory. A page is locked once at most."""
        if self._streams.contexts[-1] is None:
            return INVALID_CONTEXT
        if address_of(pointer) in self._pinned:
            return ALREADY_REGISTERED
        if sum(size for size, _ in self._pinned.values()) + size.value > self.max_locked_bytes:
            return OUT_OF_MEMORY
        self._pinned[address_of(pointer)] = (size.value, None)
        return SUCCESS

    def cuMemHostUnregister(self, pointer: Any) -> int:
        """Unlock pages after all queued copies to them."""
        self._streams.flush_all()
        return SUCCESS if self._pinned.pop(address_of(pointer), None) else NOT_REGISTERED

    def cuDeviceGraphMemTrim(self, _: Any) -> int:
        """Release memory of graphs, which keep none here."""
        return SUCCESS

    def cuDeviceGet(self, out: Any, ordinal: Any) -> int:
        if not 0 <= ordinal.value < settings.devices:
            return INVALID_DEVICE
        out._obj.value = ordinal.value
        return SUCCESS

    def cuDeviceGetDefaultMemPool(self, out: Any, device: Any) -> int:
        """The pool of a device: all devices share one."""
        out._obj.value = 0x900C + device.value
        return SUCCESS

    def cuMemPoolGetAttribute(self, _: Any, name: Any, out: Any) -> int:
        if name.value not in (RESERVED, USED):
            return INVALID_VALUE
        out._obj.value = self._memory.reserved if name.value == RESERVED else self._memory.used
        return SUCCESS

    def cuMemPoolTrimTo(self, _: Any, bytes_to_keep: Any) -> int:
        """Hand back what is not in use, but for so many bytes."""
        self._memory.trim(bytes_to_keep.value)
        return SUCCESS
