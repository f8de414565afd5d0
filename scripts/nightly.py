"""Run checks that are too slow for CI, an hour of them drawn by the date: `make nightly`.

    make nightly                                     the steps of today, then the table
    make nightly ARGS="--seed 2026-11-30"            the steps of another day
    make nightly ARGS="--all"                        all steps, many hours
    make nightly ARGS="--only taichi --only fuzz"    the steps whose names begin so
    make nightly ARGS="--list"                       days, expected minutes and commands of all steps

Some steps run each day, with the date as seed. Each other step has one day of a cycle, on which it is among the first
ones. Steps whose day has passed without a result follow, the latest day first. A step is started only if it is expected
to end within the budget, by its measured time where there is one. The number of days of the cycle is printed.

The newest result of each step is in build/nightly, or in the folder that POINTLOOM_NIGHTLY names, with its log. The
next run continues: results of the same day count toward the budget, and a step does not run again if it has passed
since its day, or has a result for the present tree (uncommitted files included), command, variables, version of Python
and presence of POINTLOOM_DATA. `--again` runs it anyway. An interruption loses only the step that was running. The exit
code is 1 if a step failed, or with --all or --only was not run.
"""

from __future__ import annotations

import argparse
import contextlib
import datetime
import hashlib
import json
import math
import os
import re
import resource
import runpy
import signal
import subprocess
import sys
import tempfile
import time
import zlib
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PASSED, FAILED, NOT_RUN = "passed", "failed", "not run"
NO_TESTS = re.compile(r"^make(\[\d+\])?: \*\*\* .*\] Error 5$", re.MULTILINE)  # pytest's exit code
STOPS = (signal.SIGINT, signal.SIGTERM)
STEP_LIMIT = 3.0  # times the expected seconds, at least MIN_LIMIT: then the step is ended and has failed
MIN_LIMIT, TIMED_OUT = 600.0, 124
STOP_SECONDS = 10.0  # from SIGTERM to SIGKILL for the processes of an interrupted step
# Set by make for its own targets; a step is to run as on its own.
DROPPED = {"ARGS", "RUNS", "LOADED_RUNS", "TESTS", "MAKEFLAGS", "MFLAGS", "MAKEOVERRIDES", "MAKELEVEL"}

# ------------------------------------------------------------------------------------------------ table of steps

BUDGET = 60.0  # minutes on two cores
FILES_OF_PART = 20  # test files of one step
EMULATED = (
    "kernels", "core", "cameras", "pcd", "io", "registration", "meshing", "rgbd", "visualization", "photogrammetry",
    "tiling", "datasets", "cli", "open3d", "emulated_cuda",
)  # fmt: skip
ARCHITECTURES = (75, 90, 120)
ORDERS = (0, 2, 3)
FLAKES = {"quiet": (4, 0), "loaded": (0, 2)}  # kind -> runs and loaded runs
# Of 60 changes, of which 92 % should be noticed: less than 80 % is chance in one of 1,000 runs.
MUTANTS = "--count 60 --jobs 2 --budget 1500 --at-least 0.8"

PYTHON = ".venv/bin/python"
# With other libraries: the newest versions that pip finds (its settings choose the index), in their own environment.
# They include packages that tests import but that are in no list of constraints.
OTHERS = "torch jax numba open3d pyinstaller meshoptimizer>=0.2.30a0 pytest pytest-xdist hypothesis"
TESTS_BESIDE = (
    *(f"tests/core/test_{name}.py" for name in ("array_libraries", "other_array_libraries", "standard_streams")),
    *("tests/core/test_surroundings.py", "tests/io/test_gltf.py"),
)
BESIDE = f"""set -e
{PYTHON} -m venv build/beside
build/beside/bin/python -m pip install --quiet --upgrade --editable . {" ".join(map(repr, OTHERS.split()))}
build/beside/bin/python -m pip list
build/beside/bin/python -m pytest -n 0 {" ".join(TESTS_BESIDE)}"""


