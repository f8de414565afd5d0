"""Worker processes of dask.distributed: tiles, and functions mapped over arguments."""

import os
import shutil
import signal
import subprocess
import sys
import threading
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path

import numpy as np
import pytest

import pointloom as loom
from pointloom.tiling import processes, tile_tree
from pointloom.tiling.processes import Processes
from pointloom.tiling.runners import retry_tiles
from pointloom.tiling.status import tile_status

from .scenes import finished, kill_runner, rows_of, survey

distributed = pytest.importorskip("distributed")

STEPS = [
    {"step": "remove_statistical_outlier", "nb_neighbors": 8, "std_ratio": 2.0},
    {"step": "voxel_down_sample", "voxel_size": 0.5},
]


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    return survey(tmp_path_factory.mktemp("survey"), count=2000)


@pytest.fixture(scope="module")
def expected(files, tmp_path_factory):
    job = tmp_path_factory.mktemp("alone")
    loom.tiling.plan_tiles(files, STEPS, job, size=30.0)
    assert loom.tiling.run_tiles(job).is_finished
    return rows_of(finished(job))


@pytest.fixture
def job(files, tmp_path):
    loom.tiling.plan_tiles(files, STEPS, tmp_path / "job", size=30.0)
    return tmp_path / "job"


@pytest.fixture(scope="module")
def scheduler():
    """Address of a scheduler with one worker, both in threads of this process."""
    with distributed.LocalCluster(
        1, processes=False, threads_per_worker=1, host="127.0.0.1", protocol="tcp", dashboard_address="127.0.0.1:0"
    ) as cluster:
        yield cluster.scheduler_address


def test_a_cluster_gives_the_rows_of_one_process(expected, scheduler, job):
    events = []
    status = loom.tiling.run_tiles(job, scheduler=scheduler, progress=lambda *words: events.append(words))
    assert status.is_finished and events[-1] == ("pass 2 of 2", 4, 4)
    np.testing.assert_array_equal(rows_of(finished(job)), expected)


def test_a_missing_scheduler_is_named_and_nothing_is_lost(monkeypatch, job):
    monkeypatch.setattr(processes, "CONNECT_TIMEOUT", 0.2)
    with pytest.raises(loom.FileError, match=r"no scheduler at tcp://127\.0\.0\.1:9"):
        loom.tiling.run_tiles(job, scheduler="tcp://127.0.0.1:9")
    assert tile_status(job).waiting == 4


def test_a_worker_of_another_version_is_rejected(scheduler, monkeypatch, job):
    monkeypatch.setattr(processes, "_prepare", lambda device: "0.0.1")
    with pytest.raises(loom.FileError, match=r"on the worker at .*, got 0\.0\.1"):
        loom.tiling.run_tiles(job, scheduler=scheduler)
    assert tile_status(job).waiting == 4


def test_workers_are_rejected_with_a_scheduler_and_without_distributed(job, monkeypatch):
    with pytest.raises(ValueError, match="expected one of them, got both"):
        loom.tiling.run_tiles(job, workers=2, scheduler="tcp://127.0.0.1:9")
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(loom.FileError, match=r'pip install "pointloom\[tiling\]"'):
        loom.tiling.run_tiles(job, workers=2)


def dies(cloud, folder, deaths):
    """Kill the worker up to `deaths` times."""
    if len([*Path(folder).iterdir()]) < deaths:
        (Path(folder) / str(os.getpid())).touch()
        os.kill(os.getpid(), signal.SIGKILL)
    return cloud


