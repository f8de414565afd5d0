"""Processes that start together share compiled modules, and a log record announces a first launch that takes long."""

import json
import logging
import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path
from types import SimpleNamespace

import pytest
import warp as wp

from pointloom.kernels import lang, launches
from pointloom.kernels.language import cache_folders, compile_notices, module_loading

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
LOCK_PROGRAM = """
import sys, time
from pointloom.kernels import lang  # starts Warp, whose folder the turns are in
from pointloom.kernels.language.module_loading import locked
with locked("a module"):
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
    assert not [line for line in err.splitlines() if not line.startswith("pointloom: compil")]  # reported to a script
    return json.loads(out)


def run(program, *arguments):
    command = [sys.executable, "-c", program, *arguments]
    done = subprocess.run(command, env=os.environ | {"PYTHONPATH": SRC}, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr[-2000:]
    return done.stdout


@pytest.mark.slow
def test_four_processes_at_once_compile_each_module_once_between_them(tmp_path):
    reports = [finished(process) for process in [start(PROGRAM, tmp_path) for _ in range(4)]]
    compiled = [name for each in reports for name in each["compiled"]]
    assert len(compiled) > 3, "the cache was empty"
    assert sorted(compiled) == sorted(set(compiled))
    assert all(each["points"] == reports[0]["points"] for each in reports)
    assert finished(start(PROGRAM, tmp_path))["compiled"] == []


@pytest.fixture
def holder(monkeypatch, tmp_path):
    """A process that has the turn of "a module" in an empty cache, which is this process's too."""
    process = start(LOCK_PROGRAM, tmp_path)
    assert process.stdout.readline() == "held\n"
    monkeypatch.setattr(wp.config, "kernel_cache_dir", str(tmp_path / wp.__version__))
    yield process
    process.send_signal(signal.SIGCONT)
    process.kill()
    process.communicate()


def test_a_lock_is_awaited_until_its_process_ends_or_a_timeout(holder, monkeypatch):
    with monkeypatch.context() as patched:
        patched.setattr(module_loading, "POLL_SECONDS", 1e6)  # a waiting process would sleep
        with module_loading.locked("another module"):
            pass
    monkeypatch.setattr(module_loading, "LONGEST_WAIT", 0.2)
    holder.send_signal(signal.SIGSTOP)
    begin = time.monotonic()
    with module_loading.locked("a module"):
        assert 0.2 <= time.monotonic() - begin < 30
    monkeypatch.setattr(module_loading, "LONGEST_WAIT", 60.0)
    holder.kill()
    holder.wait()
    begin = time.monotonic()
    with module_loading.locked("a module"):
        assert time.monotonic() - begin < 30


def test_a_cache_without_locks_works_unlocked(monkeypatch, tmp_path):
    monkeypatch.setattr(wp.config, "kernel_cache_dir", str(tmp_path / "nowhere"))
    done = []
    with module_loading.locked("a module"):
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
        item.resolve()
        _ = item.cpu
modules = [m for name in names for m in (*modules_for_cuda(name), wp.get_module(name + ".cpu")) if m.kernels]
hashes = {m.name: m.get_module_hash().hex() for m in modules}
print(json.dumps(dict(sorted(hashes.items()))))
"""


@pytest.mark.nightly
def test_module_contents_do_not_depend_on_the_order_of_use():
    """Else a cache would have as many of it as there are programs."""
    reports = [json.loads(run(ORDERS, order)) for order in ("forward", "backward")]
    assert len(reports[0]) > 100
    assert reports[0] == reports[1]


FIRST = """
from pointloom.kernels import lang
from pointloom.kernels.language.warp_compiler import cuda_module
from pointloom.kernels.search import neighbor_distances as file

kernels = cuda_module(file.__name__).kernels
_ = getattr(file, "{first}").twin.cuda
of_first = set(kernels)
lang.resolve_module(file.__name__)
assert of_first == set(kernels) and len(kernels) == 3, (of_first, set(kernels))
"""


@pytest.mark.slow
@pytest.mark.parametrize("first", ["average_distances_kernel", "sum_finite"])
def test_the_first_launch_prepares_all_kernels_of_its_module_for_gpus(first):
    """Else the module is compiled again for the next one, and code that was compiled ahead does not match."""
    run(FIRST.format(first=first))


SMALL = """
@kernel
def small_kernel(out: array(dtype=int32)):
    i = tid()
    out[i] = 3 * i
