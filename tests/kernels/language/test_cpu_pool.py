"""Threads share launches on the CPU: every index of a launch runs exactly once."""

import ctypes
import os
import signal
import subprocess
import sys
import textwrap
import threading
import time
from types import SimpleNamespace

import numpy as np
import pytest
import warp as wp

import pointloom as loom
from pointloom.core.threads import get_num_threads
from pointloom.kernels import lang, memory
from pointloom.kernels.arrays.segment_blocks import SegmentBlocks
from pointloom.kernels.language import cpu_code, cpu_pool
from pointloom.kernels.language.device_lock import lock

from ...sigint import sigint_enabled

SOURCE = """
@kernel
def count_kernel(seen: array(dtype=int), total: array(dtype=int)):
    i = tid()
    seen[i] = seen[i] + 1
    atomic_add(total, 0, 1)  # whole numbers

@kernel
def extremes_kernel(values: array(dtype=float), wholes: array(dtype=int64), low: array(dtype=float),
                    high: array(dtype=float), top: array(dtype=int64)):
    i = tid()
    atomic_min(low, 0, values[i])
    atomic_max(high, 0, values[i])
    atomic_max(top, i % 3, wholes[i])

@kernel
def meet_kernel(arrived: array(dtype=int), patience: int, met: array(dtype=int)):
    i = tid()
    here = atomic_add(arrived, 0, 1) + 1
    turns = int(0)
    while turns < patience and here < 2:
        here = atomic_add(arrived, 0, 0)
        turns = turns + 1
    met[i] = 1 if turns < patience else 0

@reduction
def sums(values: array(dtype=float)) -> vec3d:
    i = tid()
    x = float64(values[i])
    return vec3d(x, x * x, 1.0)

@segment_reduction
def segment_sums(values: array(dtype=float)) -> vec2d:
    i = tid()
    return vec2d(float64(values[i]), 1.0)
"""
COUNTS = (1, 2, 3, 31, 32, 33, 63, 1023, 1024, 1025, 4097, 100_003)


@pytest.fixture(scope="module")
def kernels(write_kernels):
    return write_kernels("cpu_pool_kernels", SOURCE)


@pytest.fixture(autouse=True)
def default_threads(monkeypatch):
    monkeypatch.delenv("POINTLOOM_CPU", raising=False)
    yield
    loom.set_num_threads(None)


def device_array(values, dtype):
    return wp.array(values, dtype=dtype, device="cpu")


def run_program(program: str, *, timeout: float = 120, **environment: str) -> subprocess.CompletedProcess:
    inherited = {name: value for name, value in os.environ.items() if not name.startswith("POINTLOOM_CPU")}
    command = [sys.executable, "-W", "ignore::ResourceWarning", "-c", textwrap.dedent(program)]
    return subprocess.run(command, env=inherited | environment, capture_output=True, text=True, timeout=timeout)


@pytest.mark.parametrize("threads", [1, 2, 3, 7, 64])
def test_each_thread_of_a_launch_runs_once(kernels, threads):
    loom.set_num_threads(threads)
    for count in COUNTS:
        visits, total = device_array(np.zeros(count, np.int32), int), device_array([0], int)
        for _ in range(3):
            lang.launch(kernels.count_kernel, count, [visits, total])
        assert (visits.numpy() == 3).all() and total.numpy()[0] == 3 * count


def test_launches_in_quick_succession_lose_no_thread(kernels):
    """Workers that come late, between two launches, or to one that has ended find the one that is open, or none."""
    loom.set_num_threads(5)
    visits, total = device_array(np.zeros(500, np.int32), int), device_array([0], int)
    for iteration in range(3000):
        lang.launch(kernels.count_kernel, 1 + iteration % 500, [visits, total])
        if iteration % 1000 == 0:
            time.sleep(0.01)  # they sleep
    assert total.numpy()[0] == sum(1 + iteration % 500 for iteration in range(3000)) == visits.numpy().sum()


@pytest.mark.parametrize("threads", [2, 7])
def test_atomics_are_of_all_threads(kernels, rng, threads):
    loom.set_num_threads(threads)
    values, wholes = rng.normal(size=50_000).astype(np.float32), rng.integers(-(2**60), 2**60, 50_000)
    low, high = (device_array([limit], float) for limit in (np.inf, -np.inf))
    top = device_array([-(2**62)] * 3, wp.int64)
    arrays = [device_array(values, float), device_array(wholes, wp.int64), low, high, top]
    lang.launch(kernels.extremes_kernel, len(values), arrays)
    assert (low.numpy()[0], high.numpy()[0]) == (values.min(), values.max())
    assert top.numpy().tolist() == [wholes[k::3].max() for k in range(3)]


