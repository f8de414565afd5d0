"""What the environment may ask for, and machines on which nothing would run."""

import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import pytest

from . import gcc
from .gcc import EmulationError
from .settings import Order, Settings


def test_settings_come_from_the_environment(monkeypatch):
    for name, text in {"ORDER": "3", "SEED": "9", "LAZY": "0", "CACHE": "/somewhere"}.items():
        monkeypatch.setenv(f"EMULATED_CUDA_{name}", text)
    settings = Settings.from_environment()
    assert (settings.order, settings.seed, settings.lazy, settings.cache) == (Order.INTERLEAVED, 9, False, "/somewhere")


@pytest.mark.parametrize(("text", "message"), [("7", "expected 0 to 3, got '7'"), ("x", "expected 0 to 3, got 'x'")])
def test_an_order_that_is_none_is_refused(monkeypatch, text, message):
    monkeypatch.setenv("EMULATED_CUDA_ORDER", text)
    with pytest.raises(ValueError, match=f"EMULATED_CUDA_ORDER: {message}"):
        Settings.from_environment()


def test_a_missing_gcc_is_reported_with_install_instructions(monkeypatch):
    monkeypatch.setenv("PATH", "/nowhere")
    with pytest.raises(EmulationError, match=r"^the emulated device needs gcc: apt-get install gcc libc6-dev$"):
        gcc.check_machine()


def test_another_processor_is_refused(monkeypatch):
    monkeypatch.setattr("platform.machine", lambda: "aarch64")
    with pytest.raises(EmulationError, match="needs Linux on x86-64, this is Linux on aarch64"):
        gcc.check_machine()


def test_several_processes_may_compile_the_same_at_once(tmp_path):
    code = f"import sys; sys.path.insert(0, {str(gcc.RUNTIME.parents[1])!r})\n"
    code += "from emulated_cuda import gcc\nprint(gcc.load_runtime().emulator_launch is not None)"
    environment = os.environ | {"EMULATED_CUDA_CACHE": str(tmp_path)}
    start = lambda _: subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env=environment)  # noqa: E731
    with ThreadPoolExecutor(4) as pool:
        done = list(pool.map(start, range(4)))
    assert [d.stdout for d in done] == ["True\n"] * 4, done[0].stderr
    assert [path.suffix for path in tmp_path.iterdir()] == [".so"]
