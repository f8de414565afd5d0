"""Operations on the GPU (gpu_operations.py): times of the caller, and times of the kernels by name.

    python -m gpu_kit.measure STATE SECONDS call|device     one of the two measurements
    python -m gpu_kit.measure --once NAME=SIZE ...          run each twice: for ncu and compute-sanitizer
    python -m gpu_kit.measure --json call|device NAME=SIZE ...      results as a line of JSON

Caller: the median of some synchronized calls on existing data. Device: the total duration of kernels, copies and fills,
including those in graphs, measured by CUPTI through torch's profiler. Without torch there is only the caller's time.
They are two processes: CUPTI stays attached and slows later launches (pytorch/pytorch#144455), and it does not resolve
graphs created before. `times_of` raises an error after a profile. The oldest measurements are repeated first.
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

from real_data import DataMissingError

from gpu_kit import device as devices
from gpu_kit.documents import keep_part, last_measured, saved_part
from gpu_kit.runner import MORE

ROUNDS, WARM_UP, ENOUGH = 7, 2, 1.5  # timed calls, calls before them, and seconds of timed calls


class Profiler:
    """Whether this process has used the profiler, which stays attached."""

    attached = False


def runs(field: str, chip: str) -> list[tuple[str, int]]:
    """Names and sizes, those with the oldest value of a field on this chip first."""
    from gpu_operations import OPERATIONS

    if devices.is_dry():
        return [(operation.name, operation.small) for operation in OPERATIONS.values()]
    known = last_measured("operations", chip=chip, field=field)
    sizes = [(operation.name, size) for operation in OPERATIONS.values() for size in operation.sizes]
    return sorted(sizes, key=lambda each: known.get(key_of(*each), ("", ""))[0])


def key_of(name: str, size: int) -> str:
    return f"{name} {size}"


def times_of(name: str, size: int) -> list[float]:
    """Seconds of some synchronized calls.

    Raises:
        RuntimeError: This process has used the profiler.
    """
    if Profiler.attached:
        raise RuntimeError("times after a profile in one process: the profiler stays attached and slows launches")
    import warp as wp
    from gpu_operations import OPERATIONS

    operation, seconds = OPERATIONS[name], []
    call = operation.prepare(size)
    warm_up, rounds = (0, 1) if devices.is_dry() else (WARM_UP, ROUNDS)
    for k in range(warm_up + rounds):
        if k and operation.in_new_state:
            call = operation.prepare(size)
        wp.synchronize_device(devices.NAME)
        start = time.perf_counter()
        try:
            result = call()
        except StopIteration:  # end of a sequence of frames
            break
        wp.synchronize_device(devices.NAME)
        elapsed = time.perf_counter() - start
        del result
        if k >= warm_up or elapsed > ENOUGH:
            seconds.append(elapsed)
        if sum(seconds) > ENOUGH:
            break
    return seconds


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

    Profiler.attached = True
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
    seconds = times_of(name, size)
    return {"caller_ms": 1e3 * statistics.median(seconds), "best_ms": 1e3 * min(seconds), "calls": len(seconds)}


def device_times(name: str, size: int) -> dict[str, Any]:
    """The device's times of an operation, by kernel; empty without a profiler."""
    from gpu_operations import OPERATIONS

    operation = OPERATIONS[name]
    call = operation.prepare(size)
    call()  # loads kernels, creates graphs
    if operation.in_new_state:
        call = operation.prepare(size)
    try:
        rows = kernels_of(call)
    except Exception as error:  # of the profiler: the times of the other process remain valid
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


MEASURES = {"call": (call_times, "caller_ms"), "device": (device_times, "device_ms")}


def measured(kind: str, name: str, size: int) -> dict[str, Any]:
    """One of the two measurements of an operation, with its seconds including the preparation; or its error, or
    the real data that are missing."""
    start = time.monotonic()
    try:
        result = MEASURES[kind][0](name, size)
    except DataMissingError as error:
        return {"missing": str(error)}
    except Exception as error:
        traceback.print_exc(limit=4)
        return {"error": f"{type(error).__name__}: {str(error)[:400]}"}
    return result | {f"seconds of {kind}": round(time.monotonic() - start, 2)}


def package() -> str:
    """The folder of the measured code."""
    import pointloom

    return str(Path(pointloom.__file__).parent)


def main() -> int:
    """Measure the remaining operations; returns MORE if some remain."""
    first, *words = sys.argv[1:]
    device = devices.start()
    if first == "--once":
        once(words)
        return 0
    if first == "--json":
        sizes = [word.partition("=")[::2] for word in words[1:]]
        results = {key_of(name, int(size)): measured(words[0], name, int(size)) for name, size in sizes}
        print(json.dumps({"package": package(), "results": results}))
        return 0
    state, end, kind = Path(first), time.monotonic() + float(words[0]), words[1]
    field, results = MEASURES[kind][1], saved_part(state, "operations")
    for name, size in runs(field, device.chip):
        result = results.setdefault(key_of(name, size), {})
        if "error" in result or f"seconds of {kind}" in result:
            continue
        if time.monotonic() > end:
            print("no time left before", name, size)
            return MORE
        result |= measured(kind, name, size)
        if "missing" in result:
            print(f"{name}, {size:,}: not measured. {result['missing']}", flush=True)
            del results[key_of(name, size)]
            continue
        print(described(name, size, result), flush=True)
        keep_part(state, device, "operations", results)
    return 1 if any("error" in each for each in results.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
