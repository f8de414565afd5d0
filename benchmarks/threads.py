"""Two threads against one: speed-up of each operation of `make bench`, beside that of its best baseline.

    python benchmarks/threads.py [--only NAME] [--output FILE]

Each operation runs at the last size of the saved `make bench`, each contestant in one process with one thread and core
and in another with two. A run goes on where one of the same commit ended. The rows are saved in
results/threads-cpu.json, from which write_pages.py makes the table of docs/measured.md.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER))

from contest import POINTLOOM, limit_threads, operations  # noqa: E402
from run import continued, in_own_process, write_json  # noqa: E402

RESULTS = FOLDER / "results" / "threads-cpu.json"
BENCH_RESULTS = FOLDER / "results" / "operations-cpu.json"
SECONDS = 2.0  # of timed calls, of which the best counts
MIN_CALLS = 2
PROCESS_SECONDS = 600.0


def run_one(name: str, size: str, label: str) -> float:
    """Seconds of a contestant's call in this process."""
    _, operation = operations()[name]
    contestant, device = operation.contestant(label, "cpu")
    scene = operation.scenes[size]()  # kept alive until the end, with its files
    trial = contestant.trial(scene, device)
    trial.once()
    seconds: list[float] = []
    while len(seconds) < MIN_CALLS or (sum(seconds) < SECONDS and len(seconds) < 100):
        arguments = trial.arguments()
        begin = time.perf_counter()
        trial.call(*arguments)
        seconds.append(time.perf_counter() - begin)
    return min(seconds)


def timed(name: str, size: str, label: str, threads: int) -> float | None:
    """`run_one` in a process of its own with some threads. None if it fails."""
    command = [sys.executable, __file__, "--one", name, size, label]
    row, _ = in_own_process(command, PROCESS_SECONDS, BENCH_THREADS=str(threads))
    return None if row is None else row["seconds"]


def main() -> int:
    if sys.argv[1:2] == ["--one"]:
        limit_threads("cpu")
        print(json.dumps({"seconds": run_one(*sys.argv[2:5])}))
        return 0
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--only", action="append", help="operations whose names start with this")
    parser.add_argument("--output", type=Path, default=RESULTS, metavar="FILE", help="JSON file of the rows")
    options = parser.parse_args()
    run = continued(options.output)
    last = {row["operation"]: row for row in json.loads(BENCH_RESULTS.read_text())["results"] if "ratio" in row}
    for name, row in last.items():
        if name in run["rows"] or (options.only and not any(name.startswith(start) for start in options.only)):
            continue
        size, peer = row["size"], row["best_peer"]
        seconds = {label: [timed(name, size, label, threads) for threads in (1, 2)] for label in (POINTLOOM, peer)}
        run["rows"][name] = {"size": size, "peer": peer, "seconds": seconds}
        texts = [
            f"{label} " + " -> ".join("none" if s is None else f"{s:.4f} s" for s in seconds[label])
            for label in seconds
        ]
        print(f"{name:24} {size:20} {'   '.join(texts)}", flush=True)
        write_json(options.output, run)
    return 0


if __name__ == "__main__":
    sys.exit(main())
