"""Warp's own device functions (fill, strided copies, scans, radix sort): its host versions over the device's bytes."""

import ctypes
import functools
from typing import Any

from .findings import UNWRITTEN, CudaFault, Findings
from .memory import FRESH, Memory
from .streams import CURRENT_STREAM, Streams, address_of

PLAIN, INDEXED = 0, 1  # Warp's kinds of arrays
WIDTHS = {"int": 4, "uint": 4, "int64": 8, "uint64": 8, "float": 4, "double": 8}


class Arrays:
    """Functions of warp.so for which there is a host version."""

    def __init__(self, real: ctypes.CDLL, streams: Streams, memory: Memory, findings: Findings):
        self.real, self.streams, self.memory, self.findings = real, streams, memory, findings
        for name in WIDTHS:
            setattr(self, f"wp_radix_sort_pairs_{name}_device", functools.partial(self._sort, name))
            if not name.startswith("uint"):
                setattr(self, f"wp_array_scan_{name}_device", functools.partial(self._scan, name))

    def _queue(self, operation: Any, context: Any = None) -> bool:
        self.streams.enqueue(self.streams.stream(CURRENT_STREAM, context), operation, "kernel launch")
        return True

    def _description(self, pointer: Any, kind: int) -> Any:
        """A copy of an array's description, as it is at the call."""
        import warp._src.types as types

        structure = {PLAIN: types.array_t, INDEXED: types.indexedarray_t}[kind]
        return structure.from_buffer_copy(ctypes.string_at(address_of(pointer), ctypes.sizeof(structure)))

    def _located(self, described: Any, kind: int, size: int, *, write: bool) -> Any:
        """The description with pointers that the host can follow; a fault where it leaves its arrays."""
        array = type(described).from_buffer_copy(bytes(described))
        plain = array if kind == PLAIN else array.data
        shape, strides = plain.shape[: plain.ndim], plain.strides[: plain.ndim]
        if kind == INDEXED:
            for axis in range(plain.ndim):
                if array.indices[axis]:
                    array.indices[axis] = self._checked_indices(array.indices[axis], array.shape[axis], shape[axis])
        if all(shape):
            offsets = [(n - 1) * stride for n, stride in zip(shape, strides, strict=True)]
            low, high = sum(min(0, r) for r in offsets), sum(max(0, r) for r in offsets) + size
            plain.data = self.memory.real(plain.data + low, high - low, "array", write=write) - low
        return array

    def _checked_indices(self, pointer: int, count: int, length: int) -> int:
        real = self.memory.real(pointer, 4 * count, "indices")
        rows = (ctypes.c_int32 * count).from_address(real)
        if count and not (min(rows) >= 0 and max(rows) < length):
            raise CudaFault(f"illegal address: an index outside 0..{length - 1} in an indexed array")
        return real

    def wp_array_copy_device(self, context, dst, src, dst_kind, src_kind, size):
        to, source = self._description(dst, dst_kind), self._description(src, src_kind)

        def copy() -> None:
            a, b = self._located(to, dst_kind, size, write=True), self._located(source, src_kind, size, write=False)
            if not self.real.wp_array_copy_host(ctypes.byref(a), ctypes.byref(b), dst_kind, src_kind, size):
                raise CudaFault("array copy failed")

        return self._queue(copy, context)

    def wp_array_fill_device(self, context, array, kind, value, size):
        described, data = self._description(array, kind), ctypes.string_at(address_of(value), size)

        def fill() -> None:
            located = self._located(described, kind, size, write=True)
            self.real.wp_array_fill_host(ctypes.byref(located), kind, data, size)

        self._queue(fill, context)

    def _scan(self, name, source, out, count, in_stride, out_stride, length, inclusive):
        scan = getattr(self.real, f"wp_array_scan_{name}_host")
        width = WIDTHS[name] * length

        def run() -> None:
            f = self.memory.real(source, (count - 1) * in_stride + width, "scan")
            t = self.memory.real(out, (count - 1) * out_stride + width, "scan", write=True)
            scan(f, t, count, in_stride, out_stride, length, inclusive)

        return self._queue(run)

    def _sort(self, name, keys, values, count, begin, end, value_size):
        sort, width = getattr(self.real, f"wp_radix_sort_pairs_{name}_host"), WIDTHS[name]

        def run() -> None:
            areas = []
            for address, size in ((keys, width * count), (values, value_size * count)):
                areas.append((self.memory.real(address, 2 * size, "sort"), size))
                if self.memory.unwritten(address, size):
                    self.findings.note("radix sort", UNWRITTEN, "keys or values")
            sort(areas[0][0], areas[1][0], count, begin, end, value_size)
            for real, size in areas:
                ctypes.memset(real + size, FRESH, size)  # scratch: undefined afterward

        self._queue(run)
