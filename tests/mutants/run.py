"""Apply small changes of behavior one at a time, and report which of them the tests detect: `make mutants`.

The changes are in the .toml files of this folder, each with the tests that must detect it. They are applied to a copy
of the tree in a temporary folder, and the tests run without real data. Exit code 0 if enough were detected, 1 if not,
2 if the list or the tests themselves are wrong: then the mutants are not tried.

    make mutants ARGS="--only kernels/volumes"     those with this in their name or file
    make mutants ARGS="--from pcd.toml --part 1/3" the first third of one list
    make mutants ARGS="--list"                     the list of mutants
    make mutants ARGS="--all"                      with the tests of `make test-all`, not those of `make test`
"""

from __future__ import annotations

import argparse
import ast
import os
import queue
import shutil
import subprocess
import sys
import tempfile
import time
import tomllib
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[2]
COPIED = ("src", "docs", "tests", "benchmarks", "pyproject.toml")
MIN_NOTICED = 0.95
TIME_LIMIT = 600  # [s] of the tests of one mutant; an endless loop is noticed
PASSED, FAILED, BROKEN = 0, 1, 2  # pytest's exit codes; 2 where a test file cannot even be imported
NONE_LEFT = 5  # pytest's exit code where a choice of tests leaves out all that are named
QUICK = ("--quick",)  # the choice of `make test`, as in the Makefile


class ListError(Exception):
    """The list of mutants, or the tree that they are for, is wrong."""


class Mutant(NamedTuple):
    """A change of behavior: in `file` the text `old`, which is there once, becomes `new`; `tests` must notice it."""

    name: str
    file: str
    old: str
    new: str
    tests: list[str]


class Outcome(NamedTuple):
    """What became of a mutant: how it was noticed, "" where it was not, and the seconds that took."""

    mutant: Mutant
    noticed_by: str
    seconds: float


def read_mutants(folder: Path, lists: str = "*.toml") -> list[Mutant]:
    """The mutants of the .toml files of a folder, or of those that match `lists`.

    Raises:
        ListError: A field is missing, one too many, or a name is duplicated.
    """
    mutants: list[Mutant] = []
    for path in sorted(folder.glob(lists)):
        for fields in tomllib.loads(path.read_text(encoding="utf-8"))["mutant"]:
            name = fields.get("name", "a mutant without a name")
            if set(fields) != set(Mutant._fields):
                raise ListError(f"{path.name}: {name}: expected {', '.join(Mutant._fields)}, got {', '.join(fields)}")
            if any(name == other.name for other in mutants):
                raise ListError(f"{path.name}: {name}: a name that is taken already")
            mutants.append(Mutant(**fields))
    return mutants


