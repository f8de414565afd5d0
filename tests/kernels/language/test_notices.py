"""A first launch that lasts is announced by a log record; a short one, and the next, are not."""

import logging
import time

import pytest
import warp as wp

from pointloom.kernels import lang, launches
from pointloom.kernels.language import notices

pytestmark = pytest.mark.both_compilers


def records(caplog) -> list[str]:
    return [record.getMessage() for record in caplog.records if record.name == "pointloom"]


@pytest.mark.parametrize("holds_all_threads", [False, True])
def test_what_lasts_is_announced_once(caplog, monkeypatch, holds_all_threads):
    monkeypatch.setattr(notices, "PATIENCE", 0.05)
    if holds_all_threads:  # as Taichi's compiler does
        monkeypatch.setattr(notices.threading.Timer, "start", lambda timer: None)
    with caplog.at_level(logging.INFO, "pointloom"):
        with notices.announced("slow_kernel"):
            time.sleep(0.3)
        with notices.announced("quick_kernel"):
            pass
        time.sleep(0.1)
    (message,) = records(caplog)
    assert "slow_kernel for its first use on this machine" in message


def test_an_error_ends_the_announcement(caplog, monkeypatch):
    monkeypatch.setattr(notices, "PATIENCE", 0.05)
    with caplog.at_level(logging.INFO, "pointloom"):
        with pytest.raises(ValueError), notices.announced("broken_kernel"):
            raise ValueError
        time.sleep(0.1)
    assert records(caplog) == []


def test_the_first_launch_of_a_kernel_alone_is_announced(write_kernels, device, monkeypatch):
    source = "@kernel\ndef double_it_kernel(a: array(dtype=float)):\n    i = tid()\n    a[i] = a[i] * 2.0\n"
    kernel = write_kernels(f"announced_{device[:3]}_{lang.current_cpu_compiler()}", source).double_it_kernel
    named = []
    monkeypatch.setattr(launches, "announced", lambda name: named.append(name) or notices.announced(name))
    a = wp.zeros(4, dtype=float, device=device)
    for _ in range(3):
        lang.launch(kernel, 4, [a])
    assert named == ["double_it_kernel"]
