"""Child processes: limits, crashes, last output, and cleanup."""

import contextlib
import fcntl
import io
import os
import queue
import select
import signal
import termios
import threading
import time
from pathlib import Path
from types import SimpleNamespace

import pytest

import pointloom as loom
from pointloom.photogrammetry.sfm import colmap_jobs, colmap_worker, features, limited_process
from pointloom.photogrammetry.sfm.features import find_features
from pointloom.photogrammetry.sfm.limited_process import LimitedProcess
from pointloom.photogrammetry.sfm.mapping import map_images
from pointloom.photogrammetry.sfm.matches import match_features
from pointloom.photogrammetry.sfm.settings import SfmSettings

from ...sigint import sigint_enabled
from .conftest import write_images

# Code of a worker instead of its job, and the expected message.
FAIL = 'print("{{\\"failed\\": \\"{}\\"}}")'
DEATHS = {
    "killed": ("os.kill(os.getpid(), signal.SIGKILL)", r"was ended by SIGKILL.*fewer or smaller images"),
    "crashed": ("print('no', file=sys.stderr); os.abort()", r"was ended by SIGABRT; its last output: no"),
    "hung": ("time.sleep(60)", r"was stopped after 1 s, its limit \(max_seconds\).*Give it more time"),
    "greedy": ("b = bytearray(10**9); time.sleep(60)", r"of memory; its limit \(max_memory\) is 200.0 MiB"),
    "out of memory": (FAIL.format("out of memory"), r"out of memory. Give it more memory"),
    "full disk": (FAIL.format("database or disk is full"), r"free on the disk of .*Free some space"),
    "without pycolmap": ('print(\'{"missing": "it"}\')', r'the package pycolmap. pip install "pointloom\[sfm\]"'),
    "refusing": (FAIL.format("ValueError: no"), r"finding features failed: ValueError: no"),
    "silent": ("pass", r"finding features ended with exit code 0"),
    "mumbling": ("print('no json'); print('[1]'); sys.exit(7)", r"finding features ended with exit code 7"),
}


@pytest.fixture
def worker(tmp_path, monkeypatch):
    """A function that replaces COLMAP's worker by other code."""

    def replace(lines: str) -> None:
        (tmp_path / "worker.py").write_text(f"import os, signal, subprocess, sys, time\n{lines}\nsys.stdout.flush()\n")
        monkeypatch.setattr(colmap_jobs, "_WORKER", tmp_path / "worker.py")

    return replace


@pytest.mark.parametrize("death", DEATHS)
def test_a_crashed_worker_is_an_error_with_its_last_output(scene_images, tmp_path, worker, death):
    lines, message = DEATHS[death]
    worker(lines)
    images = write_images(tmp_path / "images", scene_images[:2])
    limits = {"hung": {"max_seconds": 1}, "greedy": {"max_memory": 200 * 2**20}}.get(death, {})
    began = time.monotonic()
    with pytest.raises(loom.FileError, match=message):
        find_features(images, tmp_path / "f.db", SfmSettings(**limits))
    assert time.monotonic() - began < 30
    assert {path.name for path in tmp_path.iterdir()} == {"images", "worker.py"}


@pytest.mark.parametrize("package", ["pycolmap", "cv2"])
def test_a_missing_package_is_an_error(scene_images, tmp_path, monkeypatch, package):
    (tmp_path / "gone").mkdir()
    (tmp_path / "gone" / f"{package}.py").write_text("raise ImportError('no such package')")
    monkeypatch.setenv("PYTHONPATH", os.fspath(tmp_path / "gone"))
    images = write_images(tmp_path / "images", scene_images[:2])
    if package == "pycolmap":
        with pytest.raises(loom.FileError, match="/images:"):
            find_features(images, tmp_path / "f.db")
    else:
        (tmp_path / "video.mp4").write_bytes(b"video")
        with pytest.raises(loom.FileError, match=r"/video\.mp4:"):
            loom.photogrammetry.choose_frames(
                tmp_path / "video.mp4", tmp_path / "out", sampling=loom.photogrammetry.VideoSampling(reader="opencv")
            )


def is_alive(pid: int) -> bool:
    with contextlib.suppress(OSError):
        return " Z " not in Path(f"/proc/{pid}/stat").read_text()
    return False


