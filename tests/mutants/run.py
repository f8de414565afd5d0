"""Draw small changes of the product, apply each to a copy of the tree, and print those that no test notices.

    make mutants                                   60 changes of the whole product; the commit is the seed
    make mutants ARGS="--count 20 --changed"       20 changes of the modules that changed lately
    make mutants ARGS="--only src/pointloom/pcd --seed 7 --list"
    make mutants ARGS="--one src/pointloom/pcd/ground.py:120:14:comparison"

Each change is tried with the most specific tests (callers.py), then with more tests, changes of kernels then on the
emulated CUDA device. The tests that failed run once more without any change: one that fails then notices nothing. The
exit code is 0, or 1 if --at-least is given and a smaller fraction was noticed, or 2 for wrong arguments.
"""

from __future__ import annotations

import argparse
import contextlib
import gc
import os
import queue
import resource
import select
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

from .callers import CallGraph
from .changes import Change, draw, find_changes, iter_modules, option_fields
from .cpu_budget import FAILED

ROOT = Path(__file__).resolve().parents[2]
PRODUCT, KERNELS = "src/pointloom", "src/pointloom/kernels/"
NOT_COPIED = {"build", "dist", "demo"}  # and hidden files
NOT_TESTED = ("src/pointloom/_pyinstaller/", "src/pointloom/torch/")  # not by tests that run in .venv
NOT_TESTS = ("tests/browser/", "tests/other_tools/", "tests/torch/", "tests/mutants/")  # these need other programs
EMULATED = "tests/emulated_cuda/"  # its tests run on the emulated device only
ON_EMULATED = "emulated CUDA"  # name of a round
QUICK = ("--quick",)  # the choice of `make test`, as in the Makefile
SPECIFIC_FILES, SPECIFIC_TESTS, WIDER_FILES = 3, 16, 6
INTERRUPTED, NO_TESTS = 2, 5  # exit codes of pytest; 2, too, if a test file cannot be imported
IDLE_SECONDS, IDLE_CHECKS = 120, 12  # seconds without any activity from which on tests are in a deadlock
RECENT_COMMITS = 10  # that --changed compares with on the main branch itself
MIN_TRIED = 20  # changes from which on --at-least is checked


class UsageError(Exception):
    """The arguments or the tree are wrong."""


@dataclass(frozen=True)
class Round:
    """One choice of tests for all changes that were not noticed so far.

    Attributes:
        name: Printed.
        options: Of pytest.
        seconds: CPU seconds after which no further test starts.
        choose: The tests of a change; none if the round does not concern it.
    """

    name: str
    options: tuple[str, ...]
    seconds: float
    choose: Callable[[Change], list[str]]


@dataclass
class Outcome:
    """The result of a change.

    Attributes:
        change: The change.
        noticed_by: The test that failed, or another sign; "" if nothing was noticed.
        tried: The tests of each round.
        seconds: CPU seconds.
    """

    change: Change
    noticed_by: str = ""
    tried: list[str] = field(default_factory=list)
    seconds: float = 0.0


def copy_tree(root: Path, to: Path) -> Path:
    """Copy what the tests need, with the compiled bytecode."""
    to.mkdir()
    for path in root.iterdir():
        if path.name in NOT_COPIED or path.name.startswith("."):
            continue
        if path.is_dir() and not path.is_symlink():
            shutil.copytree(path, to / path.name, symlinks=True)
        else:
            shutil.copy2(path, to / path.name, follow_symlinks=False)
    return to


def run_tests(tree: Path, tests: Sequence[str], options: Sequence[str], seconds: float) -> tuple[int, str, float]:
    """The exit code, output and CPU seconds of pytest; the exit code is negative if a signal ended it."""
    environment = {name: value for name, value in os.environ.items() if not name.startswith(("PYTEST_", "POINTLOOM_"))}
    environment.pop("PYTHONDONTWRITEBYTECODE", None)
    environment.setdefault("OPENBLAS_NUM_THREADS", "1")
    environment |= {
        "PYTHONPATH": os.pathsep.join([str(tree / "src"), str(Path(__file__).parent)]),
        "MUTANT_CPU_SECONDS": str(seconds),
    }
    command = [sys.executable, "-m", "pytest", "-x", "-q", "--no-header", "-p", "cpu_budget", *options, *tests]
    hard = int(min(3 * seconds, 3600)) + 5  # CPU seconds: one test may be long, an endless loop is longer
    with tempfile.TemporaryFile("w+") as output:
        process = subprocess.Popen(
            command, cwd=tree, env=environment, stdin=subprocess.DEVNULL, stdout=output, stderr=subprocess.STDOUT,
            start_new_session=True, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (hard, hard)),
        )  # fmt: skip
        pidfd = os.pidfd_open(process.pid)
        try:
            idle, last = 0, ()
            while idle < IDLE_CHECKS and not select.select([pidfd], [], [], IDLE_SECONDS / IDLE_CHECKS)[0]:
                now = activity_of(process.pid)
                idle, last = idle + 1 if now == last else 0, now
            if idle == IDLE_CHECKS:
                os.killpg(process.pid, signal.SIGKILL)
            _, status, usage = os.wait4(process.pid, 0)
        finally:
            os.close(pidfd)
        process.returncode = os.waitstatus_to_exitcode(status)
        kill_group(process.pid)
        output.seek(0)
        return process.returncode, output.read()[-20_000:], usage.ru_utime + usage.ru_stime


