"""On a GPU: the seconds of the operations of the GPU model, beside what it predicted of them."""

from __future__ import annotations

import json
import sys
import time
from pathlib import Path

from gpu_operations import DEVICE, OPERATIONS
from gpu_prediction import predict
from gpu_results import MEASURED, newest

ROUNDS = 5


class NoGpuError(RuntimeError):
    """There is nothing to measure on."""


def measured(name: str, size: int) -> float:
    """Seconds of the fastest of some calls, each on data of its own, until the device is done."""
    import warp as wp

    if not wp.is_cuda_available():
        raise NoGpuError(f"--measure: no {DEVICE} here; without --measure the emulated device counts")
    best = float("inf")
    for _ in range(ROUNDS + 1):  # the first compiles
        call = OPERATIONS[name].prepare(size)
        wp.synchronize()
        start = time.perf_counter()
        result = call()
        wp.synchronize()
        best = min(best, time.perf_counter() - start)
        del result
    return best


def measure(runs: list[tuple[str, int]]) -> int:
    """Measure and keep; one line each, beside the newest prediction."""
    predicted = {(c["operation"], c["size"]): predict(c).timeline for c in newest()}
    found = json.loads(MEASURED.read_text()) if MEASURED.exists() else {}
    for name, size in runs:
        try:
            seconds = measured(name, size)
        except NoGpuError as error:
            print(error, file=sys.stderr)
            return 1
        found[f"{name} {size}"] = seconds
        line = f"{name}, {size:,}: measured {1e3 * seconds:.3f} ms"
        if timeline := predicted.get((name, size)):
            line += f", predicted {1e3 * timeline.call:.3f} ms, of it on the device {1e3 * timeline.device:.3f} ms"
        print(line, flush=True)
        Path(MEASURED).write_text(json.dumps(found, indent=1, sort_keys=True) + "\n")
    return 0
