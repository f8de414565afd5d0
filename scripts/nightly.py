"""Run the checks that are too slow for CI, one after another: `make nightly`. The next run continues where it ended.

    make nightly                                          all steps without a stored result, then the table
    make nightly ARGS="--budget 60"                       those that are expected to end within 60 minutes
    make nightly ARGS="--only mutants --only fuzz"        the steps whose names begin so
    make nightly ARGS="--failed"                          failed steps, too
    make nightly ARGS="--only fuzz --again fuzz"          a step that has a result
    make nightly ARGS="--list"                            names, results, expected minutes and commands

The result of a step is stored by its name and the digest of its inputs: the contents of its files, uncommitted and
untracked ones included, its command, its variables, the version of Python, and whether POINTLOOM_DATA is set. A step
with a result for the present inputs is not run again. An interruption loses only the step that was running.

Results and logs are in build/nightly. POINTLOOM_NIGHTLY names another folder, which several checkouts of one machine
may share. The exit code is 1 if a selected step failed or was not run.
"""

from __future__ import annotations

import argparse
import contextlib
import fcntl
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
import time
import tomllib
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass, field
from datetime import UTC, datetime, timedelta
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PASSED, FAILED, NOT_RUN = "passed", "failed", "not run"
CHANGED = "inputs changed"  # while the step was running: the result is of no known inputs
RESULTS_OF_STEP = 8  # of other inputs, the newest ones; they give the expected time
NO_TESTS = re.compile(r"^make(\[\d+\])?: \*\*\* .*\] Error 5$", re.MULTILINE)  # pytest's exit code
DAYS_OF_INDEX = 14  # results that depend on a package index are repeated after this time
STOP_SECONDS = 10.0  # from SIGTERM to SIGKILL for the processes of an interrupted step
# Set by make for its own targets; a step is to run as on its own.
DROPPED = {"ARGS", "RUNS", "LOADED_RUNS", "TESTS", "MAKEFLAGS", "MFLAGS", "MAKEOVERRIDES", "MAKELEVEL"}

# ------------------------------------------------------------------------------------------------ table of steps

PRODUCT = ("kernels/", "pcd/", "registration/", "meshing/", "src/")
TESTS = ("tests/", "!tests/mutants/", "!tests/test_nightly.py")
CODE = (*PRODUCT, *TESTS, "benchmarks/")  # what tests of a package read
ALL = ("", "!scripts/nightly.py", "!tests/test_nightly.py")
OF_ALL_STEPS = ("constraints/", "pyproject.toml", "Makefile")

FILES_OF_PART = 20  # test files of one step
MUTANTS_OF_PART = 40
EMULATED = (
    "kernels", "core", "cameras", "pcd", "io", "registration", "meshing", "rgbd", "visualization", "photogrammetry",
    "tiling", "datasets", "cli", "open3d", "emulated_cuda",
)  # fmt: skip
ARCHITECTURES = (75, 90, 120)
ORDERS = (0, 2, 3)  # the first one with marks for the coverage of kernels
FLAKES = {"quiet": ((5, 0), 4), "loaded": ((0, 2), 5)}  # kind -> runs and loaded runs of a part, number of parts

PYTHON = ".venv/bin/python"
# With other libraries: the newest versions that pip finds (its settings choose the index), in their own environment.
OTHERS = "torch jax numba open3d pyinstaller pytest pytest-xdist hypothesis"
TESTS_BESIDE = " ".join(
    f"tests/core/test_{name}.py" for name in ("array_libraries", "other_array_libraries", "standard_streams")
)
BESIDE = f"""set -e
{PYTHON} -m venv build/beside
build/beside/bin/python -m pip install --quiet --upgrade --editable . {OTHERS}
build/beside/bin/python -m pip list
build/beside/bin/python -m pytest -n 0 {TESTS_BESIDE}"""
UNMARKED = "tests/emulated_cuda/test_compiled_ahead.py"  # loads kernels without marks
# Marks of one part, in a folder of the present inputs.
MARKED = """mkdir -p "$(dirname "$EMULATED_CUDA_COVERAGE")" && rm -f "$EMULATED_CUDA_COVERAGE" && exec make \
test-cuda-emulated ARGS="--ignore {unmarked} {tests}" """
MERGE = """import pathlib, subprocess, sys
files = [path.read_bytes() for path in sorted(pathlib.Path(sys.argv[1]).iterdir())]
out = pathlib.Path("build/kernel-coverage/marks")
out.parent.mkdir(parents=True, exist_ok=True)
out.write_bytes(bytes(map(max, *files, bytes(len(files[0])))))
missed = ["--missed", str(out.with_name("missed.txt"))]
sys.exit(subprocess.call([sys.executable, "-m", "emulated_cuda.kernel_coverage", str(out), *missed]))"""