def activity_of(group: int) -> tuple[object, ...]:
    """CPU time of the processes of a group. It always differs while a thread is ready to run, on a loaded machine, too.

    So a deadlock takes no CPU seconds and is recognized by equal values.
    """
    ticks = []
    for path in Path("/proc").glob("[0-9]*/task/[0-9]*/stat"):
        with contextlib.suppress(OSError):
            fields = path.read_text().rpartition(")")[2].split()
            if int(fields[2]) == group:
                ticks.append((path, fields[11:13], time.monotonic() if fields[0] in "RD" else 0.0))
    return tuple(ticks)


def kill_group(group: int) -> None:
    """End processes that a test has left."""
    with contextlib.suppress(ProcessLookupError):
        os.killpg(group, signal.SIGKILL)


def sign_of(code: int, output: str) -> str:
    """How tests noticed a change; "" if all passed."""
    is_stopped = code == INTERRUPTED and "the CPU seconds are used" in output and " failed" not in output
    if code in (0, NO_TESTS) or is_stopped:
        return ""
    if code < 0:
        return f"ended by {signal.Signals(-code).name}"
    lines = [line for line in output.splitlines() if line] or [""]
    return next((line for line in lines if line.startswith(FAILED)), f"exit code {code}: {lines[-1]}")


def try_change(tree: Path, outcome: Outcome, step: Round, tests: list[str], number: int, left: float) -> None:
    """Apply a change to the copy, run tests for at most the CPU seconds `left`, and put the file back."""
    path = tree / outcome.change.file
    source, before = path.read_bytes(), path.stat()
    path.write_bytes(outcome.change.apply(source))
    # Compiled bytecode is that of another content if time and size of the file agree: each content has its own time.
    os.utime(path, (before.st_atime, before.st_mtime + 10 * (number + 1)))
    try:
        code, output, seconds = run_tests(tree, tests, step.options, min(step.seconds, left))
    finally:
        path.write_bytes(source)
        os.utime(path, ns=(before.st_atime_ns, before.st_mtime_ns))
    outcome.seconds += seconds
    outcome.noticed_by = sign_of(code, output)
    outcome.tried.append(f"{step.name}: {' '.join(files_of(tests))}")


def files_of(tests: Sequence[str]) -> list[str]:
    return list(dict.fromkeys(test.partition("::")[0] for test in tests))


