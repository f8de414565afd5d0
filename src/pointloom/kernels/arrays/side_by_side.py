"""Small arrays packed into one allocation: one copy to the device, one sync to read them back."""

from collections.abc import Hashable, Mapping, Sequence
from typing import Any, Generic, TypeVar

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ..array_types import AnyArray, Device, DeviceArray, Element
from ..lang import uint8
from ..language.device_arrays import element_kind, reinterpreted
from ..language.device_lock import lock_for
from ..memory import contiguous, copy, download, empty, upload, write

Name = TypeVar("Name", bound=Hashable)
ALIGNMENT_BYTES = 256  # bytes, as of separate allocations


def part_of(
    buffer: AnyArray, first: int, dtype: type[Element], shape: int | tuple[int, ...]
) -> DeviceArray[Element, Any]:
    """View of a device array from a byte offset on as another type. Keeps the array alive."""
    view: Any = reinterpreted(buffer, first, dtype, shape)
    if view is not None:
        return view
    with lock_for(buffer.device):
        part = wp.array(ptr=buffer.ptr + first, dtype=dtype, shape=shape, device=buffer.device, copy=False)
    part._ref = buffer
    return part


def read_together(arrays: Sequence[AnyArray]) -> list[NDArray[Any]]:
    """`download` of several arrays on one device with one sync."""
    if len(arrays) == 1 or not arrays[0].device.is_cuda:
        return [download(values) for values in arrays]
    kinds = [element_kind(values.dtype) for values in arrays]
    sizes = [values.size * kind.element_bytes for values, kind in zip(arrays, kinds, strict=True)]
    buffer, first, firsts = empty(sum(sizes), uint8, arrays[0].device), 0, [0] * len(arrays)
    for k in sorted(
        range(len(arrays)), key=lambda k: -kinds[k].scalar.itemsize
    ):  # largest elements first, for alignment
        if sizes[k]:
            copy(buffer, part_of(contiguous(arrays[k]), 0, uint8, sizes[k]), count=sizes[k], offset=first)
        firsts[k], first = first, first + sizes[k]
    host, results = download(buffer), []  # sync
    for values, kind, begin, size in zip(arrays, kinds, firsts, sizes, strict=True):
        results.append(host[begin : begin + size].view(kind.scalar).reshape(*values.shape, *kind.inner))
    return results


class SideBySide(Generic[Name]):
    """Arrays packed into one allocation, by name with element types. Each device view keeps it alive."""

    def __init__(self, values: Mapping[Name, tuple[ArrayLike, Any]], device: Device) -> None:
        hosts = {name: _as_elements(*value) for name, value in values.items()}
        self._layout: dict[Name, tuple[int, int, tuple[int, ...], np.dtype]] = {}  # first byte, size, shape, type
        size = 0
        for name, host in hosts.items():
            self._layout[name] = (size, host.nbytes, host.shape, host.dtype)
            size += -(-max(host.nbytes, 1) // ALIGNMENT_BYTES) * ALIGNMENT_BYTES
        self._content = np.zeros(size, np.uint8)  # as uploaded last
        self._set(hosts)
        self._buffer = upload(self._content, uint8, device)
        self.arrays: dict[Name, DeviceArray[Any, Any]] = {}
        for name, (_, dtype) in values.items():
            first, _, shape, _ = self._layout[name]
            width = len(getattr(dtype, "_shape_", ()))
            self.arrays[name] = part_of(self._buffer, first, dtype, shape[: len(shape) - width] if width else shape)

    def _set(self, hosts: Mapping[Name, np.ndarray]) -> None:
        for name, host in hosts.items():
            first, size, _, _ = self._layout[name]
            self._content[first : first + size] = host.reshape(-1).view(np.uint8)

    def rewrite(self, values: Mapping[Name, tuple[ArrayLike, Any]]) -> None:
        """Overwrite all arrays in one copy: with values of the same shapes, the others with their last ones."""
        self._set({name: _as_elements(*value) for name, value in values.items()})
        write(self._buffer, self._content)

    def download(self, *names: Name) -> dict[Name, np.ndarray]:
        """The named arrays, or all, as NumPy by name: views on the CPU, one sync on a GPU."""
        buffer = download(self._buffer)  # sync
        chosen = {}
        for name in names or self._layout:
            first, size, shape, dtype = self._layout[name]
            chosen[name] = buffer[first : first + size].view(dtype).reshape(shape)
        return chosen


def _as_elements(value: ArrayLike, dtype: Any) -> np.ndarray:
    return np.ascontiguousarray(value, dtype=wp.dtype_to_numpy(getattr(dtype, "_wp_scalar_type_", dtype)))