@pytest.mark.slow
def test_a_worker_takes_part_from_the_first_launch_on():
    """In a process of its own, whose first launch needs two threads at once to come to an end in time."""
    program = f"""
        import pathlib, sys, tempfile
        folder = tempfile.mkdtemp()
        pathlib.Path(folder, "meeting.py").write_text("from pointloom.kernels.lang import *\\n" + {SOURCE!r})
        sys.path.insert(0, folder)
        import meeting, warp as wp
        from pointloom.kernels import lang
        from pointloom.kernels.language import prepared_launches
        prepared_launches.MIN_POOL_SECONDS = 0  # s: else a launch whose last one was fast runs on one thread
        for _ in range(5):
            arrived, met = wp.zeros(1, dtype=int, device="cpu"), wp.zeros(2, dtype=int, device="cpu")
            lang.launch(meeting.meet_kernel, 2, [arrived, 200_000_000, met])
            assert met.numpy().tolist() == [1, 1], met.numpy()
    """
    done = run_program(program, POINTLOOM_CPU_THREADS="2")
    assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.parametrize("count", [0, 1, 1024, 1025, 50_000])
def test_a_sum_is_bitwise_identical_for_any_number_of_threads(kernels, rng, count):
    values = device_array(rng.normal(size=count).astype(np.float32), float)
    results = set()
    for threads in (1, 2, 3, 8):
        loom.set_num_threads(threads)
        results.add(lang.reduce(kernels.sums, count, [values]).numpy().tobytes())
    assert len(results) == 1 and np.frombuffer(results.pop())[2] == count


def test_sums_of_segments_are_bitwise_identical_for_any_number_of_threads(kernels, rng):
    counts = [0, 1, 5000, 3, 2047, 40_000]
    values = device_array(rng.normal(size=sum(counts)).astype(np.float32), float)
    blocks = SegmentBlocks(np.cumsum([0, *counts[:-1]]), counts, wp.get_device("cpu"))
    live = device_array([1, 1, 1, 0, 1, 1], int)
    results = set()
    for threads in (1, 2, 5):
        loom.set_num_threads(threads)
        partials, out = blocks.partials(lang.vec2d), memory.zeros(len(counts), lang.vec2d, "cpu")
        lang.reduce_segments(kernels.segment_sums, blocks, live, [values], partials, out)
        results.add(out.numpy().tobytes())
    assert len(results) == 1
    expected = [0.0 if k == 3 else float(n) for k, n in enumerate(counts)]
    assert np.frombuffer(results.pop()).reshape(-1, 2)[:, 1].tolist() == expected


def test_the_number_of_threads_is_the_program_s_to_choose(monkeypatch):
    monkeypatch.setenv("POINTLOOM_CPU_THREADS", "3")
    assert get_num_threads() == 3
    loom.set_num_threads(2)
    assert get_num_threads() == 2
    loom.set_num_threads(None)
    assert get_num_threads() == 3
    monkeypatch.delenv("POINTLOOM_CPU_THREADS")
    assert 1 <= get_num_threads() <= len(os.sched_getaffinity(0))


@pytest.mark.parametrize("count", [0, -1, 1025, 2.5, True])
def test_a_senseless_number_of_threads_is_refused(count):
    with pytest.raises((ValueError, TypeError), match="count:"):
        loom.set_num_threads(count)


def test_the_default_number_of_threads_follows_limits_of_the_system(monkeypatch):
    monkeypatch.delenv("POINTLOOM_CPU_THREADS", raising=False)
    monkeypatch.setattr(os, "sched_getaffinity", lambda _: set(range(64)))
    monkeypatch.setattr(cpu_pool.Path, "read_text", lambda *_: "250000 100000\n")
    assert cpu_pool.default_thread_count() == 3
    monkeypatch.setattr(cpu_pool.Path, "read_text", lambda *_: "max 100000\n")
    assert cpu_pool.default_thread_count() == 64
    monkeypatch.delattr(os, "sched_getaffinity")
    monkeypatch.setattr(os, "cpu_count", lambda: 12)
    assert cpu_pool.usable_cores() == 12
    for system in ("darwin", "win32"):
        monkeypatch.setattr(sys, "platform", system)
        monkeypatch.delenv("POINTLOOM_CPU_THREADS", raising=False)
        assert cpu_pool.default_thread_count() == 1
        monkeypatch.setenv("POINTLOOM_CPU_THREADS", "5")
        assert cpu_pool.default_thread_count() == 5