def part_of(mutants: list[Mutant], part: str) -> list[Mutant]:
    """The mutants of part K of N equal parts, given as "K/N".

    Raises:
        ListError: It has another form, or K is not one of 1 to N.
    """
    number, _, count = part.partition("/")
    if not (number.isdecimal() and count.isdecimal() and 1 <= int(number) <= int(count)):
        raise ListError(f"--part: expected K/N with K from 1 to N, such as 1/3, got {part}")
    begin, end = (len(mutants) * k // int(count) for k in (int(number) - 1, int(number)))
    return mutants[begin:end]


def mutated(tree: Path, mutant: Mutant) -> str:
    """The text of the mutant's file with the change in it.

    Raises:
        ListError: The file, or the old text in it, is not there exactly once.
    """
    path = tree / mutant.file
    if not path.is_file():
        raise ListError(f"{mutant.name}: there is no file {mutant.file}; name the one that holds this code now")
    text = path.read_text(encoding="utf-8")
    if text.count(mutant.old) != 1 or mutant.old == mutant.new:
        raise ListError(
            f"{mutant.name}: {mutant.file} holds the old text {text.count(mutant.old)} times, wanted once and another "
            f"text than the new one; bring the list up to date:\n{mutant.old}"
        )
    return text.replace(mutant.old, mutant.new)


def check_list(tree: Path, mutants: Sequence[Mutant]) -> None:
    """Look for every text and every test file before anything runs.

    Raises:
        ListError: Names all that are not there.
    """
    wrong = []
    for mutant in mutants:
        try:
            ast.parse(mutated(tree, mutant))  # any test would notice a file that cannot be read
        except ListError as error:
            wrong.append(str(error))
        except SyntaxError as error:
            wrong.append(f"{mutant.name}: the new text is no Python: {error}")
        wrong += [f"{mutant.name}: there is no test {test}" for test in mutant.tests if not has_test(tree, test)]
        if not mutant.tests:
            wrong.append(f"{mutant.name}: names no tests")
    if wrong:
        raise ListError("\n".join(wrong))


def has_test(tree: Path, test: str) -> bool:
    """True if a file of tests exists and has the function that is named after `::`, if any."""
    name, _, function = test.partition("::")
    path = tree / name
    if not function or not path.is_file():
        return path.exists()
    return f"def {function.partition('[')[0].rpartition('::')[2]}(" in path.read_text(encoding="utf-8")


def copy_tree(root: Path, to: Path) -> Path:
    """A copy of what the tests need."""
    for name in COPIED:
        if (root / name).is_dir():
            shutil.copytree(root / name, to / name, ignore=shutil.ignore_patterns("__pycache__"))
        elif (root / name).exists():
            shutil.copy2(root / name, to / name)
    return to


def run_tests(tree: Path, tests: Sequence[str], choice: Sequence[str]) -> tuple[int | None, str]:
    """Pytest's exit code and last lines for some tests of a tree; None where the time limit ended them.

    Args:
        tree: The copy.
        tests: Files or single tests.
        choice: Which of these to run, as options of pytest.
    """
    environment = {name: value for name, value in os.environ.items() if not name.startswith(("PYTEST_", "POINTLOOM_"))}
    # no bytecode: a change within a second that keeps the length of a file would run as the file before it
    environment |= {"PYTHONDONTWRITEBYTECODE": "1", "PYTHONPATH": str(tree / "src")}
    command = [sys.executable, "-m", "pytest", "-x", "-q", "--no-header", *choice, *tests]
    try:
        done = subprocess.run(
            command, cwd=tree, env=environment, capture_output=True, text=True, check=False, timeout=TIME_LIMIT
        )
    except subprocess.TimeoutExpired:
        return None, ""
    return done.returncode, done.stdout[-3000:] + done.stderr[-1000:]


def check_tests(tree: Path, mutants: Sequence[Mutant], choice: Sequence[str]) -> None:
    """Run all tests that the mutants name as the tree is: a test that fails anyway notices nothing.

    Raises:
        ListError: One does not pass.
    """
    code, output = run_tests(tree, sorted({test for mutant in mutants for test in mutant.tests}), choice)
    if code not in (PASSED, NONE_LEFT):
        raise ListError(f"the tests do not pass without any mutant (pytest's exit code {code}):\n{output}")


def try_mutant(tree: Path, mutant: Mutant, choice: Sequence[str]) -> Outcome:
    """Apply a mutant to a copy, run those of its tests that are chosen, and put the file back.

    Raises:
        ListError: Its tests could not be run at all.
    """
    path, start = tree / mutant.file, time.monotonic()
    text, before = mutated(tree, mutant), path.read_bytes()
    path.write_text(text, encoding="utf-8")
    try:
        code, output = run_tests(tree, mutant.tests, choice)
    finally:
        path.write_bytes(before)
    if code is not None and code > BROKEN and code != NONE_LEFT:
        raise ListError(f"{mutant.name}: its tests could not be run (pytest's exit code {code}):\n{output}")
    failures = [line for line in output.splitlines() if line.startswith(("FAILED ", "ERROR "))]
    reason = (
        failures[0].split(" - ")[0] if failures else {None: f"no end in {TIME_LIMIT} s"}.get(code, f"exit code {code}")
    )
    return Outcome(mutant, "" if code in (PASSED, NONE_LEFT) else reason, time.monotonic() - start)


def try_all(root: Path, mutants: Sequence[Mutant], jobs: int, choice: Sequence[str] = ()) -> list[Outcome]:
    """Try all mutants, each in one of `jobs` copies of the tree, and print a line for each as it is done.

    Raises:
        ListError: The list or the tests are wrong.
    """
    check_list(root, mutants)
    outcomes: list[Outcome] = []
    with tempfile.TemporaryDirectory(prefix="pointloom-mutants-") as folder:
        copies: queue.Queue[Path] = queue.Queue()
        for number in range(jobs):
            copies.put(copy_tree(root, Path(folder, str(number))))
        tree = copies.get()
        print(f"{len(mutants)} mutants; first their tests without any", flush=True)
        check_tests(tree, mutants, choice)
        copies.put(tree)

        def work(mutant: Mutant) -> Outcome:
            tree = copies.get()
            try:
                return try_mutant(tree, mutant, choice)
            finally:
                copies.put(tree)

        with ThreadPoolExecutor(jobs) as pool:
            for outcome in pool.map(work, mutants):
                outcomes.append(outcome)
                status = outcome.noticed_by or "NOT NOTICED"
                print(f"{outcome.mutant.name:<62} {outcome.seconds:6.1f} s  {status}", flush=True)
    return outcomes


def main(words: Sequence[str] | None = None, *, root: Path = ROOT, folder: Path | None = None) -> int:
    """The command; returns its exit code."""
    parser = argparse.ArgumentParser(prog="make mutants", description=__doc__.partition("\n")[0])
    parser.add_argument("--only", default="", metavar="TEXT", help="those with this text in their name or file")
    parser.add_argument("--from", dest="lists", default="*.toml", metavar="FILE", help="those of this .toml file")
    parser.add_argument("--part", default="1/1", metavar="K/N", help="part K of N equal parts of the selection")
    parser.add_argument("--jobs", type=int, default=1, metavar="N", help="how many at once (each takes all cores)")
    parser.add_argument("--list", action="store_true", help="check the list and print it; run nothing")
    parser.add_argument("--all", action="store_true", help="also with tests that `make test` leaves out")
    options = parser.parse_args(words)
    try:
        every = read_mutants(folder or Path(__file__).parent, options.lists)
        if not every:
            raise ListError(f"--from: expected a .toml file with mutants in tests/mutants, got {options.lists}")
        mutants = part_of([m for m in every if options.only in m.name or options.only in m.file], options.part)
        if not mutants or options.jobs < 1:
            raise ListError(f"--only {options.only}: no mutant has this in its name" if not mutants else "--jobs: < 1")
        if options.list:
            check_list(root, mutants)
            print("\n".join(f"{m.file:<42} {m.name}" for m in mutants))
            return 0
        outcomes = try_all(root, mutants, options.jobs, () if options.all else QUICK)
    except ListError as error:
        print(error, file=sys.stderr)
        return 2
    noticed = sum(bool(outcome.noticed_by) for outcome in outcomes)
    fraction = noticed / len(outcomes)
    print(f"{noticed} of {len(outcomes)} noticed: {fraction:.1%}, at least {MIN_NOTICED:.0%} wanted")
    print("\n".join(f"not noticed: {o.mutant.name} ({o.mutant.file})" for o in outcomes if not o.noticed_by), end="")
    return 0 if fraction >= MIN_NOTICED else 1


if __name__ == "__main__":
    sys.exit(main())