@dataclass(frozen=True)
class Step:
    """A command and what its result depends on.

    Attributes:
        name: Of the form family-part, unique.
        command: Run in the root of the checkout. `{marks}` becomes a folder for the present inputs.
        inputs: Prefixes of the paths of files; "!" before a prefix excludes them again.
        variables: Environment variables, with `{marks}` as in the command.
        minutes: Expected time on two cores, before the first result.
        max_days: A result that is older is not used; None for no limit.
        after: Run only if all steps whose names begin so have passed.
        may_be_empty: It passes, too, if pytest selects no test.
    """

    name: str
    command: tuple[str, ...]
    inputs: tuple[str, ...] = ALL
    variables: dict[str, str] = field(default_factory=dict)
    minutes: float = 30.0
    max_days: int | None = None
    after: str = ""
    may_be_empty: bool = False

    def line(self) -> str:
        """The command as a line for the shell."""
        words = [word if re.fullmatch(r"[\w./=-]+", word) else repr(word) for word in self.command]
        return " ".join([*(f"{name}={value}" for name, value in self.variables.items()), *words])


def all_steps(root: Path = ROOT) -> list[Step]:
    """The steps of `make nightly`, the ones that take longest at the end."""
    versions = (PYTHON, "scripts/test_versions.py")
    return [
        Step("gpu-kit", ("make", "gpu-run", "ARGS=--dry"), CODE),
        *(
            Step(f"cuda-architectures-{number}", ("make", "check-cuda", f"ARGS={number}"), ("kernels/", "src/"))
            for number in ARCHITECTURES
        ),
        Step("trust", ("make", "trust", "ARGS=--quick"), CODE, minutes=10),
        Step(
            "fuzz", (PYTHON, "benchmarks/fuzz/run.py", "--count", "3000", "--seed", "1"), (*PRODUCT, "benchmarks/fuzz/")
        ),
        *(
            Step(f"{choice}-versions{name}", (*versions, choice, *options), max_days=DAYS_OF_INDEX)
            for choice in ("oldest", "newest")
            for name, options in (("", ()), ("-rest", ("--rest",)))
        ),
        Step(
            "platforms",
            (PYTHON, "scripts/check_platforms.py"),
            ("scripts/check_platforms.py", "docs/install.md"),
            max_days=DAYS_OF_INDEX,
        ),
        Step("beside", ("sh", "-c", BESIDE), CODE, max_days=DAYS_OF_INDEX),
        Step("gallery", ("sh", "-c", "make docs-clean && make docs")),
        *nightly_tests(root),
        *taichi_tests(root),
        *flakes(root),
        *mutants(root),
        *emulated(root),
    ]


def nightly_tests(root: Path) -> Iterator[Step]:
    """The tests that CI leaves to `make nightly` (tests/choice.py), by package."""
    top = root / "tests"
    packages = sorted({path.relative_to(top).parts[0] for path in top.rglob("test_*.py") if path.parent != top})
    parts = [part for package in packages for part in test_parts(root, package)]
    for name, paths in [*parts, ("others", [relative(path, root) for path in sorted(top.glob("test_*.py"))])]:
        command = ("make", "test-all", f"ARGS=--nightly {' '.join(paths)}")
        yield Step(f"nightly-tests-{name}", command, may_be_empty=True)


def taichi_tests(root: Path) -> Iterator[Step]:
    """The tests that run on Taichi: those of tests/kernels in parts, and all others."""
    for name, paths in test_parts(root, "kernels"):
        yield Step(f"taichi-{name}", ("make", "test-all", f"ARGS=--taichi {' '.join(paths)}"), CODE)
    yield Step("taichi-others", ("make", "test-all", "ARGS=--taichi --ignore tests/kernels"))


