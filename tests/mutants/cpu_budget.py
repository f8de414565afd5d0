"""A plugin of pytest for `make mutants`: the limit MUTANT_CPU_SECONDS, and the names of failed tests."""

import os
import time

import pytest

FAILED = "FAILED TEST "  # before the name of each, at the end of the output


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_protocol(item: pytest.Item) -> None:
    """Start no further test after the limit."""
    used = time.process_time() + sum(os.times()[2:4])
    if used > float(os.environ["MUTANT_CPU_SECONDS"]):
        item.session.shouldstop = "the CPU seconds are used"


@pytest.hookimpl(trylast=True)
def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    for kind in ("failed", "error"):
        for report in terminalreporter.stats.get(kind, ()):
            terminalreporter.write_line(f"{FAILED}{report.nodeid}")
