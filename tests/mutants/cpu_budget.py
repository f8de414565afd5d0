"""A plugin of pytest that starts no further test after the CPU seconds of the variable MUTANT_CPU_SECONDS."""

import os
import time

import pytest


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_protocol(item: pytest.Item) -> None:
    used = time.process_time() + sum(os.times()[2:4])
    if used > float(os.environ["MUTANT_CPU_SECONDS"]):
        item.session.shouldstop = "the CPU seconds are used"
