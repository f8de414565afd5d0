"""Tiles that a cluster of dask.distributed works off."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import threading

import numpy as np
import pytest

import pointloom as loom
from pointloom.scale import cluster
from pointloom.scale.manifest import Manifest

from .scenes import finished, rows_of, survey

distributed = pytest.importorskip("distributed")
psutil = pytest.importorskip("psutil")  # which distributed needs

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
    loom.scale.plan_tiles(files, STEPS, job, size=30.0)
    assert loom.scale.run_tiles(job).is_finished
    return rows_of(finished(job))


@pytest.fixture(scope="module")
def scheduler():
    """Address of a scheduler with one worker, both threads of this process."""
    with distributed.LocalCluster(
        1, processes=False, threads_per_worker=1, host="127.0.0.1", protocol="tcp", dashboard_address="127.0.0.1:0"
    ) as found:
        yield found.scheduler_address


def test_a_cluster_gives_the_rows_of_one_process(files, expected, scheduler, tmp_path):
    loom.scale.plan_tiles(files, STEPS, tmp_path / "job", size=30.0)
    told = []
    status = loom.scale.run_tiles(tmp_path / "job", scheduler=scheduler, progress=lambda *words: told.append(words))
    assert status.is_finished and told[-1] == ("pass 2 of 2", 4, 4)
    np.testing.assert_array_equal(rows_of(finished(tmp_path / "job")), expected)


def failing(cloud):
    raise ValueError("this step always fails")


@pytest.mark.slow
def test_a_step_that_fails_on_a_cluster_is_named_by_tile(files, scheduler, tmp_path):
    steps = [{"step": "function", "call": failing, "reach": 0}]
    loom.scale.plan_tiles(files, steps, tmp_path / "job", size=30.0)
    status = loom.scale.run_tiles(tmp_path / "job", scheduler=scheduler)
    assert status.failed == 4 and not status.waiting
    assert all("this step always fails" in text for text in status.troubles.values())


def test_a_scheduler_that_is_not_there_is_named_and_nothing_is_lost(files, tmp_path, monkeypatch):
    monkeypatch.setattr(cluster, "PATIENCE", 0.2)
    loom.scale.plan_tiles(files, STEPS, tmp_path / "job", size=30.0)
    with pytest.raises(loom.FileError, match=r"no scheduler at tcp://127\.0\.0\.1:9"):
        loom.scale.run_tiles(tmp_path / "job", scheduler="tcp://127.0.0.1:9")
    assert loom.scale.tile_status(tmp_path / "job").waiting == 4


def test_a_worker_of_another_version_is_refused(files, scheduler, tmp_path, monkeypatch):
    loom.scale.plan_tiles(files, STEPS, tmp_path / "job", size=30.0)
    monkeypatch.setattr(cluster, "_version", _another_version)
    with pytest.raises(loom.FileError, match=r"has pointloom 0\.0\.1, this is"):
        loom.scale.run_tiles(tmp_path / "job", scheduler=scheduler)
    assert loom.scale.tile_status(tmp_path / "job").waiting == 4


def _another_version():
    return "0.0.1"


def test_two_runners_are_refused(files, tmp_path):
    loom.scale.plan_tiles(files, STEPS, tmp_path / "job", size=30.0)
    with pytest.raises(ValueError, match="expected one of them, got several"):
        loom.scale.run_tiles(tmp_path / "job", workers=2, dask=2)


@pytest.mark.slow
def test_a_worker_that_is_killed_is_replaced_and_its_tile_done_again(files, expected, tmp_path):
    """Processes of a cluster of this machine; one kills itself at the first tile that it is given."""
    once = tmp_path / "once"
    steps = [{"step": "function", "call": dies_once, "reach": 0, "arguments": {"mark": str(once)}}, *STEPS]
    loom.scale.plan_tiles(files, steps, tmp_path / "job", size=30.0)
    status = loom.scale.run_tiles(tmp_path / "job", dask=2)
    assert once.exists() and status.is_finished
    np.testing.assert_array_equal(rows_of(finished(tmp_path / "job")), expected)


def dies_once(cloud, mark):
    import os
    import signal
    from pathlib import Path

    try:
        Path(mark).touch(exist_ok=False)
    except FileExistsError:
        return cloud
    os.kill(os.getpid(), signal.SIGKILL)
    return cloud


@pytest.mark.slow
def test_a_script_without_a_guard_may_start_a_cluster_whose_processes_end_with_it(files, tmp_path):
    """What distributed starts workers by would load the script once more in each of them."""
    loom.scale.plan_tiles(files, STEPS, tmp_path / "job", size=30.0)
    script = tmp_path / "script.py"
    script.write_text("import sys, pointloom as loom\nprint(loom.scale.run_tiles(sys.argv[1], dask=2))\n")
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(sys.path), "POINTLOOM_CPU_THREADS": "1"}
    command = [sys.executable, str(script), str(tmp_path / "job")]
    ended = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    assert ended.stdout.startswith("4 of 4 tiles done") and not ended.stderr


@pytest.mark.slow
def test_workers_of_a_runner_that_is_killed_end_and_the_job_goes_on(files, expected, tmp_path):
    loom.scale.plan_tiles(files, STEPS, tmp_path / "job", size=4.0)
    program = "import sys, pointloom as loom; say = lambda *at: print(at, flush=True)\n"
    program += "loom.scale.run_tiles(sys.argv[1], dask=2, progress=say)"
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(sys.path), "POINTLOOM_CPU_THREADS": "1"}
    command = [sys.executable, "-c", program, str(tmp_path / "job")]
    with subprocess.Popen(command, env=environment, stdout=subprocess.PIPE) as runner:
        with Manifest(tmp_path / "job") as manifest:  # looked at with each step
            assert any(manifest.counts("tiles", "pass > 0")["waiting"] for _ in runner.stdout)
        workers = psutil.Process(runner.pid).children(recursive=True)
        runner.kill()
        runner.wait()
    gone, alive = psutil.wait_procs(workers, timeout=30)
    assert gone and not alive
    assert loom.scale.run_tiles(tmp_path / "job").is_finished
    np.testing.assert_array_equal(rows_of(finished(tmp_path / "job")), expected)


@pytest.mark.slow
def test_a_cluster_that_lacks_workers_or_goes_away_is_an_error_by_name(files, tmp_path, monkeypatch):
    monkeypatch.setattr(cluster, "MOST_LONELY", 0.3)
    loom.scale.plan_tiles(files, STEPS, tmp_path / "job", size=30.0)
    alone = {"host": "127.0.0.1", "protocol": "tcp", "dashboard_address": "127.0.0.1:0"}
    with distributed.LocalCluster(n_workers=0, processes=False, **alone) as empty:
        with pytest.raises(loom.FileError, match="there was no worker at"):
            loom.scale.run_tiles(tmp_path / "job", scheduler=empty.scheduler_address)
        monkeypatch.setattr(cluster, "MOST_LONELY", 60)
        asked, waited = threading.Event(), cluster._waited
        monkeypatch.setattr(cluster, "_waited", lambda *given: (asked.set(), waited(*given))[1])
        closing = threading.Thread(target=lambda: asked.wait(60) and empty.close())
        closing.start()
        with pytest.raises(loom.FileError, match="has gone"):
            loom.scale.run_tiles(tmp_path / "job", scheduler=empty.scheduler_address)
        closing.join()
    assert loom.scale.tile_status(tmp_path / "job").waiting == 4


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("openssl") is None, reason="certificates are made by openssl")
def test_a_scheduler_with_certificates_takes_those_who_have_them(files, expected, tmp_path):
    key, certificate = str(tmp_path / "key.pem"), str(tmp_path / "certificate.pem")
    made = ["openssl", "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-days", "2", "-subj", "/CN=localhost"]
    subprocess.run([*made, "-keyout", key, "-out", certificate], check=True, capture_output=True)
    roles = {f"tls_{role}_{what}": value for role in ("scheduler", "worker", "client")
             for what, value in (("key", key), ("cert", certificate))}  # fmt: skip
    security = distributed.Security(tls_ca_file=certificate, require_encryption=True, **roles)
    told = {"host": "127.0.0.1", "protocol": "tls", "dashboard_address": "127.0.0.1:0", "security": security}
    loom.scale.plan_tiles(files, STEPS, tmp_path / "job", size=30.0)
    with distributed.LocalCluster(1, processes=False, threads_per_worker=1, **told) as cluster:
        address = cluster.scheduler_address
        with pytest.raises(loom.FileError, match=r"no scheduler at tls://.*TLS"):
            loom.scale.run_tiles(tmp_path / "job", scheduler=address)
        assert loom.scale.run_tiles(tmp_path / "job", scheduler=address, security=security).is_finished
    np.testing.assert_array_equal(rows_of(finished(tmp_path / "job")), expected)
