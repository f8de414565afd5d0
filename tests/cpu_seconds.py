"""The slowest tests, by the CPU seconds of their process and of its child processes.

Wall-clock seconds would show which tests ran while the machine had other work.
"""

from __future__ import annotations

import resource
from collections import Counter
from collections.abc import Iterator
from typing import Any

import pytest

SHOWN, MIN_SECONDS = 20, 0.3  # tests, and the CPU seconds [s] below which a test is not listed
SLOW = 1.0  # [s] from which on a test is marked `slow`


def cpu_seconds() -> tuple[float, float]:
    """CPU seconds of this process so far, and of its children that have ended."""
    usage = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    own, children = (each.ru_utime + each.ru_stime for each in usage)
    return own, children


class CpuSeconds:
    """Takes the seconds where a test runs, and sums them up where the reports come together (pytest -n: elsewhere)."""

    def __init__(self) -> None:
        self.before = 0.0
        self.seconds: Counter[str] = Counter()

    def pytest_runtest_logstart(self) -> None:
        self.before = sum(cpu_seconds())

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_makereport(self) -> Iterator[None]:
        report: Any = yield
        now = sum(cpu_seconds())
        report.cpu_seconds, self.before = now - self.before, now
        return report

    def pytest_runtest_logreport(self, report: Any) -> None:
        self.seconds[report.nodeid] += report.cpu_seconds

    def pytest_terminal_summary(self, terminalreporter: Any) -> None:
        slowest = [(test, spent) for test, spent in self.seconds.most_common(SHOWN) if spent >= MIN_SECONDS]
        if not slowest:
            return
        terminalreporter.section(f"slowest tests, of {self.seconds.total() / 60:.1f} CPU min")
        for test, spent in slowest:
            terminalreporter.write_line(f"{spent:6.1f} s  {test}")
