"""Uploads of images through two page-locked buffers per GPU, which return before the GPU has the values.

CUDA copies more than 64 KB of other memory only after the earlier work of the stream, and the host waits (CUDA C++
Programming Guide, "Asynchronous Concurrent Execution"; CUDA Runtime API, "API synchronization behavior"). Warp does not
stage copies. The host fills one buffer while the GPU works on the values of the other. A buffer is filled again after
the event that follows its copies. Between uploads, idle memory belongs to the pool of results (pinned_results.py).
"""

from collections.abc import Sequence
from ctypes import c_ubyte
from typing import Any

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ..array_types import AnyArray, Device
from ..language.device_lock import lock, lock_for, why_no_cuda_here
from ..language.driver import driver
from ..language.pinned_results import Buffer, pool
from ..memory import on_give_back, write

MIN_PINNED_BYTES = 1 << 16  # [B] CUDA itself stages smaller copies, without a wait


class _Slot:
    """Page-locked memory of an upload. `is_followed` is False while copies run that no event follows."""

    def __init__(self, device: Device) -> None:
        self.buffer: Buffer | None = None
        self.event, self.is_followed = wp.Event(device), True

    def take(self, size: int) -> NDArray[np.uint8] | None:
        """Memory to fill. None if no more can be locked."""
        self.give_back()
        self.buffer = pool.take(size, self.event.device.context_guard)
        if self.buffer is None:
            return None
        return np.frombuffer(memoryview((c_ubyte * size).from_address(self.buffer.address)), np.uint8)

    def give_back(self) -> None:
        """Return the memory to the pool when the GPU has read it."""
        if self.buffer is None:
            return
        if not self.is_followed:  # an upload was interrupted
            with self.event.device.context_guard:
                driver().cuCtxSynchronize()  # sync
        elif not self.event.is_complete:
            wp.synchronize_event(self.event)  # sync
        buffer, self.buffer, self.is_followed = self.buffer, None, True
        pool.returned.append(buffer)


_slots: dict[str, list[_Slot]] = {}  # two of each GPU, by its name; the one filled last is at the end


def write_pinned(targets: Sequence[AnyArray], sources: Sequence[NDArray[Any]]) -> None:
    """Overwrite arrays of a GPU as `memory.write` does, but without a wait for its earlier work."""
    device, size = targets[0].device, sum(values.nbytes for values in sources)
    with lock_for(device):
        slot = _next_slot(device) if size > MIN_PINNED_BYTES and not device.captures else None
        memory = None if slot is None else slot.take(size)
        if slot is None or memory is None:
            for target, values in zip(targets, sources, strict=True):
                write(target, values)
            return
        first, slot.is_followed = 0, False
        for target, values in zip(targets, sources, strict=True):
            staged = memory[first : first + values.nbytes].view(values.dtype).reshape(values.shape)
            np.copyto(staged, values)
            write(target, staged)
            first += values.nbytes
        device.stream.record_event(slot.event)
        slot.is_followed = True


def _next_slot(device: Any) -> _Slot:
    if device.alias not in _slots:
        _slots[device.alias] = [_Slot(device), _Slot(device)]
    slots = _slots[device.alias]
    slots.reverse()
    return slots[-1]


def _give_back() -> None:
    if why_no_cuda_here():
        return
    with lock:
        for slots in _slots.values():
            for slot in slots:
                slot.give_back()


on_give_back.insert(0, _give_back)  # before the pool releases idle memory
