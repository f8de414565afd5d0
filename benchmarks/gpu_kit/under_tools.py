"""NVIDIA's tools on a few calls: ncu for stall reasons of kernels, compute-sanitizer for errors.

python -m gpu_kit.under_tools STATE SECONDS ncu|sanitizer
"""

from __future__ import annotations

import re
import subprocess
import sys
import time
from pathlib import Path

from gpu_kit.documents import saved_part
from gpu_kit.runner import MORE

# Calls for ncu if there is no profile, and small ones for compute-sanitizer
NCU_CALLS = ("normals_k30=1000000", "dbscan_device=1000000", "knn20_device=1000000", "fpfh_device=300000")
NCU_CALLS += ("tsdf_integrate=307200", "closest_points_device=200000", "cast_rays_device=1000000", "icp_plane=200000")
SANITIZED = ("normals_k30=3000", "dbscan_device=3000", "icp_plane=3000", "fpfh_device=3000", "voxel_down_sample=3000")
SANITIZED += ("farthest_points=3000", "tsdf_mesh=307200")
NCU_SECTIONS = ("SpeedOfLight", "Occupancy", "LaunchStats", "MemoryWorkloadAnalysis", "WarpStateStats")
HOTTEST, LAUNCHES, AT_LEAST = 12, 60, 40.0
KNOWN = ("fit_normals_nearest", "search_nearest", "find_limits", "sum_histograms", "match_lanes", "sum_plane_rows")
KNOWN += ("step_jobs", "integrate_voxels", "find_nearest_triangles", "cast_rays", "unite_cores", "choose_by_leaves")
SANITIZERS = ("memcheck", "racecheck", "initcheck")
FAULT = re.compile(r"ERROR SUMMARY|=========.*(?:Invalid|Race|Uninit)")
ONCE = (sys.executable, "-m", "gpu_kit.measure", "--once")


def hottest(state: Path) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """The kernels with the longest launches in the profile, and the calls with these launches."""
    longest: dict[str, tuple[float, str]] = {}
    for key, result in saved_part(state, "operations").items():
        for row in result.get("kernels", []):
            if row["kernel"].endswith(("_kernel", "_tiles")):
                launch = (row["us"] / row["launches"], "=".join(key.split()))
                longest[row["kernel"]] = max(longest.get(row["kernel"], launch), launch)
    kernels = tuple(sorted(longest, key=lambda name: longest[name], reverse=True)[:HOTTEST])
    calls = dict.fromkeys(longest[name][1] for name in kernels)
    return (kernels, tuple(calls)) if kernels else (KNOWN, NCU_CALLS)


def run_ncu(state: Path, end: float) -> int:
    """Counters of the slowest kernels as a table; clock settings are unchanged."""
    kernels, calls = hottest(state)
    command = ["ncu", "--clock-control", "none", "--target-processes", "all", "--csv", "--page", "raw"]
    command += ["-k", f"regex:{'|'.join(kernels)}", "-c", str(LAUNCHES)]
    command += [word for name in (*NCU_SECTIONS, "InstructionStats") for word in ("--section", name)]
    table = state / "logs" / "ncu.csv"
    with table.open("w") as file:
        try:
            done = subprocess.run([*command, *ONCE, *calls], stdout=file, timeout=end - time.monotonic(), check=False)
        except subprocess.TimeoutExpired:
            print(f"out of time; {table.name} contains the results so far")
            return MORE
    print(f"{table.name}: {len(table.read_text().splitlines())} lines")
    return done.returncode


def run_sanitizers(state: Path, end: float) -> int:
    """Run each sanitizer on small calls and count its messages."""
    code = 0
    for tool in SANITIZERS:
        log, left = state / "logs" / f"sanitizer-{tool}.txt", end - time.monotonic()
        if log.exists() and "ERROR SUMMARY" in log.read_text(errors="replace"):
            continue
        if left < AT_LEAST:
            print("no time left before", tool)
            return MORE
        command = ["compute-sanitizer", "--tool", tool, "--target-processes", "all", "--error-exitcode", "9"]
        with log.open("w") as file:
            try:
                done = subprocess.run(
                    [*command, *ONCE, *SANITIZED], stdout=file, stderr=subprocess.STDOUT, timeout=left, check=False
                )
            except subprocess.TimeoutExpired:
                print(f"{tool}: out of time")
                return MORE
        lines = [line for line in log.read_text(errors="replace").splitlines() if FAULT.search(line)]
        print(f"{tool}: exit {done.returncode}", *lines[:6], sep="\n  ", flush=True)
        code = code or done.returncode
    return code


def main() -> int:
    """Run the requested tool."""
    state, end = Path(sys.argv[1]), time.monotonic() + float(sys.argv[2])
    return {"ncu": run_ncu, "sanitizer": run_sanitizers}[sys.argv[3]](state, end)


if __name__ == "__main__":
    sys.exit(main())
