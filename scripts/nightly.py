"""Run the checks that are too slow for CI, one after another: `make nightly`. The next run continues where it ended.

    make nightly                                          all steps without a stored result, then the table
    make nightly ARGS="--budget 60"                       those that are expected to end within 60 minutes
    make nightly ARGS="--only mutants --only fuzz"        the steps whose names begin so
    make nightly ARGS="--only fuzz --again"               a step that has a result, such as a failed one
    make nightly ARGS="--list"                            names, results, expected minutes and commands

The newest result of each step is stored with the digest of its inputs: the contents of its files, uncommitted and
untracked ones included, its command, its variables, the version of Python, and whether POINTLOOM_DATA is set. A step
with a result for the present inputs is not run again. An interruption loses only the step that was running.

Results and logs are in build/nightly, or in the folder that POINTLOOM_NIGHTLY names. The exit code is 1 if a selected
step failed or was not run.
"""

from __future__ import annotations

import argparse
import contextlib
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
import tomllib
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PASSED, FAILED, NOT_RUN = "passed", "failed", "not run"
NO_TESTS = re.compile(r"^make(\[\d+\])?: \*\*\* .*\] Error 5$", re.MULTILINE)  # pytest's exit code
STOPS = (signal.SIGINT, signal.SIGTERM)
STOP_SECONDS = 10.0  # from SIGTERM to SIGKILL for the processes of an interrupted step
# Set by make for its own targets; a step is to run as on its own.
DROPPED = {"ARGS", "RUNS", "LOADED_RUNS", "TESTS", "MAKEFLAGS", "MFLAGS", "MAKEOVERRIDES", "MAKELEVEL"}

# ------------------------------------------------------------------------------------------------ table of steps

PRODUCT = ("src/",)
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
ORDERS = (0, 2)  # order 3 is that of the coverage of kernels
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


