"""What a worker process has to itself: its share of the cores, and one GPU that no other run of the machine works on.

Who works on a GPU is told by a locked file, which the system lets go of however the processes end that hold it, a
runner and its worker.
"""

from __future__ import annotations

import os
import sys
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NamedTuple

from ..core.devices import resolve_device
from ..core.errors import DeviceError

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None

LOCKS = "pointloom-gpus"  # in the temporary folder of the machine


class Gpu(NamedTuple):
    """A GPU that this process holds: Warp's name, what CUDA_VISIBLE_DEVICES calls it, the descriptor of its lock."""

    alias: str
    name: str
    lock: int


@contextmanager
def held_gpus(device: Any, count: int) -> Iterator[list[Gpu]]:
    """So many GPUs that are this process's as long as the block; none for a CPU.

    Args:
        device: "cpu", "cuda" for any, or "cuda:1" for that one.
        count: How many.

    Raises:
        DeviceError: There is no such device, or fewer are free.
    """
    found = resolve_device(device)
    if not found.is_cuda:
        yield []
        return
    known = _known() if device == "cuda" else [(found.alias, found.uuid, _visible_name(found))]
    held: list[Gpu] = []
    try:
        for alias, uuid, name in known:
            lock = _lock(uuid)
            if lock is not None:
                held.append(Gpu(alias, name, lock))
            if len(held) == count:
                break
        if len(held) < count:
            reason = f"{len(held)} of {len(known)} GPUs are free, other runs work on the rest; {count} are wanted"
            raise DeviceError(f"device: {reason}, one a process")
        yield held
    finally:
        for gpu in held:
            os.close(gpu.lock)


def environment_of(count: int, gpu: Sequence[Gpu] = ()) -> dict[str, str]:
    """The environment of one of so many processes: modules as here, its share of the cores, and one GPU alone."""
    threads = os.environ.get("POINTLOOM_CPU_THREADS") or str(max(1, (os.cpu_count() or 1) // count))
    paths = os.pathsep.join(path or os.getcwd() for path in sys.path)  # noqa: PTH109
    told = {**os.environ, "PYTHONPATH": paths, "POINTLOOM_CPU_THREADS": threads}
    return told | ({"CUDA_VISIBLE_DEVICES": gpu[0].name} if gpu else {})


def _known() -> list[tuple[str, str, str]]:
    import warp as wp

    return [(found.alias, found.uuid, _visible_name(found)) for found in wp.get_cuda_devices()]


def _visible_name(found: Any) -> str:
    """What CUDA_VISIBLE_DEVICES calls a device: as the user has it there, else by its UUID."""
    names = [name for name in os.environ.get("CUDA_VISIBLE_DEVICES", "").split(",") if name]
    return names[found.ordinal] if found.ordinal < len(names) else found.uuid


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