@dataclass(frozen=True)
class Step:
    """A command of the table.

    Attributes:
        name: Of the form family-part, unique.
        command: Run in the root of the checkout.
        minutes: Expected time on two cores, before the first result.
        is_daily: It runs each day, with the date as seed.
        variables: Environment variables.
        may_be_empty: It passes, too, if pytest selects no test.
    """

    name: str
    command: tuple[str, ...]
    minutes: float
    is_daily: bool = False
    variables: dict[str, str] = field(default_factory=dict)
    may_be_empty: bool = False

    def line(self) -> str:
        """The command as a line for the shell."""
        words = [word if re.fullmatch(r"[\w./=-]+", word) else repr(word) for word in self.command]
        return " ".join([*(f"{name}={value}" for name, value in self.variables.items()), *words])


def all_steps(day: datetime.date, root: Path = ROOT) -> list[Step]:
    """The steps of `make nightly`."""
    versions, fuzz = ((PYTHON, "scripts/test_versions.py"), (PYTHON, "tests/fuzz/run.py", "--count", "200", "--seed"))
    return [
        Step("mutants", ("make", "mutants", f"ARGS={MUTANTS} --seed {day}"), 13, is_daily=True),
        Step("fuzz", (*fuzz, str(day.toordinal())), 10, is_daily=True),
        Step(
            "trust", ("make", "trust", f"ARGS=--budget 5 --seed {day} --output build/nightly/trust"), 5, is_daily=True
        ),
        Step("gpu-kit", ("make", "gpu-run", "ARGS=--dry"), 10),
        *(Step(f"cuda-architectures-{each}", ("make", "check-cuda", f"ARGS={each}"), 8) for each in ARCHITECTURES),
        *(
            Step(f"{choice}-versions{name}", (*versions, choice, *options), 15)
            for choice in ("oldest", "newest")
            for name, options in (("", ()), ("-rest", ("--rest",)))
        ),
        Step("platforms", (PYTHON, "scripts/check_platforms.py"), 3),
        Step("beside", ("sh", "-c", BESIDE), 12),
        Step("other-tools", ("make", "test-other-tools"), 8),
        Step("gallery", ("sh", "-c", "make docs-clean && make docs"), 15),
        *nightly_tests(root),
        *taichi_tests(root),
        *flakes(root),
        Step("kernel-coverage", ("make", "kernel-coverage", "TESTS=full"), 90),
        *emulated(root),
    ]


def nightly_tests(root: Path) -> Iterator[Step]:
    """The tests that CI leaves to `make nightly` (tests/choice.py), by package."""
    top = root / "tests"
    packages = sorted({path.relative_to(top).parts[0] for path in top.rglob("test_*.py") if path.parent != top})
    parts = [part for package in packages for part in test_parts(root, package)]
    for name, paths in [*parts, ("others", [relative(path, root) for path in sorted(top.glob("test_*.py"))])]:
        command = ("make", "test-all", f"ARGS=--nightly {' '.join(paths)}")
        yield Step(f"nightly-tests-{name}", command, 3, may_be_empty=True)


def taichi_tests(root: Path) -> Iterator[Step]:
    """The tests that run on Taichi: those of tests/kernels in parts, and all others."""
    for name, paths in test_parts(root, "kernels"):
        yield Step(f"taichi-{name}", ("make", "test-all", f"ARGS=--taichi {' '.join(paths)}"), 6)
    yield Step("taichi-others", ("make", "test-all", "ARGS=--taichi --ignore tests/kernels"), 20)


def flakes(root: Path) -> Iterator[Step]:
    """Repeated runs of each group of tests/flakes.py, with and without busy processes."""
    for number, paths in enumerate(runpy.run_path(str(root / "tests" / "flakes.py"))["GROUPS"], 1):
        for kind, (runs, loaded_runs) in FLAKES.items():
            command = ("make", "flakes", f"RUNS={runs}", f"LOADED_RUNS={loaded_runs}", f"ARGS={' '.join(paths)}")
            yield Step(f"flakes-{number}-{kind}", command, 12)