@dataclass(frozen=True)
class Step:
    """A command and what its result depends on.

    Attributes:
        name: Of the form family-part, unique.
        command: Run in the root of the checkout.
        inputs: Prefixes of the paths of files; "!" before a prefix excludes them again.
        variables: Environment variables.
        minutes: Expected time on two cores, before the first result.
        may_be_empty: It passes, too, if pytest selects no test.
    """

    name: str
    command: tuple[str, ...]
    inputs: tuple[str, ...] = ALL
    variables: dict[str, str] = field(default_factory=dict)
    minutes: float = 30.0
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
            Step(f"cuda-architectures-{number}", ("make", "check-cuda", f"ARGS={number}"), PRODUCT)
            for number in ARCHITECTURES
        ),
        Step("trust", ("make", "trust", "ARGS=--quick"), CODE, minutes=10),
        Step(
            "fuzz", (PYTHON, "benchmarks/fuzz/run.py", "--count", "3000", "--seed", "1"), (*PRODUCT, "benchmarks/fuzz/")
        ),
        *(
            Step(f"{choice}-versions{name}", (*versions, choice, *options))
            for choice in ("oldest", "newest")
            for name, options in (("", ()), ("-rest", ("--rest",)))
        ),
        Step("platforms", (PYTHON, "scripts/check_platforms.py"), ("scripts/check_platforms.py", "docs/install.md")),
        Step("beside", ("sh", "-c", BESIDE), CODE),
        Step("other-tools", ("make", "test-other-tools"), (*CODE, "docs/other-tools.md"), minutes=5),
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
    """The tests on the emulated device: all with the coverage of kernels, then in two orders of threads, by package."""
    inputs = (*CODE, "docs/")
    yield Step("kernel-coverage", ("make", "kernel-coverage", "TESTS=full"), inputs)
    for order in ORDERS:
        for name, paths in (part for package in EMULATED for part in test_parts(root, package)):
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

    def refresh(self) -> None:
        """Read the files again: as a tree of git, by an index of its own, which starts as a copy of the checkout's."""
        with tempfile.TemporaryDirectory() as folder:
            index = Path(folder) / "index"
            index.write_bytes((self.root / self.git("rev-parse", "--git-path", "index").strip()).read_bytes())
            self.git("add", "--all", index=index)
            rows = self.git("ls-tree", "-r", "-z", self.git("write-tree", index=index).strip()).split("\0")
        self.files = [(path, facts) for facts, _, path in (row.partition("\t") for row in rows if row)]

    def commit(self) -> str:
        """The short hash of the commit, with "+" if the tree differs from it."""
        commit = self.git("rev-parse", "--short=8", "HEAD").strip()
        return commit + ("+" if self.git("status", "--porcelain").strip() else "")

    def digest(self, step: Step) -> str:
        """A digest of all that the result of a step depends on."""
        prefixes = (*OF_ALL_STEPS, *step.inputs)
        wanted = [prefix for prefix in prefixes if not prefix.startswith("!")]
        excluded = [prefix[1:] for prefix in prefixes if prefix.startswith("!")]
        facts = {
            # An exclusion is overruled by a longer prefix, such as one list of an excluded folder.
            "files": [(p, content) for p, content in self.files if longest(p, wanted) > longest(p, excluded)],
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


def longest(path: str, prefixes: Sequence[str]) -> int:
    """The length of the longest prefix of a path, -1 if there is none."""
    return max((len(prefix) for prefix in prefixes if path.startswith(prefix)), default=-1)


@dataclass(frozen=True)
class Result:
    """The stored result of a step for one digest of its inputs."""

    digest: str
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

    def of(self, step: Step, digest: str) -> Result | None:
        """The result of a step for these inputs."""
        result = self.newest.get(step.name)
        return result if result and result.digest == digest else None

    def log(self, step: Step) -> Path:
        return self.logs / f"{step.name}.log"

    def expected_seconds(self, step: Step) -> float:
        return self.newest[step.name].seconds if step.name in self.newest else 60 * step.minutes


# ------------------------------------------------------------------------------------------------ running


def run_command(step: Step, root: Path, log: Path) -> int:
    """Run the command of a step with its output in `log`; returns its exit code. An interruption ends its processes."""
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
            return process.wait()
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


def run_step(step: Step, tree: Tree, results: Results) -> None:
    """Run a step and store its result."""
    digest, commit, log = tree.digest(step), tree.commit(), results.log(step)
    print(f"{step.name}: {step.line()[:200]}\n    log: {log}", flush=True)
    begin, cpu = time.monotonic(), cpu_seconds()
    code = run_command(step, tree.root, log)
    seconds, cpu = time.monotonic() - begin, cpu_seconds() - cpu
    is_empty = step.may_be_empty and NO_TESTS.search(log.read_text(encoding="utf-8", errors="replace"))
    outcome = PASSED if code == 0 or is_empty else FAILED
    result = Result(digest, outcome, round(seconds, 1), round(cpu, 1), commit, last_line(log, code))
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


def run_steps(chosen: Sequence[Step], options: argparse.Namespace, tree: Tree, results: Results) -> None:
    """Run the chosen steps that have no result and fit into the budget."""
    begin = time.monotonic()
    for step in chosen:
        tree.refresh()
        if results.of(step, tree.digest(step)) and not options.again:
            continue
        spent = time.monotonic() - begin
        if options.budget is None or spent + results.expected_seconds(step) <= 60 * options.budget:
            run_step(step, tree, results)


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
            last = results.newest.get(step.name)
            other = f"{last.result} at {last.commit}, for other inputs" if last else ""
            print(f"{step.name:<{width}}  {NOT_RUN:<8} {'':>9}  {other}".rstrip())
            continue
        counts[result.result] += 1
        seconds, cpu = seconds + result.seconds, cpu + result.cpu_seconds
        print(f"{step.name:<{width}}  {result.result:<8} {result.seconds:>9.1f}  {result.commit}")
        if result.result == FAILED:
            notes.append(f"failed: {step.name}: {result.last_line}\n    log: {results.log(step)}")
    total = ", ".join(f"{count} {name}" for name, count in counts.items())
    print(f"{'total':<{width}}  {'':<8} {seconds:>9.1f}  {total}; {cpu:.0f} CPU s")
    if notes:
        print("\n".join(notes))
    if remaining:
        minutes = sum(results.expected_seconds(step) for step in remaining) / 60
        print(f"remaining: {len(remaining)} steps, {minutes:.0f} min expected: {', '.join(s.name for s in remaining)}")
    return 1 if counts[FAILED] or counts[NOT_RUN] else 0


def print_list(chosen: Sequence[Step], results: Results) -> None:
    """Print names, expected minutes and commands."""
    width = max(len(step.name) for step in chosen)
    for step in chosen:
        print(f"{step.name:<{width}}  {results.expected_seconds(step) / 60:5.1f} min  {step.line()}")


def read_options(words: Sequence[str] | None, steps: Sequence[Step]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="make nightly", description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--only", action="append", default=[], metavar="STEP", help="steps whose names begin so")
    parser.add_argument("--again", action="store_true", help="run also steps that have a result")
    parser.add_argument(
        "--budget", type=float, metavar="MINUTES", help="start only steps that are expected to end within this time"
    )
    parser.add_argument("--list", action="store_true", help="print the steps and run nothing")
    options = parser.parse_args(words)
    for prefix in options.only:
        if not any(step.name.startswith(prefix) for step in steps):
            families = sorted({step.name.partition("-")[0] for step in steps})
            parser.error(f"expected the beginning of a step's name, got {prefix!r}. Steps: {', '.join(families)}")
    return options


def main(words: Sequence[str] | None = None, *, root: Path = ROOT, steps: Sequence[Step] | None = None) -> int:
    """The command; returns the exit code."""
    steps = all_steps(root) if steps is None else steps
    options = read_options(words, steps)
    chosen = [step for step in steps if step.name.startswith(tuple(options.only or [""]))]
    folder = os.environ.get("POINTLOOM_NIGHTLY") or root / "build" / "nightly"
    tree, results = Tree(root), Results(Path(folder).resolve())
    if options.list:
        print_list(chosen, results)
        return 0
    before = {number: signal.signal(number, signal.default_int_handler) for number in STOPS}  # it may be ignored
    try:
        run_steps(chosen, options, tree, results)
    except KeyboardInterrupt:
        print("\nInterrupted. The result of the step that was running is not stored.", flush=True)
        report(chosen, tree, results)
        return 128 + signal.SIGINT
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
    return report(chosen, tree, results)


if __name__ == "__main__":
    sys.exit(main())
