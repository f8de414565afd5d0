"""Allocations, releases and copies, in the order that CUDA promises and no stronger."""

import ctypes
from typing import Any

from .findings import Findings, caller
from .graphs import Graphs
from .memory import FRESH, Memory
from .streams import CURRENT_STREAM, Streams, address_of

DEVICE_POINTER, PINNED_POINTER, HOST_POINTER = 4, 2, 1  # Warp's kinds of memory


class Allocations:
    def __init__(self, streams: Streams, memory: Memory, findings: Findings, graphs: Graphs):
        self.streams, self.memory, self.findings, self.graphs = streams, memory, findings, graphs
        self.pinned: dict[int, tuple[int, Any]] = {}
        streams.after_wait = lambda: memory.trim(memory.threshold)

    def _is_pinned(self, address: int) -> bool:
        return any(start <= address < start + size for start, (size, _) in self.pinned.items())

    def wp_cuda_pointer_get_memory_kind(self, _, pointer):
        if self.memory.contains(address_of(pointer)):
            return DEVICE_POINTER
        return PINNED_POINTER if self._is_pinned(address_of(pointer)) else HOST_POINTER

    def _allocate(self, size: int) -> int | None:
        if self.memory.used + size > self.memory.room:
            self.streams.flush_all()
        address = self.memory.allocate(size, caller())
        if not address:
            left = self.memory.room - self.memory.used
            self.findings.refuse(f"out of memory: {size} bytes, {left} free ({caller()})")
        return address or None

    def wp_alloc_pinned(self, size, tag=None):
        buffer = ctypes.create_string_buffer(size + 64)
        address = -(-ctypes.addressof(buffer) // 64) * 64
        ctypes.memset(address, FRESH, size)
        self.pinned[address] = (size, buffer)
        return address

    def wp_free_pinned(self, pointer):
        self.streams.flush_all()
        self.pinned.pop(address_of(pointer), None)

    def wp_alloc_device(self, context, size, tag=None):
        return self.wp_alloc_device_async(context, size, CURRENT_STREAM, tag)

    def wp_alloc_device_default(self, _, size, tag=None):
        if self.streams.captures:
            self.findings.refuse(f"operation not permitted when stream is capturing: cudaMalloc ({caller()})")
            return None
        self.streams.flush_all()
        return self._allocate(size)

    def wp_alloc_device_async(self, context, size, stream=CURRENT_STREAM, tag=None):
        self.findings.counts["allocations"] += 1
        address, capture = self._allocate(size), self.streams.stream(stream, context).capture
        if address and capture is not None:  # a graph's array is fresh in each launch
            capture.nodes.append((lambda: self.memory.freshen(address, size), "memory allocation"))
        return address

    def wp_free_device(self, context, pointer):
        self.wp_free_device_async(context, pointer)

    def wp_free_device_default(self, _, pointer):
        self.wp_free_device_async(_, pointer)
        if not self.streams.captures:
            self.streams.flush_all()

    def wp_free_device_async(self, _, pointer, node=None):
        address = address_of(pointer)
        if self.streams.captures:  # as Warp does
            self.graphs.put_off.append(lambda: self.memory.release(address))
        else:
            self.streams.on_legacy(lambda: self.memory.release(address))

    def wp_memcpy_h2d(self, context, dest, src, n, stream=CURRENT_STREAM):
        stream_object, to, source = self.streams.stream(stream, context), address_of(dest), address_of(src)
        if self.memory.contains(source):
            return self.findings.refuse(f"invalid argument: a copy to the device from device memory ({caller()})")
        self.findings.counts["copies to device"] += 1
        self.findings.counts["bytes to device"] += n
        is_pinned = self._is_pinned(source)
        if not is_pinned:
            if stream_object.capture is not None:
                self.findings.note("copies", "pageable host memory in a graph", caller())
            else:  # it is staged before the call returns; pinned memory is read when the copy runs
                source = ctypes.string_at(source, n) if n else b""

        def copy() -> None:
            ctypes.memmove(self.memory.real(to, n, "copy to", write=True), source, n)

        self.streams.enqueue(stream_object, copy, "memcpy")
        return True

    def wp_memcpy_d2h(self, context, dest, src, n, stream=CURRENT_STREAM):
        stream_object, to, source = self.streams.stream(stream, context), address_of(dest), address_of(src)
        where, is_pinned = caller(), self._is_pinned(to)

        def copy() -> None:
            real = self.memory.real(source, n, "copy from")
            if unwritten := self.memory.unwritten(source, n):
                text = f"{unwritten} of {n} bytes, {where}; {self.memory.describe(source)}"
                self.findings.note("copies", "uninitialized bytes copied to the host", text)
            ctypes.memmove(to, real, n)

        self.findings.counts["copies to host"] += 1
        self.findings.counts["bytes to host"] += n
        if stream_object.capture is not None and not is_pinned:
            self.findings.fault(f"a copy to pageable host memory in a capture: what is read is not there yet ({where})")
        self.streams.enqueue(stream_object, copy, "memcpy")
        if stream_object.capture is None and not is_pinned:
            self.streams.flush(stream_object)  # such a copy waits
        return True

    def wp_memcpy_d2d(self, context, dest, src, n, stream=CURRENT_STREAM):
        to, source = address_of(dest), address_of(src)
        self.streams.enqueue(self.streams.stream(stream, context), lambda: self.memory.copy(to, source, n), "memcpy")
        return True

    def wp_memcpy_p2p(self, context, dest, __, src, n, stream=CURRENT_STREAM):
        return self.wp_memcpy_d2d(context, dest, src, n, stream)

    def wp_memset_device(self, context, dest, value, n, stream=CURRENT_STREAM):
        to = address_of(dest)

        def fill() -> None:
            ctypes.memset(self.memory.real(to, n, "memset", write=True), value, n)

        self.streams.enqueue(self.streams.stream(stream, context), fill, "memset")
        return True

    def wp_memtile_device(self, context, dest, src, size, count):
        to, data = address_of(dest), ctypes.string_at(address_of(src), size) * count

        def fill() -> None:
            ctypes.memmove(self.memory.real(to, len(data), "fill", write=True), data, len(data))

        self.streams.enqueue(self.streams.stream(CURRENT_STREAM, context), fill, "kernel launch")