def flakes(root: Path) -> Iterator[Step]:
    """Repeated runs of tests/flakes.py, in parts: each group of its tests, with and without busy processes."""
    for number, paths in enumerate(runpy.run_path(str(root / "tests" / "flakes.py"))["GROUPS"], 1):
        for kind, ((runs, loaded_runs), parts) in FLAKES.items():
            command = ("make", "flakes", f"RUNS={runs}", f"LOADED_RUNS={loaded_runs}", f"ARGS={' '.join(paths)}")
            for part in range(1, parts + 1):
                yield Step(f"flakes-{number}-{kind}-{part}", command)


def mutants(root: Path) -> Iterator[Step]:
    """The lists of mutants, long ones in parts."""
    for path in sorted((root / "tests" / "mutants").glob("*.toml")):
        count = len(tomllib.loads(path.read_text(encoding="utf-8"))["mutant"])
        parts = math.ceil(count / MUTANTS_OF_PART)
        for part in range(1, parts + 1):
            command = ("make", "mutants", f"ARGS=--all --from {path.name} --part {part}/{parts}")
            name = f"mutants-{path.stem}" + (f"-{part}" if parts > 1 else "")
            inputs = (*CODE, "docs/", "tests/mutants/run.py", f"tests/mutants/{path.name}")
            yield Step(name, command, inputs)


def emulated(root: Path) -> Iterator[Step]:
    """The tests on the emulated device in three orders, by package, and the coverage of kernels in the first order."""
    first, *others = ORDERS
    chunks = [part for package in EMULATED for part in test_parts(root, package)]
    inputs = (*CODE, "docs/")
    for name, paths in chunks:
        variables = {"EMULATED_CUDA_ORDER": str(first), "EMULATED_CUDA_COVERAGE": f"{{marks}}/{name}"}
        marked = " ".join(path for path in paths if path != UNMARKED)  # pytest ignores no file that is named
        command = ("sh", "-c", MARKED.format(unmarked=UNMARKED, tests=marked).strip())
        yield Step(f"emulated-{first}-{name}", command, inputs, variables)
    merge = (PYTHON, "-c", MERGE, "{marks}")
    coverage = {"PYTHONPATH": "tests"}
    yield Step("kernel-coverage", merge, inputs, coverage, minutes=1, after=f"emulated-{first}-")
    for order in others:
        for name, paths in chunks:
            command = ("make", "test-cuda-emulated", f"ARGS={' '.join(paths)}")
            yield Step(f"emulated-{order}-{name}", command, inputs, {"EMULATED_CUDA_ORDER": str(order)})


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


# ------------------------------------------------------------------------------------------------ inputs and results


class Tree:
    """Contents of the files of a checkout that git tracks or would track."""

    def __init__(self, root: Path) -> None:
        self.root = root
        self.known: dict[tuple[str, int, int], str] = {}  # path, size and time -> digest of the contents
        self.refresh()

    def refresh(self) -> None:
        """List the files again."""
        listed = git(self.root, "ls-files", "--cached", "--others", "--exclude-standard", "-z")
        self.paths = sorted({name for name in listed.split("\0") if name})
        self.of_inputs: dict[tuple[str, ...], str] = {}

    def commit(self) -> str:
        """The short hash of the commit, with "+" if the tree differs from it."""
        commit = git(self.root, "rev-parse", "--short=8", "HEAD").strip()
        return commit + ("+" if git(self.root, "status", "--porcelain").strip() else "")

    def digest_of_inputs(self, step: Step) -> str:
        """A digest of the contents of the step's files."""
        prefixes = (*OF_ALL_STEPS, *step.inputs)
        if prefixes not in self.of_inputs:
            wanted = tuple(prefix for prefix in prefixes if not prefix.startswith("!"))
            excluded = tuple(prefix[1:] for prefix in prefixes if prefix.startswith("!"))
            # An exclusion is overruled by a longer prefix, such as one list of an excluded folder.
            chosen = [p for p in self.paths if longest(p, wanted) > longest(p, excluded)]
            lines = [f"{path} {content}" for path in chosen if (content := self._content(path))]
            self.of_inputs[prefixes] = hashlib.sha256("\n".join(lines).encode()).hexdigest()
        return self.of_inputs[prefixes]

    def digest(self, step: Step) -> str:
        """A digest of all that the result of a step depends on."""
        facts = {
            "files": self.digest_of_inputs(step),
            "command": step.command,
            "variables": step.variables,
            "python": f"{sys.version_info.major}.{sys.version_info.minor}",
            "real data": bool(os.environ.get("POINTLOOM_DATA")),
        }
        return hashlib.sha256(json.dumps(facts, sort_keys=True).encode()).hexdigest()

    def _content(self, name: str) -> str:
        """The digest of a file or the target of a link; empty for a removed file or a nested repository."""
        path = self.root / name
        if path.is_symlink():
            return f"-> {path.readlink()}"
        try:
            status = path.stat()
        except FileNotFoundError:
            return ""
        if not path.is_file():
            return ""
        key = (name, status.st_size, status.st_mtime_ns)
        if key not in self.known:
            self.known[key] = hashlib.sha256(path.read_bytes()).hexdigest()
        return self.known[key]