def test_where_the_system_refuses_threads_there_are_fewer(kernels, monkeypatch):
    start, started = threading.Thread.start, []

    def start_one(thread):
        if started:
            raise RuntimeError("can't start new thread")
        started.append(start(thread))

    monkeypatch.setattr(threading.Thread, "start", start_one)
    loom.set_num_threads(4)
    visits, total = device_array(np.zeros(1000, np.int32), int), device_array([0], int)
    with pytest.warns(RuntimeWarning, match=r"uses 2 of 4 threads: can't start new thread; POINTLOOM_CPU_THREADS"):
        lang.launch(kernels.count_kernel, 1000, [visits, total])
    assert total.numpy()[0] == 1000


def test_a_signal_handler_may_launch(kernels):
    loom.set_num_threads(2)
    inner, outer = ((device_array(np.zeros(3000, np.int32), int), device_array([0], int)) for _ in range(2))
    calls = []

    def handle(*_):
        calls.append(lang.launch(kernels.count_kernel, 3000, inner))

    before = signal.signal(signal.SIGALRM, handle)
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.002, 0.002)
        rounds = 0
        while len(calls) < 20:
            lang.launch(kernels.count_kernel, 3000, outer)
            rounds += 1
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert (outer[1].numpy()[0], inner[1].numpy()[0]) == (3000 * rounds, 3000 * len(calls))


THIN = """
import numpy as np, pointloom as loom
points = np.random.default_rng(0).random((50_000, 3))
def thin():
    return len(loom.PointCloud(points).voxel_down_sample(0.1))
"""
FORKS = {
    "of a pool": """
import multiprocessing, threading
def work(_):
    return thin(), sum(thread.name.startswith("pointloom-cpu") for thread in threading.enumerate())
expected = thin()
with multiprocessing.get_context("fork").Pool(2) as pool:
    assert pool.map(work, range(4)) == [(expected, 2)] * 4
assert thin() == expected
""",
    "during launches of another thread": """
import os, threading
expected, go_on = thin(), True
def work():
    while go_on:
        thin()
worker = threading.Thread(target=work)
worker.start()
for _ in range(5):
    child = os.fork()
    if child == 0:
        os._exit(0 if thin() == expected else 1)
    assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 0
go_on = False
worker.join()
""",
}


@pytest.mark.slow
@pytest.mark.parametrize("name", FORKS)
def test_a_fork_has_threads_of_its_own(name):
    done = run_program(THIN + FORKS[name], POINTLOOM_CPU_THREADS="3")
    assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.slow
def test_a_handler_at_exit_can_still_work():
    """The handler of pointloom ends the threads, and runs before one that was registered earlier."""
    program = "import atexit\natexit.register(lambda: print(thin()))" + THIN + "thin()"
    done = run_program(program, POINTLOOM_CPU_THREADS="2")
    assert (done.returncode, done.stderr) == (0, "") and int(done.stdout) > 100


ENDLESS = f"""
import sys
{THIN}
thin()
dropped = []
sys.unraisablehook = dropped.append
print("begun", flush=True)
while not dropped:
    thin()
(report,) = dropped
assert report.exc_type is KeyboardInterrupt and not str(report.object.__module__).startswith("pointloom"), report
raise KeyboardInterrupt
"""


@pytest.mark.slow
def test_ctrl_c_ends_a_program_during_launches():
    """Python drops exceptions of `__del__` and of weak references: no code of pointloom may lose an interrupt so."""
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
    environment = os.environ | {"POINTLOOM_CPU_THREADS": "2"}
    with sigint_enabled():
        process = subprocess.Popen([sys.executable, "-c", ENDLESS], env=environment, **pipes)
    with process:
        assert process.stdout.readline() == "begun\n"
        process.send_signal(signal.SIGINT)
        try:
            _, errors = process.communicate(timeout=120)
        finally:
            process.kill()
    assert process.returncode == -signal.SIGINT and errors.rstrip().endswith("KeyboardInterrupt")


FALLBACK = f"""
import pathlib, warnings
from pointloom.kernels.language import cpu_code
header = cpu_code.header()
cpu_code.header = lambda: CHANGED
with warnings.catch_warnings(record=True) as caught:
    warnings.simplefilter("always", RuntimeWarning)
{textwrap.indent(THIN, "    ")}
    print(thin())
from pointloom.core.threads import get_num_threads
assert get_num_threads() == 1
(warning,) = [str(w.message) for w in caught if w.category is RuntimeWarning]
assert "pointloom uses one CPU core, and slower code: Warp" in warning and EXPECTED in warning, warning
"""
CHANGES = [("linear_tid", "line_tid", "begins elsewhere"), ("array_t<T>", "matrix_t<T>", "build failed")]


