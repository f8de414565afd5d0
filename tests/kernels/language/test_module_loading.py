"""Processes that start together share what is compiled: one compiles a module, the others wait for it."""

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
import warp as wp

from pointloom.kernels import lang
from pointloom.kernels.language import module_loading

pytestmark = pytest.mark.both_compilers

SRC = str(Path(__file__).parents[3] / "src")

# Counts what Warp compiles for the CPU, in an operation of a few modules.
PROGRAM = """
import json, sys
import numpy as np
import pointloom as loom
import warp._src.build as build

compiled, real = [], build.build_cpu
def counted(path, *rest, **options):
    compiled.append(path.rpartition("/")[2])
    return real(path, *rest, **options)
build.build_cpu = counted

points = np.random.default_rng(0).random((500, 3)).astype(np.float32)
cloud = loom.PointCloud(points).voxel_down_sample(0.1)
print(json.dumps({"compiled": compiled, "points": cloud.points.tolist()}))
"""

HOLD = """
import sys, time
from pointloom.kernels import lang  # starts Warp, whose folder the turns are in
from pointloom.kernels.language.module_loading import turn_of
with turn_of("a module"):
    print("held", flush=True)
    time.sleep(600)
"""


def start(program, cache, **settings):
    environment = os.environ | {"WARP_CACHE_PATH": str(cache), "PYTHONPATH": SRC, "POINTLOOM_CPU": "warp"} | settings
    command = [sys.executable, "-c", program]
    return subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def finished(process):
    out, err = process.communicate(timeout=300)
    assert process.returncode == 0, err[-2000:]
    assert not [line for line in err.splitlines() if not line.startswith("pointloom: compil")]  # which a script is told
    return json.loads(out)


@pytest.mark.slow
def test_four_processes_at_once_compile_each_module_once_between_them(tmp_path):
    found = [finished(process) for process in [start(PROGRAM, tmp_path) for _ in range(4)]]
    compiled = [name for each in found for name in each["compiled"]]
    assert len(compiled) > 3, "the cache was empty"
    assert sorted(compiled) == sorted(set(compiled))
    assert all(each["points"] == found[0]["points"] for each in found)
    assert finished(start(PROGRAM, tmp_path))["compiled"] == []


@pytest.fixture
def holder(monkeypatch, tmp_path):
    """A process that has the turn of "a module" in an empty cache, which is this process's too."""
    process = start(HOLD, tmp_path)
    assert process.stdout.readline() == "held\n"
    monkeypatch.setattr(wp.config, "kernel_cache_dir", str(tmp_path / wp.__version__))
    yield process
    process.send_signal(signal.SIGCONT)
    process.kill()
    process.communicate()


def test_a_turn_is_waited_for_until_its_process_ends_and_not_for_ever(holder, monkeypatch):
    with monkeypatch.context() as patched:
        patched.setattr(module_loading, "PAUSE", 1e6)  # who waited would sleep
        with module_loading.turn_of("another module"):
            pass
    monkeypatch.setattr(module_loading, "LONGEST_WAIT", 0.2)
    holder.send_signal(signal.SIGSTOP)
    begin = time.monotonic()
    with module_loading.turn_of("a module"):
        assert 0.2 <= time.monotonic() - begin < 30
    monkeypatch.setattr(module_loading, "LONGEST_WAIT", 60.0)
    holder.kill()
    holder.wait()
    begin = time.monotonic()
    with module_loading.turn_of("a module"):
        assert time.monotonic() - begin < 30


def test_a_cache_without_locks_is_used_without_turns(monkeypatch, tmp_path):
    monkeypatch.setattr(wp.config, "kernel_cache_dir", str(tmp_path / "nowhere"))
    done = []
    with module_loading.turn_of("a module"):
        done.append(True)
    assert done


ORDERS = """
import sys, importlib, json, pkgutil
import warp as wp
from pointloom.kernels import lang
from pointloom.kernels.language.warp_compiler import modules_for_cuda
import pointloom.kernels as kernels

names = [m.name for m in pkgutil.walk_packages(kernels.__path__, kernels.__name__ + ".") if not m.ispkg]
names = names[::-1] if sys.argv[1] == "backward" else names
for name in names:
    importlib.import_module(name)
    items = list(lang.LAUNCHED.get(name, {}).values())
    for item in items[::-1] if sys.argv[1] == "backward" else items:
        item.settle()
        _ = item.cpu
modules = [m for name in names for m in (*modules_for_cuda(name), wp.get_module(name + ".cpu")) if m.kernels]
hashes = {m.name: m.get_module_hash().hex() for m in modules}
print(json.dumps(dict(sorted(hashes.items()))))
"""


@pytest.mark.slow
def test_what_a_module_holds_does_not_depend_on_what_was_used_first():
    """Else a cache would have as many of it as there are programs."""
    found = []
    for order in ("forward", "backward"):
        command = [sys.executable, "-c", ORDERS, order]
        done = subprocess.run(command, env=os.environ | {"PYTHONPATH": SRC}, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr[-2000:]
        found.append(json.loads(done.stdout))
    assert len(found[0]) > 100
    assert found[0] == found[1]


def test_a_module_that_is_loaded_takes_no_turn(monkeypatch, write_kernels):
    module = write_kernels(
        "loaded_once",
        """
        @kernel
        def count_kernel(out: array(dtype=int32)):
            i = tid()
            out[i] = i
        """,
    )
    out = wp.zeros(4, dtype=int, device="cpu")
    with lang.cpu_compiler("warp"):
        lang.launch(module.count_kernel, 4, [out])
    monkeypatch.setattr(module_loading, "turn_of", lambda name: pytest.fail(f"waits for {name}"))
    module_loading.load_module(module.count_kernel.cpu.module, wp.get_device("cpu"))
    assert out.numpy().tolist() == [0, 1, 2, 3]