def longest(path: str, prefixes: Sequence[str]) -> int:
    """The length of the longest prefix of a path, -1 if there is none."""
    return max((len(prefix) for prefix in prefixes if path.startswith(prefix)), default=-1)


def git(root: Path, *words: str) -> str:
    return subprocess.run(["git", *words], cwd=root, stdout=subprocess.PIPE, check=True).stdout.decode()


@dataclass(frozen=True)
class Result:
    """The stored result of a step for one digest of its inputs."""

    step: str
    digest: str
    result: str
    seconds: float
    cpu_seconds: float
    commit: str
    date: str
    last_line: str
    log: str


class Results:
    """The results of all steps in one JSON file, which several checkouts may share."""

    def __init__(self, folder: Path) -> None:
        self.folder, self.path = folder, folder / "results.json"
        (folder / "logs").mkdir(parents=True, exist_ok=True)

    def read(self) -> list[Result]:
        """All results, the newest of a step last."""
        if not self.path.exists():
            return []
        try:
            return [Result(**fields) for fields in json.loads(self.path.read_text(encoding="utf-8"))["results"]]
        except (ValueError, KeyError, TypeError) as error:
            raise SystemExit(
                f"make nightly: {self.path}: expected the results of an earlier run, got a file that cannot be read "
                f"({error!r}). Remove it to run all steps again."
            ) from None

    def add(self, result: Result) -> None:
        """Store a result atomically, together with those that other checkouts have added."""
        with (self.folder / "lock").open("w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            others = [r for r in self.read() if (r.step, r.digest) != (result.step, result.digest)]
            of_step = [r for r in others if r.step == result.step][1 - RESULTS_OF_STEP :]
            kept = [*(r for r in others if r.step != result.step or r in of_step), result]
            new = self.path.with_suffix(".new")
            with new.open("w", encoding="utf-8") as file:
                json.dump({"results": [asdict(r) for r in kept]}, file, indent=1)
                file.flush()
                os.fsync(file.fileno())
            new.replace(self.path)
        for old in set(others) - set(kept):
            Path(old.log).unlink(missing_ok=True)

    def of(self, step: Step, digest: str) -> Result | None:
        """The result of a step for these inputs, if there is one that may still be used."""
        for result in self.read():
            if (result.step, result.digest) != (step.name, digest) or result.result == CHANGED:
                continue
            age = datetime.now(UTC) - datetime.fromisoformat(result.date)
            if step.max_days is None or age < timedelta(days=step.max_days):
                return result
        return None

    def last(self, name: str) -> Result | None:
        """The newest result of a step for any inputs; a passed one if there is one, which ran to its end."""
        results = [r for r in self.read() if r.step == name]
        return ([r for r in results if r.result == PASSED] or results or [None])[-1]

    def expected_seconds(self, step: Step) -> float:
        last = self.last(step.name)
        return last.seconds if last else 60 * step.minutes


# ------------------------------------------------------------------------------------------------ running


class Interruption:
    """SIGINT and SIGTERM raise KeyboardInterrupt, but only while a step is waited for.

    While its processes are started, the signal is only recorded, since an exception would lose them.
    """

    def __init__(self) -> None:
        self.is_requested = self.is_waiting = False

    @contextlib.contextmanager
    def handled(self) -> Iterator[None]:
        """Handle both signals in this block."""
        before = {number: signal.signal(number, self._handle) for number in (signal.SIGINT, signal.SIGTERM)}
        try:
            yield
        finally:
            for number, handler in before.items():
                signal.signal(number, handler)

    def _handle(self, *_: object) -> None:
        self.is_requested = True
        if self.is_waiting:
            raise KeyboardInterrupt

    def check(self) -> None:
        """Raise KeyboardInterrupt if a signal has come."""
        if self.is_requested:
            raise KeyboardInterrupt

    def wait(self, process: subprocess.Popen[bytes]) -> int:
        """Wait for a process. Returns its exit code, or raises KeyboardInterrupt if a signal comes first."""
        try:
            self.is_waiting = True
            self.check()
            return process.wait()
        finally:
            self.is_waiting = False


def run_command(step: Step, root: Path, marks: Path, log: Path, interruption: Interruption) -> int:
    """Run the command of a step with its output in `log`; returns its exit code. An interruption ends its processes."""
    command = [word.replace("{marks}", str(marks)) for word in step.command]
    variables = {name: value.replace("{marks}", str(marks)) for name, value in step.variables.items()}
    environment = {name: value for name, value in os.environ.items() if name not in DROPPED} | variables
    with log.open("wb") as output:
        process = subprocess.Popen(
            command,
            cwd=root,
            env=environment,
            stdin=subprocess.DEVNULL,
            stdout=output,
            stderr=subprocess.STDOUT,
            start_new_session=True,
        )
        try:
            return interruption.wait(process)
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


def run_step(step: Step, tree: Tree, results: Results, interruption: Interruption) -> None:
    """Run a step and store its result."""
    digest, commit = tree.digest(step), tree.commit()
    marks = results.folder / "marks" / tree.digest_of_inputs(step)[:16]
    running = results.folder / "logs" / f"{step.name}.running.log"
    print(f"{step.name}: {step.line()[:200]}\n    log: {running}", flush=True)
    begin, cpu = time.monotonic(), cpu_seconds()
    code = run_command(step, tree.root, marks, running, interruption)
    seconds, cpu = time.monotonic() - begin, cpu_seconds() - cpu
    tree.refresh()
    is_empty = step.may_be_empty and NO_TESTS.search(running.read_text(encoding="utf-8", errors="replace"))
    outcome = PASSED if code == 0 or is_empty else FAILED
    if tree.digest(step) != digest:
        outcome = CHANGED
        print(f"{step.name}: files that it depends on were changed while it ran, so it is not counted", flush=True)
    log = running.with_name(f"{step.name}-{digest[:12]}.log")
    running.replace(log)
    date = datetime.now(UTC).isoformat(timespec="seconds")
    result = Result(
        step.name, digest, outcome, round(seconds, 1), round(cpu, 1), commit, date, last_line(log, code), str(log)
    )
    results.add(result)
    print(f"{step.name}: {outcome}, {seconds:.0f} s, {cpu:.0f} CPU s: {result.last_line}", flush=True)


def cpu_seconds() -> float:
    """CPU seconds of all processes that have ended."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def last_line(log: Path, code: int) -> str:
    """The last line of the output that is not empty or of make, without colors."""
    text = re.sub(r"\x1b\[[0-9;]*m", "", log.read_text(encoding="utf-8", errors="replace"))
    lines = [line.strip() for line in text.splitlines() if line.strip() and not re.match(r"make(\[\d+\])?: ", line)]
    return lines[-1][:160] if lines else f"no output, exit code {code}"


@dataclass
class Options:
    """The options of the command line."""

    only: list[str]
    again: list[str]
    failed: bool
    budget: float | None
    list: bool


def is_due(step: Step, result: Result | None, options: Options) -> bool:
    """True if a step is to be run."""
    return result is None or begins(step, options.again) or (options.failed and result.result == FAILED)


def begins(step: Step, prefixes: Sequence[str]) -> bool:
    return step.name.startswith(tuple(prefixes))


def run_steps(chosen: Sequence[Step], steps: Sequence[Step], options: Options, tree: Tree, results: Results) -> None:
    """Run the chosen steps that are due and fit into the budget. Raises KeyboardInterrupt after SIGINT or SIGTERM."""
    begin, interruption = time.monotonic(), Interruption()
    with interruption.handled():
        for step in chosen:
            interruption.check()
            tree.refresh()
            if not is_due(step, results.of(step, tree.digest(step)), options):
                continue
            spent = time.monotonic() - begin
            if options.budget is not None and spent + results.expected_seconds(step) > 60 * options.budget:
                continue
            if step.after and not all(passed(other, tree, results) for other in steps if begins(other, [step.after])):
                print(f"{step.name}: not run: it needs all steps {step.after}* to have passed", flush=True)
                continue
            run_step(step, tree, results, interruption)


def passed(step: Step, tree: Tree, results: Results) -> bool:
    result = results.of(step, tree.digest(step))
    return result is not None and result.result == PASSED


# ------------------------------------------------------------------------------------------------ output


def report(chosen: Sequence[Step], tree: Tree, results: Results) -> int:
    """Print the table, the failed steps and what remains; returns the exit code."""
    tree.refresh()
    width = max(len(step.name) for step in chosen)
    print(f"\n{'step':<{width}}  {'result':<8} {'seconds':>9}  commit")
    counts = {PASSED: 0, FAILED: 0, NOT_RUN: 0}
    notes, remaining, seconds, cpu = [], [], 0.0, 0.0
    for step in chosen:
        result = results.of(step, tree.digest(step))
        if result is None:
            counts[NOT_RUN] += 1
            remaining.append(step)
            last = results.last(step.name)
            other = f"{last.result} at {last.commit}, for other inputs" if last else ""
            print(f"{step.name:<{width}}  {NOT_RUN:<8} {'':>9}  {other}".rstrip())
            continue
        counts[result.result] += 1
        seconds, cpu = seconds + result.seconds, cpu + result.cpu_seconds
        print(f"{step.name:<{width}}  {result.result:<8} {result.seconds:>9.1f}  {result.commit}")
        if result.result == FAILED:
            notes.append(f"failed: {step.name}: {result.last_line}\n    log: {result.log}")
    total = ", ".join(f"{count} {name}" for name, count in counts.items())
    print(f"{'total':<{width}}  {'':<8} {seconds:>9.1f}  {total}; {cpu:.0f} CPU s")
    if notes:
        print("\n".join(notes))
    if remaining:
        minutes = sum(results.expected_seconds(step) for step in remaining) / 60
        print(f"remaining: {len(remaining)} steps, {minutes:.0f} min expected: {', '.join(s.name for s in remaining)}")
    return 1 if counts[FAILED] or counts[NOT_RUN] else 0


def print_list(chosen: Sequence[Step], tree: Tree, results: Results) -> None:
    """Print names, results, expected minutes and commands."""
    width = max(len(step.name) for step in chosen)
    for step in chosen:
        result = results.of(step, tree.digest(step))
        minutes = results.expected_seconds(step) / 60
        print(f"{step.name:<{width}}  {result.result if result else NOT_RUN:<8} {minutes:5.1f} min  {step.line()}")


def read_options(words: Sequence[str] | None, steps: Sequence[Step]) -> Options:
    parser = argparse.ArgumentParser(prog="make nightly", description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--only", action="append", default=[], metavar="STEP", help="steps whose names begin so")
    parser.add_argument(
        "--again", action="append", default=[], metavar="STEP", help="run these even if they have a result"
    )
    parser.add_argument("--failed", action="store_true", help="run failed steps again")
    parser.add_argument(
        "--budget", type=float, metavar="MINUTES", help="start only steps that are expected to end within this time"
    )
    parser.add_argument("--list", action="store_true", help="print the steps and run nothing")
    options = Options(**vars(parser.parse_args(words)))
    for prefix in (*options.only, *options.again):
        if not any(begins(step, [prefix]) for step in steps):
            families = sorted({step.name.partition("-")[0] for step in steps})
            parser.error(f"expected the beginning of a step's name, got {prefix!r}. Steps: {', '.join(families)}")
    return options


def main(words: Sequence[str] | None = None, *, root: Path = ROOT, steps: Sequence[Step] | None = None) -> int:
    """The command; returns the exit code."""
    steps = all_steps(root) if steps is None else steps
    options = read_options(words, steps)
    chosen = [step for step in steps if not options.only or begins(step, options.only)]
    folder = os.environ.get("POINTLOOM_NIGHTLY") or root / "build" / "nightly"
    tree, results = Tree(root), Results(Path(folder).resolve())
    if options.list:
        print_list(chosen, tree, results)
        return 0
    try:
        run_steps(chosen, steps, options, tree, results)
    except KeyboardInterrupt:
        print("\nInterrupted. The result of the step that was running is not stored.", flush=True)
        report(chosen, tree, results)
        return 128 + signal.SIGINT
    return report(chosen, tree, results)


if __name__ == "__main__":
    sys.exit(main())
