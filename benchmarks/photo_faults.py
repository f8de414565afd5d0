"""The chain from photographs to a mesh, killed at random moments: is the result that of a run that nothing disturbed?

    python benchmarks/photo_faults.py WORK --kills 20 [--seed 0]

Eight pictures of the country of photo_sets.py from the air, which tell where they were taken, with masks, as
`pointloom video --work --resume`. The command gets SIGKILL after a random time, or soon after a random stage has begun;
what is left is gone on with, until it is done, and begun anew until there were as many kills as asked for. Each result
is held against that of a run without kills, byte for byte: mesh, cloud, poses and every file of the stages but COLMAP's
database (rows in another order) and records (times).
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import random
import re
import shutil
import subprocess
import sys
import time
from collections import Counter
from pathlib import Path

import numpy as np
import psutil
from photo_sets import View, drone
from photo_writing import write_set
from PIL import Image

from pointloom.datasets.made.views import look_at

COUNT, STEP = 8, 12.0  # pictures, and [degrees] from one to the next
MAX_RUNS = 60
MARK = "POINTLOOM_PHOTO_FAULTS"
OPTIONS = ["--max-size", "96", "--max-features", "1500", "--force", "--resume", "--json"]
STAGES = ("frames", "features", "matches", "model", "undistorted", "depth", "fused", "mesh")
LOOSE = re.compile(r"(features|matches)/.*database\.db|records/|report\.json|video\.json")  # rows, times
LATE = 1.5  # [s] after a stage has begun, in the mean, half of the kills come; the others come at any time
GONE = 20.0  # [s] in which children of a killed run have to end


def write(folder: Path) -> None:
    """Pictures of an oblique round, and masks that leave out a strip below and a block."""
    photos = drone()
    turns = np.radians(STEP * np.arange(COUNT))
    eyes = np.column_stack([48 * np.cos(turns), 48 * np.sin(turns), 42 + 3 * np.sin(9 * turns)])
    photos.views = [View(look_at(eye), 560, 30) for eye in eyes]
    write_set(photos, folder)
    (folder / "masks").mkdir()
    for k, name in enumerate(photos.names):
        mask = np.full((480, 640), 255, np.uint8)
        mask[440:], mask[40:120, 60 * k : 60 * k + 100] = 0, 0
        Image.fromarray(mask).save(folder / "masks" / f"{name}.png")


def begin(folder: Path, work: Path, out: Path) -> subprocess.Popen[bytes]:
    outputs = ["-o", out / "mesh.ply", "--cloud", out / "cloud.ply", "--trajectory", out / "poses.log"]
    command = [sys.executable, "-m", "pointloom", "video", folder / "pictures", "--masks", folder / "masks"]
    with (out / "log").open("wb") as log, (out / "errors").open("wb") as errors:
        return subprocess.Popen(
            [*map(str, command), *map(str, outputs), "--work", str(work), *OPTIONS],
            stdout=log,
            stderr=errors,
            env=os.environ | {MARK: str(out)},
        )


def digests(work: Path, out: Path) -> dict[str, str]:
    files = [path for path in work.rglob("*") if path.is_file() and not LOOSE.search(str(path.relative_to(work)))]
    files += [path for path in out.iterdir() if path.name not in ("log", "errors")]
    base = {work: "work", out: "out"}
    named = {f"{base[top]}/{p.relative_to(top)}": p for top in base for p in files if p.is_relative_to(top)}
    return {name: hashlib.sha256(path.read_bytes()).hexdigest() for name, path in sorted(named.items())}


def children_left(out: Path) -> int:
    """Processes of a run that live on after it was killed."""
    end = time.monotonic() + GONE
    while True:
        left = 0
        for process in psutil.process_iter():
            try:
                left += process.environ().get(MARK) == str(out) and process.status() != psutil.STATUS_ZOMBIE
            except (psutil.Error, OSError):
                continue
        if not left or time.monotonic() > end:
            return left
        time.sleep(0.2)


def attack(folder: Path, base: Path, mean: float, chance: random.Random, most: int, tell: Counter[str]) -> str:
    """One job, killed until it is done or there were enough kills; which stage each kill met is counted."""
    work, out = base / "work", base / "out"
    shutil.rmtree(base, ignore_errors=True)
    out.mkdir(parents=True)
    for _ in range(MAX_RUNS):
        ahead = [stage for stage in STAGES if not (work / "records" / f"{stage}.json").is_file()]
        begun = work / f"{chance.choice(ahead or STAGES)}.part" if chance.random() < 0.5 else None
        wait = chance.expovariate(1 / mean) if begun is None else chance.expovariate(1 / LATE)
        process = begin(folder, work, out)
        while begun is not None and process.poll() is None and not begun.is_dir():
            time.sleep(0.003)
        end = time.monotonic() + (wait if tell["kills"] < most else 1e9)
        while process.poll() is None and time.monotonic() < end:
            time.sleep(0.003)
        if process.poll() is not None:
            tell["exit codes not 0"] += process.returncode != 0
            return (out / "log").read_text()
        process.kill()
        process.wait()
        tell["kills"] += 1
        done = [stage for stage in STAGES if (work / "records" / f"{stage}.json").is_file()]
        tell[f"after {done[-1] if done else 'nothing'}"] += 1
        tell["processes left over"] += children_left(out)
    raise SystemExit(f"not finished after {MAX_RUNS} runs")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("work", type=Path)
    parser.add_argument("--kills", type=int, default=20)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--output", type=Path)
    given = parser.parse_args()
    folder, chance, tell = given.work / "set", random.Random(given.seed), Counter[str]()
    if not (folder / "masks").is_dir():
        write(folder)
    start = time.monotonic()
    quiet = Counter[str]({"kills": 0})
    log = attack(folder, given.work / "quiet", 1e9, chance, 0, quiet)
    whole = time.monotonic() - start
    true = digests(given.work / "quiet" / "work", given.work / "quiet" / "out")
    told = json.loads(log)
    print(
        f"undisturbed: {whole:.0f} s, {len(true)} files, units {told['units']}, warnings {told['warnings']}", flush=True
    )
    while tell["kills"] < given.kills:
        attack(folder, given.work / "killed", whole / 4, chance, given.kills, tell)
        found = digests(given.work / "killed" / "work", given.work / "killed" / "out")
        differ = [name for name in sorted(true.keys() | found.keys()) if true.get(name) != found.get(name)]
        tell["jobs"] += 1
        tell["files compared"] += len(true)
        tell["files that differ"] += len(differ)
        print(dict(tell), differ[:5], flush=True)
    report = {
        "seed": given.seed,
        "units": told["units"],
        "warnings": told["warnings"],
        "counts": dict(sorted(tell.items())),
    }
    if given.output:
        given.output.write_text(json.dumps(report, indent=1) + "\n")
    print(json.dumps(report, indent=1))


if __name__ == "__main__":
    main()
