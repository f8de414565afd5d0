"""LiDAR SLAM: loops of drives around blocks of houses close, places that look alike do not, and states survive."""

import dataclasses
import itertools

import numpy as np
import pytest

import pointloom as loom
from pointloom.registration import LidarOdometry, LidarSLAM
from pointloom.registration.lidar import lidar_slam
from pointloom.registration.lidar.deskewing import point_times
from pointloom.registration.lidar.lidar_steps import FIRST_SCAN, OdometryStep
from pointloom.registration.lidar.raw_scan import RawScan
from pointloom.registration.pose_errors import PoseCovariance
from pointloom.registration.rigid import pose_of
from tests.registration.block_drives import drive_along, make_blocks, unit

BLOCK, STREET = (36.0, 24.0), 12.0  # [m]
SIZES = {"max_range": 40.0, "min_range": 1.5, "submap_length": 10.0}
AROUND = [(1, 1), (2, 1), (2, 2), (1, 2), (1, 1), (2, 1)]  # crossings; the last street is the first one again
OPPOSITE = [(1, 1), (2, 1), (2, 2), (1, 2), (1, 0), (2, 0), (2, 1), (1, 1)]  # likewise, in the other direction


def lane_along(crossings, lane=1.5):
    """Points of the right lane along streets between crossings (column, row)."""
    P = np.array([[i * (BLOCK[0] + STREET), j * (BLOCK[1] + STREET)] for i, j in crossings]) - STREET / 2
    points = []
    for k in range(len(P)):
        ways = [unit(P[b] - P[a]) for a, b in ((k - 1, k), (k, k + 1)) if a >= 0 and b < len(P)]
        points.append(P[k] + lane * sum(np.array([y, -x]) for x, y in ways))
    points[0] = points[0] + 10 * unit(P[1] - P[0])
    return np.array(points)


def make_drive(crossings, alike=False, seed=3):
    boxes = make_blocks((3, 3), BLOCK, STREET, seed, alike)
    return drive_along(boxes, lane_along(crossings), speed=12.0, azimuths=360, max_range=40.0)


class DriftingOdometry(LidarOdometry):
    """Known poses with a drift per scan, and the covariance of such a drift, in place of the estimated ones."""

    def __init__(self, poses, drift, sigma=None, **options):
        super().__init__(**options)
        motions = np.linalg.inv(poses[:-1]) @ poses[1:]
        self.path, twist = [np.eye(4)], np.asarray(drift, float)
        for motion in motions:
            self.path.append(self.path[-1] @ motion @ pose_of(twist))
        self.sigma = np.abs(twist) if sigma is None else np.asarray(sigma, float)
        self.raw, self.known, self.covariance = None, [], PoseCovariance(np.zeros((6, 6)), np.zeros(3))

    @property
    def steps(self):
        return self.known

    @property
    def last_scan(self):
        return self.raw

    @property
    def last_motion(self):
        return np.linalg.inv(self.path[len(self.known) - 2]) @ self.path[len(self.known) - 1]

    def register(self, scan, timestamps=None, *, prior=None, imu=None, time=None):
        index = len(self.known)
        pose = self.path[index]
        if index:
            matrix = self.covariance.about(pose[:3, 3]).matrix + np.diag(self.sigma**2) * index**0.0
            self.covariance = PoseCovariance(matrix, pose[:3, 3])
        status = "converged" if index else FIRST_SCAN
        step = OdometryStep(index, pose, 1.0, 100, 1.0, 0.1, index and 5, True, False, status)
        self.known.append(dataclasses.replace(step, covariance=self.covariance))
        self.device, self.raw = scan.device, RawScan(scan.arrays["points"], scan.origin, point_times(scan, timestamps))
        return pose


def slam_of(monkeypatch, drive, drift, sigma=None, **options):
    def make(**sizes):
        return DriftingOdometry(drive.poses, drift, sigma, **sizes)

    monkeypatch.setattr(lidar_slam, "LidarOdometry", make)
    return LidarSLAM(**SIZES, **options)


def truth_of(drive):
    return np.linalg.inv(drive.poses[0]) @ drive.poses


