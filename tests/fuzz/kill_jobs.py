"""Kill runs of a tile job at random times: `python tests/fuzz/kill_jobs.py --count 30 --seed 1`.

Each job is killed (SIGKILL to the run; its workers exit on their own) until a run completes. Then the result must be
bitwise identical to that of an undisturbed job, and the files beside the job must be unchanged. The exit code is 1 if
one differs.
"""

from __future__ import annotations

import argparse
import random
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

import pointloom as loom

STEPS = [
    {"step": "remove_statistical_outlier", "nb_neighbors": 8, "std_ratio": 2.0},
    {"step": "voxel_down_sample", "voxel_size": 0.5},
]


def planned(folder: Path) -> Path:
    """Plan a job of 16 tiles in a folder."""
    points = np.random.default_rng(0).random((20_000, 3)) * (40, 40, 2)
    loom.write_point_cloud(folder / "in.laz", loom.PointCloud(points))
    loom.tiling.plan_tiles([folder / "in.laz"], STEPS, folder / "job", size=10.0)
    return folder / "job"


def run(job: Path) -> subprocess.Popen[bytes]:
    """Start a process that runs the job with two workers."""
    command = [sys.executable, "-m", "pointloom", "tile", "run", str(job), "--workers", "2"]
    return subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def kills_until_done(job: Path, rng: random.Random, usual: float) -> int:
    """Kill runs at random times until one completes. Returns the number of kills."""
    kills = 0
    while True:
        worker = run(job)
        try:
            if worker.wait(rng.uniform(0.2, 1.0) * usual):
                raise RuntimeError(f"{job}: a run ended with code {worker.returncode}")
            return kills
        except subprocess.TimeoutExpired:
            worker.kill()
            worker.wait()
            kills += 1


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=30, help="minimum number of kills")
    parser.add_argument("--seed", type=int, default=0)
    given = parser.parse_args()
    rng, kills, jobs, wrong = random.Random(given.seed), 0, 0, 0
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        job = planned(folder)
        shutil.copytree(job, folder / "kept")
        begin = time.monotonic()
        if run(job).wait():
            raise RuntimeError("the undisturbed run failed")
        usual, expected = time.monotonic() - begin, loom.tiling.finish_tiles(job).read_bytes()
        while kills < given.count:
            shutil.rmtree(job)
            shutil.copytree(folder / "kept", job)
            kills += kills_until_done(job, rng, usual)
            jobs += 1
            left = sorted(each.name for each in folder.iterdir())
            is_same = loom.tiling.finish_tiles(job).read_bytes() == expected and left == ["in.laz", "job", "kept"]
            wrong += not is_same
            print(f"{kills} of {given.count} kills in {time.monotonic() - begin:.0f} s", file=sys.stderr, flush=True)
    print(f"| tile jobs | {jobs} jobs, {kills} kills | {wrong} differ |")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
