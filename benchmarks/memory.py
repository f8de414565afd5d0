"""Peak memory of one contestant at one operation, in a process of its own.

    python benchmarks/memory.py OPERATION SIZE CONTESTANT [DEVICE]

prints {"bytes": ...}: the most that was held while the operation ran beyond what was held before, when the data were
loaded and kernels compiled on small data. On the CPU it is resident memory (ru_maxrss) with freed memory given back
before; on a GPU the memory that the library took from the device.
"""

from __future__ import annotations

import ctypes
import gc
import json
import resource
import sys
from pathlib import Path

from contest import OURS, Contestant, Operation, Trial, limit_threads, operations


def peak_bytes(trial: Trial) -> int:
    """Bytes of resident memory that one call needs beyond what there is, the set-up of the call included."""
    _settle()
    before = _resident()
    held = trial.once()
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
    del held
    return max(0, peak - before)


def _settle() -> None:
    """Give freed memory back and forget the highest mark so far, so that both do not hide what comes."""
    gc.collect()
    try:
        ctypes.CDLL(None).malloc_trim(0)
        Path("/proc/self/clear_refs").write_text("5")  # Linux: ru_maxrss begins again at what is resident now
    except (OSError, AttributeError):
        return


def _resident() -> int:
    try:
        lines = Path("/proc/self/status").read_text().splitlines()
        return next(1024 * int(line.split()[1]) for line in lines if line.startswith("VmRSS"))
    except (OSError, StopIteration):
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024


def device_peak_bytes(trial: Trial, device: str, label: str) -> int:
    """Bytes of GPU memory that one call needs.

    Ours by the high mark of Warp's pool; peers by what is gone from the device afterward, since Open3D's cache keeps
    what it took.
    """
    import warp as wp

    wp.synchronize_device(device)
    if label == OURS:
        before = wp.get_mempool_used_mem_current(device)
        trial.once()
        return wp.get_mempool_used_mem_high(device) - before
    before = wp.get_device(device).free_memory
    held = trial.once()
    wp.synchronize_device(device)
    taken = before - wp.get_device(device).free_memory
    del held
    return max(0, taken)


def warm_up(operation: Operation, contestant: Contestant, device: str) -> None:
    """Compile kernels, load libraries and start threads on small data."""
    scene = next(iter(operation.quick.values()))()
    contestant.trial(scene, device).once()


def measure(operation_name: str, size: str, label: str, device: str) -> int:
    """The peak of one contestant, warmed up on the smallest data."""
    _, operation = operations()[operation_name]
    contestant, place = operation.contestant(label, device)
    warm_up(operation, contestant, place)
    scene = {**operation.quick, **operation.scenes}[size]()  # held until the end: its files go with it
    trial = contestant.trial(scene, place)
    return device_peak_bytes(trial, place, label) if place.startswith("cuda") else peak_bytes(trial)


if __name__ == "__main__":
    name, size, label, device = [*sys.argv[1:], "cpu"][:4]
    limit_threads(device)
    print(json.dumps({"bytes": measure(name, size, label, device)}))
