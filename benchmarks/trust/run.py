"""Rates of unreliable results accepted and of reliable results rejected.

    make trust                                      cases drawn with the date as seed, 40 minutes on all idle cores
    make trust ARGS="--all --write"                 all cases, and the tables of docs/trust.md
    make trust ARGS="--only lidar --budget 5"       POINTLOOM_DATA: folder of real data, optional

Cases that should be rejected and cases that should be accepted, by area: those of each area's own file, and synthetic
sites on which no constant was chosen (held_out.py). Each area gets the same fraction of its expected time, and one
without a list of cases is drawn with this probability. The table has all cases with a result for the present code, of
earlier runs, too. `--write` replaces the rows of the areas of which all cases have a result, and keeps the others.

Each result is stored in build/trust, or in the folder of `--output`. A run that was interrupted continues with the
cases that are left. A case runs again if the code that it ran has changed (results.py). Areas run in one process per
core, each with one thread: two of them finish sooner than one with two threads. Times are CPU seconds.
"""

from __future__ import annotations

import argparse
import datetime
import fcntl
import importlib
import os
import random
import signal
import sys
import time
from collections.abc import Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from dataclasses import dataclass
from multiprocessing import get_context
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
sys.path[:0] = [str(FOLDER), str(FOLDER.parent)]

from judged import NO_CONSTANT, Case, Judged, rates, table  # noqa: E402
from pages import text_between, write_between  # noqa: E402
from results import Result, Results, imported_modules, read_lines  # noqa: E402

