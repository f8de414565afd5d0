"""A pytest plugin for a GPU, `-p gpu_kit.gpu_only`: runs tests of a GPU only and restarts workers that have lost their
device.

An illegal address invalidates the CUDA context for all later tests of the process. So a worker of pytest-xdist whose
context is lost exits; another one is started and continues with the next test.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Generator
from typing import Any

import pytest

LOST = 77  # exit code of a worker without a device


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    def on_gpu(item: Any) -> bool:
        return hasattr(item, "callspec") and str(item.callspec.params.get("device", "")).startswith("cuda")

    config.hook.pytest_deselected(items=[item for item in items if not on_gpu(item)])
    items[:] = [item for item in items if on_gpu(item)]


@pytest.hookimpl(wrapper=True)
def pytest_runtest_protocol(item: pytest.Item) -> Generator[None, object, object]:
    result = yield
    if "PYTEST_XDIST_WORKER" in os.environ and _is_lost():
        os._exit(LOST)
    return result


def _is_lost() -> bool:
    warp = sys.modules.get("warp")
    if warp is None or not warp._src.context.runtime or "emulated_cuda.install" in sys.modules:
        return False
    try:
        if warp.get_cuda_device_count():
            warp.synchronize_device("cuda:0")
    except Exception:
        return True
    return False
