"""Trajectories: round trips of every format, agreement with Open3D, and errors with line numbers."""

import json

import numpy as np
import pytest

from pointloom.cameras.camera import PinholeCameraIntrinsic
from pointloom.cameras.pose_text import read_pose
from pointloom.cameras.trajectory import Trajectory, read_trajectory, write_trajectory
from pointloom.core.errors import FileError

CAMERA = PinholeCameraIntrinsic.prime_sense_default()
FORMATS = [("tum", "t.txt"), ("kitti", "t.txt"), *((name, f"t.{name}") for name in ("log", "tum", "kitti", "json"))]


def rotations(generator, count):
    """Random rotations, including rotations by 180 degrees, for which a quaternion has w = 0."""
    q = generator.normal(size=(count, 4))
    q[:3] = [[1, 0, 0, 0], [0, 1, 0, 1e-9], [0.6, 0.8, 0, 0]]
    q /= np.linalg.norm(q, axis=1, keepdims=True)
    R = []
    for vx, vy, vz, w in q:
        K = np.array([[0, -vz, vy], [vz, 0, -vx], [-vy, vx, 0]])
        R.append(np.eye(3) + 2 * w * K + 2 * K @ K)
    return np.array(R)


@pytest.fixture
def trajectory() -> Trajectory:
    generator = np.random.default_rng(0)
    poses = np.tile(np.eye(4), (12, 1, 1))
    poses[:, :3, :3] = rotations(generator, 12)
    poses[:, :3, 3] = generator.normal(size=(12, 3)) * (1, 10, 100)
    ids = np.stack([np.arange(12) * 3, np.arange(12), np.full(12, 99)], axis=1)
    return Trajectory(poses, timestamps=1305031102.175304 + np.arange(12) / 30, ids=ids)


def log_text(pose=None, ids="0 0 1") -> str:
    rows = np.eye(4) if pose is None else pose
    return f"{ids}\n" + "".join(" ".join(map(repr, row.tolist())) + "\n" for row in rows)


def json_text(*cameras) -> str:
    return json.dumps({"class_name": "PinholeCameraTrajectory", "parameters": cameras})


@pytest.mark.parametrize(("format", "name"), FORMATS)
def test_round_trip(tmp_path, trajectory, format, name):
    write_trajectory(tmp_path / name, trajectory, format=format, intrinsic=CAMERA)
    again = read_trajectory(tmp_path / name)
    np.testing.assert_allclose(again.poses, trajectory.poses, rtol=0, atol=1e-12)
    if format in ("log", "kitti"):
        assert np.array_equal(again.poses, trajectory.poses)
    assert (again.timestamps is not None) == (format == "tum") and (again.ids is not None) == (format == "log")
    if again.timestamps is not None:
        assert np.array_equal(again.timestamps, trajectory.timestamps)
    if again.ids is not None:
        assert np.array_equal(again.ids, trajectory.ids)


def test_real_logs_are_read_in_full(real_file):
    assert len(read_trajectory(real_file("rgbd-cupoch-redwood5/trajectory.log"))) == 5
    odometry = read_trajectory(real_file("rgbd-cupoch-redwood5/odometry.log"))
    assert odometry.poses[0, :3, 3].tolist() == [2, 2, -0.3]
    pairs = read_trajectory(real_file("reg-3dmatch-logs/configs/benchmarks/3DMatch/7-scenes-redkitchen/gt.log"))
    assert pairs.ids is not None and pairs.ids[1].tolist() == [0, 2, 60]


def test_tum_quaternions_are_x_y_z_w_and_camera_to_world(tmp_path):
    path = tmp_path / "groundtruth.txt"
    path.write_text("# a comment\n\n7.5 1 2 3 0 0 0.7071 0.7071\n")
    trajectory = read_trajectory(path)
    assert trajectory.timestamps is not None and trajectory.timestamps.tolist() == [7.5]
    expected = [[0, -1, 0, 1], [1, 0, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1]]
    np.testing.assert_allclose(trajectory.poses[0], expected, atol=1e-12)


def test_missing_times_and_ids_are_counted_as_open3d_does(tmp_path):
    plain = Trajectory(np.tile(np.eye(4), (3, 1, 1)))
    write_trajectory(tmp_path / "t.log", plain)
    write_trajectory(tmp_path / "t.tum", plain)
    ids, times = read_trajectory(tmp_path / "t.log").ids, read_trajectory(tmp_path / "t.tum").timestamps
    assert ids is not None and ids.tolist() == [[0, 0, 1], [1, 1, 2], [2, 2, 3]]
    assert times is not None and times.tolist() == [0, 1, 2]


def test_rounded_rotations_are_unchanged_and_in_tum_the_nearest_rotation(tmp_path):
    rounded = np.eye(4)
    rounded[0, 0] = 0.995
    (tmp_path / "t.log").write_text(log_text(rounded))
    assert np.array_equal(read_trajectory(tmp_path / "t.log").poses[0], rounded)
    rounded[:3, :3] = 1.004 * np.eye(3)
    write_trajectory(tmp_path / "t.tum", Trajectory(rounded[None]))
    np.testing.assert_allclose(read_trajectory(tmp_path / "t.tum").poses[0], np.eye(4), atol=1e-12)


