"""A pytest plugin for a GPU, `-p gpu_kit.gpu_only`: runs tests of a GPU only, writes failures at once, and restarts
workers that have lost their device.

Each failure is appended to the file FAILURES as a line of JSON, so that no name is lost if the run is ended.

An illegal address invalidates the CUDA context for all later tests of the process. So a worker of pytest-xdist whose
context is lost exits; another one is started and continues with the next test.
"""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Generator
from pathlib import Path
from typing import Any

import pytest

LOST = 77  # exit code of a worker without a device
FAILURES = "POINTLOOM_GPU_FAILURES"


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    def on_gpu(item: Any) -> bool:
        return hasattr(item, "callspec") and str(item.callspec.params.get("device", "")).startswith("cuda")

    config.hook.pytest_deselected(items=[item for item in items if not on_gpu(item)])
    items[:] = [item for item in items if on_gpu(item)]


def pytest_runtest_logreport(report: pytest.TestReport) -> None:
    write_failure(report)


def pytest_collectreport(report: pytest.CollectReport) -> None:
    write_failure(report)


def write_failure(report: pytest.TestReport | pytest.CollectReport) -> None:
    """Append a failure to the file; with pytest-xdist in the main process, which receives all reports."""
    path = os.environ.get(FAILURES)
    if path and report.failed and "PYTEST_XDIST_WORKER" not in os.environ:
        with Path(path).open("a") as file:
            file.write(json.dumps({"test": report.nodeid, "text": report.longreprtext[-2000:]}) + "\n")


@pytest.hookimpl(wrapper=True)
def pytest_runtest_protocol(item: pytest.Item) -> Generator[None, object, object]:
    result = yield
    if "PYTEST_XDIST_WORKER" in os.environ and _is_lost():
        os._exit(LOST)
    return result


def _is_lost() -> bool:
    warp = sys.modules.get("warp")
    if warp is None or not warp._src.context.runtime or "tests.emulated_cuda.install" in sys.modules:
        return False
    try:
        if warp.get_cuda_device_count():
            warp.synchronize_device("cuda:0")
    except Exception:
        return True
    return False