def errors_of(slam, drive):
    """Position errors [m] of the odometry and of the corrected poses, [n] each."""
    truth = truth_of(drive)[: len(slam.poses), :3, 3]
    return [np.linalg.norm(poses[:, :3, 3] - truth, axis=1) for poses in (slam.odometry.poses, slam.poses)]


def false_loops(slam, drive, limit=0.6):
    """Accepted loops whose pose is off by more than a limit [m]."""
    truth, submaps = truth_of(drive), slam.submaps
    wrong = []
    for loop in slam.loops:
        a, b = (truth[submaps[k].first_scan] for k in (loop.target, loop.source))
        if loop.reliable and np.linalg.norm(loop.transformation[:3, 3] - (np.linalg.inv(a) @ b)[:3, 3]) > limit:
            wrong.append(loop)
    return wrong


HEADING_DRIFT = [0, 0, 0.0004, 0, 0.002, 0.002]  # [rad, m] a scan


@pytest.fixture(scope="module")
def mapped(around):
    with pytest.MonkeyPatch.context() as patch:
        slam = slam_of(patch, around, HEADING_DRIFT)
        for cloud in around.clouds():
            slam.register(cloud)
    return slam


def test_a_loop_around_a_block_removes_most_of_the_drift(mapped, around):
    before, after = errors_of(mapped, around)
    accepted = [loop for loop in mapped.loops if loop.reliable]
    assert len(accepted) >= 3 and not false_loops(mapped, around)
    assert before[-1] > 1.5 and after[-1] < 0.4
    assert np.sqrt((after**2).mean()) < 0.5 * np.sqrt((before**2).mean())
    assert all(loop.source - loop.target > 5 and loop.score > 0.5 for loop in accepted)


@pytest.mark.slow
def test_the_map_of_a_loop_is_not_doubled(mapped, around):
    """Walls along the street that was driven twice: thin in the map."""
    walls = make_blocks((3, 3), BLOCK, STREET, 3)
    points = mapped.map.points @ around.poses[0][:3, :3].T + around.poses[0][:3, 3]
    low, high = walls
    start, end = lane_along(AROUND)[:2]
    near = points[(np.abs(points[:, 1] - start[1]) < 12) & (points[:, 0] > start[0]) & (points[:, 0] < end[0] - 8)]
    near = near[near[:, 2] > 0.5]
    outside = np.maximum(low[None] - near[:, None], near[:, None] - high[None]).max(axis=2)
    assert len(near) > 500
    assert np.percentile(np.abs(outside).min(axis=1), 90) < 0.35


def test_covariances_shrink_where_a_loop_closed(mapped):
    odometry, corrected = mapped.odometry.pose_covariances, mapped.pose_covariances
    assert len(corrected) == len(mapped.poses)
    assert np.linalg.norm(corrected[-1].sigmas[3:]) < np.linalg.norm(odometry[-1].sigmas[3:])


def test_summary_counts_submaps_and_loops(mapped):
    summary = mapped.summary
    assert summary.submap_count == len(mapped.submaps) and len(summary.loops) >= 3
    assert summary.reliable and summary.to_dict()["reliable"] and "loops" in str(summary)
    assert summary.max_correction > 0.5


def test_submaps_are_small_and_cover_all_scans(mapped):
    submaps = mapped.submaps
    assert [s.index for s in submaps] == list(range(len(submaps)))
    assert submaps[0].first_scan == 0
    assert all(b.first_scan == a.last_scan + 1 for a, b in itertools.pairwise(submaps))
    assert all(10.0 <= s.length < 14.0 and 6 * s.point_count < 200_000 for s in submaps)
    assert len(submaps[2].cloud) == submaps[2].point_count


@pytest.mark.slow
def test_a_return_in_the_opposite_lane_is_found(monkeypatch):
    drive = make_drive(OPPOSITE)
    slam = slam_of(monkeypatch, drive, HEADING_DRIFT)
    for cloud in drive.clouds():
        slam.register(cloud)
    truth, submaps = truth_of(drive), slam.submaps
    headings = []
    for loop in slam.loops:
        if loop.reliable:
            a, b = (truth[submaps[k].first_scan] for k in (loop.target, loop.source))
            headings.append((np.linalg.inv(a) @ b)[0, 0])
    assert min(headings, default=1.0) < -0.95 and not false_loops(slam, drive)
    before, after = errors_of(slam, drive)
    assert after[-1] < 0.3 * before[-1]


