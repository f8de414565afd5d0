"""Taichi beside other processes: what they share, what they leave behind, what the system refuses, how it ends."""

import contextlib
import fcntl
import os
import resource
import subprocess
import sys
import textwrap
from collections.abc import Callable
from pathlib import Path

import pytest

from pointloom.kernels.language import taichi_compiler
from pointloom.kernels.language.taichi_compiler import KernelFolder

pytestmark = [pytest.mark.both_compilers, pytest.mark.taichi]
SMALL_WORK = """
from pointloom.kernels.arrays.sort import positions
from pointloom.kernels.lang import current_cpu_compiler
assert positions(3, "cpu").numpy().tolist() == [0, 1, 2]
"""


@pytest.fixture
def cache(tmp_path) -> Path:
    return tmp_path / "taichi" / "ticache"


@pytest.fixture
def run(cache) -> Callable[..., subprocess.CompletedProcess]:
    def run(after: str = "", before: str = "", preexec: Callable[[], None] | None = None, **environment: str):
        program = textwrap.dedent(before) + SMALL_WORK + textwrap.dedent(after)
        inherited = {name: value for name, value in os.environ.items() if not name.startswith(("POINTLOOM_CPU", "TI_"))}
        inherited |= {"XDG_CACHE_HOME": str(cache.parent.parent), "POINTLOOM_CPU": "taichi", **environment}
        return subprocess.run(
            [sys.executable, "-c", program],
            env=inherited, preexec_fn=preexec, capture_output=True, text=True, timeout=300,
        )  # fmt: skip

    return run


def assert_silent(done: subprocess.CompletedProcess) -> None:
    assert (done.stdout, done.stderr, done.returncode) == ("", "", 0)


def kernels(cache: Path) -> set[str]:
    return {path.name for path in cache.glob("*.tic")}


@pytest.mark.slow
def test_files_of_a_killed_process_do_not_block_the_folder(cache, run):
    """Taichi's lock is a file that remains when its process ends."""
    cache.mkdir(parents=True)
    left = cache / "ticache.lock"
    left.touch()
    os.utime(left, (0, 0))
    assert_silent(run())
    assert not left.exists()
    assert kernels(cache)


PROGRAMS = {
    # Taichi's destructor would throw, and the process abort
    "a deleted folder": """
        import pathlib, shutil, taichi
        folder = pathlib.Path(taichi.cfg.offline_cache_file_path)
        shutil.rmtree(folder, ignore_errors=True)
        folder.touch()  # no folder can be made there
    """,
    # Taichi's destructor would wait for threads that a fork does not have
    "a fork": """
        import os, sys
        child = os.fork()
        if child == 0:
            sys.exit(3)
        assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 3
    """,
}


@pytest.mark.slow
@pytest.mark.parametrize("name", PROGRAMS)
def test_a_program_with_a_deleted_folder_and_a_fork_end_normally(run, name):
    done = run(PROGRAMS[name])
    assert done.returncode == 0 and "terminate" not in done.stderr, done.stderr


def is_free(folder: Path) -> bool:
    with (folder / "pointloom.lock").open("w") as file:
        try:
            fcntl.flock(file.fileno(), fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            return False
    return True


def test_only_one_process_at_a_time_has_the_lock(tmp_path):
    with KernelFolder(str(tmp_path)).locked():
        assert not is_free(tmp_path)
    assert is_free(tmp_path)


def test_a_lock_that_is_never_released_is_skipped_and_a_folder_that_cannot_be_made(tmp_path, monkeypatch):
    monkeypatch.setattr(taichi_compiler, "LOCK_TIMEOUT", 0.0)
    (tmp_path / "file").touch()
    for folders in (["", ""], ["file/folder"]):
        with contextlib.ExitStack() as locks:
            for folder in folders:
                locks.enter_context(KernelFolder(str(tmp_path / folder)).locked())


@pytest.mark.slow
@pytest.mark.skipif(
    resource.getrlimit(resource.RLIMIT_STACK)[1] != resource.RLIM_INFINITY, reason="the size of stacks is limited"
)
def test_refused_threads_are_reported_with_the_reason(run):
    """Taichi would abort: "terminate called without an active exception"."""
    limits = (1 << 46, resource.RLIM_INFINITY)  # thread stacks of half the address space
    threads = {"POINTLOOM_CPU_THREADS": "4", "OPENBLAS_NUM_THREADS": "1"}
    done = run(preexec=lambda: resource.setrlimit(resource.RLIMIT_STACK, limits), **threads)
    assert done.returncode == 1
    assert "TaichiUnavailableError: the system refuses this process 5 threads" in done.stderr  # one of them compiles


@pytest.mark.slow
def test_kernels_compile_in_any_thread(run):
    """LLVM would abort: "Opaque pointers are only supported in -opaque-pointers mode"."""
    program = """
        import threading
        import numpy as np
        import pointloom as loom
        points = np.random.default_rng(0).random((20_000, 3))
        calls = [
            lambda: loom.PointCloud(points).voxel_down_sample(0.1),
            lambda: loom.PointCloud(points).estimate_normals(radius=0.1, max_nn=10),
            lambda: loom.PointCloud(points).transform(np.eye(4)),
        ]
        done = []
        threads = [threading.Thread(target=lambda call=call: done.append(call())) for call in calls]
        for thread in threads:
            thread.start()
        done.append(loom.PointCloud(points).remove_radius_outlier(3, 0.1))
        for thread in threads:
            thread.join()
        assert len(done) == 4
    """
    done = run(program)
    lines = [line for line in done.stderr.splitlines() if not line.startswith("pointloom: compil")]
    assert (done.returncode, lines) == (0, [])


@pytest.mark.slow
def test_no_thread_checks_the_internet_for_a_newer_taichi(cache, run):
    assert_silent(run("import threading\nassert threading.active_count() == 1"))
    assert not (cache.parent / "version_info").exists()


@pytest.mark.slow
def test_a_handler_at_exit_can_still_work(run):
    """Handlers run in the reverse order of their registration: this one after Taichi's shutdown."""
    program = """
        import atexit

        def work():
            assert positions(2, "cpu").numpy().tolist() == [0, 1]
            print("done")

        atexit.register(work)
    """
    done = run(before=program)
    assert (done.stdout, done.stderr, done.returncode) == ("done\n", "", 0)


def test_without_locks_a_folder_is_repaired_all_the_same(tmp_path, monkeypatch):
    monkeypatch.setattr(taichi_compiler, "fcntl", None)
    left = tmp_path / "ticache.lock"
    left.touch()
    os.utime(left, (0, 0))
    with KernelFolder(str(tmp_path)).locked():
        assert not left.exists() and is_free(tmp_path)