def emulated(root: Path) -> Iterator[Step]:
    """The tests on the emulated device in each order of threads, by package."""
    for order in ORDERS:
        for name, paths in (part for package in EMULATED for part in test_parts(root, package)):
            command = ("make", "test-cuda-emulated", f"ARGS={' '.join(paths)}")
            yield Step(f"emulated-{order}-{name}", command, 4, variables={"EMULATED_CUDA_ORDER": str(order)})


def test_parts(root: Path, package: str) -> list[tuple[str, list[str]]]:
    """The test files of a package in parts of at most FILES_OF_PART, but a subpackage is in one part.

    Returns:
        The name of each part, such as pcd-2, and its folders and files.
    """
    top = root / "tests" / package
    units: dict[Path, int] = {}  # subfolders and files with their numbers of files
    for path in sorted(top.rglob("test_*.py")):
        unit = top / path.relative_to(top).parts[0]
        units[unit] = units.get(unit, 0) + 1
    total = sum(units.values())
    if total <= FILES_OF_PART:
        return [(package, [relative(top, root)])]
    target = total / math.ceil(total / FILES_OF_PART)
    parts: list[list[str]] = [[]]
    size = 0
    for unit, count in units.items():
        if size and size + count > target:
            parts.append([])
            size = 0
        parts[-1].append(relative(unit, root))
        size += count
    return [(f"{package}-{number}", paths) for number, paths in enumerate(parts, 1)]


def relative(path: Path, root: Path) -> str:
    return path.relative_to(root).as_posix()


# ------------------------------------------------------------------------------------------------ drawing


class Cycle:
    """The days of the steps: each day has the daily steps and about the same expected minutes of the others.

    Attributes:
        days: The number of days in which all steps that fit into the budget are drawn once.
    """

    def __init__(self, steps: Sequence[Step], day: datetime.date) -> None:
        self.day = day
        drawn = [step for step in steps if not step.is_daily and step.minutes <= BUDGET]
        each = max(BUDGET - sum(step.minutes for step in steps if step.is_daily), 1.0)
        self.days = max(math.ceil(sum(step.minutes for step in drawn) / each), 1)
        minutes, self._days = [0.0] * self.days, {}
        for step in sorted(drawn, key=lambda step: (-step.minutes, zlib.crc32(step.name.encode()))):
            self._days[step.name] = number = minutes.index(min(minutes))
            minutes[number] += step.minutes

    def age(self, step: Step) -> int:
        """The number of days since the latest day of a step; that of one which fits into no day: the whole cycle."""
        if step.is_daily:
            return 0
        return (self.day.toordinal() - self._days[step.name]) % self.days if step.name in self._days else self.days

    def latest(self, step: Step) -> str:
        """The latest day of a step."""
        return (self.day - datetime.timedelta(self.age(step))).isoformat()


# ------------------------------------------------------------------------------------------------ results


class Tree:
    """Contents of the files of a checkout that git tracks or would track."""

    def __init__(self, root: Path) -> None:
        self.root = root

    def refresh(self) -> None:
        """Read the files again: as a tree of git, by an index of its own, which starts as a copy of the checkout's."""
        with tempfile.TemporaryDirectory() as folder:
            index = Path(folder) / "index"
            index.write_bytes((self.root / self.git("rev-parse", "--git-path", "index").strip()).read_bytes())
            self.git("add", "--all", index=index)
            self.contents = self.git("write-tree", index=index).strip()

    def commit(self) -> str:
        """The short hash of the commit, with "+" if the tree differs from it."""
        commit = self.git("rev-parse", "--short=8", "HEAD").strip()
        return commit + ("+" if self.git("status", "--porcelain").strip() else "")

    def digest(self, step: Step) -> str:
        """A digest of all that the result of a step depends on."""
        facts = {
            "tree": self.contents,
            "command": step.command,
            "variables": step.variables,
            "python": f"{sys.version_info.major}.{sys.version_info.minor}",
            "real data": bool(os.environ.get("POINTLOOM_DATA")),
        }
        return hashlib.sha256(json.dumps(facts, sort_keys=True).encode()).hexdigest()

    def git(self, *words: str, index: Path | None = None) -> str:
        environment = os.environ | ({"GIT_INDEX_FILE": str(index)} if index else {})
        command = ["git", "-c", "advice.addEmbeddedRepo=false", *words]
        done = subprocess.run(command, cwd=self.root, env=environment, stdout=subprocess.PIPE, check=True)
        return done.stdout.decode()


