"""evaluate: the errors of a trajectory."""

from pathlib import Path

import numpy as np
import pytest

import pointloom as loom
from pointloom.cameras.trajectory import Trajectory, read_trajectory, write_trajectory
from pointloom.io.pictures.image_files import read_color
from pointloom.visualization.render.plots import trajectory_plot

from .commands import answer, refusal, run, unreliable
from .surface_poses import path_of, yaw_pose


@pytest.fixture
def paths(tmp_path) -> tuple[Path, Path]:
    """A trajectory of 40 poses, 4% too long and rotated, and the true one."""
    truth = path_of(40)
    estimate = yaw_pose(30, 1, 2, 3) @ truth
    estimate[:, :3, 3] = 1.04 * (estimate[:, :3, 3] - estimate[0, :3, 3]) + estimate[0, :3, 3]
    files = tmp_path / "poses.txt", tmp_path / "truth.log"
    write_trajectory(files[0], Trajectory(estimate), format="kitti")
    write_trajectory(files[1], Trajectory(truth))
    return files


ALIGNMENTS = {"none": {"align": None}, "first": {"align": "first"}, "se3": {}, "sim3": {"with_scale": True}}


@pytest.mark.parametrize("align", ALIGNMENTS)
def test_evaluate_matches_the_library(paths, align):
    options = ALIGNMENTS[align]
    report = answer("evaluate", *paths, "--alignment", align)
    expected = loom.registration.evaluate_trajectory(read_trajectory(paths[0]), read_trajectory(paths[1]), **options)
    assert (report["align"], report["compared"], report["scale"]) == (align, 40, expected.scale)
    assert report["absolute"]["m"]["rmse"] == expected.absolute_translation.rmse
    assert report["absolute"]["deg"]["max"] == expected.absolute_rotation.max
    assert report["relative"]["m"]["median"] == expected.relative_translation.median
    np.testing.assert_array_equal(report["transformation"], expected.transformation)
    printed = run("evaluate", *paths, "--alignment", align).stdout
    assert f"40 poses, aligned by {align}" in printed
    assert f"ATE       {expected.absolute_translation.rmse:.4g} m rmse" in printed
    assert ("scale 0.961538" in printed) == (align == "sim3")


def test_segments_and_relative_errors_are_printed_if_the_trajectory_is_long_enough(tmp_path):
    poses = np.array([yaw_pose(0, 2 * i, 0, 0) for i in range(120)])
    write_trajectory(tmp_path / "b.txt", Trajectory(poses.copy()), format="kitti")
    poses[:, 0, 3] *= 1.01
    write_trajectory(tmp_path / "a.txt", Trajectory(poses), format="kitti")
    report = answer("evaluate", tmp_path / "a.txt", tmp_path / "b.txt")
    assert [segment["length_m"] for segment in report["segments"]] == [100, 200]
    assert report["segment_percent"] == pytest.approx(1.02, abs=0.02)  # of the first pose beyond each length
    assert "over 100, 200 m" in run("evaluate", tmp_path / "a.txt", tmp_path / "b.txt").stdout
    write_trajectory(tmp_path / "a.log", Trajectory(np.eye(4)[None]))
    assert answer("evaluate", tmp_path / "a.log", tmp_path / "a.log")["relative"]["m"]["rmse"] is None
    assert "RPE       none: too few poses" in run("evaluate", tmp_path / "a.log", tmp_path / "a.log").stdout


def test_a_picture_shows_the_aligned_estimate(paths, tmp_path):
    answer("evaluate", *paths, "--alignment", "sim3", "--picture", tmp_path / "path.png")
    estimate, truth = map(read_trajectory, paths)
    result = loom.registration.evaluate_trajectory(estimate, truth, with_scale=True)
    aligned = estimate.poses[:, :3, 3] @ result.transformation[:3, :3].T + result.transformation[:3, 3]
    title = "poses.txt against truth.log, aligned by sim3"
    expected = trajectory_plot(aligned, truth.poses[:, :3, 3], times=None, title=title)
    np.testing.assert_array_equal(read_color(tmp_path / "path.png"), expected)
    poses = path_of(20)
    write_trajectory(tmp_path / "truth.tum", Trajectory(poses, timestamps=np.arange(20.0)))
    write_trajectory(tmp_path / "part.tum", Trajectory(poses[5:9], timestamps=np.arange(5.0, 9.0)))
    report = answer("evaluate", tmp_path / "part.tum", tmp_path / "truth.tum", "--picture", tmp_path / "part.png")
    assert report["compared"] == 4 and read_color(tmp_path / "part.png").shape == (960, 1280, 3)


