"""Operations on the GPU (gpu_operations.py): times of the caller, and times of the kernels by name.

    python -m gpu_kit.profile STATE SECONDS call|device     one of the two measurements
    python -m gpu_kit.profile --once NAME=SIZE ...          run each twice: for ncu and compute-sanitizer
    python -m gpu_kit.profile --json NAME=SIZE              one call's times as a line of JSON

Caller: the median of some synchronized calls on existing data. Device: the total duration of kernels, copies and fills,
including those in graphs, measured by CUPTI through torch's profiler. Without torch there is only the caller's time.
They are two processes: CUPTI stays attached and slows later launches (pytorch/pytorch#144455), and it does not resolve
graphs created before. The oldest measurements are repeated first.
"""

from __future__ import annotations

import json
import statistics
import sys
import tempfile
import time
import traceback
from collections.abc import Callable
from pathlib import Path
from typing import Any

from gpu_kit import device as devices
from gpu_kit.documents import keep_part, last_measured
from gpu_kit.runner import MORE

ROUNDS, WARM_UP, ENOUGH = 7, 2, 6.0  # timed calls, calls before them, and maximum total seconds
FRESH = ("tree",)  # operations whose result is cached are prepared again for each call
DRY_OPERATIONS = {"voxel_down_sample": 3000, "normals_k30": 3000}


def runs() -> list[tuple[str, int]]:
    """Names and sizes, in order."""
    from gpu_operations import OPERATIONS

    if devices.is_dry():
        return list(DRY_OPERATIONS.items())
    known = last_measured("operations")
    sizes = [(operation.name, size) for operation in OPERATIONS.values() for size in operation.sizes]
    return sorted(sizes, key=lambda each: known.get(key_of(*each), ""))


def key_of(name: str, size: int) -> str:
    return f"{name} {size}"


def timed(name: str, size: int) -> tuple[list[float], Callable[[], Any]]:
    """Times of calls, and a prepared call."""
    import warp as wp
    from gpu_operations import OPERATIONS

    prepare = OPERATIONS[name].prepare
    call, seconds = prepare(size), []
    for k in range(WARM_UP + ROUNDS):
        if name in FRESH:
            call = prepare(size)
        wp.synchronize_device(devices.NAME)
        start = time.perf_counter()
        try:
            result = call()
        except StopIteration:  # end of a sequence of frames
            break
        wp.synchronize_device(devices.NAME)
        if k >= WARM_UP:
            seconds.append(time.perf_counter() - start)
        del result
        if sum(seconds) > ENOUGH:
            break
    return seconds, prepare(size) if name in FRESH else call


def kernels_of(call: Callable[[], Any]) -> list[dict[str, Any]] | None:
    """Kernels of one call, the longest first; None without torch or its profiler."""
    try:
        import torch
        from torch.profiler import ProfilerActivity, profile
    except ImportError:
        return None
    if not torch.cuda.is_available():
        return None
    import warp as wp

    torch.cuda.init()
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "trace.json"
        with profile(activities=[ProfilerActivity.CPU, ProfilerActivity.CUDA]) as profiler:
            call()
            wp.synchronize_device(devices.NAME)
        profiler.export_chrome_trace(str(path))
        return rows_of(json.loads(path.read_text())["traceEvents"])


