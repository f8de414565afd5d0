"""Full disks, damaged or modified files and copies of open jobs: an error names the file, or work is repeated."""

import contextlib
import json
import os
import shutil
import sqlite3
import subprocess
import sys
from functools import partial

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.tiling import buckets, finish, sources, tasks
from pointloom.tiling.manifest import NAME, Manifest, canonical, exclusive, hash_of, worker_lock
from pointloom.tiling.plan import open_plan
from pointloom.tiling.runners import retry_tiles
from pointloom.tiling.status import tile_status

from .scenes import RADIUS, finished, rows_of

resource = pytest.importorskip("resource")


def assert_goes_on(job, expected):
    assert loom.tiling.run_tiles(job).is_finished
    np.testing.assert_array_equal(rows_of(finished(job)), expected)


@contextlib.contextmanager
def files_up_to(size):
    """Limit the size of files [bytes], as on a full disk."""
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)


def on_a_full_disk(monkeypatch, table, size):
    """Limit the size of files written by tasks of a table."""
    work = tasks.do_task

    def full(plan, folder, task, owner):
        with files_up_to(size) if task.table == table else contextlib.nullcontext():
            return work(plan, folder, task, owner)

    monkeypatch.setattr(tasks, "do_task", full)


def test_a_full_disk_while_points_are_sorted_is_an_error_and_leaves_nothing(job, expected, monkeypatch):
    with monkeypatch.context() as patch:
        on_a_full_disk(patch, "sources", 2000)
        with pytest.raises(FileError, match=r"/part0\.laz:"):
            loom.tiling.run_tiles(job)
    assert not [*(job / "buckets").iterdir()]
    retry_tiles(job)
    assert_goes_on(job, expected)


def test_a_full_disk_while_tiles_are_written_fails_each_tile(job, expected, monkeypatch):
    with monkeypatch.context() as patch:
        on_a_full_disk(patch, "tiles", 300)  # less than a header
        status = loom.tiling.run_tiles(job)
    assert status.failed == 4 and all("File too large" in error for error in status.troubles.values())
    assert not [*(job / "tiles").iterdir()]
    retry_tiles(job)
    assert_goes_on(job, expected)


def test_a_full_disk_for_the_log_of_the_manifest_does_not_require_a_new_plan(job, expected):
    with files_up_to(0), pytest.raises(FileError, match=r"plan\.sqlite"):
        tile_status(job)
    assert_goes_on(job, expected)


def test_a_full_manifest_is_an_error_and_nothing_is_lost(job, expected):
    with Manifest(job) as manifest:
        manifest.base.execute("PRAGMA max_page_count = 1")
        full = pytest.raises(FileError, match=r"/plan\.sqlite:")
        with full, manifest.change() as base:
            base.executemany("INSERT INTO checksums VALUES (?, 1)", [(number,) for number in range(5000)])
        assert not manifest.base.in_transaction
        manifest.base.execute("PRAGMA max_page_count = 100000")
        assert manifest.claim("tiles", "dead")["id"] == 0
    assert_goes_on(job, expected)


@pytest.mark.parametrize("name", ["result.laz", "result.copc.laz"])
def test_a_full_disk_at_the_end_keeps_the_previous_result_and_the_tiles(job, expected, name, monkeypatch):
    loom.tiling.run_tiles(job)
    (job / name).write_bytes(b"before")

    def full(write, *given):
        with files_up_to(2000):
            return write(*given)

    with monkeypatch.context() as patch:
        for writer in ("_merge", "write_tree"):
            patch.setattr(finish, writer, partial(full, getattr(finish, writer)))
        with pytest.raises(FileError, match=r"cannot be written.*File too large"):
            loom.tiling.finish_tiles(job, job / name)
    assert (job / name).read_bytes() == b"before" and not [*job.glob(".*.part")]
    np.testing.assert_array_equal(rows_of(finished(job)), expected)


@pytest.mark.parametrize("fault", ["flipped", "cut", "gone"])
def test_a_modified_tile_is_named_and_recomputed(job, expected, fault):
    loom.tiling.run_tiles(job)
    path = job / "tiles" / "1_1.laz"
    content = bytearray(path.read_bytes())
    content[-200] ^= 16
    path.write_bytes(content if fault == "flipped" else content[:-100])
    if fault == "gone":
        path.unlink()
    with pytest.raises(FileError, match=r"1_1\.laz"):
        loom.tiling.finish_tiles(job)
    assert not (job / "result.laz").exists() and tile_status(job).waiting == 1
    assert_goes_on(job, expected)


def test_a_missing_tile_without_buckets_is_recomputed_from_the_sources(job, expected):
    loom.tiling.run_tiles(job)
    finished(job)
    for name in ("0_0", "1_1"):
        (job / "tiles" / f"{name}.laz").unlink()
    with pytest.raises(FileError, match=r"/0_0\.laz:.*1"):
        loom.tiling.finish_tiles(job)
    assert_goes_on(job, expected)


