"""--record: recordings, reports and errors."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import pointloom as loom

from .commands import answer, names_in, refusal, run, unreliable
from .surface_poses import NEAR, VOXEL, bumpy, moved, path_of


@pytest.fixture
def pair(tmp_path, rng) -> tuple[Path, Path]:
    """A surface sampled twice, the second 2 degrees and 4 cm off."""
    paths = tmp_path / "a.ply", tmp_path / "b.ply"
    for path, T in zip(paths, (np.linalg.inv(NEAR), np.eye(4)), strict=True):
        loom.write_point_cloud(path, loom.PointCloud(moved(bumpy(rng), T)))
    return paths


@pytest.fixture
def drive(tmp_path, rng) -> Path:
    """A folder of 3 scans of a room."""
    room = rng.uniform(-8, 8, (8000, 3)) * [1, 1, 0.3]
    room[np.arange(8000), np.arange(8000) % 3] = np.where(rng.random(8000) < 0.5, -1, 1) * 8.0
    folder = tmp_path / "drive"
    folder.mkdir()
    for number, T in enumerate(path_of(3)):
        loom.write_point_cloud(folder / f"{number}.ply", loom.PointCloud(moved(room, np.linalg.inv(T))))
    return folder


def frame_count(path: Path) -> int:
    with Image.open(path) as image:
        return getattr(image, "n_frames", 1)


@pytest.mark.slow
def test_register_records_every_iteration_and_finds_the_same_pose(pair, tmp_path):
    file = tmp_path / "icp.gif"
    words = ["register", *pair, *VOXEL, "--init", "identity"]
    alone = answer(*words)
    report = answer(*words, "--record", file, "-o", tmp_path / "T.txt")
    assert report["transformation"] == alone["transformation"]
    assert report["files"] == [str(tmp_path / "T.txt"), str(file)]
    assert frame_count(file) == report["iterations"] + 3  # three scales, each with its start


def test_register_records_a_search_as_a_start_and_a_result(pair, tmp_path):
    file = tmp_path / "icp.html"
    result = run("register", *pair, *VOXEL, "--record", file)
    assert result.exit_code == 0, result.stderr
    assert str(file) in result.stdout
    text = file.read_text()
    assert "initial poses" in text
    assert "registered: converged" in text
    assert "ICP, voxels of 0.06 m, iteration 1" in text


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
    assert all(
        f'"label":"{label}' in file.read_text() for label in ("scan 0", "scan 1", "scan 2", "the map of 3 scans")
    )


@pytest.mark.slow
@pytest.mark.parametrize("command", ["fuse", "track", "reconstruct"])
def test_commands_of_frames_record_the_camera_and_the_surface(frames, tmp_path, command):
    file, output = tmp_path / "r.html", tmp_path / ("poses.txt" if command == "track" else "mesh.ply")
    result = run(command, frames, "-o", output, "--voxel", 0.08, "--record", file)
    assert result.exit_code in (0, 3), result.stderr
    assert str(file) in result.stdout
    text = file.read_text()
    assert '"camera"' in text
    assert "the surface of" in text


def test_an_unwritable_recording_is_rejected_first(pair, tmp_path):
    assert "does not exist" in refusal("register", *pair, "--record", tmp_path / "no" / "r.gif")
    (tmp_path / "r.gif").write_bytes(b"keep")
    assert "exists already" in refusal("register", *pair, "--record", tmp_path / "r.gif")
    assert (tmp_path / "r.gif").read_bytes() == b"keep"


def test_a_failure_before_the_first_frame_leaves_no_recording(tmp_path):
    loom.write_point_cloud(tmp_path / "empty.ply", loom.PointCloud())
    refusal("register", tmp_path / "empty.ply", tmp_path / "empty.ply", "--record", tmp_path / "r.html")
    assert names_in(tmp_path) == ["empty.ply"]
