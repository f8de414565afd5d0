"""Odometry with empty scans, wrong arguments, folders and files."""

from contextlib import nullcontext

import numpy as np
import pytest

import pointloom as loom
from pointloom.cameras.trajectory import read_trajectory, write_trajectory
from pointloom.io.points.scan_files import list_scans
from pointloom.registration import LidarOdometry, run_odometry
from pointloom.registration.lidar.lidar_runs import iterate_odometry

from .drives import clouds, follow, truth_of


def wall(device, z=0.0, count=40):
    rows = [[10, 0.5 * i, 0.5 * j + z] for i in range(-count // 2, count // 2) for j in range(count // 2)]
    return loom.PointCloud(np.array(rows, float), device=device)


@pytest.mark.parametrize("what", ["empty", "near", "far", "nan"])
def test_an_empty_scan_gets_the_predicted_pose(device, fast_drive, what):
    points = {"empty": np.zeros((0, 3)), "near": np.full((9, 3), 0.1), "far": np.full((9, 3), 400.0)}
    bad = loom.PointCloud(points.get(what, np.full((9, 3), np.nan)), device=device)
    odometry = follow(fast_drive, device, 4)
    before = odometry.poses
    T = odometry.register(bad)
    np.testing.assert_allclose(T, before[-1] @ np.linalg.inv(before[-2]) @ before[-1], atol=1e-12)
    step = odometry.steps[-1]
    assert (step.status, step.is_predicted, step.converged, step.inliers) == ("no points in range", True, False, 0)
    assert step.warnings == ("the pose is a prediction: no points in range",) and not step.to_dict()["reliable"]
    assert odometry.summary.predicted == (4,)
    next_scan = clouds(fast_drive, device)[5]
    gap = odometry.register(next_scan)[:3, 3] - truth_of(fast_drive).poses[5, :3, 3]
    assert not odometry.steps[-1].is_predicted and np.linalg.norm(gap) < 0.3


def test_the_first_nonempty_scan_starts_the_map(device):
    odometry = LidarOdometry()
    for cloud in (loom.PointCloud(device=device), loom.PointCloud(device=device), wall(device), wall(device)):
        odometry.register(cloud)
    assert [step.status for step in odometry.steps] == ["no points in range"] * 2 + ["first scan", "converged"]
    np.testing.assert_allclose(odometry.poses, np.tile(np.eye(4), (4, 1, 1)), atol=1e-4)


def test_a_distant_scan_is_reported_and_added_to_the_map(device):
    odometry = LidarOdometry()
    for z in (0.0, 0.0, 60.0, 60.0):
        odometry.register(wall(device, z))
    assert [step.status for step in odometry.steps] == ["first scan", "converged", "no overlap", "converged"]
    assert odometry.summary.predicted == (2,)
    np.testing.assert_allclose(odometry.poses[2:], odometry.poses[1:2].repeat(2, axis=0), atol=1e-3)


def test_times_can_have_any_unit_and_start(device, fast_drive):
    seconds, other = LidarOdometry(), LidarOdometry()
    for cloud in clouds(fast_drive, device, 4):
        seconds.register(cloud)
        other.register(cloud, (cloud["time"] * 1e9).astype(np.int64) + 1_700_000_000_000_000_000)
    np.testing.assert_allclose(seconds.poses, other.poses, atol=1e-4)


def test_one_common_time_means_no_motion(device, fast_drive):
    still, plain = LidarOdometry(), LidarOdometry(deskew=False)
    for points in fast_drive.scans[:3]:
        with pytest.warns(UserWarning, match=r"^timestamps: ") if not still.steps else nullcontext():
            still.register(loom.PointCloud(points, device=device), np.full(len(points), 7.0))
        plain.register(loom.PointCloud(points, device=device))
    np.testing.assert_allclose(still.poses, plain.poses, atol=1e-3)


def test_invalid_scans_are_rejected_and_leave_the_odometry_unchanged(device, fast_drive):
    odometry = follow(fast_drive, device, 2)
    cloud = clouds(fast_drive, device, 1)[0]
    with pytest.raises(
        ValueError, match=rf"timestamps: expected shape \[{len(cloud)}\], one for each point, got \[3\]"
    ):
        odometry.register(cloud, [0.0, 0.5, 1.0])
    with pytest.raises(TypeError, match="scan:"):
        odometry.register(cloud.points)
    cloud["time"] = np.zeros((len(cloud), 2))
    with pytest.raises(ValueError, match="time:"):
        odometry.register(cloud)
    assert len(odometry.steps) == 2
    np.testing.assert_array_equal(odometry.poses, follow(fast_drive, device, 2).poses)


def test_a_folder_of_kitti_scans_is_read_in_natural_order(device, fast_drive, tmp_path):
    for k in (10, 2, 1, 9, 0, 3, 4, 5, 6, 7, 8):
        rows = np.column_stack([fast_drive.scans[k], np.full(len(fast_drive.scans[k]), 0.5)]).astype("<f4")
        rows.tofile(tmp_path / f"scan{k}.bin")
    assert [path.name for path in list_scans(tmp_path)] == [f"scan{k}.bin" for k in range(11)]
    seen = []
    path = run_odometry(tmp_path, timestamps=np.arange(11) / 10, progress=seen.append, device=device)
    direct = run_odometry([loom.PointCloud(points, device=device) for points in fast_drive.scans[:11]])
    np.testing.assert_array_equal(path.poses, direct.poses)
    assert [step.index for step in seen] == list(range(11)) and direct.timestamps is None
    for format, suffix in (("kitti", ".txt"), ("tum", ".tum")):
        write_trajectory(tmp_path / f"path{suffix}", path, format=format)
        np.testing.assert_allclose(read_trajectory(tmp_path / f"path{suffix}").poses, path.poses, atol=1e-12)
    assert read_trajectory(tmp_path / "path.tum").timestamps.tolist() == (np.arange(11) / 10).tolist()


def test_files_preserve_their_times(device, fast_drive, tmp_path):
    for k, cloud in enumerate(clouds(fast_drive, device, 4)):
        loom.write_point_cloud(tmp_path / f"{k}.ply", cloud)
    steps = list(iterate_odometry(sorted(tmp_path.glob("*.ply")), device=device))
    np.testing.assert_array_equal([step.pose for step in steps], follow(fast_drive, device, 4).poses)