@pytest.mark.slow
def test_a_tile_that_kills_workers_is_repeated_and_quarantined_after_three_deaths(
    files, expected, two_workers, tmp_path
):
    for deaths in (2, 3):
        folder, job = tmp_path / str(deaths), tmp_path / f"job{deaths}"
        folder.mkdir()
        step = {"step": "function", "call": dies, "reach": 0, "arguments": {"folder": str(folder), "deaths": deaths}}
        loom.tiling.plan_tiles(files, [step, *STEPS], job, size=100.0)
        status = loom.tiling.run_tiles(job, scheduler=two_workers)
        assert len([*folder.iterdir()]) == deaths
        if deaths == 2:
            assert status.is_finished
        else:
            assert (status.aside, status.failed) == (1, 0)
            assert "the worker died 3 times at this task" in str(status)
            retry_tiles(job)
            assert loom.tiling.run_tiles(job, functions=[dies]).is_finished
        np.testing.assert_array_equal(rows_of(finished(job)), expected)


@pytest.mark.slow
def test_a_script_may_start_workers_and_prints_nothing_of_them(expected, tmp_path, job):
    script = tmp_path / "script.py"
    text = "import os, sys, pointloom as loom\n"
    text += "if __name__ == '__main__':\n    before = dict(os.environ)\n"
    text += "    before.pop('__DASK_PARENT_PID', None)\n"
    text += "    print(loom.tiling.run_tiles(sys.argv[1], workers=2))\n"
    text += "    assert before.items() <= os.environ.items()\n"
    script.write_text(text)
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(sys.path)}
    command = [sys.executable, str(script), str(job)]
    ended = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    assert (ended.returncode, ended.stderr) == (0, "") and ended.stdout.startswith("4 of 4 tiles done")
    np.testing.assert_array_equal(rows_of(finished(job)), expected)


@pytest.mark.slow
def test_workers_of_a_killed_run_end_and_the_job_is_resumed(files, expected, tmp_path):
    job = tmp_path / "job"
    loom.tiling.plan_tiles(files, STEPS, job, size=4.0)
    kill_runner("loom.tiling.run_tiles", job, "pass 2", workers=2)
    before = tile_status(job)
    assert before.done and not before.is_finished and loom.tiling.run_tiles(job).is_finished
    np.testing.assert_array_equal(rows_of(finished(job)), expected)
    assert not [*(job / "locks").iterdir()]


@pytest.mark.slow
def test_a_cluster_without_workers_or_that_disconnects_is_an_error(monkeypatch, job):
    monkeypatch.setattr(processes, "MAX_WITHOUT_WORKERS", 0.3)
    alone = {"host": "127.0.0.1", "protocol": "tcp", "dashboard_address": "127.0.0.1:0"}
    with distributed.LocalCluster(n_workers=0, processes=False, **alone) as empty:
        with pytest.raises(loom.FileError, match="no worker was connected to"):
            loom.tiling.run_tiles(job, scheduler=empty.scheduler_address)
        monkeypatch.setattr(processes, "MAX_WITHOUT_WORKERS", 60)
        checked, ended = threading.Event(), processes._ended
        monkeypatch.setattr(processes, "_ended", lambda *given: (checked.set(), ended(*given))[1])
        closing = threading.Thread(target=lambda: checked.wait(60) and empty.close())
        closing.start()
        with pytest.raises(loom.FileError, match="was lost"):
            loom.tiling.run_tiles(job, scheduler=empty.scheduler_address)
        closing.join()
    assert tile_status(job).waiting == 4


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("openssl") is None, reason="certificates are made by openssl")
def test_a_scheduler_with_certificates_accepts_clients_that_have_them(expected, tmp_path, job):
    key, certificate = str(tmp_path / "key.pem"), str(tmp_path / "certificate.pem")
    command = ["openssl", "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-days", "2", "-subj", "/CN=localhost"]
    subprocess.run([*command, "-keyout", key, "-out", certificate], check=True, capture_output=True)
    roles = {f"tls_{role}_{what}": value for role in ("scheduler", "worker", "client")
             for what, value in (("key", key), ("cert", certificate))}  # fmt: skip
    security = distributed.Security(tls_ca_file=certificate, require_encryption=True, **roles)
    options = {"host": "127.0.0.1", "protocol": "tls", "dashboard_address": "127.0.0.1:0", "security": security}
    with distributed.LocalCluster(1, processes=False, threads_per_worker=1, **options) as cluster:
        address = cluster.scheduler_address
        with pytest.raises(loom.FileError, match=r"no scheduler at tls://.*TLS"):
            loom.tiling.run_tiles(job, scheduler=address)
        assert loom.tiling.run_tiles(job, scheduler=address, security=security).is_finished
    np.testing.assert_array_equal(rows_of(finished(job)), expected)


