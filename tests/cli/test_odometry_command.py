"""odometry: the trajectory, its errors, and invalid calls."""

import dataclasses
import io
import sys

import numpy as np
import pytest

import pointloom as loom
from pointloom.cameras.trajectory import Trajectory, read_trajectory, write_trajectory
from pointloom.cli.shell import console
from pointloom.registration import LidarOdometry

from .commands import answer, names_in, refusal, run, unreliable
from .surface_poses import path_of

INDOORS = ["--max-range", 30, "--min-range", 0.5]


def test_odometry_writes_the_trajectory_and_its_errors(drive, tmp_path, device):
    poses, truth = tmp_path / "poses.txt", tmp_path / "truth.tum"
    write_trajectory(truth, Trajectory(path_of(5)))
    report = answer("odometry", drive, "-o", poses, *INDOORS, "--truth", truth, "--device", device)
    trajectory = read_trajectory(poses)
    np.testing.assert_allclose(trajectory.poses, path_of(5), atol=0.02)
    expected = loom.registration.run_odometry(drive, max_range=30, min_range=0.5)
    np.testing.assert_allclose(trajectory.poses, expected.poses, atol=1e-5)
    assert (report["scans"], report["points"], report["predicted"]) == (5, 25000, [])
    assert report["errors"]["absolute"]["m"]["rmse"] < 0.01
    error = loom.registration.evaluate_trajectory(trajectory, Trajectory(path_of(5)))
    assert report["errors"]["relative"]["m"]["rmse"] == pytest.approx(error.relative_translation.rmse, rel=1e-6)
    assert report["files"] == [str(poses)]


@pytest.mark.slow
def test_odometry_writes_each_format_and_a_summary(drive, tmp_path):
    result = run("odometry", drive, "-o", tmp_path / "poses.txt", *INDOORS)
    assert result.exit_code == 0, result.stderr
    assert "5, 25,000 points, " in result.stdout and "scans/s" in result.stdout and "ATE" not in result.stdout
    tum = read_trajectory(tmp_path / "poses.txt")
    assert tum.timestamps.tolist() == [0, 1, 2, 3, 4]
    words = ["odometry", drive, *INDOORS, "-o"]
    for name, form in (("poses.kitti", "kitti"), ("00.txt", "kitti"), ("a.log", "log")):
        more = ["--format", "kitti"] if name == "00.txt" else []
        assert answer(*words, tmp_path / name, *more)["format"] == form
    assert (tmp_path / "00.txt").read_bytes() == (tmp_path / "poses.kitti").read_bytes()
    for name in ("poses.kitti", "a.log"):
        np.testing.assert_allclose(read_trajectory(tmp_path / name).poses, tum.poses, atol=1e-12)


def test_a_scan_that_does_not_overlap_is_unreliable(drive, tmp_path, rng):
    stray = np.column_stack([rng.uniform(20, 25, (500, 3)), np.ones(500)]).astype(np.float32)
    stray.tofile(drive / "scan10.bin")
    report = unreliable("odometry", drive, "-o", tmp_path / "poses.txt", "--max-range", 50, "--min-range", 0.5)
    assert report["predicted"] == [2] and "1 of 5 scans" in str(report["warnings"])
    assert "broken at scan 2" in str(report["warnings"]) and len(read_trajectory(tmp_path / "poses.txt")) == 5
    result = run("odometry", drive, "-o", tmp_path / "b.txt", "--max-range", 50, "--min-range", 0.5)
    assert "predicted  1: scan 2" in result.stdout


