"""Kill processes of tile jobs at random times, and compare the result with an undisturbed run.

    python benchmarks/tile_faults.py --seed 0 --kills 100

Jobs over a synthetic survey are run by processes of this machine (`--workers`) and by a dask scheduler with its own
workers (`--scheduler`), alternately. A worker, the runner, the scheduler or the
process that writes the merged file gets SIGKILL; killed processes are restarted until the job is finished. The sorted
rows of each finished file are compared bitwise with those of a run in one process.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import os
import random
import shutil
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import laspy
import numpy as np
import psutil

import pointloom as loom
from pointloom.tiling.manifest import Manifest
from pointloom.tiling.runners import retry_tiles
from pointloom.tiling.status import tile_status

STEPS = [
    {"step": "remove_statistical_outlier", "nb_neighbors": 8, "std_ratio": 2.0},
    {"step": "voxel_down_sample", "voxel_size": 0.5},
    {"step": "estimate_normals", "max_nn": 10},
]
CLUSTERS = [{"step": "voxel_down_sample", "voxel_size": 0.5}, {"step": "cluster_dbscan", "eps": 0.8, "min_points": 4}]
CHAINS = {"filters": STEPS, "clusters": CLUSTERS}
RUNNERS = ("workers", "scheduler")
COMMAND = [sys.executable, "-m", "pointloom", "tile"]
MAX_RUNS = 60  # per job
MAX_KILLS = 10  # during the tiles of one job, so that there are several jobs of each runner
LONGEST = 300.0  # [s] per run
SEARCH_SECONDS = 60.0  # [s] that workers may search for a lost scheduler
MARK = "POINTLOOM_FAULT_RUN"  # environment variable of all processes of a run


def made_survey(folder: Path, points: int, seed: int) -> list[Path]:
    """Three LAZ files of a hilly square at 4 points per square meter, in steps of 1 mm, with some points in two of
    them.
    """
    rng = np.random.default_rng(seed)
    side = (points / 4) ** 0.5
    positions = rng.random((points, 2)) * side
    height = 10 * np.sin(positions[:, 0] / 30) * np.cos(positions[:, 1] / 40) + rng.normal(0, 0.03, points)
    height[::500] += rng.random(len(height[::500])) * 30
    cloud = np.column_stack([positions, height]) + np.array([500_000, 4_000_000, 100])
    paths = []
    for number, rows in enumerate(np.array_split(rng.permutation(points), 3)):
        shared = rows if number else np.concatenate([rows, [0, 1, 2]])
        times = rng.random(len(shared))
        paths.append(folder / f"part{number}.laz")
        loom.write_point_cloud(paths[-1], loom.PointCloud(cloud[shared], gps_time=times), scale=0.001)
    return paths


def sorted_rows(path: Path) -> bytes:
    """The sorted rows of a file, as bytes."""
    with laspy.open(path) as reader:
        rows = reader.read().points.array
    return np.sort(rows.view(np.dtype((np.void, rows.dtype.itemsize))).ravel()).tobytes()


class Attack:
    """One job that is killed until it is finished.

    Attributes:
        kills: Number of kills of each kind of process.
        counts: Numbers of runs and of faults.
    """

    def __init__(self, job: Path, chance: random.Random, kills: Counter[str], counts: Counter[str], max_kills: int):
        self.job, self.chance, self.kills, self.counts, self.max_kills = job, chance, kills, counts, max_kills
        self._here = min(max_kills, kills.total() + MAX_KILLS)

    def work(self, runner: str) -> None:
        """Run until all tiles are done, with kills."""
        for _ in range(MAX_RUNS):
            with _cluster(runner) as (options, others):
                self.counts["runs"] += 1
                process = _begin("run", str(self.job), *options)
                self._harass(process, others)
                _end(process)
            status = tile_status(self.job)
            if status.aside + status.failed:
                self.counts["tiles set aside"] += status.aside
                self.counts["tiles failed"] += status.failed
                if status.failed:
                    print(str(status)[:600], file=sys.stderr)
                retry_tiles(self.job)
            elif states := _bad_files(self.job):
                print(str(status)[:600], file=sys.stderr)
                self.counts["files set aside"] += states.count("aside")  # three workers were killed during it
                self.counts["files failed"] += states.count("failed")
                retry_tiles(self.job)
            elif status.is_finished:
                return
        raise SystemExit(f"{self.job}: not finished after {MAX_RUNS} runs")

    def _harass(self, process: subprocess.Popen[bytes], others: dict[str, list[subprocess.Popen[bytes]]]) -> None:
        end = time.monotonic() + LONGEST
        while process.poll() is None:
            wait = time.monotonic() + self.chance.expovariate(1 / 1.5)
            while time.monotonic() < min(wait, end) and process.poll() is None:
                time.sleep(0.02)
            if time.monotonic() > end:
                self.counts["runs that hung"] += 1
                _end(process)
                return
            if process.poll() is None and self.kills.total() < self._here:
                self._kill(process, others)

    def _kill(self, process: subprocess.Popen[bytes], others: dict[str, list[subprocess.Popen[bytes]]]) -> None:
        """Kill one process of the run; the runner less often than its workers."""
        workers = _workers_of(process) + others.get("worker", [])
        kind = self.chance.choice(["worker"] * 3 + ["runner"] + ["scheduler"] * ("scheduler" in others))
        victims = {"worker": workers, "runner": [process]}.get(kind, others.get(kind, []))
        with contextlib.suppress(psutil.NoSuchProcess):
            if victims:
                victim = self.chance.choice(victims)
                victim.kill()
                victim.wait()
                self.kills[kind] += 1
                if kind == "worker" and victim in others.get("worker", []):
                    others["worker"].remove(victim)
                    others["worker"].append(_dask("worker", others["address"], *_WORKER))  # as a cluster's manager does

    def finish(self, expected: bytes) -> None:
        """Write the merged file, with kills, and compare it with the expected one."""
        path = self.job / "result.laz"
        while True:
            process = _begin("finish", str(self.job), "--force")
            if self.chance.random() < 0.7 and self.kills.total() < self.max_kills:
                time.sleep(self.chance.uniform(0.5, 1.6))
                if process.poll() is None:
                    process.kill()
                    self.kills["finish"] += 1
            code = process.wait()
            if path.exists():
                self.counts["files"] += 1
                self.counts["files that differ"] += sorted_rows(path) != expected
            if code == 0:
                return
            if code > 0:
                self.counts["finish failed"] += 1
                loom.tiling.run_tiles(self.job)


def _bad_files(job: Path) -> list[str]:
    """States of input files that could not be sorted into tiles."""
    with Manifest(job) as manifest:
        return [row["state"] for row in manifest.rows("SELECT state FROM sources WHERE state IN ('failed', 'aside')")]


_WORKER = ("--nthreads", "1", "--no-nanny", "--no-dashboard", "--memory-limit", "0", "--death-timeout", "20")


def _dask(what: str, address: str, *options: str) -> subprocess.Popen[bytes]:
    command = [sys.executable, "-m", f"distributed.cli.dask_{what}", address, "--host", "127.0.0.1", *options]
    return subprocess.Popen(command if address else [*command[:3], *command[4:]], stderr=subprocess.DEVNULL)


@contextlib.contextmanager
def _cluster(runner: str) -> Iterator[tuple[list[str], dict[str, Any]]]:
    """The options of a runner, and its additional processes."""
    if runner != "scheduler":
        yield [f"--{runner}", "2"], {}
        return
    scheduler_file = Path(tempfile.mkdtemp()) / "scheduler.json"
    options = ("--port", "0", "--no-dashboard", "--scheduler-file", str(scheduler_file))
    others: dict[str, Any] = {"scheduler": [_dask("scheduler", "", *options)], "worker": []}
    while not scheduler_file.exists() or not scheduler_file.read_text().endswith("}"):
        time.sleep(0.05)
    others["address"] = json.loads(scheduler_file.read_text())["address"]
    others["worker"] = [_dask("worker", others["address"], *_WORKER) for _ in range(2)]
    try:
        yield ["--scheduler", others["address"]], others
    finally:
        for process in others["worker"] + others["scheduler"]:
            process.kill()
            process.wait()
        shutil.rmtree(scheduler_file.parent)


def _begin(what: str, *options: str) -> subprocess.Popen[bytes]:
    return subprocess.Popen([*COMMAND, what, *options], stdout=subprocess.DEVNULL, stderr=_log, start_new_session=True)


def _end(process: subprocess.Popen[bytes]) -> None:
    process.kill()
    process.wait()


def _workers_of(process: subprocess.Popen[bytes]) -> list[psutil.Process]:
    """The worker processes of a runner."""
    children = []
    with contextlib.suppress(psutil.NoSuchProcess):
        for child in psutil.Process(process.pid).children(recursive=True):
            with contextlib.suppress(psutil.NoSuchProcess):
                words = " ".join(child.cmdline())
                if "resource_tracker" not in words and words:
                    children.append(child)
    return children


def left_over(mark: str) -> int:
    """Number of processes of the runs that still exist after a while; they are terminated."""
    end = time.monotonic() + SEARCH_SECONDS
    while True:
        left = []
        for process in psutil.process_iter():
            with contextlib.suppress(psutil.Error):
                if process.environ().get(MARK) == mark and process.pid != os.getpid():
                    left.append(process)
        if not left or time.monotonic() > end:
            break
        time.sleep(1)
    for process in left:
        with contextlib.suppress(psutil.Error):
            process.kill()
    return len(left)


_log: Any = subprocess.DEVNULL


def main() -> None:
    """Run the attacks and print the results."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--kills", type=int, default=100)
    parser.add_argument("--points", type=int, default=300_000)
    parser.add_argument("--runners", default=",".join(RUNNERS))
    parser.add_argument("--chain", choices=CHAINS, default="filters")
    parser.add_argument("--log", help="file for the output of the killed commands")
    parser.add_argument("--json", type=Path, help="file for the counts")
    arguments = parser.parse_args()
    global _log
    _log = Path(arguments.log).open("wb") if arguments.log else subprocess.DEVNULL  # noqa: SIM115
    os.environ.setdefault("POINTLOOM_CPU_THREADS", "1")
    mark = os.environ[MARK] = f"{os.getpid()}-{time.time()}"
    steps = CHAINS[arguments.chain]
    chance, kills, counts = random.Random(arguments.seed), Counter[str](), Counter[str]()
    begin = time.monotonic()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        files = made_survey(folder, arguments.points, arguments.seed)
        side = (arguments.points / 4) ** 0.5
        loom.tiling.plan_tiles(files, steps, folder / "alone", size=side / 2.5)
        loom.tiling.run_tiles(folder / "alone")
        expected = sorted_rows(loom.tiling.finish_tiles(folder / "alone"))
        size = len(expected)
        print(f"{arguments.points:,} points in {len(files)} files; {size:,} bytes of rows expected", flush=True)
        while kills.total() < arguments.kills:
            runner = arguments.runners.split(",")[counts["jobs"] % len(arguments.runners.split(","))]
            job = folder / f"job{counts['jobs']}"
            loom.tiling.plan_tiles(files, steps, job, size=side / 7)
            attack = Attack(job, chance, kills, counts, arguments.kills)
            attack.work(runner)
            attack.finish(expected)
            counts["jobs"] += 1
            counts["files left over"] += sum(1 for _ in job.rglob("*.part")) + len([*(job / "locks").iterdir()])
            shutil.rmtree(job)
            seconds = time.monotonic() - begin
            print(f"{seconds:5.0f} s  {runner:9}  kills {dict(kills)}  {dict(counts)}", flush=True)
    counts["processes left over"] = left_over(mark)
    print(f"kills {dict(kills)}  {dict(counts)}")
    if arguments.json:
        options = {name: getattr(arguments, name) for name in ("seed", "points", "runners", "chain")}
        row = options | {"seconds": round(time.monotonic() - begin), "kills": kills, "counts": counts}
        arguments.json.write_text(json.dumps(row, indent=1) + "\n")
    if (
        counts["processes left over"]
        or counts["files that differ"]
        or counts["tiles failed"]
        or counts["files failed"]
        or counts["runs that hung"]
    ):
        raise SystemExit(1)


if __name__ == "__main__":
    main()
