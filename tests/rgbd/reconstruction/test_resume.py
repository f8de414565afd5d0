"""A resumed run reuses results of an earlier run that are still valid, and recomputes the others."""

import errno
import io
import os
import shutil
from pathlib import Path

import numpy as np
import pytest

import pointloom as loom
from pointloom.core import atomic
from pointloom.core.errors import FileError

from ...interruptions import run_lines
from .test_job import digest_of
from .walks import ShortSequence, blank, config, frame_at

run_system = loom.reconstruction.run_system
FILES = tuple(
    f"rgbd/reconstruction/{name}.py" for name in ("fragments", "walk", "placement", "refinement", "scene", "job")
)
SETTINGS = config(n_frames_per_fragment=3)


def short_sequence():
    """Seven frames, one of them covered: two fragments, the second bridged."""
    return ShortSequence(range(7), changed={3: blank(frame_at(3))})


@pytest.fixture(scope="module")
def done(tmp_path_factory):
    """An uninterrupted run: its folder, its report and its files."""
    folder = tmp_path_factory.mktemp("whole")
    report = run_system(short_sequence(), SETTINGS, folder)
    return folder, report, digest_of(folder)


@pytest.fixture
def complete_digest(done):
    return done[2]


@pytest.fixture
def job(done, tmp_path):
    """A copy of the completed run that a test may change."""
    return Path(shutil.copytree(done[0], tmp_path / "job"))


def test_a_completed_run_is_unchanged(done, job):
    times = {path: path.stat().st_mtime_ns for path in job.rglob("*.ply")}
    again = run_system(short_sequence(), SETTINGS, job, resume=True)
    assert again.resumed == 2
    assert {path: path.stat().st_mtime_ns for path in job.rglob("*.ply")} == times
    for name in ("lost", "fragments", "mesh", "trajectory_error", "warnings"):
        assert getattr(again, name) == getattr(done[1], name)
    assert digest_of(job) == done[2]


@pytest.mark.slow
def test_an_interrupted_run_resumes_to_the_same_bits(tmp_path, complete_digest):
    lines = run_lines(lambda: run_system(short_sequence(), SETTINGS, tmp_path / "all"), FILES)
    for k, stop in enumerate(np.linspace(1, lines - 1, 9).astype(int).tolist()):
        folder = tmp_path / str(k)
        assert run_lines(lambda folder=folder: run_system(short_sequence(), SETTINGS, folder), FILES, stop) == stop
        run_system(short_sequence(), SETTINGS, folder, resume=True)
        assert digest_of(folder) == complete_digest, f"interrupted before line {stop} of {lines}"


def test_an_interruption_loses_one_fragment_at_most(tmp_path):
    sequence = short_sequence()
    inner = sequence.read

    def read(index):
        if index == 6 and (tmp_path / "records" / "fragment_000.json").exists():
            raise KeyboardInterrupt
        return inner(index)

    sequence.read = read
    with pytest.raises(KeyboardInterrupt):
        run_system(sequence, SETTINGS, tmp_path)
    assert run_system(short_sequence(), SETTINGS, tmp_path, resume=True).resumed == 1


class FullDisk(io.FileIO):
    """A file on a disk with little space left, for all files together."""

    room = 0

    def write(self, data):
        FullDisk.room -= len(data)
        if FullDisk.room < 0:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        return super().write(data)


@pytest.mark.parametrize("room", [3000, 200_000])
def test_a_full_disk_is_reported_and_the_run_resumes_from_there(tmp_path, monkeypatch, complete_digest, room):
    FullDisk.room = room
    with monkeypatch.context() as patch:
        patch.setattr(atomic.io, "FileIO", FullDisk)
        with pytest.raises(FileError, match="No space left"):
            run_system(short_sequence(), SETTINGS, tmp_path)
    assert not list(tmp_path.rglob("*.part"))
    run_system(short_sequence(), SETTINGS, tmp_path, resume=True)
    assert digest_of(tmp_path) == complete_digest


@pytest.mark.parametrize("name", ["fragments/fragment_001.ply", "scene/integrated.ply", "records/refine.json"])
def test_a_damaged_file_is_recomputed(job, complete_digest, name):
    path = job / name
    path.write_bytes(path.read_bytes()[:-40])
    run_system(short_sequence(), SETTINGS, job, resume=True)
    assert digest_of(job) == complete_digest


def test_a_changed_configuration_starts_a_new_run(job):
    report = run_system(short_sequence(), config(n_frames_per_fragment=2), job, resume=True)
    assert report.resumed == 0
    assert [fragment.frames for fragment in report.fragments] == [2, 2]


def test_a_stage_is_rerun_if_its_own_settings_change(done, job):
    report = run_system(short_sequence(), config(n_frames_per_fragment=3, tsdf_voxel_size=0.04), job, resume=True)
    assert report.resumed == 2
    assert report.mesh["vertices"] < done[1].mesh["vertices"]


def test_a_changed_frame_reruns_its_fragment_and_later_ones(job):
    changed = ShortSequence(range(7), changed={3: blank(frame_at(3)), 5: {"depth": frame_at(5).depth + np.uint16(1)}})
    assert run_system(changed, SETTINGS, job, resume=True).resumed == 1


@pytest.mark.slow
def test_a_longer_sequence_reuses_complete_fragments(tmp_path):
    run_system(ShortSequence(range(5)), SETTINGS, tmp_path)
    report = run_system(ShortSequence(range(8)), SETTINGS, tmp_path, resume=True)
    assert report.resumed == 1
    assert [fragment.frames for fragment in report.fragments] == [3, 3, 2]


def test_a_shorter_sequence_leaves_no_old_fragment(job):
    report = run_system(ShortSequence(range(3)), SETTINGS, job, resume=True)
    assert [fragment.frames for fragment in report.fragments] == [3]
    assert report.used == 3
    assert not list(job.rglob("*_001.*"))


@pytest.mark.slow
def test_old_fragments_are_removed_even_after_an_interruption(tmp_path):
    run_system(ShortSequence(range(8)), config(n_frames_per_fragment=2), tmp_path)
    (tmp_path / "records" / "fragment_001.json").unlink()
    report = run_system(ShortSequence(range(4)), config(n_frames_per_fragment=2), tmp_path, resume=True)
    assert report.used == 4
    assert not list(tmp_path.rglob("*_003.*"))


def test_without_resume_nothing_is_reused(job):
    assert run_system(short_sequence(), SETTINGS, job).resumed == 0