PAGE = FOLDER.parent.parent / "docs" / "trust.md"
OUTPUT = FOLDER.parent.parent / "build" / "trust"
BUDGET = 40.0  # minutes on all cores
MOST_CASES = 12  # of a kind of result in the table of failure cases
REPORT_SECONDS = 60.0  # between progress lines if standard error is no terminal
ONE_THREAD = {"POINTLOOM_CPU_THREADS": "1", "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "MKL_NUM_THREADS": "1"}
ALL = "all"  # name of the only case of an area without a list of cases

# Files with `cases` or `judge`, and CPU seconds of each area with one thread (2026-11-29). Long areas start first.
OWN = {
    "images": 750.0,
    "facades": 650.0,
    "depth": 80.0,
    "lidar": 660.0,
    "stream": 400.0,
    "cameras": 300.0,
    "posed_cameras": 260.0,
    "tracking": 50.0,
    "maps": 270.0,
    "registration": 160.0,
    "alignment": 160.0,
    "surfaces": 930.0,
    "meshes": 230.0,
    "fusing": 2630.0,
}
HELD_OUT = {"tracking": 330.0, "scanning": 160.0, "registering": 410.0, "images": 210.0, "picturing": 350.0}
HELD_OUT_LISTS = ("tracking", "scanning", "picturing")  # areas of held_out.py that list their cases
SECONDS = OWN | {f"held-out-{name}": seconds for name, seconds in HELD_OUT.items()}


def areas() -> list[str]:
    """The names of the areas."""
    return [name for name in SECONDS if name not in OWN or (FOLDER / f"{name}.py").exists()]


def cases_of(area: str) -> dict[str, Case]:
    """The cases of an area by name, without running them."""
    if area in OWN:
        module = importlib.import_module(area)
        make, is_list = getattr(module, "cases", None) or module.judge, hasattr(module, "cases")
    else:
        name = area.removeprefix("held-out-")
        make, is_list = importlib.import_module("held_out").AREAS[name], name in HELD_OUT_LISTS
    cases = list(make()) if is_list else [Case(ALL, make)]
    named = {case.name: case for case in cases}
    if len(named) < len(cases):
        raise ValueError(f"{area}: two cases have one name")
    return named


def run_case(area: str, name: str) -> Result | str:
    """Run a case in this process. The reason if its data are missing."""
    from real_data import DataMissingError

    begin = _cpu()
    try:
        judged = tuple(cases_of(area)[name].judge())
    except DataMissingError as error:
        return str(error)
    return Result(area, name, _cpu() - begin, judged, imported_modules())


def draw(named: dict[str, dict[str, Case]], seed: str, seconds: float) -> dict[str, dict[str, Case]]:
    """Draw cases that are expected to take at most some CPU seconds, the same fraction of each area."""
    order, drawn = [], {area: {} for area in named}
    for area, cases in named.items():
        generator = random.Random(f"{seed} {area}")
        first = generator.random()
        names = generator.sample(list(cases), len(cases))
        order += [((k + first) / len(names), area, name) for k, name in enumerate(names)]
    for _, area, name in sorted(order):
        each = SECONDS[area] / len(named[area])
        if each <= seconds:
            drawn[area][name] = named[area][name]
            seconds -= each
    return drawn


def _cpu() -> float:
    return sum(os.times()[:4])


# ------------------------------------------------------------------------------------------------ worker processes


@dataclass
class Job:
    """A case to run, and its expected CPU time [s]."""

    area: str
    case: str
    seconds: float


def jobs_of(drawn: dict[str, dict[str, Case]], named: dict[str, dict[str, Case]], stored: Results) -> list[Job]:
    """The drawn cases without a valid result. Those of one area take equal times, or as their area's stored ones do."""
    jobs = []
    for area in drawn:
        known = [stored.valid[area, case].seconds for case in named[area] if (area, case) in stored.valid]
        each = sum(known) / len(known) if len(known) > 3 else SECONDS[area] / max(len(named[area]), 1)
        jobs += [Job(area, case, each) for case in drawn[area] if (area, case) not in stored.valid]
    return jobs


class Worker:
    """One process that runs the cases of one area after another; a new area gets a new process."""

    def __init__(self) -> None:
        self.area, self._pool = "", None

    def start(self, job: Job) -> Future:
        if self._pool is None or job.area != self.area:
            self.stop()
            self.area = job.area
            self._pool = ProcessPoolExecutor(1, get_context("spawn"), initializer=_prepare, initargs=(os.getpid(),))
        return self._pool.submit(run_case, job.area, job.case)

    def stop(self) -> None:
        """End the process, also while it runs a case."""
        if self._pool is not None:
            processes = list((self._pool._processes or {}).values())
            self._pool.shutdown(wait=False, cancel_futures=True)
            for process in processes:
                process.terminate()
            self._pool = None


def _prepare(parent: int) -> None:
    """Leave Ctrl-C to the parent, and end with it."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    if sys.platform == "linux":
        import ctypes

        ctypes.CDLL(None).prctl(1, signal.SIGKILL)  # PR_SET_PDEATHSIG
    if os.getppid() != parent:
        raise SystemExit("the parent process has ended")


def next_job(jobs: list[Job], area: str, others: set[str]) -> Job:
    """A case of the same area, else of the area with the most expected work that no other process runs."""
    work: dict[str, float] = {}
    for job in jobs:
        work[job.area] = work.get(job.area, 0.0) + job.seconds
    best = area if area in work else max(work, key=lambda name: (name not in others, work[name]))
    return next(job for job in jobs if job.area == best)


def run_jobs(jobs: list[Job]) -> Iterator[tuple[Job, Result | str | BaseException]]:
    """Run the jobs in one process per core, and yield each result as it ends. No process is left behind."""
    os.environ.update(ONE_THREAD)
    workers = [Worker() for _ in range(len(os.sched_getaffinity(0)))]
    idle, running, queue = list(workers), {}, list(jobs)
    try:
        while queue or running:
            while idle and queue:
                worker = next((each for each in idle if any(job.area == each.area for job in queue)), idle[0])
                job = next_job(queue, worker.area, {other.area for other, _ in running.values()})
                queue.remove(job)
                idle.remove(worker)
                running[worker.start(job)] = worker, job
            for future in wait(running, return_when=FIRST_COMPLETED).done:
                worker, job = running.pop(future)
                idle.append(worker)
                error = future.exception()
                if isinstance(error, BrokenProcessPool):
                    worker.stop()
                yield job, future.result() if error is None else error
    finally:
        for worker in workers:  # one that starts during an interruption is neither idle nor running
            worker.stop()


class Progress:
    """Prints the number of cases and the expected remaining time."""

    def __init__(self, jobs: list[Job]) -> None:
        self.left, self.count, self.done, self.spent = sum(job.seconds for job in jobs), len(jobs), 0, 0.0
        self._begin = self._printed = time.monotonic()

    def add(self, job: Job) -> None:
        self.done, self.left, self.spent = self.done + 1, self.left - job.seconds, self.spent + job.seconds
        now = time.monotonic()
        if not sys.stderr.isatty() and now - self._printed < REPORT_SECONDS and self.done < self.count:
            return
        self._printed = now
        remaining = self.left * (now - self._begin) / self.spent if self.spent else 0.0
        text = f"{self.done:,} of {self.count:,} cases, {job.area}, about {remaining / 60:.0f} min left"
        print(f"\r{text:<78}" if sys.stderr.isatty() else text, end="", file=sys.stderr, flush=True)
        if not sys.stderr.isatty() or self.done == self.count:
            print(file=sys.stderr, flush=True)


# ------------------------------------------------------------------------------------------------ command


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", action="append", choices=areas(), help="an area; may be given several times")
    parser.add_argument("--output", type=Path, default=OUTPUT, help="folder of the stored results (build/trust)")
    parser.add_argument("--cases", action="store_true", help="print each case, not only the rates")
    parser.add_argument("--write", action="store_true", help="write the tables of complete areas into docs/trust.md")
    parser.add_argument("--all", action="store_true", help="all cases, not drawn ones")
    parser.add_argument("--budget", type=float, default=BUDGET, metavar="MINUTES", help="of the drawn cases (40)")
    parser.add_argument("--seed", default=str(datetime.date.today()), help="of the drawn cases, instead of the date")
    parser.add_argument(
        "--read", type=Path, action="append", help="read cases from files of an --output folder instead of running any"
    )
    arguments = parser.parse_args()
    if arguments.read:
        rows = [row for path in arguments.read for line in read_lines(path) for row in line.get("judged", [line])]
        judged = [Judged(**row) for row in rows]
        report(judged, judged if arguments.write else [], cases=arguments.cases)
        return 0
    chosen = [name for name in areas() if not arguments.only or name in arguments.only]
    named = {area: cases_of(area) for area in chosen}
    seconds = float("inf") if arguments.all else 60 * arguments.budget * len(os.sched_getaffinity(0))
    judged, incomplete, failures = run_all(draw(named, arguments.seed, seconds), named, arguments.output)
    complete = [each for area in chosen if area not in incomplete for each in judged[area]]
    report(
        [each for area in chosen for each in judged[area]], complete if arguments.write else [], cases=arguments.cases
    )
    if arguments.write and incomplete:
        print(f"{PAGE.name}: rows not written, since cases are missing: {', '.join(incomplete)}", file=sys.stderr)
    print("\n".join(failures), file=sys.stderr)
    return int(bool(failures))


def run_all(
    drawn: dict[str, dict[str, Case]], named: dict[str, dict[str, Case]], folder: Path
) -> tuple[dict[str, list[Judged]], list[str], list[str]]:
    """Run the drawn cases without a stored result.

    Returns:
        The results of all cases that have one, by area, the areas that lack some, and the failures.
    """
    stored = Results(folder)
    with (folder / "lock").open("w") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise SystemExit(f"{folder}: another run writes into this folder") from None
        jobs, failures, missing = jobs_of(drawn, named, stored), [], set()
        count, work = sum(map(len, drawn.values())), sum(job.seconds for job in jobs)
        cores = len(os.sched_getaffinity(0))
        total = sum(map(len, named.values()))
        print(f"{count:,} of {total:,} cases drawn")
        print(f"{len(jobs):,} of {count:,} cases left, about {work / 60 / cores:.0f} min on {cores} idle cores")
        progress = Progress(jobs)
        try:
            for job, outcome in run_jobs(jobs):
                if isinstance(outcome, Result):
                    stored.add(outcome)
                elif isinstance(outcome, BaseException):
                    failures.append(f"{job.area}, {job.case}: {type(outcome).__name__}: {outcome}")
                else:
                    missing.add((job.area, job.case))
                    print(f"{job.area}, {job.case}: left out, {outcome}", file=sys.stderr)
                progress.add(job)
        except KeyboardInterrupt:
            raise SystemExit(f"\ninterrupted: run the same command again to continue ({folder})") from None
    keys = {area: [(area, case) for case in named[area] if (area, case) not in missing] for area in named}
    has_result = {area: [key for key in keys[area] if key in stored.valid] for area in named}
    judged = {area: [each for key in has_result[area] for each in stored.valid[key].judged] for area in named}
    print(f"{sum(map(len, has_result.values())):,} of {total:,} cases have a result for the present code")
    return judged, [area for area in named if len(has_result[area]) < len(keys[area])], failures


def report(judged: list[Judged], written: list[Judged], *, cases: bool) -> None:
    """Print the tables, and write those of some results into the page."""
    print("\n".join([*rates(judged), "", *(table(judged) if cases else [])]))
    if written:
        failures = [c for c in written if c.wrong_believed or c.right_refused]
        kinds = list(dict.fromkeys(c.area for c in written))
        first = [c for kind in kinds for c in [f for f in failures if f.area == kind][:MOST_CASES]]
        for name, lines in (("rates", rates(written)), ("cases", table(first))):
            write_between(PAGE, name, "\n".join(merged(text_between(PAGE, name).splitlines(), lines, kinds)))


def merged(old: list[str], new: list[str], kinds: list[str]) -> list[str]:
    """The rows of a table, with those of some kinds of results replaced where the first of each kind was."""
    heading, rows = new[:2], new[2:]
    kind_of = {row: row.split(" | ")[0].removeprefix("| ").removesuffix(NO_CONSTANT) for row in old[2:] + rows}
    order = dict.fromkeys([kind_of[row] for row in old[2:]] + kinds)
    return heading + [row for kind in order for row in (rows if kind in kinds else old[2:]) if kind_of[row] == kind]


if __name__ == "__main__":
    raise SystemExit(main())
