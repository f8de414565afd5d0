"""A queue of sequences gives the results of single runs; sequences that fail are named."""

import contextlib
import shutil
import sqlite3
from pathlib import Path

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.datasets.scenes.room import write_room_sequence
from pointloom.tiling.jobs import run_jobs
from pointloom.tiling.jobs.run_jobs import job_status, plan_sequences, retry_job
from pointloom.tiling.manifest import NAME

SIZES = {"n_frames_per_fragment": 3, "tsdf_voxel_size": 0.04, "depth_max": 4.0}
CONFIG = loom.reconstruction.ReconstructionConfig(**SIZES)


@pytest.fixture(scope="module")
def sequences(tmp_path_factory):
    folder = tmp_path_factory.mktemp("sequences")
    write_room_sequence(folder / "kitchen", frame_count=6, width=80, height=60)
    (folder / "upstairs").mkdir()
    write_room_sequence(folder / "upstairs" / "kitchen", frame_count=4, width=80, height=60, seed=3)
    return [folder / "kitchen", folder / "upstairs" / "kitchen"]


@pytest.fixture
def broken(sequences, tmp_path):
    named = zip(sequences, ("a", "b"), strict=True)
    copies = [Path(shutil.copytree(folder, tmp_path / name)) for folder, name in named]
    (copies[1] / "camera-intrinsics.json").write_text("{")
    return copies


def test_a_sequence_gives_the_files_of_a_single_run(sequences, tmp_path):
    assert plan_sequences(sequences[1:], tmp_path / "job", config=CONFIG).waiting == 1
    status = loom.tiling.run_job(tmp_path / "job")
    assert status.is_finished, status
    alone = loom.reconstruction.run_system(loom.open_frames(sequences[1]), CONFIG, tmp_path / "alone")
    for path in alone.files:
        output = tmp_path / "job" / "sequences" / "kitchen" / Path(path).relative_to(tmp_path / "alone")
        assert output.read_bytes() == Path(path).read_bytes()
    assert alone.files


@pytest.mark.slow
def test_an_unreadable_sequence_fails_alone_and_can_be_replaced(broken, tmp_path, monkeypatch):
    job, started = tmp_path / "job", []
    run_system = run_jobs.run_system
    monkeypatch.setattr(
        run_jobs, "run_system", lambda *args, **how: started.append(args[2].name) or run_system(*args, **how)
    )
    plan_sequences(broken, job, config=CONFIG)
    status = loom.tiling.run_job(job)
    assert (status.done, status.failed, started) == (1, 1, ["a"])
    assert "camera-intrinsics.json" in status.troubles["b"]
    shutil.copy(broken[0] / "camera-intrinsics.json", broken[1] / "camera-intrinsics.json")
    retry_job(job)
    assert loom.tiling.run_job(job).is_finished
    assert started == ["a", "b"]
    path = next(broken[0].glob("*.depth.png"))
    path.write_bytes(path.read_bytes()[:-10])
    with pytest.raises(FileError, match="a:"):
        loom.tiling.run_job(job)


@pytest.mark.slow
def test_an_interrupted_sequence_is_resumed(sequences, tmp_path, monkeypatch):
    job = tmp_path / "job"
    plan_sequences(sequences[:1], job, config=CONFIG)

    def stop(stage, done, total):
        if stage == "integrate":
            raise KeyboardInterrupt

    run_system = run_jobs.run_system
    monkeypatch.setattr(run_jobs, "run_system", lambda *args, **how: run_system(*args, **how, progress=stop))
    output = job / "sequences" / "kitchen"
    with pytest.raises(KeyboardInterrupt):
        loom.tiling.run_job(job)
    assert job_status(job).waiting == 1
    before = {path: path.stat().st_mtime_ns for path in output.rglob("*.ply")}
    assert before
    monkeypatch.setattr(run_jobs, "run_system", run_system)
    assert loom.tiling.run_job(job).is_finished
    assert all(path.stat().st_mtime_ns == time for path, time in before.items())


def test_invalid_queues_are_rejected(sequences, tmp_path):
    first, gone = sequences[0], tmp_path / "nowhere"
    for folders, expected in (([], "one folder"), ([first, first], "kitchen"), ([first, gone], "nowhere")):
        with pytest.raises((ValueError, FileError), match=expected):
            plan_sequences(folders, tmp_path / "job")
    assert not (tmp_path / "job").exists()


@pytest.mark.slow
def test_workers_share_the_queue(sequences, tmp_path):
    plan_sequences(sequences, tmp_path / "job", config=CONFIG)
    assert loom.tiling.run_job(tmp_path / "job", workers=2).is_finished
    assert np.all([(tmp_path / "job" / "sequences" / name).is_dir() for name in ("kitchen", "kitchen_2")])


@pytest.mark.parametrize("name", ["../../outside", "/tmp/outside", "..", "a/b", "a\0b"])
def test_task_names_cannot_be_paths(sequences, tmp_path, name):
    job = tmp_path / "job"
    plan_sequences(sequences[1:], job, config=CONFIG)
    with contextlib.closing(sqlite3.connect(job / NAME)) as base, base:
        base.execute("UPDATE tasks SET name = ?", (name,))
    status = loom.tiling.run_job(job)
    assert status.failed == 1 and "expected a plain file name" in str(status)
    assert not (job / "sequences").exists() and not (tmp_path / "outside").exists()
