"""Rates of unreliable results accepted and of reliable results rejected.

    make trust [ARGS="--only lidar --write"]        POINTLOOM_DATA: folder of real data, optional
    make trust ARGS=--quick                         the first cases of each area, five minutes in total

Cases that should be rejected and cases that should be accepted, by area: those of each area's own file, and synthetic
sites on which no constant was chosen (held_out.py). Prints the tables of docs/trust.md. `--write` replaces the rows of
the areas that were run, and keeps the others.

Each result is stored in build/trust, or in the folder of `--output`. A run that was interrupted continues with the
cases that are left. A case runs again if the code that it ran has changed (results.py). Areas run in one process per
core, each with one thread: two of them finish sooner than one with two threads. Times are CPU seconds.
"""

from __future__ import annotations

import argparse
import fcntl
import importlib
import itertools
import os
import signal
import sys
import time
from collections.abc import Iterable, Iterator
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
QUICK_SECONDS = 300.0  # of all areas with --quick
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


def run_case(area: str, name: str, limit: float = float("inf")) -> Result | str:
    """Run a case in this process; it ends early after `limit` seconds. The reason if its data are missing."""
    from real_data import DataMissingError

    begin, judged = _cpu(), []
    try:
        for each in cases_of(area)[name].judge():
            judged.append(each)
            if _cpu() - begin > limit:
                break
    except DataMissingError as error:
        return str(error)
    return Result(area, name, _cpu() - begin, tuple(judged), imported_modules())


def _cpu() -> float:
    return sum(os.times()[:4])


# ------------------------------------------------------------------------------------------------ worker processes


@dataclass
class Job:
    """A case to run, and its expected CPU time [s]."""

    area: str
    case: str
    seconds: float


def jobs_of(names: Iterable[str], stored: Results, only: dict[str, dict[str, Case]]) -> list[Job]:
    """The cases without a valid result. Those of one area take equal times, or as their area's stored ones do."""
    jobs = []
    for area in names:
        known = [stored.valid[area, case].seconds for case in only[area] if (area, case) in stored.valid]
        each = sum(known) / len(known) if len(known) > 3 else SECONDS[area] / max(len(only[area]), 1)
        jobs += [Job(area, case, each) for case in only[area] if (area, case) not in stored.valid]
    return jobs


class Worker:
    """One process that runs the cases of one area after another; a new area gets a new process."""

    def __init__(self) -> None:
        self.area, self._pool = "", None

    def start(self, job: Job, limit: float) -> Future:
        if self._pool is None or job.area != self.area:
            self.stop()
            self.area = job.area
            self._pool = ProcessPoolExecutor(1, get_context("spawn"), initializer=_prepare, initargs=(os.getpid(),))
        return self._pool.submit(run_case, job.area, job.case, limit)

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


def run_jobs(jobs: list[Job], limits: dict[str, float]) -> Iterator[tuple[Job, Result | str | BaseException]]:
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
                running[worker.start(job, limits.get(job.area, float("inf")))] = worker, job
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
    parser.add_argument("--write", action="store_true", help="write the tables into docs/trust.md")
    parser.add_argument("--quick", action="store_true", help="the first cases of each area, five minutes in all")
    parser.add_argument(
        "--read", type=Path, action="append", help="read cases from files of an --output folder instead of running any"
    )
    arguments = parser.parse_args()
    if arguments.read:
        rows = [row for path in arguments.read for line in read_lines(path) for row in line.get("judged", [line])]
        report([Judged(**row) for row in rows], cases=arguments.cases, write=arguments.write)
        return 0
    chosen = [name for name in areas() if not arguments.only or name in arguments.only]
    named = {area: cases_of(area) for area in chosen}
    if arguments.quick:
        judged, failures = run_quickly(named)
    else:
        judged, failures = run_all(named, arguments.output)
    report(judged, cases=arguments.cases, write=arguments.write)
    print("\n".join(failures), file=sys.stderr)
    return int(bool(failures))


def run_all(named: dict[str, dict[str, Case]], folder: Path) -> tuple[list[Judged], list[str]]:
    """Run the cases without a stored result. All results of the areas that are complete, and the failures."""
    stored = Results(folder)
    with (folder / "lock").open("w") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise SystemExit(f"{folder}: another run writes into this folder") from None
        jobs, failures, missing = jobs_of(named, stored, named), [], set()
        count, work = sum(map(len, named.values())), sum(job.seconds for job in jobs)
        cores = len(os.sched_getaffinity(0))
        print(f"{len(jobs):,} of {count:,} cases left, about {work / 60 / cores:.0f} min on {cores} idle cores")
        progress = Progress(jobs)
        try:
            for job, outcome in run_jobs(jobs, {}):
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
    failed = {failure.split(",")[0] for failure in failures}
    cases = [
        (area, case) for area in named if area not in failed for case in named[area] if (area, case) not in missing
    ]
    return [judged for key in cases for judged in stored.valid[key].judged], failures


def run_quickly(named: dict[str, dict[str, Case]]) -> tuple[list[Judged], list[str]]:
    """The first cases of each area, in the order of the areas. Nothing is stored."""
    share = QUICK_SECONDS * len(os.sched_getaffinity(0)) / len(named)
    jobs = []
    for area, cases in named.items():
        each = SECONDS[area] / max(len(cases), 1)
        jobs += [Job(area, case, each) for case in itertools.islice(cases, max(1, int(share / each)))]
    judged, failures, progress = [], [], Progress(jobs)
    for job, outcome in run_jobs(jobs, dict.fromkeys(named, share)):
        if isinstance(outcome, Result):
            judged += outcome.judged
        else:
            failures += [f"{job.area}, {job.case}: {outcome!r}"] if isinstance(outcome, BaseException) else []
        progress.add(job)
    return judged, failures


def report(cases_of_run: list[Judged], *, cases: bool, write: bool) -> None:
    """Print the tables and write them into the page."""
    print("\n".join([*rates(cases_of_run), "", *(table(cases_of_run) if cases else [])]))
    if write:
        failures = [c for c in cases_of_run if c.wrong_believed or c.right_refused]
        kinds = list(dict.fromkeys(c.area for c in cases_of_run))
        first = [c for kind in kinds for c in [f for f in failures if f.area == kind][:MOST_CASES]]
        for name, lines in (("rates", rates(cases_of_run)), ("cases", table(first))):
            write_between(PAGE, name, "\n".join(merged(text_between(PAGE, name).splitlines(), lines, kinds)))


def merged(old: list[str], new: list[str], kinds: list[str]) -> list[str]:
    """The rows of a table, with those of some kinds of results replaced where the first of each kind was."""
    heading, rows = new[:2], new[2:]
    kind_of = {row: row.split(" | ")[0].removeprefix("| ").removesuffix(NO_CONSTANT) for row in old[2:] + rows}
    order = dict.fromkeys([kind_of[row] for row in old[2:]] + kinds)
    return heading + [row for kind in order for row in (rows if kind in kinds else old[2:]) if kind_of[row] == kind]


if __name__ == "__main__":
    raise SystemExit(main())