@pytest.mark.parametrize(
    ("name", "text", "message"),
    [
        ("t.log", "# nothing\n", "contains no pose"),
        ("t.log", log_text() + "1 1 2\n1 0 0 0\n", "line 7): ends within a pose"),
        ("t.log", log_text(ids="0 0 1.5"), "line 1): expected three integers"),
        ("t.log", log_text(ids=f"0 0 {2**63}"), "line 1): expected three integers"),
        ("t.log", log_text() + log_text(np.diag([2.0, 1, 1, 1])), "line 7): pose: expected a rigid motion"),
        ("t.log", log_text(np.diag([-1.0, 1, 1, 1])), "rigid"),
        ("t.log", log_text().replace("1.0", "nan"), "line 2): expected finite"),
        ("t.log", log_text().replace("1.0", "1e200"), "line 2): expected finite"),
        ("t.log", log_text().replace("1.0", "one"), "line 2): not a number"),
        ("t.log", log_text().replace("1.0", "1_0"), "line 2): expected finite"),
        ("t.log", log_text().replace("1.0 0.0", "1.0", 1), "line 2): expected 4 numbers, got 3"),
        ("t.txt", "1 2 3 4\n", "line 1): expected 8 columns (TUM) or 12 (KITTI), got 4"),
        ("t.txt", "0 0 0 0 0 0 0 0\n", "length 0"),
        ("t.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 0 0 2 0 0 0 0 1 0\n", "line 2): pose: expected a rigid"),
        ("t.json", "{}", "key class_name): missing"),
        ("t.json", json_text().replace("PinholeCameraTrajectory", "PoseGraph"), "got 'PoseGraph'"),
        ("t.json", json_text(), "at least one camera"),
        ("t.json", json_text(3), "key parameters[0]"),
        ("t.json", json_text({"extrinsic": [1, 2]}), "extrinsic): expected a list of 16 numbers, got 2"),
        ("t.json", json_text({"extrinsic": [0] * 15 + [1]}), "extrinsic): pose: expected a rigid motion"),
        # digits, blanks and line ends of ASCII
        ("t.tum", "\uff11 0 0 0 0 0 0 1\n", "line 1"),
        ("t.tum", "1 0 0 0 0 0 0 1\n\u2028\n2 0 0 0 0 0 0 1\n", "line 2"),
        ("t.tum", "1 0 0 0 0 0 0\u00a01\n", "line 1"),
        ("t.tum", "1 0 0 0 0 0 0 1\x1c2 0 0 0 0 0 0 1\n", "line 1"),
        ("t.log", log_text(ids="\uff10 0 1"), "expected three integers before a pose"),
        ("t.log", log_text(ids="0 1_0 1"), "expected three integers before a pose"),
        ("t.csv", "1", "unknown trajectory format '.csv'"),
        ("t.log", b"\xff", "not a text file"),
    ],
)
def test_bad_files_are_refused_with_the_line(tmp_path, name, text, message):
    (tmp_path / name).write_bytes(text if isinstance(text, bytes) else text.encode())
    with pytest.raises(FileError) as caught:
        read_trajectory(tmp_path / name)
    assert message in str(caught.value) and name in str(caught.value)


def test_pose_file_has_four_rows(tmp_path):
    path = tmp_path / "frame.pose.txt"
    path.write_text("1 0 0 5\n0 1 0 6\n0 0 1 7\n0 0 0 1\n")
    assert read_pose(path)[:3, 3].tolist() == [5, 6, 7]
    path.write_text("1 0 0 5\n0 1 0 6\n0 0 1 7\n")
    with pytest.raises(FileError, match=r"/frame\.pose\.txt:.*4.*3"):
        read_pose(path)


def test_writing_refuses_before_it_touches_the_file(tmp_path, trajectory):
    path = tmp_path / "t.json"
    path.write_text("precious")
    with pytest.raises(ValueError, match="intrinsic"):
        write_trajectory(path, trajectory)
    with pytest.raises(FileError, match="exists already"):
        write_trajectory(path, trajectory, intrinsic=CAMERA, overwrite=False)
    skewed = Trajectory(trajectory.poses * 1.0)
    skewed.poses[7, 0, 0] += 1
    with pytest.raises(ValueError, match=r"poses\[7\]"):
        write_trajectory(path, skewed, intrinsic=CAMERA)
    with pytest.raises(ValueError, match=r"^trajectory:"):
        write_trajectory(path, Trajectory(np.empty((0, 4, 4))), intrinsic=CAMERA)
    assert path.read_text() == "precious" and len(list(tmp_path.iterdir())) == 1


def test_formats_and_names_must_agree(tmp_path, trajectory):
    for more in ({}, {"format": "log"}):
        with pytest.raises(FileError, match=r"/t\.txt:"):
            write_trajectory(tmp_path / "t.txt", trajectory, **more)
    with pytest.raises(ValueError, match="format:"):
        write_trajectory(tmp_path / "t.txt", trajectory, format="euroc")
    assert not list(tmp_path.iterdir())


def test_trajectory_iterates_over_poses_and_checks_shapes(trajectory):
    for wrong in ({"poses": np.eye(4)}, {"timestamps": [1, 2]}, {"ids": [[0.5, 1, 2]]}, {"ids": [[0], [1]]}):
        with pytest.raises(ValueError, match=f"{next(iter(wrong))}: expected"):
            Trajectory(**{"poses": np.eye(4)[None]} | wrong)
    assert np.array_equal(trajectory[-1], trajectory.poses[-1]) and np.array_equal(list(trajectory), trajectory.poses)
