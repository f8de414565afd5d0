"""Number of GPUs, synchronization with them, and their unused memory."""

from __future__ import annotations

from typing import Any

from ....core.device_memory import free_memory
from ....core.devices import resolve_device
from ....kernels.language.device_lock import lock_for
from ..device import Device


def device_count() -> int:
    import warp as wp

    from ....core import devices  # noqa: F401

    return wp.get_cuda_device_count()


def is_available() -> bool:
    return device_count() > 0


def synchronize(device: Device | Any = None) -> None:
    """Wait until a GPU has finished its work. All of them if `device` is None."""
    import warp as wp

    if not is_available():
        return
    for each in wp.get_cuda_devices() if device is None else [resolve_device(Device(device).name)]:
        with lock_for(each):
            wp.synchronize_device(each)


def release_cache() -> None:
    """Return unused GPU memory to the system."""
    free_memory()