def test_a_damaged_chunk_of_an_octree_fails_its_tiles_by_name(files, tmp_path):
    loom.write_point_cloud(tmp_path / "whole.copc.laz", loom.read_point_cloud(files[0]), scale=1e-4)
    content = (tmp_path / "whole.copc.laz").read_bytes()
    rng = np.random.default_rng(0)
    begin = sources.open_las(tmp_path / "whole.copc.laz").header.begin
    outcomes = {"same": 0, "named": 0}
    expected = None
    for number in range(8):
        path, job = tmp_path / f"flipped{number}.copc.laz", tmp_path / f"job{number}"
        changed = bytearray(content)
        changed[begin + 8 + int(rng.integers(0, 400))] ^= 1 << int(rng.integers(0, 8)) if number else 0
        path.write_bytes(changed)
        loom.tiling.plan_tiles(path, RADIUS, job, size=100.0)
        status = loom.tiling.run_tiles(job)
        if number == 0:
            expected = status.points_out
        outcomes["named" if status.failed else "same"] += 1
        assert all("damaged" in error for error in status.troubles.values()), status
        assert status.failed or status.points_out == expected or number
    assert outcomes["named"] >= 4, outcomes


@pytest.mark.parametrize("fault", ["flipped", "cut"])
def test_a_bucket_that_is_damaged_fails_its_tile_by_name(job, fault):
    loom.tiling.run_tiles(job)
    with Manifest(job) as manifest, manifest.change() as base:
        base.execute("UPDATE tiles SET state = 'waiting' WHERE id = 0")
    path = job / "buckets" / "000000" / "0.blocks"
    content = bytearray(path.read_bytes())
    content[-5] ^= 1
    path.write_bytes(content if fault == "flipped" else content[:-7])
    status = loom.tiling.run_tiles(job)
    assert status.failed == 1 and "0.blocks" in status.troubles["0_0"]
    assert ("does not match its checksum" if fault == "flipped" else "damaged") in status.troubles["0_0"]


def test_existing_buckets_are_not_rewritten_while_they_are_read(job):
    """A worker of a cluster may outlive its run and start a file that another run has finished meanwhile."""
    loom.tiling.run_tiles(job)
    manifest, plan = open_plan(job)
    with manifest, worker_lock(job) as alive:
        before = (job / "buckets" / "000000" / "index.json").stat()
        (row,) = manifest.rows("SELECT points, full, bytes FROM sources WHERE id = 0")
        result = buckets.fill_buckets(plan, job, 0, "late")
        assert (result.points, result.full, result.size) == tuple(row) and sum(result.tiles.values()) == result.points
        assert (job / "buckets" / "000000" / "index.json").stat() == before
        shutil.rmtree(job / "buckets" / "000000")
        for owner in (alive, "remote-1", "dead"):
            (job / "buckets" / f"000000.{owner}.part").mkdir()
        assert buckets.fill_buckets(plan, job, 0, "again") == result
        left = sorted(path.name for path in (job / "buckets").glob("*.part"))
        assert left == sorted([f"000000.{alive}.part", "000000.remote-1.part"])


def test_removed_buckets_are_rebuilt_by_retry(job, expected):
    with Manifest(job) as manifest:
        manifest.claim("tiles", "dead")
    loom.tiling.run_tiles(job)
    shutil.rmtree(job / "buckets" / "000001")
    with Manifest(job) as manifest, manifest.change() as base:
        base.execute("UPDATE tiles SET state = 'waiting' WHERE id < 3")
    status = loom.tiling.run_tiles(job)
    assert status.failed == 3 and "call retry_tiles(folder)" in status.troubles["0_0"]
    assert retry_tiles(job).sources_waiting == 1
    assert_goes_on(job, expected)


def test_files_of_a_killed_finish_are_removed_and_concurrent_finishes_are_rejected(job, expected):
    loom.tiling.run_tiles(job)
    (job / ".result.laz.killed.part").write_bytes(b"half")
    with exclusive(job, "finish"), pytest.raises(FileError, match="/job:"):
        loom.tiling.finish_tiles(job)
    np.testing.assert_array_equal(rows_of(finished(job)), expected)
    assert not [*job.rglob("*.part")] and not [*(job / "locks").iterdir()]


def test_a_file_modified_while_it_is_sorted_into_tiles_is_rejected(job, files, monkeypatch):
    fill = buckets._fill

    def touched(plan, file, part):
        result = fill(plan, file, part)
        os.utime(files[0], ns=(1, 1))
        return result

    monkeypatch.setattr(buckets, "_fill", touched)
    with pytest.raises(FileError, match=r"part0\.laz"):
        loom.tiling.run_tiles(job)
    assert tile_status(job).done == 0 and not (job / "buckets" / "000000").exists()


