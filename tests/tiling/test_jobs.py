"""Jobs of registration and of fusion give the results computed in memory, and recover from errors."""

import contextlib
import errno
import json
import re
import shutil
import sqlite3
from collections import Counter

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.datasets.scenes.room import write_room_sequence
from pointloom.registration.pose_graphs.multiway import FragmentPair
from pointloom.tiling.jobs import run_jobs
from pointloom.tiling.jobs import scans as scans_job
from pointloom.tiling.jobs.run_jobs import job_status, retry_job
from pointloom.tiling.jobs.scans import box_at_pose, groups_of, meeting_boxes, most_similar, nearest_of
from pointloom.tiling.manifest import NAME, Manifest, canonical, hash_of

from .scenes import watch_calls

SIZE = 0.08
STRAY = 3  # the scan that overlaps no other


def relief(x, y):
    z = 0.25 * np.sin(2.1 * x) * np.cos(1.7 * y) + 0.12 * np.sin(4.3 * y + x) + 0.08 * np.cos(5.9 * x - 2 * y)
    return z + 0.15 * np.exp(-4 * ((x - 0.7) ** 2 + (y + 0.4) ** 2))


@pytest.fixture(scope="module")
def surveyed(tmp_path_factory):
    """Files of four scans along a relief, the last of another object, and their poses."""
    folder, rng = tmp_path_factory.mktemp("scans"), np.random.default_rng(3)
    paths, poses = [], []
    for k in range(4):
        x, y = rng.uniform(-1.1, 1.1, (2, 4000))
        x = x + 0.9 * k - 1.6
        T = np.eye(4)
        T[:3, :3], T[:3, 3] = Rotation.random(random_state=k).as_matrix(), rng.uniform(-3, 3, 3)
        points = (np.column_stack([x, y, relief(x, y)]) - T[:3, 3]) @ T[:3, :3]
        if k == STRAY:
            points = rng.normal(0, 1, (3000, 3)) * [1, 1, 0.01]
        paths.append(folder / f"{k}.ply")
        loom.write_point_cloud(paths[-1], loom.PointCloud(points))
        poses.append(T)
    return paths, np.array(poses)


def in_memory(paths, device="cpu", **options):
    clouds = [loom.read_point_cloud(path, device=device) for path in paths]
    return loom.registration.register_multiway(clouds, voxel_size=SIZE, **options)


def by_tasks(paths, job, device="cpu", **options):
    loom.tiling.plan_registration(paths, job, voxel_size=SIZE, **options)
    status = loom.tiling.run_job(job, device=device)
    assert status.is_finished, status
    return loom.tiling.finish_registration(job)


def tasks_of(job, stage):
    with Manifest(job, is_job=True) as manifest:
        return [row["name"] for row in manifest.rows("SELECT name FROM tasks WHERE stage = ? ORDER BY id", stage)]


@pytest.fixture(scope="module")
def expected(surveyed):
    return in_memory(surveyed[0])


def assert_same(result, expected):
    """Check that pairs, groups, edges and poses are bitwise identical."""
    assert [pair[:2] for pair in result.pairs] == [pair[:2] for pair in expected.pairs]
    uncertain = [[edge.uncertain for edge in each.pose_graph.edges] for each in (result, expected)]
    assert uncertain[0] == uncertain[1]
    np.testing.assert_array_equal(result.groups, expected.groups)
    np.testing.assert_array_equal(result.placed, expected.placed)
    assert result.reference == expected.reference
    np.testing.assert_array_equal(result.poses, expected.poses)
    for actual, other in zip(result.pairs, expected.pairs, strict=True):
        np.testing.assert_array_equal(actual.transformation, other.transformation)
        assert actual.fitness == other.fitness
        np.testing.assert_array_equal(actual.score, other.score)
    for actual, other in zip(result.pose_graph.edges, expected.pose_graph.edges, strict=True):
        np.testing.assert_array_equal(actual.information, other.information)


@pytest.mark.slow
def test_scans_are_registered_as_in_memory_and_every_pair_has_a_status(device, surveyed, expected, tmp_path):
    result = by_tasks(surveyed[0], tmp_path / "job", device)
    assert result.placed.tolist() == [True, True, True, False]
    assert_same(result, expected if device == "cpu" else in_memory(surveyed[0], device))
    tried = {pair[:2]: pair for pair in result.tried}  # if a pair was registered later as a loop, that entry
    assert set(tried) == {(j, i) for i in range(4) for j in range(i + 1, 4)}
    assert [pair.by for pair in result.tried[:6]] == ["order"] * 6 and {p.by for p in result.tried[6:]} == {"loop"}
    for pair in result.pairs:
        assert tried[pair[:2]].status == "kept"
        np.testing.assert_array_equal(tried[pair[:2]].score, pair.score)
    for pair in result.tried:
        if STRAY in pair[:2]:
            assert pair.status not in ("kept", "dropped", "apart", "") and pair.score <= 0.5
    assert result.not_placed == [str(surveyed[0][STRAY])]
    assert result.to_dict()["tried"][0]["source"] == str(surveyed[0][1])