def test_an_interrupt_kills_the_worker_and_its_children(scene_images, tmp_path, worker):
    fifo, watched = tmp_path / "pids", []
    os.mkfifo(fifo)
    worker(
        "child = subprocess.Popen(['sleep', '60'])\n"
        f"open({os.fspath(fifo)!r}, 'w').write(f'{{os.getpid()}} {{child.pid}}\\n')\n"
        "signal.signal(signal.SIGINT, signal.SIG_IGN)\ntime.sleep(60)"
    )
    images = write_images(tmp_path / "images", scene_images[:2])

    def interrupt() -> None:
        pids = [int(text) for text in fifo.read_text().split()]  # once the worker has written them
        watched.extend(os.pidfd_open(pid) for pid in pids)
        signal.raise_signal(signal.SIGINT)

    threading.Thread(target=interrupt, daemon=True).start()
    with sigint_enabled(), pytest.raises(KeyboardInterrupt):
        find_features(images, tmp_path / "f.db")
    assert len(watched) == 2
    for process in watched:
        assert select.select([process], [], [], 60)[0]  # it has ended
        os.close(process)
    assert not (tmp_path / "f.db").exists()


def test_an_error_of_the_caller_ends_the_program():
    with pytest.raises(ZeroDivisionError), LimitedProcess(["sleep", "60"]) as process:
        assert process._process is not None
        pid = process._process.pid
        _ = 1 // 0
    assert not is_alive(pid)


def test_a_program_that_is_not_there_leaves_nothing_open():
    with pytest.raises(FileNotFoundError), LimitedProcess(["/no/such/program"]):
        pass


def test_the_last_output_of_a_program_is_quoted_in_one_line():
    with LimitedProcess(["sh", "-c", "seq 1000 >&2; exit 3"]) as process:
        assert process.wait() == 3
        assert process.last_words() == "995 / 996 / 997 / 998 / 999 / 1000"
        assert process.why_ended() == "ended with exit code 3"


def test_the_peak_memory_of_a_program_is_recorded(monkeypatch):
    program, seen = "b = b'x' * 10**8\nimport signal; signal.pause()", queue.Queue()
    memory_of = limited_process.peak_of_process
    monkeypatch.setattr(limited_process, "peak_of_process", lambda pid: (seen.put(memory := memory_of(pid)), memory)[1])
    with LimitedProcess([limited_process.sys.executable, "-c", program]) as process:
        while seen.get(timeout=60) <= 10**8:
            pass
    assert 10**8 < process.peak_bytes < 3 * 10**8


def test_a_packed_application_does_not_start_itself_again(monkeypatch, tmp_path):
    monkeypatch.setattr(limited_process.sys, "frozen", True, raising=False)
    job = {"stage": "features", "database": str(tmp_path / "database.db")}
    with pytest.raises(RuntimeError, match=r"colmap_worker.py needs a Python interpreter.* packed by PyInstaller"):
        colmap_jobs.run_job(job, tmp_path, max_seconds=1.0, max_memory=None)


def test_threads_that_find_features_fit_into_memory(monkeypatch):
    monkeypatch.setattr(features, "usable_cores", lambda: 64)
    size = (3072, 2048)
    assert features.threads_for([size], 1600, 2**30) == 1
    assert features.threads_for([size], 1600, 8 * 2**30) == 13
    assert features.threads_for([(320, 240)], 1600, 8 * 2**30) == 64


def test_the_largest_model_is_saved_in_any_order(tmp_path):
    def model(count: int) -> SimpleNamespace:
        write = lambda path: Path(path).write_text(str(count))  # noqa: E731
        return SimpleNamespace(num_reg_images=lambda: count, num_points3D=lambda: 0, write=write)

    options = SimpleNamespace(mapper=SimpleNamespace(), triangulation=SimpleNamespace())
    models = {0: model(3), 1: model(30), 2: model(30), 3: model(7)}
    pycolmap = SimpleNamespace(IncrementalPipelineOptions=lambda: options, incremental_mapping=lambda *_, **__: models)
    pycolmap.Database = SimpleNamespace(open=lambda _: contextlib.nullcontext(SimpleNamespace(read_all_cameras=list)))
    job = {"threads": 1, "seed": 5, "fixed_camera": True, "database": "", "images": "", "scratch": tmp_path}
    job |= {"model": tmp_path / "model", "mapper": "incremental"}
    done = colmap_worker.map_images(pycolmap, job, io.StringIO())
    assert done == {"sizes": [30, 30, 7, 3], "cameras": {}}  # models without points are not checked
    assert (tmp_path / "model").read_text() == "30"
    assert (options.num_threads, options.random_seed, options.ba_refine_focal_length) == (1, 5, False)


