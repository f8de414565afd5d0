"""One GPU for each process: a locked file reserves it, and the system releases the lock when the process ends."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from ..core.devices import resolve_device
from ..core.errors import DeviceError

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None

LOCKS = "pointloom-gpus"  # in the temporary folder of the machine


@contextmanager
def reserved_device(device: str) -> Iterator[str]:
    """Reserve a device for this process: the CPU, which needs none, or a GPU that no other run of the machine uses.

    Args:
        device: "cpu", "cuda" for any GPU, or "cuda:1" for that one.

    Yields:
        Warp's name of the device.

    Raises:
        DeviceError: There is no such device, or none is free.
    """
    first = resolve_device(device)
    if not first.is_cuda:
        yield device
        return
    import warp as wp

    gpus = wp.get_cuda_devices() if device == "cuda" else [first]
    for gpu in gpus:
        lock = _lock(gpu.uuid)
        if lock is not None:
            break
    else:
        raise DeviceError(f"device: all of {len(gpus)} GPUs are in use by other workers or runs. Take fewer workers")
    try:
        yield gpu.alias
    finally:
        os.close(lock)


def _lock(uuid: str) -> int | None:
    """The descriptor of a GPU's lock, or None where another process holds it."""
    folder = Path(tempfile.gettempdir()) / LOCKS
    path = folder / uuid
    try:
        if not folder.is_dir():
            folder.mkdir(exist_ok=True)
            folder.chmod(0o1777)  # of all users of the machine
        try:
            lock = os.open(path, os.O_RDONLY)  # another user's is not written to
        except FileNotFoundError:
            lock = os.open(path, os.O_RDONLY | os.O_CREAT, 0o644)
    except OSError as error:
        raise DeviceError(f"device: {path}: the GPU cannot be locked: {error.strerror or error}") from error
    if fcntl is None:
        return lock
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        os.close(lock)
        return None
    return lock