def add(more, value):
    return os.getpid(), more + value


def die(folder, deaths, value):
    """Kill this process at value 2, up to `deaths` times."""
    if value == 2 and len([*folder.iterdir()]) < deaths:
        (folder / str(os.getpid())).touch()
        os.kill(os.getpid(), signal.SIGKILL)
    return value


def refuse(value):
    raise loom.FileError("made.laz", f"holds {value}", remedy="Take another")


def test_without_processes_map_runs_in_this_process(tmp_path):
    with Processes(0, tmp_path) as pool:
        assert [*pool.map(partial(add, 1), [(1,)])] == [(os.getpid(), 2)]


@pytest.mark.slow
def test_processes_map_in_order_and_repeat_tasks_of_dead_ones(tmp_path):
    (tmp_path / "again").mkdir()
    with Processes(2, tmp_path / "made.laz") as pool:
        for more in (10, 20):
            results = [*pool.map(partial(add, more), ((k,) for k in range(9)))]
            assert [value for _, value in results] == [more + k for k in range(9)]
            assert os.getpid() not in {process for process, _ in results}
        with pytest.raises(loom.FileError, match=r"holds 3\. Take another"):
            [*pool.map(refuse, [(3,)])]
        assert [*pool.map(partial(die, tmp_path / "again", 2), ((k,) for k in range(5)))] == [*range(5)]
        with pytest.raises(loom.FileError, match=r"made\.laz"):
            [*pool.map(partial(die, tmp_path / "again", 99), ((k,) for k in range(5)))]


def wait_for_event(value):
    distributed.Event("started").set()
    distributed.Event("go").wait()
    return value


def forget_tasks(dask_scheduler):
    """Release the tasks of all clients, as dask may do when a worker dies. Returns their number."""
    for client in [*dask_scheduler.clients]:
        dask_scheduler.client_releases_keys([*dask_scheduler.tasks], client)
    return len(dask_scheduler.tasks)


@pytest.mark.slow
def test_tasks_that_the_scheduler_lost_are_submitted_again(tmp_path, monkeypatch):
    monkeypatch.setattr(processes, "CHECK_INTERVAL", 0.2)
    with Processes(1, tmp_path / "made.laz") as pool, ThreadPoolExecutor(1) as thread:
        results = thread.submit(lambda: [*pool.map(wait_for_event, ((k,) for k in range(2)))])
        assert distributed.Event("started", client=pool._client).wait(60)
        pool._client.run_on_scheduler(forget_tasks)
        distributed.Event("go", client=pool._client).set()
        assert results.result(60) == [0, 1]


@pytest.mark.slow
def test_any_number_of_workers_writes_the_same_octree(tmp_path, monkeypatch):
    monkeypatch.setattr(tile_tree, "MAX_POINTS", 900)
    monkeypatch.setattr(tile_tree, "MIN_POINTS", 30)
    keep = {"step": "remove_radius_outlier", "nb_points": 1, "radius": 50.0}
    loom.tiling.plan_tiles(survey(tmp_path, count=4000), [keep], tmp_path / "job", size=15.0)
    assert loom.tiling.run_tiles(tmp_path / "job").is_finished
    contents = []
    for workers in (0, 2):
        events: list[tuple[str, int, int]] = []
        path = tmp_path / f"{workers}.copc.laz"
        report = lambda *step, events=events: events.append(step)  # noqa: E731
        loom.tiling.finish_tiles(tmp_path / "job", path, workers=workers, progress=report)
        contents.append(path.read_bytes())
        assert events[-1][1] == events[-1][2] and len({step[1] for step in events}) > 4
    assert contents[0] == contents[1]
