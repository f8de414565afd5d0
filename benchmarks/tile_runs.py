"""Measure a tile job: wall and CPU time of each phase, memory of a worker, disk space.

    python benchmarks/made_survey.py SURVEY --points 1e8
    python benchmarks/tile_runs.py SURVEY JOB --workers 2

Ground, a DTM of 1 m, voxels of 1 m and their normals, in one chain, and one COPC file of the result. The record is
written to `benchmarks/results/tiles-cpu.json`; it replaces one with the same number of points.
"""

from __future__ import annotations

import argparse
import json
import os
import resource
import shutil
import sys
import time
from pathlib import Path
from typing import Any

import psutil

import pointloom as loom
from pointloom.core.atomic import atomic_write
from pointloom.tiling.buckets import FOLDER as BUCKETS
from pointloom.tiling.manifest import Manifest

RESULTS = Path(__file__).parent / "results" / "tiles-cpu.json"
STEPS = [
    {"step": "classify_ground"},
    {"step": "rasterize", "cell": 1.0, "kind": "dtm"},
    {"step": "voxel_down_sample", "voxel_size": 1.0},
    {"step": "estimate_normals", "radius": 3.0, "max_nn": 20},
]


def size_of(folder: Path) -> int:
    """Bytes in a folder."""
    return sum(path.stat().st_size for path in folder.rglob("*") if path.is_file())


class Watch:
    """Start of the first tile, resources of workers until then, and disk space of the sorted input files."""

    def __init__(self, job: Path):
        self.job, self.begin = job, time.monotonic()
        self.laid_s = self.laid_cpu_s = 0.0
        self.laid_bytes = 0

    def __call__(self, phase: str, done: int, total: int) -> None:
        """Progress callback of `run_tiles`."""
        print(f"\r{phase}: {done} of {total}   ", end="", file=sys.stderr, flush=True)
        if phase != "files" and not self.laid_bytes:
            self.laid_s = time.monotonic() - self.begin
            self.laid_cpu_s = sum(sum(child.cpu_times()[:2]) for child in psutil.Process().children(recursive=True))
            self.laid_bytes = size_of(self.job / BUCKETS)


def cpu_seconds() -> float:
    """CPU seconds of this process and of its finished children."""
    own, children = resource.getrusage(resource.RUSAGE_SELF), resource.getrusage(resource.RUSAGE_CHILDREN)
    return own.ru_utime + own.ru_stime + children.ru_utime + children.ru_stime


def measured(survey: Path, job: Path, workers: int) -> dict[str, Any]:
    """Plan, run and finish a job."""
    os.environ.setdefault("POINTLOOM_CPU_THREADS", "1")
    loom.tiling.plan_tiles(survey, STEPS, job)
    watch = Watch(job)
    status = loom.tiling.run_tiles(job, workers=workers, progress=watch)
    run_s = time.monotonic() - watch.begin
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    if not status.is_finished:
        raise SystemExit(f"{status}")
    with Manifest(job) as manifest:
        (row,) = manifest.rows("SELECT count(*) AS tiles FROM tiles")
    tile_bytes = size_of(job / "tiles")
    begin, cpu = time.monotonic(), cpu_seconds()
    result = loom.tiling.finish_tiles(job, job / "result.copc.laz", workers=workers, overwrite=True)
    return {
        "points": status.points,
        "files": len(list(survey.glob("*.laz"))),
        "tiles": row["tiles"],
        "workers": workers,
        "points_out": status.points_out,
        "run_s": round(run_s, 1),
        "lay_s": round(watch.laid_s, 1),
        "lay_cpu_s": round(watch.laid_cpu_s, 1),
        "tile_cpu_s": round(used.ru_utime + used.ru_stime - watch.laid_cpu_s, 1),
        "finish_s": round(time.monotonic() - begin, 1),
        "finish_cpu_s": round(cpu_seconds() - cpu, 1),
        "worker_bytes": used.ru_maxrss * 1024,
        "file_bytes": size_of(survey),
        "laid_bytes": watch.laid_bytes,
        "tile_bytes": tile_bytes,
        "result_bytes": result.stat().st_size,
    }


def keep(record: dict[str, Any]) -> None:
    """Save a record in the results file; replaces one with the same number of points."""
    runs = json.loads(RESULTS.read_text())["runs"] if RESULTS.exists() else []
    runs = [run for run in runs if run["points"] != record["points"]] + [record]
    content = {"steps": STEPS, "runs": sorted(runs, key=lambda run: run["points"])}
    with atomic_write(RESULTS) as file:
        file.write(json.dumps(content, indent=1).encode() + b"\n")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("survey", type=Path)
    parser.add_argument("job", type=Path, help="a new folder, removed at the end")
    parser.add_argument("--workers", type=int, default=2)
    options = parser.parse_args()
    record = measured(options.survey, options.job, options.workers)
    keep(record)
    print(json.dumps(record, indent=1))
    shutil.rmtree(options.job)


if __name__ == "__main__":
    main()