@pytest.mark.slow
@pytest.mark.parametrize(("old", "new", "expected"), CHANGES)
def test_a_warp_without_the_header_runs_on_one_core_with_one_warning(old, new, expected):
    changed = f"header.replace({old!r}, {new!r})"
    program = FALLBACK.replace("CHANGED", changed).replace("EXPECTED", repr(expected))
    done = run_program(program, POINTLOOM_CPU_THREADS="4")
    assert done.returncode == 0, done.stderr
    assert int(done.stdout) == len(loom.PointCloud(np.random.default_rng(0).random((50_000, 3))).voxel_down_sample(0.1))


def test_another_header_is_another_module(kernels, monkeypatch):
    """Else an update would run the machine code of before."""
    module = kernels.count_kernel.cpu.module
    before = module.get_module_identifier(block_dim=1)
    changed = wp.ModuleBuildOptions(extra_cpu_preamble="// another\n")
    assert module.options["extra_build_options"].extra_cpu_preamble == cpu_code.header()
    monkeypatch.setitem(module.options, "extra_build_options", changed)
    module.mark_modified()
    assert module.get_module_identifier(block_dim=1) != before
    monkeypatch.undo()
    module.mark_modified()
    assert module.get_module_identifier(block_dim=1) == before


SEMAPHORES = []  # they exist for longer than a pool


class MadeSemaphores:
    """Creates semaphores of this system, for the name and the arguments of another system."""

    def __init__(self) -> None:
        self.calls, self._system = [], ctypes.CDLL(None)

    def __call__(self, *arguments):
        self.calls.append(arguments)
        SEMAPHORES.append(ctypes.create_string_buffer(64))
        assert self._system.sem_init(SEMAPHORES[-1], 0, 0) == 0
        return ctypes.addressof(SEMAPHORES[-1])


@pytest.mark.parametrize("system", ["darwin", "win32"])
def test_a_pool_uses_the_semaphores_of_its_system(kernels, system, monkeypatch):
    """With functions of this system under the names of the other: they ignore the additional arguments."""
    loom.set_num_threads(1)
    visits, total = device_array(np.zeros(1000, np.int32), int), device_array([0], int)
    lang.launch(kernels.count_kernel, 1000, [visits, total])  # compiled
    this, create, libraries = ctypes.CDLL(None), MadeSemaphores(), []
    wait, post, switch = this.sem_wait, this.sem_post, this.sched_yield
    names = {
        "darwin": {"dispatch_semaphore_wait": wait, "dispatch_semaphore_signal": post, "sched_yield": switch}
        | {"dispatch_semaphore_create": create},
        "win32": {"WaitForSingleObject": wait, "ReleaseSemaphore": post, "SwitchToThread": switch}
        | {"CreateSemaphoreW": create},
    }[system]

    def load(name):
        libraries.append(name)
        return SimpleNamespace(**names)

    monkeypatch.setattr(cpu_pool, "sys", SimpleNamespace(platform=system))
    monkeypatch.setattr(ctypes, "WinDLL" if system == "win32" else "CDLL", load, raising=False)
    loom.set_num_threads(3)
    with lock:
        pool = cpu_pool.pool()
    monkeypatch.undo()
    stored = [getattr(pool.memory, name) for name in ("wait", "post", "give_way")]
    assert stored == [ctypes.cast(function, ctypes.c_void_p).value for function in (wait, post, switch)]
    assert libraries == ["kernel32" if system == "win32" else None]
    assert create.calls == [(None, 0, 2**30, None) if system == "win32" else (0,)] * 2
    for _ in range(20):
        lang.launch(kernels.count_kernel, 1000, [visits, total])
        while not all(worker.sleeps for worker in pool.workers):  # they sleep
            os.sched_yield()
    assert (visits.numpy() == 21).all() and total.numpy()[0] == 21_000


@pytest.mark.parametrize(("size", "is_enough"), [(128 << 10, False), (256 << 10, False), (1 << 20, True)])
def test_a_thread_with_a_small_stack_gets_an_error_instead_of_a_crash(size, is_enough):
    cloud, results = loom.PointCloud(np.random.default_rng(0).random((500, 3)), device="cpu"), []

    def work():
        try:
            results.append(len(cloud.voxel_down_sample(0.2)))
        except RuntimeError as error:
            results.append(str(error))

    before = threading.stack_size(size)
    try:
        thread = threading.Thread(target=work)
        thread.start()
    finally:
        threading.stack_size(before)
    thread.join()
    message = f"this thread has a stack of {size >> 10} KiB, and kernels need 512 KiB: call threading.stack_size("
    assert results[0] == len(cloud.voxel_down_sample(0.2)) if is_enough else results[0].startswith(message)