def rows_of(events: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """A row for each kernel: launches, microseconds, registers per thread, and the profiler's occupancy estimate."""
    rows: dict[str, dict[str, Any]] = {}
    for event in events:
        if event.get("cat") not in ("kernel", "gpu_memcpy", "gpu_memset"):
            continue
        about, name = event.get("args", {}), plain(event["name"])
        row = rows.setdefault(name, {"kernel": name, "launches": 0, "us": 0.0})
        row["launches"] += 1
        row["us"] += float(event.get("dur", 0))
        row["registers"] = about.get("registers per thread")
        row["occupancy"] = about.get("est. achieved occupancy %")
    return sorted(rows.values(), key=lambda row: -row["us"])


def plain(name: str) -> str:
    """A kernel's name in the sources: without Warp's hash and suffix."""
    own, separator, _ = name.partition("_cuda_kernel_forward")
    return own.rpartition("_")[0] if separator else name


def call_times(name: str, size: int) -> dict[str, Any]:
    """The caller's times of an operation."""
    seconds, _ = timed(name, size)
    return {"caller_ms": 1e3 * statistics.median(seconds), "best_ms": 1e3 * min(seconds)}


def device_times(name: str, size: int) -> dict[str, Any]:
    """The device's times of an operation, by kernel; empty without a profiler."""
    _, call = timed(name, size)  # warm
    try:
        rows = kernels_of(call)
    except Exception as error:  # of the profiler: the caller's time remains valid
        traceback.print_exc(limit=4)
        return {"profiler": f"{type(error).__name__}: {str(error)[:200]}"}
    if not rows:
        return {}
    total = sum(row["us"] for row in rows) / 1e3
    return {"device_ms": total, "launches": sum(row["launches"] for row in rows), "kernels": rows}


def described(name: str, size: int, result: dict[str, Any]) -> str:
    """Describe the times, with the longest kernels below."""
    if "error" in result:
        return f"{name}, {size:,}: FAILED {result['error']}"
    line = f"{name}, {size:,}:"
    if "caller_ms" in result:
        line += f" caller {result['caller_ms']:.3f} ms (best {result['best_ms']:.3f});"
    if "device_ms" in result:
        line += f" device {result['device_ms']:.3f} ms in {result['launches']} launches"
    rows = [
        f"    {row['kernel'][:44]:44} x{row['launches']:<5} {row['us']:10.1f} us, registers {row['registers']}"
        for row in result.get("kernels", [])[:5]
    ]
    return "\n".join([line, *rows])


def bounds_in_use() -> dict[str, int]:
    """Register limits of the kernels created in this process, by name; 0 for none."""
    import warp as wp

    modules = [m for m in wp._src.context.user_modules.values() if m.name.startswith("pointloom.")]
    kernels = (kernel for module in modules if not module.name.endswith(".cpu") for kernel in module.kernels.values())
    return {kernel.key: kernel.options.get("cuda_max_registers", 0) for kernel in kernels}


def once(words: list[str]) -> None:
    """Run calls twice, without saving results."""
    import warp as wp
    from gpu_operations import OPERATIONS

    for word in words:
        name, _, size = word.partition("=")
        call = OPERATIONS[name].prepare(int(size))
        for _ in range(2):
            call()
            wp.synchronize_device(devices.NAME)


def main() -> int:
    """Measure the remaining operations; returns MORE if some remain."""
    first, *words = sys.argv[1:]
    device = devices.start()
    if first in ("--once", "--json"):
        if first == "--once":
            once(words)
        else:
            name, _, size = words[0].partition("=")
            times = device_times(name, int(size))
            times = times if "device_ms" in times else times | call_times(name, int(size))
            print(json.dumps(times | {"bounds": bounds_in_use()}))
        return 0
    state, end = Path(first), time.monotonic() + float(words[0])
    measure, field = {"call": (call_times, "caller_ms"), "device": (device_times, "device_ms")}[words[1]]
    saved = state / "parts" / "operations.json"
    results: dict[str, Any] = json.loads(saved.read_text())["content"] if saved.exists() else {}
    for name, size in runs():
        result = results.setdefault(key_of(name, size), {})
        if "error" in result or field in result:
            continue
        if time.monotonic() > end:
            print("no time left before", name, size)
            return MORE
        try:
            result |= measure(name, size)
        except Exception as error:
            traceback.print_exc(limit=4)
            result["error"] = f"{type(error).__name__}: {str(error)[:400]}"
        print(described(name, size, result), flush=True)
        keep_part(state, device, "operations", results)
    return 1 if any("error" in each for each in results.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
