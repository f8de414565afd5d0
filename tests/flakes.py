"""Run the tests of pages, threads and processes many times and list every test whose outcome differed.

    python tests/flakes.py --runs 20 --loaded-runs 10 [--keep FOLDER] [paths and options of pytest]

Eight busy processes run during loaded runs. A retry counts as a difference (tests/browser retries a failed test
once). The exit code is 1 if an outcome differed or a test failed.
"""

from __future__ import annotations

import argparse
import contextlib
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as ElementTree
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
BUSY_PROCESSES = 8
# One process each: Chromium's tests run alone in CI as well.
GROUPS = (
    ("tests/browser",),
    ("tests/visualization/viewer",),
    ("tests/tiling",),
    (
        *("tests/kernels/language/test_cpu_pool.py", "tests/kernels/language/test_device_lock.py"),
        *("tests/kernels/language/test_kernel_cache.py", "tests/kernels/language/test_module_loading.py"),
        "tests/photogrammetry/sfm/test_limits.py",
        *("tests/io/test_rgbd_sources.py", "tests/rgbd/test_frame_calls.py", "tests/cli/test_cli.py"),
        *("tests/cli/test_file_commands.py", "tests/cli/test_tile_command.py", "tests/cli/test_view_command.py"),
    ),
)


@dataclass
class Outcomes:
    """Outcomes of several runs.

    Attributes:
        runs: Number of runs that were read.
        tests: Outcome of each test in each run: "passed", "failed", "error", "skipped", "retried", "absent".
        messages: Messages of failures and retries, by test.
        skipped: Number of skipped tests of the last run, by reason.
    """

    runs: int = 0
    tests: dict[str, list[str]] = field(default_factory=dict)
    messages: dict[str, list[str]] = field(default_factory=dict)
    skipped: Counter[str] = field(default_factory=Counter)

    def add(self, *reports: str) -> Counter[str]:
        """Add the JUnit reports of a run. Returns its number of tests by outcome."""
        by_name: dict[str, str] = {}
        self.skipped = Counter()
        for case in (case for report in reports for case in ElementTree.fromstring(report).iter("testcase")):
            name = f"{case.get('classname')}::{case.get('name')}"
            outcome, message = _outcome_of(case)
            if outcome == "skipped":
                self.skipped[message] += 1
            elif message:
                self.messages.setdefault(name, []).append(message)
            by_name[name] = outcome if by_name.get(name, "passed") == "passed" else by_name[name]
        for name in by_name.keys() - self.tests.keys():
            self.tests[name] = ["absent"] * self.runs
        for name, outcomes in self.tests.items():
            outcomes.append(by_name.get(name, "absent"))
        self.runs += 1
        return Counter(by_name.values())

    def differing(self) -> dict[str, Counter[str]]:
        """Outcomes of the tests that had more than one, were retried or failed."""
        counted = {name: Counter(outcomes) for name, outcomes in sorted(self.tests.items())}
        return {name: count for name, count in counted.items() if len(count) > 1 or not count.keys() <= PEACEFUL}


PEACEFUL = {"passed", "skipped"}


def _outcome_of(case: ElementTree.Element) -> tuple[str, str]:
    for kind, outcome in (("error", "error"), ("failure", "failed"), ("skipped", "skipped")):
        if (element := case.find(kind)) is not None:
            return outcome, element.get("message") or ""
    for item in case.iter("property"):
        if item.get("name") == "flake":
            return "retried", item.get("value") or ""
    return "passed", ""


@contextlib.contextmanager
def busy_processes(count: int) -> Iterator[None]:
    """Keep so many processes busy."""
    processes = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(count)]
    try:
        yield
    finally:
        for process in processes:
            process.kill()
            process.wait()


def run_once(paths: Sequence[str], report: Path, log: Path) -> int:
    """Run the tests. Returns pytest's exit code."""
    command = [sys.executable, "-m", "pytest", "-n", "0", "-q", f"--junitxml={report}", *paths]
    with log.open("w") as file:
        return subprocess.run(command, cwd=ROOT, stdout=file, stderr=subprocess.STDOUT, check=False).returncode


def main(arguments: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description="List tests whose outcome differs between runs.")
    parser.add_argument("--runs", type=int, default=20)
    parser.add_argument("--loaded-runs", type=int, default=10)
    parser.add_argument("--keep", type=Path, help="folder for reports and logs of each run")
    options, more = parser.parse_known_args(arguments)  # more: for pytest; paths take the place of the groups
    groups = [()] if any(word.startswith("tests") for word in more) else GROUPS
    folder = options.keep or Path(tempfile.mkdtemp(prefix="flakes-"))
    folder.mkdir(parents=True, exist_ok=True)
    outcomes, broken = Outcomes(), []
    plan = [("quiet", 0)] * options.runs + [("loaded", BUSY_PROCESSES)] * options.loaded_runs
    for number, (kind, busy) in enumerate(plan, 1):
        start, reports = time.monotonic(), []
        for group, paths in enumerate(groups, 1):
            report, log = folder / f"{number}-{group}.xml", folder / f"{number}-{group}.log"
            with busy_processes(busy):
                code = run_once([*paths, *more], report, log)
            if code in (0, 1) and report.exists():
                reports.append(report.read_text(encoding="utf-8"))
            else:
                broken.append(f"run {number}: pytest ended with {code}; see {log}")
                print(broken[-1], flush=True)
        counts = ", ".join(f"{count} {outcome}" for outcome, count in sorted(outcomes.add(*reports).items()))
        print(f"{number}/{len(plan)} {kind}: {counts} in {time.monotonic() - start:.0f} s", flush=True)
    return report_on(outcomes, broken, folder)


def report_on(outcomes: Outcomes, broken: Sequence[str], folder: Path) -> int:
    """Print what differed. Returns the exit code."""
    for reason, count in outcomes.skipped.most_common():
        print(f"skipped: {count} tests: {reason}")
    differing = outcomes.differing()
    for name, counts in differing.items():
        print(f"DIFFERS {name}: {', '.join(f'{count} {outcome}' for outcome, count in counts.items())}")
        for message in sorted(set(outcomes.messages.get(name, ()))):
            print(f"    {message.splitlines()[0] if message else ''}")
    for line in broken:
        print(f"BROKEN {line}")
    print(f"{len(differing)} of {len(outcomes.tests)} tests differed or failed in {outcomes.runs} runs; logs: {folder}")
    return 1 if differing or broken or not outcomes.tests else 0


if __name__ == "__main__":
    sys.exit(main())