"""


def test_a_loaded_module_needs_no_lock(monkeypatch, write_kernels):
    kernel, out = write_kernels("loaded_once", SMALL).small_kernel, wp.zeros(4, dtype=int, device="cpu")
    with lang.cpu_compiler("warp"):
        lang.launch(kernel, 4, [out])
    monkeypatch.setattr(module_loading, "locked", lambda name: pytest.fail(f"waits for {name}"))
    module_loading.load_module(kernel.cpu.module, wp.get_device("cpu"))
    assert out.numpy().tolist() == [0, 3, 6, 9]


@pytest.fixture
def loaded(monkeypatch, write_kernels, tmp_path):
    """A module in a cache of its own, its two files, and a function that loads it anew and counts what is compiled."""
    import warp._src.build as build

    monkeypatch.setattr(wp.config, "kernel_cache_dir", str(tmp_path / "cache"))
    kernel = write_kernels(f"small_{tmp_path.name}", SMALL).small_kernel.cpu
    module, device = kernel.module, wp.get_device("cpu")
    compiled, real = [], build.build_cpu
    monkeypatch.setattr(build, "build_cpu", lambda path, *a, **k: (compiled.append(path), real(path, *a, **k))[1])

    def load():
        before = len(compiled)
        module.unload()
        module_loading.load_module(module, device)
        out = wp.zeros(4, dtype=int, device="cpu")
        wp.launch(kernel, 4, [out], device="cpu")
        assert out.numpy().tolist() == [0, 3, 6, 9]
        return len(compiled) - before

    assert (load(), load()) == (1, 0)
    return load, module_loading._files_of(module, device, 1)


@pytest.mark.parametrize(
    ("file", "harm", "has_digest"),
    [(0, "cut off", True), (0, "zeros", True), (0, "gone", True), (0, "cut off", False), (1, "cut off", True)]
    + [(0, mode, True) for mode in (0o666, 0o664)],
)
def test_a_file_that_is_not_intact_or_that_others_can_write_is_compiled_again(
    loaded, file, harm, has_digest, monkeypatch
):
    monkeypatch.setattr(cache_folders, "_is_own_group", lambda group: False)
    load, files = loaded
    path = files[file]
    content = path.read_bytes()
    if isinstance(harm, int):
        path.chmod(harm)
    elif harm == "gone":
        path.unlink()
    else:
        path.write_bytes(content[:-8] if harm == "cut off" else content[:9] + bytes(len(content) - 9))
    if not has_digest:
        path.with_name(f"{path.name}.sha256").unlink()
    assert (load(), load()) == (1, 0)
    assert len([*path.parent.glob("*.sha256")]) == 2


def test_files_of_an_earlier_version_are_used_and_get_their_digests(loaded):
    load, files = loaded
    for path in files[0].parent.glob("*.sha256"):
        path.unlink()
    assert load() == 0


def test_a_full_cache_folder_is_replaced_by_a_temporary_one(loaded, monkeypatch):
    load, files = loaded
    files[0].unlink()
    folder = wp.config.kernel_cache_dir
    monkeypatch.setattr(module_loading, "is_writable", lambda path, size: path != folder)
    assert load() == 1 and wp.config.kernel_cache_dir != folder and not files[0].exists()


def test_an_error_lists_the_full_folders(loaded, monkeypatch):
    load, files = loaded
    files[0].unlink()

    def full(*rest):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(wp._src.context.Module, "_write_meta", full)
    with pytest.raises(cache_folders.CacheError, match=wp.config.kernel_cache_dir):
        load()


@pytest.mark.parametrize(
    ("mode", "part", "writers"),
    [(0o755, "", ""), (0o700, "", ""), (0o777, "", "all users"), (0o777, "1.0", "all users"), (0o775, "", "group")],
)
def test_a_cache_writable_by_other_users_is_detected(tmp_path, monkeypatch, mode, part, writers):
    monkeypatch.setattr(cache_folders, "_is_own_group", lambda group: False)
    (tmp_path / "warp" / "1.0").mkdir(parents=True)
    for folder in (tmp_path / "warp", tmp_path / "warp" / "1.0"):
        folder.chmod(0o755)
    (tmp_path / "warp" / part).chmod(mode)
    others = cache_folders.other_writers(tmp_path / "warp")
    assert writers in others and bool(others) == bool(writers)
    monkeypatch.setattr(os, "getuid", lambda: 12345)
    assert tmp_path.stat().st_uid == 0 or "belongs to user" in cache_folders.other_writers(tmp_path / "warp")


@pytest.mark.slow
@pytest.mark.parametrize("is_named", [True, False])
def test_kernels_that_others_could_have_written_are_not_used_silently(tmp_path, is_named):
    warp = tmp_path / "warp"
    warp.mkdir()
    warp.chmod(0o777)
    environment = os.environ | {"XDG_CACHE_HOME": str(tmp_path), "PYTHONPATH": SRC, "POINTLOOM_CPU": "warp"}
    environment.pop("WARP_CACHE_PATH", None)
    if is_named:
        environment["WARP_CACHE_PATH"] = str(warp)
    done = subprocess.run([sys.executable, "-c", PROGRAM], env=environment, capture_output=True, text=True, check=True)
    assert "RuntimeWarning" in done.stderr and str(warp) in done.stderr
    assert bool([*warp.rglob("*.o")]) == is_named


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