def test_files_that_are_no_databases_are_rejected(tmp_path):
    (tmp_path / "no.db").write_bytes(b"no database" * 100)
    for call in (
        lambda: match_features(tmp_path / "no.db", tmp_path / "m.db"),
        lambda: map_images(tmp_path, tmp_path / "no.db", tmp_path / "sparse"),
    ):
        with pytest.raises(loom.FileError, match=r"no\.db:"):
            call()
    assert {path.name for path in tmp_path.iterdir()} == {"no.db"}


@pytest.mark.slow
def test_a_database_without_matches_is_an_error(stages, tmp_path):
    with pytest.raises(loom.FileError, match=r"contains no matches. photogrammetry.match_features computes them"):
        map_images(stages.images, stages.features_db, tmp_path / "sparse")


@pytest.fixture
def windows(monkeypatch):
    """Child processes without process groups, and pipes that `select` does not take."""

    def peek(handle, size):
        assert size == 0
        available = int.from_bytes(fcntl.ioctl(handle, termios.FIONREAD, bytes(4)), "little")
        if not available and select.select([handle], [], [], 0)[0]:
            raise BrokenPipeError
        return available, 0

    monkeypatch.setitem(colmap_jobs.sys.modules, "_winapi", SimpleNamespace(PeekNamedPipe=peek))
    monkeypatch.setitem(colmap_jobs.sys.modules, "msvcrt", SimpleNamespace(get_osfhandle=lambda handle: handle))
    system = SimpleNamespace(platform="win32", executable=colmap_jobs.sys.executable)
    monkeypatch.setattr(colmap_jobs, "select", None)
    for module in (colmap_jobs, limited_process):
        monkeypatch.setattr(module, "sys", system)
    for name in ("killpg", "pread", "statvfs"):
        monkeypatch.delattr(os, name)
    monkeypatch.setattr(colmap_jobs.shutil, "disk_usage", lambda _: SimpleNamespace(free=2**40))


@pytest.mark.parametrize("death", ["crashed", "hung", "refusing", "silent"])
def test_windows_reports_a_crashed_worker(windows, tmp_path, worker, death):
    lines, message = DEATHS[death]
    worker(lines)
    job = {"stage": "features", "database": os.fspath(tmp_path / "a" / "f.db")}
    polls = []
    limits = {"max_seconds": 1 if death == "hung" else 60, "max_memory": None}
    with pytest.raises(loom.FileError, match=message):
        colmap_jobs.run_job(job, tmp_path, **limits, poll=lambda: polls.append(1))
    assert polls or death != "hung"


def test_windows_reads_all_messages_of_a_worker(windows, tmp_path, worker):
    send = "for n in range(3): print('{\"registered\": %d}' % n, flush=True)\n"
    worker(send + 'print(\'{"done": {"a": 1}}\')')
    job, messages = {"stage": "features", "database": "f.db"}, []
    done, _ = colmap_jobs.run_job(job, tmp_path, max_seconds=60, max_memory=None, report=messages.append)
    assert done == {"a": 1} and messages == [{"registered": n} for n in range(3)]


@pytest.mark.parametrize(("system", "is_known"), [("linux", True), ("darwin", False), ("win32", False)])
def test_free_memory_is_known_on_linux(system, is_known, monkeypatch):
    monkeypatch.setattr(limited_process, "sys", SimpleNamespace(platform=system))
    assert (limited_process.free_memory() < 2**60) is is_known


@pytest.mark.parametrize("system", ["linux", "darwin", "win32"])
def test_a_worker_ends_with_its_parent_on_linux_and_finds_the_driver_of_its_system(system, monkeypatch):
    calls, libraries = [], []
    functions = SimpleNamespace(prctl=lambda *arguments: calls.append(arguments), cuInit=lambda _: 1)

    def load(name):
        libraries.append(name)
        return functions

    answers = io.StringIO()
    monkeypatch.setattr(colmap_worker, "sys", SimpleNamespace(platform=system, stdin=io.StringIO("{}")))
    monkeypatch.setattr(colmap_worker, "_own_output", lambda: answers)
    monkeypatch.setattr(colmap_worker.ctypes, "CDLL", load)
    monkeypatch.setitem(colmap_jobs.sys.modules, "pycolmap", None)
    assert colmap_worker.main() == 1 and "missing" in answers.getvalue()
    assert calls == ([(1, signal.SIGKILL)] if system == "linux" else [])
    libraries.clear()
    assert colmap_worker._cuda_devices() == 0
    assert libraries == ["nvcuda.dll" if system == "win32" else "libcuda.so.1"]