@pytest.mark.slow
def test_blocks_that_look_alike_give_no_false_loop(monkeypatch):
    """All blocks are equal, and the path never returns: each pair of streets is an alternative."""
    drive = make_drive([(0, 1), (2, 1), (2, 2)], alike=True)
    slam = slam_of(monkeypatch, drive, HEADING_DRIFT)
    for cloud in drive.clouds():
        slam.register(cloud)
    assert not [loop for loop in slam.loops if loop.reliable]
    assert [loop for loop in slam.loops if loop.status == "waiting" and loop.score > 0.5]
    assert slam.summary.notes and np.allclose(slam.poses, slam.odometry.poses, atol=1e-9)


@pytest.mark.slow
def test_an_unknown_drift_needs_loops_that_agree(monkeypatch, around):
    """A drift beyond the covariances: the first loops wait, later ones confirm them."""
    slam = slam_of(monkeypatch, around, [0, 0, 0.0004, 0, 0.02, 0.0], sigma=[1e-5] * 3 + [1e-4] * 3)
    states = []
    for cloud in around.clouds():
        slam.register(cloud)
        states.append({loop.status for loop in slam.loops} - {"rejected"})
    assert {"waiting"} in states and not false_loops(slam, around)
    before, after = errors_of(slam, around)
    assert after[-1] < 0.3 * before[-1]


def scans_at(drive, index, count=6):
    """Several scans in the sensor's frame of the first: one alone has too few beams for surfaces."""
    parts, clouds, poses = [], drive.clouds(), drive.poses
    for k in range(index, index + count):
        scan = loom.registration.deskew_point_cloud(clouds[k], np.linalg.inv(poses[k - 1]) @ poses[k])
        parts.append(scan.transform(np.linalg.inv(poses[index]) @ poses[k]).points)
    return loom.PointCloud(np.concatenate(parts))


@pytest.mark.slow
def test_localize_finds_scans_at_any_heading(mapped, around):
    truth = truth_of(around)
    for index, angle in ((30, 2.0), (75, -1.0)):
        turn = np.eye(4)
        turn[:2, :2] = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
        found = mapped.localize(scans_at(around, index).transform(turn))
        assert found.reliable, found.warnings
        assert np.linalg.norm(found.transformation[:3, 3] - truth[index][:3, 3]) < 0.6
        assert found.to_dict()["reliable"] and "score" in str(found)


@pytest.mark.slow
def test_localize_rejects_another_place(mapped):
    other = make_drive([(1, 1), (2, 1)], seed=11)
    found = mapped.localize(scans_at(other, 20))
    assert not found.reliable and found.warnings


@pytest.mark.slow
def test_submaps_on_disk_give_the_same_result(monkeypatch, around, mapped, tmp_path):
    slam = slam_of(monkeypatch, around, HEADING_DRIFT, folder=tmp_path / "map")
    for cloud in around.clouds():
        slam.register(cloud)
    assert np.array_equal(slam.poses, mapped.poses)
    assert np.array_equal(slam.map.points, mapped.map.points)
    assert len(list((tmp_path / "map").glob("submap-*.npz"))) == len(slam.submaps)
    (tmp_path / "map" / "submap-000000.npz").write_bytes(b"damaged")
    with pytest.raises(loom.FileError, match="submap-000000"):
        for submap in slam.submaps:
            submap.cloud  # noqa: B018


@pytest.mark.slow
def test_an_interrupted_search_continues_with_the_next_call(monkeypatch, around, mapped):
    slam = slam_of(monkeypatch, around, HEADING_DRIFT)
    find, interrupted = lidar_slam.find_loops, []

    def interrupt(search, graph, source):
        if source not in interrupted:
            interrupted.append(source)
            raise KeyboardInterrupt
        return find(search, graph, source)

    monkeypatch.setattr(lidar_slam, "find_loops", interrupt)
    for number, cloud in enumerate(around.clouds()):
        try:
            slam.register(cloud)
        except KeyboardInterrupt:
            assert len(slam.odometry.steps) == number + 1  # the scan is in
    assert len(interrupted) == len(slam.submaps)
    assert np.array_equal(slam.poses, mapped.poses)