@dataclass(frozen=True)
class Result:
    """The stored result of a step for one digest of its inputs, and the day whose steps were run."""

    digest: str
    day: str
    result: str
    seconds: float
    cpu_seconds: float
    commit: str
    last_line: str


class Results:
    """The newest result of each step, in one JSON file beside the logs."""

    def __init__(self, folder: Path) -> None:
        self.path, self.logs = folder / "results.json", folder / "logs"
        self.logs.mkdir(parents=True, exist_ok=True)
        try:
            stored = json.loads(self.path.read_text(encoding="utf-8")) if self.path.exists() else {}
            self.newest = {name: Result(**fields) for name, fields in stored.items()}
        except (ValueError, AttributeError, TypeError) as error:
            raise SystemExit(
                f"make nightly: {self.path}: expected the results of an earlier run, got a file that cannot be read "
                f"({error!r}). Remove it to run all steps again."
            ) from None

    def add(self, step: Step, result: Result) -> None:
        """Store a result atomically."""
        self.newest[step.name] = result
        new = self.path.with_suffix(".new")
        new.write_text(json.dumps({name: asdict(each) for name, each in self.newest.items()}, indent=1))
        new.replace(self.path)

    def log(self, step: Step) -> Path:
        return self.logs / f"{step.name}.log"

    def expected_seconds(self, step: Step) -> float:
        return self.newest[step.name].seconds if step.name in self.newest else 60 * step.minutes


# ------------------------------------------------------------------------------------------------ running


def run_command(step: Step, root: Path, log: Path, limit: float) -> int:
    """Run the command of a step with its output in `log`; returns its exit code.

    An interruption ends its processes, and so do `limit` seconds.
    """
    environment = {name: value for name, value in os.environ.items() if name not in DROPPED} | step.variables
    arrived: list[int] = []  # an exception inside of Popen would lose the process
    before = {number: signal.signal(number, lambda *words: arrived.append(words[0])) for number in STOPS}
    with log.open("wb") as output:
        try:
            process = subprocess.Popen(
                step.command,
                cwd=root,
                env=environment,
                stdin=subprocess.DEVNULL,
                stdout=output,
                stderr=subprocess.STDOUT,
                start_new_session=True,
            )
        finally:
            for number, handler in before.items():
                signal.signal(number, handler)
        try:
            if arrived:
                raise KeyboardInterrupt
            return process.wait(limit)
        except subprocess.TimeoutExpired:
            end_processes(process)
            output.write(f"\nended after {limit / 60:.0f} minutes\n".encode())
            return TIMED_OUT
        finally:
            end_processes(process)


def end_processes(process: subprocess.Popen[bytes]) -> None:
    """End the process group of a step: all of it, since a killed `make` leaves its children behind."""
    with contextlib.suppress(ProcessLookupError, PermissionError):
        os.killpg(process.pid, signal.SIGTERM)
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(STOP_SECONDS)
        os.killpg(process.pid, signal.SIGKILL)
    process.wait()


