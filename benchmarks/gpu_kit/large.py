"""Large clouds: time, and peak memory beyond the cloud.

    python -m gpu_kit.large STATE SECONDS

Sizes are those of `Operation.large` (gpu_operations.py), each operation in a new process: memory that a previous one
leaves in the pool does not count, and an operation without enough memory does not stop the others.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

from gpu_kit import device as devices
from gpu_kit.documents import keep_part, saved_part
from gpu_kit.runner import MORE

CALLS, AT_LEAST = 3, 8.0  # calls of an operation, and seconds to start it


def measured(name: str, size: int) -> dict[str, Any]:
    """Times of some calls, and the peak memory of the last one beyond the data before it."""
    import warp as wp
    from gpu_operations import OPERATIONS

    operation, device = OPERATIONS[name], wp.get_device(devices.NAME)
    call, seconds, before, after = operation.prepare(size), [], 0, 0
    for k in range(CALLS):
        if k and operation.in_new_state:
            call = operation.prepare(size)
        wp.synchronize_device(device)
        before = wp.get_mempool_used_mem_current(device)
        start = time.perf_counter()
        result = call()
        wp.synchronize_device(device)
        seconds.append(time.perf_counter() - start)
        after = wp.get_mempool_used_mem_current(device)
        del result
    peak = wp.get_mempool_used_mem_high(device)
    return {
        "first_ms": 1e3 * seconds[0],
        "best_ms": 1e3 * min(seconds),
        "bytes before": before,
        "bytes of the result": after - before,
        "peak bytes": peak,
        "peak bytes per point": round((peak - before) / size, 1),
    }


def in_process(name: str, size: int, seconds: float) -> dict[str, Any]:
    """The measurement in a new process, or its error."""
    command = [sys.executable, "-m", "gpu_kit.large", "--json", name, str(size)]
    try:
        done = subprocess.run(
            command, capture_output=True, text=True, timeout=seconds, env=dict(os.environ), check=False
        )
    except subprocess.TimeoutExpired:
        return {"error": f"took more than {seconds:.0f} s"}
    lines = [line for line in done.stdout.splitlines() if line.startswith("{")]
    return json.loads(lines[-1]) if lines else {"error": f"exit {done.returncode}: {done.stderr[-400:]}"}


def sizes() -> list[tuple[str, int]]:
    """Operations and sizes, the smaller ones first."""
    from gpu_operations import OPERATIONS

    pairs = [
        (o.name, size) for o in OPERATIONS.values() for size in ((o.small,) if devices.is_dry() else o.large) if o.large
    ]
    return sorted(pairs, key=lambda pair: pair[1])


def main() -> int:
    """Measure the remaining operations; returns MORE if some remain."""
    device = devices.start()
    if sys.argv[1] == "--json":
        print(json.dumps(measured(sys.argv[2], int(sys.argv[3]))))
        return 0
    state, end = Path(sys.argv[1]), time.monotonic() + float(sys.argv[2])
    results = saved_part(state, "large")
    for name, size in sizes():
        key = f"{name} {size}"
        if key in results:
            continue
        if (left := end - time.monotonic()) < AT_LEAST:
            print("no time left before", key)
            return MORE
        results[key] = in_process(name, size, left)
        print(f"{key}: {results[key]}", flush=True)
        keep_part(state, device, "large", results)
    return 1 if any("error" in each for each in results.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