@pytest.mark.slow
def test_without_loops_poses_are_those_of_the_odometry():
    drive = make_drive([(1, 1), (2, 1)])
    slam, odometry = LidarSLAM(**SIZES), LidarOdometry(max_range=40.0, min_range=1.5)
    for cloud in drive.clouds()[:12]:
        T, T_odometry = slam.register(cloud), odometry.register(cloud)
        assert np.array_equal(T, T_odometry)
    assert np.array_equal(slam.poses, odometry.poses)
    assert len(slam.map) > 1000 and slam.submaps and "12 scans" in repr(slam)


@pytest.mark.slow
def test_finish_searches_the_loops_of_the_open_submap(monkeypatch, around, mapped):
    slam = slam_of(monkeypatch, around, HEADING_DRIFT)
    count = mapped.submaps[-1].first_scan + 7  # 8.4 m of 10
    for cloud in around.clouds()[:count]:
        slam.register(cloud)
    before = len(slam.submaps), len(slam.loops)
    slam.finish()
    assert (len(slam.submaps), slam.submaps[-1].last_scan) == (before[0] + 1, count - 1)
    assert len(slam.loops) > before[1]
    slam.finish()
    slam.register(around.clouds()[count])
    assert len(slam.submaps) == before[0] + 1 and len(slam.poses) == count + 1


def test_wrong_arguments():
    for options in ({"submap_length": 0}, {"submap_length": np.nan}, {"max_range": -1}):
        with pytest.raises(ValueError, match=next(iter(options))):
            LidarSLAM(**options)
    with pytest.raises(TypeError):
        LidarSLAM(unknown=1)
    slam = LidarSLAM(**SIZES)
    with pytest.raises(TypeError, match="scan"):
        slam.register(np.zeros((3, 3)))
    with pytest.raises(ValueError, match="localize"):
        slam.localize(loom.PointCloud([[1.0, 0, 0]]))
    with pytest.raises(ValueError, match="timestamps"):
        slam.register(loom.PointCloud([[10.0, 0, 0]]), [0.0, 1.0])
    assert len(slam.poses) == 0 and len(slam.map) == 0 and not slam.summary.reliable
    with pytest.raises(TypeError, match="copied"):
        __import__("copy").deepcopy(slam)


@pytest.mark.slow
def test_a_viewer_shows_the_submaps_the_path_and_the_loops(monkeypatch, around):
    slam = slam_of(monkeypatch, around, HEADING_DRIFT)
    changes, scans = [], around.clouds()
    with loom.Viewer(port=0) as viewer:
        for call in ("add", "set_pose", "update"):
            edit = getattr(viewer.edits, call)
            monkeypatch.setattr(
                viewer.edits, call, lambda *given, do=edit, **style: changes.append(given) or do(*given, **style)
            )
        with viewer.follow(slam):
            for scan in scans:
                count = len(changes), len(slam.submaps)
                slam.register(scan)
                assert len(changes) == count[0] or len(slam.submaps) > count[1]
        names = [f"map/{k}" for k in range(len(slam.submaps))]
        assert set(viewer.items) == {*names, "path", "loops"}
        for name, submap in zip(names, slam.submaps, strict=True):
            pose = np.eye(4) if viewer.items[name].pose is None else viewer.items[name].pose
            np.testing.assert_array_equal(pose, submap.T_world_submap)
            assert len(viewer.items[name].cloud) == min(submap.point_count, 20_000)
        np.testing.assert_array_equal(viewer.items["path"].geometry.points[0], slam.poses[0, :3, 3])
        assert len(viewer.items["loops"].geometry.lines) == sum(loop.reliable for loop in slam.loops)
        adds = [given[0] for given in changes if given[0].startswith("map/") and isinstance(given[1], loom.PointCloud)]
        assert adds == names  # the points of a submap are sent once
        with pytest.raises(TypeError, match=r"^slam: "):
            viewer.follow(slam.odometry)


def test_closing_the_viewer_does_not_stop_the_mapping(monkeypatch, around):
    slam = slam_of(monkeypatch, around, HEADING_DRIFT)
    with loom.Viewer(port=0) as viewer, viewer.follow(slam):
        for scan in around.clouds()[:40]:
            slam.register(scan)
            if len(slam.submaps) == 1:
                viewer.close()
    assert len(slam.poses) == 40 and len(slam.submaps) > 1
