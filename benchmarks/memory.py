"""Peak memory of one contestant at one operation, in a separate process.

    python benchmarks/memory.py MODULE OPERATION SIZE CONTESTANT [DEVICE]

prints {"bytes": ...}: the peak memory during the operation minus the memory before it, after loading the data and
compiling kernels on small data. On the CPU this is resident memory, with freed memory released first; on a GPU it is
device memory. ru_maxrss, the usual peak, also counts that of the program that started the process.
"""

from __future__ import annotations

import ctypes
import gc
import importlib
import json
import resource
import sys
from pathlib import Path

from contest import POINTLOOM, Contestant, Operation, Trial, limit_threads


def peak_bytes(trial: Trial) -> int:
    """Additional resident memory [bytes] of one call, including its set-up."""
    release_memory()
    before = resident_bytes()
    result = trial.once()
    peak = resident_bytes("VmHWM")
    del result
    return max(0, peak - before)


def release_memory() -> None:
    """Release freed memory and reset the high-water mark, which would hide the call's memory."""
    gc.collect()
    try:
        ctypes.CDLL(None).malloc_trim(0)
        Path("/proc/self/clear_refs").write_text("5")  # Linux: resets the peak to the current resident memory
    except (OSError, AttributeError):
        return


def resident_bytes(field: str = "VmRSS") -> int:
    """Resident memory [bytes] now, VmRSS, or its peak, VmHWM; elsewhere than on Linux always the peak."""
    try:
        lines = Path("/proc/self/status").read_text().splitlines()
        return next(1024 * int(line.split()[1]) for line in lines if line.startswith(field))
    except (OSError, StopIteration):
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024


def device_peak_bytes(trial: Trial, device: str, label: str) -> int:
    """GPU memory [bytes] of one call.

    For pointloom, the high-water mark of Warp's pool; for baselines, the device memory in use afterward, since
    Open3D's cache
    keeps its memory.
    """
    import warp as wp

    wp.synchronize_device(device)
    if label == POINTLOOM:
        before = wp.get_mempool_used_mem_current(device)
        trial.once()
        return wp.get_mempool_used_mem_high(device) - before
    before = wp.get_device(device).free_memory
    result = trial.once()
    wp.synchronize_device(device)
    taken = before - wp.get_device(device).free_memory
    del result
    return max(0, taken)


def warm_up(operation: Operation, contestant: Contestant, device: str) -> None:
    """Compile kernels, load libraries and start threads on small data."""
    scene = next(iter(operation.quick.values()))()
    contestant.trial(scene, device).once()


def measure(module: str, operation_name: str, size: str, label: str, device: str) -> int:
    """The peak of one contestant, warmed up on the smallest data."""
    operation = next(each for each in importlib.import_module(module).OPERATIONS if each.name == operation_name)
    contestant, run_device = operation.contestant(label, device)
    warm_up(operation, contestant, run_device)
    scene = {**operation.quick, **operation.scenes}[size]()  # kept alive until the end, with its files
    trial = contestant.trial(scene, run_device)
    return device_peak_bytes(trial, run_device, label) if run_device.startswith("cuda") else peak_bytes(trial)


if __name__ == "__main__":
    module, name, size, label, device = [*sys.argv[1:], "cpu"][:5]
    limit_threads(device)
    print(json.dumps({"bytes": measure(module, name, size, label, device)}))