@pytest.mark.slow
def test_level_scans_are_registered_as_in_memory_without_tilt(surveyed, tmp_path):
    paths = []
    for k, (path, T) in enumerate(zip(surveyed[0][:3], surveyed[1][:3], strict=True)):
        rotation = Rotation.from_euler("z", 50 * k, degrees=True).as_matrix()
        paths.append(tmp_path / f"{k}.ply")
        loom.write_point_cloud(paths[-1], loom.read_point_cloud(path).transform(T).rotate(rotation, center=[k, 0, 0]))
    how = {"free": ["x", "y", "z", "yaw"]}
    result = by_tasks(paths, tmp_path / "job", **how)
    assert result.placed.all() and np.abs(result.poses[:, 2, :2]).max() < 1e-15
    assert_same(result, in_memory(paths, **how))


def test_given_and_known_pairs_match_registration_in_memory(surveyed, expected, tmp_path):
    first = expected.pairs[0]
    known = [FragmentPair(first.source, first.target, first.transformation, 0.0, 1.0)]
    how = {"pairs": [(2, 1), (0, 2)], "known": known}
    assert_same(by_tasks(surveyed[0], tmp_path / "job", max_similar=0, **how), in_memory(surveyed[0], **how))
    assert tasks_of(tmp_path / "job", 1) == ["pair 0 1", "pair 0 2", "pair 1 2"]


def test_pairs_are_chosen_by_known_poses_and_by_similarity(surveyed, expected, tmp_path):
    paths, poses = surveyed
    result = by_tasks(paths, tmp_path / "job", places=[poses[0], poses[1], poses[2][:3, 3], None], place_error=0.05)
    assert set(tasks_of(tmp_path / "job", 1)) == {"pair 0 1", "pair 0 2", "pair 1 2"}
    assert tasks_of(tmp_path / "job", 2) == ["pair 0 3", "pair 1 3", "pair 2 3"]
    assert_same(result, expected)


def test_boxes_at_given_poses_intersect():
    low, high = np.array([-1.0, -1, 0]), np.array([1.0, 2, 1])
    rotated = np.eye(4)
    rotated[:2, :2] = [[0, -1], [1, 0]]
    rotated[0, 3] = 4.0
    first, second = box_at_pose(low, high, np.eye(4), 0.0), box_at_pose(low, high, rotated, 0.0)
    np.testing.assert_array_equal(second, ([2, -1, 0], [5, 1, 1]))
    assert meeting_boxes([first, None, second]) == []
    wide = [box_at_pose(low, high, T, 0.5) for T in (np.eye(4), rotated)]
    assert meeting_boxes([wide[0], None, wide[1]]) == [(0, 2)]
    row = [box_at_pose(low, high, np.array([x, 0.0, 0.0]), 0.0) for x in (0, 1, 3, 3.5)]
    assert meeting_boxes(row) == [(i, j) for i in range(4) for j in range(i + 1, 4)]
    assert nearest_of(meeting_boxes(row), row, 1) == [(0, 1), (2, 3)]
    ball = box_at_pose(low, high, np.array([0.0, 0, 10]), 0.25)
    np.testing.assert_allclose(ball[1] - ball[0], 2 * (np.sqrt(1 + 4 + 1) + 0.25))
    np.testing.assert_array_equal(groups_of(5, [(3, 1), (4, 3)]), [0, 1, 2, 1, 1])
    assert most_similar(np.array([[0.0, 5], [1, 5], [0.1, 5], [9, 5]]), 0, np.array([1, 2, 3]), 2) == [2, 1]


def test_an_unreadable_scan_is_named_and_can_be_replaced(surveyed, expected, tmp_path):
    paths = []
    for path in surveyed[0]:
        paths.append(tmp_path / path.name)
        paths[-1].write_bytes(path.read_bytes() if path.name != "1.ply" else path.read_bytes()[:5000])
    job = tmp_path / "job"
    loom.tiling.plan_registration(paths, job, voxel_size=SIZE)
    status = loom.tiling.run_job(job)
    assert (status.failed, status.stage) == (1, "scans") and "1.ply" in status.troubles[str(paths[1])]
    with pytest.raises(FileError, match="/job:"):
        loom.tiling.finish_registration(job)
    paths[1].write_bytes(surveyed[0][1].read_bytes())
    retry_job(job)
    assert loom.tiling.run_job(job).is_finished
    assert_same(loom.tiling.finish_registration(job), expected)
    loom.write_point_cloud(paths[0], loom.PointCloud(np.zeros((1, 3))))
    with pytest.raises(FileError, match=r"0\.ply"):
        loom.tiling.run_job(job)


