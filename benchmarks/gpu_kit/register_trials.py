"""Operations with several register limits: does a lower limit increase occupancy more than its spills cost?

    python -m gpu_kit.register_trials STATE SECONDS

Each limit runs in a separate process with POINTLOOM_MOST_REGISTERS set, which recompiles the kernel (NVRTC,
seconds). The
limit in the source is kept if no other is faster by 10 %.
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
from gpu_kit.documents import keep_part
from gpu_kit.runner import MORE

VARIABLE = "POINTLOOM_MOST_REGISTERS"
AT_LEAST, AT_MOST = 15.0, 90.0  # seconds of a trial
OWN = -1  # the limit in the source
BOUNDS = (OWN, 64, 80, 96, 128, 0)
TRIALS = (  # operation, size, CUDA names of kernels: the slowest with a limit, or with more than 128 registers
    ("normals_k30", 1_000_000, ("fit_normals_nearest_kernel",)),
    ("dbscan", 1_000_000, ("unite_cores_of_lanes_kernel", "find_cores_of_lanes_kernel")),
    ("knn20", 1_000_000, ("search_nearest_of_lanes_kernel",)),
    ("fpfh", 300_000, ("count_angles_kernel", "sum_histograms_of_lanes_kernel")),
    ("icp_plane", 200_000, ("match_lanes_kernel", "sum_plane_rows")),
    ("closest_points", 200_000, ("find_nearest_triangles_of_lanes_kernel",)),
)
DRY_TRIALS = (("voxel_down_sample", 3000, ("encode_voxels_kernel",)),)
DRY_BOUNDS = (OWN, 96)


def setting(kernels: tuple[str, ...], bound: int) -> str:
    """The value of the environment variable."""
    return "" if bound == OWN else ",".join(f"{name}={bound}" for name in kernels)


def trial(operation: str, size: int, kernels: tuple[str, ...], bound: int, seconds: float) -> dict[str, Any]:
    """The times of an operation under a limit."""
    command = [sys.executable, "-m", "gpu_kit.profile", "--json", f"{operation}={size}"]
    environment = {**os.environ, VARIABLE: setting(kernels, bound)}
    try:
        done = subprocess.run(
            command, env=environment, capture_output=True, text=True, timeout=seconds, check=False
        )  # fmt: skip
    except subprocess.TimeoutExpired:
        return {"error": f"took more than {seconds:.0f} s"}
    lines = [line for line in done.stdout.splitlines() if line.startswith("{")]
    if done.returncode or not lines:
        return {"error": f"exit {done.returncode}: {done.stderr[-400:]}"}
    result = json.loads(lines[-1])
    missed = [name for name in kernels if bound not in (OWN, bound_of(name, result["bounds"]))]
    if missed:
        return {"error": f"the call has no {', '.join(missed)}: the kernel was renamed"}
    rows = [row for row in result.get("kernels", []) if row["kernel"].startswith(kernels)]
    about = {name: result[name] for name in ("caller_ms", "device_ms") if name in result}
    return about | {"kernels": rows}


def bound_of(name: str, bounds: dict[str, int]) -> int | None:
    """The limit that a kernel, or the sum of a function, was compiled with."""
    return bounds.get(name, bounds.get(f"{name}_tiles"))


def line(operation: str, bound: int, result: dict[str, Any]) -> str:
    """One line for a trial."""
    named = "its own" if bound == OWN else f"at most {bound}" if bound else "no bound"
    if "error" in result:
        return f"{operation:18} {named:12} FAILED {result['error']}"
    kernels = ", ".join(f"{row['kernel']} {row['us']:.0f} us at {row['registers']}" for row in result["kernels"])
    return f"{operation:18} {named:12} {result.get('device_ms') or result['caller_ms']:9.3f} ms  {kernels}"


def main() -> int:
    """Run the remaining trials; returns MORE if some remain."""
    state, end = Path(sys.argv[1]), time.monotonic() + float(sys.argv[2])
    device, saved = devices.start(), state / "parts" / "registers.json"
    results: dict[str, Any] = json.loads(saved.read_text())["content"] if saved.exists() else {}
    for operation, size, kernels in DRY_TRIALS if devices.is_dry() else TRIALS:
        for bound in DRY_BOUNDS if devices.is_dry() else BOUNDS:
            key = f"{operation} {size} {setting(kernels, bound) or 'own'}"
            if key in results:
                continue
            left = end - time.monotonic()
            if left < AT_LEAST:
                print("no time left before", key)
                return MORE
            results[key] = trial(operation, size, kernels, bound, min(left, AT_MOST))
            print(line(operation, bound, results[key]), flush=True)
            keep_part(state, device, "registers", results)
    return 1 if any("error" in each for each in results.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