def run_step(step: Step, day: str, tree: Tree, results: Results) -> None:
    """Run a step and store its result."""
    tree.refresh()
    digest, commit, log = tree.digest(step), tree.commit(), results.log(step)
    print(f"{step.name}: {step.line()[:200]}\n    log: {log}", flush=True)
    begin, cpu = time.monotonic(), cpu_seconds()
    code = run_command(step, tree.root, log, max(STEP_LIMIT * results.expected_seconds(step), MIN_LIMIT))
    seconds, cpu = time.monotonic() - begin, cpu_seconds() - cpu
    is_empty = step.may_be_empty and NO_TESTS.search(log.read_text(encoding="utf-8", errors="replace"))
    outcome = PASSED if code == 0 or is_empty else FAILED
    result = Result(digest, day, outcome, round(seconds, 1), round(cpu, 1), commit, last_line(log, code))
    tree.refresh()
    if tree.digest(step) == digest:
        results.add(step, result)
        print(f"{step.name}: {outcome}, {seconds:.0f} s, {cpu:.0f} CPU s: {result.last_line}", flush=True)
    else:
        print(f"{step.name}: files that it depends on were changed while it ran, so it is not counted", flush=True)


def cpu_seconds() -> float:
    """CPU seconds of all processes that have ended."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def last_line(log: Path, code: int) -> str:
    """The last line of the output that is not empty or of make, without colors."""
    text = re.sub(r"\x1b\[[0-9;]*m", "", log.read_text(encoding="utf-8", errors="replace"))
    lines = [line.strip() for line in text.splitlines() if line.strip() and not re.match(r"make(\[\d+\])?: ", line)]
    return lines[-1][:160] if lines else f"no output, exit code {code}"


class Run:
    """The steps of a run, in order, and whether their newest results count."""

    def __init__(self, steps: Sequence[Step], options: argparse.Namespace, tree: Tree, results: Results) -> None:
        self.options, self.tree, self.results = options, tree, results
        self.cycle, self.day = Cycle(steps, options.seed), options.seed.isoformat()
        self.is_drawn = not (options.all or options.only)
        self.steps = [step for step in steps if step.name.startswith(tuple(options.only or [""]))]
        if self.is_drawn:
            self.steps.sort(key=self.cycle.age)
        minutes = BUDGET if options.budget is None and self.is_drawn else options.budget
        self.budget = math.inf if minutes is None else 60 * minutes

    def is_done(self, step: Step) -> bool:
        """True if the newest result is of the present inputs, or if a drawn step has passed since its day."""
        last = self.results.newest.get(step.name)
        if last is None:
            return False
        has_passed = self.is_drawn and last.result == PASSED and last.day >= self.cycle.latest(step)
        return has_passed or last.digest == self.tree.digest(step)

    def is_of_today(self, step: Step) -> bool:
        """True if the newest result of a step is of the day of a drawn run."""
        last = self.results.newest.get(step.name)
        return self.is_drawn and last is not None and last.day == self.day

    def run(self) -> None:
        """Run the steps that are not done and fit into the budget."""
        self.tree.refresh()
        is_again = self.options.again
        earlier = (
            0.0 if is_again else sum(self.results.newest[s.name].seconds for s in self.steps if self.is_of_today(s))
        )
        begin = time.monotonic() - earlier
        for step in self.steps:
            is_due = is_again or not self.is_done(step)
            if is_due and time.monotonic() - begin + self.results.expected_seconds(step) <= self.budget:
                run_step(step, self.day, self.tree, self.results)

    def report(self) -> int:
        """Print the table and the failed and remaining steps; returns the exit code."""
        self.tree.refresh()
        results = self.results
        done = [step for step in self.steps if self.is_of_today(step) or self.is_done(step)]
        missing = [step for step in self.steps if step not in done]
        if self.is_drawn:
            done = [step for step in done if self.is_of_today(step) or not self.cycle.age(step)]
            missing = [step for step in missing if not self.cycle.age(step)]
        width = max(len(step.name) for step in self.steps)
        print(f"\n{'step':<{width}}  {'result':<8} {'seconds':>9} {'CPU s':>9}  commit")
        for name, each in ((step.name, results.newest[step.name]) for step in done):
            print(f"{name:<{width}}  {each.result:<8} {each.seconds:>9.1f} {each.cpu_seconds:>9.1f}  {each.commit}")
        for step in missing:
            last = results.newest.get(step.name)
            other = f"{last.result} at {last.commit}, for other inputs" if last else ""
            print(f"{step.name:<{width}}  {NOT_RUN:<8} {'':>9} {'':>9}  {other}".rstrip())
        rows = [results.newest[step.name] for step in done]
        counts = {name: sum(each.result == name for each in rows) for name in (PASSED, FAILED)} | {
            NOT_RUN: len(missing)
        }
        times = f"{sum(each.seconds for each in rows):>9.1f} {sum(each.cpu_seconds for each in rows):>9.1f}"
        print(f"{'total':<{width}}  {'':<8} {times}  {', '.join(f'{count} {name}' for name, count in counts.items())}")
        for step in done:
            if results.newest[step.name].result == FAILED:
                print(f"failed: {step.name}: {results.newest[step.name].last_line}\n    log: {results.log(step)}")
        if missing:
            minutes = sum(map(results.expected_seconds, missing)) / 60
            print(f"remaining: {len(missing)} steps, {minutes:.0f} min expected: {', '.join(s.name for s in missing)}")
        if self.is_drawn:
            self._report_others(len(done) + len(missing))
        return 1 if counts[FAILED] or (missing and not self.is_drawn) else 0

    def _report_others(self, count: int) -> None:
        """Print how many steps are not of this day, and how many have no result within a cycle."""
        first = (self.options.seed - datetime.timedelta(self.cycle.days - 1)).isoformat()
        newest = (self.results.newest.get(step.name) for step in self.steps)
        recent = sum(last is not None and last.day >= first for last in newest)
        total, days = len(self.steps), self.cycle.days
        print(f"not drawn on {self.day}: {total - count} of {total} steps, each is among the first once in {days} days")
        print(f"without any result of the last {days} days: {total - recent} of {total} steps")

    def print_list(self) -> None:
        """Print names, days, expected minutes and commands."""
        width = max(len(step.name) for step in self.steps)
        for step in self.steps:
            day = "daily" if step.is_daily else self.cycle.latest(step)
            minutes = self.results.expected_seconds(step) / 60
            print(f"{step.name:<{width}}  {day:<10}  {minutes:5.1f} min  {step.line()}")


# ------------------------------------------------------------------------------------------------ command line


def read_options(words: Sequence[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="make nightly", description=(__doc__ or "").partition("\n")[0])
    add = parser.add_argument
    add("--seed", type=datetime.date.fromisoformat, default=datetime.date.today(), metavar="DATE", help="another day")
    add("--all", action="store_true", help="all steps, without a budget")
    add("--only", action="append", default=[], metavar="STEP", help="steps whose names begin so, without a budget")
    add("--again", action="store_true", help="run also steps that have a result")
    add("--budget", type=float, metavar="MINUTES", help="start only steps that are expected to end in this time (60)")
    add("--list", action="store_true", help="print the steps and run nothing")
    return parser.parse_args(words)


def main(words: Sequence[str] | None = None, *, root: Path = ROOT, steps: Sequence[Step] | None = None) -> int:
    """The command; returns the exit code."""
    options = read_options(words)
    steps = all_steps(options.seed, root) if steps is None else steps
    for prefix in options.only:
        if not any(step.name.startswith(prefix) for step in steps):
            families = ", ".join(sorted({step.name.partition("-")[0] for step in steps}))
            raise SystemExit(f"make nightly: --only: expected the beginning of a step ({families}), got {prefix!r}")
    folder = os.environ.get("POINTLOOM_NIGHTLY") or root / "build" / "nightly"
    run = Run(steps, options, Tree(root), Results(Path(folder).resolve()))
    if options.list:
        run.print_list()
        return 0
    before = {number: signal.signal(number, signal.default_int_handler) for number in STOPS}  # it may be ignored
    try:
        run.run()
    except KeyboardInterrupt:
        print("\nInterrupted. The result of the step that was running is not stored.", flush=True)
        run.report()
        return 128 + signal.SIGINT
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
    return run.report()


if __name__ == "__main__":
    sys.exit(main())
