"""--record: recordings, reports and errors."""

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import pointloom as loom

from .commands import answer, names_in, refusal, run, unreliable
from .surface_poses import VOXEL, bumpy


def frame_count(path: Path) -> int:
    with Image.open(path) as image:
        return getattr(image, "n_frames", 1)


@pytest.mark.slow
def test_register_records_every_iteration_and_finds_the_same_pose(near, tmp_path):
    file = tmp_path / "icp.gif"
    words = ["register", *near, *VOXEL, "--init", "identity"]
    alone = answer(*words)
    report = answer(*words, "--record", file, "-o", tmp_path / "T.txt")
    assert report["transformation"] == alone["transformation"]
    assert report["files"] == [str(tmp_path / "T.txt"), str(file)]
    assert frame_count(file) == report["iterations"] + 3  # three scales, each with its start


def test_register_records_a_search_as_a_start_and_a_result(near, tmp_path):
    file = tmp_path / "icp.html"
    result = run("register", *near, *VOXEL, "--record", file)
    assert result.exit_code == 0, result.stderr
    assert str(file) in result.stdout
    text = file.read_text()
    assert "initial poses" in text and "registered: converged" in text and "ICP, voxels of 0.06 m, iteration 1" in text


@pytest.mark.slow
def test_an_unreliable_result_is_recorded_too(tmp_path, rng):
    for k, offset in enumerate((0, 50)):
        loom.write_point_cloud(tmp_path / f"{k}.ply", loom.PointCloud(bumpy(rng) + np.array([offset, 0, 0])))
    words = [tmp_path / "0.ply", tmp_path / "1.ply", *VOXEL, "--init", "identity", "--record", tmp_path / "r.html"]
    assert unreliable("register", *words)["files"] == [str(tmp_path / "r.html")]


def test_odometry_records_scan_by_scan(drive, tmp_path):
    file, poses = tmp_path / "drive.html", tmp_path / "poses.txt"
    report = answer("odometry", drive, "-o", poses, "--max-range", 30, "--min-range", 0.5, "--record", file)
    assert report["files"] == [str(poses), str(file)]
    assert all(f'"label":"{one}' in file.read_text() for one in ("scan 0", "scan 1", "scan 4", "the map of 5 scans"))


@pytest.mark.slow
@pytest.mark.parametrize("command", ["fuse", "track", "reconstruct"])
def test_commands_of_frames_record_the_camera_and_the_surface(frames, tmp_path, command):
    file, output = tmp_path / "r.html", tmp_path / ("poses.txt" if command == "track" else "mesh.ply")
    result = run(command, frames, "-o", output, "--voxel", 0.08, "--record", file)
    assert result.exit_code in (0, 3), result.stderr
    assert str(file) in result.stdout
    text = file.read_text()
    assert '"camera"' in text and "the surface of" in text


def test_an_unwritable_recording_is_rejected_first(near, tmp_path):
    assert "does not exist" in refusal("register", *near, "--record", tmp_path / "no" / "r.gif")
    (tmp_path / "r.gif").write_bytes(b"keep")
    assert "exists already" in refusal("register", *near, "--record", tmp_path / "r.gif")
    assert (tmp_path / "r.gif").read_bytes() == b"keep"


def test_a_failure_before_the_first_frame_leaves_no_recording(tmp_path):
    loom.write_point_cloud(tmp_path / "empty.ply", loom.PointCloud())
    refusal("register", tmp_path / "empty.ply", tmp_path / "empty.ply", "--record", tmp_path / "r.html")
    assert names_in(tmp_path) == ["empty.ply"]
