"""An allocation of the emulated device that fails, at a place of its own: memory that runs out in mid-operation."""

import contextlib
from collections.abc import Callable, Iterator
from types import SimpleNamespace
from typing import Any

from .install import Device


@contextlib.contextmanager
def failing_allocation(device: Device, number: int | None = None) -> Iterator[SimpleNamespace]:
    """Count the allocations in here; the one of this number, from 1 on, fails."""
    allocations, allocated = device.part("_allocate"), SimpleNamespace(count=0)
    real: Callable[[int], Any] = allocations._allocate

    def allocate(size: int) -> int | None:
        allocated.count += 1
        if allocated.count == number:
            device.findings.refuse(f"out of memory: {size} bytes, as a test wants it")
            return None
        return real(size)

    allocations._allocate = allocate
    try:
        with device.findings.expected() if number else contextlib.nullcontext():
            yield allocated
    finally:
        del allocations._allocate
