"""The CPU seconds of a run of the tests: the sum in units of a reference workload, and the slowest tests.

Wall-clock seconds show which tests ran while the machine had other work, and CPU seconds differ between machines. The
quotient of the CPU seconds of all processes and those of a fixed workload can be compared. The same processes measure
it before, between and after their tests, since other guests of a host slow a machine down for some minutes.
`python -m tests.cpu_seconds` prints the seconds of the workload on this machine.
"""

from __future__ import annotations

import resource
from collections import Counter
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

SHOWN, MIN_SECONDS = 20, 0.3  # tests, and the CPU seconds [s] below which a test is not listed
TESTS_BETWEEN = 1_000  # measurements of the workload in a process: eight in `make test`, 1 % of its seconds
MAX_QUOTIENT = "--max-cpu-quotient"
REFERENCE = "reference workload"


def cpu_seconds() -> tuple[float, float]:
    """CPU seconds of this process so far, and of its children that have ended."""
    usage = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    own, children = (each.ru_utime + each.ru_stime for each in usage)
    return own, children


def reference_seconds() -> float:
    """CPU seconds of the reference workload: Python's compiler, dictionaries, and sorts of NumPy on one core.

    It is the unit of recorded quotients, so a change of it makes them wrong.
    """
    begin = cpu_seconds()[0]
    body = "return [a * {0} + b for c in range(a) if c % 3]"
    source = "\n".join(f"def f{k}(a, b={k}): {body.format(k)}" for k in range(2_000))
    words = Counter(source.split())
    for _ in range(3):
        compile(source, "reference", "exec")
        words.update(word for word in source.split() if word in words)
    numbers = np.random.default_rng(0).random(2_000_000)
    for _ in range(3):
        np.sort(numbers)[::2].cumsum()
    return cpu_seconds()[0] - begin


class CpuSeconds:
    """Measures the seconds in the process that runs a test, and adds them up in the first process (pytest -n)."""

    def __init__(self) -> None:
        self.before = 0.0
        self.seconds: Counter[str] = Counter()  # of tests
        self.processes: list[float] = []  # seconds of each process that ran tests
        self.references: list[float] = []  # of the workload in each process
        self.tests = 0  # that began in this process

    def pytest_addoption(self, parser: pytest.Parser) -> None:
        text = f"with -n: fail if the CPU seconds exceed N times those of the {REFERENCE}"
        parser.addoption(MAX_QUOTIENT, type=float, metavar="N", help=text)

    def pytest_sessionstart(self, session: pytest.Session) -> None:
        if hasattr(session.config, "workerinput"):
            self.references.append(reference_seconds())

    def pytest_runtest_logstart(self) -> None:
        self.tests += 1
        if self.references and self.tests % TESTS_BETWEEN == 0:
            self.references.append(reference_seconds())
        self.before = sum(cpu_seconds())

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_makereport(self) -> Iterator[None]:
        report: Any = yield
        now = sum(cpu_seconds())
        report.cpu_seconds, self.before = now - self.before, now
        return report

    def pytest_runtest_logreport(self, report: Any) -> None:
        self.seconds[report.nodeid] += report.cpu_seconds

    @pytest.hookimpl(wrapper=True)
    def pytest_sessionfinish(self, session: pytest.Session) -> Iterator[None]:
        yield  # the first process waits for the others here
        if hasattr(session.config, "workeroutput"):
            self.references.append(reference_seconds())
            spent = sum(cpu_seconds()) - sum(self.references)
            session.config.workeroutput["cpu_seconds"] = spent, self.references
        limit = session.config.getoption(MAX_QUOTIENT)
        if limit is not None and self.quotient() > limit:
            session.exitstatus = pytest.ExitCode.TESTS_FAILED

    @pytest.hookimpl(optionalhook=True)
    def pytest_testnodedown(self, node: Any) -> None:
        seconds, references = getattr(node, "workeroutput", {}).get("cpu_seconds", (0.0, []))
        self.processes.append(seconds)
        self.references += references

    def total(self) -> float:
        """CPU seconds of this process and of those that ran tests."""
        return cpu_seconds()[0] + sum(self.processes)

    def quotient(self) -> float:
        """The total in units of the reference workload; 0 without a measurement of it."""
        return self.total() / np.mean(self.references) if self.references else 0.0

    def pytest_terminal_summary(self, terminalreporter: Any) -> None:
        slowest = [(test, spent) for test, spent in self.seconds.most_common(SHOWN) if spent >= MIN_SECONDS]
        if slowest:
            terminalreporter.section(f"slowest tests, of {self.seconds.total() / 60:.1f} CPU min")
        for test, spent in slowest:
            terminalreporter.write_line(f"{spent:6.1f} s  {test}")
        if self.references:
            least, most = min(self.references), max(self.references)
            terminalreporter.write_line(
                f"CPU: {self.total():.0f} s, {self.quotient():.0f} times the {REFERENCE} ({least:.2f} to {most:.2f} s)"
            )
        limit = terminalreporter.config.getoption(MAX_QUOTIENT)
        if limit is not None and self.quotient() > limit:
            terminalreporter.write_line(
                f"FAILED: expected at most {limit:.0f} times the {REFERENCE}. Use smaller scenes, or mark tests `slow`"
            )


if __name__ == "__main__":
    print(f"{np.mean([reference_seconds() for _ in range(4)]):.3f}")
