"""Operations under several bounds of registers: does a lower one let in more threads than its spills cost?

    python -m gpu_kit.register_trials STATE SECONDS

Each bound is a process of its own with POINTLOOM_MOST_REGISTERS set, which compiles the kernel anew (NVRTC, seconds).
The bound in the source is worth keeping where no other is faster by a tenth.
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
OWN = -1  # the bound that the source has
BOUNDS = (OWN, 64, 80, 96, 128, 0)
TRIALS = (  # operation, size, kernels as CUDA has them: the hottest that have a bound, or over 128 registers
    ("normals_k30", 1_000_000, ("fit_normals_nearest_kernel",)),
    ("dbscan", 1_000_000, ("unite_cores_kernel", "find_cores_kernel")),
    ("knn20", 1_000_000, ("search_nearest_of_lanes_kernel",)),
    ("fpfh", 300_000, ("count_angles_kernel", "sum_histograms_of_lanes_kernel")),
    ("icp_plane", 200_000, ("match_lanes_kernel", "sum_plane_rows")),
    ("closest_points", 200_000, ("find_nearest_triangles_of_lanes_kernel",)),
)
DRY_TRIALS = (("voxel_down_sample", 3000, ("encode_voxels_kernel",)),)
DRY_BOUNDS = (OWN, 96)


def setting(kernels: tuple[str, ...], bound: int) -> str:
    """What the variable says."""
    return "" if bound == OWN else ",".join(f"{name}={bound}" for name in kernels)


def trial(operation: str, size: int, kernels: tuple[str, ...], bound: int, seconds: float) -> dict[str, Any]:
    """The times of an operation under a bound."""
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
    found = json.loads(lines[-1])
    missed = [name for name in kernels if bound not in (OWN, bound_of(name, found["bounds"]))]
    if missed:
        return {"error": f"the call has no {', '.join(missed)}: the kernel is called otherwise now"}
    rows = [row for row in found.get("kernels", []) if row["kernel"].startswith(kernels)]
    about = {name: found[name] for name in ("caller_ms", "device_ms") if name in found}
    return about | {"kernels": rows}


def bound_of(name: str, bounds: dict[str, int]) -> int | None:
    """The bound that a kernel, or the sum of a function, was compiled with."""
    return bounds.get(name, bounds.get(f"{name}_tiles"))


def line(operation: str, bound: int, found: dict[str, Any]) -> str:
    """A trial in words."""
    named = "its own" if bound == OWN else f"at most {bound}" if bound else "no bound"
    if "error" in found:
        return f"{operation:18} {named:12} FAILED {found['error']}"
    kernels = ", ".join(f"{row['kernel']} {row['us']:.0f} us at {row['registers']}" for row in found["kernels"])
    return f"{operation:18} {named:12} {found.get('device_ms', found['caller_ms']):9.3f} ms  {kernels}"


def main() -> int:
    """Make the trials that are left; MORE where some still are."""
    state, end = Path(sys.argv[1]), time.monotonic() + float(sys.argv[2])
    device, kept = devices.start(), state / "parts" / "registers.json"
    found: dict[str, Any] = json.loads(kept.read_text())["content"] if kept.exists() else {}
    for operation, size, kernels in DRY_TRIALS if devices.is_dry() else TRIALS:
        for bound in DRY_BOUNDS if devices.is_dry() else BOUNDS:
            key = f"{operation} {size} {setting(kernels, bound) or 'own'}"
            if key in found:
                continue
            left = end - time.monotonic()
            if left < AT_LEAST:
                print("no time left before", key)
                return MORE
            found[key] = trial(operation, size, kernels, bound, min(left, AT_MOST))
            print(line(operation, bound, found[key]), flush=True)
            keep_part(state, device, "registers", found)
    return 1 if any("error" in each for each in found.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
