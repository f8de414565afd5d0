"""LiDAR SLAM over several sessions: a saved map opens, a second drive joins it, and damaged files are named."""

import shutil

import numpy as np
import pytest

import pointloom as loom
from pointloom.registration import LidarSLAM, PositionReadings
from pointloom.registration.lidar import lidar_sessions, lidar_slam
from tests.registration.block_drives import BlockDrive
from tests.registration.test_lidar_slam import (
    AROUND,
    HEADING_DRIFT,
    OPPOSITE,
    SIZES,
    DriftingOdometry,
    make_drive,
    scans_at,
)


def part_of(drive, first, last):
    rows = slice(first, last)
    return BlockDrive(drive.scans[rows], drive.times[rows], drive.poses[rows])


def session(drive, folder, *, opened=False, positions=None, each=None):
    """Map a drive into a folder, or continue its map."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(
            lidar_slam, "LidarOdometry", lambda **sizes: DriftingOdometry(drive.poses, HEADING_DRIFT, **sizes)
        )
        slam = LidarSLAM.open(folder) if opened else LidarSLAM(folder=folder, **SIZES)
        for number, cloud in enumerate(drive.clouds()):
            slam.register(cloud, time=float(number), positions=positions)
            if each is not None:
                each(slam)
        slam.finish()
    return slam


def largest_error(slam, drive, first):
    """Of the positions [m], in the world of a true pose."""
    truth = np.linalg.inv(first) @ drive.poses
    return np.linalg.norm(slam.poses[:, :3, 3] - truth[:, :3, 3], axis=1).max()


@pytest.fixture(scope="module")
def first_map(around, tmp_path_factory):
    folder = tmp_path_factory.mktemp("maps") / "first"
    return folder, session(part_of(around, 0, 110), folder)


@pytest.fixture
def folder(first_map, tmp_path):
    """A copy of the first map."""
    shutil.copytree(first_map[0], tmp_path / "map")
    return tmp_path / "map"


def test_an_opened_map_is_the_saved_one(first_map, around):
    saved, opened = first_map[1], LidarSLAM.open(first_map[0])
    assert opened.is_joined and len(opened.poses) == 0 and len(opened.submaps) == len(saved.submaps)
    for a, b in zip(saved.submaps, opened.submaps, strict=True):
        assert np.array_equal(a.T_world_submap, b.T_world_submap) and a.point_count == b.point_count
        assert (a.first_scan, a.last_scan, a.length, a.session) == (b.first_scan, b.last_scan, b.length, 0)
    points = saved.map.points
    assert 0.9 * len(points) < len(opened.map) <= len(points)  # without the open submap
    found = opened.localize(scans_at(around, 30))
    assert found.reliable and np.linalg.norm(found.transformation[:3, 3] - saved.poses[30][:3, 3]) < 0.6
    assert opened.summary.session_count == 2


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["overlap", "opposite"])
def test_a_second_session_joins_the_map(around, folder, kind):
    """The second drive begins elsewhere, in the same direction or in the other."""
    drive = part_of(around, 60, 177) if kind == "overlap" else make_drive(OPPOSITE)
    count, states = len(LidarSLAM.open(folder).submaps), []
    slam = session(drive, folder, opened=True, each=lambda slam: states.append(slam.is_joined))
    assert not any(states[:20]) and all(states[60:]) and slam.is_joined
    assert largest_error(slam, drive, around.poses[0]) < 0.5
    between = [loop for loop in slam.loops if loop.reliable and loop.target < count]
    assert len({loop.source for loop in between}) >= 3
    assert slam.summary.reliable and slam.summary.session_count == 2 and "joined" in str(slam.summary)
    assert {submap.session for submap in slam.submaps} == {0, 1}
    third = LidarSLAM.open(folder)
    assert [s.session for s in third.submaps] == [s.session for s in slam.submaps]
    assert third.is_joined and abs(len(third.map) - len(slam.map)) < 0.02 * len(slam.map)


@pytest.mark.slow
def test_a_session_elsewhere_stays_separate(first_map, around, folder):
    other = make_drive(AROUND[:4], seed=11)
    slam = session(other, folder, opened=True)
    assert not slam.is_joined and not [loop for loop in slam.loops if loop.reliable]
    assert not slam.summary.reliable and "no place" in str(slam.summary.warnings)
    assert np.allclose(slam.poses, slam.odometry.poses, atol=1e-9)  # in its own frame
    alone = LidarSLAM(**SIZES)
    with pytest.raises(ValueError, match="localize"):
        alone.localize(loom.PointCloud([[1.0, 0, 0]]))
    assert len(slam.map) < 1.2 * sum(s.point_count for s in slam.submaps if s.session)
    found = slam.localize(scans_at(other, 30))
    assert found.reliable and slam.submaps[found.submap].session == 1
    covariances = slam.pose_covariances
    assert covariances[0].sigmas.max() < 1e-3 < np.linalg.norm(covariances[-1].sigmas[3:]) < 10
    reopened = LidarSLAM.open(folder)
    assert len(reopened.submaps) == len(slam.submaps)
    assert np.array_equal(reopened.map.points, LidarSLAM.open(first_map[0]).map.points)  # without the separate part


@pytest.mark.slow
def test_equal_blocks_do_not_join_sessions(tmp_path):
    """Each street of the second drive looks like several of the first."""
    drives = [make_drive(crossings, alike=True) for crossings in ([(0, 1), (2, 1)], [(0, 2), (2, 2)])]
    session(drives[0], tmp_path / "map")
    slam = session(drives[1], tmp_path / "map", opened=True)
    assert not slam.is_joined and [loop for loop in slam.loops if loop.status != "rejected"]


@pytest.mark.slow
def test_common_positions_join_sessions(around, tmp_path):
    """Drives without a common place, with GNSS in one frame."""
    first, second = part_of(around, 0, 40), part_of(around, 62, 110)
    rng = np.random.default_rng(0)
    for number, drive in enumerate((first, second)):
        at = drive.poses[:, :3, 3] + rng.normal(0, 0.1, (len(drive.poses), 3))
        readings = PositionReadings(np.arange(len(at)), at, 0.1)
        slam = session(drive, tmp_path / "map", opened=number > 0, positions=readings)
    assert slam.is_joined and largest_error(slam, second, around.poses[0]) < 1.0
    assert slam.summary.positions.used > 0.95 * (len(first.poses) + len(second.poses))
    opened = LidarSLAM.open(tmp_path / "map")
    assert np.array_equal(opened.T_reference_world, slam.T_reference_world)
    assert opened.summary.positions.used == slam.summary.positions.used


def test_a_new_map_does_not_overwrite_one(folder):
    with pytest.raises(loom.FileError, match="has a map already"):
        LidarSLAM(folder=folder, **SIZES)


@pytest.mark.slow
def test_sizes_of_the_map_are_kept(folder):
    slam = LidarSLAM.open(folder, min_range=2.0, deskew=False)
    assert (slam.odometry.max_range, slam.submap_length, slam.odometry.min_range) == (40.0, 10.0, 2.0)
    for name in ("voxel_size", "max_range"):
        with pytest.raises(ValueError, match=f"{name}: expected .* as in the map, got 70"):
            LidarSLAM.open(folder, **{name: 70.0})
    with pytest.raises(TypeError):
        LidarSLAM.open(folder, unknown=1)
    with pytest.raises(loom.FileError, match="none"):
        LidarSLAM.open(folder / "none")


def changed(path, name, change):
    with np.load(path) as stored:
        arrays = dict(stored)
    arrays[name] = change(arrays[name].copy())
    np.savez(path, **arrays)


def at_first(values, value):
    values.flat[0] = value
    return values


CHANGES = {
    "version": lambda v: v + 1, "sizes": lambda v: -v, "scans": lambda v: v[:, ::-1] - 5, "path": lambda v: v * np.nan,
    "point_counts": lambda v: v + 1, "middles": lambda v: v[:, :2], "odometry_poses": lambda v: 2 * v,
    "poses": lambda v: v[1:], "edge_ends": lambda v: v + 1000, "edge_poses": lambda v: at_first(v, np.inf),
    "edge_covariances": lambda v: -v, "prior_nodes": lambda v: np.zeros(3, np.int64), "reference": lambda v: v[0:0, 0],
    "prior_origin": lambda v: v.astype(np.int64),
}  # fmt: skip


@pytest.mark.parametrize("name", CHANGES)
def test_wrong_values_of_a_map_are_errors_that_name_the_file(folder, name):
    changed(folder / "map.npz", name, CHANGES[name])
    with pytest.raises(loom.FileError, match="submap-000000" if name == "point_counts" else "map.npz"):
        LidarSLAM.open(folder)


@pytest.mark.parametrize("name", ["map.npz", "submap-000003.npz"])
def test_truncated_and_missing_files_are_named(folder, name):
    path = folder / name
    body = path.read_bytes()
    for part in (b"", body[: len(body) // 2], body[:-1], b"\0" * len(body)):
        path.write_bytes(part)
        with pytest.raises(loom.FileError, match=name):
            LidarSLAM.open(folder)
    path.unlink()
    with pytest.raises(loom.FileError, match=name):
        LidarSLAM.open(folder)


@pytest.mark.slow
def test_an_interruption_at_any_write_leaves_a_map_that_opens(around, folder, monkeypatch):
    """Ctrl-C while a file is written: the files of the last finished submap are there."""
    known, drive = len(LidarSLAM.open(folder).submaps), part_of(around, 60, 110)
    for module, name in ((lidar_slam, "write_map"), (lidar_slam.PointStore, "add")):
        write = getattr(module, name)
        counts = iter([0, 0, 1])

        def interrupt(*arguments, write=write, counts=counts):
            if next(counts, 1):
                raise KeyboardInterrupt
            write(*arguments)

        with monkeypatch.context() as patch:
            patch.setattr(module, name, interrupt)
            with pytest.raises(KeyboardInterrupt):
                session(drive, folder, opened=True)
        opened = LidarSLAM.open(folder)
        assert len(opened.submaps) == known + 2 and opened.submaps[-1].session == opened.summary.session_count - 2
        known += 2


def test_an_interrupted_write_is_made_up_for(around, tmp_path, monkeypatch):
    """A caught Ctrl-C: the next call writes what is missing."""
    write, is_first = lidar_sessions.write_map, [True]

    def interrupt(*arguments):
        if is_first.pop() if is_first else False:
            raise KeyboardInterrupt
        write(*arguments)

    monkeypatch.setattr(lidar_slam, "write_map", interrupt)
    drive = part_of(around, 0, 24)
    monkeypatch.setattr(
        lidar_slam, "LidarOdometry", lambda **sizes: DriftingOdometry(drive.poses, HEADING_DRIFT, **sizes)
    )
    slam = LidarSLAM(folder=tmp_path / "map", **SIZES)
    for cloud in drive.clouds():
        try:
            slam.register(cloud)
        except KeyboardInterrupt:
            assert not (tmp_path / "map" / "map.npz").exists()
    assert len(LidarSLAM.open(tmp_path / "map").submaps) == len(slam.submaps) == 2
