"""Folders of jobs that machines share, and the GPUs that processes share."""

import contextlib
import os
import sqlite3
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.tiling import manifest, processes
from pointloom.tiling.manifest import NAME, Manifest, is_shared
from pointloom.tiling.processes import reserved_device

from .scenes import finished, rows_of, survey, tiled

STEPS = [
    {"step": "remove_statistical_outlier", "nb_neighbors": 8, "std_ratio": 2.0},
    {"step": "voxel_down_sample", "voxel_size": 0.5},
]
MOUNTS = r"""22 1 254:0 / / rw,relatime shared:1 - ext4 /dev/vda rw
30 22 0:40 / {0}/far rw - nfs4 server:/data rw,vers=4.2
31 30 0:41 / {0}/far/near rw - xfs /dev/vdb rw
32 22 0:42 / {0}/two\040words rw shared:7 master:3 - fuse.sshfs host: rw
33 22 0:43 / {0}/over rw - ext4 /dev/vdc rw
34 33 0:44 / {0}/over rw - lustre ost:/l rw
"""


@pytest.fixture
def mounts(tmp_path, monkeypatch):
    (tmp_path / "mountinfo").write_text(MOUNTS.replace("{0}", str(tmp_path.resolve())))
    monkeypatch.setattr(manifest, "MOUNTS", tmp_path / "mountinfo")


def test_a_folder_is_shared_if_its_mount_is_and_local_without_a_table_of_mounts(tmp_path, mounts, monkeypatch):
    assert all(is_shared(tmp_path / folder) for folder in ("far", "far/job", "two words/job", "over"))
    assert not any(is_shared(tmp_path / folder) for folder in ("far/near/job", "farther", ""))
    monkeypatch.setattr(manifest, "MOUNTS", tmp_path / "nowhere")
    assert not is_shared(tmp_path / "far")


def mode_of(job):
    with contextlib.closing(sqlite3.connect(job / NAME)) as base:
        return base.execute("PRAGMA journal_mode").fetchone()[0]


@pytest.mark.slow
def test_parts_of_an_array_job_share_a_folder_without_a_log(tmp_path, monkeypatch):
    files = survey(tmp_path, count=1000)
    expected = rows_of(tiled(files, STEPS, tmp_path / "expected", size=100.0)[0])
    assert mode_of(tmp_path / "expected") == "wal"
    monkeypatch.setattr(manifest, "is_shared", lambda _: True)
    job = tmp_path / "job"
    loom.tiling.plan_tiles(files, STEPS, job, size=20.0)
    assert mode_of(job) == "delete"
    for _ in range(2):  # with two passes, a part stops when it needs another part
        with ThreadPoolExecutor() as pool:
            [*pool.map(lambda part: loom.tiling.run_tiles(job, part=part), [(1, 3), (2, 3), (3, 3)])]
    assert mode_of(job) == "delete" and not [*job.glob("*-wal")]
    np.testing.assert_array_equal(rows_of(finished(job)), expected)


def test_a_job_planned_on_a_local_disk_drops_the_log_where_it_is_shared(tmp_path, monkeypatch):
    job = tmp_path / "job"
    loom.tiling.plan_tiles(survey(tmp_path, count=200), STEPS, job, size=20.0)
    with Manifest(job) as here, monkeypatch.context() as patch:
        here.counts()
        patch.setattr(manifest, "is_shared", lambda _: True)
        patch.setattr(manifest, "LOCK_TIMEOUT", 0.2)
        with pytest.raises(FileError, match=r"plan\.sqlite"):
            Manifest(job)
    assert mode_of(job) == "wal"
    monkeypatch.setattr(manifest, "is_shared", lambda _: True)
    assert loom.tiling.run_tiles(job).is_finished and mode_of(job) == "delete"


def test_locks_of_workers_on_windows_end_with_their_block(tmp_path, monkeypatch):
    """Windows has no fcntl and removes no open file."""
    unlink = Path.unlink

    def unlink_closed(path, missing_ok=False):
        if any(path.samefile(f"/proc/self/fd/{number}") for number in opened):
            raise PermissionError(f"{path} is open")
        unlink(path, missing_ok)

    opened, open_file, close_file = set(), os.open, os.close
    monkeypatch.setattr(os, "open", lambda *given, **more: opened.add(number := open_file(*given, **more)) or number)
    monkeypatch.setattr(os, "close", lambda number: opened.discard(number) or close_file(number))
    monkeypatch.setattr(Path, "unlink", unlink_closed)
    monkeypatch.setattr(manifest, "fcntl", None)
    with manifest.worker_lock(tmp_path) as owner, manifest.exclusive(tmp_path, "run"):
        assert len(opened) == 2 and not manifest.is_dead(tmp_path, owner)
    assert not opened and manifest.is_dead(tmp_path, owner)


def test_a_missing_device_is_named(job):
    with pytest.raises(loom.DeviceError, match="cuda:7"):
        loom.tiling.run_tiles(job, device="cuda:7")


@pytest.fixture
def three_gpus(monkeypatch, tmp_path):
    """A machine with three GPUs and its locks in tmp_path."""
    gpus = [SimpleNamespace(is_cuda=True, alias=f"cuda:{k}", uuid=f"GPU-{k}", ordinal=k) for k in range(3)]
    monkeypatch.setattr(processes.tempfile, "gettempdir", lambda: str(tmp_path))
    monkeypatch.setattr("warp.get_cuda_devices", lambda: gpus)
    monkeypatch.setattr(processes, "resolve_device", lambda name: gpus[int(name[5:] or 0)])


@pytest.mark.usefixtures("three_gpus")
def test_each_process_takes_another_gpu():
    """As with processes: each opened lock file is a separate owner of the lock."""
    with reserved_device("cuda") as first, reserved_device("cuda") as second:
        assert (first, second) == ("cuda:0", "cuda:1")
        for taken, message in (("cuda", "all of 3 GPUs are in use"), ("cuda:1", "all of 1 GPUs are in use")):
            error = pytest.raises(loom.DeviceError, match=message)
            with reserved_device("cuda:2"), error, reserved_device(taken):
                pass
    with reserved_device("cuda:1") as third:
        assert third == "cuda:1"


@pytest.mark.usefixtures("three_gpus")
def test_a_worker_keeps_its_gpu(monkeypatch):
    monkeypatch.setattr(processes, "_devices", {})
    with contextlib.ExitStack() as locks:
        monkeypatch.setattr(processes, "_device_locks", locks)
        processes._prepare("cuda")
        assert processes._call(lambda _, device: device, None, "cuda") == "cuda:0"
        with reserved_device("cuda") as other:
            assert other == "cuda:1"


@pytest.mark.usefixtures("three_gpus")
def test_without_locks_processes_share_a_gpu(monkeypatch):
    monkeypatch.setattr(processes, "fcntl", None)
    with reserved_device("cuda") as first, reserved_device("cuda") as second:
        assert (first, second) == ("cuda:0", "cuda:0")