@pytest.mark.slow
def test_lost_odometry_is_unreliable_and_names_the_scans(real_file, tmp_path):
    folder = tmp_path / "submaps"
    folder.mkdir()
    for number in range(5):  # submaps of a drive, 3 to 12 m apart
        points = np.fromfile(real_file(f"reg-gtsam-points/kitti_07_dump/{number:06}/points.bin"), "<f4")
        loom.write_point_cloud(folder / f"{number}.ply", loom.PointCloud(points.reshape(-1, 3)[::3]))
    report = unreliable("odometry", folder, "-o", tmp_path / "a.txt", "--device", "cpu")
    assert report["strayed"][0] == 3  # the first two are rotated by 32 and 49 degrees, and registered
    assert "scans do not match the map of earlier scans (scan 3" in str(report["warnings"])
    assert "probably lost from scan 3 on" in str(report["warnings"])


def test_scans_that_do_not_converge_are_named(drive, tmp_path, monkeypatch):
    steps = iter([False, True, True, False, True, True])

    def not_converged(self, *args, **kwargs):
        step = match(self, *args, **kwargs)
        return dataclasses.replace(step, status="max_iteration", converged=False) if next(steps) else step

    match = LidarOdometry._match
    monkeypatch.setattr(LidarOdometry, "_match", not_converged)
    report = unreliable("odometry", drive, "-o", tmp_path / "a.txt", *INDOORS)
    assert report["unsettled"] == [1, 2, 4]
    assert report["warnings"] == ["3 of 5 scans did not converge on the map (scan 1-2, 4)"]
    steps = iter([False, False, True, False, False])
    result = run("odometry", drive, "-o", tmp_path / "b.txt", *INDOORS)
    assert result.exit_code == 3  # a quarter of four


def test_scans_out_of_range_write_nothing(drive, tmp_path):
    truth = tmp_path / "truth.txt"
    write_trajectory(truth, Trajectory(path_of(5)), format="kitti")
    report = unreliable("odometry", drive, "-o", tmp_path / "a.txt", "--min-range", 90, "--truth", truth)
    assert "no scan has points in range" in str(report["warnings"])
    assert (report["files"], report["errors"]) == ([], None) and not (tmp_path / "a.txt").exists()


def test_odometry_rejects_invalid_calls_first(drive, tmp_path):
    poses, truth = tmp_path / "poses.txt", tmp_path / "truth.txt"
    assert "poses are not written to .json" in refusal("odometry", drive, "-o", tmp_path / "a.json")
    refused = refusal("odometry", drive, "-o", tmp_path / "a.kitti", "--format", "tum")
    assert "poses as tum are not written to .kitti" in refused
    assert "does not exist" in refusal("odometry", tmp_path / "none", "-o", poses)
    write_trajectory(truth, Trajectory(path_of(4)), format="kitti")
    assert "expected 5 poses, one per scan of " in refusal("odometry", drive, "-o", poses, "--truth", truth)
    poses.write_text("kept")
    assert "exists already" in refusal("odometry", drive, "-o", poses)
    for path in sorted(drive.iterdir())[1:]:
        path.unlink()
    assert "expected at least two scans, got scan10.bin only" in refusal("odometry", drive, "-o", tmp_path / "a.txt")
    (drive / "scan9.bin").write_bytes(b"12345")
    assert "scan9.bin (byte 0): 5 bytes" in refusal("odometry", drive, "-o", tmp_path / "a.txt")
    assert names_in(tmp_path) == ["drive", "poses.txt", "truth.txt"]


def test_progress_reports_the_rate(monkeypatch, capsys):
    monkeypatch.setattr(console, "LINE_INTERVAL", 0.0)
    with console.Progress(rates=True) as progress:
        progress("scans", 3, 10)
    assert "scans: 3 of 10 " in (line := capsys.readouterr().err) and line.endswith(" scans/s\n")
    screen = io.StringIO()
    screen.isatty = lambda: True
    monkeypatch.setattr(sys, "stderr", screen)
    monkeypatch.setenv("TERM", "xterm")
    with console.Progress(rates=True) as progress:
        progress("scans", 3, 10)
        progress("scans", 10, 10)
    assert "10/10" in screen.getvalue() and " scans/s" in screen.getvalue()