def test_a_damaged_surface_fails_its_pairs(surveyed, tmp_path):
    job = tmp_path / "job"
    loom.tiling.plan_registration(surveyed[0][:2], job, voxel_size=SIZE)
    loom.tiling.run_job(job, part=(2, 3))  # one scan each; the pair belongs to the first part
    loom.tiling.run_job(job, part=(3, 3))
    surface = job / "surfaces" / "1.npz"
    data = bytearray(surface.read_bytes())
    data[len(data) // 2] ^= 1
    surface.write_bytes(data)
    status = loom.tiling.run_job(job)
    assert status.failed == 1 and "1.npz: a scan's surface cannot be read" in status.troubles["pair 0 1"]


def test_a_full_disk_fails_the_scan_and_leaves_no_partial_files(surveyed, tmp_path, monkeypatch):
    def full(file, **arrays):
        file.write(b"half")
        raise OSError(errno.ENOSPC, "No space left on device")

    loom.tiling.plan_registration(surveyed[0], tmp_path / "job", voxel_size=SIZE)
    monkeypatch.setattr(np, "savez", full)
    status = loom.tiling.run_job(tmp_path / "job")
    assert status.failed == 4 and "No space left" in str(status)
    assert not [*(tmp_path / "job" / "surfaces").iterdir()]


def test_an_interrupted_run_repeats_no_pair(surveyed, expected, tmp_path, monkeypatch):
    job, tried = tmp_path / "job", Counter()

    def stop(_, stage, name, *__):
        if stage == 1 and len(tried) == last:
            raise KeyboardInterrupt
        tried.update([name] if stage == 1 else [])

    last = 3
    loom.tiling.plan_registration(surveyed[0], job, voxel_size=SIZE)
    watch_calls(monkeypatch, scans_job.RegistrationJob, "do", stop)
    with pytest.raises(KeyboardInterrupt):
        loom.tiling.run_job(job)
    assert job_status(job).done == 7
    last = None
    assert loom.tiling.run_job(job).is_finished and set(tried.values()) == {1} and len(tried) == 6
    assert_same(loom.tiling.finish_registration(job), expected)


def test_a_scan_without_a_surface_is_reported_and_left_out(surveyed, tmp_path):
    loom.write_point_cloud(tmp_path / "few.ply", loom.PointCloud(np.random.default_rng(0).random((3, 3)) * 100))
    paths = [surveyed[0][0], tmp_path / "few.ply", surveyed[0][1]]
    assert by_tasks(paths, tmp_path / "job").placed.tolist() == [True, False, True]
    assert "few.ply: has no surface" in str(job_status(tmp_path / "job"))


@pytest.mark.parametrize(
    ("how", "message"),
    [
        ({"places": [None]}, "places"),
        ({"places": [None] * 3 + [np.eye(3)]}, r"places\[3\]"),
        ({"places": [None] * 3 + [2 * np.eye(4)]}, r"places\[3\]"),
        ({"places": [None] * 4, "pairs": [(0, 1)]}, "both"),
        ({"neighbors": 2, "pairs": [(0, 1)]}, "both"),
        ({"pairs": [(0, 4)]}, r"pairs\[0\]"),
        ({"pairs": [(1, 1)]}, r"pairs\[0\]"),
        ({"pairs": [3]}, r"pairs\[0\]"),
        ({"place_error": -1}, "place_error"),
        ({"max_similar": -1}, "max_similar"),
    ],
)
def test_invalid_arguments_are_rejected_before_files_are_written(surveyed, tmp_path, how, message):
    with pytest.raises(ValueError, match=message):
        loom.tiling.plan_registration(surveyed[0], tmp_path / "job", voxel_size=SIZE, **how)
    with pytest.raises(FileError, match=r"none\.ply"):
        loom.tiling.plan_registration([*surveyed[0], tmp_path / "none.ply"], tmp_path / "job", voxel_size=SIZE)
    assert not (tmp_path / "job").exists()


def test_the_status_of_a_job_is_json(surveyed, tmp_path):
    status = loom.tiling.plan_registration(surveyed[0], tmp_path / "job", voxel_size=SIZE)
    assert status.to_dict()["job"] == "registration"
    with pytest.raises(FileError, match=r"/job:.*voxel_size.*0\.1.*0\.08"):
        loom.tiling.plan_registration(surveyed[0], tmp_path / "job", voxel_size=0.1)


@pytest.fixture(scope="module")
def frames(tmp_path_factory):
    folder = tmp_path_factory.mktemp("frames") / "kitchen"
    write_room_sequence(folder, frame_count=4, width=80, height=60, seed=3)
    return folder


def finished(kind, surveyed, frames, job):
    """A finished job, and the function that uses its results."""
    if kind == "registration":
        by_tasks(surveyed[0][:2], job)
        return loom.tiling.finish_registration
    loom.tiling.plan_fusion(frames, job, voxel_size=0.1)
    assert loom.tiling.run_job(job).is_finished
    return loom.tiling.finish_fusion


@pytest.mark.parametrize("kind", run_jobs.KINDS)
def test_each_field_of_an_untrusted_job_is_validated(kind, surveyed, frames, tmp_path):
    """A plan, an input or a result with another type is an error that names the manifest."""
    job = tmp_path / "job"
    finish = finished(kind, surveyed, frames, job)
    with contextlib.closing(sqlite3.connect(job / NAME, isolation_level=None)) as base:
        (text,) = base.execute("SELECT value FROM meta WHERE key = 'plan'").fetchone()
        plan, rows = json.loads(text), base.execute("SELECT stage, id, told, found FROM tasks").fetchall()
        first = {stage: row for stage, *row in reversed(rows)}  # of each stage

        def is_rejected():
            with pytest.raises(FileError, match=r"plan\.sqlite"):
                loom.tiling.run_job(job)
                finish(job)
            return True

        def store(value):
            known = {"plan": canonical(value), "hash": hash_of(value)}
            base.executemany("UPDATE meta SET value = ? WHERE key = ?", [(known[key], key) for key in known])

        for name in plan.keys() - {"job"}:
            store(plan | {name: {"/etc/passwd": 1}})
            assert is_rejected(), name
        store(plan)
        for row, *texts in first.values():
            for column, text in zip(("told", "found"), texts, strict=True):
                for name in json.loads(text):
                    changed = json.dumps(json.loads(text) | {name: {"/etc/passwd": [1]}})
                    base.execute(f"UPDATE tasks SET {column} = ? WHERE id = ?", (changed, row))
                    assert is_rejected(), (column, name)
                base.execute(f"UPDATE tasks SET {column} = ? WHERE id = ?", (text, row))
        finish(job)


@pytest.mark.parametrize("change", [{"first": 3}, {"first": 10**6, "count": 1}, {"count": 5}])
def test_a_task_of_frames_that_do_not_exist_is_named(frames, tmp_path, change):
    job = tmp_path / "job"
    loom.tiling.plan_fusion(frames, job, voxel_size=0.1)
    with contextlib.closing(sqlite3.connect(job / NAME)) as base, base:
        (text,) = base.execute("SELECT told FROM tasks").fetchone()
        base.execute("UPDATE tasks SET told = ?", (json.dumps(json.loads(text) | change),))
    (error,) = loom.tiling.run_job(job).troubles.values()
    assert re.match(r"FileError: .*plan\.sqlite: a task has frames beyond the 4 of ", error)


@pytest.mark.parametrize("text", ["\ud800", "a\udfff", "\0"])
def test_a_name_of_a_plan_is_text_of_the_file_system(surveyed, tmp_path, text):
    job = tmp_path / "job"
    loom.tiling.plan_registration(surveyed[0], job, voxel_size=SIZE)
    with contextlib.closing(sqlite3.connect(job / NAME)) as base, base:
        (plan,) = base.execute("SELECT value FROM meta WHERE key = 'plan'").fetchone()
        changed = json.loads(plan) | {"scans": [text, *json.loads(plan)["scans"][1:]]}
        for key, value in (("plan", canonical(changed)), ("hash", hash_of(changed))):
            base.execute("UPDATE meta SET value = ? WHERE key = ?", (value, key))
    with pytest.raises(FileError, match=r"plan\.sqlite.*plan: scans is "):
        loom.tiling.run_job(job)


@pytest.mark.parametrize("kind", run_jobs.KINDS)
def test_no_job_writes_through_symbolic_links(kind, surveyed, frames, tmp_path):
    job, unrelated = tmp_path / "job", tmp_path / "kept"
    finished(kind, surveyed, frames, job)
    outputs = [path for path in job.rglob("*") if path.is_file() and path.suffix in (".npz", ".ply", ".json", ".log")]
    assert outputs
    for path in (outputs[0], outputs[-1], outputs[0].parent):
        with contextlib.closing(sqlite3.connect(job / NAME)) as base, base:
            base.execute("UPDATE tasks SET state = 'waiting'")
            base.execute("UPDATE meta SET value = '0' WHERE key = 'stage'")
        shutil.rmtree(path) if path.is_dir() else path.unlink()
        unrelated.mkdir() if path == outputs[0].parent else unrelated.write_text("mine")
        path.symlink_to(unrelated)
        with contextlib.suppress(FileError):
            assert "symbolic link" in str(loom.tiling.run_job(job))
        assert [*unrelated.iterdir()] == [] if unrelated.is_dir() else unrelated.read_text() == "mine"
        path.unlink()
        unrelated.unlink(missing_ok=True) if unrelated.is_file() else None
