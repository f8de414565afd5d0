"""Registration of hundreds of small scans as a job: time per pair, time of the manifest, memory, and pose errors.

    python benchmarks/registration_job.py [--scans 500] [--workers 0] [--folder DIR]

Scans of 2.4 m are 1.5 m apart on a random relief, with random headings and offsets; their positions are known within
0.3 m, and one scan is of another scene. The time of the manifest is the wall time outside tasks, per task; it is not
reported with several workers.
"""

from __future__ import annotations

import argparse
import json
import resource
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np
from scipy.ndimage import map_coordinates

import pointloom as loom
from pointloom.core.timing import peak_bytes
from pointloom.tiling.jobs.job import open_manifest

SIZE, WIDTH, APART, ERROR = 0.12, 2.4, 1.5, 0.3  # [m]
POINTS = 3000
CELL = 0.6  # [m] grid spacing of the relief's random heights


def make_scans(folder: Path, count: int) -> tuple[list[Path], np.ndarray]:
    """Write scans as files; returns them and their poses."""
    rng, columns = np.random.default_rng(1), int(np.ceil(np.sqrt(count)))
    heights = rng.normal(0, 0.35, (int(columns * APART / CELL) + 20,) * 2)
    paths, poses = [], []
    for k in range(count):
        corner = np.array([k % columns, k // columns]) * APART + 3.0
        x, y = corner[:, None] + rng.uniform(0, WIDTH, (2, POINTS))
        points = np.column_stack([x, y, map_coordinates(heights, [x / CELL, y / CELL], order=3)])
        angle, T = rng.uniform(0, 2 * np.pi), np.eye(4)
        T[:2, :2] = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
        T[:3, 3] = [*(corner + WIDTH / 2), 0.0]
        if k == count - 1:
            points = T[:3, 3] + rng.normal(0, 0.5, (POINTS, 3)) * [1, 1, 0.01]
        paths.append(folder / f"scan{k}.ply")
        loom.write_point_cloud(paths[-1], loom.PointCloud((points - T[:3, 3]) @ T[:3, :3]))
        poses.append(T)
    return paths, np.array(poses)


def measure(folder: Path, count: int, workers: int) -> dict[str, Any]:
    """Run the job and return its measurements."""
    paths, truth = make_scans(folder, count)
    rough_poses = truth.copy()
    rough_poses[:, :3, 3] += np.random.default_rng(2).uniform(-ERROR, ERROR, (count, 3)) / np.sqrt(3)
    begin, clock = time.thread_time(), time.perf_counter()
    loom.tiling.plan_registration(paths, folder / "job", voxel_size=SIZE, places=list(rough_poses), place_error=ERROR)
    planned = time.perf_counter() - clock
    status = loom.tiling.run_job(folder / "job", workers=workers)
    ran, cpu = time.perf_counter() - clock - planned, time.thread_time() - begin
    result = loom.tiling.finish_registration(folder / "job")
    finished = time.perf_counter() - clock - planned - ran
    with open_manifest(folder / "job") as manifest:
        rows = manifest.rows("SELECT stage, count(*) AS n, sum(seconds) AS s FROM tasks GROUP BY stage ORDER BY stage")
    stages = {str(row["stage"]): [row["n"], round(row["s"], 2)] for row in rows}
    tasks, seconds = sum(row["n"] for row in rows), sum(row["s"] for row in rows)
    relative = np.linalg.inv(truth[result.reference]) @ truth
    errors = np.linalg.norm((result.poses - relative)[result.placed, :3, 3], axis=1)
    report = {"scans": count, "workers": workers, "placed": int(result.placed.sum()), "pairs": len(result.tried)}
    report |= {"believed": len(result.pairs), "stages": stages, "is_finished": status.is_finished}
    report |= {"plan_s": planned, "run_s": ran, "finish_s": finished, "cpu_s": cpu}
    report |= {
        "task_ms": 1e3 * seconds / tasks,
        "manifest_ms_a_task": None if workers else 1e3 * (ran - seconds) / tasks,
    }
    peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss * 1024 if workers else peak_bytes()
    report |= {"peak_mb": round(peak / 2**20)}
    report |= {"worst_off_m": float(errors.max()), "median_off_m": float(np.median(errors))}
    return report | {"not_placed": [Path(path).name for path in result.not_placed]}


def main() -> None:
    """Print the measurements as JSON."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scans", type=int, default=500)
    parser.add_argument("--workers", type=int, default=0)
    parser.add_argument("--folder", type=Path)
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        print(json.dumps(measure(given.folder or Path(temporary), given.scans, given.workers), indent=1))


if __name__ == "__main__":
    main()
