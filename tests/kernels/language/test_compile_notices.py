"""A first launch that lasts is announced by a log record; a short one, and the next, are not."""

import logging
import threading
import time
from types import SimpleNamespace

import pytest
import warp as wp

from pointloom.kernels import lang, launches
from pointloom.kernels.language import compile_notices, module_loading

pytestmark = pytest.mark.both_compilers


def records(caplog) -> list[str]:
    return [record.getMessage() for record in caplog.records if record.name == "pointloom"]


@pytest.mark.parametrize("blocks_all_threads", [False, True])
def test_slow_compilations_are_announced_once(caplog, monkeypatch, blocks_all_threads):
    now, timers = [1.0], []
    monkeypatch.setattr(compile_notices, "time", SimpleNamespace(monotonic=lambda: now[0]))
    monkeypatch.setattr(compile_notices.threading.Timer, "start", lambda timer: timers.append(timer))

    def take(seconds):
        now[0] += seconds
        if timers and not blocks_all_threads:  # as Taichi's compiler does
            timers.pop().function()

    with caplog.at_level(logging.INFO, "pointloom"):
        with compile_notices.announced("slow_kernel"):
            compile_notices.compiling()
            take(2 * compile_notices.NOTICE_DELAY)
        with compile_notices.announced("loaded_kernel"):  # from a cache, on a slow machine
            take(2 * compile_notices.NOTICE_DELAY)
        with compile_notices.announced("quick_kernel"):
            compile_notices.compiling()
            now[0] += 0.5 * compile_notices.NOTICE_DELAY
    (message,) = records(caplog)
    assert "slow_kernel for its first use on this machine" in message


def test_an_error_ends_the_announcement(caplog, monkeypatch):
    monkeypatch.setattr(compile_notices, "NOTICE_DELAY", 60.0)
    caplog.set_level(logging.INFO, "pointloom")
    with pytest.raises(ValueError), compile_notices.announced("broken_kernel"):
        compile_notices.compiling()
        raise ValueError
    assert not [thread for thread in threading.enumerate() if isinstance(thread, threading.Timer)]
    assert records(caplog) == []


def test_only_the_first_launch_of_a_kernel_is_announced(write_kernels, device, monkeypatch):
    source = "@kernel\ndef double_it_kernel(a: array(dtype=float)):\n    i = tid()\n    a[i] = a[i] * 2.0\n"
    kernel = write_kernels(f"announced_{device[:3]}_{lang.current_cpu_compiler()}", source).double_it_kernel
    named = []
    monkeypatch.setattr(launches, "announced", lambda name: named.append(name) or compile_notices.announced(name))
    a = wp.zeros(4, dtype=float, device=device)
    for _ in range(3):
        lang.launch(kernel, 4, [a])
    assert named == ["double_it_kernel"]


@pytest.mark.slow
def test_modules_cached_by_an_earlier_process_are_not_compiled(write_kernels, monkeypatch):
    """A compilation is reported only for modules that are not in Warp's cache."""
    factor = f"1.{time.time_ns()}"  # which no earlier run had
    source = f"@kernel\ndef triple_it_kernel(a: array(dtype=float)):\n    i = tid()\n    a[i] = a[i] * {factor}\n"
    module, compiled = write_kernels("in_no_cache", source).triple_it_kernel.on_host.module, []
    monkeypatch.setattr(module_loading, "compiling", lambda: compiled.append(True))
    module_loading.load_module(module, wp.get_device("cpu"))
    assert compiled == [True]
    module.execs.clear()  # as in the next process
    module_loading.load_module(module, wp.get_device("cpu"))
    assert compiled == [True]
