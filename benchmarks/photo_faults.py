"""Kill the pipeline from photographs to a mesh at random times, and compare the result with an undisturbed run.

    python benchmarks/photo_faults.py WORK --kills 20 [--seed 0]

Data: eight aerial images of the country of photo_sets.py, with GPS and masks, as `pointloom video --work --resume`. The
command gets SIGKILL after a random time, or soon after the start of a random stage. It is resumed until it
completes, and
repeated until the requested number of kills. Each result is compared with an undisturbed run byte for byte: mesh,
cloud,
poses and every file of the stages, except for COLMAP's database (other row order) and records (times).
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

COUNT, STEP = 8, 12.0  # number of images, and [degrees] between them
MAX_RUNS = 60
MARK = "POINTLOOM_PHOTO_FAULTS"
OPTIONS = ["--max-size", "96", "--max-features", "1500", "--force", "--resume", "--json"]
STAGES = ("frames", "features", "matches", "model", "undistorted", "depth", "fused", "mesh")
LOOSE = re.compile(r"(features|matches)/.*database\.db|records/|report\.json|video\.json")  # rows, times
LATE = 1.5  # [s] mean delay of half of the kills after the start of a stage; the others have a random time
GONE = 20.0  # [s] in which children of a killed run must exit


def write(folder: Path) -> None:
    """Images of an oblique orbit, and masks that exclude a bottom strip and a block."""
    photos = drone()
    angles = np.radians(STEP * np.arange(COUNT))
    eyes = np.column_stack([48 * np.cos(angles), 48 * np.sin(angles), 42 + 3 * np.sin(9 * angles)])
    photos.views = [View(look_at(eye), 560, 30) for eye in eyes]
    write_set(photos, folder)
    (folder / "masks").mkdir()
    for k, name in enumerate(photos.names):
        mask = np.full((480, 640), 255, np.uint8)
        mask[440:], mask[40:120, 60 * k : 60 * k + 100] = 0, 0
        Image.fromarray(mask).save(folder / "masks" / f"{name}.png")


def begin(folder: Path, work: Path, out: Path) -> subprocess.Popen[bytes]:
    outputs = ["-o", out / "mesh.ply", "--cloud", out / "cloud.ply", "--trajectory", out / "poses.log"]
    command = [sys.executable, "-m", "pointloom", "video", folder / "images", "--masks", folder / "masks"]
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
    """Processes of a run that survive its kill."""
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


def attack(folder: Path, base: Path, mean: float, chance: random.Random, max_kills: int, counts: Counter[str]) -> str:
    """Kill one job until it completes or there were enough kills; counts the stage of each kill."""
    work, out = base / "work", base / "out"
    shutil.rmtree(base, ignore_errors=True)
    out.mkdir(parents=True)
    for _ in range(MAX_RUNS):
        ahead = [stage for stage in STAGES if not (work / "records" / f"{stage}.json").is_file()]
        stage_folder = work / f"{chance.choice(ahead or STAGES)}.part" if chance.random() < 0.5 else None
        wait = chance.expovariate(1 / mean) if stage_folder is None else chance.expovariate(1 / LATE)
        process = begin(folder, work, out)
        while stage_folder is not None and process.poll() is None and not stage_folder.is_dir():
            time.sleep(0.003)
        end = time.monotonic() + (wait if counts["kills"] < max_kills else 1e9)
        while process.poll() is None and time.monotonic() < end:
            time.sleep(0.003)
        if process.poll() is not None:
            counts["exit codes not 0"] += process.returncode != 0
            return (out / "log").read_text()
        process.kill()
        process.wait()
        counts["kills"] += 1
        done = [stage for stage in STAGES if (work / "records" / f"{stage}.json").is_file()]
        counts[f"after {done[-1] if done else 'nothing'}"] += 1
        counts["processes left over"] += children_left(out)
    raise SystemExit(f"not finished after {MAX_RUNS} runs")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("work", type=Path)
    parser.add_argument("--kills", type=int, default=20)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--output", type=Path)
    given = parser.parse_args()
    folder, chance, counts = given.work / "set", random.Random(given.seed), Counter[str]()
    if not (folder / "masks").is_dir():
        write(folder)
    start = time.monotonic()
    quiet = Counter[str]({"kills": 0})
    log = attack(folder, given.work / "quiet", 1e9, chance, 0, quiet)
    seconds = time.monotonic() - start
    true = digests(given.work / "quiet" / "work", given.work / "quiet" / "out")
    first_report = json.loads(log)
    print(
        f"undisturbed: {seconds:.0f} s, {len(true)} files, units {first_report['units']}, "
        f"warnings {first_report['warnings']}",
        flush=True,
    )
    while counts["kills"] < given.kills:
        attack(folder, given.work / "killed", seconds / 4, chance, given.kills, counts)
        actual = digests(given.work / "killed" / "work", given.work / "killed" / "out")
        differ = [name for name in sorted(true.keys() | actual.keys()) if true.get(name) != actual.get(name)]
        counts["jobs"] += 1
        counts["files compared"] += len(true)
        counts["files that differ"] += len(differ)
        print(dict(counts), differ[:5], flush=True)
    report = {
        "seed": given.seed,
        "units": first_report["units"],
        "warnings": first_report["warnings"],
        "counts": dict(sorted(counts.items())),
    }
    if given.output:
        given.output.write_text(json.dumps(report, indent=1) + "\n")
    print(json.dumps(report, indent=1))


if __name__ == "__main__":
    main()