def test_an_octree_modified_while_it_is_read_fails_the_tile(files, tmp_path, monkeypatch):
    path = tmp_path / "whole.copc.laz"
    loom.write_point_cloud(path, loom.read_point_cloud(files[0]), scale=1e-4)
    loom.tiling.plan_tiles(path, RADIUS, tmp_path / "job", size=100.0)
    read = sources._rows_of_copc
    monkeypatch.setattr(sources, "_rows_of_copc", lambda *given: (read(*given), os.utime(path, ns=(1, 1)))[0])
    status = loom.tiling.run_tiles(tmp_path / "job")
    assert status.failed == 1 and "has changed since" in status.troubles["0_0"]


def test_a_copy_of_a_running_job_is_a_valid_job(job, tmp_path, expected):
    """The folder is copied while its manifest is open and a tile is claimed; the copy has no live worker."""
    with Manifest(job) as manifest, worker_lock(job) as alive:
        manifest.claim("sources", alive)
        shutil.copytree(job, tmp_path / "copy")
        assert_goes_on(tmp_path / "copy", expected)
        assert manifest.counts("sources")["running"] == 1


@pytest.mark.slow
def test_a_manifest_copied_without_its_log_is_resumed_and_a_truncated_one_is_rejected(files, tmp_path, expected):
    job, copy = tmp_path / "job", tmp_path / "copy"
    loom.tiling.plan_tiles(files, RADIUS, job, size=10.0)
    with Manifest(job) as manifest:  # open, so that the log is not yet in the file
        loom.tiling.run_tiles(job)
        copy.mkdir()
        shutil.copy(job / NAME, copy / NAME)
        assert manifest.counts()["done"]
    assert tile_status(copy).done < tile_status(job).done
    assert_goes_on(copy, expected)
    content = (job / NAME).read_bytes()
    (copy / NAME).write_bytes(content[: len(content) // 2])
    with pytest.raises(FileError, match=r"plan\.sqlite"):
        loom.tiling.run_tiles(copy)


@pytest.mark.skipif(os.geteuid() != 0, reason="only root can take the permissions of another user")
@pytest.mark.parametrize("what", ["sources", "job", "file"])
def test_folders_and_files_without_permission_are_named(files, tmp_path, what):
    data, job = tmp_path / "data", tmp_path / "job"
    data.mkdir()
    shutil.copy(files[0], data / "one.laz")
    loom.tiling.plan_tiles(data, RADIUS, job, size=20.0)
    for folder in (tmp_path, *tmp_path.parents):
        if "pytest-" in str(folder):
            folder.chmod(0o755)
    {"sources": data, "job": job, "file": data / "one.laz"}[what].chmod(0)
    os.seteuid(65534)
    try:
        with pytest.raises(FileError, match=r"(data|one\.laz|job.*): .*[Pp]ermission denied"):
            if what == "job":
                loom.tiling.run_tiles(job)
            loom.tiling.plan_tiles(data, RADIUS, tmp_path / "other", size=20.0)
    finally:
        os.seteuid(0)


@pytest.mark.slow
def test_two_runs_with_workers_on_one_folder_do_all_tiles_once(files, tmp_path, expected):
    job = tmp_path / "job"
    loom.tiling.plan_tiles(files, RADIUS, job, size=4.0)
    program = "import sys, pointloom as loom; assert loom.tiling.run_tiles(sys.argv[1], workers=1).is_finished"
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(sys.path), "POINTLOOM_CPU_THREADS": "1"}
    runs = [subprocess.Popen([sys.executable, "-c", program, str(job)], env=environment) for _ in range(2)]
    assert [run.wait() for run in runs] == [0, 0]
    status = tile_status(job)
    assert status.points_in == status.points
    np.testing.assert_array_equal(rows_of(finished(job)), expected)
    assert not [*(job / "locks").iterdir()] and not [*job.rglob("*.part")]


def rewritten(job, change):
    """Change the plan of a manifest and its hash, as an untrusted program could."""
    with contextlib.closing(sqlite3.connect(job / NAME)) as base, base:
        plan = json.loads(base.execute("SELECT value FROM meta WHERE key = 'plan'").fetchone()[0])
        change(plan)
        values = {"plan": canonical(plan), "hash": hash_of(plan)}
        base.executemany("UPDATE meta SET value = ? WHERE key = ?", [(value, key) for key, value in values.items()])


PLANS = {
    "no points": lambda plan: plan["sources"][0].pop("points"),
    "a number for a path": lambda plan: plan["sources"][0].update(path=5),
    "NUL in a path": lambda plan: plan["sources"][0].update(path="a\0b"),
    "no origin": lambda plan: plan.pop("origin"),
    "a list for a source": lambda plan: plan["sources"].append([]),
    "a huge number": lambda plan: plan.update(slack=10**400),
    "an unknown output": lambda plan: plan.update(output="x"),
    "a side of zero": lambda plan: plan.update(size=0.0),
    "an unknown step": lambda plan: (plan["steps"].append({"step": "shell"}), plan["guesses"].append(0.0)),
    "steps without names": lambda plan: plan.update(steps=[1]),
    "more tiles than memory": lambda plan: plan.update(shape=[2**31, 2**31]),
}


@pytest.mark.parametrize("change", PLANS.values(), ids=PLANS)
def test_a_plan_with_invalid_values_is_an_error_that_names_the_manifest(job, change):
    rewritten(job, change)
    for call in (tile_status, loom.tiling.run_tiles, loom.tiling.finish_tiles):
        with pytest.raises(FileError, match=r"plan\.sqlite"):
            call(job)


OF_OTHER_TYPES = {
    "a state": "UPDATE tiles SET state = 5",
    "a state of bytes": "UPDATE tiles SET state = x'ff'",
    "a count": "UPDATE tiles SET points_out = 'x'",
    "a negative count": "UPDATE tiles SET points_in = -1",
    "a file that the plan lacks": "UPDATE sources SET id = 1000000 WHERE id = 0",
    "a negative tile": "UPDATE tiles SET id = -1 WHERE id = 0",
    "a tile that the plan lacks": "UPDATE tiles SET id = 1000000 WHERE id = 0",
    "a checksum": "UPDATE checksums SET crc = 'x'",
}


@pytest.mark.parametrize("change", OF_OTHER_TYPES.values(), ids=OF_OTHER_TYPES)
def test_a_manifest_with_values_of_other_types_is_an_error(job, change):
    """SQLite stores values of any type in any column."""
    loom.tiling.run_tiles(job)
    with contextlib.closing(sqlite3.connect(job / NAME)) as base:
        base.executescript(change)
    for call in (tile_status, loom.tiling.run_tiles):
        with contextlib.suppress(FileError):
            call(job)
    with pytest.raises(FileError, match=r"plan\.sqlite.*damaged"):
        loom.tiling.finish_tiles(job)


@pytest.mark.parametrize("change", ["total = 'x'", "squares = 1.5", "count = 'x'"])
def test_sums_of_other_types_are_an_error(files, tmp_path, change):
    steps = [{"step": "remove_statistical_outlier", "nb_neighbors": 5, "std_ratio": 2.0}]
    loom.tiling.plan_tiles(files, steps, tmp_path / "job", size=50)
    loom.tiling.run_tiles(tmp_path / "job")
    with contextlib.closing(sqlite3.connect(tmp_path / "job" / NAME)) as base:
        base.executescript(f"UPDATE tiles SET state = 'waiting', pass = 1; UPDATE numbers SET {change}")
    with pytest.raises(FileError, match=r"plan\.sqlite.*damaged"):
        loom.tiling.run_tiles(tmp_path / "job")


FOREIGN = {
    "the owner": "UPDATE tiles SET state = 'running', owner = '{path}'",
    "the owner, from the folder": "UPDATE tiles SET state = 'running', owner = '../../kept.txt'",
    "a trigger": "CREATE TRIGGER t AFTER UPDATE ON tiles BEGIN DELETE FROM meta; END",
    "an endless view": "DROP TABLE joins; CREATE VIEW joins AS "
    "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT i AS id, '' AS state FROM n",
    "another table": "DROP TABLE checksums; ALTER TABLE tiles ADD COLUMN more",
}


@pytest.mark.parametrize("change", FOREIGN.values(), ids=FOREIGN)
def test_an_untrusted_manifest_removes_and_runs_nothing(job, tmp_path, change):
    unrelated = tmp_path / "kept.txt"
    unrelated.write_text("mine")
    with contextlib.closing(sqlite3.connect(job / NAME)) as base:
        base.executescript(change.format(path=unrelated))
    with pytest.raises(FileError, match=r"plan\.sqlite"):
        loom.tiling.run_tiles(job)
    assert unrelated.read_text() == "mine"


@pytest.mark.parametrize("name", ["locks", "tiles", "buckets", NAME])
def test_a_job_does_not_write_through_symbolic_links(job, tmp_path, name):
    elsewhere = tmp_path / "elsewhere"
    if (job / name).exists():
        (job / name).rename(elsewhere)
    else:
        elsewhere.mkdir()
        (elsewhere / ("0" * 32)).write_text("mine")
    (job / name).symlink_to(elsewhere)
    with pytest.raises(FileError, match=rf"{name}:"):
        loom.tiling.run_tiles(job)
    assert elsewhere.is_file() or [*elsewhere.iterdir()] == [elsewhere / ("0" * 32)]
