"""The benchmarks on the GPU beside the baselines, one process per operation, within a time limit: those with a baseline
on the GPU first, then by the date of their last measurement, the oldest first.

    python -m gpu_kit.benches STATE SECONDS

benchmarks/run.py writes one document at its end, and measures memory. This module saves the rows of each operation at
once, and the next run continues with the remaining operations.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

from contest import operations, versions

from gpu_kit import device as devices
from gpu_kit.documents import keep_part, last_measured, saved_part
from gpu_kit.runner import MORE

ORDER = [
    "normals_hybrid", "normals_knn30", "knn20_query", "icp_plane", "tsdf_integrate", "voxel_down_sample", "fpfh",
    "dbscan", "statistical_outliers", "ransac", "register_globally", "marching_cubes", "tsdf_mesh", "closest_points",
    "cast_rays", "rgbd_odometry", "slam", "gicp", "poisson", "decimation", "odometry", "stereo_pair",
    "farthest_points", "segment_plane", "feature_matching", "icp_batch", "orient_consistently", "smooth",
    "cloud_distance", "radius_outliers", "reconstruction", "ball_pivoting", "alpha_shape", "render", "iss_keypoints",
]  # fmt: skip
DRY_ORDER = ["voxel_down_sample"]
AT_LEAST, AT_MOST = 15.0, 80.0  # seconds per operation


def chosen(chip: str) -> dict[str, str]:
    """Operations and their modules, in the order for a chip."""
    known = operations()
    modules: dict[str, str] = {}
    for prefix in DRY_ORDER if devices.is_dry() else [*ORDER, ""]:
        for name, (module, _) in known.items():
            if name.startswith(prefix) or module == f"bench_{prefix}":
                modules.setdefault(name, module)
    known_dates = last_measured("benchmarks", "operations", chip=chip)
    with_peer = on_gpu()
    return dict(
        sorted(modules.items(), key=lambda each: (each[0] not in with_peer, known_dates.get(each[0], ("", ""))[0]))
    )


def on_gpu() -> list[str]:
    """Operations with a baseline on the GPU."""
    known = operations().items()
    return [name for name, (_, each) in known if any("cuda" in peer.devices for peer in each.contestants[1:])]


def time_one(name: str, module: str, seconds: float) -> tuple[dict[str, Any] | None, str]:
    """pytest-benchmark's document of an operation, or an error message."""
    with tempfile.TemporaryDirectory() as folder:
        result = Path(folder) / "benchmark.json"
        command = [sys.executable, "-m", "pytest", f"benchmarks/{module}.py", "-q", "-s", "--tb=line"]
        command += ["-p", "gpu_kit.dry_plugin"] if devices.is_dry() else []
        command += [f"--benchmark-json={result}", "--benchmark-quiet", f"--bench-device={devices.NAME}"]
        command += [f"--bench-operation={name}", "-o", "filterwarnings=default", *["--bench-quick"] * devices.is_dry()]
        try:
            done = subprocess.run(command, capture_output=True, text=True, timeout=seconds, check=False)
        except subprocess.TimeoutExpired:
            return None, f"took more than {seconds:.0f} s"
        if result.exists() and result.stat().st_size:
            return json.loads(result.read_text()), ""
    return None, f"exit {done.returncode}: {(done.stdout + done.stderr)[-700:]}"


def main() -> int:
    """Time the remaining operations; returns MORE if some remain."""
    state, end = Path(sys.argv[1]), time.monotonic() + float(sys.argv[2])
    device = devices.start()
    from report import collect, table  # its targets import the benchmarks, and those pointloom

    os.environ.setdefault("BENCH_THREADS", str(max(2, (os.cpu_count() or 2) - 2)))
    results = saved_part(state, "benchmarks") or {"operations": {}}
    results["versions"] = versions()
    complete = True
    for name, module in chosen(device.chip).items():
        if name in results["operations"]:
            continue
        left = end - time.monotonic()
        if left < AT_LEAST:
            print(f"no time left before {name}")
            complete = False
            break
        start = time.monotonic()
        document, why = time_one(name, module, min(left - 3, AT_MOST))
        rows = list(collect([document]).values()) if document else []
        results["operations"][name] = [
            {"size": row.size, "peer": label, "best_ms": 1e3 * timing.best, "median_ms": 1e3 * timing.median}
            for row in rows
            for label, timing in row.timings.items()
        ] or {"error": why}
        results.setdefault("seconds", {})[name] = round(time.monotonic() - start, 1)
        keep_part(state, device, "benchmarks", results)
        print(table(rows, with_targets=False) if rows else f"{name}: no table: {why}", flush=True)
    if not complete:
        return MORE
    return 1 if any("error" in rows for rows in results["operations"].values()) else 0


if __name__ == "__main__":
    sys.exit(main())