def rounds(root: Path, graph: CallGraph, options: argparse.Namespace) -> Iterator[Round]:
    """The choices of tests, from specific to wide."""
    choice = () if options.all else QUICK

    def ranked(change: Change, *, emulated: bool = False) -> list[tuple[str, list[str]]]:
        """Files of tests with their tests, the likeliest first."""
        files: dict[str, list[tuple[float, str]]] = {}
        left_out = NOT_TESTS if emulated else (*NOT_TESTS, EMULATED)
        for weight, test in graph.tests_of(change.file, change.owner, with_slow=options.all):
            if not test.file.startswith(left_out):
                files.setdefault(test.file, []).append((weight, f"{test.file}::{test.name}"))
        order = sorted(files, key=lambda file: -sum(weight for weight, _ in files[file][:5]))
        return [(file, [test for _, test in files[file]]) for file in order]

    def specific(change: Change) -> list[str]:
        named = ranked(change)[:SPECIFIC_FILES]
        # of each file in turn: the first tests of the first file, then those of the others
        shares = [tests[: SPECIFIC_TESTS // 2**rank] for rank, (_, tests) in enumerate(named, 1)]
        return [test for share in shares for test in share]

    def wider(change: Change) -> list[str]:
        return [file for file, _ in ranked(change)[:WIDER_FILES]]

    def emulated(change: Change) -> list[str]:
        is_of_device = change.operator == "option" and "device" in change.lines((root / change.file).read_bytes())[1]
        if not change.file.startswith(KERNELS) and not is_of_device:
            return []
        return [file for file, _ in ranked(change, emulated=True)[:SPECIFIC_FILES]]

    yield Round("specific", choice, options.seconds, specific)
    if not options.specific:
        yield Round("wider", choice, 3 * options.seconds, wider)
        if shutil.which("gcc"):
            yield Round(ON_EMULATED, ("--emulated-cuda-quick",), 3 * options.seconds, emulated)


def try_all(root: Path, changes: Sequence[Change], graph: CallGraph, options: argparse.Namespace) -> list[Outcome]:
    """Try all changes, in `options.jobs` copies of the tree. Changes for which no budget was left are not returned."""
    outcomes = {change: Outcome(change) for change in changes}
    with tempfile.TemporaryDirectory(prefix="pointloom-mutants-") as folder:
        copies: queue.Queue[Path] = queue.Queue()
        for number in range(options.jobs):
            copies.put(copy_tree(root, Path(folder, str(number))))

        for step in rounds(root, graph, options):

            def work(item: tuple[int, Change], step: Round = step) -> None:
                number, change = item
                outcome = outcomes[change]
                tests = [] if outcome.noticed_by else step.choose(change)
                left = options.budget - own_seconds()
                if not tests or left < 0:
                    return
                tree = copies.get()
                try:
                    try_change(tree, outcome, step, tests, number, left)
                finally:
                    copies.put(tree)
                status = outcome.noticed_by or "not noticed"
                print(f"{step.name:<13} {outcome.seconds:5.1f} CPU s  {change}  {status}", flush=True)

            with ThreadPoolExecutor(options.jobs) as pool:
                for _ in pool.map(work, enumerate(changes)):
                    pass
        tried = [outcome for outcome in outcomes.values() if outcome.tried or own_seconds() <= options.budget]
        check_tests(copies.get(), tried, options)
    return tried


def own_seconds() -> float:
    """CPU seconds of this process and those that it has started."""
    return sum(os.times()[:4])


def check_tests(tree: Path, outcomes: Sequence[Outcome], options: argparse.Namespace) -> None:
    """Run the tests that failed without any change: changes noticed by one that fails again were not noticed."""
    failed: dict[bool, dict[str, list[Outcome]]] = {False: {}, True: {}}
    for outcome in outcomes:
        if outcome.noticed_by.startswith(FAILED):
            is_emulated = outcome.tried[-1].startswith(ON_EMULATED)
            failed[is_emulated].setdefault(outcome.noticed_by.removeprefix(FAILED), []).append(outcome)
    for is_emulated, tests in failed.items():
        words = ("--emulated-cuda",) if is_emulated else () if options.all else QUICK
        while tests:
            code, output, _ = run_tests(tree, sorted(tests), words, float("inf"))
            sign = sign_of(code, output)
            if not sign:
                break
            for outcome in tests.pop(sign.removeprefix(FAILED), None) or [o for some in tests.values() for o in some]:
                outcome.noticed_by = ""
                outcome.tried.append(f"fails without any change: {sign}")
            if not sign.startswith(FAILED):
                break


# ---------------------------------------------------------------------------------------------------- command line


def git(root: Path, *words: str) -> list[str]:
    """The lines that git prints; none if it fails."""
    done = subprocess.run(["git", *words], cwd=root, capture_output=True, text=True, check=False)
    return done.stdout.split("\n")[:-1] if done.returncode == 0 else []


def base_of(root: Path, given: str) -> str:
    """The commit that --changed compares with; "" if there is none.

    Without a given one: where this branch left origin/main or main; on that branch, or without it, ten commits ago, or
    the first one of a shallow clone.

    Raises:
        UsageError: The given one does not exist.
    """
    head = git(root, "rev-parse", "HEAD")
    if given:
        found = git(root, "merge-base", given, "HEAD") or git(root, "rev-parse", "--verify", f"{given}^{{commit}}")
        if not found:
            raise UsageError(f"--changed: expected a commit, got {given}")
        return found[0]
    for branch in ("origin/main", "main"):
        base = git(root, "merge-base", branch, "HEAD")
        if base and base != head:
            return base[0]
    commits = git(root, "rev-list", "--first-parent", f"--max-count={RECENT_COMMITS + 1}", "HEAD")
    return commits[-1] if len(commits) > 1 else ""


def changed_files(root: Path, base: str) -> set[str]:
    """The files that differ from a commit, new ones included; all files of the product without a commit."""
    if not base:
        return set(iter_modules(root, PRODUCT))
    new = git(root, "ls-files", "--others", "--exclude-standard", PRODUCT)
    return {*git(root, "diff", "--name-only", base, "--", PRODUCT), *new}


def parsed(words: Sequence[str] | None) -> argparse.Namespace:
    """The options of the command line."""
    parser = argparse.ArgumentParser(prog="make mutants", description=(__doc__ or "").partition("\n")[0])
    add = parser.add_argument
    add("--count", type=int, default=60, metavar="N", help="number of changes (60)")
    add("--seed", default="", help="another seed than the present commit")
    add("--only", default=PRODUCT, metavar="PATH", help="changes of this file or folder")
    add("--changed", nargs="?", const="", metavar="COMMIT", help="changes of modules that differ from a commit; without"
        " one: from the main branch, on that branch from ten commits ago")  # fmt: skip
    add("--one", default="", metavar="CHANGE", help="this change, as file:line:column:operator")
    add("--all", action="store_true", help="also with tests that `make test` leaves out")
    add("--specific", action="store_true", help="only with the most specific tests, for a quick look")
    add("--jobs", type=int, default=1, metavar="N", help="changes at a time (1)")
    add("--seconds", type=float, default=20.0, metavar="S", help="CPU s of the first tests of a change (20), later 3 S")
    add("--budget", type=float, default=float("inf"), metavar="S", help="CPU s after which no further change is tried")
    add(
        "--at-least",
        type=float,
        default=0.0,
        metavar="F",
        help="exit code 1 if a smaller fraction of 20 or more is noticed",
    )
    add("--list", action="store_true", help="print the changes, run nothing")
    return parser.parse_args(words)


def chosen_changes(root: Path, options: argparse.Namespace) -> list[Change]:
    """The changes that the options select.

    Raises:
        UsageError: An option is wrong.
    """
    if options.count < 1 or options.jobs < 1 or options.seconds <= 0:
        raise UsageError("--count, --jobs, --seconds: expected positive numbers")
    if not (root / options.only).exists():
        raise UsageError(f"--only: expected a file or a folder of the product, got {options.only}")
    every = list(iter_modules(root, PRODUCT))
    fields = option_fields((root / file).read_bytes() for file in every)
    if options.one:
        file = options.one.partition(":")[0]
        found = [change for change in find_changes(root, {file} & {*every}, fields) if str(change) == options.one]
        if not found:
            raise UsageError(f"--one: expected a change as --list prints it, got {options.one}")
        return found
    folder = (root / options.only).relative_to(root).as_posix()
    files = {file for file in every if file == folder or file.startswith(f"{folder}/")}
    files -= {file for file in files if file.startswith(NOT_TESTED) or (not options.all and "taichi" in file)}
    if options.changed is not None:
        files &= changed_files(root, base_of(root, options.changed))
    return draw(root, find_changes(root, files, fields), options.count, options.seed)


def report(root: Path, outcomes: Sequence[Outcome]) -> float:
    """Print the changes that were not noticed and the counts. Returns the fraction that was noticed."""
    for outcome in outcomes:
        if not outcome.noticed_by:
            old, new = outcome.change.lines((root / outcome.change.file).read_bytes())
            print(f"\nNOT NOTICED {outcome.change}  in {outcome.change.owner}\n  - {old}\n  + {new}")
            print("\n".join(f"  {tried}" for tried in outcome.tried or ["no test reaches it"]))
    noticed = sum(bool(outcome.noticed_by) for outcome in outcomes)
    print(f"\n{noticed} of {len(outcomes)} changes noticed, {sum(o.seconds for o in outcomes):.0f} CPU s of tests")
    return noticed / len(outcomes) if outcomes else 1.0


def main(words: Sequence[str] | None = None, *, root: Path = ROOT) -> int:
    """The command; returns its exit code."""
    gc.disable()  # a graph of the whole product has no rubbish
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(128 + signal.SIGTERM))  # removes the copies
    options = parsed(words)
    options.seed = options.seed or (git(root, "rev-parse", "--short=12", "HEAD") or ["0"])[0]
    try:
        changes = chosen_changes(root, options)
        print(f"seed {options.seed}: {len(changes)} changes", flush=True)
        if options.list:
            for change in changes:
                old, new = change.lines((root / change.file).read_bytes())
                print(f"{change}\n  - {old}\n  + {new}")
            return 0
        if not changes:
            return 0
        graph = CallGraph(root, [*iter_modules(root, PRODUCT), *iter_modules(root, "tests")])
        outcomes = try_all(root, changes, graph, options)
    except UsageError as error:
        print(error, file=sys.stderr)
        return 2
    if len(outcomes) < len(changes):
        print(f"\n{len(changes) - len(outcomes)} changes were not tried: the CPU seconds of --budget are used")
    fraction = report(root, outcomes)
    return 1 if len(outcomes) >= MIN_TRIED and fraction < options.at_least else 0


if __name__ == "__main__":
    sys.exit(main())