def test_unrelated_trajectories_and_an_unwritable_picture_are_errors_before_the_inputs_are_read(paths, tmp_path):
    write_trajectory(tmp_path / "c.txt", Trajectory(path_of(7)), format="kitti")
    refused = refusal("evaluate", paths[0], tmp_path / "c.txt")
    assert f"poses.txt: has 40 poses, and {tmp_path / 'c.txt'} has 7" in refused
    for name, start in (("a.tum", 0.0), ("b.tum", 1e6)):
        write_trajectory(tmp_path / name, Trajectory(path_of(7), timestamps=start + np.arange(7.0)))
    assert "cannot be compared with" in refusal("evaluate", tmp_path / "a.tum", tmp_path / "b.tum")
    missing = tmp_path / "none.txt"  # is read after the picture is checked
    assert "cannot be read" in refusal("evaluate", paths[0], missing)
    assert "expected .png or .webp" in refusal("evaluate", missing, paths[1], "--picture", tmp_path / "a.jpg")
    assert "folder" in refusal("evaluate", missing, paths[1], "--picture", tmp_path / "nowhere" / "a.png")
    (tmp_path / "mine.png").write_text("mine")
    assert "--force" in refusal("evaluate", *paths, "--picture", tmp_path / "mine.png")
    assert (tmp_path / "mine.png").read_text() == "mine"


KITTI_TR = np.array([[0, -1, 0, 0.02], [0, 0, -1, -0.07], [1, 0, 0, -0.27], [0, 0, 0, 1.0]])


def drive(count=400, step=1.0, seed=0, noise=0.0):
    """The trajectory of a steering car, with optional noise on its motions."""
    rng = np.random.default_rng(seed)
    poses = [np.eye(4)]
    for i in range(count - 1):
        move = yaw_pose(np.degrees(0.004 * np.sin(i / 30)), step, 0, 0)
        move[:3, 3] += rng.normal(0, noise, 3)
        poses.append(poses[-1] @ move)
    return np.array(poses)


@pytest.mark.parametrize("Tr", [KITTI_TR, np.linalg.inv(KITTI_TR), yaw_pose(30, 0, 0, 0)])
@pytest.mark.parametrize("noise", [0.0, 0.02])
def test_trajectories_of_two_sensors_are_detected_and_compared_with_their_offset(Tr, noise):
    lidar = drive(noise=noise)
    camera = Trajectory(Tr @ drive() @ np.linalg.inv(Tr))
    error = loom.registration.evaluate_trajectory(Trajectory(lidar), camera)
    assert "--extrinsic" not in str(error.warnings) and "two sensors" in str(error.warnings)
    for extrinsic in (Tr, error.sensor_offset):
        better = loom.registration.evaluate_trajectory(Trajectory(lidar), camera, extrinsic=extrinsic)
        assert better.reliable and better.sensor_offset is None
        assert better.relative_translation.rmse < max(2 * noise, 0.01) < error.relative_translation.rmse


@pytest.mark.parametrize(
    "distort",
    [
        lambda poses: poses,
        lambda poses: yaw_pose(40, 5, 6, 7) @ poses,
        lambda poses: poses @ yaw_pose(0, 0, 0, 0),
        lambda poses: np.array([*poses[:200], *(yaw_pose(20, 3, 0, 0) @ poses[200:])]),
        lambda poses: np.where(np.arange(16).reshape(4, 4) % 4 == 3, poses * [[1.2], [1.2], [1.2], [1]], poses),
        lambda poses: drive(seed=3, noise=0.3),
        lambda poses: np.tile(np.eye(4), (len(poses), 1, 1)),
    ],
    ids=["same", "moved", "itself", "jump", "too long", "noise", "resting"],
)
def test_other_errors_are_not_reported_as_a_second_sensor(distort):
    truth = drive()
    assert loom.registration.evaluate_trajectory(Trajectory(distort(truth)), Trajectory(truth)).reliable


@pytest.mark.parametrize("key", ["Tr:", "Tr_velo_to_cam:", None])
def test_evaluate_accepts_the_extrinsic_of_kitti(tmp_path, key):
    lidar = drive(120)
    files = tmp_path / "lidar.kitti", tmp_path / "camera.kitti"
    for path, poses in zip(files, (lidar, KITTI_TR @ lidar @ np.linalg.inv(KITTI_TR)), strict=True):
        write_trajectory(path, Trajectory(poses))
    warning = unreliable("evaluate", *files)["warnings"][0]
    assert "two sensors" in warning and "extrinsic" in warning
    calib = tmp_path / "calib.txt"
    if key is None:
        np.savetxt(calib, KITTI_TR)
    else:
        row = " ".join(map(str, KITTI_TR[:3].ravel()))
        calib.write_text(f"P0: 1 0 0 0 0 1 0 0 0 0 1 0\n{key} {row}\n")
    report = answer("evaluate", *files, "--extrinsic", calib, "--picture", tmp_path / "a.png")
    assert report["segment_percent"] == pytest.approx(0, abs=1e-6) and report["reliable"]
